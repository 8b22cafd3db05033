//! Bodies whose stiffness depends on the depth: layers, a thin sheet of springs, a graded half-space.
//!
//! # Examples
//! ```
//! use springbed::input::table::InMemory;
//! use springbed::material::{Body, Under, joined};
//!
//! // 5 µm of gel on glass, bonded: the top is that of an endless gel, what lies below is told apart.
//! let json = r#"{"Layered": {"layers": [{"body": {"Elastic": {"young": "10 kPa", "poisson": 0.5}}, "thickness": "5 um"}],
//!     "base": "Rigid"}}"#;
//! # #[cfg(feature = "text")] {
//! let gel: Body = serde_json::from_str(json)?;
//! let joined = joined(&(gel, Body::Rigid), &InMemory::default(), None).map_err(|problems| problems[0].clone())?;
//! let joined = joined.ok_or("two rigid bodies")?;
//! assert!((joined.pair.normal / (1e4 / 0.75) - 1.0).abs() < 1e-14);
//! assert!(matches!(joined.under, Under::Layers(_)));
//! # }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::Body;
use crate::input::quantity::{GradingExponent, Length, Modulus, Poisson};
use serde::{Deserialize, Serialize};

/// Layers on a base, the topmost first.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Layered {
    /// The layers from the top down; Elastic or Viscoelastic.
    pub layers: Vec<Layer>,
    /// What they lie on: Rigid, Elastic or Viscoelastic, without an end.
    pub base: Box<Body>,
    /// How each layer is joined to what lies below it.
    #[serde(default)]
    pub bond: Joint,
}

/// One layer.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Layer {
    /// What it is made of.
    pub body: Body,
    /// Thickness h [m].
    pub thickness: Length,
    /// How it is joined to what lies below it, if not as the others.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bond: Option<Joint>,
}

/// How a layer is joined to what lies below it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize)]
pub enum Joint {
    /// Neither opens nor slides.
    #[default]
    Bonded,
    /// Does not open, and carries no shear stress.
    Sliding,
}

/// A sheet of independent springs (Winkler): each gives by ph/M under the pressure p.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Winkler {
    /// Modulus M [Pa] of the sheet; (1−ν)E/((1+ν)(1−2ν)) of a thin bonded layer.
    pub modulus: Modulus,
    /// Thickness h [m].
    pub thickness: Length,
}

/// A half-space with E(z) = E₀(z/z₀)ⁿ and a constant ν.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Graded {
    /// Young's modulus E₀ [Pa] at the depth z₀.
    pub young: Modulus,
    /// Depth z₀ [m].
    pub depth: Length,
    /// Exponent n, from 0 to below 1.
    pub exponent: GradingExponent,
    /// Poisson's ratio ν.
    pub poisson: Poisson,
}

/// What lies under the surfaces that touch.
#[derive(Debug, Clone, PartialEq)]
pub enum Under {
    /// Two half-spaces, each alike at all depths.
    HalfSpaces,
    /// The layers of one body or of both, each with its share E*/E*ᵢ in what both give.
    Layers(Vec<(f64, Stack)>),
    /// Independent springs in a sheet of the thickness [m].
    Springs(f64),
    /// A modulus that grows with the depth.
    Graded(Graded),
}

/// A layer or a base in numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sheet {
    /// Shear modulus G [Pa], or its ratio to another one.
    pub shear: f64,
    /// Poisson's ratio ν.
    pub poisson: f64,
    /// Thickness [m]; of a base without meaning.
    pub thickness: f64,
    /// Joint to what lies below.
    pub joint: Joint,
}

/// Layers on a base in numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct Stack {
    /// The layers from the top down.
    pub sheets: Vec<Sheet>,
    /// The half-space below them; `None` if it is rigid.
    pub base: Option<Sheet>,
}

impl Under {
    /// What lies under two bodies whose shares E*/E*ᵢ in what both give are `shares`; a body that is not a half-space of
    /// one modulus or of layers has only a rigid one beside it.
    pub(super) fn both(one: Self, other: Self, shares: (f64, f64)) -> Self {
        let scaled =
            |parts: Vec<(f64, Stack)>, share: f64| parts.into_iter().map(move |(part, stack)| (part * share, stack));
        match (one, other) {
            (Self::HalfSpaces, Self::HalfSpaces) => Self::HalfSpaces,
            (Self::Layers(one), Self::Layers(other)) => {
                Self::Layers(scaled(one, shares.0).chain(scaled(other, shares.1)).collect())
            }
            (Self::Layers(parts), Self::HalfSpaces) => Self::Layers(scaled(parts, shares.0).collect()),
            (Self::HalfSpaces, Self::Layers(parts)) => Self::Layers(scaled(parts, shares.1).collect()),
            (under @ (Self::Springs(_) | Self::Graded(_)), _) | (_, under @ (Self::Springs(_) | Self::Graded(_))) => {
                under
            }
        }
    }
}
