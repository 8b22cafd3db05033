//! From JSON to a scene and back.

use super::TextError;
use super::walk;
use crate::scene::Scene;
use serde_json::Error;
use serde_json::error::Category;

/// The scene in `text`; single values are checked, whether they fit together is not.
///
/// # Errors
/// The first fault of the text.
pub fn scene(text: &str) -> Result<Scene, TextError> {
    serde_json::from_str(text).map_err(|error| placed(text, &error))
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
