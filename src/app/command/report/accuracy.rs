//! `springbed report accuracy`: error first, run time second.

use super::peers::{self, Peer};
use super::{Common, File, deliver};
use crate::app::console::{Console, Failure};
use crate::app::export::{promise as promises, work_precision as export};
use crate::app::machine::Machine;
use crate::app::progress::Progress;
use crate::app::scene_file::SceneFile;
use crate::check::promise::{self, Row};
use crate::check::work_precision::{self, Effort, Point, Study};
use std::path::Path;

/// All cases by all solvers.
///
/// # Errors
/// A solver gave no answer, or a file cannot be written.
pub fn run(effort: Effort, common: &Common, console: &Console) -> Result<(), Failure> {
    let studies = work_precision::all(effort);
    let points = measured(&studies, effort, &Progress::of("report accuracy", console));
    let peers = peers::all()?;
    let machine = Machine::here();
    let promises = promise::rows(|| ());
    let mut files = files(&studies, &points, (&peers, &machine))?;
    files.push(("accuracy.promises.csv".to_owned(), promises::csv(&promises).map_err(Failure::failed)?));
    let json = export::json((&studies, &points), &promises, &machine).map_err(Failure::failed)?;
    let table = || format!("{}\n{}", promises::table(&promises), export::table(&studies, &points, &machine));
    let said = if common.json { json.clone() } else { table() };
    files.push(("accuracy.json".to_owned(), json));
    deliver(files, &said, common, console)?;
    complete(&points)?;
    kept(&promises)
}

#[expect(clippy::cast_precision_loss, reason = "few points")]
fn measured(studies: &[Study], effort: Effort, progress: &Progress<'_>) -> Vec<Vec<Point>> {
    let all = studies.iter().map(Study::len).sum::<usize>() as f64;
    let mut behind = 0.0;
    let mut done = || {
        behind += 1.0;
        progress.done(behind / all);
    };
    studies.iter().map(|study| study.points(effort, &mut done)).collect()
}

fn files(
    studies: &[Study],
    points: &[Vec<Point>],
    (peers, machine): (&[Peer], &Machine),
) -> Result<Vec<File>, Failure> {
    let csv = export::csv(points).map_err(Failure::failed)?;
    let mut files = vec![("accuracy.csv".to_owned(), csv)];
    #[cfg(feature = "plot")]
    for (study, points) in studies.iter().zip(points) {
        let peers: Vec<&Peer> = peers.iter().filter(|peer| peer.case == study.case).collect();
        let marks: Vec<(&str, f64, f64)> =
            peers.iter().map(|peer| (peer.code.as_str(), peer.error, peer.time_s)).collect();
        let figure = export::figure(study, points, &marks, machine);
        files.push((format!("accuracy.{}.svg", study.case), figure.svg()));
    }
    #[cfg(not(feature = "plot"))]
    let _ = peers;
    Ok(files)
}

/// One scene by its own solver at several accuracies and by springs.
///
/// # Errors
/// The scene is wrong or cannot be run, or a file cannot be written.
pub fn of_scene(path: &Path, effort: Effort, common: &Common, console: &Console) -> Result<(), Failure> {
    let scene = SceneFile::load(path).map_err(Failure::Scene)?;
    let studies = [work_precision::scene(&scene.setup, effort).map_err(Failure::failed)?];
    let mut points = measured(&studies, effort, &Progress::of("report accuracy", console));
    // A bed may not be able to follow what the scene's own solver can.
    points[0].retain(|point| !point.error.is_nan());
    let machine = Machine::here();
    let json = export::json((&studies, &points), &[], &machine).map_err(Failure::failed)?;
    let csv = export::csv(&points).map_err(Failure::failed)?;
    let said = if common.json { json.clone() } else { export::table(&studies, &points, &machine) };
    let name = |ending: &str| format!("{}.accuracy.{ending}", scene.stem());
    let files = vec![(name("csv"), csv), (name("json"), json)];
    #[cfg(feature = "plot")]
    let files = [files, vec![(name("svg"), export::figure(&studies[0], &points[0], &[], &machine).svg())]].concat();
    deliver(files, &said, common, console)
}

/// A solver that gave no answer is a failure.
fn complete(points: &[Vec<Point>]) -> Result<(), Failure> {
    let silent = points.iter().flatten().filter(|point| point.error.is_nan());
    let silent: Vec<String> = silent.map(|point| format!("{} by {}", point.case, point.method)).collect();
    if silent.is_empty() { Ok(()) } else { Err(Failure::Failed(format!("no answer: {}", silent.join(", ")))) }
}

/// A true error larger than the estimate is a failure.
fn kept(rows: &[Row]) -> Result<(), Failure> {
    let broken: Vec<&str> = rows.iter().filter(|row| !row.kept).map(|row| row.scene).collect();
    if broken.is_empty() {
        return Ok(());
    }
    Err(Failure::Failed(format!("true errors larger than estimated: {}", broken.join(", "))))
}
