//! A machine without a mass, a spring by whose far end a contact is led.

use super::draft::Draft;
use super::machine::{refused, refused_entry};
use crate::input::problem::Problem;
use crate::material::Body;
use crate::scene::history::EntryTraits;
use crate::scene::mended::Look;

/// A machine without a mass is a spring.
pub(super) fn without_mass(draft: &Draft<'_>) -> Option<Problem> {
    let machine = draft.machine().filter(|machine| machine.mass.is_none())?;
    if machine.damping.is_some() {
        return refused(
            "machine.damping",
            "a damper acts where a mass moves, and there is none: expected a mass, or no damping",
        );
    }
    (machine.stiffness() <= 0.0).then(|| {
        Problem::new(
            "machine",
            "has neither a mass to be moved nor a spring to lead the contact by: expected mass: …, or stiffness: … above zero",
        )
    })
}

/// The spring of a machine without a mass, if there is one.
fn is_spring(draft: &Draft<'_>) -> Option<()> {
    draft.machine().filter(|machine| machine.mass.is_none() && machine.stiffness() > 0.0).map(|_| ())
}

/// How bodies that remember or yield move behind a spring depends on how fast it is led.
pub(super) fn on_bodies(draft: &Draft<'_>) -> Option<Problem> {
    is_spring(draft)?;
    let (one, two) = draft.bodies(Look::Kind)?;
    let named = |of: fn(&Body) -> bool| [one, two].into_iter().find(|body| of(body)).map(Body::name);
    let (name, why) = match (named(Body::relaxes), named(|body| matches!(body, Body::Plastic(_)))) {
        (Some(name), _) => {
            (name, "its depth follows from what the spring has carried at all times, not from where its far end is")
        }
        (None, Some(name)) => (name, "the dent it is left with is told of a prescribed depth or force"),
        (None, None) => return None,
    };
    refused(
        "machine",
        format!(
            "without a mass on a {name} body cannot be computed, for {why}: expected Elastic bodies, or no machine"
        ),
    )
}

/// A spring behind what else leads or holds a contact.
pub(super) fn with_parts(draft: &Draft<'_>) -> Option<Problem> {
    is_spring(draft)?;
    let why = if draft.friction(Look::Kind).is_some() {
        "friction goes along the surface, where nothing is said of its spring: expected no friction"
    } else if draft.adhesion(Look::Whole).is_some_and(|adhesion| adhesion.traits().closing.is_some()) {
        "an edge that stands still between two works has its own past: expected no closing"
    } else {
        return None;
    };
    refused("machine", format!("without a mass cannot be computed here, for {why}, or no machine"))
}

/// What moves by itself is not led by a spring.
pub(super) fn in_history(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    is_spring(draft)?;
    (entry.impact.is_some() || entry.glide.is_some()).then_some(())?;
    refused_entry(
        entry,
        format!(
            "{} is a motion of its own, which no spring leads: expected Indent, Press, Retract or a Table, or no machine",
            entry.name
        ),
    )
}
