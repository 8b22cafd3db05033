//! Impacts of bodies whose adhesive edge depends on what has been.

use super::steps::{ELASTIC, Struck};
use super::table::ImpactRow;
use super::{Followed, RECORDS, failed};
use crate::contact::viscoelastic::Spectrum;
use crate::contact::viscoelastic::continuous::ContinuousContact;
use crate::contact::viscoelastic::memory::Memory;
use crate::drive::impact::{ImpactError, ImpactState, Projectile, StruckHalfSpace};
use crate::material::Relaxation;
use crate::run::compose::told;
use crate::run::{SimulationError, Wanted, fields};
use crate::scene::law::HeldEdge;
use crate::scene::plan::ImpactPlan;
use std::num::NonZeroUsize;
use std::sync::Arc;

/// Follows an impact; records and fields only where `wanted`.
///
/// # Errors
/// The contact would outgrow the profile.
pub fn follow(
    plan: &ImpactPlan,
    (relaxation, edge): (&Relaxation, &HeldEdge),
    impact: Projectile,
    wanted: Option<Wanted>,
) -> Result<Followed, SimulationError> {
    let (contact, time) = struck(plan, (relaxation, edge), impact).map_err(failed)?;
    let struck = Struck { contact: &contact, impact, time };
    let last =
        struck.settled(plan.accuracy(), plan.scene.accuracy.is_some()).map_err(|source| failed(source.into()))?;
    let rebound = last.rebound;
    let deepest = last.deepest.as_ref();
    let loading = deepest.and_then(|(_, contact)| contact.loading());
    let peak_pressure = loading.as_ref().and_then(|loading| loading.peak());
    let row = ImpactRow { speed: impact.speed, rebound, oblique: None, peak_pressure };
    let count = plan.scene.steps.map_or(RECORDS, NonZeroUsize::get);
    let moments = if wanted.is_some() { moments(&last.states, count) } else { Vec::new() };
    let field = deepest.filter(|_| wanted.is_some_and(|wanted| wanted.fields));
    let field = field.map(|(time, contact)| (time, told(&plan.profile, contact.copy())));
    let field = field.and_then(|(time, contact)| fields::field(contact.as_ref(), "greatest depth".to_owned(), *time));
    let loaded = loading.as_ref().filter(|_| wanted.is_some_and(|wanted| wanted.stresses));
    let loaded = loaded.and_then(|loading| loading.loaded());
    let radius = loading.as_ref().map_or(0.0, |loading| loading.contact_radius());
    Ok(Followed { row, moments, radius, field, loaded, bytes: last.bytes })
}

/// What is struck, and the time of the impact on the stiffest bodies, without adhesion [s].
fn struck(
    plan: &ImpactPlan,
    (relaxation, edge): (&Relaxation, &HeldEdge),
    impact: Projectile,
) -> Result<(ContinuousContact, f64), ImpactError> {
    let spectrum = Arc::new(Spectrum::new(relaxation));
    let attraction = edge.attraction(&spectrum).to_accuracy(plan.accuracy());
    let without = StruckHalfSpace { spectrum: spectrum.clone(), profile: plan.profile.clone() };
    let time = ELASTIC * without.depth_scale(&impact)? / impact.speed;
    Ok((ContinuousContact::new(Memory::new(spectrum, plan.profile.clone()).with(attraction)), time))
}

/// About `count` of the states at equal times, with both sides of the parting, and those of the least and the largest force:
/// a mass that sticks may be followed for long after it has struck.
fn moments(states: &[ImpactState], count: usize) -> Vec<ImpactState> {
    let end = states.last().map_or(0.0, |state| state.time);
    let at = |k: usize| states.partition_point(|state| state.time < end * k as f64 / count as f64);
    let sides = states.len().saturating_sub(2)..states.len();
    let by_force = |&i: &usize, &j: &usize| states[i].force.total_cmp(&states[j].force);
    let extremes = (0..states.len()).min_by(by_force).into_iter().chain((0..states.len()).max_by(by_force));
    let mut chosen: Vec<usize> = (0..count).map(at).chain(sides).chain(extremes).collect();
    chosen.sort_unstable();
    chosen.dedup();
    chosen.into_iter().filter_map(|k| states.get(k).copied()).collect()
}
