//! Pads: many springs or rounded summits whose heights are scattered.

use crate::input::quantity::{Length, Positive};
use serde::{Deserialize, Serialize};

/// A nominally flat pad whose heights are scattered normally about its mean plane.
///
/// On a `Winkler` sheet each place of the area is a spring of its own; with adhesion it holds until it is stretched by
/// √(2wh/M), where its energy is the work of adhesion w (Popov, Contact Mechanics and Friction, ch. 3, problem 3). With
/// `summits` on elastic half-spaces each summit is a ball that knows nothing of the others (Greenwood & Williamson 1966),
/// adhesive ones by Johnson, Kendall & Roberts (Fuller & Tabor 1975). The indentation counts from the mean plane of the
/// heights, so that it is negative where the highest touch.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Pad {
    /// Side [m] of the square that is its nominal area.
    pub side: Length,
    /// Standard deviation σ [m] of the heights.
    pub deviation: Length,
    /// Rounded summits, if it is these that touch.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub summits: Option<Summits>,
}

/// Summits of one radius.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Summits {
    /// Their number N on the area.
    pub number: Positive,
    /// Their radius R [m].
    pub radius: Length,
}

impl Pad {
    /// Nominal area [m²].
    #[must_use]
    pub fn area(&self) -> f64 {
        self.side.si().powi(2)
    }
}
