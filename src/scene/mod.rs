//! The scene: what is pressed on what, and how.
//!
//! # Examples
//! ```
//! use springbed::input::table::InMemory;
//! use springbed::material::{Body, Elastic};
//! use springbed::scene::Scene;
//! use springbed::scene::history::{Entry, Indent};
//! use springbed::shape::{Paraboloid, Shape};
//!
//! // A scene from values; two rigid bodies are refused.
//! let ball = Shape::Paraboloid(Paraboloid { radius: "10 mm".parse()? });
//! let steel = Body::Elastic(Elastic { young: "210 GPa".parse()?, poisson: "0.3".parse()?, yield_stress: None });
//! let history = vec![Entry::Indent(Indent { to: "1 um".parse()?, over: "1 s".parse()? })];
//! let scene = |bodies| Scene {
//!     title: String::new(),
//!     shape: ball.clone(),
//!     bodies,
//!     adhesion: None,
//!     friction: None,
//!     wear: None,
//!     machine: None,
//!     history: history.clone(),
//!     accuracy: None,
//!     springs: None,
//!     solver: None,
//!     steps: None,
//!     plots: None,
//!     sweep: None,
//!     fit: None,
//! };
//! let plan = scene((steel, Body::Rigid)).resolve(&InMemory::default()).map_err(|problems| problems[0].clone())?;
//! assert!((plan.pair.normal / 230.769e9 - 1.0).abs() < 1e-5);
//! assert!(scene((Body::Rigid, Body::Rigid)).resolve(&InMemory::default()).is_err());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod fit;
pub mod history;
mod limits;
mod pixelled;
mod read;
mod resolve;
mod words;
pub mod law;
pub mod mended;
pub mod parts;
pub mod plan;
pub mod reach;
pub mod rules;
pub mod solver;
pub mod stage;
pub mod surface;
mod times;
pub mod swept;
pub mod tractive;

use crate::contact::adhesion::Adhesion;
use crate::drive::machine::Machine;
use crate::friction::Friction;
use crate::input::quantity::Accuracy;
use crate::material::Body;
use crate::scene::history::Entry;
use crate::scene::solver::SolverChoice;
use crate::scene::swept::Swept;
use crate::shape::Shape;
use crate::wear::Wear;
use serde::{Deserialize, Serialize};
use std::num::NonZeroUsize;

/// A contact to be computed, as written in a scene file.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    /// Title, for figures and summaries.
    #[serde(default)]
    pub title: String,
    /// Shape of the indenter.
    pub shape: Shape,
    /// The two bodies.
    pub bodies: (Body, Body),
    /// Adhesion, if any.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub adhesion: Option<Adhesion>,
    /// Friction, if any.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction: Option<Friction>,
    /// Wear of the indenter, if any.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wear: Option<Wear>,
    /// The machine of which the contact is a part, if any.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub machine: Option<Machine>,
    /// What is done, in order.
    pub history: Vec<Entry>,
    /// Relative error to aim at, 1e-6 if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub accuracy: Option<Accuracy>,
    /// Number of springs, to study the classical bed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub springs: Option<NonZeroUsize>,
    /// Another solver than the one that suits.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub solver: Option<SolverChoice>,
    /// Records per history entry.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub steps: Option<NonZeroUsize>,
    /// Figures wanted; what suits the scene if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub plots: Option<Vec<Plot>>,
    /// Values that some of its places are to take, one scene for each; the scene itself is as if this were not there.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sweep: Option<Swept>,
    /// What is to be found from measured curves.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fit: Option<fit::Measured>,
}

/// A figure one can ask for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
pub enum Plot {
    /// Force against indentation, and against time where time matters.
    Force,
    /// Contact radius.
    Radius,
    /// Pressure profile.
    Pressure,
    /// Stress of von Mises over place and depth below the surface, and the stresses on the axis.
    Stress,
    /// Stresses over place and depth below the surface, one by one.
    Field,
    /// Springs of the bed at the greatest force and at the end, and what they carry.
    Bed,
    /// Surfaces of both bodies at the greatest force, to scale and exaggerated.
    Surface,
    /// Stored and dissipated energy.
    Energy,
    /// Shape f(r) with its one-dimensional equivalent g(x).
    Shape,
    /// Relaxation modulus and storage and loss moduli.
    Moduli,
    /// Tangential force against tangential displacement.
    Friction,
    /// Radius of the contact and of its sticking part.
    Stick,
    /// Shear stress over the radius.
    Shear,
    /// Energy lost to friction over the radius, of a contact that is shaken.
    Fretting,
    /// Worn profiles and their pressures in time, and the worn volume.
    Wear,
    /// Coefficient of sliding friction against the load, without adhesion.
    Coefficient,
    /// Area of contact: of a sheared adhesive one against the sliding speed, of one on pixels against the force.
    Area,
    /// Map of the pressure with the outline of the contact, on pixels.
    Contact,
    /// Distributions of pressure and gap, on pixels.
    Distribution,
    /// What the gap lets through of a fluid against the force, on pixels.
    Leak,
    /// Restitution against speed.
    Restitution,
    /// Displacement, speed and forces of a machine over time.
    Machine,
    /// Resistance of a body that glides or rolls over a body that remembers: over the speed, or over the time.
    Resistance,
    /// Traction of a body that rolls over its creepage, and what the places of its contact carry.
    Traction,
}

impl Scene {
    /// Whether one of the bodies is viscoelastic.
    #[must_use]
    pub fn relaxes(&self) -> bool {
        self.bodies.0.relaxes() || self.bodies.1.relaxes()
    }
}
