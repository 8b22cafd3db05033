//! Coulomb contacts with coefficients and amplitudes of all sizes.

use super::case;
use crate::check::case::{Attempt, Case};
use crate::check::contacts::paraboloid;
use crate::check::extreme::{Extreme, Tally, powers};
use crate::check::tangential::CattaneoMindlin;
use crate::friction::{Grip, Pose, TangentialMemory};
use crate::shape::rough::Random;
use std::f64::consts::PI;

pub(super) const CASES: &[Case] = &[
    case(
        "extremes/coefficient of friction and amplitude",
        Extreme {
            range: "μ 10⁻⁶ … 10⁶, slide 10⁻¹² of gross slip … twice it",
            against: "Cattaneo–Mindlin: tangential force",
            tried: coefficients,
        },
        1e-12,
        "a few dozen roundings; small slides are kept as differences",
    ),
    case(
        "extremes/reversals without drift",
        Extreme {
            range: "10⁶ random reversals at constant depth",
            against: "the force of first loading after a last slide beyond all turns",
            tried: reversals,
        },
        1e-13,
        "the last slide wipes out every turn: no rounding is left of them",
    ),
];

const DEPTH: f64 = 0.01;

fn exact(coefficient: f64) -> CattaneoMindlin {
    CattaneoMindlin::on_ball(DEPTH, 0.8, coefficient)
}

fn grip(coefficient: f64) -> Grip {
    Grip { normal_modulus: 1.0, tangential_modulus: 0.8, coefficient }
}

fn at(slide: f64) -> Pose {
    Pose { indentation: DEPTH, slide }
}

fn coefficients() -> Attempt<Tally> {
    let mut tally = Tally::default();
    let lens = paraboloid(1.0)?;
    for coefficient in powers(-6.0, 6.0, 0.5) {
        let exact = exact(coefficient);
        for part in powers(-12.0, 0.3, 0.3) {
            let mut memory = TangentialMemory::new(lens.clone(), grip(coefficient));
            let slide = part * exact.reach();
            memory.advance(at(0.0))?;
            memory.advance(at(slide))?;
            tally.pair(memory.state().tangential_force, exact.tangential_force(slide));
        }
    }
    Ok(tally)
}

fn reversals() -> Attempt<Tally> {
    let mut tally = Tally::default();
    let (lens, exact) = (paraboloid(1.0)?, exact(0.3));
    let mut memory = TangentialMemory::new(lens.clone(), grip(0.3));
    let mut random = Random::seeded(1);
    for _ in 0..1_000_000 {
        memory.advance(at(0.9 * exact.reach() * (random.phase() / PI - 1.0)))?;
        tally.law(memory.state().tangential_force.abs() <= exact.limit() * (1.0 + 1e-12));
    }
    // All turns lie within ±0.9 of gross slip: half the way from the lowest possible one is more than that.
    for part in [0.95, 3.0] {
        memory.advance(at(part * exact.reach()))?;
    }
    tally.pair(memory.state().tangential_force, exact.limit());
    memory.advance(at(2.0 * exact.reach()))?;
    let back = exact.masing(3.0 * exact.reach(), 2.0 * exact.reach());
    tally.error((memory.state().tangential_force - back).abs() / exact.limit());
    Ok(tally)
}
