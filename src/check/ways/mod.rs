//! The ways to compute a case that are measured against each other: our solvers, and the usual scripts.

pub(super) mod adhesion;
pub(super) mod elastic;
pub(super) mod friction;
#[cfg(feature = "half-space")]
mod grid;
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
