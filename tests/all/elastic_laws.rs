//! Elastic contacts of every closed form over at least twelve decades, the laws of all shapes, and
//! Maugis–Dugdale against its own equations.
//!
//! Bound 1e-11 as in `hertz_and_jkr.rs`: a root to two units in the last place, a few dozen roundings,
//! conditioning of the states drawn at most 10³.

use proptest::prelude::*;
use springbed::contact::adhesion::line::EdgeLine;
use springbed::contact::adhesion::range::RangeDisc;
use springbed::contact::direct::QuasiStatic;
use springbed::contact::foundation::Foundation;
use springbed::input::quantity::{Length, Positive};
use springbed::numerics::quadrature;
use springbed::shape::{
    Cone, FlatPunch, Paraboloid, Power, Profile, RoundedCone, RoundedPunch, Sphere, TruncatedCone, TruncatedParaboloid,
};
use std::f64::consts::PI;
use std::sync::Arc;

const BOUND: f64 = 1e-11;

/// 10^k for k = low … high in steps of 1/50.
fn decades(low: i32, high: i32) -> impl Strategy<Value = f64> {
    (low * 50..=high * 50).prop_map(|k| 10f64.powf(f64::from(k) / 50.0))
}

fn metres(si: f64) -> Length {
    Length::new(si).unwrap()
}

fn plain(value: f64) -> Positive {
    Positive::new(value).unwrap()
}

fn bare<P: Profile + Clone + 'static>(profile: &P, modulus: f64) -> QuasiStatic {
    QuasiStatic::new(EdgeLine::new(Foundation::new(Arc::new(profile.clone()), modulus), 0.0))
}

fn close(value: f64, right: f64) -> Result<(), TestCaseError> {
    prop_assert!((value - right).abs() <= BOUND * right.abs(), "{value:e} is not {right:e}");
    Ok(())
}

/// Stable states of a contact without adhesion: F, a, stiffness and energy, by depth and by force.
fn holds<P: Profile + Clone + 'static>(
    profile: &P,
    modulus: f64,
    d: f64,
    (force, a, energy): (f64, f64, f64),
) -> Result<(), TestCaseError> {
    let mut state = bare(profile, modulus);
    state.indent(d).unwrap();
    close(state.present().balance.force, force)?;
    close(state.present().balance.contact_radius, a)?;
    close(state.stiffness(), 2.0 * modulus * a)?;
    close(state.energy().elastic, energy)?;
    let mut pressed = bare(profile, modulus);
    pressed.press(force).unwrap();
    close(pressed.present().balance.indentation, d)
}

/// κₙ = √π Γ(n/2+1)/Γ(n/2+½), by the recursion κₙκₙ₊₁ = (n+1)π/2 from a series at large n.
fn stretch(n: f64) -> f64 {
    let far =
        |m: f64| (0.5 * PI * m).sqrt() * (1.0 + 1.0 / (4.0 * m) + 1.0 / (32.0 * m * m) - 5.0 / (128.0 * m.powi(3)));
    let steps = 4000u32;
    // Terms of 1/m⁴ at m = 4000 are below 1e-15.
    let mut value = far(n + f64::from(steps));
    for k in (0..steps).rev() {
        value = (n + f64::from(k) + 1.0) * 0.5 * PI / value;
    }
    value
}

