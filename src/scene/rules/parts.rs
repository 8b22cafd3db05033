//! Bodies, shape, adhesion, friction and springs against each other.

use super::draft::Draft;
use crate::contact::adhesion::Range;
use crate::friction::{Friction, Slip};
use crate::input::problem::Problem;
use crate::material::Body;
use crate::scene::mended::Look;
use crate::shape::{Family, Shape};

pub(super) fn refused(path: &str, what: impl Into<String>) -> Option<Problem> {
    Some(Problem::new(path, what))
}

pub(super) fn two_rigid(draft: &Draft<'_>) -> Option<Problem> {
    let (Body::Rigid, Body::Rigid) = draft.bodies(Look::Kind)? else { return None };
    let what = if draft.adheres()? {
        "two rigid bodies that attract each other have no contact to be computed: balls that touch are torn off by 2πwR (Bradley 1932), and a gap z weakens that to 2πR(w − σ₀z) under a constant stress σ₀; expected at least one Elastic(…), however stiff, with Dmt(work: …) or Maugis(work: …, stress: …)"
    } else {
        "two rigid bodies cannot be pressed together: expected at least one Elastic(…), Viscoelastic(…) or Plastic(…)"
    };
    refused("bodies", what)
}

/// An edge that closes with less work than it opens with depends on what has been.
pub(super) fn friction_with_closing(draft: &Draft<'_>) -> Option<Problem> {
    draft.friction_of_history()?;
    draft.adhesion(Look::Whole)?.traits().closing?;
    refused(
        "adhesion.closing",
        "with friction cannot be computed, for peeling is known of an edge in equilibrium only: expected no closing, or no friction",
    )
}

/// Springs of one width tell the force of a pinned edge to first order only.
pub(super) fn springs_with_closing(draft: &Draft<'_>) -> Option<Problem> {
    draft.springs()?;
    draft.adhesion(Look::Whole)?.traits().closing?;
    refused("springs", "with closing cannot be computed: expected no springs, for the continuous bed holds the edge")
}

/// Friction needs one ratio of tangential and normal stiffness at all times.
pub(super) fn friction_of_bodies_in_series(draft: &Draft<'_>) -> Option<Problem> {
    draft.friction(Look::Kind)?;
    let (one, two) = draft.bodies(Look::Whole)?;
    let similar = matches!(one, Body::Rigid) || matches!(two, Body::Rigid) || one == two;
    if similar || !draft.pair_relaxes()? {
        return None;
    }
    refused(
        "friction",
        "with a Viscoelastic body against another that gives cannot be computed, for the pair is not elastically similar at all times: expected Rigid or an equal body beside Viscoelastic, or no friction",
    )
}

pub(super) fn gross_sliding_of_viscoelastic(draft: &Draft<'_>) -> Option<Problem> {
    draft.pair_relaxes()?.then_some(())?;
    let friction = draft.friction_of_history()?;
    match friction.slip() {
        // Of what sticks everywhere its edge is told its own reason.
        Slip::Local(_) | Slip::Nowhere => None,
        Slip::Gross => refused(
            "friction",
            format!(
                "{} with a Viscoelastic body cannot be computed, for a contact that slides as a whole presses on ever other places, and a ground that relaxes resists them otherwise than at rest: expected Coulomb(coefficient: …), Elastic or Rigid bodies, or no friction",
                friction.name()
            ),
        ),
    }
}

