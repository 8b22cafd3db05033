//! Adhesion: the models as a scene names them, their equilibria and the branches of these.
//!
//! # Examples
//! ```
//! use springbed::contact::adhesion::{Adhesion, Jkr, Range};
//! use springbed::input::quantity::WorkOfAdhesion;
//!
//! let gel = Adhesion::Jkr(Jkr { work: WorkOfAdhesion::new(0.02)?, closing: None, edge: None });
//! assert_eq!((gel.traits().name, gel.traits().work), ("Jkr", 0.02));
//! assert_eq!(gel.traits().range, Range::Vanishing(None));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

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

/// What a model of adhesion is, for all that must know.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AdhesionTraits<'a> {
    /// The name a scene gives it.
    pub name: &'static str,
    /// Work of adhesion w [J/m²].
    pub work: f64,
    /// Work of adhesion [J/m²] of a closing edge, where it is less.
    pub closing: Option<f64>,
    /// How far the attraction reaches.
    pub range: Range<'a>,
}

/// How far an attraction reaches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Range<'a> {
    /// It acts at the edge alone; what holds an opening edge of a viscoelastic body.
    Vanishing(Option<&'a EdgeRule>),
    /// It acts across the gap.
    Finite,
}

impl Adhesion {
    /// What the model is: the one place that knows every kind.
    #[must_use]
    pub fn traits(&self) -> AdhesionTraits<'_> {
        match self {
            Self::Jkr(jkr) => AdhesionTraits {
                name: "Jkr",
                work: jkr.work.si(),
                closing: jkr.closing.map(|closing| closing.si()).filter(|&closing| closing < jkr.work.si()),
                range: Range::Vanishing(jkr.edge.as_ref()),
            },
            Self::Maugis(maugis) => {
                AdhesionTraits { name: "Maugis", work: maugis.work.si(), closing: None, range: Range::Finite }
            }
        }
    }
}

/// Adhesion of vanishing range.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Jkr {
    /// Work of adhesion w [J/m²].
    pub work: WorkOfAdhesion,
    /// Work of adhesion [J/m²] of a closing edge, at most `work`, which it is unless given; with 0 the edge attaches
    /// where the bodies touch. Between the two limits the edge stands still.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub closing: Option<WorkOfAdhesion>,
    /// What holds the edge of a viscoelastic body; needed there, refused elsewhere.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edge: Option<EdgeRule>,
}

/// What holds the edge of an adhesive contact of a viscoelastic body.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(rename = "Edge")]
pub enum EdgeRule {
    /// The relaxed modulus E∞: the process zone is long against the relaxation.
    Relaxed,
    /// The instantaneous modulus E(0): a process zone of length zero.
    Instantaneous,
    /// Gent & Schultz: the relaxed modulus and w·[1 + (v/v₀)ⁿ].
    Rate(Rate),
}

impl EdgeRule {
    /// The rule by which the edge of a viscoelastic contact holds, in words.
    #[must_use]
    pub fn in_words(&self) -> String {
        let held = match self {
            Self::Relaxed => "E_c = E*(∞), w_eff = w: the process zone is long against the relaxation".to_owned(),
            Self::Instantaneous => "E_c = E*(0), w_eff = w: the process zone has no length".to_owned(),
            Self::Rate(rate) => format!(
                "E_c = E*(∞), w_eff = w [1 + (v/v₀)ⁿ] with v₀ = {:e} m/s, n = {} (Gent & Schultz): a fast edge holds stronger",
                rate.speed.si(),
                rate.exponent.si()
            ),
        };
        format!(
            "an edge spring leaves at q² = A′E_c w_eff and joins where the bodies are √(A′w/E_c) apart, moved by E_c alone, with A′ = 2πa under a round contact and {held}"
        )
    }
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
