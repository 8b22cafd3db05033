//! Readers of serde that mend what is asked for and hand on all else.

use super::super::standin::Guise;
use super::{Mending, State};
use serde::Deserialize;
use serde::de::{self, DeserializeSeed, IgnoredAny, IntoDeserializer, Visitor};
use std::fmt;

/// A seed, parser, visitor or list of serde that mends what is asked for and hands on all else.
pub struct Watched<'m, I> {
    pub(super) inner: I,
    pub(super) mending: &'m Mending,
}

impl<'de, S: DeserializeSeed<'de>> DeserializeSeed<'de> for Watched<'_, S> {
    type Value = S::Value;

    fn deserialize<D: de::Deserializer<'de>>(self, parser: D) -> Result<S::Value, D::Error> {
        let Self { inner, mending } = self;
        let guise = mending.stand_ins.get(mending.path.borrow().as_str()).copied();
        let Some(guise) = guise else { return inner.deserialize(mending.watch(parser)) };
        mending.doing(State::PassingOver, || IgnoredAny::deserialize(parser))?;
        mending.stand_in(inner, guise)
    }
}

/// Asks the parser for whatever number there is, so that one that is not whole is a wrong value and not a fault of the notation.
macro_rules! any_number {
    ($($asked:ident),* $(,)?) => {$(
        fn $asked<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, D::Error> {
            self.deserialize_any(visitor)
        }
    )*};
}

/// Hands every question of a type on to the parser, the visitor watched.
macro_rules! handed_on {
    ($($asked:ident($($name:ident: $kind:ty),*)),* $(,)?) => {$(
        fn $asked<V: Visitor<'de>>(self, $($name: $kind,)* visitor: V) -> Result<V::Value, D::Error> {
            self.inner.$asked($($name,)* self.mending.watch(visitor))
        }
    )*};
}

impl<'de, D: de::Deserializer<'de>> de::Deserializer<'de> for Watched<'_, D> {
    type Error = D::Error;

    any_number! {
        deserialize_i8, deserialize_i16, deserialize_i32, deserialize_i64,
        deserialize_u8, deserialize_u16, deserialize_u32, deserialize_u64,
    }

    handed_on! {
        deserialize_any(), deserialize_bool(), deserialize_i128(), deserialize_u128(), deserialize_f32(), deserialize_f64(), deserialize_char(), deserialize_str(), deserialize_string(),
        deserialize_bytes(), deserialize_byte_buf(), deserialize_option(), deserialize_unit(),
        deserialize_unit_struct(name: &'static str), deserialize_newtype_struct(name: &'static str),
        deserialize_seq(), deserialize_tuple(length: usize),
        deserialize_tuple_struct(name: &'static str, length: usize), deserialize_map(),
        deserialize_struct(name: &'static str, fields: &'static [&'static str]),
        deserialize_enum(name: &'static str, kinds: &'static [&'static str]),
        deserialize_identifier(), deserialize_ignored_any(),
    }

    fn is_human_readable(&self) -> bool {
        self.inner.is_human_readable()
    }
}

/// Hands every simple value on to the visitor.
macro_rules! values {
    ($($visit:ident($kind:ty)),* $(,)?) => {$(
        fn $visit<E: de::Error>(self, value: $kind) -> Result<V::Value, E> {
            self.inner.$visit(value)
        }
    )*};
}

impl<'de, V: Visitor<'de>> Visitor<'de> for Watched<'_, V> {
    type Value = V::Value;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.inner.expecting(f)
    }

    values! {
        visit_bool(bool), visit_i8(i8), visit_i16(i16), visit_i32(i32), visit_i64(i64), visit_i128(i128),
        visit_u8(u8), visit_u16(u16), visit_u32(u32), visit_u64(u64), visit_u128(u128), visit_f32(f32), visit_f64(f64),
        visit_char(char), visit_str(&str), visit_borrowed_str(&'de str), visit_string(String), visit_bytes(&[u8]),
        visit_borrowed_bytes(&'de [u8]), visit_byte_buf(Vec<u8>),
    }

    fn visit_none<E: de::Error>(self) -> Result<V::Value, E> {
        self.inner.visit_none()
    }

    fn visit_unit<E: de::Error>(self) -> Result<V::Value, E> {
        self.inner.visit_unit()
    }

    fn visit_some<D: de::Deserializer<'de>>(self, parser: D) -> Result<V::Value, D::Error> {
        self.inner.visit_some(self.mending.watch(parser))
    }

    fn visit_newtype_struct<D: de::Deserializer<'de>>(self, parser: D) -> Result<V::Value, D::Error> {
        self.inner.visit_newtype_struct(self.mending.watch(parser))
    }

    fn visit_seq<A: de::SeqAccess<'de>>(self, list: A) -> Result<V::Value, A::Error> {
        self.inner.visit_seq(Elements { list, index: 0, mending: self.mending })
    }

    fn visit_map<A: de::MapAccess<'de>>(self, map: A) -> Result<V::Value, A::Error> {
        let supplied = self.mending.supplied.get(self.mending.path.borrow().as_str()).cloned().unwrap_or_default();
        self.inner.visit_map(Fields { map, names: Vec::new(), supplied, lacking: false, mending: self.mending })
    }

    fn visit_enum<A: de::EnumAccess<'de>>(self, kind: A) -> Result<V::Value, A::Error> {
        self.inner.visit_enum(self.mending.watch(kind))
    }
}

impl<'de, 'm, A: de::EnumAccess<'de>> de::EnumAccess<'de> for Watched<'m, A> {
    type Error = A::Error;
    type Variant = Watched<'m, A::Variant>;

