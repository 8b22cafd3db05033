//! Layers against numbers from another solution, limits, and laws.

use super::kernel::Kernel;
use super::punch::{self, Punch};
use super::*;
use crate::input::quantity::{GradingExponent, Length, Modulus, Poisson, Positive};
use crate::material::{Graded, Joint, Sheet, Stack};
use crate::numerics::panelled::PanelledCurve;
use crate::numerics::quadrature;
use crate::shape::{Cone, Paraboloid, Sphere, TruncatedCone, edge_by_search};
use proptest::prelude::*;
use std::sync::Arc;

fn sheet(shear: f64, poisson: f64, joint: Joint) -> Sheet {
    Sheet { shear, poisson, thickness: 1.0, joint }
}

fn on_rigid(poisson: f64, joint: Joint) -> Stack {
    Stack { sheets: vec![sheet(1.0, poisson, joint)], base: None }
}

fn on_base(contrast: f64, top: f64, below: f64) -> Stack {
    let base = sheet(1.0 / contrast, below, Joint::Bonded);
    Stack { sheets: vec![sheet(1.0, top, Joint::Bonded)], base: Some(base) }
}

/// M(t) of one layer in closed form, bonded to a base: α = G₁/G₀.
fn closed(contrast: f64, top: f64, below: f64, t: f64) -> f64 {
    let (kappa, kappa_below) = (3.0 - 4.0 * top, 3.0 - 4.0 * below);
    let a = (contrast * kappa_below - kappa) / (1.0 + contrast * kappa_below);
    let b = (contrast - 1.0) / (contrast + kappa);
    let e = (-2.0 * t).exp();
    (1.0 + 4.0 * b * t * e - a * b * e * e) / (1.0 - (a + b + 4.0 * b * t * t) * e + a * b * e * e)
}

#[test]
fn one_layer_is_the_closed_form() {
    for t in [1e-6, 1e-3, 0.1, 1.0, 3.0, 10.0, 100.0, 1e5] {
        for (contrast, top, below) in
            [(0.1, 0.5, 0.3), (10.0, 0.3, 0.3), (1.0, 0.2, 0.2), (1e6, 0.0, 0.5), (1e-6, 0.4, 0.1)]
        {
            let (found, right) = (1.0 - on_base(contrast, top, below).lacking(t), closed(contrast, top, below, t));
            // The closed form loses what its numerator or its denominator is less than one.
            let lost = 4.0 * f64::EPSILON * right.max(right.recip()) * contrast.max(1.0);
            assert!((found / right - 1.0).abs() < 1e-14 + 8.0 * lost, "{t} {contrast}: {found} {right}");
        }
        for poisson in [0.0, 0.3, 0.5] {
            let kappa: f64 = 3.0 - 4.0 * poisson;
            let e = (-2.0 * t).exp();
            let bonded = (kappa * (1.0 - e * e) - 4.0 * t * e)
                / (kappa * (1.0 + e * e) + (4.0 * t * t + 1.0 + kappa * kappa) * e);
            let found = 1.0 - on_rigid(poisson, Joint::Bonded).lacking(t);
            assert!((found - bonded).abs() < 1e-14, "{t} {poisson}: {found} {bonded}");
            let sliding = (1.0 - e).powi(2) / (1.0 - e * e + 4.0 * t * e);
            assert!((1.0 - on_rigid(poisson, Joint::Sliding).lacking(t) - sliding).abs() < 1e-14, "{t}");
        }
    }
}

