//! Error against run time, log–log.

use crate::app::figure::{Axis, Figure, Guide, Hue, Line, Mark, Marks, Panel, Series};
use crate::check::comparison::{Comparison, Method, Row};
use crate::check::theory::power_law_fit;

/// Errors below this are rounding and no part of a slope.
const ROUNDING: f64 = 1e-13;

/// An error in a row.
type Of = fn(&Row) -> Option<f64>;

/// One panel for each quantity that is compared.
#[must_use]
pub fn comparison_figure(title: &str, comparison: &Comparison) -> Figure {
    let errors: [(&str, Of); 5] = [
        ("force", |row| row.force_error),
        ("contact radius", |row| row.radius_error),
        ("indentation under the force", |row| row.indentation_error),
        ("stiffness", |row| row.stiffness_error),
        ("largest pressure", |row| row.pressure_error),
    ];
    let known = |(_, of): &(&str, Of)| comparison.rows.iter().filter(|row| of(row).is_some()).count() > 1;
    let known = errors.into_iter().filter(known);
    let panels = known.map(|(name, of)| panel(name, comparison, of));
    panels.fold(Figure::new(title), Figure::with)
}

fn panel(name: &str, comparison: &Comparison, of: Of) -> Panel {
    let axes = (Axis::log("run time", "s"), Axis::log("relative error", "1"));
    let mut panel = Panel::new(axes.0, axes.1).titled(name);
    let mut slopes = Vec::new();
    for method in [Method::Springs, Method::HalfSpace, Method::HalfPlane, Method::Direct] {
        let points = points(comparison, method, of);
        slopes.extend(slope(method, &points));
        if !points.is_empty() {
            panel = panel.with(series(method, points));
        }
    }
    if !slopes.is_empty() {
        panel = panel.note(format!("Fitted slopes: {}.", slopes.join(", ")));
    }
    let falls = !slopes.is_empty();
    let panel = panel.note(format!("Errors relative to: {}.", comparison.reference));
    if !falls {
        return panel;
    }
    panel.guide(Guide::slope(-1.0, "slope −1")).guide(Guide::slope(-2.0, "slope −2"))
}

/// A method looks the same in every panel.
fn series(method: Method, points: Vec<(f64, f64)>) -> Series {
    let (colour, line, mark) = match method {
        Method::Springs => (Hue::Blue, Line::Solid, Mark::Disc),
        Method::HalfSpace | Method::HalfPlane => (Hue::Orange, Line::Dashed, Mark::Square),
        Method::Direct => (Hue::Black, Line::DashDot, Mark::Triangle),
    };
    Series::new(method.name(), points).colour(colour).line(line).marks(Marks::As(mark))
}

fn points(comparison: &Comparison, method: Method, of: Of) -> Vec<(f64, f64)> {
    let rows = comparison.rows.iter().filter(|row| row.method == method);
    // An error of zero is shown at the rounding it is below.
    rows.filter_map(|row| Some((row.time_s, of(row)?.abs().max(f64::EPSILON)))).collect()
}

fn slope(method: Method, points: &[(f64, f64)]) -> Option<String> {
    let above: Vec<_> = points.iter().copied().filter(|point| point.1 > ROUNDING).collect();
    // Steps do not make a line of given phases better: nothing falls, nothing is fitted.
    let (exponent, _) = power_law_fit(&above).filter(|law| law.0 < -0.05)?;
    Some(format!("{} {}", method.name(), format!("{exponent:.1}").replace('-', "−")))
}