/// A sheared adhesive contact is known under uniform stress.
pub(super) fn friction_under_adhesion(draft: &Draft<'_>) -> Option<Problem> {
    draft.pair_relaxes()?;
    let (friction, adhesion) = (draft.friction_of_history()?, draft.adhesion(Look::Kind)?.traits());
    let known = draft.friction(Look::Whole).is_some();
    let (one, other) = (friction.name(), adhesion.name);
    let cannot = |why: &str| refused("friction", format!("{one} with {other} adhesion cannot be computed, for {why}"));
    match (adhesion.range, friction) {
        (Range::Vanishing(_), Friction::Coulomb(_) | Friction::StaticKinetic(_) | Friction::RateState(_)) => {
            cannot(PULLED_SPRINGS)
        }
        (Range::Vanishing(_), Friction::CoulombOrowan(_)) => cannot(UNEVEN_PEELING),
        (Range::Vanishing(_), Friction::Pressure(law)) if known && law.slope.si() > 0.0 => refused(
            "friction.slope",
            format!(
                "{one} with a slope of {} and {other} adhesion cannot be computed, for at an adhesive edge the pressure falls without bound, and τ_c + βp with it would drive the slide there: expected slope: 0, or Dmt(work: …) of hard bodies",
                law.slope.si()
            ),
        ),
        (Range::Vanishing(_), Friction::Pressure(_) | Friction::Stuck) => None,
        // What adheres at no edge is told by another rule.
        (_, Friction::Stuck) => None,
        // The pressure inside the contact is Hertz's, and the attraction outside adds to what presses.
        (Range::Outside, _) => None,
        (
            Range::Finite(_) | Range::Fading(_),
            Friction::Coulomb(_)
            | Friction::StaticKinetic(_)
            | Friction::RateState(_)
            | Friction::CoulombOrowan(_)
            | Friction::Pressure(_),
        ) => cannot(SHEARED_GAP),
    }
}

// Why shear is not known beside an attraction.
const PULLED_SPRINGS: &str = "the springs of an adhesive edge are pulled and have no limit μq: expected Stuck, Pressure(shear: …, slope: 0), Dmt(work: …) of hard bodies, or no adhesion";
const UNEVEN_PEELING: &str = "how a stress that is not uniform peels an edge has no closed answer: expected Pressure(shear: …, slope: 0), or no adhesion";
const SHEARED_GAP: &str = "how shear weakens what pulls across the gap around a contact is known of a vanishing range only: expected Jkr(…) with Pressure(shear: …, slope: 0), or no adhesion";

/// What sticks everywhere gives way at an edge that adheres.
pub(super) fn stuck_without_edge(draft: &Draft<'_>) -> Option<Problem> {
    let Friction::Stuck = draft.friction(Look::Kind)? else { return None };
    let adheres = draft.adheres()?;
    let range = adheres.then(|| draft.adhesion(Look::Kind).map(|adhesion| adhesion.traits().range)).flatten();
    let why = match range {
        Some(Range::Vanishing(_)) if !draft.pair_relaxes()? => return None,
        Some(Range::Vanishing(_)) => {
            "how the edge of a body that relaxes peels under shear has no closed answer: expected Elastic bodies"
        }
        None if !adheres => {
            "nothing says where a contact slips that no edge holds: expected adhesion: Jkr(work: …), or Coulomb(coefficient: …)"
        }
        Some(_) | None => {
            "how shear weakens what pulls outside the contact is not known: expected adhesion: Jkr(work: …)"
        }
    };
    refused("friction", format!("Stuck cannot be computed here, for {why}"))
}

/// How shear peels an edge is known of round contacts.
pub(super) fn peeling_on_section(draft: &Draft<'_>) -> Option<Problem> {
    let (friction, profile) = (draft.friction_of_history()?, draft.profile()?);
    draft.adhesion(Look::Kind)?;
    match friction.slip() {
        Slip::Gross | Slip::Nowhere if profile.is_plane() => refused(
            "friction",
            format!(
                "{} with adhesion cannot be computed on a {}, for how shear peels is known of round contacts: expected no adhesion, or no friction",
                friction.name(),
                draft.shape()?.name()
            ),
        ),
        Slip::Gross | Slip::Nowhere | Slip::Local(_) => None,
    }
}

