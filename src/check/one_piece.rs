//! Where the contact of a scene stays in one piece, in words.
//!
//! # Examples
//! ```
//! # #[cfg(feature = "text")] {
//! use springbed::prelude::*;
//! use springbed::check::one_piece;
//!
//! let text = r#"(shape: Paraboloid(radius: 1), bodies: (Elastic(young: 1, poisson: 0), Rigid),
//!     history: [Indent(to: 1, over: 1)])"#;
//! let plan = Notation::Ron.plan(text, &InMemory::default()).map_err(|errors| errors[0].clone())?;
//! let outcome = run(&plan, Wanted::NOTHING)?;
//! assert!(one_piece::in_words(&plan, &outcome)[0].contains("one round contact"));
//! assert!((one_piece::largest_force(&plan, &outcome) - 4.0 / 3.0).abs() < 1e-14);
//! # }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::theory::{Connection, PlaneContact, WavyParabola, Westergaard, exact_ranges};
use crate::run::record::Outcome;
use crate::scene::plan::Plan;
use crate::scene::reach;
use crate::scene::stage::Stage;
use crate::shape::{PlaneWave, PlaneWavy, Profile, Shape};
use std::f64::consts::{FRAC_PI_4, TAU};

/// Contact radii looked at, per largest contact radius of the scene.
const FARTHER: f64 = 1.5;
/// Features of a profile over which it is looked at, at least.
const FEATURES: f64 = 6.0;
/// Radii of the scan.
const STEPS: u32 = 600;
/// Ranges told.
const RANGES: usize = 4;

/// What is known about the contact of a scene staying in one piece; empty for rough shapes, whose contact never does.
#[must_use]
pub fn in_words(plan: &Plan, outcome: &Outcome) -> Vec<String> {
    let profile = match plan {
        Plan::Rough(_) | Plan::RoughImpact(_) => {
            return vec!["a rough contact falls into many pieces at any but the largest loads".to_owned()];
        }
        Plan::Pad(_) => return vec!["a pad touches with each of its springs or summits by itself".to_owned()],
        // The records count its patches.
        Plan::HalfSpace(_) => return Vec::new(),
        Plan::Plane(plane) => return sealed(plan, &plane.section, outcome),
        Plan::Round(round) => round.profile.as_ref(),
        Plan::Impact(impact) => impact.profile.as_ref(),
    };
    if let Shape::PlaneWave(wave) = &plan.scene.shape {
        let plain = !plan.adheres() && plan.relaxation().is_none();
        return vec![if plain { flattened(plan, wave) } else { "one contact per period".to_owned() }];
    }
    let radii = outcome.records.iter().filter_map(|record| record.normal.contact_radius);
    let limit = limit(profile, radii.fold(0.0, f64::max));
    let mut lines = round(profile, plan.pair.normal, limit);
    lines.extend(plane(plan, profile, limit));
    lines
}

/// When a wave is in full contact.
fn flattened(plan: &Plan, wave: &PlaneWave) -> String {
    let (modulus, amplitude, wavelength) = (plan.pair.normal, wave.amplitude.si(), wave.wavelength.si());
    let full = Westergaard { modulus, amplitude, wavelength }.full_contact_pressure();
    let force = full * wavelength * wave.width();
    format!("one contact per period; full contact from a mean pressure of {full:.4e} Pa, {force:.4e} N per period")
}

/// Loads of a wavy section at which its contact is in one piece, up to that of the scene.
fn sealed(plan: &Plan, wavy: &PlaneWavy, outcome: &Outcome) -> Vec<String> {
    let largest = largest_force(plan, outcome) / wavy.width();
    let slope = |x: f64| wavy.ripple_slope(x);
    let parabola = WavyParabola { modulus: plan.pair.normal, radius: wavy.radius.si(), slope: &slope };
    let contact = |load: f64| parabola.symmetric(load).ok().flatten();
    let least = |sure: fn(&PlaneContact) -> bool| least_load(|load| contact(load).is_some_and(|c| sure(&c)), largest);
    let Some(whole) = least(|_| true) else {
        return vec![format!("not in one piece under the largest load of the scene, {largest:.4e} N/m: it leaks")];
    };
    let from = |load: f64| if load > 0.0 { format!("from {load:.4e} N/m") } else { "at every load".to_owned() };
    let sure = least(PlaneContact::surely_connected).map_or("not".to_owned(), from);
    vec![
        format!("in one piece {} up to the largest load of the scene, {largest:.4e} N/m", from(whole)),
        format!("by the sufficient condition alone (Kudish et al. 2.18): {sure}"),
    ]
}

/// The largest force of the scene [N], found or prescribed, whether its contact was in one piece or not.
pub fn largest_force(plan: &Plan, outcome: &Outcome) -> f64 {
    let found = outcome.records.iter().map(|record| record.normal.force);
    found.chain(plan.stages.iter().filter_map(Stage::force)).fold(0.0, f64::max)
}

