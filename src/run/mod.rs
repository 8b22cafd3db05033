//! A scene run from its first touch to the end of its history.
//!
//! # Examples
//! ```
//! # #[cfg(feature = "text")] {
//! use springbed::prelude::*;
//!
//! let text = r#"(shape: Paraboloid(radius: 1), bodies: (Elastic(young: 1, poisson: 0), Rigid), adhesion: Jkr(work: 1),
//!     history: [Press(to: 1, over: 1), Retract(speed: 0.1)])"#;
//! let plan = Notation::Ron.plan(text, &InMemory::default()).map_err(|errors| errors[0].clone())?;
//! let outcome = run(&plan, Wanted::NOTHING)?;
//! let pull_off = outcome.number("pull_off_force_n").unwrap();
//! assert!((pull_off + 1.5 * std::f64::consts::PI).abs() < 0.2, "{pull_off}");
//! assert!(outcome.error_estimate.relative < 1e-9);
//! # }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod bed;
mod conditioning;
mod compose;
pub mod curves;
mod ensemble;
mod error;
mod fields;
mod follow;
#[cfg(feature = "half-space")]
pub mod half_space;
mod fretting;
mod pad;
mod plane;
mod plastic;
mod gliding;
mod rolling;
pub mod named;
pub mod record;
mod results;
mod rough;
mod stresses;
mod surface;
mod impact;
mod machine;
pub mod table;
pub mod unit;
mod unloading;
mod warnings;
mod wave;
mod wear;
mod viscoelastic;

pub use crate::contact::error::ContactError;
pub use compose::{direct, sheared};
pub use machine::steady_sliding;
pub use plane::in_pieces;
pub use warnings::tabor_parameter;

use crate::drive::impact::ImpactError;
use crate::drive::machine::MachineError;
use crate::input::problem::Problem;
use crate::run::record::{Outcome, Record};
use crate::scene::parts::Parts;
use crate::scene::plan::{Plan, RoundPlan};
use curves::sliding;
use follow::{Run, follow};
use named::Named;
use results::Pressures;
use rolling::Rolled;
use stresses::Carried;

/// Why a scene could not be run to its end.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SimulationError {
    /// The contact cannot follow what an entry prescribes.
    #[error("history[{entry}]: {source}")]
    Contact {
        /// Number of the entry.
        entry: usize,
        /// Why.
        source: ContactError,
    },
    /// A machine cannot be followed.
    #[error("history[{entry}]: {source}")]
    Machine {
        /// Number of the entry.
        entry: usize,
        /// Why.
        source: MachineError,
    },
    /// An impact leaves what can be followed.
    #[error("history[0]: {0}")]
    Impact(#[from] ImpactError),
    /// The scene holds a part that cannot be computed.
    #[error("{0}")]
    Refused(String),
}

impl From<Vec<Problem>> for SimulationError {
    fn from(problems: Vec<Problem>) -> Self {
        let all: Vec<String> = problems.iter().map(ToString::to_string).collect();
        Self::Refused(all.join("; "))
    }
}

/// What is wanted beside records and results; what is not asked for is not computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Wanted {
    /// Pressure and surface profiles.
    pub fields: bool,
    /// Stresses below the surface.
    pub stresses: bool,
    /// The springs of the bed at the greatest force and at the end.
    pub bed: bool,
    /// The surfaces of both bodies at the greatest force.
    pub surface: bool,
    /// Where in the contact friction takes its energy.
    pub fretting: bool,
    /// Records of what happens between those asked for: turns of the force, jumps.
    pub instants: bool,
}

impl Wanted {
    /// Records and results only.
    pub const NOTHING: Self =
        Self { fields: false, stresses: false, bed: false, surface: false, fretting: false, instants: true };
}

/// What a solver finds, and the load of the contact at its greatest force where that was asked for.
struct Solved {
    outcome: Outcome,
    carried: Option<Carried>,
}

impl Solved {
    fn without_load(outcome: Outcome) -> Self {
        Self { outcome, carried: None }
    }
}

