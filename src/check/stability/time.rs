//! Viscoelastic contacts with relaxation times and steps of all lengths.

use super::{Found, Trial, Whose, powers};
use crate::check::ting::Triangle;
use crate::check::usual;
use crate::contact::adhesion::line::EdgeLine;
use crate::contact::direct::QuasiStatic;
use crate::contact::foundation::HalfSpace;
use crate::contact::viscoelastic::Spectrum;
use crate::contact::viscoelastic::layout::Layout;
use crate::contact::viscoelastic::lazy::Lazy;
use crate::contact::viscoelastic::memory::Memory;
use crate::drive::impact::{Passage, Projectile};
use crate::input::quantity::Length;
use crate::material::Relaxation;
use crate::shape::{FlatPunch, Paraboloid};
use std::sync::Arc;

pub(super) const TRIALS: &[Trial] = &[
    Trial {
        name: "relaxation times",
        range: "31 terms, 10⁻¹⁵ … 10¹⁵ s, ramps of 10⁻¹⁴ … 10¹⁴ s",
        against: "flat punch: F = 2bv[E∞t + ΣEᵢτᵢ(1 − e^(−t/τᵢ))]",
        bound: 1e-13,
        reason: "31 terms of one sign, each rounded a few times",
        whose: Whose::Ours,
        run: || decades(continuous),
    },
    Trial {
        name: "relaxation times, bed of springs",
        range: "31 terms, 10⁻¹⁵ … 10¹⁵ s, ramps of 10⁻¹⁴ … 10¹⁴ s",
        against: "flat punch: F = 2bv[E∞t + ΣEᵢτᵢ(1 − e^(−t/τᵢ))]",
        bound: 1e-13,
        reason: "31 terms and 100 springs of one sign, each rounded a few times",
        whose: Whose::Ours,
        run: || decades(springs),
    },
    Trial {
        name: "steps against relaxation time",
        range: "step/τ 10⁻³ … 10¹², up to 500 steps",
        against: "force at the turn of Ting's triangle, whatever the number of steps",
        bound: 1e-12,
        reason: "five hundred steps, each of a few roundings",
        whose: Whose::Ours,
        run: steps,
    },
    Trial {
        name: "steps against relaxation time, explicit Euler",
        range: "step/τ 10⁻³ … 10, a held spring",
        against: "E∞ + E₁e^(−t/τ); explodes from step/τ = 2",
        bound: f64::INFINITY,
        reason: "shown beside ours",
        whose: Whose::Usual,
        run: euler,
    },
    Trial {
        name: "impact",
        range: "m 10⁻¹⁵ … 10¹⁵ kg, v 10⁻⁶ … 10⁴ m/s",
        against: "Hertz: contact time 2.943275 x₀/v, greatest depth x₀",
        bound: 1e-10,
        reason: "the accuracy asked for, 10⁻¹¹, tenfold",
        whose: Whose::Ours,
        run: impacts,
    },
];

/// Force [N] on a punch after a ramp of a speed [m/s] and a duration [s].
type Ramped = fn(&Arc<Spectrum>, &Arc<FlatPunch>, (f64, f64)) -> Option<f64>;

fn continuous(spectrum: &Arc<Spectrum>, punch: &Arc<FlatPunch>, (speed, duration): (f64, f64)) -> Option<f64> {
    let mut bed = Memory::new(spectrum.clone(), punch.clone());
    bed.advance(speed, duration).ok()?;
    Some(bed.force())
}

fn springs(spectrum: &Arc<Spectrum>, punch: &Arc<FlatPunch>, (speed, duration): (f64, f64)) -> Option<f64> {
    let mut bed = Lazy::new(spectrum.clone(), Layout::uniform(punch.as_ref(), punch.radius.si(), 100));
    bed.advance(speed, duration);
    Some(bed.force())
}

