//! What wear is known to do.

use super::rings::Rings;
use super::{Load, Motion, Ring, Start, Wearing};
use crate::input::quantity::{Length, Positive};
use crate::laws::cases;
use crate::numerics::quadrature;
use crate::shape::{Cone, FlatPunch, Paraboloid, Power, Profile, RoundedPunch, TruncatedCone, height_by_integral};
use proptest::prelude::*;
use std::f64::consts::{FRAC_1_PI, FRAC_1_SQRT_2, FRAC_PI_2, PI};
use std::sync::Arc;

fn length(si: f64) -> Length {
    Length::new(si).unwrap()
}

fn ball() -> Arc<dyn Profile> {
    Arc::new(Paraboloid { radius: length(1.0) })
}

fn punch() -> Arc<dyn Profile> {
    Arc::new(FlatPunch { radius: length(1.0) })
}

fn shapes() -> Vec<Arc<dyn Profile>> {
    let positive = |si: f64| Positive::new(si).unwrap();
    let (slope, coefficient, exponent) = (positive(0.7), positive(0.5), positive(3.5));
    vec![
        ball(),
        punch(),
        Arc::new(Cone { slope }),
        Arc::new(Power { coefficient, exponent }),
        Arc::new(RoundedPunch { flat_radius: length(0.6), edge_radius: length(0.2) }),
        Arc::new(TruncatedCone { flat_radius: length(0.4), slope }),
    ]
}

fn start(cells: usize) -> Start {
    Start { contact_radius: 1.0, stick: None, cells }
}

/// E* = k_w = a = 1.
fn sliding(profile: Arc<dyn Profile>, cells: usize, load: Load, path: f64) -> Wearing {
    let mut wearing = Wearing::new(profile, 1.0, 1.0, start(cells));
    wearing.begin(Motion::Slide, load, path).unwrap();
    wearing.advance(path).unwrap();
    wearing
}

/// A ball that sticks inside a/√2, shaken under a constant depth.
fn fretting(cells: usize, cycles: f64) -> Wearing {
    let mut wearing = Wearing::new(ball(), 1.0, 1.0, Start { stick: Some(FRAC_1_SQRT_2), ..start(cells) });
    let motion = Motion::Shake { amplitude: 0.15, reach: 0.3 };
    wearing.begin(motion, Load::Indentation(1.0), cycles).unwrap();
    wearing.advance(cycles).unwrap();
    wearing
}

/// Complete elliptic integral of the second kind by its definition.
fn elliptic(k: f64) -> f64 {
    quadrature::panel(|t| (1.0 - (k * t.sin()).powi(2)).sqrt(), 0.0, FRAC_PI_2)
}

proptest! {
    #![proptest_config(cases(48))]
    /// V = k_w∫F ds for every shape, load, number of cells and path, wherever on it one looks.
    #[test]
    fn volume_is_that_of_archard(shape in 0usize..6, by_force: bool, size in 1i32..40, cells in 12usize..40, way in -20i32..16) {
        let (profile, path) = (shapes()[shape].clone(), 10f64.powf(0.1 * f64::from(way)));
        let depth = profile.reduced(1.0).max(1e-3) * (1.0 + 0.01 * f64::from(size));
        let force = 0.05 * f64::from(size);
        let load = if by_force { Load::Force(force) } else { Load::Indentation(depth) };
        let mut wearing = Wearing::new(profile, 1.0, 1.0, start(cells));
        wearing.begin(Motion::Slide, load, path).unwrap();
        for part in [0.037, 0.31, 0.83, 1.0] {
            wearing.advance(part * path).unwrap();
            let (volume, rubbed) = (wearing.worn().volume, wearing.rubbed());
            prop_assert!((volume / rubbed - 1.0).abs() < 1e-12, "{volume} {rubbed}");
            prop_assert!(!by_force || (rubbed / (force * part * path) - 1.0).abs() < 1e-12, "{rubbed}");
            prop_assert!((wearing.friction() / rubbed - 1.0).abs() < 1e-12);
        }
    }

    /// The worn volume of a shaken contact is k_w ∫∫ p ds dA to rounding; what friction takes from the springs is the same
    /// to the width of a cell.
    #[test]
    fn volume_of_fretting(cells in 16usize..64, decades in -20i32..20, by_force: bool) {
        let cycles = 10f64.powf(0.1 * f64::from(decades));
        let mut wearing = Wearing::new(ball(), 1.0, 1.0, Start { stick: Some(FRAC_1_SQRT_2), ..start(cells) });
        let load = if by_force { Load::Force(4.0 / 3.0) } else { Load::Indentation(1.0) };
        wearing.begin(Motion::Shake { amplitude: 0.15, reach: 0.3 }, load, cycles).unwrap();
        wearing.advance(cycles).unwrap();
        let (volume, rubbed) = (wearing.worn().volume, wearing.rubbed());
        prop_assert!((volume / rubbed - 1.0).abs() < 1e-12);
        prop_assert!((wearing.friction() / rubbed - 1.0).abs() < 20.0 / (cells as f64).powi(2));
    }
}

