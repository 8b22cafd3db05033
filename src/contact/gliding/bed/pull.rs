//! The bed of a body that moves along under a prescribed force.

use super::{GlidingBed, Window, integer};
use crate::contact::error::ContactError;
use crate::contact::model::Pull;

/// Most halvings of a step under a prescribed force.
const HALVINGS: u32 = 40;
/// By how much a force may be missed at the end of a piece, as a part of itself.
const ROUNDING: f64 = 1e-12;

impl GlidingBed {
    /// The part of the bed that the body can meet within `duration` [s]: cheap to take and to throw away.
    fn scout(&self, along: f64, duration: f64) -> Self {
        let cells = |place: f64| integer(place / self.width);
        let (one, other) = (cells(self.now.place), cells(self.now.place + along * duration));
        let extent = self.outline.extent();
        let (from, to) = match self.outline.ring() {
            Some(_) => (self.first, self.end()),
            None => ((one.min(other) + extent.start).max(self.first), (one.max(other) + extent.end).min(self.end())),
        };
        let at = |j: i64| usize::try_from(j - self.first).unwrap_or(0).min(self.springs.len());
        Self {
            springs: self.springs.range(at(from)..at(to).max(at(from))).cloned().collect(),
            first: from,
            kernel: self.kernel.clone(),
            outline: self.outline.clone(),
            window: Window::default(),
            ..*self
        }
    }

    /// The force at the end of a piece, which is not taken.
    fn force_after(&self, down: f64, along: f64, duration: f64) -> Result<f64, ContactError> {
        let mut scout = self.scout(along, duration);
        scout.advance(self.now.depth + down * duration, self.now.place + along * duration, duration)?;
        Ok(scout.forces().0)
    }

    /// Speed down [m/s] that brings the force to `force` [N] after `duration` [s].
    fn speed_to(&self, force: f64, along: f64, duration: f64) -> Result<f64, ContactError> {
        let scale = force.abs().max(self.forces().0);
        let lack = |down: f64| Ok::<f64, ContactError>(self.force_after(down, along, duration)? - force);
        let mut one = (self.moved.down, lack(self.moved.down)?);
        let stiffness = self.stiffness().max(self.stiffness_of_touch());
        let mut two = (one.0 - one.1 / (stiffness * duration), f64::NAN);
        two.1 = lack(two.0)?;
        let within = ROUNDING * scale;
        for _ in 0..60 {
            if two.1.abs() <= within || one.1.total_cmp(&two.1).is_eq() {
                break;
            }
            let next = two.0 - two.1 * (two.0 - one.0) / (two.1 - one.1);
            // Bodies apart carry nothing, however far: half the way back from there.
            let next = if two.1 <= -force && force > 0.0 { 0.5 * (one.0 + two.0) } else { next };
            (one, two) = (two, (next, lack(next)?));
        }
        Ok(two.0)
    }

    /// Follows a prescribed force: in the middle of every straight piece of the depth it is right to the accuracy.
    pub(super) fn pull(&mut self, pull: &Pull) -> Result<(), ContactError> {
        let duration = if pull.duration > 0.0 { pull.duration } else { self.spectrum().instant() };
        let (from, along) = (self.forces().0, (pull.slide - self.now.place) / duration);
        let at = |time: f64| from + (pull.force - from) * (time / duration);
        let (mut time, tolerance) = (0.0, self.accuracy * from.max(pull.force));
        while time < duration {
            let mut step = self.step.min(duration - time);
            let mut halvings = 0;
            let down = loop {
                let down = self.speed_to(at(time + step), along, step)?;
                let middle = self.force_after(down, along, 0.5 * step)? - at(time + 0.5 * step);
                if middle.abs() <= tolerance || halvings >= HALVINGS {
                    if 8.0 * middle.abs() < tolerance {
                        self.step = 2.0 * step;
                    }
                    break down;
                }
                (step, halvings) = (0.5 * step, halvings + 1);
                self.step = step;
            };
            let last = time + step >= duration;
            let place = if last { pull.slide } else { self.now.place + along * step };
            self.advance(self.now.depth + down * step, place, step)?;
            time = if last { duration } else { time + step };
        }
        Ok(())
    }
}
