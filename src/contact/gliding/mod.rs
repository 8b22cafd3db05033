//! Profiles that glide over a bed that remembers: what the bed takes back too late is a resistance.
//!
//! Under a profile g(ξ) that glides at the speed v every spring of the bed goes down and up once: u(t) = d − g(ξ), ξ = x − vt.
//! It is touched where the surface, still recovering from what has been, meets the profile, carries f ≥ 0, is let go
//! where f would become a pull, and recovers freely. The normal force is F = ∫ f dξ and the resistance
//! F_x = ∫ f g′ dξ (Popov 2010, ch. 16; Popov & Heß 2015, ch. 7); the power F_x v is all turned into heat.
//!
//! In the steady state all springs go through the same, one after the other: one spring tells of all ([`SteadyGlide`]). How
//! it comes to that from a contact at rest is told by a bed of springs ([`GlidingBed`]).
//!
//! Of a round body g(ξ) is its one-dimensional profile of Heß's rule. That is exact as long as the contact is
//! round; one that glides is not, and for it the bed is a model: exact for the profile of one dimension, right in the order of
//! size for the body in three.
//!
//! # Examples
//! ```
//! use springbed::contact::gliding::SteadyGlide;
//! use springbed::input::quantity::Positive;
//! use springbed::material::{Relaxation, Spectrum};
//! use springbed::shape::Cone;
//! use std::sync::Arc;
//!
//! // A wedge of slope c on a Kelvin–Voigt bed, s = ηvc/(Ed): μ/c = s(4 − s)/(2 + s²) for s ≤ 1.
//! let solid = Relaxation { equilibrium: 1.0, terms: vec![], viscosity: 1.0 };
//! let wedge = Arc::new(Cone { slope: Positive::new(0.2 / std::f64::consts::FRAC_PI_2)? });
//! let glide = SteadyGlide::round(Arc::new(Spectrum::new(&solid)), wedge, 1e-9);
//! let (s, c, depth) = (0.5, 0.2, 1e-3);
//! let state = glide.at_depth(s * depth / c, depth)?;
//! let friction = state.resistance / state.force;
//! assert!((friction / (c * s * (4.0 - s) / (2.0 + s * s)) - 1.0).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bed;
mod cycle;
mod kernel;
mod steady;
mod sweep;
mod tally;
mod track;
#[cfg(test)]
mod tests;

pub use bed::GlidingBed;
pub use steady::{SteadyGlide, SteadyState};
pub use track::GlidingLine;
