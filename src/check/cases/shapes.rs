//! Indenter shapes against closed forms and against each other.

use crate::check::case::{Case, Proof, worst};
use crate::check::closed_forms::{self, Contact};
use crate::input::quantity::{Amplitude, Length, Positive, QuantityError};
use crate::input::table::InMemory;
use crate::shape::{
    Cone, Measured, Profile, RoundedCone, RoundedPunch, Sphere, TruncatedCone, TruncatedParaboloid, WavyParaboloid,
};
use std::path::Path;

const ROUNDING: &str = "closed forms in other variables, a few dozen roundings";
const FORCE_ONLY: &str = "indentation, force and contact radius; the fields are in the property tests";

pub(super) const CASES: &[Case] = &[
    Case {
        name: "shape/sphere",
        proof: Proof::Rounding,
        bound: 5e-14,
        reason: "closed form by the rapidity: rounding of a counts 1/(1 − a/R) = 200 times at t = 3",
        weak: FORCE_ONLY,
        error: || sphere().unwrap_or(f64::NAN),
    },
    Case {
        name: "shape/truncated cone",
        proof: Proof::Rounding,
        bound: 2e-14,
        reason: ROUNDING,
        weak: FORCE_ONLY,
        error: || truncated_cone().unwrap_or(f64::NAN),
    },
    Case {
        name: "shape/truncated paraboloid",
        proof: Proof::Rounding,
        bound: 2e-14,
        reason: ROUNDING,
        weak: FORCE_ONLY,
        error: || truncated_paraboloid().unwrap_or(f64::NAN),
    },
    Case {
        name: "shape/rounded cone",
        proof: Proof::Rounding,
        bound: 2e-14,
        reason: ROUNDING,
        weak: FORCE_ONLY,
        error: || rounded_cone().unwrap_or(f64::NAN),
    },
    Case {
        name: "shape/rounded punch",
        proof: Proof::Rounding,
        bound: 2e-13,
        reason: "the closed form in the angle loses φ⁻² digits at φ = 0.1",
        weak: FORCE_ONLY,
        error: || rounded_punch().unwrap_or(f64::NAN),
    },
    Case {
        name: "shape/waviness",
        proof: Proof::Rounding,
        bound: 1e-15,
        reason: "a reference with sixteen digits",
        weak: "one value of g; the transform is in the property tests",
        error: || waviness().unwrap_or(f64::NAN),
    },
    Case {
        name: "shape/table of a cone",
        proof: Proof::Rounding,
        bound: 1e-13,
        reason: "points of a cone give the cone; heights are rounded over 40 steps",
        weak: "the interpolant is exact here; between points of another shape it is not",
        error: || table_of_a_cone().unwrap_or(f64::NAN),
    },
];

/// Angles φ from a contact just beyond the kink to one a hundred times as large.
const ANGLES: [f64; 5] = [0.1, 0.4, 0.9, 1.3, 1.56];

/// Depth, force and edge of a profile against a closed form.
fn deviations(profile: &dyn Profile, right: Contact) -> Option<Vec<(f64, f64)>> {
    Some(vec![
        (profile.reduced(right.radius), right.indentation),
        (2.0 * profile.load_integral(right.radius), right.force),
        (profile.edge(right.indentation)?, right.radius),
    ])
}

fn over_angles(profile: &dyn Profile, right: impl Fn(f64) -> Contact) -> Option<f64> {
    let all: Option<Vec<_>> = ANGLES.iter().map(|&angle| deviations(profile, right(angle))).collect();
    Some(worst(&all?.concat()))
}

fn length(si: f64) -> Option<Length> {
    Length::new(si).ok()
}

fn number(value: f64) -> Option<Positive> {
    let checked: Result<Positive, QuantityError> = Positive::new(value);
    checked.ok()
}

fn sphere() -> Option<f64> {
    let shape = Sphere { radius: length(2.0)? };
    let mut pairs = Vec::new();
    for rapidity in [0.4, 0.8, 2.0, 3.0] {
        pairs.extend(deviations(&shape, closed_forms::sphere(2.0, rapidity))?);
    }
    for a in [1e-9, 1e-4, 0.01, 0.3, 1.2] {
        pairs.push((2.0 * shape.load_integral(a), closed_forms::sphere_force_series(2.0, a)));
    }
    Some(worst(&pairs))
}

fn truncated_cone() -> Option<f64> {
    let shape = TruncatedCone { flat_radius: length(0.3)?, slope: number(0.2)? };
    over_angles(&shape, |angle| closed_forms::truncated_cone(0.3, 0.2, angle))
}

fn truncated_paraboloid() -> Option<f64> {
    let shape = TruncatedParaboloid { flat_radius: length(0.3)?, radius: length(1.7)? };
    over_angles(&shape, |angle| closed_forms::truncated_paraboloid(0.3, 1.7, angle))
}

fn rounded_cone() -> Option<f64> {
    let shape = RoundedCone { radius: length(1.7)?, slope: number(0.2)? };
    over_angles(&shape, |angle| closed_forms::rounded_cone(1.7, 0.2, angle))
}

fn rounded_punch() -> Option<f64> {
    let shape = RoundedPunch { flat_radius: length(0.3)?, edge_radius: length(1.7)? };
    over_angles(&shape, |angle| closed_forms::rounded_punch(0.3, 1.7, angle))
}

fn waviness() -> Option<f64> {
    let amplitude = Amplitude::new(0.01).ok()?;
    let shape = WavyParaboloid { radius: length(1.0)?, amplitude, wavelength: length(0.25)? };
    Some(worst(&[(shape.reduced(0.6), 0.418_075_937_086_176_2)]))
}

fn table_of_a_cone() -> Option<f64> {
    let radii: Vec<f64> = (0..=40).map(|k| f64::from(k) / 40.0).collect();
    let heights: Vec<f64> = radii.iter().map(|r| 0.2 * r).collect();
    let tables = InMemory::default().with("cone.csv", &[("radius_m", &radii), ("height_m", &heights)]);
    let table = Measured::read(Path::new("cone.csv"), &tables).ok()?;
    let cone = Cone { slope: number(0.2)? };
    let mut pairs = Vec::new();
    for a in [0.01, 0.33, 0.5, 0.99] {
        pairs.extend(deviations(&table, closed_forms::cone(0.2, cone.reduced(a)))?);
        pairs.push((table.pressure_integral(0.3 * a, a), closed_forms::cone_pressure(0.2, a, 0.3 * a)));
    }
    Some(worst(&pairs))
}
