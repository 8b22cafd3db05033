//! The outside world.

#[cfg(feature = "plot")]
pub mod figure;
