//! Masses on contacts with rate and state, against the linear theory, explicit steps and their ledger.

use super::*;
use crate::friction::{RateState, StateLaw};
use crate::input::quantity::{Length, Ratio, Speed};
use crate::numerics::complex::Complex;
use proptest::prelude::*;

fn law(direct: f64, evolution: f64, of_state: StateLaw) -> RateState {
    RateState {
        coefficient: Ratio::new(0.6).unwrap(),
        direct: Ratio::new(direct).unwrap(),
        evolution: Ratio::new(evolution).unwrap(),
        distance: Length::new(1.0).unwrap(),
        speed: Speed::new(1.0).unwrap(),
        law: Some(of_state),
        state: None,
    }
}

/// (F/D)s[a(s + 1) − b](Ms² + Cs + k + κ) + (s + 1)κ(Ms² + Cs + k) in s = pD/V, from the lowest power on.
fn polynomial(law: &RateState, speed: f64, (machine, carried): (&Suspension, Carried)) -> [f64; 5] {
    let (a, b) = law.effects(speed);
    let rate = speed / law.distance.si();
    let (m, c, k) = (machine.mass * rate * rate, machine.damping * rate, machine.stiffness);
    let (f, kappa) = (carried.force / law.distance.si(), carried.stiffness);
    let (one, two) = ([0.0, f * (a - b), f * a], [k + kappa, c, m]);
    let (three, four) = ([kappa, kappa], [k, c, m]);
    let mut sum = [0.0; 5];
    for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
        sum[i + j] += one[i] * two[j];
    }
    for (i, j) in (0..2).flat_map(|i| (0..3).map(move |j| (i, j))) {
        sum[i + j] += three[i] * four[j];
    }
    sum
}

/// The roots of a polynomial of the fourth order, by the simultaneous iteration of Weierstrass.
fn roots(polynomial: &[f64; 5]) -> [Complex; 4] {
    let monic = polynomial.map(|number| number / polynomial[4]);
    // Roots are as large as this at most, and far apart where numbers are.
    let size = (0..4).map(|k| (4.0 * monic[k].abs()).powf(1.0 / (4 - k) as f64)).fold(0.0, f64::max);
    let mut roots: [Complex; 4] = std::array::from_fn(|k| Complex::polar(size, 0.4 + 1.6 * k as f64));
    let minus = |z: Complex| z * Complex::from(-1.0);
    for _ in 0..300 {
        for k in 0..4 {
            let z = roots[k];
            let value = monic.iter().rev().fold(Complex::from(0.0), |sum, &number| sum * z + Complex::from(number));
            let apart = (0..4).filter(|&j| j != k).fold(Complex::from(1.0), |all, j| all * (z + minus(roots[j])));
            roots[k] = z + minus(value * apart.inverse());
        }
    }
    roots
}

/// The root that grows fastest, in 1/s.
fn fastest(law: &RateState, speed: f64, of: (&Suspension, Carried)) -> Complex {
    let all = roots(&polynomial(law, speed, of));
    let first = all.into_iter().max_by(|one, other| one.re.total_cmp(&other.re)).unwrap();
    first * Complex::from(speed / law.distance.si())
}

/// Growth and angular frequency [1/s] of a small disturbance of steady sliding, once the rest of it has died down: of four
/// equidistant looks at exp(λt), z₂ = (q + q̄)z₁ − qq̄z₀.
fn measured(
    law: &RateState,
    speed: f64,
    (machine, carried): (&Suspension, Carried),
    (wait, apart): (f64, f64),
) -> (f64, f64) {
    let mut mass = RatedMass::sliding(*machine, law, (carried, 1e-13), (speed, 1e-6));
    let steady = law.steady(speed) * carried.force;
    let mut looks = [0.0; 4];
    for (k, look) in looks.iter_mut().enumerate() {
        while mass.step(wait + apart * k as f64).unwrap().is_some() {}
        *look = mass.tangential().force - steady;
    }
    let [z, y, x, w] = looks;
    let (sum, product) = ((z * w - y * x) / (z * x - y * y), (y * w - x * x) / (z * x - y * y));
    let (growth, turn) = (product.sqrt(), 0.5 * sum / product.sqrt());
    (growth.ln() / apart, turn.clamp(-1.0, 1.0).acos() / apart)
}

