//! Gliding contacts against closed forms, limits and laws.

use super::cycle;
use super::kernel::Kernel;
use super::sweep::swept;
use super::tally::Tally;
use super::{GlidingBed, GlidingLine, SteadyGlide, SteadyState};
use crate::contact::model::{ContactModel, Pull, Straight};
use crate::contact::viscoelastic::laws::recipe;
use crate::contact::viscoelastic::spring::Spring;
use crate::input::quantity::{Length, Positive};
use crate::material::{Relaxation, Spectrum};
use crate::shape::{Cone, Paraboloid, Profile};
use proptest::prelude::*;
use std::f64::consts::FRAC_PI_2;
use std::sync::Arc;

fn ball(radius: f64) -> Arc<dyn Profile> {
    Arc::new(Paraboloid { radius: Length::new(radius).unwrap() })
}

/// A cone whose one-dimensional profile is g = c|ξ|.
fn wedge(c: f64) -> Arc<dyn Profile> {
    Arc::new(Cone { slope: Positive::new(c / FRAC_PI_2).unwrap() })
}

fn material(equilibrium: f64, terms: &[(f64, f64)], viscosity: f64) -> Arc<Spectrum> {
    Arc::new(Spectrum::new(&Relaxation { equilibrium, terms: terms.to_vec(), viscosity }))
}

proptest! {
    #![proptest_config(crate::laws::cases(64))]

    /// Wedge g = c|ξ| on Kelvin–Voigt, s = ηvc/(Ed): μ/c = s(4 − s)/(2 + s²), and c for s ≥ 1. A wedge is its own
    /// polygon: rounding of 512 pieces.
    #[test]
    fn a_wedge_on_kelvin_voigt(s in 1i32..=200, c in -30i32..=0, e in -60i32..60, d in -80i32..0) {
        let (s, c) = (0.01 * f64::from(s), 10f64.powf(0.1 * f64::from(c)));
        let (modulus, depth) = (10f64.powf(0.1 * f64::from(e)), 10f64.powf(0.1 * f64::from(d)));
        let glide = SteadyGlide::round(material(modulus, &[], 0.3 * modulus), wedge(c), 1e-6);
        let state = glide.at_depth(s * depth / (0.3 * c), depth).unwrap();
        let expected = if s < 1.0 { c * s * (4.0 - s) / (2.0 + s * s) } else { c };
        prop_assert!((state.coefficient().unwrap() / expected - 1.0).abs() < 1e-11, "{s} {:e}", state.resistance / state.force / expected);
        prop_assert!((state.leading_edge.unwrap() * c / depth - 1.0).abs() < 1e-12);
        let rear = if s < 1.0 { -(depth / c) * (1.0 - s) } else { 0.0 };
        prop_assert!((state.trailing_edge.unwrap() - rear).abs() < 1e-11 * depth / c, "{:e} {rear:e}", state.trailing_edge.unwrap());
    }

    /// Work in is heat, for any spectrum, speed and depth; and no resistance is above the steepest slope.
    #[test]
    fn all_power_is_heat(recipe in recipe(8), v in -60i32..60, d in -60i32..0) {
        let (speed, depth) = (10f64.powf(0.1 * f64::from(v)), 10f64.powf(0.1 * f64::from(d)));
        let glide = SteadyGlide::round(Arc::new(Spectrum::new(&recipe.relaxation())), ball(1.0), 1e-4);
        let state = glide.at_depth(speed, depth).unwrap();
        let scale = state.force * 2.0 * depth.sqrt();
        prop_assert!((state.work - state.resistance).abs() <= 1e-10 * scale, "{:e} {:e}", state.work, state.resistance);
        prop_assert!(state.resistance >= 0.0 && state.resistance <= scale);
        let (front, rear) = (state.leading_edge.unwrap(), state.trailing_edge.unwrap());
        prop_assert!(rear.abs() <= front * (1.0 + 1e-12));
    }

    /// A force is met to rounding.
    #[test]
    fn a_force_is_met(recipe in recipe(4), v in -40i32..40, d in -60i32..0) {
        let (speed, depth) = (10f64.powf(0.1 * f64::from(v)), 10f64.powf(0.1 * f64::from(d)));
        let glide = SteadyGlide::round(Arc::new(Spectrum::new(&recipe.relaxation())), ball(1.0), 1e-6);
        let state = glide.at_depth(speed, depth).unwrap();
        let again = glide.at_force(speed, state.force).unwrap();
        prop_assert!((again.force / state.force - 1.0).abs() < 1e-10);
        prop_assert!((again.indentation / depth - 1.0).abs() < 4e-6, "{:e}", again.indentation / depth - 1.0);
    }
}

