//! Complex numbers, polynomials by pieces, exponentials, roots, extrema, quadrature and special functions: no physics.
//!
//! # Examples
//! ```
//! use springbed::numerics::{quadrature, root};
//!
//! // Where ∫₀ˣ cos t dt reaches a half: at π/6.
//! let x = root::brent(|x| quadrature::panel(f64::cos, 0.0, x) - 0.5, 0.0, 1.0)?;
//! assert!((x - std::f64::consts::FRAC_PI_6).abs() < 1e-15);
//! # Ok::<(), root::RootError>(())
//! ```

pub mod chebyshev;
pub mod complex;
pub mod discrete;
pub mod exponential;
pub mod extrapolation;
pub mod extremum;
pub mod isotonic;
pub mod legendre;
pub mod monotone;
pub mod normal;
pub mod panelled;
pub mod quadrature;
pub mod root;
pub mod special;
pub mod stabilized;
pub mod stiff;
