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

mod alone;
mod elastic;
mod layered;
mod pair;
mod power_law;
mod secular;
mod shares;
mod shear;
mod shift;
mod spectrum;
mod stacked;
mod viscoelastic;

pub use elastic::{Elastic, Plastic, PlasticLimit, YIELD_PRESSURE};
pub use layered::{Graded, Joint, Layer, Layered, Sheet, Stack, Under, Winkler};
pub use pair::{Joined, Pair, joined};
pub use power_law::{PowerLaw, Series, Times};
pub use shares::Shares;
pub use shift::{Shift, ShiftError, Wlf};
pub use spectrum::Element;
pub use spectrum::{Mode, Spectrum};
pub use viscoelastic::{Shear, Term, Terms, Viscoelastic};

use crate::input::quantity::Modulus;
use serde::{Deserialize, Serialize};

/// One of the two bodies.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
pub enum Body {
    /// Cannot deform.
    Rigid,
    /// Isotropic, linearly elastic half-space.
    Elastic(Elastic),
    /// Isotropic, linearly viscoelastic half-space.
    Viscoelastic(Viscoelastic),
    /// Layers on a base.
    Layered(Layered),
    /// A thin sheet of independent springs.
    Winkler(Winkler),
    /// A half-space whose modulus is a power of the depth.
    Graded(Graded),
    /// Isotropic, linearly elastic until it yields, then perfectly plastic.
    Plastic(Plastic),
}

impl Body {
    /// What it is called in a scene.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Rigid => "Rigid",
            Self::Elastic(_) => "Elastic",
            Self::Viscoelastic(_) => "Viscoelastic",
            Self::Plastic(_) => "Plastic",
            Self::Layered(_) => "Layered",
            Self::Winkler(_) => "Winkler",
            Self::Graded(_) => "Graded",
        }
    }

    /// Poisson's ratio ν where it is the same at all depths; of a rigid body, of layers and of springs none.
    #[must_use]
    pub fn poisson(&self) -> Option<f64> {
        match self {
            Self::Elastic(elastic) => Some(elastic.poisson.si()),
            Self::Viscoelastic(viscoelastic) => Some(viscoelastic.poisson.si()),
            Self::Graded(graded) => Some(graded.poisson.si()),
            Self::Plastic(plastic) => Some(plastic.poisson.si()),
            Self::Rigid | Self::Layered(_) | Self::Winkler(_) => None,
        }
    }

    /// Yield stress Y [Pa] of an elastic body, if it is stated: there the contact is no longer known.
    #[must_use]
    pub fn yield_stress(&self) -> Option<f64> {
        match self {
            Self::Elastic(elastic) => elastic.yield_stress.map(Modulus::si),
            Self::Viscoelastic(_)
            | Self::Rigid
            | Self::Plastic(_)
            | Self::Layered(_)
            | Self::Winkler(_)
            | Self::Graded(_) => None,
        }
    }

    /// Largest pressure [Pa] that a body bears whose yielding is followed.
    #[must_use]
    pub fn hardness(&self) -> Option<f64> {
        match self {
            Self::Plastic(plastic) => Some(plastic.greatest_pressure()),
            Self::Rigid
            | Self::Elastic(_)
            | Self::Viscoelastic(_)
            | Self::Layered(_)
            | Self::Winkler(_)
            | Self::Graded(_) => None,
        }
    }

    /// The power law by which it relaxes, if it does by one.
    #[must_use]
    pub fn power_law(&self) -> Option<&PowerLaw> {
        match self {
            Self::Viscoelastic(body) => body.shear.power_law.as_ref(),
            Self::Layered(body) => {
                body.layers.iter().map(|layer| &layer.body).chain([body.base.as_ref()]).find_map(Self::power_law)
            }
            Self::Rigid | Self::Elastic(_) | Self::Winkler(_) | Self::Graded(_) | Self::Plastic(_) => None,
        }
    }

    /// Whether it relaxes.
    #[must_use]
    pub fn relaxes(&self) -> bool {
        match self {
            Self::Rigid | Self::Elastic(_) | Self::Plastic(_) | Self::Winkler(_) | Self::Graded(_) => false,
            Self::Viscoelastic(_) => true,
            Self::Layered(body) => body.layers.iter().any(|layer| layer.body.relaxes()) || body.base.relaxes(),
        }
    }

    /// Whether its stiffness depends on the depth.
    #[must_use]
    pub fn is_uneven(&self) -> bool {
        match self {
            Self::Rigid | Self::Elastic(_) | Self::Viscoelastic(_) | Self::Plastic(_) => false,
            Self::Layered(_) | Self::Winkler(_) | Self::Graded(_) => true,
        }
    }
}

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
