//! A mass that is drawn so slowly that it is in balance all the time, while the contact sticks.

use super::super::Suspension;
use super::DrawnState;
use crate::friction::{FrictionError, Pose, TangentialMemory};
use crate::numerics::root;

/// A contact under a spring that is drawn out, k(X − x) = F_x + cẋ, without the inertia of the mass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Creep {
    pub(super) suspension: Suspension,
    /// Speed V of the far end [m/s].
    pub(super) drawn: f64,
    /// Displacement in the memory [m], extension of the spring [m] and time [s] at its beginning.
    pub(super) from: (f64, f64, f64),
}

impl Creep {
    /// Speed [m/s] of the mass against the stiffness `contact` [N/m] of the contact: V k/(k + k_x).
    pub(super) fn speed(&self, contact: f64) -> f64 {
        let stiffness = self.suspension.stiffness;
        self.drawn * stiffness / (stiffness + contact)
    }

    /// Time [s] at which the contact slips as a whole; never under a spring that is not drawn out.
    pub(super) fn slip_time(&self, memory: &TangentialMemory) -> f64 {
        if self.drawn.abs() <= 0.0 {
            return f64::INFINITY;
        }
        let ahead = 1f64.copysign(self.drawn);
        let (slide, extension, time) = self.from;
        let last = memory.last_corner(ahead);
        let drawn_out = (ahead * memory.limit() + self.suspension.damping * self.drawn) / self.suspension.stiffness;
        time + (((drawn_out - extension) + (last - slide)) / self.drawn).max(0.0)
    }

    /// Displacement [m] at the time `time` [s].
    ///
    /// # Errors
    /// The indentation leaves the profile.
    pub(super) fn at(&self, memory: &TangentialMemory, time: f64) -> Result<f64, FrictionError> {
        let ahead = 1f64.copysign(self.drawn);
        let (slide, extension, begin) = self.from;
        let indentation = memory.position().indentation;
        let out = extension + self.drawn * (time - begin);
        let pulled = |at: f64| {
            let mut there = memory.clone();
            let moved = there.advance(Pose { indentation, slide: at });
            let state = there.state();
            let drag = self.suspension.damping * self.speed(state.stiffness);
            let force = self.suspension.stiffness * (out - (at - slide)) - state.tangential_force - drag;
            moved.map_or(f64::NAN, |()| ahead * force)
        };
        let last = memory.last_corner(ahead);
        if pulled(slide) <= 0.0 {
            return Ok(slide);
        }
        // Rounding alone may leave no root before the last corner.
        Ok(root::brent(pulled, slide, last).unwrap_or(last))
    }
}

/// What a mass has beyond the balance [J]: half of it kinetic, as it swings.
pub(super) fn beyond(suspension: &Suspension, state: &DrawnState, (force, contact): (f64, f64), drawn: f64) -> f64 {
    let Suspension { mass, stiffness, damping } = *suspension;
    let fast = state.speed - drawn * stiffness / (stiffness + contact);
    let miss = stiffness * state.extension - force - damping * state.speed;
    0.5 * mass * fast * fast + 0.5 * miss * miss / (stiffness + contact)
}
