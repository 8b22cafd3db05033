//! A wavy surface on an elastic half-plane: pressing and gross sliding.

use crate::numerics::{quadrature, root};
use std::f64::consts::{FRAC_PI_2, PI, SQRT_2};

/// A wave of amplitude Δ and wavelength λ pressed on an elastic half-plane (Westergaard 1939), force per width.
///
/// The gap is Δ(1 − cos(2πx/λ)). Valid in plane strain, for small slopes (rms slope below 0.44), without adhesion. Linear theory:
/// the same for a wavy body on a flat and a flat body on a wave, at rest and in gross sliding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Westergaard {
    /// Effective modulus E* [Pa].
    pub modulus: f64,
    /// Amplitude Δ [m].
    pub amplitude: f64,
    /// Wavelength λ [m].
    pub wavelength: f64,
}

/// Gross sliding of one period of the wave.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GrossSliding {
    /// Mean shear stress over a period [Pa], tangential force per width and wavelength.
    pub mean_shear: f64,
    /// Half width [m] of the middle zone in which the shear stress is at its limit; 0 if nowhere.
    pub capped_half_width: f64,
}

impl Westergaard {
    /// Mean pressure of full contact p* = πE*Δ/λ [Pa].
    #[must_use]
    pub fn full_contact_pressure(&self) -> f64 {
        PI * self.modulus * self.amplitude / self.wavelength
    }

    /// Root mean square slope √2 π Δ/λ.
    #[must_use]
    pub fn rms_slope(&self) -> f64 {
        SQRT_2 * PI * self.amplitude / self.wavelength
    }

    /// Mean pressure p̄ = (πE*Δ/λ) sin²(πa/λ) [Pa] at a contact half width a [m], a ≤ λ/2.
    #[must_use]
    pub fn mean_pressure(&self, half_width: f64) -> f64 {
        self.full_contact_pressure() * (PI * half_width / self.wavelength).sin().powi(2)
    }

    /// Contact half width [m] under a mean pressure [Pa]; λ/2 from full contact on.
    #[must_use]
    pub fn half_width(&self, mean_pressure: f64) -> f64 {
        let share = (mean_pressure / self.full_contact_pressure()).clamp(0.0, 1.0);
        self.wavelength / PI * share.sqrt().asin()
    }

    /// Pressure [Pa] at a distance x [m] from the crest under a mean pressure p̄ [Pa].
    ///
    /// p = 2p* cos(πx/λ) √(sin²(πa/λ) − sin²(πx/λ)) in partial contact, p̄ + p* cos(2πx/λ) in full contact
    /// (Johnson, Contact Mechanics, eqs. 13.3 and 13.7).
    #[must_use]
    pub fn pressure(&self, x: f64, mean_pressure: f64) -> f64 {
        let (full, angle) = (self.full_contact_pressure(), PI * x / self.wavelength);
        if mean_pressure >= full {
            return mean_pressure + full * (2.0 * angle).cos();
        }
        let edge = (mean_pressure / full).max(0.0);
        let inside = edge - angle.sin().powi(2);
        if inside <= 0.0 { 0.0 } else { 2.0 * full * angle.cos().abs() * inside.sqrt() }
    }

    /// Gross sliding under the friction law τ = min(μp, τ_max) (Coulomb–Orowan, Ceglie et al. eq. 6) on the pressure of rest.
    ///
    /// `law` is (μ, τ_max [Pa]). In linear theory with an incompressible or rigid pair sliding leaves the pressure as it is.
    #[must_use]
    pub fn sliding(&self, mean_pressure: f64, (coefficient, limit): (f64, f64)) -> GrossSliding {
        let a = self.half_width(mean_pressure);
        let capped_half_width = self.where_pressure_is(limit / coefficient, (mean_pressure, a));
        // x = a − (a − c) cos²: the root at the edge becomes smooth.
        let (c, span) = (capped_half_width, a - capped_half_width);
        let shear = |phi: f64| {
            let (sine, cosine) = phi.sin_cos();
            coefficient * self.pressure(c + span * sine, mean_pressure) * span * cosine
        };
        let outer = if span > 0.0 { quadrature::panel(shear, 0.0, FRAC_PI_2) } else { 0.0 };
        GrossSliding { mean_shear: 2.0 * (outer + limit * c) / self.wavelength, capped_half_width }
    }

