//! Curves read off the records of a scene, and the theory beside them.
//!
//! # Examples
//! ```
//! # #[cfg(feature = "text")] {
//! use springbed::prelude::*;
//! use springbed::run::curves::branches::jumps;
//!
//! let text = r#"(shape: Paraboloid(radius: 1), bodies: (Elastic(young: 1, poisson: 0), Rigid), adhesion: Jkr(work: 1),
//!     history: [Press(to: 1, over: 1), Retract(speed: 0.1)])"#;
//! let plan = Notation::Ron.plan(text, &InMemory::default()).map_err(|errors| errors[0].clone())?;
//! // The jump into contact and the one out of it.
//! let outcome = run(&plan, Wanted::NOTHING)?;
//! assert!(jumps(&outcome.records).count() > 0);
//! # }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod between;
pub mod branches;
pub mod sliding;
