//! The outside world: scenes, tables, figures, the command line.

pub mod fault;
mod read;
pub mod scene_file;
mod matrix_file;
pub mod table_file;
pub mod write;
pub mod console;
pub mod progress;
pub mod machine;
#[cfg(feature = "plot")]
pub mod figure;
pub mod export;
pub mod run;
pub mod starters;
pub mod command;
