//! Real contact area without adhesion, after Persson.
//!
//! His theory of adhesive rough contact (Persson 2002) stays out: what it could be held against are the figures of Persson
//! et al. 2008, whose surfaces the text does not give. Two surfaces of the same true area, self-affine over the same six
//! decades with H = 0.8 and 0.6, differ in rms height by √(3(10^2.4 + 1)/8) = 9.7, not by 1.01 µm / 0.66 µm = 1.5; with 9.7
//! full contact costs the rougher one as much at a modulus 45 times higher, which is what the paper finds (1 and 50 MPa),
//! with the heights as printed it would be 1.1 times. From the height and area of the surface with H = 0.8 the theory gives contact over 95 %
//! at 1 MPa as printed, but regions that end at 2.0–2.5 and 3.5–4 MPa where the paper has 5 and 10: the longest wave,
//! to which both are inversely proportional, and the number in the detachment stress, of order one in the theory, are
//! not told. Adhesive rough contact is what `solver: HalfSpace(…)` computes.

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
    use crate::shape::rough::RoughnessSpectrum;
    use std::f64::consts::PI;

    const DECADES: f64 = 1e6;

    /// Square of height over slope of a self-affine surface, from the longest wave 2π to a millionth of it.
    fn square_height(hurst: f64) -> f64 {
        let ends = [(1.0, 1.0), (DECADES, DECADES.powf(-2.0 * (1.0 + hurst)))];
        let spectrum = RoughnessSpectrum::table(&ends).unwrap();
        (spectrum.rms_height() / spectrum.rms_slope()).powi(2)
    }

    /// What the module says of the surfaces of Persson et al. 2008: heights at equal slopes, and the energies (πE*/2)∫q²C dq
    /// of full contact, h²H(1 − ζ^(1−2H))/(2H − 1) each.
    #[test]
    fn surfaces_of_one_true_area_differ_more_in_height_than_was_printed() {
        let [smoother, rougher] = [0.6, 0.8].map(square_height);
        let exact = 0.375 * (DECADES.powf(0.4) + 1.0);
        assert!((rougher / smoother / exact - 1.0).abs() < 1e-6, "{}", rougher / smoother);
        let energy =
            |square: f64, hurst: f64| square * hurst * (1.0 - DECADES.powf(1.0 - 2.0 * hurst)) / (2.0 * hurst - 1.0);
        let moduli = energy(rougher, 0.8) / energy(smoother, 0.6);
        assert!((40.0..50.0).contains(&moduli), "{moduli}");
        let printed = energy(1.01 * 1.01, 0.8) / energy(0.66 * 0.66, 0.6);
        assert!((1.0..1.2).contains(&printed), "{printed}");
    }

    #[test]
    fn low_and_full_contact_are_the_limits() {
        assert!((low_load_area_slope() - (8.0 / PI).sqrt()).abs() < 1e-15);
        let (modulus, slope) = (1e9, 0.1);
        assert!((area_fraction(1e2, modulus, slope) / (low_load_area_slope() * 1e-6) - 1.0).abs() < 1e-12);
        assert!((area_fraction(1e10, modulus, slope) - 1.0).abs() < 1e-15);
    }
}
