//! The figures a scene asks for, or those that suit it.

mod bed;
mod comparison;
mod curve;
mod fields;
mod fit;
mod friction;
mod gliding;
mod impacts;
mod machine;
mod overlay;
mod pixels;
mod rolling;
mod rough;
mod shape;
mod stress;
mod surface;
mod sweep;
mod wear;

use crate::app::figure::{Axis, Figure, Panel, Series};
use crate::run::curves::between::filled;
use crate::run::record::{CONTACT_RADIUS, FORCE, INDENTATION, JOINED_SHARE, Outcome, Record};
use crate::run::table::Column;
use crate::run::unit::Unit;
use crate::scene::Plot;
use crate::scene::plan::{ImpactPlan, Plan, RoughPlan, RoundPlan};
use crate::shape::{Cylinder, PlaneWave, PlaneWavy, Rim, Shape};
pub use comparison::comparison_figure;
use curve::{against_depth, against_time, axis_of, of_records};
pub use fit::{fit_figure, map_figure, models_figure, spectrum_figure};
pub use overlay::overlay_figure;
pub use sweep::sweep_figure;

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
        Plan::Round(_) if outcome.table("profiles").is_some() => vec![Plot::Wear, Plot::Stick, Plot::Force],
        Plan::Round(RoundPlan { machine: Some(law), friction, .. }) => machine::suiting(law, friction.as_ref()),
        Plan::Round(RoundPlan { friction: Some(law), .. }) if slides(outcome) => friction::suiting(law, outcome),
        Plan::Round(RoundPlan { travel: Some(travel), .. }) => gliding::suiting(travel),
        Plan::Round(RoundPlan { rolling: Some(_), .. }) => rolling::suiting(outcome),
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
        Plan::Pad(_) => vec![Plot::Force, Plot::Energy],
        Plan::Rough(RoughPlan { travel: Some(travel), .. }) => {
            gliding::suiting(travel).into_iter().chain([Plot::Shape]).collect()
        }
        Plan::Rough(rough) => rough::suiting(rough),
        Plan::RoughImpact(impact) if impact.impact.speed.len() > 1 => vec![Plot::Restitution],
        Plan::RoughImpact(_) => vec![Plot::Force, Plot::Shape],
        Plan::HalfSpace(plan) => pixels::suiting(plan, outcome),
    }
}

/// Whether a body slides in the records of an outcome.
fn slides(outcome: &Outcome) -> bool {
    outcome.records.iter().filter_map(|record| record.tangential).any(|state| state.slide.abs() > 0.0)
}

/// The contact radius, of a section its half width.
fn radius_of(plan: &Plan) -> &'static Column<Record> {
    if plan.scene.shape.is_plane() { &HALF_WIDTH } else { &CONTACT_RADIUS }
}

/// Force over depth: per length of a section without a width.
fn force_of(plan: &Plan) -> &'static Column<Record> {
    match &plan.scene.shape {
        Shape::Cylinder(Cylinder { width: None, .. })
        | Shape::PlaneWave(PlaneWave { width: None, .. })
        | Shape::PlaneWavy(PlaneWavy { width: None, .. }) => &LINE_FORCE,
        _ => &FORCE,
    }
}

fn panels(plot: Plot, plan: &Plan, outcome: &Outcome) -> Vec<Panel> {
    let records = &outcome.records;
    match plot {
        Plot::Force => force(plan, outcome),
        Plot::Radius => radius(plan, records),
        Plot::Pressure => vec![fields::pressure(plan, outcome)],
        Plot::Stress => stress::panels(outcome),
        Plot::Field => stress::fields(outcome),
        Plot::Bed => bed::panels(outcome),
        Plot::Surface => surface::panels(plan, outcome),
        Plot::Energy => vec![energy(records)],
        Plot::Shape => indenter(plan, outcome).into_iter().collect(),
        Plot::Friction => vec![friction::loops(plan, records)],
        Plot::Stick | Plot::Shear => match (plan, plot) {
            (Plan::HalfSpace(_), Plot::Stick) => vec![pixels::stick(records)],
            (Plan::HalfSpace(_), _) => pixels::shear(outcome).into_iter().collect(),
            (_, Plot::Stick) => vec![friction::stick(plan, records)],
            (_, _) => friction::stress(plan, outcome).into_iter().collect(),
        },
        Plot::Fretting => friction::fretting(outcome).into_iter().collect(),
        Plot::Wear => wear::panels(outcome),
        Plot::Coefficient => vec![friction::coefficient(plan, records)],
        Plot::Contact => pixels::contact(outcome).into_iter().collect(),
        Plot::Distribution => pixels::distribution(outcome),
        Plot::Leak => pixels::leak(outcome).into_iter().collect(),
        Plot::Area => area(plan, outcome).into_iter().collect(),
        Plot::Moduli => {
            plan.relaxation().map(|relaxation| shape::moduli(relaxation, plan, outcome)).into_iter().collect()
        }
        Plot::Resistance => plan.travel().map_or_else(Vec::new, |travel| gliding::resistance(travel, outcome)),
        Plot::Traction => rolling::traction(outcome),
        Plot::Machine => plan
            .round()
            .and_then(|round| round.machine.as_ref())
            .map_or_else(Vec::new, |law| machine::panels(law, outcome)),
        Plot::Restitution => outcome.table("impacts").and_then(impacts::restitution).into_iter().collect(),
    }
}

