//! A free impact, as a scene names it.

use crate::input::quantity::{IncidenceAngle, Mass, Speed, Spin};
use serde::{Deserialize, Deserializer, Serialize, de};

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

pub(super) fn one_or_more<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<Speed>, D::Error> {
    deserializer.deserialize_any(SpeedsVisitor)
}
