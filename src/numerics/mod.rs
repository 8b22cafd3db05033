//! Roots, extrema, quadrature and special functions: no physics.

pub mod extremum;
pub mod quadrature;
pub mod root;
pub mod special;
