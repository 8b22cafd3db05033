//! Load histories, as a scene names them.

pub mod impacts;
mod motion;
pub mod rules;

pub use motion::{Driven, Motion};

use crate::input::quantity::{
    Amplitude, Displacement, Duration, Force, Frequency, IncidenceAngle, Mass, Positive, Speed, Spin,
};
use serde::{Deserialize, Deserializer, Serialize, de};
use std::path::PathBuf;

/// One entry of a history.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
pub enum Entry {
    /// Moves to an indentation at constant speed.
    Indent(Indent),
    /// Moves to a normal force at constant rate.
    Press(Press),
    /// Keeps the depth.
    Hold(Hold),
    /// Keeps the normal force.
    HoldForce(Hold),
    /// Moves tangentially to a displacement at constant speed.
    Slide(Slide),
    /// Oscillates the depth about the present one.
    Oscillate(Oscillate),
    /// Oscillates the tangential displacement about the present one.
    Shake(Oscillate),
    /// Retracts at constant speed until the bodies part.
    Retract(Retract),
    /// A free impact; the only entry of its history.
    Impact(Impact),
    /// A table of time and indentation or force, next to the scene.
    Table(PathBuf),
}

/// Ramp of the indentation.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Indent {
    /// Indentation at the end [m].
    pub to: Displacement,
    /// Duration [s].
    pub over: Duration,
}

/// Ramp of the normal force.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Press {
    /// Normal force at the end [N].
    pub to: Force,
    /// Duration [s].
    pub over: Duration,
}

/// A time in which what was controlled stays.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Hold {
    /// Duration [s].
    pub over: Duration,
}

/// Ramp of the tangential displacement.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Slide {
    /// Tangential displacement at the end [m].
    pub to: Displacement,
    /// Duration [s].
    pub over: Duration,
}

/// Sinusoidal motion about the present position.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Oscillate {
    /// Amplitude [m].
    pub amplitude: Amplitude,
    /// Frequency [Hz].
    pub frequency: Frequency,
    /// Number of cycles.
    pub cycles: Positive,
}

/// Retraction until the bodies part.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Retract {
    /// Speed [m/s].
    pub speed: Speed,
}

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

struct SpeedsVisitor;

impl<'de> de::Visitor<'de> for SpeedsVisitor {
    type Value = Vec<Speed>;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("a speed such as \"1 m/s\", or a list of speeds")
    }

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<Vec<Speed>, E> {
        Ok(vec![Speed::new(value).map_err(E::custom)?])
    }

    #[expect(clippy::cast_precision_loss, reason = "a whole number above 2^53 in a scene is a rounded number anyway")]
    fn visit_i64<E: de::Error>(self, value: i64) -> Result<Vec<Speed>, E> {
        self.visit_f64(value as f64)
    }

    #[expect(clippy::cast_precision_loss, reason = "a whole number above 2^53 in a scene is a rounded number anyway")]
    fn visit_u64<E: de::Error>(self, value: u64) -> Result<Vec<Speed>, E> {
        self.visit_f64(value as f64)
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<Vec<Speed>, E> {
        Ok(vec![text.parse().map_err(E::custom)?])
    }

    fn visit_seq<A: de::SeqAccess<'de>>(self, mut seq: A) -> Result<Vec<Speed>, A::Error> {
        let mut speeds = Vec::new();
        while let Some(speed) = seq.next_element()? {
            speeds.push(speed);
        }
        Ok(speeds)
    }
}

fn one_or_more<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<Speed>, D::Error> {
    deserializer.deserialize_any(SpeedsVisitor)
}
