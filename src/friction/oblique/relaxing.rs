//! Oblique impact of a ball on bodies that relax.
//!
//! # Examples
//! ```
//! use springbed::friction::Grip;
//! use springbed::friction::oblique::{Ball, BallMotion, SOLID};
//! use springbed::friction::oblique::relaxing::{NormalCourse, RelaxingBall};
//! use springbed::material::Spectrum;
//! use std::sync::Arc;
//!
//! // A ball, driven down and up at 1 m/s on a body without memory, grazes it and slips all along.
//! let grip = Grip { normal_modulus: 1.0, tangential_modulus: 0.8, coefficient: 0.2 };
//! let ball = Ball { grip, radius: 1.0, mass: 1.0, gyration: SOLID };
//! let depth = |t: f64| 0.1 - (t - 0.1).abs();
//! let normal = NormalCourse { depth: &depth, end: 0.2, greatest_depth: 0.1, restitution: 1.0 };
//! let relaxing = RelaxingBall { ball, spectrum: Arc::new(Spectrum::elastic(1.0)) };
//! let rebound = relaxing.hit(BallMotion { normal_speed: 1.0, tangential_speed: 9.0, spin: 0.0 }, &normal, 1e-3)?;
//! // ∫F dt = 2·(4/3)·(2/5)·0.1^{5/2}, and Δv = μ∫F dt/m.
//! let lost = 0.2 * 16.0 / 15.0 * 0.1f64.powf(2.5);
//! assert!(((9.0 - rebound.flight.tangential_speed) / lost - 1.0).abs() < 1e-3);
//! # Ok::<(), springbed::friction::FrictionError>(())
//! ```

use super::{Ball, BallMotion, BallRebound, ObliquePath, Phase, note, regime};
use crate::contact::viscoelastic::Spectrum;
use crate::friction::{FrictionError, ViscoelasticBed};
use crate::input::quantity::Length;
use crate::shape::Paraboloid;
use std::num::NonZeroUsize;
use std::sync::Arc;

/// Steps of the coarsest run, and its springs; each further run has twice as many of both.
const FEWEST: usize = 32;
const MOST: usize = 4096;
/// How much wider than the largest contact the bed is.
const WIDER: f64 = 1.0 + 1e-9;

/// A ball that hits bodies that relax: the [`Ball`] of its moduli at once, and the spectrum of both bodies.
#[derive(Debug, Clone)]
pub struct RelaxingBall {
    /// The ball; of its moduli only the ratio counts.
    pub ball: Ball,
    /// The spectrum of E*(t) [Pa].
    pub spectrum: Arc<Spectrum>,
}

/// The normal motion of an impact, which friction does not change.
#[derive(Clone, Copy)]
pub struct NormalCourse<'c> {
    /// Depth [m] over the time since the first touch [s].
    pub depth: &'c dyn Fn(f64) -> f64,
    /// When the bodies part, or the ball has come to rest [s].
    pub end: f64,
    /// Largest depth [m].
    pub greatest_depth: f64,
    /// −ḋ at the end over ḋ at the first touch.
    pub restitution: f64,
}

/// Looks at the normal motion, as many at equal times and as many at equal ratios, down to this part of its end.
const LOOKS: u32 = 512;
const SHORTEST: f64 = 1e-12;

impl NormalCourse<'_> {
    /// Ends of `count` steps [s], which take equal parts of the time and of the way together: behind a dashpot the blow is
    /// over long before the bodies part.
    #[expect(clippy::cast_precision_loss, reason = "far fewer steps than 2^53")]
    fn times(&self, count: usize) -> Vec<f64> {
        let part = |k: u32| f64::from(k) / f64::from(LOOKS);
        let looks = (0..LOOKS).flat_map(|k| [part(k), SHORTEST.powf(1.0 - part(k))]);
        let mut looks: Vec<f64> = looks.chain([1.0]).map(|part| part * self.end).collect();
        looks.sort_by(f64::total_cmp);
        let mut ways = vec![0.0];
        for look in looks.windows(2) {
            let way = ((self.depth)(look[1]) - (self.depth)(look[0])).abs();
            ways.push(ways[ways.len() - 1] + way);
        }
        let whole = ways[ways.len() - 1].max(f64::MIN_POSITIVE);
        let parts: Vec<f64> = looks.iter().zip(&ways).map(|(t, way)| 0.5 * (t / self.end + way / whole)).collect();
        let at = |k: usize| {
            let goal = k as f64 / count as f64;
            let high = parts.partition_point(|&part| part < goal).clamp(1, parts.len() - 1);
            let (low, gap) = (high - 1, parts[high] - parts[high - 1]);
            let over = if gap > 0.0 { ((goal - parts[low]) / gap).clamp(0.0, 1.0) } else { 1.0 };
            looks[low] + over * (looks[high] - looks[low])
        };
        (0..=count).map(|k| if k < count { at(k) } else { self.end }).collect()
    }
}

