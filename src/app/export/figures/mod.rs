//! The figures a scene asks for, or those that suit it.

mod comparison;
mod curve;
mod fields;
mod friction;
mod impacts;
mod rough;
mod shape;

use crate::app::figure::{Axis, Figure, Panel, Series};
use crate::run::record::{CONTACT_RADIUS, FORCE, INDENTATION, Outcome, Record};
use crate::run::table::Column;
use crate::run::unit::Unit;
use crate::scene::Plot;
use crate::scene::history::Entry;
use crate::scene::plan::{Plan, RoundPlan};
use crate::shape::Rim;
pub use comparison::comparison_figure;
use curve::{against_depth, against_time, axis_of, of_records};

/// The force of a plane contact: per length.
const LINE_FORCE: Column<Record> = Column { label: "force per length F", unit: Unit::NEWTON_PER_METRE, ..FORCE };
/// Half the width of a plane contact.
const HALF_WIDTH: Column<Record> = Column { label: "half width a", ..CONTACT_RADIUS };

/// The figure of a scene: one panel per plot wanted.
#[must_use]
pub fn figures(plan: &Plan, outcome: &Outcome) -> Figure {
    let wanted = plan.scene.plots.clone().unwrap_or_else(|| suiting(plan, outcome));
    let panels = wanted.iter().flat_map(|plot| panels(*plot, plan, outcome)).chain(oblique(plan, outcome));
    panels.fold(Figure::new(plan.scene.title.clone()), Figure::with)
}

/// What suits a scene that asks for nothing.
fn suiting(plan: &Plan, outcome: &Outcome) -> Vec<Plot> {
    match plan {
        Plan::Round(RoundPlan { friction: Some(_), .. }) => friction::suiting(plan, outcome),
        Plan::Round(round) => {
            let pressure = (!outcome.fields.is_empty()).then_some(Plot::Pressure);
            let shape = (!matches!(round.profile.rim(), Rim::Wall(_))).then_some(Plot::Shape);
            [Plot::Force, Plot::Radius].into_iter().chain(pressure).chain(shape).collect()
        }
        Plan::Impact(impact) => match (impact.impact.speed.len(), &impact.ball) {
            (1, Some(_)) => vec![Plot::Force],
            (1, None) => vec![Plot::Force, Plot::Pressure],
            _ => vec![Plot::Restitution],
        },
        Plan::Plane(_) => vec![Plot::Force, Plot::Radius, Plot::Pressure],
        Plan::Rough(_) => rough::SUITING.to_vec(),
    }
}

fn panels(plot: Plot, plan: &Plan, outcome: &Outcome) -> Vec<Panel> {
    let records = &outcome.records;
    match (plot, plan) {
        (_, Plan::Rough(rough)) => rough::panels(plot, rough, outcome),
        (Plot::Force, Plan::Impact(_)) => {
            let loop_of = against_depth(plan, records, &FORCE, axis_of(&FORCE));
            impacts::over_time(records).into_iter().chain([loop_of]).collect()
        }
        (Plot::Force, _) => force(plan, records),
        (Plot::Radius, _) => radius(plan, records),
        (Plot::Pressure, _) => vec![fields::pressure(plan, outcome)],
        (Plot::Stress, _) => vec![fields::stress(outcome)],
        (Plot::Energy, _) => vec![energy(records)],
        (Plot::Shape, _) => plan.profile().map(|profile| shape::profile(profile, outcome)).into_iter().collect(),
        (Plot::Friction, _) => vec![friction::loops(plan, records)],
        (Plot::Stick, _) => vec![friction::stick(records)],
        (Plot::Shear, _) => friction::stress(plan, outcome).into_iter().collect(),
        (Plot::Fretting, _) => friction::fretting(outcome).into_iter().collect(),
        (Plot::Coefficient, _) => friction::coefficient(plan, records).into_iter().collect(),
        (Plot::Area, _) => friction::area(plan, outcome).into_iter().collect(),
        (Plot::Moduli, _) => plan.relaxation().map(shape::moduli).into_iter().collect(),
        (Plot::Restitution, _) => outcome.table("impacts").and_then(impacts::restitution).into_iter().collect(),
    }
}

/// The angles of every oblique impact.
fn oblique(plan: &Plan, outcome: &Outcome) -> Vec<Panel> {
    let Plan::Impact(plan) = plan else { return Vec::new() };
    let tables = outcome.table("incidence").zip(outcome.table("impacts"));
    let panels = tables.and_then(|(table, impacts)| impacts::incidence(plan.impact.incidence(), table, impacts));
    panels.unwrap_or_default()
}

/// Force against indentation, and against time where the bodies remember.
fn force(plan: &Plan, records: &[Record]) -> Vec<Panel> {
    let column = if plan.scene.shape.is_plane() { LINE_FORCE } else { FORCE };
    let mut panels = vec![against_depth(plan, records, &column, axis_of(&column))];
    if plan.relaxation().is_some() {
        panels.extend([FORCE, INDENTATION].iter().map(|column| against_time(records, column)));
        panels.extend(last_loop(plan, records));
    }
    panels
}

/// Contact radius against indentation, and against time where the bodies remember.
fn radius(plan: &Plan, records: &[Record]) -> Vec<Panel> {
    let column = if plan.scene.shape.is_plane() { HALF_WIDTH } else { CONTACT_RADIUS };
    let by_depth = against_depth(plan, records, &column, axis_of(&column).from(0.0));
    let over_time = plan.relaxation().map(|_| against_time(records, &column));
    std::iter::once(by_depth).chain(over_time).collect()
}

/// Force against indentation in the last oscillation alone, where nothing else hides it.
fn last_loop(plan: &Plan, records: &[Record]) -> Option<Panel> {
    let entry = plan.scene.history.iter().rposition(|entry| matches!(entry, Entry::Oscillate(_)))?;
    let inside: Vec<Record> = records.iter().filter(|record| record.entry == entry).copied().collect();
    let series = Series::new("", of_records(&inside, &INDENTATION, &FORCE)).arrow();
    Some(Panel::new(axis_of(&INDENTATION), axis_of(&FORCE)).titled("oscillation").with(series))
}

fn energy(records: &[Record]) -> Panel {
    let of = |value: fn(&Record) -> f64| records.iter().map(|record| (record.time, value(record))).collect::<Vec<_>>();
    let mut panel = Panel::new(Axis::linear("time t", "s"), Axis::linear("energy", "J"))
        .with(Series::new("elastic", of(|record| record.normal.stored.elastic)));
    if records.iter().any(|record| record.normal.stored.surface.abs() > 0.0) {
        panel = panel.with(Series::new("surface", of(|record| record.normal.stored.surface)));
    }
    panel.with(Series::new(
        "dissipated",
        of(|record| record.normal.dissipated + record.tangential.and_then(|state| state.dissipated).unwrap_or(0.0)),
    ))
}
