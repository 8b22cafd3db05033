//! Steady sliding against what is known of it.

use super::*;
use crate::halfspace::kernel::Rectangle;
use crate::laws::cases;
use crate::material::Relaxation;
use crate::numerics::quadrature;
use ndarray::Array2;
use proptest::prelude::*;
use std::f64::consts::TAU;

fn rubber() -> Spectrum {
    Spectrum::new(&Relaxation { equilibrium: 1.0, terms: vec![(2.0, 1.0), (5.0, 0.1)], viscosity: 0.0 })
}

fn travelled(side: f64, boundary: Boundary, speed: f64) -> Travelled {
    Travelled { pixel: [side; 2], boundary, speed, ground: None }
}

fn ball(n: usize, half: f64) -> (Array2<f64>, f64) {
    let side = 2.0 * half / n as f64;
    let place = |k: usize| (k as f64 - (n / 2) as f64) * side;
    (Array2::from_shape_fn((n, n), |(i, j)| 0.5 * (place(i).powi(2) + place(j).powi(2))), side)
}

fn slid(heights: &Array2<f64>, side: f64, (boundary, speed): (Boundary, f64), force: f64) -> SteadyContact {
    let response = SteadyResponse::new(&rubber(), heights.dim().into(), &travelled(side, boundary, speed));
    response.solve(heights.view(), Prescribed::Force(force), None, &Settings::default()).unwrap()
}

fn resting(heights: &Array2<f64>, side: f64, (boundary, modulus): (Boundary, f64), force: f64) -> Solution {
    let problem =
        PressedMap { heights: heights.view(), pixel: [side; 2], modulus, boundary, control: Prescribed::Force(force) };
    super::super::solve(&problem, Start::Coarser, &Settings::default()).unwrap()
}

/// Waves in all directions, the height over one period.
fn waves(n: usize, height: f64) -> (Array2<f64>, Vec<(f64, f64, f64)>) {
    let parts = [(1.0, 0.0, 1.0), (2.0, 3.0, 0.4), (-1.0, 2.0, 0.7), (0.0, 1.0, 0.5)];
    let at = |i: usize, j: usize| {
        let (x, y) = (TAU * j as f64 / n as f64, TAU * i as f64 / n as f64);
        parts.iter().map(|(kx, ky, h)| height * h * (kx * x + ky * y).cos()).sum()
    };
    let parts = parts.map(|(kx, ky, h)| (TAU * kx, TAU * ky, height * h)).to_vec();
    (Array2::from_shape_fn((n, n), |(i, j)| at(i, j)), parts)
}

/// Full contact: F_x/A = Σ ¼ |k| |k_x| h² E″(|k_x| v) over the waves. Rounding of the sums, times what the solver may miss.
#[test]
fn waves_pressed_flat() {
    let n = 24;
    for speed in [1e-6, 1e-3, 0.1, 3.0, 1e4] {
        let (heights, parts) = waves(n, 1e-3);
        let found = slid(&heights, 1.0 / n as f64, (Boundary::Periodic, speed), 1.0);
        let of =
            |(kx, ky, h): &(f64, f64, f64)| 0.25 * kx.hypot(*ky) * kx.abs() * h * h * rubber().loss(kx.abs() * speed);
        let exact: f64 = parts.iter().filter(|part| part.0.abs() > 0.0).map(of).sum();
        assert_eq!(found.solution.contact_pixels(), n * n);
        assert!((found.resistance / exact - 1.0).abs() < 1e-6, "{speed}: {} {exact}", found.resistance);
    }
}

