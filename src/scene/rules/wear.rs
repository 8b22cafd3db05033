//! Wear against the other parts: it is followed on round elastic contacts under Coulomb friction.

use super::draft::Draft;
use super::parts::not_round;
use crate::friction::Friction;
use crate::input::problem::Problem;
use crate::material::Body;
use crate::scene::history::EntryTraits;
use crate::scene::mended::Look;
use crate::shape::{Family, Shape};

fn refused(path: &str, what: impl Into<String>) -> Option<Problem> {
    Some(Problem::new(path, what))
}

pub(super) fn without_friction(draft: &Draft<'_>) -> Option<Problem> {
    let (name, false) = (draft.wear()?, draft.rubs()?) else { return None };
    refused(
        "wear",
        format!("{name} needs friction, for bodies wear where they rub: expected friction: Coulomb(coefficient: …)"),
    )
}

pub(super) fn under_friction(draft: &Draft<'_>) -> Option<Problem> {
    let (name, friction) = (draft.wear()?, draft.friction(Look::Kind)?);
    match friction {
        Friction::Coulomb(_) => None,
        Friction::StaticKinetic(_) | Friction::RateState(_) => None,
        Friction::Stuck => refused(
            "wear",
            format!(
                "{name} under Stuck cannot be computed, for nothing rubs that sticks: expected Coulomb(coefficient: …)"
            ),
        ),
        Friction::CoulombOrowan(_) | Friction::Pressure(_) => refused(
            "wear",
            format!(
                "{name} under {} friction cannot be computed, for it is a law of gross sliding that knows no stick: expected Coulomb(coefficient: …)",
                friction.name()
            ),
        ),
    }
}

pub(super) fn of_bodies(draft: &Draft<'_>) -> Option<Problem> {
    let (name, (one, two)) = (draft.wear()?, draft.bodies(Look::Kind)?);
    let beyond = |body: &&Body| !matches!(body, Body::Rigid | Body::Elastic(_));
    let body = [one, two].into_iter().find(beyond)?;
    let why = if body.relaxes() {
        "a body that relaxes remembers a profile that is no longer there"
    } else if body.hardness().is_some() {
        "a dent that yields and wears at once is not known in closed form"
    } else {
        "what is worn off changes the bed of a half-space that is alike at all depths, and of no other"
    };
    refused(
        "wear",
        format!("{name} of a {} body cannot be computed, for {why}: expected Elastic or Rigid", body.name()),
    )
}

pub(super) fn under_adhesion(draft: &Draft<'_>) -> Option<Problem> {
    let (name, adhesion) = (draft.wear()?, draft.adhesion(Look::Kind)?.traits());
    refused(
        "wear",
        format!(
            "{name} with {} adhesion cannot be computed, for at an edge that is pulled Archard's law would wear by a negative pressure: expected no adhesion",
            adhesion.name
        ),
    )
}

pub(super) fn on_shape(draft: &Draft<'_>) -> Option<Problem> {
    let (name, shape) = (draft.wear()?, draft.shape()?);
    let why = match (shape.family(), shape) {
        (_, Shape::Ellipsoid(_)) => "its contact is an ellipse, which does not stay one as it wears",
        (_, Shape::WavyParaboloid(_)) => "its waves touch in rings as the contact grows",
        (Family::Round, shape) if shape.is_plane() => "wear is followed in rings around an axis",
        (Family::Round, _) => return None,
        (Family::Line(_) | Family::Map(..), _) => "a line that stands for a surface does not know the real pressure",
        (Family::Tips(_), _) => "the wear of tips side by side is not that of rings around an axis",
        (Family::Wavy(_), _) => "a series of the half-plane knows no wear",
        (Family::Pad(_), _) => "its heights do not stay normal as the highest wear first",
    };
    let shape = not_round(shape).unwrap_or_else(|| format!("a {}", shape.name()));
    refused("wear", format!("{name} on {shape} cannot be computed, for {why}: expected a round shape"))
}

pub(super) fn on_springs(draft: &Draft<'_>) -> Option<Problem> {
    draft.springs()?;
    let name = draft.wear()?;
    refused(
        "springs",
        format!(
            "with {name} wear cannot be computed, for the cells of a worn bed follow from `accuracy`: leave springs out"
        ),
    )
}

pub(super) fn in_entry(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    let name = draft.wear()?;
    let (what, why) = match (entry.impact, entry.table) {
        (Some(_), _) => ("Impact", "how far bodies slide as they strike is not followed"),
        (None, Some(_)) if entry.slides() => ("Table with slide_m", "load and slide would change at once"),
        (None, Some(_) | None) => return None,
    };
    Some(Problem::new(
        entry.place(),
        format!("{what} with {name} wear cannot be computed, for {why}: expected Slide or Shake, or no wear"),
    ))
}