/// Names of the tables that an outcome of the plan can have beside its records.
#[must_use]
pub fn tables(plan: &Plan) -> &'static [&'static str] {
    match plan {
        Plan::Round(_) => &[
            "pressure",
            "stress",
            "bed",
            "surface",
            "fretting",
            "glides",
            "tractions",
            "rolling",
            "profiles",
            "bounces",
            "slips",
        ],
        Plan::Impact(_) => &["pressure", "stress", "impacts", "incidence"],
        Plan::Plane(_) => &["pressure"],
        Plan::Pad(_) => &[],
        Plan::Rough(_) => &["ensemble", "glides"],
        Plan::RoughImpact(_) => &["ensemble", "impacts"],
        Plan::HalfSpace(_) => &["distribution", "glides"],
    }
}

/// Runs a scene.
///
/// # Errors
/// The contact would leave its profile, or cannot be followed.
pub fn run(plan: &Plan, wanted: Wanted) -> Result<Outcome, SimulationError> {
    run_watched(plan, wanted, &|_| ())
}

/// Runs a scene; `done` is told the share of the work that is behind, from any thread, where it is long.
///
/// # Errors
/// As for [`run`].
pub fn run_watched(plan: &Plan, wanted: Wanted, done: &(dyn Fn(f64) + Sync)) -> Result<Outcome, SimulationError> {
    let told = wanted.stresses || wanted.fields && stresses::are_at_hand(plan);
    let kept = Wanted { stresses: told || warnings::can_yield(plan), ..wanted };
    let Solved { mut outcome, carried } = match plan {
        Plan::Round(plan) => run_round(plan, kept),
        Plan::Impact(plan) => impact::run(plan, kept),
        Plan::Plane(plan) => plane::run(plan, wanted).map(Solved::without_load),
        Plan::Rough(plan) => rough::run(plan, done).map(Solved::without_load),
        Plan::RoughImpact(plan) => impact::rough::run(plan, done).map(Solved::without_load),
        Plan::Pad(plan) => pad::run(plan, wanted).map(Solved::without_load),
        Plan::HalfSpace(plan) => half_space::run(plan, wanted, done).map(Solved::without_load),
    }?;
    let pressure = fields::pressure_table(&outcome.fields, &outcome.records);
    let mapped = carried.as_ref().filter(|_| wanted.stresses);
    let stresses = mapped.and_then(|carried| stresses::table(plan, carried));
    outcome.tables.splice(0..0, pressure.into_iter().chain(stresses));
    outcome.results.extend(carried.iter().flat_map(|carried| stresses::results(plan, carried)));
    outcome.results.extend(mapped.map(stresses::unit));
    outcome.warnings.extend(warnings::of(plan, &outcome.records));
    outcome.warnings.extend(carried.iter().flat_map(|carried| stresses::warnings(plan, carried)));
    outcome.warnings.extend(mapped.and_then(|carried| stresses::remark(plan, carried)));
    if let (Some(ratio), false) = (warnings::pressure_on_ellipse(plan), matches!(plan, Plan::HalfSpace(_))) {
        outcome.results.iter_mut().for_each(|named| named.scale("peak_pressure", ratio));
    }
    let on_pixels = matches!(plan, Plan::HalfSpace(_));
    let shape = warnings::error_of_shape(plan, &outcome.records)
        .filter(|shape| !on_pixels && shape.relative > outcome.error_estimate.relative);
    outcome.error_estimate = shape.unwrap_or(outcome.error_estimate);
    if let Some(times) = plan.times() {
        outcome.error_estimate.relative += times.error();
        outcome.error_estimate.basis.push_str("; and the series that stands for the power law");
    }
    Ok(outcome)
}

/// Without the solver a scene that asks for it is refused before.
#[cfg(not(feature = "half-space"))]
mod half_space {
    use super::{Outcome, SimulationError, Wanted};
    use crate::scene::plan::HalfSpacePlan;

    pub(super) fn run(_: &HalfSpacePlan, _: Wanted, _: &(dyn Fn(f64) + Sync)) -> Result<Outcome, SimulationError> {
        Err(SimulationError::Refused("solver: this program was built without the half-space".to_owned()))
    }
}

