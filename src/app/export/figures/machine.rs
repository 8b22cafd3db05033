//! Figures of a contact in a machine.

use super::curve::{against_time, axis_of, log, of_records};
use crate::app::figure::{Axis, Guide, Line, Panel, Points, Series};
use crate::run::record::{
    DRAWN, FORCE, INDENTATION, Outcome, Record, SLIDE, SLIP_SPEED, SPEED, SPRING_FORCE, STATE, TANGENTIAL_FORCE, TIME,
};
use crate::run::table::Column;
use crate::scene::Plot;
use crate::scene::law::{FrictionLaw, MachineLaw};

/// What suits a machine; a contact with rate and state never sticks.
pub fn suiting(law: &MachineLaw, friction: Option<&FrictionLaw>) -> Vec<Plot> {
    let sticks = law.is_along() && friction.and_then(FrictionLaw::rate_state).is_none();
    if sticks { vec![Plot::Machine, Plot::Stick] } else { vec![Plot::Machine] }
}

/// Least speed that is drawn, as a part of the largest.
const DECADES: f64 = 1e-9;

/// Speed of slip and state of the contact, if it has them, in decades.
fn rate_and_state(records: &[Record]) -> Vec<Panel> {
    let over_time = |column: &Column<Record>| -> Points {
        let sizes = records.iter().filter_map(|record| Some((record.time, (column.of)(record)?.abs())));
        let largest = sizes.clone().map(|at| at.1).fold(f64::MIN_POSITIVE, f64::max);
        // A contact at rest has no speed, and one that carries little creeps over dozens of decades.
        sizes.map(|at| Some(at).filter(|at| at.1 > DECADES * largest)).collect()
    };
    let (speeds, states) = (over_time(&SLIP_SPEED), over_time(&STATE));
    if records.iter().all(|record| (STATE.of)(record).is_none()) {
        return Vec::new();
    }
    let panel = |axis: Axis| Panel::new(axis_of(&TIME), log(axis));
    let masses = Series::new("mass", over_time(&SPEED)).line(Line::Dashed);
    vec![
        panel(Axis::linear("speed", SLIP_SPEED.unit.symbol)).with(Series::new("contact", speeds)).with(masses),
        panel(axis_of(&STATE)).with(Series::new("", states)),
    ]
}

/// Displacement and forces over time.
pub fn panels(law: &MachineLaw, outcome: &Outcome) -> Vec<Panel> {
    let records = moved(&outcome.records);
    if law.is_along() {
        let along = [displacements(&records), forces(&records, &TANGENTIAL_FORCE, "friction Fₓ")];
        return along.into_iter().chain(rate_and_state(&records)).collect();
    }
    let depth = if law.falls() { height(&records) } else { against_time(&records, &INDENTATION) };
    let force = if law.suspension.stiffness > 0.0 {
        forces(&records, &FORCE, "contact F")
    } else {
        against_time(&records, &FORCE)
    };
    vec![depth, force]
}

/// The height of a mass that falls.
fn height(records: &[Record]) -> Panel {
    let up = records.iter().map(|record| Some((record.time, -record.normal.indentation?)));
    Panel::new(axis_of(&TIME), Axis::linear("height −d", INDENTATION.unit.symbol))
        .with(Series::new("", up.collect::<Points>()))
        .guide(Guide::horizontal(0.0, "ground"))
}

/// Force and depth of the contact over time: where a mass swings, over its depth there is nothing to see but a line.
pub fn force(records: &[Record]) -> Vec<Panel> {
    [FORCE, INDENTATION].map(|column| against_time(records, &column)).into()
}

/// The records from the last one before the machine on.
fn moved(records: &[Record]) -> Vec<Record> {
    let first = records.iter().position(|record| record.machine.is_some()).unwrap_or(0);
    records[first..].to_vec()
}

fn displacements(records: &[Record]) -> Panel {
    Panel::new(axis_of(&TIME), Axis::linear("tangential displacement", SLIDE.unit.symbol))
        .with(Series::new("mass", of_records(records, &TIME, &SLIDE)))
        .with(Series::new("far end of the spring", of_records(records, &TIME, &DRAWN)).line(Line::Dashed))
}

fn forces(records: &[Record], of_contact: &Column<Record>, name: &'static str) -> Panel {
    Panel::new(axis_of(&TIME), Axis::linear("force", FORCE.unit.symbol))
        .with(Series::new(name, of_records(records, &TIME, of_contact)))
        .with(Series::new("spring", of_records(records, &TIME, &SPRING_FORCE)).line(Line::Dashed))
}
