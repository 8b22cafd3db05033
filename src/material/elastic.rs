//! Bodies that are elastic, or elastic until they yield.

use super::alone::Stiffness;
use crate::input::quantity::{Modulus, Poisson, QuantityError};
use serde::ser::SerializeStruct;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

/// Isotropic, linearly elastic material; a scene gives Young's modulus `young` or the shear modulus `shear`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Elastic {
    /// Young's modulus E [Pa].
    pub young: Modulus,
    /// Poisson's ratio ν.
    pub poisson: Poisson,
    /// Yield stress in uniaxial tension [Pa]; if given, a contact pressure beyond first yield is a warning.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub yield_stress: Option<Modulus>,
}

impl<'de> Deserialize<'de> for Elastic {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        /// As a scene writes it, with one of two moduli.
        #[derive(Deserialize)]
        #[serde(rename = "Elastic", deny_unknown_fields)]
        struct Written {
            young: Option<Modulus>,
            shear: Option<Modulus>,
            poisson: Poisson,
            yield_stress: Option<Modulus>,
        }
        let Written { young, shear, poisson, yield_stress } = Written::deserialize(deserializer)?;
        let young = match (young, shear) {
            (Some(young), None) => young,
            (None, Some(shear)) => young_of_shear(shear, poisson).map_err(de::Error::custom)?,
            (None, None) => return Err(de::Error::missing_field("young")),
            (Some(_), Some(_)) => {
                return Err(de::Error::custom("an Elastic body has both `young` and `shear`: expected one of the two"));
            }
        };
        Ok(Self { young, poisson, yield_stress })
    }
}

/// E = 2G(1+ν).
fn young_of_shear(shear: Modulus, poisson: Poisson) -> Result<Modulus, QuantityError> {
    Modulus::new(2.0 * shear.si() * (1.0 + poisson.si()))
}

/// Isotropic material, linearly elastic until it yields and perfectly plastic from then on; a scene gives the yield stress
/// or the hardness.
#[derive(Debug, Clone, PartialEq)]
pub struct Plastic {
    /// Young's modulus E [Pa].
    pub young: Modulus,
    /// Poisson's ratio ν.
    pub poisson: Poisson,
    /// What it bears.
    pub limit: PlasticLimit,
}

/// What a body that yields bears.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PlasticLimit {
    /// Yield stress Y [Pa] in uniaxial tension: it yields under 1.6 Y.
    YieldStress(Modulus),
    /// Largest pressure H [Pa] itself, some 2.8 Y where all of a contact yields (Tabor 1951).
    Hardness(Modulus),
}

impl Serialize for Plastic {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut written = serializer.serialize_struct("Plastic", 3)?;
        written.serialize_field("young", &self.young)?;
        written.serialize_field("poisson", &self.poisson)?;
        match &self.limit {
            PlasticLimit::YieldStress(stress) => written.serialize_field("yield_stress", stress)?,
            PlasticLimit::Hardness(hardness) => written.serialize_field("hardness", hardness)?,
        }
        written.end()
    }
}

impl<'de> Deserialize<'de> for Plastic {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        /// As a scene writes it, with one of two limits.
        #[derive(Deserialize)]
        #[serde(rename = "Plastic", deny_unknown_fields)]
        struct Written {
            young: Modulus,
            poisson: Poisson,
            yield_stress: Option<Modulus>,
            hardness: Option<Modulus>,
        }
        let Written { young, poisson, yield_stress, hardness } = Written::deserialize(deserializer)?;
        let limit = match (yield_stress, hardness) {
            (Some(stress), None) => PlasticLimit::YieldStress(stress),
            (None, Some(hardness)) => PlasticLimit::Hardness(hardness),
            (None, None) => return Err(de::Error::missing_field("yield_stress")),
            (Some(_), Some(_)) => {
                return Err(de::Error::custom(
                    "a Plastic body has both `yield_stress` and `hardness`: expected one of the two",
                ));
            }
        };
        Ok(Self { young, poisson, limit })
    }
}

impl Elastic {
    /// E/(1−ν²) [Pa], the modulus against a rigid body.
    #[must_use]
    pub fn plane_modulus(&self) -> f64 {
        self.stiffness().normal
    }

    pub(super) fn stiffness(&self) -> Stiffness {
        let poisson = self.poisson.si();
        Stiffness::new(self.young.si() / ((1.0 - poisson) * (1.0 + poisson)), poisson)
    }
}

/// Limiting pressure over yield stress: that of first yield below a ball of ν ≈ 0.3 (Johnson 1985, §6.1).
pub const YIELD_PRESSURE: f64 = 1.6;

impl Plastic {
    /// Largest pressure [Pa].
    #[must_use]
    pub fn greatest_pressure(&self) -> f64 {
        match self.limit {
            PlasticLimit::YieldStress(stress) => YIELD_PRESSURE * stress.si(),
            PlasticLimit::Hardness(hardness) => hardness.si(),
        }
    }

    /// As it is before it yields.
    pub(super) fn elastic(&self) -> Elastic {
        Elastic { young: self.young, poisson: self.poisson, yield_stress: None }
    }
}
