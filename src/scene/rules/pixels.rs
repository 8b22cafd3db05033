//! The half-space solver against the other parts: it presses shapes on pixels, and slides them as far as pressures tell.

use super::draft::Draft;
use super::plastic::yields;
use crate::contact::adhesion::{AdhesionTraits, Range};
use crate::friction::Friction;
use crate::input::problem::Problem;
use crate::scene::history::{EntryTraits, Glide};
use crate::scene::mended::Look;
use crate::scene::solver::{HalfSpace, Tractions};
use crate::shape::{Boundary, Family, Shape};

/// Fewest and most pixels along x.
const GRID: (usize, usize) = (8, 8192);

fn refused(path: &str, what: impl Into<String>) -> Option<Problem> {
    Some(Problem::new(path, what))
}

pub(super) fn built(draft: &Draft<'_>) -> Option<Problem> {
    draft.half_space(Look::Kind)?;
    let what = "HalfSpace cannot be computed, for this program was built without it: expected the feature `half-space`, or no solver";
    (!cfg!(feature = "half-space")).then(|| Problem::new("solver", what))
}

pub(super) fn grid(draft: &Draft<'_>) -> Option<Problem> {
    let grid = draft.half_space(Look::Whole)?.grid?.get();
    let (fewest, most) = GRID;
    if grid < fewest {
        return refused("solver.grid", format!("{grid} pixels do not show a contact: expected at least {fewest}"));
    }
    let what = format!("{grid} × {grid} pixels do not fit into memory: expected at most {most}");
    (grid > most).then(|| Problem::new("solver.grid", what))
}

/// On pixels an attraction acts across the gap, and at no edge.
pub(super) fn adhesion(draft: &Draft<'_>) -> Option<Problem> {
    draft.half_space(Look::Kind)?;
    let AdhesionTraits { name, closing, range, .. } = draft.adhesion(Look::Whole)?.traits();
    let why = match (closing, range) {
        (Some(_), _) => "closing: … of an edge",
        (None, Range::Vanishing(Some(_))) => "edge: … of a body that relaxes",
        (None, Range::Vanishing(None) | Range::Outside | Range::Finite(_) | Range::Fading(_)) => return None,
    };
    let what = format!(
        "{name} with {why} and the solver HalfSpace cannot be computed, for its pixels pull across the gap and have no edge of their own: expected Maugis(work, stress), or no solver"
    );
    refused("adhesion", what)
}

/// On pixels friction is told by pressures alone.
pub(super) fn friction(draft: &Draft<'_>) -> Option<Problem> {
    draft.half_space(Look::Kind)?;
    let friction = draft.friction(Look::Kind)?;
    let name = friction.name();
    let (of, why) = match friction {
        Friction::StaticKinetic(_) | Friction::RateState(_) => (
            "",
            "it is followed in a machine, which pixels have none of: expected Coulomb(coefficient: …), or no solver",
        ),
        Friction::Stuck => {
            ("", "it is known of the edge of a round contact: expected Coulomb(coefficient: …), or no solver")
        }
        Friction::Coulomb(_) if draft.pair_relaxes()? => (
            " of a Viscoelastic body",
            "what stuck at one time has crept at another, so that differences of pressures no longer tell its shear: expected Elastic or Rigid bodies, or no solver",
        ),
        Friction::Pressure(_) if draft.adheres()? => (
            " under adhesion",
            "how shear weakens what pulls across the gap of each pixel is not known: expected no adhesion, or no solver",
        ),
        Friction::Coulomb(_) | Friction::CoulombOrowan(_) | Friction::Pressure(_) => return None,
    };
    refused("friction", format!("{name}{of} with the solver HalfSpace cannot be computed, for {why}"))
}

/// Pressures and shear together are those of elastic half-spaces under Coulomb's law.
pub(super) fn tractions(draft: &Draft<'_>) -> Option<Problem> {
    if draft.half_space(Look::Whole)?.tractions? == Tractions::Independent {
        return None;
    }
    let (one, two) = draft.bodies(Look::Kind)?;
    let friction = draft.friction(Look::Kind);
    let why = if !matches!(friction, Some(Friction::Coulomb(_))) {
        "without Coulomb(coefficient: …) cannot be computed, for there is no shear that sticks and slips: expected friction: Coulomb(…), or tractions: Independent"
    } else if draft.adheres()? {
        "under adhesion cannot be computed, for what it does to shear is not known: expected no adhesion, or tractions: Independent"
    } else if one.is_uneven() || two.is_uneven() {
        "over layers cannot be computed, for only what presses is known of them: expected Elastic or Rigid bodies, or tractions: Independent"
    } else if draft.pair_relaxes()? || yields(draft)? {
        "of a body that relaxes or yields cannot be computed: expected Elastic or Rigid bodies, or tractions: Independent"
    } else if draft.glides()? {
        "of a body that glides on cannot be computed, for there nothing sticks: expected tractions: Independent"
    } else {
        return None;
    };
    refused("solver.tractions", format!("Coupled {why}"))
}

/// What rubs off changes the heights.
pub(super) fn wear(draft: &Draft<'_>) -> Option<Problem> {
    draft.half_space(Look::Kind)?;
    let name = draft.wear()?;
    let what = format!(
        "{name} with the solver HalfSpace cannot be computed, for wear is followed in rings of a round contact: expected no wear, or no solver"
    );
    refused("wear", what)
}

