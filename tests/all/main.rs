//! The tests of the library and of the program from outside, one program: each file is a module.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod allocation;
#[cfg(feature = "cli")]
mod bad_scenes;
#[cfg(feature = "text")]
mod beds;
mod circles;
#[cfg(feature = "cli")]
mod compare;
#[cfg(feature = "cli")]
mod coverage;
#[cfg(feature = "watch")]
mod devtools;
mod elastic_laws;
#[cfg(feature = "cli")]
mod fit;
#[cfg(feature = "cli")]
mod fit_driven;
mod friction;
#[cfg(feature = "cli")]
mod fuzz;
#[cfg(feature = "text")]
mod gliding;
#[cfg(feature = "text")]
mod ground;
#[cfg(all(feature = "text", feature = "half-space"))]
mod half_space;
#[cfg(all(feature = "text", feature = "half-space"))]
mod half_space_coupled;
#[cfg(all(feature = "text", feature = "half-space"))]
mod half_space_friction;
#[cfg(all(feature = "text", feature = "half-space"))]
mod half_space_gliding;
#[cfg(all(feature = "text", feature = "half-space"))]
mod half_space_jumps;
#[cfg(all(feature = "text", feature = "half-space"))]
mod half_space_layers;
#[cfg(all(feature = "text", feature = "half-space"))]
mod half_space_past;
mod hertz_and_jkr;
#[path = "../../src/laws.rs"]
mod laws;
mod layers;
#[cfg(feature = "text")]
mod led_by_spring;
#[cfg(all(feature = "text", feature = "half-space"))]
mod leak;
#[cfg(feature = "text")]
mod machine;
#[cfg(feature = "text")]
mod mended;
#[cfg(feature = "cli")]
mod overlay;
#[cfg(feature = "cli")]
mod pictures;
#[cfg(feature = "cli")]
mod program;
#[cfg(feature = "cli")]
mod rough;
#[cfg(feature = "cli")]
mod scenes;
#[cfg(feature = "text")]
mod stresses;
#[cfg(feature = "text")]
mod stuck;
#[cfg(feature = "cli")]
mod sweep;
#[cfg(all(feature = "cli", feature = "half-space"))]
mod validation;
#[cfg(feature = "text")]
mod text;
#[cfg(feature = "text")]
mod told;
#[cfg(feature = "text")]
mod traction;
#[cfg(feature = "text")]
mod unloading;
mod viscoelastic_scenes;
#[cfg(feature = "watch")]
mod watch;
#[cfg(feature = "text")]
mod wear;
mod wavy_jumps;
