//! A scene led through the rows of a measured curve by a run of its own.

use super::FitError;
use super::adhesive::Jump;
use super::curve::Curve;
use super::drive::{DRIVE, Prescribed};
use crate::contact::adhesion::equilibrium::Control;
use crate::input::problem::Problem;
use crate::input::quantity::Speed;
use crate::input::table::Tables;
use crate::run::record::{Outcome, Record};
use crate::run::{Wanted, run};
use crate::scene::Scene;
use crate::scene::fit::{Baseline, Drive};
use crate::scene::history::{Entry, Impact};
use crate::scene::plan::Plan;
use crate::scene::stage::{Path, Stage};

/// What drives a scene: what is asked for, or else what its history says.
///
/// # Errors
/// It cannot be driven so.
pub fn led_by(scene: &Scene, asked: Option<Drive>) -> Result<Drive, FitError> {
    let strikes = matches!(scene.history.first(), Some(Entry::Impact(_)));
    let slides = matches!(scene.history.last(), Some(Entry::Slide(_) | Entry::Shake(_)));
    let by_scene = match scene.history.first() {
        _ if strikes => Drive::Speed,
        _ if slides => Drive::Slide,
        Some(Entry::Press(_) | Entry::HoldForce(_)) => Drive::Force,
        _ => Drive::Depth,
    };
    let led = asked.unwrap_or(by_scene);
    if strikes == (led == Drive::Speed) {
        return Ok(led);
    }
    Err(FitError::Scene(if strikes { OF_IMPACTS } else { OF_SPEEDS }.to_owned()))
}

/// The line under what answers to `led`: a restitution has none.
///
/// # Errors
/// Another one is asked for.
pub fn baseline(asked: Baseline, led: Drive) -> Result<Baseline, FitError> {
    match (led, asked) {
        (Drive::Speed, Baseline::Absent | Baseline::Constant) => Ok(Baseline::Absent),
        (Drive::Speed, Baseline::Linear | Baseline::Virtual) => {
            Err(FitError::Free("a restitution has no baseline: expected baseline: Absent".to_owned()))
        }
        (Drive::Depth | Drive::Force | Drive::Slide, _) => Ok(asked),
    }
}

const OF_IMPACTS: &str =
    "an impact has no curve of depths and forces: expected drive: Speed, and speeds with restitutions";
const OF_SPEEDS: &str = "speeds drive an impact: expected history: [Impact(…)]";

/// A curve and the tables of the scene.
pub type Data<'d> = (&'d Curve, &'d dyn Tables);

/// What the scene of a plan answers to each row of the data, and where it jumps; first touch at `contact` of what drives.
///
/// # Errors
/// The scene cannot be led so.
pub fn answered(plan: &Plan, data: Data<'_>, (led, contact): (Drive, f64)) -> Result<(Vec<f64>, Vec<Jump>), String> {
    let (curve, _) = data;
    let from_touch = || curve.driven(led).iter().map(|value| value - contact).collect();
    match led {
        Drive::Depth => followed(plan, data, vec![("indentation_m", from_touch())], |record| Ok(record.normal.force)),
        Drive::Force => {
            let depth = |record: &Record| record.normal.indentation.ok_or_else(parted);
            followed(plan, data, vec![("force_n", from_touch())], depth)
        }
        Drive::Speed => Ok((struck(plan, data)?, Vec::new())),
        Drive::Slide => Ok((slid(plan, data)?, Vec::new())),
    }
}

/// The answers of a scene whose history is the columns alone, and where adhesive bodies snap together or part on the way.
fn followed(
    plan: &Plan,
    data: Data<'_>,
    columns: Vec<(&'static str, Vec<f64>)>,
    answer: impl Fn(&Record) -> Result<f64, String>,
) -> Result<(Vec<f64>, Vec<Jump>), String> {
    let outcome = through((plan, &[]), data, columns)?;
    let records = rows(&outcome, data.0)?;
    let response = records.iter().map(answer).collect::<Result<Vec<f64>, String>>()?;
    let jumps = if plan.adheres() { jumps(records, &response) } else { Vec::new() };
    Ok((response, jumps))
}

/// A run through the entries `before` and then through a table of the columns.
fn through(
    (plan, before): (&Plan, &[Entry]),
    data: Data<'_>,
    columns: Vec<(&'static str, Vec<f64>)>,
) -> Result<Outcome, String> {
    let drive = Prescribed::of(data, columns, plan.scene.relaxes())?;
    let history = before.iter().cloned().chain([Entry::Table(DRIVE.into())]).collect();
    ran(Scene { history, ..plan.scene.clone() }, &drive)
}

fn ran(scene: Scene, tables: &dyn Tables) -> Result<Outcome, String> {
    let plan = scene.resolve(tables).map_err(|problems| told(&problems))?;
    run(&plan, Wanted { instants: false, ..Wanted::NOTHING }).map_err(|error| error.to_string())
}

/// The records of the rows: one each, behind all that came before.
fn rows<'o>(outcome: &'o Outcome, curve: &Curve) -> Result<&'o [Record], String> {
    let before = outcome.records.len().checked_sub(curve.len()).ok_or("the run left out a row")?;
    Ok(&outcome.records[before..])
}

