//! Flat-ended cylindrical punch.

use super::{Profile, Rim};
use crate::input::quantity::Length;
use serde::{Deserialize, Serialize};

/// Flat punch f(r) = 0 for r ≤ b, infinite beyond; g(x) likewise.
///
/// b is the radius [m]; the contact radius is b at any indentation, F = 2E*bd (Boussinesq 1885;
/// Popov & Heß 2015, ch. 3) and with adhesion the punch parts at F = −√(8πE*wb³) (Kendall 1971).
/// The pressure is infinite at the sharp edge. Check: E* = 1, b = 1, d = 1 gives F = 2.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct FlatPunch {
    /// Radius.
    pub radius: Length,
}

impl Profile for FlatPunch {
    fn height(&self, r: f64) -> f64 {
        if r <= self.radius.si() { 0.0 } else { f64::INFINITY }
    }

    fn reduced(&self, x: f64) -> f64 {
        self.height(x)
    }

    fn reduced_slope(&self, x: f64) -> f64 {
        self.height(x)
    }

    fn load_integral(&self, _a: f64) -> f64 {
        0.0
    }

    fn energy_integral(&self, _a: f64) -> f64 {
        0.0
    }

    fn pressure_integral(&self, _r: f64, _a: f64) -> f64 {
        0.0
    }

    fn displacement_integral(&self, _r: f64, _a: f64) -> f64 {
        0.0
    }

    fn edge(&self, _d: f64) -> Option<f64> {
        Some(self.radius.si())
    }

    fn flat_radius(&self) -> f64 {
        self.radius.si()
    }

    fn rim(&self) -> Rim {
        Rim::Wall(self.radius.si())
    }

    fn scale(&self) -> f64 {
        self.radius.si()
    }
}
