//! Impacts against closed answers, limits, steps on a bed of springs and one another.

use super::*;
use crate::contact::viscoelastic::growing::GrowingBed;
use crate::contact::viscoelastic::layout::Layout;
use crate::drive::impact::SteppedMass;
use crate::input::quantity::{Length, Positive};
use crate::material::Relaxation;
use crate::shape::{Cone, FlatPunch, Paraboloid, Power};
use proptest::prelude::*;

const UNIT: Projectile = Projectile { mass: 1.0, speed: 1.0 };

fn ball() -> Arc<dyn Profile> {
    Arc::new(Paraboloid { radius: Length::new(1.0).unwrap() })
}

fn spectrum(equilibrium: f64, terms: &[(f64, f64)], viscosity: f64) -> Arc<Spectrum> {
    Arc::new(Spectrum::new(&Relaxation { equilibrium, terms: terms.to_vec(), viscosity }))
}

fn driven(spectrum: Arc<Spectrum>) -> StruckHalfSpace {
    StruckHalfSpace { spectrum, profile: ball() }
}

fn rebound(spectrum: Arc<Spectrum>, accuracy: f64) -> Rebound {
    driven(spectrum).flight(&UNIT, accuracy).unwrap().rebound()
}

/// The bodies part where the last spring is let go, also where rounding leaves it pressed in the step that ends there: no
/// flight after it counts as contact.
#[test]
fn a_flight_ends_where_the_last_spring_is_let_go() {
    let power = |k: i32| 10f64.powf(0.1 * f64::from(k));
    let terms = [(-3, 4), (0, -6), (19, -9)].map(|(modulus, time)| (power(modulus), power(time)));
    let profile = Arc::new(Cone { slope: Positive::new(0.5).unwrap() });
    let model = StruckHalfSpace { spectrum: spectrum(0.2, &terms, power(-5)), profile };
    let [seen, fine] = [1e-2, 1e-10].map(|accuracy| model.flight(&UNIT, accuracy).unwrap().rebound());
    assert!(seen.difference(&fine) <= seen.error, "{seen:?} {fine:?}");
}

/// Steps that rounding keeps from meeting the tolerance are tried with a larger one, and what they miss is told.
#[test]
fn what_rounding_leaves_is_told() {
    let power = |k: i32| 10f64.powf(0.1 * f64::from(k));
    let terms = [(18, -12), (-12, -3), (-17, -3), (-6, -29)].map(|(modulus, time)| (power(modulus), power(time)));
    let profile = Arc::new(Cone { slope: Positive::new(0.5).unwrap() });
    let model = StruckHalfSpace { spectrum: spectrum(0.2, &terms, power(-10)), profile };
    let [seen, fine] = [1e-9, 1e-10].map(|accuracy| model.flight(&UNIT, accuracy).unwrap().rebound());
    assert!(seen.error.max(fine.error) < 1e-7 && seen.difference(&fine) <= seen.error, "{seen:?} {fine:?}");
}

/// Kelvin–Voigt ball with δ = (η/E∞)(E∞²Rv/m²)^{1/5}, E∞ = R = m = v = 1; five digits, the last uncertain.
#[test]
fn restitution_of_kelvin_voigt() {
    let table = [(0.01, 0.98089), (0.05, 0.91012), (0.1, 0.83272), (0.2, 0.70673), (0.5, 0.46894), (1.0, 0.28082)];
    for (delta, restitution) in table {
        let seen = rebound(spectrum(1.0, &[], delta), 1e-6);
        assert!((seen.restitution - restitution).abs() < 1e-5, "{delta}: {seen:?}");
        assert!(seen.error <= 1e-6);
    }
}

