//! Contacts whose stated error is checked and which are computed in several ways, in numbers both share.

use super::ting::TingTriangle;
use crate::material::Relaxation;

/// Depth [m] of most scenes.
pub const DEPTH: f64 = 0.01;
/// Slope of the cone.
pub const SLOPE: f64 = 0.1;

fn solid(equilibrium: f64, decaying: f64, time: f64) -> Relaxation {
    Relaxation { equilibrium, terms: vec![(decaying, time)], viscosity: 0.0 }
}

/// The triangle of a standard linear solid, E* = 0.4 + 3.6e^{−t/0.2}.
pub fn triangle() -> TingTriangle {
    TingTriangle { relaxation: solid(0.4, 3.6, 0.2), radius: 1.0, speed: DEPTH, turn: 1.0 }
}

/// A force that rises and stays on a ball of E* = 1 + e^{−t}.
pub struct Creeping {
    /// Force [N].
    pub force: f64,
    /// Time in which it rises [s].
    pub rise: f64,
}

impl Creeping {
    pub fn relaxation() -> Relaxation {
        solid(1.0, 1.0, 1.0)
    }

    /// Contact radius [m] at the time `t` [s] after the rise: a³ = (3R/4) ∫ J dF with J = 1 − ½e^{−t/2}.
    pub fn radius(&self, t: f64) -> f64 {
        let delayed = (2.0 / self.rise) * (-0.5 * t).exp() * -(-0.5 * self.rise).exp_m1();
        (0.75 * self.force * (1.0 - 0.5 * delayed)).cbrt()
    }
}
