//! Cone and paraboloid with a worn-off tip.

use super::kernel::{OutsideKink, root_of_difference};
use super::{Profile, flank};
use crate::input::quantity::{HalfAngle, Length, Positive};
use crate::numerics::quadrature;
use crate::numerics::root;
use serde::{Deserialize, Deserializer, Serialize};
use std::f64::consts::{FRAC_2_PI, FRAC_PI_2};

/// Truncated cone f(r) = t(r−b)₊, g(x) = t x arccos(b/x) for x > b, else 0.
///
/// b is the radius of the flat [m], t the slope of the flank (Popov & Heß 2015, ch. 3;
/// Ejike 1981). F = E*t[a² arccos(b/a) + b√(a²−b²)]. The pressure is infinite (logarithmically) at
/// r = b. Check: E* = 1, b = 0.3, t = 0.2, a = 0.6 gives d = 0.1256637061435917.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TruncatedCone {
    /// Radius of the flat.
    pub flat_radius: Length,
    /// Slope of the flank, rise over run; a scene may give the angle between axis and flank instead, `half_angle`.
    pub slope: Positive,
}

impl<'de> Deserialize<'de> for TruncatedCone {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        /// As a scene writes it.
        #[derive(Deserialize)]
        #[serde(rename = "TruncatedCone", deny_unknown_fields)]
        struct Written {
            flat_radius: Length,
            slope: Option<Positive>,
            half_angle: Option<HalfAngle>,
        }
        let Written { flat_radius, slope, half_angle } = Written::deserialize(deserializer)?;
        Ok(Self { flat_radius, slope: flank::slope("TruncatedCone", slope, half_angle)? })
    }
}

/// Truncated paraboloid f(r) = (r²−b²)₊/2R, g(x) = (x/R)√(x²−b²) for x > b, else 0.
///
/// b is the radius of the flat [m], R the radius of curvature [m] of the paraboloid cut off (Popov &
/// Heß 2015, ch. 3). F = (2E*/3R)(2a²+b²)√(a²−b²). The pressure is infinite (logarithmically) at
/// r = b. Check: E* = R = 1, b = 0.3, a = 0.6 gives d = 0.3117691453623979.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct TruncatedParaboloid {
    /// Radius of the flat.
    pub flat_radius: Length,
    /// Radius of curvature of the paraboloid.
    pub radius: Length,
}

impl TruncatedCone {
    fn beyond(&self) -> OutsideKink {
        OutsideKink(self.flat_radius.si())
    }

    /// x, √(x²−b²) and arccos(b/x); the angle is 0 on the flat.
    fn at(&self, x: f64) -> (f64, f64, f64) {
        let b = self.flat_radius.si();
        let q = root_of_difference(x, b);
        (x, q, q.atan2(b))
    }

    /// g′(x)√(x²−b²).
    fn slope_times_root(&self, q: f64) -> f64 {
        let b = self.flat_radius.si();
        self.slope.si() * (q.atan2(b) * q + b)
    }
}

/// ∫₀^U gd(u) du with gd(u) = 2 arctan tanh(u/2), for a/b = cosh U: (π/2)U − 2G + 2Ti₂(e^{−U}).
fn gudermann_integral(end: f64) -> f64 {
    if end < 1.0 {
        return quadrature::panel(|u| 2.0 * (0.5 * u).tanh().atan(), 0.0, end);
    }
    const TWICE_CATALAN: f64 = 1.831_931_188_354_438;
    let y = (-end).exp();
    let (mut power, mut odd, mut sum) = (y, 1.0, 0.0_f64);
    while power.abs() > 1e-18 {
        sum += power / (odd * odd);
        power *= -y * y;
        odd += 2.0;
    }
    FRAC_PI_2 * end - TWICE_CATALAN + 2.0 * sum
}

impl Profile for TruncatedCone {
    fn height(&self, r: f64) -> f64 {
        self.slope.si() * (r - self.flat_radius.si()).max(0.0)
    }

    fn reduced(&self, x: f64) -> f64 {
        let (x, _, phi) = self.at(x);
        self.slope.si() * x * phi
    }

    fn reduced_slope(&self, x: f64) -> f64 {
        let (_, q, phi) = self.at(x);
        if x < self.flat_radius.si() { 0.0 } else { self.slope.si() * (phi + self.flat_radius.si() / q) }
    }

