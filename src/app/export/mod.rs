//! Results as bytes: tables, JSON, figures, a summary. Nothing here writes a file.
//!
//! # Examples
//! ```
//! use springbed::app::export::with_prefix;
//!
//! assert_eq!(with_prefix(1.5e9, "Pa"), "1.5 GPa");
//! ```

mod comparison;
mod fit;
mod fit_json;
mod fitted;
#[cfg(feature = "plot")]
mod gallery;
mod json;
mod moduli;
mod npy;
mod overlay;
mod summary;
mod sweep;
mod tables;
mod validation;
pub(crate) mod reports;

#[cfg(feature = "plot")]
mod figures;
#[cfg(feature = "plot")]
pub(crate) mod report_figures;

pub use comparison::{comparison_json, comparison_table, comparison_text};
#[cfg(feature = "plot")]
pub use figures::{
    comparison_figure, figures, fit_figure, map_figure, models_figure, overlay_figure, spectrum_figure, sweep_figure,
};
pub use fit::{FitsRow, fit_points, fit_text, fits_table, map_table, models_table};
pub use fit_json::{fit_json, fit_member, fits_json};
pub use fitted::{Answered, Fitted, Tried};
#[cfg(feature = "plot")]
pub use gallery::{Shown, gallery, shown};
pub use json::{json, json_of_all};
pub use moduli::{shifts_table, spectrum_json, spectrum_points, spectrum_text};
pub use npy::npy;
pub use overlay::{OVERLAID, Overlaid, overlay_json, overlay_table, overlay_text};
pub use summary::{summary, with_prefix};
#[cfg(feature = "plot")]
use sweep::ranges;
pub use sweep::{sweep_json, sweep_summary, sweep_warnings};
pub use tables::csv;
pub use validation::validation;
