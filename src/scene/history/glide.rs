//! Motion along the surface: over a body that remembers, or rolling with a traction.

use super::list::{one_or_more, some_or_more};
use crate::input::quantity::{Creepage, Duration, Force, Speed};
use crate::scene::stage::{Path, Stage};
use serde::{Deserialize, Serialize};

/// Steady motion along the surface, gliding or rolling; what is prescribed of depth or force stays.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Glide {
    /// Speed [m/s], or a list of speeds.
    #[serde(deserialize_with = "one_or_more")]
    pub speed: Vec<Speed>,
    /// Duration [s]; without one the steady state at each speed is asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub over: Option<Duration>,
    /// Creepage of a body that rolls with friction, or a list: by how much its surface goes faster than the other one,
    /// over the speed of rolling; below zero it brakes.
    #[serde(default, skip_serializing_if = "Option::is_none", deserialize_with = "some_or_more")]
    pub creepage: Option<Vec<Creepage>>,
    /// Tangential force [N] that a body transmits as it rolls with friction, or a list, in the place of the creepage.
    #[serde(default, skip_serializing_if = "Option::is_none", deserialize_with = "some_or_more")]
    pub traction: Option<Vec<Force>>,
}

/// How a body moves along the surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Motion {
    /// The same points of it stay in contact.
    Glides,
    /// It lays down one point after the other.
    Rolls,
}

impl Glide {
    /// The stage of a motion with a duration; a steady state has none.
    pub(super) fn stage(&self, rest: Stage) -> Option<Stage> {
        let (over, speed) = (self.over?.si(), self.speed.first()?.si());
        Some(Stage { control: None, tangential: Path::Steady { speed }, over, ..rest })
    }

    /// Whether it asks for steady states.
    #[must_use]
    pub fn is_steady(&self) -> bool {
        self.over.is_none()
    }

    /// Whether a creepage or a tangential force is prescribed.
    #[must_use]
    pub fn has_traction(&self) -> bool {
        self.creepage.is_some() || self.traction.is_some()
    }
}
