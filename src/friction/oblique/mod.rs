//! Oblique impact of a ball with friction and spin.
//!
//! # Examples
//! ```
//! use springbed::friction::Grip;
//! use springbed::friction::oblique::{Ball, BallMotion, SOLID};
//!
//! // A grazing ball slips all along and loses μ(1 + e) times its normal speed along the surface: 2·0.2·1 m/s.
//! let grip = Grip { normal_modulus: 1e9, tangential_modulus: 0.8e9, coefficient: 0.2 };
//! let ball = Ball { grip, radius: 0.01, mass: 0.03, gyration: SOLID };
//! let rebound = ball.hit(BallMotion { normal_speed: 1.0, tangential_speed: 10.0, spin: 0.0 }, 1e-6)?;
//! assert!((rebound.flight.tangential_speed - 9.6).abs() < 1e-9 && (rebound.impulse_ratio - 0.2).abs() < 1e-9);
//! # Ok::<(), springbed::friction::FrictionError>(())
//! ```

pub mod relaxing;

use super::FrictionError;
use super::turning::{Grip, Pose, TangentialMemory};
use crate::input::quantity::Length;
use crate::numerics::quadrature::node_and_weight;
use crate::shape::Paraboloid;
use rayon::prelude::*;
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

/// I/(mR²) of a solid ball.
pub const SOLID: f64 = 0.4;

/// Hertz's contact time is this times the largest depth over the speed: (4/5) ∫₀^π sin^{−1/5}.
const CONTACT_TIME: f64 = 2.943_275_184_324_705;

/// Steps from which on the error of a run is judged; each further run has twice as many.
const FEWEST_STEPS: usize = 64;
const MOST_STEPS: usize = 1 << 16;

/// A ball that hits a half-space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ball {
    /// Moduli and friction.
    pub grip: Grip,
    /// Radius R [m].
    pub radius: f64,
    /// Mass m [kg].
    pub mass: f64,
    /// I/(mR²); [`SOLID`] for a solid ball.
    pub gyration: f64,
}

/// How a ball moves before or after the impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallMotion {
    /// Speed along the normal [m/s], above zero: towards the surface before, away from it after.
    pub normal_speed: f64,
    /// Speed of the centre along the surface [m/s].
    pub tangential_speed: f64,
    /// Spin ω [rad/s]; positive if it moves the contact point the same way as the centre moves at a
    /// positive tangential speed.
    pub spin: f64,
}

/// What the contact does in a part of the impact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Regime {
    /// All of the contact sticks.
    Stick,
    /// An annulus slips.
    Partial,
    /// All of it slips.
    Slip,
}

/// A part of the impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Phase {
    /// What the contact does.
    pub regime: Regime,
    /// Its end, as a fraction of the contact time.
    pub until: f64,
}

/// The non-dimensional course of an impact (Maw, Barber & Fawcett 1976).
#[derive(Debug, Clone, PartialEq)]
pub struct ObliquePath {
    /// ψ₂ after the impact.
    pub after: f64,
    /// Energy lost to friction over the kinetic energy of the normal motion, divided by μ²E*/G*:
    /// (ψ₁² − ψ₂²)/(2χ).
    pub dissipated: f64,
    /// The same as the sum over the slipping springs; the difference is of second order in the step.
    pub slip_work: f64,
    /// What the contact did.
    pub phases: Vec<Phase>,
    /// Estimate of the error of ψ₂.
    pub error: f64,
    /// Steps of the finest run.
    pub steps: usize,
}

/// A rebound.
#[derive(Debug, Clone, PartialEq)]
pub struct BallRebound {
    /// Motion afterwards.
    pub flight: BallMotion,
    /// −w₂/w₁ with w the speed of the contact point; `None` without one before.
    pub tangential_restitution: Option<f64>,
    /// Angle of the path to the normal after the impact [rad].
    pub angle: f64,
    /// Energy lost to friction [J].
    pub dissipated: f64,
    /// Hertz's contact time [s].
    pub contact_time: f64,
    /// Largest indentation [m].
    pub largest_indentation: f64,
    /// Tangential over normal impulse, at most μ.
    pub impulse_ratio: f64,
    /// Non-dimensional speeds of the contact point, ψ = (G*/μE*) w/v, before and after.
    pub psi: (f64, f64),
    /// The course in detail; `None` without friction.
    pub course: Option<ObliquePath>,
}