fn decades(ramped: Ramped) -> Option<Found> {
    let mut found = Found::default();
    let terms: Vec<(f64, f64)> = powers(-15.0, 15.0, 1.0).map(|time| (1.0, time)).collect();
    let relaxation = Relaxation { equilibrium: 1e-3, terms, viscosity: 0.0 };
    let spectrum = Arc::new(Spectrum::new(&relaxation));
    let punch = Arc::new(FlatPunch { radius: Length::new(0.5).ok()? });
    for duration in powers(-14.0, 14.0, 0.5) {
        let speed = 0.01 / duration;
        let risen = relaxation.terms.iter().map(|(modulus, time)| -modulus * time * (-duration / time).exp_m1());
        let right = speed * (relaxation.equilibrium * duration + risen.sum::<f64>());
        found.pair(ramped(&spectrum, &punch, (speed, duration))?, right);
    }
    Some(found)
}

/// Force at the turn of a triangle of 2 s, in steps of equal length.
fn steps() -> Option<Found> {
    let mut found = Found::default();
    let ball = Arc::new(Paraboloid { radius: Length::new(1.0).ok()? });
    for count in [1i32, 10, 100, 500] {
        for ratio in powers(-3.0, 12.0, 3.0) {
            let step = f64::from(count).recip();
            let relaxation = Relaxation { equilibrium: 0.5, terms: vec![(1.0, step / ratio)], viscosity: 0.0 };
            let mut bed = Memory::new(Arc::new(Spectrum::new(&relaxation)), ball.clone());
            for _ in 0..count {
                bed.advance(0.01, step).ok()?;
            }
            found.pair(bed.force(), at_turn(relaxation));
        }
    }
    Some(found)
}

/// Force at the turn, 2√R v^{3/2} ∫₀ᵀ E*(T−s)√s ds; for short times the integral by parts,
/// τ − τ²/2 − τ³/4 − 3τ⁴/8 − 15τ⁵/16, whose next term is below 4τ⁶.
fn at_turn(relaxation: Relaxation) -> f64 {
    let (modulus, time) = relaxation.terms[0];
    if time > 3e-3 {
        return Triangle { relaxation, radius: 1.0, speed: 0.01, turn: 1.0 }.at(1.0).0;
    }
    let parts = [1.0, -1.0 / 2.0, -1.0 / 4.0, -3.0 / 8.0, -15.0 / 16.0];
    let decaying = time * parts.iter().rev().fold(0.0, |sum, part| sum * time + part);
    2.0 * 0.01f64.powf(1.5) * (relaxation.equilibrium / 1.5 + modulus * decaying)
}

fn euler() -> Option<Found> {
    let mut found = Found::default();
    for ratio in powers(-3.0, 1.0, 0.25) {
        let relaxation = Relaxation { equilibrium: 1.0, terms: vec![(3.0, 1.0)], viscosity: 0.0 };
        let forces = usual::explicit_euler(&relaxation, (&[0.0], 0.5), &[1.0; 60], ratio);
        let exact = |k: usize| 1.0 + 3.0 * (-ratio * k as f64).exp();
        let worst = forces.iter().enumerate().map(|(k, force)| (force / exact(k) - 1.0).abs()).fold(0.0, f64::max);
        found.error(worst);
    }
    Some(found)
}

fn impacts() -> Option<Found> {
    let mut found = Found::default();
    let ball = Paraboloid { radius: Length::new(0.3).ok()? };
    for mass in powers(-15.0, 15.0, 2.0) {
        for speed in powers(-6.0, 4.0, 1.0) {
            let contact = QuasiStatic::new(EdgeLine::new(HalfSpace::new(Arc::new(ball.clone()), 7.0), 0.0));
            let seen = Passage::new(&contact, Projectile { mass, speed }, 1e-11).ok()?.rebound();
            let depth = (15.0 * mass * speed * speed / (16.0 * 7.0 * 0.3f64.sqrt())).powf(0.4);
            found.pair(seen.greatest_depth, depth);
            found.pair(seen.contact_time?, 2.943_275_184_324_705 * depth / speed);
        }
    }
    Some(found)
}
