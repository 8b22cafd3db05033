//! One scene by the direct path, by springs and by the full half-space: error against run time.

#[cfg(feature = "half-space")]
mod full;
mod methods;
mod plane;
mod reference;
mod rough;
#[cfg(feature = "half-space")]
mod rough_full;

use crate::run::record::Record;
use crate::run::{self, SimulationError, Wanted};
use crate::scene::plan::Plan;
use crate::scene::plan::SceneSettings;
use serde::Serialize;
use std::time::Instant;

/// Numbers of springs of the classical bed.
const SPRINGS: [usize; 6] = [32, 128, 512, 2048, 8192, 32768];
/// Pixels on the side of the half-space grid.
#[cfg(feature = "half-space")]
const GRIDS: [usize; 6] = [32, 64, 128, 256, 512, 1024];
#[cfg(not(feature = "half-space"))]
const GRIDS: [usize; 0] = [];
/// What is said where the solver is left out.
const NO_HALF_SPACE: &str = "the program was built without the half-space solver";
/// Repeats end after this time [s]: what is slower is measured once.
const ENOUGH: f64 = 0.05;
/// Most repeats of a quick computation; the least time counts.
const REPEATS: usize = 20;

/// A way to compute a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Method {
    /// Edge and force as a root and an integral of g(x).
    Direct,
    /// The classical bed.
    Springs,
    /// The full three-dimensional half-space.
    HalfSpace,
    /// The half-plane in strips.
    HalfPlane,
}

impl Method {
    /// Name in tables and figures.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Direct => "direct",
            Self::Springs => "springs",
            Self::HalfSpace => "half-space",
            Self::HalfPlane => "half-plane",
        }
    }
}

/// The state that all methods compute.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct State {
    /// Indentation [m].
    pub indentation_m: f64,
    /// Normal force [N].
    pub force_n: f64,
    /// Contact radius [m]; of a contact that is not a circle, of the circle of the same area; `None` of rough shapes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub contact_radius_m: Option<f64>,
    /// Largest pressure [Pa]; `None` where it is singular.
    pub peak_pressure_pa: Option<f64>,
    /// Stiffness [N/m], of rough shapes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stiffness_n_per_m: Option<f64>,
    /// Real over nominal contact area, of the half-space under rough shapes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub area_fraction: Option<f64>,
}

/// One method at one fineness. Errors are relative to the reference; `None` where there is nothing to compare, and in
/// the row that is the reference itself.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Row {
    /// Method.
    pub method: Method,
    /// Springs of the bed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub springs: Option<usize>,
    /// Pixels on the side of the grid.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub grid: Option<usize>,
    /// Relative error of the force.
    pub force_error: Option<f64>,
    /// Relative error of the contact radius.
    pub radius_error: Option<f64>,
    /// Relative error of the largest pressure.
    pub pressure_error: Option<f64>,
    /// Relative error of the indentation under the force, of rough shapes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub indentation_error: Option<f64>,
    /// Relative error of the stiffness, of rough shapes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stiffness_error: Option<f64>,
    /// Time from the shape to the answer [s], the least of several runs.
    pub time_s: f64,
    /// Bytes of state.
    pub bytes: u64,
    /// Iterations of the half-space solver on its finest grid.
    pub iterations: Option<usize>,
    /// What the method found.
    #[serde(skip)]
    pub state: State,
}

/// A scene compared.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Comparison {
    /// What the errors are relative to.
    pub reference: String,
    /// The state compared, of the largest force in the scene, as the reference has it.
    pub state: State,
    /// One row per method and fineness.
    pub rows: Vec<Row>,
    /// What is left out and why.
    pub notes: Vec<String>,
}

/// Why a scene cannot be compared.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ComparisonError {
    /// The scene cannot be run.
    #[error(transparent)]
    Simulation(#[from] SimulationError),
    /// The bodies never press on each other.
    #[error("there is nothing to compare: the bodies never press on each other in this scene")]
    NoContact,
}

/// What a method gave.
#[derive(Debug, Clone, Copy)]
struct Measured {
    state: State,
    time: f64,
    bytes: u64,
    iterations: Option<usize>,
}