impl Ball {
    /// χ = (G*/2E*)(1 + mR²/I), the one number besides ψ₁ that shapes an impact.
    ///
    /// Check: 7/6 for a solid incompressible ball on a rigid surface, 1.441 at ν = 0.3.
    #[must_use]
    pub fn chi(&self) -> f64 {
        0.5 * (self.grip.tangential_modulus / self.grip.normal_modulus) * (1.0 + self.gyration.recip())
    }

    /// The impact: Hertz along the normal, the Coulomb bed along the surface, both bodies elastic.
    ///
    /// m d̈ = −F, m v̇_x = −F_x, Iω̇ = −F_x R; the contact point moves with w = v_x + Rω. `accuracy`
    /// (default 1e-6, from 1e-10 to 1e-2) is the error of ψ₂ aimed at, relative to max(1, |ψ₁|): smaller
    /// costs steps as its inverse root, larger shows in the angle. Valid while a ≪ R and the speed is
    /// far below that of sound; F_x does not act back on the normal motion (elastic similarity).
    ///
    /// # Errors
    /// The normal speed is not above zero.
    pub fn hit(&self, before: BallMotion, accuracy: f64) -> Result<BallRebound, FrictionError> {
        if before.normal_speed.is_nan() || before.normal_speed <= 0.0 {
            return Err(FrictionError::NoApproach { speed: before.normal_speed });
        }
        let speed = before.tangential_speed + self.radius * before.spin;
        let unit = self.grip.reach() * before.normal_speed;
        let course = (unit > 0.0).then(|| course(speed / unit, self.chi(), accuracy)).transpose()?;
        Ok(self.rebound(before, speed, course))
    }

    /// Impacts in parallel, in the order given; the result does not depend on the number of threads.
    ///
    /// # Errors
    /// As of [`hit`](Self::hit).
    pub fn hits(&self, before: &[BallMotion], accuracy: f64) -> Result<Vec<BallRebound>, FrictionError> {
        before.par_iter().map(|&flight| self.hit(flight, accuracy)).collect()
    }

    fn rebound(&self, before: BallMotion, speed: f64, course: Option<ObliquePath>) -> BallRebound {
        let unit = self.grip.reach() * before.normal_speed;
        let psi = course.as_ref().map_or((0.0, 0.0), |course| (speed / unit, course.after));
        // Δw = −(1 + mR²/I) P_x/m.
        let kick = unit * (psi.0 - psi.1) / (1.0 + self.gyration.recip());
        let flight = BallMotion {
            normal_speed: before.normal_speed,
            tangential_speed: before.tangential_speed - kick,
            spin: before.spin - kick / (self.gyration * self.radius),
        };
        let depth = self.largest_indentation(before.normal_speed);
        let energy = 0.5 * self.mass * before.normal_speed * before.normal_speed;
        let friction = self.grip.coefficient * self.grip.reach() * energy;
        BallRebound {
            tangential_restitution: (speed.abs() > 0.0)
                .then(|| -(flight.tangential_speed + self.radius * flight.spin) / speed),
            angle: flight.tangential_speed.atan2(flight.normal_speed),
            dissipated: course.as_ref().map_or(0.0, |course| friction * course.dissipated),
            contact_time: CONTACT_TIME * depth / before.normal_speed,
            largest_indentation: depth,
            impulse_ratio: 0.5 * kick / before.normal_speed,
            flight,
            psi,
            course,
        }
    }

    /// (15mv²/(16E*√R))^{2/5} [m].
    fn largest_indentation(&self, speed: f64) -> f64 {
        (0.9375 * self.mass * speed * (speed / (self.grip.normal_modulus * self.radius.sqrt()))).powf(0.4)
    }
}

