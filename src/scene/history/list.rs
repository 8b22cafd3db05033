//! A quantity, a list of them, or a range.

use crate::input::quantity::{Dimension, Domain, Quantity};
use crate::input::values::{Range, Values};
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
        if text.contains("..")
            && let Values::Range(range) = text.parse().map_err(E::custom)?
        {
            return ranged(&range);
        }
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

/// The values of a range, as a sweep has them: `"1 mm/s..1 m/s:20log"`.
fn ranged<D: Dimension, R: Domain, E: de::Error>(range: &Range) -> Result<Vec<Quantity<D, R>>, E> {
    let end = |text: &str| text.parse::<Quantity<D, R>>().map_err(E::custom);
    let values = range.between(end(&range.from)?.si(), end(&range.to)?.si()).map_err(E::custom)?;
    values.into_iter().map(|value| Quantity::new(value).map_err(E::custom)).collect()
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::quantity::{AboveZero, MetrePerSecond};
    use serde::de::value::{Error, StrDeserializer};

    fn speeds(text: &str) -> Result<Vec<f64>, String> {
        let read = one_or_more::<MetrePerSecond, AboveZero, _>(StrDeserializer::<Error>::new(text));
        read.map(|speeds| speeds.iter().map(|speed| speed.si()).collect()).map_err(|error| error.to_string())
    }

    #[test]
    fn a_range_has_its_ends_and_equal_ratios() {
        let all = speeds("1 mm/s..1 m/s:4log").unwrap();
        let exact = [1e-3, 1e-2, 0.1, 1.0];
        assert!(all.len() == 4 && all.iter().zip(exact).all(|(v, e)| (v / e - 1.0).abs() < 1e-15), "{all:?}");
        assert_eq!(speeds("1 m/s..2 m/s:3").unwrap(), [1.0, 1.5, 2.0]);
    }

    #[test]
    fn a_wrong_range_says_what_is_wrong() {
        assert!(speeds("1 mm/s..1 m/s").unwrap_err().contains("does not say how many values"));
        assert!(speeds("1 mm/s..1 N:3").unwrap_err().contains("a speed in one of"));
        assert!(speeds("0 m/s..1 m/s:3log").unwrap_err().contains("above zero"));
    }
}
