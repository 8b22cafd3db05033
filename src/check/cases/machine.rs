//! Contacts in a machine, run as whole scenes, against closed forms.

use crate::check::case::{Attempt, Case, Pairs, Proof};
use crate::check::sketch::{Sketch, ball, beside, elastic, result, si};
use crate::drive::machine::GRAVITY;
use crate::material::Relaxation;
use crate::run::record::Outcome;
use crate::shape::{FlatPunch, Shape};
use std::f64::consts::{PI, TAU};

pub(super) const CASES: &[Case] = &[
    Case::new("machine/small swing", Proof::Bound, 1e-9, "ω² = (k + 2E*a)/m up to the square of the amplitude, 1e-5 of the depth, and its rounding")
        .weak("the frequency; one preload")
        .by(swing),
    Case::new("machine/damped swing", Proof::Rounding, 1e-9, "on a punch the contact is a spring: ζ = c/(2√(Km)), f = √(1 − ζ²)√(K/m)/2π")
        .weak("linear")
        .by(damped),
    Case::new("machine/elastic bounces", Proof::Bound, 1e-8, "flights of 2v/g and contacts of 2.943275 x₀/v, the weight being 5e-5 of the force of a blow that lasts 1e-4 of a flight")
        .weak("no losses")
        .by(bounces),
    Case::new("machine/stick and slip", Proof::Bound, 1e-5, "jumps of 2(μ_s − μ_k)F/k in π√(m/k), up to the speed of the drive over that of the slip, 1e-6")
        .weak("a limit; the motion between two slips is left out, for it dies down there")
        .by(slips),
    Case::new("machine/slips of a punch", Proof::Rounding, 1e-9, "what sticks is a spring: the spring is drawn out to μ_s F where the swing of the mass has died down")
        .weak("overdamped")
        .by(punch),
    Case::new("machine/the ledger of stick and slip", Proof::Rounding, 1e-10, "work of the drive = kinetic + spring + contact + friction + damper, some 1e4 steps of 1e-13")
        .weak("one scene; the property tests take any")
        .by(ledger),
    Case::new("machine/a ball comes to lie on rubber", Proof::Order, 1e-3, "in the end it lies at the depth that carries its weight, E∞, within the swing that counts as lying")
        .weak("the state it comes to, not the way there")
        .by(lies),
];

/// A ball with R = E* = 1 under F = 4/3, d = a = 1.
fn pressed() -> Sketch {
    Sketch::of(ball(1.0)).press(4.0 / 3.0, 1.0).steps(20)
}

fn swing() -> Attempt<Pairs> {
    let mut pairs = Vec::new();
    for stiffness in [0.0, 3.0] {
        let scene = pressed().machine(0.5, stiffness, 0.0).ring(1e-5, 60.0);
        pairs.extend(beside(&scene.run()?, &[("frequency_hz", ((stiffness + 2.0) / 0.5).sqrt() / TAU)])?);
    }
    Ok(pairs)
}

fn flat() -> Attempt<Shape> {
    Ok(Shape::FlatPunch(FlatPunch { radius: si(1.0)? }))
}

fn damped() -> Attempt<Pairs> {
    let (stiffness, damping): (f64, f64) = (3.0, 0.2);
    let scene = Sketch::of(flat()).press(2.0, 1.0).steps(20).machine(0.5, stiffness, damping).ring(0.1, 20.0);
    let whole = stiffness + 2.0;
    let ratio = 0.5 * damping / (whole * 0.5f64).sqrt();
    let frequency = (1.0 - ratio * ratio).sqrt() * (whole / 0.5).sqrt() / TAU;
    beside(&scene.run()?, &[("frequency_hz", frequency), ("damping_ratio", ratio)])
}

/// A column of a table of the outcome.
fn column(outcome: &Outcome, table: &str, name: &str) -> Attempt<Vec<f64>> {
    let column = outcome.table(table).and_then(|table| table.column(name)).ok_or("the scene has no such table")?;
    Ok(column.numbers().iter().copied().flatten().collect())
}

fn bounces() -> Attempt<Pairs> {
    let (radius, mass, height) = (5e-3, 4e-3, 0.1);
    let scene = Sketch::of(ball(radius)).body(elastic(210e9, 0.3)).machine(mass, 0.0, 0.0).fall(height, 2.0).steps(20);
    let modulus = 210e9 / (1.0 - 0.09);
    let speed = (2.0 * GRAVITY * height).sqrt();
    let deepest = (15.0 * mass * speed * speed / (16.0 * modulus * radius.sqrt())).powf(0.4);
    let contact = 2.943_275_184_324_705 * deepest / speed;
    let touches = column(&scene.run()?, "bounces", "touch_time")?;
    let right = |k: usize| speed / GRAVITY + (k as f64) * (2.0 * speed / GRAVITY + contact);
    Ok(touches.iter().enumerate().map(|(k, &touch)| (touch, right(k))).collect())
}

fn slips() -> Attempt<Pairs> {
    let (stiffness, drawn) = (0.01, 1e-6);
    let (held, fall): (f64, f64) = (0.4 * 4.0 / 3.0, 0.1 * 4.0 / 3.0);
    let scene = pressed().static_kinetic(0.4, 0.3).machine(1.0, stiffness, 0.0);
    let outcome = scene.drive(drawn, 1.1 * held / (stiffness * drawn)).run()?;
    beside(&outcome, &[("slip_jump_m", 2.0 * fall / stiffness), ("slip_time_s", PI / stiffness.sqrt())])
}

fn punch() -> Attempt<Pairs> {
    // G* = 2/3: m d = μd E*/G* = 0.6 at the first slip, μF = 0.8.
    let (stiffness, damping, drawn) = (0.5, 4.0, 1e-2);
    let scene = Sketch::of(flat()).indent(1.0, 1.0).steps(20).coulomb(0.4).machine(1.0, stiffness, damping);
    let outcome = scene.drive(drawn, 300.0).run()?;
    // Steady creep behind the start: c k V/K of drag, K = k + 2G*, and the lag cK⁻¹ of the spring.
    let whole = stiffness + 4.0 / 3.0;
    let along = stiffness * drawn / whole;
    let right = 0.6 / along + damping / whole;
    Ok(vec![(result(&outcome, "first_slip_time_s")? - 1.0, right)])
}

fn ledger() -> Attempt<Pairs> {
    let scene = pressed().static_kinetic(0.4, 0.2).machine(1.0, 0.02, 0.05).drive(0.2, 1500.0).drive(-0.1, 500.0);
    Ok(vec![(1.0 + result(&scene.run()?, "energy_error")?, 1.0)])
}

fn lies() -> Attempt<Pairs> {
    let rubber = Relaxation { equilibrium: 1e6, terms: vec![(3e6, 2e-3)], viscosity: 0.0 };
    let (radius, mass) = (5e-3, 4e-3);
    let scene = Sketch::of(ball(radius)).ground(crate::check::sketch::relaxing(&rubber)).accuracy(1e-2);
    let outcome = scene.machine(mass, 0.0, 0.0).fall(0.02, 3.0).steps(20).run()?;
    let depth: f64 = (0.75 * mass * GRAVITY / (1e6 * radius.sqrt())).powf(2.0 / 3.0);
    beside(&outcome, &[("final_force_n", mass * GRAVITY), ("final_indentation_m", depth)])
}
