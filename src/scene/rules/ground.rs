//! Bodies that are not alike at all depths against the other parts.

use super::draft::Draft;
use crate::contact::adhesion::Range;
use crate::friction::Slip;
use crate::input::problem::Problem;
use crate::material::Body;
use crate::scene::mended::Look;
use crate::shape::{Family, Shape};

/// Place and name of the body that is not alike at all depths.
fn uneven(draft: &Draft<'_>) -> Option<(&'static str, &'static str)> {
    let (one, two) = draft.bodies(Look::Kind)?;
    let named = [("bodies.0", one), ("bodies.1", two)];
    named.into_iter().find(|(_, body)| body.is_uneven()).map(|(place, body)| (place, body.name()))
}

/// What one body is known to be pressed against.
pub(super) fn beside(draft: &Draft<'_>) -> Option<Problem> {
    let (one, two) = draft.bodies(Look::Kind)?;
    let (place, name) = uneven(draft)?;
    let other = if place == "bodies.0" { two } else { one };
    let why = match (if place == "bodies.0" { one } else { two }, other) {
        (_, Body::Rigid) => return None,
        (Body::Layered(_), _) if one.relaxes() || two.relaxes() => {
            "layers that relax are known by one function of time, and so is the pair"
        }
        (Body::Layered(_), Body::Elastic(_) | Body::Viscoelastic(_) | Body::Layered(_)) => return None,
        (_, Body::Plastic(_)) => "how it yields is known on a half-space",
        (_, _) => "the sum of both is neither a sheet of springs nor a power of the depth",
    };
    let what = format!("{name} against {} cannot be computed, for {why}: expected Rigid beside it", other.name());
    Some(Problem::new("bodies", what))
}

/// Shapes on which the bed over such a body is known.
pub(super) fn under_shape(draft: &Draft<'_>) -> Option<Problem> {
    let ((place, name), shape) = (uneven(draft)?, draft.shape()?);
    if draft.chooses_solver()? && !shape.is_plane() {
        return None;
    }
    let why = match (shape.family(), shape) {
        (_, Shape::Ellipsoid(_)) => "its contact is an ellipse",
        (Family::Round, shape) if shape.is_plane() => "of layers the bed under a round contact is known",
        (Family::Round, _) => return None,
        // It has a rule of its own.
        (Family::Pad(_), _) => return None,
        (Family::Line(_) | Family::Map(..) | Family::Tips(_) | Family::Wavy(_), _) => {
            "of layers the bed under a single round contact is known"
        }
    };
    let or = if shape.is_plane() { "" } else { ", or solver: HalfSpace(…)" };
    let what = format!(
        "{name} under the shape {} cannot be computed, for {why}: expected a round shape, or Elastic{or}",
        shape.name()
    );
    Some(Problem::new(place, what))
}

/// The stiffness along the surface is another one than across it, and not told; what slides as a whole asks for pressures
/// alone, which pixels tell.
pub(super) fn friction(draft: &Draft<'_>) -> Option<Problem> {
    let ((_, name), friction) = (uneven(draft)?, draft.friction(Look::Kind)?);
    if friction.slip() == Slip::Gross && draft.on_pixels()? {
        return None;
    }
    let what = format!(
        "{} on a {name} body cannot be computed, for its stiffness along the surface is not in one ratio to that across it: expected no friction, or Elastic",
        friction.name()
    );
    Some(Problem::new("friction", what))
}

/// An attraction that reaches beyond the contact meets the surface there; springs without neighbours have no edge.
pub(super) fn adhesion(draft: &Draft<'_>) -> Option<Problem> {
    let ((_, name), adhesion) = (uneven(draft)?, draft.adhesion(Look::Kind)?.traits());
    let on_pixels = draft.chooses_solver()?;
    let why = match adhesion.range {
        Range::Vanishing(_) if matches!(draft.shape()?.family(), Family::Pad(_)) => return None,
        Range::Vanishing(_) if name == "Winkler" => {
            "its springs have no neighbours by which an edge could open: expected no adhesion, Layered(…), or the shape Pad(…), whose springs let go one by one"
        }
        Range::Vanishing(_) if on_pixels && name == "Graded" => {
            "at its surface it has no modulus that the ring of pixels could be made of in which an attraction without a range acts: expected Maugis(work: …, stress: …), or no solver"
        }
        Range::Vanishing(_) => return None,
        Range::Finite(_) | Range::Fading(_) if on_pixels => return None,
        Range::Outside | Range::Finite(_) | Range::Fading(_) => {
            "its attraction acts on a surface that is bent otherwise than a half-space: expected Jkr(work: …), or solver: HalfSpace(…)"
        }
    };
    Some(Problem::new("adhesion", format!("{} on a {name} body cannot be computed, for {why}", adhesion.name)))
}
