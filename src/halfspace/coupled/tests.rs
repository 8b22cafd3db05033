//! The coupled contact against punches that stick, balls that slip as Spence has it, Cattaneo's ball, and the contact without
//! friction.

use super::*;
use crate::halfspace::{PressedMap, solve};
use std::f64::consts::PI;

/// Of the Poisson ratio against a rigid body.
fn pair(poisson: f64) -> Pair {
    let tangential = 2.0 * (1.0 - poisson) / (2.0 - poisson);
    Pair { normal: 1.0, tangential, coupling: (0.5 - poisson) / (1.0 - poisson) }
}

/// Heights over a square of the side 2·`half`, the tip on a corner of pixels.
fn heights(count: usize, half: f64, of: impl Fn(f64) -> f64) -> (Array2<f64>, [f64; 2]) {
    let side = 2.0 * half / count as f64;
    let place = |index: usize| (index as f64 + 0.5) * side - half;
    (Array2::from_shape_fn((count, count), |(row, column)| of(place(row).hypot(place(column)))), [side; 2])
}

fn rubbing<'h>(heights: &'h Array2<f64>, pixel: [f64; 2], law: (Pair, f64)) -> RubbingMap<'h> {
    RubbingMap::new(heights.view(), (pixel, Boundary::Free), law, Settings::default())
}

fn apart(one: &Array2<f64>, other: &Array2<f64>) -> f64 {
    one.iter().zip(other).fold(0.0, |most: f64, (one, other)| most.max((one - other).abs()))
}

/// A flat punch that sticks is stiffer by ln((1 + β)/(1 − β))/(2β) = (1 − ν) ln(3 − 4ν)/(1 − 2ν) than one without friction
/// (Mossakovskii 1954): 1.0986 for ν = 0. Both on the same pixels; what these leave falls with their side.
#[test]
fn flat_punch_that_sticks() {
    for poisson in [0.0, 0.3] {
        let factor = |count: usize| {
            let (heights, pixel) = heights(count, 1.25, |r| if r < 1.0 { 0.0 } else { f64::INFINITY });
            let of = |coefficient: f64| {
                let mut map = rubbing(&heights, pixel, (pair(poisson), coefficient));
                map.advance(Prescribed::Indentation(1e-3), [0.0; 2]).unwrap().contact.force()
            };
            of(f64::INFINITY) / of(0.0)
        };
        let beta = pair(poisson).coupling;
        let exact = (beta.ln_1p() - (-beta).ln_1p()) / (2.0 * beta);
        let (coarse, fine) = (factor(20) / exact - 1.0, factor(40) / exact - 1.0);
        assert!(fine.abs() < 2e-3 && fine.abs() < 0.6 * coarse.abs(), "ν = {poisson}: {coarse:e} {fine:e}");
    }
}

/// K(√(1 − k²)) by the arithmetic-geometric mean of 1 and k.
fn complementary(k: f64) -> f64 {
    let (mut a, mut b) = (1.0, k);
    for _ in 0..40 {
        (a, b) = (0.5 * (a + b), f64::sqrt(a * b));
    }
    0.5 * PI / a
}

/// c/a of (a/2c) ln((a + c)/(a − c)) = (μ/β) K′(c/a), by halving.
fn spence(ratio: f64) -> f64 {
    let miss = |c: f64| (c.ln_1p() - (-c).ln_1p()) / (2.0 * c) - ratio * complementary(c);
    let (mut low, mut high) = (1e-3, 1.0 - 1e-12);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        (low, high) = if miss(middle) > 0.0 { (low, middle) } else { (middle, high) };
    }
    low
}

/// Pressed without a slide, a ball slips outside c with (a/2c) ln((a + c)/(a − c)) = (μ/β) K′(c/a), whatever its load
/// (Spence 1975, who leaves out what shear does to pressures: here β → 0 under a ratio μ/β that stays). What pixels have gone
/// before they touched counts as slip of the step in which they do: of the first order in the steps.
#[test]
fn a_ball_sticks_where_spence_has_it() {
    let (heights, pixel) = heights(48, 1.2, |r| 0.5 * r * r);
    let pair = Pair { normal: 1.0, tangential: 0.8, coupling: 0.01 };
    for ratio in [0.8, 1.5] {
        let stuck = |steps: u32| {
            let mut map = rubbing(&heights, pixel, (pair, 0.01 * ratio));
            let radii = (1..=steps).map(|step| f64::from(step) / f64::from(steps));
            let states = radii.map(|radius| map.advance(Prescribed::Indentation(radius * radius), [0.0; 2]).unwrap());
            let last = states.last().unwrap();
            assert!(last.dissipated > 0.0 && last.force()[0].abs() < 1e-9);
            (last.stuck.iter().filter(|stuck| **stuck).count() as f64 * pixel[0] * pixel[1] / PI).sqrt()
        };
        let exact = spence(ratio);
        let (coarse, fine) = (stuck(8) - exact, stuck(32) - exact);
        assert!(fine.abs() < 0.015 && fine.abs() < 0.4 * coarse.abs(), "μ/β = {ratio}: {exact} {coarse} {fine}");
    }
}

