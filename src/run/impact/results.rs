//! Named results of impacts.

use super::table::{AFTER, ImpactRow, LOST};
use crate::friction::oblique::{BallRebound, Regime};
use crate::run::named::Named;
use crate::run::record::{Field, Record};
use crate::run::unit::Unit;
use crate::scene::plan::ImpactPlan;

/// The results of a scene, in a fixed order; records, the contact radius at the greatest depth [m] and pressure are
/// those of the fastest impact.
#[must_use]
pub fn named(
    plan: &ImpactPlan,
    (rows, records): (&[ImpactRow], &[Record]),
    deepest_radius: f64,
    field: Option<&Field>,
) -> Vec<Named> {
    let mut results = match rows {
        [one] => single(one),
        many => curve(many),
    };
    let largest_radius =
        records.iter().filter_map(|record| record.normal.contact_radius).fold(deepest_radius, f64::max);
    let mut add = |quantity, unit, value| results.push(Named::number(quantity, unit, value));
    add("largest_contact_radius", Unit::METRE, largest_radius);
    if let Some(intensity) = field.and_then(|field| field.stress_intensity) {
        add("largest_stress_intensity", Unit::PASCAL_ROOT_METRE, intensity);
    }
    if plan.law.bodies().adheres() {
        let least = records.iter().map(|record| record.normal.force).fold(0.0, f64::min);
        add("pull_off_force", Unit::NEWTON, least);
    }
    if let (Some(first), Some(last)) = (records.first(), records.last()) {
        let (before, after) = (first.normal.stored.stored(), last.normal.stored.stored());
        add("work", Unit::JOULE, after - before + last.normal.dissipated);
        add("dissipated", Unit::JOULE, last.normal.dissipated);
        add("final_time", Unit::SECOND, last.time);
        add("final_indentation", Unit::METRE, last.normal.indentation.unwrap_or(0.0));
        add("final_force", Unit::NEWTON, last.normal.force);
        add("final_stored_elastic", Unit::JOULE, last.normal.stored.elastic);
        if plan.law.bodies().adheres() {
            add("final_stored_surface", Unit::JOULE, last.normal.stored.surface);
        }
    }
    results
}

fn single(row: &ImpactRow) -> Vec<Named> {
    let rebound = &row.rebound;
    let mut results = vec![Named::answer("sticks", rebound.sticks())];
    let mut add = |quantity, unit, value: Option<f64>| {
        results.extend(value.map(|value| Named::number(quantity, unit, value)));
    };
    add("restitution", Unit::ONE, Some(rebound.restitution));
    add("rebound_speed", Unit::METRE_PER_SECOND, Some(row.rebound_speed()));
    add("contact_time", Unit::SECOND, rebound.contact_time);
    add("largest_force", Unit::NEWTON, Some(rebound.greatest_force));
    add("largest_indentation", Unit::METRE, Some(rebound.greatest_depth));
    add("peak_pressure", Unit::PASCAL, row.peak_pressure);
    results.extend(row.oblique.iter().flat_map(tangential));
    results
}

/// How an oblique impact ends, how long each part of it lasts, and what it loses.
fn tangential(rebound: &BallRebound) -> Vec<Named> {
    let times = [
        Named::number("stick_time", Unit::SECOND, lasted(rebound, Regime::Stick)),
        Named::number("partial_slip_time", Unit::SECOND, lasted(rebound, Regime::Partial)),
        Named::number("gross_slip_time", Unit::SECOND, lasted(rebound, Regime::Slip)),
    ];
    let after = AFTER.iter().filter_map(|column| column.named(rebound));
    after.chain(times).chain(LOST.named(rebound)).collect()
}

/// Time [s] a regime lasts in all.
fn lasted(rebound: &BallRebound, regime: Regime) -> f64 {
    let phases = rebound.course.iter().flat_map(|course| &course.phases);
    let starts = std::iter::once(0.0).chain(phases.clone().map(|phase| phase.until));
    let parts = phases.zip(starts).filter(|(phase, _)| phase.regime == regime);
    rebound.contact_time * parts.map(|(phase, start)| phase.until - start).sum::<f64>()
}

/// What a list of speeds has beside its table.
fn curve(rows: &[ImpactRow]) -> Vec<Named> {
    let largest = |of: fn(&ImpactRow) -> f64| rows.iter().map(of).fold(0.0, f64::max);
    let least = rows.iter().map(|row| row.rebound.restitution).fold(f64::INFINITY, f64::min);
    let pressures = rows.iter().map(|row| row.peak_pressure).collect::<Option<Vec<f64>>>();
    let peak = pressures.map(|pressures| pressures.into_iter().fold(0.0, f64::max));
    let found = [
        Named::count("impacts", rows.len()),
        Named::count("sticking_impacts", rows.iter().filter(|row| row.rebound.sticks()).count()),
        Named::number("least_restitution", Unit::ONE, least),
        Named::number("largest_restitution", Unit::ONE, largest(|row| row.rebound.restitution)),
        Named::number("largest_force", Unit::NEWTON, largest(|row| row.rebound.greatest_force)),
        Named::number("largest_indentation", Unit::METRE, largest(|row| row.rebound.greatest_depth)),
    ];
    found.into_iter().chain(peak.map(|peak| Named::number("peak_pressure", Unit::PASCAL, peak))).collect()
}
