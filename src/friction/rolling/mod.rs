//! Steady rolling with traction: how much a driven or braked body creeps, and what it transmits.
//!
//! A body that rolls with a tangential force T goes by the creepage ξ further on its own surface than on the other one.
//! Material comes in at the leading edge without strain, sticks, is strained the more the further it gets, and slips in
//! the end. Under Coulomb's law with the coefficient μ and the normal force P a traction curve is
//!
//! > T/(μP) = 1 − (1 − |ξ|/ξₛ)ⁿ,   |ξ| ≤ ξₛ;   T = μP beyond,
//!
//! with n = 2 for a cylinder (Carter 1926) and n = 3 for a ball on its one-dimensional bed; the stick zone of the width
//! 2a(1 − |ξ|/ξₛ) lies at the leading edge. Bodies have to be elastically similar.
//!
//! # Examples
//! ```
//! use springbed::friction::Grip;
//! use springbed::friction::rolling::{RollingContact, carter};
//!
//! // E* = R = 1, a = 0.01: P = πE*a²/4R per length; half of μP goes at ξ = (μa/R)(1 − √½).
//! let grip = Grip { normal_modulus: 1.0, tangential_modulus: 1.0, coefficient: 0.3 };
//! let force = 0.25 * std::f64::consts::PI * 1e-4;
//! let law = carter::law(&RollingContact { grip, radius: 1.0, half_width: 0.01, force });
//! let creepage = law.creepage(0.5 * 0.3 * force).unwrap();
//! assert!((creepage / (0.3 * 0.01 * (1.0 - 0.5f64.sqrt())) - 1.0).abs() < 1e-14);
//! assert!((law.traction(creepage) / (0.15 * force) - 1.0).abs() < 1e-14 && law.creepage(force).is_none());
//! ```

pub mod ball;
pub mod carter;
pub mod kalker;

use super::Grip;
use std::f64::consts::PI;

/// A contact that rolls, as its normal force has made it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollingContact {
    /// Moduli and coefficient of friction.
    pub grip: Grip,
    /// Radius of curvature R [m] of both bodies together.
    pub radius: f64,
    /// Half width, or radius, a of the contact [m].
    pub half_width: f64,
    /// Normal force P [N].
    pub force: f64,
}

impl RollingContact {
    /// Largest tangential force μP [N].
    #[must_use]
    pub fn limit(&self) -> f64 {
        self.grip.coefficient * self.force
    }
}

/// A traction curve T/(μP) = 1 − (1 − |ξ|/ξₛ)ⁿ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CreepLaw {
    /// Largest tangential force μP [N].
    pub limit: f64,
    /// Creepage ξₛ from which on all slips.
    pub full_slip: f64,
    /// Exponent n.
    pub order: i32,
}

/// Part by which a force may lie above μP and still stand for it: numbers in a scene are rounded.
const ROUNDED: f64 = 1e-9;

impl CreepLaw {
    /// Part of the contact that slips, |ξ|/ξₛ up to 1.
    #[must_use]
    pub fn slipping(&self, creepage: f64) -> f64 {
        if creepage.abs() < self.full_slip { creepage.abs() / self.full_slip } else { 1.0 }
    }

    /// Tangential force T [N] at a creepage ξ, of its sign.
    #[must_use]
    pub fn traction(&self, creepage: f64) -> f64 {
        let slips = self.slipping(creepage);
        let sticks = 1.0 - slips;
        // 1 − (1 − s)ⁿ = s Σ (1 − s)ᵏ, without cancellation.
        let sum: f64 = (0..self.order).map(|power| sticks.powi(power)).sum();
        (self.limit * slips * sum).copysign(creepage)
    }

    /// Creepage ξ at a tangential force T [N], of its sign; the least one of all at T = μP, `None` above it.
    #[must_use]
    pub fn creepage(&self, traction: f64) -> Option<f64> {
        if traction.abs() > self.limit * (1.0 + ROUNDED) {
            return None;
        }
        if self.limit <= 0.0 {
            return Some(0.0);
        }
        let part = (traction.abs() / self.limit).min(1.0);
        let slips = -((-part).ln_1p() / f64::from(self.order)).exp_m1();
        Some((self.full_slip * slips).copysign(traction))
    }

    /// Creep stiffness dT/dξ [N] at small creepages, nμP/ξₛ.
    #[must_use]
    pub fn stiffness(&self) -> f64 {
        f64::from(self.order) * self.limit / self.full_slip
    }
}

/// What a place of the contact carries, in the direction of rolling.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollingPlace {
    /// Place x [m]; the leading edge is at a.
    pub place: f64,
    /// Pressure p [Pa] of a cylinder; line load [N/m] of the bed of a ball.
    pub normal: f64,
    /// Shear stress [Pa] of a cylinder, line load along the surface [N/m] of the bed of a ball; of the sign of the creepage.
    pub tangential: f64,
    /// Speed of slip [m/s], of the sign of the creepage.
    pub slip: f64,
}

/// Pieces of a zone that sticks or slips.
const PIECES: u32 = 32;

/// Places [m] from the trailing edge −a to the leading one, dense at the edges and at the border of stick `border`.
fn places(half_width: f64, border: f64) -> Vec<f64> {
    let between = |low: f64, high: f64| {
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
        let inner = (1..PIECES).map(move |k| middle - half * (PI * f64::from(k) / f64::from(PIECES)).cos());
        std::iter::once(low).chain(inner).chain([high]).filter(move |_| high > low)
    };
    let mut places: Vec<f64> = between(-half_width, border).chain(between(border, half_width)).collect();
    places.dedup();
    places
}
