//! Rubber friction by Persson's theory, from the spectrum of the surface in two dimensions.
//!
//! # Examples
//! ```
//! use springbed::contact::rough::PerssonGlide;
//! use springbed::material::{Relaxation, Spectrum};
//! use springbed::shape::rough::{Rings, RoughnessSpectrum};
//!
//! // Hysteresis is largest where the roughness meets the loss peak; slow and fast it goes away.
//! let roughness = RoughnessSpectrum::table(&[(6.4, 1e-12), (640.0, 1e-18)])?;
//! let rubber = Spectrum::new(&Relaxation { equilibrium: 1e6, terms: vec![(1e7, 1e-3)], viscosity: 0.0 });
//! let rings = Rings::of(&roughness, 1.0, 1000)?;
//! let theory = PerssonGlide { rings: &rings, spectrum: &rubber, pressure: 1e5 };
//! assert!(theory.coefficient(10.0) > 10.0 * theory.coefficient(1e-4));
//! assert!(theory.coefficient(10.0) > 10.0 * theory.coefficient(1e6));
//! # Ok::<(), springbed::shape::rough::RoughError>(())
//! ```

use crate::contact::viscoelastic::Spectrum;
use crate::numerics::quadrature;
use crate::shape::rough::Rings;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Rubber under a nominal pressure on a rough surface over which it glides.
///
/// μ = ½ ∫ q³ C S P ∫₀^{2π} cos φ Im[E*(qv cos φ)/p] dφ dq with P(q) = erf(1/(2√𝒢)),
/// 𝒢(q) = ⅛ ∫^q q′³ C ∫₀^{2π} |E*(q′v cos φ)/p|² dφ dq′ and S = ½ + ½P² (Persson, J. Chem. Phys. 115, 3840,
/// 2001); S is what a partial contact is less deformed. p nominal pressure [Pa], v speed [m/s], q wavevector
/// [rad/m], C its density [m⁴].
/// In full contact (P = S = 1) it is exact for the half-space; at small load it is a theory.
#[derive(Debug, Clone, Copy)]
pub struct PerssonGlide<'s> {
    /// Roughness, ring by ring.
    pub rings: &'s Rings,
    /// Material.
    pub spectrum: &'s Spectrum,
    /// Nominal pressure [Pa].
    pub pressure: f64,
}

impl PerssonGlide<'_> {
    /// Coefficient of friction μ at the speed `speed` [m/s].
    #[must_use]
    pub fn coefficient(&self, speed: f64) -> f64 {
        let (mut spread, mut sum) = (0.0, 0.0);
        for (k, variance) in self.rings.variances().iter().enumerate().skip(1) {
            let wave = self.rings.wavevector(k);
            // q³C dq of the ring, V = 2πqC dq.
            let weight = wave * wave * variance / TAU;
            let (loss, square) = self.over_angles(wave * speed);
            let own = 0.125 * weight * square;
            // The middle of the ring stands for it.
            let part = if spread + own > 0.0 { libm::erf(0.5 / (spread + 0.5 * own).sqrt()) } else { 1.0 };
            sum += 0.5 * weight * (0.5 + 0.5 * part * part) * part * loss;
            spread += own;
        }
        sum
    }

    /// ∫ cos φ Im E*(ω cos φ)/p dφ and ∫ |E*(ω cos φ)/p|² dφ over all angles.
    fn over_angles(&self, omega: f64) -> (f64, f64) {
        let quarter = |of: &dyn Fn(f64) -> f64| 4.0 * quadrature::panels(of, (0.0, FRAC_PI_2), &[]);
        let loss = quarter(&|angle| angle.cos() * self.spectrum.loss(omega * angle.cos()) / self.pressure);
        let square = quarter(&|angle| {
            let at = omega * angle.cos();
            (self.spectrum.storage(at) / self.pressure).powi(2) + (self.spectrum.loss(at) / self.pressure).powi(2)
        });
        (loss, square)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::Relaxation;
    use crate::shape::rough::RoughnessSpectrum;
    use std::f64::consts::PI;

    fn rings() -> Rings {
        Rings::of(&RoughnessSpectrum::table(&[(6.4, 1e-12), (64.0, 1e-15)]).unwrap(), 1.0, 200).unwrap()
    }

    /// Under a great pressure all is in contact: μp = ½ ∫ q³ C 4∫ cos φ E″ dφ, with E″ = ηω that is ½ η v π ∫ q⁴ C dq.
    #[test]
    fn a_dashpot_in_full_contact() {
        let spectrum = Spectrum::new(&Relaxation { equilibrium: 1.0, terms: vec![], viscosity: 2.0 });
        let (rings, pressure, speed) = (rings(), 1e9, 0.3);
        let theory = PerssonGlide { rings: &rings, spectrum: &spectrum, pressure };
        let moment = |(k, variance): (usize, &f64)| rings.wavevector(k).powi(3) * variance / TAU;
        let sum: f64 = rings.variances().iter().enumerate().map(moment).sum();
        assert!((theory.coefficient(speed) * pressure / (0.5 * 2.0 * speed * PI * sum) - 1.0).abs() < 1e-9);
    }

    /// At little load P = 1/√(π𝒢) and S = ½: μ does not depend on the pressure.
    #[test]
    fn at_little_load_the_pressure_does_not_count() {
        let spectrum = Spectrum::new(&Relaxation { equilibrium: 1e6, terms: vec![(1e7, 0.01)], viscosity: 0.0 });
        let rings = rings();
        let at = |pressure| PerssonGlide { rings: &rings, spectrum: &spectrum, pressure }.coefficient(1.0);
        assert!((at(1e-6) / at(1e-7) - 1.0).abs() < 1e-6);
        assert!(at(1e-6) > 0.0);
    }

    #[test]
    fn elastic_bodies_do_not_resist() {
        let rings = rings();
        let theory = PerssonGlide { rings: &rings, spectrum: &Spectrum::elastic(1e6), pressure: 1e3 };
        assert_eq!(theory.coefficient(1.0).to_bits(), 0);
    }
}
