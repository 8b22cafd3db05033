use ndarray::{Array1, Array2};
use proptest::prelude::*;

use super::*;
use crate::contact::elliptic::EllipticHertz;

const PI: f64 = std::f64::consts::PI;

fn free(heights: &Array2<f64>, pixel: f64, control: Prescribed) -> PressedMap<'_> {
    PressedMap { heights: heights.view(), pixel: [pixel; 2], modulus: 1.0, boundary: Boundary::Free, control }
}

fn solved(problem: &PressedMap<'_>) -> Solution {
    solve(problem, Start::Coarser, &Settings::default()).unwrap()
}

/// Heights of f(x, y) with the origin `offset` pixels off the middle node.
fn sample(n: usize, pixel: f64, offset: f64, f: impl Fn(f64, f64) -> f64) -> Array2<f64> {
    let place = |index: usize| (index as f64 - (n / 2) as f64 + offset) * pixel;
    Array2::from_shape_fn((n, n), |(row, column)| f(place(column), place(row)))
}

/// Relative errors of force, radius and peak pressure: Hertz with R = E* = 1, d = 0.01, a = 0.1 on a window of 3a.
fn hertz(n: usize, offset: f64) -> [f64; 3] {
    let pixel = 0.3 / n as f64;
    let heights = sample(n, pixel, offset, |x, y| (x * x + y * y) / 2.0);
    let solution = solved(&free(&heights, pixel, Prescribed::Indentation(0.01)));
    let force = 4.0 / 3.0 * 0.1 * 0.01;
    [
        solution.force() / force - 1.0,
        solution.hertzian_semi_axes()[0] / 0.1 - 1.0,
        solution.peak_pressure() * PI / 0.2 - 1.0,
    ]
}

/// Order: the heights are exact at the nodes and the pressure is constant on a pixel, so the force errs by
/// (Δ/a)² times a number of order ∫(p″) ~ 1/8, which the edge, itself uncertain within a pixel, changes by as much.
/// A peak between the nodes is lower by (Δ/2a)² at most, since p = p₀√(1 − r²/a²), r² ≤ Δ²/2.
#[test]
fn hertz_falls_with_the_square_of_the_pixel_wherever_the_apex_lies() {
    for n in [32, 45, 64, 81, 128] {
        for offset in [0.0, 0.25, 0.5] {
            let [force, radius, peak] = hertz(n, offset);
            let square = (3.0 / n as f64).powi(2);
            assert!(force.abs() < 0.125 * square, "{n} {offset}: {force}");
            assert!(radius.abs() < 0.25 * square, "{n} {offset}: {radius}");
            assert!(peak.abs() < 0.375 * square, "{n} {offset}: {peak}");
        }
    }
}

/// Other code: every solver of pixels of constant pressure finds 2.3e-6 on this grid.
#[test]
fn hertz_on_512_pixels() {
    let [force, ..] = hertz(512, 0.0);
    assert!(force.abs() < 2.5e-6, "{force}");
}

/// A grid on the borderline: heights that tie in symmetric pairs, the indentation exactly a height of the grid,
/// and the same grid written in two algebraically equal ways.
#[test]
fn no_grid_hangs_on_rounding() {
    let n = 64;
    let pixel = 0.3 / n as f64;
    let centred = sample(n, pixel, 0.5, |x, y| (x * x + y * y) / 2.0);
    let expanded = Array2::from_shape_fn((n, n), |(row, column)| {
        let place = |index: usize| (index as f64 + 0.5) * pixel - 0.5 * n as f64 * pixel;
        place(row).powi(2) / 2.0 + place(column).powi(2) / 2.0
    });
    let forces: Vec<f64> = [&centred, &expanded]
        .map(|heights| solved(&free(heights, pixel, Prescribed::Indentation(0.01))).force())
        .into();
    assert!((forces[0] / forces[1] - 1.0).abs() < 1e-7, "{forces:?}");
    let tie = centred[[n / 2, n / 2 + 20]];
    let around: Vec<f64> = [tie.next_down(), tie, tie.next_up()]
        .map(|depth| solved(&free(&centred, pixel, Prescribed::Indentation(depth))).force())
        .into();
    assert!((around[0] / around[1] - 1.0).abs() < 1e-7 && (around[2] / around[1] - 1.0).abs() < 1e-7, "{around:?}");
}

