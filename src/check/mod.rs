//! What is right, and how well the program hits it.
//!
//! # Examples
//! ```
//! use springbed::check::cases;
//!
//! // Every case with a known answer, by name: error, bound and kind of proof.
//! let case = &cases::matching("Hertz")[0];
//! let row = case.verdict();
//! assert!(row.why.is_none() && case.bound > 0.0 && !case.because.is_empty());
//! ```

pub mod closed_forms;
pub(crate) mod tangential;
pub mod theory;
#[cfg(feature = "half-space")]
pub mod agreement;
pub(crate) mod attempt;
pub mod case;
pub mod cases;
#[cfg(feature = "text")]
pub mod matrix;
mod measured;
pub mod one_piece;
pub mod power_law;
pub mod comparison;
pub mod ting;
pub(crate) mod clock;
pub(crate) mod contacts;
pub(crate) mod extreme;
pub mod row;
pub(crate) mod sketch;
pub mod speed;
pub(crate) mod stated;
pub mod study;
pub mod ways;