#[test]
fn a_paraboloid_on_a_layer() {
    let shape = paraboloid();
    let cases = [
        (
            on_rigid(0.5, Joint::Bonded),
            [0.87973315759, 7.2374716979, 108.94439628],
            [0.0071502006930, 0.055941548556, 0.36673061439],
            [0.0036710110238, 0.18806668992, 15.695633214],
        ),
        (
            on_rigid(0.3, Joint::Bonded),
            [0.79966254282, 4.9670492583, 37.567754032],
            [0.0075452333484, 0.064762231993, 0.49245203236],
            [0.0036466635918, 0.16786246035, 9.2386522433],
        ),
        (
            on_rigid(0.3, Joint::Sliding),
            [0.76381797408, 4.3972427313, 31.724584629],
            [0.0077427372908, 0.067398064499, 0.50410444640],
            [0.0036300451024, 0.15781227473, 8.0325780231],
        ),
        (
            on_base(10.0, 0.3, 0.3),
            [0.25236991473, 0.41759734796, 0.84126330883],
            [0.016854985122, 0.23028302178, 1.4136473981],
            [0.0034869154256, 0.079231674852, 0.84935080951],
        ),
    ];
    for (stack, stiffness, depth, force) in cases {
        let layers: Arc<dyn Ground> = Arc::new(Layers::new(vec![(1.0, stack)]));
        let bed = Grounded::new(shape.clone(), layers.clone());
        for (k, a) in [0.3, 1.0, 3.0].into_iter().enumerate() {
            let s = layers.measure(a);
            assert!((layers.radius(s) / a - 1.0).abs() < 1e-13);
            // Bound: the digits of the numbers.
            for (found, right) in
                [(2.0 * s, stiffness[k]), (bed.reduced(s), depth[k]), (2.0 * bed.load_integral(s), force[k])]
            {
                assert!((found / right - 1.0).abs() < 5e-11, "{a}: {found} {right}");
            }
        }
    }
}

/// k′ = 2E*q₁² is s′ = q₁²: two results of one equation. And what the springs carry is what the line load is.
#[test]
fn the_springs_are_those_of_the_punches() {
    let layers = Layers::new(vec![(1.0, on_base(0.1, 0.5, 0.3))]);
    for a in [0.01, 0.2, 0.7, 1.9, 5.0, 12.0] {
        let h = 1e-5;
        let slope = (layers.measure(a * (1.0 + h)) - layers.measure(a * (1.0 - h))) / (2.0 * h * a);
        assert!((slope / layers.density(a) - 1.0).abs() < 1e-9, "{a}");
        let growth = (layers.density(a * (1.0 + h)) / layers.density(a * (1.0 - h))).ln() / (2.0 * h);
        assert!((growth - layers.density_growth(a)).abs() < 1e-9, "{a}");
        assert!((a * layers.density(a) / layers.measure(a) / layers.growth(a) - 1.0).abs() < 1e-13);
    }
}

fn paraboloid() -> Arc<Paraboloid> {
    Arc::new(Paraboloid { radius: Length::new(10.0).unwrap() })
}

/// Layers of twice the thickness have everything at twice the radius, to the bit, and what one is asked for is no matter of
/// the other's: the error it states neither.
#[test]
fn what_is_known_of_layers_serves_all_that_are_alike() {
    let thick = |thickness: f64| {
        let layer = Sheet { thickness, ..sheet(1.0, 0.5, Joint::Bonded) };
        Layers::new(vec![(1.0, Stack { sheets: vec![layer], base: None })])
    };
    let (one, two) = (thick(1.0), thick(2.0));
    for a in [1e-3, 0.2, 0.25, 0.3, 1.0, 7.0, 300.0] {
        let doubled = [two.measure(2.0 * a), two.radius(2.0 * one.measure(a)), two.per_density(2.0 * a)];
        let single = [one.measure(a), one.radius(one.measure(a)), one.per_density(a)];
        let bits = |lengths: [f64; 3]| lengths.map(f64::to_bits);
        assert_eq!(bits(doubled), bits(single.map(|length| 2.0 * length)), "{a}");
        assert_eq!(two.density(2.0 * a).to_bits(), one.density(a).to_bits(), "{a}");
    }
    assert!(one.table_error() > thick(4.0).table_error());
}

