//! Whole scenes that were slow once, from their text to fields and the last record: at the default accuracy and at 1e-4;
//! noisy rows over their number, records over the number of springs.
//!
//! `cargo run --release -p benches --example slow_scenes -- [part of a name …]`.

use springbed::input::table::Tables;
use springbed::prelude::*;
use std::time::Instant;

const BALL: &str = "shape: Paraboloid(radius: 5e-3)";
const WAVY: &str = "shape: WavyParaboloid(radius: 2e-2, amplitude: 2e-7, wavelength: 1e-4)";
const ELASTIC: &str = "bodies: (Elastic(young: 2e6, poisson: 0.5), Rigid)";
const RUBBER: &str = "bodies: (Viscoelastic(poisson: 0.5, shear: (equilibrium: 3e5, terms: [(modulus: 5e5, time: 0.1), \
                      (modulus: 2e5, time: 3)])), Rigid)";
const KELVIN_VOIGT: &str = "bodies: (Viscoelastic(poisson: 0.5, shear: (equilibrium: 3e5, viscosity: 1e4)), Rigid)";
const LIQUID: &str = "bodies: (Viscoelastic(poisson: 0.5, shear: (terms: [(modulus: 5e5, time: 0.05)])), Rigid), adhesion: Jkr(work: 0.05, edge: Instantaneous)";
const RELAXED: &str = "adhesion: Jkr(work: 0.05, edge: Relaxed)";

/// Name, shape, bodies with their attraction, history.
const SCENES: [[&str; 4]; 10] = [
    ["Kelvin–Voigt half released", BALL, KELVIN_VOIGT, "Press(to: 5e-3, over: 1), Press(to: 2.5e-3, over: 1)"],
    [
        "Kelvin–Voigt let go",
        BALL,
        KELVIN_VOIGT,
        "Press(to: 1e-3, over: 1), Press(to: 0, over: 0.01), HoldForce(over: 10)",
    ],
    ["relaxed edge under a force", BALL, "", "Press(to: 5e-3, over: 1), Press(to: -4e-4, over: 1)"],
    ["sine under adhesion", BALL, "", "Indent(to: 1e-5, over: 1), Oscillate(amplitude: 2e-6, frequency: 1, cycles: 5)"],
    ["wavy relaxed edge", WAVY, "", "Press(to: 5e-3, over: 1), Press(to: -7e-3, over: 1)"],
    ["wavy adhesive impact", WAVY, "JKR", "Impact(mass: 1e-3, speed: 0.05)"],
    ["Maugis impact", BALL, "MAUGIS", "Impact(mass: 1e-3, speed: 0.05)"],
    ["pull-off by rate, slow", BALL, "RATE", "Press(to: 1e-3, over: 1), Retract(speed: 1e-7)"],
    ["pull-off by rate, fast", BALL, "RATE", "Press(to: 1e-3, over: 1), Retract(speed: 1e-4)"],
    ["liquid torn off", BALL, LIQUID, "Indent(to: 1e-5, over: 1), Retract(speed: 1e-3)"],
];

/// What a run asks for, as the program does.
const WANTED: Wanted = Wanted { fields: true, instants: true, ..Wanted::NOTHING };

type Fault = Box<dyn std::error::Error>;

fn bodies(text: &str) -> String {
    match text {
        "" => format!("{RUBBER}, {RELAXED}"),
        "JKR" => format!("{ELASTIC}, adhesion: Jkr(work: 0.05)"),
        "MAUGIS" => format!("{ELASTIC}, adhesion: Maugis(work: 0.05, stress: 1e5)"),
        "RATE" => format!("{RUBBER}, adhesion: Jkr(work: 0.05, edge: Rate(speed: 1e-4, exponent: 0.5))"),
        own => own.to_owned(),
    }
}

/// Seconds that a scene takes, from its text on.
fn seconds(text: &str, tables: &dyn Tables) -> Result<f64, Fault> {
    let begun = Instant::now();
    let plan = Notation::Ron.plan(text, tables).map_err(|errors| errors[0].to_string())?;
    run(&plan, WANTED)?;
    Ok(begun.elapsed().as_secs_f64())
}

/// Depths of a ramp with noise, by a congruential generator.
fn noisy(rows: u32) -> [Vec<f64>; 2] {
    let mut state = 1_u32;
    let mut noise = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state) / f64::from(u32::MAX) - 0.5
    };
    let parts: Vec<f64> = (0..=rows).map(|k| f64::from(k) / f64::from(rows)).collect();
    let times = parts.iter().map(|part| 10.0 * part).collect();
    let depths = parts.iter().map(|part| if *part > 0.0 { 5e-6 + 5e-6 * part + 1e-6 * noise() } else { 0.0 });
    [times, depths.collect()]
}

fn rows() -> Result<(), Fault> {
    for rows in [300, 1000, 3000] {
        let [times, depths] = noisy(rows);
        let tables = InMemory::default().with("rows.csv", &[("time_s", &times), ("indentation_m", &depths)]);
        let text = format!("({BALL}, {RUBBER}, history: [Table(\"rows.csv\")])");
        println!("{rows} noisy rows: {:.3} s", seconds(&text, &tables)?);
    }
    Ok(())
}

fn springs() -> Result<(), Fault> {
    for springs in [1000, 1_000_000] {
        let of = |records: u32| {
            let steps = records / 2;
            let text = format!(
                "({BALL}, {RUBBER}, springs: {springs}, steps: {steps}, history: [Indent(to: 1e-5, over: 1), Indent(to: 1e-6, over: 1)])"
            );
            seconds(&text, &InMemory::default())
        };
        let (fewest, few, many) = (of(40)?, of(400)?, of(40_000)?);
        println!(
            "{springs} springs: 40 records {fewest:.3} s, 400 records {few:.3} s, 40 000 records {many:.3} s, between the \
             last two {:.3} s",
            many - few
        );
    }
    Ok(())
}

fn main() -> Result<(), Fault> {
    let asked: Vec<String> = std::env::args().skip(1).collect();
    let is_asked = |name: &str| asked.is_empty() || asked.iter().any(|part| name.contains(part.as_str()));
    for [name, shape, text, history] in SCENES.into_iter().filter(|[name, ..]| is_asked(name)) {
        let scene = |accuracy: &str| format!("({shape}, {}, {accuracy} history: [{history}])", bodies(text));
        let [usual, coarse] = [scene(""), scene("accuracy: 1e-4,")];
        let [usual, coarse] = [seconds(&usual, &InMemory::default())?, seconds(&coarse, &InMemory::default())?];
        println!("{name}: {usual:.3} s, at 1e-4 {coarse:.3} s");
    }
    if is_asked("noisy rows") {
        rows()?;
    }
    if is_asked("springs") {
        springs()?;
    }
    Ok(())
}
