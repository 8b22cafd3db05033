//! What a scene in JSON may hold, as a JSON Schema for editors.
//!
//! The schema is learnt from the reader itself: it is given a scene made up as it asks, once for every kind, and what
//! it asks for is written down. So it knows every field and kind there is, and cannot fall behind.
//!
//! # Examples
//! ```
//! use springbed::text::schema::schema;
//!
//! let schema = schema();
//! assert_eq!(schema["$defs"]["Sphere"]["required"][0], "radius");
//! assert!(schema["$defs"]["Sphere"]["properties"]["radius"]["description"].as_str().unwrap().starts_with("a length"));
//! ```

use super::place::Value;
use crate::scene::Scene;
use serde::Deserialize;
use serde::de::value::Error;
use serde::de::{self, DeserializeSeed, IntoDeserializer, Visitor};
use serde_json::map::Entry;
use serde_json::{Map, json};
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

/// The JSON Schema (draft 2020-12) of a scene.
#[must_use]
pub fn schema() -> Value {
    let mut survey = Survey::default();
    survey.kinds();
    survey.alternatives();
    survey.required();
    survey.written()
}

/// Which kind each enum is to have; the first one where nothing is said.
type Choices = BTreeMap<&'static str, usize>;

/// What is given where the reader takes more than one kind of value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Guise {
    Number,
    Whole,
    Text,
    List,
    Table,
}

impl Guise {
    const ALL: [Self; 5] = [Self::Number, Self::Whole, Self::Text, Self::List, Self::Table];

    /// Name of the type in a schema.
    fn name(self) -> &'static str {
        match self {
            Self::Number => "number",
            Self::Whole => "integer",
            Self::Text => "string",
            Self::List => "array",
            Self::Table => "object",
        }
    }
}

/// How one reading is done.
#[derive(Debug, Clone, Default)]
struct Reading {
    choices: Choices,
    /// By what the reader says it expects.
    guises: BTreeMap<String, Guise>,
    /// Structures and fields that are left out of them.
    omitted: BTreeSet<(&'static str, &'static str)>,
}

/// What has been learnt.
#[derive(Debug, Default)]
struct Learnt {
    /// Fields of structures.
    structures: BTreeMap<&'static str, Map<String, Value>>,
    /// Kinds of enums by their number.
    kinds: BTreeMap<&'static str, BTreeMap<usize, Value>>,
    /// Kinds that are not yet read.
    ahead: Vec<Choices>,
    /// The first reading that met a value of several types, and those types.
    open: BTreeMap<String, (Choices, BTreeSet<Guise>)>,
    /// The first reading that met a structure, with its fields.
    met: BTreeMap<&'static str, (Reading, &'static [&'static str])>,
    /// What the reader was at when it stopped.
    last_open: String,
    last_structure: &'static str,
    inside: Vec<&'static str>,
    /// Values it has taken.
    taken: usize,
    /// Whether it has stopped.
    stopped: bool,
}

#[derive(Default)]
struct Survey {
    learnt: RefCell<Learnt>,
    guises: BTreeMap<String, Guise>,
    /// Fields that cannot stand beside the others of their structure.
    either: BTreeMap<&'static str, &'static str>,
    required: BTreeMap<&'static str, Vec<&'static str>>,
}

impl Survey {
    fn read(&self, reading: &Reading) -> Result<(), Error> {
        let mut learnt = self.learnt.borrow_mut();
        learnt.inside.clear();
        learnt.taken = 0;
        learnt.stopped = false;
        drop(learnt);
        let slot = RefCell::new(Value::Null);
        Scene::deserialize(Asked { learnt: &self.learnt, reading, slot: &slot }).map(drop)
    }

    fn reading(&self, choices: &Choices) -> Reading {
        let omitted = self.either.iter().map(|(structure, field)| (*structure, *field)).collect();
        Reading { choices: choices.clone(), guises: self.guises.clone(), omitted }
    }

    /// Reads a scene of every kind.
    fn kinds(&mut self) {
        let mut next = Some(Choices::new());
        while let Some(choices) = next {
            self.settle(&choices);
            next = self.learnt.borrow_mut().ahead.pop();
        }
    }

    /// Finds values under which a scene of given kinds can be read to its end.
    fn settle(&mut self, choices: &Choices) {
        let mut reached = self.reach(&self.reading(choices));
        while reached < usize::MAX {
            let further = self.disguised(choices, reached).or_else(|| self.parted(choices, reached));
            let Some(further) = further else { return };
            reached = further;
        }
    }

