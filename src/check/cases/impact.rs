//! Impacts with closed answers, run as whole scenes: mass 1, R = 1, E* = 1.

use crate::check::case::{Attempt, Case, Pairs, Proof};
use crate::check::sketch::{Sketch, ball, beside, relaxing, result, si};
use crate::material::{Body, Relaxation};
use crate::run::named::Finding;
use crate::run::record::Outcome;
use crate::shape::{FlatPunch, Shape};
use std::f64::consts::{FRAC_2_PI, PI};

pub(super) const CASES: &[Case] = &[
    Case::new("impact/Hertz", Proof::Rounding, 1e-11, "roots within roots and the quadrature of a smooth function")
        .weak("one ball; the property tests span the decades")
        .by(hertz_elastic),
    Case::new(
        "impact/Hertz by the driven bed",
        Proof::Bound,
        1e-9,
        "the accuracy asked for, of a body that could relax but has nothing that does",
    )
    .weak("without damping; the peak pressure, which is no part of the estimate, left out")
    .by(hertz_driven),
    Case::new("impact/flat punch", Proof::Rounding, 1e-11, "half a period of an oscillator, by quadrature")
        .weak("a linear contact")
        .by(punch),
    Case::new(
        "impact/adhesive restitution",
        Proof::Rounding,
        1e-6,
        "e² = 1 − (v_s/v)² with the seven digits of W = 7.092196 (w⁵R⁴/E*²)^{1/3}, a fifth above v_s",
    )
    .weak("the reference is rounded")
    .by(adhesive),
    Case::new(
        "impact/Kelvin–Voigt ball",
        Proof::Other,
        4e-5,
        "a bed of springs let go one by one, five digits of which the last is uncertain",
    )
    .weak("the same model by another program")
    .by(kelvin_voigt),
    Case::new(
        "impact/small damping",
        Proof::Bound,
        1e-7,
        "e = 1 − 1.9412δ + 3.0837δ² at δ = 10⁻³: five digits of 1.9412 and a third term of 6δ³",
    )
    .weak("springs let go one by one: a law that keeps tension has 2.261 in the place of 3.0837")
    .by(small_damping),
    Case::new(
        "impact/gross slip",
        Proof::Rounding,
        1e-12,
        "Δv_x = −2μv_n and Δω = −5μv_n/R where the ball slips all along",
    )
    .weak("no stick; MBF's curve has no closed form")
    .by(gross_slip),
    Case::new(
        "impact/stick and slip",
        Proof::Rounding,
        1e-12,
        "what the flight has lost is what friction took; about the contact point nothing acts",
    )
    .weak("conservation, not the course itself")
    .by(conserved),
    Case::new(
        "impact/oblique on a body that relaxes",
        Proof::Bound,
        1e-4,
        "a grazing ball slips all along and loses μ(1 + e) of its normal speed, e that of the impact; with next to no Prony term it rebounds as from an elastic body: steps and springs doubled until ψ₂ settles to 1e-4",
    )
    .weak("relative to the normal speed; what lies between the limits has no closed form")
    .by(relaxing_along),
];

/// A ball with a dashpot η beside E∞ = 1.
fn damped_ball(viscosity: f64) -> Sketch {
    Sketch::of(ball(1.0)).body(relaxing(&Relaxation { equilibrium: 1.0, terms: Vec::new(), viscosity }))
}

/// Speed [m/s] of the Hertz impact.
const SPEED: f64 = 0.3;

/// x₀ = (15mv²/16)^{2/5}.
fn greatest_depth() -> f64 {
    (0.9375 * SPEED * SPEED).powf(0.4)
}

/// Contact time 2.943275184324705 x₀/v, F = (4/3)x₀^{3/2}, e = 1; and the ledger.
fn hertz(outcome: &Outcome) -> Attempt<Pairs> {
    let depth = greatest_depth();
    let mut pairs = beside(
        outcome,
        &[
            ("largest_indentation_m", depth),
            ("contact_time_s", 2.943_275_184_324_705 * depth / SPEED),
            ("largest_force_n", 4.0 / 3.0 * depth * depth.sqrt()),
            ("restitution", 1.0),
        ],
    )?;
    pairs.push((1.0 + result(outcome, "dissipated_j")?, 1.0));
    Ok(pairs)
}

/// p₀ = (2/π)√x₀ besides.
fn hertz_elastic() -> Attempt<Pairs> {
    let outcome = Sketch::of(ball(1.0)).impact(SPEED).accuracy(1e-6).run()?;
    let pressure = beside(&outcome, &[("peak_pressure_pa", FRAC_2_PI * greatest_depth().sqrt())])?;
    Ok([hertz(&outcome)?, pressure].concat())
}

fn hertz_driven() -> Attempt<Pairs> {
    hertz(&damped_ball(0.0).impact(SPEED).accuracy(1e-9).run()?)
}

fn punch() -> Attempt<Pairs> {
    let punch = si(0.5).map(|radius| Shape::FlatPunch(FlatPunch { radius }));
    let outcome = Sketch::of(punch).impact(0.7).run()?;
    beside(&outcome, &[("contact_time_s", PI), ("largest_indentation_m", 0.7), ("restitution", 1.0)])
}

