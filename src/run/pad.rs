//! Pads of scattered heights.

use super::follow::{Run, follow};
use super::results::{self, Pressures};
use super::{SimulationError, Wanted};
use crate::contact::pad::{Element, Pad};
use crate::contact::state::Normal;
use crate::run::named::Named;
use crate::run::record::{ErrorEstimate, Outcome, Record};
use crate::run::unit::Unit;
use crate::scene::plan::PadPlan;

/// Share of the area of a pad beyond which its summits feel each other.
const CROWDED: f64 = 0.1;

/// Runs a scene with a pad.
pub(super) fn run(plan: &PadPlan, wanted: Wanted) -> Result<Outcome, SimulationError> {
    let run = follow(plan, Box::new(Pad::new(plan.bed)), wanted)?;
    let mut results = results::named(None, &run.records, &Pressures { fields: &run.fields, at_greatest_force: None });
    results.extend(joined(&run.records));
    results.extend(pulled(plan, &run));
    let relative = match plan.bed.element {
        Element::Spring(_) => 1e-13,
        Element::Summit(_) => 1e-11,
    };
    let basis = "sums over normal heights: rounding; of a pad with few springs or summits the scatter of its heights comes on top";
    Ok(Outcome {
        map: None,
        results,
        fields: Vec::new(),
        tables: Vec::new(),
        error_estimate: ErrorEstimate { relative, basis: basis.to_owned() },
        warnings: run.notes.iter().cloned().chain(crowded(plan, &run.records)).collect(),
        plan: plan.parts(),
        records: run.records,
    })
}

/// The most that is joined.
fn joined(records: &[Record]) -> impl Iterator<Item = Named> {
    let share = records.iter().filter_map(|record| Some(record.joined?.share)).reduce(f64::max);
    let area = largest_area(records);
    let share = share.map(|share| Named::number("largest_joined_share", Unit::ONE, share));
    share.into_iter().chain(area.map(|area| Named::number("largest_area", Unit::SQUARE_METRE, area)))
}

fn largest_area(records: &[Record]) -> Option<f64> {
    records.iter().filter_map(|record| record.joined?.area).reduce(f64::max)
}

/// What adhesion does: the pull the pad has held, over its preload, and the greatest it can hold.
fn pulled(plan: &PadPlan, run: &Run) -> Vec<Named> {
    let hold = plan.bed.hold();
    if hold.leaves <= 0.0 {
        return Vec::new();
    }
    let in_jumps = run.jumps().iter().flat_map(|(before, after)| [before, after]);
    let forces = |state: &Normal| state.force;
    let least =
        in_jumps.map(forces).chain(results::pull_off(&run.records)).reduce(f64::min).filter(|least| *least < 0.0);
    let preload = run.records.iter().map(|record| record.normal.force).reduce(f64::max).filter(|load| *load > 0.0);
    let found = [
        ("pull_off_force", Unit::NEWTON, least),
        ("pull_off_over_preload", Unit::ONE, least.zip(preload).map(|(least, preload)| -least / preload)),
        ("greatest_pull_off_force", Unit::NEWTON, Some(plan.bed.greatest_pull())),
        ("stretch_at_break", Unit::METRE, Some(hold.leaves)),
        ("stretch_over_deviation", Unit::ONE, Some(hold.leaves / plan.bed.deviation)),
    ];
    found.into_iter().filter_map(|(name, unit, number)| Some(Named::number(name, unit, number?))).collect()
}

/// Summits that are taken as alone although they are not.
fn crowded(plan: &PadPlan, records: &[Record]) -> Option<String> {
    let share = largest_area(records)? / plan.pad.area();
    (share > CROWDED).then(|| {
        format!(
            "the summits touch over {share:.2} of the area: what one presses in its neighbours feel, which summits that stand for themselves leave out"
        )
    })
}
