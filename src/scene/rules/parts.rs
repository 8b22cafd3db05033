//! Bodies, shape, adhesion, friction and springs against each other.

use super::draft::Draft;
use crate::contact::adhesion::{Adhesion, AdhesionTraits, EdgeRule, Range};
use crate::friction::{Friction, Slip};
use crate::input::problem::Problem;
use crate::material::{Body, Relaxation};
use crate::scene::mended::Look;
use crate::shape::{Family, Rim, Shape};

fn refused(path: &str, what: impl Into<String>) -> Option<Problem> {
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

/// An attraction, and what holds its edge, between elastic or viscoelastic bodies.
pub(super) fn adhesion_between_bodies(draft: &Draft<'_>) -> Option<Problem> {
    let (adhesion, relaxes) = (draft.adhesion(Look::Whole)?.traits(), draft.pair_relaxes()?);
    if super::power_law::relaxes_by_power(draft)? {
        return None;
    }
    let on_pixels = draft.chooses_solver()?;
    let cannot = |why: &str| refused("adhesion", format!("{} with {why}", adhesion.name));
    match (adhesion.range, relaxes) {
        (Range::Vanishing(None), true) if on_pixels => cannot(CRACK_ON_PIXELS),
        (Range::Outside, _) if on_pixels => cannot(OUTSIDE_ON_PIXELS),
        (Range::Outside, true) => cannot(OUTSIDE_A_DENT),
        (Range::Vanishing(None) | Range::Outside, false) => None,
        (Range::Vanishing(Some(_)), false) => {
            refused("adhesion.edge", "an edge is a matter of Viscoelastic bodies, and there is none: leave it out")
        }
        (Range::Vanishing(None), true) => cannot(NO_EDGE),
        (Range::Vanishing(Some(edge)), true) => edge_that_holds_nothing(edge, draft.relaxation()?),
        (Range::Finite(_) | Range::Fading(_), _) if adhesion.work <= 0.0 => refused(
            "adhesion.work",
            "a work of zero gives the attraction no range: expected one above zero, or no adhesion",
        ),
        (Range::Finite(_) | Range::Fading(_), true) if !on_pixels => cannot(GAP_THAT_CREEPS),
        (Range::Finite(_) | Range::Fading(_), _) => None,
    }
}

// Why an attraction, told by its name before, does not go with a body that relaxes or with pixels.
const CRACK_ON_PIXELS: &str = "a Viscoelastic body and the solver HalfSpace cannot be computed, for how much a crack through such a body takes depends on the range of what holds it: expected Maugis(work: …, stress: …)";
const OUTSIDE_ON_PIXELS: &str = "the solver HalfSpace cannot be computed, for its pixels pull across the gap, by a stress: expected Maugis(work: …, stress: …), or no solver";
const OUTSIDE_A_DENT: &str = "a Viscoelastic body cannot be computed, for 2πwR is the attraction of a ball on a flat, and a body that relaxes is left with a dent that is not known to be flat: expected Jkr(work: …, edge: …), or Elastic bodies";
const NO_EDGE: &str = "a Viscoelastic body lacks what holds its edge: expected edge: Relaxed, Instantaneous or Rate(speed: …, exponent: …)";
const GAP_THAT_CREEPS: &str = "a Viscoelastic body cannot be computed on a bed, for the surfaces it draws together creep where no spring is in contact: expected Jkr(work: …, edge: …), or solver: HalfSpace(…)";

/// Opening an edge takes at least what closing it has given.
pub(super) fn closing_beyond_opening(draft: &Draft<'_>) -> Option<Problem> {
    let Adhesion::Jkr(jkr) = draft.adhesion(Look::Whole)? else { return None };
    let (work, closing) = (jkr.work.si(), jkr.closing?.si());
    (closing > work).then(|| {
        Problem::new(
            "adhesion.closing",
            format!("a closing edge gives {closing:?} J/m², more than the work {work:?} J/m² that opens it again: expected at most {work:?}"),
        )
    })
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

fn edge_that_holds_nothing(edge: &EdgeRule, relaxation: &Relaxation) -> Option<Problem> {
    match edge {
        EdgeRule::Relaxed | EdgeRule::Rate(_) if relaxation.equilibrium <= 0.0 => refused(
            "adhesion.edge",
            "an edge held by the relaxed modulus, which is zero here, holds nothing: expected edge: Instantaneous, or an equilibrium modulus above zero",
        ),
        EdgeRule::Instantaneous if relaxation.viscosity > 0.0 => refused(
            "adhesion.edge",
            "Instantaneous with a viscosity has no finite instantaneous modulus: expected edge: Relaxed or Rate(…)",
        ),
        EdgeRule::Relaxed | EdgeRule::Rate(_) | EdgeRule::Instantaneous => None,
    }
}

/// An attraction that fades is followed where every gap is known.
pub(super) fn fading(draft: &Draft<'_>) -> Option<Problem> {
    let AdhesionTraits { name, range: Range::Fading(_), .. } = draft.adhesion(Look::Kind)?.traits() else {
        return None;
    };
    // A pad is no bed, and is told its own reason.
    (!draft.chooses_solver()? && !matches!(draft.shape()?.family(), Family::Pad(_))).then_some(())?;
    refused(
        "adhesion",
        format!(
            "{name} cannot be computed on a bed, for what fades with the gap pulls wherever there is one: expected solver: HalfSpace(…), or Maugis(work: …, stress: …)"
        ),
    )
}

pub(super) fn range_on_shape(draft: &Draft<'_>) -> Option<Problem> {
    let (adhesion, profile) = (draft.adhesion(Look::Kind)?.traits(), draft.profile()?);
    if draft.chooses_solver()? {
        return None;
    }
    let of_paraboloid = profile.is_square() && !profile.is_plane();
    match adhesion.range {
        Range::Outside if !of_paraboloid => {
            return refused(
                "adhesion",
                format!(
                    "{} on a {} cannot be computed, for outside its contact a paraboloid alone is attracted by a force, 2πwR, that depends on the work and not on the range: expected Paraboloid(radius: …) or Spheres(…), or Maugis(work: …, stress: …)",
                    adhesion.name,
                    draft.shape()?.name()
                ),
            );
        }
        Range::Finite(_) => {}
        Range::Outside | Range::Vanishing(_) | Range::Fading(_) => return None,
    }
    let why = if profile.is_plane() {
        "an attraction of finite range is known around a round contact, not beside a strip"
    } else if let Rim::Wall(_) = profile.rim() {
        "the side of the punch leaves the attraction no gap of growing width"
    } else if profile.feature().is_some() {
        "the slope of this profile rises and falls, so it could be attracted in several rings"
    } else {
        return None;
    };
    let (name, shape) = (adhesion.name, draft.shape()?.name());
    refused("adhesion", format!("{name} on a {shape} cannot be computed: {why}; expected Jkr(work: …)"))
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

/// On a rough line patches of elastic bodies are held by their edges.
pub(super) fn adhesion_on_shape(draft: &Draft<'_>) -> Option<Problem> {
    let (adhesion, shape) = (draft.adhesion(Look::Kind)?.traits(), draft.shape()?);
    if draft.chooses_solver()? && !shape.is_plane() {
        return None;
    }
    let (of, why) = match (shape.family(), &adhesion.range) {
        (Family::Pad(_), Range::Vanishing(_)) => return None,
        (Family::Pad(_), Range::Outside | Range::Finite(_) | Range::Fading(_)) => {
            let why = "for its springs and summits hold what they touch: expected Jkr(work: …)";
            return refused("adhesion", format!("{} cannot be computed on a Pad, {why}", adhesion.name));
        }
        (Family::Line(_) | Family::Map(..), Range::Vanishing(_)) if !draft.pair_relaxes()? => return None,
        (Family::Line(_) | Family::Map(..), Range::Vanishing(_)) => (
            " of Viscoelastic bodies",
            "each of its patches would have edges with a past of their own, which join and part",
        ),
        (Family::Line(_) | Family::Map(..), Range::Outside | Range::Finite(_) | Range::Fading(_)) => {
            return refused(
                "adhesion",
                format!(
                    "{} cannot be computed on {}, for its attraction reaches from patch to patch: expected Jkr(work: …)",
                    adhesion.name,
                    not_round(shape).unwrap_or_default()
                ),
            );
        }
        (Family::Round | Family::Tips(_) | Family::Wavy(_), _) => {
            ("", "its series is that of a pressure which ends at zero, not in the pull of an adhesive edge")
        }
    };
    cannot_be_on(draft, "adhesion", &format!("{}{of}", adhesion.name), why)
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
