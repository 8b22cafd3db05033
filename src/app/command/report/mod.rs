//! `springbed report`: accuracy, stability, speed.

mod peers;

use super::delivery::{Files, Findings};
use super::{Common, Topic};
use crate::app::console::{Console, Failure};
#[cfg(feature = "plot")]
use crate::app::export::report_figures;
use crate::app::export::reports::{self, ACCURACY, SPEED, STABILITY, STATED};
#[cfg(feature = "plot")]
use crate::app::figure::Figure;
use crate::app::machine::Machine;
use crate::app::overwrite::{self, Outputs};
use crate::app::progress::Progress;
use crate::app::scene_file::SceneFile;
use crate::check::case::{Case, Question};
use crate::check::cases;
use crate::check::row::Row;
use crate::check::speed;
use crate::check::study::{Study, Thoroughness};
use crate::check::ways;
use rayon::prelude::*;
use serde_json::json;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Makes a report.
///
/// # Errors
/// A scene is wrong, a check failed, or a file cannot be written.
pub fn run(
    topic: Topic,
    scene: Option<&Path>,
    effort: Thoroughness,
    common: &Common,
    console: &Console,
) -> Result<(), Failure> {
    let (report, failed) = match (topic, scene) {
        (Topic::Accuracy, None) => accuracy(effort, console)?,
        (Topic::Stability, None) => stability(console)?,
        (Topic::Speed, None) => throughput(effort, console)?,
        (Topic::Accuracy, Some(scene)) => accuracy_of(scene, effort, common, console)?,
        (Topic::Stability | Topic::Speed, Some(scene)) => {
            return Err(Failure::Usage(format!(
                "{}: stability and speed are those of the program: expected no scene",
                scene.display()
            )));
        }
    };
    report.deliver(common, console)?;
    if failed.is_empty() { Ok(()) } else { Err(Failure::Failed(failed.join("; "))) }
}

/// What failed, in words.
type Failed = Vec<String>;

/// Scenes with the errors they state, then all ways to compute the cases that have several.
fn accuracy(effort: Thoroughness, console: &Console) -> Result<(Findings, Failed), Failure> {
    let studies = cases::studies(effort).map_err(Failure::failed)?;
    let rows = measured(&studies, effort, console);
    let stated: Vec<Row> = cases::all().iter().flat_map(stated).collect();
    let machine = Machine::here();
    let files = vec![
        ("accuracy.csv".to_owned(), reports::csv(ACCURACY, &rows.concat()).map_err(Failure::failed)?),
        ("accuracy.stated.csv".to_owned(), reports::csv(STATED, &stated).map_err(Failure::failed)?),
    ];
    let json = accuracy_json(&studies, &rows, &stated, &machine)?;
    let table = reports::accuracy_table(&studies, &rows, &machine);
    let report = Findings {
        table: format!("{}\n{table}", reports::stated_table(&stated)),
        json,
        files: Files {
            texts: files,
            #[cfg(feature = "plot")]
            figures: figures(&studies, &rows, &machine)?,
        },
    };
    Ok((report.named("accuracy"), [silent(&rows.concat()), beyond(&stated)].concat()))
}

/// The rows of a case that states its own error.
fn stated(case: &Case) -> Vec<Row> {
    let Question::Stated(stated) = &case.question else { return Vec::new() };
    stated.rows().into_iter().map(|row| Row { case: case.name, ..row }).collect()
}

/// One scene by its own solver at several accuracies and by springs.
fn accuracy_of(
    path: &Path,
    effort: Thoroughness,
    common: &Common,
    console: &Console,
) -> Result<(Findings, Failed), Failure> {
    let scene = SceneFile::load(path).map_err(Failure::Scene)?;
    let names = common.format.iter().map(|format| format!("{}.accuracy.{}", scene.stem(), format.ending())).collect();
    overwrite::refuse(&common.out, &[Outputs { scene: &scene, names }])?;
    let studies = [ways::scene(&scene.plan, effort).map_err(Failure::failed)?];
    let rows = measured(&studies, effort, console);
    let machine = Machine::here();
    let name = format!("{}.accuracy", scene.stem());
    let files = vec![(format!("{name}.csv"), reports::csv(ACCURACY, &rows[0]).map_err(Failure::failed)?)];
    let json = accuracy_json(&studies, &rows, &[], &machine)?;
    let report = Findings {
        table: reports::accuracy_table(&studies, &rows, &machine),
        json,
        files: Files {
            texts: files,
            #[cfg(feature = "plot")]
            figures: vec![(name.clone(), report_figures::accuracy(&studies[0], &rows[0], &[], &machine))],
        },
    };
    // A bed may not be able to follow what the scene's own solver can.
    Ok((report.named(&name), Vec::new()))
}

