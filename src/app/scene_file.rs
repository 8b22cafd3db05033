//! Scene files: bytes in, a checked scene out, or every fault with its place.
//!
//! # Examples
//! ```
//! use springbed::app::scene_file::plan;
//!
//! // A fault names the file and the place in it.
//! let faults = plan("lens.ron".as_ref(), "(shape: Ball(radius: 1))").unwrap_err();
//! assert_eq!(faults[0].file, std::path::Path::new("lens.ron"));
//! assert!(faults[0].position.is_some());
//! ```

use super::fault::Fault;
use super::read::{read_stdin, read_text};
use super::table_file::TableFiles;
use crate::input::problem::Problem;
use crate::scene::Scene;
use crate::scene::plan::Plan;
use crate::sweep::Sweep;
use crate::text::{Notation, TextError, placed};
use std::path::{Path, PathBuf};

/// A scene read from a file, ready to be computed.
#[derive(Debug, Clone)]
pub struct SceneFile {
    /// The file.
    pub path: PathBuf,
    /// The scene with its tables read.
    pub plan: Plan,
    /// The tables it names.
    pub tables: Vec<PathBuf>,
    /// Its text.
    pub text: String,
}

/// Largest scene file: a history of a million entries has a third of it.
const LARGEST: u64 = 64 << 20;

impl SceneFile {
    /// The scene in the file at `path`, or in standard input if that is `-`; tables are looked for beside it.
    ///
    /// # Errors
    /// Everything that is wrong with it, in the order of the text.
    pub fn load(path: &Path) -> Result<Self, Vec<Fault>> {
        let text = if is_stdin(path) { read_stdin(LARGEST) } else { read_text(path, LARGEST) };
        Self::of(path, text.map_err(|fault| vec![fault])?)
    }

    /// The scene in `text`, as if it stood in the file at `path`.
    ///
    /// # Errors
    /// Everything that is wrong with it, in the order of the text.
    pub fn of(path: &Path, text: String) -> Result<Self, Vec<Fault>> {
        let tables = TableFiles::beside(path);
        let plan = read(path, &text, &tables)?;
        if let Some(Err(problem)) = Sweep::written(&plan.scene) {
            let errors = at_its_place(&text, &plan.scene, problem);
            return Err(errors.into_iter().map(|error| Fault::at(path, error)).collect());
        }
        Ok(Self { path: path.to_owned(), plan, tables: tables.read(), text })
    }

    /// Name of the file without directory and extension, the stem of its outputs.
    #[must_use]
    pub fn stem(&self) -> String {
        let stem = self.path.file_stem().filter(|_| !is_stdin(&self.path));
        stem.map_or_else(|| "scene".to_owned(), |stem| stem.to_string_lossy().into_owned())
    }

    /// Name of the file without directory.
    #[must_use]
    pub fn file_name(&self) -> String {
        self.path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
    }
}

/// What is wrong with the sweep a scene writes, at the place of the values.
fn at_its_place(text: &str, scene: &Scene, problem: Problem) -> Vec<TextError> {
    let set = scene.sweep.iter().flat_map(|swept| &swept.set);
    let number = set.into_iter().position(|setting| setting.path == problem.path);
    let path = number.map_or_else(|| "sweep".to_owned(), |number| format!("sweep.set[{number}]"));
    let message = if number.is_some() { problem.to_string() } else { problem.message };
    placed(text, &[Problem { path, message }])
}

/// Whether a path stands for standard input.
fn is_stdin(path: &Path) -> bool {
    path == Path::new("-")
}

/// The plan of the scene in `text`, which came from the file at `path`: JSON by its name, or else RON; from standard
/// input JSON if it begins with a brace.
///
/// # Errors
/// Everything that is wrong with it, in the order of the text.
pub fn plan(path: &Path, text: &str) -> Result<Plan, Vec<Fault>> {
    read(path, text, &TableFiles::beside(path))
}

fn read(path: &Path, text: &str, tables: &TableFiles) -> Result<Plan, Vec<Fault>> {
    let named = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("json"));
    let json = named || is_stdin(path) && text.trim_start().starts_with('{');
    let notation = if json { Notation::Json } else { Notation::Ron };
    let plan = notation.plan(text, tables);
    plan.map_err(|errors| errors.into_iter().map(|error| Fault::at(path, error)).collect())
}
