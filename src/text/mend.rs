//! Reading on after a fault: every wrong value, unknown name and missing field of a text, not the first alone.
//!
//! A parser stops at the first fault. So the text is read again with the fault mended: a value that cannot be
//! read is passed over and a [`StandIn`] takes its place, a field that is not known is passed over, a missing
//! one is supplied. What is not mended goes to the parser as it is, so that places and messages are its own. What
//! is read at last has no fault left but what was mended, so the rest of it can be judged.

use super::names::nearest;
use super::standin::{Guise, StandIn};
use serde::Deserialize;
use serde::de::{self, DeserializeSeed, IgnoredAny, IntoDeserializer, Visitor};
use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

/// Most faults that are looked for; each takes a reading of the text.
const MOST_FAULTS: usize = 100;
/// Most bytes that are read again to find them.
const MOST_BYTES: usize = 1 << 28;

/// What a parser says is wrong at the place it stopped at.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Wrong {
    /// The value.
    Value,
    /// A field that is not known.
    UnknownField(String),
    /// A field that is there for the second time.
    RepeatedField(String),
    /// A field that is not there.
    MissingField(String),
    /// The notation itself, so that nothing after it can be trusted.
    Notation,
}

/// What is wrong with a text, and what can be read of it all the same.
#[derive(Debug)]
pub struct Faulty<T, E> {
    /// Its faults.
    pub faults: Vec<E>,
    /// What was read with every fault mended, and where; `None` if not all could be.
    pub rest: Option<(Box<T>, Mends)>,
}

/// What was mended.
#[derive(Debug, Default)]
pub struct Mends {
    /// Paths of values that are not those of the text.
    pub values: Vec<String>,
    /// Fields that are not known and were passed over: the path of their holder, and their name.
    pub unknown: Vec<(String, String)>,
}

impl<T, E> Faulty<T, E> {
    /// The same faults, `told` in another way.
    pub fn told<F>(self, told: impl Fn(&E) -> F) -> Faulty<T, F> {
        Faulty { faults: self.faults.iter().map(told).collect(), rest: self.rest }
    }
}

impl<T, E> From<Vec<E>> for Faulty<T, E> {
    fn from(faults: Vec<E>) -> Self {
        Self { faults, rest: None }
    }
}

/// Reads a text of `length` bytes by `read` until all faults are found; `wrong` says what an error is about.
///
/// # Errors
/// All faults up to and with the first of the notation.
pub fn read_all<T, E>(
    length: usize,
    read: impl Fn(&Mending) -> Result<T, E>,
    wrong: impl Fn(&E) -> Wrong,
) -> Result<T, Faulty<T, E>> {
    let mut mending = Mending::default();
    let mut faults = Vec::new();
    loop {
        match (read(&mending), mending.stop()) {
            (Ok(value), _) if faults.is_empty() => return Ok(value),
            (Ok(value), _) => return Err(Faulty { faults, rest: Some((Box::new(value), mending.mends())) }),
            (Err(_), Stop::PassingOver) => return Err(faults.into()),
            (Err(_), Stop::StandIn(path)) => {
                if !mending.disguise(path) {
                    return Err(faults.into());
                }
            }
            (Err(error), Stop::At(path)) => {
                let wrong = wrong(&error);
                if !mending.told_by_its_misspelling(&path, &wrong) {
                    faults.push(error);
                }
                let mended = mending.mend(path, wrong);
                if !mended || faults.len() >= MOST_FAULTS || faults.len() * length > MOST_BYTES {
                    return Err(faults.into());
                }
            }
        }
    }
}

/// What is mended, and how far the present reading has come.
#[derive(Debug, Default)]
pub struct Mending {
    stand_ins: BTreeMap<String, Guise>,
    supplied: BTreeMap<String, Vec<String>>,
    unknown: BTreeSet<(String, String)>,
    repeated: BTreeSet<(String, String)>,
    path: RefCell<String>,
    state: Cell<State>,
}

/// What is being done at the present path.
#[derive(Debug, Default, Clone, Copy, PartialEq, Eq)]
enum State {
    #[default]
    Reading,
    PassingOver,
    StandingIn,
}

