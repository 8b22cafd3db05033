//! Ting's solution for a paraboloid driven in and out at constant speed.
//!
//! # Examples
//! ```
//! use springbed::check::ting::TingTriangle;
//! use springbed::material::Relaxation;
//!
//! // An elastic body pressed for a second and withdrawn carries nothing when the indenter is back.
//! let relaxation = Relaxation { equilibrium: 1.0, terms: Vec::new(), viscosity: 0.0 };
//! let triangle = TingTriangle { relaxation, radius: 1.0, speed: 1.0, turn: 1.0 };
//! assert!((triangle.at(1.0)?.0 - 4.0 / 3.0).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error + Send + Sync>>(())
//! ```

use super::case::Attempt;
use crate::material::Relaxation;
use crate::numerics::{quadrature, root};

/// A paraboloid driven to v·T and back at the same speed: d = v·min(t, 2T − t).
///
/// While the contact grows (Lee & Radok 1960) F(t) = (4/3)√R ∫₀^t E*(t−s) d(d^{3/2}); after the turn
/// (Ting 1966) the integral ends at t₁, ∫_{t₁}^t E*(t−s) ḋ ds = 0, and a(t) = a(t₁).
/// Check: E* = 0.4 + 3.6e^{−t/0.2}, R = 1, v = 0.01, T = 1 has F(1.1) = 6.847747e-4.
#[derive(Debug, Clone)]
pub struct TingTriangle {
    /// Relaxation E*(t), without a dashpot.
    pub relaxation: Relaxation,
    /// Radius R [m].
    pub radius: f64,
    /// Speed v [m/s].
    pub speed: f64,
    /// Time T of the turn [s].
    pub turn: f64,
}

impl TingTriangle {
    /// Force [N] and contact radius [m] at a time [s].
    ///
    /// # Errors
    /// The root t₁ cannot be enclosed.
    pub fn at(&self, t: f64) -> Attempt<(f64, f64)> {
        let touched = if t <= self.turn { t } else { self.touched(t)? };
        Ok((self.force(t, touched), (self.radius * self.speed * touched).sqrt()))
    }

    /// When the force vanishes [s]; 2T if the bodies part with the depth.
    ///
    /// # Errors
    /// The root cannot be enclosed.
    pub fn parting(&self) -> Attempt<f64> {
        let left = |t: f64| self.gathered(t) - 2.0 * self.gathered(t - self.turn);
        if left(2.0 * self.turn) >= 0.0 {
            return Ok(2.0 * self.turn);
        }
        Ok(root::brent(left, self.turn, 2.0 * self.turn)?)
    }

    /// t₁, at which the radius was what it is at t > T: I(t − t₁) = 2I(t − T) with I the primitive of E*.
    fn touched(&self, t: f64) -> Attempt<f64> {
        let since = t - self.turn;
        // In the lag beyond t − T, which may be far shorter than t.
        let left = |lag: f64| self.gathered(since + lag) - 2.0 * self.gathered(since);
        if left(self.turn) <= 0.0 {
            return Ok(0.0);
        }
        Ok(self.turn - root::brent(left, 0.0, self.turn)?)
    }

    /// (4/3)√R ∫₀^last E*(t−s) d(d^{3/2}), in panels that shrink towards s = last; towards s = 0 the root is taken away.
    #[must_use]
    pub fn force(&self, t: f64, last: f64) -> f64 {
        if last <= 0.0 {
            return 0.0;
        }
        let near = |lag: f64| self.modulus((t - last) + lag) * (last - lag).max(0.0).sqrt();
        let breaks: Vec<f64> = (1..=60).rev().map(|k| last * 0.5f64.powi(k)).collect();
        let far = |root: f64| 2.0 * root * root * self.modulus(t - root * root);
        let half = 0.5 * last;
        let integral = quadrature::panels(near, (0.0, half), &breaks) + quadrature::panel(far, 0.0, half.sqrt());
        2.0 * self.radius.sqrt() * self.speed.powf(1.5) * integral
    }

    /// E*(t) [Pa].
    #[must_use]
    pub fn modulus(&self, t: f64) -> f64 {
        let decaying = self.relaxation.terms.iter().map(|(modulus, time)| modulus * (-t / time).exp());
        self.relaxation.equilibrium + decaying.sum::<f64>()
    }

    /// I(t) = ∫₀^t E* [Pa s].
    fn gathered(&self, t: f64) -> f64 {
        let decayed = self.relaxation.terms.iter().map(|(modulus, time)| -modulus * time * (-t / time).exp_m1());
        self.relaxation.equilibrium * t + decayed.sum::<f64>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle(equilibrium: f64, terms: &[(f64, f64)]) -> TingTriangle {
        let relaxation = Relaxation { equilibrium, terms: terms.to_vec(), viscosity: 0.0 };
        TingTriangle { relaxation, radius: 1.0, speed: 0.01, turn: 1.0 }
    }

    fn near(value: f64, right: f64, digits: f64) {
        assert!((value / right - 1.0).abs() < digits, "{value} {right}");
    }

    /// Numbers of sixteen digits, made with thirty; a parting time of six and a second solid of ten and eight digits.
    #[test]
    fn references() {
        let fast = triangle(0.4, &[(3.6, 0.2)]);
        near(fast.at(1.0).unwrap().0, 0.001_806_718_005_259_622, 1e-14);
        near(fast.at(1.1).unwrap().0, 6.847_747_151_480_37e-4, 1e-14);
        // The integral ends at t₁, which is known to rounding over its distance from the parting.
        near(fast.at(1.2).unwrap().0, 9.472_904_613_700_438e-5, 1e-13);
        near(fast.parting().unwrap(), 1.246_44, 5e-6);
        near(triangle(2.0, &[(2.0, 0.2)]).at(1.3).unwrap().0, 0.001_202_474_851_197_649, 1e-13);
        near(triangle(0.04, &[(3.96, 0.01)]).at(1.0).unwrap().0, 1.321_353_228_636_076e-4, 1e-13);
        let two = triangle(1.0, &[(3.0, 0.3), (2.0, 5.0)]);
        near(two.at(0.5).unwrap().0, 0.002_171_497_338, 5e-10);
        near(two.at(1.2).unwrap().0, 0.002_530_129_213, 5e-10);
        near(two.at(1.4).unwrap().0, 0.000_916_887_196, 1e-9);
        near(two.at(1.4).unwrap().1, (0.01 * 0.406_330_48f64).sqrt(), 1e-8);
    }
}
