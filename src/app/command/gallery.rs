//! `springbed gallery`: scenes and what came out of them as one page.

use super::Common;
use super::check::load;
use crate::app::console::{Console, Failure};
use crate::app::export::{self, Shown};
use crate::app::overwrite::{self, Outputs};
use crate::app::run::{Format, compute};
use crate::app::scene_file::SceneFile;
use crate::app::write::write_all;
use rayon::prelude::*;
use std::path::PathBuf;

/// Name of the page.
const PAGE: &str = "index.html";

/// Computes scenes and writes a page of them into `--out`.
///
/// # Errors
/// A scene is wrong or cannot be computed; the page cannot be written.
pub fn run(paths: &[PathBuf], common: &Common, console: &Console) -> Result<(), Failure> {
    let scenes = load(paths)?;
    for scene in &scenes {
        overwrite::refuse(&common.out, &[Outputs { scene, names: vec![PAGE.to_owned()] }])?;
    }
    let progress = console.progress(scenes.len(), "scenes");
    let shown = scenes.into_par_iter().map(shown).inspect(|_| progress.inc(1)).collect::<Result<Vec<_>, Failure>>();
    progress.finish_and_clear();
    let page = export::gallery(&shown?);
    let written = write_all(&common.out, &[(PAGE.to_owned(), page.as_bytes())]).map_err(Failure::failed)?;
    for path in written {
        console.message(&format!("  wrote {}", path.display()));
    }
    Ok(())
}

fn shown(scene: SceneFile) -> Result<Shown, Failure> {
    let outcome = compute(&scene.plan, &[Format::Svg, Format::Json]);
    let outcome = outcome.map_err(|error| Failure::Failed(format!("{}: {error}", scene.path.display())))?;
    Ok(Shown { stem: scene.stem(), text: scene.text, plan: scene.plan, outcome })
}
