//! The ways to compute a case that are measured against each other: our solvers, and the usual scripts.
//!
//! # Examples
//! ```
//! # #[cfg(feature = "text")] {
//! use springbed::prelude::*;
//! use springbed::check::study::Thoroughness;
//! use springbed::check::ways;
//!
//! let text = r#"(shape: Paraboloid(radius: 1), bodies: (Elastic(young: 1, poisson: 0), Rigid),
//!     history: [Indent(to: 1, over: 1)])"#;
//! let plan = Notation::Ron.plan(text, &InMemory::default()).map_err(|errors| errors[0].clone())?;
//! // Its own solver, and beds of springs.
//! let study = ways::scene(&plan, Thoroughness::Brief).map_err(|why| why.to_string())?;
//! assert!(study.methods.len() > 3 && study.methods[0].name == "direct");
//! # }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub(super) mod adhesion;
pub(super) mod elastic;
pub(super) mod friction;
#[cfg(feature = "half-space")]
mod grid;
pub(super) mod ground;
pub(super) mod impact;
pub(super) mod rough;
mod scene;
pub(super) mod script;
pub(super) mod viscoelastic;

pub use scene::scene;

use crate::contact::springs::EdgeLocation;

/// The two ways of a bed to find its edge.
const EDGES: [(&str, EdgeLocation); 2] =
    [("springs, edge between", EdgeLocation::BetweenSprings), ("springs, counted", EdgeLocation::AtSprings)];
