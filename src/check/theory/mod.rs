//! Theories of rough contact beside which a bed or a half-space solution is shown.
//!
//! Closed forms and small quadratures, numbers in and numbers out. None of them is used to compute a bed.
//!
//! # Examples
//! ```
//! use springbed::check::theory::{area_fraction, low_load_area_slope, stiffness_exponent};
//!
//! // Persson: a pressure of a thousandth of E* times the rms slope touches on √(8/π) thousandths of the area.
//! let share = area_fraction(1e-3 * 1e9 * 0.1, 1e9, 0.1);
//! assert!((share / (1e-3 * low_load_area_slope()) - 1.0).abs() < 1e-5);
//! assert!((stiffness_exponent(0.8) - 1.0 / 1.8).abs() < 1e-15);
//! ```

mod beside;
mod exact_range;
mod ground;
mod greenwood_williamson;
mod persson;
mod scaling;

pub use crate::contact::plane::{
    Connection, GrossSliding, PlaneContact, WavyParabola, Westergaard, flat_punch_load, single_harmonic_load,
};
pub use beside::{NominallyFlat, in_words, of_roughness};
pub use exact_range::{ExactRange, exact_ranges};
pub use greenwood_williamson::{GreenwoodWilliamson, SummitStatistics, gaussian_tail};
pub use ground::{film_weight, gel_series};
pub use persson::{area_fraction, low_load_area_slope};
pub use scaling::{StiffnessLaw, contact_conductance, plasticity_index, power_law_fit, stiffness_exponent};
