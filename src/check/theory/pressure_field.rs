//! Real contact area and pressure distribution without adhesion, after Persson.

use crate::shape::rough::RoughnessSpectrum;
use std::f64::consts::{FRAC_2_SQRT_PI, PI, SQRT_2, TAU};

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

/// A rough contact at one nominal pressure, resolved up to any wavevector.
#[derive(Debug, Clone, Copy)]
pub struct PerssonContact<'a> {
    /// Power spectrum of the surface.
    pub spectrum: &'a RoughnessSpectrum,
    /// Effective modulus E* [Pa].
    pub modulus: f64,
    /// Nominal pressure p [Pa], above zero.
    pub pressure: f64,
}

impl PerssonContact<'_> {
    /// Variance of the full-contact pressure [Pa²] from waves up to q: (E*/2)² 2π∫q³C dq; rms E*s/2.
    #[must_use]
    pub fn pressure_variance(&self, wavevector: f64) -> f64 {
        let slope = TAU * self.spectrum.power_moment(3, (0.0, wavevector));
        0.25 * self.modulus * self.modulus * slope
    }

    /// Area in contact over nominal area when waves up to q [rad/m] are seen.
    #[must_use]
    pub fn area_fraction(&self, wavevector: f64) -> f64 {
        libm::erf(self.pressure / (2.0 * self.pressure_variance(wavevector)).sqrt())
    }

    /// Probability density [1/Pa] of the contact pressure σ > 0 when waves up to q are seen:
    /// [e^{−(σ−p)²/2V} − e^{−(σ+p)²/2V}]/√(2πV), V the variance; its integral is the area fraction, its first moment p.
    #[must_use]
    pub fn pressure_density(&self, stress: f64, wavevector: f64) -> f64 {
        let v = self.pressure_variance(wavevector);
        let main = (-(stress - self.pressure).powi(2) / (2.0 * v)).exp();
        // The image as a factor: exact where both are large and nearly equal.
        main * -(-2.0 * stress * self.pressure / v).exp_m1() / (TAU * v).sqrt()
    }

    /// Elastic energy per nominal area [J/m²] with waves of a share A(q)/A₀ of the surface deformed:
    /// (πE*/2) ∫ q² C A/A₀ dq (Persson 2001); exact in full contact, too large by up to a factor 2.5 at small load.
    #[must_use]
    pub fn elastic_energy(&self) -> f64 {
        let (low, high) = self.spectrum.cut_offs();
        let (octaves, mut sum) = ((high / low).ln(), 0.0);
        for k in 0..STEPS {
            let edge = |k: i32| low * (octaves * f64::from(k) / f64::from(STEPS)).exp();
            let band = (edge(k), edge(k + 1));
            sum += self.spectrum.power_moment(2, band) * self.area_fraction((band.0 * band.1).sqrt());
        }
        0.5 * PI * self.modulus * sum
    }
}

/// Bands of the energy integral; its error is of the order of (octaves per band)², 1e-5 at four decades.
const STEPS: i32 = 2000;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::quadrature;

    fn spectrum() -> RoughnessSpectrum {
        RoughnessSpectrum::table(&[(1e4, 1e-22), (1e7, 1e-22 * 1e3f64.powf(-3.6))]).unwrap()
    }

    #[test]
    fn low_and_full_contact_are_the_limits() {
        assert!((low_load_area_slope() - (8.0 / PI).sqrt()).abs() < 1e-15);
        let (modulus, slope) = (1e9, 0.1);
        assert!((area_fraction(1e2, modulus, slope) / (low_load_area_slope() * 1e-6) - 1.0).abs() < 1e-12);
        assert!((area_fraction(1e10, modulus, slope) - 1.0).abs() < 1e-15);
        let s = spectrum();
        let contact = PerssonContact { spectrum: &s, modulus: 1e9, pressure: 3e5 };
        let closed = area_fraction(3e5, 1e9, s.rms_slope());
        assert!((contact.area_fraction(1e7) / closed - 1.0).abs() < 1e-13);
    }

    /// Area and load are the moments of the distribution: quadrature over 12 standard deviations.
    #[test]
    fn the_distribution_carries_area_and_load() {
        let s = spectrum();
        for pressure in [1e4, 1e6, 1e8] {
            let contact = PerssonContact { spectrum: &s, modulus: 1e9, pressure };
            let deviation = contact.pressure_variance(1e7).sqrt();
            let breaks: Vec<f64> =
                (1..60).map(|k| 0.2 * f64::from(k) * deviation + pressure * f64::from(k) / 60.0).collect();
            let end = 12.0 * deviation + pressure;
            let moment =
                |n: i32| quadrature::panels(|x| x.powi(n) * contact.pressure_density(x, 1e7), (0.0, end), &breaks);
            assert!((moment(0) / contact.area_fraction(1e7) - 1.0).abs() < 1e-12, "{pressure}");
            assert!((moment(1) / pressure - 1.0).abs() < 1e-12, "{pressure}");
        }
    }

    /// Full contact: (πE*/2)∫q²C dq; the spectrum's integral is in closed form.
    #[test]
    fn full_contact_stores_the_spectral_energy() {
        let s = spectrum();
        let contact = PerssonContact { spectrum: &s, modulus: 1e9, pressure: 1e12 };
        let exact = 0.5 * PI * 1e9 * s.power_moment(2, (0.0, f64::MAX));
        assert!((contact.elastic_energy() / exact - 1.0).abs() < 1e-12);
    }
}
