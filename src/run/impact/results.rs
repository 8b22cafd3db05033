//! Named results of impacts.

use super::table::{
    AFTER, CONTACT_TIME, GREATEST_DEPTH, ImpactRow, LARGEST_FORCE, LOSS, LOST, REBOUND_SPEED, RESTITUTION, over,
};
use crate::drive::impact::Rebound;
use crate::friction::oblique::{BallRebound, Regime};
use crate::run::named::Named;
use crate::run::record::{Field, Record};
use crate::run::results::pull_off;
use crate::run::table::Column;
use crate::run::unit::Unit;
use crate::scene::plan::ImpactPlan;
use crate::shape::rough::Scatter;

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
    let adheres = plan.law.bodies().adheres();
    let found = [
        ("largest_contact_radius", Unit::METRE, Some(largest_radius)),
        ("largest_stress_intensity", Unit::PASCAL_ROOT_METRE, field.and_then(|field| field.stress_intensity)),
        ("pull_off_force", Unit::NEWTON, pull_off(records).filter(|_| adheres)),
    ];
    let told = |(quantity, unit, value): (&'static str, Unit, Option<f64>)| Some(Named::number(quantity, unit, value?));
    results.extend(found.into_iter().filter_map(told));
    results.extend(of_records(records, adheres));
    results
}

/// Work and losses of the impact of the records, and its last state.
fn of_records(records: &[Record], adheres: bool) -> Vec<Named> {
    let mut results = Vec::new();
    let mut add = |quantity, unit, value| results.push(Named::number(quantity, unit, value));
    if let (Some(first), Some(last)) = (records.first(), records.last()) {
        let (before, after) = (first.normal.stored.stored(), last.normal.stored.stored());
        add("work", Unit::JOULE, after - before + last.normal.dissipated);
        add("dissipated", Unit::JOULE, last.normal.dissipated);
        add("final_time", Unit::SECOND, last.time);
        add("final_indentation", Unit::METRE, last.normal.indentation.unwrap_or(0.0));
        add("final_force", Unit::NEWTON, last.normal.force);
        add("final_stored_elastic", Unit::JOULE, last.normal.stored.elastic);
        if adheres {
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

/// Results that scatter over random surfaces, with the names of their deviations.
const OF_SURFACES: [(Column<ImpactRow>, &str); 5] = [
    (RESTITUTION, "restitution_deviation"),
    (REBOUND_SPEED, "rebound_speed_deviation"),
    (CONTACT_TIME, "contact_time_deviation"),
    (LARGEST_FORCE, "largest_force_deviation"),
    (Column { quantity: "largest_indentation", ..GREATEST_DEPTH }, "largest_indentation_deviation"),
];

/// The results of impacts on random surfaces, of each one row per speed; records are means over the surfaces at the
/// greatest speed, `pulls` the greatest pulls [N] there of bodies that adhere.
#[must_use]
pub fn of_surfaces(surfaces: &[Vec<ImpactRow>], records: &[Record], pulls: Option<&[f64]>) -> Vec<Named> {
    let speeds = surfaces.first().map_or(0, Vec::len);
    let mut results = if speeds > 1 { curve(&means(surfaces, speeds)) } else { at_one_speed(surfaces) };
    if let Some(pull) = pulls.and_then(Scatter::of) {
        results.push(Named::number("pull_off_force", Unit::NEWTON, pull.mean));
        let deviation = Named::number("pull_off_force_deviation", Unit::NEWTON, pull.deviation);
        results.extend((surfaces.len() > 1).then_some(deviation));
    }
    results.extend(of_records(records, pulls.is_some()));
    results
}

/// Means over random surfaces, and how far they scatter; the mass `sticks` if it comes free of none.
fn at_one_speed(surfaces: &[Vec<ImpactRow>]) -> Vec<Named> {
    let stuck = surfaces.iter().flatten().filter(|row| row.rebound.sticks()).count();
    let many = surfaces.len() > 1;
    let mut results = vec![Named::answer("sticks", stuck == surfaces.len())];
    results.extend(many.then_some(Named::count("sticking_members", stuck)));
    for (column, deviation) in &OF_SURFACES {
        let Some(scatter) = over(surfaces, 0, column) else { continue };
        results.push(Named::number(column.quantity, column.unit, scatter.mean));
        results.extend(many.then_some(Named::number(deviation, column.unit, scatter.deviation)));
    }
    results
}

/// The mean impact over random surfaces at each speed.
fn means(surfaces: &[Vec<ImpactRow>], speeds: usize) -> Vec<ImpactRow> {
    let row = |k: usize| {
        let mean = |column| over(surfaces, k, column).map(|scatter| scatter.mean);
        let first = surfaces.first()?.get(k)?;
        let rebound = Rebound {
            contact_time: mean(&CONTACT_TIME),
            restitution: mean(&RESTITUTION)?,
            greatest_depth: mean(&GREATEST_DEPTH)?,
            greatest_force: mean(&LARGEST_FORCE)?,
            lost: mean(&LOSS)?,
            error: first.rebound.error,
        };
        Some(ImpactRow { rebound, ..first.clone() })
    };
    (0..speeds).filter_map(row).collect()
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
