//! Contact mechanics by Popov's method of dimensionality reduction (MDR).
//!
//! A ball on a flat: elastic, adhesive, rubbing or viscoelastic, exact for any history. [`prelude`] has what most
//! programs need; [`Contact`](library::Contact) is a contact one can hold, [`run`](run::run) takes a whole scene.
//!
//! # How hard does a steel ball press?
//! ```
//! use springbed::prelude::*;
//!
//! // R = 10 mm pressed 1 µm into a rigid flat: Hertz.
//! let mut ball = Contact::paraboloid(0.01)?.elastic(210e9 / (1.0 - 0.3f64.powi(2)))?;
//! ball.advance(1e-6, 0.0)?;
//! assert!((ball.force() / 30.76923076923077 - 1.0).abs() < 1e-14);
//! assert!((ball.contact_radius() / 1e-4 - 1.0).abs() < 1e-14);
//! assert!((ball.pressure(0.0)? / 1.469122551617495e9 - 1.0).abs() < 1e-14);
//! // It yields first at 0.48 a below the surface.
//! let hardest = ball.loaded().hardest(0.3).unwrap();
//! assert!((hardest.depth / 1e-4 - 0.480864).abs() < 1e-6);
//! # Ok::<(), LibraryError>(())
//! ```
//!
//! # At what force does an adhesive lens part?
//! ```
//! use springbed::prelude::*;
//!
//! let mut lens = Contact::paraboloid(2.5e-3)?.elastic(6.4e6)?.jkr(0.042)?;
//! lens.press(0.048)?;
//! let jumps = lens.press(-1.0)?;
//! let pull_off = -1.5 * std::f64::consts::PI * 0.042 * 2.5e-3;
//! assert!((jumps[0].before.force / pull_off - 1.0).abs() < 1e-12);
//! assert!(!lens.is_joined() && lens.dissipated() > 0.0);
//! # Ok::<(), LibraryError>(())
//! ```
//!
//! # How much of a rubbing contact sticks?
//! ```
//! use springbed::prelude::*;
//!
//! // E* = G* = R = d = 1, μ = 0.3: slid by 0.225 it sticks inside a/2 (Cattaneo & Mindlin).
//! let mut ball = Contact::paraboloid(1.0)?.elastic(1.0)?.coulomb(1.0, 0.3)?;
//! ball.advance(1.0, 0.0)?;
//! ball.advance(1.0, 0.225)?;
//! assert!((ball.stick_radius() - 0.5).abs() < 1e-14);
//! assert!((ball.tangential_force() - 0.35).abs() < 1e-14);
//! # Ok::<(), LibraryError>(())
//! ```
//!
//! # How does the force on rubber relax?
//! ```
//! use springbed::prelude::*;
//!
//! // E*(t) = 1 MPa + 9 MPa·exp(−t/0.1 s) under R = 10 mm, d = 0.1 mm, a tenth of a second after a step.
//! let rubber = Relaxation { equilibrium: 1e6, terms: vec![(9e6, 0.1)], viscosity: 0.0 };
//! let mut ball = Contact::paraboloid(0.01)?.viscoelastic(&rubber)?;
//! ball.advance(1e-4, 0.0)?;
//! ball.advance_over(1e-4, 0.0, 0.1)?;
//! let modulus = 1e6 + 9e6 * (-1.0f64).exp();
//! assert!((ball.force() / (4.0 / 3.0 * modulus * 0.1 * 1e-6) - 1.0).abs() < 1e-9);
//! # Ok::<(), LibraryError>(())
//! ```
//!
//! # What comes of a whole scene?
//! ```
//! # #[cfg(feature = "text")] {
//! use springbed::prelude::*;
//!
//! let text = r#"(shape: Paraboloid(radius: "10 mm"), bodies: (Elastic(young: "210 GPa", poisson: 0.3), Rigid),
//!     history: [Indent(to: "1 um", over: 1)])"#;
//! let plan = Notation::Ron.plan(text, &InMemory::default()).map_err(|errors| errors[0].clone())?;
//! let outcome = run(&plan, Wanted::NOTHING)?;
//! let last = outcome.records.last().unwrap();
//! assert!((last.normal.force / 30.76923076923077 - 1.0).abs() < 1e-14);
//! # }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Order
//! Folders stand in the order of use: each one may use only those above it (`tests/all/layers.rs`).

pub mod numerics;
pub mod input;
pub mod shape;
pub mod material;
pub mod ground;
pub mod contact;
pub mod friction;
pub mod wear;
pub mod library;
pub mod drive;
#[cfg(feature = "half-space")]
pub mod halfspace;
pub mod scene;
pub mod run;
#[cfg(feature = "text")]
#[expect(clippy::wildcard_enum_match_arm, reason = "values and errors of other crates may get new kinds")]
pub mod text;
#[cfg(feature = "text")]
pub mod sweep;
#[cfg(feature = "fit")]
pub mod fit;
pub mod prelude;
pub mod check;
#[cfg(feature = "cli")]
#[expect(clippy::wildcard_enum_match_arm, reason = "values and errors of other crates may get new kinds")]
pub mod app;

#[cfg(test)]
mod laws;

/// The example of the README, run as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
