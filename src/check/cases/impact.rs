//! Impacts with closed answers, run as whole scenes.

use crate::check::case::{Case, Proof, worst};
use crate::contact::adhesion::{Adhesion, Jkr};
use crate::friction::{Coulomb, Friction};
use crate::input::quantity::{
    Accuracy, IncidenceAngle, Length, Mass, Modulus, Poisson, Ratio, Speed, Spin, Stress, Viscosity, WorkOfAdhesion,
};
use crate::input::table::InMemory;
use crate::material::{Body, Elastic, Shear, Terms, Viscoelastic};
use crate::run::named::Finding;
use crate::run::record::Outcome;
use crate::run::{self, Wanted};
use crate::scene::Scene;
use crate::scene::history::{Entry, Impact};
use crate::shape::{FlatPunch, Paraboloid, Shape};
use std::f64::consts::{FRAC_2_PI, PI};

pub(super) const CASES: &[Case] = &[
    Case {
        name: "impact/Hertz",
        proof: Proof::Rounding,
        bound: 1e-11,
        reason: "roots within roots and the quadrature of a smooth function",
        weak: "one ball; the property tests span the decades",
        error: || hertz(elastic(), 1e-6).unwrap_or(f64::NAN),
    },
    Case {
        name: "impact/Hertz by the driven bed",
        proof: Proof::Bound,
        bound: 1e-9,
        reason: "the accuracy asked for, of a body that could relax but has nothing that does",
        weak: "without damping; the peak pressure, which is no part of the estimate, left out",
        error: || hertz(relaxing(0.0), 1e-9).unwrap_or(f64::NAN),
    },
    Case {
        name: "impact/flat punch",
        proof: Proof::Rounding,
        bound: 1e-11,
        reason: "half a period of an oscillator, by quadrature",
        weak: "a linear contact",
        error: || punch().unwrap_or(f64::NAN),
    },
    Case {
        name: "impact/adhesive restitution",
        proof: Proof::Rounding,
        bound: 1e-6,
        reason: "e² = 1 − (v_s/v)² with the seven digits of W = 7.092196 (w⁵R⁴/E*²)^{1/3}, a fifth above v_s",
        weak: "the reference is rounded",
        error: || adhesive().unwrap_or(f64::NAN),
    },
    Case {
        name: "impact/Kelvin–Voigt ball",
        proof: Proof::Other,
        bound: 4e-5,
        reason: "a bed of springs let go one by one, five digits of which the last is uncertain",
        weak: "the same model by another program",
        error: || kelvin_voigt().unwrap_or(f64::NAN),
    },
    Case {
        name: "impact/small damping",
        proof: Proof::Bound,
        bound: 1e-7,
        reason: "e = 1 − 1.9412δ + 3.0837δ² at δ = 10⁻³: five digits of 1.9412 and a third term of 6δ³",
        weak: "springs let go one by one: a law that keeps tension has 2.261 in the place of 3.0837",
        error: || small_damping().unwrap_or(f64::NAN),
    },
    Case {
        name: "impact/gross slip",
        proof: Proof::Rounding,
        bound: 1e-12,
        reason: "Δv_x = −2μv_n and Δω = −5μv_n/R where the ball slips all along",
        weak: "no stick; MBF's curve has no closed form",
        error: || gross_slip().unwrap_or(f64::NAN),
    },
    Case {
        name: "impact/stick and slip",
        proof: Proof::Rounding,
        bound: 1e-12,
        reason: "what the flight has lost is what friction took; about the contact point nothing acts",
        weak: "conservation, not the course itself",
        error: || conserved().unwrap_or(f64::NAN),
    },
];

/// E* = 1: rubber on a rigid body.
fn elastic() -> Option<Body> {
    Some(Body::Elastic(Elastic {
        young: Modulus::new(0.75).ok()?,
        poisson: Poisson::new(0.5).ok()?,
        yield_stress: None,
    }))
}

/// E∞ = 1 with a dashpot η, E*(t) = 4G(t).
fn relaxing(viscosity: f64) -> Option<Body> {
    let shear = Shear {
        equilibrium: Stress::new(0.25).ok()?,
        viscosity: Viscosity::new(0.25 * viscosity).ok()?,
        terms: Terms::default(),
    };
    Some(Body::Viscoelastic(Viscoelastic { poisson: Poisson::new(0.5).ok()?, shear }))
}

/// Mass 1 and R = 1.
fn scene(body: Option<Body>, speed: f64) -> Option<Scene> {
    let (mass, speed) = (Mass::new(1.0).ok()?, vec![Speed::new(speed).ok()?]);
    Some(Scene {
        title: String::new(),
        shape: Shape::Paraboloid(Paraboloid { radius: Length::new(1.0).ok()? }),
        bodies: (body?, Body::Rigid),
        adhesion: None,
        friction: None,
        history: vec![Entry::Impact(Impact { mass, speed, angle: None, spin: None })],
        accuracy: None,
        springs: None,
        steps: None,
        plots: None,
    })
}

fn run(scene: Scene) -> Option<Outcome> {
    let setup = scene.resolve(&InMemory::default()).ok()?;
    run::run(&setup, Wanted::NOTHING).ok()
}

