//! Bodies as a scene writes them, and what an elastic one is.

use super::layered::{Graded, Layered, Winkler};
use super::pair::Stiffness;
use super::power_law::PowerLaw;
use super::viscoelastic::Viscoelastic;
use crate::input::quantity::{Modulus, Poisson, QuantityError};
use serde::ser::SerializeStruct;
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

/// One of the two bodies.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
pub enum Body {
    /// Cannot deform.
    Rigid,
    /// Isotropic, linearly elastic half-space.
    Elastic(Elastic),
    /// Isotropic, linearly viscoelastic half-space.
    Viscoelastic(Viscoelastic),
    /// Layers on a base.
    Layered(Layered),
    /// A thin sheet of independent springs.
    Winkler(Winkler),
    /// A half-space whose modulus is a power of the depth.
    Graded(Graded),
    /// Isotropic, linearly elastic until it yields, then perfectly plastic.
    Plastic(Plastic),
}

impl Body {
    /// What it is called in a scene.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Rigid => "Rigid",
            Self::Elastic(_) => "Elastic",
            Self::Viscoelastic(_) => "Viscoelastic",
            Self::Plastic(_) => "Plastic",
            Self::Layered(_) => "Layered",
            Self::Winkler(_) => "Winkler",
            Self::Graded(_) => "Graded",
        }
    }

    /// Poisson's ratio ν where it is the same at all depths; of a rigid body, of layers and of springs none.
    #[must_use]
    pub fn poisson(&self) -> Option<f64> {
        match self {
            Self::Elastic(elastic) => Some(elastic.poisson.si()),
            Self::Viscoelastic(viscoelastic) => Some(viscoelastic.poisson.si()),
            Self::Graded(graded) => Some(graded.poisson.si()),
            Self::Plastic(plastic) => Some(plastic.poisson.si()),
            Self::Rigid | Self::Layered(_) | Self::Winkler(_) => None,
        }
    }

    /// Yield stress Y [Pa] of an elastic body, if it is stated: there the contact is no longer known.
    #[must_use]
    pub fn yield_stress(&self) -> Option<f64> {
        match self {
            Self::Elastic(elastic) => elastic.yield_stress.map(Modulus::si),
            Self::Viscoelastic(_)
            | Self::Rigid
            | Self::Plastic(_)
            | Self::Layered(_)
            | Self::Winkler(_)
            | Self::Graded(_) => None,
        }
    }

    /// Largest pressure [Pa] that a body bears whose yielding is followed.
    #[must_use]
    pub fn hardness(&self) -> Option<f64> {
        match self {
            Self::Plastic(plastic) => Some(plastic.greatest_pressure()),
            Self::Rigid
            | Self::Elastic(_)
            | Self::Viscoelastic(_)
            | Self::Layered(_)
            | Self::Winkler(_)
            | Self::Graded(_) => None,
        }
    }

    /// The power law by which it relaxes, if it does by one.
    #[must_use]
    pub fn power_law(&self) -> Option<&PowerLaw> {
        match self {
            Self::Viscoelastic(body) => body.shear.power_law.as_ref(),
            Self::Layered(body) => {
                body.layers.iter().map(|layer| &layer.body).chain([body.base.as_ref()]).find_map(Self::power_law)
            }
            Self::Rigid | Self::Elastic(_) | Self::Winkler(_) | Self::Graded(_) | Self::Plastic(_) => None,
        }
    }

    /// Whether it relaxes.
    #[must_use]
    pub fn relaxes(&self) -> bool {
        match self {
            Self::Rigid | Self::Elastic(_) | Self::Plastic(_) | Self::Winkler(_) | Self::Graded(_) => false,
            Self::Viscoelastic(_) => true,
            Self::Layered(body) => body.layers.iter().any(|layer| layer.body.relaxes()) || body.base.relaxes(),
        }
    }

    /// Whether its stiffness depends on the depth.
    #[must_use]
    pub fn is_uneven(&self) -> bool {
        match self {
            Self::Rigid | Self::Elastic(_) | Self::Viscoelastic(_) | Self::Plastic(_) => false,
            Self::Layered(_) | Self::Winkler(_) | Self::Graded(_) => true,
        }
    }
}

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