/// Where a reading stopped.
#[derive(Debug)]
enum Stop {
    /// At a value or in a structure of the text.
    At(String),
    /// In a value that was to be passed over: its notation is wrong.
    PassingOver,
    /// At a stand-in that will not do.
    StandIn(String),
}

impl Mending {
    /// Where the last reading stopped; the next one begins anew.
    fn stop(&self) -> Stop {
        let path = self.path.take();
        match self.state.take() {
            State::Reading => Stop::At(path),
            State::PassingOver => Stop::PassingOver,
            State::StandingIn => Stop::StandIn(path),
        }
    }

    /// Mends a fault at `path`; whether it is one that can be mended and was not already.
    fn mend(&mut self, path: String, wrong: Wrong) -> bool {
        match wrong {
            Wrong::Value => self.stand_ins.insert(path, Guise::Number).is_none(),
            Wrong::UnknownField(field) => self.unknown.insert((path, field)),
            Wrong::RepeatedField(field) => self.repeated.insert((path, field)),
            Wrong::MissingField(field) => {
                let supplied = self.supplied.entry(path).or_default();
                let lacks = !supplied.contains(&field);
                supplied.push(field);
                lacks
            }
            Wrong::Notation => false,
        }
    }

    /// What is mended.
    fn mends(self) -> Mends {
        let supplied = self
            .supplied
            .into_iter()
            .flat_map(|(path, fields)| fields.into_iter().map(move |field| (path.clone(), field)));
        let fields = supplied.chain(self.repeated).map(|(path, field)| format!("{path}.{field}"));
        Mends {
            values: self.stand_ins.into_keys().chain(fields).collect(),
            unknown: self.unknown.into_iter().collect(),
        }
    }

    /// Whether a missing field is there under a name like its own, of which is told already.
    fn told_by_its_misspelling(&self, path: &str, wrong: &Wrong) -> bool {
        let Wrong::MissingField(field) = wrong else { return false };
        let mut here = self.unknown.iter().filter(|(holder, _)| holder == path);
        here.any(|(_, unknown)| nearest(unknown, &[field]).is_some())
    }

    /// Tries another stand-in at `path`; whether there is one.
    fn disguise(&mut self, path: String) -> bool {
        let next = self.stand_ins.get(&path).copied().map_or(Some(Guise::Text), Guise::next);
        next.map(|guise| self.stand_ins.insert(path, guise)).is_some()
    }

    /// Does `read` one step further down the path; the path stays where it fails.
    fn inside<T, E>(&self, step: &str, read: impl FnOnce() -> Result<T, E>) -> Result<T, E> {
        let before = self.path.borrow().len();
        self.path.borrow_mut().push_str(step);
        let value = read()?;
        self.path.borrow_mut().truncate(before);
        Ok(value)
    }

    fn doing<T, E>(&self, state: State, act: impl FnOnce() -> Result<T, E>) -> Result<T, E> {
        self.state.set(state);
        let value = act()?;
        self.state.set(State::Reading);
        Ok(value)
    }

    fn stand_in<'de, S: DeserializeSeed<'de>, E: de::Error>(&self, seed: S, guise: Guise) -> Result<S::Value, E> {
        self.doing(State::StandingIn, || seed.deserialize(StandIn::<E>::new(guise)))
    }

    /// What is read by a `seed`, under the eyes of the mending.
    pub fn watch<S>(&self, seed: S) -> Watched<'_, S> {
        Watched { inner: seed, mending: self }
    }

    /// Whether the field `name` of the structure here is to be passed over; `before` are the names before it.
    fn passes_over(&self, name: &str, before: &[String]) -> bool {
        if self.unknown.is_empty() && self.repeated.is_empty() {
            return false;
        }
        let field = (self.path.borrow().clone(), name.to_owned());
        self.unknown.contains(&field) || self.repeated.contains(&field) && before.iter().any(|seen| seen == name)
    }
}

