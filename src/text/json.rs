//! From JSON to a scene and back.

use super::TextError;
use super::mend::{self, Faulty, Mending, Wrong};
use super::walk;
use crate::scene::Scene;
use serde::de::DeserializeSeed;
use serde_json::error::Category;
use serde_json::{Deserializer, Error};
use std::marker::PhantomData;

/// The scene in `text`; single values are checked, whether they fit together is not.
///
/// # Errors
/// All faults of the text, up to and with the first of its notation.
pub fn scene(text: &str) -> Result<Scene, Faulty<Scene, TextError>> {
    mend::read_all(text.len(), |mending| watched(text, mending), wrong)
        .map_err(|faulty| faulty.told(|error| placed(text, error)))
}

fn watched(text: &str, mending: &Mending) -> Result<Scene, Error> {
    let mut parser = Deserializer::from_str(text);
    let scene = mending.watch(PhantomData).deserialize(&mut parser)?;
    parser.end()?;
    Ok(scene)
}

/// What an error is about; the parser says it in words.
fn wrong(error: &Error) -> Wrong {
    if error.classify() != Category::Data {
        return Wrong::Notation;
    }
    let message = error.to_string();
    let mut quoted = message.split('`');
    let (what, name) = (quoted.next().unwrap_or(""), quoted.next().unwrap_or("").to_owned());
    match what {
        "missing field " => Wrong::MissingField(name),
        "unknown field " => Wrong::UnknownField(name),
        "duplicate field " => Wrong::RepeatedField(name),
        _ => Wrong::Value,
    }
}

/// The error at the value it speaks of; a lacking field at the bracket that should hold it.
fn placed(text: &str, error: &Error) -> TextError {
    let described = error.to_string();
    let message = described.rsplit_once(" at line ").map_or(described.as_str(), |(message, _)| message);
    let at = offset(text, error);
    let around = walk::surroundings(text, at);
    if error.classify() != Category::Data {
        return TextError::at(text, at, format!("{message}: expected a scene in the notation of JSON"));
    }
    let around = match around.open {
        Some((_, open)) if message.starts_with("missing field") => walk::surroundings(text, open),
        _ => around,
    };
    let held = if around.path.is_empty() { String::new() } else { format!("{}: ", around.path) };
    TextError::at(text, around.token, format!("{held}{message}"))
}

/// Byte offset of an error; its columns count bytes.
fn offset(text: &str, error: &Error) -> usize {
    let before = text.split_inclusive('\n').take(error.line().saturating_sub(1)).map(str::len).sum::<usize>();
    let mut at = (before + error.column().saturating_sub(1)).min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}
