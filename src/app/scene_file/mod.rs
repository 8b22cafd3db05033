//! Scene files: bytes in, a checked scene out, or every fault with its place.

mod bytes;
mod names;
mod parse;

pub use bytes::{read_bytes, read_text};
pub use names::{advice, nearest};

use super::fault::Fault;
use super::place;
use super::table_file::TableFiles;
use crate::input::problem::Problem;
use crate::scene::setup::Setup;
use std::path::{Path, PathBuf};

/// A scene read from a file, ready to be computed.
#[derive(Debug, Clone)]
pub struct SceneFile {
    /// The file.
    pub path: PathBuf,
    /// The scene with its tables read.
    pub setup: Setup,
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
        let setup = setup(path, &text)?;
        Ok(Self { path: path.to_owned(), setup })
    }

    /// Name of the file without directory and extension, the stem of its outputs.
    #[must_use]
    pub fn stem(&self) -> String {
        self.path.file_stem().map_or_else(|| "scene".to_owned(), |stem| stem.to_string_lossy().into_owned())
    }
}

/// The setup of the scene in `text`, which came from the file at `path`.
///
/// # Errors
/// Everything that is wrong with it, in the order of the text.
pub fn setup(path: &Path, text: &str) -> Result<Setup, Vec<Fault>> {
    let scene = parse::scene(path, text).map_err(|fault| vec![*fault])?;
    let tables = TableFiles::beside(path);
    scene.resolve(&tables).map_err(|problems| placed(path, text, &problems))
}

/// Problems at their places in the text, sorted by place.
fn placed(path: &Path, text: &str, problems: &[Problem]) -> Vec<Fault> {
    let paths: Vec<&str> = problems.iter().map(|problem| problem.path.as_str()).collect();
    let mut faults: Vec<Fault> = place::locate(text, &paths)
        .into_iter()
        .zip(problems)
        .map(|(offset, problem)| Fault::at(path, (text, offset), problem.to_string()))
        .collect();
    faults.sort_by(|a, b| (a.position, &a.message).cmp(&(b.position, &b.message)));
    faults
}
