//! Hertz contact of an ellipsoid, exact through complete elliptic integrals.
//!
//! # Examples
//! ```
//! use springbed::contact::elliptic::{EllipticHertz, mean_radius_error};
//! use springbed::numerics::root::RootError;
//!
//! // Equal radii are Hertz' ball; at 10:1 the mean radius gives a force 10 % too small.
//! let ball = EllipticHertz::at_indentation([1.0, 1.0], 1.0, 0.01)?;
//! assert!((ball.force / (4.0 / 3.0 * 1e-3) - 1.0).abs() < 1e-12);
//! assert!((mean_radius_error([10.0, 1.0])?.abs() - 0.10).abs() < 0.01);
//! # Ok::<(), RootError>(())
//! ```

use crate::numerics::root::{RootError, brent};

/// Complete elliptic integrals of one modulus, lengths in units of the larger semi-axis.
///
/// With k′ the ratio of the semi-axes, b/a = k′ ≤ 1, and e² = 1 − k′²:
/// K = ∫dθ/Δ, D = ∫sin²θ dθ/Δ = (K − E)/e², B = ∫cos²θ dθ/Δ = K − D, Δ² = 1 − e² sin²θ, θ = 0…π/2.
/// At k′ = 1: K = π/2, B = D = π/4.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Integrals {
    k: f64,
    b: f64,
    d: f64,
}

impl Integrals {
    fn new(ratio: f64) -> Self {
        Self { k: cel(ratio, 1.0, 1.0), b: cel(ratio, 1.0, 0.0), d: cel(ratio, 0.0, 1.0) }
    }
}

/// Bulirsch's complete integral ∫(α cos²θ + β sin²θ) dθ/√(cos²θ + k′² sin²θ), θ = 0…π/2 (Bulirsch 1969, p = 1).
///
/// Arithmetic–geometric means: quadratic convergence, and no difference of nearby numbers for α, β ≥ 0.
fn cel(complement: f64, alpha: f64, beta: f64) -> f64 {
    let (mut kc, mut m, mut e, mut p) = (complement, 1.0, complement, 1.0);
    let (mut a, mut b) = (alpha, beta);
    // Forty doublings reach rounding from any k′ above 1e-300.
    for _ in 0..40 {
        let before = a;
        a += b / p;
        let g = e / p;
        b = 2.0 * (b + before * g);
        p += g;
        let last = m;
        m += kc;
        if (last - kc).abs() <= f64::EPSILON.sqrt() * last {
            break;
        }
        kc = 2.0 * e.sqrt();
        e = kc * m;
    }
    std::f64::consts::FRAC_PI_2 * (b + a * m) / (m * (m + p))
}

/// Contact of an ellipsoid of principal radii R₁ ≥ R₂ (relative radii of curvature of the pair) with a half-space.
///
/// > R₁/R₂ = B(k′)/(k′² D(k′)), a³ = 3 F R₁ D/(πE*), d = 3 F K/(2πE* a), p₀ = 3F/(2πab), b = k′a
///
/// with the integrals K, B, D of modulus e² = 1 − b²/a² (Johnson, Contact Mechanics, eqs 4.25–4.28 with
/// (K − E)/e² = D and (E − k′²K)/e² = B). Valid for a much smaller than both radii.
/// A sphere: a² = Rd, F = (4/3)E*√R d^{3/2}.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EllipticHertz {
    /// Semi-axes of the contact along the larger and the smaller radius \[m\].
    pub semi_axes: [f64; 2],
    /// Normal force \[N\].
    pub force: f64,
    /// Indentation \[m\].
    pub indentation: f64,
    /// Pressure in the centre \[Pa\].
    pub peak_pressure: f64,
}

impl EllipticHertz {
    /// Contact at an indentation d ≥ 0 \[m\], radii in either order \[m\], E* \[Pa\].
    ///
    /// # Errors
    /// Radii, modulus or indentation that are not finite and positive leave no bracket for the axes.
    pub fn at_indentation(radii: [f64; 2], modulus: f64, indentation: f64) -> Result<Self, RootError> {
        let (ratio, integrals) = shape(radii)?;
        let major = (2.0 * indentation * (radii[0].max(radii[1]) * integrals.d / integrals.k)).sqrt();
        let force = 2.0 / 3.0 * std::f64::consts::PI * modulus * major * indentation / integrals.k;
        Ok(Self::new([major, ratio * major], force, indentation))
    }