/// Restitution at each of the measured speeds.
fn struck(plan: &Plan, (curve, tables): Data<'_>) -> Result<Vec<f64>, String> {
    let Some(Entry::Impact(impact)) = plan.scene.history.first() else {
        return Err("speeds drive an impact: expected history: [Impact(…)]".to_owned());
    };
    let speed = curve.driven(Drive::Speed).iter().map(|&speed| Speed::new(speed)).collect::<Result<_, _>>();
    let impact = Impact { speed: speed.map_err(|error| error.to_string())?, ..impact.clone() };
    let outcome = ran(Scene { history: vec![Entry::Impact(impact)], ..plan.scene.clone() }, tables)?;
    let column = outcome.table("impacts").and_then(|table| table.column("restitution"));
    let answers: Option<Vec<f64>> = column.and_then(|column| column.numbers().iter().copied().collect());
    answers.ok_or_else(|| "the impacts have no restitution".to_owned())
}

/// Tangential force at each of the measured slides, from where the entries before the last one of the history end.
fn slid(plan: &Plan, data: Data<'_>) -> Result<Vec<f64>, String> {
    let before = plan.scene.history.split_last().map_or(&[][..], |(_, before)| before);
    let stages = plan.stages.iter().take_while(|stage| stage.entry < before.len());
    let start = stages.fold(Start::default(), Start::after);
    let (name, held) = match start.held {
        Some((Control::Indentation, depth)) => ("indentation_m", depth),
        Some((Control::Force, force)) => ("force_n", force),
        None => return Err(UNPRESSED.to_owned()),
    };
    let slides = data.0.driven(Drive::Slide);
    let zero = slides.first().copied().unwrap_or(0.0) - start.slide;
    let columns =
        vec![(name, vec![held; slides.len()]), ("slide_m", slides.iter().map(|slide| slide - zero).collect())];
    let outcome = through((plan, before), data, columns)?;
    let force = |record: &Record| record.tangential_force().ok_or("the bodies do not rub: expected friction");
    Ok(rows(&outcome, data.0)?.iter().map(force).collect::<Result<_, _>>()?)
}

const UNPRESSED: &str =
    "slides drive bodies that are pressed: expected Indent or Press, of which the last is kept, before the last entry";

/// Where slides begin.
#[derive(Debug, Clone, Copy, Default)]
struct Start {
    /// What is kept, and at which value, if that is known.
    held: Option<(Control, f64)>,
    /// Tangential displacement [m].
    slide: f64,
}

impl Start {
    fn after(self, stage: &Stage) -> Self {
        let held = match (stage.control, stage.normal) {
            (None, _) => self.held,
            (Some(control), Path::To(value)) => Some((control, value)),
            (Some(control), path) => {
                let same = self.held.filter(|(before, _)| *before == control);
                same.map(|(_, value)| (control, path.at(value, 1.0, stage.over)))
            }
        };
        Self { held, slide: stage.tangential.at(self.slide, 1.0, stage.over) }
    }
}

/// Where adhesive bodies have snapped together or parted since the record before.
fn jumps(records: &[Record], response: &[f64]) -> Vec<Jump> {
    let joined = |record: &Record| record.normal.contact_radius.is_some_and(|radius| radius > 0.0);
    let before = std::iter::once(false).chain(records.iter().map(joined));
    let rows = before.zip(records.iter().map(joined)).enumerate();
    // Before the first row nothing has touched.
    let height = |row: usize| (response[row] - row.checked_sub(1).map_or(0.0, |before| response[before])).abs();
    let jump = |(row, _)| Jump { row, height: height(row), at: None };
    rows.filter(|(_, (before, here))| before != here).map(jump).collect()
}

fn parted() -> String {
    "the force parts the bodies: expected drive: Depth for a curve on which they pull at each other".to_owned()
}

/// Problems in one line.
pub fn told(problems: &[Problem]) -> String {
    problems.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
}