/// Computes a scene by all methods; `done` is told the share of the work that is behind.
///
/// An elastic contact is compared in the state of its largest force: at its indentation the methods start from the shape. What
/// depends on the past is run from the beginning, by the direct path and by springs.
///
/// # Errors
/// The scene cannot be run, or the bodies never press on each other.
pub fn compare(setup: &Plan, done: &dyn Fn(f64)) -> Result<Comparison, ComparisonError> {
    if setup.scene.shape.is_plane() {
        return plane::compare(setup, done);
    }
    let setup = setup.with(SceneSettings { springs: None, ..setup.settings() }).map_err(SimulationError::from)?;
    let outcome = run::run(&setup, Wanted::NOTHING)?;
    let most = outcome.records.iter().max_by(|a, b| a.normal.force.total_cmp(&b.normal.force));
    let most = most.filter(|record| record.normal.force > 0.0).ok_or(ComparisonError::NoContact)?;
    if let Some(surface) = setup.surface() {
        let force = most.normal.force;
        return Ok(rough::compare(&rough::Rough { setup: &setup, surface, force }, done));
    }
    let scenario = methods::Scenario::of(&setup, most);
    let mut notes = notes(&setup, &scenario);
    let mut rows = Vec::new();
    let work: f64 = SPRINGS.iter().map(|&n| cost(Some(n), None)).chain(GRIDS.map(|n| cost(None, Some(n)))).sum();
    let mut behind = 0.0;
    for (method, springs, grid) in fineness() {
        match scenario.measured((method, springs, grid)) {
            Some(Ok(measured)) => rows.push(row((method, springs, grid), &measured)),
            Some(Err(note)) => notes.push(note),
            None => {}
        }
        behind += cost(springs, grid);
        done(behind / work);
    }
    let (reference, state) = reference::of(&scenario, &mut rows);
    Ok(Comparison { reference, state, rows, notes })
}

type Fineness = (Method, Option<usize>, Option<usize>);

fn fineness() -> impl Iterator<Item = Fineness> {
    let springs = SPRINGS.into_iter().map(|n| (Method::Springs, Some(n), None));
    let grids = GRIDS.into_iter().map(|n| (Method::HalfSpace, None, Some(n)));
    std::iter::once((Method::Direct, None, None)).chain(springs).chain(grids)
}

/// Rough work of a row, in pixels.
fn cost(springs: Option<usize>, grid: Option<usize>) -> f64 {
    springs.unwrap_or(0) as f64 + grid.map_or(0.0, |n| (n * n) as f64)
}

fn row((method, springs, grid): Fineness, measured: &Measured) -> Row {
    Row {
        method,
        springs,
        grid,
        force_error: None,
        radius_error: None,
        pressure_error: None,
        indentation_error: None,
        stiffness_error: None,
        time_s: measured.time,
        bytes: measured.bytes,
        iterations: measured.iterations,
        state: measured.state,
    }
}

/// What the half-space leaves out of the scene.
fn notes(setup: &Plan, scenario: &methods::Scenario<'_>) -> Vec<String> {
    let mut notes = Vec::new();
    let mut left_out = |what: &str| {
        notes.push(format!(
            "{what}: the half-space solver computes the frictionless elastic contact only and is left out"
        ));
    };
    if setup.scene.adhesion.is_some() {
        left_out("adhesion");
    }
    if setup.relaxation().is_some() {
        left_out("viscoelastic bodies");
    }
    if setup.scene.friction.is_some() {
        notes.push("friction: compared is the normal contact, which friction does not change here".to_owned());
    }
    if !cfg!(feature = "half-space") {
        notes.push(NO_HALF_SPACE.to_owned());
    }
    notes.extend(scenario.note());
    notes
}

/// The answer of a computation and its least time [s] over repeats.
fn timed<T>(mut work: impl FnMut() -> T) -> (T, f64) {
    let (mut least, mut total, mut count) = (f64::INFINITY, 0.0, 0);
    loop {
        let clock = Instant::now();
        let answer = work();
        let time = clock.elapsed().as_secs_f64();
        least = least.min(time);
        total += time;
        count += 1;
        if total > ENOUGH || count == REPEATS {
            return (answer, least);
        }
    }
}

/// The state of a record; the largest pressure is not in it.
fn state_of(record: &Record) -> State {
    State {
        indentation_m: record.normal.indentation.unwrap_or(f64::NAN),
        force_n: record.normal.force,
        contact_radius_m: record.normal.contact_radius,
        ..State::default()
    }
}