    fn variant_seed<V: DeserializeSeed<'de>>(self, seed: V) -> Result<(V::Value, Self::Variant), A::Error> {
        let (kind, content) = self.inner.variant_seed(seed)?;
        Ok((kind, self.mending.watch(content)))
    }
}

impl<'de, A: de::VariantAccess<'de>> de::VariantAccess<'de> for Watched<'_, A> {
    type Error = A::Error;

    fn unit_variant(self) -> Result<(), A::Error> {
        self.inner.unit_variant()
    }

    fn newtype_variant_seed<T: DeserializeSeed<'de>>(self, seed: T) -> Result<T::Value, A::Error> {
        self.inner.newtype_variant_seed(self.mending.watch(seed))
    }

    fn tuple_variant<V: Visitor<'de>>(self, length: usize, visitor: V) -> Result<V::Value, A::Error> {
        self.inner.tuple_variant(length, self.mending.watch(visitor))
    }

    fn struct_variant<V: Visitor<'de>>(
        self,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, A::Error> {
        self.inner.struct_variant(fields, self.mending.watch(visitor))
    }
}

/// The elements of a list.
struct Elements<'m, A> {
    list: A,
    index: usize,
    mending: &'m Mending,
}

impl<'de, A: de::SeqAccess<'de>> de::SeqAccess<'de> for Elements<'_, A> {
    type Error = A::Error;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>, A::Error> {
        let step = format!("[{}]", self.index);
        self.index += 1;
        let Self { list, mending, .. } = self;
        mending.inside(&step, || list.next_element_seed(mending.watch(seed)))
    }

    fn size_hint(&self) -> Option<usize> {
        self.list.size_hint()
    }
}

/// The fields of a structure, and after them those that are supplied.
struct Fields<'m, A> {
    map: A,
    /// Names read so far; the last is the present one.
    names: Vec<String>,
    supplied: Vec<String>,
    /// Whether the present field is a supplied one.
    lacking: bool,
    mending: &'m Mending,
}

impl<'de, A: de::MapAccess<'de>> de::MapAccess<'de> for Fields<'_, A> {
    type Error = A::Error;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, A::Error> {
        let mut seed = Some(seed);
        while let Some(key) =
            self.map.next_key_seed(FieldName { seed: &mut seed, names: &mut self.names, mending: self.mending })?
        {
            if key.is_some() {
                return Ok(key);
            }
            self.mending.doing(State::PassingOver, || self.map.next_value::<IgnoredAny>())?;
        }
        let (Some(name), Some(seed)) = (self.supplied.pop(), seed) else { return Ok(None) };
        self.lacking = true;
        seed.deserialize(name.into_deserializer()).map(Some)
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, A::Error> {
        let Self { map, names, mending, .. } = self;
        if self.lacking {
            return mending.stand_in(seed, Guise::Number);
        }
        let name = names.last().map_or("", String::as_str);
        let step = if mending.path.borrow().is_empty() { name.to_owned() } else { format!(".{name}") };
        mending.inside(&step, || map.next_value_seed(mending.watch(seed)))
    }
}

/// The name of a field; its seed is left where it is if the field is to be passed over.
struct FieldName<'f, 'm, K> {
    seed: &'f mut Option<K>,
    names: &'f mut Vec<String>,
    mending: &'m Mending,
}

impl<'de, K: DeserializeSeed<'de>> DeserializeSeed<'de> for FieldName<'_, '_, K> {
    type Value = Option<K::Value>;

    fn deserialize<D: de::Deserializer<'de>>(self, parser: D) -> Result<Self::Value, D::Error> {
        parser.deserialize_identifier(self)
    }
}

impl<'de, K: DeserializeSeed<'de>> Visitor<'de> for FieldName<'_, '_, K> {
    type Value = Option<K::Value>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the name of a field")
    }

    fn visit_str<E: de::Error>(self, name: &str) -> Result<Self::Value, E> {
        if self.mending.passes_over(name, self.names) {
            return Ok(None);
        }
        self.names.push(name.to_owned());
        self.seed.take().map(|seed| seed.deserialize(name.into_deserializer())).transpose()
    }
}