/// Symmetric heights, symmetric pressure, to the tolerance amplified by the stiffest wave (π pixels⁻¹, E*|q|/2).
#[test]
fn pressure_has_the_symmetry_of_the_heights() {
    let n = 48;
    let heights = sample(n, 0.01, 0.5, |x, y| (x * x + y * y) / 2.0);
    let pressure = solved(&free(&heights, 0.01, Prescribed::Indentation(0.01))).pressure;
    let peak = pressure.iter().copied().fold(0.0, f64::max);
    for ((row, column), p) in pressure.indexed_iter() {
        for other in [[column, row], [n - 1 - row, column], [row, n - 1 - column]] {
            assert!((p - pressure[other]).abs() < 1e-5 * peak);
        }
    }
}

/// F = 2E*bd. A circle of pixels has an equivalent radius √(A/π); its ragged edge changes the force by less than
/// half a pixel of radius, which is the bound.
#[test]
fn flat_punch_with_no_material_around_it() {
    let n = 96;
    let pixel = 0.025;
    let heights = sample(n, pixel, 0.5, |x, y| if x.hypot(y) <= 1.0 { 0.0 } else { f64::INFINITY });
    let solution = solved(&free(&heights, pixel, Prescribed::Indentation(0.1)));
    assert!((solution.force() / (2.0 * solution.contact_radius() * 0.1) - 1.0).abs() < 0.5 * pixel);
    assert_eq!(solution.contact_pixels(), heights.iter().filter(|height| height.is_finite()).count());
    let under = solution.displacement.iter().zip(&heights).filter(|(_, height)| height.is_finite());
    under.for_each(|(u, _)| assert!((u - 0.1).abs() < 1e-8));
}

/// F = (2/π)E*d²/t. The apex is blunted over a pixel: error of the order (Δ/a)² with a = 2d/(πt).
#[test]
fn cone() {
    let (slope, depth) = (0.1, 0.01);
    let radius = 2.0 * depth / (PI * slope);
    for n in [64, 128] {
        let pixel = 3.0 * radius / n as f64;
        let heights = sample(n, pixel, 0.5, |x, y| slope * x.hypot(y));
        let force = solved(&free(&heights, pixel, Prescribed::Indentation(depth))).force();
        assert!((force * PI * slope / (2.0 * depth * depth) - 1.0).abs() < 0.5 * (pixel / radius).powi(2));
    }
}

/// Ellipsoids on square and on stretched pixels against the elliptic integrals; bound as for the sphere with
/// the smaller semi-axis, b.
#[test]
fn elliptic_hertz() {
    for ratio in [0.5, 0.1] {
        let exact = EllipticHertz::at_indentation([1.0, ratio], 1.0, 0.01).unwrap();
        let [a, b] = exact.semi_axes;
        let (n, pixel) = (96, [3.0 * a / 96.0, 3.0 * b / 96.0]);
        let heights = Array2::from_shape_fn((n, n), |(row, column)| {
            let (x, y) = ((column as f64 - 47.5) * pixel[0], (row as f64 - 47.5) * pixel[1]);
            x * x / 2.0 + y * y / (2.0 * ratio)
        });
        let problem = PressedMap {
            heights: heights.view(),
            pixel,
            modulus: 1.0,
            boundary: Boundary::Free,
            control: Prescribed::Force(exact.force),
        };
        let solution = solved(&problem);
        let square = (3.0_f64 / 96.0).powi(2);
        assert!((solution.indentation / exact.indentation - 1.0).abs() < 0.125 * square);
        assert!((solution.peak_pressure() / exact.peak_pressure - 1.0).abs() < 0.375 * square);
        let axes = solution.hertzian_semi_axes();
        assert!((axes[0] / a - 1.0).abs() < 0.25 * square && (axes[1] / b - 1.0).abs() < 0.25 * square);
    }
}

