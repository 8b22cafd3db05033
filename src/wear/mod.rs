//! Wear: the profile of an indenter that rubs itself away, by Archard's law.
//!
//! The depth worn per path slid is proportional to the pressure, ∂f/∂s = k_w p(r) (Archard 1953; Popov, *Contact Mechanics
//! and Friction*, ch. 17; Popov & Heß 2015, ch. 7); k_w [m²/N] is the volume worn per path and normal force. All of it
//! is taken off the indenter, k_w being that of the pair; the bodies stay elastic.
//!
//! # Which representation, and why it is stable
//! State is the depth w worn off in rings of the surface, in three dimensions; the bed keeps the part Δg that follows from
//! it. Both transforms of the method are linear: the pressure in a ring follows from the line loads q of the springs, and
//! Δg of a spring from the worn depths, and by the theorem of virtual work the matrices of both are each other's
//! transpose. With springs in cells and w in rings there is one matrix M, in closed form,
//!
//! M_ij = [√(x² − r²)] over the borders x of the cell i and r of the ring j,
//! F_j = 2 Σ_i M_ij q_i, h_i Δg_i = Σ_j M_ij w_j,
//!
//! the forces of the rings and the mean of Δg over a cell of the width h. What wears is then
//! h_i ∂g_i/∂s = 2k_w Σ_jl M_ij A_j⁻¹ M_lj q_l, A_j the areas of the rings, a symmetric operator without a negative
//! eigenvalue: the elastic energy can only fall, whatever the profile, the cells and the place where sticking ends. A pair
//! of transforms each computed for itself has no such law, and breaks down at the border of stick (Li, Forsbach & Benad
//! 2019). A cell knows of the rings inside it alone: where the contact sticks, the profile is untouched to the last bit.
//! In the continuum the operator is ½k_w|∂/∂x|, so that waves of the length λ are worn off over the path λ/(πk_wE*).
//!
//! Σ_j M_ij = h_i, so that the forces of the rings sum to F and the worn volume is k_w∫F ds to rounding, however the path
//! is cut into steps.
//!
//! The staircase of cells errs by the order h^{3/2} times ζ(−½, 1 − θ), where θ is the place of the borders of the rings
//! in the cells: they stand where that is zero, and the error left is of second order, but for the edge of the contact,
//! known within its cell.
//!
//! # Where it stops being valid
//! A slide counts from its beginning, though the contact slips as a whole only after μE*d/G*; a shaken contact is followed
//! by the mean of its cycles, of which one must wear next to nothing. The worn contact has to stay in one piece.
//!
//! # Examples
//! ```
//! use springbed::input::quantity::Length;
//! use springbed::shape::FlatPunch;
//! use springbed::wear::{Load, Motion, Start, Wearing, Worn};
//! use std::sync::Arc;
//!
//! // A punch, b = E* = 1 m and Pa, under 1 N, k_w = 1 m²/N: after a path of 20 m the pressure is the same everywhere,
//! // to what the steps leave.
//! let punch = Arc::new(FlatPunch { radius: Length::new(1.0)? });
//! let start = Start { contact_radius: 1.0, stick: None, cells: 64 };
//! let mut wearing = Wearing::new(punch, 1.0, 1.0, start);
//! wearing.begin(Motion::Slide, Load::Force(1.0), 20.0)?;
//! wearing.advance(20.0)?;
//! let worn: Worn = wearing.worn();
//! assert!((worn.volume / 20.0 - 1.0).abs() < 1e-12);
//! let flat = std::f64::consts::FRAC_1_PI;
//! assert!(wearing.surface().iter().all(|ring| (ring.pressure / flat - 1.0).abs() < 1e-3));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bed;
mod edge;
mod rings;
mod rubbing;
mod seen;
mod slips;
mod wearing;

pub use bed::Load;
pub use rings::Start;
pub use rubbing::{Rubbed, Rubbing};
pub use wearing::{Motion, Ring, Wearing, Worn};

use crate::input::quantity::WearCoefficient;
use serde::{Deserialize, Serialize};

/// Law of wear.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
pub enum Wear {
    /// Depth per path proportional to the pressure.
    Archard(Archard),
}

/// Archard's law of wear.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Archard {
    /// Volume worn per path slid and normal force, k_w [m²/N].
    pub coefficient: WearCoefficient,
}

impl Wear {
    /// The name a scene gives it.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Archard(_) => "Archard",
        }
    }
}

#[cfg(test)]
mod tests;
