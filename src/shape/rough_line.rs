//! Rough line: the one-dimensional equivalent of an isotropic rough surface, alone or on a smooth shape.

use super::Shape;
use crate::input::quantity::Length;
use crate::shape::rough::SpectrumSource;
use serde::{Deserialize, Deserializer, Serialize, de};
use std::fmt;
use std::num::NonZeroUsize;

/// Rough line z(x) of a power spectrum on the one-dimensional profile g(x) of a smooth shape.
///
/// Stands for an isotropic surface with C₁D(q) = πqC(q) (Popov & Heß 2015, ch. 10). Approximate: force and stiffness
/// follow those of the surface, the real contact area does not.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields, rename = "RoughLine")]
pub struct RoughShape {
    /// Smooth shape under the roughness; nominally flat if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub base: Option<Box<Shape>>,
    /// Power spectrum of the surface.
    pub spectrum: SpectrumSource,
    /// Length of the line [m], side of the nominal area; at least the longest wave.
    pub length: Length,
    /// Springs on the length, at least two on the shortest wave; more cost memory and time only.
    pub points: NonZeroUsize,
    /// Seed of the random phases, or a list of them for an ensemble; 1 if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seed: Option<Seeds>,
    /// Number of seeds 1, 2, … of an ensemble, in place of `seed`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seeds: Option<NonZeroUsize>,
}

/// Seeds of random surfaces.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(transparent)]
pub struct Seeds(pub Vec<u64>);

impl RoughShape {
    /// The seeds, one per member of the ensemble.
    #[must_use]
    pub fn seeds(&self) -> Vec<u64> {
        match (&self.seed, self.seeds) {
            (Some(seeds), _) => seeds.0.clone(),
            (None, Some(count)) => (1..=count.get() as u64).collect(),
            (None, None) => vec![1],
        }
    }
}

impl<'de> Deserialize<'de> for Seeds {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(SeedsVisitor)
    }
}

struct SeedsVisitor;

impl<'de> de::Visitor<'de> for SeedsVisitor {
    type Value = Seeds;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a seed, a whole number from 0, or a list of them")
    }

    fn visit_u64<E: de::Error>(self, seed: u64) -> Result<Seeds, E> {
        Ok(Seeds(vec![seed]))
    }

    fn visit_i64<E: de::Error>(self, seed: i64) -> Result<Seeds, E> {
        let refused = || E::custom(format!("{seed} is out of range: expected a seed, a whole number from 0"));
        self.visit_u64(u64::try_from(seed).map_err(|_| refused())?)
    }

    fn visit_seq<A: de::SeqAccess<'de>>(self, mut list: A) -> Result<Seeds, A::Error> {
        let mut seeds = Vec::new();
        while let Some(seed) = list.next_element()? {
            seeds.push(seed);
        }
        if seeds.is_empty() {
            Err(de::Error::custom("the list is empty: expected at least one seed"))
        } else {
            Ok(Seeds(seeds))
        }
    }
}
