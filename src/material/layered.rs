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

use super::pair::{Alone, Known, Stiffness};
use super::viscoelastic::instantly_stiff;
use super::{Body, Relaxation, Spectrum};
use crate::input::problem::Problem;
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

/// A body of a layer or of a base, in numbers.
struct Material {
    shear: f64,
    poisson: f64,
    relaxation: Relaxation,
}

impl Material {
    fn of(body: &Body, path: &str, known: Known<'_>) -> Result<Self, Problem> {
        let (poisson, relaxation) = match body {
            Body::Elastic(elastic) => {
                let equilibrium = elastic.plane_modulus();
                (elastic.poisson.si(), Relaxation { equilibrium, terms: Vec::new(), viscosity: 0.0 })
            }
            Body::Viscoelastic(body) => (body.poisson.si(), instantly_stiff(body, path, known)?),
            Body::Rigid | Body::Plastic(_) | Body::Layered(_) | Body::Winkler(_) | Body::Graded(_) => {
                let what =
                    format!("{} cannot be part of a layered body: expected Elastic(…) or Viscoelastic(…)", body.name());
                return Err(Problem::new(path, what));
            }
        };
        Ok(Self { shear: 0.5 * (1.0 - poisson) * relaxation.instantaneous(), poisson, relaxation })
    }

    /// Whether it relaxes by the same function of time as another one.
    fn relaxes_as(&self, other: &Self) -> bool {
        let (one, two) = (&self.relaxation, &other.relaxation);
        let (first, second) = (one.instantaneous(), two.instantaneous());
        let near = |a: f64, b: f64| (a / first - b / second).abs() <= SAME;
        let terms = one.terms.iter().zip(&two.terms);
        one.terms.len() == two.terms.len()
            && near(one.equilibrium, two.equilibrium)
            && near(one.viscosity, two.viscosity)
            && terms.into_iter().all(|(a, b)| near(a.0, b.0) && (a.1 / b.1 - 1.0).abs() <= SAME)
    }
}

/// Relaxation functions that differ by less are written differently, not different.
const SAME: f64 = 1e-12;

/// A layered body against a rigid one: its modulus is that of an endless top layer.
pub(super) fn layered(body: &Layered, path: &str, known: Known<'_>) -> Result<Alone, Vec<Problem>> {
    let layers = body.layers.iter().enumerate();
    let layers = layers.map(|(k, layer)| Material::of(&layer.body, &format!("{path}.layers[{k}].body"), known));
    let base = (!matches!(*body.base, Body::Rigid)).then(|| Material::of(&body.base, &format!("{path}.base"), known));
    let (materials, problems): (Vec<_>, Vec<_>) = layers.chain(base).partition(Result::is_ok);
    let problems: Vec<Problem> = problems.into_iter().filter_map(Result::err).collect();
    let materials: Vec<Material> = materials.into_iter().flatten().collect();
    if !problems.is_empty() {
        return Err(problems);
    }
    let (Some(top), false) = (materials.first(), body.layers.is_empty()) else {
        return Err(vec![Problem::new(format!("{path}.layers"), "has no layer: expected at least one")]);
    };
    if let Some(number) = materials.iter().position(|other| !top.relaxes_as(other)) {
        let place = if number < body.layers.len() { format!("layers[{number}].body") } else { "base".to_owned() };
        let what = "does not relax as the topmost layer does, by the same share in the same times: expected one relaxation function for all layers and a base that gives";
        return Err(vec![Problem::new(format!("{path}.{place}"), what)]);
    }
    let sheet = |material: &Material, thickness: f64, joint: Joint| Sheet {
        shear: material.shear / top.shear,
        poisson: material.poisson,
        thickness,
        joint,
    };
    let sheets = body.layers.iter().zip(&materials);
    let sheets = sheets.map(|(layer, material)| sheet(material, layer.thickness.si(), layer.bond.unwrap_or(body.bond)));
    let base = materials.get(body.layers.len()).map(|material| sheet(material, 0.0, Joint::Bonded));
    let stack = Stack { sheets: sheets.collect(), base };
    Ok(Alone {
        stiffness: Stiffness::new(top.relaxation.instantaneous(), top.poisson),
        spectrum: Some(Spectrum::new(&top.relaxation)),
        under: Under::Layers(vec![(1.0, stack)]),
    })
}

/// A sheet of springs: its modulus stands for E*.
pub(super) fn winkler(body: &Winkler) -> Alone {
    let modulus = body.modulus.si();
    Alone {
        stiffness: Stiffness::new(modulus, 0.0),
        spectrum: Some(Spectrum::elastic(modulus)),
        under: Under::Springs(body.thickness.si()),
    }
}

/// A graded body: E₀/(1−ν²) stands for E*.
pub(super) fn graded(body: &Graded) -> Alone {
    let poisson = body.poisson.si();
    let modulus = body.young.si() / ((1.0 - poisson) * (1.0 + poisson));
    Alone {
        stiffness: Stiffness::new(modulus, poisson),
        spectrum: Some(Spectrum::elastic(modulus)),
        under: Under::Graded(body.clone()),
    }
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
