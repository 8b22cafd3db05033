//! Ting's solution for a paraboloid driven in and out at constant speed.

use crate::material::Relaxation;
use crate::numerics::{quadrature, root};

/// A paraboloid pressed into a Prony half-space at the speed v for the time T, then withdrawn at the same speed.
///
/// While the contact grows F = 2√R v^{3/2} ∫₀ᵗ E*(t−s)√s ds (Lee & Radok 1960); while it shrinks the
/// integral ends at t₁(t), where ∫_{t₁}^t E*(t−s)ḋ ds = 0 (Ting 1966), here K(t−t₁) = 2K(t−T) with
/// K(t) = ∫₀ᵗE* ds, and a² = R v t₁.
/// Check: E* = 0.4 + 3.6e^{−t/0.2}, R = 1, v = 0.01, T = 1 has F(1.1) = 6.847747e-4.
#[derive(Debug, Clone)]
pub struct Triangle {
    /// E*(t), without a dashpot.
    pub relaxation: Relaxation,
    /// Radius of curvature R [m].
    pub radius: f64,
    /// Speed v [m/s].
    pub speed: f64,
    /// Time of the turn T [s].
    pub turn: f64,
}

impl Triangle {
    /// Force [N] and contact radius [m] at the time `t` [s]; zero once the bodies have parted.
    #[must_use]
    pub fn at(&self, t: f64) -> (f64, f64) {
        let touched = if t <= self.turn { t } else { self.touched(t) };
        if touched <= 0.0 {
            return (0.0, 0.0);
        }
        // s = y²: √s ds = 2y² dy.
        let shortest = self.relaxation.terms.iter().map(|term| term.1).fold(t, f64::min);
        let longest = (0.25 * shortest).min(0.1 * t) / touched.sqrt();
        let integrand = |y: f64| 2.0 * y * y * self.modulus(t - y * y);
        let integral = quadrature::equal_panels(integrand, (0.0, touched.sqrt()), longest);
        (2.0 * self.radius.sqrt() * self.speed.powf(1.5) * integral, (self.radius * self.speed * touched).sqrt())
    }

    /// Time [s] at which the bodies part: K(t) = 2K(t−T).
    #[must_use]
    pub fn parting(&self) -> f64 {
        let left = |t: f64| self.gathered(t) - 2.0 * self.gathered(t - self.turn);
        root::brent(left, self.turn, 2.0 * self.turn).unwrap_or(2.0 * self.turn)
    }

    /// t₁ [s]; not above zero once the bodies have parted.
    fn touched(&self, t: f64) -> f64 {
        let left = |s: f64| self.gathered(t - s) - 2.0 * self.gathered(t - self.turn);
        if left(0.0) <= 0.0 {
            return 0.0;
        }
        root::brent(left, 0.0, self.turn).unwrap_or(0.0)
    }

    fn modulus(&self, t: f64) -> f64 {
        let decaying = self.relaxation.terms.iter().map(|(modulus, time)| modulus * (-t / time).exp());
        self.relaxation.equilibrium + decaying.sum::<f64>()
    }

    /// K(t) = ∫₀ᵗ E* ds.
    fn gathered(&self, t: f64) -> f64 {
        let decayed = self.relaxation.terms.iter().map(|(modulus, time)| -modulus * time * (-t / time).exp_m1());
        self.relaxation.equilibrium * t + decayed.sum::<f64>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle(equilibrium: f64, terms: &[(f64, f64)]) -> Triangle {
        let relaxation = Relaxation { equilibrium, terms: terms.to_vec(), viscosity: 0.0 };
        Triangle { relaxation, radius: 1.0, speed: 0.01, turn: 1.0 }
    }

    fn near(value: f64, right: f64, digits: f64) {
        assert!((value / right - 1.0).abs() < digits, "{value} {right}");
    }

    /// Numbers of sixteen digits, made with thirty; a parting time of six and a second solid of ten and eight digits.
    #[test]
    fn references() {
        let fast = triangle(0.4, &[(3.6, 0.2)]);
        near(fast.at(1.0).0, 0.001_806_718_005_259_622, 1e-14);
        near(fast.at(1.1).0, 6.847_747_151_480_37e-4, 1e-14);
        // The integral ends at t₁, which is known to rounding over its distance from the parting.
        near(fast.at(1.2).0, 9.472_904_613_700_438e-5, 1e-13);
        near(fast.parting(), 1.246_44, 5e-6);
        near(triangle(2.0, &[(2.0, 0.2)]).at(1.3).0, 0.001_202_474_851_197_649, 1e-13);
        near(triangle(0.04, &[(3.96, 0.01)]).at(1.0).0, 1.321_353_228_636_076e-4, 1e-13);
        let two = triangle(1.0, &[(3.0, 0.3), (2.0, 5.0)]);
        near(two.at(0.5).0, 0.002_171_497_338, 5e-10);
        near(two.at(1.2).0, 0.002_530_129_213, 5e-10);
        near(two.at(1.4).0, 0.000_916_887_196, 1e-9);
        near(two.at(1.4).1, (0.01 * 0.406_330_48f64).sqrt(), 1e-8);
    }
}
