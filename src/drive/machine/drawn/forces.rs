//! The forces on a mass whose contact sticks.

use super::super::Suspension;
use crate::friction::{Pose, TangentialMemory};
use crate::numerics::extrapolation::Motion;

/// Rounding of a force, relative to the greatest friction.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// The forces on a mass whose contact sticks, as a motion in time of displacement, speed, work and loss.
pub(super) struct Sticking<'m> {
    pub(super) suspension: Suspension,
    pub(super) memory: &'m TangentialMemory,
    pub(super) drawn: f64,
    /// Displacement in the memory and extension of the spring at the beginning of the step [m].
    pub(super) from: (f64, f64),
}

impl Sticking<'_> {
    fn friction(&self, slide: f64) -> f64 {
        let indentation = self.memory.position().indentation;
        self.memory.force_at(Pose { indentation, slide }).unwrap_or(f64::NAN)
    }

    pub(super) fn pull(&self, time: f64, slide: f64) -> f64 {
        self.suspension.stiffness * (self.from.1 + self.drawn * time - (slide - self.from.0))
    }

    /// Acceleration [m/s²].
    pub(super) fn acceleration(&self, time: f64, slide: f64, speed: f64) -> f64 {
        let drag = self.suspension.damping * speed;
        (self.pull(time, slide) - drag - self.friction(slide)) / self.suspension.mass
    }

    /// Greatest rounding of the acceleration [m/s²].
    pub(super) fn noise(&self) -> f64 {
        let limit = self.memory.limit().max(self.suspension.stiffness * self.from.1.abs());
        ROUNDING * limit / self.suspension.mass
    }
}

impl Motion<4> for Sticking<'_> {
    fn rate(&mut self, time: f64, &[slide, speed, _, _]: &[f64; 4]) -> [f64; 4] {
        let work = self.pull(time, slide) * self.drawn;
        [speed, self.acceleration(time, slide, speed), work, self.suspension.damping * speed * speed]
    }

    fn rounding(&self) -> [f64; 4] {
        [0.0, self.noise(), 0.0, 0.0]
    }
}

/// The same over the root σ of the way to a corner, from σ₀ down: time, speed, work and loss.
pub(super) struct Approach<'m> {
    pub(super) sticking: Sticking<'m>,
    pub(super) corner: f64,
    pub(super) ahead: f64,
    /// σ at the beginning of the step.
    pub(super) root: f64,
}

impl Motion<4> for Approach<'_> {
    fn rate(&mut self, since: f64, &[time, speed, _, _]: &[f64; 4]) -> [f64; 4] {
        let root = self.root - since;
        let slide = self.corner - self.ahead * root * root;
        let onwards = self.ahead * speed;
        if onwards <= 0.0 {
            return [f64::NAN; 4];
        }
        let pace = 2.0 * root / onwards;
        let work = self.sticking.pull(time, slide) * self.sticking.drawn;
        let loss = self.sticking.suspension.damping * speed * speed;
        [pace, pace * self.sticking.acceleration(time, slide, speed), pace * work, pace * loss]
    }
}