/// So slow that the ground follows, and so fast that it never does: the elastic contacts of E∞ and E(0); what repeats
/// across the motion alone stays relaxed. The tolerance of both solvers.
#[test]
fn slow_and_fast_are_elastic() {
    let (flat, side) = ball(48, 0.1);
    let (rough, _) = waves(48, 1e-2);
    for (heights, side, boundary, force) in [
        (&flat, side, Boundary::Free, 5e-4),
        (&flat, side, Boundary::Periodic, 5e-4),
        (&rough, 1.0 / 48.0, Boundary::Periodic, 0.02),
    ] {
        let fast = (boundary == Boundary::Free).then_some((1e12, 8.0));
        for (speed, modulus) in [(0.0, 1.0), (1e-9, 1.0)].into_iter().chain(fast) {
            let found = slid(heights, side, (boundary, speed), force);
            let exact = resting(heights, side, (boundary, modulus), force);
            let apart = |of: fn(&Solution) -> f64| (of(&found.solution) / of(&exact) - 1.0).abs();
            assert!(apart(|s| s.indentation) < 1e-6 && apart(Solution::peak_pressure) < 1e-5, "{boundary:?} {speed}");
            assert!(found.resistance.abs() < 1e-8 * force, "{boundary:?} {speed}: {}", found.resistance);
        }
    }
}

/// Bodies that only touch, or do not, carry nothing at any speed.
#[test]
fn nothing_presses_without_a_load() {
    let (heights, side) = ball(16, 0.1);
    for boundary in [Boundary::Free, Boundary::Periodic] {
        let response = SteadyResponse::new(&rubber(), [16, 16], &travelled(side, boundary, 0.1));
        for control in [Prescribed::Force(0.0), Prescribed::Indentation(0.0), Prescribed::Indentation(-1e-3)] {
            let found = response.solve(heights.view(), control, None, &Settings::default()).unwrap();
            let again = Some(found.solution.pressure.view());
            let again = response.solve(heights.view(), control, again, &Settings::default()).unwrap();
            assert_eq!((found.resistance, found.solution.force(), again), (0.0, 0.0, found.clone()));
        }
    }
}

/// F_x = v Στ F/R of a slow ball, for ∂²u/∂x² = −1/R under it: Σ Eᵢτᵢ/E∞ of the ground. First order at the rim: Δ/a.
#[test]
fn a_slow_ball() {
    let (force, speed) = (5e-4, 1e-4);
    let lag = 2.0 * 1.0 + 5.0 * 0.1;
    let a = (0.75f64 * force).cbrt();
    for n in [32, 64, 96] {
        let (heights, side) = ball(n, 0.1);
        let found = slid(&heights, side, (Boundary::Free, speed), force);
        let exact = speed * lag * force;
        assert!((found.resistance / exact - 1.0).abs() < side / a, "{n}: {}", found.resistance / exact);
    }
}

/// What is lost, −∫ p ∂u/∂ξ dA, is what the shape of the ball says, ∫ p x/R dA: of second order, (Δ/a)².
#[test]
fn the_heat_is_the_work_of_the_shape() {
    let (n, force) = (96, 5e-4);
    let (heights, side) = ball(n, 0.1);
    for speed in [0.03, 0.1, 0.3, 3.0] {
        let found = slid(&heights, side, (Boundary::Free, speed), force);
        let of_shape = |((_, j), p): ((usize, usize), &f64)| p * (j as f64 - (n / 2) as f64) * side.powi(3);
        let shape: f64 = found.solution.pressure.indexed_iter().map(of_shape).sum();
        let bound = 2.0 * (side / found.solution.contact_radius()).powi(2);
        assert!((shape / found.resistance - 1.0).abs() < bound, "{speed}: {shape} {} {bound}", found.resistance);
    }
}

