//! Pixels over layers and over other bodies that are not alike at all depths: against the beds that know the answer,
//! against waves in closed form, and under the laws that hold whatever lies beneath.

use ndarray::Array2;
use springbed::prelude::*;
use springbed::run::record::{Outcome, Record};
use std::f64::consts::TAU;

const SOFT: &str = "Elastic(young: 2e6, poisson: 0.5)";
const GEL: &str = "Viscoelastic(poisson: 0.5, shear: (equilibrium: 3e5, terms: [(modulus: 5e5, time: 0.1)]))";

fn layered(body: &str, thickness: f64, rest: &str) -> String {
    format!("Layered(layers: [(body: {body}, thickness: {thickness:e})], {rest})")
}

fn outcome(text: &str) -> Outcome {
    let motion: [(&str, &[f64]); 2] = [("time_s", &[0.0, 1.0, 2.0]), ("indentation_m", &[0.0, 1e-5, 4e-6])];
    let tables = InMemory::default().with_heights("wave.csv", wave()).with("motion.csv", &motion);
    let plan = Notation::Ron.plan(text, &tables).unwrap_or_else(|errors| panic!("{text}: {}", errors[0]));
    run(&plan, Wanted::NOTHING).unwrap_or_else(|error| panic!("{text}: {error}"))
}

const AMPLITUDE: f64 = 1e-6;
const LENGTH: f64 = 32e-6;

/// One wave on 32 pixels of 1 µm.
fn wave() -> Array2<f64> {
    Array2::from_shape_fn((32, 32), |(_, j)| AMPLITUDE * (TAU * j as f64 / 32.0).cos())
}

fn pressed(bodies: &str, rest: &str) -> Outcome {
    outcome(&format!("(shape: Paraboloid(radius: 5e-3), bodies: ({bodies}), {rest})"))
}

fn end(outcome: &Outcome) -> &Record {
    outcome.records.last().unwrap()
}

/// Force at a depth beside the bed, on 96 pixels over three radii, where Hertz' contact has (Δ/a)²/8: three times that
/// where the stiffness grows with the radius by up to its sixth power.
#[test]
fn what_lies_beneath_is_that_of_the_bed() {
    let bodies = [
        layered(SOFT, 2e-4, "base: Rigid"),
        layered("Elastic(young: 2e6, poisson: 0.3)", 1e-4, "base: Rigid, bond: Sliding"),
        layered(SOFT, 1e-4, "base: Elastic(young: 1e5, poisson: 0.3)"),
        layered("Elastic(young: 2e8, poisson: 0.3)", 2e-5, &format!("base: {SOFT}")),
        format!(
            "Layered(layers: [(body: {SOFT}, thickness: 5e-5), (body: Elastic(young: 2e7, poisson: 0.3), thickness: 3e-5)], base: {SOFT})"
        ),
        "Graded(young: 2e6, depth: 1e-3, exponent: 0.6, poisson: 0.4)".to_owned(),
        "Winkler(modulus: 2e6, thickness: 1e-3)".to_owned(),
    ];
    let bound = 3.0 * 0.125 * (3.0_f64 / 96.0).powi(2);
    for body in bodies {
        for shape in ["Paraboloid(radius: 5e-3)", "Cone(slope: 0.05)"] {
            let of = |solver: &str| {
                outcome(&format!(
                    "(shape: {shape}, bodies: ({body}, Rigid), {solver} steps: 2, history: [Indent(to: 1e-5, over: 1)])"
                ))
            };
            let (bed, pixels) = (of(""), of("solver: HalfSpace(grid: 96),"));
            let apart = (end(&pixels).normal.force / end(&bed).normal.force - 1.0).abs();
            // The apex of a cone is blunted over a pixel: (Δ/a)²/2.
            let bound = if shape.starts_with("Cone") { 4.0 * bound } else { bound };
            assert!(apart < bound, "{shape} on {body}: {apart:e} of {bound:e}");
            assert!(pixels.error_estimate.relative > apart, "{shape} on {body}: {apart:e}");
            let stored = (end(&pixels).normal.stored.elastic / end(&bed).normal.stored.elastic - 1.0).abs();
            assert!(stored < 2.0 * bound, "{shape} on {body}: energy {stored:e}");
        }
    }
}

