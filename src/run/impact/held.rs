//! Impacts of bodies whose adhesive edge depends on what has been.

use super::table::ImpactRow;
use super::{Followed, RECORDS, failed};
use crate::contact::error::ContactError;
use crate::contact::model::ContactModel;
use crate::contact::viscoelastic::Spectrum;
use crate::contact::viscoelastic::continuous::ContinuousContact;
use crate::contact::viscoelastic::memory::Memory;
use crate::drive::impact::{ImpactError, ImpactState, Projectile, Rebound, SteppedMass, StruckHalfSpace};
use crate::material::Relaxation;
use crate::run::compose::told;
use crate::run::{SimulationError, Wanted, fields};
use crate::scene::law::HeldEdge;
use crate::scene::plan::ImpactPlan;
use std::num::NonZeroUsize;
use std::sync::Arc;

/// Steps in the time of an impact on the stiffest bodies: those of the first run, the most of a run, and the most where
/// the scene asks for an accuracy.
const STEPS: f64 = 25.0;
const MOST: f64 = 200.0;
const MOST_ASKED: f64 = 800.0;
/// Time of an elastic impact in depths over speeds.
const ELASTIC: f64 = 2.94;

/// What is struck, and by what.
struct Struck {
    contact: ContinuousContact,
    impact: Projectile,
    /// Time of the impact on the stiffest bodies, without adhesion [s].
    time: f64,
}

/// One run, with the states at the ends of its steps.
struct Struggle {
    rebound: Rebound,
    states: Vec<ImpactState>,
    /// The contact as the mass turns, and when [s].
    deepest: Option<(f64, Box<dyn ContactModel>)>,
    bytes: usize,
}

/// Follows an impact; records and fields only where `wanted`.
///
/// Runs with half as long steps until their limits agree to the accuracy, or to what that many steps give: the error
/// states how far they do.
///
/// # Errors
/// The contact would outgrow the profile.
pub fn follow(
    plan: &ImpactPlan,
    (relaxation, edge): (&Relaxation, &HeldEdge),
    impact: Projectile,
    wanted: Option<Wanted>,
) -> Result<Followed, SimulationError> {
    let struck = Struck::new(plan, (relaxation, edge), impact).map_err(failed)?;
    let most = if plan.scene.accuracy.is_some() { MOST_ASKED } else { MOST };
    let mut steps = 2.0 * STEPS;
    let mut coarse = struck.run(STEPS).map_err(|source| failed(source.into()))?;
    let mut limit: Option<Rebound> = None;
    let (last, rebound) = loop {
        let fine = struck.run(steps).map_err(|source| failed(source.into()))?;
        let now = fine.rebound.extrapolated(&coarse.rebound);
        let error = limit.map_or(f64::INFINITY, |limit| now.difference(&limit)).max(f64::EPSILON);
        if error <= plan.accuracy() || steps >= most {
            break (fine, Rebound { error, ..now });
        }
        (coarse, limit, steps) = (fine, Some(now), 2.0 * steps);
    };
    let deepest = last.deepest.as_ref();
    let loading = deepest.and_then(|(_, contact)| contact.loading());
    let infinite = loading.as_ref().and_then(|loading| loading.stress_intensity()).is_some_and(|edge| edge < 0.0);
    let peak_pressure = loading.as_ref().filter(|_| !infinite).and_then(|loading| loading.pressure(0.0));
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

impl Struck {
    fn new(
        plan: &ImpactPlan,
        (relaxation, edge): (&Relaxation, &HeldEdge),
        impact: Projectile,
    ) -> Result<Self, ImpactError> {
        let spectrum = Arc::new(Spectrum::new(relaxation));
        let attraction = edge.attraction(&spectrum).to_accuracy(plan.accuracy());
        let without = StruckHalfSpace { spectrum: spectrum.clone(), profile: plan.profile.clone() };
        let time = ELASTIC * without.depth_scale(&impact)? / impact.speed;
        let contact = ContinuousContact::new(Memory::new(spectrum, plan.profile.clone()).with(attraction));
        Ok(Self { contact, impact, time })
    }

    fn run(&self, steps: f64) -> Result<Struggle, ContactError> {
        let mut contact = self.contact.clone();
        let (mut states, mut deepest) =
            (vec![ImpactState { speed: self.impact.speed, ..ImpactState::default() }], None);
        let mut watcher = |state: ImpactState, contact: &dyn ContactModel| {
            states.push(state);
            if state.speed <= 0.0 && deepest.is_none() {
                deepest = Some((state.time, contact.copy()));
            }
        };
        let mass = SteppedMass { impact: self.impact, longest: self.time / steps };
        let rebound = mass.watched(&mut contact, &mut watcher)?;
        Ok(Struggle { rebound, states, deepest, bytes: contact.effort().bytes })
    }
}

/// About `count` of the states at equal times, with both sides of the parting.
fn moments(states: &[ImpactState], count: usize) -> Vec<ImpactState> {
    let end = states.last().map_or(0.0, |state| state.time);
    let at = |k: usize| states.partition_point(|state| state.time < end * k as f64 / count as f64);
    let sides = states.len().saturating_sub(2)..states.len();
    let mut chosen: Vec<usize> = (0..count).map(at).chain(sides).collect();
    chosen.sort_unstable();
    chosen.dedup();
    chosen.into_iter().filter_map(|k| states.get(k).copied()).collect()
}
