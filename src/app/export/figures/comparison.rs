//! Error against run time, log–log.

use crate::app::figure::{Axis, Figure, Guide, Hue, Line, Mark, Marks, Panel, Series};
use crate::check::comparison::Comparison;
use crate::check::row::{Row, Setting};
use crate::check::theory::power_law_fit;

/// Errors below this are rounding and no part of a slope.
const ROUNDING: f64 = 1e-13;

/// An error in a row.
type Of = fn(&Row) -> Option<f64>;

/// A method looks the same in every panel.
fn look(setting: &Setting) -> (Hue, Line, Mark) {
    match (setting.springs, setting.grid) {
        (Some(_), _) => (Hue::Blue, Line::Solid, Mark::Disc),
        (_, Some(_)) => (Hue::Orange, Line::Dashed, Mark::Square),
        _ => (Hue::Black, Line::DashDot, Mark::Triangle),
    }
}

/// One panel for each quantity that is compared.
#[must_use]
pub fn comparison_figure(title: &str, comparison: &Comparison) -> Figure {
    let errors: [(&str, Of); 5] = [
        ("force", |row| row.errors.force),
        ("contact radius", |row| row.errors.radius),
        ("indentation under the force", |row| row.errors.indentation),
        ("stiffness", |row| row.errors.stiffness),
        ("largest pressure", |row| row.errors.pressure),
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
    for rows in comparison.rows.chunk_by(|one, next| one.method == next.method) {
        // An error of zero is shown at the rounding it is below.
        let place = |row: &Row| Some((row.times?.warm, of(row)?.abs().max(f64::EPSILON)));
        let points: Vec<(f64, f64)> = rows.iter().filter_map(place).collect();
        slopes.extend(slope(rows[0].method, &points));
        if !points.is_empty() {
            let (colour, line, mark) = look(&rows[0].setting);
            let series = Series::new(rows[0].method, points).colour(colour).line(line);
            panel = panel.with(series.marks(Marks::As(mark)));
        }
    }
    if !slopes.is_empty() {
        panel = panel.note(format!("Fitted slopes: {}.", slopes.join(", ")));
    }
    let panel = panel.note(format!("Errors relative to: {}.", comparison.reference));
    if slopes.is_empty() {
        return panel;
    }
    panel.guide(Guide::slope(-1.0, "slope −1")).guide(Guide::slope(-2.0, "slope −2"))
}

fn slope(method: &str, points: &[(f64, f64)]) -> Option<String> {
    let above: Vec<_> = points.iter().copied().filter(|point| point.1 > ROUNDING).collect();
    // Steps do not make a line of given phases better: nothing falls, nothing is fitted.
    let (exponent, _) = power_law_fit(&above).filter(|law| law.0 < -0.05)?;
    Some(format!("{method} {}", format!("{exponent:.1}").replace('-', "−")))
}
