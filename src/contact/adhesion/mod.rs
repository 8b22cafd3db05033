//! Adhesion: the models as a scene names them, their equilibria and the branches of these.

mod rules;
pub mod equilibrium;
pub mod line;
pub mod range;

use crate::input::quantity::{Modulus, Positive, Speed, WorkOfAdhesion};
use serde::{Deserialize, Serialize};

/// Model of adhesion.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
pub enum Adhesion {
    /// Johnson, Kendall & Roberts: attraction of vanishing range.
    Jkr(Jkr),
    /// Maugis–Dugdale: constant attractive stress up to a finite range.
    Maugis(Maugis),
}

/// Adhesion of vanishing range.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Jkr {
    /// Work of adhesion w [J/m²].
    pub work: WorkOfAdhesion,
    /// What holds an opening edge of a viscoelastic body; needed there, refused elsewhere.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edge: Option<Edge>,
}

/// What holds the opening edge of an adhesive contact of a viscoelastic body.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
pub enum Edge {
    /// The relaxed modulus E∞: the process zone is long against the relaxation.
    Relaxed,
    /// The instantaneous modulus E(0): a process zone of length zero.
    Instantaneous,
    /// Gent & Schultz: the relaxed modulus and w·[1 + (v/v₀)ⁿ].
    Rate(Rate),
}

/// Gent–Schultz law w_eff = w·[1 + (v/v₀)ⁿ] of an edge opening at the speed v.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Rate {
    /// Reference speed v₀ [m/s].
    pub speed: Speed,
    /// Exponent n.
    pub exponent: Positive,
}

/// Constant attractive stress σ₀ up to the range w/σ₀.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Maugis {
    /// Work of adhesion w [J/m²].
    pub work: WorkOfAdhesion,
    /// Attractive stress σ₀ [Pa].
    pub stress: Modulus,
}
