//! Balls that come in at an angle or with a spin.

use super::table::Incidence;
use crate::friction::oblique::{Ball, BallMotion, BallRebound, SOLID};
use crate::friction::{Friction, Grip};
use crate::run::{ContactError, SimulationError};
use crate::scene::history::Impact;
use crate::scene::setup::Setup;
use crate::shape::Shape;
use std::f64::consts::FRAC_PI_2;

/// Angles of incidence of the curve, between head-on and grazing.
const ANGLES: u32 = 100;

/// The ball of a scene whose impact is oblique.
fn ball(setup: &Setup, impact: &Impact) -> Option<Ball> {
    let (Shape::Paraboloid(shape), Some(Friction::Coulomb(coulomb))) = (&setup.scene.shape, &setup.scene.friction)
    else {
        return None;
    };
    let grip = Grip {
        normal_modulus: setup.pair.normal,
        tangential_modulus: setup.pair.tangential,
        coefficient: coulomb.coefficient.si(),
    };
    let ball = Ball { grip, radius: shape.radius.si(), mass: impact.mass.si(), gyration: SOLID };
    impact.is_oblique().then_some(ball)
}

/// What the tangential motion of an impact at the speed `speed` [m/s] comes to.
///
/// # Errors
/// The ball does not approach.
pub fn of(setup: &Setup, impact: &Impact, speed: f64) -> Result<Option<BallRebound>, SimulationError> {
    let rebound = |ball: Ball| ball.hit(flight(impact, (speed, impact.incidence())), setup.accuracy());
    ball(setup, impact).map(rebound).transpose().map_err(failed)
}

/// The same at the greatest speed over all angles of incidence.
///
/// # Errors
/// As of [`of`].
pub fn over_angles(setup: &Setup, impact: &Impact) -> Result<Vec<Incidence>, SimulationError> {
    let Some(ball) = ball(setup, impact) else { return Ok(Vec::new()) };
    let speed = impact.speed.iter().map(|speed| speed.si()).fold(0.0, f64::max);
    let angles: Vec<f64> = (0..ANGLES).map(|k| FRAC_PI_2 * (f64::from(k) + 0.5) / f64::from(ANGLES)).collect();
    let flights: Vec<BallMotion> = angles.iter().map(|&angle| flight(impact, (speed, angle))).collect();
    let rebounds = ball.hits(&flights, setup.accuracy().max(1e-6)).map_err(failed)?;
    Ok(angles.into_iter().zip(rebounds).map(|(angle, rebound)| Incidence { angle, rebound }).collect())
}

fn flight(impact: &Impact, (speed, angle): (f64, f64)) -> BallMotion {
    let spin = impact.spin.map_or(0.0, |spin| spin.si());
    BallMotion { normal_speed: speed * angle.cos(), tangential_speed: speed * angle.sin(), spin }
}

fn failed(source: crate::friction::FrictionError) -> SimulationError {
    SimulationError::Contact { entry: 0, source: ContactError::Friction(source) }
}
