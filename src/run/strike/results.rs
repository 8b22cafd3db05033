//! Named results of impacts.

use crate::friction::oblique::{BallRebound, Regime};
use crate::run::record::{Field, ImpactRow, Impacts, Record, Value};
use crate::scene::setup::Setup;

/// The results of a scene, in a fixed order; `shown` are the records and the pressure of the fastest impact.
#[must_use]
pub fn named(
    setup: &Setup,
    impacts: &Impacts,
    (records, field): (&[Record], Option<&Field>),
) -> Vec<(&'static str, Value)> {
    let mut results = match &impacts.rows[..] {
        [one] => single(one),
        many => curve(many),
    };
    let largest = |of: fn(&Record) -> f64| records.iter().map(of).fold(0.0, f64::max);
    let mut add = |name, value: f64| results.push((name, Value::Number(value)));
    add("largest_contact_radius_m", largest(|record| record.normal.contact_radius.unwrap_or(0.0)));
    if let Some(intensity) = field.and_then(|field| field.stress_intensity) {
        add("largest_stress_intensity_pa_sqrt_m", intensity);
    }
    if setup.scene.adhesion.is_some() {
        let least = records.iter().map(|record| record.normal.force).fold(0.0, f64::min);
        add("pull_off_force_n", least);
    }
    if let (Some(first), Some(last)) = (records.first(), records.last()) {
        let (before, after) = (first.normal.stored.stored(), last.normal.stored.stored());
        add("work_j", after - before + last.normal.dissipated);
        add("dissipated_j", last.normal.dissipated);
        add("final_time_s", last.time);
        add("final_indentation_m", last.normal.indentation.unwrap_or(0.0));
        add("final_force_n", last.normal.force);
        add("final_stored_elastic_j", last.normal.stored.elastic);
        if setup.scene.adhesion.is_some() {
            add("final_stored_surface_j", last.normal.stored.surface);
        }
    }
    results
}

fn single(row: &ImpactRow) -> Vec<(&'static str, Value)> {
    let rebound = &row.rebound;
    let mut results = vec![("sticks", Value::Answer(rebound.sticks()))];
    let mut add = |name, value: Option<f64>| results.extend(value.map(|value| (name, Value::Number(value))));
    add("restitution", Some(rebound.restitution));
    add("rebound_speed_m_per_s", Some(row.rebound_speed()));
    add("contact_time_s", rebound.contact_time);
    add("largest_force_n", Some(rebound.greatest_force));
    add("largest_indentation_m", Some(rebound.greatest_depth));
    add("peak_pressure_pa", row.peak_pressure);
    results.extend(row.oblique.iter().flat_map(tangential));
    results
}

fn tangential(rebound: &BallRebound) -> Vec<(&'static str, Value)> {
    let lasted = |wanted: Regime| {
        let starts = std::iter::once(0.0);
        let phases = rebound.course.iter().flat_map(|course| &course.phases);
        let starts = starts.chain(phases.clone().map(|phase| phase.until));
        let parts = phases.zip(starts).filter(|(phase, _)| phase.regime == wanted);
        rebound.contact_time * parts.map(|(phase, start)| phase.until - start).sum::<f64>()
    };
    let restitution = rebound.tangential_restitution;
    let numbers = [
        ("rebound_angle_rad", rebound.angle),
        ("rebound_spin_rad_per_s", rebound.flight.spin),
        ("tangential_restitution", restitution),
        ("impulse_ratio", rebound.impulse_ratio),
        ("local_incidence", rebound.psi.0),
        ("local_rebound", rebound.psi.1),
        ("stick_time_s", lasted(Regime::Stick)),
        ("partial_slip_time_s", lasted(Regime::Partial)),
        ("gross_slip_time_s", lasted(Regime::Slip)),
        ("friction_dissipated_j", rebound.dissipated),
    ];
    numbers
        .into_iter()
        .filter(|(_, value)| value.is_finite())
        .map(|(name, value)| (name, Value::Number(value)))
        .collect()
}

/// What a list of speeds has beside its table.
fn curve(rows: &[ImpactRow]) -> Vec<(&'static str, Value)> {
    let largest = |of: fn(&ImpactRow) -> f64| rows.iter().map(of).fold(0.0, f64::max);
    let least = rows.iter().map(|row| row.rebound.restitution).fold(f64::INFINITY, f64::min);
    vec![
        ("impacts", Value::Count(rows.len())),
        ("sticking_impacts", Value::Count(rows.iter().filter(|row| row.rebound.sticks()).count())),
        ("least_restitution", Value::Number(least)),
        ("largest_restitution", Value::Number(largest(|row| row.rebound.restitution))),
        ("largest_force_n", Value::Number(largest(|row| row.rebound.greatest_force))),
        ("largest_indentation_m", Value::Number(largest(|row| row.rebound.greatest_depth))),
    ]
    .into_iter()
    .chain(rows.iter().map(|row| row.peak_pressure).collect::<Option<Vec<f64>>>().map(peak))
    .collect()
}

fn peak(pressures: Vec<f64>) -> (&'static str, Value) {
    ("peak_pressure_pa", Value::Number(pressures.into_iter().fold(0.0, f64::max)))
}
