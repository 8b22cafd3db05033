//! Theories of rough contact beside which a bed or a half-space solution is shown.
//!
//! Closed forms and small quadratures, numbers in and numbers out. None of them is used to compute a bed.

mod beside;
mod exact_range;
mod greenwood_williamson;
mod persson;
mod scaling;

pub use crate::contact::plane::{
    Connection, GrossSliding, PlaneContact, WavyParabola, Westergaard, flat_punch_load, single_harmonic_load,
};
pub use beside::in_words;
pub use exact_range::{ExactRange, exact_ranges};
pub use greenwood_williamson::{GreenwoodWilliamson, SummitStatistics, gaussian_tail};
pub use persson::{area_fraction, low_load_area_slope};
pub use scaling::{StiffnessLaw, contact_conductance, plasticity_index, power_law_fit, stiffness_exponent};
