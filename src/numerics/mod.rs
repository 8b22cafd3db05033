//! Roots, quadrature and special functions: no physics.

pub mod quadrature;
pub mod root;
pub mod special;