/// e = 1 − 1.9412δ + C₂δ² + O(δ³), C₂ = (3/5)·1.9412² + (5/6)(15/16)^{1/5} = 3.0837.
///
/// The first part of C₂ is that of a law that keeps tension (Ramírez et al. 1999); springs that let
/// go spare the tension of a ring of the width η|ḋ|/(2aE), which is worth η²∫ḋ²dd/(2aE). Bound: the
/// digits of 1.9412 and a term of 6δ³, which the table above allows for.
#[test]
fn small_damping() {
    let second = 0.6 * 1.9412f64.powi(2) + 5.0 / 6.0 * (15.0f64 / 16.0).powf(0.2);
    for delta in [0.0001, 0.001, 0.003] {
        let seen = rebound(spectrum(1.0, &[], delta), 1e-9).restitution;
        let series = 1.0 - 1.9412 * delta + second * delta * delta;
        assert!((seen - series).abs() < 5e-5 * delta + 6.0 * delta.powi(3), "{delta}: {seen} {series}");
    }
}

/// No damping: Hertz, to the accuracy asked for and the error stated.
#[test]
fn without_damping_it_is_hertz() {
    for accuracy in [1e-4, 1e-6, 1e-9] {
        let seen = rebound(spectrum(1.0, &[], 0.0), accuracy);
        let depth = (15.0f64 / 16.0).powf(0.4);
        let time = seen.contact_time.unwrap() / depth / 2.943_275_184_324_705 - 1.0;
        let off = (seen.restitution - 1.0).abs().max(time.abs()).max((seen.greatest_depth / depth - 1.0).abs());
        let force = seen.greatest_force / (4.0 / 3.0 * depth.powf(1.5)) - 1.0;
        assert!(off.max(force.abs()) <= seen.error && seen.error <= accuracy, "{accuracy}: {off:e} {force:e} {seen:?}");
    }
}

/// A Maxwell element so slow, or so fast, that it is elastic; bound: the time it is off by.
#[test]
fn limits_of_one_term() {
    for (time, stiffness) in [(1e12, 4.0), (1e-12, 1.0), (1e15, 4.0), (1e-15, 1.0)] {
        let seen = rebound(spectrum(1.0, &[(3.0, time)], 0.0), 1e-8);
        let depth = (15.0f64 / 16.0 / stiffness).powf(0.4);
        assert!((seen.greatest_depth / depth - 1.0).abs() < 1e-8, "{time} {seen:?}");
        assert!((seen.restitution - 1.0).abs() < 1e-8, "{time} {seen:?}");
    }
}

/// Terms without modulus change nothing, to the last bit.
#[test]
fn terms_of_no_modulus_are_none() {
    let (with, without) = (spectrum(1.0, &[(0.0, 0.3)], 0.2), spectrum(1.0, &[], 0.2));
    assert_eq!(rebound(with, 1e-6), rebound(without, 1e-6));
}

/// A Maxwell liquid that relaxes at once takes all.
#[test]
fn liquid_swallows_a_slow_ball() {
    let seen = rebound(spectrum(0.0, &[(1.0, 1e-3)], 0.0), 1e-6);
    assert!(seen.restitution < 0.05, "{seen:?}");
    let stuck = rebound(spectrum(0.0, &[], 0.3), 1e-6);
    assert!(stuck.sticks() && stuck.restitution <= 0.0, "{stuck:?}");
}

/// A flat punch on a standard solid is a linear oscillator: m d̈ = −2b(E∞d + s), ṡ = Eḋ − s/τ, followed
/// until F = 0 by Runge and Kutta's method in steps of 1e-4; bound: its fourth order and a step's linear cut.
#[test]
fn flat_punch_is_linear() {
    let punch = Arc::new(FlatPunch { radius: Length::new(0.5).unwrap() });
    let model = StruckHalfSpace { spectrum: spectrum(1.0, &[(2.0, 0.7)], 0.1), profile: punch };
    let seen = model.flight(&UNIT, 1e-9).unwrap().rebound();
    let force = |y: [f64; 3]| y[0] + y[2] + 0.1 * y[1];
    let rate = |y: [f64; 3]| [y[1], -force(y), 2.0 * y[1] - y[2] / 0.7];
    let (mut y, h) = ([0.0, 1.0, 0.0], 1e-4);
    let mut t = 0.0;
    loop {
        let ahead = |k: [f64; 3], part: f64| std::array::from_fn(|i| y[i] + part * h * k[i]);
        let a = rate(y);
        let b = rate(ahead(a, 0.5));
        let c = rate(ahead(b, 0.5));
        let d = rate(ahead(c, 1.0));
        let next: [f64; 3] = std::array::from_fn(|i| y[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]));
        if force(next) <= 0.0 {
            t += h * force(y) / (force(y) - force(next));
            break;
        }
        (y, t) = (next, t + h);
    }
    assert!((seen.contact_time.unwrap() - t).abs() < 1e-8, "{t} {seen:?}");
    // The force is zero at the end: a step of 1e-4 from there changes the speed by 1e-8.
    assert!((seen.restitution + y[1]).abs() < 3e-8, "{} {seen:?}", y[1]);
}

