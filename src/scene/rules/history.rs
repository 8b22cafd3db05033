//! Entries of the history against the other parts, and against each other.

use super::draft::Draft;
use super::parts::{cannot_be_on, is_without_bed};
use crate::contact::adhesion::Range;
use crate::friction::{Friction, Slip};
use crate::input::problem::Problem;
use crate::scene::history::{EntryTraits, Impact};
use crate::scene::mended::Look;
use crate::scene::stage::Path;
use crate::shape::{Family, Shape};

fn refused(entry: &EntryTraits<'_>, what: impl Into<String>) -> Option<Problem> {
    Some(Problem::new(entry.place(), what))
}

fn oblique<'e>(entry: &EntryTraits<'e>) -> Option<&'e Impact> {
    entry.impact.filter(|impact| impact.is_oblique())
}

pub(super) fn impact_on_plane(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    draft.shape().filter(|shape| is_without_bed(shape))?;
    entry.impact?;
    cannot_be_on(
        draft,
        &entry.place(),
        entry.name,
        "a half-plane gives without end, so that a mass does not know how deep it is",
    )
}

pub(super) fn slide_on_plane(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    let shape = draft.shape()?;
    if !is_without_bed(shape) || entry.impact.is_some() || !entry.slides() {
        return None;
    }
    refused(
        entry,
        format!(
            "cannot be computed on {}, for its series is that of a pressure and knows no shear: expected none",
            shape.name()
        ),
    )
}

/// A wavy section is known by its load.
pub(super) fn depth_of_wavy(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    let shape = draft.shape()?;
    match shape.family() {
        Family::Wavy(_) if entry.by_depth() => refused(
            entry,
            format!(
                "cannot be computed on {}, for a half-plane gives without end and has no depth of its own: expected Press(…) or HoldForce(…)",
                shape.name()
            ),
        ),
        Family::Round | Family::Line(_) | Family::Map(..) | Family::Tips(_) | Family::Wavy(_) | Family::Pad(_) => None,
    }
}

pub(super) fn oblique_on_shape(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    oblique(entry)?;
    let shape = draft.shape()?;
    if let Shape::Paraboloid(_) = shape {
        return None;
    }
    refused(
        entry,
        format!(
            "an oblique Impact of a {} cannot be computed, for only a ball is known to turn as it slips: expected Paraboloid(radius: …), or no angle and spin",
            shape.name()
        ),
    )
}

pub(super) fn pull_without_adhesion(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    let pulled = |path| matches!(path, Path::To(force) if force < 0.0);
    if draft.adheres()? || !entry.by_force() {
        return None;
    }
    let at = entry.stages.iter().position(|stage| pulled(stage.normal))?;
    let Path::To(force) = entry.stages[at].normal else { return None };
    let what = match entry.table {
        Some(_) => format!("{}force_n: {force:?} is a pull", entry.row(at)),
        None => format!("{force:?} N is a pull"),
    };
    Some(Problem::new(
        format!("{}{}", entry.place(), entry.field),
        format!("{what}, and without adhesion bodies cannot be pulled: expected a force of zero or above"),
    ))
}

pub(super) fn oblique_under_adhesion(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    oblique(entry)?;
    let adhesion = draft.adhesion(Look::Kind)?.traits();
    let why = match adhesion.range {
        Range::Outside => {
            "its course along the surface is told of a ball that takes Hertz's time and no attraction draws"
        }
        Range::Vanishing(_) | Range::Finite(_) | Range::Fading(_) => {
            "the springs of an adhesive edge are pulled and have no limit μq at which the ball would slip"
        }
    };
    refused(
        entry,
        format!(
            "an oblique Impact with {} adhesion cannot be computed, for {why}: expected no adhesion, or no angle and spin",
            adhesion.name
        ),
    )
}

/// Sliding as it stands in a message.
fn sliding(entry: &EntryTraits<'_>) -> Option<String> {
    let how = match (entry.impact, entry.table) {
        (Some(_), _) => " with an angle or spin",
        (None, Some(_)) => " with slide_m",
        (None, None) => "",
    };
    entry.slides().then(|| format!("{}{how}", entry.name))
}

pub(super) fn slide_without_friction(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    let (name, false) = (sliding(entry)?, draft.rubs()?) else { return None };
    refused(entry, format!("{name} needs friction: expected a friction such as Coulomb(coefficient: 0.3)"))
}

/// Under gross sliding a contact can go one way.
pub(super) fn shake_in_gross_sliding(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    let friction = draft.friction(Look::Kind)?;
    let (Slip::Gross, false) = (friction.slip(), entry.is_slide()) else { return None };
    let (name, law) = (sliding(entry)?, friction.name());
    refused(
        entry,
        format!(
            "{name} with friction {law} cannot be computed, for {law} is a law of gross sliding: expected Coulomb(coefficient: …) or Slide(…)"
        ),
    )
}

/// A contact that sticks everywhere is followed along the surface, not up and down while it is sheared.
pub(super) fn moved_while_stuck(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    let Friction::Stuck = draft.friction(Look::Kind)? else { return None };
    let moves = entry.stages.iter().any(|stage| stage.normal != Path::Stay);
    let both = entry.slides() && moves;
    (moves && (both || draft.firsts().slide.is_some_and(|slide| slide.number < entry.number))).then_some(())?;
    refused(
        entry,
        format!(
            "{} moves a sheared contact up or down, and how a Stuck edge joins and parts on the way is not computed: expected Slide, Shake or Hold from the first slide on",
            entry.name
        ),
    )
}

pub(super) fn impact_on_springs(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    entry.impact?;
    draft.springs()?;
    refused(
        entry,
        "Impact with springs cannot be computed, for an impact is followed without springs: leave springs out",
    )
}

pub(super) fn impact_beside_others(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    entry.impact?;
    let others = draft.length()?.checked_sub(1).filter(|&others| others > 0)?;
    refused(entry, format!("Impact stands beside {others} other entries: expected it alone in the history"))
}

/// A retraction needs bodies in contact.
pub(super) fn nothing_to_part(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    if !entry.parts() {
        return None;
    }
    let why = if entry.number == 0 {
        (!draft.adheres()?).then_some("the bodies only touch at the start")
    } else {
        draft.entry_before(entry)?.parts().then_some("the entry before has parted the bodies")
    }?;
    refused(entry, format!("{why}: expected an Indent or Press before Retract"))
}
