//! Theories of rough contact beside which a bed or a half-space solution is shown.
//!
//! Closed forms and small quadratures, numbers in and numbers out. None of them is used to compute a bed.

mod adhesive_area;
mod exact_range;
mod greenwood_williamson;
mod pressure_field;
mod scaling;
mod survival;

pub use crate::contact::plane::{
    Connection, ConnectivityError, GrossSliding, PlaneContact, WavyParabola, Westergaard, flat_punch_load,
    single_harmonic_load,
};
pub use adhesive_area::{AdhesiveContact, AdhesiveRoughness, NotSettled, Region};
pub use exact_range::{ExactRange, exact_ranges, first_fall};
pub use greenwood_williamson::{GreenwoodWilliamson, SummitStatistics, gaussian_tail};
pub use pressure_field::{PerssonContact, area_fraction, low_load_area_slope};
pub use scaling::{StiffnessLaw, contact_conductance, plasticity_index, power_law_fit, stiffness_exponent};
