//! The error of elastic contacts, and where it comes from.

use super::conditioning::moved_edge;
use super::shear;
use crate::contact::adhesion::Adhesion;
use crate::contact::adhesion::line::EdgeLine;
use crate::contact::springs::reach_for;
use crate::contact::state::Normal;
use crate::run::record::{ErrorEstimate, Record};
use crate::scene::setup::Setup;
use std::num::NonZeroUsize;

/// What a few hundred roundings leave of a state, conditioned a thousand times worse than themselves.
const ROUNDING: f64 = 1e-11;

/// Where the error of an elastic scene comes from.
#[must_use]
pub fn estimate(setup: &Setup, records: &[Record]) -> ErrorEstimate {
    with_friction(setup, normal_error(setup, records))
}

/// The error of the normal contact or of the tangential one, whichever is larger.
#[must_use]
pub fn with_friction(setup: &Setup, normal: ErrorEstimate) -> ErrorEstimate {
    shear::error_estimate(setup).filter(|tangential| tangential.relative > normal.relative).unwrap_or(normal)
}

fn normal_error(setup: &Setup, records: &[Record]) -> ErrorEstimate {
    let of = |relative, basis: &str| ErrorEstimate { relative, basis: basis.to_owned() };
    match (setup.scene.springs, &setup.scene.adhesion) {
        (Some(springs), _) => springs_error(setup, springs, records),
        (None, Some(Adhesion::Maugis(_))) => {
            of(1e-10, "direct path with roots within roots: rounding, against Maugis' equations over twelve decades")
        }
        (None, _) => {
            let edge = moved_edge(setup, records);
            if edge > ROUNDING {
                return of(
                    edge,
                    "direct path: the contact radius near a turning point, moved by the rounding of what is prescribed",
                );
            }
            of(ROUNDING, "direct path: rounding, against closed forms over twelve decades")
        }
    }
}

/// The error of a bed: second order in the width h of a spring, and what the load q(a) of an adhesive edge
/// does within one spring, q(a)h against the largest force.
fn springs_error(setup: &Setup, springs: NonZeroUsize, records: &[Record]) -> ErrorEstimate {
    let largest = |of: fn(&Normal) -> f64| records.iter().map(|record| of(&record.normal).abs()).fold(0.0, f64::max);
    let (a, force) = (largest(|normal| normal.contact_radius.unwrap_or(0.0)), largest(|normal| normal.force));
    let count = springs.get() as f64;
    let second = (17.0 / 16.0 * 2.0 / count).powi(2).max(1e-11);
    let work = if let Some(Adhesion::Jkr(jkr)) = &setup.scene.adhesion { jkr.work.si() } else { 0.0 };
    let width = reach_for(setup.profile.as_ref(), a) / count;
    let line = EdgeLine::new(setup.ground(), work);
    let edge = setup.pair.normal * line.elongation(a) * width / force.max(f64::MIN_POSITIVE);
    if edge > second {
        let basis = format!("bed of {springs} springs: the load of one spring at the adhesive edge, first order");
        return ErrorEstimate { relative: edge.min(1.0), basis };
    }
    let basis = format!("bed of {springs} springs: second order in the spring width, constant at most 4");
    ErrorEstimate { relative: second, basis }
}
