//! Coulomb contacts with coefficients and amplitudes of all sizes.

use super::{Found, Trial, Whose, powers};
use crate::check::closed_forms;
use crate::check::tangential::CattaneoMindlin;
use crate::friction::{Grip, Pose, TangentialMemory};
use crate::input::quantity::Length;
use crate::shape::Paraboloid;
use crate::shape::rough::Random;
use std::sync::Arc;

pub(super) const TRIALS: &[Trial] = &[
    Trial {
        name: "coefficient of friction and amplitude",
        range: "μ 10⁻⁶ … 10⁶, slide 10⁻¹² of gross slip … twice it",
        against: "Cattaneo–Mindlin: tangential force",
        bound: 1e-12,
        reason: "a few dozen roundings; small slides are kept as differences",
        whose: Whose::Ours,
        run: coefficients,
    },
    Trial {
        name: "reversals without drift",
        range: "10⁶ random reversals at constant depth",
        against: "the force of first loading after a last slide beyond all turns",
        bound: 1e-13,
        reason: "the last slide wipes out every turn: no rounding is left of them",
        whose: Whose::Ours,
        run: reversals,
    },
];

const DEPTH: f64 = 0.01;

fn lens() -> Option<Paraboloid> {
    Some(Paraboloid { radius: Length::new(1.0).ok()? })
}

fn exact(coefficient: f64) -> CattaneoMindlin {
    let hertz = closed_forms::hertz(1.0, DEPTH);
    CattaneoMindlin { force: hertz.force, contact_radius: hertz.radius, tangential_modulus: 0.8, coefficient }
}

fn grip(coefficient: f64) -> Grip {
    Grip { normal_modulus: 1.0, tangential_modulus: 0.8, coefficient }
}

fn coefficients() -> Option<Found> {
    let mut found = Found::default();
    let lens = lens()?;
    for coefficient in powers(-6.0, 6.0, 0.5) {
        let exact = exact(coefficient);
        for part in powers(-12.0, 0.3, 0.3) {
            let mut memory = TangentialMemory::new(Arc::new(lens.clone()), grip(coefficient));
            memory.advance(Pose { indentation: DEPTH, slide: 0.0 }).ok()?;
            let slide = part * exact.reach();
            memory.advance(Pose { indentation: DEPTH, slide }).ok()?;
            found.pair(memory.state().tangential_force, exact.tangential_force(slide));
        }
    }
    Some(found)
}

fn reversals() -> Option<Found> {
    let mut found = Found::default();
    let (lens, exact) = (lens()?, exact(0.3));
    let mut memory = TangentialMemory::new(Arc::new(lens.clone()), grip(0.3));
    let mut random = Random::seeded(1);
    for _ in 0..1_000_000 {
        let slide = 0.9 * exact.reach() * (random.phase() / std::f64::consts::PI - 1.0);
        memory.advance(Pose { indentation: DEPTH, slide }).ok()?;
        found.law(memory.state().tangential_force.abs() <= exact.limit() * (1.0 + 1e-12));
    }
    memory.advance(Pose { indentation: DEPTH, slide: 0.95 * exact.reach() }).ok()?;
    // All turns lie within ±0.9 of gross slip: half the way from the lowest possible one is more than that.
    memory.advance(Pose { indentation: DEPTH, slide: 3.0 * exact.reach() }).ok()?;
    found.pair(memory.state().tangential_force, exact.limit());
    let back = exact.masing(3.0 * exact.reach(), 2.0 * exact.reach());
    memory.advance(Pose { indentation: DEPTH, slide: 2.0 * exact.reach() }).ok()?;
    found.error((memory.state().tangential_force - back).abs() / exact.limit());
    Some(found)
}
