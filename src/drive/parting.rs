//! The end of a pull: the bodies let go, or are led until they part.

use super::force::{ahead, depth_of};
use super::instants::last_of;
use super::{Driver, Occurrence};
use crate::contact::error::{BedError, ContactError};
use crate::contact::model::{ContactModel, Straight};
use crate::contact::state::Normal;
use crate::material::Spectrum;

/// Parts of the slowest time after which nothing of a start is left, e^−64.
const FADED: f64 = 64.0;

/// The time [s] after which a liquid that is stretched steadily has the same load for ever; `None` of a solid, whose load
/// grows.
fn steady_after(spectrum: &Spectrum) -> Option<f64> {
    let slowest = spectrum.terms().iter().map(|term| term.time).fold(0.0, f64::max);
    (spectrum.equilibrium() <= 0.0).then_some(FADED * slowest)
}

impl Driver {
    /// The bodies part under a pull, and the indenter is taken away: the pull acts until they do, and until it has done
    /// what springs that give at once do not give of the work of adhesion. The rest of its work is lost.
    pub(super) fn let_go(&mut self, contact: &mut dyn ContactModel, time: f64) -> Occurrence {
        let (before, had) = (self.state(contact), contact.state().accounted());
        let last = contact.leave();
        let way = last.zip(before.indentation).map_or(0.0, |(last, depth)| last - depth);
        let spare = before.force * way - (contact.state().accounted() - had);
        let owed = before.dissipated - self.state(contact).dissipated;
        self.lost += spare.max(owed).max(0.0);
        let after = Normal { indentation: None, ..self.state(contact) };
        Occurrence { time, before, after, tangential: contact.tangential() }
    }

    /// Depth [m] at which a retraction from here at the speed `speed` [m/s] parts the bodies.
    ///
    /// # Errors
    /// The contact cannot follow, or the bodies never part: a liquid that is stretched steadily bears v ΣEᵢτᵢ, which may be
    /// less than its edge holds.
    pub fn last_depth(&self, contact: &mut dyn ContactModel, speed: f64) -> Result<f64, ContactError> {
        if let Some(depth) = contact.last_depth() {
            return depth;
        }
        let start = depth_of(contact);
        let held = |contact: &mut dyn ContactModel, time: f64| {
            Ok::<_, ContactError>(contact.look(&ahead(contact, -speed, time))?.contact_radius > 0.0)
        };
        let mut high = start.abs().max(1e-300) / speed;
        let steady = contact.memory().as_deref().and_then(steady_after);
        while held(contact, high)? {
            if steady.is_some_and(|steady| high > steady && high * speed > start.abs()) {
                return Err(BedError::NeverParts { speed }.into());
            }
            high *= 2.0;
        }
        let known = contact.parting(&ahead(contact, -speed, high))?;
        let (last, _) = last_of(|time| held(contact, time), (0.0, high), known)?;
        Ok(start - speed * last)
    }

    /// Parts the bodies at the last depth of a retraction at the speed `speed` [m/s]; the state after.
    ///
    /// # Errors
    /// The contact cannot follow.
    pub fn part(&mut self, contact: &mut dyn ContactModel, speed: f64) -> Result<Normal, ContactError> {
        let depth = contact.position().unwrap_or(0.0);
        if contact.memory().is_none() {
            let jumps = contact.follow(&Straight::between(depth, depth.next_down(), 0.0))?;
            let after = jumps.last().map_or_else(|| contact.state(), |jump| jump.after);
            return Ok(Normal { indentation: Some(depth), ..after });
        }
        // On at the same speed for as short a time as it takes.
        let mut duration = f64::EPSILON * self.stage.now;
        while contact.look(&ahead(contact, -speed, duration))?.contact_radius > 0.0 && duration < self.stage.now {
            duration *= 2.0;
        }
        contact.follow(&ahead(contact, -speed, duration))?;
        Ok(Normal { indentation: Some(depth), ..self.state(contact) })
    }
}
