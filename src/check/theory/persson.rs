//! Real contact area without adhesion, after Persson.

use std::f64::consts::{FRAC_2_SQRT_PI, SQRT_2};

/// Real over nominal area, A/A₀ = erf(√2 p/(E* s)) = erf(1/(2√𝒢)), 𝒢 = (π/4)(E*/p)²∫q³C dq.
///
/// p nominal pressure [Pa], E* effective modulus [Pa], s rms slope of the surface (Persson 2001; Persson et al. 2008).
/// Exact in full contact; at small load full solutions give about 25 % more.
#[must_use]
pub fn area_fraction(pressure: f64, modulus: f64, rms_slope: f64) -> f64 {
    if pressure <= 0.0 { 0.0 } else { libm::erf(SQRT_2 * pressure / (modulus * rms_slope)) }
}

/// κ of A/A₀ = κ p/(E* s) at small load: √(8/π) = 1.5957691 in this theory; about 2 in full solutions.
#[must_use]
pub fn low_load_area_slope() -> f64 {
    SQRT_2 * FRAC_2_SQRT_PI
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn low_and_full_contact_are_the_limits() {
        assert!((low_load_area_slope() - (8.0 / PI).sqrt()).abs() < 1e-15);
        let (modulus, slope) = (1e9, 0.1);
        assert!((area_fraction(1e2, modulus, slope) / (low_load_area_slope() * 1e-6) - 1.0).abs() < 1e-12);
        assert!((area_fraction(1e10, modulus, slope) - 1.0).abs() < 1e-15);
    }
}
