//! Bodies that glide and roll over bodies that remember, run as whole scenes, against closed forms.

use crate::check::case::{Attempt, Case, Pairs, Proof};
use crate::check::sketch::{Sketch, ball, beside, relaxing, result, si};
use crate::material::Relaxation;
use crate::shape::{Cone, Shape};
use std::f64::consts::FRAC_PI_2;

const CHORDS: &str = "chords of second order, halved until they change nothing above 1e-8";

pub(super) const CASES: &[Case] = &[
    Case::new("gliding/wedge on Kelvin–Voigt", Proof::Rounding, 1e-12, "μ/c = s(4 − s)/(2 + s²), s = ηvc/(Ed), and c from s = 1 on; a wedge is its own polygon: sums of some hundred terms")
        .weak("no Maxwell elements; the property tests take any modulus, slope and depth")
        .by(wedge),
    Case::new("gliding/paraboloid on Kelvin–Voigt", Proof::Bound, 2e-8, CHORDS)
        .weak("integrals over f between the front √(Rd) and the rear τv − √((τv)² + Rd)")
        .by(paraboloid),
    Case::new("gliding/slow", Proof::Bound, 2e-6, "F_x = vΣEᵢτᵢ∫g′²dξ up to vτ/a = 1e-6 of itself, in chords to 1e-6")
        .weak("a limit of many decades, at one speed")
        .by(slow),
    Case::new("gliding/fast", Proof::Bound, 2e-6, "f = E(0)u: Hertz with E(0), up to a/vτ = 1e-6 of itself, in chords to 1e-6")
        .weak("the force; the resistance there is what is left of it")
        .by(fast),
    Case::new("gliding/start", Proof::Order, 1e-4, "springs of a 708th of the contact, of second order, their edges within a part of a spring")
        .weak("against the steady state of the same model, found another way")
        .by(start),
    Case::new("gliding/power is heat", Proof::Order, 1e-4, "springs of a 708th of the contact: heat on the last half of the way against the resistance times that way")
        .weak("against the steady state of the same model, found another way")
        .by(heat),
];

/// Slope of the one-dimensional profile of the wedge.
const SLOPE: f64 = 0.2;

fn dashpot() -> Relaxation {
    Relaxation { equilibrium: 4.0, terms: Vec::new(), viscosity: 2.0 }
}

fn solid() -> Relaxation {
    Relaxation { equilibrium: 1.0, terms: vec![(3.0, 0.3), (2.0, 5.0)], viscosity: 0.0 }
}

fn on(relaxation: &Relaxation, shape: Attempt<Shape>) -> Sketch {
    Sketch::of(shape).ground(relaxing(relaxation)).steps(4)
}

fn wedge() -> Attempt<Pairs> {
    let depth = 1e-3;
    let coefficient = |s: f64| {
        let shape = si(SLOPE / FRAC_PI_2).map(|slope| Shape::Cone(Cone { slope }));
        let speed = s * depth * dashpot().equilibrium / (dashpot().viscosity * SLOPE);
        result(&on(&dashpot(), shape).indent(depth, 1.0).glide(speed, None).run()?, "resistance_coefficient")
    };
    let right = |s: f64| if s < 1.0 { SLOPE * s * (4.0 - s) / (2.0 + s * s) } else { SLOPE };
    let all = (1..=20).map(|k| 0.1 * f64::from(k));
    all.map(|s| Ok((coefficient(s)?, right(s)))).collect()
}

fn paraboloid() -> Attempt<Pairs> {
    let (modulus, depth) = (dashpot().equilibrium, 0.01f64);
    let mut pairs = Vec::new();
    for way in [0.001, 0.03, 0.1, 1.0] {
        let speed = way * modulus / dashpot().viscosity;
        let scene = on(&dashpot(), ball(1.0)).accuracy(1e-8).indent(depth, 1.0).glide(speed, None);
        // f = E(d − ξ² + 2τvξ), F_x = ∫ f 2ξ dξ, R = 1.
        let force = |x: f64| modulus * (depth * x - x.powi(3) / 3.0 + way * x * x);
        let drag = |x: f64| modulus * (depth * x * x - 0.5 * x.powi(4) + 4.0 / 3.0 * way * x.powi(3));
        let (front, rear) = (depth.sqrt(), -depth / (way + way.hypot(depth.sqrt())));
        let (force, drag) = (force(front) - force(rear), drag(front) - drag(rear));
        let right = [("tangential_force_n", drag), ("resistance_coefficient", drag / force), ("leading_edge_m", front)];
        pairs.extend(beside(&scene.run()?, &right)?);
    }
    Ok(pairs)
}

fn slow() -> Attempt<Pairs> {
    let (speed, depth) = (1e-9, 1e-4f64);
    let outcome = on(&solid(), ball(1.0)).indent(depth, 1.0).glide(speed, None).run()?;
    let loss: f64 = solid().terms.iter().map(|(modulus, time)| modulus * time).sum();
    // ∫ (2ξ)² dξ from −√d to √d.
    beside(&outcome, &[("tangential_force_n", speed * loss * 8.0 / 3.0 * depth.powf(1.5))])
}

fn fast() -> Attempt<Pairs> {
    let (speed, depth) = (1e6, 1e-2f64);
    let outcome = on(&solid(), ball(1.0)).indent(depth, 1.0).glide(speed, None).run()?;
    let (coefficient, drag) = (result(&outcome, "resistance_coefficient")?, result(&outcome, "tangential_force_n")?);
    Ok(vec![(drag / coefficient, 4.0 / 3.0 * solid().instantaneous() * depth.powf(1.5))])
}

/// Way [m] and speed [m/s] of a start: more than the contact is wide.
const WAY: f64 = 0.4;
const SPEED: f64 = 0.2;

fn started() -> Sketch {
    on(&solid(), ball(1.0)).indent(0.01, 1.0).glide(SPEED, Some(WAY / SPEED))
}

fn start() -> Attempt<Pairs> {
    let outcome = started().run()?;
    let steady = result(&outcome, "steady_resistance_coefficient")?;
    beside(&outcome, &[("resistance_coefficient", steady)])
}

fn heat() -> Attempt<Pairs> {
    let outcome = started().run()?;
    let energy = |time: f64| {
        let record = outcome.records.iter().find(|record| (record.time - time).abs() < 1e-9);
        record.map(|record| record.normal.dissipated + record.normal.stored.elastic).ok_or("no record in the middle")
    };
    let (middle, end) = (energy(1.0 + 0.5 * WAY / SPEED)?, energy(1.0 + WAY / SPEED)?);
    Ok(vec![((end - middle) / (0.5 * WAY), result(&outcome, "steady_tangential_force_n")?)])
}
