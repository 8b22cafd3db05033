//! Named results of a run.

use super::shear;
use crate::friction::Friction;
use crate::friction::peeling::TangentialLoad;
use crate::friction::state::Tangential;
use crate::run::record::{Ensemble, EnsembleRow, Field, Record, Value};
use crate::scene::setup::Setup;
use crate::scene::stage::Path;
use crate::scene::surface::Surface;

/// The results the scene has, in a fixed order.
#[must_use]
pub fn named(setup: &Setup, records: &[Record], fields: &[Field]) -> Vec<(&'static str, Value)> {
    let largest = |of: fn(&Record) -> f64| records.iter().map(of).fold(f64::NEG_INFINITY, f64::max);
    let mut results = vec![
        ("largest_force_n", Value::Number(largest(|record| record.normal.force))),
        (
            "largest_indentation_m",
            Value::Number(largest(|record| record.normal.indentation.unwrap_or(f64::NEG_INFINITY))),
        ),
    ];
    let mut add = |name, value: Option<f64>| results.extend(value.map(|value| (name, Value::Number(value))));
    add("largest_contact_radius_m", records.iter().filter_map(|record| record.normal.contact_radius).reduce(f64::max));
    add("peak_pressure_pa", peak_pressure(fields));
    let intensity = fields.iter().filter_map(|field| field.stress_intensity);
    add("largest_stress_intensity_pa_sqrt_m", intensity.max_by(|x, y| x.abs().total_cmp(&y.abs())));
    if setup.scene.adhesion.is_some() {
        let least = records.iter().map(|record| record.normal.force).fold(f64::INFINITY, f64::min);
        add("pull_off_force_n", (least < 0.0).then_some(least));
    }
    if let (Some(first), Some(last)) = (records.first(), records.last()) {
        let stored = last.normal.stored.stored();
        let initial = first.normal.stored.stored();
        add("work_j", Some(stored - initial + last.normal.dissipated));
        add("dissipated_j", Some(last.normal.dissipated));
        add("final_time_s", Some(last.time));
        add("final_indentation_m", last.normal.indentation);
        add("final_force_n", Some(last.normal.force));
        add("final_contact_radius_m", last.normal.contact_radius);
        add("final_stored_elastic_j", Some(last.normal.stored.elastic));
        if setup.scene.adhesion.is_some() && setup.relaxation.is_none() {
            add("final_stored_surface_j", Some(last.normal.stored.surface));
        }
    }
    results.extend(rubbing(setup, records));
    results
}

/// Results of a rough shape; of an ensemble, those of the means with their deviation.
#[must_use]
pub fn rough(surface: &Surface, records: &[Record], ensemble: Option<&Ensemble>) -> Vec<(&'static str, Value)> {
    let largest = |of: fn(&Record) -> f64| Value::Number(records.iter().map(of).fold(f64::NEG_INFINITY, f64::max));
    let roughness = surface.roughness();
    let mut results = vec![
        ("largest_force_n", largest(|record| record.normal.force)),
        ("largest_indentation_m", largest(|record| record.normal.indentation.unwrap_or(f64::NEG_INFINITY))),
        ("largest_stiffness_n_per_m", largest(|record| record.normal.stiffness)),
        ("largest_stored_elastic_j", largest(|record| record.normal.stored.elastic)),
        ("rms_height_m", Value::Number(roughness.rms_height)),
        ("rms_slope", Value::Number(roughness.rms_slope)),
        ("rms_curvature_per_m", Value::Number(roughness.rms_curvature)),
    ];
    if roughness.peak_to_valley.is_finite() {
        results.push(("peak_to_valley_m", Value::Number(roughness.peak_to_valley)));
    }
    if let Some(ensemble) = ensemble {
        let deviation = |of: fn(&EnsembleRow) -> f64| Value::Number(ensemble.rows.iter().map(of).fold(0.0, f64::max));
        results.push(("members", Value::Count(ensemble.members)));
        results.push(("largest_force_deviation_n", deviation(|row| row.force.deviation)));
        results.push(("largest_indentation_deviation_m", deviation(|row| row.indentation.deviation)));
        results.push(("largest_stiffness_deviation_n_per_m", deviation(|row| row.stiffness.deviation)));
    }
    results
}