    /// How many values a reading takes before it stops; no number is as large if it comes to its end, and none as small
    /// if it stops for what it lacks.
    fn reach(&self, reading: &Reading) -> usize {
        match self.read(reading) {
            Ok(()) => usize::MAX,
            Err(error) if error.to_string().starts_with("missing field") => 0,
            Err(_) => self.learnt.borrow().taken,
        }
    }

    /// Takes another type where the reader stopped, if it then gets further.
    fn disguised(&mut self, choices: &Choices, reached: usize) -> Option<usize> {
        let open = self.learnt.borrow().last_open.clone();
        let mut reading = self.reading(choices);
        for guise in Guise::ALL {
            reading.guises.insert(open.clone(), guise);
            let further = self.reach(&reading);
            if further > reached {
                self.guises.insert(open, guise);
                return Some(further);
            }
        }
        // The reading is as before, so that it stops where it did.
        self.reach(&self.reading(choices));
        None
    }

    /// Leaves out a field that cannot stand beside the others of its structure, if the reader then gets further.
    fn parted(&mut self, choices: &Choices, reached: usize) -> Option<usize> {
        let structure = self.learnt.borrow().last_structure;
        let fields = self.learnt.borrow().met.get(structure).map_or(&[][..], |met| met.1);
        for field in fields.iter().rev() {
            let mut reading = self.reading(choices);
            reading.omitted.insert((structure, field));
            let further = self.reach(&reading);
            // A value less is taken, and those after the structure are more.
            if further > reached {
                self.either.insert(structure, field);
                return Some(further);
            }
        }
        None
    }

    /// Tries every type where the reader takes several.
    fn alternatives(&mut self) {
        let open: Vec<(String, Choices)> =
            self.learnt.borrow().open.iter().map(|(open, (choices, _))| (open.clone(), choices.clone())).collect();
        for (open, choices) in open {
            for guise in Guise::ALL {
                let mut reading = self.reading(&choices);
                reading.guises.insert(open.clone(), guise);
                let refused = |error: &Error| error.to_string().starts_with("invalid type");
                if !self.read(&reading).is_err_and(|error| refused(&error)) {
                    self.learnt.borrow_mut().open.entry(open.clone()).and_modify(|entry| _ = entry.1.insert(guise));
                }
            }
        }
    }

    /// Leaves out every field of every structure, one at a time.
    fn required(&mut self) {
        let met = self.learnt.borrow().met.clone();
        for (structure, (first, fields)) in met {
            // As every scene is read, and as the one that met the structure was: it may stand in a list alone.
            let as_met = Reading { guises: first.guises, ..self.reading(&first.choices) };
            let readings = [self.reading(&first.choices), as_met];
            let is_required = |field: &&'static str| {
                readings
                    .iter()
                    .any(|reading| self.lacks(reading, structure, field).is_err_and(|lacking| lacking == **field))
            };
            let required = fields.iter().copied().filter(is_required).collect();
            self.required.insert(structure, required);
        }
    }

    /// Reads with a field of a structure left out; what stops it is the field it lacks, or nothing that has a name.
    fn lacks(&self, reading: &Reading, structure: &'static str, field: &'static str) -> Result<(), String> {
        let mut reading = reading.clone();
        reading.omitted.retain(|other| other.0 != structure);
        reading.omitted.insert((structure, field));
        self.read(&reading).map_err(|error| {
            let error = error.to_string();
            let field = error.strip_prefix("missing field `").and_then(|rest| rest.strip_suffix('`'));
            field.unwrap_or("").to_owned()
        })
    }

    fn written(&self) -> Value {
        let learnt = self.learnt.borrow();
        let mut definitions = Map::new();
        for (name, kinds) in &learnt.kinds {
            let kinds: Vec<&Value> = kinds.values().collect();
            definitions.insert((*name).to_owned(), json!({ "oneOf": kinds }));
        }
        for (name, fields) in &learnt.structures {
            let required = self.required.get(name);
            definitions.insert(
                (*name).to_owned(),
                json!({ "type": "object", "properties": fields, "required": required, "additionalProperties": false }),
            );
        }
        let mut whole = json!({
            "$schema": "https://json-schema.org/draft/2020-12/schema",
            "title": "a scene of springbed",
            "$ref": "#/$defs/Scene",
            "$defs": definitions,
        });
        typed(&mut whole, &learnt);
        whole
    }
}

/// Key of what the reader expects where it takes several types, until they are known.
const OPEN: &str = "description";

