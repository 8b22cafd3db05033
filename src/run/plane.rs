//! Wavy sections on the half-plane, by their Chebyshev series.

use super::follow::follow;
use super::results::{self, Pressures};
use super::{SimulationError, Wanted};
use crate::contact::model::ContactModel;
use crate::contact::plane::WavyContact;
use crate::run::named::{Finding, Named};
use crate::run::record::{ErrorEstimate, Outcome, Record};
use crate::run::unit::Unit;
use crate::scene::plan::PlanePlan;

/// Runs a scene with a wavy section.
pub(super) fn run(plan: &PlanePlan, wanted: Wanted) -> Result<Outcome, SimulationError> {
    let contact = WavyContact::new(plan.section.clone(), plan.pair.normal);
    let (mut outcome, broken) = outcome(plan, Box::new(contact), wanted)?;
    outcome.results.push(Named::answer("in_one_piece", broken.is_none()));
    outcome.results.push(Named::number("rms_slope", Unit::ONE, plan.section.rms_slope()));
    if let Some(force) = broken {
        outcome.warnings.push(format!(
            "under {force:.4e} N the contact is not in one piece, as under other forces that are missing here: it leaks"
        ));
    }
    Ok(outcome)
}

/// Why an outcome has nothing to show: none of its loaded states is in one piece.
#[must_use]
pub fn in_pieces(outcome: &Outcome) -> Option<&'static str> {
    let broken = outcome.named("in_one_piece") == Some(Finding::Answer(false));
    let unknown = broken && outcome.records.iter().all(|record| record.normal.force <= 0.0);
    unknown.then_some(
        "shape: under no force of the history is the contact in one piece, and one in several pieces is not computed: expected longer or lower waves, or a greater force",
    )
}

/// A state of a contact in one piece, or of none at all.
fn is_known(record: &Record) -> bool {
    record.normal.contact_radius.is_some()
}

/// The outcome of a plane contact, and the largest force [N] under which it is not in one piece.
fn outcome(
    plan: &PlanePlan,
    contact: Box<dyn ContactModel>,
    wanted: Wanted,
) -> Result<(Outcome, Option<f64>), SimulationError> {
    let run = follow(plan, contact, wanted)?;
    let (records, broken): (Vec<_>, Vec<_>) = run.records.into_iter().partition(is_known);
    let outcome = Outcome {
        map: None,
        results: results::named(None, &records, &Pressures { fields: &run.fields, at_greatest_force: None }),
        records,
        fields: run.fields,
        tables: Vec::new(),
        error_estimate: ErrorEstimate {
            relative: 1e-11,
            basis: "Chebyshev series of the half-plane: rounding".to_owned(),
        },
        warnings: run.notes,
        plan: plan.parts(),
    };
    Ok((outcome, broken.iter().map(|record| record.normal.force).reduce(f64::max)))
}
