//! `springbed gather`: the parts of a sweep put together.

use super::finish;
use super::journal::{Head, Rows, read};
use crate::app::command::Common;
use crate::app::console::{Console, Failure};
use crate::app::export;
use crate::app::read::read_text;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Largest file of a part.
const LARGEST: u64 = 1 << 36;

/// The parts of one sweep found in a folder.
struct Found {
    head: Head,
    rows: Rows,
    file: PathBuf,
}

/// Puts together the parts of all sweeps in `folder`.
///
/// # Errors
/// There is none, rows are missing, parts are of different sweeps under one name, or a file cannot be written.
pub fn gather(folder: &Path, common: &Common, console: &Console) -> Result<(), Failure> {
    let found = found(folder)?;
    if found.is_empty() {
        let right = "expected what `springbed run --part K/N` writes into --out";
        return Err(Failure::Usage(format!("{}: holds no parts of a sweep: {right}", folder.display())));
    }
    let (mut jsons, mut failed) = (Vec::new(), Vec::new());
    for Found { head, rows, file } in found.into_values() {
        let missing: Vec<usize> = (0..head.rows).filter(|number| !rows.contains_key(number)).collect();
        if let (Some(first), Some(last)) = (missing.first(), missing.last()) {
            return Err(Failure::Failed(format!(
                "{}: {} of {} rows are missing, from {first} to {last}: the parts that hold them are to be run (again)",
                head.file,
                missing.len(),
                head.rows,
            )));
        }
        let sweep = head.sweep().map_err(|problem| Failure::Failed(format!("{}: {problem}", file.display())))?;
        let swept = finish(&head, &sweep, rows, common, console)?;
        jsons.extend(swept.json);
        failed.extend(swept.failure);
    }
    if common.json {
        console.result(&export::json_of_all(&jsons))?;
    }
    if failed.is_empty() { Ok(()) } else { Err(Failure::Failed(failed.join("\n"))) }
}

/// The sweeps whose parts are in a folder, by the stems of their scenes, in the order of the names of their files.
fn found(folder: &Path) -> Result<BTreeMap<String, Found>, Failure> {
    let unreadable = |error: std::io::Error| Failure::Usage(format!("{}: cannot be read: {error}", folder.display()));
    let entries = std::fs::read_dir(folder).map_err(unreadable)?;
    let is_part = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        name.contains(".sweep.part-") && name.ends_with(".jsonl")
    };
    let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).filter(is_part).collect();
    paths.sort();
    let mut sweeps: BTreeMap<String, Found> = BTreeMap::new();
    for file in paths {
        let text = read_text(&file, LARGEST).map_err(|fault| Failure::Scene(vec![fault]))?;
        let Some((head, rows)) = read(&text) else {
            return Err(Failure::Failed(format!("{}: is no part of a sweep", file.display())));
        };
        match sweeps.get_mut(&head.stem) {
            None => drop(sweeps.insert(head.stem.clone(), Found { head, rows, file })),
            Some(found) if found.head == head => found.rows.extend(rows),
            Some(found) => {
                return Err(Failure::Failed(format!(
                    "{} and {} are of different sweeps: expected the parts of one scene with the same values",
                    found.file.display(),
                    file.display()
                )));
            }
        }
    }
    Ok(sweeps)
}
