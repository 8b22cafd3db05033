//! What the rules look at.
//!
//! The only way to it is by questions that answer nothing of a part that had to be mended, so that no rule speaks
//! of what nobody has written.

use crate::contact::adhesion::Adhesion;
use crate::drive::machine::Machine;
use crate::friction::{Friction, StrengthCurve};
use crate::material::{Body, Joined, Relaxation};
use crate::scene::history::{EntryTraits, Motion};
use crate::scene::mended::{Look, Mended};
use crate::scene::reach::Bound;
use crate::scene::solver::{HalfSpace, SolverChoice};
use crate::scene::{Plot, Scene};
use crate::shape::{Profile, Shape};
use crate::wear::Wear;
use std::collections::BTreeSet;
use std::num::NonZeroUsize;

/// A scene whose parts are read but not yet held against each other.
#[derive(Debug)]
pub struct Draft<'s> {
    written: Written<'s>,
    read: Parts<'s>,
    bounds: Vec<Bound>,
    /// Numbers of the entries in which something is mended.
    mended_entries: BTreeSet<usize>,
    /// Whether all entries are of the kind that is written.
    knows_kinds: bool,
    firsts: Firsts<'s>,
}

/// The first entries of some kinds, which rules ask every entry for.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Firsts<'s> {
    /// Of those that set a machine in motion, unless one before it is mended.
    pub(super) machine: Option<&'s EntryTraits<'s>>,
    /// Of those that move a body along from rest, unless one before it is mended.
    pub(super) advancing: Option<&'s EntryTraits<'s>>,
    /// Of those that glide, and of those that roll.
    pub(super) motions: [Option<&'s EntryTraits<'s>>; 2],
    /// Of those that roll with a creepage or traction.
    pub(super) traction: Option<&'s EntryTraits<'s>>,
    /// Of those that slide.
    pub(super) slide: Option<&'s EntryTraits<'s>>,
}

/// A scene and its history, as far as they are as written.
#[derive(Debug, Clone, Copy)]
pub(in crate::scene) struct Written<'s> {
    pub(in crate::scene) scene: &'s Scene,
    pub(in crate::scene) entries: &'s [EntryTraits<'s>],
    pub(in crate::scene) mended: &'s Mended,
}

/// Parts with their tables read; `None` where the scene has none, or one that is mended or cannot be read.
#[derive(Debug, Clone, Copy)]
pub(in crate::scene) struct Parts<'s> {
    /// The profile over a radius.
    pub(in crate::scene) profile: Option<&'s dyn Profile>,
    /// The bodies.
    pub(in crate::scene) bodies: Option<&'s Joined>,
    /// The table of the friction.
    pub(in crate::scene) strength: Option<&'s StrengthCurve>,
}

impl<'s> Written<'s> {
    /// Numbers of the entries that are mended so far that a look at them shows it.
    fn mended_entries(self, look: Look) -> impl Iterator<Item = usize> + 's {
        let entries = if self.mended.is_empty() { &[] } else { self.entries };
        entries.iter().filter(move |entry| !self.mended.knows(&entry.place(), look)).map(|entry| entry.number)
    }
}

impl<'s> Draft<'s> {
    /// What is `written` and `read`; `bounds` says how deep a profile can be pressed, with adhesion or without.
    pub(in crate::scene) fn new(
        written: Written<'s>,
        read: Parts<'s>,
        bounds: impl FnOnce(&dyn Profile, bool) -> Vec<Bound>,
    ) -> Self {
        let mended_entries = written.mended_entries(Look::Whole).collect();
        let knows_kinds = written.mended_entries(Look::Kind).next().is_none();
        let firsts = Firsts::default();
        let mut draft = Self { written, read, bounds: Vec::new(), mended_entries, knows_kinds, firsts };
        draft.firsts = draft.found();
        if let (Some(profile), Some(adheres)) = (read.profile, draft.adheres()) {
            draft.bounds = bounds(profile, adheres);
        }
        draft
    }

    fn knows(&self, path: &str, look: Look) -> bool {
        self.written.mended.knows(path, look)
    }

    /// What `part` finds in the scene, if a look at `path` finds what is written.
    fn seen<T>(&self, path: &str, look: Look, part: impl FnOnce(&'s Scene) -> T) -> Option<T> {
        self.knows(path, look).then(|| part(self.written.scene))
    }

    /// The shape; for what is in it see its profile.
    pub(super) fn shape(&self) -> Option<&'s Shape> {
        self.seen("shape", Look::Kind, |scene| &scene.shape)
    }