/// Equal layers are one body, far below a thick layer nothing is, and nothing depends on where a layer is cut.
#[test]
fn limits_of_layers() {
    let same = Layers::new(vec![(1.0, on_base(1.0, 0.3, 0.3))]);
    let thick = Layers::new(vec![(
        1.0,
        Stack { sheets: vec![Sheet { thickness: 1e9, ..sheet(1.0, 0.4, Joint::Bonded) }], base: None },
    )]);
    for a in [1e-6, 0.1, 1.0, 7.0] {
        assert!((same.measure(a) / a - 1.0).abs() < 1e-14 && (thick.measure(a) / a - 1.0).abs() < 2e-8);
    }
    let whole = Layers::new(vec![(1.0, on_base(5.0, 0.2, 0.4))]);
    let part = |thickness: f64| Sheet { thickness, ..sheet(1.0, 0.2, Joint::Bonded) };
    let base = Some(sheet(0.2, 0.4, Joint::Bonded));
    let cut = Layers::new(vec![(1.0, Stack { sheets: vec![part(0.5), part(0.2), part(0.3)], base })]);
    let (shape, half) = (paraboloid(), 0.5);
    let beds = [Grounded::new(shape.clone(), Arc::new(whole)), Grounded::new(shape, Arc::new(cut))];
    for a in [0.01, 0.4, 2.0, 9.0, 20.0] {
        let [one, other] = [&beds[0], &beds[1]].map(|bed| {
            let s = bed.place(a);
            [
                s,
                bed.reduced(s),
                bed.load_integral(s),
                bed.energy_integral(s),
                bed.pressure_integral(bed.place(half * a), s),
            ]
        });
        for (one, other) in one.into_iter().zip(other) {
            assert!((one / other - 1.0).abs() < 1e-11, "{a}: {one} {other}");
        }
    }
}

/// Two bodies of one material, one of them in layers, are that material twice: shares add.
#[test]
fn compliances_of_two_bodies_add() {
    let alone = Layers::new(vec![(1.0, on_rigid(0.3, Joint::Bonded))]);
    let both = Layers::new(vec![(0.5, on_rigid(0.3, Joint::Bonded)), (0.5, on_rigid(0.3, Joint::Bonded))]);
    let one = Layers::new(vec![(0.5, on_rigid(0.3, Joint::Bonded))]);
    for a in [0.1, 1.0, 4.0] {
        assert!((alone.measure(a) / both.measure(a) - 1.0).abs() < 1e-13);
        let between = one.measure(a);
        assert!(between > a && between < alone.measure(a));
    }
}

/// Thin layers: Winkler's springs where they can be squeezed out of the way, F = (2π/3)ER²d³/h³ where they cannot.
#[test]
fn thin_layers() {
    let far = 2e4;
    let shape = Arc::new(Paraboloid { radius: Length::new(far).unwrap() });
    let ratios = [(0.5, 20.0, 1.0432356), (0.3, 20.0, 0.99937261), (0.5, 80.0, 1.003_171_733), (0.3, 80.0, 0.99995675)];
    for (poisson, a, ratio) in ratios {
        let radius = 1000.0;
        let shape = Arc::new(Paraboloid { radius: Length::new(radius).unwrap() });
        let bed = Grounded::new(shape, Arc::new(Layers::new(vec![(1.0, on_rigid(poisson, Joint::Bonded))])));
        let s = bed.place(a);
        let (depth, force) = (bed.reduced(s), 2.0 * bed.load_integral(s));
        // E* = 1: E = 1 − ν².
        let young = 1.0 - poisson * poisson;
        let thin = if poisson < 0.5 {
            let modulus = (1.0 - poisson) * young / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
            std::f64::consts::PI * modulus * radius * depth * depth
        } else {
            2.0 / 3.0 * std::f64::consts::PI * young * radius * radius * depth.powi(3)
        };
        // Bound: the digits of the ratio.
        assert!((force / thin / ratio - 1.0).abs() < 5e-8, "{poisson}: {}", force / thin);
    }
    let springs = Grounded::new(shape, Arc::new(Springs { thickness: 0.5 }));
    for a in [1e-6, 1.0, 1e3] {
        let s = springs.place(a);
        let (depth, force) = (springs.reduced(s), 2.0 * springs.load_integral(s));
        assert!((depth / (0.5 * a * a / far) - 1.0).abs() < 1e-13);
        assert!((force / (std::f64::consts::PI * far * depth * depth / 0.5) - 1.0).abs() < 1e-12, "{a}");
        let r = springs.place(0.6 * a);
        let pressure = (depth - 0.5 * (0.6 * a).powi(2) / far) / 0.5;
        assert!((springs.pressure_integral(r, s) / pressure - 1.0).abs() < 1e-12);
        assert!((springs.energy_integral(s) / (force * depth / 3.0) - 1.0).abs() < 1e-11);
    }
}

