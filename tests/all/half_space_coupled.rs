//! Pressures and shear found together in scenes: against those found apart where they are, and what is lost where they are not.

use springbed::prelude::*;
use springbed::run::record::Outcome;

fn outcome(bodies: &str, tractions: &str) -> Outcome {
    let text = format!(
        "(shape: Paraboloid(radius: 1), bodies: {bodies}, friction: Coulomb(coefficient: 0.3), steps: 4,
        solver: HalfSpace(grid: 48, window: 0.3{tractions}),
        history: [Indent(to: 0.01, over: 1), Slide(to: 0.0015, over: 1), Slide(to: -0.005, over: 1), Indent(to: 0, over: 1)])"
    );
    let plan = Notation::Ron.plan(&text, &InMemory::default()).unwrap_or_else(|errors| panic!("{text}: {}", errors[0]));
    run(&plan, Wanted { fields: true, ..Wanted::NOTHING }).unwrap_or_else(|error| panic!("{text}: {error}"))
}

/// Equal bodies press as without friction, and ν = 0, G* = E*, shears as Cattaneo has it, which is what differences of
/// pressures say; pixels miss (Δ/a)²/8, 0.05 % each. Under a depth that stays each step is exact, whatever its length.
#[test]
fn elastically_similar_bodies_slip_as_without_coupling() {
    let equal = "(Elastic(young: 1, poisson: 0), Elastic(young: 1, poisson: 0))";
    let (apart, together) = (outcome(equal, ""), outcome(equal, ", tractions: Coupled"));
    assert_eq!(apart.records.len(), together.records.len());
    for (one, other) in apart.records.iter().zip(&together.records).take(13) {
        assert!((one.normal.force - other.normal.force).abs() <= 1e-5 * 7e-4, "{one:?} {other:?}");
        let (one, other) = (one.tangential.unwrap(), other.tangential.unwrap());
        assert!((one.force - other.force).abs() <= 2e-3 * 0.3 * 7e-4, "{one:?} {other:?}");
        assert!(
            (one.dissipated.unwrap() - other.dissipated.unwrap()).abs() < 0.02 * 1e-6 + 0.02 * one.dissipated.unwrap()
        );
    }
    assert!(together.warnings.iter().all(|warning| !warning.contains("Dundurs")), "{:?}", together.warnings);
}

/// A compressible body on a rigid one slips while it is pressed without a slide, is stiffer for its shear, by less than where all
/// sticks, ln 3 for ν = 0, and slides at μF, less what is turned aside where the surface is still drawn in.
#[test]
fn what_presses_draws_the_surface_along() {
    let cork = "(Elastic(young: 1, poisson: 0), Rigid)";
    let (apart, together) = (outcome(cork, ""), outcome(cork, ", tractions: Coupled"));
    let ratio = together.records[4].normal.force / apart.records[4].normal.force;
    assert!(ratio > 1.01 && ratio < 3.0_f64.ln(), "{ratio}");
    let pressed = together.records[4].tangential.unwrap();
    assert!(pressed.force.abs() < 1e-9 && pressed.dissipated.unwrap() > 0.0 && pressed.stick_radius < 0.1);
    let slid = &together.records[12];
    let share = -slid.tangential.unwrap().force / (0.3 * slid.normal.force);
    assert!(share > 0.995 && share <= 1.0 + 1e-9, "{share}");
    assert!(apart.warnings.iter().any(|warning| warning.contains("Dundurs")));
}

/// An attraction that fades by e over ρ attracts a hard ball at the distance z by 2πwR e^(−z/ρ) (Bradley 1932), and holds a soft one as Jkr does as ρ shrinks with
/// the pixel: 1.5πwR, to what the range leaves.
#[test]
fn what_fades_attracts_as_bradley_and_jkr_have_it() {
    let attracted = |young: &str, range: &str, history: &str, solver: &str| {
        let text = format!(
            "(shape: Paraboloid(radius: 1), bodies: (Elastic(young: {young}, poisson: 0), Rigid), steps: 10,
            adhesion: Exponential(work: 1e-4, range: {range}), solver: HalfSpace({solver}), history: [{history}])"
        );
        let plan =
            Notation::Ron.plan(&text, &InMemory::default()).unwrap_or_else(|errors| panic!("{text}: {}", errors[0]));
        run(&plan, Wanted::NOTHING).unwrap_or_else(|error| panic!("{text}: {error}"))
    };
    let least = |outcome: &Outcome| outcome.records.iter().map(|record| record.normal.force).fold(0.0, f64::min);
    let bradley = -std::f64::consts::TAU * 1e-4;
    let hard = attracted("1e6", "1e-4", "Indent(to: 1e-9, over: 1), Retract(speed: 1e-3)", "grid: 64, window: 0.12");
    let away = hard.records.iter().filter_map(|record| {
        let depth = record.normal.indentation.filter(|depth| *depth < -1e-6 && *depth > -5e-4)?;
        Some((record.normal.force, bradley * (depth / 1e-4).exp()))
    });
    assert!(away.clone().count() > 10);
    for (force, exact) in away {
        assert!((force / exact - 1.0).abs() < 1e-3, "{force} {exact}");
    }
    let soft = attracted("1", "1.2e-3", "Indent(to: 2e-3, over: 1), Retract(speed: 1e-3)", "grid: 96, window: 0.4");
    let pulled = least(&soft) / (0.75 * bradley);
    assert!(pulled > 0.97 && pulled < 1.1, "{pulled} {:?}", soft.warnings);
}

/// A history cut in two takes other steps, and is the same within what is stated.
#[test]
fn a_cut_changes_less_than_is_stated() {
    let led = |history: &str| {
        let text = format!(
            "(shape: Paraboloid(radius: 1), bodies: (Elastic(young: 1, poisson: 0), Rigid), friction: Coulomb(coefficient: 0.3),
            steps: 4, solver: HalfSpace(grid: 32, window: 0.3, tractions: Coupled), history: [{history}])"
        );
        let plan =
            Notation::Ron.plan(&text, &InMemory::default()).unwrap_or_else(|errors| panic!("{text}: {}", errors[0]));
        run(&plan, Wanted::NOTHING).unwrap_or_else(|error| panic!("{text}: {error}"))
    };
    let whole = led("Indent(to: 0.01, over: 1), Slide(to: 0.0015, over: 1)");
    let cut = led(
        "Indent(to: 0.005, over: 0.5), Indent(to: 0.01, over: 0.5), Slide(to: 0.00075, over: 0.5), Slide(to: 0.0015, over: 0.5)",
    );
    let shear = |outcome: &Outcome| outcome.records.last().unwrap().tangential.unwrap().force;
    let apart = (shear(&whole) / shear(&cut) - 1.0).abs();
    assert!(apart < whole.error_estimate.relative, "{apart:e} {:?}", whole.error_estimate);
    assert!(whole.error_estimate.relative < 1e-2, "{:?}", whole.error_estimate);
}
