//! Rough shapes: force and stiffness of the bed, and the line itself.

use crate::app::figure::{Axis, Guide, Line, Panel, Series};
use crate::run::record::{EnsembleRow, Outcome, Record};
use crate::scene::Plot;
use crate::scene::setup::Setup;
use crate::scene::surface::Surface;
use crate::shape::Shape;
use crate::shape::rough::{RoughLine, Scatter, SpectrumSource};

/// What suits a rough shape.
pub const SUITING: [Plot; 2] = [Plot::Force, Plot::Shape];

/// Panels of a rough shape.
pub fn panels(plot: Plot, (setup, surface): (&Setup, &Surface), outcome: &Outcome) -> Vec<Panel> {
    match plot {
        Plot::Force => vec![force(outcome), stiffness(setup, outcome)],
        Plot::Shape => vec![line(setup, surface)],
        Plot::Energy => vec![super::energy(&outcome.records)],
        _ => Vec::new(),
    }
}

fn force(outcome: &Outcome) -> Panel {
    let panel = Panel::new(Axis::linear("indentation d", "m"), Axis::linear("force F", "N").from(0.0));
    let panel = banded(panel, outcome, (depth, |record| record.normal.force), |row| (row.indentation, row.force));
    panel.note("Indentation counts from first touch.")
}

fn stiffness(setup: &Setup, outcome: &Outcome) -> Panel {
    let panel = Panel::new(Axis::log("force F", "N"), Axis::log("stiffness k", "N/m"));
    let of: (Of, Of) = (|record| record.normal.force, |record| record.normal.stiffness);
    let panel = banded(panel, outcome, of, |row| (row.force, row.stiffness));
    let panel = match hurst(setup) {
        Some(hurst) => {
            let exponent = 1.0 / (1.0 + hurst);
            panel.guide(Guide::slope(exponent, format!("slope 1/(1+H) = {exponent:.3}")))
        }
        None => panel,
    };
    panel.note("Approximate: a line stands for the surface. It does not give the real contact area.")
}

type Of = fn(&Record) -> f64;

fn depth(record: &Record) -> f64 {
    record.normal.indentation.unwrap_or(f64::NAN)
}

/// The mean curve, and curves one standard deviation above and below it.
fn banded(panel: Panel, outcome: &Outcome, (x, y): (Of, Of), of: fn(&EnsembleRow) -> (Scatter, Scatter)) -> Panel {
    let mean = outcome.records.iter().map(|record| (x(record), y(record))).collect();
    let Some(ensemble) = &outcome.ensemble else { return panel.with(Series::new("", mean)) };
    let moved = |sign: f64| {
        let point = |row: &EnsembleRow| {
            let (x, y) = of(row);
            // Across the scatter: that of the force under a prescribed depth, of the depth under a prescribed force.
            if y.deviation > 0.0 {
                (x.mean, y.mean + sign * y.deviation)
            } else {
                (x.mean + sign * x.deviation, y.mean)
            }
        };
        Series::new("one standard deviation", ensemble.rows.iter().map(point).collect()).line(Line::Dashed)
    };
    let label = format!("mean of {} surfaces", ensemble.members);
    panel.with(Series::new(label, mean)).with(moved(1.0)).with(moved(-1.0))
}

/// Hurst exponent of a nominally flat self-affine surface.
fn hurst(setup: &Setup) -> Option<f64> {
    let Shape::RoughLine(line) = &setup.scene.shape else { return None };
    match (&line.base, &line.spectrum) {
        (None, SpectrumSource::SelfAffine(spectrum)) => Some(spectrum.hurst.si()),
        _ => None,
    }
}

/// The rough line on its base.
fn line(setup: &Setup, surface: &Surface) -> Panel {
    let seed = surface.seeds.first().copied().unwrap_or(1);
    let line = RoughLine::new(&surface.rings, seed);
    let places = line.places(surface.points);
    let heights = line.heights(surface.points).unwrap_or_default();
    let profile = setup.profile.as_ref();
    let gap = |(x, z): (&f64, &f64)| (*x, profile.reduced(x.abs()) + z);
    let points = places.iter().zip(&heights).map(gap).filter(|point| point.1.is_finite()).collect();
    let panel = Panel::new(Axis::linear("place x", "m"), Axis::linear("height g + z", "m"));
    panel.with(Series::new("", points)).note(format!("Equivalent line of seed {seed}."))
}
