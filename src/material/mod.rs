//! Bodies, their materials and the effective moduli of a pair.
//!
//! # Examples
//! ```
//! use springbed::material::{Relaxation, Spectrum};
//!
//! // 1 MPa + 9 MPa·exp(−t/0.1 s): E*(0) = 10 MPa, and loss and storage at ω = 1/τ.
//! let rubber = Relaxation { equilibrium: 1e6, terms: vec![(9e6, 0.1)], viscosity: 0.0 };
//! let spectrum = Spectrum::new(&rubber);
//! assert_eq!(rubber.instantaneous(), 1e7);
//! assert!((spectrum.storage(10.0) / 5.5e6 - 1.0).abs() < 1e-14 && (spectrum.loss(10.0) / 4.5e6 - 1.0).abs() < 1e-14);
//! ```

mod body;
mod layered;
mod pair;
mod power_law;
mod secular;
mod shares;
mod shear;
mod shift;
mod spectrum;
mod viscoelastic;

pub use body::{Body, Elastic, Plastic, PlasticLimit, YIELD_PRESSURE};
pub use layered::{Graded, Joint, Layer, Layered, Sheet, Stack, Under, Winkler};
pub use pair::{Joined, Pair, joined};
pub use power_law::{PowerLaw, Series, Times};
pub use shares::Shares;
pub use shift::{Shift, ShiftError, Wlf};
pub use spectrum::Element;
pub use spectrum::{Mode, Spectrum};
pub use viscoelastic::{Shear, Term, Terms, Viscoelastic};

use serde::Serialize;

/// Relaxation of the effective modulus E*(t) = E∞ + Σ Eᵢ e^(−t/τᵢ), with a parallel dashpot η [Pa s].
///
/// For a viscoelastic half-space against a rigid one, E*(t) = 2G(t)/(1−ν).
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Relaxation {
    /// E∞ [Pa].
    pub equilibrium: f64,
    /// Pairs (Eᵢ [Pa], τᵢ [s]).
    pub terms: Vec<(f64, f64)>,
    /// η [Pa s] of the parallel dashpot, in the scale of E*.
    pub viscosity: f64,
}

impl Relaxation {
    /// E*(0), the instantaneous modulus [Pa] (the dashpot apart).
    #[must_use]
    pub fn instantaneous(&self) -> f64 {
        self.equilibrium + self.terms.iter().map(|term| term.0).sum::<f64>()
    }
}
