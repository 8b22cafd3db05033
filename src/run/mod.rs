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

use crate::contact::adhesion::Adhesion;
use crate::contact::adhesion::line::EdgeLine;
use crate::contact::adhesion::range::RangeDisc;
use crate::contact::direct::{Attraction, QuasiStatic};
use crate::contact::springs::{SpringBed, reach_for};
use crate::run::record::Outcome;
use crate::scene::plan;
use crate::scene::setup::Setup;
use follow::follow;
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
/// The order: the plan picks a solver; the history becomes stages; each stage is followed record by
/// record, jumps between records included; then the named results are read off the records.
///
/// # Errors
/// The contact would leave its profile, or cannot be followed.
pub fn run(setup: &Setup, wanted: Wanted) -> Result<Outcome, SimulationError> {
    run_watched(setup, wanted, &|_| ())
}

/// Runs a scene; `done` is told the share of the work that is behind, from any thread, where it is long.
///
/// # Errors
/// As for [`run`].
pub fn run_watched(setup: &Setup, wanted: Wanted, done: &(dyn Fn(f64) + Sync)) -> Result<Outcome, SimulationError> {
    let mut outcome = solved(setup, wanted, done)?;
    let pressure = fields::pressure_table(&outcome.fields, &outcome.records);
    outcome.tables.splice(0..0, pressure);
    outcome.warnings.extend(warnings::of(setup, &outcome.records));
    let shape = warnings::error_of_shape(setup).filter(|shape| shape.relative > outcome.error_estimate.relative);
    outcome.error_estimate = shape.unwrap_or(outcome.error_estimate);
    Ok(outcome)
}

/// What the solver of a scene finds.
fn solved(setup: &Setup, wanted: Wanted, done: &(dyn Fn(f64) + Sync)) -> Result<Outcome, SimulationError> {
    if let Some(surface) = &setup.surface {
        return rough::run(setup, surface, done);
    }
    if let Some(outcome) = plane::run(setup, wanted) {
        return outcome;
    }
    if let Some(impact) = strike::of(setup) {
        return strike::run(setup, impact, wanted);
    }
    let mut plan = plan::of(setup);
    let mut run = follow(setup, contact(setup, wanted)?, wanted)?;
    let mut error_estimate = error::estimate(setup, &run.records);
    if setup.relaxation.is_some() {
        let own = run.tangential.as_ref().map_or((0, 0), |tangential| (tangential.bytes(), tangential.springs()));
        (plan.state_bytes, plan.springs) = (run.bytes + own.0, run.contact.springs() + own.1);
        error_estimate = error::with_friction(setup, relaxing::error_estimate(setup, &run));
    }
    let stresses = if wanted.stresses { run.stresses(setup) } else { None };
    let path = run.tangential.as_ref().map_or(&[][..], |tangential| tangential.path());
    let fretting = fretting::map(setup, path);
    let mut results = results::named(setup, &run.records, &run.fields);
    results.extend(relaxing::results(setup, &run));
    run.notes.extend(relaxing::remark(&run));
    Ok(Outcome {
        records: std::mem::take(&mut run.records),
        fields: std::mem::take(&mut run.fields),
        tables: [stresses, fretting].into_iter().flatten().collect(),
        results,
        error_estimate,
        warnings: std::mem::take(&mut run.notes),
        plan,
    })
}

/// The contact of a scene, bodies just touching.
fn contact(setup: &Setup, wanted: Wanted) -> Result<Contact<'_>, SimulationError> {
    if let Some(relaxation) = &setup.relaxation {
        let tangential = shear::of(setup, None, None)?;
        return Ok(Contact { normal: relaxing::contact(setup, relaxation), tangential });
    }
    let direct = direct(setup)?;
    let Some(springs) = setup.scene.springs else {
        let path = (wanted.fretting && fretting::is_fretting(setup)).then(Vec::new);
        return Ok(Contact { normal: Box::new(direct), tangential: shear::of(setup, None, path)? });
    };
    let (bed, reach) = springs_under(setup, springs, direct)?;
    let tangential = shear::of(setup, Some((springs, reach)), None)?;
    Ok(Contact { normal: Box::new(bed), tangential })
}

/// The direct path of a scene, bodies just touching.
///
/// # Errors
/// The attraction has no contact.
pub fn direct(setup: &Setup) -> Result<QuasiStatic, SimulationError> {
    let ground = setup.ground();
    let mut contact = match &setup.scene.adhesion {
        None => QuasiStatic::new(EdgeLine::new(ground, 0.0)),
        Some(Adhesion::Jkr(jkr)) => QuasiStatic::new(EdgeLine::new(ground, jkr.work.si())),
        Some(Adhesion::Maugis(maugis)) => {
            let disc = RangeDisc::new(ground, maugis.work.si(), maugis.stress.si());
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
fn springs_under(setup: &Setup, springs: NonZeroUsize, direct: QuasiStatic) -> Result<(Springs, f64), SimulationError> {
    let work = match &setup.scene.adhesion {
        Some(Adhesion::Jkr(jkr)) => jkr.work.si(),
        Some(Adhesion::Maugis(_)) => {
            return Err(SimulationError::Refused("springs: a bed of springs cannot carry Maugis adhesion".to_owned()));
        }
        None => 0.0,
    };
    let run = follow(setup, Contact { normal: Box::new(direct), tangential: None }, Wanted::NOTHING)?;
    let largest = run.records.iter().filter_map(|record| record.normal.contact_radius).fold(0.0, f64::max);
    let reach = reach_for(setup.profile.as_ref(), largest);
    let bed = SpringBed::new(setup.ground(), (springs.get(), reach), work);
    Ok((Springs::new(bed), reach))
}