/// One run: the contact point at the end, and what the contact did.
#[derive(Clone)]
struct Course {
    /// w [m/s] at the end.
    speed: f64,
    /// Energy lost to friction [J].
    dissipated: f64,
    phases: Vec<Phase>,
}

impl Course {
    /// What half as many steps, whose error is twice as large, tell of no steps at all.
    fn extrapolated(&self, coarse: &Self) -> Self {
        let beyond = |fine: f64, coarse: f64| fine + (fine - coarse);
        Self {
            speed: beyond(self.speed, coarse.speed),
            dissipated: beyond(self.dissipated, coarse.dissipated).max(0.0),
            phases: self.phases.clone(),
        }
    }
}

impl RelaxingBall {
    /// The impact: the normal motion as it is, the viscoelastic bed with Coulomb friction along the surface.
    ///
    /// m v̇_x = −F_x, Iω̇ = −F_x R, the contact point at w = v_x + Rω: a leapfrog of second order, each step a straight piece
    /// of depth and slide, exact for every spring. Steps and springs are doubled until ψ₂ changes by less than
    /// `accuracy`·max(1, |ψ₁|). Behind a dashpot, whose force jumps with the speed, they are of first order and are
    /// extrapolated.
    /// Valid for one constant Poisson's ratio, a ≪ R and elastic similarity.
    /// Check: without Prony terms it is [`Ball::hit`]; slipping all along it loses κμv(1 + e), κ = 1 + mR²/I.
    ///
    /// # Errors
    /// The normal speed is not above zero.
    pub fn hit(
        &self,
        before: BallMotion,
        normal: &NormalCourse<'_>,
        accuracy: f64,
    ) -> Result<BallRebound, FrictionError> {
        if before.normal_speed.is_nan() || before.normal_speed <= 0.0 {
            return Err(FrictionError::NoApproach { speed: before.normal_speed });
        }
        let speed = before.tangential_speed + self.ball.radius * before.spin;
        let unit = self.ball.grip.reach() * before.normal_speed;
        let course = (unit > 0.0).then(|| self.settled(speed, unit, normal, accuracy)).transpose()?;
        Ok(self.rebound(before, normal, (speed, unit), course))
    }

    /// The course doubled until it settles, and how far it had not.
    fn settled(
        &self,
        speed: f64,
        unit: f64,
        normal: &NormalCourse<'_>,
        accuracy: f64,
    ) -> Result<(Course, f64, usize), FrictionError> {
        let mut coarse = self.run(speed, normal, FEWEST)?;
        let mut known = coarse.clone();
        let (mut change, mut count) = (f64::INFINITY, 2 * FEWEST);
        loop {
            let fine = self.run(speed, normal, count)?;
            let better = if self.spectrum.viscosity() > 0.0 { fine.extrapolated(&coarse) } else { fine.clone() };
            let last = (better.speed - known.speed).abs() / unit;
            // As in the elastic impact: a change that is small by chance is not believed.
            let error = last.max(0.25 * change);
            if error <= accuracy * (speed / unit).abs().max(1.0) || count >= MOST {
                return Ok((better, error, count));
            }
            (coarse, known, change) = (fine, better, last);
            count *= 2;
        }
    }

