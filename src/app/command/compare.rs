//! `springbed compare`: a scene by all methods.

use super::Common;
use crate::app::console::{Console, Failure};
use crate::app::export;
use crate::app::progress::Progress;
use crate::app::run::Format;
use crate::app::scene_file::SceneFile;
use crate::app::write::write_all;
use crate::check::comparison::{Comparison, compare};
use std::path::Path;

/// Compares the methods on a scene: table on standard output, CSV and figure in files.
///
/// # Errors
/// The scene is wrong or cannot be compared; a file cannot be written.
pub fn run(path: &Path, common: &Common, console: &Console) -> Result<(), Failure> {
    let scene = SceneFile::load(path).map_err(Failure::Scene)?;
    let progress = Progress::of("comparing", console);
    let comparison = compare(&scene.plan, &|share| progress.done(share)).map_err(Failure::failed)?;
    drop(progress);
    let title = &scene.plan.scene.title;
    if common.json {
        console.result(&export::comparison_json(&comparison).map_err(Failure::failed)?)?;
    } else {
        console.say(&export::comparison_text(title, &comparison))?;
    }
    let files = files(&scene, &comparison, common)?;
    let files: Vec<(String, &[u8])> = files.iter().map(|(name, text)| (name.clone(), text.as_bytes())).collect();
    let written = write_all(&common.out, &files).map_err(Failure::failed)?;
    let written: Vec<String> = written.iter().map(|path| path.display().to_string()).collect();
    if !written.is_empty() {
        console.message(&format!("  wrote {}", written.join(", ")));
    }
    Ok(())
}

/// Names and contents of the files asked for.
fn files(scene: &SceneFile, comparison: &Comparison, common: &Common) -> Result<Vec<(String, String)>, Failure> {
    let stem = scene.stem();
    let mut files = Vec::new();
    let wants = |format| common.format.contains(&format);
    if wants(Format::Csv) {
        let table = export::comparison_table(comparison).map_err(Failure::failed)?;
        files.push((format!("{stem}.compare.csv"), table));
    }
    if wants(Format::Json) {
        let json = export::comparison_json(comparison).map_err(Failure::failed)?;
        files.push((format!("{stem}.compare.json"), json));
    }
    #[cfg(feature = "plot")]
    if wants(Format::Svg) {
        let title = &scene.plan.scene.title;
        files.push((format!("{stem}.compare.svg"), export::comparison_figure(title, comparison).svg()));
    }
    Ok(files)
}
