//! Contact mechanics by Popov's method of dimensionality reduction (MDR).
pub mod check;
pub mod physics;
#[cfg(feature = "cli")]
pub mod app;
