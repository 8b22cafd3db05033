//! What lies on its dent: bodies that remember, touch, and that no force presses.
//!
//! Whatever pushed them would press the dent in again, and a dashpot makes much of a little. So the bodies are drawn apart
//! by less than the depth is known, and meet again at the end of the piece: what comes up in between does so freely, and
//! errors of the depth do not add up.

use super::apart::way_to_touch;
use super::search::LEAST_DEPTH;
use super::{ForceDrive, SHORTEST, Stretch, ahead, depth_of};
use crate::contact::model::ContactModel;
use crate::contact::state::Normal;

/// Multiple of the least force asked for that is none: as it comes to nothing a force is known no better.
const NOTHING: f64 = 10.0;
/// Places of a piece at which the bodies may not touch and are no further apart than the depth is known.
const PLACES: [f64; 3] = [0.25, 0.5, 0.75];
/// Part of the gap that may be left at the end of a piece.
const ENDS: f64 = 1e-2;
/// Longest piece, relative to the one before, and if that had to be shortened.
const LONGER: [f64; 2] = [4.0, 1.5];
/// Part that is left of a piece too long.
const SHORTENED: f64 = 0.5;

/// How bodies lie upon each other.
#[derive(Debug, Clone, Copy, Default)]
pub(super) enum Lying {
    /// Not, or not known.
    #[default]
    Unknown,
    /// They touch, as the last piece has ended so.
    Touching,
    /// They are drawn apart.
    Apart,
    /// They do not follow so and are led.
    Led,
}

impl ForceDrive {
    /// How far apart \[m\] bodies may be that should touch: the accuracy, of the largest depth of the drive.
    fn gap(&self) -> f64 {
        0.5 * self.ramp.accuracy * self.deepest
    }

    /// The next piece of bodies on a dent that nothing presses from now on, `None` if they are not.
    pub(super) fn lies(&mut self, contact: &mut dyn ContactModel, here: &Normal) -> Option<Stretch> {
        let is_free = self.ramp.rate == 0.0 && self.ramp.from.abs() < NOTHING * super::touching(self.ramp.scale);
        if !is_free || contact.memory().is_none() || self.creep.is_some() || here.stored.surface < 0.0 {
            return None;
        }
        let piece = match self.lying {
            Lying::Apart => self.meets_again(contact),
            Lying::Unknown | Lying::Touching => self.draws_apart(contact),
            Lying::Led => None,
        };
        if piece.is_none() {
            self.lying = Lying::Led;
        }
        piece
    }

    fn draws_apart(&mut self, contact: &mut dyn ContactModel) -> Option<Stretch> {
        let until = (self.now + SHORTEST * self.end).max(self.now.next_up());
        let (duration, gap, depth) = (until - self.now, self.gap(), depth_of(contact));
        if gap <= LEAST_DEPTH || until >= self.end {
            return None;
        }
        if matches!(self.lying, Lying::Unknown) && would_stick(contact, gap, duration) {
            return None;
        }
        let touch = match self.lying {
            Lying::Touching => depth,
            Lying::Unknown | Lying::Apart | Lying::Led => {
                way_to_touch(|to| touches(contact, to - depth, duration), depth.max(gap), ENDS * gap)
            }
        };
        if touch <= ENDS * gap {
            // Nothing comes up beyond where it lay before all.
            let speed = -depth / (self.end - self.now);
            self.now = self.end;
            return Some(Stretch { speed, until: self.end });
        }
        let speed = (touch - gap - depth) / duration;
        (self.now, self.lying) = (until, Lying::Apart);
        Some(Stretch { speed, until })
    }

    fn meets_again(&mut self, contact: &mut dyn ContactModel) -> Option<Stretch> {
        let mut until = (self.now + self.step).min(self.end);
        let (depth, gap, mut longer) = (depth_of(contact), self.gap(), LONGER[0]);
        while until > self.now {
            let duration = until - self.now;
            let mut meets = |way: f64, lift: f64, part: f64| touches(contact, part * way + lift, part * duration);
            let way = way_to_touch(|to| meets(to - depth, 0.0, 1.0), depth.max(gap), ENDS * gap) - depth;
            let follows = PLACES.iter().all(|&part| !meets(way, 0.0, part) && meets(way, 2.0 * gap, part));
            if follows && !meets(way, 0.0, 1.0) {
                (self.now, self.step, self.lying) = (until, longer * duration, Lying::Touching);
                return Some(Stretch { speed: way / duration, until });
            }
            (until, longer) = (self.now + SHORTENED * duration, LONGER[1]);
        }
        None
    }
}

/// Whether bodies touch after a way \[m\] of `duration` [s].
fn touches(contact: &mut dyn ContactModel, way: f64, duration: f64) -> bool {
    contact.look(&ahead(contact, way / duration, duration)).map_or(true, |seen| seen.contact_radius > 0.0)
}

/// Whether bodies that are pressed by `way` \[m\] within `duration` \[s\] stick to each other.
fn would_stick(contact: &dyn ContactModel, way: f64, duration: f64) -> bool {
    let mut tried = contact.copy();
    tried.follow(&ahead(contact, way / duration, duration)).is_err() || tried.state().stored.surface < 0.0
}
