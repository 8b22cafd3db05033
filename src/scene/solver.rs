//! Another solver than the one that suits: the full half-space.
//!
//! # Examples
//! ```
//! # #[cfg(feature = "text")] {
//! use springbed::scene::Scene;
//! use springbed::scene::solver::{HalfSpace, SolverChoice};
//!
//! let scene = Scene::from_ron(r#"(shape: Paraboloid(radius: 1), bodies: (Elastic(young: 1, poisson: 0), Rigid),
//!     history: [Indent(to: 1e-3, over: 1)], solver: HalfSpace(grid: 128))"#)?;
//! let Some(SolverChoice::HalfSpace(HalfSpace { grid, window: None, boundary: None, leak: None, tractions: None })) = scene.solver else { panic!() };
//! assert_eq!(grid.map(|grid| grid.get()), Some(128));
//! # }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::input::quantity::{FluidViscosity, Length};
use crate::shape::Boundary;
use serde::{Deserialize, Serialize};
use std::num::NonZeroUsize;

/// The solver a scene asks for.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, Serialize)]
#[serde(rename = "Solver")]
pub enum SolverChoice {
    /// The half-space under every pixel of the shape.
    HalfSpace(HalfSpace),
}

/// The frictionless contact on the pixels of a half-space: elastic, viscoelastic, plastic, attracted across the gap.
///
/// Force and indentation of a smooth shape are right to about (pixel/contact radius)²/8; areas to the first order in
/// the pixel, less what counting adds along the edges.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct HalfSpace {
    /// Pixels along x, 8 to 8192; absent: those of a map, four on the shortest wave of a spectrum (128 to 1024), else
    /// 256. Time and memory grow with its square.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub grid: Option<NonZeroUsize>,
    /// Side of the square that is computed [m], about the tip of a smooth shape; absent: the whole of a surface, and
    /// three times the largest contact of a smooth shape. A larger one spends pixels on what does not touch.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub window: Option<Length>,
    /// What happens at its edge; absent: `Periodic` for a spectrum on a flat, else `Free`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub boundary: Option<Boundary>,
    /// The fluid that the gap lets through, if that is asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub leak: Option<Leak>,
    /// Whether pressures and shear change each other; absent: `Independent`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tractions: Option<Tractions>,
}

/// How pressures and shear under Coulomb's law are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize)]
pub enum Tractions {
    /// Pressures as without friction, shear from their differences: exact of round contacts of elastically similar bodies.
    #[default]
    Independent,
    /// Together, on every pixel and in both directions, record by record: what presses draws the surface along, what shears
    /// lifts it (Dundurs' β), and shear along x moves it along y. To the first order of the steps between records; the first
    /// body is the one below.
    Coupled,
}

/// A viscous fluid between the surfaces, which a difference of the pressure drives from one border to the other.
///
/// Its own pressure is far below that of the contact and does not open the gap.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Leak {
    /// Viscosity η [Pa s].
    pub viscosity: FluidViscosity,
    /// The way it flows; absent: along x.
    #[serde(default)]
    pub along: Heading,
}

/// A direction on a map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, Serialize)]
pub enum Heading {
    /// Along the rows.
    #[default]
    X,
    /// From row to row.
    Y,
}