    /// Largest distance from the crest at which the pressure is at least `pressure`; 0 if nowhere.
    fn where_pressure_is(&self, pressure: f64, (mean, half_width): (f64, f64)) -> f64 {
        let excess = |x: f64| self.pressure(x, mean) - pressure;
        if excess(0.0) <= 0.0 {
            return 0.0;
        }
        root::brent(excess, 0.0, half_width).unwrap_or(half_width)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const WAVE: Westergaard = Westergaard { modulus: 2e6, amplitude: 1e-5, wavelength: 1e-4 };

    #[test]
    fn the_aspect_ratios_of_the_paper_have_its_slopes() {
        assert!((WAVE.rms_slope() - 0.444).abs() < 5e-4);
        assert!((Westergaard { amplitude: 3e-5, ..WAVE }.rms_slope() - 1.333).abs() < 5e-4);
    }

    /// Coulomb alone is μp̄; a limit that is never reached changes nothing; a limit everywhere is τ_max·2a/λ.
    #[test]
    fn sliding_has_its_limits() {
        let p = 0.3 * WAVE.full_contact_pressure();
        let free = WAVE.sliding(p, (0.5, 1e12));
        assert!((free.mean_shear / (0.5 * p) - 1.0).abs() < 1e-13, "{}", free.mean_shear / (0.5 * p) - 1.0);
        assert!(free.capped_half_width <= 0.0);
        let capped = WAVE.sliding(p, (1e9, 1e3));
        assert!((capped.mean_shear / (2e3 * WAVE.half_width(p) / WAVE.wavelength) - 1.0).abs() < 1e-6);
        let full = WAVE.sliding(2.0 * WAVE.full_contact_pressure(), (1e9, 1e3));
        assert!((full.mean_shear / 1e3 - 1.0).abs() < 1e-12 && (full.capped_half_width / 5e-5 - 1.0).abs() < 1e-12);
    }

    proptest! {
        /// The pressure carries its mean, is positive, and the half width inverts the mean pressure.
        #[test]
        fn pressure_integrates_to_its_mean(k in 1i32..200) {
            let mean = 0.01 * f64::from(k) * WAVE.full_contact_pressure();
            let a = WAVE.half_width(mean);
            let carried = quadrature::panel(|t: f64| WAVE.pressure(a * t.sin(), mean) * a * t.cos(), 0.0, FRAC_PI_2);
            prop_assert!((2.0 * carried / WAVE.wavelength / mean - 1.0).abs() < 1e-11);
            prop_assert!((WAVE.mean_pressure(a) / mean.min(WAVE.full_contact_pressure()) - 1.0).abs() < 1e-12);
            prop_assert!(WAVE.pressure(0.3 * a, mean) > 0.0);
        }

        /// Friction never exceeds either bound and grows with the load.
        #[test]
        fn friction_is_below_both_bounds(k in 1i32..150, mu in 1i32..30, cap in 1i32..100) {
            let (mean, mu) = (0.01 * f64::from(k) * WAVE.full_contact_pressure(), 0.1 * f64::from(mu));
            let cap = 0.02 * f64::from(cap) * WAVE.full_contact_pressure();
            let s = WAVE.sliding(mean, (mu, cap));
            prop_assert!(s.mean_shear <= mu * mean * (1.0 + 1e-12));
            prop_assert!(s.mean_shear <= 2.0 * cap * WAVE.half_width(mean) / WAVE.wavelength * (1.0 + 1e-12));
            prop_assert!(WAVE.sliding(1.01 * mean, (mu, cap)).mean_shear >= s.mean_shear * (1.0 - 1e-12));
        }
    }
}