/// A paraboloid rolling on Kelvin–Voigt: front √(Rd), rear τv − √((τv)² + Rd), and the two integrals
/// F = ∫ E(d − g) − ηv… in closed form. Bound: chords of second order to the accuracy asked for.
#[test]
fn a_paraboloid_on_kelvin_voigt() {
    for tv in [0.01, 0.3, 1.0, 4.0] {
        let (radius, depth) = (2.0, 0.5);
        let glide = SteadyGlide::round(material(3.0, &[], 3.0), ball(radius), 1e-8);
        let state = glide.at_depth(tv, depth).unwrap();
        let front = (radius * depth).sqrt();
        let rear = tv - (tv * tv + radius * depth).sqrt();
        assert!((state.leading_edge.unwrap() / front - 1.0).abs() < 1e-14);
        // The rear is found to a part of a chord, of which there are 2^13 on either side or more.
        assert!((state.trailing_edge.unwrap() - rear).abs() < 1e-4 * front, "{rear}");
        // f = E(d − ξ²/R + 2τvξ/R), F_x = ∫ f 2ξ/R.
        let force = |x: f64| 3.0 * (depth * x - x.powi(3) / (3.0 * radius) + tv * x * x / radius);
        let drag = |x: f64| {
            6.0 / radius * (0.5 * depth * x * x - x.powi(4) / (4.0 * radius) + 2.0 * tv * x.powi(3) / (3.0 * radius))
        };
        assert!((state.force / (force(front) - force(rear)) - 1.0).abs() < 1e-8);
        assert!((state.resistance / (drag(front) - drag(rear)) - 1.0).abs() < 1e-8);
    }
}

/// Bodies that remember nothing glide without resistance, to the bit.
#[test]
fn elastic_bodies_do_not_resist() {
    let glide = SteadyGlide::round(Arc::new(Spectrum::elastic(2.0)), ball(1.0), 1e-8);
    let state = glide.at_force(0.3, 0.01).unwrap();
    assert_eq!(state.resistance.to_bits(), 0);
    let depth = (0.01 * 0.75 / 2.0f64).powf(2.0 / 3.0);
    assert!((state.indentation / depth - 1.0).abs() < 1e-8);
}

/// Slow and fast the resistance goes to zero with v and 1/v, and the force to that of E∞ and E(0).
#[test]
fn slow_and_fast_there_is_no_resistance() {
    let glide = SteadyGlide::round(material(1.0, &[(9.0, 1.0)], 0.0), ball(1.0), 1e-8);
    let hertz = |modulus: f64| 4.0 / 3.0 * modulus * 0.01f64.powf(1.5);
    let (slow, slower) = (glide.at_depth(1e-9, 0.01).unwrap(), glide.at_depth(1e-10, 0.01).unwrap());
    assert!((slow.force / hertz(1.0) - 1.0).abs() < 1e-6 && (slow.resistance / slower.resistance - 10.0).abs() < 1e-4);
    let (fast, faster) = (glide.at_depth(1e9, 0.01).unwrap(), glide.at_depth(1e10, 0.01).unwrap());
    assert!((fast.force / hertz(10.0) - 1.0).abs() < 1e-6 && (fast.resistance / faster.resistance - 10.0).abs() < 1e-4);
    // Slowly, f = E∞u + Στᵢ Eᵢ u̇: F_x = v ΣEᵢτᵢ ∫g′² dξ = v Eτ (8/3)d√(d/R)…
    let expected = 1e-9 * 9.0 * 8.0 / 3.0 * 0.01f64.powf(1.5);
    assert!((slow.resistance / expected - 1.0).abs() < 1e-6, "{:e} {expected:e}", slow.resistance);
}