/// A disturbance grows or dies as the linear theory says, below the threshold, on it and above it, with inertia, drag and a
/// contact that gives; both laws of the state agree.
#[test]
fn disturbances_grow_as_the_linear_theory_says() {
    let speed = 2.0;
    for of_state in [StateLaw::Ageing, StateLaw::Slip] {
        for (mass, damping, contact) in [(1e-6, 0.0, 1e4), (3e-3, 0.0, 1e3), (2e-3, 1e-3, 0.02)] {
            let law = law(0.01, 0.015, of_state);
            let carried = Carried { force: 1.0, stiffness: contact };
            let machine = |stiffness: f64| Suspension { mass, stiffness, damping };
            let Threshold::At { stiffness, pulse, .. } = threshold(&law, speed, (&machine(0.0), carried)) else {
                panic!("no threshold")
            };
            for part in [0.8, 1.0, 1.2] {
                let machine = machine(part * stiffness);
                let right = fastest(&law, speed, (&machine, carried));
                let (growth, turn) = measured(&law, speed, (&machine, carried), (12.0, 0.4));
                let size = right.re.hypot(right.im);
                assert!((growth - right.re).abs() < 2e-5 * size, "{mass} {part}: {growth:e} {:e}", right.re);
                assert!((turn - right.im.abs()).abs() < 2e-5 * size, "{mass} {part}: {turn:e} {:e}", right.im);
                if (part - 1.0).abs() <= 0.0 {
                    assert!(right.re.abs() < 1e-12 * size && (right.im.abs() / pulse - 1.0).abs() < 1e-12, "{right:?}");
                }
            }
        }
    }
}

proptest! {
    #![proptest_config(crate::laws::cases(512))]

    /// Below the threshold a root of the characteristic polynomial lies on the right, above it none; and on it one lies between.
    #[test]
    fn a_threshold_parts_growth_from_decay(
        direct in 0u32..100, evolution in 0u32..100, mass in 0i32..80, damping in 0i32..80, contact in 0i32..60, off in 1u32..40,
    ) {
        let logarithmic = |k: i32, from: f64| 10f64.powf(from + 0.1 * f64::from(k));
        let law = law(0.002 + 2e-4 * f64::from(direct), 0.002 + 3e-4 * f64::from(evolution), StateLaw::Ageing);
        let carried = Carried { force: 1.0, stiffness: logarithmic(contact, -4.0) };
        // Where the contact is just soft enough to let go by itself the threshold goes beyond all numbers.
        prop_assume!(((law.evolution.si() - law.direct.si()) / carried.stiffness - 1.0).abs() > 1e-3);
        let machine = |stiffness: f64| Suspension { mass: logarithmic(mass, -8.0), stiffness, damping: logarithmic(damping, -9.0) };
        let grows = |stiffness: f64| fastest(&law, 1.0, (&machine(stiffness), carried)).re;
        match threshold(&law, 1.0, (&machine(0.0), carried)) {
            Threshold::Never => for k in 0..6 {
                prop_assert!(grows(logarithmic(10 * k, -4.0)) < 1e-9);
            },
            Threshold::Always => prop_assert!(grows(1e6 * (1.0 + carried.stiffness)) > -1e-9),
            Threshold::At { stiffness, held, .. } => {
                let part = 0.02 * f64::from(off);
                prop_assert!(grows(stiffness * (1.0 + part)) < 1e-12, "{stiffness:e}");
                let below = (stiffness / (1.0 + part)).max(0.5 * (held + stiffness));
                prop_assert!(grows(below) > 0.0, "{held:e} {stiffness:e}");
                prop_assert!(held <= 0.0 || grows(held / (1.0 + part)) < 1e-12, "{held:e} {stiffness:e}");
            }
        }
    }
}

