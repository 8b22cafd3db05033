//! Viscoelastic contacts with relaxation times and steps of all lengths.

use super::case;
use crate::check::case::{Attempt, Case};
use crate::check::contacts::{paraboloid, plain};
use crate::check::extreme::{Extreme, Tally, powers};
use crate::check::sketch::si;
use crate::check::ting::TingTriangle;
use crate::check::ways::script::Steps;
use crate::contact::viscoelastic::layout::Layout;
use crate::contact::viscoelastic::lazy::Lazy;
use crate::contact::viscoelastic::memory::Memory;
use crate::drive::impact::{Passage, Projectile};
use crate::material::{Relaxation, Spectrum};
use crate::shape::FlatPunch;
use std::sync::Arc;

pub(super) const CASES: &[Case] = &[
    case(
        "extremes/relaxation times",
        Extreme {
            range: "31 terms, 10⁻¹⁵ … 10¹⁵ s, ramps of 10⁻¹⁴ … 10¹⁴ s",
            against: "flat punch: F = 2bv[E∞t + ΣEᵢτᵢ(1 − e^(−t/τᵢ))]",
            tried: || decades(continuous),
        },
        1e-13,
        "31 terms of one sign, each rounded a few times",
    ),
    case(
        "extremes/relaxation times, bed of springs",
        Extreme {
            range: "31 terms, 10⁻¹⁵ … 10¹⁵ s, ramps of 10⁻¹⁴ … 10¹⁴ s",
            against: "flat punch: F = 2bv[E∞t + ΣEᵢτᵢ(1 − e^(−t/τᵢ))]",
            tried: || decades(springs),
        },
        1e-13,
        "31 terms and 100 springs of one sign, each rounded a few times",
    ),
    case(
        "extremes/steps against relaxation time",
        Extreme {
            range: "step/τ 10⁻³ … 10¹², up to 500 steps",
            against: "force at the turn of Ting's triangle, whatever the number of steps",
            tried: steps,
        },
        1e-12,
        "five hundred steps, each of a few roundings",
    ),
    case(
        "extremes/impact",
        Extreme {
            range: "m 10⁻¹⁵ … 10¹⁵ kg, v 10⁻⁶ … 10⁴ m/s",
            against: "Hertz: contact time 2.943275 x₀/v, greatest depth x₀",
            tried: impacts,
        },
        1e-10,
        "the accuracy asked for, 10⁻¹¹, tenfold",
    ),
];

/// The usual way, shown beside ours and held to nothing.
pub(in crate::check) const EXPLICIT_EULER: Case = case(
    "extremes/steps against relaxation time, explicit Euler",
    Extreme {
        range: "step/τ 10⁻³ … 10, a held spring",
        against: "E∞ + E₁e^(−t/τ); explodes from step/τ = 2",
        tried: euler,
    },
    f64::INFINITY,
    "shown beside ours",
);

/// Force [N] on a punch after a ramp of a speed [m/s] and a duration [s].
type Ramped = fn(Arc<Spectrum>, Arc<FlatPunch>, f64, f64) -> Attempt<f64>;

fn continuous(spectrum: Arc<Spectrum>, punch: Arc<FlatPunch>, speed: f64, duration: f64) -> Attempt<f64> {
    let mut bed = Memory::new(spectrum, punch);
    bed.advance(speed, duration)?;
    Ok(bed.force())
}

fn springs(spectrum: Arc<Spectrum>, punch: Arc<FlatPunch>, speed: f64, duration: f64) -> Attempt<f64> {
    let mut bed = Lazy::new(spectrum, Layout::uniform(punch.as_ref(), punch.radius.si(), 100));
    bed.advance(speed, duration);
    Ok(bed.force())
}