    /// One run of `count` steps on as many springs.
    #[expect(clippy::cast_precision_loss, reason = "far fewer springs than 2^53")]
    fn run(&self, speed: f64, normal: &NormalCourse<'_>, count: usize) -> Result<Course, FrictionError> {
        let ball = &self.ball;
        let radius = WIDER * (ball.radius * normal.greatest_depth).sqrt();
        let beyond = FrictionError::BeyondRadius { radius };
        let shape = Paraboloid { radius: Length::new(ball.radius).map_err(|_| beyond)? };
        let springs = NonZeroUsize::new(count).ok_or(beyond)?;
        let mut bed = ViscoelasticBed::new(&shape, self.spectrum.clone(), ball.grip, springs, radius)?;
        let kick = (1.0 + ball.gyration.recip()) / ball.mass;
        let times = normal.times(count);
        let (mut course, mut depth) = (Course { speed, dissipated: 0.0, phases: Vec::new() }, 0.0);
        for (k, step) in times.windows(2).enumerate() {
            let (span, to) = (step[1] - step[0], (normal.depth)(step[1]));
            bed.advance(((to - depth) / span, course.speed), span);
            depth = to;
            let (pressed, stuck) = bed.held();
            if pressed > 0 {
                note(&mut course.phases, regime(stuck as f64 / pressed as f64), step[1] / normal.end);
            }
            // From the middle of this step to that of the next.
            let next = times.get(k + 2).map_or(0.0, |next| next - step[1]);
            course.speed -= kick * bed.forces().1 * 0.5 * (span + next);
        }
        if let Some(phase) = course.phases.last_mut() {
            phase.until = 1.0;
        }
        course.dissipated = bed.dissipated();
        Ok(course)
    }

