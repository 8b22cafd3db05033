//! The direct path against the full solutions of Hertz and of Johnson, Kendall & Roberts, over at
//! least twelve decades of every parameter, and the laws both obey.
//!
//! Bound 1e-11: a root to two units in the last place, a few dozen roundings, and the conditioning
//! of the states drawn (at most 10³ away from a turning point): 10³ · 50 · 2⁻⁵³ < 1e-11.

use proptest::prelude::*;
use springbed::contact::adhesion::line::EdgeLine;
use springbed::contact::adhesion::range::RangeDisc;
use springbed::contact::direct::QuasiStatic;
use springbed::contact::foundation::Foundation;
use springbed::input::quantity::{Length, Positive};
use springbed::numerics::quadrature;
use springbed::shape::{Cone, Paraboloid, Power, Profile};
use std::f64::consts::PI;
use std::sync::Arc;

const BOUND: f64 = 1e-11;

/// 10^k for k = low … high in steps of 1/50.
fn decades(low: i32, high: i32) -> impl Strategy<Value = f64> {
    (low * 50..=high * 50).prop_map(|k| 10f64.powf(f64::from(k) / 50.0))
}

fn ball(radius: f64) -> Paraboloid {
    Paraboloid { radius: Length::new(radius).unwrap() }
}

fn contact<P: Profile + Clone + 'static>(profile: &P, modulus: f64, work: f64) -> QuasiStatic {
    QuasiStatic::new(EdgeLine::new(Foundation::new(Arc::new(profile.clone()), modulus), work))
}

fn close(value: f64, right: f64) -> Result<(), TestCaseError> {
    prop_assert!((value - right).abs() <= BOUND * right.abs(), "{value:e} is not {right:e}");
    Ok(())
}

/// Radius of JKR under the load F (Johnson, Kendall & Roberts 1971).
fn jkr_radius(load: f64, (radius, modulus, work): (f64, f64, f64)) -> f64 {
    let pull = 1.5 * PI * work * radius;
    (0.75 * radius / modulus * (pull.sqrt() + (load + pull).sqrt()).powi(2)).cbrt()
}

/// Depth of JKR at the radius a.
fn jkr_depth(a: f64, (radius, modulus, work): (f64, f64, f64)) -> f64 {
    a * a / radius - (2.0 * PI * a * work / modulus).sqrt()
}