fn adhesive() -> Attempt<Pairs> {
    let sticking = (2.0 * 7.092_196f64).sqrt();
    let hit = |ratio: f64| Sketch::of(ball(1.0)).jkr(1.0, None).impact(ratio * sticking).run();
    let mut pairs = Vec::new();
    for ratio in [1.2, 2.0, 10.0] {
        pairs.push((result(&hit(ratio)?, "restitution")?, (1.0 - 1.0 / (ratio * ratio)).sqrt()));
    }
    let stuck = hit(0.999)?;
    if stuck.named("sticks") != Some(Finding::Answer(true)) {
        return Err("a ball slower than the sticking speed does not stick".into());
    }
    pairs.push((result(&stuck, "restitution")?, 0.0));
    Ok(pairs)
}

/// Restitution of a Kelvin–Voigt ball with δ = (η/E∞)(E∞²Rv/m²)^{1/5}.
fn damped(delta: f64, accuracy: f64) -> Attempt<f64> {
    result(&damped_ball(delta).impact(1.0).accuracy(accuracy).run()?, "restitution")
}

fn kelvin_voigt() -> Attempt<Pairs> {
    let table = [(0.01, 0.98089), (0.05, 0.91012), (0.1, 0.83272), (0.2, 0.70673), (0.5, 0.46894), (1.0, 0.28082)];
    table.iter().map(|&(delta, right)| Ok((damped(delta, 1e-6)?, right))).collect()
}

fn small_damping() -> Attempt<Pairs> {
    let delta = 1e-3;
    let second = 0.6 * 1.9412f64.powi(2) + 5.0 / 6.0 * (15.0f64 / 16.0).powf(0.2);
    Ok(vec![(damped(delta, 1e-9)?, 1.0 - 1.9412 * delta + second * delta * delta)])
}

/// A ball of 0.1 m/s at the angle `angle` [rad] with the spin `spin` [rad/s], μ = 0.2.
fn oblique(angle: f64, spin: f64) -> Attempt<Outcome> {
    Sketch::of(ball(1.0)).coulomb(0.2).oblique(0.1, angle, spin).run()
}

/// The same on another body.
fn oblique_on(body: Attempt<Body>, angle: f64, spin: f64) -> Attempt<Outcome> {
    Sketch::of(ball(1.0)).body(body).coulomb(0.2).oblique(0.1, angle, spin).run()
}

fn gross_slip() -> Attempt<Pairs> {
    let angle = 1.2f64;
    let (normal, tangential) = (0.1 * angle.cos(), 0.1 * angle.sin());
    let after = tangential - 0.4 * normal;
    beside(
        &oblique(angle, 0.0)?,
        &[
            ("rebound_angle_rad", after.atan2(normal)),
            ("rebound_spin_rad_per_s", -normal),
            ("rebound_speed_m_per_s", after.hypot(normal)),
            ("impulse_ratio", 0.2),
            ("restitution", 1.0),
        ],
    )
}

/// The grazing ball, and at four angles the elastic one beside one of next to no term; speeds over the normal one.
fn relaxing_along() -> Attempt<Pairs> {
    let rubber = Relaxation { equilibrium: 0.5, terms: vec![(0.5, 2.0)], viscosity: 0.0 };
    let angle = 1.2f64;
    let grazing = oblique_on(relaxing(&rubber), angle, 0.0)?;
    let (normal, tangential) = (0.1 * angle.cos(), 0.1 * angle.sin());
    let restitution = result(&grazing, "restitution")?;
    let after = tangential - 0.2 * (1.0 + restitution) * normal;
    let speed = result(&grazing, "rebound_speed_m_per_s")?;
    let mut pairs = vec![((speed - after.hypot(restitution * normal)) / normal, 0.0)];
    let faint = Relaxation { equilibrium: 1.0, terms: vec![(1e-9, 1.0)], viscosity: 0.0 };
    for (angle, spin) in [(0.1f64, 0.0), (0.3, 0.0), (0.5, -0.02), (0.2, 0.03)] {
        let (elastic, other) = (oblique(angle, spin)?, oblique_on(relaxing(&faint), angle, spin)?);
        for name in ["rebound_speed_m_per_s", "rebound_spin_rad_per_s"] {
            pairs.push(((result(&other, name)? - result(&elastic, name)?) / (0.1 * angle.cos()), 0.0));
        }
    }
    Ok(pairs)
}

fn conserved() -> Attempt<Pairs> {
    let mut pairs = Vec::new();
    for (angle, spin) in [(0.1f64, 0.0), (0.3, 0.0), (0.5, -0.02), (0.2, 0.03)] {
        let outcome = oblique(angle, spin)?;
        let number = |name| result(&outcome, name);
        let (speed, turned) = (number("rebound_speed_m_per_s")?, number("rebound_spin_rad_per_s")?);
        let energy = |v: f64, w: f64| 0.5 * v * v + 0.2 * w * w;
        pairs.push((energy(speed, turned) + number("friction_dissipated_j")?, energy(0.1, spin)));
        let about = |v: f64, w: f64| 1.0 + v - 0.4 * w;
        let sideways = speed * number("rebound_angle_rad")?.sin();
        pairs.push((about(sideways, turned), about(0.1 * angle.sin(), spin)));
    }
    Ok(pairs)
}