/// The area that touches: that of the pixels, or that of a round contact.
fn area(plan: &Plan, outcome: &Outcome) -> Option<Panel> {
    match plan {
        Plan::HalfSpace(pixels) => Some(pixels::area(plan, pixels, outcome)),
        Plan::Round(_) | Plan::Impact(_) | Plan::Plane(_) | Plan::Rough(_) | Plan::RoughImpact(_) | Plan::Pad(_) => {
            friction::area(plan, outcome)
        }
    }
}

/// The profile, or the line that stands for a rough surface; a plane section has neither.
fn indenter(plan: &Plan, outcome: &Outcome) -> Option<Panel> {
    match plan {
        Plan::Round(RoundPlan { profile, .. }) | Plan::Impact(ImpactPlan { profile, .. }) => {
            Some(shape::profile(profile.as_ref(), outcome, fields::across(plan)))
        }
        Plan::Rough(rough) => Some(rough::line(rough)),
        Plan::RoughImpact(impact) => Some(rough::line(&impact.rough)),
        Plan::Plane(_) | Plan::Pad(_) | Plan::HalfSpace(_) => None,
    }
}

/// The angles of every oblique impact.
fn oblique(plan: &Plan, outcome: &Outcome) -> Vec<Panel> {
    let angle = match plan {
        Plan::Impact(plan) => plan.impact.incidence(),
        Plan::Round(_) | Plan::Plane(_) | Plan::Rough(_) | Plan::RoughImpact(_) | Plan::Pad(_) | Plan::HalfSpace(_) => {
            return Vec::new();
        }
    };
    let tables = outcome.table("incidence").zip(outcome.table("impacts"));
    tables.and_then(|(table, impacts)| impacts::incidence(angle, table, impacts)).unwrap_or_default()
}

/// Force against indentation; against time too in an impact and where the bodies remember.
fn force(plan: &Plan, outcome: &Outcome) -> Vec<Panel> {
    let records = &outcome.records;
    let against_depth = |column| against_depth(plan, records, column, axis_of(column));
    match plan {
        Plan::Rough(rough) => {
            let over_time = [FORCE, INDENTATION].map(|column| against_time(records, &column));
            let over_time = over_time.into_iter().filter(|_| rough.relaxation.is_some());
            rough::force(rough, outcome).into_iter().chain(over_time).collect()
        }
        Plan::RoughImpact(_) => {
            let over_time = [INDENTATION, FORCE].map(|column| against_time(records, &column));
            over_time.into_iter().chain([rough::against_depth(outcome)]).collect()
        }
        Plan::Pad(_) => [&FORCE, &JOINED_SHARE].map(against_depth).into(),
        Plan::Plane(_) => vec![against_depth(force_of(plan))],
        Plan::HalfSpace(_) => {
            std::iter::once(against_depth(force_of(plan))).chain(pixels::stiffness(plan, outcome)).collect()
        }
        Plan::Impact(_) => {
            let over_time = impacts::over_time(records, [force_of(plan), radius_of(plan)]);
            over_time.into_iter().chain([against_depth(force_of(plan))]).collect()
        }
        Plan::Round(RoundPlan { machine: Some(_), .. }) => machine::force(records),
        // The same depth carries less as the profile wears.
        Plan::Round(RoundPlan { wear: Some(_), .. }) => {
            [FORCE, INDENTATION].map(|column| against_time(records, &column)).into()
        }
        Plan::Round(round) if round.contact.bodies().relaxation().is_none() => {
            let panel = against_depth(force_of(plan));
            let pull_off = curve::pull_off(records, &panel);
            std::iter::once(panel).chain(pull_off).collect()
        }
        Plan::Round(_) => {
            let over_time = [force_of(plan), &INDENTATION].map(|column| against_time(records, column));
            [against_depth(force_of(plan))].into_iter().chain(over_time).chain(last_loop(plan, records)).collect()
        }
    }
}

/// Contact radius against indentation, and against time where the bodies remember.
fn radius(plan: &Plan, records: &[Record]) -> Vec<Panel> {
    let column = radius_of(plan);
    if plan.round().is_some_and(|round| round.wear.is_some()) {
        return vec![against_time(records, column)];
    }
    let by_depth = against_depth(plan, records, column, axis_of(column).from(0.0));
    let over_time = plan.relaxation().map(|_| against_time(&filled(plan, records), column));
    std::iter::once(by_depth).chain(over_time).collect()
}

/// Force against indentation in the last oscillation alone, where nothing else hides it.
fn last_loop(plan: &Plan, records: &[Record]) -> Option<Panel> {
    let entry = plan.stages.iter().rfind(|stage| stage.normal.is_wave())?.entry;
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
