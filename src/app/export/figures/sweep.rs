//! A sweep in pictures: a family of curves, results over a parameter, results over two parameters as colours.

use super::curve::axis_of;
use crate::app::export::{ranges, with_prefix};
use crate::app::figure::{Axis as Ruled, Cells, Figure, Marks, Panel, Scale, Series};
use crate::run::record::{FORCE, INDENTATION};
use crate::run::unit::Unit;
use crate::sweep::{Arrangement, Axis, Row, Sweep};

/// Ratio of the ends from which on positive values are spread over decades.
const WIDE: f64 = 20.0;
/// Relative difference up to which two ratios are equal.
const EQUAL: f64 = 1e-9;
/// Least relative change of a result that is shown.
const CHANGE: f64 = 1e-9;
/// Results shown.
const SHOWN: usize = 2;
/// Points up to which each carries a mark.
const FEW: usize = 30;
/// What tells most of a sweep, first.
const TELLING: [&str; 8] = [
    "pull_off_force_n",
    "restitution",
    "largest_force_n",
    "largest_contact_radius_m",
    "largest_indentation_m",
    "peak_pressure_pa",
    "contact_time_s",
    "dissipated_j",
];

/// The figure of a sweep: curves of some rows; results over the first parameter, or over the first two of a grid.
#[must_use]
pub fn sweep_figure(title: &str, sweep: &Sweep, rows: &[Row]) -> Figure {
    let varied: Vec<usize> = (0..sweep.axes().len()).filter(|&at| is_varied(&sweep.axes()[at])).collect();
    let over = |name: &&str| match varied[..] {
        [first, second, ..] if sweep.arrangement() == Arrangement::Grid => heat(sweep, rows, (first, second), name),
        [first, ..] => Some(results(sweep, rows, first, name)),
        [] => None,
    };
    let telling = telling(rows);
    let panels = telling.iter().filter_map(over);
    family(sweep, rows).into_iter().chain(panels).fold(Figure::new(title), Figure::with)
}

/// Whether an axis has two numbers at least, and nothing but numbers.
fn is_varied(axis: &Axis) -> bool {
    axis.values.len() > 1 && (0..axis.values.len()).all(|pick| axis.number(pick).is_some())
}

/// The results that change over the rows, the most telling ones first.
fn telling(rows: &[Row]) -> Vec<&str> {
    let ranges = ranges(rows);
    let changing = ranges.iter().filter(|(_, least, most)| most - least > CHANGE * most.abs().max(least.abs()));
    let changing: Vec<&str> = changing.map(|(name, ..)| *name).collect();
    let known = TELLING.into_iter().filter_map(|name| changing.iter().copied().find(|other| *other == name));
    let others = changing.iter().copied().filter(|name| !TELLING.contains(name));
    known.chain(others).take(SHOWN).collect()
}

fn spread(label: &str, unit: &str, numbers: impl Iterator<Item = f64>) -> Ruled {
    let numbers: Vec<f64> = numbers.collect();
    let (least, most) = numbers.iter().fold((f64::INFINITY, 0.0_f64), |(lo, hi), value| (value.min(lo), value.max(hi)));
    let wide = most > WIDE * least || is_of_equal_ratios(&numbers);
    let scale = if least > 0.0 && wide { Scale::Log } else { Scale::Linear };
    Ruled { scale, ..Ruled::linear(label, unit) }
}

/// Whether three numbers at least follow each other by one ratio.
fn is_of_equal_ratios(numbers: &[f64]) -> bool {
    let ratios = numbers.windows(2).map(|pair| pair[1] / pair[0]);
    let (least, most) = ratios.fold((f64::INFINITY, 0.0_f64), |(lo, hi), ratio| (lo.min(ratio), hi.max(ratio)));
    numbers.len() > 2 && most - least < EQUAL * least
}

fn axis_over(axis: &Axis) -> Ruled {
    let numbers = (0..axis.values.len()).filter_map(|pick| axis.number(pick));
    spread(&axis.path, axis.unit.as_deref().unwrap_or(""), numbers)
}

fn axis_of_result(name: &str, rows: &[Row]) -> Ruled {
    let (quantity, unit) = Unit::of_name(name);
    spread(&quantity.replace('_', " "), unit.symbol, rows.iter().filter_map(|row| row.number(name)))
}