fn recipe() -> impl Strategy<Value = Relaxation> {
    let term = (-20i32..20, -30i32..30);
    (0i32..3, prop::collection::vec(term, 0..6), prop::option::of(-20i32..5)).prop_map(|(solid, terms, viscosity)| {
        let power = |k: i32| 10f64.powf(0.1 * f64::from(k));
        Relaxation {
            equilibrium: [0.2, 1.0, 5.0][solid as usize],
            terms: terms.into_iter().map(|(e, tau)| (power(e), power(tau))).collect(),
            viscosity: viscosity.map_or(0.0, power),
        }
    })
}

fn shape() -> impl Strategy<Value = Arc<dyn Profile>> {
    prop_oneof![
        Just(ball()),
        Just(Arc::new(Cone { slope: Positive::new(0.5).unwrap() }) as Arc<dyn Profile>),
        Just(Arc::new(Power { coefficient: Positive::new(1.0).unwrap(), exponent: Positive::new(3.0).unwrap() })
            as Arc<dyn Profile>),
    ]
}

proptest! {
    #![proptest_config(crate::laws::cases(48))]

    /// 0 ≤ e ≤ 1, heat never negative and never given back, the error is the one asked for; and the records stand where they
    /// stand however many there are.
    #[test]
    fn laws(relaxation in recipe(), profile in shape(), speed in -10i32..10) {
        let spectrum = Arc::new(Spectrum::new(&relaxation));
        let impact = Projectile { mass: 1.0, speed: 10f64.powf(0.1 * f64::from(speed)) };
        let flight = StruckHalfSpace { spectrum, profile }.flight(&impact, 1e-6).unwrap();
        let seen = flight.rebound();
        prop_assert!((0.0..=1.0 + 1e-6).contains(&seen.restitution), "{seen:?}");
        prop_assert!(seen.error <= 1e-6, "{seen:?}");
        let moments = flight.moments(40);
        let heat: Vec<f64> = moments.iter().map(|moment| moment.dissipated).collect();
        prop_assert!(heat.windows(2).all(|two| two[1] >= two[0] - 2e-4 * impact.energy()), "{heat:?}");
        let many = flight.moments(80);
        prop_assert!(moments.iter().zip(many.iter().step_by(2)).all(|(x, y)| (x.force - y.force).abs() < 1e-9 * seen.greatest_force));
    }

    /// The error stated bounds the distance to a far finer run.
    #[test]
    fn the_error_is_true(relaxation in recipe(), profile in shape(), accuracy in 2i32..7) {
        let model = StruckHalfSpace { spectrum: Arc::new(Spectrum::new(&relaxation)), profile };
        let seen = model.flight(&UNIT, 10f64.powi(-accuracy)).unwrap().rebound();
        let fine = model.flight(&UNIT, 1e-10).unwrap().rebound();
        prop_assert!(seen.difference(&fine) <= seen.error, "{:e} {:e}", seen.difference(&fine), seen.error);
    }

    /// The bed of springs; bound: second order in springs, 0.25·(4.85/500)², and steps.
    #[test]
    fn is_the_limit_of_many_springs(relaxation in recipe()) {
        let spectrum = Arc::new(Spectrum::new(&relaxation));
        let depth = driven(spectrum.clone()).depth_scale(&UNIT).unwrap();
        let layout = Layout::graded(ball().as_ref(), (depth.sqrt() / 64.0, depth.sqrt()), 500);
        let mut bed = GrowingBed::new(spectrum.clone(), ball(), layout);
        let plain = SteppedMass { impact: UNIT, time: depth, steps: 200.0 }.rebound(&mut bed).unwrap();
        let seen = rebound(spectrum, 1e-6);
        prop_assert!((seen.restitution - plain.restitution).abs() < 1e-4, "{seen:?} {plain:?}");
        prop_assert!((seen.greatest_depth / plain.greatest_depth - 1.0).abs() < 1e-3, "{seen:?} {plain:?}");
    }

    /// Only the numbers without dimension matter: mass, speed, size and moduli over many decades.
    #[test]
    fn scales(relaxation in recipe(), m in -60i32..60, v in -30i32..30, r in -60i32..60, e in -60i32..60) {
        let power = |k: i32| 10f64.powf(0.1 * f64::from(k));
        let (mass, speed, radius, modulus) = (power(m), power(v), power(r), power(e));
        // Depth ∝ (mv²/(E√R))^{2/5}, time depth/v.
        let time = (mass * speed * speed / (modulus * radius.sqrt())).powf(0.4) / speed;
        let scaled = Relaxation {
            equilibrium: modulus * relaxation.equilibrium,
            terms: relaxation.terms.iter().map(|&(e, tau)| (modulus * e, time * tau)).collect(),
            viscosity: modulus * time * relaxation.viscosity,
        };
        let profile = Arc::new(Paraboloid { radius: Length::new(radius).unwrap() });
        let model = StruckHalfSpace { spectrum: Arc::new(Spectrum::new(&scaled)), profile };
        let here = model.flight(&Projectile { mass, speed }, 1e-6).unwrap().rebound();
        let there = rebound(Arc::new(Spectrum::new(&relaxation)), 1e-6);
        prop_assert!((here.restitution - there.restitution).abs() < 2e-6, "{here:?} {there:?}");
        prop_assert!((here.contact_time.unwrap() / time / there.contact_time.unwrap() - 1.0).abs() < 2e-6);
    }
}

