//! A quantity, or a list of them.

use crate::input::quantity::{Dimension, Domain, Quantity};
use serde::{Deserializer, de};
use std::fmt;
use std::marker::PhantomData;

struct OneOrMore<D, R>(PhantomData<(D, R)>);

impl<'de, D: Dimension, R: Domain> de::Visitor<'de> for OneOrMore<D, R> {
    type Value = Vec<Quantity<D, R>>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match D::UNITS[0].0 {
            "" => write!(f, "{}, or a list of such", D::NAME),
            unit => write!(f, "{} such as \"1 {unit}\", or a list of such", D::NAME),
        }
    }

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<Self::Value, E> {
        Ok(vec![Quantity::new(value).map_err(E::custom)?])
    }

    #[expect(clippy::cast_precision_loss, reason = "a whole number above 2^53 in a scene is a rounded number anyway")]
    fn visit_i64<E: de::Error>(self, value: i64) -> Result<Self::Value, E> {
        self.visit_f64(value as f64)
    }

    #[expect(clippy::cast_precision_loss, reason = "a whole number above 2^53 in a scene is a rounded number anyway")]
    fn visit_u64<E: de::Error>(self, value: u64) -> Result<Self::Value, E> {
        self.visit_f64(value as f64)
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<Self::Value, E> {
        Ok(vec![text.parse().map_err(E::custom)?])
    }

    fn visit_seq<A: de::SeqAccess<'de>>(self, mut seq: A) -> Result<Self::Value, A::Error> {
        let mut quantities = Vec::new();
        while let Some(quantity) = seq.next_element()? {
            quantities.push(quantity);
        }
        Ok(quantities)
    }
}

pub(super) fn one_or_more<'de, D: Dimension, R: Domain, P: Deserializer<'de>>(
    deserializer: P,
) -> Result<Vec<Quantity<D, R>>, P::Error> {
    deserializer.deserialize_any(OneOrMore(PhantomData))
}

/// The same of a field that may be left out.
pub(super) fn some_or_more<'de, D: Dimension, R: Domain, P: Deserializer<'de>>(
    deserializer: P,
) -> Result<Option<Vec<Quantity<D, R>>>, P::Error> {
    one_or_more(deserializer).map(Some)
}