/// A value of an axis as a person writes it.
fn written(axis: &Axis, pick: usize) -> String {
    let unit = axis.unit.as_deref().unwrap_or("");
    match axis.number(pick) {
        Some(number) if matches!(unit, "" | "kg" | "rad" | "rad/s") => with_prefix_of_one(number, unit),
        Some(number) => with_prefix(number, unit).replace("^2", "²"),
        None => axis
            .values
            .get(pick)
            .map(|value| value.as_str().map_or_else(|| value.to_string(), str::to_owned))
            .unwrap_or_default(),
    }
}

/// A number whose unit takes no prefix.
fn with_prefix_of_one(number: f64, unit: &str) -> String {
    let text = if (1e-3..1e5).contains(&number.abs()) { format!("{number:.6}") } else { format!("{number:.5e}") };
    let text = if text.contains('.') && !text.contains('e') {
        text.trim_end_matches('0').trim_end_matches('.')
    } else {
        &text
    };
    format!("{text} {unit}").trim_end().to_owned()
}

/// The last name of a path that is no number.
fn short(path: &str) -> &str {
    path.rsplit(['.', '[', ']']).find(|step| step.starts_with(char::is_alphabetic)).unwrap_or(path)
}

/// Force over depth of the rows that have kept their curve.
fn family(sweep: &Sweep, rows: &[Row]) -> Option<Panel> {
    let axes = sweep.axes();
    let labelled = if sweep.arrangement() == Arrangement::Zip { axes } else { axes.get(..1)? };
    let label = |row: &Row| {
        let picks = sweep.picks(row.number);
        let values =
            labelled.iter().zip(picks).map(|(axis, pick)| format!("{} {}", short(&axis.path), written(axis, pick)));
        values.collect::<Vec<_>>().join(", ")
    };
    let kept: Vec<&Row> = rows.iter().filter(|row| row.curve.len() > 1).collect();
    let first = kept.first()?;
    let fixed = axes.iter().zip(sweep.picks(first.number)).skip(labelled.len());
    let fixed: Vec<String> = fixed.map(|(axis, pick)| format!("{} {}", axis.path, written(axis, pick))).collect();
    let panel = Panel::new(axis_of(&INDENTATION), axis_of(&FORCE)).titled(fixed.join(", "));
    Some(kept.iter().fold(panel, |panel, row| panel.with(Series::new(label(row), row.curve.iter().copied()))))
}

/// A result over the values of an axis; the other axes are in their middle.
fn results(sweep: &Sweep, rows: &[Row], at: usize, name: &str) -> Panel {
    let axis = &sweep.axes()[at];
    let mut points: Vec<(f64, f64)> = rows
        .iter()
        .filter(|row| sweep.is_in_the_middle(row.number, &[at]))
        .filter_map(|row| Some((axis.number(*sweep.picks(row.number).get(at)?)?, row.number(name)?)))
        .collect();
    points.sort_by(|one, other| one.0.total_cmp(&other.0));
    let marks = if points.len() <= FEW { Marks::Numbered } else { Marks::Absent };
    Panel::new(axis_over(axis), axis_of_result(name, rows)).with(Series::new("", points).marks(marks))
}

/// A result over the values of two axes; the other axes are in their middle.
fn heat(sweep: &Sweep, rows: &[Row], at: (usize, usize), name: &str) -> Option<Panel> {
    let (one, other) = (&sweep.axes()[at.0], &sweep.axes()[at.1]);
    let (x, y) = (rising(one), rising(other));
    let mut values = vec![None; x.len() * y.len()];
    for row in rows.iter().filter(|row| sweep.is_in_the_middle(row.number, &[at.0, at.1])) {
        let picks = sweep.picks(row.number);
        let place = |axis: &Axis, at: usize, all: &[f64]| {
            let number = axis.number(*picks.get(at)?)?;
            all.binary_search_by(|known| known.total_cmp(&number)).ok()
        };
        let (column, line) = (place(one, at.0, &x)?, place(other, at.1, &y)?);
        values[column * y.len() + line] = row.number(name);
    }
    if x.len() < 2 || y.len() < 2 {
        return None;
    }
    let of = axis_of_result(name, rows);
    let title = of.label.clone();
    Some(Panel::new(axis_over(one), axis_over(other)).titled(title).cells(Cells { x, y, values, of }))
}

/// The numbers of an axis in rising order, each once.
fn rising(axis: &Axis) -> Vec<f64> {
    let mut numbers: Vec<f64> = (0..axis.values.len()).filter_map(|pick| axis.number(pick)).collect();
    numbers.sort_by(f64::total_cmp);
    numbers.dedup_by(|one, other| one.total_cmp(other).is_eq());
    numbers
}