/// Without β pressures are those without friction, to what both miss of them, and nothing is sheared that is not slid.
#[test]
fn without_coupling_friction_does_not_press() {
    let (heights, pixel) = heights(24, 1.2, |r| 0.5 * r * r);
    let mut map = rubbing(&heights, pixel, (pair(0.5), 0.7));
    let pressed = map.advance(Prescribed::Force(0.5), [0.0; 2]).unwrap();
    assert!(pressed.shear.iter().flatten().all(|shear| shear.abs() <= 0.0));
    let slid = map.advance(Prescribed::Force(0.5), [0.05, 0.02]).unwrap();
    let alone = PressedMap {
        heights: heights.view(),
        pixel,
        modulus: 1.0,
        boundary: Boundary::Free,
        control: Prescribed::Force(0.5),
    };
    let alone = solve(&alone, Start::Coarser, &Settings::default()).unwrap();
    for state in [&pressed, &slid] {
        assert!(apart(&state.contact.pressure, &alone.pressure) < 1e-6 * alone.peak_pressure());
    }
}

/// Where tractions do across the surface what they do along it, G* = E*, a ball slips as Cattaneo (1938) and Mindlin (1949) have
/// it: Fₓ = μF [1 − (1 − s/(μd))^{3/2}], and what it has lost is their loss. Pixels miss (Δ/a)²/8 of the forces and, in the ring
/// that slips, Δ/a.
#[test]
fn a_ball_slips_as_cattaneo_has_it() {
    let (heights, pixel) = heights(64, 1.2, |r| 0.5 * r * r);
    let (mu, depth) = (0.3, 1.0);
    let mut map = rubbing(&heights, pixel, (Pair { normal: 1.0, tangential: 1.0, coupling: 0.0 }, mu));
    map.advance(Prescribed::Indentation(depth), [0.0; 2]).unwrap();
    for part in [0.3_f64, 0.7, 1.2] {
        let state = map.advance(Prescribed::Indentation(depth), [part * mu * depth, 0.0]).unwrap();
        let exact = mu * 4.0 / 3.0 * (1.0 - (1.0 - part).max(0.0).powf(1.5));
        let [force, beside] = state.force();
        assert!((force / exact - 1.0).abs() < 2e-3, "{part}: {force} {exact}");
        assert!(beside.abs() < 1e-9, "{beside}");
        let c = (state.stuck.iter().filter(|stuck| **stuck).count() as f64 * pixel[0] * pixel[1] / PI).sqrt();
        assert!((c - (1.0 - part).max(0.0).sqrt()).abs() < pixel[0], "{part}: {c}");
        // All that is stuck is as stiff as a punch of its radius.
        assert!((state.stiffness - 2.0 * c).abs() <= 0.03 * 2.0 * c, "{} {c}", state.stiffness);
    }
}

/// A ball that is slid the other way is sheared the other way round, whatever the coupling; what has been slipped is lost for good.
#[test]
fn a_slide_back_mirrors_a_slide() {
    let (heights, pixel) = heights(24, 1.2, |r| 0.5 * r * r);
    let led = |sign: f64| {
        let mut map = rubbing(&heights, pixel, (pair(0.2), 0.3));
        let mut lost = 0.0;
        let mut states = Vec::new();
        for (depth, slide) in [(0.5, 0.0), (1.0, 0.0), (1.0, 0.2), (0.8, 0.1), (0.8, -0.3), (0.2, -0.3), (-0.1, -0.3)] {
            let state = map.advance(Prescribed::Indentation(depth), [sign * slide, 0.0]).unwrap();
            assert!(state.dissipated >= lost, "{} {lost}", state.dissipated);
            lost = state.dissipated;
            states.push(state);
        }
        states
    };
    for (one, other) in led(1.0).iter().zip(led(-1.0)) {
        let mut mirrored = other.shear[0].mapv(|shear| -shear);
        mirrored.invert_axis(ndarray::Axis(1));
        assert!(apart(&one.shear[0], &mirrored) < 1e-5);
        assert!((one.dissipated - other.dissipated).abs() < 1e-6 && (one.force()[0] + other.force()[0]).abs() < 1e-6);
    }
    let last = led(1.0).pop().unwrap();
    assert!(last.contact.force() <= 0.0 && last.force()[0].abs() <= 0.0 && last.stored.abs() <= 1e-15);
}