fn pushed(law: &RateState, machine: Suspension, tolerance: f64) -> RatedMass {
    RatedMass::new(machine, law, (Carried { force: 1.0, stiffness: 5.0 }, 1.0, tolerance))
}

fn slips(mass: &mut RatedMass, until: f64) -> Vec<DrawnMoment> {
    std::iter::from_fn(|| mass.step(until).unwrap()).collect()
}

/// Work of the far end less all that is kept or lost.
fn open(mass: &RatedMass) -> f64 {
    let (state, contact, machine) = (mass.state(), mass.tangential(), mass.suspension());
    let spring = 0.5 * machine.stiffness * state.extension * state.extension;
    let kept = spring + machine.kinetic(state.speed) + contact.stored.unwrap();
    state.work - kept - state.damped - contact.dissipated.unwrap()
}

/// Stick and slip, by the classical rule of Runge and Kutta in steps far shorter than anything in the motion.
#[test]
fn stick_and_slip_is_that_of_small_explicit_steps() {
    for of_state in [StateLaw::Ageing, StateLaw::Slip] {
        let law = law(0.05, 0.1, of_state);
        let machine = Suspension { mass: 1e-3, stiffness: 0.02, damping: 5e-3 };
        let mut mass = pushed(&law, machine, 1e-11);
        mass.draw(1.0);
        let until = 90.0;
        let begun = slips(&mut mass, until);
        let brute = |steps: u32| {
            let h = until / f64::from(steps);
            let rate = |y: [f64; 4]| {
                let slip = law.slip(y[2], y[3]);
                let force = machine.stiffness * y[0] - machine.damping * y[1] - y[2];
                [1.0 - y[1], force / machine.mass, 5.0 * (y[1] - slip.speed), law.evolves(&slip, y[3])]
            };
            let mut y = [0.0, 0.0, 0.0, law.log_state(law.rested(1.0))];
            for _ in 0..steps {
                let on = |k: [f64; 4], part: f64| std::array::from_fn(|i| y[i] + part * h * k[i]);
                let k1 = rate(y);
                let k2 = rate(on(k1, 0.5));
                let k3 = rate(on(k2, 0.5));
                let k4 = rate(on(k3, 1.0));
                y = std::array::from_fn(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]));
            }
            y
        };
        let fine = brute(900_000);
        let state = mass.state();
        assert!(begun.len() >= 2, "{of_state:?}: {begun:?}");
        assert!((state.extension - fine[0]).abs() < 1e-7 * fine[0].abs(), "{of_state:?}: {state:?} {fine:?}");
        assert!((mass.tangential().force - fine[2]).abs() < 1e-7, "{:?} {fine:?}", mass.tangential());
        assert!(open(&mass).abs() < 1e-9 * state.work, "{:e} {:e}", open(&mass), state.work);
    }
}

/// Where a motion is looked at changes nothing, to the last bit; nor does a draw at the speed there is.
#[test]
fn looks_do_not_change_a_motion_of_rate_and_state() {
    let law = law(0.05, 0.1, StateLaw::Ageing);
    let run = |cuts: u32| {
        let mut mass = pushed(&law, Suspension { mass: 1e-3, stiffness: 0.02, damping: 5e-3 }, 1e-9);
        let mut moments = Vec::new();
        for k in 1..=cuts {
            mass.draw(1.0);
            moments.extend(slips(&mut mass, 90.0 * f64::from(k) / f64::from(cuts)));
        }
        (moments, mass.state(), mass.steps())
    };
    let ((one, end, steps), (many, cut, others)) = (run(1), run(333));
    assert!(one.len() > 1 && one == many && steps == others, "{} {}", one.len(), many.len());
    assert_eq!(end, cut);
}

