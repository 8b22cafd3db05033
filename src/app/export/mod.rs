//! Results as bytes: tables, JSON, figures, a summary. Nothing here writes a file.

mod json;
mod summary;
mod tables;
mod verdicts;

#[cfg(feature = "plot")]
mod figures;

#[cfg(feature = "plot")]
pub use figures::figures;
pub use json::json;
pub use summary::{summary, with_prefix};
pub use tables::{pressure_table, record_table};
pub use verdicts::{validation, verdict_table};
