//! The rows of a sweep on disk as they are computed: what a stopped sweep goes on from, and what parts are put
//! together from.
//!
//! A line of JSON says which sweep it is, then each row has a line, written whole and in no order. A last line without
//! its end was being written when the program was stopped; it is computed again.

use crate::app::command::Common;
use crate::app::console::Failure;
use crate::app::scene_file::SceneFile;
use crate::input::problem::Problem;
use crate::scene::Scene;
use crate::sweep::{Arrangement, Axis, Part, Row, Sweep};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs::{File, TryLockError};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// Which sweep the rows are of; two that differ in nothing give the same rows.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
pub struct Head {
    /// Version of the program.
    pub version: String,
    /// Name of the scene's file.
    pub file: String,
    /// Name of the scene's file without its extension, the stem of the outputs.
    pub stem: String,
    /// The scene before anything is set.
    pub scene: Scene,
    /// What is varied.
    pub axes: Vec<Axis>,
    /// How the axes go together.
    pub arrangement: Arrangement,
    /// Number of rows of all parts.
    pub rows: usize,
    /// Tables the scene names, and what they hold in a number.
    pub tables: Vec<(PathBuf, u64)>,
}

impl Head {
    /// Of the sweep of a scene.
    ///
    /// # Errors
    /// A table of the scene has gone.
    pub fn of(scene: &SceneFile, sweep: &Sweep) -> Result<Self, Failure> {
        let held = |path: &PathBuf| Ok((path.clone(), digest(path)?));
        Ok(Self {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            file: scene.file_name(),
            stem: scene.stem(),
            scene: scene.plan.scene.clone(),
            axes: sweep.axes().to_vec(),
            arrangement: sweep.arrangement(),
            rows: sweep.rows(),
            tables: scene.tables.iter().map(held).collect::<Result<_, io::Error>>().map_err(Failure::failed)?,
        })
    }

    /// Names of the files of the whole, in the order of the formats asked for.
    pub fn outputs(&self, common: &Common) -> impl Iterator<Item = String> {
        common.format.iter().map(|format| format!("{}.sweep.{}", self.stem, format.ending()))
    }

    /// The sweep.
    ///
    /// # Errors
    /// The file was made by hand.
    pub fn sweep(&self) -> Result<Sweep, Problem> {
        Sweep::over(&self.scene, self.axes.clone(), self.arrangement)
    }
}

/// A number that differs if the bytes of a file do.
fn digest(path: &Path) -> io::Result<u64> {
    let mut hasher = DefaultHasher::new();
    std::fs::read(path)?.hash(&mut hasher);
    Ok(hasher.finish())
}

/// Rows by their number.
pub type Rows = BTreeMap<usize, Row>;

/// Name of the file of a part, without its stem.
pub fn ending(part: Part) -> String {
    match part {
        Part::WHOLE => ".sweep.unfinished.jsonl".to_owned(),
        part => format!(".sweep.part-{}-of-{}.jsonl", part.number(), part.of()),
    }
}

/// A journal that is written.
#[derive(Debug)]
pub struct Journal {
    file: Mutex<File>,
}

impl Journal {
    /// The journal at `path` and the rows it has, none if it is of another sweep than `head`; other programs that
    /// write it are kept out.
    ///
    /// # Errors
    /// The file cannot be made, read or written, or another program writes it.
    pub fn open(path: &Path, head: &Head) -> io::Result<(Self, Rows)> {
        let mut file = File::options().read(true).write(true).create(true).truncate(false).open(path)?;
        if let Err(TryLockError::WouldBlock) = file.try_lock() {
            return Err(io::Error::other("another run is computing it"));
        }
        let first = line(head)?;
        let mut text = String::new();
        // A file that is no text is none of ours, and begun anew as one of another sweep is.
        let read = file.read_to_string(&mut text);
        let mut rows = Rows::new();
        let mut kept = 0;
        if read.is_ok() && text.starts_with(&first) {
            let whole = text.rfind('\n').map_or(0, |at| at + 1);
            rows = rows_of(&text[first.len()..whole]);
            kept = whole as u64;
        }
        file.set_len(kept)?;
        file.seek(SeekFrom::End(0))?;
        if kept == 0 {
            file.write_all(first.as_bytes())?;
        }
        Ok((Self { file: Mutex::new(file) }, rows))
    }