    /// The shape with all that is in it.
    pub(super) fn whole_shape(&self) -> Option<&'s Shape> {
        self.seen("shape", Look::Whole, |scene| &scene.shape)
    }

    /// The profile over a radius; `None` where the shape has none or its table cannot be read.
    pub(super) fn profile(&self) -> Option<&'s dyn Profile> {
        self.read.profile
    }

    /// How deep the profile can be pressed.
    pub(super) fn bounds(&self) -> &[Bound] {
        &self.bounds
    }

    /// Both bodies.
    pub(super) fn bodies(&self, look: Look) -> Option<(&'s Body, &'s Body)> {
        Some((self.body(0, look)?, self.body(1, look)?))
    }

    /// The first body or the second.
    pub(super) fn body(&self, number: usize, look: Look) -> Option<&'s Body> {
        let (path, body) = match number {
            0 => ("bodies.0", &self.written.scene.bodies.0),
            _ => ("bodies.1", &self.written.scene.bodies.1),
        };
        self.seen(path, look, |_| body)
    }

    /// The bodies together; `None` where they make no pair.
    pub(super) fn joined(&self) -> Option<&'s Joined> {
        self.read.bodies
    }

    /// Whether one of the bodies is viscoelastic; `None` for two rigid ones.
    pub(super) fn pair_relaxes(&self) -> Option<bool> {
        match self.bodies(Look::Kind)? {
            (Body::Rigid, Body::Rigid) => None,
            (one, two) => Some(one.relaxes() || two.relaxes()),
        }
    }

    /// E*(t) of the bodies, if they make a pair that relaxes.
    pub(super) fn relaxation(&self) -> Option<&'s Relaxation> {
        self.joined()?.relaxation.as_ref()
    }

    /// Whether the bodies flow without an end; `None` of bodies that relax in a way not known.
    pub(super) fn flows(&self) -> Option<bool> {
        if !self.pair_relaxes()? {
            return Some(false);
        }
        self.relaxation().map(|relaxation| relaxation.equilibrium <= 0.0)
    }

    /// Whether there is adhesion.
    pub(super) fn adheres(&self) -> Option<bool> {
        self.seen("adhesion", Look::Kind, |scene| scene.adhesion.is_some())
    }

    /// The adhesion, if there is one.
    pub(super) fn adhesion(&self, look: Look) -> Option<&'s Adhesion> {
        self.seen("adhesion", look, |scene| scene.adhesion.as_ref())?
    }

    /// Whether there is friction.
    pub(super) fn rubs(&self) -> Option<bool> {
        self.seen("friction", Look::Kind, |scene| scene.friction.is_some())
    }

    /// The friction, if there is one.
    pub(super) fn friction(&self, look: Look) -> Option<&'s Friction> {
        self.seen("friction", look, |scene| scene.friction.as_ref())?
    }

    /// The name of the law of wear, if there is one.
    pub(in crate::scene) fn wear(&self) -> Option<&'static str> {
        self.seen("wear", Look::Kind, |scene| scene.wear.as_ref().map(Wear::name))?
    }

    /// Whether there is wear.
    pub(super) fn wears(&self) -> Option<bool> {
        self.seen("wear", Look::Kind, |scene| scene.wear.is_some())
    }

    /// Whether there is a machine.
    pub(super) fn has_machine(&self) -> Option<bool> {
        self.seen("machine", Look::Kind, |scene| scene.machine.is_some())
    }

    /// The machine with all that is in it, if there is one.
    pub(super) fn machine(&self) -> Option<&'s Machine> {
        self.seen("machine", Look::Whole, |scene| scene.machine.as_ref())?
    }

    /// Whether a machine moves the contact.
    pub(super) fn is_driven(&self) -> Option<bool> {
        self.knows_history_by_kind().then(|| self.written.entries.iter().any(|entry| entry.machine.is_some()))
    }

    /// Whether a machine moves the contact along the surface.
    pub(super) fn drives(&self) -> Option<bool> {
        let along = |entry: &EntryTraits<'_>| entry.machine.is_some_and(|machine| machine.motion.is_along());
        self.knows_history_by_kind().then(|| self.written.entries.iter().any(along))
    }

    /// The friction by its kind, unless the history is an impact, which has its own rules.
    pub(super) fn friction_of_history(&self) -> Option<&'s Friction> {
        let known = self.knows_history_by_kind();
        self.friction(Look::Kind).filter(|_| known && self.written.entries.iter().all(|entry| entry.impact.is_none()))
    }

    /// Whether the entries are as many, and each of the kind, as is written.
    fn knows_history_by_kind(&self) -> bool {
        self.knows("history", Look::Kind) && self.knows_kinds
    }

    /// The table of the friction.
    pub(super) fn strength(&self) -> Option<&'s StrengthCurve> {
        self.read.strength
    }

    /// The number of springs, if there is one.
    pub(in crate::scene) fn springs(&self) -> Option<NonZeroUsize> {
        self.seen("springs", Look::Whole, |scene| scene.springs)?
    }

    /// Whether the scene asks for a solver.
    pub(super) fn chooses_solver(&self) -> Option<bool> {
        self.seen("solver", Look::Kind, |scene| scene.solver.is_some())
    }

    /// The half-space solver, if the scene asks for it.
    pub(super) fn half_space(&self, look: Look) -> Option<&'s HalfSpace> {
        let SolverChoice::HalfSpace(asked) = self.seen("solver", look, |scene| scene.solver.as_ref())??;
        Some(asked)
    }

    /// Whether the scene asks for the half-space solver.
    pub(super) fn on_pixels(&self) -> Option<bool> {
        self.seen("solver", Look::Kind, |scene| matches!(scene.solver, Some(SolverChoice::HalfSpace(_))))
    }

    /// Whether the scene says how many records an entry has.
    pub(in crate::scene) fn counts_records(&self) -> Option<bool> {
        self.seen("steps", Look::Whole, |scene| scene.steps.is_some())
    }

    /// Number of entries of the history.
    pub(in crate::scene) fn length(&self) -> Option<usize> {
        self.seen("history", Look::Kind, |scene| scene.history.len())
    }

    /// The entries of the history in order; `None` where one is mended.
    pub(in crate::scene) fn entries(&self) -> impl Iterator<Item = Option<&'s EntryTraits<'s>>> {
        self.written.entries.iter().map(|entry| self.as_written(entry))
    }

    /// The first entries of the kinds that rules ask for.
    pub(super) fn firsts(&self) -> Firsts<'s> {
        self.firsts
    }

    fn found(&self) -> Firsts<'s> {
        let unless_mended =
            |is: fn(&EntryTraits<'_>) -> bool| self.entries().find(|entry| entry.is_none_or(is)).flatten();
        let moving = |motion| self.entries().flatten().find(|entry| entry.glide.is_some_and(|(_, its)| its == motion));
        Firsts {
            machine: unless_mended(|entry| entry.machine.is_some()),
            advancing: unless_mended(|entry| entry.glide.is_some_and(|(glide, _)| !glide.is_steady())),
            motions: [Motion::Glides, Motion::Rolls].map(moving),
            traction: self.entries().flatten().find(|entry| entry.traction().is_some()),
            slide: self.entries().flatten().find(|entry| entry.slides()),
        }
    }

    /// The entry before another.
    pub(super) fn entry_before(&self, entry: &EntryTraits<'_>) -> Option<&'s EntryTraits<'s>> {
        self.as_written(self.written.entries.get(entry.number.checked_sub(1)?)?)
    }

    /// The entry, unless something in it is mended.
    fn as_written(&self, entry: &'s EntryTraits<'s>) -> Option<&'s EntryTraits<'s>> {
        (!self.mended_entries.contains(&entry.number)).then_some(entry)
    }

    /// Number of speeds at which the bodies strike; zero if they do not.
    pub(super) fn speeds(&self) -> Option<usize> {
        if !self.knows_history_by_kind() {
            return None;
        }
        let Some(entry) = self.written.entries.iter().find(|entry| entry.impact.is_some()) else { return Some(0) };
        self.as_written(entry)?.impact.map(|impact| impact.speed.len())
    }

    /// Whether a body glides or rolls.
    pub(super) fn glides(&self) -> Option<bool> {
        self.knows_history_by_kind().then(|| self.written.entries.iter().any(|entry| entry.glide.is_some()))
    }

    /// Whether a body is followed as it glides or rolls.
    pub(super) fn moves_along(&self) -> Option<bool> {
        self.knows_history_by_kind().then_some(())?;
        let mut glides = self.written.entries.iter().filter(|entry| entry.glide.is_some());
        let follows = |entry: &EntryTraits<'_>| entry.glide.is_some_and(|(glide, _)| !glide.is_steady());
        // How long it lasts tells, which is not known where the entry is mended.
        let found = glides.find(|entry| self.as_written(entry).is_none_or(follows));
        found.map_or(Some(false), |entry| self.as_written(entry).map(|_| true))
    }

    /// Whether a body rolls with a creepage or a tangential force prescribed.
    pub(super) fn has_traction(&self) -> Option<bool> {
        self.knows_history_by_kind().then_some(())?;
        let has = |entry: &EntryTraits<'_>| entry.traction().is_some();
        let found = self.entries().find(|entry| entry.is_none_or(has));
        found.map_or(Some(false), |entry| entry.map(|_| true))
    }

    /// The figures wanted, with their numbers.
    pub(super) fn plots(&self) -> impl Iterator<Item = (usize, Plot)> {
        let numbered = self.written.scene.plots.iter().flatten().copied().enumerate();
        numbered.filter(|(number, _)| self.knows(&format!("plots[{number}]"), Look::Whole))
    }
}