/// Gives every open value the types that were found for it.
fn typed(value: &mut Value, learnt: &Learnt) {
    match value {
        Value::Object(fields) => {
            let open = fields.get(OPEN).and_then(Value::as_str).and_then(|open| learnt.open.get(open));
            if let Some((_, types)) = open {
                let spare = |guise: &&Guise| **guise == Guise::Whole && types.contains(&Guise::Number);
                let types: Vec<&str> = types.iter().filter(|guise| !spare(guise)).map(|guise| guise.name()).collect();
                fields.insert("type".to_owned(), json!(types));
            }
            fields.values_mut().for_each(|field| typed(field, learnt));
        }
        Value::Array(entries) => entries.iter_mut().for_each(|entry| typed(entry, learnt)),
        _ => {}
    }
}

/// A value made up as the reader asks for it; what is asked is put into the slot.
#[derive(Clone, Copy)]
struct Asked<'r> {
    learnt: &'r RefCell<Learnt>,
    reading: &'r Reading,
    slot: &'r RefCell<Value>,
}

/// What a visitor says it expects.
struct Expected<'v, V>(&'v V);

impl<'de, V: Visitor<'de>> fmt::Display for Expected<'_, V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.expecting(f)
    }
}

impl<'r> Asked<'r> {
    fn put(&self, schema: Value) {
        *self.slot.borrow_mut() = schema;
    }

    /// What `read` asks for of a value inside this one; it is taken if it can be read.
    fn inside<T>(&self, read: impl FnOnce(Asked<'_>) -> Result<T, Error>) -> (Value, Result<T, Error>) {
        let slot = RefCell::new(json!({}));
        let value = read(Asked { learnt: self.learnt, reading: self.reading, slot: &slot });
        self.learnt.borrow_mut().taken += usize::from(value.is_ok());
        (slot.into_inner(), value)
    }

    /// The fields of a structure.
    fn fields<'de, V: Visitor<'de>>(
        self,
        name: &'static str,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        let mut learnt = self.learnt.borrow_mut();
        learnt.met.entry(name).or_insert_with(|| (self.reading.clone(), fields));
        drop(learnt);
        let kept = fields.iter().copied().filter(|field| !self.reading.omitted.contains(&(name, *field)));
        let value = visitor.visit_map(Members { asked: self, structure: name, left: kept.collect(), present: "" });
        let mut learnt = self.learnt.borrow_mut();
        // A structure may be refused when all its fields are read; those around it stop with it.
        if !learnt.stopped && !learnt.inside.is_empty() {
            learnt.last_structure = name;
        }
        learnt.stopped |= value.is_err();
        value
    }
}

macro_rules! plain {
    ($($asked:ident => $kind:literal, $visit:ident, $value:expr;)*) => {$(
        fn $asked<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
            self.put(json!({ "type": $kind }));
            visitor.$visit($value)
        }
    )*};
}