proptest! {
    #![proptest_config(crate::laws::cases(128))]

    #[test]
    fn cone(modulus in decades(0, 13), slope in decades(-6, 0), d in decades(-12, 1)) {
        let shape = Cone { slope: plain(slope) };
        let (force, a) = (2.0 / PI * modulus * d * d / slope, 2.0 / PI * d / slope);
        holds(&shape, modulus, d, (force, a, force * d / 3.0))?;
        let mut state = bare(&shape, modulus);
        state.indent(d).unwrap();
        // p(r) = (E*t/2) arcosh(a/r)
        close(state.loaded().pressure(0.5 * a), 0.5 * modulus * slope * 2f64.acosh())?;
    }

    #[test]
    fn power(modulus in decades(0, 13), n in 2i32..60, coefficient in decades(-6, 6), d in decades(-12, 0)) {
        let n = 0.25 * f64::from(n);
        let shape = Power { coefficient: plain(coefficient), exponent: plain(n) };
        let a = (d / (stretch(n) * coefficient)).powf(1.0 / n);
        prop_assume!(a > 1e-100 && a < 1e100);
        let force = 2.0 * n / (n + 1.0) * modulus * d * a;
        holds(&shape, modulus, d, (force, a, force * d * n / (2.0 * n + 1.0)))?;
    }

    #[test]
    fn flat_punch(modulus in decades(0, 13), radius in decades(-9, 4), d in decades(-15, 0)) {
        let shape = FlatPunch { radius: metres(radius) };
        let force = 2.0 * modulus * radius * d;
        holds(&shape, modulus, d, (force, radius, 0.5 * force * d))?;
        let mut state = bare(&shape, modulus);
        state.indent(d).unwrap();
        close(state.loaded().pressure(0.6 * radius), modulus * d / (PI * 0.8 * radius))?;
        close(state.loaded().stress_intensity(), -modulus * d / (PI * radius).sqrt())?;
        // u(2b) = (2d/π) arcsin ½
        close(state.loaded().surface(2.0 * radius), d / 3.0)?;
    }

    /// The exact sphere; its closed force loses digits to a difference below a/R = 0.05.
    #[test]
    fn sphere(modulus in decades(0, 13), radius in decades(-9, 4), part in 5i32..95) {
        let s = 0.01 * f64::from(part);
        let shape = Sphere { radius: metres(radius) };
        let (a, d) = (s * radius, s * radius * s.atanh());
        let force = modulus * radius * radius * ((1.0 + s * s) * s.atanh() - s);
        let mut state = bare(&shape, modulus);
        state.indent(d).unwrap();
        close(state.present().balance.force, force)?;
        close(state.present().balance.contact_radius, a)?;
        let mut pressed = bare(&shape, modulus);
        pressed.press(force).unwrap();
        close(pressed.present().balance.indentation, d)?;
    }

    /// dF/dd = 2E*a and F = dU/dd for every shape: both integrated over a piece of the curve.
    #[test]
    fn force_and_energy_are_integrals(size in decades(-6, 6), from in 1i32..40, stretch in 1i32..20) {
        let (b, modulus) = (0.3 * size, 7.0);
        let shapes: [Arc<dyn Profile>; 9] = [
            Arc::new(Paraboloid { radius: metres(size) }),
            Arc::new(Sphere { radius: metres(size) }),
            Arc::new(Cone { slope: plain(0.2) }),
            Arc::new(Power { coefficient: plain(0.1 * size.powi(-3)), exponent: plain(4.0) }),
            Arc::new(FlatPunch { radius: metres(b) }),
            Arc::new(TruncatedCone { flat_radius: metres(b), slope: plain(0.2) }),
            Arc::new(TruncatedParaboloid { flat_radius: metres(b), radius: metres(size) }),
            Arc::new(RoundedCone { radius: metres(size), slope: plain(0.3) }),
            Arc::new(RoundedPunch { flat_radius: metres(b), edge_radius: metres(size) }),
        ];
        let (low, high) = (0.01 * size * f64::from(from), 0.01 * size * f64::from(from) * (1.0 + 0.02 * f64::from(stretch)));
        for shape in shapes {
            let at = |d: f64| {
                let mut state = QuasiStatic::new(EdgeLine::new(Foundation::new(shape.clone(), modulus), 0.0));
                state.indent(d).unwrap();
                (state.present().balance.force, state.stiffness(), state.energy().elastic)
            };
            // Where the law changes, d = g(kink), the curves have roots: panels close in on it.
            let corner = shape.kink().map(|kink| shape.reduced(kink)).filter(|d| *d > 0.99 * low && *d < high);
            let near = |d: f64| (0..8).rev().map(move |k| d + (high - d) * 8f64.powi(-k));
            let breaks: Vec<f64> = corner.into_iter().flat_map(|d| std::iter::once(d).chain(near(d))).collect();
            let (start, end) = (at(low), at(high));
            let gained = quadrature::panels(|d| at(d).1, (low, high), &breaks);
            prop_assert!((end.0 - start.0 - gained).abs() <= 1e-11 * end.0, "{shape:?}: {} {gained}", end.0 - start.0);
            let worked = quadrature::panels(|d| at(d).0, (low, high), &breaks);
            prop_assert!((end.2 - start.2 - worked).abs() <= 1e-11 * end.2, "{shape:?}: {} {worked}", end.2 - start.2);
        }
    }

    /// The same depth by any way gives the same state: loading, unloading, in strides or steps.
    #[test]
    fn unloading_retraces(modulus in decades(0, 12), b in decades(-9, 3), d in decades(-6, 0), turn in 2i32..50) {
        let shape = TruncatedCone { flat_radius: metres(b), slope: plain(0.2) };
        let (d, deep) = (d * b, 0.5 * d * b * f64::from(turn));
        let (mut straight, mut round) = (bare(&shape, modulus), bare(&shape, modulus));
        straight.indent(d).unwrap();
        for to in [0.3 * d, deep, 0.0, 2.0 * deep, d] {
            round.indent(to).unwrap();
        }
        close(round.present().balance.force, straight.present().balance.force)?;
        close(round.energy().elastic, straight.energy().elastic)?;
        round.indent(0.0).unwrap();
        prop_assert!(round.present().balance.force == 0.0 && round.energy().elastic == 0.0);
    }
}

