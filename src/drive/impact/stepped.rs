//! A mass on a contact of any kind, step by step.

use super::{Projectile, Rebound};
use crate::contact::error::ContactError;
use crate::contact::model::{ContactModel, Straight};
use crate::drive::force::{ahead, depth_of};

/// A mass that drives any contact in straight pieces of its depth.
///
/// In a step of the duration h the depth goes straight, with the mean w of the speeds at both ends:
/// m(v₁ − v₀) = −∫F dt, the impulse of the contact along the piece by Simpson's rule. m(v₁² − v₀²)/2 = −w∫F dt is
/// then its work: kinetic energy, stored energy and heat add up to the error of that rule however long the
/// steps. Of second order in h. The energy of an elastic impact and the collocation of a viscoelastic one are the
/// better answers where they exist; this one is theirs to be held against, and serves any contact they do not know.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SteppedMass {
    /// The mass and its speed.
    pub impact: Projectile,
    /// Longest step [s].
    pub longest: f64,
}

/// Steps after which a mass that does not come back counts as stuck.
const MOST_STEPS: usize = 200_000;
/// First step, relative to the longest: the force rises from zero like a root.
const FIRST: f64 = 1e-6;
/// Growth of the steps at first, relative to the time that has passed.
const GROWTH: f64 = 0.1;

/// The mass on its way.
struct MovingMass<'c> {
    contact: &'c mut dyn ContactModel,
    impact: Projectile,
    speed: f64,
    time: f64,
    most: Rebound,
}

impl SteppedMass {
    /// What comes of the impact on a contact that just touches.
    ///
    /// # Errors
    /// The contact cannot follow.
    pub fn rebound(&self, contact: &mut dyn ContactModel) -> Result<Rebound, ContactError> {
        let most = Rebound { lost: self.impact.energy(), ..Rebound::default() };
        let mut way = MovingMass { contact, impact: self.impact, speed: self.impact.speed, time: 0.0, most };
        let mut step = FIRST * self.longest;
        for _ in 0..MOST_STEPS {
            if way.step(step)? || way.rests() {
                break;
            }
            step = self.longest.min(GROWTH * way.time + FIRST * self.longest);
        }
        Ok(way.most)
    }
}

impl MovingMass<'_> {
    fn rests(&self) -> bool {
        self.speed.abs() < 1e-9 * self.impact.speed && self.contact.state().force <= 0.0
    }

    /// One step; whether the bodies have parted in it.
    fn step(&mut self, duration: f64) -> Result<bool, ContactError> {
        let mean = self.mean_speed(duration)?;
        let parted = mean < 0.0 && !self.joined_after(mean, duration)?;
        // The pull at the moment of parting belongs to the impulse, the nothing after it does not.
        let (held, duration) = if parted { self.parting(mean, duration)? } else { (duration, duration) };
        self.speed -= self.impulse(mean, held)? / self.impact.mass;
        self.contact.follow(&ahead(self.contact, mean, duration))?;
        self.time += duration;
        let most = &mut self.most;
        most.greatest_depth = most.greatest_depth.max(depth_of(self.contact));
        most.greatest_force = most.greatest_force.max(self.contact.state().force);
        if parted {
            most.restitution = -self.speed / self.impact.speed;
            most.lost = self.impact.energy() - 0.5 * self.impact.mass * self.speed * self.speed;
            most.contact_time = Some(self.time);
        }
        Ok(parted)
    }

    /// ∫F dt [N s] over a piece at the speed `mean` [m/s].
    fn impulse(&mut self, mean: f64, duration: f64) -> Result<f64, ContactError> {
        let mut force = |part: f64| {
            let piece: Straight = ahead(self.contact, mean, part * duration);
            Ok::<_, ContactError>(self.contact.look(&piece)?.force)
        };
        // A dashpot takes the new speed on at once: the beginning is just after it.
        Ok(duration / 6.0 * (force(f64::EPSILON)? + 4.0 * force(0.5)? + force(1.0)?))
    }

    fn joined_after(&mut self, mean: f64, duration: f64) -> Result<bool, ContactError> {
        let piece = ahead(self.contact, mean, duration);
        Ok(self.contact.look(&piece)?.contact_radius > 0.0)
    }

    /// w = v₀ − ½∫F dt/m with the impulse along w itself.
    fn mean_speed(&mut self, duration: f64) -> Result<f64, ContactError> {
        let mass = self.impact.mass;
        let mut mean = self.speed - 0.5 * self.contact.state().force * duration / mass;
        let mut last: Option<(f64, f64)> = None;
        for _ in 0..20 {
            let miss = self.speed - 0.5 * self.impulse(mean, duration)? / mass - mean;
            let slope = last.map_or(-1.0, |(w, m)| (miss - m) / (mean - w));
            last = Some((mean, miss));
            let better = mean - miss / if slope.is_finite() && slope < -0.5 { slope } else { -1.0 };
            if (better - mean).abs() <= 1e-12 * self.impact.speed {
                break;
            }
            mean = better;
        }
        Ok(mean)
    }

    /// The last time in the step at which the bodies hold, and the first at which they have parted.
    fn parting(&mut self, mean: f64, duration: f64) -> Result<(f64, f64), ContactError> {
        let (mut low, mut high) = (0.0, duration);
        for _ in 0..48 {
            let middle = 0.5 * (low + high);
            *(if self.joined_after(mean, middle)? { &mut low } else { &mut high }) = middle;
        }
        Ok((low, high))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::adhesion::line::EdgeLine;
    use crate::contact::direct::QuasiStatic;
    use crate::contact::foundation::HalfSpace;
    use crate::drive::impact::Passage;
    use crate::input::quantity::Length;
    use crate::shape::Paraboloid;
    use std::sync::Arc;

    /// An elastic ball, with and without adhesion, against the energy of the direct path. Of second order: a
    /// fourth of the error in half the steps.
    #[test]
    fn elastic_impacts_converge_to_those_of_energy() {
        let ball = Arc::new(Paraboloid { radius: Length::new(1.0).unwrap() });
        let impact = Projectile { mass: 1.0, speed: 3.0 };
        for work in [0.0, 0.3] {
            let contact = QuasiStatic::new(EdgeLine::new(HalfSpace::new(ball.clone(), 1.0), work));
            let exact = Passage::new(&contact, impact, 1e-9).unwrap().rebound();
            let off = |longest: f64| {
                let mut contact = contact.clone();
                let seen = SteppedMass { impact, longest }.rebound(&mut contact).unwrap();
                let time = seen.contact_time.unwrap() / exact.contact_time.unwrap() - 1.0;
                (seen.restitution - exact.restitution).abs().max(time.abs())
            };
            let (coarse, fine) = (off(0.02), off(0.01));
            assert!(coarse < 1e-3 && fine < 0.5 * coarse, "{work}: {coarse:e} {fine:e}");
        }
    }
}
