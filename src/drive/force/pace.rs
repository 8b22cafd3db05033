//! The speed of the next piece: as the depth has followed the force lately, and where that leads nowhere by a search.

use super::search::{Found, Goal, damping};
use super::{CLOSE, ForceDrive, PARTED, Watched, ahead, depth_of, has_dashpot, is_damped};
use crate::contact::error::{BedError, ContactError};
use crate::contact::model::ContactModel;
use crate::contact::state::Normal;

/// Part of the error allowed by which the force may be missed at the end of a piece.
const NEAR: f64 = 1e-2;
/// The same of the last piece, relative to the largest force.
const NEAREST: f64 = 1e-12;
/// Looks for a speed from the pace on, before it is searched for from rest.
const MOST_LOOKS: u32 = 8;
/// Part of what a look was off by that the next one may be off by, if the pace leads there.
const CLOSER: f64 = 0.25;

/// How the depth has followed the force lately: where the next piece is looked for.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Pace {
    /// Speeds [m/s] of the last two pieces and the times [s] of their middles, the newest first.
    speeds: [Option<(f64, f64)>; 2],
    /// By what the force has grown with the way on the last piece [N/m], behind a dashpot with the speed [N s/m].
    slope: Option<f64>,
}

impl Pace {
    /// The speed [m/s] of a piece whose middle is at the time `t` [s], if all goes on as before.
    pub(super) fn at(&self, t: f64) -> f64 {
        match self.speeds {
            [Some((now, at)), Some((before, then))] if at > then => now + (now - before) * (t - at) / (at - then),
            [Some((now, _)), _] => now,
            _ => 0.0,
        }
    }

    /// Whether more than one piece has told it.
    pub(super) fn is_known(&self) -> bool {
        self.speeds[1].is_some()
    }

    pub(super) fn add(&mut self, speed: f64, middle: f64) {
        self.speeds = [Some((speed, middle)), self.speeds[0]];
    }
}

impl ForceDrive {
    /// The speed that leads to the force at the time `until`, over no more than so many places of the edge, and up to a jump
    /// over it if those are told.
    pub(super) fn speed(
        &mut self,
        (contact, here): Watched<'_>,
        until: f64,
        (edges, tells_jumps): (u32, bool),
    ) -> Result<Found, ContactError> {
        let duration = until - self.now;
        match self.exact(until) {
            Some(creep) => {
                let depth = creep.indentation().ok_or(BedError::Overloaded { force: creep.force() })?;
                Ok(Found::Speed((depth - depth_of(contact)) / duration))
            }
            None => {
                let until = if self.meets_in_the_middle(contact) { self.now + 0.5 * duration } else { until };
                match self.paced((contact, here), until) {
                    Some(speed) => Ok(Found::Speed(speed)),
                    None => {
                        let (force, within) = (self.target(here, until), self.within((contact, here), until));
                        let relative =
                            if until - self.now > PARTED * self.end { CLOSE * self.ramp.accuracy } else { 0.0 };
                        let pace = if tells_jumps { self.pace.at(until) } else { f64::INFINITY };
                        Goal { force, within, relative, edges, pace }.speed(contact, here, until - self.now)
                    }
                }
            }
        }
    }

    /// By how much the force [N] may be missed at the time `until` [s].
    pub(super) fn within(&self, (contact, here): (&dyn ContactModel, &Normal), until: f64) -> f64 {
        let scale = self.ramp.scale.max(here.in_balance());
        if until < self.end { NEAR * self.allowed((contact, here), until) } else { NEAREST * scale }
    }

    /// Whether pieces meet the force in their middles.
    pub(super) fn meets_in_the_middle(&self, contact: &dyn ContactModel) -> bool {
        self.exact(self.now).is_none() && is_damped(contact)
    }

    /// The same by secants from the pace on; `None` where they lead nowhere soon.
    fn paced(&mut self, (contact, here): Watched<'_>, until: f64) -> Option<f64> {
        let (force, duration) = (self.target(here, until), until - self.now);
        let within = self.within((contact, here), until);
        // What a dashpot bears is that of the speed, however long the piece.
        let is_of_speed = has_dashpot(contact);
        let length = if is_of_speed { 1.0 } else { duration };
        let first = if is_of_speed { damping(contact, here.stiffness) } else { here.stiffness };
        let mut slope = self.pace.slope.unwrap_or(first) * length;
        let mut speed = self.pace.at(self.now + 0.5 * duration);
        let mut before: Option<(f64, f64)> = None;
        for _ in 0..MOST_LOOKS {
            let seen = contact.look(&ahead(contact, speed, duration)).ok()?;
            let off = seen.force - force;
            if let Some((then, was)) = before {
                slope = (off - was) / (speed - then);
            }
            if seen.contact_radius <= 0.0 || slope.is_nan() || slope <= 0.0 {
                return None;
            }
            if off.abs() <= within {
                self.pace.slope = Some(slope / length);
                return Some(speed);
            }
            if before.is_some_and(|(_, was)| off.abs() > CLOSER * was.abs()) {
                // The last piece was not as stiff; the next may be as this one.
                self.pace.slope = Some(slope / length);
                return None;
            }
            before = Some((speed, off));
            speed -= off / slope;
        }
        None
    }
}
