//! Several tips of one body, each at a place of its own.

use super::{Profile, Shape};
use crate::input::quantity::Displacement;
use crate::input::table::Tables;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// A round shape beside others of the same body.
///
/// Tips near each other do not carry what each would alone: one lifts the other off by F/(πE*D) at the distance D. Only
/// a half-space knows that.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Tip {
    /// The round shape.
    pub shape: Box<Shape>,
    /// Place of its axis along x [m]; 0 if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub x: Option<Displacement>,
    /// Place of its axis along y [m]; 0 if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub y: Option<Displacement>,
    /// How much farther away its apex is than height 0 [m]; 0 if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub height: Option<Displacement>,
}

/// A tip ready for evaluation.
#[derive(Debug, Clone)]
pub struct PlacedTip {
    /// The profile over the distance from its axis.
    pub profile: Arc<dyn Profile>,
    /// Place of its axis along x and y [m].
    pub at: [f64; 2],
    /// Height of its apex [m].
    pub height: f64,
}

impl Tip {
    /// The tip with its tables read.
    ///
    /// # Errors
    /// It is not round, or its table cannot be read; the text says what would be right.
    pub fn placed(&self, tables: &dyn Tables) -> Result<PlacedTip, String> {
        let round = matches!(self.shape.family(), super::Family::Round) && !self.shape.is_plane();
        if !round || matches!(*self.shape, Shape::Ellipsoid(_)) {
            return Err(format!("{} is no tip: expected a round shape such as Sphere(radius: …)", self.shape.name()));
        }
        let profile = self.shape.profile(tables).map_err(|error| error.to_string())?;
        let metres = |quantity: Option<Displacement>| quantity.map_or(0.0, Displacement::si);
        Ok(PlacedTip { profile, at: [metres(self.x), metres(self.y)], height: metres(self.height) })
    }
}

impl PlacedTip {
    /// Height [m] at x and y [m]; +∞ where it has no material.
    #[must_use]
    pub fn height_at(&self, x: f64, y: f64) -> f64 {
        let r = (x - self.at[0]).hypot(y - self.at[1]);
        if r > self.profile.rim().radius() { f64::INFINITY } else { self.height + self.profile.height(r) }
    }
}
