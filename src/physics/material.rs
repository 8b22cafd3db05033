//! Bodies, their materials and the effective moduli of a pair.

use super::quantity::{Duration, Modulus, Poisson, Stress, Viscosity};
use serde::{Deserialize, Deserializer, Serialize, de};
use std::{fmt, path::PathBuf};

/// One of the two bodies.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
pub enum Body {
    /// Cannot deform.
    Rigid,
    /// Isotropic, linearly elastic half-space.
    Elastic(Elastic),
    /// Isotropic, linearly viscoelastic half-space.
    Viscoelastic(Viscoelastic),
}

/// Isotropic, linearly elastic material.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Elastic {
    /// Young's modulus E [Pa].
    pub young: Modulus,
    /// Poisson's ratio ν.
    pub poisson: Poisson,
    /// Yield stress in uniaxial tension [Pa]; if given, a contact pressure beyond first yield is a warning.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub yield_stress: Option<Modulus>,
}

/// Isotropic, linearly viscoelastic material with a constant Poisson's ratio.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Viscoelastic {
    /// Poisson's ratio ν, constant in time.
    pub poisson: Poisson,
    /// Relaxation in shear.
    pub shear: Shear,
}

/// Relaxation function in shear, G(t) = G∞ + Σ Gᵢ e^(−t/τᵢ), and a parallel dashpot η.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Shear {
    /// Equilibrium modulus G∞ [Pa]; zero for a liquid.
    #[serde(default)]
    pub equilibrium: Stress,
    /// Terms Gᵢ, τᵢ of the Prony series.
    #[serde(default)]
    pub terms: Terms,
    /// Viscosity η [Pa s] of a parallel dashpot (Kelvin–Voigt).
    #[serde(default)]
    pub viscosity: Viscosity,
}

/// The terms of a Prony series: a list, or a table with columns `time_s,modulus_pa`.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Terms {
    /// Terms in the scene.
    List(Vec<Term>),
    /// Terms in a file next to the scene.
    Table(PathBuf),
}

impl Default for Terms {
    fn default() -> Self {
        Self::List(Vec::new())
    }
}

/// One Maxwell element: modulus Gᵢ [Pa] and relaxation time τᵢ [s].
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Term {
    /// Modulus Gᵢ [Pa].
    pub modulus: Stress,
    /// Relaxation time τᵢ [s].
    pub time: Duration,
}

struct TermsVisitor;

impl<'de> de::Visitor<'de> for TermsVisitor {
    type Value = Terms;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of terms [(modulus: \"1 MPa\", time: \"1 s\"), …] or the path of a table with columns time_s,modulus_pa")
    }

    fn visit_str<E: de::Error>(self, path: &str) -> Result<Terms, E> {
        Ok(Terms::Table(path.into()))
    }

    fn visit_seq<A: de::SeqAccess<'de>>(self, mut seq: A) -> Result<Terms, A::Error> {
        let mut terms = Vec::new();
        while let Some(term) = seq.next_element()? {
            terms.push(term);
        }
        Ok(Terms::List(terms))
    }
}

impl<'de> Deserialize<'de> for Terms {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(TermsVisitor)
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
