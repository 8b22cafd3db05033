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
use crate::scene::plan::Plan;
use crate::shape::Rim;
pub use comparison::comparison_figure;
use curve::{against_depth, against_time, axis_of, of_records};

/// The force of a plane contact: per length.
const LINE_FORCE: Column<Record> = Column { label: "force per length F", unit: Unit::NEWTON_PER_METRE, ..FORCE };
/// Half the width of a plane contact.
const HALF_WIDTH: Column<Record> = Column { label: "half width a", ..CONTACT_RADIUS };

/// The figure of a scene: one panel per plot wanted.
#[must_use]
pub fn figures(setup: &Plan, outcome: &Outcome) -> Figure {
    let wanted = setup.scene.plots.clone().unwrap_or_else(|| suiting(setup, outcome));
    let panels = wanted.iter().flat_map(|plot| panels(*plot, setup, outcome)).chain(oblique(setup, outcome));
    panels.fold(Figure::new(setup.scene.title.clone()), Figure::with)
}

/// What suits a scene that asks for nothing.
fn suiting(setup: &Plan, outcome: &Outcome) -> Vec<Plot> {
    if setup.surface().is_some() {
        return rough::SUITING.to_vec();
    }
    if setup.scene.shape.is_plane() {
        return vec![Plot::Force, Plot::Radius, Plot::Pressure];
    }
    if let Some(impacts) = outcome.table("impacts") {
        return match impacts.rows() {
            1 if outcome.table("incidence").is_some() => vec![Plot::Force],
            1 => vec![Plot::Force, Plot::Pressure],
            _ => vec![Plot::Restitution],
        };
    }
    if outcome.records.iter().any(|record| record.tangential.is_some()) {
        return friction::suiting(setup, outcome);
    }
    let mut plots = vec![Plot::Force, Plot::Radius];
    if !outcome.fields.is_empty() {
        plots.push(Plot::Pressure);
    }
    if setup.scene.friction.is_none() && setup.profile().is_some_and(|profile| !matches!(profile.rim(), Rim::Wall(_))) {
        plots.push(Plot::Shape);
    }
    plots
}

fn panels(plot: Plot, setup: &Plan, outcome: &Outcome) -> Vec<Panel> {
    if let Some(surface) = setup.surface() {
        return rough::panels(plot, setup, surface, outcome);
    }
    let records = &outcome.records;
    match plot {
        Plot::Force if outcome.table("impacts").is_some() => {
            let loop_of = against_depth(setup, records, &FORCE, axis_of(&FORCE));
            impacts::over_time(records).into_iter().chain([loop_of]).collect()
        }
        Plot::Force => force(setup, records),
        Plot::Radius => radius(setup, records),
        Plot::Pressure => vec![fields::pressure(setup, outcome)],
        Plot::Stress => vec![fields::stress(outcome)],
        Plot::Energy => vec![energy(records)],
        Plot::Shape => setup.profile().map(|profile| shape::profile(profile, outcome)).into_iter().collect(),
        Plot::Friction => vec![friction::loops(setup, records)],
        Plot::Stick => vec![friction::stick(records)],
        Plot::Shear => friction::stress(setup, outcome).into_iter().collect(),
        Plot::Fretting => friction::fretting(outcome).into_iter().collect(),
        Plot::Coefficient => friction::coefficient(setup, records).into_iter().collect(),
        Plot::Area => friction::area(setup, outcome).into_iter().collect(),
        Plot::Moduli => setup.relaxation().map(shape::moduli).into_iter().collect(),
        Plot::Restitution => outcome.table("impacts").and_then(impacts::restitution).into_iter().collect(),
    }
}

/// The angles of every oblique impact.
fn oblique(setup: &Plan, outcome: &Outcome) -> Vec<Panel> {
    let angle = setup.scene.history.iter().find_map(|entry| match entry {
        Entry::Impact(impact) => Some(impact.incidence()),
        _ => None,
    });
    let tables = outcome.table("incidence").zip(outcome.table("impacts"));
    let panels = tables.zip(angle).and_then(|((table, impacts), angle)| impacts::incidence(angle, table, impacts));
    panels.into_iter().flatten().collect()
}

/// Force against indentation, and against time where the bodies remember.
fn force(setup: &Plan, records: &[Record]) -> Vec<Panel> {
    let column = if setup.scene.shape.is_plane() { LINE_FORCE } else { FORCE };
    let mut panels = vec![against_depth(setup, records, &column, axis_of(&column))];
    if setup.relaxation().is_some() {
        panels.extend([FORCE, INDENTATION].iter().map(|column| against_time(records, column)));
        panels.extend(last_loop(setup, records));
    }
    panels
}

/// Contact radius against indentation, and against time where the bodies remember.
fn radius(setup: &Plan, records: &[Record]) -> Vec<Panel> {
    let column = if setup.scene.shape.is_plane() { HALF_WIDTH } else { CONTACT_RADIUS };
    let by_depth = against_depth(setup, records, &column, axis_of(&column).from(0.0));
    let over_time = setup.relaxation().map(|_| against_time(records, &column));
    std::iter::once(by_depth).chain(over_time).collect()
}

/// Force against indentation in the last oscillation alone, where nothing else hides it.
fn last_loop(setup: &Plan, records: &[Record]) -> Option<Panel> {
    let entry = setup.scene.history.iter().rposition(|entry| matches!(entry, Entry::Oscillate(_)))?;
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
