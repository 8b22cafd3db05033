//! The flank of a cone as a scene writes it.

use crate::input::quantity::{HalfAngle, Positive};
use serde::de;

/// The slope t of a flank: given itself, or by the angle θ between axis and flank, t = cot θ.
///
/// Check: 70.3° is the cone with the contact area of a Berkovich tip, t = 0.358.
///
/// # Errors
/// Both are given, or neither.
pub(super) fn slope<E: de::Error>(
    of: &str,
    slope: Option<Positive>,
    half_angle: Option<HalfAngle>,
) -> Result<Positive, E> {
    match (slope, half_angle) {
        (Some(slope), None) => Ok(slope),
        (None, Some(angle)) => Positive::new(angle.si().tan().recip()).map_err(E::custom),
        (None, None) => Err(E::missing_field("slope")),
        (Some(_), Some(_)) => {
            Err(E::custom(format!("a {of} has both `slope` and `half_angle`: expected one of the two")))
        }
    }
}