    /// Adds a row.
    ///
    /// # Errors
    /// The file cannot be written, as on a full disk.
    pub fn add(&self, row: &Row) -> io::Result<()> {
        let line = line(row)?;
        self.file.lock().unwrap_or_else(PoisonError::into_inner).write_all(line.as_bytes())
    }
}

/// The head and the rows in the text of a journal, if it is one.
pub fn read(text: &str) -> Option<(Head, Rows)> {
    let (head, rows) = text.split_once('\n')?;
    let whole = rows.rfind('\n').map_or(0, |at| at + 1);
    Some((serde_json::from_str(head).ok()?, rows_of(&rows[..whole])))
}

fn rows_of(lines: &str) -> Rows {
    lines.lines().filter_map(|line| serde_json::from_str::<Row>(line).ok()).map(|row| (row.number, row)).collect()
}

fn line(value: &impl Serialize) -> io::Result<String> {
    let mut line = serde_json::to_string(value)?;
    line.push('\n');
    Ok(line)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn head(title: &str) -> Head {
        let text = format!(
            "(title: \"{title}\", shape: Cone(slope: 0.1), bodies: (Elastic(young: 1, poisson: 0), Rigid), \
             history: [Indent(to: 1, over: 1)])"
        );
        let axes = vec![Axis { path: "shape.slope".to_owned(), unit: None, values: vec![0.1.into(), 0.2.into()] }];
        Head {
            version: "0".to_owned(),
            file: "s.ron".to_owned(),
            stem: "s".to_owned(),
            scene: Scene::from_ron(&text).unwrap(),
            axes,
            arrangement: Arrangement::Grid,
            rows: 2,
            tables: Vec::new(),
        }
    }

    fn row(number: usize) -> Row {
        Row {
            number,
            results: vec![("force_n".to_owned(), (0.1 + number as f64).into())],
            error_estimate: Some(1e-14),
            warnings: vec!["a \"b\"\n c".to_owned()],
            failure: None,
            curve: vec![(1.0 / 3.0, -2e-9)],
        }
    }

    /// Cut at any byte, the whole rows before it are there again and the rest can be added.
    #[test]
    fn a_journal_cut_anywhere_keeps_its_whole_rows() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("j");
        let (journal, rows) = Journal::open(&path, &head("a")).unwrap();
        assert!(rows.is_empty());
        journal.add(&row(1)).unwrap();
        journal.add(&row(0)).unwrap();
        drop(journal);
        let whole = std::fs::read(&path).unwrap();
        let ends: Vec<usize> =
            whole.iter().enumerate().filter(|(_, byte)| **byte == b'\n').map(|(at, _)| at + 1).collect();
        for cut in 0..=whole.len() {
            std::fs::write(&path, &whole[..cut]).unwrap();
            let (journal, rows) = Journal::open(&path, &head("a")).unwrap();
            let expected: Vec<usize> =
                [1, 0].into_iter().zip(&ends[1..]).filter(|(_, end)| **end <= cut).map(|(row, _)| row).collect();
            assert_eq!(rows.len(), expected.len(), "cut at {cut}");
            assert!(rows.iter().all(|(number, found)| expected.contains(number) && *found == row(*number)));
            for number in [1, 0].into_iter().filter(|number| !rows.contains_key(number)) {
                journal.add(&row(number)).unwrap();
            }
            drop(journal);
            assert!(std::fs::read(&path).unwrap() == whole, "cut at {cut}");
        }
    }

    #[test]
    fn a_journal_of_another_sweep_is_begun_anew_and_a_taken_one_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("j");
        let (journal, _) = Journal::open(&path, &head("a")).unwrap();
        journal.add(&row(0)).unwrap();
        assert!(Journal::open(&path, &head("a")).unwrap_err().to_string().contains("another run"));
        drop(journal);
        let (_, rows) = Journal::open(&path, &head("b")).unwrap();
        assert!(rows.is_empty());
        assert_eq!(read(&std::fs::read_to_string(&path).unwrap()).unwrap().0, head("b"));
    }
}
