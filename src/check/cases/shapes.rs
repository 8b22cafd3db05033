//! Indenter shapes against closed forms and against each other.

use crate::check::case::{Attempt, Case, Pairs, Proof};
use crate::check::closed_forms::{self, ClosedForm};
use crate::check::sketch::si;
use crate::input::table::InMemory;
use crate::shape::{
    Cone, Measured, Profile, RoundedCone, RoundedPunch, Sphere, TruncatedCone, TruncatedParaboloid, WavyParaboloid,
};
use std::path::Path;

const ROUNDING: &str = "closed forms in other variables, a few dozen roundings";
const FORCE_ONLY: &str = "indentation, force and contact radius; the fields are in the property tests";

pub(super) const CASES: &[Case] = &[
    Case::new(
        "shape/sphere",
        Proof::Rounding,
        5e-14,
        "closed form by the rapidity: rounding of a counts 1/(1 − a/R) = 200 times at t = 3",
    )
    .weak(FORCE_ONLY)
    .by(sphere),
    Case::new("shape/truncated cone", Proof::Rounding, 2e-14, ROUNDING).weak(FORCE_ONLY).by(truncated_cone),
    Case::new("shape/truncated paraboloid", Proof::Rounding, 2e-14, ROUNDING).weak(FORCE_ONLY).by(truncated_paraboloid),
    Case::new("shape/rounded cone", Proof::Rounding, 2e-14, ROUNDING).weak(FORCE_ONLY).by(rounded_cone),
    Case::new(
        "shape/rounded punch",
        Proof::Rounding,
        2e-13,
        "the closed form in the angle loses φ⁻² digits at φ = 0.1",
    )
    .weak(FORCE_ONLY)
    .by(rounded_punch),
    Case::new("shape/waviness", Proof::Rounding, 1e-15, "a reference with sixteen digits")
        .weak("one value of g; the transform is in the property tests")
        .by(waviness),
    Case::new(
        "shape/table of a cone",
        Proof::Rounding,
        1e-13,
        "points of a cone give the cone; heights are rounded over 40 steps",
    )
    .weak("the interpolant is exact here; between points of another shape it is not")
    .by(table_of_a_cone),
];

/// Angles φ from a contact just beyond the kink to one a hundred times as large.
const ANGLES: [f64; 5] = [0.1, 0.4, 0.9, 1.3, 1.56];

/// Depth, force and edge of a profile against a closed form.
fn deviations(profile: &dyn Profile, right: ClosedForm) -> Attempt<Pairs> {
    Ok(vec![
        (profile.reduced(right.radius), right.indentation),
        (2.0 * profile.load_integral(right.radius), right.force),
        (profile.edge(right.indentation).ok_or("the depth leaves the profile")?, right.radius),
    ])
}

fn over_angles(profile: &dyn Profile, right: impl Fn(f64) -> ClosedForm) -> Attempt<Pairs> {
    Ok(ANGLES.iter().map(|&angle| deviations(profile, right(angle))).collect::<Attempt<Vec<_>>>()?.concat())
}

fn sphere() -> Attempt<Pairs> {
    let shape = Sphere { radius: si(2.0)? };
    let mut pairs = Vec::new();
    for rapidity in [0.4, 0.8, 2.0, 3.0] {
        pairs.extend(deviations(&shape, closed_forms::sphere(2.0, rapidity))?);
    }
    let series = [1e-9, 1e-4, 0.01, 0.3, 1.2];
    pairs.extend(series.map(|a| (2.0 * shape.load_integral(a), closed_forms::sphere_force_series(2.0, a))));
    Ok(pairs)
}

fn truncated_cone() -> Attempt<Pairs> {
    let shape = TruncatedCone { flat_radius: si(0.3)?, slope: si(0.2)? };
    over_angles(&shape, |angle| closed_forms::truncated_cone(0.3, 0.2, angle))
}

fn truncated_paraboloid() -> Attempt<Pairs> {
    let shape = TruncatedParaboloid { flat_radius: si(0.3)?, radius: si(1.7)? };
    over_angles(&shape, |angle| closed_forms::truncated_paraboloid(0.3, 1.7, angle))
}

fn rounded_cone() -> Attempt<Pairs> {
    let shape = RoundedCone { radius: si(1.7)?, slope: si(0.2)? };
    over_angles(&shape, |angle| closed_forms::rounded_cone(1.7, 0.2, angle))
}

fn rounded_punch() -> Attempt<Pairs> {
    let shape = RoundedPunch { flat_radius: si(0.3)?, edge_radius: si(1.7)? };
    over_angles(&shape, |angle| closed_forms::rounded_punch(0.3, 1.7, angle))
}

fn waviness() -> Attempt<Pairs> {
    let shape = WavyParaboloid { radius: si(1.0)?, amplitude: si(0.01)?, wavelength: si(0.25)? };
    Ok(vec![(shape.reduced(0.6), 0.418_075_937_086_176_2)])
}

fn table_of_a_cone() -> Attempt<Pairs> {
    let radii: Vec<f64> = (0..=40).map(|k| f64::from(k) / 40.0).collect();
    let heights: Vec<f64> = radii.iter().map(|r| 0.2 * r).collect();
    let tables = InMemory::default().with("cone.csv", &[("radius_m", &radii), ("height_m", &heights)]);
    let table = Measured::read(Path::new("cone.csv"), &tables)?;
    let cone = Cone { slope: si(0.2)? };
    let mut pairs = Vec::new();
    for a in [0.01, 0.33, 0.5, 0.99] {
        pairs.extend(deviations(&table, closed_forms::cone(0.2, cone.reduced(a)))?);
        pairs.push((table.pressure_integral(0.3 * a, a), closed_forms::cone_pressure(0.2, a, 0.3 * a)));
    }
    Ok(pairs)
}
