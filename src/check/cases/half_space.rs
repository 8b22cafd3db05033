//! The full half-space against closed forms, and the plane closed forms against the half-plane solver.

use crate::check::case::{Case, Proof};
use crate::check::theory::{WavyParabola, Westergaard};
use crate::contact::elliptic::EllipticHertz;
use crate::halfspace::{
    Boundary, PlaneBoundary, PlaneProblem, PlaneSolution, Prescribed, PressedMap, Settings, Solution, Start, solve,
    solve_plane,
};
use ndarray::{Array1, Array2};
use std::f64::consts::{PI, TAU};

pub(super) const CASES: &[Case] = &[
    Case {
        name: "half-space/Hertz on 512²",
        proof: Proof::Other,
        bound: 2.5e-6,
        reason: "every solver of pixels of constant pressure finds 2.3e-6 in the force on this window of three radii",
        weak: "one place of the apex, on a node",
        error: || hertz_error(512, 0.0).unwrap_or(f64::NAN),
    },
    Case {
        name: "half-space/Hertz on 1024²",
        proof: Proof::Other,
        bound: 6e-7,
        reason: "every solver of pixels of constant pressure finds 5.7e-7 in the force on this window of three radii",
        weak: "one place of the apex, on a node",
        error: || hertz_error(1024, 0.0).unwrap_or(f64::NAN),
    },
    Case {
        name: "half-space/Hertz with the apex on, between and off the nodes",
        proof: Proof::Order,
        bound: 1.0,
        reason: "|ε| ≤ (Δ/a)²/8, printed as the part of the bound used",
        weak: "even and odd grids of 63 to 96 pixels",
        error: || apex().unwrap_or(f64::NAN),
    },
    Case {
        name: "half-space/cone",
        proof: Proof::Order,
        bound: 1.0,
        reason: "the apex is blunted over a pixel: |ε| ≤ (Δ/a)²/2, printed as the part of the bound used",
        weak: "one slope and grid",
        error: || cone().unwrap_or(f64::NAN),
    },
    Case {
        name: "half-space/flat punch",
        proof: Proof::Order,
        bound: 1.0,
        reason: "F = 2E*bd with b the radius of the pixels' area, to half a pixel; printed as the part of the bound used",
        weak: "a ragged edge is first order",
        error: || flat_punch().unwrap_or(f64::NAN),
    },
    Case {
        name: "half-space/elliptic Hertz",
        proof: Proof::Order,
        bound: 1.0,
        reason: "|ε| ≤ (Δ/b)²/8 in the indentation under a force, printed as the part of the bound used",
        weak: "radii 1 to 0.1 and one grid",
        error: || ellipse().unwrap_or(f64::NAN),
    },
    Case {
        name: "half-space/full contact of two waves",
        proof: Proof::Rounding,
        bound: 1e-6,
        reason: "the spectral answer p̄ − ½E*q·h, to the tolerance of 1e-8 times the stiffness of the shortest wave",
        weak: "one grid",
        error: || full_contact().unwrap_or(f64::NAN),
    },
    Case {
        name: "half-plane/Westergaard wave",
        proof: Proof::Order,
        bound: 1.0,
        reason: "half width to a strip, indentation d = Δt(1 − ln t), t = sin²(πa/λ), to (π/n)² of Δ; printed as the part of the bound used",
        weak: "five loads, 1024 strips",
        error: || westergaard().unwrap_or(f64::NAN),
    },
    Case {
        name: "half-plane/wavy parabola in one piece",
        proof: Proof::Other,
        bound: 4e-5,
        reason: "the Chebyshev series of Kudish et al. 2.12 beside the half-plane solver of 2000 strips: pressure in the middle half, to (strip/wave)²",
        weak: "one roughness and load",
        error: || wavy_parabola().unwrap_or(f64::NAN),
    },
];

fn solved(heights: &Array2<f64>, pixel: [f64; 2], boundary: Boundary, control: Prescribed) -> Option<Solution> {
    let problem = PressedMap { heights: heights.view(), pixel, modulus: 1.0, boundary, control };
    solve(&problem, Start::Coarser, &Settings::default()).ok()
}

/// Heights with the origin `offset` pixels off the middle node.
fn sampled((n, pixel, offset): (usize, f64, f64), f: impl Fn(f64, f64) -> f64) -> Array2<f64> {
    let place = |index: usize| (index as f64 - (n / 2) as f64 + offset) * pixel;
    Array2::from_shape_fn((n, n), |(row, column)| f(place(column), place(row)))
}

/// |F/F_Hertz − 1| for R = E* = 1, d = 0.01, a = 0.1 on a window of 3a.
fn hertz_error(n: usize, offset: f64) -> Option<f64> {
    let pixel = 0.3 / n as f64;
    let heights = sampled((n, pixel, offset), |x, y| 0.5 * (x * x + y * y));
    let force = solved(&heights, [pixel; 2], Boundary::Free, Prescribed::Indentation(0.01))?.force();
    Some((force * 750.0 - 1.0).abs())
}

fn apex() -> Option<f64> {
    let mut most: f64 = 0.0;
    for n in [63, 64, 81, 96] {
        for offset in [0.0, 0.25, 0.5] {
            most = most.max(hertz_error(n, offset)? * 8.0 * (n as f64 / 3.0).powi(2));
        }
    }
    Some(most)
}

