//! Bodies that glide over the pixels of a half-space that remembers, as whole scenes.

use springbed::prelude::*;
use springbed::run::record::Outcome;

const RUBBER: &str = "Viscoelastic(poisson: 0.5, shear: (equilibrium: 1e6, terms: [(modulus: 5e6, time: 1e-3), (modulus: 2e6, time: 0.1)]))";
const ROUGH: &str =
    "RoughLine(spectrum: SelfAffine(hurst: 0.8, rms: 1e-6, long: 1e-4, short: 1.25e-5), length: 1e-4, points: 512)";
const BALL: &str = "Paraboloid(radius: 5e-3)";

fn outcome(shape: &str, body: &str, rest: &str) -> Outcome {
    let text = format!("(shape: {shape}, bodies: (Rigid, {body}), steps: 1, {rest})");
    let plan = Notation::Ron.plan(&text, &InMemory::default()).unwrap_or_else(|errors| panic!("{text}: {}", errors[0]));
    run(&plan, Wanted::NOTHING).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn column(outcome: &Outcome, name: &str) -> Vec<f64> {
    let glides = outcome.table("glides").unwrap();
    glides.column(name).unwrap().numbers().iter().flatten().copied().collect()
}

/// Each speed of a list is what it is alone, wherever its search begins; at most what the solver may miss.
#[test]
fn a_list_is_its_speeds() {
    let at = |speeds: &str| {
        outcome(
            ROUGH,
            RUBBER,
            &format!(
                "solver: HalfSpace(grid: 48), accuracy: 1e-6, history: [Press(to: 1e-3, over: 1), Glide(speed: {speeds})]"
            ),
        )
    };
    let all = at("[1e-6, 1e-4, 1e-2, 1e-3]");
    for (k, speed) in ["1e-6", "1e-4", "1e-2", "1e-3"].into_iter().enumerate() {
        let alone = at(speed);
        for name in ["tangential_force", "indentation", "area_fraction"] {
            let (one, other) = (column(&all, name)[k], column(&alone, name)[0]);
            assert!((one / other - 1.0).abs() < 1e-4, "{speed} {name}: {one} {other}");
        }
        let named = alone.number("resistance_coefficient").unwrap();
        assert!((column(&alone, "resistance_coefficient")[0] / named - 1.0).abs() < 1e-12);
    }
}

/// Under the force that a depth takes the depth is that, whoever is prescribed.
#[test]
fn a_depth_and_its_force_are_one_state() {
    for (shape, depth, solver) in
        [(ROUGH, "1e-6", "HalfSpace(grid: 48)"), (BALL, "5e-6", "HalfSpace(grid: 48, window: 8e-4)")]
    {
        let with = |entry: &str| {
            outcome(shape, RUBBER, &format!("solver: {solver}, accuracy: 1e-6, history: [{entry}, Glide(speed: 1e-3)]"))
        };
        let deep = with(&format!("Indent(to: {depth}, over: 1)"));
        let force = column(&deep, "force")[0];
        let pressed = with(&format!("Press(to: {force:e}, over: 1)"));
        for name in ["indentation", "tangential_force", "peak_pressure"] {
            let (one, other) = (column(&deep, name)[0], column(&pressed, name)[0]);
            assert!((one / other - 1.0).abs() < 1e-5, "{shape} {name}: {one} {other}");
        }
    }
}

/// A thick layer of the ground is the ground, and one so thin that all of it is loaded alike resists less under a force.
#[test]
fn a_thick_layer_is_the_half_space() {
    let with = |body: &str| {
        let rest = "solver: HalfSpace(grid: 48), accuracy: 1e-6, history: [Press(to: 1e-3, over: 1), Glide(speed: [1e-4, 1e-2])]";
        column(&outcome(ROUGH, body, rest), "tangential_force")
    };
    let layer =
        |thickness: f64| with(&format!("Layered(layers: [(body: {RUBBER}, thickness: {thickness:e})], base: Rigid)"));
    let (half_space, thick, thin) = (with(RUBBER), layer(1.0), layer(2e-6));
    for k in 0..2 {
        assert!((thick[k] / half_space[k] - 1.0).abs() < 1e-5, "{thick:?} {half_space:?}");
        assert!(thin[k] < 0.8 * half_space[k], "{thin:?} {half_space:?}");
    }
}

/// The estimate, from every second pixel, is above what four times as many say.
#[test]
fn the_estimate_is_above_the_error() {
    for speed in ["1e-5", "1e-3", "0.1"] {
        let on = |grid: usize| {
            let rest = format!(
                "solver: HalfSpace(grid: {grid}, window: 1.2e-3), history: [Press(to: 0.05, over: 1), Glide(speed: {speed})]"
            );
            outcome(BALL, RUBBER, &rest)
        };
        let (some, many) = (on(48), on(192));
        let error =
            (column(&some, "resistance_coefficient")[0] / column(&many, "resistance_coefficient")[0] - 1.0).abs();
        assert!(error <= some.error_estimate.relative, "{speed}: {error} {:?}", some.error_estimate);
    }
}

/// A ball that rolls is one that glides; one that glides in front touches further than behind.
#[test]
fn a_ball_rolls_as_it_glides() {
    let with = |entry: &str| {
        outcome(BALL, RUBBER, &format!("solver: HalfSpace(grid: 48), history: [Press(to: 0.05, over: 1), {entry}]"))
    };
    let (glides, rolls) = (with("Glide(speed: 1e-2)"), with("Roll(speed: 1e-2)"));
    assert_eq!(column(&glides, "tangential_force"), column(&rolls, "tangential_force"));
    assert!(column(&glides, "leading_edge")[0] > -column(&glides, "trailing_edge")[0]);
}

/// What the bed makes of a ball: slowly 2vτF/R where the half-space has vτF/R, for its one-dimensional profile is twice as
/// steep, and fast the same. To the rim of the pixels, 3 %.
#[test]
fn the_bed_is_twice_as_slow_and_fast_the_same() {
    let with = |solver: &str, speed: &str| {
        let rest = format!("{solver} history: [Press(to: 0.1, over: 1), Glide(speed: {speed})]");
        column(&outcome(BALL, RUBBER, &rest), "tangential_force")[0]
    };
    for (speed, ratio) in [("1e-5", 2.0), ("10", 1.0)] {
        let (bed, pixels) = (with("", speed), with("solver: HalfSpace(grid: 96),", speed));
        assert!((bed / pixels / ratio - 1.0).abs() < 0.03, "{speed}: {bed} {pixels}");
    }
}

/// Pressed flat, what touches is as steep as the surface; the heat is the power of the resistance over the nominal area.
#[test]
fn what_touches_in_full_contact_is_the_surface() {
    let at = |force: &str| {
        let rest = format!(
            "solver: HalfSpace(grid: 64), accuracy: 1e-6, history: [Press(to: {force}, over: 1), Glide(speed: 1e-3)]"
        );
        outcome(ROUGH, RUBBER, &rest)
    };
    let (full, part) = (at("0.1"), at("1e-3"));
    assert!((column(&full, "area_fraction")[0] - 1.0).abs() < 1e-12);
    let slope = full.number("rms_slope").unwrap();
    let steep = full.number("contact_rms_slope").unwrap();
    // Differences over two pixels see a wave of λ less steep, by sin(2πh/λ)/(2πh/λ): 10 % of the shortest, of eight pixels.
    assert!((steep / slope - 1.0).abs() < 0.1, "{steep} {slope}");
    let heat = full.number("heat_per_area_w_per_m2").unwrap();
    assert!((heat * 1e-8 / (1e-3 * column(&full, "tangential_force")[0]) - 1.0).abs() < 1e-12);
    assert!(part.number("contact_rms_slope").unwrap() < 2.0 * slope);
}
