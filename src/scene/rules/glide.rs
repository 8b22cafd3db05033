//! Bodies that glide or roll against the other parts.

use super::draft::Draft;
use crate::input::problem::Problem;
use crate::material::Body;
use crate::scene::history::{EntryTraits, Glide, Motion};
use crate::scene::mended::Look;
use crate::scene::stage::Path;
use crate::shape::{Family, Rim, Shape};

fn refused(entry: &EntryTraits<'_>, what: String) -> Option<Problem> {
    Some(Problem::new(entry.place(), what))
}

/// The motion of a body that feels nothing but the bed; one with a traction has rules of its own.
fn freely(entry: &EntryTraits<'_>) -> Option<Motion> {
    entry.glide.filter(|(glide, _)| !glide.has_traction()).map(|(_, motion)| motion)
}

/// A shape with a bed on which each place stands for itself, and no wall that a gliding body would push before it.
pub(super) fn on_shape(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    let motion = freely(entry)?;
    let shape = draft.shape()?;
    if draft.on_pixels()? && motion == Motion::Glides {
        return walled(draft, entry);
    }
    let why = match (shape.family(), shape, motion) {
        (Family::Tips(_), _, _) => "their places side by side are none of a bed",
        (Family::Wavy(_), _, _) => "a series of the half-plane has no springs to be gone through",
        (Family::Pad(_), _, _) => "its springs are pressed from straight above",
        (Family::Line(_) | Family::Map(..), _, Motion::Rolls) => {
            "what rolls lays each of its heights on one place of the ground, which a line that is drawn over it does not: expected Glide"
        }
        (Family::Line(_) | Family::Map(..), _, Motion::Glides) => return of_rough(draft, entry),
        (Family::Round, Shape::Ellipsoid(_), _) => {
            "the way in which it moves is not told: expected Paraboloid(radius: …)"
        }
        (Family::Round, shape, _) if shape.is_plane() => {
            "the springs under a lying body stand for strips, not for places one after the other"
        }
        (Family::Round, Shape::Paraboloid(_) | Shape::Sphere(_) | Shape::Spheres(_), _) => return None,
        (Family::Round, _, Motion::Rolls) => {
            "only a ball shows the ground the same shape as it turns: expected Paraboloid(radius: …), or Glide"
        }
        (Family::Round, _, Motion::Glides) => match draft.profile()?.rim() {
            Rim::Wall(_) => "its wall would push the ground before it, which a bed of small slopes does not know",
            Rim::None | Rim::End(_) => return None,
        },
    };
    refused(entry, format!("{} of a {} cannot be computed: {why}", entry.name, shape.name()))
}

/// A wall, as pixels know none.
fn walled(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    let shape = draft.shape()?;
    matches!(draft.profile()?.rim(), Rim::Wall(_)).then(|| {
        let what = format!(
            "{} of a {} cannot be computed: its wall would push the ground before it, which a surface of small slopes does not know",
            entry.name,
            shape.name()
        );
        Problem::new(entry.place(), what)
    })
}

/// A rough line has a steady state where the ground comes back.
fn of_rough(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    let shape = draft.shape()?;
    let liquid = draft.flows()?;
    let why = match draft.profile().map(|profile| profile.rim()) {
        _ if liquid => {
            "a ground that flows is ironed flat and has no steady state: expected an equilibrium modulus above zero"
        }
        Some(Rim::Wall(_)) => {
            "the wall of its base would push the ground before it, which a bed of small slopes does not know"
        }
        Some(Rim::None | Rim::End(_)) | None => return None,
    };
    refused(entry, format!("{} of a {} cannot be computed: {why}", entry.name, shape.name()))
}

/// A dashpot under a slope that begins like a root takes an endless power.
pub(super) fn steep_on_dashpot(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    entry.glide?;
    let (shape, relaxation) = (draft.shape()?, draft.relaxation()?);
    let root = |shape: &Shape| matches!(shape, Shape::Power(power) if power.exponent.si() <= 0.5);
    let steep = matches!(shape, Shape::TruncatedCone(_) | Shape::TruncatedParaboloid(_)) || root(shape);
    if !steep || relaxation.viscosity <= 0.0 {
        return None;
    }
    refused(
        entry,
        format!(
            "{} of a {} on a body with a viscosity cannot be computed, for beside its edge the ground would have to give infinitely fast: expected viscosity: 0",
            entry.name,
            shape.name()
        ),
    )
}