proptest! {
    #![proptest_config(crate::laws::cases(256))]

    #[test]
    fn hertz(modulus in decades(0, 13), radius in decades(-9, 7), part in decades(-15, -1)) {
        let (shape, d) = (ball(radius), part * radius);
        let mut state = contact(&shape, modulus, 0.0);
        state.indent(d).unwrap();
        let (force, a) = (4.0 / 3.0 * modulus * radius.sqrt() * d.powf(1.5), (radius * d).sqrt());
        close(state.present().balance.force, force)?;
        close(state.present().balance.contact_radius, a)?;
        close(state.loaded().pressure(0.0), 1.5 * force / (PI * a * a))?;
        close(state.loaded().pressure(0.6 * a), 0.8 * 1.5 * force / (PI * a * a))?;
        close(state.stiffness(), 2.0 * modulus * a)?;
        close(state.energy().elastic, 0.4 * force * d)?;
        // u(r) = [(2a² − r²) arcsin(a/r) + a√(r² − a²)]/(πR) at r = 2a.
        let outside = a * a * (3.0f64.sqrt() - 2.0 * 0.5f64.asin()) / (PI * radius);
        close(state.loaded().surface(2.0 * a), outside)?;
        let mut pressed = contact(&shape, modulus, 0.0);
        pressed.press(force).unwrap();
        close(pressed.present().balance.indentation, d)?;
    }

    #[test]
    fn jkr(
        (modulus, radius) in (decades(0, 13), decades(-9, 4)),
        (work, ratio) in (decades(-9, 3), decades(-6, 6)),
        pulled in any::<bool>(),
    ) {
        let all = (radius, modulus, work);
        let pull = 1.5 * PI * work * radius;
        // Down to 0.9 of pull-off; a is then at most ten times worse conditioned than F.
        let load = if pulled { -0.9 * pull * (ratio / (1.0 + ratio)) } else { ratio * pull };
        let a = jkr_radius(load, all);
        let d = jkr_depth(a, all);
        prop_assume!(d.abs() > 1e-2 * a * a / radius);
        let shape = ball(radius);
        let mut by_force = contact(&shape, modulus, work);
        by_force.press(0.0).unwrap();
        by_force.press(load).unwrap();
        close(by_force.present().balance.contact_radius, a)?;
        close(by_force.present().balance.indentation, d)?;
        let mut by_depth = contact(&shape, modulus, work);
        by_depth.indent(0.0).unwrap();
        by_depth.indent(d).unwrap();
        prop_assume!(load.abs() > 1e-2 * pull);
        close(by_depth.present().balance.force, load)?;
        // K_I²/(2E*) = w, from d − g(a): the difference loses what g is larger than Δl.
        prop_assume!(ratio < 1e3);
        close(by_depth.loaded().stress_intensity(), (2.0 * modulus * work).sqrt())?;
        let centre = 2.0 * modulus * a / (PI * radius) - (2.0 * modulus * work / (PI * a)).sqrt();
        prop_assume!(centre.abs() > 1e-2 * modulus * a / radius);
        close(by_depth.loaded().pressure(0.0), centre)?;
    }

    /// JKR for power-law profiles: F of the edge radius a, found again from d.
    #[test]
    fn jkr_of_powers(n in 5i32..40, scale in decades(-6, 6), work in decades(-9, 3), above in decades(-1, 4)) {
        let exponent = 0.2 * f64::from(n);
        let shape = Power { coefficient: Positive::new(scale).unwrap(), exponent: Positive::new(exponent).unwrap() };
        let modulus = 1e6;
        let stretch = shape.reduced(1.0);
        // Turning point: n g = Δl/2.
        let turn = ((2.0 * PI * work / modulus).sqrt() / (2.0 * exponent * stretch)).powf(1.0 / (exponent - 0.5));
        let a = turn * (1.0 + above);
        prop_assume!(a.is_finite() && a < 1e30 && a > 1e-30);
        let (g, gap) = (stretch * a.powf(exponent), (2.0 * PI * a * work / modulus).sqrt());
        prop_assume!((g - gap).abs() > 1e-2 * g);
        let mut state = contact(&shape, modulus, work);
        state.indent((g - gap).max(0.0)).unwrap();
        state.indent(g - gap).unwrap();
        prop_assert!((state.present().balance.contact_radius / a - 1.0).abs() < 1e-10);
        let force = 2.0 * modulus * a * (exponent / (exponent + 1.0) * g - gap);
        prop_assert!((state.present().balance.force - force).abs() < 1e-10 * 2.0 * modulus * a * g.max(gap));
    }

    /// Similarity: lengths times s and moduli times t make forces times s²t.
    #[test]
    fn similarity(s in decades(-6, 6), t in decades(-6, 6), load in (1i32..100).prop_map(|k| 0.1 * f64::from(k))) {
        let (one, other) = (ball(1.0), ball(s));
        let (mut first, mut second) = (contact(&one, 1.0, 1.0), contact(&other, t, s * t));
        first.press(load).unwrap();
        second.press(load * s * s * t).unwrap();
        close(second.present().balance.contact_radius, s * first.present().balance.contact_radius)?;
        close(second.energy().elastic, s * s * s * t * first.energy().elastic)?;
        close(second.energy().surface, s * s * s * t * first.energy().surface)?;
    }

    /// Without adhesion the curve comes back on itself, and work of adhesion 0 is the contact without
    /// adhesion to the bit.
    #[test]
    fn no_adhesion_leaves_no_trace(modulus in decades(0, 12), radius in decades(-9, 3), part in decades(-12, -2)) {
        let shape = ball(radius);
        let mut bare = contact(&shape, modulus, 0.0);
        bare.indent(part * radius).unwrap();
        let first = bare.present().balance;
        bare.indent(3.0 * part * radius).unwrap();
        bare.indent(part * radius).unwrap();
        close(bare.present().balance.force, first.force)?;
        close(bare.present().balance.contact_radius, first.contact_radius)?;
        prop_assert_eq!(first.force.to_bits(), (2.0 * modulus * shape.load_integral(first.contact_radius)
            + 2.0 * modulus * first.contact_radius * 0.0).to_bits());
    }

    /// The energy is the work: ∫F dd over any piece of a stable branch.
    #[test]
    fn energy_is_work(from in 0i32..30, length in 1i32..30, work in decades(-3, 1)) {
        let (from, length) = (0.1 * f64::from(from), 0.1 * f64::from(length));
        let shape = ball(1.0);
        let mut state = contact(&shape, 1.0, work);
        state.indent(from).unwrap();
        let start = state.energy().stored();
        let force = |d: f64| {
            let mut at = state.clone();
            at.indent(d).unwrap();
            at.present().balance.force
        };
        let breaks: Vec<f64> = (1..8).map(|k| from + length * 0.25f64.powi(8 - k)).collect();
        let area = quadrature::panels(force, (from, from + length), &breaks);
        let mut end = state.clone();
        end.indent(from + length).unwrap();
        let gained = end.energy().stored() - start;
        let scale = end.energy().elastic - end.energy().surface;
        prop_assert!((gained - area).abs() <= 1e-11 * scale, "{gained} {area}");
    }

    /// ∫p dA = F with the singular edge.
    #[test]
    fn pressure_carries_the_force(load in (-10i32..100).prop_map(|k| 0.1 * f64::from(k))) {
        let shape = ball(1.0);
        let mut state = contact(&shape, 1.0, 1.0);
        state.press(0.0).unwrap();
        state.press(load).unwrap();
        let a = state.present().balance.contact_radius;
        // r = a sin θ makes p r dr smooth in θ: the singular part is constant.
        let ring = |theta: f64| {
            let r = a * theta.sin();
            state.loaded().pressure(r) * 2.0 * PI * r * a * theta.cos()
        };
        let carried = quadrature::panel(ring, 0.0, 0.5 * PI);
        // Close to θ = π/2 the root √(a² − r²) keeps half of the digits, weighted by the last node.
        prop_assert!((carried - load).abs() < 1e-11 * (load.abs() + 1.5 * PI), "{carried} {load}");
    }

}

