//! Contact mechanics by Popov's method of dimensionality reduction (MDR).
#[cfg(feature = "cli")]
pub mod app;
pub mod check;
pub mod physics;

/// The example of the README, run as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
