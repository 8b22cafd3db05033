//! The outside world: scenes, tables, figures, the command line.

#[cfg(feature = "plot")]
pub mod figure;
pub mod export;
pub mod run;