/// The course of an impact with ψ₁ = `before` and `chi`, to an error of ψ₂ of
/// `accuracy`·max(1, |ψ₁|).
///
/// Lengths in the largest depth (times m = μE*/G* along the surface), times in depth over speed, the
/// normal motion exact: d = sin^{4/5}φ, impulse 1 − cos φ. The tangential motion is a leapfrog with
/// exact impulses, of second order: each run is compared with one of twice the steps.
/// Check: gross slip all along, ψ₁ ≥ 4χ − 1, gives ψ₂ = ψ₁ − 4χ.
///
/// # Errors
/// None for finite numbers.
pub fn course(before: f64, chi: f64, accuracy: f64) -> Result<ObliquePath, FrictionError> {
    let mut coarse = run(before, chi, FEWEST_STEPS)?;
    let mut change = f64::INFINITY;
    let mut steps = 2 * FEWEST_STEPS;
    loop {
        let mut fine = run(before, chi, steps)?;
        // Of second order, a change is a quarter of the one before; where it is less, by the chance of
        // a regime that begins on a node, the one before is believed.
        let last = (fine.after - coarse.after).abs();
        fine.error = last.max(0.25 * change);
        if fine.error <= accuracy * before.abs().max(1.0) || steps >= MOST_STEPS {
            return Ok(fine);
        }
        (coarse, change) = (fine, last);
        steps *= 2;
    }
}

/// A place on the way: depth, impulse so far, time so far.
#[derive(Clone, Copy)]
struct Waypoint {
    depth: f64,
    impulse: f64,
    time: f64,
}

/// The normal motion at `steps` + 1 nodes and the middles between them, even in φ^{4/5} up to the
/// turning point and its mirror image after it.
#[expect(clippy::cast_precision_loss, reason = "far fewer steps than 2^53")]
fn ticks(steps: usize) -> Vec<Waypoint> {
    let rule: [(f64, f64); 3] = std::array::from_fn(|k| node_and_weight(3, k));
    let width = FRAC_PI_2.powf(0.8) / steps as f64;
    let phase = |y: f64| y.powf(1.25);
    // dt = (4/5) sin^{−1/5}φ dφ = (φ/sin φ)^{1/5} dy.
    let rate = |y: f64| (phase(y) / phase(y).sin()).powf(0.2);
    let mut time = 0.0;
    let mut half = vec![Waypoint { depth: 0.0, impulse: 0.0, time }];
    for k in 0..steps {
        let low = k as f64 * width;
        time += 0.5 * width * rule.iter().map(|&(x, w)| w * rate(low + 0.5 * width * (1.0 + x))).sum::<f64>();
        let phi = phase(low + width);
        half.push(Waypoint { depth: phi.sin().powf(0.8), impulse: 2.0 * (0.5 * phi).sin().powi(2), time });
    }
    let mirrored =
        |tick: &Waypoint| Waypoint { depth: tick.depth, impulse: 2.0 - tick.impulse, time: 2.0 * time - tick.time };
    let back: Vec<Waypoint> = half.iter().rev().skip(1).map(mirrored).collect();
    half.extend(back);
    half
}

/// One run of the leapfrog.
fn run(before: f64, chi: f64, steps: usize) -> Result<ObliquePath, FrictionError> {
    let shape = Paraboloid { radius: Length::new(1.0).map_err(|_| FrictionError::BeyondRadius { radius: 1.0 })? };
    let grip = Grip { normal_modulus: 1.0, tangential_modulus: 1.0, coefficient: 1.0 };
    let mut memory = TangentialMemory::new(Arc::new(shape.clone()), grip);
    let ticks = ticks(steps);
    let (mut psi, mut slide) = (before, 0.0);
    // At first touch F_x/F → the slope of the path, within the cone.
    let mut hold = before.clamp(-1.0, 1.0);
    psi -= 2.0 * chi * hold * ticks[1].impulse;
    let mut phases: Vec<Phase> = Vec::new();
    for k in (2..ticks.len()).step_by(2) {
        let (node, last) = (ticks[k], k + 1 >= ticks.len());
        slide += psi * (node.time - ticks[k - 2].time);
        memory.advance(Pose { indentation: if last { 0.0 } else { node.depth }, slide })?;
        if !last {
            let state = memory.state();
            hold = 0.75 * state.tangential_force / (node.depth * node.depth.sqrt());
            note(&mut phases, regime(state.stick_radius / state.contact_radius), node.time / CONTACT_TIME);
        }
        let next = if last { 2.0 } else { ticks[k + 1].impulse };
        psi -= 2.0 * chi * hold * (next - ticks[k - 1].impulse);
    }
    if let Some(phase) = phases.last_mut() {
        phase.until = 1.0;
    }
    let dissipated = 0.5 * (before - psi) * (before + psi) / chi;
    Ok(ObliquePath { after: psi, dissipated, slip_work: 1.875 * memory.state().dissipated, phases, error: 0.0, steps })
}