/// Under a profile that is flatter than a paraboloid, p ∝ (a² + 2r²)√(a² − r²) for r⁴, the largest pressure is off the axis,
/// √2 times that on it.
#[test]
fn the_peak_pressure_is_sought_off_the_axis() {
    let profile = Power { coefficient: Positive::new(1.0).unwrap(), exponent: Positive::new(4.0).unwrap() };
    let model = StruckHalfSpace { spectrum: spectrum(1.0, &[], 0.0), profile: Arc::new(profile) };
    let flight = model.flight(&UNIT, 1e-9).unwrap();
    let ratio = flight.peak_pressure().unwrap() / flight.pressure(flight.turn(), 0.0);
    assert!((ratio / 2f64.sqrt() - 1.0).abs() < 1e-9, "{ratio}");
}

/// A body that relaxes within a small part of the impact is pressed hardest at its very beginning: the largest pressure is no
/// less than any of a fine scan, and is met by it as closely as the scan is fine.
#[test]
fn the_peak_pressure_is_no_less_than_any_before() {
    for terms in [&[(1.0, 0.1)][..], &[(5.0, 0.05), (1.0, 1.0)], &[(100.0, 1e-3)], &[(20.0, 1e-2), (1.0, 2.0)]] {
        let flight = driven(spectrum(0.2, terms, 0.0)).flight(&UNIT, 1e-9).unwrap();
        let scan = (1..=1200).map(|k| flight.pressure(flight.turn() * (-0.01 * f64::from(k - 1)).exp(), 0.0));
        let (scanned, seen) = (scan.fold(0.0, f64::max), flight.peak_pressure().unwrap());
        assert!(scanned <= seen * (1.0 + 1e-9) && seen <= scanned * (1.0 + 1e-4), "{terms:?}: {seen} {scanned}");
    }
}