/// Pressures and shear wide enough that a pixel's own shape does not count do the same pixel by pixel as wave by wave, but for the
/// copies at the distance L and the mean they leave out: of x/r² that takes off π(r/L)², of what falls as 1/r it is of
/// the order of (r/L)².
#[test]
fn what_repeats_is_moved_like_what_stands_alone() {
    let (count, middle) = (96, 48.0_f64);
    let patch = Array2::from_shape_fn((count, count), |(row, column)| {
        let [x, y] = [column, row].map(|index| (index as f64 - middle) / 4.0);
        (-0.5 * (x * x + y * y)).exp()
    });
    let nothing = Array2::zeros((count, count));
    let of = |boundary: Boundary| CoupledResponse::new([count; 2], [1.0; 2], boundary, pair(0.2));
    let (free, repeats) = (of(Boundary::Free), of(Boundary::Periodic));
    let shear = [patch.view(), nothing.view()];
    let alike = |one: f64, other: f64| assert!((one / other - 1.0).abs() < 0.01, "{one} {other}");
    let place = [44, 57];
    let beside = 1.0 - PI * (4.0 * 4.0 + 9.0 * 9.0) / (96.0 * 96.0);
    for axis in 0..2 {
        alike(beside * free.drawn(patch.view())[axis][place], repeats.drawn(patch.view())[axis][place]);
    }
    alike(beside * free.lifted(shear)[place], repeats.lifted(shear)[place]);
    // The mean displacement of what repeats is zero: only differences are alike.
    let fall = |response: &CoupledResponse| {
        let along = &response.sheared(shear)[0];
        along[[48, 48]] - along[[48, 58]]
    };
    let (one, other) = (fall(&free), fall(&repeats));
    assert!((one / other - 1.0).abs() < 0.03, "{one} {other}");
    let (one, other) = (free.sheared(shear)[1][[57, 57]], repeats.sheared(shear)[1][[57, 57]]);
    assert!((one / other - 1.0).abs() < 0.03, "{one} {other}");
    // Betti: pressures draw as shear lifts, of opposite sign, for the way from one to the other is.
    let lifted = free.lifted(shear);
    assert!((free.drawn(patch.view())[0][place] + lifted[place]).abs() < 1e-14 && lifted[place] > 0.0);
}

/// What the forces do is stored or lost, but for what steps of trapezia leave: of the first order where pixels touch and slip.
#[test]
fn work_is_stored_or_lost() {
    let (heights, pixel) = heights(24, 1.2, |r| 0.5 * r * r);
    let missed = |steps: u32| {
        let mut map = rubbing(&heights, pixel, (pair(0.1), 0.3));
        let (mut work, mut before) = (0.0, [0.0; 4]);
        let mut accounted = 0.0;
        for step in 1..=2 * steps {
            let part = f64::from(step) / f64::from(steps);
            let (depth, slide) = (part.min(1.0), 0.25 * (part - 1.0).max(0.0));
            let state = map.advance(Prescribed::Indentation(depth), [slide, 0.0]).unwrap();
            let (contact, [force, _]) = (&state.contact, state.force());
            let elastic = 0.5 * pixel[0] * pixel[1] * (&contact.pressure * &contact.displacement).sum();
            let now = [depth, contact.force(), slide, force];
            work +=
                0.5 * (now[1] + before[1]) * (now[0] - before[0]) + 0.5 * (now[3] + before[3]) * (now[2] - before[2]);
            accounted = elastic + state.stored + state.dissipated;
            before = now;
        }
        accounted / work - 1.0
    };
    let (coarse, fine) = (missed(8), missed(32));
    assert!(fine.abs() < 0.01 && fine.abs() < 0.5 * coarse.abs(), "{coarse} {fine}");
}
