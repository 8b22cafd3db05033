//! Name of a plan while the callers move to it.

pub use super::plan::Plan as Setup;
