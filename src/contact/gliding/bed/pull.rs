//! The bed of a body that moves along under a prescribed force.

use super::{GlidingBed, Window, integer};
use crate::contact::error::ContactError;
use crate::contact::model::Pull;

/// Most halvings of a step under a prescribed force.
const HALVINGS: u32 = 40;
/// Part of the way on which a dashpot takes on the speed at which it meets the last force.
const MEETING: f64 = 1e-6;
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

    /// The bed at the end of a piece, which is not taken.
    fn after(&self, down: f64, along: f64, duration: f64) -> Result<Self, ContactError> {
        let mut scout = self.scout(along, duration);
        scout.advance(self.now.depth + down * duration, self.now.place + along * duration, duration)?;
        Ok(scout)
    }

    /// The force there [N].
    fn force_after(&self, down: f64, along: f64, duration: f64) -> Result<f64, ContactError> {
        Ok(self.after(down, along, duration)?.forces().0)
    }

    /// Speed down [m/s] that brings the force to `force` [N] after `duration` [s].
    fn speed_to(&self, force: f64, along: f64, duration: f64) -> Result<f64, ContactError> {
        let scale = force.abs().max(self.forces().0);
        let lack = |down: f64| Ok::<f64, ContactError>(self.force_after(down, along, duration)? - force);
        let mut one = (self.moved.down, lack(self.moved.down)?);
        let stiffness = self.stiffness().max(self.stiffness_of_touch());
        let mut two = (one.0 - one.1 / (stiffness * duration + self.damping()), f64::NAN);
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

    /// The speed down [m/s] of a piece of the duration `step` [s] under a force that goes from `from` to `to` [N], and what it
    /// misses [N].
    ///
    /// The force is met at the end, and missed in the middle by what a straight piece cannot follow. That of a dashpot jumps
    /// with the speed: it is met in the middle, the implicit midpoint rule, and missed by what the chord of the depth is,
    /// d″h²/8.
    fn piece(&self, [from, to]: [f64; 2], along: f64, step: f64) -> Result<(f64, f64), ContactError> {
        let middle = 0.5 * (from + to);
        if self.spectrum().viscosity() <= 0.0 {
            let down = self.speed_to(to, along, step)?;
            return Ok((down, self.force_after(down, along, 0.5 * step)? - middle));
        }
        let down = self.speed_to(middle, along, 0.5 * step)?;
        let end = self.after(down, along, step)?;
        let felt = end.stiffness().max(middle.abs() / end.now.depth.abs().max(f64::MIN_POSITIVE));
        Ok((down, 0.125 * felt * (down - self.moved.down) * step))
    }

    /// Follows a prescribed force: in the middle of every straight piece of the depth it is right to the accuracy, and at the
    /// end of the last one, which a dashpot makes a very short one.
    pub(super) fn pull(&mut self, pull: &Pull) -> Result<(), ContactError> {
        let duration = if pull.duration > 0.0 { pull.duration } else { self.spectrum().instant() };
        let (from, along) = (self.forces().0, (pull.slide - self.now.place) / duration);
        let at = |time: f64| from + (pull.force - from) * (time / duration);
        let (mut time, tolerance) = (0.0, self.accuracy * from.max(pull.force));
        let damped = self.spectrum().viscosity() > 0.0;
        let until = if damped { duration * (1.0 - MEETING) } else { duration };
        while time < until {
            let mut step = self.step.min(until - time);
            let mut halvings = 0;
            let down = loop {
                let (down, missed) = self.piece([at(time), at(time + step)], along, step)?;
                if missed.abs() <= tolerance || halvings >= HALVINGS {
                    if 8.0 * missed.abs() < tolerance {
                        self.step = 2.0 * step;
                    }
                    break down;
                }
                (step, halvings) = (0.5 * step, halvings + 1);
                self.step = step;
            };
            let last = time + step >= until;
            let place = if last && !damped { pull.slide } else { self.now.place + along * step };
            self.advance(self.now.depth + down * step, place, step)?;
            time = if last { until } else { time + step };
        }
        if damped {
            let rest = duration - until;
            let down = self.speed_to(pull.force, along, rest)?;
            self.advance(self.now.depth + down * rest, pull.slide, rest)?;
        }
        Ok(())
    }
}