fn cone() -> Option<f64> {
    let (slope, depth, n) = (0.1, 0.01, 96);
    let radius = 2.0 * depth / (PI * slope);
    let pixel = 3.0 * radius / n as f64;
    let heights = sampled((n, pixel, 0.5), |x, y| slope * x.hypot(y));
    let force = solved(&heights, [pixel; 2], Boundary::Free, Prescribed::Indentation(depth))?.force();
    Some((force * PI * slope / (2.0 * depth * depth) - 1.0).abs() * 2.0 * (radius / pixel).powi(2))
}

fn flat_punch() -> Option<f64> {
    let pixel = 0.025;
    let heights = sampled((96, pixel, 0.5), |x, y| if x.hypot(y) <= 1.0 { 0.0 } else { f64::INFINITY });
    let solution = solved(&heights, [pixel; 2], Boundary::Free, Prescribed::Indentation(0.1))?;
    Some((solution.force() / (0.2 * solution.contact_radius()) - 1.0).abs() / (0.5 * pixel))
}

fn ellipse() -> Option<f64> {
    let exact = EllipticHertz::at_indentation([1.0, 0.1], 1.0, 0.01).ok()?;
    let n = 96;
    let pixel = exact.semi_axes.map(|axis| 3.0 * axis / n as f64);
    let place = |index: usize, pixel: f64| (index as f64 - 47.5) * pixel;
    let heights = Array2::from_shape_fn((n, n), |(row, column)| {
        0.5 * place(column, pixel[0]).powi(2) + 5.0 * place(row, pixel[1]).powi(2)
    });
    let solution = solved(&heights, pixel, Boundary::Free, Prescribed::Force(exact.force))?;
    Some((solution.indentation / exact.indentation - 1.0).abs() * 8.0 * (n as f64 / 3.0).powi(2))
}

fn full_contact() -> Option<f64> {
    let (rows, columns) = (27, 45);
    let waves = |row: usize, column: usize| {
        let (x, y) = (TAU * column as f64 / columns as f64, TAU * row as f64 / rows as f64);
        [1e-3 * (x + 0.3).cos(), 5e-4 * (2.0 * x - 3.0 * y).sin()]
    };
    let heights = Array2::from_shape_fn((rows, columns), |(row, column)| waves(row, column).iter().sum());
    let pixel = [1.0 / columns as f64, 1.0 / rows as f64];
    let solution = solved(&heights, pixel, Boundary::Periodic, Prescribed::Force(0.1))?;
    let difference = |((row, column), p): ((usize, usize), &f64)| {
        let [first, second] = waves(row, column);
        ((p - 0.1 + PI * (first + 13.0_f64.sqrt() * second)) / 0.1).abs()
    };
    Some(solution.pressure.indexed_iter().map(difference).fold(0.0, f64::max))
}

fn plane(
    heights: &Array1<f64>,
    step: f64,
    modulus: f64,
    (boundary, load): (PlaneBoundary, f64),
) -> Option<PlaneSolution> {
    let problem = PlaneProblem { heights: heights.view(), step, modulus, boundary, control: Prescribed::Force(load) };
    solve_plane(&problem, None, &Settings::default()).ok()
}

fn westergaard() -> Option<f64> {
    let n = 1024;
    let wave = Westergaard { modulus: 1.0, amplitude: 0.01, wavelength: 1.0 };
    let heights = Array1::from_shape_fn(n, |i| 0.02 * (PI * i as f64 / n as f64).sin().powi(2));
    let mut most: f64 = 0.0;
    for share in [0.02, 0.1, 0.3, 0.45, 0.49] {
        let load = wave.mean_pressure(share);
        let solution = plane(&heights, 1.0 / n as f64, 1.0, (PlaneBoundary::Periodic, load))?;
        let t = (PI * share).sin().powi(2);
        let depth = 0.01 * t * (1.0 - t.ln());
        most = most.max((0.5 * solution.contact_width() - share).abs() * n as f64);
        most = most.max((solution.indentation - depth).abs() / 0.01 * (n as f64 / PI).powi(2));
    }
    Some(most)
}

fn wavy_parabola() -> Option<f64> {
    let (modulus, radius, load) = (1e7, 0.1, 200.0);
    let wave = 4e-4;
    let slope = |x: f64| 1e-3 * (x / wave).sin();
    let contact = WavyParabola { modulus, radius, slope: &slope }.under(load).ok()?;
    let n = 2000;
    let step = 3.0 * contact.half_width / n as f64;
    let place = |i: usize| (i as f64 - 999.5) * step;
    let height = |x: f64| 0.5 * x * x / radius + 2e-3 * wave * (0.5 * x / wave).sin().powi(2);
    let heights = Array1::from_shape_fn(n, |i| height(place(i)));
    let solution = plane(&heights, step, modulus, (PlaneBoundary::Free { datum: 1.0 }, load))?;
    let inner = (0..n).filter(|&i| place(i).abs() < 0.5 * contact.half_width);
    let difference = |i: usize| (solution.pressure[i] / contact.pressure(place(i)) - 1.0).abs();
    Some(inner.map(difference).fold(0.0, f64::max))
}