    fn load_integral(&self, a: f64) -> f64 {
        let (a, q, phi) = self.at(a);
        0.5 * self.slope.si() * (a * a * phi + self.flat_radius.si() * q)
    }

    fn energy_integral(&self, a: f64) -> f64 {
        // b³t²/3 · [φ² sec³φ + 2φ sec φ tan φ + sec φ − 1 − ∫θ sec θ dθ]
        let (t, b) = (self.slope.si(), self.flat_radius.si());
        let (a, q, phi) = self.at(a);
        let angle = b * b * b * gudermann_integral((q / b).asinh());
        t * t / 3.0 * (a * a * a * phi * phi + 2.0 * phi * a * q * b + b * b * (a - b).max(0.0) - angle)
    }

    fn pressure_integral(&self, r: f64, a: f64) -> f64 {
        self.beyond().pressure(|_, q| self.slope_times_root(q), r, a)
    }

    fn displacement_integral(&self, r: f64, a: f64) -> f64 {
        self.beyond().displacement(|_, q| self.slope_times_root(q), r, a)
    }

    fn edge(&self, d: f64) -> Option<f64> {
        // (π/2)t(x−b) ≤ g(x) ≤ (π/2)t x
        let cone = FRAC_2_PI * d.max(0.0) / self.slope.si();
        let b = self.flat_radius.si();
        Some(root::within(|x| self.reduced(x) - d, b.max(cone), b + cone))
    }

    fn flat_radius(&self) -> f64 {
        self.flat_radius.si()
    }

    fn scale(&self) -> f64 {
        self.flat_radius.si()
    }

    fn kink(&self) -> Option<f64> {
        Some(self.flat_radius.si())
    }
}

impl TruncatedParaboloid {
    fn beyond(&self) -> OutsideKink {
        OutsideKink(self.flat_radius.si())
    }

    fn root(&self, x: f64) -> f64 {
        root_of_difference(x, self.flat_radius.si())
    }

    /// g′(x)√(x²−b²).
    fn slope_times_root(&self, x: f64, q: f64) -> f64 {
        (x * x + q * q) / self.radius.si()
    }
}

impl Profile for TruncatedParaboloid {
    fn height(&self, r: f64) -> f64 {
        let b = self.flat_radius.si();
        0.5 * (r - b).max(0.0) * ((r + b) / self.radius.si())
    }

    fn reduced(&self, x: f64) -> f64 {
        x / self.radius.si() * self.root(x)
    }

    fn reduced_slope(&self, x: f64) -> f64 {
        if x < self.flat_radius.si() { 0.0 } else { self.slope_times_root(x, self.root(x)) / self.root(x) }
    }

    fn load_integral(&self, a: f64) -> f64 {
        let b = self.flat_radius.si();
        (2.0 * a * a + b * b) / (3.0 * self.radius.si()) * self.root(a)
    }

    fn energy_integral(&self, a: f64) -> f64 {
        // (8a⁵ − 10ab⁴ + 2b⁵)/15R², its root a = b taken out.
        let b = self.flat_radius.si();
        let quartic = 4.0 * a * (a * (a * (a + b) + b * b) + b * b * b) - b.powi(4);
        2.0 / 15.0 * (a - b).max(0.0) * (quartic / self.radius.si() / self.radius.si())
    }

    fn pressure_integral(&self, r: f64, a: f64) -> f64 {
        self.beyond().pressure(|x, q| self.slope_times_root(x, q), r, a)
    }

    fn displacement_integral(&self, r: f64, a: f64) -> f64 {
        self.beyond().displacement(|x, q| self.slope_times_root(x, q), r, a)
    }

    fn edge(&self, d: f64) -> Option<f64> {
        // x²(x²−b²) = (Rd)²
        let (b, product) = (self.flat_radius.si(), self.radius.si() * d.max(0.0));
        Some((0.5 * (b * b + (b * b).hypot(2.0 * product))).sqrt())
    }

    fn flat_radius(&self) -> f64 {
        self.flat_radius.si()
    }

    fn scale(&self) -> f64 {
        self.radius.si()
    }

    fn kink(&self) -> Option<f64> {
        Some(self.flat_radius.si())
    }
}