/// x₀ = (15mv²/16)^{2/5}, time 2.943275184324705 x₀/v, F = (4/3)x₀^{3/2}, p₀ = (2/π)√x₀, e = 1; and the ledger.
fn hertz(body: Option<Body>, accuracy: f64) -> Option<f64> {
    let speed = 0.3;
    let exact = matches!(body, Some(Body::Elastic(_)));
    let outcome = run(Scene { accuracy: Accuracy::new(accuracy).ok(), ..scene(body, speed)? })?;
    let number = |name| outcome.number(name);
    let depth = (0.9375 * speed * speed).powf(0.4);
    let mut pairs = vec![
        (number("largest_indentation_m")?, depth),
        (number("contact_time_s")?, 2.943_275_184_324_705 * depth / speed),
        (number("largest_force_n")?, 4.0 / 3.0 * depth * depth.sqrt()),
        (number("restitution")?, 1.0),
        (1.0 + number("dissipated_j")?, 1.0),
    ];
    if exact {
        pairs.push((number("peak_pressure_pa")?, FRAC_2_PI * depth.sqrt()));
    }
    Some(worst(&pairs))
}

fn punch() -> Option<f64> {
    let shape = Shape::FlatPunch(FlatPunch { radius: Length::new(0.5).ok()? });
    let outcome = run(Scene { shape, ..scene(elastic(), 0.7)? })?;
    let number = |name| outcome.number(name);
    Some(worst(&[
        (number("contact_time_s")?, PI),
        (number("largest_indentation_m")?, 0.7),
        (number("restitution")?, 1.0),
    ]))
}

fn adhesive() -> Option<f64> {
    let sticking = (2.0 * 7.092_196f64).sqrt();
    let hit = |ratio: f64| {
        let adhesion = Some(Adhesion::Jkr(Jkr { work: WorkOfAdhesion::new(1.0).ok()?, edge: None }));
        run(Scene { adhesion, ..scene(elastic(), ratio * sticking)? })
    };
    let mut pairs = Vec::new();
    for ratio in [1.2, 2.0, 10.0] {
        pairs.push((hit(ratio)?.number("restitution")?, (1.0 - 1.0 / (ratio * ratio)).sqrt()));
    }
    let stuck = hit(0.999)?;
    let sticks = stuck.named("sticks") == Some(Finding::Answer(true));
    pairs.push((stuck.number("restitution")?, if sticks { 0.0 } else { 1.0 }));
    Some(worst(&pairs))
}

/// Restitution of a Kelvin–Voigt ball with δ = (η/E∞)(E∞²Rv/m²)^{1/5}.
fn damped(delta: f64, accuracy: f64) -> Option<f64> {
    let outcome = run(Scene { accuracy: Accuracy::new(accuracy).ok(), ..scene(relaxing(delta), 1.0)? })?;
    outcome.number("restitution")
}

fn kelvin_voigt() -> Option<f64> {
    let table = [(0.01, 0.98089), (0.05, 0.91012), (0.1, 0.83272), (0.2, 0.70673), (0.5, 0.46894), (1.0, 0.28082)];
    let pairs: Option<Vec<_>> = table.iter().map(|&(delta, right)| Some((damped(delta, 1e-6)?, right))).collect();
    Some(worst(&pairs?))
}

fn small_damping() -> Option<f64> {
    let delta = 1e-3;
    let second = 0.6 * 1.9412f64.powi(2) + 5.0 / 6.0 * (15.0f64 / 16.0).powf(0.2);
    Some(worst(&[(damped(delta, 1e-9)?, 1.0 - 1.9412 * delta + second * delta * delta)]))
}

/// A ball at the angle `angle` [rad] with the spin `spin` [rad/s], μ = 0.2.
fn oblique(angle: f64, spin: f64) -> Option<Outcome> {
    let (angle, spin) = (Some(IncidenceAngle::new(angle).ok()?), Some(Spin::new(spin).ok()?));
    let history =
        vec![Entry::Impact(Impact { mass: Mass::new(1.0).ok()?, speed: vec![Speed::new(0.1).ok()?], angle, spin })];
    let friction = Some(Friction::Coulomb(Coulomb { coefficient: Ratio::new(0.2).ok()? }));
    run(Scene { history, friction, ..scene(elastic(), 0.1)? })
}

fn gross_slip() -> Option<f64> {
    let angle = 1.2f64;
    let outcome = oblique(angle, 0.0)?;
    let (normal, tangential) = (0.1 * angle.cos(), 0.1 * angle.sin());
    let after = tangential - 0.4 * normal;
    let number = |name| outcome.number(name);
    Some(worst(&[
        (number("rebound_angle_rad")?, after.atan2(normal)),
        (number("rebound_spin_rad_per_s")?, -normal),
        (number("rebound_speed_m_per_s")?, after.hypot(normal)),
        (number("impulse_ratio")?, 0.2),
        (number("restitution")?, 1.0),
    ]))
}

fn conserved() -> Option<f64> {
    let mut pairs = Vec::new();
    for (angle, spin) in [(0.1f64, 0.0), (0.3, 0.0), (0.5, -0.02), (0.2, 0.03)] {
        let outcome = oblique(angle, spin)?;
        let number = |name| outcome.number(name);
        let (speed, turned) = (number("rebound_speed_m_per_s")?, number("rebound_spin_rad_per_s")?);
        let energy = |v: f64, w: f64| 0.5 * v * v + 0.2 * w * w;
        pairs.push((energy(speed, turned) + number("friction_dissipated_j")?, energy(0.1, spin)));
        let about = |v: f64, w: f64| 1.0 + v - 0.4 * w;
        let sideways = speed * number("rebound_angle_rad")?.sin();
        pairs.push((about(sideways, turned), about(0.1 * angle.sin(), spin)));
    }
    Some(worst(&pairs))
}
