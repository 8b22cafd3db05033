//! Scenes whose history is one impact.

mod elastic;
mod held;
mod oblique;
mod plastic;
mod viscoelastic;
mod results;
pub mod rough;
mod steps;
mod table;

use super::stresses::Carried;
use super::{SimulationError, Solved, Wanted};
use crate::contact::loaded::Loaded;
use crate::contact::mapped::known;
use crate::contact::state::Normal;
use crate::drive::impact::{self, ImpactError, ImpactState};
use crate::run::record::{ErrorEstimate, Field, Outcome, Record};
use crate::scene::law::ImpactLaw;
use crate::scene::parts::Parts;
use crate::scene::plan::ImpactPlan;
use crate::scene::reach;
use rayon::prelude::*;
use table::ImpactRow;

/// Records of an impact unless the scene says otherwise.
const RECORDS: usize = 200;

/// What is followed of one impact.
struct Followed {
    row: ImpactRow,
    moments: Vec<ImpactState>,
    /// Where the bed ends at the greatest depth [m], which no record need hit.
    radius: f64,
    field: Option<Field>,
    loaded: Option<Loaded>,
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
pub fn run(plan: &ImpactPlan, wanted: Wanted) -> Result<Solved, SimulationError> {
    let impact = &plan.impact;
    let fastest = impact.speed.iter().map(|speed| speed.si()).fold(0.0, f64::max);
    let one = |&speed: &f64| follow(plan, speed, (speed >= fastest).then_some(wanted));
    let speeds: Vec<f64> = impact.speed.iter().map(|speed| speed.si()).collect();
    let followed: Vec<Result<Followed, SimulationError>> = speeds.par_iter().map(one).collect();
    let mut followed = followed.into_iter().collect::<Result<Vec<_>, _>>()?;
    let incidence = oblique::over_angles(plan)?;
    let rows: Vec<ImpactRow> = followed.iter().map(|one| one.row.clone()).collect();
    let shown = followed.iter().position(|one| one.row.speed >= fastest).unwrap_or(0);
    let shown = followed.swap_remove(shown);
    let records = records(plan, &shown.moments);
    let deepest_radius = plan.profile.contact_radius(shown.radius);
    known(plan.profile.as_ref(), deepest_radius)
        .map_err(|source| SimulationError::Contact { entry: 0, source: source.into() })?;
    let named = results::named(plan, (&rows, &records), deepest_radius, shown.field.as_ref());
    let outcome = Outcome {
        map: None,
        results: named.into_iter().chain(plastic::results(plan, &shown.row)).collect(),
        records,
        fields: shown.field.into_iter().collect(),
        tables: std::iter::once(table::impacts(&rows)).chain(table::incidence(&incidence)).collect(),
        error_estimate: error_estimate(plan, &rows),
        warnings: Vec::new(),
        plan: Parts { state_bytes: shown.bytes, ..plan.parts() },
    };
    // Stresses below the surface are those of a round contact.
    let loaded = shown.loaded.filter(|_| !plan.profile.is_mapped());
    Ok(Solved { outcome, carried: loaded.map(Carried::without_friction) })
}

/// Follows the impact at one speed; records and fields only where `wanted`.
fn follow(plan: &ImpactPlan, speed: f64, wanted: Option<Wanted>) -> Result<Followed, SimulationError> {
    let oblique = oblique::of(plan, speed)?;
    let normal = impact::Projectile { mass: plan.impact.mass.si(), speed: speed * plan.impact.incidence().cos() };
    let followed = match &plan.law {
        ImpactLaw::Elastic(adhesion) => elastic::follow(plan, *adhesion, normal, wanted),
        ImpactLaw::Viscoelastic { relaxation } => viscoelastic::follow(plan, relaxation, normal, wanted),
        ImpactLaw::Held { relaxation, edge } => held::follow(plan, (relaxation, edge), normal, wanted),
        ImpactLaw::Plastic(ball) => Ok(plastic::follow(plan, ball, normal, wanted)),
    }?;
    within_bounds(plan, followed.row.rebound.greatest_depth)?;
    Ok(Followed { row: ImpactRow { speed, oblique, ..followed.row }, ..followed })
}

/// Whether the contact has stayed within its profile and in one piece.
fn within_bounds(plan: &ImpactPlan, depth: f64) -> Result<(), SimulationError> {
    let mut bounds = reach::bounds(plan.profile.as_ref(), plan.law.bodies().adheres()).into_iter();
    match bounds.find(|bound| depth > bound.depth) {
        None => Ok(()),
        Some(bound) => Err(SimulationError::Refused(format!(
            "history[0].speed: the impact goes {depth:.3e} m deep, deeper than {}",
            bound.in_words()
        ))),
    }
}

fn failed(source: ImpactError) -> SimulationError {
    source.into()
}

fn records(plan: &ImpactPlan, moments: &[ImpactState]) -> Vec<Record> {
    let record = |moment: &ImpactState| Record {
        pixels: None,
        entry: 0,
        time: moment.time,
        normal: Normal {
            indentation: Some(moment.depth),
            force: moment.force,
            contact_radius: Some(plan.profile.contact_radius(moment.radius)),
            stiffness: 2.0 * plan.pair.normal * moment.radius,
            stored: moment.stored,
            dissipated: moment.dissipated,
        },
        tangential: None,
        gliding: None,
        worn: None,
        joined: None,
        machine: None,
        spring: None,
    };
    moments.iter().map(record).collect()
}

fn error_estimate(plan: &ImpactPlan, rows: &[ImpactRow]) -> ErrorEstimate {
    let normal = rows.iter().map(|row| row.rebound.error).fold(0.0, f64::max);
    let tangential = rows.iter().filter_map(|row| Some(row.oblique.as_ref()?.course.as_ref()?.error));
    let basis = match plan.law {
        ImpactLaw::Elastic(_) => {
            "energy of the direct path; contact time by quadrature, against one of half as many panels"
        }
        ImpactLaw::Viscoelastic { .. } => "steps of high order in time, against a run of sixteen times the tolerance",
        ImpactLaw::Plastic(_) => "yielding ball in closed form: rounding",
        ImpactLaw::Held { .. } => "straight steps of the depth, their limit against that of steps twice as long",
    };
    ErrorEstimate { relative: tangential.fold(normal, f64::max), basis: basis.to_owned() }
}