/// Westergaard 1939: p̄ = (πE*Δ/λ) sin²(πa/λ) for heights Δ(1 − cos(2πx/λ)), a the half width of contact.
/// The edge is known within a pixel.
#[test]
fn westergaard_wave() {
    let n = 1024;
    let heights = Array1::from_shape_fn(n, |i| 0.01 * (1.0 - (2.0 * PI * i as f64 / n as f64).cos()));
    for share in [0.02, 0.1, 0.3, 0.45, 0.49_f64] {
        let force = PI * 0.01 * (PI * share).sin().powi(2);
        let problem = PlaneProblem {
            heights: heights.view(),
            step: 1.0 / n as f64,
            modulus: 1.0,
            boundary: PlaneBoundary::Periodic,
            control: Prescribed::Force(force),
        };
        let solution = solve_plane(&problem, None, &Settings::default()).unwrap();
        assert!(
            (solution.contact_width() / 2.0 - share).abs() <= 1.0 / n as f64,
            "{share}: {}",
            solution.contact_width()
        );
        let peak = 2.0 * force / (PI * share).sin();
        assert!((solution.peak_pressure() / peak - 1.0).abs() < 2.0 / (n as f64 * share), "{share}");
    }
}

/// Cylinder on a half-plane: a = 2√(FR/πE*), p₀ = 2F/πa (Johnson 4.43–4.45), and whatever the datum the same pressure.
#[test]
fn cylinder_on_a_free_half_plane() {
    let n = 500;
    let (radius, force) = (1.0, 0.01);
    let half = 2.0 * (force * radius / PI).sqrt();
    let step = 3.0 * half / n as f64;
    let heights = Array1::from_shape_fn(n, |i| ((i as f64 - 249.3) * step).powi(2) / (2.0 * radius));
    let solution = |datum: f64| {
        let problem = PlaneProblem {
            heights: heights.view(),
            step,
            modulus: 1.0,
            boundary: PlaneBoundary::Free { datum },
            control: Prescribed::Force(force),
        };
        solve_plane(&problem, None, &Settings::default()).unwrap()
    };
    let (near, far) = (solution(n as f64 * step), solution(1e3));
    assert!((near.contact_width() / (2.0 * half) - 1.0).abs() < step / half);
    assert!((near.peak_pressure() * PI * half / (2.0 * force) - 1.0).abs() < (step / half).powi(2));
    let rigid = 2.0 / PI * force * (1e3 / (n as f64 * step)).ln();
    assert!((far.indentation - near.indentation - rigid).abs() < 1e-7 * far.indentation);
    assert!((far.peak_pressure() / near.peak_pressure() - 1.0).abs() < 1e-6);
}

/// Full contact of two waves: p = p̄ − Σ ½E*q·(their heights), the spectral answer, to the tolerance times
/// the stiffness of the shortest wave.
#[test]
fn full_contact_is_the_spectral_answer() {
    for (rows, columns) in [(32, 32), (27, 45), (16, 50)] {
        let wave = |row: usize, column: usize| {
            let (x, y) = (2.0 * PI * column as f64 / columns as f64, 2.0 * PI * row as f64 / rows as f64);
            [1e-3 * (x + 0.3).cos(), 5e-4 * (2.0 * x - 3.0 * y).sin()]
        };
        let heights = Array2::from_shape_fn((rows, columns), |(row, column)| wave(row, column).iter().sum());
        let pixel = [1.0 / columns as f64, 1.0 / rows as f64];
        let problem = PressedMap {
            heights: heights.view(),
            pixel,
            modulus: 2.0,
            boundary: Boundary::Periodic,
            control: Prescribed::Force(0.1),
        };
        let solution = solved(&problem);
        for ((row, column), p) in solution.pressure.indexed_iter() {
            let [first, second] = wave(row, column);
            let exact = 0.1 - 2.0 * PI * (first + 13.0_f64.sqrt() * second);
            assert!((p - exact).abs() < 1e-6 * 0.1, "{rows}×{columns}: {p} {exact}");
        }
        assert!(solution.indentation.abs() < 1e-8);
    }
}

