//! Contact mechanics by Popov's method of dimensionality reduction (MDR).
//!
//! Folders stand in the order of use: each one may use only those above it (`tests/all/layers.rs`).

pub mod numerics;
pub mod input;
pub mod shape;
pub mod material;
pub mod contact;
pub mod friction;
pub mod drive;
pub mod scene;
pub mod run;
#[cfg(feature = "text")]
pub mod text;
#[cfg(feature = "half-space")]
pub mod halfspace;
pub mod check;
#[cfg(feature = "cli")]
pub mod app;

/// The example of the README, run as a test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
