//! Curves of records and of tables, on axes that name their columns.

use crate::app::export::with_prefix;
use crate::app::figure::{Axis, Guide, Hue, Line, Mark, Marks, Panel, Points, Scale, Series};
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

/// A quantity in four digits, with a true minus sign: what a legend has room for.
pub fn short(value: f64, unit: &str) -> String {
    let rounded = format!("{value:.3e}").parse().unwrap_or(value);
    with_prefix(rounded, unit).replacen('-', "−", 1)
}

/// A quantity over time.
pub fn against_time(records: &[Record], column: &Column<Record>) -> Panel {
    let series = Series::new("", of_records(records, &TIME, column));
    Panel::new(time_axis(records), axis_of(column)).with(series)
}

/// Decades of time from which on a history is drawn over the logarithm of time.
const MANY_DECADES: f64 = 3.0;

/// Times of neighbouring records between which a line over the logarithm of time is still one.
const DENSE: f64 = 2.0;

/// Time, in decades if half of the records lie before a thousandth of the whole and the others are dense enough not to be
/// joined by lines that are none.
pub fn time_axis(records: &[Record]) -> Axis {
    let last = records.last().map_or(0.0, |record| record.time);
    let (_, late) = records.split_at(records.len() / 2);
    let middle = late.first().map_or(last, |record| record.time);
    let many = middle > 0.0 && last > middle * 10f64.powf(MANY_DECADES) * (1.0 - 1e-9);
    let dense = late.windows(2).all(|pair| pair[1].time <= DENSE * pair[0].time);
    if many && dense { log(axis_of(&TIME)) } else { axis_of(&TIME) }
}

/// A quantity against the indentation, approaches first: a label has the same look in all panels.
pub fn against_depth(plan: &Plan, records: &[Record], column: &Column<Record>, axis: Axis) -> Panel {
    let mut found = branches(records);
    found.sort_by_key(|branch| branch.direction);
    // Of a history that trembles only the long ways say where it goes.
    let longest = |way| found.iter().filter(|branch| branch.direction == way).map(reach).fold(0.0, f64::max);
    let least =
        if found.len() > MOST_ARROWS { [Direction::Approach, Direction::Retraction].map(longest) } else { [0.0; 2] };
    let drawn = |branch: &Branch<'_>| {
        let (label, colour, line) = look(branch.direction);
        let points = of_records(&filled(plan, branch.records), &INDENTATION, column);
        let series = Series::new(label, points).colour(colour).line(line);
        let series = if few(plan, records) { series.marks(Marks::As(Mark::Point)) } else { series };
        let least = least[usize::from(branch.direction == Direction::Retraction)];
        if reach(branch) >= least { series.arrow() } else { series }
    };
    let panel = found.iter().map(drawn).fold(Panel::new(axis_of(&INDENTATION), axis), Panel::with);
    let at = |record: &Record| record.normal.indentation.zip((column.of)(record));
    let jumps = jumps(records).filter_map(|(before, after)| at(before).zip(at(after)));
    jumps.fold(panel, |panel, (from, to)| panel.guide(Guide::Jump { from, to }))
}

/// Tension over pressure below which it cannot be seen beside it.
const HIDDEN: f64 = 0.1;

/// The force about the pull-off in a panel of its own, where a large load hides it.
pub fn pull_off(records: &[Record], whole: &Panel) -> Option<Panel> {
    let states = || records.iter().filter_map(|record| record.normal.indentation.zip(Some(record.normal.force)));
    let ends = |(least, most): (f64, f64), (_, force): (f64, f64)| (least.min(force), most.max(force));
    let (least, most) = states().fold((0.0, 0.0), ends);
    if least >= 0.0 || -least > HIDDEN * most {
        return None;
    }
    let below = |limit: f64| states().filter(move |(_, force)| *force < limit).map(|(depth, _)| depth);
    let from = below(0.0).fold(f64::INFINITY, f64::min);
    let to = below(-least).fold(from, f64::max);
    let mut panel = whole.clone().titled("pull-off");
    panel.x = panel.x.from(from - ROOM * (to - from)).to(to);
    panel.y = panel.y.from((1.0 + ROOM) * least).to(-least);
    Some(panel)
}

/// Room beside a curve, as a part of its width.
const ROOM: f64 = 0.1;

/// Branches beyond which not every one has an arrow.
const MOST_ARROWS: usize = 16;

/// How far a branch goes [m].
fn reach(branch: &Branch<'_>) -> f64 {
    let depth = |record: Option<&Record>| record.and_then(|record| record.normal.indentation).unwrap_or(0.0);
    (depth(branch.records.last()) - depth(branch.records.first())).abs()
}

/// Records up to which each of them is marked: a line between two of them is no more than a guide to the eye.
const FEW: usize = 40;

/// Whether what is drawn are single solutions of pixels, and few.
pub fn few(plan: &Plan, records: &[Record]) -> bool {
    matches!(plan, Plan::HalfSpace(_)) && records.len() <= FEW
}

/// Name, colour and line of a branch.
fn look(direction: Direction) -> (&'static str, Hue, Line) {
    match direction {
        Direction::Approach => ("approach", Hue::Blue, Line::Solid),
        Direction::Retraction => ("retraction", Hue::Orange, Line::Dashed),
    }
}
