//! `springbed compare`: a scene by all methods.

use super::Common;
use super::delivery::{Files, Findings};
use crate::app::console::{Console, Failure};
use crate::app::export;
use crate::app::overwrite::{self, Outputs};
use crate::app::progress::Progress;
use crate::app::scene_file::SceneFile;
use crate::check::comparison::compare;
use std::path::Path;

/// Compares the methods on a scene: table on standard output, CSV and figure in files.
///
/// # Errors
/// The scene is wrong or cannot be compared; a file cannot be written.
pub fn run(path: &Path, common: &Common, console: &Console) -> Result<(), Failure> {
    let scene = SceneFile::load(path).map_err(Failure::Scene)?;
    let names = common.format.iter().map(|format| format!("{}.compare.{}", scene.stem(), format.ending())).collect();
    overwrite::refuse(&common.out, &[Outputs { scene: &scene, names }])?;
    let progress = Progress::of("comparing", console);
    let comparison = compare(&scene.plan, &|share| progress.done(share)).map_err(Failure::failed)?;
    drop(progress);
    let (title, name) = (&scene.plan.scene.title, format!("{}.compare", scene.stem()));
    let table = export::comparison_table(&comparison).map_err(Failure::failed)?;
    let files = vec![(format!("{name}.csv"), table)];
    let json = export::comparison_json(&comparison).map_err(Failure::failed)?;
    let findings = Findings {
        table: export::comparison_text(title, &comparison),
        json,
        files: Files {
            texts: files,
            #[cfg(feature = "plot")]
            figures: vec![(name.clone(), export::comparison_figure(title, &comparison))],
        },
    };
    findings.named(&name).deliver(common, console)
}
