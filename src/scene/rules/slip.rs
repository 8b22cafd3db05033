//! Frictions that a contact alone does not follow, and their numbers.

use super::draft::Draft;
use super::machine::{refused, refused_entry};
use crate::friction::Friction;
use crate::input::problem::Problem;
use crate::scene::history::EntryTraits;
use crate::scene::mended::Look;

/// A friction under which a contact slips by itself.
pub(super) fn falling_friction(draft: &Draft<'_>) -> Option<Problem> {
    let why = match draft.friction(Look::Kind)? {
        Friction::StaticKinetic(_) => {
            "StaticKinetic falls as the contact begins to slide, and how fast it then slips only a mass knows"
        }
        Friction::RateState(_) => "RateState depends on the speed of slip, which only a mass and a spring decide",
        Friction::Coulomb(_) | Friction::Stuck | Friction::CoulombOrowan(_) | Friction::Pressure(_) => return None,
    };
    if draft.drives()? {
        return None;
    }
    refused(
        "friction",
        format!("{why}: expected a machine and Drive(speed: …, over: …) in the history, or Coulomb(coefficient: …)"),
    )
}

/// Without a direct effect nothing says how fast a contact slips that loses its state.
pub(super) fn without_direct_effect(draft: &Draft<'_>) -> Option<Problem> {
    let Friction::RateState(law) = draft.friction(Look::Whole)? else { return None };
    (law.direct.si() <= 0.0 && law.evolution.si() > 0.0).then(|| {
        Problem::new(
            "friction.direct",
            "a friction that changes with the state but not with the speed does not say how fast the contact slips: expected a direct effect above zero such as 0.01, or evolution: 0 as well for Coulomb's law",
        )
    })
}

/// Effects above the friction itself would make it vanish within a change of the speed by a factor of e.
pub(super) fn large_effects(draft: &Draft<'_>) -> Option<Problem> {
    let Friction::RateState(law) = draft.friction(Look::Whole)? else { return None };
    let most = law.coefficient.si();
    let named = [("friction.direct", law.direct), ("friction.evolution", law.evolution)];
    let (path, effect) = named.into_iter().find(|(_, effect)| effect.si() > most)?;
    Some(Problem::new(
        path,
        format!(
            "{:?} is more than the coefficient {most:?} itself, which would be lost within a factor of e of the speed: expected a small part of it, such as 0.01",
            effect.si()
        ),
    ))
}

/// A contact cannot slide more heavily than it is held.
pub(super) fn kinetic_above_static(draft: &Draft<'_>) -> Option<Problem> {
    let Friction::StaticKinetic(law) = draft.friction(Look::Whole)? else { return None };
    let (held, slides) = (law.r#static.si(), law.kinetic.si());
    (slides > held).then(|| {
        Problem::new(
            "friction.kinetic",
            format!("a contact that slides is held by {slides:?}, more than the {held:?} it takes to set it sliding: expected at most {held:?}"),
        )
    })
}

/// The path of the slide that breaks away is known to the machine alone.
pub(super) fn slide_before(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    let friction = draft.friction(Look::Kind)?;
    let why = match friction {
        Friction::StaticKinetic(_) => "how fast it slips once it has given way only a mass knows",
        Friction::RateState(_) => "it has a contact slip at any load, at a speed that its machine decides",
        Friction::Coulomb(_) | Friction::Stuck | Friction::CoulombOrowan(_) | Friction::Pressure(_) => return None,
    };
    entry.slides().then_some(())?;
    refused_entry(
        entry,
        format!(
            "{} under {} friction cannot be computed, for {why}: expected Drive(speed: …, over: …)",
            entry.name,
            friction.name()
        ),
    )
}