/// Two half-spaces, of which the one that remembers is gone over.
pub(super) fn of_bodies(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    let motion = freely(entry)?;
    let ((one, two), on_pixels) = (draft.bodies(Look::Kind)?, draft.on_pixels()?);
    let why = match (one, two, motion) {
        (Body::Plastic(_), _, _) | (_, Body::Plastic(_), _) => {
            "a body that yields is left with a groove: expected Elastic or Viscoelastic"
        }
        (one, two, Motion::Glides) if on_pixels && two.is_uneven() && !one.is_uneven() => return None,
        (one, two, _) if one.is_uneven() || two.is_uneven() => {
            "the springs over such a body stand for radii, not for places one after the other: expected Elastic or Viscoelastic"
        }
        (Body::Viscoelastic(_), _, Motion::Glides) => {
            "the first body carries the shape, and the same points of it stay in contact: they relax once and lose nothing more; expected the Viscoelastic body second, or Roll"
        }
        (_, _, Motion::Glides | Motion::Rolls) => return None,
    };
    let name =
        if one.is_uneven() || matches!(one, Body::Plastic(_) | Body::Viscoelastic(_)) { one } else { two }.name();
    refused(entry, format!("{} with {name} cannot be computed: {why}", entry.name))
}

pub(super) fn with_adhesion(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    entry.glide?;
    let adhesion = draft.adhesion(Look::Kind)?.traits();
    refused(
        entry,
        format!(
            "{} with {} adhesion cannot be computed, for a contact that closes in front and opens behind is not round, and the strength of its edges is known of round ones only: expected no adhesion",
            entry.name, adhesion.name
        ),
    )
}

pub(super) fn with_friction(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    let right = match freely(entry)? {
        Motion::Glides => "no friction",
        Motion::Rolls => "no friction, or a creepage or traction of Elastic bodies in Roll",
    };
    let friction = draft.friction(Look::Kind)?;
    refused(
        entry,
        format!(
            "{} with {} friction cannot be computed together: the resistance of a bed that remembers adds to that of the surfaces; expected {right}",
            entry.name,
            friction.name()
        ),
    )
}

pub(super) fn on_springs(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    entry.glide?;
    draft.springs()?;
    refused(
        entry,
        format!(
            "{} with springs cannot be computed, for its springs follow from the accuracy: leave springs out",
            entry.name
        ),
    )
}

/// What a motion along the surface can stand behind, and what cannot stand beside it.
pub(super) fn in_history(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    let (glide, _) = entry.glide?;
    let last = draft.length()?.checked_sub(1)?;
    if entry.number == 0 {
        return refused(
            entry,
            format!("the bodies only touch at the start: expected an Indent or Press before {}", entry.name),
        );
    }
    match glide {
        Glide { speed, over: Some(_), .. } if speed.len() > 1 => refused(
            entry,
            format!(
                "{} has {} speeds, each of which has a steady state that takes no time: expected no `over`, or one speed",
                entry.name,
                speed.len()
            ),
        ),
        Glide { over: None, .. } if entry.number != last => refused(
            entry,
            format!(
                "{} without a duration is the steady state, behind which nothing can follow: expected `over`, or the entry at the end",
                entry.name
            ),
        ),
        Glide { .. } => None,
    }
}

/// Motions that are not straight, or of another bed, beside one along the surface.
pub(super) fn beside(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    let glide = draft.firsts().advancing?;
    let waves =
        entry.stages.iter().any(|stage| stage.normal.is_wave() || matches!(stage.normal, Path::UntilParted { .. }));
    if !waves {
        return None;
    }
    refused(
        entry,
        format!(
            "{} beside {} cannot be computed, for the bed of a body that moves along is led in straight pieces: expected Indent, Press, Hold or HoldForce",
            entry.name, glide.name
        ),
    )
}

/// Glides and rolls of one body in one history.
pub(super) fn both(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    let (_, motion) = entry.glide?;
    let [glide, roll] = draft.firsts().motions;
    let other = match motion {
        Motion::Glides => roll,
        Motion::Rolls => glide,
    }?;
    (entry.number > other.number).then(|| {
        let what = format!("{} beside {} cannot be computed: expected one of the two", entry.name, other.name);
        Problem::new(entry.place(), what)
    })
}