proptest! {
    #![proptest_config(crate::laws::cases(24))]

    /// Maugis–Dugdale tends to JKR as the range of the attraction goes to zero.
    #[test]
    fn maugis_tends_to_jkr(load in (-30i32..100).prop_map(|k| 0.1 * f64::from(k))) {
        let shape = ball(1.0);
        let right = jkr_radius(load, (1.0, 1.0, 1.0));
        let error = |stress: f64| {
            let disc = RangeDisc::new(Foundation::new(Arc::new(shape.clone()), 1.0), 1.0, stress).unwrap();
            let mut state = QuasiStatic::new(disc);
            state.press(0.0).unwrap();
            state.press(load).unwrap();
            (state.present().balance.contact_radius / right - 1.0).abs()
        };
        let (coarse, fine) = (error(100.0), error(1000.0));
        // The neck is short against a: its width falls as σ₀⁻², the error with it.
        prop_assert!(coarse < 1e-2 && fine < 0.05 * coarse, "{coarse:e} {fine:e}");
    }
}

/// A cone against its closed form, and the DMT limit of Maugis: pull-off −2πwR.
#[test]
fn cone_and_dmt() {
    let cone = Cone { slope: Positive::new(0.1).unwrap() };
    let mut state = contact(&cone, 3.0, 0.0);
    state.indent(0.02).unwrap();
    assert!((state.present().balance.force / (2.0 / PI * 3.0 * 0.02 * 0.02 / 0.1) - 1.0).abs() < 1e-14);
    let shape = ball(1.0);
    let disc = RangeDisc::new(Foundation::new(Arc::new(shape.clone()), 1e6), 1.0, 1.0).unwrap();
    let mut tip = QuasiStatic::new(disc);
    tip.press(0.0).unwrap();
    let off = tip.press(-10.0).unwrap().last().unwrap().before.force;
    // λ = 1.2e-4 here; the departure from DMT is of the order λ.
    assert!((off / (-2.0 * PI) - 1.0).abs() < 1e-3, "{off}");
}
