//! Laws that every bed obeys, on random materials and histories.

use super::direct::Direct;
use super::layout::Layout;
use super::lazy::Lazy;
use super::{Motion, Spectrum};
use crate::input::quantity::Length;
use crate::material::Relaxation;
use crate::shape::Paraboloid;
use proptest::prelude::*;
use std::sync::Arc;

/// A random material: moduli over 12 and times over 30 decades.
#[derive(Debug, Clone)]
pub(crate) struct Recipe {
    pub equilibrium: Option<i32>,
    pub terms: Vec<(i32, i32)>,
    pub viscosity: Option<i32>,
}

impl Recipe {
    pub(crate) fn relaxation(&self) -> Relaxation {
        let value = |k: Option<i32>| k.map_or(0.0, |k| 10f64.powf(0.1 * f64::from(k)));
        let term = |&(e, tau): &(i32, i32)| (value(Some(e)), 10f64.powf(0.1 * f64::from(tau)));
        Relaxation {
            equilibrium: value(self.equilibrium),
            terms: self.terms.iter().map(term).collect(),
            viscosity: value(self.viscosity),
        }
    }
}

pub(crate) fn recipe(most: usize) -> impl Strategy<Value = Recipe> {
    let terms = prop::collection::vec((-60i32..60, -150i32..150), 1..most);
    let recipe = (prop::option::weighted(0.7, -60i32..60), terms, prop::option::weighted(0.2, -60i32..60));
    recipe.prop_map(|(equilibrium, terms, viscosity)| Recipe { equilibrium, terms, viscosity })
}

/// A random history: depths in hundredths of the greatest one, durations over 8 decades.
pub(crate) fn history(most: usize) -> impl Strategy<Value = Vec<Motion>> {
    let turns = prop::collection::vec((-20i32..100, -40i32..40), 2..most);
    turns.prop_map(|turns| {
        let mut start = 0.0;
        let motion = |(depth, time): (i32, i32)| {
            let (end, duration) = (0.01 * f64::from(depth), 10f64.powf(0.1 * f64::from(time)));
            let motion = Motion { start, speed: (end - start) / duration, duration };
            start = motion.end();
            motion
        };
        turns.into_iter().map(motion).collect()
    })
}

pub(crate) fn unit_ball() -> Paraboloid {
    Paraboloid { radius: Length::new(1.0).unwrap() }
}

proptest! {
    #![proptest_config(crate::laws::cases(128))]

    /// Force of both beds after every motion; the bound is the rounding of the sums, relative to the
    /// greatest force of the history.
    #[test]
    fn lazy_bed_is_the_direct_bed(recipe in recipe(8), history in history(12)) {
        let spectrum = Arc::new(Spectrum::new(&recipe.relaxation()));
        let layout = Layout::uniform(&unit_ball(), 1.0, 40);
        let mut direct = Direct::new(spectrum.clone(), layout.clone());
        let mut lazy = Lazy::new(spectrum, layout);
        let mut greatest = 0f64;
        for motion in history {
            direct.advance(motion.speed, motion.duration);
            lazy.advance(motion.speed, motion.duration);
            greatest = greatest.max(direct.force());
            prop_assert!((direct.force() - lazy.force()).abs() <= 1e-11 * greatest, "{} {}", direct.force(), lazy.force());
            prop_assert!((direct.stored() - lazy.ledger().stored).abs() <= 1e-11 * greatest);
        }
    }

    /// Work in = stored + heat, the three computed apart.
    #[test]
    fn energy_is_kept(recipe in recipe(8), history in history(12)) {
        let spectrum = Arc::new(Spectrum::new(&recipe.relaxation()));
        let mut bed = Direct::new(spectrum, Layout::uniform(&unit_ball(), 1.0, 20));
        let (mut work, mut heat, mut scale) = (0.0, 0.0, 0f64);
        for motion in history {
            let ledger = bed.audit(motion.speed, motion.duration);
            bed.advance(motion.speed, motion.duration);
            work += ledger.work;
            heat += ledger.dissipated;
            scale = scale.max(ledger.work.abs()).max(bed.stored());
            prop_assert!(ledger.dissipated >= -1e-12 * scale);
            prop_assert!((work - bed.stored() - heat).abs() <= 1e-11 * scale, "{work} {} {heat}", bed.stored());
        }
    }
}

