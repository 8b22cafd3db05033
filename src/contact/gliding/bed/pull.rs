//! The bed of a body that moves along under a prescribed force.

use super::{GlidingBed, Window, integer};
use crate::contact::error::ContactError;
use crate::contact::model::Pull;
use std::f64::consts::FRAC_1_SQRT_2;

/// A step in two straight pieces of the depth.
#[derive(Debug, Clone, Copy)]
struct Step {
    /// Speeds down [m/s].
    down: [f64; 2],
    /// Force [N] by which pieces miss the depth between their ends.
    missed: f64,
}

/// Shortest step under a prescribed force, as a part of its duration; what it misses, it misses.
const SHORTEST: f64 = 1e-9;
/// Most speeds that are tried for a force.
const MOST_TRIALS: u32 = 100;
/// Part γ = 1 − 1/√2 of a step after which the force is met for the first time.
const STAGE: f64 = 1.0 - FRAC_1_SQRT_2;
/// By how much a force may be missed in the end, as a part of the largest.
const ROUNDING: f64 = 1e-12;
/// By how much on the way there, as a part of what pieces may miss.
const UNSEEN: f64 = 1e-3;

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
        Ok(self.after(down, along, duration)?.force())
    }

    /// Speed down [m/s] that brings the force to `force` [N] after `duration` [s], to `within` [N].
    fn speed_to(&self, force: f64, (along, duration): (f64, f64), within: f64) -> Result<f64, ContactError> {
        let lack = |down: f64| Ok::<f64, ContactError>(self.force_after(down, along, duration)? - force);
        let mut one = (self.moved.down, lack(self.moved.down)?);
        let stiffness = self.stiffness().max(self.stiffness_of_touch());
        let mut next = one.0 - one.1 / (stiffness * duration + self.damping());
        // The force grows with the speed: nearest speeds at which it is too small and too large.
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        for _ in 0..MOST_TRIALS {
            *(if one.1 < 0.0 { &mut low } else { &mut high }) = one.0;
            if low.is_finite() && high.is_finite() && !(low < next && next < high) {
                next = 0.5 * (low + high);
            }
            if one.1.abs() <= within || next.total_cmp(&one.0).is_eq() {
                break;
            }
            let two = (next, lack(next)?);
            // Bodies apart carry nothing, however far: half the way back from there.
            let apart = two.1 <= -force && force > 0.0;
            let secant = two.0 - two.1 * (two.0 - one.0) / (two.1 - one.1);
            next = if apart || !secant.is_finite() { 0.5 * (one.0 + two.0) } else { secant };
            one = two;
        }
        Ok(one.0)
    }

    /// A step of the duration `step` [s] under a force that goes from `from` to `to` [N].
    ///
    /// The first piece lasts (1 − γ)h and meets the force after γh, the second meets it at its end, with γ = 1 − 1/√2: the
    /// L-stable diagonally implicit method of second order (Alexander 1977), whose stages are on the way of the
    /// body. So elements that relax within a step and dashpots, whose force depends on the speed, do not shorten it. It
    /// misses what the chord of the depth is, d″h²/8.
    fn step(&self, [from, to]: [f64; 2], (along, step): (f64, f64), within: f64) -> Result<Step, ContactError> {
        let [stage, first] = [STAGE * step, (1.0 - STAGE) * step];
        let mut scout = self.scout(along, step);
        let one = scout.speed_to(from + STAGE * (to - from), (along, stage), within)?;
        scout.advance(scout.now.depth + one * first, scout.now.place + along * first, first)?;
        let two = scout.speed_to(to, (along, stage), within)?;
        scout.advance(scout.now.depth + two * stage, scout.now.place + along * stage, stage)?;
        let felt = scout.stiffness_after(first).max(to.abs() / scout.now.depth.abs().max(f64::MIN_POSITIVE));
        Ok(Step { down: [one, two], missed: 0.125 * felt * (two - one).abs() * first })
    }

    /// Follows a prescribed force: along every straight piece of the depth it is right to the accuracy, and at the end.
    pub(super) fn pull(&mut self, pull: &Pull) -> Result<(), ContactError> {
        let duration = if pull.duration > 0.0 { pull.duration } else { self.spectrum().instant() };
        let (from, along) = (self.force(), (pull.slide - self.now.place) / duration);
        let at = |time: f64| from + (pull.force - from) * (time / duration);
        let (largest, shortest) = (from.max(pull.force), SHORTEST * duration);
        let (mut time, tolerance) = (0.0, self.accuracy * largest);
        while time < duration {
            let rest = duration - time;
            // A rest that is rounding is no step.
            let mut step = if self.step < rest * (1.0 - SHORTEST) { self.step.max(shortest) } else { rest };
            let taken = loop {
                let within = if step < rest { UNSEEN * tolerance } else { ROUNDING * largest };
                let taken = self.step([at(time), at(time + step)], (along, step), within)?;
                if taken.missed <= tolerance || step <= shortest {
                    if 8.0 * taken.missed < tolerance {
                        self.step = self.step.max(2.0 * step);
                    }
                    break taken;
                }
                step *= 0.5;
                self.step = step;
            };
            let last = step >= rest;
            let place = self.now.place + along * step;
            let stage = STAGE * step;
            self.advance(self.now.depth + taken.down[0] * (step - stage), place - along * stage, step - stage)?;
            self.advance(self.now.depth + taken.down[1] * stage, if last { pull.slide } else { place }, stage)?;
            time = if last { duration } else { time + step };
        }
        Ok(())
    }
}
