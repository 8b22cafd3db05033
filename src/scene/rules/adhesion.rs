//! Attractions against bodies, shape and solver.

use super::draft::Draft;
use super::parts::{cannot_be_on, not_round, refused};
use crate::contact::adhesion::{Adhesion, AdhesionTraits, EdgeRule, Range};
use crate::input::problem::Problem;
use crate::material::Relaxation;
use crate::scene::mended::Look;
use crate::shape::{Family, Rim};

/// An attraction, and what holds its edge, between elastic or viscoelastic bodies.
pub(super) fn between_bodies(draft: &Draft<'_>) -> Option<Problem> {
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

/// On a rough line patches of elastic bodies are held by their edges.
pub(super) fn on_shape(draft: &Draft<'_>) -> Option<Problem> {
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