pub(super) fn springs_under_adhesion(draft: &Draft<'_>) -> Option<Problem> {
    draft.springs()?;
    let adhesion = draft.adhesion(Look::Whole)?.traits();
    let name = adhesion.name;
    match adhesion.range {
        Range::Outside | Range::Finite(_) | Range::Fading(_) => {
            refused("springs", format!("with {name} adhesion cannot be computed: expected Jkr(…), or no springs"))
        }
        Range::Vanishing(Some(_)) => refused(
            "springs",
            "with an adhesive Viscoelastic body cannot be computed: expected no springs, for the continuous bed holds the edge",
        ),
        Range::Vanishing(None) => {
            draft.friction(Look::Kind)?;
            refused(
                "springs",
                format!(
                    "with {name} adhesion under shear cannot be computed: expected no springs, no adhesion or no friction"
                ),
            )
        }
    }
}

/// A shape that is rough or plane, in words.
pub(super) fn not_round(shape: &Shape) -> Option<String> {
    match shape.family() {
        Family::Round | Family::Tips(_) => None,
        Family::Line(_) | Family::Map(..) => Some(format!("the rough shape {}", shape.name())),
        Family::Wavy(_) => Some(shape.name().to_owned()),
        Family::Pad(_) => Some(format!("a {}", shape.name())),
    }
}

/// A part that cannot be computed on the shape of the scene.
pub(super) fn cannot_be_on(draft: &Draft<'_>, path: &str, part: &str, why: &str) -> Option<Problem> {
    let shape = not_round(draft.shape()?)?;
    refused(path, format!("{part} cannot be computed on {shape}, for {why}: expected none"))
}

/// Of friction a wave knows gross sliding, as a result.
pub(super) fn friction_on_shape(draft: &Draft<'_>) -> Option<Problem> {
    let (friction, shape) = (draft.friction(Look::Kind)?, draft.shape()?);
    match (shape.family(), friction) {
        (Family::Line(_) | Family::Map(..), Friction::Coulomb(_)) => None,
        (Family::Line(_) | Family::Map(..), Friction::CoulombOrowan(_) | Friction::Pressure(_))
            if draft.on_pixels()? =>
        {
            None
        }
        (
            Family::Line(_) | Family::Map(..),
            Friction::StaticKinetic(_)
            | Friction::RateState(_)
            | Friction::Stuck
            | Friction::CoulombOrowan(_)
            | Friction::Pressure(_),
        ) => refused(
            "friction",
            format!(
                "{} cannot be computed on {}: a rough bed tells neither the real pressure nor when all of it slides; expected Coulomb(coefficient: …)",
                friction.name(),
                not_round(shape).unwrap_or_default()
            ),
        ),
        (Family::Pad(_), _) => {
            cannot_be_on(draft, "friction", friction.name(), "its springs and summits are pressed from straight above")
        }
        (Family::Round | Family::Tips(_) | Family::Wavy(_), _) => {
            cannot_be_on(draft, "friction", friction.name(), "its series is that of a pressure and knows no shear")
        }
    }
}

pub(super) fn springs_on_shape(draft: &Draft<'_>) -> Option<Problem> {
    draft.springs()?;
    cannot_be_on(draft, "springs", "a number of springs", "how many it has follows from the shape")
}

/// Whether the shape is a section known by a series of its own, not by a bed.
pub(super) fn is_without_bed(shape: &Shape) -> bool {
    matches!(shape.family(), Family::Wavy(_))
}

pub(super) fn viscoelastic_on_plane(draft: &Draft<'_>) -> Vec<Problem> {
    if !draft.shape().is_some_and(is_without_bed) {
        return Vec::new();
    }
    let bodies = [("bodies.0", draft.body(0, Look::Kind)), ("bodies.1", draft.body(1, Look::Kind))];
    let viscoelastic = bodies.into_iter().filter(|(_, body)| body.is_some_and(Body::relaxes));
    let why = "pieces of its contact join and part, and a body that relaxes would remember which was when";
    viscoelastic.filter_map(|(path, _)| cannot_be_on(draft, path, "a viscoelastic body", why)).collect()
}