/// A bed of springs, pressed, held and set in motion, comes into the steady state exactly when all springs are new, and
/// its ledger holds: the work of both forces is stored or heat.
#[test]
fn a_bed_comes_into_the_steady_state() {
    let spectrum = material(1.0, &[(4.0, 0.3), (2.0, 5.0)], 0.1);
    let (depth, speed) = (0.01, 0.2);
    let mut bed = GlidingBed::new(spectrum.clone(), ball(1.0), (0.1 / 400.0, 1e-6));
    bed.follow(&Straight::between(0.0, depth, 1.0)).unwrap();
    assert!(bed.gliding().unwrap().resistance.abs() < 1e-15);
    let way = 0.25;
    bed.follow(&Straight { slide: way, sliding_speed: speed, ..Straight::between(depth, depth, way / speed) }).unwrap();
    let steady = SteadyGlide::round(spectrum, ball(1.0), 1e-8).at_depth(speed, depth).unwrap();
    let (state, gliding) = (bed.state(), bed.gliding().unwrap());
    assert!((state.force / steady.force - 1.0).abs() < 1e-4, "{:e}", state.force / steady.force - 1.0);
    assert!(
        (gliding.resistance / steady.resistance - 1.0).abs() < 1e-3,
        "{:e}",
        gliding.resistance / steady.resistance
    );
    assert!((gliding.leading_edge.unwrap() / steady.leading_edge.unwrap() - 1.0).abs() < 1e-12);
    assert!((gliding.trailing_edge.unwrap() - steady.trailing_edge.unwrap()).abs() < 2.0 * 0.1 / 400.0);
    // On from there the power is heat: F_x Δx.
    let before = bed.state();
    bed.follow(&Straight { slide: 2.0 * way, sliding_speed: speed, ..Straight::between(depth, depth, way / speed) })
        .unwrap();
    let after = bed.state();
    let done = after.dissipated + after.stored.elastic - before.dissipated - before.stored.elastic;
    assert!((done / (steady.resistance * way) - 1.0).abs() < 1e-4, "{:e}", done / (steady.resistance * way));
}

/// Under a prescribed force the same.
#[test]
fn a_bed_under_a_force_comes_into_the_steady_state() {
    let spectrum = material(1.0, &[(4.0, 0.3)], 0.0);
    let (force, speed) = (2e-3, 0.2);
    let mut bed = GlidingBed::new(spectrum.clone(), ball(1.0), (0.1 / 200.0, 1e-5));
    let pull = |slide: f64, duration: f64| Pull { force, slide, sliding_speed: speed, duration };
    bed.press(&pull(0.0, 1.0)).unwrap().unwrap();
    assert!((bed.state().force / force - 1.0).abs() < 1e-9);
    bed.press(&pull(0.8, 4.0)).unwrap().unwrap();
    let steady = SteadyGlide::round(spectrum, ball(1.0), 1e-8).at_force(speed, force).unwrap();
    let (state, gliding) = (bed.state(), bed.gliding().unwrap());
    assert!(
        (state.indentation.unwrap() / steady.indentation - 1.0).abs() < 2e-4,
        "{:e}",
        state.indentation.unwrap() / steady.indentation - 1.0
    );
    assert!(
        (gliding.resistance / steady.resistance - 1.0).abs() < 2e-3,
        "{:e}",
        gliding.resistance / steady.resistance - 1.0
    );
}

/// What relaxes within a step, or a dashpot, does not shorten it: neither where it is pressed, nor where it rolls and
/// springs are touched and let go all the time. All these grounds are next to the same.
#[test]
fn a_stiff_ground_is_followed_in_long_steps() {
    let (force, duration) = (2e-3, 1.0);
    let end = |fast: &[(f64, f64)], viscosity: f64| {
        let terms = [&[(0.3, 0.4)], fast].concat();
        let mut bed = GlidingBed::new(material(1.0, &terms, viscosity), ball(1.0), (0.1 / 400.0, 1e-5));
        bed.press(&Pull { force, slide: 0.0, sliding_speed: 0.1, duration }).unwrap().unwrap();
        let pressed = bed.step;
        bed.press(&Pull { force, slide: 0.1, sliding_speed: 0.1, duration }).unwrap().unwrap();
        let (normal, gliding) = (bed.state(), bed.gliding().unwrap());
        assert!((normal.force / force - 1.0).abs() < 1e-9, "{:e}", normal.force / force - 1.0);
        assert!(pressed.min(bed.step) > 2e-3 * duration, "{fast:?} {viscosity}: {pressed:e} {:e}", bed.step);
        [normal.indentation.unwrap(), gliding.resistance]
    };
    let plain = end(&[], 0.0);
    for other in [end(&[(30.0, 1e-6)], 0.0), end(&[(3.0, 1e-6)], 1e-6), end(&[], 3e-5)] {
        assert!((other[0] / plain[0] - 1.0).abs() < 1e-3, "{} {}", other[0], plain[0]);
        assert!((other[1] / plain[1] - 1.0).abs() < 1e-2, "{} {}", other[1], plain[1]);
    }
}

