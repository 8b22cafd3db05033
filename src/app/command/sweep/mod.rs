//! `springbed run --set`: a scene with many values, on all threads, from where it was stopped.
//!
//! # Examples
//! ```no_run
//! // springbed run scene.ron --set bodies.0.young=1kPa..1MPa:50log
//! let code = springbed::app::command::main();
//! ```

mod gather;
mod journal;

pub use gather::gather;
use journal::Head;

use super::Common;
use crate::app::console::{Console, Failure};
use crate::app::export;
use crate::app::overwrite::Outputs;
use crate::app::progress::Progress;
use crate::app::run::Format;
use crate::app::scene_file::SceneFile;
use crate::app::table_file::TableFiles;
use crate::app::write::write_all;
use crate::input::values::Values;
use crate::sweep::{Arrangement, Part, Row, Sweep, table};
use journal::{Journal, Rows, ending};
use rayon::prelude::*;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

/// What is varied, as the command line says it.
#[derive(Debug, Clone, clap::Args)]
pub struct SweepArgs {
    /// Values of a place of the scene, such as bodies.0.young=1kPa..1MPa:50log or adhesion.work=[0.01,0.05]; several
    /// make a grid.
    #[arg(long, value_name = "PATH=VALUES", value_parser = setting)]
    pub set: Vec<(String, Values)>,
    /// The values of all --set side by side, not each with every other.
    #[arg(long, requires = "set")]
    pub zip: bool,
    /// Only part K of N of a sweep, for one of N jobs; `springbed gather` puts them together.
    #[arg(long, value_name = "K/N")]
    pub part: Option<Part>,
}

fn setting(text: &str) -> Result<(String, Values), String> {
    let (path, values) = text.split_once('=').ok_or("expected PATH=VALUES, such as bodies.0.young=1kPa..1MPa:50log")?;
    let values = values.parse().map_err(|error: crate::input::values::ValuesError| error.to_string())?;
    Ok((path.trim().to_owned(), values))
}

/// The sweep of a scene, or a part of it.
#[derive(Debug)]
pub struct Job<'s> {
    scene: &'s SceneFile,
    sweep: Sweep,
    head: Head,
    part: Part,
}

/// What came out of a sweep.
#[derive(Debug, Default)]
pub struct Swept {
    /// Its JSON, if that is wanted and all parts are there.
    pub json: Option<String>,
    /// Which rows could not be computed, and why.
    pub failure: Option<String>,
}

impl SweepArgs {
    /// The sweep of a scene: that of the command line if it says one, or else that of the scene, if it does.
    ///
    /// # Errors
    /// A path or value is wrong; a part is wanted of a scene that has no values.
    pub fn job<'s>(&self, scene: &'s SceneFile) -> Result<Option<Job<'s>>, Failure> {
        let usage = |what: String| Failure::Usage(format!("{}: {what}", scene.path.display()));
        let arrangement = if self.zip { Arrangement::Zip } else { Arrangement::Grid };
        let sweep = match Sweep::written(&scene.plan.scene) {
            written if self.set.is_empty() => written,
            _ => Some(Sweep::new(&scene.plan.scene, &self.set, arrangement)),
        };
        match sweep {
            None if self.part.is_some() => {
                Err(usage("--part needs a sweep: expected --set, or `sweep` in the scene".to_owned()))
            }
            None => Ok(None),
            Some(Err(problem)) => Err(usage(problem.to_string())),
            Some(Ok(sweep)) => {
                let (head, part) = (Head::of(scene, &sweep)?, self.part.unwrap_or(Part::WHOLE));
                Ok(Some(Job { scene, sweep, head, part }))
            }
        }
    }
}

