//! What an analysis of the unloading by Oliver and Pharr says of bodies that are known.

use springbed::prelude::*;
use std::f64::consts::PI;

fn told(shape: &str, bodies: &str, force: f64) -> [f64; 3] {
    let text = format!(
        "(shape: {shape}, bodies: ({bodies}, Rigid), history: [Press(to: {force}, over: 1), Press(to: 0, over: 1)])"
    );
    let plan = Notation::Ron.plan(&text, &InMemory::default()).unwrap_or_else(|errors| panic!("{}", errors[0]));
    let outcome = run(&plan, Wanted::NOTHING).unwrap();
    ["oliver_pharr_modulus_pa", "hardness_pa", "contact_depth_m"].map(|name| outcome.number(name).unwrap())
}

/// E* of an elastic ball and punch to rounding, of a cone to 0.5 % by the ε in use; hardness is the mean pressure.
#[test]
fn elastic_bodies_are_found_again() {
    let elastic = "Elastic(young: 1e9, poisson: 0)";
    let [modulus, hardness, depth] = told("Paraboloid(radius: 1e-3)", elastic, 1.0);
    // a³ = 3FR/4E*, f(a) = a²/2R.
    let a = (0.75e-3f64 / 1e9).cbrt();
    assert!((modulus / 1e9 - 1.0).abs() < 1e-12, "{modulus}");
    assert!((hardness * PI * a * a - 1.0).abs() < 1e-12 && (depth / (0.5e3 * a * a) - 1.0).abs() < 1e-12);
    let [modulus, ..] = told("FlatPunch(radius: 1e-3)", elastic, 1.0);
    assert!((modulus / 1e9 - 1.0).abs() < 1e-12, "{modulus}");
    let [modulus, ..] = told("Cone(slope: 0.1)", elastic, 1e-3);
    assert!((modulus / 1e9 - 2.0 / PI / 0.64).abs() < 1e-11, "{modulus}");
}

/// After Thornton's plastic loading the modulus falls from E* to E*/√2, for the contact is a² = Rd.
#[test]
fn a_ball_that_yields_seems_softer() {
    let plastic = "Plastic(young: 1e11, poisson: 0, yield_stress: 1e8)";
    let elastic = told("Paraboloid(radius: 1e-3)", plastic, 1e-6);
    assert!((elastic[0] / 1e11 - 1.0).abs() < 1e-12);
    let deep = told("Paraboloid(radius: 1e-3)", plastic, 1e2);
    assert!((deep[0] / 1e11 * 2f64.sqrt() - 1.0).abs() < 0.01, "{deep:?}");
    // The mean pressure over twice the area of Thornton's contact.
    assert!((deep[1] / 0.8e8 - 1.0).abs() < 0.01, "{deep:?}");
}
