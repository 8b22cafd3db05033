//! Impacts of elastic bodies on the direct path.

use super::table::ImpactRow;
use super::{Followed, RECORDS, failed};
use crate::contact::direct::QuasiStatic;
use crate::contact::model::Loading;
use crate::drive::impact::{Passage, Projectile};
use crate::run::compose::told;
use crate::run::{SimulationError, Wanted, direct, fields};
use crate::scene::law::ElasticAdhesion;
use crate::scene::plan::ImpactPlan;
use std::num::NonZeroUsize;

/// Follows an impact; records and fields only where `wanted`.
///
/// # Errors
/// The contact would leave its profile, or cannot be followed.
pub fn follow(
    plan: &ImpactPlan,
    adhesion: ElasticAdhesion,
    impact: Projectile,
    wanted: Option<Wanted>,
) -> Result<Followed, SimulationError> {
    let contact = direct(plan.ground(), adhesion)?;
    let passage = Passage::new(&contact, impact, plan.accuracy()).map_err(failed)?;
    let deepest = passage.deepest();
    let (rebound, peak_pressure) = (passage.rebound(), deepest.as_ref().and_then(|contact| contact.loaded().peak()));
    let row = ImpactRow { speed: impact.speed, rebound, oblique: None, peak_pressure };
    let records = plan.scene.steps.map_or(RECORDS, NonZeroUsize::get);
    let moments = if wanted.is_some() { passage.moments(records) } else { Vec::new() };
    let time = moments.iter().max_by(|x, y| x.depth.total_cmp(&y.depth)).map_or(0.0, |moment| moment.time);
    let field = deepest.as_ref().filter(|_| wanted.is_some_and(|wanted| wanted.fields));
    let field = field.map(|contact| told(&plan.profile, Box::new(contact.clone())));
    let field = field.and_then(|contact| fields::field(contact.as_ref(), "greatest depth".to_owned(), time));
    let loaded = deepest.as_ref().filter(|_| wanted.is_some_and(|wanted| wanted.stresses)).map(QuasiStatic::loaded);
    let radius = deepest.as_ref().map_or(0.0, |contact| contact.loaded().contact_radius());
    Ok(Followed { row, moments, radius, field, loaded, bytes: passage.bytes() })
}
