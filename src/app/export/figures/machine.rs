//! Figures of a contact in a machine.

use super::curve::{against_time, axis_of, of_records};
use crate::app::figure::{Axis, Guide, Line, Panel, Points, Series};
use crate::run::record::{DRAWN, FORCE, INDENTATION, Outcome, Record, SLIDE, SPRING_FORCE, TANGENTIAL_FORCE, TIME};
use crate::run::table::Column;
use crate::scene::Plot;
use crate::scene::law::MachineLaw;

/// What suits a machine.
pub fn suiting(law: &MachineLaw) -> Vec<Plot> {
    if law.is_along() { vec![Plot::Machine, Plot::Stick] } else { vec![Plot::Machine] }
}

/// Displacement and forces over time.
pub fn panels(law: &MachineLaw, outcome: &Outcome) -> Vec<Panel> {
    let records = moved(&outcome.records);
    if law.is_along() {
        return vec![displacements(&records), forces(&records, &TANGENTIAL_FORCE, "friction Fₓ")];
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
