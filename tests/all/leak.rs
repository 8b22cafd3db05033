//! What a gap lets through of a fluid, in scenes.

use ndarray::Array2;
use springbed::prelude::*;
use springbed::run::record::Outcome;
use std::f64::consts::TAU;

const AMPLITUDE: f64 = 1e-6;

fn outcome(heights: &str, solver: &str, history: &str) -> Outcome {
    // 24 × 48 pixels of 1 µm × 1 µm: a plate, and a wave along x.
    let plate = Array2::zeros((24, 48));
    let wave = Array2::from_shape_fn((24, 48), |(_, j)| AMPLITUDE * (TAU * (j as f64 + 0.5) / 48.0).cos());
    let tables = InMemory::default().with_heights("plate.csv", plate).with_heights("wave.csv", wave);
    let text = format!(
        "(shape: HeightMap({heights:?}, \"1 um\"), bodies: (Elastic(young: 2e6, poisson: 0.5), Rigid), solver: HalfSpace({solver}), steps: 2, history: [{history}])"
    );
    let plan = Notation::Ron.plan(&text, &tables).unwrap_or_else(|errors| panic!("{text}: {}", errors[0]));
    run(&plan, Wanted::NOTHING).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn last(outcome: &Outcome) -> f64 {
    outcome.records.last().unwrap().pixels.unwrap().leak.unwrap()
}

/// Plane Poiseuille flow between plates 2 µm apart, along x and along y: w g³/(12ηl).
#[test]
fn plates() {
    for (along, ratio) in [("", 0.5), (", along: Y", 2.0)] {
        for boundary in ["Free", "Periodic"] {
            let solver = format!("boundary: {boundary}, leak: (viscosity: \"10 mPa s\"{along})");
            let outcome = outcome("plate.csv", &solver, "Indent(to: -2e-6, over: 1)");
            let right = ratio * 8e-18 / (12.0 * 0.01);
            assert!((last(&outcome) / right - 1.0).abs() < 1e-12, "{along} {boundary}");
        }
    }
}

/// A wave of the gap along the flow resists in series, (1−a²)^{5/2}/(1+a²/2) of plates at the mean distance; across it
/// lets through in parallel, 1 + 3a²/2. Pressed together it is closed along x as soon as it touches, and the valleys lie
/// open along y until the contact is full.
#[test]
fn a_wave() {
    let apart = 1e-6;
    let (mean, a) = (AMPLITUDE + apart, AMPLITUDE / (AMPLITUDE + apart));
    let plates = |ratio: f64| ratio * mean.powi(3) / (12.0 * 1e-3);
    let of = |along: &str, history: &str| {
        outcome("wave.csv", &format!("boundary: Periodic, leak: (viscosity: 1e-3, along: {along})"), history)
    };
    // Touched is the lowest pixel, beside the crest of the wave by half a pixel.
    let missed = AMPLITUDE * (1.0 - (TAU * 0.5 / 48.0).cos());
    let history = format!("Indent(to: {:e}, over: 1)", -apart - missed);
    let (series, parallel) = (last(&of("X", &history)), last(&of("Y", &history)));
    assert!((series / plates(0.5) / ((1.0 - a * a).powf(2.5) / (1.0 + 0.5 * a * a)) - 1.0).abs() < 1e-9);
    assert!((parallel / plates(2.0) / (1.0 + 1.5 * a * a) - 1.0).abs() < 1e-9);
    let press = "Press(to: 1e-5, over: 1)";
    let (closed, open) = (of("X", press), of("Y", press));
    assert!(last(&closed).abs() <= 0.0 && closed.number("sealing_force_n").is_some());
    assert!(last(&open) > 0.0 && last(&open) < plates(2.0) && open.number("sealing_force_n").is_none());
    // What is asked for beside it changes nothing of the contact.
    let without = outcome("wave.csv", "boundary: Periodic", press);
    assert_eq!(without.records.last().unwrap().normal, open.records.last().unwrap().normal);
    assert!(without.records.iter().all(|record| record.pixels.unwrap().leak.is_none()));
}