/// What friction adds.
fn rubbing(setup: &Setup, records: &[Record]) -> Vec<(&'static str, Value)> {
    let Some(last) = records.last().and_then(|record| record.tangential) else { return Vec::new() };
    let force = records.iter().filter_map(|record| Some(record.tangential?.force.abs()));
    let mut results = vec![
        ("largest_tangential_force_n", force.fold(0.0, f64::max)),
        ("final_slide_m", last.slide),
        ("final_tangential_force_n", last.force),
        ("final_stick_radius_m", last.stick_radius),
        ("final_tangential_stiffness_n_per_m", last.stiffness),
    ];
    results.extend(last.stored.map(|energy| ("final_stored_tangential_j", energy)));
    results.extend(last.dissipated.map(|energy| ("friction_dissipated_j", energy)));
    results.extend(per_cycle(setup, records).map(|lost| ("dissipated_per_cycle_j", lost)));
    results.extend(coefficient(setup, records).map(|ratio| ("friction_coefficient", ratio)));
    let numbers = results.into_iter().map(|(name, value)| (name, Value::Number(value)));
    numbers.chain(peeled(setup, records)).collect()
}

/// F_x/F of the last slide under a law of gross sliding.
fn coefficient(setup: &Setup, records: &[Record]) -> Option<f64> {
    if matches!(setup.scene.friction, None | Some(Friction::Coulomb(_))) {
        return None;
    }
    let slides = |record: &Record| {
        let rubs = record.tangential.filter(|state| state.stick_radius <= 0.0 && state.force.abs() > 0.0)?;
        (record.normal.force > 0.0).then_some(rubs.force.abs() / record.normal.force)
    };
    records.iter().rev().find_map(slides)
}

/// What sliding does to an adhesive contact: A/A_JKR at the last slide and at its least, what is left
/// without adhesion, and the tangential force at which the edge would jump under that force.
fn peeled(setup: &Setup, records: &[Record]) -> Vec<(&'static str, Value)> {
    let ratio = |record: &Record| record.tangential.and_then(|state| state.area_ratio);
    let last = records.iter().rev().find_map(ratio);
    let sheared = records.iter().filter(|record| ratio(record).is_some());
    let least = sheared.min_by(|x, y| ratio(x).unwrap_or(1.0).total_cmp(&ratio(y).unwrap_or(1.0)));
    let (Some(contact), Some(last), Some(least)) = (shear::sheared(setup), last, least) else { return Vec::new() };
    let (force, radius) = (least.normal.force, least.normal.contact_radius.unwrap_or(0.0));
    let mut results = vec![("area_ratio", last), ("least_area_ratio", ratio(least).unwrap_or(last))];
    let rest = contact.under(force, TangentialLoad::Force(0.0)).map(|state| state.contact_radius);
    if let (Ok(plain), Ok(rest)) = (contact.plain_radius(force), rest) {
        results.push(("hertz_area_ratio", (plain / rest).powi(2)));
    }
    let critical = contact.critical(force);
    results.extend(critical.iter().map(|state| ("critical_tangential_force_n", state.tangential_force)));
    let peels = critical.map(|state| ("peels", Value::Answer(radius <= state.contact_radius)));
    results.into_iter().map(|(name, value)| (name, Value::Number(value))).chain(peels).collect()
}

/// Energy [J] lost from one turning point of the last `Shake` to the next but one: a closed loop.
fn per_cycle(setup: &Setup, records: &[Record]) -> Option<f64> {
    let entry = setup.stages.iter().rev().find(|stage| matches!(stage.tangential, Path::Wave { .. }))?.entry;
    let shaken = records.iter().filter(|record| record.entry == entry).filter_map(|record| record.tangential);
    let shaken: Vec<Tangential> = shaken.collect();
    let turns = |three: &&[Tangential]| (three[1].slide - three[0].slide) * (three[2].slide - three[1].slide) < 0.0;
    let lost: Vec<f64> = shaken.windows(3).filter(turns).filter_map(|three| three[1].dissipated).collect();
    match lost[..] {
        [.., first, _, last] => Some(last - first),
        _ => None,
    }
}

/// The largest pressure of all fields, if it is finite: a sharp edge or apex has none.
fn peak_pressure(fields: &[Field]) -> Option<f64> {
    let compressed = |field: &&Field| field.stress_intensity.is_none_or(|intensity| intensity > 0.0);
    if fields.iter().any(|field| !compressed(&field)) {
        return None;
    }
    let all_known = |field: &Field| field.rows.first().is_some_and(|row| row.pressure.is_some());
    if !fields.iter().all(all_known) {
        return None;
    }
    let pressures = fields.iter().flat_map(|field| field.rows.iter().filter_map(|row| row.pressure));
    pressures.reduce(f64::max)
}
