//! Complex numbers, exponentials, roots, extrema, quadrature and special functions: no physics.

pub mod complex;
pub mod exponential;
pub mod extremum;
pub mod quadrature;
pub mod root;
pub mod special;
