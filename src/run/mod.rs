//! A scene run from its first touch to the end of its history.

mod conditioning;
mod contact;
pub mod curves;
mod ensemble;
mod error;
mod fields;
mod follow;
mod fretting;
mod relaxing;
mod plane;
pub mod named;
pub mod record;
mod results;
mod rough;
mod shear;
mod strike;
pub mod table;
pub mod unit;
mod warnings;

pub use contact::{ContactError, Drive, Event, Loop, Moment, NormalContact, Springs};
pub use plane::PlaneError;
pub use rough::LineTooShort;
pub use shear::{TangentialContact, sheared};

use crate::contact::adhesion::line::EdgeLine;
use crate::contact::adhesion::range::RangeDisc;
use crate::contact::direct::{Attraction, QuasiStatic};
use crate::contact::foundation::HalfSpace;
use crate::contact::springs::{SpringBed, reach_for};
use crate::input::problem::Problem;
use crate::run::record::Outcome;
use crate::scene::law::{ContactLaw, ElasticAdhesion};
use crate::scene::parts::Parts;
use crate::scene::plan::{Plan, RoundPlan};
use follow::{Run, follow};
use std::num::NonZeroUsize;

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
    /// Where in the contact friction takes its energy.
    pub fretting: bool,
}

impl Wanted {
    /// Records and results only.
    pub const NOTHING: Self = Self { fields: false, stresses: false, fretting: false };
}

/// The contact of a run: what presses, and what rubs if the scene has friction.
pub(super) struct Contact<'p> {
    normal: Box<dyn NormalContact + 'p>,
    tangential: Option<Box<dyn TangentialContact + 'p>>,
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
    let mut outcome = match plan {
        Plan::Round(plan) => run_round(plan, wanted),
        Plan::Impact(plan) => strike::run(plan, wanted),
        Plan::Plane(plan) => plane::run(plan, wanted),
        Plan::Rough(plan) => rough::run(plan, done),
    }?;
    let pressure = fields::pressure_table(&outcome.fields, &outcome.records);
    outcome.tables.splice(0..0, pressure);
    outcome.warnings.extend(warnings::of(plan, &outcome.records));
    let shape = warnings::error_of_shape(plan).filter(|shape| shape.relative > outcome.error_estimate.relative);
    outcome.error_estimate = shape.unwrap_or(outcome.error_estimate);
    Ok(outcome)
}

/// Leads a round contact through its history.
///
/// The order: each stage is followed record by record, jumps between records included; then the named results
/// are read off the records.
fn run_round(plan: &RoundPlan, wanted: Wanted) -> Result<Outcome, SimulationError> {
    let mut run = follow(&plan.stages, contact(plan, wanted)?, wanted)?;
    let stresses = if wanted.stresses { run.stresses(plan) } else { None };
    let path = run.tangential.as_ref().map_or(&[][..], |tangential| tangential.path());
    let fretting = fretting::map(plan, path);
    let mut results = results::named(Some(&plan.contact), &run.records, &run.fields);
    results.extend(results::of_friction(plan, &run.records));
    results.extend(relaxing::results(plan, &run));
    run.notes.extend(relaxing::remark(&run));
    Ok(Outcome {
        error_estimate: error::estimate(plan, &run),
        plan: parts(plan, &run),
        records: std::mem::take(&mut run.records),
        fields: std::mem::take(&mut run.fields),
        tables: [stresses, fretting].into_iter().flatten().collect(),
        results,
        warnings: std::mem::take(&mut run.notes),
    })
}

/// The plan in words, with the springs and bytes that are known from the run alone.
fn parts(plan: &RoundPlan, run: &Run<'_>) -> Parts {
    let parts = plan.parts();
    if plan.contact.relaxation().is_none() {
        return parts;
    }
    let (bytes, springs) = run.tangential.as_ref().map_or((0, 0), |part| (part.bytes(), part.springs()));
    Parts { state_bytes: run.bytes + bytes, springs: run.contact.springs() + springs, ..parts }
}

/// The contact of a scene, bodies just touching.
fn contact(plan: &RoundPlan, wanted: Wanted) -> Result<Contact<'_>, SimulationError> {
    let mut bed_radius = 0.0;
    let normal: Box<dyn NormalContact> = match &plan.contact {
        ContactLaw::Direct(adhesion) => Box::new(direct(plan.ground(), *adhesion)?),
        ContactLaw::Springs { count, work } => {
            let bed = springs_under(plan, *count, *work)?;
            bed_radius = bed.1;
            Box::new(bed.0)
        }
        ContactLaw::Continuous { relaxation, edge } => relaxing::continuous(plan, relaxation, edge.as_ref()),
        ContactLaw::ViscoelasticSprings { relaxation, count } => relaxing::springs(plan, relaxation, count.get()),
    };
    let kept = (wanted.fretting && fretting::is_fretting(plan)).then(Vec::new);
    let tangential = plan.friction.as_ref().map(|law| shear::of(plan, law, bed_radius, kept)).transpose()?;
    Ok(Contact { normal, tangential })
}

/// The direct path on a ground, bodies just touching.
///
/// # Errors
/// The attraction has no contact.
pub fn direct(ground: HalfSpace, adhesion: ElasticAdhesion) -> Result<QuasiStatic, SimulationError> {
    let mut contact = match adhesion {
        ElasticAdhesion::None => QuasiStatic::new(EdgeLine::new(ground, 0.0)),
        ElasticAdhesion::Vanishing { work } => QuasiStatic::new(EdgeLine::new(ground, work)),
        ElasticAdhesion::Finite { work, stress } => {
            let disc = RangeDisc::new(ground, work, stress);
            QuasiStatic::new(disc.map_err(|error| SimulationError::Refused(error.to_string()))?)
        }
    };
    if let Attraction::Range(_) = contact.attraction() {
        // The bodies have come from far away: at d = 0 they attract each other already.
        contact.indent(0.0).map_err(|source| SimulationError::Contact { entry: 0, source: source.into() })?;
    }
    Ok(contact.without_losses())
}

/// A bed of `springs` springs that is just wide enough for the history, as the direct path finds it,
/// and its half width [m].
fn springs_under(
    plan: &RoundPlan,
    springs: NonZeroUsize,
    work: Option<f64>,
) -> Result<(Springs, f64), SimulationError> {
    let adhesion = work.map_or(ElasticAdhesion::None, |work| ElasticAdhesion::Vanishing { work });
    let normal = Box::new(direct(plan.ground(), adhesion)?);
    let run = follow(&plan.stages, Contact { normal, tangential: None }, Wanted::NOTHING)?;
    let largest = run.records.iter().filter_map(|record| record.normal.contact_radius).fold(0.0, f64::max);
    let reach = reach_for(plan.profile.as_ref(), largest);
    let bed = SpringBed::new(plan.ground(), (springs.get(), reach), work.unwrap_or(0.0));
    Ok((Springs::new(bed), reach))
}
