//! Scenes as text: RON, as people write it, and JSON, as programs do.
//!
//! Both have the same fields. A kind with its fields is `Sphere(radius: "5 mm")` in RON and
//! `{"Sphere": {"radius": "5 mm"}}` in JSON, a kind without fields `Rigid` and `"Rigid"`, the two bodies
//! `(…, …)` and `[…, …]`. What is wrong is said with line and column.
//!
//! # Examples
//! ```
//! use springbed::prelude::*;
//!
//! // What is wrong is told with its place.
//! let text = r#"(shape: Paraboloid(radius: -1), bodies: (Rigid, Rigid), history: [])"#;
//! let errors = Notation::Ron.plan(text, &InMemory::default()).unwrap_err();
//! assert_eq!(errors[0].position.line, 1);
//! assert!(errors[0].message.contains("radius"));
//! ```

mod json;
mod mend;
mod names;
pub mod place;
mod position;
mod ron;
pub mod schema;
mod standin;
mod walk;
pub mod written;

pub use names::{advice, nearest};
pub use position::Position;

use crate::input::problem::Problem;
use crate::input::table::Tables;
use crate::scene::Scene;
use crate::scene::mended::Mended;
use crate::scene::plan::Plan;
use mend::{Faulty, Mends};
use names::FIELDS;

/// What is wrong with a text, and where.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("line {}, column {}: {message}", position.line, position.column)]
pub struct TextError {
    /// Where.
    pub position: Position,
    /// What it was, and what would be right.
    pub message: String,
    /// The line of the text.
    pub line: String,
}

impl TextError {
    /// An error at the byte `offset` of a text.
    pub fn at(text: &str, offset: usize, message: impl Into<String>) -> Self {
        let position = Position::of(text, offset);
        let line = text.lines().nth(position.line - 1).unwrap_or("").to_owned();
        Self { position, message: message.into(), line }
    }
}

/// How a scene is written down.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Notation {
    /// Rusty Object Notation, with comments.
    Ron,
    /// JavaScript Object Notation.
    Json,
}

impl Notation {
    /// The scene in `text`; single values are checked, whether they fit together [`resolve`](Scene::resolve) says.
    ///
    /// # Errors
    /// Every wrong value, unknown name and missing field up to the first fault of the notation itself, in the order
    /// of the text.
    pub fn scene(self, text: &str) -> Result<Scene, Vec<TextError>> {
        self.read(text).map_err(|faulty| sorted(faulty.faults))
    }

    fn read(self, text: &str) -> Result<Scene, Faulty<Scene, TextError>> {
        match self {
            Self::Ron => ron::scene(text),
            Self::Json => json::scene(text),
        }
    }

    /// The scene in `text`, made ready with the `tables` it names.
    ///
    /// # Errors
    /// All that is wrong with the text and with the scene in it, in the order of the text. Where the text is wrong, of
    /// the scene that is told which is wrong whatever should stand there.
    pub fn plan(self, text: &str, tables: &dyn Tables) -> Result<Plan, Vec<TextError>> {
        match self.read(text) {
            Ok(scene) => scene.resolve(tables).map_err(|problems| sorted(placed(text, &problems))),
            Err(Faulty { mut faults, rest }) => {
                let problems = rest.map(|(scene, mends)| scene.problems_beside(&mended(text, &mends), tables));
                faults.extend(placed(text, &problems.unwrap_or_default()));
                Err(sorted(faults))
            }
        }
    }
}

impl Scene {
    /// The scene in a RON text; single values are checked, whether they fit together [`resolve`](Self::resolve) says.
    ///
    /// ```
    /// # use springbed::scene::Scene;
    /// let text = r#"(shape: Sphere(radius: "5 mm"), bodies: (Elastic(young: "1 MPa", poisson: 0.5), Rigid),
    ///     history: [Indent(to: "10 um", over: 1)])"#;
    /// let json = Scene::from_ron(text)?.to_json()?;
    /// assert_eq!(Scene::from_json(&json)?, Scene::from_ron(text)?);
    /// let error = Scene::from_ron(&text.replace("5 mm", "5 kg")).unwrap_err();
    /// assert_eq!((error.position.line, error.position.column), (1, 24));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// The first fault of the text; [`Notation::scene`] has all of them.
    pub fn from_ron(text: &str) -> Result<Self, TextError> {
        Notation::Ron.scene(text).map_err(first)
    }

    /// The scene in a JSON text, such as the `resolved` scene of a summary.
    ///
    /// # Errors
    /// The first fault of the text; [`Notation::scene`] has all of them.
    pub fn from_json(text: &str) -> Result<Self, TextError> {
        Notation::Json.scene(text).map_err(first)
    }

    /// The scene as JSON, all quantities in SI units.
    ///
    /// # Errors
    /// A number that JSON does not have.
    pub fn to_json(&self) -> Result<String, serde_json::Error> {
        serde_json::to_string_pretty(self)
    }
}

/// The places of a scene that are not as the writer of the text meant them.
fn mended(text: &str, mends: &Mends) -> Mended {
    let meant = mends.unknown.iter().flat_map(|(holder, name)| meant(text, holder, name));
    Mended::at(mends.values.iter().cloned().chain(meant))
}

/// The paths that may be meant by the field `name` that `holder` does not have.
fn meant(text: &str, holder: &str, name: &str) -> Vec<String> {
    if !holder.is_empty() {
        // A field of the scene has got into one of its parts, or else this is one of the part.
        let strayed = FIELDS.into_iter().filter(|&field| field == name).map(str::to_owned);
        return strayed.chain([format!("{holder}.{name}")]).collect();
    }
    let scene = walk::locate(text, &[""]);
    let absent: Vec<&str> = FIELDS.into_iter().filter(|field| walk::locate(text, &[field]) == scene).collect();
    nearest(name, &absent).map_or(absent, |field| vec![field]).into_iter().map(str::to_owned).collect()
}

/// Problems at their places in the text.
#[must_use]
pub fn placed(text: &str, problems: &[Problem]) -> Vec<TextError> {
    let paths: Vec<&str> = problems.iter().map(|problem| problem.path.as_str()).collect();
    let places = walk::locate(text, &paths).into_iter().zip(problems);
    places.map(|(offset, problem)| TextError::at(text, offset, problem.to_string())).collect()
}

/// Errors in the order of the text.
fn sorted(mut errors: Vec<TextError>) -> Vec<TextError> {
    errors.sort_by(|a, b| (a.position, &a.message).cmp(&(b.position, &b.message)));
    errors
}

/// The first of errors in the order of the text; there is one.
fn first(errors: Vec<TextError>) -> TextError {
    errors.into_iter().next().unwrap_or_else(|| TextError::at("", 0, "cannot be read: expected a scene"))
}
