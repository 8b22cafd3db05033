//! Contact mechanics by Popov's method of dimensionality reduction (MDR).
#[cfg(feature = "cli")]
pub mod app;
pub mod check;
pub mod physics;
