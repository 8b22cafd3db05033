//! Roughness of a sample of finite size, by rings of the wavevector plane.

use super::{RoughError, RoughnessSpectrum};
use std::f64::consts::TAU;

/// Height variance of a periodic sample, split over rings of wavevectors of width Δq = 2π/length.
///
/// Ring k holds the wavevectors nearest to kΔq:
/// V_k = 2π ∫ C q dq = 2 ∫ C₁D dq from (k − ½)Δq to (k + ½)Δq, the end rings reaching out to the cut-offs. A rough line
/// puts V_k into one cosine of wavevector kΔq, B_k²/2 = V_k; where the ring is narrow beside its wavevector that is
/// B = √(8πC₁D/length) (Popov & Heß 2015, ch. 10). A surface spreads V_k over the waves of the ring.
/// Either way Σ V_k is the rms height squared of the spectrum, to rounding, however few waves there are.
#[derive(Debug, Clone, PartialEq)]
pub struct Rings {
    length: f64,
    /// Variance of ring k at index k; index 0, the mean plane, is zero.
    variances: Vec<f64>,
}

/// Wavelengths that equal a limit but for rounding of a scene's numbers count as equal.
const SLACK: f64 = 1e-9;

impl Rings {
    /// The rings of a spectrum on a sample of a length [m] with a number of points on that length.
    ///
    /// # Errors
    /// A length that is not positive; a spectrum with waves longer than the length or shorter than two steps.
    pub fn of(spectrum: &RoughnessSpectrum, length: f64, points: usize) -> Result<Self, RoughError> {
        let length = super::error::positive("length", length)?;
        let (least, greatest) = spectrum.cut_offs();
        let width = TAU / length;
        if least < width * (1.0 - SLACK) {
            return Err(RoughError::TooLong { long: TAU / least, length });
        }
        let (first, last) = (whole(least / width - SLACK) + 1, whole(greatest / width * (1.0 + SLACK)));
        if last.max(1) * 2 > points {
            return Err(too_fine(TAU / greatest, length, points));
        }
        let edge = |k: usize| width * (half_steps(k) - 0.5);
        let band =
            |k: usize| (if k <= first { least } else { edge(k) }, if k >= last { greatest } else { edge(k + 1) });
        let mut variances = vec![0.0; last.max(first) + 1];
        for (k, v) in variances.iter_mut().enumerate().skip(first) {
            *v = spectrum.mean_square(0, band(k));
        }
        Ok(Self { length, variances })
    }

    /// Rings measured on a sample of a length [m]: variance of ring k at index k.
    pub(super) fn measured(length: f64, variances: Vec<f64>) -> Self {
        Self { length, variances }
    }

    /// Length [m] of the sample, the longest wavelength.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Variance [m²] of ring k at index k.
    #[must_use]
    pub fn variances(&self) -> &[f64] {
        &self.variances
    }

    /// Wavevector kΔq [rad/m] of ring k.
    #[must_use]
    pub fn wavevector(&self, k: usize) -> f64 {
        half_steps(k) * TAU / self.length
    }

    /// Root mean square height [m].
    #[must_use]
    pub fn rms_height(&self) -> f64 {
        self.mean_square(0).sqrt()
    }

    /// Root mean square slope of the line made from the rings: Σ q_k² V_k.
    #[must_use]
    pub fn rms_slope(&self) -> f64 {
        self.mean_square(1).sqrt()
    }

    /// Σ q_k²ⁿ V_k, mean square of the n-th derivative of the line made from the rings.
    #[must_use]
    pub fn mean_square(&self, derivative: i32) -> f64 {
        let term = |(k, v): (usize, &f64)| self.wavevector(k).powi(2 * derivative) * v;
        self.variances.iter().enumerate().skip(1).map(term).sum()
    }

    /// The rings as rows of (q [rad/m], C [m⁴]), C = V_k/(2πqΔq): the spectrum of a measured surface. Empty rings are left out.
    #[must_use]
    pub fn density(&self) -> Vec<(f64, f64)> {
        let width = TAU / self.length;
        let row = |k: usize| (self.wavevector(k), self.variances[k] / (TAU * self.wavevector(k) * width));
        (1..self.variances.len()).map(row).filter(|r| r.1 > 0.0).collect()
    }
}

#[expect(clippy::cast_precision_loss, reason = "rings are far fewer than 2^53")]
fn half_steps(k: usize) -> f64 {
    k as f64
}

/// Whole part of a number not below zero, held at u32::MAX.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a cast of a float saturates")]
fn whole(x: f64) -> usize {
    x.clamp(0.0, f64::from(u32::MAX)) as usize
}

fn too_fine(short: f64, length: f64, points: usize) -> RoughError {
    let needed = whole((2.0 * length / short * (1.0 - SLACK)).ceil());
    RoughError::TooFine { short, step: length / half_steps(points), length, points, needed }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    pub(crate) fn self_affine(hurst: f64, long: f64, short: f64) -> RoughnessSpectrum {
        RoughnessSpectrum::table(&[(TAU / long, 1.0), (TAU / short, (long / short).powf(-2.0 * (1.0 + hurst)))])
            .unwrap()
    }

    #[test]
    fn a_spectrum_that_does_not_fit_is_refused_with_both_numbers() {
        let text = |length, points| Rings::of(&self_affine(0.8, 1e-3, 1e-6), length, points).unwrap_err().to_string();
        let coarse = text(1e-3, 1024);
        assert!(coarse.contains("spectrum finer than the grid"), "{coarse}");
        assert!(coarse.contains("in 1024 points); use at least 2000 points"), "{coarse}");
        assert!(text(5e-4, 4096).contains("does not fit into the length 0.0005 m"));
        assert!(Rings::of(&self_affine(0.8, 1e-3, 1e-6), 1e-3, 2000).is_ok());
        assert!(text(0.0, 4096).contains("length = 0.0"));
    }

    proptest! {
        /// Whatever the sample, no variance is lost.
        #[test]
        fn rings_keep_the_variance(h in 1i32..=100, longer in 0i32..30, range in 1i32..30) {
            let long = 1e-3;
            let short = long * 10f64.powf(-0.1 * f64::from(range));
            let spectrum = self_affine(0.01 * f64::from(h), long, short);
            let length = long * 10f64.powf(0.1 * f64::from(longer));
            let rings = Rings::of(&spectrum, length, 3 + whole(2.0 * length / short)).unwrap();
            prop_assert!((rings.rms_height() / spectrum.rms_height() - 1.0).abs() < 1e-13);
        }

        /// One cosine per ring gives the slope to the square of the ring's relative width: for n rings below the
        /// longest wave, relative width 1/n, |error| < 1/n for the sum of mid-point and end rings.
        #[test]
        fn rings_keep_the_slope(h in 1i32..=100, n in 8i32..40) {
            let spectrum = self_affine(0.01 * f64::from(h), 1e-3, 1e-5);
            let rings = Rings::of(&spectrum, 1e-3 * f64::from(n), 300 * 40).unwrap();
            let error = (rings.rms_slope() / spectrum.rms_slope() - 1.0).abs();
            prop_assert!(error < 1.0 / f64::from(n * n), "{error}");
        }
    }
}