/// Rate [k_wE*/b] at which the slowest form that carries no force, of the operator ½k_wE*|∂/∂x| on (−b, b), decays.
const SLOWEST: f64 = 2.060_649_986_92;

/// Solves a full system of linear equations by elimination; the last column of the rows is the right side.
fn solved(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let n = rows.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|&i, &j| rows[i][k].abs().total_cmp(&rows[j][k].abs())).unwrap();
        rows.swap(k, pivot);
        let (head, tail) = rows.split_at_mut(k + 1);
        for row in tail {
            let factor = row[k] / head[k][k];
            row.iter_mut().zip(&head[k]).skip(k).for_each(|(one, other)| *one -= factor * other);
        }
    }
    let mut x = vec![0.0; n];
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|j| rows[k][j] * x[j]).sum();
        x[k] = (rows[k][n] - known) / rows[k][k];
    }
    x
}

/// The slowest rate of the cells and rings of a punch: Kv + μh = λHv with Σ hᵢvᵢ = 0, by inverse iteration.
fn slowest_of_cells(cells: usize) -> f64 {
    let rings = Rings::new(punch().as_ref(), start(cells));
    let n = rings.len();
    let widths: Vec<f64> = (0..n).map(|i| rings.width(i)).collect();
    let worn = |loads: &[f64]| {
        let mut forces = vec![0.0; n];
        rings.forces(loads, &mut forces);
        let pressures: Vec<f64> = forces.iter().zip(rings.areas()).map(|(force, area)| force / area).collect();
        (0..n).map(|i| widths[i] * rings.raised(i, &pressures)).collect::<Vec<f64>>()
    };
    let unit = |k: usize| (0..n).map(|i| if i == k { 1.0 } else { 0.0 }).collect::<Vec<f64>>();
    let columns: Vec<Vec<f64>> = (0..n).map(|k| worn(&unit(k))).collect();
    let mut form: Vec<f64> = rings.cells()[1..].iter().map(|x| 1.0 - 2.0 * x * x).collect();
    for _ in 0..12 {
        let row = |i: usize| (0..n).map(|k| columns[k][i]).chain([widths[i], widths[i] * form[i]]).collect();
        let border = widths.iter().copied().chain([0.0, 0.0]).collect();
        let next = solved((0..n).map(row).chain([border]).collect());
        let square: f64 = next[..n].iter().zip(&widths).map(|(v, h)| h * v * v).sum();
        form = next[..n].iter().map(|v| v / square.sqrt()).collect();
    }
    worn(&form).iter().zip(&form).map(|(rate, v)| rate * v).sum()
}

/// Cells and rings have the slowest rate of the operator they stand for to the second order of their width, so that what the
/// pressures of a punch show of it before is the next form, at 3.67, not yet gone.
#[test]
fn the_slowest_rate_is_that_of_the_operator() {
    let off = [24, 48, 96].map(|cells| slowest_of_cells(cells) / SLOWEST - 1.0);
    assert!(off[2].abs() < 2.5e-4, "{off:?}");
    for pair in off.windows(2) {
        assert!((pair[0] / pair[1] - 4.0).abs() < 0.2, "{off:?}");
    }
}