/// Gaps of a line of a few waves at `count` points, one period long.
fn waves(count: usize, parts: &[(u32, f64, f64)]) -> Vec<f64> {
    let at = |k: usize| {
        let x = std::f64::consts::TAU * (k as f64) / count as f64;
        parts.iter().map(|(q, height, phase)| height * (f64::from(*q) * x + phase).cos()).sum()
    };
    (0..count).map(at).collect()
}

/// Harmonics of a polygon that are summed.
const HARMONICS: i32 = 20_000;

/// Full contact of the polygon of a cosine: ½Σ Bₘ²qₘE″(qₘv) over its own harmonics qₘ = q(1 + mN), whose amplitudes are
/// B(sin(qh/2)/(qₘh/2))². E″ grows at most as q, so that a term is at most (q/qₘ)² of the first, and what is
/// left out beyond |m| = M at most 2(q/Nq₁)²/M of the sum, q₁ the longest wave.
fn in_full_contact(spectrum: &Spectrum, (count, length): (usize, f64), part: (u32, f64), speed: f64) -> f64 {
    let (points, h) = (count as f64, length / count as f64);
    let base = std::f64::consts::TAU / length;
    let wave = |m: i32| {
        let q = base * (f64::from(part.0) + f64::from(m) * points);
        let amplitude = part.1 * ((0.5 * base * f64::from(part.0) * h).sin() / (0.5 * q * h)).powi(2);
        0.5 * length * amplitude * amplitude * q.abs() * spectrum.loss(q.abs() * speed)
    };
    (-HARMONICS..=HARMONICS).map(wave).sum()
}

proptest! {
    #![proptest_config(crate::laws::cases(32))]

    /// In full contact of a line, whatever the spectrum and the speed.
    #[test]
    fn a_line_in_full_contact(recipe in recipe(6), v in -60i32..60, q in 1u32..4) {
        let recipe = crate::contact::viscoelastic::laws::Recipe { equilibrium: Some(0), viscosity: None, ..recipe };
        let spectrum = Arc::new(Spectrum::new(&recipe.relaxation()));
        let (speed, count) = (10f64.powf(0.1 * f64::from(v)), 64);
        let gaps = waves(count, &[(q, 1.0, 0.3)]);
        let line = Arc::new(GlidingLine::periodic(&gaps, 1.0 / count as f64));
        // So deep that nothing is let go.
        let depth = 4.0 * spectrum.instantaneous() / spectrum.equilibrium();
        let state = SteadyGlide::line(spectrum.clone(), line).at_depth(speed, depth).unwrap();
        let expected = in_full_contact(&spectrum, (count, 1.0), (q, 1.0), speed);
        let left_out = 2.0 * (f64::from(q) / count as f64).powi(2) / f64::from(HARMONICS);
        let off = state.resistance / expected - 1.0;
        prop_assert!(off.abs() < left_out + 1e-9, "{:e} {expected:e}", state.resistance);
        let lowest = gaps.iter().copied().fold(f64::INFINITY, f64::min);
        let force = spectrum.equilibrium() * (depth + lowest);
        prop_assert!((state.force / force - 1.0).abs() < 1e-9, "{:e} {force:e}", state.force);
        // All of it touches: the slope is that of the chords of the line.
        let chords = (0..count).map(|k| (gaps[(k + 1) % count] - gaps[k]) * count as f64);
        let slope = (chords.map(|chord| chord * chord).sum::<f64>() / count as f64).sqrt();
        // A chord is the difference of two depths, of some tenths.
        prop_assert!((state.rms_slope.unwrap() / slope - 1.0).abs() < 1e-12 + 1e-14 * depth);
    }

    /// Partial contact: found at once it is what comes of itself after many periods; where the period starts does
    /// not matter; work in is heat; μ is never above the steepest slope.
    #[test]
    fn a_line_in_partial_contact(recipe in recipe(5), v in -30i32..30, d in 1i32..30, turn in 0usize..60) {
        let recipe = crate::contact::viscoelastic::laws::Recipe { equilibrium: Some(recipe.equilibrium.unwrap_or(0)), ..recipe };
        let spectrum = Arc::new(Spectrum::new(&recipe.relaxation()));
        let (speed, depth, count) = (10f64.powf(0.1 * f64::from(v)), 0.1 * f64::from(d), 60);
        let mut gaps = waves(count, &[(1, 1.0, 0.3), (2, 0.5, 1.0), (5, 0.2, 2.0)]);
        let of = |gaps: &[f64]| -> SteadyState {
            let line = Arc::new(GlidingLine::periodic(gaps, 1.0 / count as f64));
            SteadyGlide::line(spectrum.clone(), line).at_depth(speed, depth).unwrap()
        };
        let state = of(&gaps);
        gaps.rotate_left(turn);
        let turned = of(&gaps);
        prop_assert!((turned.force / state.force - 1.0).abs() < 1e-12 && (turned.resistance - state.resistance).abs() <= 1e-11 * state.resistance);
        let steepest = 2.0 * std::f64::consts::PI * (1.0 + 1.0 + 1.0);
        let scale = state.force * steepest;
        prop_assert!(state.resistance >= 0.0 && state.resistance <= scale * (1.0 + 1e-9));
        prop_assert!((state.work - state.resistance).abs() <= 1e-8 * scale, "{:e} {:e}", state.work, state.resistance);
    }
}

