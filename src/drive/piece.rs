//! The way of a contact without memory from record to record: one straight piece.

use super::course::Course;
use super::{Driver, Occurrence, prescribed};
use crate::contact::adhesion::equilibrium::Control;
use crate::contact::error::ContactError;
use crate::contact::model::{ContactModel, Event, Pull, Straight};
use crate::contact::state::Tangential;

impl Driver {
    /// One straight piece to the next record.
    pub(super) fn step(
        &mut self,
        contact: &mut dyn ContactModel,
        part: f64,
        occurrences: &mut Vec<Occurrence>,
    ) -> Result<(), ContactError> {
        let stage = &self.stage;
        let Course { control, normal, tangential, over, .. } = stage.course;
        let (to, slide) = (normal.at(stage.from, part, over), tangential.at(stage.slide, part, over));
        // Of bodies that a pull has parted the state does not know what pulls them.
        let pulled = control == Control::Force && contact.state().indentation.is_none();
        let behind = if over > 0.0 { stage.now / over } else { 0.0 };
        let from =
            if pulled { normal.at(stage.from, behind, over) } else { prescribed(contact, &contact.state(), control) };
        let (duration, sliding_speed) = (part * over - stage.now, stage.sliding_speed());
        let before = contact.tangential();
        let events = match control {
            Control::Indentation => {
                let piece = Straight { slide, sliding_speed, ..Straight::between(from, to, duration) };
                contact.follow(&piece)?
            }
            // Without a push they stay apart.
            Control::Force if pulled && to <= 0.0 => {
                // What rubs is told where it goes all the same.
                let force = to.min(-f64::MIN_POSITIVE);
                let past = before.and_then(|_| contact.press(&Pull { force, slide, sliding_speed, duration }));
                past.unwrap_or_else(|| Ok(Vec::new()))?
            }
            Control::Force => {
                let pull = Pull { force: to, slide, sliding_speed, duration };
                contact.press(&pull).unwrap_or_else(|| Ok(Vec::new()))?
            }
        };
        let part = |from: f64, to: f64, at: f64| {
            if (to - from).abs() > 0.0 { ((at - from) / (to - from)).clamp(0.0, 1.0) } else { 0.0 }
        };
        // Where nothing moves but along the surface, it is the slide that tells.
        let slid = |there: Tangential| part(before.map_or(0.0, |before| before.slide), slide, there.slide);
        let time = |event: &Event| match event.tangential.filter(|_| (to - from).abs() <= 0.0) {
            Some(there) => slid(there),
            None => part(from, to, event.at),
        };
        occurrences.extend(events.iter().map(|event| Occurrence {
            time: stage.now + time(event) * duration,
            before: event.before,
            after: event.after,
            tangential: event.tangential.or(before),
        }));
        Ok(())
    }
}
