//! Independent summits of one curvature and Gaussian heights.

use crate::numerics::root::{self, RootError};
use crate::shape::rough::Roughness;
use std::f64::consts::{PI, TAU};

/// ∫_h^∞ φ(z) (z − h)ⁿ dz for the standard normal density φ, any real n > −1 and finite h.
///
/// Computed as φ(h) ∫₀^∞ sⁿ e^{−hs−s²/2} ds, a sum of positive terms without cancellation however large h
/// (Greenwood & Williamson 1966; Popov, Contact Mechanics and Friction, eqs. 7.5–7.7).
/// By hand: n = 1, h = 0 gives 1/√(2π); n = 0, h = 0 gives 1/2. Relative error below 1e-13 for |h| ≤ 20;
/// the value leaves the range of numbers beyond h ≈ 38.
#[must_use]
pub fn gaussian_tail(n: f64, h: f64) -> f64 {
    (-0.5 * h * h).exp() / TAU.sqrt() * laplace_moment(n, h)
}

/// ∫₀^∞ sⁿ e^{−hs−s²/2} ds by the trapezium rule in u with s = scale·e^{u − e^{−u}}: both ends die double-exponentially.
fn laplace_moment(n: f64, h: f64) -> f64 {
    // Where the integrand is largest or, for large h, the decay length (n + 1)/h.
    let scale = 2.0 * (n + 1.0) / (h + (h * h + 4.0 * (n + 1.0)).sqrt());
    // For h < 0 the bump at s = −h has relative width 1/|h|: the step follows it.
    let step = 1.0 / (24.0 * (1.0 - h.min(0.0)).max(1.0));
    let term = |k: i32| {
        let u = f64::from(k) * step;
        let fall = (-u).exp();
        let s = scale * (u - fall).exp();
        // sⁿ ds = s^{n+1} (1 + e^{−u}) du; one exponential, so that 0·∞ cannot arise.
        ((n + 1.0) * (scale.ln() + u - fall) - s * (h + 0.5 * s)).exp() * (1.0 + fall)
    };
    #[expect(clippy::cast_possible_truncation, reason = "a few thousand steps")]
    let (first, last) = ((-5.0 / step) as i32, (6.0 / step) as i32);
    step * (first..=last).map(term).sum::<f64>()
}

/// Summits of an isotropic Gaussian surface from the moments of its spectrum (Nayak 1971, McCool 1987).
///
/// With profile moments m₀ = ⟨z²⟩, m₂ = ⟨z_x²⟩, m₄ = ⟨z_xx²⟩ and bandwidth α = m₀m₄/m₂² ≥ 3/2:
/// density m₄/(6π√3 m₂), mean curvature (8/3)√(m₄/π), summit height variance m₀[1 − (1 − 3√3 + 16/π)/α]
/// about a mean 4√(m₀/(πα)) above the surface mean. 1 − 3√3 + 16/π = 0.896806….
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SummitStatistics {
    /// Summits per area η [1/m²].
    pub density: f64,
    /// Radius R [m], the inverse of the mean curvature of the summits.
    pub radius: f64,
    /// Standard deviation of summit heights σ_s [m].
    pub deviation: f64,
    /// Mean height [m] of the summits above the mean plane of the surface.
    pub mean_height: f64,
    /// Bandwidth α = m₀m₄/m₂².
    pub bandwidth: f64,
}

impl SummitStatistics {
    /// The summits of an isotropic surface: m₀ = ⟨h²⟩, m₂ = ⟨|∇h|²⟩/2, m₄ = (3/8)⟨(∇²h)²⟩, κ = ∇²h/2.
    #[must_use]
    pub fn of(roughness: &Roughness) -> Self {
        let Roughness { rms_height, rms_slope, rms_curvature, .. } = *roughness;
        Self::from_moments(rms_height * rms_height, 0.5 * rms_slope * rms_slope, 1.5 * rms_curvature * rms_curvature)
    }

    /// The summits of an isotropic Gaussian surface with profile moments m₀ [m²], m₂ [1] and m₄ [1/m²].
    #[must_use]
    pub fn from_moments(m0: f64, m2: f64, m4: f64) -> Self {
        let bandwidth = (m0 / m2) * (m4 / m2);
        let summits = 1.0 - 3.0 * 3f64.sqrt() + 16.0 / PI;
        Self {
            density: m4 / m2 / (6.0 * PI * 3f64.sqrt()),
            radius: 0.375 * (PI / m4).sqrt(),
            deviation: (m0 * (1.0 - summits / bandwidth)).sqrt(),
            mean_height: 4.0 * (m0 / (PI * bandwidth)).sqrt(),
            bandwidth,
        }
    }
}

/// Greenwood–Williamson contact: independent summits, no coupling between them.
///
/// Wrong for surfaces with many scales: area proportional to load over a vanishing range only (Persson et al. 2008, appendix A).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GreenwoodWilliamson {
    /// The summits.
    pub summits: SummitStatistics,
    /// Effective modulus E* [Pa].
    pub modulus: f64,
}

impl GreenwoodWilliamson {
    fn tail(&self, n: f64, separation: f64) -> f64 {
        let s = &self.summits;
        s.deviation.powf(n) * gaussian_tail(n, (separation - s.mean_height) / s.deviation)
    }

