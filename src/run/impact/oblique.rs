//! Balls that come in at an angle or with a spin.

use super::table::Incidence;
use crate::drive::impact::{Projectile, StruckHalfSpace};
use crate::friction::FrictionError;
use crate::friction::oblique::relaxing::{NormalCourse, RelaxingBall};
use crate::friction::oblique::{Ball, BallMotion, BallRebound};
use crate::material::{Relaxation, Spectrum};
use crate::run::{ContactError, SimulationError};
use crate::scene::history::Impact;
use crate::scene::plan::ImpactPlan;
use rayon::prelude::*;
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

/// Angles of incidence of the curve, between head-on and grazing, and the accuracy of each: of elastic bodies, and of those
/// that relax, whose springs are followed one by one.
const CURVE: (u32, f64) = (100, 1e-6);
const RELAXING_CURVE: (u32, f64) = (40, 2e-3);
/// The accuracy aimed at of one impact of bodies that relax, unless less is asked for.
const RELAXING: f64 = 1e-4;

/// What the tangential motion of an impact at the speed `speed` [m/s] comes to.
///
/// # Errors
/// The ball does not approach, or its normal motion comes to no end.
pub fn of(plan: &ImpactPlan, speed: f64) -> Result<Option<BallRebound>, SimulationError> {
    let before = flight(&plan.impact, (speed, plan.impact.incidence()));
    let accuracy = if relaxes(plan) { plan.accuracy().max(RELAXING) } else { plan.accuracy() };
    plan.ball.as_ref().map(|ball| rebound(plan, ball, before, accuracy)).transpose()
}

/// The same at the greatest speed over all angles of incidence.
///
/// # Errors
/// As of [`of`].
pub fn over_angles(plan: &ImpactPlan) -> Result<Vec<Incidence>, SimulationError> {
    let Some(ball) = &plan.ball else { return Ok(Vec::new()) };
    let impact = &plan.impact;
    let speed = impact.speed.iter().map(|speed| speed.si()).fold(0.0, f64::max);
    let (count, accuracy) = if relaxes(plan) { RELAXING_CURVE } else { CURVE };
    let at = |k: u32| {
        let angle = FRAC_PI_2 * (f64::from(k) + 0.5) / f64::from(count);
        let before = flight(impact, (speed, angle));
        Ok(Incidence { angle, rebound: rebound(plan, ball, before, plan.accuracy().max(accuracy))? })
    };
    (0..count).into_par_iter().map(at).collect()
}

/// What comes of a ball that comes in as `before` says.
fn rebound(plan: &ImpactPlan, ball: &Ball, before: BallMotion, accuracy: f64) -> Result<BallRebound, SimulationError> {
    match plan.law.bodies().relaxation() {
        Some(relaxation) => relaxing(plan, (ball, relaxation), before, accuracy),
        None => ball.hit(before, accuracy).map_err(failed),
    }
}

fn relaxes(plan: &ImpactPlan) -> bool {
    plan.law.bodies().relaxation().is_some()
}

/// The same of bodies that relax: the normal motion by itself, and what it carries along the surface.
fn relaxing(
    plan: &ImpactPlan,
    (ball, relaxation): (&Ball, &Relaxation),
    before: BallMotion,
    accuracy: f64,
) -> Result<BallRebound, SimulationError> {
    let spectrum = Arc::new(Spectrum::new(relaxation));
    let ground = StruckHalfSpace { spectrum: spectrum.clone(), profile: plan.profile.clone() };
    let impact = Projectile { mass: ball.mass, speed: before.normal_speed };
    let struck = ground.flight(&impact, accuracy.min(plan.accuracy()))?;
    let (depth, rebound) = (|t: f64| struck.depth(t), struck.rebound());
    let normal = NormalCourse {
        depth: &depth,
        end: struck.duration(),
        greatest_depth: rebound.greatest_depth,
        restitution: rebound.restitution,
    };
    RelaxingBall { ball: *ball, spectrum }.hit(before, &normal, accuracy).map_err(failed)
}

fn flight(impact: &Impact, (speed, angle): (f64, f64)) -> BallMotion {
    let spin = impact.spin.map_or(0.0, |spin| spin.si());
    BallMotion { normal_speed: speed * angle.cos(), tangential_speed: speed * angle.sin(), spin }
}

fn failed(source: FrictionError) -> SimulationError {
    SimulationError::Contact { entry: 0, source: ContactError::Friction(source) }
}
