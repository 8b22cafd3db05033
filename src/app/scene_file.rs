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
use super::read::read_text;
use super::table_file::TableFiles;
use crate::scene::plan::Plan;
use crate::text::Notation;
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
}

/// Largest scene file: a history of a million entries has a third of it.
const LARGEST: u64 = 64 << 20;

impl SceneFile {
    /// The scene in the file at `path`; tables are looked for beside it.
    ///
    /// # Errors
    /// Everything that is wrong with it, in the order of the text.
    pub fn load(path: &Path) -> Result<Self, Vec<Fault>> {
        let text = read_text(path, LARGEST).map_err(|fault| vec![fault])?;
        let tables = TableFiles::beside(path);
        let plan = read(path, &text, &tables)?;
        Ok(Self { path: path.to_owned(), plan, tables: tables.read() })
    }

    /// Name of the file without directory and extension, the stem of its outputs.
    #[must_use]
    pub fn stem(&self) -> String {
        self.path.file_stem().map_or_else(|| "scene".to_owned(), |stem| stem.to_string_lossy().into_owned())
    }
}

/// The plan of the scene in `text`, which came from the file at `path`: JSON by its name, or else RON.
///
/// # Errors
/// Everything that is wrong with it, in the order of the text.
pub fn plan(path: &Path, text: &str) -> Result<Plan, Vec<Fault>> {
    read(path, text, &TableFiles::beside(path))
}

fn read(path: &Path, text: &str, tables: &TableFiles) -> Result<Plan, Vec<Fault>> {
    let json = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("json"));
    let notation = if json { Notation::Json } else { Notation::Ron };
    let plan = notation.plan(text, tables);
    plan.map_err(|errors| errors.into_iter().map(|error| Fault::at(path, error)).collect())
}
