//! Bodies apart: how long they rest, and how they come near each other.

use super::pace::Pace;
use super::search::{LEAST_DEPTH, UNSEEN};
use super::{ForceDrive, PARTED, SHORTEST, Stretch, ahead, depth_of};
use crate::contact::error::ContactError;
use crate::contact::model::ContactModel;

/// Parts of a gap by which what closes it stays before the touch: no look along it tells that better, and a contact that
/// follows it may touch earlier by its rounding, or by what its panels may miss of the springs that are met first.
const SHORT_OF: [f64; 12] = [1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3];
/// No gap is longer than this [m].
const FARTHEST: f64 = 1e9;
/// Part of a way on which bodies that draw each other together have met, and next to nothing presses them.
const MEETING: f64 = 1e-9;

impl ForceDrive {
    /// The rest of bodies apart, until the force pushes them together or ends; `None` where there is nothing to wait for.
    pub(super) fn wait(&mut self) -> Option<Stretch> {
        let pushes = if self.ramp.rate > 0.0 { -self.ramp.from / self.ramp.rate } else { f64::INFINITY };
        // A force that comes back to none at the end does not push by its rounding.
        let pushes = if pushes < self.end * (1.0 - PARTED) { pushes } else { f64::INFINITY };
        let until = pushes.min(self.end);
        (self.parted, self.step, self.pace) = (pushes >= self.end, self.end, Pace::default());
        (until > self.now).then(|| {
            self.now = until;
            Stretch { speed: 0.0, until }
        })
    }

    /// The way of bodies apart to where they all but touch, in no time: a dashpot would feel how fast they come, and a search
    /// that begins so far away would lead bodies that draw each other in beyond where they balance. A dent that is not yet
    /// filled up is part of the way.
    pub(super) fn closes(&mut self, contact: &mut dyn ContactModel) -> Result<Option<Stretch>, ContactError> {
        if contact.joined() || contact.memory().is_none() || self.parted || self.now >= self.end {
            return Ok(None);
        }
        let until = (self.now + SHORTEST * self.end).max(self.now.next_up());
        let duration = until - self.now;
        let depth = depth_of(contact);
        let meets = |way: f64| match contact.look(&ahead(contact, way / duration, duration)) {
            Ok(seen) => seen.contact_radius > 0.0,
            Err(_) => true,
        };
        let gap = way_to_touch(meets, (-depth).max(LEAST_DEPTH), 0.0);
        let stays_apart = |way: &f64| {
            let mut copy = contact.copy();
            copy.follow(&ahead(contact, way / duration, duration)).is_ok() && !copy.joined()
        };
        let way = SHORT_OF.map(|part| (1.0 - part) * gap).into_iter().find(stays_apart).unwrap_or(0.0);
        Ok((way > LEAST_DEPTH.max(UNSEEN * depth.abs())).then(|| {
            self.now = until;
            Stretch { speed: way / duration, until }
        }))
    }
}

/// The longest way [m] on which bodies apart do not yet meet, about as long as `guess` [m], to `within` [m] at the best.
pub(super) fn way_to_touch(mut meets: impl FnMut(f64) -> bool, guess: f64, within: f64) -> f64 {
    let (mut near, mut far) = (0.0, guess);
    while far < FARTHEST && !meets(far) {
        (near, far) = (far, 2.0 * far);
    }
    while far > LEAST_DEPTH && far - near > within.max(UNSEEN * far) {
        let middle = 0.5 * (near + far);
        *(if meets(middle) { &mut far } else { &mut near }) = middle;
    }
    near
}

/// Whether bodies apart jump into contact as they meet: no time is so short that it would not be within it.
pub(super) fn draws(contact: &mut dyn ContactModel, speed: f64, duration: f64) -> Result<bool, ContactError> {
    Ok(!contact.joined() && contact.look(&ahead(contact, MEETING * speed, duration))?.force < 0.0)
}