impl<'de> de::Deserializer<'de> for Asked<'_> {
    type Error = Error;

    plain! {
        deserialize_bool => "boolean", visit_bool, true;
        deserialize_i8 => "integer", visit_i8, 1;
        deserialize_i16 => "integer", visit_i16, 1;
        deserialize_i32 => "integer", visit_i32, 1;
        deserialize_i64 => "integer", visit_i64, 1;
        deserialize_u8 => "integer", visit_u8, 1;
        deserialize_u16 => "integer", visit_u16, 1;
        deserialize_u32 => "integer", visit_u32, 1;
        deserialize_u64 => "integer", visit_u64, 1;
        deserialize_f32 => "number", visit_f32, 0.05;
        deserialize_f64 => "number", visit_f64, 0.05;
        deserialize_char => "string", visit_char, '1';
        deserialize_str => "string", visit_str, "1";
        deserialize_string => "string", visit_str, "1";
        deserialize_bytes => "string", visit_str, "1";
        deserialize_byte_buf => "string", visit_str, "1";
        deserialize_identifier => "string", visit_str, "1";
    }

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        let open = Expected(&visitor).to_string();
        let mut learnt = self.learnt.borrow_mut();
        learnt.open.entry(open.clone()).or_insert_with(|| (self.reading.choices.clone(), BTreeSet::new()));
        learnt.last_open.clone_from(&open);
        drop(learnt);
        let guise = self.reading.guises.get(&open).copied().unwrap_or(Guise::Number);
        self.put(json!({ OPEN: open }));
        match guise {
            // In every range: of lengths, of ratios, of accuracies.
            Guise::Number => visitor.visit_f64(0.05),
            Guise::Whole => visitor.visit_u64(1),
            Guise::Text => visitor.visit_str("5 %"),
            Guise::List => visitor.visit_seq(Entries { asked: self, left: 1, asked_for: Vec::new(), told: false }),
            Guise::Table => visitor.visit_map(Members { asked: self, structure: "", left: Vec::new(), present: "" }),
        }
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_some(self)
    }

    fn deserialize_unit<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        self.put(json!({ "type": "null" }));
        visitor.visit_unit()
    }

    fn deserialize_unit_struct<V: Visitor<'de>>(self, _: &'static str, visitor: V) -> Result<V::Value, Error> {
        self.deserialize_unit(visitor)
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(self, _: &'static str, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_seq(Entries { asked: self, left: 1, asked_for: Vec::new(), told: true })
    }

    fn deserialize_tuple<V: Visitor<'de>>(self, length: usize, visitor: V) -> Result<V::Value, Error> {
        let asked = Asked { slot: &RefCell::new(Value::Null), ..self };
        let mut entries = Entries { asked, left: length, asked_for: Vec::new(), told: false };
        let value = visitor.visit_seq(&mut entries);
        self.put(json!({ "type": "array", "prefixItems": entries.asked_for, "minItems": length, "maxItems": length }));
        value
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
        self.put(json!({ "type": "object" }));
        visitor.visit_map(Members { asked: self, structure: "", left: Vec::new(), present: "" })
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        name: &'static str,
        fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        self.put(json!({ "$ref": format!("#/$defs/{name}") }));
        self.learnt.borrow_mut().structures.entry(name).or_default();
        self.fields(name, fields, visitor)
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        name: &'static str,
        kinds: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        self.put(json!({ "$ref": format!("#/$defs/{name}") }));
        let mut learnt = self.learnt.borrow_mut();
        if !learnt.kinds.contains_key(name) {
            learnt.kinds.insert(name, BTreeMap::new());
            let others = (1..kinds.len()).rev();
            let choices = &self.reading.choices;
            let others =
                others.map(|kind| choices.iter().map(|(name, kind)| (*name, *kind)).chain([(name, kind)]).collect());
            learnt.ahead.extend(others.collect::<Vec<Choices>>());
        }
        // A kind may hold its like, as a rough shape its smooth one: the simplest, so that there is an end.
        let again = learnt.inside.contains(&name);
        let kind = if again { 0 } else { self.reading.choices.get(name).copied().unwrap_or(0) };
        learnt.inside.push(name);
        drop(learnt);
        let value =
            visitor.visit_enum(Kind { asked: self, of: name, name: kinds.get(kind).copied().unwrap_or(""), kind });
        self.learnt.borrow_mut().inside.pop();
        value
    }

    fn deserialize_ignored_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_unit()
    }
}

/// Entries of a list or of a tuple.
struct Entries<'r> {
    asked: Asked<'r>,
    left: usize,
    asked_for: Vec<Value>,
    /// Whether the slot is told what an entry is.
    told: bool,
}

impl<'de> de::SeqAccess<'de> for Entries<'_> {
    type Error = Error;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>, Error> {
        let Some(left) = self.left.checked_sub(1) else { return Ok(None) };
        self.left = left;
        let (schema, value) = self.asked.inside(|asked| seed.deserialize(asked));
        if self.told {
            self.asked.put(json!({ "type": "array", "items": schema }));
        }
        self.asked_for.push(schema);
        value.map(Some)
    }
}

/// Fields of a structure.
struct Members<'r> {
    asked: Asked<'r>,
    structure: &'static str,
    left: Vec<&'static str>,
    present: &'static str,
}

impl<'de> de::MapAccess<'de> for Members<'_> {
    type Error = Error;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, Error> {
        if self.left.is_empty() {
            return Ok(None);
        }
        self.present = self.left.remove(0);
        seed.deserialize(self.present.into_deserializer()).map(Some)
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, Error> {
        let (schema, value) = self.asked.inside(|asked| seed.deserialize(asked));
        let mut learnt = self.asked.learnt.borrow_mut();
        keep(learnt.structures.entry(self.structure).or_default().entry(self.present), schema, value.is_ok());
        value
    }
}

/// Keeps what was asked for, unless it is what a reading that stopped inside it left and there is something already.
fn keep(entry: Entry<'_>, schema: Value, whole: bool) {
    match entry {
        Entry::Occupied(mut known) if whole => drop(known.insert(schema)),
        Entry::Occupied(_) => {}
        Entry::Vacant(place) => drop(place.insert(schema)),
    }
}