/// Leads a round contact through its history.
///
/// The order: each stage is followed record by record, jumps between records included; then the named results
/// are read off the records.
fn run_round(plan: &RoundPlan, wanted: Wanted) -> Result<Solved, SimulationError> {
    if let Some(law) = plan.wear {
        return wear::run(plan, law, wanted);
    }
    if let Some(law) = &plan.machine {
        return machine::run(plan, law, wanted);
    }
    run_unworn(plan, wanted)
}

/// Leads a round contact through its history; the profile stays as it is.
fn run_unworn(plan: &RoundPlan, wanted: Wanted) -> Result<Solved, SimulationError> {
    let contact = compose::contact(plan, wanted)?;
    let led = || follow(plan, contact, wanted);
    let (run, again) = if error::goes_twice(plan) { rayon::join(led, || error::again(plan)) } else { (led(), None) };
    let mut run = run?;
    if let Some(stiffness) = plan.spring {
        run.records.iter_mut().for_each(|record| record.spring = spring(record, stiffness));
    }
    let fretting = fretting::map(plan, run.path());
    let glides = gliding::steady(plan, &run.records)?;
    let rolled = rolling::steady(plan, &run.records)?;
    let pressures = Pressures { fields: &run.fields, at_greatest_force: run.peak_at_greatest_force() };
    let mut results = results::named(Some(&plan.contact), &run.records, &pressures);
    results.extend(own_results(plan, &run));
    results.extend(gliding::results(plan.travel.as_ref(), &run.records, &glides));
    results.extend(rolled.iter().flat_map(Rolled::results));
    let warnings = own_warnings(plan, &run).chain(rolled.iter().filter_map(Rolled::remark)).collect();
    let estimate = gliding::at_least(error::beside(plan, &run, again.as_deref()), &glides, gliding::OF_CHORDS);
    let outcome = Outcome {
        map: None,
        error_estimate: match &rolled {
            Some(rolled) => rolled.at_least(estimate),
            None => estimate,
        },
        plan: parts(plan, &run),
        tables: bed::table(&run)
            .into_iter()
            .chain(surface::table(plan, &run))
            .chain(fretting)
            .chain(gliding::table(&glides))
            .chain(rolled.iter().flat_map(Rolled::tables))
            .collect(),
        results,
        warnings,
        records: run.records,
        fields: run.fields,
    };
    Ok(Solved { outcome, carried: run.carried })
}

/// What the parts of a round contact say of its records.
fn own_results(plan: &RoundPlan, run: &Run) -> impl Iterator<Item = Named> {
    let of_past = viscoelastic::results(plan, run).into_iter().chain(plastic::results(plan, &run.records));
    let of_shape = unloading::results(plan, &run.records).into_iter().chain(wave::results(plan, &run.records));
    results::of_friction(plan, &run.records).into_iter().chain(of_past).chain(of_shape)
}

/// What a reader of its records should know.
fn own_warnings(plan: &RoundPlan, run: &Run) -> impl Iterator<Item = String> {
    let of_past = run.notes.iter().cloned().chain(viscoelastic::remark(run));
    let of_shape = wave::remark(plan, &run.records).into_iter().chain(unloading::remark(plan, &run.records));
    of_past.chain(sliding::short_slides(plan, &run.records)).chain(of_shape).chain(gliding::remark(plan))
}

/// Where the far end of a spring of the stiffness `stiffness` [N/m] is that carries a contact [m], and its energy [J].
fn spring(record: &Record, stiffness: f64) -> Option<(f64, f64)> {
    let way = record.normal.force / stiffness;
    Some((record.normal.indentation? + way, 0.5 * record.normal.force * way))
}

/// The plan in words, with the springs and bytes that are known from the run alone.
fn parts(plan: &RoundPlan, run: &Run) -> Parts {
    let parts = plan.parts();
    match plan.contact.bodies().relaxation() {
        None => parts,
        Some(_) => Parts { state_bytes: run.effort.bytes, springs: run.effort.springs, ..parts },
    }
}