/// The rows of each study.
#[expect(clippy::cast_precision_loss, reason = "few studies")]
fn measured(studies: &[Study], effort: Thoroughness, console: &Console) -> Vec<Vec<Row>> {
    let progress = Progress::of("report accuracy", console);
    let all = studies.len() as f64;
    let rows = |(at, study): (usize, &Study)| study.rows(effort, &mut |share| progress.done((at as f64 + share) / all));
    studies.iter().enumerate().map(rows).collect()
}

fn accuracy_json(studies: &[Study], rows: &[Vec<Row>], stated: &[Row], machine: &Machine) -> Result<String, Failure> {
    let references: serde_json::Map<_, _> =
        studies.iter().map(|study| (study.case.to_owned(), study.reference.clone().into())).collect();
    text(&json!({
        "reference": references,
        "rows": reports::objects(ACCURACY, &rows.concat()),
        "stated": reports::objects(STATED, stated),
        "machine": machine,
    }))
}

#[cfg(feature = "plot")]
fn figures(studies: &[Study], rows: &[Vec<Row>], machine: &Machine) -> Result<Vec<(String, Figure)>, Failure> {
    let peers = peers::all()?;
    let figure = |(study, rows): (&Study, &Vec<Row>)| {
        let same = peers.iter().filter(|peer| peer.case == study.case);
        let others: Vec<_> = same.map(|peer| (peer.code.as_str(), peer.error, peer.time_s)).collect();
        let figure = report_figures::accuracy(study, rows, &others, machine);
        (format!("accuracy.{}", study.case), figure)
    };
    Ok(studies.iter().zip(rows).map(figure).collect())
}

/// Every range of values against its exact answer or law, and the usual way beside.
fn stability(console: &Console) -> Result<(Findings, Failed), Failure> {
    let extreme = |case: &Case| matches!(case.question, Question::Over(_));
    let mut all: Vec<Case> = cases::all().into_iter().filter(extreme).collect();
    all.push(cases::USUAL);
    let progress = Progress::of("report stability", console);
    let rows = verdicts(&all, &|share| progress.done(share));
    drop(progress);
    let machine = Machine::here();
    let passed = rows.iter().all(Row::passed);
    let json = text(&json!({ "passed": passed, "rows": reports::objects(STABILITY, &rows), "machine": machine }))?;
    let files = vec![("stability.csv".to_owned(), reports::csv(STABILITY, &rows).map_err(Failure::failed)?)];
    let report = Findings {
        table: reports::stability_table(&rows, &machine),
        json,
        files: Files {
            texts: files,
            #[cfg(feature = "plot")]
            figures: Vec::new(),
        },
    };
    Ok((report.named("stability"), beyond(&rows)))
}

/// The verdicts on cases in their order, found on all threads; `done` is told the share that is behind.
#[expect(clippy::cast_precision_loss, reason = "few cases")]
pub(super) fn verdicts(cases: &[Case], done: &(dyn Fn(f64) + Sync)) -> Vec<Row> {
    let behind = AtomicUsize::new(0);
    let verdict = |case: &Case| {
        let row = case.verdict();
        done((behind.fetch_add(1, Ordering::Relaxed) + 1) as f64 / cases.len() as f64);
        row
    };
    cases.par_iter().map(verdict).collect()
}

/// Every kernel at several sizes.
fn throughput(effort: Thoroughness, console: &Console) -> Result<(Findings, Failed), Failure> {
    let progress = Progress::of("report speed", console);
    let rows = speed::rows(&speed::kernels(), 5 * effort.budget(), |share| progress.done(share));
    drop(progress);
    let machine = Machine::here();
    let json = text(&json!({ "rows": reports::objects(SPEED, &rows), "machine": machine }))?;
    let files = vec![("speed.csv".to_owned(), reports::csv(SPEED, &rows).map_err(Failure::failed)?)];
    let report = Findings {
        table: reports::speed_table(&rows, &machine),
        json,
        files: Files {
            texts: files,
            #[cfg(feature = "plot")]
            figures: vec![("speed".to_owned(), report_figures::speed(&rows, &machine))],
        },
    };
    Ok((report.named("speed"), silent(&rows)))
}

/// Methods that gave no answer.
fn silent(rows: &[Row]) -> Failed {
    let why = |row: &Row| row.why.as_ref().map(|why| format!("{} {}: no answer: {why}", row.case, row.method));
    rows.iter().filter_map(why).collect()
}

/// Cases beyond their bounds.
pub(super) fn beyond(rows: &[Row]) -> Failed {
    let failed = rows.iter().filter(|row| !row.passed());
    let why = |row: &Row| row.why.clone().unwrap_or_else(|| "beyond its bound".to_owned());
    failed.map(|row| format!("{}: {}", row.case, why(row))).collect()
}

fn text(value: &serde_json::Value) -> Result<String, Failure> {
    serde_json::to_string_pretty(value).map_err(Failure::failed)
}