    /// Contact under a force F ≥ 0 \[N\], radii in either order \[m\], E* \[Pa\].
    ///
    /// # Errors
    /// As for [`EllipticHertz::at_indentation`].
    pub fn at_force(radii: [f64; 2], modulus: f64, force: f64) -> Result<Self, RootError> {
        let (ratio, integrals) = shape(radii)?;
        let load = 3.0 * force / (std::f64::consts::PI * modulus);
        let major = (load * radii[0].max(radii[1]) * integrals.d).cbrt();
        let indentation = if major > 0.0 { 0.5 * load * integrals.k / major } else { 0.0 };
        Ok(Self::new([major, ratio * major], force, indentation))
    }

    fn new(semi_axes: [f64; 2], force: f64, indentation: f64) -> Self {
        let area = std::f64::consts::PI * semi_axes[0] * semi_axes[1];
        let peak_pressure = if area > 0.0 { 1.5 * force / area } else { 0.0 };
        Self { semi_axes, force, indentation, peak_pressure }
    }
}

/// Relative error in the force at a given indentation if the ellipsoid is replaced by a sphere of radius √(R₁R₂)
/// (Popov, Contact Mechanics and Friction, eq. 5.30).
///
/// 0 for equal radii, −1.0 % at R₁/R₂ = 2, −9.8 % at 10 (a footnote to eq. 5.30 puts it at 2.5 % there; the
/// elliptic integrals and the half-space solver agree on 9.8 %).
///
/// # Errors
/// As for [`EllipticHertz::at_indentation`].
pub fn mean_radius_error(radii: [f64; 2]) -> Result<f64, RootError> {
    let larger = radii[0].max(radii[1]);
    let ratio = radii[0].min(radii[1]) / larger;
    let exact = EllipticHertz::at_indentation([1.0, ratio], 1.0, 1.0)?.force;
    Ok(4.0 / 3.0 * ratio.sqrt().sqrt() / exact - 1.0)
}

/// Peak pressure of an ellipsoid over that of a sphere of radius √(R₁R₂) under the same force.
///
/// It depends on R₁/R₂ alone: a² p₀ of both goes with the force, and their axes with its cube root. 1 for equal radii.
///
/// # Errors
/// As for [`EllipticHertz::at_indentation`].
pub fn peak_pressure_ratio(radii: [f64; 2]) -> Result<f64, RootError> {
    let larger = radii[0].max(radii[1]);
    let ratio = radii[0].min(radii[1]) / larger;
    let pressure = |radii| EllipticHertz::at_force(radii, 1.0, 1.0).map(|contact| contact.peak_pressure);
    Ok(pressure([1.0, ratio])? / pressure([ratio.sqrt(); 2])?)
}

