//! A value of any type, in the place of one that cannot be read, so that the rest of a scene can.

use serde::de::value::{Error, StrDeserializer};
use serde::de::{self, DeserializeSeed, IntoDeserializer, Visitor};

/// What stands for a value that says itself what it may be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Guise {
    /// 0.1, which every quantity may be.
    Number,
    /// An empty text.
    Text,
    /// A list without elements.
    List,
}

impl Guise {
    /// The one to try if this one will not do.
    pub fn next(self) -> Option<Self> {
        match self {
            Self::Number => Some(Self::Text),
            Self::Text => Some(Self::List),
            Self::List => None,
        }
    }
}

/// The stand-in; of an enum it is the first kind, of a structure all fields are stand-ins.
#[derive(Debug, Clone, Copy)]
pub struct StandIn {
    guise: Guise,
    place: Place,
}

/// Where a stand-in stands, which decides whether something optional is there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Place {
    /// In the place of a value that is given or lacking: it is there.
    Asked,
    /// Within another stand-in: it is left out.
    Within,
}

impl StandIn {
    pub fn new(guise: Guise) -> Self {
        Self { guise, place: Place::Asked }
    }

    /// A part of it.
    fn within(self) -> Self {
        Self { place: Place::Within, ..self }
    }
}

/// Forwards what is asked for by type to one answer of the visitor.
macro_rules! answers {
    ($($asked:ident: $visit:ident($($value:expr)?)),* $(,)?) => {$(
        fn $asked<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
            visitor.$visit($($value)?)
        }
    )*};
}

impl<'de> de::Deserializer<'de> for StandIn {
    type Error = Error;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        match self.guise {
            Guise::Number => visitor.visit_f64(0.1),
            Guise::Text => visitor.visit_str(""),
            Guise::List => self.deserialize_seq(visitor),
        }
    }

    answers! {
        deserialize_bool: visit_bool(false),
        deserialize_i8: visit_i8(1),
        deserialize_i16: visit_i16(1),
        deserialize_i32: visit_i32(1),
        deserialize_i64: visit_i64(1),
        deserialize_u8: visit_u8(1),
        deserialize_u16: visit_u16(1),
        deserialize_u32: visit_u32(1),
        deserialize_u64: visit_u64(1),
        deserialize_f32: visit_f32(0.1),
        deserialize_f64: visit_f64(0.1),
        deserialize_char: visit_char(' '),
        deserialize_str: visit_str(""),
        deserialize_string: visit_str(""),
        deserialize_bytes: visit_bytes(&[]),
        deserialize_byte_buf: visit_bytes(&[]),
        deserialize_unit: visit_unit(),
        deserialize_identifier: visit_str(""),
        deserialize_ignored_any: visit_unit(),
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        match self.place {
            Place::Asked => visitor.visit_some(self.within()),
            Place::Within => visitor.visit_none(),
        }
    }

    fn deserialize_unit_struct<V: Visitor<'de>>(self, _: &'static str, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_unit()
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(self, _: &'static str, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        self.deserialize_tuple(0, visitor)
    }

    fn deserialize_tuple<V: Visitor<'de>>(self, length: usize, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_seq(StandIns { each: self, left: length, fields: &[] })
    }

    fn deserialize_tuple_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        length: usize,
        visitor: V,
    ) -> Result<V::Value, Error> {
        self.deserialize_tuple(length, visitor)
    }

    fn deserialize_map<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        self.deserialize_struct("", &[], visitor)
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        visitor.visit_map(StandIns { each: self, left: 0, fields })
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        kinds: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        visitor.visit_enum(FirstKind { name: kinds.first().copied().unwrap_or(""), content: self })
    }
}

/// Elements of a list, or fields of a structure.
struct StandIns {
    each: StandIn,
    left: usize,
    fields: &'static [&'static str],
}

impl<'de> de::SeqAccess<'de> for StandIns {
    type Error = Error;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>, Error> {
        let Some(left) = self.left.checked_sub(1) else { return Ok(None) };
        self.left = left;
        seed.deserialize(self.each.within()).map(Some)
    }
}

impl<'de> de::MapAccess<'de> for StandIns {
    type Error = Error;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, Error> {
        let Some((first, rest)) = self.fields.split_first() else { return Ok(None) };
        self.fields = rest;
        seed.deserialize((*first).into_deserializer()).map(Some)
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, Error> {
        seed.deserialize(self.each.within())
    }
}

/// The first kind of an enum.
struct FirstKind {
    name: &'static str,
    content: StandIn,
}

impl<'de> de::EnumAccess<'de> for FirstKind {
    type Error = Error;
    type Variant = StandIn;

    fn variant_seed<V: DeserializeSeed<'de>>(self, seed: V) -> Result<(V::Value, StandIn), Error> {
        let name: StrDeserializer<'_, Error> = self.name.into_deserializer();
        Ok((seed.deserialize(name)?, self.content))
    }
}

impl<'de> de::VariantAccess<'de> for StandIn {
    type Error = Error;

    fn unit_variant(self) -> Result<(), Error> {
        Ok(())
    }

    fn newtype_variant_seed<T: DeserializeSeed<'de>>(self, seed: T) -> Result<T::Value, Error> {
        seed.deserialize(self)
    }

    fn tuple_variant<V: Visitor<'de>>(self, length: usize, visitor: V) -> Result<V::Value, Error> {
        de::Deserializer::deserialize_tuple(self, length, visitor)
    }

    fn struct_variant<V: Visitor<'de>>(self, fields: &'static [&'static str], visitor: V) -> Result<V::Value, Error> {
        de::Deserializer::deserialize_struct(self, "", fields, visitor)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;
    use serde::Deserialize;

    /// A whole scene of stand-ins: whatever cannot be read has one.
    #[test]
    fn there_is_a_stand_in_for_every_part_of_a_scene() {
        let scene = Scene::deserialize(StandIn::new(Guise::Number)).unwrap();
        assert!(scene.history.is_empty() && scene.springs.is_none());
    }
}