/// A layer of what lies beneath it is no layer, whatever is pressed on it and however.
#[test]
fn equal_layers_are_one() {
    let none = format!("{SOFT}, Rigid");
    let layer = format!("{}, Rigid", layered(SOFT, 3e-5, &format!("base: {SOFT}")));
    let relaxing = [format!("{GEL}, Rigid"), format!("{}, Rigid", layered(GEL, 3e-5, &format!("base: {GEL}")))];
    let way = "steps: 3, history: [Indent(to: 1e-5, over: 1), Indent(to: 2e-6, over: 1)]";
    let ball = "shape: Paraboloid(radius: 5e-3), solver: HalfSpace(grid: 48, window: 9e-4)";
    let tips = "shape: Tips([(shape: Sphere(radius: 5e-3), x: -1e-4), (shape: Sphere(radius: 5e-3), x: 1e-4, height: 1e-6)]), solver: HalfSpace(grid: 48, window: 9e-4)";
    let map = "shape: HeightMap(\"wave.csv\", \"1 um\"), solver: HalfSpace(boundary: Periodic)";
    let pair = [none, layer];
    let press = "steps: 3, history: [Press(to: 1e-5, over: 1)]";
    let rows: [(&[String; 2], String); 6] = [
        (&pair, format!("{ball}, {way}")),
        (&pair, format!("{ball}, adhesion: Maugis(work: 0.05, stress: 2e4), {way}")),
        (&pair, format!("{ball}, adhesion: Jkr(work: 0.05), {way}")),
        (&relaxing, format!("{ball}, {way}")),
        (&pair, format!("{tips}, {way}")),
        (&pair, format!("{map}, {press}")),
    ];
    for (bodies, rest) in rows {
        let [one, other] = bodies.each_ref().map(|bodies| outcome(&format!("(bodies: ({bodies}), {rest})")));
        let largest = one.records.iter().map(|record| record.normal.force.abs()).fold(0.0, f64::max);
        for (one, other) in one.records.iter().zip(&other.records) {
            let apart = (one.normal.force - other.normal.force).abs() / largest;
            let depth = (one.normal.indentation.unwrap() / other.normal.indentation.unwrap() - 1.0).abs();
            // The solver's tolerance is 1e-8; attraction settles to 1e-5 of its stress.
            let bound = if rest.contains("adhesion") { 1e-5 } else { 1e-7 };
            assert!(apart < bound && (depth < bound || depth.is_nan()), "{rest}: {apart:e} {depth:e}");
        }
    }
}

/// A wave in full contact of a bonded layer on a rigid base: p = p̄ + E*kΔ/(2M(kh)) cos kx with M of physics (Johnson 1985,
/// §5.7 in plane strain), and the mean depth by the oedometric modulus; there a depth is prescribed as well as a force.
#[test]
fn full_contact_of_a_layer_is_a_wave() {
    for (poisson, thickness) in [(0.5_f64, 5e-6_f64), (0.3, 5e-6), (0.3, 4e-5)] {
        let (young, k) = (2e6, TAU / LENGTH);
        let modulus = young / (1.0 - poisson * poisson);
        let (kappa, t) = (3.0 - 4.0 * poisson, k * thickness);
        let give = (2.0 * kappa * (2.0 * t).sinh() - 4.0 * t)
            / (2.0 * kappa * (2.0 * t).cosh() + 4.0 * t * t + 1.0 + kappa * kappa);
        let swing = modulus * k * AMPLITUDE / (2.0 * give);
        let body = layered(&format!("Elastic(young: {young:e}, poisson: {poisson})"), thickness, "base: Rigid");
        let mean = 2.0 * swing;
        let force = mean * LENGTH * LENGTH;
        let scene = |entry: &str| {
            outcome(&format!(
                "(shape: HeightMap(\"wave.csv\", \"1 um\"), bodies: ({body}, Rigid), solver: HalfSpace(boundary: Periodic), accuracy: 1e-8, steps: 2, history: [{entry}])"
            ))
        };
        let by_force = scene(&format!("Press(to: {force:e}, over: 1)"));
        let record = end(&by_force);
        assert!((record.pixels.unwrap().peak_pressure / (mean + swing) - 1.0).abs() < 1e-7, "{poisson} {thickness:e}");
        let compression = thickness * (1.0 - 2.0 * poisson) * (1.0 + poisson) / ((1.0 - poisson) * young);
        // From first touch, the crest, to the mean plane, and down from there.
        let depth = AMPLITUDE + mean * compression;
        let found = record.normal.indentation.unwrap();
        assert!((found / depth - 1.0).abs() < 1e-7, "{poisson} {thickness:e}: {found:e} {depth:e}");
        if compression > 0.0 {
            let stiffness = record.normal.stiffness * compression / (LENGTH * LENGTH);
            assert!((stiffness - 1.0).abs() < 1e-12, "{stiffness}");
            let by_depth = scene(&format!("Indent(to: {depth:e}, over: 1)"));
            assert!((end(&by_depth).normal.force / force - 1.0).abs() < 1e-6);
        }
    }
}

