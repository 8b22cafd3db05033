//! What most programs need: `use springbed::prelude::*;`.

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
