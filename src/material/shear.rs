//! How a scene writes the relaxation of a body: terms of a series, or a power law.

use super::{PowerLaw, Shear, Terms};
use crate::input::quantity::{Duration, Modulus, RelaxationExponent, Stress, Viscosity};
use serde::de::value::MapAccessDeserializer;
use serde::ser::SerializeStruct;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};
use std::fmt;

/// The name before the fields of a power law. RON takes it or leaves it out; in JSON it stands around them.
const NAME: &str = "PowerLaw";

/// As a scene writes it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Written {
    #[serde(default)]
    equilibrium: Stress,
    #[serde(default)]
    terms: Terms,
    #[serde(default)]
    viscosity: Viscosity,
    modulus: Option<Modulus>,
    exponent: Option<RelaxationExponent>,
    time: Option<Duration>,
    #[serde(rename = "PowerLaw")]
    around: Option<Around>,
}

/// What stands in JSON within the name.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Around {
    #[serde(default)]
    equilibrium: Stress,
    #[serde(default)]
    terms: Terms,
    #[serde(default)]
    viscosity: Viscosity,
    modulus: Modulus,
    exponent: RelaxationExponent,
    time: Duration,
}

impl Written {
    const FIELDS: &[&str] = &["equilibrium", "terms", "viscosity", "modulus", "exponent", "time", NAME];

    fn shear<E: de::Error>(self) -> Result<Shear, E> {
        let Self { equilibrium, terms, viscosity, modulus, exponent, time, around } = self;
        let outside = [modulus.is_some(), exponent.is_some(), time.is_some()];
        let empty = Shear { equilibrium, terms, viscosity, power_law: None };
        let bare = empty == Shear::default();
        match (around, modulus, exponent, time) {
            (None, None, None, None) => Ok(empty),
            (None, Some(modulus), Some(exponent), Some(time)) => {
                Ok(Shear { power_law: Some(PowerLaw { modulus, exponent, time }), ..empty })
            }
            (None, None, _, _) => Err(E::missing_field("modulus")),
            (None, _, None, _) => Err(E::missing_field("exponent")),
            (None, _, _, None) => Err(E::missing_field("time")),
            (Some(around), ..) if bare && outside == [false; 3] => Ok(around.shear()),
            (Some(_), ..) => Err(E::custom("a field stands beside PowerLaw: expected all fields within it")),
        }
    }
}

impl Around {
    fn shear(self) -> Shear {
        let Self { equilibrium, terms, viscosity, modulus, exponent, time } = self;
        Shear { equilibrium, terms, viscosity, power_law: Some(PowerLaw { modulus, exponent, time }) }
    }
}

struct ShearVisitor;

impl<'de> de::Visitor<'de> for ShearVisitor {
    type Value = Shear;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("(equilibrium: …, terms: […], viscosity: …) or PowerLaw(modulus: …, exponent: …, time: …)")
    }

    fn visit_map<A: de::MapAccess<'de>>(self, map: A) -> Result<Shear, A::Error> {
        Written::deserialize(MapAccessDeserializer::new(map))?.shear()
    }
}

impl<'de> Deserialize<'de> for Shear {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_struct(NAME, Written::FIELDS, ShearVisitor)
    }
}

/// What a power law has beside itself, and itself.
#[derive(Serialize)]
struct Named<'s> {
    equilibrium: Stress,
    terms: &'s Terms,
    viscosity: Viscosity,
    modulus: Modulus,
    exponent: RelaxationExponent,
    time: Duration,
}

impl Serialize for Shear {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self { equilibrium, terms, viscosity, power_law } = self;
        let (equilibrium, viscosity) = (*equilibrium, *viscosity);
        if let Some(PowerLaw { modulus, exponent, time }) = *power_law {
            let named = Named { equilibrium, terms, viscosity, modulus, exponent, time };
            return serializer.serialize_newtype_variant("Shear", 0, NAME, &named);
        }
        let mut fields = serializer.serialize_struct("Shear", 3)?;
        fields.serialize_field("equilibrium", &equilibrium)?;
        fields.serialize_field("terms", terms)?;
        fields.serialize_field("viscosity", &viscosity)?;
        fields.end()
    }
}