/// Triangle of indentation: E*(t) = 4[G∞ + G₁e^(−t/τ)], R = 1, d from 0 to 0.01 in 1 s and back.
pub(crate) struct Triangle {
    shear: (f64, f64, f64),
    /// Pairs of time and force with nine digits (Ting 1966).
    pub forces: &'static [(f64, f64)],
    /// When the force vanishes, six digits.
    pub parting: f64,
}

pub(crate) const TRIANGLES: [Triangle; 3] = [
    Triangle {
        shear: (0.1, 0.9, 0.2),
        forces: &[(1.0, 1.806_718_02e-3), (1.1, 6.847_747e-4), (1.2, 9.472_905e-5)],
        parting: 1.24644,
    },
    Triangle { shear: (0.5, 0.5, 0.2), forces: &[(1.0, 3.374_102_65e-3), (1.3, 1.202_475e-3)], parting: 1.80705 },
    Triangle { shear: (0.01, 0.99, 0.01), forces: &[(1.0, 1.321_353_24e-4)], parting: 1.04144 },
];

impl Triangle {
    pub(crate) fn spectrum(&self) -> Arc<Spectrum> {
        let (equilibrium, modulus, time) = self.shear;
        let terms = vec![(4.0 * modulus, time)];
        Arc::new(Spectrum::new(&Relaxation { equilibrium: 4.0 * equilibrium, terms, viscosity: 0.0 }))
    }
}

/// The usual explicit step, sᵢ ← sᵢ + h(Eᵢv − sᵢ/τᵢ), grows without bound once h > 2τᵢ; the exact one
/// gives Eᵢvτᵢ(1 − e^(−t/τᵢ)) for any h.
#[test]
fn explicit_steps_explode() {
    let spectrum = Spectrum::new(&Relaxation { equilibrium: 0.0, terms: vec![(1.0, 1e-3)], viscosity: 0.0 });
    let (mut euler, mut exact) = (0.0, [0.0]);
    for _ in 0..1000 {
        euler += 0.0025 * (1.0 - euler / 1e-3);
        spectrum.press(&mut exact, 1.0, 0.0025);
    }
    assert!(f64::abs(euler) > 1e100 || euler.is_nan());
    assert!((exact[0] - 1e-3).abs() < 1e-18);
}

/// Bound: −1/4 ≤ error·(a/Δx)² ≤ 1/8 for a bed of cells, relative to the force of the instantaneous
/// modulus, which the load at the edge follows; Δx/a = 1/1000.
#[test]
fn triangles_by_springs() {
    let glassy = 4.0 / 3.0 * 4.0 * 1e-3;
    for triangle in TRIANGLES {
        let mut bed = Lazy::new(triangle.spectrum(), Layout::uniform(&unit_ball(), 0.1, 1000));
        bed.advance(0.01, 1.0);
        for &(t, force) in triangle.forces {
            let seen = bed.tried(-0.01, t - 1.0, Lazy::force);
            assert!((seen - force).abs() < 0.25e-6 * glassy, "{t}: {seen:e} {force:e}");
        }
        let (early, late) = (triangle.parting - 2e-5, triangle.parting + 2e-5);
        assert!(bed.tried(-0.01, early - 1.0, Lazy::pressed) > 0);
        assert_eq!(bed.tried(-0.01, late - 1.0, Lazy::pressed), 0);
    }
}

proptest! {
    #![proptest_config(crate::laws::cases(64))]

    /// One motion in one step or in many: the same states to rounding. Each piece rounds the depth
    /// anew, and the force feels that with at most the stiffness 2E(0)a of the whole bed.
    #[test]
    fn answer_does_not_depend_on_the_steps(recipe in recipe(8), history in history(6), pieces in 2u32..40) {
        let spectrum = Arc::new(Spectrum::new(&recipe.relaxation()));
        let layout = Layout::uniform(&unit_ball(), 1.0, 30);
        let stiffness = spectrum.instantaneous();
        let (mut once, mut often) = (Lazy::new(spectrum.clone(), layout.clone()), Lazy::new(spectrum, layout));
        let rounding = 2.0 * stiffness * f64::EPSILON * f64::from(pieces) * history.len() as f64;
        let mut greatest = 0f64;
        for motion in history {
            once.advance(motion.speed, motion.duration);
            for _ in 0..pieces {
                often.advance(motion.speed, motion.duration / f64::from(pieces));
            }
            greatest = greatest.max(once.force());
            prop_assert!((once.force() - often.force()).abs() <= 1e-11 * greatest + rounding, "{} {}", once.force(), often.force());
        }
    }
}
