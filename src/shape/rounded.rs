//! Cone with a rounded tip and flat punch with a rounded edge.

use super::kernel::{OutsideKink, arc_minus_sine, root_of_difference, sine_minus_arc_cosine};
use super::paraboloid;
use super::{Profile, flank};
use crate::input::quantity::{HalfAngle, Length, Positive};
use crate::numerics::root;
use serde::{Deserialize, Deserializer, Serialize};
use std::f64::consts::{FRAC_1_PI, FRAC_2_PI};

/// Cone with a rounded tip: f(r) = r²/2R up to b = Rt, then t(r − b/2).
///
/// g(x) = x²/R up to b, then (x/R)[b²/(x+√(x²−b²)) + b arccos(b/x)]. R is the radius of the tip [m], t
/// the slope of the flank (Ciavarella 1999; Popov, Heß & Willert 2019, ch. 2). With b → 0 it is the
/// cone, with b → ∞ the paraboloid. Check: R = 1, t = 0.3, x = 0.6 gives
/// g = 0.36 − 0.6·√0.27 + 0.06π = 0.236726413853.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct RoundedCone {
    /// Radius of curvature of the tip.
    pub radius: Length,
    /// Slope of the flank, rise over run; a scene may give the angle between axis and flank instead, `half_angle`.
    pub slope: Positive,
}

impl<'de> Deserialize<'de> for RoundedCone {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        /// As a scene writes it.
        #[derive(Deserialize)]
        #[serde(rename = "RoundedCone", deny_unknown_fields)]
        struct Written {
            radius: Length,
            slope: Option<Positive>,
            half_angle: Option<HalfAngle>,
        }
        let Written { radius, slope, half_angle } = Written::deserialize(deserializer)?;
        Ok(Self { radius, slope: flank::slope("RoundedCone", slope, half_angle)? })
    }
}

/// Flat punch with a rounded edge: f(r) = (r−b)₊²/2R.
///
/// g(x) = (x/R)[√(x²−b²) − b arccos(b/x)] for x > b, else 0. b is the radius of the flat [m], R the
/// radius of curvature of the edge [m] (Schubert 1942; Ciavarella 1999; Popov, Heß & Willert 2019,
/// ch. 2). The edge is a parabola, so a − b ≪ R is required. With b → 0 it is the paraboloid.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct RoundedPunch {
    /// Radius of the flat.
    pub flat_radius: Length,
    /// Radius of curvature of the edge.
    pub edge_radius: Length,
}

impl RoundedCone {
    /// b = Rt, where the tip meets the flank.
    fn blend(&self) -> f64 {
        self.radius.si() * self.slope.si()
    }

    /// g′(x) beyond b: (2b²/(x+q) + b arccos(b/x))/R, with b/R = t.
    fn outer_slope(&self, x: f64, q: f64) -> f64 {
        let b = self.blend();
        self.slope.si() * (2.0 * b / (x + q) + q.atan2(b))
    }

    /// N(x) beyond b: (2/3)(x³−q³)/R + (t/2)(x² arccos(b/x) − bq).
    fn outer_load(&self, x: f64, q: f64) -> f64 {
        let (t, b) = (self.slope.si(), self.blend());
        let cubes = b * (x * x + x * q + q * q) / (x + q);
        // x²φ − bq = x²(φ − sin φ cos φ)
        t * (2.0 / 3.0 * cubes + 0.25 * x * x * arc_minus_sine(2.0 * q.atan2(b)))
    }
}

impl Profile for RoundedCone {
    fn height(&self, r: f64) -> f64 {
        let b = self.blend();
        if r < b { 0.5 * r * (r / self.radius.si()) } else { self.slope.si() * (r - 0.5 * b) }
    }

    fn reduced(&self, x: f64) -> f64 {
        let b = self.blend();
        if x < b {
            return x * (x / self.radius.si());
        }
        let q = root_of_difference(x, b);
        self.slope.si() * x * (b / (x + q) + q.atan2(b))
    }

    fn reduced_slope(&self, x: f64) -> f64 {
        let b = self.blend();
        if x < b { 2.0 * x / self.radius.si() } else { self.outer_slope(x, root_of_difference(x, b)) }
    }

    fn load_integral(&self, a: f64) -> f64 {
        let b = self.blend();
        if a < b { 2.0 / 3.0 * a * self.reduced(a) } else { self.outer_load(a, root_of_difference(a, b)) }
    }

