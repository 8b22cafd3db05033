//! Histories that end in the motion of a machine.

mod along;
mod bounces;
mod halved;
mod led;
mod normal;
mod rated;
mod slips;

pub use rated::steady_sliding;

use super::error;
use super::follow::{Run, follow};
use super::named::Named;
use super::record::{ErrorEstimate, Outcome, Record};
use super::results::{self, Pressures};
use super::table::Table;
use super::{SimulationError, Solved, Wanted, compose};
use crate::contact::model::Effort;
use crate::drive::machine::{MachineError, MassMoment};
use crate::material::Relaxation;
use crate::run::unit::Unit;
use crate::scene::law::MachineLaw;
use crate::scene::plan::RoundPlan;
use std::sync::Arc;

/// What a machine has done.
struct Moved {
    records: Vec<Record>,
    tables: Vec<Table>,
    results: Vec<Named>,
    warnings: Vec<String>,
    /// What happened to a mass along the normal.
    moments: Vec<MassMoment>,
    errors: Errors,
    /// How far it is from another run, if there was one, and what that was.
    error: Option<(f64, &'static str)>,
    /// The least force [N] that a mass along the normal has passed on the way out.
    least: Option<f64>,
}

/// Largest errors of the contact at the records of a motion: of its force [N] and of its radius [m].
#[derive(Debug, Clone, Copy, Default)]
struct Errors {
    force: f64,
    radius: f64,
}

impl Errors {
    fn note(&mut self, effort: &Effort) {
        self.force = self.force.max(effort.force_error.unwrap_or(0.0));
        self.radius = self.radius.max(effort.radius_error.unwrap_or(0.0));
    }
}

/// Leads a contact through its history, and then lets the machine move it.
///
/// # Errors
/// The contact would leave its profile, or the machine is too fast to be followed.
pub(super) fn run(plan: &RoundPlan, law: &MachineLaw, wanted: Wanted) -> Result<Solved, SimulationError> {
    let mut before = follow(plan, compose::contact(plan, wanted)?, wanted)?;
    let moved = match plan.contact.bodies().relaxation() {
        _ if law.is_along() => along::run(plan, law, &before)?,
        Some(relaxation) => halved::run(plan, relaxation, (law, &before))?,
        None if plan.contact.bodies().adheres() => halved::run(plan, &Arc::new(unrelaxed(plan)), (law, &before))?,
        None => normal::run(law, &mut before)?,
    };
    // A mass that falls has never been where the history begins.
    if law.falls() {
        before.records.clear();
    }
    before.force_error = before.force_error.max(moved.errors.force);
    before.radius_error = before.radius_error.max(moved.errors.radius);
    let energy_error = energy_error(&moved.records);
    before.records.extend(moved.records);
    let error_estimate = estimate(plan, &before, (energy_error, moved.error));
    let records = before.records;
    let mut results =
        results::named(Some(&plan.contact), &records, &Pressures { fields: &before.fields, at_greatest_force: None });
    if let Some((told, least)) = results::pull_off(&records).zip(moved.least)
        && least < told
    {
        results.iter_mut().for_each(|named| named.scale("pull_off_force", least / told));
    }
    results.extend(results::of_friction(plan, &records));
    results.extend(moved.results);
    results.push(Named::number("energy_error", Unit::ONE, energy_error));
    let outcome = Outcome {
        map: None,
        error_estimate,
        plan: plan.parts(),
        tables: moved.tables,
        results,
        warnings: before.notes.into_iter().chain(moved.warnings).collect(),
        records,
        fields: before.fields,
    };
    Ok(Solved::without_load(outcome))
}

/// Elastic bodies as bodies that remember nothing.
fn unrelaxed(plan: &RoundPlan) -> Relaxation {
    Relaxation { equilibrium: plan.pair.normal, terms: Vec::new(), viscosity: 0.0 }
}

/// How far work from outside and what has become of it are apart, as a part of the largest of them.
fn energy_error(records: &[Record]) -> f64 {
    let largest = records.iter().filter_map(|record| Some(record.machine?.work.abs())).fold(0.0, f64::max);
    let off = records.iter().filter_map(off_balance).fold(0.0, f64::max);
    if off > 0.0 { off / largest.max(off) } else { 0.0 }
}

/// Work from outside less all that is kept or lost [J].
fn off_balance(record: &Record) -> Option<f64> {
    let (machine, normal) = (record.machine?, record.normal);
    let kept = machine.kinetic + machine.spring + machine.sheared.unwrap_or(0.0) + normal.stored.stored();
    let rubbed = record.tangential.and_then(|state| state.dissipated).unwrap_or(0.0);
    Some((machine.work - kept - machine.damped - rubbed - normal.dissipated).abs())
}

/// Least error that is told of a motion in steps.
const STEPS: f64 = 1e-11;

/// The error of a run with its motion, whose energies are apart by `open`, from that of the contact and from another run, if
/// there was one.
fn estimate(plan: &RoundPlan, run: &Run, (open, steps): (f64, Option<(f64, &'static str)>)) -> ErrorEstimate {
    let contact = error::estimate(plan, run);
    let relative = open.max(STEPS);
    if let Some((error, basis)) = steps {
        return ErrorEstimate { relative: error.max(relative).max(contact.relative), basis: basis.to_owned() };
    }
    if contact.relative > relative {
        return contact;
    }
    let basis = "motion of the mass in extrapolated steps of 1e-13: work from outside against what is kept and lost";
    ErrorEstimate { relative, basis: basis.to_owned() }
}

/// A failure of the machine in an entry.
fn failed(entry: usize) -> impl Fn(MachineError) -> SimulationError {
    move |source| SimulationError::Machine { entry, source }
}
