//! What is right, and how well the program hits it.

pub mod closed_forms;
pub mod tangential;
pub mod theory;
#[cfg(feature = "half-space")]
pub mod agreement;
pub mod attempt;
pub mod case;
pub mod cases;
mod measured;
pub mod one_piece;
pub mod comparison;
pub mod ting;
pub mod clock;
pub mod contacts;
pub mod extreme;
pub mod row;
pub mod sketch;
pub mod speed;
pub mod stated;
pub mod study;
pub mod ways;
