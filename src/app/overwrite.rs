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
    let mut read: BTreeMap<PathBuf, &SceneFile> = BTreeMap::new();
    for (name, scene) in all.iter().flat_map(|outputs| inputs(outputs.scene)) {
        read.entry(name).or_insert(scene);
    }
    let into = followed(folder);
    let mut written: BTreeMap<PathBuf, &Path> = BTreeMap::new();
    let mut refused = Vec::new();
    for Outputs { scene, names } in all {
        refused.extend(names.iter().find_map(|name| over_input((folder, &into), name, (scene, &read))));
        refused.extend(names.iter().find_map(|name| {
            let other = written.get(&into.join(name))?;
            let (other, path) = (other.display(), scene.path.display());
            Some(format!("{other} and {path} would both write {name}: expected scenes of different names"))
        }));
        written.extend(names.iter().map(|name| (into.join(name), scene.path.as_path())));
    }
    if refused.is_empty() { Ok(()) } else { Err(Failure::Usage(refused.join("\n"))) }
}

/// Every name of every file that a scene reads: itself, its tables, and what they are links to.
fn inputs(scene: &SceneFile) -> impl Iterator<Item = (PathBuf, &SceneFile)> {
    let files = std::iter::once(&scene.path).chain(&scene.tables);
    files.flat_map(|file| names(file)).map(move |name| (name, scene))
}

/// What is wrong with the output `name` of a scene in the folder as it was given and as it is, if it is one of the files read.
fn over_input(
    (folder, into): (&Path, &Path),
    name: &str,
    (writer, read): (&SceneFile, &BTreeMap<PathBuf, &SceneFile>),
) -> Option<String> {
    let path = folder.join(name);
    let link = || path.canonicalize().ok().and_then(|file| read.get(&file));
    let reader = read.get(&into.join(name)).or_else(link)?;
    let (path, writer, reader) = (path.display(), writer.path.display(), reader.path.display());
    Some(format!("{writer} would write over {path}, which {reader} reads: expected another folder in --out"))
}

/// The absolute name of a file as it stands in its folder, and that of what it is a link to.
fn names(path: &Path) -> BTreeSet<PathBuf> {
    let folder = followed(path.parent().unwrap_or_else(|| Path::new("")));
    let own = path.file_name().map_or_else(|| folder.clone(), |name| folder.join(name));
    std::iter::once(own).chain(path.canonicalize()).collect()
}

/// The absolute name of a folder, links in the way to it followed as far as there is a way.
fn followed(folder: &Path) -> PathBuf {
    folder.canonicalize().unwrap_or_else(|_| {
        let start = std::env::current_dir().unwrap_or_default();
        folder.components().fold(start, |at, component| {
            let next = match component {
                Component::ParentDir => at.parent().map_or_else(PathBuf::new, Path::to_owned),
                Component::CurDir => at,
                Component::Normal(_) | Component::RootDir | Component::Prefix(_) => at.join(component),
            };
            next.canonicalize().unwrap_or(next)
        })
    })
}
