//! What a piece of the depth misses of the force, and what it may.

use super::search::damping;
use super::{ForceDrive, TOUCH, Watched, ahead, depth_of, is_damped};
use crate::contact::error::ContactError;
use crate::contact::model::ContactModel;
use crate::contact::state::Normal;

impl ForceDrive {
    /// Error of the force on a piece over the error allowed, in its middle and before it; of a damped contact that of its chord.
    ///
    /// Beside the exact creep it is that of the depth, F being about d^{3/2}: there the bed need not be asked.
    pub(super) fn error(&self, (contact, here): Watched<'_>, speed: f64, duration: f64) -> Result<f64, ContactError> {
        let half = 0.5 * duration;
        let middle = self.now + half;
        let allowed = self.allowed((contact, here), middle);
        let off = match self.exact(middle).and_then(|creep| creep.indentation()) {
            // From the speed at its beginning on the depth bends by d″h²/8 away from the chord, d″h/2 = v − v₀; so much
            // towards its end too, or more, where something is met on the way.
            _ if self.meets_in_the_middle(contact) => {
                let bend =
                    (speed - self.pace.at(self.now)).abs().max(self.bend_at_end((contact, here), speed, duration)?);
                0.5 * felt(here).max(self.ramp.stiffness) * bend * half
            }
            Some(depth) if depth > 0.0 => {
                let chord = depth_of(contact) + speed * half;
                1.5 * self.target(here, middle) * (1.0 - chord / depth)
            }
            _ => {
                // Bodies that have parted bear no force, and were drawn apart by none that is nothing.
                let barrier = if contact.joined() { here.in_balance() } else { 0.0 };
                let mut missed = |part: f64| -> Result<f64, ContactError> {
                    let seen = contact.look(&ahead(contact, speed, part * duration))?;
                    let off = (seen.force - self.target(here, self.now + part * duration)).abs();
                    Ok(if seen.contact_radius > 0.0 { off } else { off.max(barrier) })
                };
                let middle = missed(0.5)?;
                // What bends there and back again is nothing in the middle.
                if middle > allowed {
                    return Ok(middle / allowed);
                }
                // At its end they bear what they should where that is none.
                let may_end_apart = barrier > 0.0 && self.target(here, self.now + duration).abs() <= allowed;
                middle.max(missed(0.25)?).max(if may_end_apart { missed(1.0)? } else { 0.0 })
            }
        };
        Ok(off.abs() / allowed)
    }

    /// By what the speed [m/s] of a damped contact would have to change at the end of a piece to meet the force there.
    fn bend_at_end(&self, (contact, here): Watched<'_>, speed: f64, duration: f64) -> Result<f64, ContactError> {
        let end = contact.look(&ahead(contact, speed, duration))?.force;
        let missed = end - self.target(here, self.now + duration);
        let stiffness = here.stiffness;
        // A dashpot alone: its force is that of the speed.
        let damping = if stiffness > 0.0 { damping(contact, stiffness) } else { (end / speed).abs() };
        let bend = missed.abs() / (damping + 0.5 * stiffness * duration);
        Ok(if bend.is_finite() { bend } else { 0.0 })
    }

    /// Error of the force [N] allowed at the time `t` [s]: the accuracy times the largest force, and of a contact that has
    /// shrunk so much less that its radius is as well known as the largest, for a grows as ∛F.
    ///
    /// A dashpot keeps the depth of a contact whatever its force has become.
    pub(super) fn allowed(&self, (contact, here): (&dyn ContactModel, &Normal), t: f64) -> f64 {
        let held = here.in_balance();
        let scale = held.max(self.ramp.scale).max(f64::MIN_POSITIVE);
        if self.exact(t).is_some() || is_damped(contact) {
            return self.ramp.accuracy * scale;
        }
        let part = self.target(here, t).abs().max(held) / scale;
        self.ramp.accuracy * scale * part.min(1.0).powf(2.0 / 3.0).max(self.ramp.accuracy.powi(2))
    }

    /// A first piece this short leaves no trace in what follows.
    pub(super) fn is_first_touch(&self, contact: &dyn ContactModel, rise: f64) -> bool {
        let full = self.exact(self.end).and_then(|creep| creep.indentation());
        !contact.joined() && full.is_some_and(|full| rise <= self.ramp.accuracy * full)
    }

    /// The force to be met at the time `t` [s]: without adhesion the bodies just touch where there is none.
    pub(super) fn target(&self, here: &Normal, t: f64) -> f64 {
        let (force, least) = (self.ramp.force(t), TOUCH * self.ramp.scale);
        if force.abs() < least && here.stored.surface >= 0.0 { least } else { force }
    }
}

/// How much force [N/m] a way is worth: by the stiffness, and where there is none, on a dashpot alone, as a part of the
/// force what the way is of the depth. An edge that pulls is there at no depth too: then of the way on which the force does
/// as much as the surfaces.
fn felt(state: &Normal) -> f64 {
    let force = state.force.abs();
    let pulls = if force > 0.0 { (-state.stored.surface).max(0.0) / force } else { 0.0 };
    let depth = state.indentation.filter(|&depth| depth > 0.0);
    let as_part = depth.map_or(0.0, |depth| force / depth.max(pulls));
    state.stiffness.max(as_part)
}