/// The surface is that of the indenter inside the contact, and goes on from there; pressures sum to the force.
#[test]
fn pressure_and_surface_fit_together() {
    let graded = Graded {
        young: Modulus::new(1.0).unwrap(),
        depth: Length::new(0.7).unwrap(),
        exponent: GradingExponent::new(0.35).unwrap(),
        poisson: Poisson::new(0.3).unwrap(),
    };
    let grounds: [(Arc<dyn Ground>, f64); 3] = [
        (Arc::new(Layers::new(vec![(1.0, on_rigid(0.45, Joint::Bonded))])), 1e-8),
        (Arc::new(Layers::new(vec![(1.0, on_base(20.0, 0.3, 0.2))])), 1e-8),
        (Arc::new(PowerLaw::from(&graded)), 1e-6),
    ];
    for (ground, bound) in grounds {
        let bed = Grounded::new(paraboloid(), ground.clone());
        for a in [0.3, 2.5] {
            let s = bed.place(a);
            let depth = bed.reduced(s);
            // Inside: by the transforms of any springs.
            let springs = PanelledCurve::new(|x: f64| depth - bed.reduced(x), vec![s]);
            for part in [0.1, 0.5, 0.9] {
                let r = bed.place(part * a);
                let inside = bed.surface_of(&springs, r);
                if bound < 1e-7 {
                    assert!((inside / (depth - bed.height(r)) - 1.0).abs() < bound, "{a} {part}: {inside}");
                }
                let pressure = bed.pressure_integral(r, s);
                assert!((bed.pressure_of(&springs, r) / pressure - 1.0).abs() < 1e-6, "{a} {part}");
            }
            let beyond = bed.displacement_integral(bed.place(a * (1.0 + 1e-9)), s);
            assert!((beyond / (depth - bed.height(s)) - 1.0).abs() < 1e-4, "{a}: {beyond}");
            // F = 2π ∫ p r dr, r = a sin θ.
            let ring = |theta: f64| {
                let r = a * theta.sin();
                bed.pressure_integral(bed.place(r), s) * r * a * theta.cos()
            };
            let sum = std::f64::consts::TAU * quadrature::panel(ring, 0.0, std::f64::consts::FRAC_PI_2);
            assert!((sum / (2.0 * bed.load_integral(s)) - 1.0).abs() < 1e-7, "{a}: {sum}");
        }
    }
}

/// E*u/p of a loaded rectangle on a half-space by its corners, (1/π)Σ±[x ln(y + r) + y ln(x + r)] (Johnson 1985,
/// eq. 3.25).
fn endless([x, y]: [f64; 2], [width, height]: [f64; 2]) -> f64 {
    let corner = |x: f64, y: f64| x * (y / x.abs()).asinh() + y * (x / y.abs()).asinh();
    let (left, right) = (x - 0.5 * width, x + 0.5 * width);
    let (lower, upper) = (y - 0.5 * height, y + 0.5 * height);
    (corner(right, upper) - corner(left, upper) - corner(right, lower) + corner(left, lower)) / std::f64::consts::PI
}

/// Nine rectangles are one of three times their sides, near and far, wide and narrow; on a body without a grading, or
/// under layers that are all one, they are those of a half-space.
#[test]
fn rectangles_add_up_to_a_larger_one() {
    let graded = |exponent: f64| {
        PowerLaw::from(&Graded {
            young: Modulus::new(1.0).unwrap(),
            depth: Length::new(0.7).unwrap(),
            exponent: GradingExponent::new(exponent).unwrap(),
            poisson: Poisson::new(0.3).unwrap(),
        })
    };
    let layers = |stack: Stack| Layers::new(vec![(1.0, stack)]);
    let grounds: [Box<dyn Ground>; 6] = [
        Box::new(layers(on_rigid(0.5, Joint::Bonded))),
        Box::new(layers(on_rigid(0.3, Joint::Sliding))),
        Box::new(layers(on_base(1e4, 0.3, 0.2))),
        Box::new(layers(on_base(1e-4, 0.3, 0.5))),
        Box::new(graded(0.4)),
        Box::new(graded(0.9)),
    ];
    for (number, ground) in grounds.iter().enumerate() {
        for side in [0.01, 0.2, 0.9] {
            let sides = [side, 0.7 * side];
            let at = |[x, y]: [f64; 2], sides: [f64; 2]| ground.under_rectangle([x, y], sides, endless([x, y], sides));
            for away in [[0.0, 0.0], [2.0, 0.0], [1.0, 3.0], [40.0, 7.0]] {
                let place = [away[0] * sides[0], away[1] * sides[1]];
                let part = |k: i32| {
                    let shift = [f64::from(k / 3 - 1) * sides[0], f64::from(k % 3 - 1) * sides[1]];
                    at([place[0] + shift[0], place[1] + shift[1]], sides)
                };
                let (small, large) = ((0..9).map(part).sum::<f64>(), at(place, sides.map(|side| 3.0 * side)));
                // Of what a half-space gives at its middle, rounding and the four nodes across a layer: 1e-7 of it.
                let scale = endless([0.0; 2], sides.map(|side| 3.0 * side)).max(at([0.0; 2], sides));
                assert!((small - large).abs() < 1e-7 * scale, "{number} {side} {away:?}: {small:e} {large:e}");
            }
        }
    }
    let plain = endless([0.3, 0.1], [0.2, 0.1]);
    let same = layers(on_base(1.0, 0.3, 0.3)).under_rectangle([0.3, 0.1], [0.2, 0.1], plain);
    let barely = graded(1e-12).under_rectangle([0.3, 0.1], [0.2, 0.1], plain);
    assert!((same / plain - 1.0).abs() < 1e-13 && (barely / plain - 1.0).abs() < 1e-10, "{plain} {same} {barely}");
}