/// The influence taken late against its integral, over twelve decades of the way. Bound: Gauss' rule at the borders of a
/// pixel, where the influence has corners.
#[test]
fn late_influences_are_integrals() {
    let rectangle = Rectangle::new(1.0, 1.0);
    for way in [1e-6, 1e-3, 0.1, 1.0, 7.0, 1e3, 1e6] {
        for row in [0.0, 1.0, 5.0] {
            let given = |x: f64| rectangle.at_place(row, x);
            let n = 8;
            let late = kernel::late_row(&given, n, way);
            for (k, late) in late.iter().enumerate() {
                let x = k as f64 - n as f64;
                let (mut from, mut sum) = (0.0, 0.0);
                while from < 40.0 * way {
                    let to = from + (0.125 * (0.25 + from)).min(0.5 * way);
                    sum += quadrature::panel(|s| given((x + s).abs()) * (-s / way).exp() / way, from, to);
                    from = to;
                }
                assert!((late / sum - 1.0).abs() < 5e-5, "{way} {row} {x}: {late} {sum}");
            }
        }
    }
}

proptest! {
    #![proptest_config(cases(16))]

    /// Whatever the heights: nothing is won, a contact is the same wherever its period begins, and mirrored across the
    /// motion. Bound: the tolerance of the solver, of a sum of which little may be left.
    #[test]
    fn nothing_is_won(seed in 0u64..1 << 40, decade in -40i32..40, load in 0i32..30, shift in 0usize..16) {
        let n = 16;
        let mut state = seed;
        let mut draw = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1u64 << 53) as f64
        };
        let heights = Array2::from_shape_fn((n, n), |_| 1e-2 * draw());
        let (speed, force) = (10f64.powf(0.1 * f64::from(decade)), 1e-2 * 10f64.powf(-0.1 * f64::from(load)));
        let found = slid(&heights, 1.0 / n as f64, (Boundary::Periodic, speed), force);
        prop_assert!(found.resistance >= -1e-9 * force, "{}", found.resistance);
        let turned = Array2::from_shape_fn((n, n), |(i, j)| heights[[(n - i) % n, (j + shift) % n]]);
        let other = slid(&turned, 1.0 / n as f64, (Boundary::Periodic, speed), force);
        prop_assert!((other.resistance - found.resistance).abs() <= 1e-6 * force, "{} {}", found.resistance, other.resistance);
        prop_assert!((other.solution.indentation / found.solution.indentation - 1.0).abs() < 1e-6);
    }
}

/// Over a ground that gives way at no time at once, or next to nothing, the pressure rises and falls once along the motion,
/// though pixels that take turns would hardly be told apart in their middles; what it costs tends to a limit as pixels
/// shrink, of first order or better.
#[test]
fn pixels_do_not_take_turns() {
    for (terms, viscosity) in
        [(Vec::new(), 0.03), (Vec::new(), 0.1), (vec![(1e3, 3e-5)], 0.0), (vec![(1e3, 1e-4)], 0.0)]
    {
        let ground = Spectrum::new(&Relaxation { equilibrium: 1.0, terms, viscosity });
        let mut coarser: Option<Array2<f64>> = None;
        let resistances = [32, 64, 128].map(|n| {
            let (heights, side) = ball(n, 0.15);
            let response = SteadyResponse::new(&ground, [n, n], &travelled(side, Boundary::Free, 1.0));
            let start = coarser.as_ref().map(|coarser| Array2::from_shape_fn((n, n), |(i, j)| coarser[[i / 2, j / 2]]));
            let start = start.as_ref().map(|start| start.view());
            let contact = response.solve(heights.view(), Prescribed::Force(1e-3), start, &Settings::default()).unwrap();
            coarser = Some(contact.solution.pressure.clone());
            let along: Vec<f64> = contact.solution.pressure.row(n / 2).to_vec();
            let way: f64 = along.windows(2).map(|pair| (pair[1] - pair[0]).abs()).sum();
            let peak = along.iter().copied().fold(0.0, f64::max);
            assert!(way < 1.1 * 2.0 * peak, "{viscosity} {n}: {}", way / (2.0 * peak));
            contact.resistance
        });
        let apart = [0, 1].map(|k| (resistances[k] - resistances[k + 1]).abs());
        assert!(apart[1] < 0.75 * apart[0], "{viscosity}: {resistances:?}");
    }
}
