//! Normal contacts: the direct path, beds of springs, viscoelastic beds, plane and rough contacts.
//!
//! # Examples
//! ```
//! use springbed::contact::adhesion::line::EdgeLine;
//! use springbed::contact::direct::QuasiStatic;
//! use springbed::contact::springs::SpringBed;
//! use springbed::contact::foundation::Foundation;
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! // The same ball, R = E* = 1, by the direct path and by a thousand springs: F = (4/3)d^{3/2}.
//! let ground = Foundation::new(Arc::new(Paraboloid { radius: Length::new(1.0)? }), 1.0);
//! let mut springs = SpringBed::new(ground.clone(), 1000, 1.1, 0.0);
//! let mut direct = QuasiStatic::new(EdgeLine::new(ground, 0.0));
//! springs.indent(1.0);
//! direct.indent(1.0)?;
//! assert!((direct.present().balance.force - 4.0 / 3.0).abs() < 1e-14);
//! assert!((springs.force() - 4.0 / 3.0).abs() < 2e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod adhesion;
pub mod creep;
pub mod direct;
pub mod elliptic;
mod elastic;
pub mod foundation;
pub mod error;
pub mod gliding;
pub mod inward;
pub mod loaded;
pub mod mapped;
pub mod model;
pub mod pad;
pub mod plane;
pub mod plastic;
pub mod punch;
pub mod rough;
pub mod spring_loads;
pub mod springs;
pub mod state;
pub mod stress;
pub mod subsurface;
pub mod viscoelastic;