/// What rectangles that cover the plane give together is what a uniform pressure does: h(1−2ν)/(2G(1−ν)) (oedometer).
#[test]
fn a_covered_plane_is_compressed() {
    for (poisson, joint) in [(0.0, Joint::Bonded), (0.3, Joint::Bonded), (0.45, Joint::Bonded)] {
        let ground = Layers::new(vec![(1.0, on_rigid(poisson, joint))]);
        let side = 0.25;
        let along = || (-80..=80).map(|k| f64::from(k) * side);
        let given = |x: f64, y: f64| ground.under_rectangle([x, y], [side; 2], endless([x, y], [side; 2]));
        let all: f64 = along().map(|x| along().map(|y| given(x, y)).sum::<f64>()).sum();
        // With G of one: E* = 2/(1−ν).
        let right = (1.0 - 2.0 * poisson) / (1.0 - poisson).powi(2);
        assert!((ground.wave(0.0) / right - 1.0).abs() < 1e-14);
        // Beyond twenty thicknesses hardly anything is left; ν near one half it falls off most slowly.
        assert!((all / right - 1.0).abs() < 1e-6, "{poisson}: {all} {right}");
    }
}

/// A graded half-space as thousands of layers, each a little thicker than the one above: k = 2E*Ca^(1+n)/(1+n)z₀ⁿ
/// comes from u = (2T/E*)z₀ⁿk^(n−1)p by C = π/(2ⁿ T Γ((1+n)/2)²), and T from the layers alone.
#[test]
fn a_graded_body_is_the_limit_of_layers() {
    for (exponent, poisson) in [(0.2, 0.3), (0.5, 0.0), (0.5, 0.5), (0.6, 0.25)] {
        let compliance = |count: i32| {
            // Above the first border the modulus is constant: it gives by a share of its depth to the power of 1 − n.
            let (first, last) = (10f64.powf(-7.0 / (1.0 - exponent)), 30.0f64);
            let growth = (last / first).powf(f64::from(count).recip());
            let border = |k: i32| if k == 0 { 0.0 } else { first * growth.powi(k) };
            let modulus = |k: i32| (0.5 * (border(k) + border(k + 1))).powf(exponent);
            let sheets = (0..count).map(|k| Sheet {
                shear: modulus(k) / modulus(0),
                poisson,
                thickness: border(k + 1) - border(k),
                joint: Joint::Bonded,
            });
            let stack = Stack { sheets: sheets.collect(), base: None };
            // u = 2M/(E*₀ of the top) at k = 1; E* of the top is its modulus where E* = zⁿ.
            (1.0 - stack.lacking(1.0)) / modulus(0)
        };
        // The error of steps goes with their square.
        let (coarse, fine) = (compliance(2000), compliance(4000));
        let limit = fine + (fine - coarse) / 3.0;
        let right = std::f64::consts::PI / (exponent.exp2() * limit * libm::tgamma(0.5 * (1.0 + exponent)).powi(2));
        let graded = Graded {
            young: Modulus::new(1.0 - poisson * poisson).unwrap(),
            depth: Length::new(1.0).unwrap(),
            exponent: GradingExponent::new(exponent).unwrap(),
            poisson: Poisson::new(poisson).unwrap(),
        };
        let found = PowerLaw::from(&graded).density(1.0);
        assert!((found / right - 1.0).abs() < 1e-5, "{exponent} {poisson}: {found} {right}");
    }
}