impl<'s> Job<'s> {
    /// The files it writes.
    #[must_use]
    pub fn outputs(&self, common: &Common) -> Outputs<'s> {
        let journal = std::iter::once(self.journal());
        Outputs { scene: self.scene, names: journal.chain(self.head.outputs(common)).collect() }
    }

    fn journal(&self) -> String {
        format!("{}{}", self.head.stem, ending(self.part))
    }

    /// Computes the rows that are not there from a run that was stopped, on all threads; writes and says what came out.
    ///
    /// # Errors
    /// A file cannot be written, or another program computes the same.
    pub fn run(&self, common: &Common, console: &Console) -> Result<Swept, Failure> {
        write_all(&common.out, &[]).map_err(Failure::failed)?;
        let path = common.out.join(self.journal());
        let rows = self.rows(&path, console)?;
        if self.part == Part::WHOLE {
            let swept = finish(&self.head, &self.sweep, rows, common, console)?;
            std::fs::remove_file(&path).map_err(|error| unwritten(&path, &error))?;
            return Ok(swept);
        }
        console.message(&format!("  wrote {}", path.display()));
        let folder = common.out.display();
        console.message(&format!("  when all {} parts are there: springbed gather {folder}", self.part.of()));
        Ok(Swept { json: None, failure: failure(rows.values()) })
    }

    /// The rows of the part: those of its journal and, computed on all threads, those that are missing.
    fn rows(&self, path: &Path, console: &Console) -> Result<Rows, Failure> {
        let (journal, mut rows) = Journal::open(path, &self.head).map_err(|error| unwritten(path, &error))?;
        let all = self.part.rows(self.sweep.rows());
        let missing: Vec<usize> = all.clone().filter(|number| !rows.contains_key(number)).collect();
        if !rows.is_empty() {
            console.message(&format!("  goes on: {} of {} rows are there", rows.len(), all.len()));
        }
        let (progress, done) = (Progress::of("sweeping", console), AtomicUsize::new(0));
        let computed = missing.par_iter().map(|&number| {
            let row = self.sweep.row(number, &TableFiles::beside(&self.scene.path), self.sweep.curves(number));
            journal.add(&row).map_err(|error| unwritten(path, &error))?;
            progress.done((done.fetch_add(1, Ordering::Relaxed) + 1) as f64 / missing.len() as f64);
            Ok((number, row))
        });
        rows.extend(computed.collect::<Result<Vec<_>, Failure>>()?);
        Ok(rows)
    }
}

fn unwritten(path: &Path, error: &std::io::Error) -> Failure {
    Failure::Failed(format!("{}: cannot be written: {error}", path.display()))
}

/// Writes and says what came out of all rows.
fn finish(head: &Head, sweep: &Sweep, rows: Rows, common: &Common, console: &Console) -> Result<Swept, Failure> {
    let rows: Vec<Row> = rows.into_values().collect();
    let json = || export::sweep_json((&head.version, &head.file), &head.scene, sweep, &rows).map_err(Failure::failed);
    let mut contents = Vec::new();
    for (&format, name) in common.format.iter().zip(head.outputs(common)) {
        let content = match format {
            Format::Csv => export::csv(&table(sweep, &rows)).map_err(Failure::failed)?.into_bytes(),
            Format::Json => json()?.into_bytes(),
            #[cfg(feature = "plot")]
            Format::Svg | Format::Png | Format::Pdf => {
                let figure = export::sweep_figure(&head.scene.title, sweep, &rows);
                common.drawing().bytes(&figure, format).map_err(Failure::failed)?.unwrap_or_default()
            }
            #[cfg(not(feature = "plot"))]
            Format::Svg | Format::Png | Format::Pdf => continue,
        };
        contents.push((name, content));
    }
    let files: Vec<(String, &[u8])> = contents.iter().map(|(name, bytes)| (name.clone(), &bytes[..])).collect();
    let written = write_all(&common.out, &files).map_err(Failure::failed)?;
    if !common.json {
        console.say(&export::sweep_summary(&head.scene.title, sweep, &rows))?;
    }
    for warning in export::sweep_warnings(&rows) {
        console.warning(&format!("{}: {warning}", head.file));
    }
    let written: Vec<String> = written.iter().map(|path| path.display().to_string()).collect();
    if !written.is_empty() {
        console.message(&format!("  wrote {}", written.join(", ")));
    }
    let json = if common.json { Some(json()?) } else { None };
    Ok(Swept { json, failure: failure(rows.iter()).map(|why| format!("{}: {why}", head.file)) })
}

/// The first row that could not be computed, and how many could not.
fn failure<'r>(rows: impl Iterator<Item = &'r Row> + Clone) -> Option<String> {
    let all = rows.clone().count();
    let mut failed = rows.filter_map(|row| Some((row.number, row.failure.as_ref()?)));
    let (number, why) = failed.next()?;
    Some(format!("{} of {all} rows could not be computed; row {number}: {why}", 1 + failed.count()))
}