/// Under a constant force a punch tends to a uniform pressure, by one exponential in the end.
#[test]
fn a_punch_tends_to_its_limiting_shape() {
    let off = |path: f64| {
        let wearing = sliding(punch(), 128, Load::Force(1.0), path);
        let off = |ring: &Ring| (ring.pressure / FRAC_1_PI - 1.0).abs();
        wearing.surface().iter().map(off).fold(0.0, f64::max)
    };
    // The sum over all forms, by their eigenvalues: the next one, at 3.67, makes the middle slower at first. Steps err by a few
    // times the tolerance ½/128², against what is left to go.
    let exact = [(1.5, 1.9670), (2.0, 2.0171), (2.5, 2.0409)];
    for (path, right) in exact {
        let (before, after) = (off(path), off(path + 0.5));
        let rate = (before / after).ln() / 0.5;
        let steps = 4.0 * 0.5 / f64::from(128 * 128) / (0.5 * after);
        assert!((rate - right).abs() < steps, "{path}: {rate} {right} {steps}");
    }
    for (cells, bound) in [(32, 2e-3), (64, 6e-4), (128, 2e-4)] {
        let rings = sliding(punch(), cells, Load::Force(1.0), 30.0).surface();
        // f(r) − f(0) → (4pb/πE*)[π/2 − E(r/b)], p = F/πb².
        let right = |ring: &Ring| 4.0 * FRAC_1_PI * FRAC_1_PI * (FRAC_PI_2 - elliptic(ring.radius));
        let off = |ring: &Ring| (ring.worn - rings[0].worn - right(ring) + right(&rings[0])).abs();
        let worst = rings.iter().map(off).fold(0.0, f64::max);
        assert!(worst < bound, "{cells}: {worst}");
    }
}

/// A ball that has worn far is a rigid one with a flat: V = πa⁴/4R, worn to the depth a²/2R = √(V/πR).
#[test]
fn a_ball_ends_in_a_flat() {
    let off = |path: f64| {
        let wearing = sliding(ball(), 32, Load::Force(4.0 / 3.0), path);
        let (worn, radius) = (wearing.worn(), wearing.normal().contact_radius.unwrap());
        (worn.depth / (worn.volume / PI).sqrt() - 1.0, PI * radius.powi(4) / (4.0 * worn.volume) - 1.0)
    };
    let (early, late) = (off(10.0), off(300.0));
    assert!(late.0.abs() < 0.003 && late.0.abs() < 0.1 * early.0.abs(), "{early:?} {late:?}");
    // The edge is known within its cell, of a thirty-second of the radius.
    assert!(late.1.abs() < 4.0 / 32.0, "{late:?}");
}

/// Fretting's limit: g = x² inside c, untouched to the last bit, and d outside; 0.883883 of the force are left.
#[test]
fn fretting_tends_to_its_limiting_shape() {
    for cells in [32, 64] {
        let wearing = fretting(cells, 1000.0);
        let left = 0.75 * wearing.normal().force;
        assert!((left - 1.25 * FRAC_1_SQRT_2).abs() < 1e-6, "{left}");
        let rings = wearing.surface();
        let inside = |ring: &&Ring| ring.radius < FRAC_1_SQRT_2;
        assert!(rings.iter().filter(inside).all(|ring| ring.worn.to_bits() == 0));
        let c = FRAC_1_SQRT_2;
        let limit = |r: f64| height_by_integral(|x| if x < c { x * x } else { 1.0 }, r, &[c]);
        let worn = |r: f64| (limit(r) - 0.5 * r * r).max(0.0);
        let off = |ring: &Ring| (ring.worn - worn(ring.radius)).abs();
        let beside = 3.0 / cells as f64;
        let far = |ring: &&Ring| ring.radius > c + beside;
        let worst = rings.iter().filter(far).map(off).fold(0.0, f64::max);
        assert!(worst < 0.2 / cells as f64, "{cells}: {worst}");
    }
}