    fn rebound(
        &self,
        before: BallMotion,
        normal: &NormalCourse<'_>,
        (speed, unit): (f64, f64),
        course: Option<(Course, f64, usize)>,
    ) -> BallRebound {
        let ball = &self.ball;
        let after = course.as_ref().map_or(speed, |(course, ..)| course.speed);
        // Δw = −(1 + mR²/I) P_x/m.
        let kick = (speed - after) / (1.0 + ball.gyration.recip());
        let flight = BallMotion {
            normal_speed: normal.restitution * before.normal_speed,
            tangential_speed: before.tangential_speed - kick,
            spin: before.spin - kick / (ball.gyration * ball.radius),
        };
        let energy = 0.5 * ball.mass * before.normal_speed * before.normal_speed;
        let lost = course.as_ref().map_or(0.0, |(course, ..)| course.dissipated);
        let path = course.map(|(course, error, steps)| {
            let dissipated = lost / (ball.grip.coefficient * ball.grip.reach() * energy);
            ObliquePath { after: after / unit, dissipated, slip_work: dissipated, phases: course.phases, error, steps }
        });
        BallRebound {
            tangential_restitution: (speed.abs() > 0.0).then(|| -after / speed),
            angle: flight.tangential_speed.atan2(flight.normal_speed),
            dissipated: lost,
            contact_time: normal.end,
            largest_indentation: normal.greatest_depth,
            impulse_ratio: kick / (before.normal_speed * (1.0 + normal.restitution)),
            flight,
            psi: if unit > 0.0 { (speed / unit, after / unit) } else { (0.0, 0.0) },
            course: path,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::friction::Grip;
    use crate::friction::oblique::SOLID;
    use crate::material::Relaxation;
    use proptest::prelude::*;

    /// R = m = E* = 1.
    fn ball(coefficient: f64) -> Ball {
        let grip = Grip { normal_modulus: 1.0, tangential_modulus: 0.8, coefficient };
        Ball { grip, radius: 1.0, mass: 1.0, gyration: SOLID }
    }

    /// Depths at equal times until `end`, straight between them.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a part of the number of depths")]
    fn hertz(depths: &[f64], end: f64) -> impl Fn(f64) -> f64 + '_ {
        move |t: f64| {
            let place = t / end * (depths.len() - 1) as f64;
            let k = (place as usize).min(depths.len() - 2);
            depths[k] + (place - k as f64) * (depths[k + 1] - depths[k])
        }
    }

    /// d̈ = −(4/3)d^{3/2} until d = 0 by a leapfrog of steps too short to matter.
    fn flight() -> (Vec<f64>, f64, f64) {
        let (mut d, mut v, h) = (0.0f64, 0.1f64, 1e-4);
        let (mut depths, mut most) = (vec![0.0], 0.0f64);
        while d >= 0.0 {
            v -= 0.5 * h * 4.0 / 3.0 * d.max(0.0).powf(1.5);
            d += h * v;
            v -= 0.5 * h * 4.0 / 3.0 * d.max(0.0).powf(1.5);
            depths.push(d.max(0.0));
            most = most.max(d);
        }
        let end = h * (depths.len() - 1) as f64;
        (depths, end, most)
    }

    /// Bodies without memory are elastic ones. Bound: the error both state, and the leapfrog of the normal motion here.
    #[test]
    fn without_memory_it_is_the_elastic_impact() {
        let (depths, end, greatest_depth) = flight();
        let depth = hertz(&depths, end);
        let normal = NormalCourse { depth: &depth, end, greatest_depth, restitution: 1.0 };
        for tangential in [0.0, 0.02, 0.05, 0.1, 0.2, 0.5] {
            let before = BallMotion { normal_speed: 0.1, tangential_speed: tangential, spin: 0.01 };
            let relaxing = RelaxingBall { ball: ball(0.3), spectrum: Arc::new(Spectrum::elastic(1.0)) };
            let (one, other) = (relaxing.hit(before, &normal, 1e-4).unwrap(), ball(0.3).hit(before, 1e-8).unwrap());
            let bound = one.course.as_ref().unwrap().error + 2e-4;
            assert!((one.psi.1 - other.psi.1).abs() < bound, "{tangential}: {one:?} {other:?}");
            assert!((one.dissipated - other.dissipated).abs() < 1e-3 * 0.5e-2, "{tangential}: {one:?} {other:?}");
        }
    }

    proptest! {
        #![proptest_config(crate::laws::cases(24))]

        /// Friction takes no more than the ball has along the surface, F_x no more than μF, and a mirrored ball mirrors all.
        #[test]
        fn friction_only_takes(
            terms in prop::collection::vec((-10i32..10, -20i32..20), 0..3),
            (tangential, spin, coefficient) in (-30i32..30, -30i32..30, 1i32..20),
        ) {
            let terms = terms.iter().map(|&(e, t)| (10f64.powf(0.1 * f64::from(e)), 10f64.powf(0.1 * f64::from(t)))).collect();
            let spectrum = Arc::new(Spectrum::new(&Relaxation { equilibrium: 1.0, terms, viscosity: 0.0 }));
            let depth = |t: f64| 0.1 * t * (1.0 - t);
            let normal = NormalCourse { depth: &depth, end: 0.8, greatest_depth: 0.025, restitution: 0.6 };
            let relaxing = RelaxingBall { ball: ball(0.05 * f64::from(coefficient)), spectrum };
            let flight = |sign: f64| BallMotion {
                normal_speed: 0.1,
                tangential_speed: 0.01 * sign * f64::from(tangential),
                spin: 0.01 * sign * f64::from(spin),
            };
            let one = relaxing.hit(flight(1.0), &normal, 1e-2).unwrap();
            let other = relaxing.hit(flight(-1.0), &normal, 1e-2).unwrap();
            prop_assert!((one.psi.1 + other.psi.1).abs() <= 1e-12 * one.psi.0.abs().max(1.0), "{one:?} {other:?}");
            let along = |flight: BallMotion| {
                0.5 * (flight.tangential_speed.powi(2) + SOLID * flight.spin.powi(2))
            };
            let lost = along(flight(1.0)) - along(one.flight);
            let error = one.course.as_ref().unwrap().error * relaxing.ball.grip.reach() * 0.1 * 0.1 + 1e-6;
            // A ball that rolls or comes straight down loses nothing, and rounding a part of what it carries.
            let rounding = f64::EPSILON * (along(flight(1.0)) + 0.5 * flight(1.0).normal_speed.powi(2));
            prop_assert!(lost > one.dissipated - error && one.dissipated >= -rounding, "{lost:e} {one:?}");
        }
    }
}