/// Newton's method finds what comes of itself, period after period.
#[test]
fn the_steady_state_is_the_one_that_comes_of_itself() {
    let gaps = waves(60, &[(1, 1.0, 0.3), (2, 0.5, 1.0), (5, 0.2, 2.0)]);
    for (viscosity, depth, speed) in [(0.0, 0.3, 0.3), (0.0, 1.5, 3.0), (0.05, 0.5, 1.0), (0.0, 0.05, 20.0)] {
        let spectrum = material(1.0, &[(3.0, 0.1), (1.0, 2.0)], viscosity);
        let line = GlidingLine::periodic(&gaps, 1.0 / 60.0);
        let track = line.track(depth).unwrap();
        let mut kernel = Kernel::new(spectrum.clone());
        let found = cycle::steady(&mut kernel, &track, (speed, &mut Vec::new())).unwrap();
        let mut spring = Spring::Pressed(vec![0.0; 2]);
        let mut tally = Tally::default();
        for _ in 0..3000 {
            tally = Tally::default();
            spring = swept(&mut kernel, &track, (speed, spring), &mut tally);
        }
        assert!((found.impulse / tally.impulse - 1.0).abs() < 1e-9, "{:e} {:e}", found.impulse, tally.impulse);
        assert!((found.heat / tally.heat - 1.0).abs() < 1e-9, "{:e} {:e}", found.heat, tally.heat);
    }
}

/// A line of waves on rubber, gliding from rest at the speed `speed`: its bed, and its steady state.
fn rough_start(viscosity: f64, (depth, speed): (f64, f64)) -> (GlidingBed, SteadyState) {
    let spectrum = material(1.0, &[(3.0, 0.1), (1.0, 0.7)], viscosity);
    let gaps = waves(60, &[(1, 1.0, 0.3), (2, 0.5, 1.0), (5, 0.2, 2.0)]);
    let line = Arc::new(GlidingLine::periodic(&gaps, 1.0 / 60.0));
    let mut bed = GlidingBed::line(spectrum.clone(), line.clone(), 1e-6);
    bed.follow(&Straight::between(0.0, depth, 0.5)).unwrap();
    (bed, SteadyGlide::line(spectrum, line).at_depth(speed, depth).unwrap())
}

/// From the place `from` to `to` at the speed `speed` and the depth `depth`.
fn along(depth: f64, speed: f64, (from, to): (f64, f64)) -> Straight {
    Straight { slide: to, sliding_speed: speed, ..Straight::between(depth, depth, (to - from) / speed) }
}