/// The bed's own pressure as a start saves iterations, and the answer is the same.
#[test]
fn a_good_start_saves_iterations() {
    let n = 128;
    let pixel = 0.3 / n as f64;
    let heights = sample(n, pixel, 0.0, |x, y| (x * x + y * y) / 2.0);
    let hertzian = sample(n, pixel, 0.0, |x, y| 0.2 / PI * (1.0 - (x * x + y * y) / 0.01).max(0.0).sqrt());
    let problem = free(&heights, pixel, Prescribed::Indentation(0.01));
    let run = |start: Start<'_>| solve(&problem, start, &Settings::default()).unwrap();
    let (blank, coarser, bed) = (run(Start::Nothing), run(Start::Coarser), run(Start::Pressure(hertzian.view())));
    assert!(coarser.iterations < blank.iterations && bed.iterations <= coarser.iterations + 1);
    assert!((bed.force() / blank.force() - 1.0).abs() < 1e-7 && (coarser.force() / blank.force() - 1.0).abs() < 1e-7);
}

/// The same bits on one, two and five threads.
#[test]
fn threads_do_not_change_a_bit() {
    let heights = sample(150, 0.002, 0.3, |x, y| (x * x + y * y) / 2.0 + 1e-4 * (700.0 * x).sin() * (500.0 * y).cos());
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| solved(&free(&heights, 0.002, Prescribed::Force(1e-3))))
    };
    let one = on(1);
    assert!(one == on(2) && one == on(5));
}

/// Nothing but units: powers of ten over thirty decades change the answer by rounding only.
#[test]
fn units_do_not_matter() {
    let heights = sample(40, 0.0075, 0.0, |x, y| (x * x + y * y) / 2.0);
    let reference = solved(&free(&heights, 0.0075, Prescribed::Indentation(0.01))).force();
    for exponent in [-15, -6, 9, 15] {
        let unit = 10.0_f64.powi(exponent);
        let scaled = heights.mapv(|height| height * unit);
        let problem =
            PressedMap { modulus: unit, ..free(&scaled, 0.0075 * unit, Prescribed::Indentation(0.01 * unit)) };
        assert!((solved(&problem).force() / (reference * unit * unit * unit) - 1.0).abs() < 1e-7);
    }
}

#[test]
fn bodies_apart_do_not_press() {
    let heights = sample(16, 0.1, 0.0, |x, y| 1.0 + x * x + y * y);
    assert!(solved(&free(&heights, 0.1, Prescribed::Indentation(1.0))).force() <= 0.0);
    let touch = solved(&free(&heights, 0.1, Prescribed::Force(0.0)));
    assert!(touch.force() <= 0.0 && (touch.indentation - 1.0).abs() < 1e-15);
}

#[test]
fn wrong_input_is_told_with_its_place() {
    let message = |heights: &Array2<f64>, control: Prescribed, settings: Settings| {
        solve(&free(heights, 0.1, control), Start::Coarser, &settings).unwrap_err().to_string()
    };
    let good = sample(16, 0.1, 0.0, |x, y| x * x + y * y);
    let usual = Settings::default();
    let mut bad = good.clone();
    bad[[3, 5]] = f64::NAN;
    let depth = Prescribed::Indentation(0.1);
    assert!(message(&bad, depth, usual).starts_with("the height at row 3, column 5 is NaN"));
    bad[[3, 5]] = f64::NEG_INFINITY;
    assert!(message(&bad, depth, usual).starts_with("the height at row 3, column 5 is -inf"));
    bad.fill(f64::INFINITY);
    assert!(message(&bad, depth, usual).contains("no material"));
    assert!(message(&Array2::zeros((0, 7)), depth, usual).contains("empty (0 rows, 7 columns)"));
    assert!(message(&good, Prescribed::Force(-1.0), usual).starts_with("force is -1"));
    assert!(message(&good, Prescribed::Indentation(f64::NAN), usual).starts_with("indentation is NaN"));
    assert!(message(&good, depth, Settings { tolerance: 0.0, ..usual }).starts_with("tolerance is 0"));
    assert!(message(&good, depth, Settings { memory_limit: 10_000, ..usual }).contains("10000 are allowed"));
    let short = message(&good, depth, Settings { max_iterations: 1, ..usual });
    assert!(short.starts_with("no convergence") && short.contains("after 1 iterations"), "{short}");
}

