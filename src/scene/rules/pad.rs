//! Pads of scattered heights against the other parts: their springs or summits are pressed from straight above.

use super::draft::Draft;
use crate::input::problem::Problem;
use crate::material::Body;
use crate::scene::history::EntryTraits;
use crate::scene::mended::Look;
use crate::shape::{Family, Pad};

fn pad<'d>(draft: &Draft<'d>) -> Option<&'d Pad> {
    match draft.whole_shape()?.family() {
        Family::Pad(pad) => Some(pad),
        Family::Round | Family::Line(_) | Family::Map(..) | Family::Tips(_) | Family::Wavy(_) => None,
    }
}

/// Springs are those of a sheet, summits balls on half-spaces.
pub(super) fn on_bodies(draft: &Draft<'_>) -> Option<Problem> {
    let (pad, (one, two)) = (pad(draft)?, draft.bodies(Look::Kind)?);
    let springs = matches!(one, Body::Winkler(_)) || matches!(two, Body::Winkler(_));
    let plain = |body: &Body| matches!(body, Body::Rigid | Body::Elastic(_));
    let what = match pad.summits {
        None if !springs => {
            "a Pad without summits is made of the springs of a sheet: expected Winkler(modulus: …, thickness: …) beside Rigid, or summits: (number: …, radius: …) on Elastic bodies"
        }
        Some(_) if springs => {
            "summits on a Winkler sheet cannot be computed, for each of its springs is a summit by itself: expected no summits, or Elastic bodies"
        }
        Some(_) if !(plain(one) && plain(two)) => {
            "summits are known as balls on elastic half-spaces that are alike at all depths: expected Elastic or Rigid bodies"
        }
        None | Some(_) => return None,
    };
    Some(Problem::new("shape.summits", what))
}

/// How an edge of a ball stands still between two works is followed of one ball.
pub(super) fn closing_of_summits(draft: &Draft<'_>) -> Option<Problem> {
    pad(draft)?.summits?;
    draft.adhesion(Look::Whole)?.traits().closing?;
    let what = "on summits cannot be computed, for each of them would have an edge with a past of its own: expected no closing, or a Winkler sheet without summits";
    Some(Problem::new("adhesion.closing", what))
}

pub(super) fn moves(draft: &Draft<'_>, entry: &EntryTraits<'_>) -> Option<Problem> {
    pad(draft)?;
    let why = if entry.impact.is_some() {
        "a mass on a pad is not followed: expected Press(…) or Indent(…)"
    } else if entry.slides() {
        "its springs and summits are pressed from straight above: expected none"
    } else {
        return None;
    };
    Some(Problem::new(entry.place(), format!("{} cannot be computed on a Pad, for {why}", entry.name)))
}
