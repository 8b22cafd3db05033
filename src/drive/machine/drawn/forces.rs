//! The forces on a mass whose contact sticks.

use super::super::Suspension;
use crate::friction::{Branch, TangentialMemory};
use crate::numerics::extrapolation::Motion;

/// Rounding of a force, relative to the greatest friction: that of a difference of two loads, twice that at most, each with
/// the rounding of its depth, its radius and its power, and twice all that in the third row of an extrapolation.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// The forces on a mass whose contact sticks, as a motion in time of its way since the beginning of the step, speed, work and loss.
pub(super) struct Sticking<'m> {
    pub(super) suspension: Suspension,
    pub(super) memory: &'m TangentialMemory,
    /// Its force up to the next turning point; none of a contact that slips as a whole.
    pub(super) branch: Option<Branch<'m>>,
    pub(super) drawn: f64,
    /// Way since the memory was led on, and extension of the spring, at the beginning of the step [m].
    pub(super) from: (f64, f64),
}

impl Sticking<'_> {
    fn friction(&self, way: f64) -> f64 {
        self.branch.map_or_else(|| self.memory.state().tangential_force, |branch| branch.force(self.from.0 + way))
    }

    pub(super) fn pull(&self, time: f64, way: f64) -> f64 {
        self.suspension.stiffness * (self.from.1 + (self.drawn * time - way))
    }

    /// Acceleration [m/s²].
    pub(super) fn acceleration(&self, time: f64, way: f64, speed: f64) -> f64 {
        let drag = self.suspension.damping * speed;
        (self.pull(time, way) - drag - self.friction(way)) / self.suspension.mass
    }

    /// Greatest rounding of the acceleration [m/s²].
    pub(super) fn noise(&self) -> f64 {
        let limit = self.memory.limit().max(self.suspension.stiffness * self.from.1.abs());
        ROUNDING * limit / self.suspension.mass
    }

    /// Duration [s] of a radian of the fastest swing.
    pub(super) fn radian(&self) -> f64 {
        (self.suspension.mass / (self.suspension.stiffness + self.memory.stuck())).sqrt()
    }
}

impl Motion<4> for Sticking<'_> {
    fn rate(&mut self, time: f64, &[way, speed, _, _]: &[f64; 4]) -> [f64; 4] {
        let work = self.pull(time, way) * self.drawn;
        [speed, self.acceleration(time, way, speed), work, self.suspension.damping * speed * speed]
    }

    fn rounding(&self) -> [f64; 4] {
        [self.noise() * self.radian(), self.noise(), 0.0, 0.0]
    }
}

/// The same over the root σ of the way to a corner, from σ₀ down: time, speed, work and loss.
pub(super) struct Approach<'m> {
    pub(super) sticking: Sticking<'m>,
    /// Way [m] from the beginning to the corner, and its direction, 1 or −1.
    pub(super) whole: f64,
    pub(super) ahead: f64,
    /// σ at the beginning of the step.
    pub(super) root: f64,
}

impl Motion<4> for Approach<'_> {
    fn rate(&mut self, since: f64, &[time, speed, _, _]: &[f64; 4]) -> [f64; 4] {
        let root = self.root - since;
        let way = self.ahead * (self.whole - root * root);
        let onwards = self.ahead * speed;
        if onwards <= 0.0 {
            return [f64::NAN; 4];
        }
        let pace = 2.0 * root / onwards;
        let work = self.sticking.pull(time, way) * self.sticking.drawn;
        let loss = self.sticking.suspension.damping * speed * speed;
        [pace, pace * self.sticking.acceleration(time, way, speed), pace * work, pace * loss]
    }
}
