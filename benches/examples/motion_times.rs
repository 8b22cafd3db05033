//! How long bodies in motion take: `cargo run --release -p benches --example motion_times`.
//!
//! Whole runs on as many threads as there are, the median of repeats: a rough line of 10⁴ points that glides over a body of
//! ten terms at forty speeds; a ball shaken 10⁵ strokes, to the limit of its fretting wear; sliders in stick and slip
//! with 10⁴ events, slips and sticks. With words behind it, those rows alone whose names have one of them: `-- glide wear`.

use springbed::prelude::*;
use springbed::run::record::Outcome;
use std::error::Error;
use std::time::Instant;

/// Ten terms over ten decades of time [Pa, s].
fn terms() -> String {
    (0..10).map(|k| format!("(modulus: {:e}, time: {:e}),", 3e7 / f64::from(k + 1), 10f64.powi(k - 8))).collect()
}

/// Forty speeds from 1 µm/s to 100 m/s.
fn speeds() -> String {
    (0..40).map(|k| format!("{:e},", 10f64.powf(-6.0 + 8.0 * f64::from(k) / 39.0))).collect()
}

fn glide() -> String {
    format!(
        "(shape: RoughLine(spectrum: SelfAffine(hurst: 0.8, rms: 1e-6, long: 2e-4, short: 4e-7), length: 2e-4, points: 10000, seed: 1),
        bodies: (Rigid, Viscoelastic(poisson: 0.5, shear: (equilibrium: 1e6, terms: [{}]))), accuracy: 1e-4, steps: 1,
        history: [Press(to: 4e-4, over: 1), Glide(speed: [{}])])",
        terms(),
        speeds()
    )
}

const WEAR: &str = "(shape: Paraboloid(radius: 0.01),
    bodies: (Elastic(young: 210e9, poisson: 0.3), Elastic(young: 210e9, poisson: 0.3)),
    friction: Coulomb(coefficient: 0.3), wear: Archard(coefficient: 1e-12),
    history: [Indent(to: 1e-6, over: 1), Shake(amplitude: 182.142857143e-9, frequency: 100, cycles: 50000)])";

/// A polymer ball that jumps 5000 times in a machine of the damping `damping` [N s/m].
fn stick_slip(damping: f64) -> String {
    format!(
        "(shape: Paraboloid(radius: 5e-3), bodies: (Elastic(young: 3e9, poisson: 0.4), Elastic(young: 3e9, poisson: 0.4)),
        friction: StaticKinetic(static: 0.5, kinetic: 0.3), machine: (mass: 0.05, stiffness: 2e3, damping: {damping}),
        history: [Press(to: 2, over: 1), Drive(speed: 1e-2, over: 287)])"
    )
}

const RATED: &str = "(shape: FlatPunch(radius: 0.01),
    bodies: (Elastic(young: 60e9, poisson: 0.25), Elastic(young: 60e9, poisson: 0.25)),
    friction: RateState(coefficient: 0.6, direct: 0.01, evolution: 0.015, distance: 1e-5, speed: 1e-6),
    machine: (mass: 1, stiffness: 3e5, damping: 2e3),
    history: [Press(to: 1000, over: 1), Drive(speed: 1e-5, over: 115000)])";

fn outcome(text: &str) -> Result<Outcome, Box<dyn Error>> {
    let plan = Notation::Ron.plan(text, &InMemory::default()).map_err(|errors| errors[0].clone())?;
    Ok(run(&plan, Wanted { instants: false, ..Wanted::NOTHING })?)
}

fn told(name: &str, text: &str) -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    if !words.is_empty() && !words.iter().any(|word| name.contains(word.as_str())) {
        return Ok(());
    }
    let mut times = Vec::new();
    let mut found = None;
    for _ in 0..3 {
        let began = Instant::now();
        found = Some(outcome(text)?);
        times.push(began.elapsed().as_secs_f64());
    }
    times.sort_by(f64::total_cmp);
    let Some(found) = found else { return Ok(()) };
    let events =
        found.table("slips").map_or(0, |table| table.columns.first().map_or(0, |column| column.numbers().len()));
    println!("{name:<36} {:8.3} s  error {:.1e}  {events} slips", times[1], found.error_estimate.relative);
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    told("glide, 10⁴ points, 40 speeds", &glide())?;
    told("wear, 10⁵ strokes", WEAR)?;
    told("stick and slip, damping 0.5", &stick_slip(0.5))?;
    told("stick and slip, damping 0", &stick_slip(0.0))?;
    told("rate and state", RATED)
}