/// Maugis' equations at c/a = m and λ: a, F, d in his units; a solves the first, a quadratic.
fn maugis(lambda: f64, m: f64) -> (f64, f64, f64) {
    let (root, angle) = ((m * m - 1.0).sqrt(), (1.0 / m).acos());
    let first = 0.5 * lambda * (root + (m * m - 2.0) * angle);
    let second = 4.0 / 3.0 * lambda * lambda * (root * angle - m + 1.0);
    // first·a² + second·a = 1
    let a = 2.0 / (second + (second * second + 4.0 * first).sqrt());
    (a, a.powi(3) - lambda * a * a * (root + m * m * angle), a * a - 4.0 / 3.0 * lambda * a * root)
}

proptest! {
    #![proptest_config(crate::laws::cases(64))]

    /// Radius, depth and force of Maugis–Dugdale under a load, over twelve decades of E*, R and w.
    #[test]
    fn maugis_dugdale(
        (modulus, radius, work) in (decades(0, 12), decades(-9, 3), decades(-9, 3)),
        (lambda, neck) in (decades(-2, 1), decades(-2, 1)),
    ) {
        let (a, force, d) = maugis(lambda, 1.0 + neck);
        // The equations themselves lose what these differences lose: at most two digits.
        prop_assume!(force > 0.05 * a.powi(3) && d > 0.05 * a * a);
        let stiffness = 4.0 / 3.0 * modulus;
        let stress = 0.5 * lambda * (PI * work * stiffness * stiffness / radius).cbrt();
        let unit = (PI * work * radius * radius / stiffness).cbrt();
        let shape = Paraboloid { radius: metres(radius) };
        let disc = RangeDisc::new(Foundation::new(Arc::new(shape.clone()), modulus), work, stress).unwrap();
        let mut state = QuasiStatic::new(disc);
        state.press(0.0).unwrap();
        state.press(force * PI * work * radius).unwrap();
        let found = state.present().balance;
        // Two nested roots and two quadratures of a neck as short as 1e-2 a: 1e-10.
        prop_assert!((found.contact_radius / (a * unit) - 1.0).abs() < 1e-10, "{} {}", found.contact_radius, a * unit);
        prop_assert!((found.indentation / (d * unit * unit / radius) - 1.0).abs() < 1e-10);
        prop_assert!((found.reach / found.contact_radius - 1.0 - neck).abs() < 1e-10 * (1.0 + neck) / neck.min(1.0));
    }

    /// Pull-off from JKR's 3/2 to DMT's 2, whatever the scale.
    #[test]
    fn pull_off_at_any_scale(modulus in decades(0, 12), radius in decades(-9, 3), work in decades(-9, 3), k in 0usize..5) {
        let (lambda, right) = [
            (0.01, -1.998_287_784_321_51),
            (0.1, -1.950_594_892_123_43),
            (0.5, -1.718_245_274_886_17),
            (1.0, -1.600_734_911_254_09),
            (5.0, -1.506_349_967_716_04),
        ][k];
        let stiffness = 4.0 / 3.0 * modulus;
        let stress = 0.5 * lambda * (PI * work * stiffness * stiffness / radius).cbrt();
        let shape = Paraboloid { radius: metres(radius) };
        let disc = RangeDisc::new(Foundation::new(Arc::new(shape.clone()), modulus), work, stress).unwrap();
        let mut state = QuasiStatic::new(disc);
        state.press(0.0).unwrap();
        let off = state.press(-3.0 * PI * work * radius).unwrap().last().unwrap().before.force;
        prop_assert!((off / (right * PI * work * radius) - 1.0).abs() < 1e-12, "{off}");
    }
}