/// A million pixels a side would take terabytes: refused at once, without asking for them.
#[test]
fn a_grid_too_large_is_refused_before_it_is_made() {
    let row = Array2::<f64>::zeros((1, 1));
    let heights = row.broadcast((1_000_000, 1_000_000)).unwrap();
    let problem = PressedMap {
        heights,
        pixel: [1.0; 2],
        modulus: 1.0,
        boundary: Boundary::Free,
        control: Prescribed::Force(1.0),
    };
    assert!(matches!(solve(&problem, Start::Coarser, &Settings::default()), Err(HalfSpaceError::Memory { .. })));
}

/// Deeper than the mean height a periodic surface is in full contact and no force follows.
#[test]
fn periodic_indentation_beyond_full_contact_is_refused() {
    let heights = sample(16, 0.1, 0.0, |x, _| (2.0 * PI * x / 1.6).cos());
    let problem =
        |depth: f64| PressedMap { boundary: Boundary::Periodic, ..free(&heights, 0.1, Prescribed::Indentation(depth)) };
    assert!(matches!(
        solve(&problem(0.1), Start::Coarser, &Settings::default()),
        Err(HalfSpaceError::FullContact { .. })
    ));
    assert!(solved(&problem(-0.1)).force() > 0.0);
}

/// Surfaces of any size, stretched pixels, smooth or rough to the pixel.
fn surface() -> impl Strategy<Value = (Array2<f64>, [f64; 2])> {
    (1..30_usize, 1..30_usize, 0..200_i32, -10..10_i32, any::<u32>()).prop_map(
        |(rows, columns, rough, stretch, seed)| {
            let roughness = 10.0_f64.powf(-4.0 + 0.02 * f64::from(rough));
            let mixed =
                |k: usize| (k as u64 + 1).wrapping_mul(u64::from(seed) * 2 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
            let noise = |k: usize| (mixed(k) >> 40) as f64 / f64::from(1 << 24);
            let heights = Array2::from_shape_fn((rows, columns), |(row, column)| {
                let (x, y) = (column as f64 / columns as f64 - 0.4, row as f64 / rows as f64 - 0.5);
                x * x + y * y + roughness * noise(row * columns + column)
            });
            (heights, [10.0_f64.powf(0.05 * f64::from(stretch)) / columns as f64, 1.0 / rows as f64])
        },
    )
}

/// p ≥ 0, no overlap, p·g = 0, all to the stated residual and the rounding of the heights, and the force that was asked for.
fn obeys_the_laws(problem: &PressedMap<'_>) -> Result<(), TestCaseError> {
    let solution =
        solve(problem, Start::Coarser, &Settings::default()).map_err(|error| TestCaseError::fail(error.to_string()))?;
    let contact = solution.pressure.iter().zip(&solution.displacement).filter(|(p, _)| **p > 0.0);
    let unit = (problem.pixel[0] * problem.pixel[1]).sqrt() / problem.modulus;
    let scale = contact.fold(0.0_f64, |scale, (p, u)| scale.max(u.abs()).max(2.0 * unit * p));
    for ((p, u), height) in solution.pressure.iter().zip(&solution.displacement).zip(problem.heights) {
        let gap = u + height - solution.indentation;
        let bound = 1.1e-8 * scale + 2.0 * f64::EPSILON * height.abs();
        prop_assert!(
            *p >= 0.0 && gap >= -bound && (*p <= 0.0 || gap.abs() <= bound),
            "p = {p}, gap = {gap}, scale {scale}"
        );
    }
    if let Prescribed::Force(force) = problem.control {
        prop_assert!((solution.force() / force - 1.0).abs() < 1e-12);
    }
    Ok(())
}

proptest! {
    #![proptest_config(crate::laws::cases(96))]

    #[test]
    fn free_contact_obeys_its_laws((heights, pixel) in surface(), depth in 1..100_i32, load in any::<bool>()) {
        let depth = 0.005 * f64::from(depth);
        let control = if load { Prescribed::Force(depth) } else { Prescribed::Indentation(depth) };
        let problem = PressedMap { heights: heights.view(), pixel, modulus: 1.0, boundary: Boundary::Free, control };
        obeys_the_laws(&problem)?;
    }

    #[test]
    fn periodic_contact_obeys_its_laws((heights, pixel) in surface(), exponent in 0..100_i32) {
        let control = Prescribed::Force(10.0_f64.powf(-12.0 + 0.13 * f64::from(exponent)));
        let problem = PressedMap { heights: heights.view(), pixel, modulus: 1.0, boundary: Boundary::Periodic, control };
        obeys_the_laws(&problem)?;
    }

    /// A surface that repeats, drawn back from full contact, under any pressure that would do: one that is uniform
    /// displaces nothing.
    #[test]
    fn full_contact_opens((heights, pixel) in surface(), depth in 1..100_i32, more in 0..12_i32) {
        let mean = heights.mean().unwrap_or_default();
        let lowest = heights.iter().copied().fold(f64::INFINITY, f64::min);
        prop_assume!(mean > lowest);
        let boundary = Boundary::Periodic;
        let flat = PressedMap { heights: heights.view(), pixel, modulus: 1.0, boundary, control: Prescribed::Force(1e6) };
        let flat = solved(&flat).pressure + 10.0_f64.powi(more);
        let control = Prescribed::Indentation(lowest + 0.01 * f64::from(depth) * (mean - lowest));
        let problem = PressedMap { heights: heights.view(), pixel, modulus: 1.0, boundary, control };
        let [anew, back] = [Start::Nothing, Start::Pressure(flat.view())].map(|start| {
            solve(&problem, start, &Settings::default()).map(|solution| solution.force())
        });
        let (anew, back) = (anew.unwrap_or(f64::NAN), back.unwrap_or(f64::NAN));
        prop_assert!((back / anew - 1.0).abs() < 1e-5, "{anew:e} {back:e}");
    }
}

/// A response made before, and a hardness that is never reached, change nothing; one that is reached caps the pressure,
/// and what presses with less neither overlaps nor is apart.
#[test]
fn pressures_end_at_the_hardness() {
    let heights = sample(33, 0.01, 0.0, |x, y| (x * x + y * y) / 2.0);
    let problem = free(&heights, 0.01, Prescribed::Indentation(2e-3));
    let (settings, elastic) = (Settings::default(), solved(&problem));
    let response = || SurfaceResponse::new([33, 33], [0.01; 2], Boundary::Free);
    let same = solve_on(&response(), &problem, Start::Coarser, &settings).unwrap();
    assert_eq!(same.pressure, elastic.pressure);
    let hard =
        solve_on(&response().yielding_under(1.01 * elastic.peak_pressure()), &problem, Start::Coarser, &settings);
    let apart = (&hard.unwrap().pressure - &elastic.pressure).iter().fold(0.0, |most: f64, p| most.max(p.abs()));
    assert!(apart < 1e-6 * elastic.peak_pressure(), "{apart:e}");
    let hardness = 0.6 * elastic.peak_pressure();
    let soft = solve_on(&response().yielding_under(hardness), &problem, Start::Coarser, &settings).unwrap();
    assert!(soft.force() < elastic.force() && soft.peak_pressure() <= hardness);
    for ((&p, &u), &height) in soft.pressure.iter().zip(&soft.displacement).zip(&heights) {
        let gap = u + height - soft.indentation;
        let wrong = if p >= hardness {
            gap.max(0.0)
        } else if p > 0.0 {
            gap.abs()
        } else {
            (-gap).max(0.0)
        };
        assert!(wrong < 1e-8 * 2e-3, "{p:e} {gap:e}");
    }
    // The same force, by a greater depth; more than the window can bear is refused.
    let forced = free(&heights, 0.01, Prescribed::Force(elastic.force()));
    let deeper = solve_on(&response().yielding_under(hardness), &forced, Start::Coarser, &settings).unwrap();
    assert!((deeper.force() / elastic.force() - 1.0).abs() < 1e-9 && deeper.indentation > elastic.indentation);
    let too_much = free(&heights, 0.01, Prescribed::Force(2.0 * hardness * 0.33 * 0.33));
    let refused = solve_on(&response().yielding_under(hardness), &too_much, Start::Coarser, &settings).unwrap_err();
    assert!(refused.to_string().contains("the hardness times the area"), "{refused}");
}