/// A layer that relaxes: beside the bed, cut, from a table, the bodies swapped, and of a weight that vanishes.
#[test]
fn layers_that_relax_keep_the_laws() {
    let gel = layered(GEL, 2e-4, "base: Rigid");
    let more = "solver: HalfSpace(grid: 48, window: 9e-4), steps: 10";
    let history = "history: [Indent(to: 1e-5, over: 1), Indent(to: 4e-6, over: 1)]";
    let whole = pressed(&format!("{gel}, Rigid"), &format!("{more}, {history}"));
    let bed = pressed(&format!("{gel}, Rigid"), &format!("steps: 10, {history}"));
    let force = |outcome: &Outcome, time: f64| {
        let record = outcome.records.iter().find(|record| (record.time - time).abs() < 1e-9);
        record.unwrap().normal.force
    };
    let (peak, second) = (force(&bed, 1.0), 0.125 * (1.0_f64 / 12.0).powi(2));
    for time in [0.5, 1.0, 1.3, 1.7, 2.0] {
        let apart = (force(&whole, time) - force(&bed, time)).abs() / peak;
        assert!(apart < 2.0 * second, "{time}: {apart:e} of {second:e}");
    }
    let cut = "history: [Indent(to: 4e-6, over: 0.4), Indent(to: 1e-5, over: 0.6), Indent(to: 4e-6, over: 1)]";
    let table = "history: [Table(\"motion.csv\")]";
    let others = [
        pressed(&format!("{gel}, Rigid"), &format!("{more}, {cut}")),
        pressed(&format!("{gel}, Rigid"), &format!("{more}, {table}")),
        pressed(&format!("Rigid, {gel}"), &format!("{more}, {history}")),
    ];
    for other in &others {
        let apart = (force(&whole, 2.0) - force(other, 2.0)).abs() / peak;
        assert!(apart < whole.error_estimate.relative.min(1e-3), "{apart:e}");
    }
    let faint = GEL.replace("modulus: 5e5", "modulus: 1e-4").replace("equilibrium: 3e5", "equilibrium: 6e5");
    let elastic = layered("Elastic(shear: 6e5, poisson: 0.5)", 2e-4, "base: Rigid");
    let [faint, elastic] = [layered(&faint, 2e-4, "base: Rigid"), elastic]
        .map(|body| pressed(&format!("{body}, Rigid"), &format!("{more}, {history}")));
    assert!((force(&faint, 2.0) / force(&elastic, 2.0) - 1.0).abs() < 1e-6);
}

/// An attraction on a layer: forces beside the bed of JKR, the ledger, and two layered bodies whichever comes first.
#[test]
fn layers_are_attracted() {
    let layer = layered("Elastic(young: 1e6, poisson: 0.5)", 2e-4, "base: Rigid");
    let scene = |bodies: &str, solver: &str| {
        outcome(&format!(
            "(shape: Paraboloid(radius: 1e-2), bodies: ({bodies}), adhesion: Jkr(work: 0.05), {solver} steps: 6, history: [Indent(to: 3e-6, over: 1), Indent(to: 1e-6, over: 1)])"
        ))
    };
    let rigid = format!("{layer}, Rigid");
    let (bed, pixels) = (scene(&rigid, ""), scene(&rigid, "solver: HalfSpace(grid: 96, window: 1.2e-3),"));
    let largest = bed.records.iter().map(|record| record.normal.force.abs()).fold(0.0, f64::max);
    let apart = (end(&bed).normal.force - end(&pixels).normal.force).abs() / largest;
    // As on a half-space (tests of pixels with a past): a ring of three pixels leaves some per cent.
    assert!(apart < 0.04 && apart < 1.5 * pixels.error_estimate.relative, "{apart:e}");
    let other = layered(SOFT, 1e-4, "base: Elastic(young: 1e7, poisson: 0.3)");
    let maugis = |bodies: &str| {
        outcome(&format!(
            "(shape: Paraboloid(radius: 1e-2), bodies: ({bodies}), adhesion: Maugis(work: 0.05, stress: 2e4), solver: HalfSpace(grid: 48, window: 1.2e-3), steps: 6, history: [Indent(to: 2e-6, over: 1), Indent(to: 1e-6, over: 1)])"
        ))
    };
    let (one, two) = (maugis(&format!("{layer}, {other}")), maugis(&format!("{other}, {layer}")));
    for (one, two) in one.records.iter().zip(&two.records) {
        assert!((one.normal.force - two.normal.force).abs() < 1e-9 * largest, "{one:?} {two:?}");
    }
}