/// A rough line set in motion comes into the steady state found at once: over a period the work done on it is that of
/// the resistance, to what is left of a past twenty relaxation times ago and more; and so is what stands in the records.
#[test]
fn a_rough_line_comes_into_the_steady_state() {
    for (viscosity, depth, speed) in [(0.0, 0.6, 0.1), (0.0, 2.0, 1.0), (0.05, 0.6, 1.0), (0.0, 5.0, 3.0)] {
        let (mut bed, steady) = rough_start(viscosity, (depth, speed));
        let periods = (20.0 * 0.7 * speed).ceil() + 3.0;
        bed.follow(&along(depth, speed, (0.0, periods))).unwrap();
        // Over a period, and over one width: all springs go through the same one after the other.
        let mut work = vec![bed.state().stored.elastic + bed.state().dissipated];
        let (width, mut force) = (1.0 / 60.0, 0.0);
        for k in 0..400 {
            let at = |k: i32| periods + width * f64::from(k) / 400.0;
            bed.follow(&along(depth, speed, (at(k), at(k + 1)))).unwrap();
            force += bed.state().force / 400.0;
        }
        let resistance = bed.gliding().unwrap().resistance;
        work.push(bed.state().stored.elastic + bed.state().dissipated);
        bed.follow(&along(depth, speed, (periods + width, periods + 1.0))).unwrap();
        work.push(bed.state().stored.elastic + bed.state().dissipated);
        let off = |one: f64, other: f64| (one / other - 1.0).abs();
        assert!(off(work[2] - work[0], steady.work) < 1e-7, "{speed} {:e}", off(work[2] - work[0], steady.work));
        assert!(off(work[1] - work[0], width * steady.work) < 1e-7);
        assert!(off(resistance, steady.resistance) < 1e-7, "{speed} {:e}", off(resistance, steady.resistance));
        // Touches and releases fall between records: 1/400 of what a spring carries as it is touched or let go.
        assert!(off(force, steady.force) < 1e-3, "{speed} {:e}", off(force, steady.force));
    }
}

/// Records change nothing, and neither does where the period starts.
#[test]
fn a_rough_start_does_not_depend_on_records() {
    let (depth, speed) = (0.6, 0.4);
    let (mut one, _) = rough_start(0.02, (depth, speed));
    let mut many = one.clone();
    one.follow(&along(depth, speed, (0.0, 0.83))).unwrap();
    for k in 0..97 {
        let at = |k: i32| 0.83 * f64::from(k) / 97.0;
        many.follow(&along(depth, speed, (at(k), at(k + 1)))).unwrap();
    }
    let (one, many) = ((one.state(), one.gliding().unwrap()), (many.state(), many.gliding().unwrap()));
    assert!((one.0.force / many.0.force - 1.0).abs() < 1e-11);
    assert!((one.1.resistance / many.1.resistance - 1.0).abs() < 1e-10);
    assert!((one.0.dissipated / many.0.dissipated - 1.0).abs() < 1e-10);
}

/// At rest the bed is that of its points, and nothing resists.
#[test]
fn a_rough_line_at_rest_is_its_points() {
    let (bed, _) = rough_start(0.0, (0.6, 1.0));
    let gaps = waves(60, &[(1, 1.0, 0.3), (2, 0.5, 1.0), (5, 0.2, 2.0)]);
    let lowest = gaps.iter().copied().fold(f64::INFINITY, f64::min);
    // A ramp of the speed w: f = w[E∞ s + Σ Eᵢτᵢ(1 − e^(−s/τᵢ))], s the time since the touch.
    let down = 0.6 / 0.5;
    let spring = |gap: f64| {
        let since = ((0.6 - (gap - lowest)) / down).max(0.0);
        down * (since - 3.0 * 0.1 * (-since / 0.1).exp_m1() - 0.7 * (-since / 0.7).exp_m1())
    };
    let force = gaps.iter().map(|gap| spring(*gap)).sum::<f64>() / 60.0;
    assert!((bed.state().force / force - 1.0).abs() < 1e-12, "{:e}", bed.state().force / force - 1.0);
    assert_eq!(bed.gliding().unwrap().resistance.to_bits(), 0);
}

/// One spring of a standard solid, E∞ = 1 beside a Maxwell element (3, 0.1), by small steps: load of the element and displacement.
fn small_step((s, u, pressed): (f64, f64, bool), above: f64, dt: f64) -> (f64, f64, bool) {
    let keep = (-dt / 0.1f64).exp();
    let mean = -(-dt / 0.1f64).exp_m1() * 0.1 / dt;
    if pressed || u <= above {
        let next = keep * s + 3.0 * mean * (above - u);
        if above + next >= 0.0 && above >= 0.0 {
            return (next, above, true);
        }
    }
    // Free: E∞u + s = 0 and ṡ = 3u̇ − s/τ give u̇ = s/(4τ).
    let u = u * (-dt / 0.4f64).exp();
    (-u, u, false)
}

