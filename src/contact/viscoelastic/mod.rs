//! Viscoelastic beds, exact in time.
//!
//! Every spring is E∞, any number of Maxwell elements and a dashpot in parallel. While the indenter
//! moves at constant speed the spring's load is known in closed form, so a history of straight
//! pieces has no error of time stepping. Three beds share the [`spring`](mod@spring): the
//! [`direct`] one updates every spring in every step; the [`lazy`] one does work only for the springs
//! touched or released.
//!
//! # Examples
//! ```
//! use springbed::contact::viscoelastic::{Spectrum, direct::Direct, layout::Layout, lazy::Lazy, memory::Memory};
//! use springbed::input::quantity::Length;
//! use springbed::material::Relaxation;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! // A ball of 1 m, pressed by 10 mm in 1 s into a body of E∞ = 1 Pa and 1 Pa more that relaxes in 1 s.
//! let ball = Arc::new(Paraboloid { radius: Length::new(1.0)? });
//! let relaxation = Relaxation { equilibrium: 1.0, terms: vec![(1.0, 1.0)], viscosity: 0.0 };
//! let body = Arc::new(Spectrum::new(&relaxation));
//! let springs = Layout::uniform(ball.as_ref(), 0.15, 2000);
//! let mut plain = Direct::new(body.clone(), springs.clone());
//! let mut lazy = Lazy::new(body.clone(), springs);
//! let mut continuous = Memory::new(body, ball);
//! plain.advance(0.01, 1.0);
//! lazy.advance(0.01, 1.0);
//! continuous.advance(0.01, 1.0)?;
//! assert!((lazy.force() / plain.force() - 1.0).abs() < 1e-12);
//! assert!((lazy.force() / continuous.force() - 1.0).abs() < 1e-5);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod alike;
pub mod attraction;
pub mod continuous;
pub mod direct;
pub mod growing;
#[cfg(test)]
pub(crate) mod laws;
pub mod layout;
pub(crate) mod front;
pub mod lazy;
pub mod ledger;
pub mod memory;
mod loaded;
mod panel;
pub mod spring;
mod totals;

pub use crate::material::{Element, Mode, Spectrum};
pub use spring::Motion;
