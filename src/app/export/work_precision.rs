//! Error against run time: table, CSV, JSON, figure.

#[cfg(feature = "plot")]
use crate::app::figure::{Axis, Figure, Guide, Hue, Line, Mark, Marks, Panel, Series};
use crate::app::machine::Machine;
use crate::check::promise::Row;
use crate::check::work_precision::{Point, Setting, Study};
use std::fmt::Write;

/// Errors below this are shown at it: half a unit in the last place of a number.
#[cfg(feature = "plot")]
const FLOOR: f64 = f64::EPSILON / 2.0;

/// The points of all cases in aligned lines.
#[must_use]
pub fn table(studies: &[Study], points: &[Vec<Point>], machine: &Machine) -> String {
    let mut text = String::new();
    for (study, points) in studies.iter().zip(points) {
        let _ = writeln!(text, "{}: {}; errors against: {}", study.case, study.about, study.reference);
        let _ =
            writeln!(text, "  {:32}{:>22}{:>10}{:>10}{:>10}{:>10}", "", "error", "time", "set-up", "first", "bytes");
        for point in points {
            let _ = writeln!(text, "{}", row(point));
        }
    }
    let _ = writeln!(text, "{}; one solver at a time, least time of warm repeats", machine.line());
    text
}

fn row(point: &Point) -> String {
    let time = &point.times;
    let [warm, setup, first] = [time.warm, time.setup, time.first].map(seconds);
    let name = point.method;
    let fine = fineness(point.setting);
    format!("  {name:32}{fine:>12}{:>10.1e}{warm:>10}{setup:>10}{first:>10}{:>10}", point.error, point.bytes)
}

/// A time with three digits and its prefix.
#[must_use]
pub fn seconds(time: f64) -> String {
    let (size, unit) = match time {
        t if t >= 1.0 => (t, "s"),
        t if t >= 1e-3 => (1e3 * t, "ms"),
        t if t >= 1e-6 => (1e6 * t, "µs"),
        t => (1e9 * t, "ns"),
    };
    let decimals = if size < 9.995 {
        2
    } else if size < 99.95 {
        1
    } else {
        0
    };
    format!("{size:.decimals$} {unit}")
}

/// Springs, pixels and steps in few letters.
fn fineness(setting: Setting) -> String {
    let part = |count: Option<usize>, of: fn(usize) -> String| count.map(of);
    let parts = [
        part(setting.springs, |n| n.to_string()),
        part(setting.grid, |n| format!("{n}²")),
        part(setting.steps, |n| format!("/{n}")),
    ];
    parts.into_iter().flatten().collect()
}

/// The points as CSV.
///
/// # Errors
/// The table cannot be put together (never for points measured).
pub fn csv(points: &[Vec<Point>]) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record([
        "case",
        "method",
        "springs",
        "grid",
        "steps",
        "error",
        "radius_error",
        "pressure_error",
        "time_s",
        "setup_s",
        "first_s",
        "bytes",
        "iterations",
    ])?;
    let count = |value: Option<usize>| value.map_or_else(String::new, |value| value.to_string());
    let number = |value: Option<f64>| value.filter(|v| v.is_finite()).map_or_else(String::new, |v| format!("{v:e}"));
    for point in points.iter().flatten() {
        let (setting, times) = (point.setting, point.times);
        let errors = [Some(point.error), point.radius_error, point.pressure_error].map(number);
        let times = [times.warm, times.setup, times.first].map(|time| number(Some(time)));
        let mut row = vec![point.case.to_owned(), point.method.to_owned()];
        row.extend([setting.springs, setting.grid, setting.steps].map(count));
        row.extend(errors.into_iter().chain(times));
        row.extend([point.bytes.to_string(), count(point.iterations)]);
        writer.write_record(row)?;
    }
    let bytes = writer.into_inner().map_err(|error| std::io::Error::other(error.to_string()))?;
    String::from_utf8(bytes).map_err(|error| std::io::Error::other(error).into())
}

/// The points as JSON, with the errors asked for, estimated and true.
///
/// # Errors
/// The text cannot be put together (never for points measured).
pub fn json(
    (studies, points): (&[Study], &[Vec<Point>]),
    promises: &[Row],
    machine: &Machine,
) -> Result<String, serde_json::Error> {
    let references: serde_json::Map<String, serde_json::Value> =
        studies.iter().map(|study| (study.case.to_owned(), study.reference.clone().into())).collect();
    let rows: Vec<&Point> = points.iter().flatten().collect();
    let value = serde_json::json!({ "reference": references, "rows": rows, "promises": promises, "machine": machine });
    serde_json::to_string_pretty(&value)
}

/// The work–precision figure of a case; `peers` are other programs with their error and time [s].
#[cfg(feature = "plot")]
#[must_use]
pub fn figure(study: &Study, points: &[Point], peers: &[(&str, f64, f64)], machine: &Machine) -> Figure {
    let mut note = format!("Errors against: {}; those of rounding are shown at 10⁻¹⁶.", study.reference);
    if !peers.is_empty() {
        note.push_str(" Grey: other programs, measured on a like machine.");
    }
    let quantity = format!("relative error of the {}", study.quantity);
    let panel = panel(study, &quantity, points, |point| Some(point.error));
    let panel = others(panel, peers).note(format!("{note} {}.", machine.line()));
    let figure = Figure::new(format!("Error against run time: {}", study.about)).with(panel);
    if points.iter().all(|point| point.radius_error.is_none()) {
        return figure;
    }
    figure.with(self::panel(study, "relative error of the contact radius", points, |point| point.radius_error))
}

/// A curve for each solver.
#[cfg(feature = "plot")]
fn panel(study: &Study, quantity: &str, points: &[Point], error: impl Fn(&Point) -> Option<f64>) -> Panel {
    let mut panel = Panel::new(Axis::log(quantity, "1"), Axis::log("run time", "s"));
    for run in points.chunk_by(|one, next| one.method == next.method) {
        let place = |point: &Point| Some((error(point)?.max(FLOOR), point.times.warm));
        let series = Series::new(run[0].method, run.iter().filter_map(place).collect());
        panel = panel.with(series.marks(Marks::Numbered));
    }
    let slope = |panel: Panel, order: &f64| panel.guide(Guide::slope(-1.0 / order, format!("order {order}")));
    study.orders.iter().fold(panel, slope)
}

/// Grey marks for other programs.
#[cfg(feature = "plot")]
fn others(mut panel: Panel, peers: &[(&str, f64, f64)]) -> Panel {
    const MARKS: [Mark; 5] = [Mark::Cross, Mark::Plus, Mark::Ring, Mark::Block, Mark::Diamond];
    for (group, mark) in peers.chunk_by(|one, next| one.0 == next.0).zip(MARKS.into_iter().cycle()) {
        let points = group.iter().map(|(_, error, time)| (*error, *time)).collect();
        let series = Series::new(group[0].0, points).line(Line::Absent).colour(Hue::Grey);
        panel = panel.with(series.marks(Marks::As(mark)));
    }
    panel
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_carry_three_digits_and_their_prefix() {
        for (time, text) in [(2.5, "2.50 s"), (0.012_34, "12.3 ms"), (1.234e-4, "123 µs"), (9.999e-7, "1000 ns")] {
            assert_eq!(seconds(time), text);
        }
    }
}
