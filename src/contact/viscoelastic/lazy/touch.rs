//! Springs that are touched in a motion: again, or for the first time.

use super::{Event, Lazy};
use crate::contact::viscoelastic::ledger::first_load;
use crate::contact::viscoelastic::spring::{Motion, Spring};
use std::ops::Range;

/// A spring touched for the first time: where from [m], how fast [m/s] and for how long [s] it has been pressed.
pub(super) struct FirstTouch {
    spring: usize,
    from: f64,
    speed: f64,
    duration: f64,
}

impl Lazy {
    /// The springs that were touched before and are touched again in a motion, from the edge on.
    pub(super) fn touched_again(&self, motion: &Motion) -> Vec<Event> {
        (self.now.pressed..self.now.touched).map_while(|j| self.touched_in(j, motion)).collect()
    }

    /// The springs never touched before that a motion reaches, where it touches `again` others on its way to them.
    pub(super) fn touched_first(&self, again: usize, motion: &Motion) -> Range<usize> {
        let touched = self.now.touched;
        let reaches = self.now.pressed + again >= touched && motion.speed > 0.0;
        let reached = |height: &f64| (height - motion.start) / motion.speed <= motion.duration;
        let ahead = if reaches { &self.layout.height[touched..] } else { &[] };
        touched..touched + ahead.iter().take_while(|height| reached(height)).count()
    }

    /// Presses the spring `j`, never touched before, from the instant on at which a motion that is over has reached it. Its load
    /// counts at once, but for what is done and stored; it is to be [kept](Self::keep) if more of it is to be asked for.
    pub(super) fn touch_first(&mut self, j: usize, motion: &Motion) -> FirstTouch {
        let (weight, seen) = (self.layout.weight[j], self.seen(j, motion));
        let at = (-seen.start / seen.speed).max(0.0);
        let touch = FirstTouch { spring: j, from: seen.depth(at), speed: seen.speed, duration: seen.duration - at };
        for (sum, term) in self.now.totals.loads.iter_mut().zip(self.spectrum.terms()) {
            *sum += weight * first_load(term, touch.speed, touch.duration).0;
        }
        (self.now.pressed, self.now.touched) = (j + 1, j + 1);
        touch
    }

    /// Keeps a spring touched for the first time, and accounts for it.
    pub(super) fn keep(&mut self, touch: &FirstTouch) {
        let FirstTouch { spring: j, from, speed, duration } = *touch;
        self.note(j);
        self.since[j] = self.now.instant;
        let (weight, row) = (self.layout.weight[j], self.row(j));
        let Self { spectrum, now, constants, .. } = self;
        let steady = spectrum.equilibrium() * (from + 0.5 * speed * duration) + spectrum.viscosity() * speed;
        let mut impulse = duration * steady;
        let sums = now.totals.squares.iter_mut().zip(&now.memory);
        for ((term, constant), (square, memory)) in spectrum.terms().iter().zip(&mut constants[row]).zip(sums) {
            let (load, over) = first_load(term, speed, duration);
            *square += weight * load * load;
            *constant = load - memory;
            impulse += over();
        }
        now.impulse += weight * impulse;
    }

    pub(super) fn touched_in(&self, spring: usize, motion: &Motion) -> Option<Event> {
        let (before, seen) = (self.spring(spring), self.seen(spring, motion));
        let Spring::Free(free) = &before else { return None };
        self.spectrum.touch(free, &seen)?;
        Some(self.event(spring, before, &seen))
    }
}