proptest! {
    #![proptest_config(crate::laws::cases(128))]

    /// Maugis–Dugdale on a truncated cone, with the edge as near to the kink at b as 1e-14 b: a and c are
    /// drawn, the range of the attraction follows from them in variables in which nothing is singular.
    #[test]
    fn maugis_on_a_truncated_cone(
        (modulus, b, slope) in (decades(0, 12), decades(-9, 3), decades(-3, 0)),
        (beyond, neck, strength) in (decades(-7, 0), decades(-2, 0), decades(-4, -1)),
    ) {
        // q = √(a² − b²)
        let q = b * beyond;
        let a = b.hypot(q);
        let c = a * (1.0 + neck);
        let stress = strength * modulus * slope;
        let phi = ((c - a) * (c + a)).sqrt().atan2(a);
        let top = ((c - b) * (c + b)).sqrt();
        // ∫ₐᶜ g′ arccos(x/c) dx with x² = b² + q², q = top·sin θ.
        let kernel = |theta: f64| {
            let (q, rest) = (top * theta.sin(), top * theta.cos());
            let x = b.hypot(q);
            slope * (q * q.atan2(b) + b) / x * rest.atan2(x) * rest
        };
        let start = (q / top).asin();
        let breaks: Vec<f64> = (1..6).map(|k| start + (0.5 * PI - start) * 0.2 * f64::from(k)).collect();
        let integral = quadrature::panels(kernel, (start, 0.5 * PI), &breaks);
        let ratio = 2.0 * stress / modulus;
        let gap = 2.0 / PI * (integral + ratio * c * (phi * phi.sin() - 2.0 * (0.5 * phi).sin().powi(2)));
        let shape = TruncatedCone { flat_radius: metres(b), slope: plain(slope) };
        let disc = RangeDisc::new(Foundation::new(Arc::new(shape.clone()), modulus), gap * stress, stress).unwrap();
        let state = disc.at(c);
        let (g, pull) = (slope * a * q.atan2(b), ratio * c * phi.sin());
        // Rounding of c against a neck of 1e-2 of it, in two quadratures and a root.
        prop_assert!((state.indentation - (g - pull)).abs() <= BOUND * (g + pull), "{} {}", state.indentation, g - pull);
        let pressed = modulus * slope * (a * a * q.atan2(b) + b * q);
        let pulled = 2.0 * stress * c * c * (phi.sin() * phi.cos() + phi);
        prop_assert!((state.force - (pressed - pulled)).abs() <= BOUND * (pressed + pulled), "{} {}", state.force, pressed - pulled);
        prop_assert!((state.contact_radius / a - 1.0).abs() < BOUND);
    }
}
