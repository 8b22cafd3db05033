//! A damped contact at no force: the indenter rests on a surface that comes up by itself.

use super::Driver;
use super::force::{self, ahead, depth_of};
use crate::contact::error::ContactError;
use crate::contact::model::{ContactModel, Straight};

/// Whether what is prescribed between the two forces `ends` [N] is none, beside the largest one so far, `scale` [N].
pub(super) fn at_no_force(ends: (f64, f64), scale: f64) -> bool {
    ends.0.max(ends.1) <= 2.0 * force::touching(scale) && ends.0.min(ends.1) >= 0.0
}

/// Whether a contact at no force does nothing but rest: it is damped, and nothing attracts.
pub(super) fn rests(contact: &dyn ContactModel) -> bool {
    force::is_damped(contact) && contact.state().stored.surface >= 0.0
}

impl Driver {
    /// At no force up to the time `until` [s]: what rests on a free surface changes nothing of it. The indenter is taken away,
    /// and put down again where the surface is then.
    pub(super) fn idle(&self, contact: &mut dyn ContactModel, until: f64) -> Result<(), ContactError> {
        let instant = contact.memory().map_or(0.0, |spectrum| spectrum.instant());
        let (slide, sliding_speed) = (self.stage.slide_at(until), self.stage.sliding_speed());
        let up = ahead(contact, -depth_of(contact) / instant, instant);
        contact.follow(&Straight { to: 0.0, slide: self.stage.slide_at(self.stage.now), ..up })?;
        contact.follow(&Straight { slide, sliding_speed, ..Straight::between(0.0, 0.0, until - self.stage.now) })?;
        if let Some(speed) = force::speed_to(contact, force::touching(self.largest), instant)? {
            contact.follow(&Straight { slide, ..ahead(contact, speed, instant) })?;
        }
        Ok(())
    }
}
