//! What a command reads and what it is about to write: no file may be both, and none be written twice.

use super::console::Failure;
use super::scene_file::SceneFile;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Component, Path, PathBuf};

/// A scene and the names of the files it is about to write.
#[derive(Debug)]
pub struct Outputs<'s> {
    /// The scene.
    pub scene: &'s SceneFile,
    /// Names of its files in the folder of outputs.
    pub names: Vec<String>,
}

/// Refuses to write files into `folder` over what a scene reads, or over what another scene writes.
///
/// # Errors
/// Every pair of scenes that do, with the file.
pub fn refuse(folder: &Path, all: &[Outputs<'_>]) -> Result<(), Failure> {
    let read: Vec<(PathBuf, &SceneFile)> = all.iter().flat_map(|outputs| inputs(outputs.scene)).collect();
    let mut written: BTreeMap<PathBuf, &Path> = BTreeMap::new();
    let mut refused = Vec::new();
    for Outputs { scene, names } in all {
        refused.extend(names.iter().find_map(|name| over_input(&folder.join(name), scene, &read)));
        refused.extend(names.iter().find_map(|name| {
            let other = written.get(&resolved(&folder.join(name)))?;
            let (other, path) = (other.display(), scene.path.display());
            Some(format!("{other} and {path} would both write {name}: expected scenes of different names"))
        }));
        written.extend(names.iter().map(|name| (resolved(&folder.join(name)), scene.path.as_path())));
    }
    if refused.is_empty() { Ok(()) } else { Err(Failure::Usage(refused.join("\n"))) }
}

/// Every name of every file that a scene reads: itself, its tables, and what they are links to.
fn inputs(scene: &SceneFile) -> impl Iterator<Item = (PathBuf, &SceneFile)> {
    let files = std::iter::once(&scene.path).chain(&scene.tables);
    files.flat_map(|file| names(file)).map(move |name| (name, scene))
}

/// What is wrong with the output `path` of a scene if it is one of the files `read`.
fn over_input(path: &Path, writer: &SceneFile, read: &[(PathBuf, &SceneFile)]) -> Option<String> {
    let names = names(path);
    let (_, reader) = read.iter().find(|(input, _)| names.contains(input))?;
    let (path, writer, reader) = (path.display(), writer.path.display(), reader.path.display());
    Some(format!("{writer} would write over {path}, which {reader} reads: expected another folder in --out"))
}

/// The absolute name of a file as it stands in its folder, and that of what it is a link to.
fn names(path: &Path) -> BTreeSet<PathBuf> {
    std::iter::once(resolved(path)).chain(path.canonicalize()).collect()
}

/// The absolute name of a file in its folder, links in the way to it followed as far as there is a way.
fn resolved(path: &Path) -> PathBuf {
    let folder = path.parent().unwrap_or_else(|| Path::new(""));
    let start = std::env::current_dir().unwrap_or_default();
    let folder = folder.components().fold(start, |at, component| {
        let next = match component {
            Component::ParentDir => at.parent().map_or_else(PathBuf::new, Path::to_owned),
            Component::CurDir => at,
            Component::Normal(_) | Component::RootDir | Component::Prefix(_) => at.join(component),
        };
        next.canonicalize().unwrap_or(next)
    });
    path.file_name().map_or_else(|| folder.clone(), |name| folder.join(name))
}