/// A seed, parser, visitor or list of serde that mends what is asked for and hands on all else.
pub struct Watched<'m, I> {
    inner: I,
    mending: &'m Mending,
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

    handed_on! {
        deserialize_any(), deserialize_bool(),
        deserialize_i8(), deserialize_i16(), deserialize_i32(), deserialize_i64(), deserialize_i128(),
        deserialize_u8(), deserialize_u16(), deserialize_u32(), deserialize_u64(), deserialize_u128(),
        deserialize_f32(), deserialize_f64(), deserialize_char(), deserialize_str(), deserialize_string(),
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

#[cfg(test)]
mod tests {
    use crate::text::Notation;

    /// Line, column and message of all faults.
    fn faults(notation: Notation, text: &str) -> Vec<(usize, usize, String)> {
        let errors = notation.scene(text).unwrap_err();
        errors.into_iter().map(|error| (error.position.line, error.position.column, error.message)).collect()
    }

    fn begins(found: &[(usize, usize, String)], right: &[(usize, usize, &str)]) {
        assert_eq!(found.len(), right.len(), "{found:#?}");
        for (found, right) in found.iter().zip(right) {
            assert!((found.0, found.1) == (right.0, right.1) && found.2.contains(right.2), "{found:?}, not {right:?}");
        }
    }

    const RON: &str = r#"(
    shape: Sphere(radius: "5 kg"),
    bodies: (Elastic(young: -1, poison: 0.5), Rigid),
    adhesion: Jkrr(work: 0.05),
    history: [Indent(to: ten, over: 1), Indent(to: 0, over: 1, after: 2), Hold(over: 0)],
    springs: 10,
)"#;

    #[test]
    fn all_faults_of_a_text_are_found_in_its_order() {
        let right = [
            (2, 27, "shape.radius: \"5 kg\" has the unit"),
            (3, 29, "bodies.0.young: -1.0 Pa is out of range"),
            (3, 33, "Elastic has no field `poison`: did you mean `poisson`?"),
            (4, 15, "unknown adhesion `Jkrr`"),
            (5, 26, "history[0].to: `ten` cannot stand here"),
            (5, 64, "Indent has no field `after`"),
            (5, 86, "history[2].over: 0.0 s is out of range"),
        ];
        begins(&faults(Notation::Ron, RON), &right);
    }

    #[test]
    fn all_faults_of_json_too() {
        let text = r#"{"shape": {"Sphere": {"radius": "5 kg"}},
 "bodies": [{"Elastic": {"young": -1, "poison": 0.5}}, "Rigit"],
 "history": [{"Indent": {"to": [], "over": 1}}], "springs": 0}"#;
        let right = [
            (1, 33, "shape.radius: \"5 kg\" has the unit"),
            (2, 35, "bodies[0].young: -1.0 Pa is out of range"),
            (2, 39, "unknown field `poison`"),
            (2, 56, "unknown variant `Rigit`"),
            (3, 33, "invalid type: sequence"),
            (3, 61, "springs: invalid value"),
        ];
        begins(&faults(Notation::Json, text), &right);
    }

    #[test]
    fn several_missing_fields_and_one_given_twice() {
        let text = "(title: \"x\", title: \"y\", bodies: (Elastic(young: 1), Rigid))";
        let right = [
            (1, 1, "lacks the field `history`"),
            (1, 1, "lacks the field `shape`"),
            (1, 14, "`title` of Scene is given twice"),
            (1, 35, "lacks the field `poisson`"),
        ];
        begins(&faults(Notation::Ron, text), &right);
    }

    /// What is told after a broken bracket would be guesswork.
    #[test]
    fn nothing_is_told_of_what_follows_a_broken_notation() {
        let found = faults(Notation::Ron, &RON.replace("0.5), Rigid", "0.5, Rigid"));
        let last = found.last().unwrap();
        assert!((last.0 <= 4) && found.iter().any(|fault| fault.0 == 2), "{found:#?}");
        assert_eq!(faults(Notation::Ron, "(shape: Cone(slope: 10 deg").len(), 1);
    }

    /// A text with more faults than a person reads is not read a thousand times.
    #[test]
    fn the_number_of_faults_is_bounded() {
        let text = format!("(history: [{}])", "Indent(to: x, over: 0), ".repeat(1000));
        assert_eq!(faults(Notation::Ron, &text).len(), super::MOST_FAULTS);
    }
}
