//! `springbed check`: reads scenes and says what is wrong with them.

use super::Common;
use crate::app::console::{Console, Failure};
use crate::app::fault::Fault;
use crate::app::scene_file::SceneFile;
use serde::Serialize;
use std::path::{Path, PathBuf};

/// The scenes in the files at `paths`, all of them or every fault of every file.
///
/// # Errors
/// Any of them is wrong.
pub fn load(paths: &[PathBuf]) -> Result<Vec<SceneFile>, Failure> {
    let (mut scenes, mut faults) = (Vec::new(), Vec::new());
    for path in paths {
        match SceneFile::load(path) {
            Ok(scene) => scenes.push(scene),
            Err(found) => faults.extend(found),
        }
    }
    if faults.is_empty() { Ok(scenes) } else { Err(Failure::Scene(faults)) }
}

/// What `--json` prints of one fault.
#[derive(Serialize)]
struct FaultRow<'f> {
    file: &'f Path,
    line: Option<usize>,
    column: Option<usize>,
    message: &'f str,
}

/// Checks scenes.
///
/// # Errors
/// Any of them is wrong.
pub fn run(paths: &[PathBuf], common: &Common, console: &Console) -> Result<(), Failure> {
    let loaded = load(paths);
    if common.json {
        let faults = if let Err(Failure::Scene(faults)) = &loaded { &faults[..] } else { &[] };
        console.result(&json(faults)?)?;
    }
    for scene in &loaded? {
        let title = &scene.plan.scene.title;
        if !common.json {
            console.say(&format!(
                "{}: ok{}{title}",
                scene.path.display(),
                if title.is_empty() { "" } else { " — " }
            ))?;
        }
    }
    Ok(())
}

fn json(faults: &[Fault]) -> Result<String, Failure> {
    let rows: Vec<FaultRow<'_>> = faults.iter().map(FaultRow::of).collect();
    serde_json::to_string_pretty(&serde_json::json!({ "problems": rows })).map_err(Failure::failed)
}

impl<'f> FaultRow<'f> {
    fn of(fault: &'f Fault) -> Self {
        let (line, column) = fault.position.map(|position| (position.line, position.column)).unzip();
        Self { file: &fault.file, line, column, message: &fault.message }
    }
}
