//! Laws that every bed obeys, on random materials and histories.

use super::attraction::Attraction;
use super::direct::Direct;
use super::layout::Layout;
use super::lazy::Lazy;
use super::memory::Memory;
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

/// The same, one in eight a dashpot alone.
pub(crate) fn recipe_or_dashpot(most: usize) -> impl Strategy<Value = Recipe> {
    let alone = |viscosity| Recipe { equilibrium: None, terms: Vec::new(), viscosity: Some(viscosity) };
    prop_oneof![7 => recipe(most), 1 => (-60i32..60).prop_map(alone)]
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
    fn lazy_bed_is_the_direct_bed(recipe in recipe_or_dashpot(8), history in history(12)) {
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
    fn energy_is_kept(recipe in recipe_or_dashpot(8), history in history(12)) {
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

    /// A glance sees the edge a motion comes to, to the last bit, and the force to rounding of what its springs can bear.
    #[test]
    fn a_glance_sees_what_the_motion_comes_to(recipe in recipe_or_dashpot(8), history in history(6)) {
        let spectrum = Spectrum::new(&recipe.relaxation());
        let springs = spectrum.terms().iter().map(|term| term.modulus).sum::<f64>() + spectrum.equilibrium();
        let bearable = |speed: f64| springs + spectrum.viscosity() * speed.abs();
        let mut bed = Lazy::new(Arc::new(spectrum.clone()), Layout::uniform(&unit_ball(), 1.0, 30));
        let mut most = 0.0;
        for motion in history {
            let see = |bed: &Lazy| (bed.force(), bed.radius(), bed.pressed());
            let (force, radius, pressed) = bed.glanced(motion.speed, motion.duration, see);
            bed.advance(motion.speed, motion.duration);
            prop_assert_eq!((radius, pressed), (bed.radius(), bed.pressed()));
            most = f64::max(most, bearable(motion.speed));
            prop_assert!((force - bed.force()).abs() <= 1e-14 * most, "{force:e} {:e}, of {most:e}", bed.force());
        }
    }

    /// A bed goes back to where it was marked to the last bit, whatever has been tried and done since.
    #[test]
    fn a_mark_is_gone_back_to(recipe in recipe_or_dashpot(8), before in history(4), after in history(4)) {
        let mut bed = Lazy::new(Arc::new(Spectrum::new(&recipe.relaxation())), Layout::uniform(&unit_ball(), 1.0, 30));
        before.iter().for_each(|motion| bed.advance(motion.speed, motion.duration));
        let then = bed.clone();
        bed.mark();
        for motion in &after {
            bed.tried(-motion.speed, motion.duration, Lazy::force);
            bed.advance(motion.speed, motion.duration);
        }
        let back = bed.at_mark().unwrap();
        let bits = |bed: &Lazy| {
            let springs = (0..30).flat_map(|j| [bed.line_load(j), bed.displacement(j)]);
            springs.chain([bed.force(), bed.ledger().dissipated]).map(f64::to_bits).collect::<Vec<_>>()
        };
        prop_assert_eq!(bits(&back), bits(&then));
        bed.unmark();
        prop_assert!(bed.at_mark().is_none());
    }

    /// One motion in one step or in many: the same states to rounding. Each piece rounds the depth
    /// anew, and the force feels that with at most the stiffness 2E(0)a of the whole bed. A dashpot alone jumps where
    /// the surface that was pressed in is met again, all of it at once, for nothing recovers: what is told at that instant is
    /// rounding, and the works are held against each other in place of the forces. The work feels the depth with the
    /// force of the dashpot, at most 2ηa|v|.
    #[test]
    fn answer_does_not_depend_on_the_steps(recipe in recipe_or_dashpot(8), history in history(6), pieces in 2u32..40) {
        let spectrum = Arc::new(Spectrum::new(&recipe.relaxation()));
        let layout = Layout::uniform(&unit_ball(), 1.0, 30);
        let (stiffness, viscosity) = (spectrum.instantaneous(), spectrum.viscosity());
        let jumps = stiffness <= 0.0;
        let (mut once, mut often) = (Lazy::new(spectrum.clone(), layout.clone()), Lazy::new(spectrum, layout));
        let depths = f64::EPSILON * f64::from(pieces) * history.len() as f64;
        let fastest = history.iter().fold(0.0, |most: f64, motion| most.max(motion.speed.abs()));
        let rounding = 2.0 * depths * if jumps { viscosity * fastest } else { stiffness };
        let told = |bed: &Lazy| if jumps { bed.ledger().work } else { bed.force() };
        let mut greatest = 0f64;
        for motion in history {
            once.advance(motion.speed, motion.duration);
            for _ in 0..pieces {
                often.advance(motion.speed, motion.duration / f64::from(pieces));
            }
            greatest = greatest.max(told(&once));
            let apart = (told(&once) - told(&often)).abs();
            prop_assert!(apart <= 1e-11 * greatest + rounding, "{} {}", told(&once), told(&often));
        }
    }
}

/// A ball of 5 mm and the material with two times on which the rule of the edge was tried by brute force.
fn held_ball(attraction: impl Fn(&Spectrum) -> Attraction, terms: &[(f64, f64)]) -> Memory {
    let relaxation = Relaxation { equilibrium: 1.2e6, terms: terms.to_vec(), viscosity: 0.0 };
    let spectrum = Arc::new(Spectrum::new(&relaxation));
    let law = attraction(&spectrum);
    Memory::new(spectrum, Arc::new(Paraboloid { radius: Length::new(5e-3).unwrap() })).with(law)
}

const TWO_TIMES: [(f64, f64); 2] = [(2e6, 0.1), (0.8e6, 3.0)];

/// Force and radius at the ends of three motions; bound: springs by brute force, good to 1e-3.
#[test]
fn an_edge_joins_and_leaves_by_its_own_modulus() {
    let history = [(1e-5, 1.0), (3e-6, 1.0), (9.5e-6, 2.0)];
    type EdgeLaw = fn(f64, &Spectrum) -> Attraction;
    let relaxed = [(7.409e-3, 308.1e-6), (-0.5289e-3, 210.3e-6), (4.877e-3, 303.4e-6)];
    let at_once = [(6.155e-3, 270.2e-6), (-1.990e-3, 241.9e-6), (4.653e-3, 269.3e-6)];
    for (law, found) in [(Attraction::relaxed as EdgeLaw, relaxed), (Attraction::instantaneous as EdgeLaw, at_once)] {
        let mut bed = held_ball(|spectrum| law(0.05, spectrum), &TWO_TIMES);
        for ((to, over), (force, radius)) in history.into_iter().zip(found) {
            bed.reach(to, over).unwrap();
            assert!((bed.force() / force - 1.0).abs() < 1e-3, "{:e} {force:e}", bed.force());
            assert!((bed.radius() / radius - 1.0).abs() < 1e-3, "{:e} {radius:e}", bed.radius());
        }
    }
}

/// No Prony term is the elastic contact: JKR on the way in and out, nothing lost but in the jumps; closing with a
/// fifth of the work follows the JKR of that work on the way in, stands still, and opens with all of it.
#[test]
fn an_edge_without_memory_is_elastic() {
    let mut bed = held_ball(|spectrum| Attraction::relaxed(0.05, spectrum).closing(0.01), &[]);
    bed.reach(1e-5, 1.0).unwrap();
    let (force, radius) = (bed.force(), bed.radius());
    assert!((force / 3.4127e-3 - 1.0).abs() < 1e-4 && (radius / 261.75e-6 - 1.0).abs() < 1e-4, "{force:e} {radius:e}");
    bed.reach(0.9e-5, 1.0).unwrap();
    assert!((bed.radius() - radius).abs() <= 0.0);
    assert!((force - bed.force() - 2.0 * 1.2e6 * radius * 1e-6).abs() < 1e-12 * force);
    for work in [0.0, 0.01, 0.05] {
        let mut bed = held_ball(|spectrum| Attraction::relaxed(work, spectrum), &[]);
        for depth in [1e-7, 2e-6, 1e-5, 4e-6, 1e-6] {
            bed.reach(depth, 1.0).unwrap();
            let a = bed.radius();
            let jkr = a * a / 5e-3 - (std::f64::consts::TAU * a * work / 1.2e6).sqrt();
            assert!((jkr - depth).abs() < 1e-13 * 1e-5, "{work} {depth:e}: {jkr:e}");
        }
    }
}

/// Slow against the relaxation an edge of E∞ comes in as JKR with E∞; bound: the part E₁τ/(E∞t) of the load that
/// has not relaxed.
#[test]
fn a_slow_approach_is_jkr() {
    let mut bed = held_ball(|spectrum| Attraction::relaxed(0.05, spectrum), &TWO_TIMES);
    bed.reach(1e-5, 3e9).unwrap();
    let a = bed.radius();
    let jkr = a * a / 5e-3 - (std::f64::consts::TAU * a * 0.05 / 1.2e6).sqrt();
    assert!((jkr / 1e-5 - 1.0).abs() < 1e-13, "{jkr:e}");
    let force = 2.0 * 1.2e6 * (2.0 / 3.0 * a.powi(3) / 5e-3 + a * (1e-5 - a * a / 5e-3));
    assert!((bed.force() / force - 1.0).abs() < 1e-8, "{:e} {force:e}", bed.force());
}

proptest! {
    #![proptest_config(crate::laws::cases(48))]

    /// Cutting any motion of an adhesive bed anywhere changes nothing; what is lost at a joining or leaving by the
    /// modulus at once is never negative. Bound: the panels' polynomials, relative to the load of the whole bed; of bodies
    /// that only touch the square of the radius, Rd, that rounds as the depth does.
    #[test]
    fn cutting_a_motion_changes_nothing(
        terms in prop::collection::vec((0i32..30, -30i32..30), 0..3),
        turns in prop::collection::vec((-30i32..100, -20i32..20), 2..6),
        (shared, closing, pieces) in (any::<bool>(), 0i32..5, 2u32..5),
    ) {
        let terms: Vec<_> = terms.iter().map(|&(e, t)| (1e5 * f64::from(1 + e), 10f64.powf(0.1 * f64::from(t)))).collect();
        let law = |spectrum: &Spectrum| {
            let law = if shared { Attraction::instantaneous(0.05, spectrum) } else { Attraction::relaxed(0.05, spectrum) };
            law.closing(0.0125 * f64::from(closing))
        };
        let (mut once, mut often) = (held_ball(law, &terms), held_ball(law, &terms));
        let (stiff, mut lost) = (2.0 * 3e-4 * once.spectrum().instantaneous() * 1e-5, 0.0);
        for (depth, time) in turns {
            let (from, to, over) = (once.indentation(), 1e-7 * f64::from(depth), 10f64.powf(0.1 * f64::from(time)));
            once.reach(to, over).unwrap();
            for k in 1..=pieces {
                let part = f64::from(k) / f64::from(pieces);
                often.reach(from + part * (to - from), over / f64::from(pieces)).unwrap();
            }
            let (one, other) = (once.radius(), often.radius());
            let touching = (one * one - other * other).abs() < 5e-3 * 64.0 * f64::EPSILON * 1e-5;
            prop_assert!((one - other).abs() < 1e-9 * 3e-4 || touching, "{one:e} {other:e}");
            prop_assert!((once.force() - often.force()).abs() < 1e-9 * stiff, "{:e} {:e}", once.force(), often.force());
            let now = once.ledger().dissipated - once.surface_energy();
            prop_assert!(!shared || now >= lost - 1e-9 * stiff * 1e-5, "{lost:e} {now:e}");
            lost = now;
        }
    }
}

/// A surface that recovers under an indenter that rests where it just touched comes up to it and is never quite there: it is
/// drawn to it once rounding hides the gap, in one motion as in many.
#[test]
fn a_surface_that_comes_up_is_drawn_to_what_rests() {
    let law = |spectrum: &Spectrum| Attraction::relaxed(0.05, spectrum).closing(0.0125);
    for pieces in [1, 2, 3, 4, 7] {
        let mut bed = held_ball(law, &[(26e5, 0.1)]);
        bed.reach(1.9e-6, 3.0).unwrap();
        bed.reach(0.0, 0.02).unwrap();
        assert!(bed.radius() <= 0.0);
        for _ in 0..pieces {
            bed.reach(0.0, 20.0 / f64::from(pieces)).unwrap();
        }
        // JKR at d = 0 with the work of closing: a³ = 2πwR²/E*.
        let radius = (std::f64::consts::TAU * 0.0125 * 5e-3 * 5e-3 / 1.2e6).cbrt();
        assert!((bed.radius() / radius - 1.0).abs() < 1e-9, "{pieces}: {:e}", bed.radius());
    }
}

/// JKR's ball holds until d = −¾(π²w²R/E²)^{1/3}, where its radius may be a ten thousandth of the one it had: pulled there in one
/// motion it holds as in many.
#[test]
fn a_contact_collapses_at_a_small_part_of_its_radius() {
    let radius: f64 = 5e-3;
    for decade in 0..7 {
        let modulus = 1.2e6 * 10f64.powi(decade);
        let spectrum = Arc::new(Spectrum::elastic(modulus));
        let law = Attraction::relaxed(0.05, &spectrum).closing(0.02);
        let mut bed = Memory::new(spectrum, Arc::new(Paraboloid { radius: Length::new(radius).unwrap() })).with(law);
        bed.reach(1e-5, 1.0).unwrap();
        let last = -0.75 * ((std::f64::consts::PI * 0.05 / modulus).powi(2) * radius).cbrt();
        for part in [0.0, 0.5, 0.99] {
            let mut once = bed.clone();
            once.reach(part * last, 1.0).unwrap();
            let a = once.radius();
            let jkr = a * a / radius - (std::f64::consts::TAU * a * 0.05 / modulus).sqrt();
            assert!(a > 0.0 && (jkr - part * last).abs() < 1e-8 * last.abs(), "{modulus:e} {part}: {a:e} {jkr:e}");
        }
        bed.reach(1.01 * last, 1.0).unwrap();
        assert!(bed.radius() <= 0.0, "{modulus:e}: {:e}", bed.radius());
    }
}