/// Ratio b/a of the semi-axes for these radii, and its integrals.
fn shape(radii: [f64; 2]) -> Result<(f64, Integrals), RootError> {
    if let Some(&at) = radii.iter().find(|radius| !radius.is_finite() || **radius <= 0.0) {
        return Err(RootError::NotANumber { at });
    }
    let wanted = (radii[0].ln() - radii[1].ln()).abs();
    let excess = |logarithm: f64| {
        let integrals = Integrals::new(logarithm.exp());
        (integrals.b / integrals.d).ln() - 2.0 * logarithm - wanted
    };
    // R₂/R₁ ≤ b/a ≤ 1, since 1 ≥ k′ and B ≥ k′D.
    let ratio = if wanted > 0.0 { brent(excess, -wanted, 0.0)?.exp() } else { 1.0 };
    Ok((ratio, Integrals::new(ratio)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const PI: f64 = std::f64::consts::PI;

    /// Limits k′ = 1 to rounding, and K(k = ½), E(k = ½) of the tables: 1.685750354812596, 1.467462209339427.
    #[test]
    fn integrals_of_known_moduli() {
        let circle = Integrals::new(1.0);
        assert!(
            (circle.k - PI / 2.0).abs() < 1e-15
                && (circle.d - PI / 4.0).abs() < 1e-15
                && (circle.b - PI / 4.0).abs() < 1e-15
        );
        let half = Integrals::new(0.75_f64.sqrt());
        assert!((half.k - 1.685_750_354_812_596).abs() < 1e-15);
        assert!((half.k - 0.25 * half.d - 1.467_462_209_339_427).abs() < 2e-15);
        assert!((half.b + half.d - half.k).abs() < 1e-15);
    }

    /// Equal radii are the sphere to rounding.
    #[test]
    fn sphere_is_the_limit() {
        let hertz = EllipticHertz::at_indentation([2.0, 2.0], 3.0, 0.01).unwrap();
        let force = 4.0 / 3.0 * 3.0 * 2.0_f64.sqrt() * 0.01_f64.powf(1.5);
        assert!((hertz.force / force - 1.0).abs() < 1e-15);
        assert!((hertz.semi_axes[0] / 0.02_f64.sqrt() - 1.0).abs() < 1e-15);
        let near = EllipticHertz::at_indentation([2.0 + 1e-9, 2.0], 3.0, 0.01).unwrap();
        // The force goes with the fourth root of each radius, the ratio of axes with the power 2/3 of theirs.
        assert!((near.force / force - 1.0 - 0.125e-9).abs() < 1e-14);
        assert!((near.semi_axes[1] / near.semi_axes[0] - 1.0 + 1e-9 / 3.0).abs() < 1e-13);
    }

    /// Another library's K and E in Johnson's equations 4.25–4.28, and none between equal radii.
    #[test]
    fn mean_radius_underestimates_the_force() {
        for (ratio, error) in [(2.0, -0.009_894_417_835), (10.0, -0.098_319_471_717)] {
            assert!((mean_radius_error([ratio, 1.0]).unwrap() - error).abs() < 1e-12);
            assert!((mean_radius_error([3.0, 3.0 * ratio]).unwrap() - error).abs() < 1e-12);
        }
        assert!(mean_radius_error([1.0, 1.0]).unwrap().abs() < 1e-15);
    }

    /// From semi-axes that return both curvatures, against p₀ = (6FE*²/π³R²)^{1/3} of the sphere.
    #[test]
    fn an_ellipse_presses_harder_than_a_circle() {
        for ratio in [1.0, 0.5, 0.1, 0.01] {
            let exact = EllipticHertz::at_force([1.0, ratio], 1.0, 1.0).unwrap().peak_pressure;
            let sphere = (6.0 / (PI.powi(3) * ratio)).cbrt();
            let found = peak_pressure_ratio([7.0 * ratio, 7.0]).unwrap();
            assert!((found * sphere / exact - 1.0).abs() < 1e-14, "{ratio}");
            assert!(if ratio < 1.0 { found > 1.0 } else { (found - 1.0).abs() < 1e-14 });
        }
    }

    #[test]
    fn impossible_radii_are_refused() {
        assert!(EllipticHertz::at_indentation([f64::NAN, 1.0], 1.0, 0.1).is_err());
        assert!(EllipticHertz::at_indentation([0.0, 1.0], 1.0, 0.1).is_err());
        assert!(EllipticHertz::at_indentation([f64::INFINITY, 1.0], 1.0, 0.1).is_err());
    }

    proptest! {
        /// Force and indentation are inverse, and both curvatures come back: 1/R₁ = 2p₀bD/(E*a²),
        /// 1/R₂ = 2p₀bB/(E*b²) (Johnson, Contact Mechanics, eq. 4.25).
        #[test]
        fn force_and_indentation_agree(exponent in 0..400_i32, ratio in 0..300_i32) {
            let radii = [1.0, 10.0_f64.powf(-0.01 * f64::from(ratio))];
            let depth = 10.0_f64.powf(-15.0 + 0.05 * f64::from(exponent));
            let there = EllipticHertz::at_indentation(radii, 2.0, depth).unwrap();
            let back = EllipticHertz::at_force(radii, 2.0, there.force).unwrap();
            prop_assert!((back.indentation / depth - 1.0).abs() < 1e-13);
            let [a, b] = there.semi_axes;
            let integrals = Integrals::new(b / a);
            let curvature = |integral: f64, axis: f64| 2.0 * there.peak_pressure * b * integral / (2.0 * axis * axis);
            prop_assert!((curvature(integrals.d, a) * radii[0] - 1.0).abs() < 1e-12);
            prop_assert!((curvature(integrals.b, b) * radii[1] - 1.0).abs() < 1e-12);
        }
    }
}
