//! The bed and the surfaces as pictures, against the parts they show: an instant of a round contact of half-spaces.

use super::draft::Draft;
use super::plastic::yields;
use crate::contact::adhesion::Range;
use crate::material::{Body, Shares};
use crate::scene::Plot;
use crate::scene::mended::Look;
use crate::shape::Shape;

/// Why the surface of a section is not drawn.
pub(super) const SURFACE_OF_SECTION: &str = "the surface beside a section sinks without bound, by the logarithm of the distance: expected Force, Radius, Pressure or Energy";

/// What the scene lacks for the picture of its bed or of its surfaces, on a shape that is no section.
pub(super) fn lacks(draft: &Draft<'_>, plot: Plot) -> Option<&'static str> {
    let bed = plot == Plot::Bed;
    let either = |of_bed, of_surface| Some(if bed { of_bed } else { of_surface });
    let shape = draft.shape()?;
    if shape.is_rough() {
        return either(
            "a rough line touches in hundreds of places, more than a picture of springs can show: expected Force, Energy or Shape",
            "a rough line stands for the forces of the surface, not for its heights: expected Force, Energy or Shape",
        );
    }
    if draft.bodies(Look::Kind).is_some_and(|(one, two)| one.is_uneven() || two.is_uneven()) {
        return either(
            "the springs of layered or graded bodies stand where their stiffness says, not at their radii: expected Force, Radius, Pressure or Shape",
            "layered or graded bodies do not share the displacement in one ratio at all radii: expected Force, Radius, Pressure or Shape",
        );
    }
    if yields(draft)? {
        return either(
            "a ball that yields is known in closed form, without springs: expected Force, Radius or Pressure, or Elastic bodies",
            "the surface beside a body that yields is not known: expected Force, Radius or Pressure, or Elastic bodies",
        );
    }
    let why = if draft.speeds()? > 0 {
        IMPACT
    } else if draft.wears()? {
        WEARS
    } else if draft.is_driven()? {
        DRIVEN
    } else if draft.moves_along()? {
        ALONG
    } else {
        return if bed { of_bed(draft) } else { of_surface(draft, shape) };
    };
    Some(why)
}

// What is lacked where the bodies do more than press at rest.
const IMPACT: &str =
    "it shows a contact led by a history, not an impact: expected Force or Pressure, or a history of Indent or Press";
const WEARS: &str =
    "it is not computed of a profile that wears: expected Wear, Friction, Stick or Pressure, or no wear";
const DRIVEN: &str = "it is not computed of a contact in a machine: expected Machine, Force, Friction or Energy";
const ALONG: &str = "the contact of a body that moves along is not round: expected Force, Radius, Energy or Resistance";

/// What the bed itself lacks.
fn of_bed(draft: &Draft<'_>) -> Option<&'static str> {
    match draft.adhesion(Look::Kind)?.traits().range {
        Range::Vanishing(_) | Range::Outside => None,
        Range::Finite(_) | Range::Fading(_) => Some(
            "an attraction of finite range acts in a ring outside the contact, where no spring is touched: expected Pressure or Surface, or Jkr adhesion",
        ),
    }
}

/// What the surfaces themselves lack.
fn of_surface(draft: &Draft<'_>, shape: &Shape) -> Option<&'static str> {
    if let Shape::Ellipsoid(_) = shape {
        return Some("the surface about an ellipse is not round: expected Force, Radius, Pressure or Bed");
    }
    let (one, two) = draft.bodies(Look::Whole)?;
    let relaxes = one.relaxes() || two.relaxes();
    (relaxes && Shares::of(&(Body::clone(one), Body::clone(two))).is_none()).then_some(
        "a body that relaxes shares the displacement with another one in a ratio that changes in time: expected one of them Rigid, or Pressure",
    )
}
