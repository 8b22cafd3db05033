//! Rough shapes: force and stiffness of the bed, and the line itself.

use super::curve::{axis_of, log, of_records, points};
use crate::app::figure::{Axis, Guide, Line, Panel, Points, Series};
use crate::check::theory::stiffness_exponent;
use crate::run::record::{FORCE, INDENTATION, Outcome, Record, STIFFNESS};
use crate::run::table::{Column, Table};
use crate::scene::plan::RoughPlan;
use crate::scene::{Plot, Scene};
use crate::shape::rough::{RoughLine, SpectrumSource};
use crate::shape::{Family, RoughShape};

/// What suits a rough shape.
pub fn suiting(plan: &RoughPlan) -> Vec<Plot> {
    let rubs = plan.coefficient.map(|_| Plot::Friction);
    [Plot::Force].into_iter().chain(rubs).chain([Plot::Shape]).collect()
}

/// Force over the indentation and stiffness over the force.
pub fn force(plan: &RoughPlan, outcome: &Outcome) -> Vec<Panel> {
    let panel = against_depth(outcome);
    let panel = if plan.works.is_some() { panel } else { Panel { y: panel.y.from(0.0), ..panel } };
    vec![panel, stiffness(plan, outcome)]
}

/// Force over the indentation.
pub fn against_depth(outcome: &Outcome) -> Panel {
    banded(outcome, &INDENTATION, &FORCE).note("Indentation counts from first touch.")
}

fn stiffness(plan: &RoughPlan, outcome: &Outcome) -> Panel {
    if plan.works.is_some() {
        // One force belongs to many states of bodies that adhere.
        return banded(outcome, &INDENTATION, &STIFFNESS).note(APPROXIMATE);
    }
    let panel = banded(outcome, &FORCE, &STIFFNESS);
    let panel = Panel { x: log(panel.x), y: log(panel.y), ..panel };
    beside_the_law(panel, &plan.scene).note(APPROXIMATE)
}

/// Stiffness over force in decades, with the slope of the law that self-affine surfaces follow at small loads.
pub fn beside_the_law(panel: Panel, scene: &Scene) -> Panel {
    match hurst(scene).map(stiffness_exponent) {
        Some(exponent) => panel.guide(Guide::slope(exponent, format!("slope 1/(1+H) = {exponent:.3}"))),
        None => panel,
    }
}

/// What is said of the stiffness.
const APPROXIMATE: &str = "Approximate: a line stands for the surface. It does not give the real contact area.";

/// The mean curve, and curves one standard deviation above and below it.
fn banded(outcome: &Outcome, x: &Column<Record>, y: &Column<Record>) -> Panel {
    let panel = Panel::new(axis_of(x), axis_of(y));
    let mean = of_records(&outcome.records, x, y);
    let Some([above, below]) = outcome.table("ensemble").and_then(|table| moved(table, x, y)) else {
        return panel.with(Series::new("", mean));
    };
    let members = outcome.named("members").map_or_else(String::new, |members| members.to_string());
    let label = format!("mean of {members} surfaces");
    let deviation = |points| Series::new("one standard deviation", points).line(Line::Dashed);
    panel.with(Series::new(label, mean)).with(deviation(above)).with(deviation(below))
}

/// The curves one standard deviation above and below the mean.
///
/// Across the scatter: that of the force under a prescribed depth, of the depth under a prescribed force.
fn moved(table: &Table, x: &Column<Record>, y: &Column<Record>) -> Option<[Points; 2]> {
    let column = |of: &Column<Record>, what: &str| table.column(&format!("{}_{what}", of.quantity));
    let means = points(column(x, "mean")?, column(y, "mean")?);
    let deviations = points(column(x, "deviation")?, column(y, "deviation")?);
    let largest = means.iter().flatten().map(|mean| mean.1.abs()).fold(0.0, f64::max);
    Some([1.0, -1.0].map(|sign: f64| {
        let moved = |mean: (f64, f64), by: (f64, f64)| {
            if by.1 > SCATTERS * largest { (mean.0, mean.1 + sign * by.1) } else { (mean.0 + sign * by.0, mean.1) }
        };
        means.iter().zip(&deviations).map(|(mean, by)| Some(moved((*mean)?, (*by)?))).collect()
    }))
}

/// Part of the largest force beyond which it scatters: what is prescribed is met to rounding.
const SCATTERS: f64 = 1e-9;

/// Hurst exponent of a nominally flat self-affine surface.
fn hurst(scene: &Scene) -> Option<f64> {
    match scene.shape.family() {
        Family::Line(RoughShape { base: None, spectrum: SpectrumSource::SelfAffine(spectrum), .. }) => {
            Some(spectrum.hurst.si())
        }
        Family::Line(_) | Family::Map(..) | Family::Round | Family::Tips(_) | Family::Wavy(_) | Family::Pad(_) => None,
    }
}

/// The rough line on its base.
pub fn line(plan: &RoughPlan) -> Panel {
    let surface = &plan.surface;
    let seed = surface.seeds.first().copied().unwrap_or(1);
    let line = RoughLine::new(&surface.rings, seed);
    let places = line.places(surface.points);
    let heights = line.heights(surface.points).unwrap_or_default();
    let gap = |(x, z): (&f64, &f64)| (*x, plan.reduced(x.abs()) + z);
    let points = places.iter().zip(&heights).map(gap).filter(|point| point.1.is_finite());
    let panel = Panel::new(Axis::linear("place x", "m"), Axis::linear("height g + z", "m"));
    panel.with(Series::new("", points)).note(format!("Equivalent line of seed {seed}."))
}