#[expect(clippy::cast_possible_truncation, reason = "a number below sixty")]
fn of_sixty(k: f64) -> usize {
    k.rem_euclid(60.0) as usize
}

/// Against a bed of small steps that knows nothing of touch and release but the signs; its error goes with the step.
#[test]
fn a_rough_start_is_that_of_small_steps() {
    let (depth, speed, way) = (0.6, 0.4, 0.5 + 1.0 / 3.0);
    let gaps = waves(60, &[(1, 1.0, 0.3), (2, 0.5, 1.0), (5, 0.2, 2.0)]);
    let line = Arc::new(GlidingLine::periodic(&gaps, 1.0 / 60.0));
    let mut bed = GlidingBed::line(material(1.0, &[(3.0, 0.1)], 0.0), line, 1e-6);
    bed.follow(&Straight::between(0.0, depth, 0.5)).unwrap();
    bed.follow(&along(depth, speed, (0.0, way))).unwrap();
    let lowest = gaps.iter().copied().fold(f64::INFINITY, f64::min);
    // u = d − g(ξ) with ξ = x − X, along the chords.
    let gap = |xi: f64| {
        let (cell, part) = ((60.0 * xi).floor(), 60.0 * xi - (60.0 * xi).floor());
        let at = |k: f64| gaps[of_sixty(k)] - lowest;
        (1.0 - part) * at(cell) + part * at(cell + 1.0)
    };
    let by_steps = |steps: u32| {
        let force = |j: i32| {
            let x = f64::from(j) / 60.0 + 1e-12;
            let mut spring = (0.0, 0.0, false);
            for k in 1..=steps {
                let part = f64::from(k) / f64::from(steps);
                spring = small_step(spring, depth * part - gap(x), 0.5 / f64::from(steps));
            }
            for k in 1..=steps {
                let part = f64::from(k) / f64::from(steps);
                spring = small_step(spring, depth - gap(x - way * part), way / speed / f64::from(steps));
            }
            if spring.2 { spring.0 + spring.1 } else { 0.0 }
        };
        (0..60).map(force).sum::<f64>() / 60.0
    };
    let (coarse, fine) = (by_steps(2000), by_steps(32_000));
    let force = bed.state().force;
    assert!((fine / force - 1.0).abs() < 2e-4, "{:e} {:e}", fine / force - 1.0, coarse / force - 1.0);
    assert!((fine - force).abs() < 0.25 * (coarse - force).abs());
}

/// A line with two ends, on a ball, over new ground: the steady state of one spring swept through it; and the ends are noticed.
#[test]
fn a_line_on_a_ball_comes_into_the_steady_state() {
    let count = 400;
    let waves = waves(count, &[(20, 0.01, 0.3), (37, 0.004, 1.0)]);
    let x = |k: usize| (k as f64 + 0.5 - 0.5 * count as f64) / count as f64;
    let gaps: Vec<f64> = waves.iter().enumerate().map(|(k, z)| z + x(k) * x(k)).collect();
    let line = Arc::new(GlidingLine::single(&gaps, 1.0 / count as f64));
    let spectrum = material(1.0, &[(3.0, 0.05)], 0.0);
    let (depth, speed) = (0.05, 1.0);
    let steady = SteadyGlide::line(spectrum.clone(), line.clone()).at_depth(speed, depth).unwrap();
    let mut bed = GlidingBed::line(spectrum, line, 1e-6);
    bed.follow(&Straight::between(0.0, depth, 0.5)).unwrap();
    bed.follow(&along(depth, speed, (0.0, 2.0))).unwrap();
    let before = bed.state();
    let width = 1.0 / count as f64;
    bed.follow(&along(depth, speed, (2.0, 2.0 + 20.0 * width))).unwrap();
    let after = bed.state();
    let done = after.dissipated + after.stored.elastic - before.dissipated - before.stored.elastic;
    assert!(
        (done / (20.0 * width * steady.work) - 1.0).abs() < 1e-7,
        "{:e}",
        done / (20.0 * width * steady.work) - 1.0
    );
    assert!((after.force / steady.force - 1.0).abs() < 1e-2, "{:e}", after.force / steady.force - 1.0);
    let told = bed.follow(&Straight { slide: 2.0 + 20.0 * width, ..Straight::between(depth, 0.3, 1.0) }).unwrap_err();
    assert!(told.to_string().contains("reaches the ends of the rough line"));
}
