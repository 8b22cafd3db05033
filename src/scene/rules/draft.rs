//! What the rules look at.

use crate::friction::{Friction, StrengthCurve};
use crate::material::{Joined, Relaxation};
use crate::scene::Scene;
use crate::scene::history::EntryTraits;
use crate::scene::reach::Bound;
use crate::shape::Profile;

/// A scene whose parts are read but not yet held against each other.
#[derive(Debug)]
pub struct Draft<'s> {
    /// The scene as written.
    pub scene: &'s Scene,
    /// Its history.
    pub entries: Vec<EntryTraits<'s>>,
    /// Its profile over a radius; `None` where the shape has none or its table cannot be read.
    pub profile: Option<&'s dyn Profile>,
    /// How deep the profile can be pressed.
    pub bounds: Vec<Bound>,
    /// Its bodies; `None` where they make no pair.
    pub bodies: Option<&'s Joined>,
    /// The table of its friction.
    pub strength: Option<&'s StrengthCurve>,
}

impl Draft<'_> {
    /// E*(t) of its bodies, if they make a pair that relaxes.
    pub(super) fn relaxation(&self) -> Option<&Relaxation> {
        self.bodies?.relaxation.as_ref()
    }

    /// The friction, unless the history is an impact, which has its own rules.
    pub(super) fn friction_of_history(&self) -> Option<&Friction> {
        self.scene.friction.as_ref().filter(|_| self.entries.iter().all(|entry| entry.impact.is_none()))
    }
}
