//! Balls that come in at an angle or with a spin.

use super::table::Incidence;
use crate::friction::oblique::{Ball, BallMotion, BallRebound};
use crate::run::{ContactError, SimulationError};
use crate::scene::history::Impact;
use crate::scene::plan::ImpactPlan;
use std::f64::consts::FRAC_PI_2;

/// Angles of incidence of the curve, between head-on and grazing.
const ANGLES: u32 = 100;

/// What the tangential motion of an impact at the speed `speed` [m/s] comes to.
///
/// # Errors
/// The ball does not approach.
pub fn of(plan: &ImpactPlan, speed: f64) -> Result<Option<BallRebound>, SimulationError> {
    let impact = &plan.impact;
    let rebound = |ball: &Ball| ball.hit(flight(impact, (speed, impact.incidence())), plan.accuracy());
    plan.ball.as_ref().map(rebound).transpose().map_err(failed)
}

/// The same at the greatest speed over all angles of incidence.
///
/// # Errors
/// As of [`of`].
pub fn over_angles(plan: &ImpactPlan) -> Result<Vec<Incidence>, SimulationError> {
    let Some(ball) = &plan.ball else { return Ok(Vec::new()) };
    let impact = &plan.impact;
    let speed = impact.speed.iter().map(|speed| speed.si()).fold(0.0, f64::max);
    let angles: Vec<f64> = (0..ANGLES).map(|k| FRAC_PI_2 * (f64::from(k) + 0.5) / f64::from(ANGLES)).collect();
    let flights: Vec<BallMotion> = angles.iter().map(|&angle| flight(impact, (speed, angle))).collect();
    let rebounds = ball.hits(&flights, plan.accuracy().max(1e-6)).map_err(failed)?;
    Ok(angles.into_iter().zip(rebounds).map(|(angle, rebound)| Incidence { angle, rebound }).collect())
}

fn flight(impact: &Impact, (speed, angle): (f64, f64)) -> BallMotion {
    let spin = impact.spin.map_or(0.0, |spin| spin.si());
    BallMotion { normal_speed: speed * angle.cos(), tangential_speed: speed * angle.sin(), spin }
}

fn failed(source: crate::friction::FrictionError) -> SimulationError {
    SimulationError::Contact { entry: 0, source: ContactError::Friction(source) }
}
