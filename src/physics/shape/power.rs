//! Power-law profiles and the cone among them.

use super::Profile;
use crate::physics::quantity::Positive;
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_1_PI, FRAC_PI_2, PI};

/// Power-law profile f(r) = c rⁿ, g(x) = κₙ c xⁿ with κₙ = √π Γ(n/2+1)/Γ(n/2+½).
///
/// c is the coefficient in SI units [m^(1−n)], n the exponent (Popov & Heß 2015, eq. 3.18).
/// Check: κ₁ = π/2, κ₂ = 2, κ₃ = 3π/4.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Power {
    /// Coefficient c in SI units.
    pub coefficient: Positive,
    /// Exponent n.
    pub exponent: Positive,
}

/// κₙ = √π Γ(n/2+1)/Γ(n/2+½), the factor by which the power n is stretched.
///
/// By the logarithms of Γ above n = 200, where Γ itself would overflow.
#[must_use]
pub fn stretch(n: f64) -> f64 {
    let (above, below) = (0.5 * n + 1.0, 0.5 * n + 0.5);
    if n > 200.0 {
        return PI.sqrt() * (libm::lgamma(above) - libm::lgamma(below)).exp();
    }
    PI.sqrt() * libm::tgamma(above) / libm::tgamma(below)
}

impl Power {
    fn factor(&self) -> f64 {
        stretch(self.exponent.si()) * self.coefficient.si()
    }
}

impl Profile for Power {
    fn height(&self, r: f64) -> f64 {
        self.coefficient.si() * r.powf(self.exponent.si())
    }

    fn reduced(&self, x: f64) -> f64 {
        self.factor() * x.powf(self.exponent.si())
    }

    fn reduced_slope(&self, x: f64) -> f64 {
        let n = self.exponent.si();
        self.factor() * n * x.powf(n - 1.0)
    }

    fn load_integral(&self, a: f64) -> f64 {
        let n = self.exponent.si();
        n / (n + 1.0) * a * self.reduced(a)
    }

    fn energy_integral(&self, a: f64) -> f64 {
        let n = self.exponent.si();
        2.0 * n * n / ((n + 1.0) * (2.0 * n + 1.0)) * a * self.reduced(a).powi(2)
    }

    fn edge(&self, d: f64) -> Option<f64> {
        Some((d.max(0.0) / self.factor()).powf(1.0 / self.exponent.si()))
    }

    fn scale(&self) -> f64 {
        let n = self.exponent.si();
        if (n - 1.0).abs() < 0.05 { 1.0 } else { self.factor().powf(1.0 / (1.0 - n)).clamp(1e-150, 1e150) }
    }
}

/// Cone f(r) = t r, g(x) = (π/2) t x.
///
/// t = tan θ is the slope of the flank against the surface (Popov & Heß 2015, eq. 3.14); valid for
/// small slopes. Check: F = (2/π) E* d²/t.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Cone {
    /// Slope of the flank, rise over run.
    pub slope: Positive,
}

impl Profile for Cone {
    fn height(&self, r: f64) -> f64 {
        self.slope.si() * r
    }

    fn reduced(&self, x: f64) -> f64 {
        FRAC_PI_2 * self.slope.si() * x
    }

    fn reduced_slope(&self, _x: f64) -> f64 {
        FRAC_PI_2 * self.slope.si()
    }

    fn load_integral(&self, a: f64) -> f64 {
        0.5 * a * self.reduced(a)
    }

    fn energy_integral(&self, a: f64) -> f64 {
        a * self.reduced(a).powi(2) / 3.0
    }

    fn pressure_integral(&self, r: f64, a: f64) -> f64 {
        FRAC_1_PI * self.reduced_slope(r) * arcosh_of_ratio(a, r)
    }

    fn edge(&self, d: f64) -> Option<f64> {
        Some(d.max(0.0) / self.reduced_slope(0.0))
    }

    fn scale(&self) -> f64 {
        1.0
    }
}

/// arcosh(a/r) for r ≤ a, without the loss of digits near r = a; infinite at r = 0.
pub(super) fn arcosh_of_ratio(a: f64, r: f64) -> f64 {
    let gap = (a - r) / r;
    (gap + (gap * (gap + 2.0)).sqrt()).ln_1p()
}
