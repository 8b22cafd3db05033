//! Paraboloid of revolution, the shape of Hertz.

use super::Profile;
use super::kernel::{root_of_difference, sine_minus_arc_cosine};
use crate::input::quantity::Length;
use serde::{Deserialize, Serialize};
use std::f64::consts::FRAC_1_PI;

/// Paraboloid of revolution f(r) = r²/2R, g(x) = x²/R.
///
/// R is the radius of curvature at the apex [m] (Popov & Heß 2015, eq. 3.10). It stands for a ball
/// while a ≪ R; for the exact ball see [`Sphere`](super::Sphere).
/// Check: R = 10 mm, d = 1 µm gives a = 0.1 mm.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Paraboloid {
    /// Radius of curvature at the apex.
    pub radius: Length,
}

/// (4/πR)∫₀^a x arcsin(x/r) dx = (r²/2πR)(sin 2θ − 2θ cos 2θ) with sin θ = a/r, r ≥ a.
pub(super) fn displacement(radius: f64, r: f64, a: f64) -> f64 {
    let theta = a.atan2(root_of_difference(r, a));
    0.5 * FRAC_1_PI * r * (r / radius) * sine_minus_arc_cosine(2.0 * theta)
}

impl Profile for Paraboloid {
    fn height(&self, r: f64) -> f64 {
        0.5 * r * (r / self.radius.si())
    }

    fn reduced(&self, x: f64) -> f64 {
        x * (x / self.radius.si())
    }

    fn reduced_slope(&self, x: f64) -> f64 {
        2.0 * x / self.radius.si()
    }

    fn load_integral(&self, a: f64) -> f64 {
        2.0 / 3.0 * a * self.reduced(a)
    }

    fn energy_integral(&self, a: f64) -> f64 {
        8.0 / 15.0 * a * self.reduced(a).powi(2)
    }

    fn pressure_integral(&self, r: f64, a: f64) -> f64 {
        2.0 * FRAC_1_PI / self.radius.si() * ((a - r) * (a + r)).sqrt()
    }

    fn displacement_integral(&self, r: f64, a: f64) -> f64 {
        displacement(self.radius.si(), r, a)
    }

    fn is_square(&self) -> bool {
        true
    }

    fn power(&self) -> Option<f64> {
        Some(2.0)
    }

    fn edge(&self, d: f64) -> Option<f64> {
        Some(self.radius.si().sqrt() * d.max(0.0).sqrt())
    }

    fn scale(&self) -> f64 {
        self.radius.si()
    }
}