fn regime(stick: f64) -> Regime {
    match stick {
        c if c <= 0.0 => Regime::Slip,
        c if c >= 1.0 => Regime::Stick,
        _ => Regime::Partial,
    }
}

/// Adds a stretch of time to the phases.
fn note(phases: &mut Vec<Phase>, regime: Regime, until: f64) {
    match phases.last_mut() {
        Some(phase) if phase.regime == regime => phase.until = until,
        _ => phases.push(Phase { regime, until }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn steel() -> Ball {
        let grip = Grip { normal_modulus: 230e9, tangential_modulus: 190e9, coefficient: 0.1 };
        Ball { grip, radius: 5e-3, mass: 4e-3, gyration: SOLID }
    }

    fn energy(ball: &Ball, flight: BallMotion) -> f64 {
        let inertia = ball.gyration * ball.mass * ball.radius.powi(2);
        0.5 * ball.mass * (flight.normal_speed.powi(2) + flight.tangential_speed.powi(2))
            + 0.5 * inertia * flight.spin.powi(2)
    }

    #[test]
    fn the_clock_is_hertz() {
        let ticks = ticks(512);
        assert!((ticks.last().unwrap().time / CONTACT_TIME - 1.0).abs() < 1e-9);
    }

    /// ψ₂ = ψ₁ − 4χ above ψ₁ = 4χ − 1, to rounding of the sum of impulses.
    #[test]
    fn gross_slip_takes_the_whole_impulse() {
        let chi = 7.0 / 6.0;
        for k in 0..20 {
            let before = (4.0 * chi - 1.0) * 10f64.powf(0.2 * f64::from(k)) + 1e-3;
            let after = course(before, chi, 1e-6).unwrap().after;
            assert!((after - (before - 4.0 * chi)).abs() < 1e-12 * before, "{before}");
        }
    }

    #[test]
    fn a_grazing_impact_slips_and_a_steep_one_sticks_at_first() {
        let phases = |psi: f64| course(psi, 1.44, 1e-6).unwrap().phases;
        assert_eq!(phases(0.5)[0].regime, Regime::Stick);
        assert_eq!(phases(0.5).last().unwrap().regime, Regime::Slip);
        assert_eq!(phases(2.0)[0].regime, Regime::Slip);
        assert!(phases(2.0).len() > 1);
        assert_eq!(phases(6.0), vec![Phase { regime: Regime::Slip, until: 1.0 }]);
    }

    proptest! {
        #![proptest_config(crate::laws::cases(48))]

        /// What the flight loses is what slipping springs have lost; momentum goes to the spin.
        #[test]
        fn energy_and_angular_momentum_balance(angle in 0i32..179, spin in -20i32..20) {
            let ball = steel();
            let (sine, cosine) = (0.5 * f64::from(angle)).to_radians().sin_cos();
            let before = BallMotion { normal_speed: cosine, tangential_speed: sine, spin: 10.0 * f64::from(spin) };
            let rebound = ball.hit(before, 1e-6).unwrap();
            let lost = energy(&ball, before) - energy(&ball, rebound.flight);
            prop_assert!((lost - rebound.dissipated).abs() < 1e-14 * energy(&ball, before));
            // The springs' own ledger: of second order, with a constant below 10 by runs of 128 to 4096 steps.
            let course = rebound.course.unwrap();
            let order = 10.0 * rebound.psi.0.abs().max(1.0) / (course.steps as f64).powi(2);
            prop_assert!((course.slip_work - course.dissipated).abs() <= order, "{course:?}");
            prop_assert!(course.slip_work >= 0.0);
            // About the contact point nothing acts: m v_x R − Iω is kept.
            let about = |f: BallMotion| f.tangential_speed - ball.gyration * ball.radius * f.spin;
            prop_assert!((about(before) - about(rebound.flight)).abs() < 1e-14 * (1.0 + before.spin.abs()));
            prop_assert!(rebound.impulse_ratio.abs() <= ball.grip.coefficient * (1.0 + 1e-12));
        }

        /// The estimate bounds the distance to a far finer run.
        #[test]
        fn the_error_is_controlled(psi in 1i32..60) {
            let psi = 0.1 * f64::from(psi);
            let coarse = course(psi, 1.44, 1e-5).unwrap();
            let fine = run(psi, 1.44, 8192).unwrap();
            prop_assert!((coarse.after - fine.after).abs() <= 2.0 * coarse.error + 1e-7);
        }
    }
}
