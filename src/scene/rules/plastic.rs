//! Bodies that yield against the other parts: of them the pressed ball is known, and what pixels bear.

use super::draft::Draft;
use super::parts::not_round;
use crate::input::problem::Problem;
use crate::scene::mended::Look;
use crate::shape::Shape;

/// Whether a body yields; `None` where that is not known.
pub(super) fn yields(draft: &Draft<'_>) -> Option<bool> {
    let (one, two) = draft.bodies(Look::Kind)?;
    Some([one, two].into_iter().any(|body| body.hardness().is_some()))
}

fn refused(path: &str, what: impl Into<String>) -> Option<Problem> {
    Some(Problem::new(path, what))
}

pub(super) fn on_viscoelastic(draft: &Draft<'_>) -> Option<Problem> {
    (yields(draft)? && draft.pair_relaxes()?).then_some(())?;
    refused(
        "bodies",
        "Plastic against Viscoelastic cannot be computed, for what one creeps the other would yield: expected Plastic against Rigid, Elastic or Plastic",
    )
}

/// Thornton's solution is that of a ball; a rough line has its patches.
pub(super) fn on_shape(draft: &Draft<'_>) -> Option<Problem> {
    (yields(draft)? && !draft.chooses_solver()?).then_some(())?;
    let shape = draft.shape()?;
    if shape.is_rough() {
        return None;
    }
    if let Shape::Paraboloid(_) | Shape::Sphere(_) | Shape::Spheres(_) = shape {
        return None;
    }
    let name = not_round(shape).unwrap_or_else(|| format!("a {}", shape.name()));
    refused(
        "bodies",
        format!(
            "Plastic under {name} cannot be computed, for yielding is known in closed form below a ball and by the hardness on a rough line: expected Paraboloid(radius: …), Sphere(radius: …), Spheres(…) or a rough shape, or Elastic(…) with a yield_stress"
        ),
    )
}

pub(super) fn under_adhesion(draft: &Draft<'_>) -> Option<Problem> {
    yields(draft)?.then_some(())?;
    let adhesion = draft.adhesion(Look::Kind)?.traits();
    refused(
        "adhesion",
        format!(
            "{} of a Plastic body cannot be computed, for how an edge parts from the dent it has left has no closed answer: expected no adhesion, or Elastic(…)",
            adhesion.name
        ),
    )
}

pub(super) fn with_friction(draft: &Draft<'_>) -> Option<Problem> {
    yields(draft)?.then_some(())?;
    let friction = draft.friction(Look::Kind)?;
    refused(
        "friction",
        format!(
            "{} of a Plastic body cannot be computed, for a shear makes it yield at another pressure: expected no friction, or Elastic(…)",
            friction.name()
        ),
    )
}

pub(super) fn on_springs(draft: &Draft<'_>) -> Option<Problem> {
    yields(draft)?.then_some(())?;
    draft.springs()?;
    refused(
        "springs",
        "of a Plastic body cannot be computed: expected no springs, for the ball that yields has a closed form",
    )
}
