//! Scenes whose history is one impact.

mod oblique;
mod results;

use super::contact::{ContactError, Direct, NormalContact};
use super::{SimulationError, Wanted, direct, fields};
use crate::physics::history::{Entry, Impact};
use crate::physics::impact::{self, ImpactError, Moment, Passage};
use crate::physics::plan;
use crate::physics::record::{ErrorEstimate, Field, ImpactRow, Impacts, Normal, Outcome, Record, StressRow};
use crate::physics::setup::Setup;
use rayon::prelude::*;
use std::num::NonZeroUsize;

/// Records of an impact unless the scene says otherwise.
const RECORDS: usize = 200;

/// The impact of a scene, if it has one.
#[must_use]
pub fn of(setup: &Setup) -> Option<&Impact> {
    setup.scene.history.iter().find_map(|entry| if let Entry::Impact(impact) = entry { Some(impact) } else { None })
}

/// What is followed of one impact.
struct Followed {
    row: ImpactRow,
    moments: Vec<Moment>,
    field: Option<Field>,
    stresses: Vec<StressRow>,
}

/// Runs the impact of a scene.
///
/// The order: each speed on its own, in parallel; the friction of a ball that comes in at an angle
/// or with a spin acts on top of the normal motion, which it does not change; then the named
/// results. Records, pressures and stresses are those of the greatest speed.
///
/// # Errors
/// The contact would leave its profile, or cannot be followed.
pub fn run(setup: &Setup, impact: &Impact, wanted: Wanted) -> Result<Outcome, SimulationError> {
    if setup.relaxation.is_some() {
        return Err(SimulationError::Refused("Impact of a Viscoelastic body cannot be computed yet".to_owned()));
    }
    let fastest = impact.speed.iter().map(|speed| speed.si()).fold(0.0, f64::max);
    let one = |&speed: &f64| follow(setup, impact, (speed, (speed >= fastest).then_some(wanted)));
    let speeds: Vec<f64> = impact.speed.iter().map(|speed| speed.si()).collect();
    let followed: Vec<Result<Followed, SimulationError>> = speeds.par_iter().map(one).collect();
    let mut followed = followed.into_iter().collect::<Result<Vec<_>, _>>()?;
    let incidence = oblique::over_angles(setup, impact)?;
    let rows = followed.iter().map(|one| one.row.clone()).collect();
    let impacts = Impacts { rows, incidence };
    let shown = followed.iter().position(|one| one.row.speed >= fastest).unwrap_or(0);
    let shown = followed.swap_remove(shown);
    let records = records(setup, &shown.moments);
    Ok(Outcome {
        results: results::named(setup, &impacts, (&records, shown.field.as_ref())),
        records,
        fields: shown.field.into_iter().collect(),
        stresses: shown.stresses,
        fretting: Vec::new(),
        error_estimate: error_estimate(setup, &impacts),
        warnings: Vec::new(),
        plan: plan::of(setup),
        ensemble: None,
        impacts: Some(impacts),
    })
}

/// Follows the impact at one speed; records and fields only where `wanted`.
fn follow(setup: &Setup, impact: &Impact, (speed, wanted): (f64, Option<Wanted>)) -> Result<Followed, SimulationError> {
    let failed = |source: ImpactError| SimulationError::Contact { entry: 0, source: ContactError::Impact(source) };
    let oblique = oblique::of(setup, impact, speed)?;
    let normal = impact::Impact { mass: impact.mass.si(), speed: speed * impact.incidence().cos() };
    let contact = direct(setup)?;
    let passage = Passage::new(contact.contact(), normal, setup.accuracy()).map_err(failed)?;
    let deepest = passage.deepest().map(|contact| Direct::new(contact, setup.pair.normal));
    let row = ImpactRow { speed, rebound: passage.rebound(), oblique, peak_pressure: deepest.as_ref().and_then(peak) };
    let records = setup.scene.steps.map_or(RECORDS, NonZeroUsize::get);
    let moments = if wanted.is_some() { passage.moments(records) } else { Vec::new() };
    let field = deepest.as_ref().filter(|_| wanted.is_some_and(|wanted| wanted.fields));
    let time = moments.iter().max_by(|x, y| x.depth.total_cmp(&y.depth)).map_or(0.0, |moment| moment.time);
    let field = field.and_then(|contact| fields::field((contact, None), "greatest depth".to_owned(), time));
    let stressed = deepest.as_ref().filter(|_| wanted.is_some_and(|wanted| wanted.stresses));
    let stresses = stressed.map_or_else(Vec::new, |contact| fields::stresses(setup, &contact.state()));
    Ok(Followed { row, moments, field, stresses })
}

/// Radii at which the largest pressure is looked for.
const LOOKS: u32 = 32;

/// Largest pressure [Pa], unless a sharp edge or tip has an infinite one.
fn peak(contact: &Direct<'_>) -> Option<f64> {
    if contact.stress_intensity().is_some_and(|intensity| intensity < 0.0) {
        return None;
    }
    let a = contact.state().contact_radius?;
    let pressures = (0..LOOKS).map(|k| contact.pressure(a * f64::from(k) / f64::from(LOOKS)));
    pressures.collect::<Option<Vec<f64>>>()?.into_iter().reduce(f64::max)
}

fn records(setup: &Setup, moments: &[Moment]) -> Vec<Record> {
    let record = |moment: &Moment| Record {
        entry: 0,
        time: moment.time,
        normal: Normal {
            indentation: Some(moment.depth),
            force: moment.force,
            contact_radius: Some(moment.radius),
            stiffness: 2.0 * setup.pair.normal * moment.radius,
            stored: moment.stored,
            dissipated: moment.dissipated,
        },
        tangential: None,
    };
    moments.iter().map(record).collect()
}

fn error_estimate(setup: &Setup, impacts: &Impacts) -> ErrorEstimate {
    let normal = impacts.rows.iter().map(|row| row.rebound.error).fold(0.0, f64::max);
    let tangential = impacts.rows.iter().filter_map(|row| Some(row.oblique.as_ref()?.course.as_ref()?.error));
    let basis = match setup.relaxation {
        None => "energy of the direct path; contact time by quadrature, against one of half as many panels",
        Some(_) => "time steps of high order, against a run with a looser tolerance",
    };
    ErrorEstimate { relative: tangential.fold(normal, f64::max), basis: basis.to_owned() }
}
