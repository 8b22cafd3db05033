//! The outside world: scenes, tables, figures, the command line.
//!
//! # Examples
//! ```
//! use springbed::app::{export, run, scene_file};
//!
//! // What `springbed run` does, without files: plan, outcome, table.
//! let text = r#"(shape: Paraboloid(radius: 1), bodies: (Elastic(young: 1, poisson: 0), Rigid),
//!     history: [Indent(to: 1, over: 1)])"#;
//! let plan = scene_file::plan("ball.ron".as_ref(), text).map_err(|faults| faults[0].message.clone())?;
//! let outcome = run::compute(&plan, &[run::Format::Csv])?;
//! assert!(export::summary("ball", &outcome).contains("largest force"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod fault;
mod read;
pub mod scene_file;
mod matrix_file;
mod topography_file;
pub mod table_file;
pub mod data_file;
pub mod fitting;
mod write;
mod overwrite;
mod console;
mod progress;
mod machine;
pub mod format;
pub mod medium;
#[cfg(feature = "plot")]
pub mod figure;
pub mod picture;
pub mod export;
pub mod run;
#[cfg(feature = "watch")]
mod watch;
mod starters;
pub mod command;
