//! Power-law profiles and the cone among them.

use super::kernel::{arcosh_of_ratio, root_of_difference};
use super::{Profile, flank};
use crate::input::quantity::{HalfAngle, Positive};
use crate::numerics::quadrature;
use serde::{Deserialize, Deserializer, Serialize};
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
/// By Stirling's series for the ratio above n = 150, before Γ itself overflows.
#[must_use]
pub fn stretch(n: f64) -> f64 {
    let (above, below) = (0.5 * n + 1.0, 0.5 * n + 0.5);
    if n > 150.0 {
        // Γ(z+½)/Γ(z) = √z(1 − 1/8z + 1/128z² + 5/1024z³ − 21/32768z⁴ − 399/262144z⁵ + 869/4194304z⁶ …)
        let y = 0.125 / below;
        let series = 1.0 - y * (1.0 - y * (0.5 + y * (2.5 - y * (2.625 + y * (49.875 - y * 54.3125)))));
        return (PI * below).sqrt() * series;
    }
    PI.sqrt() * libm::tgamma(above) / libm::tgamma(below)
}

impl Power {
    fn factor(&self) -> f64 {
        stretch(self.exponent.si()) * self.coefficient.si()
    }

    /// Ratio of radii, as a logarithm, over which 32 nodes resolve xⁿ to rounding.
    fn longest_panel(&self) -> f64 {
        (36.0 / self.exponent.si()).min(2.0)
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

    fn pressure_integral(&self, r: f64, a: f64) -> f64 {
        let n = self.exponent.si();
        if r <= 0.0 {
            let at_apex = self.reduced_slope(a) / (n - 1.0);
            return if n > 1.0 { FRAC_1_PI * at_apex } else { f64::INFINITY };
        }
        // x = r cosh u: ∫ g′(x) dx/√(x²−r²) = ∫ g′ du.
        let slope = |u: f64| (r * u.cosh()).powf(n - 1.0);
        FRAC_1_PI
            * self.factor()
            * n
            * quadrature::equal_panels(slope, (0.0, arcosh_of_ratio(a, r)), self.longest_panel())
    }

    fn power(&self) -> Option<f64> {
        Some(self.exponent.si())
    }

    fn edge(&self, d: f64) -> Option<f64> {
        Some((d.max(0.0) / self.factor()).powf(1.0 / self.exponent.si()))
    }

    fn scale(&self) -> f64 {
        let n = self.exponent.si();
        if (n - 1.0).abs() < 0.05 { 1.0 } else { self.factor().powf(1.0 / (1.0 - n)).clamp(1e-150, 1e150) }
    }

    fn breaks(&self, a: f64) -> Vec<f64> {
        // xⁿ is not smooth at 0 and sharp near a for large n: panels of a constant ratio, until what
        // is left below is (x/a)^{n+1} < 1e-13 of the whole and integrated to 1e-4.
        let panel = self.longest_panel();
        let mut breaks: Vec<f64> = (1..200)
            .map(|k| -panel * f64::from(k))
            .take_while(|&log| (self.exponent.si() + 1.0) * log > -30.0 - panel)
            .map(|log| a * log.exp())
            .collect();
        breaks.reverse();
        breaks
    }
}

/// Cone f(r) = t r, g(x) = (π/2) t x.
///
/// t = tan θ is the slope of the flank against the surface (Popov & Heß 2015, eq. 3.14); valid for
/// small slopes. Check: F = (2/π) E* d²/t.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Cone {
    /// Slope of the flank, rise over run; a scene may give the angle between axis and flank instead, `half_angle`.
    pub slope: Positive,
}

impl<'de> Deserialize<'de> for Cone {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        /// As a scene writes it.
        #[derive(Deserialize)]
        #[serde(rename = "Cone", deny_unknown_fields)]
        struct Written {
            slope: Option<Positive>,
            half_angle: Option<HalfAngle>,
        }
        let Written { slope, half_angle } = Written::deserialize(deserializer)?;
        Ok(Self { slope: flank::slope("Cone", slope, half_angle)? })
    }
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

    fn displacement_integral(&self, r: f64, a: f64) -> f64 {
        // t∫ arcsin(x/r) dx = t r[θ sin θ − (1 − cos θ)] with sin θ = a/r
        let half = 0.5 * a.atan2(root_of_difference(r, a));
        let (sine, cosine) = half.sin_cos();
        2.0 * self.slope.si() * r * sine * (2.0 * half * cosine - sine)
    }

    fn power(&self) -> Option<f64> {
        Some(1.0)
    }

    fn edge(&self, d: f64) -> Option<f64> {
        Some(d.max(0.0) / self.reduced_slope(0.0))
    }

    fn scale(&self) -> f64 {
        1.0
    }
}