    fn energy_integral(&self, a: f64) -> f64 {
        let b = self.blend();
        let inner = a.min(b);
        let tip = 8.0 / 15.0 * inner * (inner * (inner / self.radius.si())).powi(2);
        tip + OutsideKink(b).energy(|x, q| q * self.outer_slope(x, q), |x, q| self.outer_load(x, q), a)
    }

    fn pressure_integral(&self, r: f64, a: f64) -> f64 {
        let b = self.blend();
        let tip = 2.0 * FRAC_1_PI / self.radius.si() * root_of_difference(a.min(b), r);
        tip + OutsideKink(b).pressure(|x, q| q * self.outer_slope(x, q), r, a)
    }

    fn displacement_integral(&self, r: f64, a: f64) -> f64 {
        let b = self.blend();
        let tip = paraboloid::displacement(self.radius.si(), r, a.min(b));
        tip + OutsideKink(b).displacement(|x, q| q * self.outer_slope(x, q), r, a)
    }

    fn edge(&self, d: f64) -> Option<f64> {
        let b = self.blend();
        let inner = self.radius.si().sqrt() * d.max(0.0).sqrt();
        if inner <= b {
            return Some(inner);
        }
        // The paraboloid is steeper, g ≤ x²/R; the cone cut off at b is flatter, g ≥ (π/2)t(x−b).
        Some(root::within(|x| self.reduced(x) - d, inner, b + FRAC_2_PI * d / self.slope.si()))
    }

    fn scale(&self) -> f64 {
        self.blend()
    }

    fn kink(&self) -> Option<f64> {
        Some(self.blend())
    }
}

impl RoundedPunch {
    fn beyond(&self) -> OutsideKink {
        OutsideKink(self.flat_radius.si())
    }

    fn at(&self, x: f64) -> (f64, f64) {
        (x.max(self.flat_radius.si()), root_of_difference(x, self.flat_radius.si()))
    }

    /// √(x²−b²) − b arccos(b/x) = x(sin φ − φ cos φ) with cos φ = b/x.
    fn rise(&self, x: f64, q: f64) -> f64 {
        x * sine_minus_arc_cosine(q.atan2(self.flat_radius.si()))
    }

    /// g′(x) = (2√(x²−b²) − b arccos(b/x))/R.
    fn outer_slope(&self, x: f64, q: f64) -> f64 {
        (q + self.rise(x, q)) / self.edge_radius.si()
    }

    /// N(x) = [(2/3)q³ − (b/2)(x² arccos(b/x) − bq)]/R.
    fn outer_load(&self, x: f64, q: f64) -> f64 {
        let b = self.flat_radius.si();
        let angle = 0.25 * b * x * x * arc_minus_sine(2.0 * q.atan2(b));
        (2.0 / 3.0 * q * q * q - angle) / self.edge_radius.si()
    }
}

impl Profile for RoundedPunch {
    fn height(&self, r: f64) -> f64 {
        let beyond = (r - self.flat_radius.si()).max(0.0);
        0.5 * beyond * (beyond / self.edge_radius.si())
    }

    fn reduced(&self, x: f64) -> f64 {
        let (x, q) = self.at(x);
        x / self.edge_radius.si() * self.rise(x, q)
    }

    fn reduced_slope(&self, x: f64) -> f64 {
        let (x, q) = self.at(x);
        self.outer_slope(x, q)
    }

    fn load_integral(&self, a: f64) -> f64 {
        let (a, q) = self.at(a);
        self.outer_load(a, q)
    }

    fn energy_integral(&self, a: f64) -> f64 {
        self.beyond().energy(|x, q| q * self.outer_slope(x, q), |x, q| self.outer_load(x, q), a)
    }

    fn pressure_integral(&self, r: f64, a: f64) -> f64 {
        self.beyond().pressure(|x, q| q * self.outer_slope(x, q), r, a)
    }

    fn displacement_integral(&self, r: f64, a: f64) -> f64 {
        self.beyond().displacement(|x, q| q * self.outer_slope(x, q), r, a)
    }

    fn edge(&self, d: f64) -> Option<f64> {
        let (b, depth) = (self.flat_radius.si(), d.max(0.0));
        // g is at least (x−b)²/R·(2/3) and at most x²/R.
        let low = b.max((self.edge_radius.si() * depth).sqrt());
        let high = b + (1.5 * self.edge_radius.si() * depth).sqrt() + f64::EPSILON * b;
        Some(root::within(|x| self.reduced(x) - depth, low, high))
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
