//! Figures of the reports: error against run time, run time against size.

use crate::app::figure::{Axis, Figure, Guide, Hue, Line, Mark, Marks, Panel, Series};
use crate::app::machine::Machine;
use crate::check::row::Row;
use crate::check::study::Study;

/// Errors below this are shown at it: half a unit in the last place of a number.
const FLOOR: f64 = f64::EPSILON / 2.0;

/// A measurement of another program: its name, error and time [s].
pub type Other<'p> = (&'p str, f64, f64);

/// An error of a row.
type Error = fn(&Row) -> Option<f64>;

/// Error against run time of the ways to compute a case.
#[must_use]
pub fn accuracy(study: &Study, rows: &[Row], others: &[Other<'_>], machine: &Machine) -> Figure {
    let mut note = format!("Errors against: {}; those of rounding are shown at 10⁻¹⁶.", study.reference);
    if !others.is_empty() {
        note.push_str(" Grey: other programs, measured on a like machine.");
    }
    let quantity = format!("relative error of the {}", study.quantity);
    let panel = ways(&quantity, rows, |row| row.error);
    let panel = beside(panel, others).note(format!("{note} {}.", machine.line()));
    let figure = Figure::new(format!("Error against run time: {}", study.about)).with(panel);
    if rows.iter().all(|row| row.errors.radius.is_none()) {
        return figure;
    }
    figure.with(ways("relative error of the contact radius", rows, |row| row.errors.radius))
}

/// A curve for each way.
fn ways(quantity: &str, rows: &[Row], error: Error) -> Panel {
    let mut panel = Panel::new(Axis::log(quantity, "1"), Axis::log("run time", "s"));
    for run in rows.chunk_by(|one, next| one.method == next.method) {
        let place = |row: &Row| Some((error(row)?.abs().max(FLOOR), row.times?.warm));
        let series = Series::new(run[0].method, run.iter().filter_map(place));
        panel = panel.with(series.marks(Marks::Numbered));
    }
    let slope = |panel: Panel, order: f64| panel.guide(Guide::slope(-1.0 / order, format!("order {order}")));
    [1.0, 2.0].into_iter().fold(panel, slope)
}

/// Grey marks for other programs.
fn beside(mut panel: Panel, others: &[Other<'_>]) -> Panel {
    const MARKS: [Mark; 5] = [Mark::Cross, Mark::Plus, Mark::Ring, Mark::Block, Mark::Diamond];
    for (group, mark) in others.chunk_by(|one, next| one.0 == next.0).zip(MARKS.into_iter().cycle()) {
        let points = group.iter().map(|(_, error, time)| (*error, *time));
        let series = Series::new(group[0].0, points).line(Line::Absent).colour(Hue::Grey);
        panel = panel.with(series.marks(Marks::As(mark)));
    }
    panel
}

/// Run time against size, for the kernels measured at several sizes.
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "sizes are far below 2^53")]
pub fn speed(rows: &[Row], machine: &Machine) -> Figure {
    let axes = [Axis::log("number of springs, terms, records or pixels", "1"), Axis::log("run time", "s")];
    let [size, time] = axes;
    let mut panel = Panel::new(size, time);
    let mut seen: Vec<&str> = Vec::new();
    for row in rows {
        let same: Vec<&Row> = rows.iter().filter(|other| other.method == row.method).collect();
        if same.len() > 1 && !seen.contains(&row.method) {
            seen.push(row.method);
            let place = |row: &&Row| Some((row.setting.counted?.1 as f64, row.times?.warm));
            let label = format!("{}: {}", row.method, row.setting.counted.map_or("", |counted| counted.0));
            let series = Series::new(label, same.iter().filter_map(place));
            panel = panel.with(series.marks(Marks::Numbered));
        }
    }
    let panel = panel.guide(Guide::slope(1.0, "in proportion")).note(format!("{}.", machine.line()));
    Figure::new("Run time against size").with(panel)
}
