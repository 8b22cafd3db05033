//! Curves of records and of tables, on axes that name their columns.

use crate::app::figure::{Axis, Guide, Hue, Line, Marks, Panel, Points, Scale, Series};
use crate::run::curves::between::filled;
use crate::run::curves::branches::{Branch, Direction, branches, jumps};
use crate::run::record::{INDENTATION, Record, TIME};
use crate::run::table::{Column, Filled};
use crate::scene::plan::Plan;

/// The axis of a quantity of the records.
pub fn axis_of(column: &Column<Record>) -> Axis {
    Axis::linear(column.label, column.unit.symbol)
}

/// The axis of a column of a table.
pub fn axis(column: &Filled) -> Axis {
    Axis::linear(column.label, column.unit.symbol)
}

/// The axis in decades.
pub fn log(axis: Axis) -> Axis {
    Axis { scale: Scale::Log, ..axis }
}

/// One column of a table over another; where either has no number there is no point.
pub fn points(x: &Filled, y: &Filled) -> Points {
    x.numbers().iter().zip(y.numbers()).map(|(x, y)| x.zip(*y)).collect()
}

/// One column of a table over another, in a panel of their own.
pub fn panel(x: &Filled, y: &Filled) -> Panel {
    Panel::new(axis(x), axis(y)).with(Series::new("", points(x, y)))
}

/// One quantity of the records over another.
pub fn of_records(records: &[Record], x: &Column<Record>, y: &Column<Record>) -> Points {
    records.iter().map(|record| (x.of)(record).zip((y.of)(record))).collect()
}

/// Points marked one by one.
pub fn marked(label: &str, points: impl IntoIterator<Item = (f64, f64)>, marks: Marks) -> Series {
    Series::new(label, points).line(Line::Absent).marks(marks)
}

/// A quantity over time.
pub fn against_time(records: &[Record], column: &Column<Record>) -> Panel {
    let series = Series::new("", of_records(records, &TIME, column));
    Panel::new(time_axis(records), axis_of(column)).with(series)
}

/// Decades of time from which on a history is drawn over the logarithm of time.
const MANY_DECADES: f64 = 3.0;

/// Time, in decades if half of the records lie before a thousandth of the whole.
fn time_axis(records: &[Record]) -> Axis {
    let last = records.last().map_or(0.0, |record| record.time);
    let middle = records.get(records.len() / 2).map_or(last, |record| record.time);
    let many = middle > 0.0 && last > middle * 10f64.powf(MANY_DECADES);
    if many { log(axis_of(&TIME)) } else { axis_of(&TIME) }
}

/// A quantity against the indentation, approaches first: a label has the same look in all panels.
pub fn against_depth(plan: &Plan, records: &[Record], column: &Column<Record>, axis: Axis) -> Panel {
    let mut found = branches(records);
    found.sort_by_key(|branch| branch.direction);
    let drawn = |branch: &Branch<'_>| {
        let (label, colour, line) = look(branch.direction);
        let points = of_records(&filled(plan, branch.records), &INDENTATION, column);
        Series::new(label, points).colour(colour).line(line).arrow()
    };
    let panel = found.iter().map(drawn).fold(Panel::new(axis_of(&INDENTATION), axis), Panel::with);
    let at = |record: &Record| record.normal.indentation.zip((column.of)(record));
    let jumps = jumps(records).filter_map(|(before, after)| at(before).zip(at(after)));
    jumps.fold(panel, |panel, (from, to)| panel.guide(Guide::Jump { from, to }))
}

/// Name, colour and line of a branch.
fn look(direction: Direction) -> (&'static str, Hue, Line) {
    match direction {
        Direction::Approach => ("approach", Hue::Blue, Line::Solid),
        Direction::Retraction => ("retraction", Hue::Orange, Line::Dashed),
    }
}
