//! Bodies that roll with traction against the other parts.

use super::draft::Draft;
use crate::friction::Friction;
use crate::input::problem::Problem;
use crate::material::Body;
use crate::scene::history::{EntryTraits, Motion};
use crate::scene::mended::Look;
use crate::scene::tractive::RollingBody;

fn refused(entry: &EntryTraits<'_>, why: &str) -> Option<Problem> {
    let (glide, _) = entry.traction()?;
    let what = if glide.creepage.is_some() { "creepage" } else { "traction" };
    Some(Problem::new(entry.place(), format!("{} with {what} {why}", entry.name)))
}

/// What is prescribed of it.
pub(super) fn prescribed(_: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    let (glide, motion) = entry.traction()?;
    let none = glide.creepage.as_ref().is_some_and(Vec::is_empty) || glide.traction.as_ref().is_some_and(Vec::is_empty);
    match motion {
        Motion::Glides => {
            refused(entry, "cannot be computed, for what glides slips as a whole and does not creep: expected Roll")
        }
        Motion::Rolls if glide.creepage.is_some() && glide.traction.is_some() => {
            refused(entry, "and traction says both, of which one follows from the other: expected one of the two")
        }
        Motion::Rolls if none => refused(entry, "is an empty list: expected at least one value"),
        Motion::Rolls if glide.over.is_some() => refused(
            entry,
            "cannot be computed with `over`, for how it comes to that is not followed: expected no `over`, for the steady state",
        ),
        Motion::Rolls if glide.speed.len() > 1 => {
            refused(entry, "has many speeds, and nothing but its power depends on the speed: expected one speed")
        }
        Motion::Rolls => None,
    }
}

pub(super) fn on_shape(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    entry.traction()?;
    let shape = draft.shape()?;
    if RollingBody::of(shape).is_some() {
        return None;
    }
    refused(
        entry,
        &format!(
            "of a {} cannot be computed, for the creep of a cylinder and of a ball alone is known: expected Paraboloid(…), Spheres(…) or Cylinder(…)",
            shape.name()
        ),
    )
}

pub(super) fn of_bodies(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    entry.traction()?;
    let (one, two) = draft.bodies(Look::Kind)?;
    let unknown = |body: &&Body| !matches!(body, Body::Rigid | Body::Elastic(_));
    let body = [one, two].into_iter().find(unknown)?;
    refused(
        entry,
        &format!(
            "and a {} body cannot be computed, for the creep of elastic half-spaces alone is known: expected Elastic or Rigid",
            body.name()
        ),
    )
}

pub(super) fn friction(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    entry.traction()?;
    if !draft.rubs()? {
        return refused(entry, "needs friction: expected a friction such as Coulomb(coefficient: 0.3)");
    }
    let friction = draft.friction(Look::Kind)?;
    if matches!(friction, Friction::Coulomb(_)) {
        return None;
    }
    let name = friction.name();
    refused(
        entry,
        &format!(
            "and {name} friction cannot be computed, for its slip zone is known under Coulomb's law alone: expected Coulomb(coefficient: …)"
        ),
    )
}

pub(super) fn with_wear(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    entry.traction()?;
    let wear = draft.wear()?;
    refused(
        entry,
        &format!(
            "and {wear} wear cannot be computed, for wear is followed in rings of a contact that does not roll: expected no wear"
        ),
    )
}

pub(super) fn on_pixels(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    entry.traction()?;
    draft.on_pixels()?.then_some(())?;
    refused(
        entry,
        "and the solver HalfSpace cannot be computed, for what creeps through a rolling contact is followed on lines of springs: expected no solver",
    )
}

/// Steady rolling forgets what was slid before, and the path of a slide is not that of the rolling.
pub(super) fn slide_beside(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    entry.slides().then_some(())?;
    draft.firsts().traction?;
    let what = format!(
        "{} beside a Roll with a creepage or traction cannot be computed, for what rolls steadily has forgotten what was slid before: expected Indent, Press, Hold or HoldForce",
        entry.name
    );
    Some(Problem::new(entry.place(), what))
}
