//! Scenes whose history is one impact.

mod elastic;
mod oblique;
mod relaxing;
mod results;
mod table;

use super::contact::ContactError;
use super::{SimulationError, Wanted};
use crate::contact::state::Normal;
use crate::drive::impact::{self, ImpactError, ImpactState};
use crate::run::record::{ErrorEstimate, Field, Outcome, Record};
use crate::run::table::Table;
use crate::scene::history::{Entry, Impact};
use crate::scene::plan;
use crate::scene::plan::Plan;
use crate::scene::reach;
use crate::scene::setup::Setup;
use rayon::prelude::*;
use table::ImpactRow;

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
    moments: Vec<ImpactState>,
    field: Option<Field>,
    stresses: Option<Table>,
    bytes: usize,
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
    let fastest = impact.speed.iter().map(|speed| speed.si()).fold(0.0, f64::max);
    let one = |&speed: &f64| follow(setup, impact, (speed, (speed >= fastest).then_some(wanted)));
    let speeds: Vec<f64> = impact.speed.iter().map(|speed| speed.si()).collect();
    let followed: Vec<Result<Followed, SimulationError>> = speeds.par_iter().map(one).collect();
    let mut followed = followed.into_iter().collect::<Result<Vec<_>, _>>()?;
    let incidence = oblique::over_angles(setup, impact)?;
    let rows: Vec<ImpactRow> = followed.iter().map(|one| one.row.clone()).collect();
    let shown = followed.iter().position(|one| one.row.speed >= fastest).unwrap_or(0);
    let shown = followed.swap_remove(shown);
    let records = records(setup, &shown.moments);
    Ok(Outcome {
        results: results::named(setup, &rows, &records, shown.field.as_ref()),
        records,
        fields: shown.field.into_iter().collect(),
        tables: [Some(table::impacts(&rows)), table::incidence(&incidence), shown.stresses]
            .into_iter()
            .flatten()
            .collect(),
        error_estimate: error_estimate(setup, &rows),
        warnings: Vec::new(),
        plan: Plan { state_bytes: shown.bytes, ..plan::of(setup) },
    })
}

/// Follows the impact at one speed; records and fields only where `wanted`.
fn follow(setup: &Setup, impact: &Impact, (speed, wanted): (f64, Option<Wanted>)) -> Result<Followed, SimulationError> {
    let oblique = oblique::of(setup, impact, speed)?;
    let normal = impact::Projectile { mass: impact.mass.si(), speed: speed * impact.incidence().cos() };
    let followed = match &setup.relaxation {
        None => elastic::follow(setup, normal, wanted),
        Some(relaxation) => relaxing::follow(setup, relaxation, (normal, wanted)),
    }?;
    within_bounds(setup, followed.row.rebound.greatest_depth)?;
    Ok(Followed { row: ImpactRow { speed, oblique, ..followed.row }, ..followed })
}

/// Whether the contact has stayed within its profile and in one piece.
fn within_bounds(setup: &Setup, depth: f64) -> Result<(), SimulationError> {
    let bounds = reach::end(setup.profile.as_ref()).into_iter();
    let second = || reach::second_contact(setup.profile.as_ref());
    let mut bounds = bounds.chain(setup.scene.adhesion.is_none().then(second).flatten());
    match bounds.find(|bound| depth > bound.depth) {
        None => Ok(()),
        Some(bound) => Err(SimulationError::Refused(format!(
            "history[0].speed: the impact goes {depth:.3e} m deep, deeper than {}",
            bound.in_words()
        ))),
    }
}

fn failed(source: ImpactError) -> SimulationError {
    SimulationError::Contact { entry: 0, source: ContactError::Impact(source) }
}

fn records(setup: &Setup, moments: &[ImpactState]) -> Vec<Record> {
    let record = |moment: &ImpactState| Record {
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

fn error_estimate(setup: &Setup, rows: &[ImpactRow]) -> ErrorEstimate {
    let normal = rows.iter().map(|row| row.rebound.error).fold(0.0, f64::max);
    let tangential = rows.iter().filter_map(|row| Some(row.oblique.as_ref()?.course.as_ref()?.error));
    let basis = match setup.relaxation {
        None => "energy of the direct path; contact time by quadrature, against one of half as many panels",
        Some(_) => "steps of high order in time, against a run of sixteen times the tolerance",
    };
    ErrorEstimate { relative: tangential.fold(normal, f64::max), basis: basis.to_owned() }
}
