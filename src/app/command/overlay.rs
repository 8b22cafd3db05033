//! `springbed overlay`: curves of several scenes, and measured ones, in one figure.

use super::Common;
use super::delivery::{Files, Findings};
use crate::app::console::{Console, Failure};
use crate::app::export::{self, Overlaid};
use crate::app::fault::Fault;
use crate::app::overwrite::{self, Outputs};
use crate::app::run::compute;
use crate::app::scene_file::SceneFile;
use crate::app::table_file::TableFiles;
use crate::input::table::Tables;
use rayon::prelude::*;
use std::path::{Path, PathBuf};

/// Name of the files, without what follows the dot.
const NAME: &str = "overlay";

/// What is to be laid over each other.
enum Source {
    Scene(Box<SceneFile>),
    Measured(Overlaid),
}

/// Draws the curves of scenes and of tables of measured values (`.csv`) together; writes figure and table.
///
/// # Errors
/// A scene or table is wrong, a computation failed, or a file cannot be written.
pub fn run(paths: &[PathBuf], common: &Common, console: &Console) -> Result<(), Failure> {
    let sources = sources(paths)?;
    let names = || common.format.iter().map(|format| format!("{NAME}.{}", format.ending())).collect();
    let scenes =
        sources.iter().filter_map(|source| if let Source::Scene(scene) = source { Some(&**scene) } else { None });
    // All scenes have one output: each is asked on its own whether it reads it.
    for scene in scenes {
        overwrite::refuse(&common.out, &[Outputs { scene, names: names() }])?;
    }
    refuse_measured(paths, common)?;
    let curves = sources.into_par_iter().map(overlaid).collect::<Result<Vec<_>, Failure>>()?;
    let json = export::overlay_json(&curves).map_err(Failure::failed)?;
    let files = vec![(format!("{NAME}.csv"), export::overlay_table(&curves).map_err(Failure::failed)?)];
    let findings = Findings {
        table: export::overlay_text(&curves),
        json,
        files: Files {
            texts: files,
            #[cfg(feature = "plot")]
            figures: vec![(NAME.to_owned(), export::overlay_figure(&curves))],
        },
    };
    findings.named(NAME).deliver(common, console)
}

fn sources(paths: &[PathBuf]) -> Result<Vec<Source>, Failure> {
    let (mut sources, mut faults) = (Vec::new(), Vec::new());
    for path in paths {
        let is_table = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("csv"));
        let read = if is_table {
            measured(path).map(Source::Measured)
        } else {
            SceneFile::load(path).map(Box::new).map(Source::Scene)
        };
        match read {
            Ok(source) => sources.push(source),
            Err(found) => faults.extend(found),
        }
    }
    if faults.is_empty() { Ok(sources) } else { Err(Failure::Scene(faults)) }
}

/// No table that is read may be one that is written.
fn refuse_measured(paths: &[PathBuf], common: &Common) -> Result<(), Failure> {
    let over = |path: &&PathBuf| {
        let written = common.out.join(format!("{NAME}.csv"));
        path.canonicalize().is_ok_and(|path| written.canonicalize().is_ok_and(|written| written == path))
    };
    match paths.iter().find(over) {
        Some(path) => Err(Failure::Usage(format!(
            "overlay would write over {}, which it reads: expected another folder in --out",
            path.display()
        ))),
        None => Ok(()),
    }
}

/// The curves of a table: those of its columns that records have too.
fn measured(path: &Path) -> Result<Overlaid, Vec<Fault>> {
    let fault = |message: String| vec![Fault::whole(path, message)];
    let tables = TableFiles::beside(path);
    let name = Path::new(path.file_name().unwrap_or_default());
    let names = tables.names(name).map_err(|error| fault(error.message))?;
    let all: Vec<&str> = names.iter().map(String::as_str).collect();
    let columns = tables.columns(name, &all).map_err(|error| {
        let row = error.row.map_or_else(String::new, |row| format!("row {row}: "));
        fault(format!("{row}{}", error.message))
    })?;
    let label = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let overlaid = Overlaid::measured(label, names.into_iter().zip(columns.values).collect());
    overlaid
        .ok_or_else(|| fault(format!("has no two columns of {}: expected them named so", export::OVERLAID.join(", "))))
}

fn overlaid(source: Source) -> Result<Overlaid, Failure> {
    match source {
        Source::Measured(curves) => Ok(curves),
        Source::Scene(scene) => {
            let failed = |error: &dyn std::fmt::Display| Failure::Failed(format!("{}: {error}", scene.path.display()));
            let outcome = compute(&scene.plan, &[]).map_err(|error| failed(&error))?;
            let title = &scene.plan.scene.title;
            Ok(Overlaid::computed(if title.is_empty() { scene.stem() } else { title.clone() }, &outcome))
        }
    }
}