    /// Touching summits per nominal area [1/m²] at a separation [m] of the mean plane from the flat.
    #[must_use]
    pub fn summits_in_contact(&self, separation: f64) -> f64 {
        self.summits.density * self.tail(0.0, separation)
    }

    /// Real over nominal area, πηR ∫(z − h)φ dz.
    #[must_use]
    pub fn area_fraction(&self, separation: f64) -> f64 {
        PI * self.summits.density * self.summits.radius * self.tail(1.0, separation)
    }

    /// Nominal pressure [Pa], (4/3)ηE*√R ∫(z − h)^{3/2} φ dz.
    #[must_use]
    pub fn pressure(&self, separation: f64) -> f64 {
        4.0 / 3.0 * self.summits.density * self.modulus * self.summits.radius.sqrt() * self.tail(1.5, separation)
    }

    /// Separation [m] at a nominal pressure [Pa].
    ///
    /// # Errors
    /// It lies beyond 30 deviations, where next to no summit is left.
    pub fn separation(&self, pressure: f64) -> Result<f64, RootError> {
        let s = &self.summits;
        let at = |h: f64| s.mean_height + h * s.deviation;
        let h = root::brent(|h| (self.pressure(at(h)) / pressure).ln(), -30.0, 30.0)?;
        Ok(at(h))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// 25-digit references at h = 1, 2, 3 for n = 1 and 3/2, given to 12 digits.
    #[test]
    fn tails_are_the_reference_numbers() {
        let known = [
            (1.0, 0.083_315_470_587_7, 0.075_668_177_391),
            (2.0, 0.008_490_702_616_83, 0.006_648_177_623_59),
            (3.0, 0.000_382_154_317_048, 0.000_263_967_554_269),
        ];
        for (h, first, root) in known {
            assert!((gaussian_tail(1.0, h) / first - 1.0).abs() < 2e-12, "{h}");
            // 0.075668177391 has 11 significant digits: half a unit is 7e-12.
            assert!((gaussian_tail(1.5, h) / root - 1.0).abs() < 8e-12, "{h}");
        }
    }

    proptest! {
        /// n = 0 is ½erfc(h/√2); the recursion I_{n+1} = n I_{n−1} − h I_n (parts) holds; dI_n/dh = −n I_{n−1} by construction.
        #[test]
        fn tails_obey_their_laws(k in -150i32..300, half in 1i32..6) {
            let (h, n) = (0.05 * f64::from(k), 0.5 * f64::from(half));
            let exact = 0.5 * libm::erfc(h / 2f64.sqrt());
            // erfc is conditioned as h² in its argument: h²ε.
            prop_assert!((gaussian_tail(0.0, h) / exact - 1.0).abs() < 1e-13 + 4e-16 * h * h, "{h}");
            let (below, here, above) = (gaussian_tail(n - 0.5 - 0.4, h), gaussian_tail(n + 0.1, h), gaussian_tail(n + 1.1, h));
            let sum = (n + 0.1) * below - h * here;
            // The recursion cancels for large positive h, by h²/n.
            prop_assert!((sum / above - 1.0).abs() < 1e-12 * (1.0 + h * h), "{h} {n} {}", sum / above - 1.0);
        }
    }

    /// A Gaussian-like narrow band has α = 3/2 (all waves of one length): the summits then spread by m₀(1 − 0.8968/1.5).
    #[test]
    fn one_wavelength_is_the_narrowest_band() {
        // Waves of the wavevector 2 [1/m]: ⟨|∇h|²⟩ = 4⟨h²⟩, ⟨(∇²h)²⟩ = 16⟨h²⟩.
        let waves = Roughness { rms_height: 3.0, rms_slope: 6.0, rms_curvature: 6.0, peak_to_valley: None };
        assert!((SummitStatistics::of(&waves).bandwidth - 1.5).abs() < 1e-15);
        let m = SummitStatistics::from_moments(2.0, 3.0, 6.75);
        assert!((m.bandwidth - 1.5).abs() < 1e-15);
        assert!((m.deviation - (2.0f64 * (1.0 - 0.896_806 / 1.5)).sqrt()).abs() < 1e-6);
    }

    /// The separation gives back its pressure, and area over pressure is nearly constant.
    #[test]
    fn area_follows_the_pressure() {
        let summits =
            SummitStatistics { density: 1e10, radius: 1e-5, deviation: 1e-7, mean_height: 0.0, bandwidth: 10.0 };
        let gw = GreenwoodWilliamson { summits, modulus: 1e11 };
        for k in 0..40 {
            let h = 1e-8 * f64::from(k);
            // The pressure falls by e over a quarter of a deviation at most.
            assert!((gw.separation(gw.pressure(h)).unwrap() - h).abs() < 1e-12 * 1e-7, "{h}");
        }
        let ratio = |h: f64| gw.area_fraction(h) / gw.pressure(h);
        assert!((ratio(3e-7) / ratio(2e-7) - 1.0).abs() < 0.2);
        assert!(gw.summits_in_contact(0.0) > 0.49e10 && gw.summits_in_contact(0.0) < 0.51e10);
    }
}
