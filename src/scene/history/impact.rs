//! A free impact, as a scene names it.

use super::list::one_or_more;
use crate::input::quantity::{IncidenceAngle, Mass, Speed, Spin};
use serde::{Deserialize, Serialize};

/// Free impact of the indenter on the other body.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Impact {
    /// Mass of the indenter [kg].
    pub mass: Mass,
    /// Speed at first touch [m/s], or a list of speeds.
    #[serde(deserialize_with = "one_or_more")]
    pub speed: Vec<Speed>,
    /// Angle of incidence from the surface normal [rad].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angle: Option<IncidenceAngle>,
    /// Spin before the impact [rad/s].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spin: Option<Spin>,
}

impl Impact {
    /// Angle of incidence from the normal [rad].
    #[must_use]
    pub fn incidence(&self) -> f64 {
        self.angle.map_or(0.0, |angle| angle.si())
    }

    /// Whether it has an angle or a spin.
    #[must_use]
    pub fn is_oblique(&self) -> bool {
        self.angle.is_some_and(|angle| angle.si() > 0.0) || self.spin.is_some_and(|spin| spin.si().abs() > 0.0)
    }
}
