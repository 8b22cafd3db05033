//! Springs that are let go in a motion, and the sums over those that are left.

use super::{Event, Instant, Lazy};
use crate::contact::viscoelastic::spring::{Motion, Piece, Spring, pressed_until};
use crate::contact::viscoelastic::totals::{Numbers, Totals};
use std::ops::Range;

impl Lazy {
    /// When [s] the last spring, the one under the apex, is let go in a motion at `speed` [m/s] for `duration` [s], if it is.
    #[must_use]
    pub fn parting(&self, speed: f64, duration: f64) -> Option<f64> {
        let motion = self.seen(0, &Motion { start: self.now.depth, speed, duration });
        match self.spring(0) {
            Spring::Pressed(loads) => self.spectrum.release(motion.start, &loads, speed, duration),
            Spring::Free(_) => None,
        }
    }

    /// The spring, if it is let go in a motion, `near` the time [s] at which its neighbour was, and then its own.
    pub(super) fn released_in(&self, spring: usize, motion: &Motion, near: &mut f64) -> Option<Event> {
        let (seen, loads): (_, Vec<f64>) = (self.seen(spring, motion), self.loads(spring).collect());
        let release = self.spectrum.release_near((seen.start, &loads, seen.speed), seen.duration, *near)?;
        *near = release;
        let mut impulse = 0.0;
        let watch = &mut |piece: &Piece<'_>| impulse += self.spectrum.impulse(piece);
        let after = pressed_until(&self.spectrum, loads.clone(), (&seen, Some(release)), watch);
        Some(Event { spring, before: Spring::Pressed(loads), after, impulse })
    }

    /// Adds up anew whenever the contact has halved, so that what is left never drowns in the rounding
    /// of what has gone: O(1) per spring released.
    pub(super) fn refresh(&mut self) {
        self.now.refreshed = self.now.refreshed.max(self.now.pressed);
        if 2 * self.now.pressed >= self.now.refreshed {
            return;
        }
        self.now.refreshed = self.now.pressed;
        let mut totals = Totals::new(&self.spectrum);
        self.add_pressed(&mut totals, 0..self.now.pressed, 1.0);
        totals.modes.clone_from(&self.now.totals.modes);
        self.now.totals = totals;
    }

    /// Adds pressed springs, as often as `times`, to sums: those that changed at the same instant have faded alike since.
    pub(super) fn add_pressed(&self, totals: &mut Totals, springs: Range<usize>, times: f64) {
        let mut faded: Option<(Instant, Numbers)> = None;
        for j in springs {
            let since = self.since[j];
            if faded.as_ref().is_none_or(|(instant, _)| *instant != since) {
                let age = self.now.instant.since(since);
                faded = Some((since, self.spectrum.terms().iter().map(|term| (-age / term.time).exp()).collect()));
            }
            let Some((_, left)) = &faded else { continue };
            let weight = times * self.layout.weight[j];
            let sums = totals.loads.iter_mut().zip(&mut totals.squares);
            let parts = self.constants[self.row(j)].iter().zip(left).zip(&self.now.memory);
            for ((load, square), ((constant, left), memory)) in sums.zip(parts) {
                let s = memory + left * constant;
                *load += weight * s;
                *square += weight * s * s;
            }
        }
    }
}
