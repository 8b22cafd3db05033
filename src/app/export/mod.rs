//! Results as bytes: tables, JSON, figures, a summary. Nothing here writes a file.

mod comparison;
mod json;
mod summary;
mod tables;
mod validation;
pub mod reports;

#[cfg(feature = "plot")]
mod figures;
#[cfg(feature = "plot")]
pub mod report_figures;

pub use comparison::{comparison_json, comparison_table, comparison_text};
#[cfg(feature = "plot")]
pub use figures::{comparison_figure, figures};
pub use json::json;
pub use summary::{summary, with_prefix};
pub use tables::csv;
pub use validation::validation;