/// The least load from which on, up to the largest, a condition holds, to a thousandth; `None` if it does not at the largest.
fn least_load(whole: impl Fn(f64) -> bool, largest: f64) -> Option<f64> {
    // The contact can touch outside at loads between others that seal, where an end of it meets the next crest: a fine
    // scan above, and decades below.
    let even = (0..=48).map(|k| largest * (1.0 - f64::from(k) / 60.0));
    let loads: Vec<f64> = even.chain((1..50).map(|k| 0.2 * largest * 0.8_f64.powi(k))).collect();
    if !whole(largest) {
        return None;
    }
    let Some(fails) = loads.iter().position(|&load| !whole(load)) else { return Some(0.0) };
    let (mut low, mut high) = (loads[fails], loads[fails.saturating_sub(1)]);
    while high > 1.001 * low {
        let middle = (low * high).sqrt();
        *(if whole(middle) { &mut high } else { &mut low }) = middle;
    }
    Some(high)
}

/// Radius [m] up to which the profile is looked at.
fn limit(profile: &dyn Profile, largest: f64) -> f64 {
    let wanted = if largest > 0.0 { FARTHER * largest } else { profile.scale() };
    let wanted = wanted.max(FEATURES * profile.feature().unwrap_or(0.0));
    wanted.min(profile.rim().radius() * (1.0 - 1e-9))
}

/// The round contact: where g stops growing, and the loads at which the mapping is exact.
fn round(profile: &dyn Profile, modulus: f64, limit: f64) -> Vec<String> {
    // A flat does not grow either, but it does not fall.
    let fall = profile.first_fall().filter(|&fall| fall < limit);
    let Some(fall) = fall else {
        let (where_to, loads) = match profile.feature() {
            None => ("everywhere".to_owned(), "at every load"),
            Some(_) => (format!("up to {limit:.3e} m"), "at every load of the scene"),
        };
        let contact = if profile.is_plane() { "contact" } else { "round contact" };
        return vec![format!("g(x) grows {where_to}: one {contact}, the mapping is exact {loads}")];
    };
    let mut lines = vec![format!("g(x) stops growing at x = {fall:.4e} m")];
    if let Some(bound) = reach::second_contact(profile) {
        lines.push(format!(
            "without adhesion one round contact, exact mapping, up to d = {:.4e} m, F = {:.4e} N; there a ring touches outside",
            bound.depth,
            2.0 * modulus * bound.load_integral
        ));
    }
    for range in exact_ranges(profile, limit, STEPS).iter().filter(|range| range.radius.0 > fall).take(RANGES) {
        let force = |n: f64| 2.0 * modulus * n;
        lines.push(format!(
            "one round contact again from F = {:.4e} N to {:.4e} N (contact radius {:.3e} m to {:.3e} m)",
            force(range.load_integral.0),
            force(range.load_integral.1),
            range.radius.0,
            range.radius.1
        ));
    }
    lines
}

/// The same profile as a cylinder on a half-plane: the sufficient condition of Kudish et al. and the least loads.
fn plane(plan: &Plan, profile: &dyn Profile, limit: f64) -> Vec<String> {
    let Some(radius) = mean_curvature_radius(&plan.scene.shape, profile, limit) else { return Vec::new() };
    let slope = |x: f64| {
        let Shape::WavyParaboloid(wavy) = &plan.scene.shape else {
            return differenced(profile, 1e-5 * limit, x) - x / radius;
        };
        let wave_number = TAU / wavy.wavelength.si();
        wavy.amplitude.si() * wave_number * (wave_number * x).sin()
    };
    let parabola = WavyParabola { modulus: plan.pair.normal, radius, slope: &slope };
    // P = πE*c²/4R of the smooth parabola.
    let load = |c: f64| FRAC_PI_4 * plan.pair.normal * c * c / radius;
    let range = (load(0.02 * limit), load(limit / FARTHER));
    let reach = 2.0 * limit;
    let words = |wanted| match parabola.least_load(range, reach, wanted) {
        Some(least) if least <= range.0 * (1.0 + 1e-9) => "at every load looked at".to_owned(),
        Some(least) => format!("from {least:.4e} N/m on"),
        None => "not at the largest load".to_owned(),
    };
    // A profile with corners, such as a table's, has no such expansion.
    if parabola.verdict(range.1, reach).is_err() {
        return Vec::new();
    }
    vec![format!(
        "as a cylinder on a half-plane (R = {radius:.3e} m), loads up to {:.3e} N/m: one contact {}; by the sufficient condition (Kudish et al. 2.18) {}",
        range.1,
        words(Connection::InOnePiece),
        words(Connection::Sure)
    )]
}

/// Slope of a profile, differenced over a step [m].
fn differenced(profile: &dyn Profile, step: f64, x: f64) -> f64 {
    let (low, high) = ((x.abs() - step).max(0.0), x.abs() + step);
    (profile.height(high) - profile.height(low)) / (high - low) * x.signum()
}

/// Radius of the parabola under a wavy or measured profile [m]; `None` for other shapes.
fn mean_curvature_radius(shape: &Shape, profile: &dyn Profile, limit: f64) -> Option<f64> {
    if let Shape::WavyParaboloid(wavy) = shape {
        return Some(wavy.radius.si());
    }
    let (Shape::Table(_) | Shape::SmoothTable(_)) = shape else { return None };
    // Least squares of f = r²/2R: R = Σr⁴ / 2Σr²f.
    let places = (1..=STEPS).map(|k| limit * f64::from(k) / f64::from(STEPS));
    let sums = places.map(|r| (r.powi(4), r * r * profile.height(r)));
    let (fourth, mixed) = sums.fold((0.0, 0.0), |sum, term| (sum.0 + term.0, sum.1 + term.1));
    Some(0.5 * fourth / mixed).filter(|radius| radius.is_finite() && *radius > 0.0)
}
