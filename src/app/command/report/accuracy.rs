//! `springbed report accuracy`: error first, run time second.

use super::peers::{self, Peer};
use super::{Common, File, deliver};
use crate::app::console::{Console, Failure};
use crate::app::export::work_precision as export;
use crate::app::machine::Machine;
use crate::app::progress::Progress;
use crate::check::work_precision::{self, Effort, Point, Study};

/// All cases by all solvers.
///
/// # Errors
/// A solver gave no answer, or a file cannot be written.
pub fn run(effort: Effort, common: &Common, console: &Console) -> Result<(), Failure> {
    let studies = work_precision::all(effort);
    let points = measured(&studies, effort, &Progress::of("report accuracy", console));
    let peers = peers::all()?;
    let machine = Machine::here();
    let files = files(&studies, &points, (&peers, &machine))?;
    let said = if common.json {
        export::json(&studies, &points, &machine).map_err(Failure::failed)?
    } else {
        export::table(&studies, &points, &machine)
    };
    deliver(files, &said, common, console)?;
    complete(&points)
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
    let json = export::json(studies, points, machine).map_err(Failure::failed)?;
    let csv = export::csv(points).map_err(Failure::failed)?;
    let mut files = vec![("accuracy.csv".to_owned(), csv), ("accuracy.json".to_owned(), json)];
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

/// A solver that gave no answer is a failure.
fn complete(points: &[Vec<Point>]) -> Result<(), Failure> {
    let silent = points.iter().flatten().filter(|point| point.error.is_nan());
    let silent: Vec<String> = silent.map(|point| format!("{} by {}", point.case, point.method)).collect();
    if silent.is_empty() { Ok(()) } else { Err(Failure::Failed(format!("no answer: {}", silent.join(", ")))) }
}