fn decades(ramped: Ramped) -> Attempt<Tally> {
    let mut tally = Tally::default();
    let terms: Vec<(f64, f64)> = powers(-15.0, 15.0, 1.0).map(|time| (1.0, time)).collect();
    let relaxation = Relaxation { equilibrium: 1e-3, terms, viscosity: 0.0 };
    let spectrum = Arc::new(Spectrum::new(&relaxation));
    let punch = Arc::new(FlatPunch { radius: si(0.5)? });
    for duration in powers(-14.0, 14.0, 0.5) {
        let speed = 0.01 / duration;
        let risen = relaxation.terms.iter().map(|(modulus, time)| -modulus * time * (-duration / time).exp_m1());
        let right = speed * (relaxation.equilibrium * duration + risen.sum::<f64>());
        tally.pair(ramped(spectrum.clone(), punch.clone(), speed, duration)?, right);
    }
    Ok(tally)
}

/// Force at the turn of a triangle of 2 s, in steps of equal length.
fn steps() -> Attempt<Tally> {
    let mut tally = Tally::default();
    let ball = paraboloid(1.0)?;
    for count in [1i32, 10, 100, 500] {
        for ratio in powers(-3.0, 12.0, 3.0) {
            let step = f64::from(count).recip();
            let relaxation = Relaxation { equilibrium: 0.5, terms: vec![(1.0, step / ratio)], viscosity: 0.0 };
            let mut bed = Memory::new(Arc::new(Spectrum::new(&relaxation)), ball.clone());
            for _ in 0..count {
                bed.advance(0.01, step)?;
            }
            tally.pair(bed.force(), at_turn(relaxation));
        }
    }
    Ok(tally)
}

/// Force at the turn, 2√R v^{3/2} ∫₀ᵀ E*(T−s)√s ds; for short times the integral by parts,
/// τ − τ²/2 − τ³/4 − 3τ⁴/8 − 15τ⁵/16, whose next term is below 4τ⁶.
fn at_turn(relaxation: Relaxation) -> f64 {
    let (modulus, time) = relaxation.terms[0];
    if time > 3e-3 {
        return TingTriangle { relaxation, radius: 1.0, speed: 0.01, turn: 1.0 }.force(1.0, 1.0);
    }
    let parts = [1.0, -1.0 / 2.0, -1.0 / 4.0, -3.0 / 8.0, -15.0 / 16.0];
    let decaying = time * parts.iter().rev().fold(0.0, |sum, part| sum * time + part);
    2.0 * 0.01f64.powf(1.5) * (relaxation.equilibrium / 1.5 + modulus * decaying)
}

fn euler() -> Attempt<Tally> {
    let mut tally = Tally::default();
    let relaxation = Relaxation { equilibrium: 1.0, terms: vec![(3.0, 1.0)], viscosity: 0.0 };
    for ratio in powers(-3.0, 1.0, 0.25) {
        let steps = Steps { depths: vec![1.0; 60], step: ratio };
        let forces = steps.explicit_euler(&relaxation, &[0.0], 0.5);
        let exact = |k: usize| 1.0 + 3.0 * (-ratio * k as f64).exp();
        tally.error(forces.iter().enumerate().map(|(k, force)| (force / exact(k) - 1.0).abs()).fold(0.0, f64::max));
    }
    Ok(tally)
}

fn impacts() -> Attempt<Tally> {
    let mut tally = Tally::default();
    let ball = paraboloid(0.3)?;
    for mass in powers(-15.0, 15.0, 2.0) {
        for speed in powers(-6.0, 4.0, 1.0) {
            let contact = plain(ball.clone(), 7.0);
            let seen = Passage::new(&contact, Projectile { mass, speed }, 1e-11)?.rebound();
            let depth = (15.0 * mass * speed * speed / (16.0 * 7.0 * 0.3f64.sqrt())).powf(0.4);
            tally.pair(seen.greatest_depth, depth);
            let time = seen.contact_time.ok_or("the bodies do not part")?;
            tally.pair(time, 2.943_275_184_324_705 * depth / speed);
        }
    }
    Ok(tally)
}