/// d_e by quadrature against powers: a paraboloid has g/(1+n), a cone the ratio of two Γ.
#[test]
fn profiles_on_a_graded_body() {
    for tenth in 0..10 {
        let n = 0.1 * f64::from(tenth);
        let graded = Graded {
            young: Modulus::new(1.0).unwrap(),
            depth: Length::new(1.0).unwrap(),
            exponent: GradingExponent::new(n).unwrap(),
            poisson: Poisson::new(0.3).unwrap(),
        };
        let ground = PowerLaw::from(&graded);
        let cone = Cone { slope: Positive::new(0.1).unwrap() };
        for a in [1e-6, 1.0, 1e6] {
            let share = ground.depth_share(paraboloid().as_ref(), a);
            assert!((share * (1.0 + n) - 1.0).abs() < 1e-12, "{n}: {share}");
            // B((n+1)/2 … ) of the mean of t: Γ(½(n+1))/(√π Γ(½n+1)).
            let mean = libm::tgamma(0.5 * (n + 1.0)) / (std::f64::consts::PI.sqrt() * libm::tgamma(0.5 * n + 1.0));
            assert!((ground.depth_share(&cone, a) / mean - 1.0).abs() < 1e-10, "{n}");
            assert!((ground.radius(ground.measure(a)) / a - 1.0).abs() < 1e-12);
        }
    }
}

/// Stiffness and depth of the tables against the integral equation with twice the nodes, from a millionth of a thickness
/// to 23, on bases over twelve decades of the modulus. Bound: roundings, a contrast of 1e6 times as large, and less for
/// the polynomials over an octave.
#[test]
fn tables_are_the_integral_equation() {
    let mut worst = [0.0f64; 2];
    for poisson in [0.0, 0.3, 0.49, 0.5] {
        let bases = [1e-6, 1e-3, 1.0, 1e3, 1e6].map(|contrast| on_base(contrast, poisson, 0.3));
        for stack in bases.into_iter().chain([on_rigid(poisson, Joint::Bonded)]) {
            let (below, least) = (stack.clone(), stack.least_wave_number());
            let kernel = Kernel::new(move |t| below.lacking(t), least);
            let layers = Layers::new(vec![(1.0, stack)]);
            for a in [1e-6, 1e-3, 0.07, 0.31, 0.93, 2.7, 9.9, 23.0] {
                let rule = punch::rule(2 * punch::count(a));
                let punch = Punch::new(&kernel, a, &rule);
                let higher = |(&(y, w), taken): (&(f64, f64), &f64)| a * w * (1.0 - y * y) * taken;
                let share = 1.0 - rule.iter().zip(&punch.resolvent).map(higher).sum::<f64>() / punch.edge;
                let off = |found: f64, right: f64| (found / right - 1.0).abs();
                worst[0] = worst[0].max(off(layers.measure(a), punch.measure));
                worst[1] = worst[1].max(off(layers.depth_share(paraboloid().as_ref(), a), share));
            }
        }
    }
    assert!(worst[0] < 1e-11 && worst[1] < layers::TABLES, "{worst:?}");
}