/// What the elastic bodies lose under a constant depth is the work of the pressure on what is worn off.
#[test]
fn the_energy_closes() {
    for profile in shapes() {
        let depth = profile.reduced(1.0).max(0.3);
        let mut wearing = Wearing::new(profile, 1.0, 1.0, start(64));
        wearing.begin(Motion::Slide, Load::Indentation(depth), 3.0).unwrap();
        let before = wearing.normal();
        wearing.advance(3.0).unwrap();
        let after = wearing.normal();
        let off = (after.stored.elastic + after.dissipated) / before.stored.elastic - 1.0;
        assert!(off.abs() < 1e-3, "{off:e}");
    }
}

/// A path cut anywhere ends in the same state, to the error of the steps; looking at it changes nothing.
#[test]
fn cuts_and_looks() {
    let load = Load::Force(4.0 / 3.0);
    let whole = sliding(ball(), 48, load, 2.0);
    let mut seen = Wearing::new(ball(), 1.0, 1.0, start(48));
    seen.begin(Motion::Slide, load, 2.0).unwrap();
    for part in 1..=37 {
        seen.advance(2.0 * f64::from(part) / 37.0).unwrap();
    }
    assert_eq!(seen.surface(), whole.surface());
    let mut cut = Wearing::new(ball(), 1.0, 1.0, start(48));
    for path in [0.3, 1.1, 0.6] {
        cut.begin(Motion::Slide, load, path).unwrap();
        cut.advance(path).unwrap();
    }
    let (one, other) = (cut.worn(), whole.worn());
    assert!((one.volume / other.volume - 1.0).abs() < 1e-12);
    assert!((one.depth / other.depth - 1.0).abs() < 1e-4, "{one:?} {other:?}");
}

/// The plain way, each transform by itself: heights at points joined by straight lines, Euler's steps.
fn by_brute_force(points: usize, path: f64) -> (f64, f64) {
    let (end, depth) = (1.6, 1.0);
    let at: Vec<f64> = (0..=points).map(|k| end * k as f64 / points as f64).collect();
    let mut height: Vec<f64> = at.iter().map(|r| 0.5 * r * r).collect();
    let (steps, mut force) = (20 * points, 0.0);
    for _ in 0..steps {
        let g = |x: f64| {
            let slope = |k: usize| (height[k + 1] - height[k]) / (at[k + 1] - at[k]);
            let angle = |r: f64| (r / x).min(1.0).asin();
            let parts = (0..points).take_while(|&k| at[k] < x);
            height[0] + x * parts.map(|k| slope(k) * (angle(at[k + 1]) - angle(at[k]))).sum::<f64>()
        };
        let q: Vec<f64> = at.iter().map(|&x| (depth - if x > 0.0 { g(x) } else { height[0] }).max(0.0)).collect();
        force = q.windows(2).map(|pair| end / points as f64 * (pair[0] + pair[1])).sum();
        let pressure = |r: f64| {
            let cosine = |x: f64| (x / r.max(1e-3 * end / points as f64)).max(1.0).acosh();
            let part = |k: usize| (q[k] - q[k + 1]) / (at[k + 1] - at[k]) * (cosine(at[k + 1]) - cosine(at[k]));
            FRAC_1_PI * (0..points).filter(|&k| at[k + 1] > r).map(part).sum::<f64>()
        };
        let worn: Vec<f64> = at.iter().map(|&r| pressure(r) * path / steps as f64).collect();
        height.iter_mut().zip(worn).for_each(|(height, worn)| *height += worn);
    }
    (force, height[points / 4] - 0.5 * at[points / 4].powi(2))
}

/// Brute force comes near, the nearer the finer it is.
#[test]
fn brute_force_agrees() {
    let wearing = sliding(ball(), 128, Load::Indentation(1.0), 0.5);
    let force = wearing.normal().force;
    let rings = wearing.surface();
    let next = rings.iter().position(|ring| ring.radius > 0.4).unwrap();
    let (low, high) = (rings[next - 1], rings[next]);
    let worn = low.worn + (0.4 - low.radius) / (high.radius - low.radius) * (high.worn - low.worn);
    let off = |points: usize| {
        let brute = by_brute_force(points, 0.5);
        (brute.0 / force - 1.0).abs().max((brute.1 / worn - 1.0).abs())
    };
    let (coarse, fine) = (off(40), off(80));
    assert!(coarse < 0.02 && fine < 0.6 * coarse, "{coarse} {fine}");
}