/// At rest a contact strengthens by the ageing law, θ = t, and does not by the slip law.
#[test]
fn a_contact_at_rest_ages() {
    for (of_state, right) in [(StateLaw::Ageing, 1.0 + 1.0 + 100.0), (StateLaw::Slip, 1.0)] {
        let law = law(0.01, 0.015, of_state);
        let mut mass = pushed(&law, Suspension { mass: 1.0, stiffness: 1.0, damping: 0.0 }, 1e-11);
        assert!(slips(&mut mass, 100.0).is_empty());
        assert!((mass.rated().state / right - 1.0).abs() < 1e-9, "{:?}", mass.rated());
    }
}

/// A step of the speed of a stiff machine: over the way θ goes to D/V exponentially by the ageing law, ln(Vθ/D) by the slip law.
#[test]
fn a_step_of_speed_decays_over_the_distance() {
    let left = (-1.5f64).exp();
    for (of_state, right) in [(StateLaw::Ageing, 0.2 + 0.8 * left), (StateLaw::Slip, 5f64.powf(left - 1.0))] {
        let law = law(0.01, 0.015, of_state);
        let machine = Suspension { mass: 1e-9, stiffness: 1e5, damping: 0.0 };
        let carried = Carried { force: 1.0, stiffness: 1e9 };
        let mut mass = RatedMass::sliding(machine, &law, (carried, 1e-11), (1.0, 0.0));
        mass.draw(5.0);
        slips(&mut mass, 0.3);
        // The spring gives by Δμ F/k = 2e-7 of the distance.
        assert!((mass.rated().state / right - 1.0).abs() < 1e-6, "{:?} {right}", mass.rated());
        assert!((mass.tangential().force - law.coefficient(5.0, right.ln())).abs() < 1e-7);
    }
}

proptest! {
    #![proptest_config(crate::laws::cases(24))]

    /// The work of the far end is all kept or lost, whatever the machine, to and fro.
    #[test]
    fn energy_of_rate_and_state_is_accounted_for(
        direct in 1u32..8, evolution in 0u32..12, mass in 0i32..50, stiffness in 0i32..30, damping in 0i32..30,
        ageing in any::<bool>(),
    ) {
        let of_state = if ageing { StateLaw::Ageing } else { StateLaw::Slip };
        let law = law(0.01 * f64::from(direct), 0.01 * f64::from(evolution), of_state);
        let logarithmic = |k: i32, from: f64| 10f64.powf(from + 0.1 * f64::from(k));
        let machine = Suspension {
            mass: logarithmic(mass, -6.0),
            stiffness: logarithmic(stiffness, -3.0),
            damping: logarithmic(damping, -4.0),
        };
        let mut mass = pushed(&law, machine, 1e-10);
        for (k, speed) in [1.0, 5.0, -2.0, 0.0].into_iter().enumerate() {
            mass.draw(speed);
            slips(&mut mass, 40.0 * (k + 1) as f64);
        }
        let most = mass.state().work.abs().max(mass.tangential().dissipated.unwrap());
        prop_assert!(open(&mass).abs() < 1e-7 * most, "{:e} of {:e}", open(&mass), most);
    }
}

/// A contact is fastest where the steps of brute force are.
#[test]
fn the_greatest_speed_of_a_slip_is_told() {
    let law = law(0.05, 0.1, StateLaw::Ageing);
    let mut mass = pushed(&law, Suspension { mass: 1e-3, stiffness: 0.02, damping: 5e-3 }, 1e-10);
    mass.draw(1.0);
    let (mut found, mut seen) = (Vec::new(), 0.0f64);
    for k in 1..=90_000 {
        while let Some(moment) = mass.step(1e-3 * f64::from(k)).unwrap() {
            if moment.what == Turnover::Fastest {
                found.push(mass.rated().speed);
            }
        }
        seen = seen.max(mass.rated().speed);
    }
    let most = found.iter().copied().fold(0.0, f64::max);
    // Looks a thousandth apart see a peak of the width 0.1 to the square of their ratio.
    assert!(most >= seen * (1.0 - 1e-9) && most < seen * (1.0 + 1e-3), "{most:e} {seen:e} {found:?}");
}
