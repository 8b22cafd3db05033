//! What most programs need: `use springbed::prelude::*;`.
//!
//! # Examples
//! ```
//! use springbed::prelude::*;
//!
//! // A paraboloid, R = E* = d = 1, carries 4/3.
//! let mut ball = Contact::paraboloid(1.0)?.elastic(1.0)?;
//! ball.advance(1.0, 0.0)?;
//! assert!((ball.force() - 4.0 / 3.0).abs() < 1e-14);
//! # Ok::<(), LibraryError>(())
//! ```

pub use crate::contact::loaded::Loaded;
pub use crate::contact::punch::{Point, Stresses};
pub use crate::input::quantity::{Length, Positive};
pub use crate::input::table::{InMemory, Tables};
pub use crate::library::{Contact, Indenter, LibraryError};
pub use crate::material::Relaxation;
pub use crate::run::{Wanted, run};
pub use crate::shape::{Profile, Shape};
#[cfg(feature = "text")]
pub use crate::text::Notation;