/// One kind of an enum.
struct Kind<'r> {
    asked: Asked<'r>,
    of: &'static str,
    name: &'static str,
    kind: usize,
}

impl Kind<'_> {
    fn holds(&self, content: &Value) {
        let schema = json!({
            "type": "object", "properties": { self.name: content }, "required": [self.name], "additionalProperties": false,
        });
        self.is(schema);
    }

    fn is(&self, schema: Value) {
        self.asked.learnt.borrow_mut().kinds.entry(self.of).or_default().insert(self.kind, schema);
    }
}

impl<'de> de::EnumAccess<'de> for Kind<'_> {
    type Error = Error;
    type Variant = Self;

    fn variant_seed<V: DeserializeSeed<'de>>(self, seed: V) -> Result<(V::Value, Self), Error> {
        Ok((seed.deserialize(self.name.into_deserializer())?, self))
    }
}

impl<'de> de::VariantAccess<'de> for Kind<'_> {
    type Error = Error;

    fn unit_variant(self) -> Result<(), Error> {
        self.is(json!({ "const": self.name }));
        Ok(())
    }

    fn newtype_variant_seed<T: DeserializeSeed<'de>>(self, seed: T) -> Result<T::Value, Error> {
        let (schema, value) = self.asked.inside(|asked| seed.deserialize(asked));
        self.holds(&schema);
        value
    }

    fn tuple_variant<V: Visitor<'de>>(self, length: usize, visitor: V) -> Result<V::Value, Error> {
        let (schema, value) = self.asked.inside(|asked| de::Deserializer::deserialize_tuple(asked, length, visitor));
        self.holds(&schema);
        value
    }

    fn struct_variant<V: Visitor<'de>>(self, fields: &'static [&'static str], visitor: V) -> Result<V::Value, Error> {
        self.holds(&json!({ "$ref": format!("#/$defs/{}", self.name) }));
        self.asked.fields(self.name, fields, visitor)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::names::FIELDS;

    fn names(value: &Value) -> BTreeSet<&str> {
        match value {
            Value::Object(fields) => fields.keys().map(String::as_str).collect(),
            Value::Array(entries) => entries.iter().filter_map(Value::as_str).collect(),
            other => panic!("{other}"),
        }
    }

    #[test]
    fn a_scene_has_its_fields() {
        let schema = schema();
        let scene = &schema["$defs"]["Scene"];
        assert_eq!(names(&scene["properties"]), FIELDS.into_iter().collect());
        assert_eq!(names(&scene["required"]), ["shape", "bodies", "history"].into_iter().collect());
    }

    /// The reader names all kinds when it meets an unknown one.
    #[test]
    fn every_kind_is_there() {
        let schema = schema();
        for (name, path) in [("Shape", "shape"), ("Body", "bodies"), ("Adhesion", "adhesion"), ("Friction", "friction")]
        {
            let unknown = json!("Nothing");
            let mut scene = json!({ "shape": { "Cone": { "slope": 1 } }, "bodies": ["Rigid", "Rigid"], "history": [] });
            scene[path] = if path == "bodies" { json!(["Nothing", "Rigid"]) } else { unknown };
            let error = serde_json::from_value::<Scene>(scene).unwrap_err().to_string();
            let known: BTreeSet<&str> = error.split('`').skip(3).step_by(2).collect();
            let kinds = schema["$defs"][name]["oneOf"].as_array().unwrap();
            let of = |kind: &'_ Value| {
                kind["const"]
                    .as_str()
                    .map(str::to_owned)
                    .unwrap_or_else(|| kind["required"][0].as_str().unwrap().to_owned())
            };
            let kinds: Vec<String> = kinds.iter().map(of).collect();
            assert_eq!(kinds.iter().map(String::as_str).collect::<BTreeSet<_>>(), known, "{name}");
        }
    }

    #[test]
    fn a_field_is_required_if_a_scene_cannot_do_without_it() {
        let schema = schema();
        let required =
            |name: &str| names(&schema["$defs"][name]["required"]).into_iter().map(str::to_owned).collect::<Vec<_>>();
        assert_eq!(required("Elastic"), ["poisson"]);
        assert_eq!(required("Impact"), ["mass", "speed"]);
        let types = |name: &str, field: &str| schema["$defs"][name]["properties"][field]["type"].clone();
        assert_eq!(types("Elastic", "young"), json!(["number", "string"]));
        assert_eq!(types("Impact", "speed"), json!(["number", "string", "array"]));
        assert_eq!(types("Jkr", "work"), json!(["number", "string", "object"]));
    }
}
