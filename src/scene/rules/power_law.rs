//! Bodies that relax by a power law against the other parts: infinitely stiff at once, and without strength in the end.

use super::draft::Draft;
use crate::contact::adhesion::equilibrium::Control;
use crate::input::problem::Problem;
use crate::material::Body;
use crate::scene::history::EntryTraits;
use crate::scene::mended::Look;
use crate::scene::stage::Path;

/// Whether a body relaxes by a power law; `None` where that is not known.
pub(super) fn relaxes_by_power(draft: &Draft<'_>) -> Option<bool> {
    let (one, two) = draft.bodies(Look::Kind)?;
    Some([one, two].into_iter().any(|body| body.power_law().is_some()))
}

/// An adhesive edge is held by the modulus at once or by that in the end.
pub(super) fn under_adhesion(draft: &Draft<'_>) -> Option<Problem> {
    relaxes_by_power(draft)?.then_some(())?;
    let adhesion = draft.adhesion(Look::Kind)?.traits();
    Some(Problem::new(
        "adhesion",
        format!(
            "{} with a body that relaxes by a PowerLaw cannot be computed, for its edge would be held by the modulus at once, which is infinite, or by that in the end, which is zero: expected shear: (equilibrium: …, terms: […]), or no adhesion",
            adhesion.name
        ),
    ))
}

/// The bed over layers asks for their response at every place and time of a series; the many short times of a power law
/// make that minutes.
pub(super) fn in_layers(draft: &Draft<'_>) -> Option<Problem> {
    if draft.chooses_solver()? {
        return None;
    }
    let (one, two) = draft.bodies(Look::Kind)?;
    let mut named = [("bodies.0", one), ("bodies.1", two)].into_iter();
    let (place, _) = named.find(|(_, body)| matches!(body, Body::Layered(_)) && body.power_law().is_some())?;
    let what = "Layered of bodies that relax by a PowerLaw cannot be computed, for the many short times of the series that stands for it take minutes over layers: expected shear: (equilibrium: …, terms: […]), or Viscoelastic without layers";
    Some(Problem::new(place, what))
}

/// The series that stands for the law needs to know the times of the history beforehand.
pub(super) fn in_entry(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    relaxes_by_power(draft)?.then_some(())?;
    let why = if entry.impact.is_some() {
        "how long it takes is known only behind it"
    } else if entry.machine.is_some() {
        "its mass moves in times of its own"
    } else if entry.glide.is_some() {
        "the shortest of its times is that in which a spring passes, and no record has it"
    } else {
        return None;
    };
    Some(Problem::new(
        entry.place(),
        format!(
            "{} of a body that relaxes by a PowerLaw cannot be computed, for the series that stands for it is laid out over the times of the history, and {why}: expected shear: (equilibrium: …, terms: […])",
            entry.name
        ),
    ))
}

/// What jumps is met by the modulus at once.
pub(super) fn at_once(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    relaxes_by_power(draft)?.then_some(())?;
    let first = entry.stages.first().filter(|stage| entry.table.is_some() && stage.over <= 0.0)?;
    let what = match (first.control, first.normal) {
        (Some(Control::Indentation), Path::To(depth)) if depth > 0.0 => {
            "the force of a depth that is there at once is infinite"
        }
        (Some(Control::Force), Path::To(force)) if force > 0.0 => {
            "a force that is there at once has not yet gone any way"
        }
        (
            Some(Control::Indentation | Control::Force) | None,
            Path::To(_) | Path::Stay | Path::Steady { .. } | Path::Wave(_) | Path::UntilParted { .. },
        ) => return None,
    };
    Some(Problem::new(
        entry.place(),
        format!(
            "{}Table of a body that relaxes by a PowerLaw cannot begin in contact, for {what}: expected a first row without it, or a later time of it",
            entry.row(0)
        ),
    ))
}