proptest! {
    #![proptest_config(crate::laws::cases(24))]

    /// Random layers: k′ = 2E*q₁² by differences, and the depth of a paraboloid from the stiffness alone is that from the
    /// resolvent, which a power of the exponent two asks for.
    #[test]
    fn random_layers_are_springs(
        parts in prop::collection::vec((-30i32..=30, 0i32..=50, 2i32..=30, any::<bool>()), 1..4),
        base in prop::option::of((-30i32..=30, 0i32..=50)),
        radius in -20i32..=9,
    ) {
        let sheet = |(shear, poisson, thickness, slides): (i32, i32, i32, bool)| Sheet {
            shear: 10f64.powf(0.1 * f64::from(shear)),
            poisson: 0.01 * f64::from(poisson),
            thickness: 0.1 * f64::from(thickness),
            joint: if slides { Joint::Sliding } else { Joint::Bonded },
        };
        let base = base.map(|(shear, poisson)| sheet((shear, poisson, 1, false)));
        let layers = Layers::new(vec![(1.0, Stack { sheets: parts.into_iter().map(sheet).collect(), base })]);
        let a = 10f64.powf(0.1 * f64::from(radius)) * layers.scale().unwrap();
        let h = 1e-4;
        let slope = (layers.measure(a * (1.0 + h)) - layers.measure(a * (1.0 - h))) / (2.0 * h * a);
        // Bound: h² and the rounding of a difference over it.
        prop_assert!((slope / layers.density(a) - 1.0).abs() < 1e-6, "{a}: {slope} {}", layers.density(a));
        let power = crate::shape::Power {
            exponent: Positive::new(2.0).unwrap(),
            coefficient: Positive::new(0.05).unwrap(),
        };
        let (square, resolvent) = (layers.depth_share(paraboloid().as_ref(), a), layers.depth_share(&power, a));
        prop_assert!((square / resolvent - 1.0).abs() < layers::TABLES, "{a}: {square} {resolvent}");
    }
}

/// A paraboloid of R = 10 on a layer of the thickness 1 bonded to a rigid base, or sliding on it, E* = 1.
fn on_a_rigid_base(poisson: f64, joint: Joint) -> (Grounded, Arc<Layers>) {
    let layers = Arc::new(Layers::new(vec![(1.0, on_rigid(poisson, joint))]));
    (Grounded::new(paraboloid(), layers.clone()), layers)
}

/// Over twelve decades of a/h: places lead back to radii, stiffness and depth grow, from a half-space to the power of a thin
/// layer, and d_e′ = 2s/Rs′ by differences, which narrow contacts know from the integral equation alone.
#[test]
fn twelve_decades_of_the_radius() {
    let layers = [
        (0.0, Joint::Bonded, 2.0),
        (0.3, Joint::Bonded, 2.0),
        (0.45, Joint::Bonded, 2.0),
        (0.5, Joint::Bonded, 4.0),
        (0.3, Joint::Sliding, 2.0),
        (0.5, Joint::Sliding, 2.0),
    ];
    for (poisson, joint, power) in layers {
        let (bed, ground) = on_a_rigid_base(poisson, joint);
        let known = bed.known_to(1e6);
        assert!(known >= 1e6, "{poisson} {joint:?}: {known}");
        let mut before = [0.0; 3];
        for k in 0..=60 {
            let a = 10f64.powf(-6.0 + 0.2 * f64::from(k));
            let s = bed.place(a);
            assert!((bed.contact_radius(s) / a - 1.0).abs() < 1e-12, "{poisson}: {a}");
            let here = [s, bed.reduced(s), ground.growth(a)];
            assert!(here[0] > before[0] && here[1] > before[1], "{poisson}: {a} {here:?} {before:?}");
            // A layer that can hardly be compressed goes by the fourth power before it goes by the second.
            assert!(here[2] > 1.0 - 1e-12 && here[2] < 4.1, "{poisson}: {a} {here:?}");
            let depth = |a: f64| bed.reduced(bed.place(a));
            let h = 1e-4;
            let slope = (depth(a * (1.0 + h)) - depth(a * (1.0 - h))) / (2.0 * h * a);
            let right = 0.2 * s / ground.density(a);
            // Bound: h² and the rounding of a difference over it.
            assert!((slope / right - 1.0).abs() < 1e-7, "{poisson}: {a} {slope} {right}");
            before = here;
        }
        assert!((before[2] / power - 1.0).abs() < 1e-5, "{poisson}: {before:?}");
    }
}