pub(super) fn springs(draft: &Draft<'_>) -> Option<Problem> {
    draft.half_space(Look::Kind)?;
    draft.springs()?;
    refused(
        "springs",
        "with the solver HalfSpace cannot be computed, for it has pixels and no springs: expected no springs, or no solver",
    )
}

pub(super) fn moves(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    draft.half_space(Look::Kind)?;
    let why = if entry.impact.is_some() {
        "its states have no motion"
    } else if entry.traction().is_some() {
        return None;
    } else if let Some((glide, _)) = entry.glide {
        return glides(draft, entry, glide);
    } else {
        return None;
    };
    let what = format!(
        "{} with the solver HalfSpace cannot be computed, for {why}: expected Indent, Press, Hold, HoldForce, Oscillate, Retract, Slide, Shake or a Table",
        entry.name
    );
    Some(Problem::new(entry.place(), what))
}

/// A body that glides, and what the ground behind it must be.
fn glides(draft: &Draft<'_>, entry: &EntryTraits<'_>, glide: &Glide) -> Option<Problem> {
    let (one, two) = draft.bodies(Look::Kind)?;
    let liquid = draft.flows()?;
    let why = if !glide.is_steady() {
        "how the motion begins is not followed on pixels: expected no `over`, for the steady state"
    } else if liquid {
        "a ground that flows gives way without an end under a body that stays on it: expected an equilibrium modulus above zero"
    } else if one.hardness().or(two.hardness()).is_some() {
        "a body that yields is left with a groove: expected no hardness"
    } else if two.is_uneven() && !repeats(draft)? {
        "behind a body that stands alone the waves of layers have no end: expected boundary: Periodic and a window: …"
    } else {
        return None;
    };
    Some(Problem::new(entry.place(), format!("{} with the solver HalfSpace cannot be computed: {why}", entry.name)))
}

/// Whether what lies on the pixels repeats.
fn repeats(draft: &Draft<'_>) -> Option<bool> {
    let (asked, shape) = (draft.half_space(Look::Whole)?, draft.shape()?);
    let random = matches!(shape.family(), Family::Line(line) if line.base.is_none());
    Some(asked.boundary.map_or(random, |boundary| boundary == Boundary::Periodic))
}

/// What lies on pixels, and where it ends.
pub(super) fn shape(draft: &Draft<'_>) -> Option<Problem> {
    let (asked, shape) = (draft.half_space(Look::Whole)?, draft.shape()?);
    if shape.is_plane() {
        let what = format!(
            "{} with the solver HalfSpace cannot be computed, for it is long across and has a half-plane of its own: expected a round or rough shape, or no solver",
            shape.name()
        );
        return refused("shape", what);
    }
    if let Family::Pad(_) = shape.family() {
        let what = "Pad with the solver HalfSpace cannot be computed, for it tells how its heights are scattered and not where they are: expected a RoughLine or HeightMap, or no solver";
        return refused("shape", what);
    }
    repeated(asked, shape).or_else(|| several(draft.whole_shape()?))
}

/// A tip repeats at a distance that somebody must say.
fn repeated(asked: &HalfSpace, shape: &Shape) -> Option<Problem> {
    let (Some(Boundary::Periodic), None, Family::Round | Family::Tips(_)) =
        (asked.boundary, asked.window, shape.family())
    else {
        return None;
    };
    let what = format!(
        "a {} that repeats does so at some distance: expected window: …, the distance from tip to tip, or boundary: Free",
        shape.name()
    );
    refused("solver.boundary", what)
}

/// What a fluid leaks past a tip that stands alone is a matter of the window.
pub(super) fn leak(draft: &Draft<'_>) -> Option<Problem> {
    let (asked, shape) = (draft.half_space(Look::Whole)?, draft.shape()?);
    let alone = matches!(shape.family(), Family::Round | Family::Tips(_)) && asked.boundary != Some(Boundary::Periodic);
    let what = format!(
        "of a {} that stands alone cannot be computed, for all that flows goes past it: expected a rough surface, or boundary: Periodic and a window: …",
        shape.name()
    );
    (asked.leak.is_some() && alone).then(|| Problem::new("solver.leak", what))
}

/// A random surface is computed one at a time.
fn several(shape: &Shape) -> Option<Problem> {
    let Family::Line(line) = shape.family() else { return None };
    let seeds = line.seeds().len();
    let what = format!(
        "{seeds} seeds with the solver HalfSpace cannot be computed, for their maps are not one: expected one seed, and a sweep over shape.seed for more"
    );
    (seeds != 1).then(|| Problem::new(if line.seeds.is_some() { "shape.seeds" } else { "shape.seed" }, what))
}

/// What is wrong with tips on a bed.
pub(in crate::scene) fn tips_without_pixels() -> Problem {
    let what = "Tips cannot be computed on a bed of springs, for each tip lifts the others off: expected solver: HalfSpace(…) beside it";
    Problem::new("shape", what)
}

pub(super) fn tips(draft: &Draft<'_>) -> Option<Problem> {
    let Family::Tips(_) = draft.shape()?.family() else { return None };
    (!draft.chooses_solver()?).then(tips_without_pixels)
}

/// A random surface has its own size.
pub(super) fn window(draft: &Draft<'_>) -> Option<Problem> {
    draft.half_space(Look::Whole)?.window?;
    let Family::Line(_) = draft.shape()?.family() else { return None };
    refused("solver.window", "of a random surface is its length: expected no window, or another shape.length")
}
