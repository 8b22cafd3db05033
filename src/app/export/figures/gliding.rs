//! Figures of bodies that glide or roll over a body that remembers.

use super::curve::{against_time, axis, axis_of, log, of_records, points};
use crate::app::figure::{Guide, Line, Marks, Panel, Series};
use crate::run::record::{LEADING_EDGE, Outcome, TANGENTIAL_FORCE, TIME, TRAILING_EDGE};
use crate::run::table::Table;
use crate::scene::Plot;
use crate::scene::law::{Start, Travel};

/// What suits a body that moves along.
pub fn suiting(travel: &Travel) -> Vec<Plot> {
    match travel.start {
        Start::Followed => vec![Plot::Resistance, Plot::Force],
        Start::LeftOut => vec![Plot::Resistance, Plot::Moduli],
    }
}

/// Resistance over the speed, where there are many; over the time, where a start is followed.
pub fn resistance(travel: &Travel, outcome: &Outcome) -> Vec<Panel> {
    let states = outcome.table("glides");
    match travel.start {
        Start::Followed => over_time(outcome),
        Start::LeftOut => states.and_then(over_speed).unwrap_or_default(),
    }
}

/// Most points of a curve that are marked one by one.
const MARKED: usize = 40;

fn over_speed(states: &Table) -> Option<Vec<Panel>> {
    let (speed, coefficient) = (states.column("speed")?, states.column("resistance_coefficient")?);
    let marks = |series: Series| if states.rows() <= MARKED { series.marks(Marks::Numbered) } else { series };
    let drawn = Panel::new(log(axis(speed)), axis(coefficient).from(0.0));
    let theory = states.column("persson_coefficient");
    let share = states.column("area_fraction");
    let name = match (theory.is_some(), share.is_some()) {
        (true, true) => "pixels of the surface",
        (true, false) => "bed of the line",
        (false, _) => "",
    };
    let drawn = drawn.with(marks(Series::new(name, points(speed, coefficient))));
    let drawn = match theory {
        Some(theory) => drawn.with(Series::new("Persson, of the surface", points(speed, theory)).line(Line::Dashed)),
        None => drawn,
    };
    let edges = ["leading_edge", "trailing_edge"].map(|name| states.column(name));
    let [Some(leading), Some(trailing)] = edges else { return Some(vec![drawn]) };
    // What is rough has no two edges.
    if leading.numbers().iter().all(Option::is_none) {
        let touching = share.map(|share| {
            Panel::new(log(axis(speed)), axis(share).from(0.0)).with(marks(Series::new("", points(speed, share))))
        });
        return Some([drawn].into_iter().chain(touching).collect());
    }
    let place = crate::app::figure::Axis::linear("edge of the contact", leading.unit.symbol);
    let contact = Panel::new(log(axis(speed)), place)
        .with(marks(Series::new("leading", points(speed, leading))))
        .with(marks(Series::new("trailing", points(speed, trailing)).line(Line::Dashed)))
        .guide(Guide::horizontal(0.0, ""));
    Some(vec![drawn, contact])
}

fn over_time(outcome: &Outcome) -> Vec<Panel> {
    let records = &outcome.records;
    let force = against_time(records, &TANGENTIAL_FORCE);
    let force = match outcome.number("steady_tangential_force_n") {
        Some(steady) => force.guide(Guide::horizontal(steady, "steady")),
        None => force,
    };
    // What is rough has no two edges.
    if records.iter().all(|record| (LEADING_EDGE.of)(record).is_none()) {
        return vec![force];
    }
    let place = crate::app::figure::Axis::linear("edge of the contact", LEADING_EDGE.unit.symbol);
    let edges = Panel::new(axis_of(&TIME), place)
        .with(Series::new("leading", of_records(records, &TIME, &LEADING_EDGE)))
        .with(Series::new("trailing", of_records(records, &TIME, &TRAILING_EDGE)).line(Line::Dashed))
        .guide(Guide::horizontal(0.0, ""));
    vec![force, edges]
}