/// The force over that of the thin limit: the rest falls as (h/a)² where the layer cannot be squeezed out of the way
/// and where it can, there by a logarithm less.
#[test]
fn the_rate_of_the_thin_limit() {
    for (poisson, [least, most]) in [(0.5, [85.0, 105.0]), (0.3, [50.0, 100.0])] {
        let (bed, _) = on_a_rigid_base(poisson, Joint::Bonded);
        let young = 1.0 - poisson * poisson;
        let rest = |a: f64| {
            let (depth, force) = (bed.reduced(bed.place(a)), 2.0 * bed.load_integral(bed.place(a)));
            let thin = if poisson < 0.5 {
                std::f64::consts::PI * (1.0 - poisson) * young / ((1.0 + poisson) * (1.0 - 2.0 * poisson))
                    * 10.0
                    * depth
                    * depth
            } else {
                2.0 / 3.0 * std::f64::consts::PI * young * 100.0 * depth.powi(3)
            };
            (force / thin - 1.0).abs()
        };
        let rate = rest(100.0) / rest(1000.0);
        assert!(rate > least && rate < most, "{poisson}: {} {}", rest(100.0), rest(1000.0));
        assert!(rest(1e5) < 3e-8, "{poisson}: {}", rest(1e5));
    }
}

/// Where the integral equation ends the polynomial goes on; what turns from one power to the other far out, or lies on a
/// base that gives, ends there, and so does every other shape.
#[test]
fn the_end_of_the_integral_equation() {
    for poisson in [0.0, 0.3, 0.5] {
        let (bed, ground) = on_a_rigid_base(poisson, Joint::Bonded);
        let jump = ground.density(64.0 * (1.0 + 1e-12)) / ground.density(64.0) - 1.0;
        assert!(jump.abs() < 1e-8, "{poisson}: {jump:e}");
        assert!(bed.table_error() <= 1e-8);
    }
    assert!(on_a_rigid_base(0.499, Joint::Bonded).0.known_to(1e3) <= 64.0);
    let given = Grounded::new(paraboloid(), Arc::new(Layers::new(vec![(1.0, on_base(0.1, 0.3, 0.3))])));
    assert!(given.known_to(1e3) <= 64.0);
    let cone = Arc::new(Cone { slope: Positive::new(0.1).unwrap() });
    let layers = Layers::new(vec![(1.0, on_rigid(0.3, Joint::Bonded))]);
    assert!(Grounded::new(cone, Arc::new(layers)).known_to(1e3) <= 64.0);
}

/// Towards the equator of a ball a radius is known to rounding, which is more and more of what is left to the equator: the
/// tables stop where halving them shows nothing else.
#[test]
fn a_ball_up_to_its_equator() {
    let ball: Arc<dyn Profile> = Arc::new(Sphere { radius: Length::new(5.0).unwrap() });
    let layers = Arc::new(Layers::new(vec![(1.0, on_rigid(0.5, Joint::Bonded))]));
    let grounded = Grounded::new(ball.clone(), layers.clone());
    for rest in [0.3, 1e-2, 1e-4, 1e-6, 1e-9] {
        let a = 5.0 * (1.0 - rest);
        let right = layers.depth_share(ball.as_ref(), a) * ball.reduced(a);
        let off = (grounded.reduced(layers.measure(a)) / right - 1.0).abs();
        assert!(off < layers::TABLES + 4.0 * f64::EPSILON / rest, "{rest}: {off:e}");
    }
}

proptest! {
    /// The edge at a depth is that which a search over all places finds, of shapes with a flat and without.
    #[test]
    fn the_edge_at_a_depth_needs_no_search(shape in 0usize..3, decade in -40i32..12, poisson in 0i32..=50) {
        let one = Length::new(1.0).unwrap();
        let shapes: [Arc<dyn Profile>; 3] = [
            Arc::new(Paraboloid { radius: one }),
            Arc::new(Cone { slope: Positive::new(0.3).unwrap() }),
            Arc::new(TruncatedCone { slope: Positive::new(0.3).unwrap(), flat_radius: one }),
        ];
        let bed = Grounded::new(shapes[shape].clone(), on_a_rigid_base(0.01 * f64::from(poisson), Joint::Bonded).1);
        let d = 10f64.powf(0.1 * f64::from(decade));
        let (edge, searched) = (bed.edge(d).unwrap(), edge_by_search(&bed, d).unwrap());
        prop_assert!((edge / searched - 1.0).abs() < 1e-9, "{edge} {searched}");
        // At a flat the depth hangs on the difference of two radii.
        prop_assert!(shape == 2 || (bed.reduced(edge) / d - 1.0).abs() < 1e-12);
        prop_assert!(bed.met(d).is_some());
    }
}
