//! One scene by the direct path, by springs and by the full half-space: error against run time.
//!
//! # Examples
//! ```no_run
//! # #[cfg(feature = "text")] {
//! use springbed::prelude::*;
//! use springbed::check::comparison::compare;
//!
//! let text = r#"(shape: Paraboloid(radius: 1), bodies: (Elastic(young: 1, poisson: 0), Rigid),
//!     history: [Indent(to: 1, over: 1)])"#;
//! let plan = Notation::Ron.plan(text, &InMemory::default()).map_err(|errors| errors[0].clone())?;
//! // By the closed form, by springs and by the half-space: a minute.
//! let comparison = compare(&plan, &|_| ())?;
//! assert!(comparison.reference.contains("closed form"));
//! assert!(comparison.rows.iter().all(|row| row.errors.force.is_none_or(|error| error.abs() < 0.1)));
//! # }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#[cfg(feature = "half-space")]
mod alone;
mod closed;
#[cfg(feature = "half-space")]
mod pixels;
mod plane;
mod rough;
mod round;

use super::one_piece::largest_force;
use super::row::{Errors, Found, Row};
use super::study::{Method, Thoroughness, measured};
use super::theory;
use crate::input::problem::Problem;
use crate::run::record::Record;
use crate::run::{self, SimulationError, Wanted};
use crate::scene::law::ElasticAdhesion;
use crate::scene::plan::{HalfSpacePlan, Plan, SceneSettings};
use crate::shape::Boundary;

/// Pixels on the side of the half-space grid.
#[cfg(feature = "half-space")]
const GRIDS: [usize; 6] = [32, 64, 128, 256, 512, 1024];
/// The same of contacts with a past, whose whole history is followed.
const PAST_GRIDS: [usize; 3] = [32, 64, 128];
/// What is said where the solver is left out.
const WITHOUT: Option<&str> = match cfg!(feature = "half-space") {
    true => None,
    false => Some("the program was built without the half-space solver"),
};

/// What the methods have in common, and what is compared of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Compared {
    /// A round contact at an indentation: force, radius, pressure.
    Round,
    /// A plane contact under a force: indentation, half width, pressure.
    Plane,
    /// A rough contact under a force: indentation, stiffness, pressure.
    Rough,
}

/// A scene compared.
#[derive(Debug, Clone)]
pub struct Comparison {
    /// What is compared.
    pub compared: Compared,
    /// What the errors are relative to.
    pub reference: String,
    /// The state compared, of the largest force in the scene, as the reference has it.
    pub state: Found,
    /// One row per method and fineness; without errors the row that is the reference itself.
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

/// Computes a scene by all methods; `done` is told the share of the work that is behind.
///
/// An elastic contact is compared in the state of its largest force: at its indentation the methods start from the shape. What
/// depends on the past is run from the beginning, by the direct path and by springs.
///
/// # Errors
/// The scene cannot be run, or the bodies never press on each other.
pub fn compare(plan: &Plan, done: &dyn Fn(f64)) -> Result<Comparison, ComparisonError> {
    let bed = plan.with(SceneSettings { springs: None, solver: None, ..plan.settings() });
    match (plan, bed) {
        (Plan::HalfSpace(pixels), Err(problems)) => on_pixels_alone(plan, pixels, &problems, done),
        (Plan::HalfSpace(pixels), Ok(bed)) => compare_with(&bed, pixels.boundary, done),
        (_, bed) => compare_with(&bed.map_err(SimulationError::from)?, Boundary::Free, done),
    }
}

/// A contact that no bed follows.
#[cfg(feature = "half-space")]
fn on_pixels_alone(
    plan: &Plan,
    pixels: &HalfSpacePlan,
    problems: &[Problem],
    done: &dyn Fn(f64),
) -> Result<Comparison, ComparisonError> {
    let outcome = run::run(plan, Wanted::NOTHING)?;
    let force = largest(&outcome.records).map_or(0.0, |record| record.normal.force);
    let why = problems.first().map_or_else(String::new, |problem| problem.message.clone());
    if force > 0.0 { Ok(alone::contest(pixels, force, &why).judged(done)) } else { Err(ComparisonError::NoContact) }
}

/// Without the solver there is no such scene.
#[cfg(not(feature = "half-space"))]
fn on_pixels_alone(
    _: &Plan,
    _: &HalfSpacePlan,
    problems: &[Problem],
    _: &dyn Fn(f64),
) -> Result<Comparison, ComparisonError> {
    Err(SimulationError::from(problems.to_vec()).into())
}

/// The same of a scene on springs; at the edge of a rough surface the half-space does what `boundary` says.
fn compare_with(plan: &Plan, boundary: Boundary, done: &dyn Fn(f64)) -> Result<Comparison, ComparisonError> {
    let outcome = run::run(plan, Wanted::NOTHING)?;
    if plan.scene.shape.is_plane() && follows_from_force(plan) {
        let force = largest_force(plan, &outcome);
        return if force > 0.0 {
            Ok(plane::contest(plan, force)?.judged(done))
        } else {
            Err(ComparisonError::NoContact)
        };
    }
    let most =
        largest(&outcome.records).filter(|record| record.normal.force > 0.0).ok_or(ComparisonError::NoContact)?;
    let Some(rough) = plan.rough() else { return Ok(round::contest(plan.clone(), most).judged(done)) };
    let force = most.normal.force;
    let mut comparison = rough::contest(rough.clone(), force, boundary).judged(done);
    let stiffness = comparison.state.stiffness_n_per_m.unwrap_or(0.0);
    comparison.notes.extend(theory::of_roughness(plan, force, stiffness));
    Ok(comparison)
}

/// Whether the state of a section under a force is that of the plain elastic contact.
fn follows_from_force(plan: &Plan) -> bool {
    matches!(plan, Plan::Plane(_)) || matches!(plan.direct(), Some(ElasticAdhesion::None))
}

/// The record of the largest force.
fn largest(records: &[Record]) -> Option<&Record> {
    records.iter().max_by(|a, b| a.normal.force.total_cmp(&b.normal.force))
}

/// The state of a record; the largest pressure is not in it.
fn found(record: &Record) -> Found {
    let normal = &record.normal;
    let (indentation_m, contact_radius_m) = (normal.indentation, normal.contact_radius);
    Found { indentation_m, force_n: Some(normal.force), contact_radius_m, ..Found::default() }
}

/// A right answer and its name.
struct Known {
    name: String,
    state: Found,
}

/// A method that may be taken for right: its number, and what it is then called.
struct Candidate {
    at: usize,
    name: String,
}

/// Methods to be measured against each other.
struct Contest {
    compared: Compared,
    methods: Vec<Method>,
    /// The closed form, where there is one.
    exact: Option<Known>,
    /// Who is right where there is none: the first of these that gives an answer.
    candidates: Vec<Candidate>,
    /// Who has the largest pressure where a closed form does not.
    pressure: Option<Candidate>,
    /// Members that a run computes one after the other; times are those of one.
    members: usize,
    notes: Vec<String>,
}

impl Contest {
    fn judged(mut self, done: &dyn Fn(f64)) -> Comparison {
        let mut rows = measured(&self.methods, Thoroughness::Brief.budget(), &mut |share| done(share));
        let (mut right, own) = self.right(&rows);
        let mut own_pressure = own;
        if let (None, None, Some(candidate)) = (own, right.state.peak_pressure_pa, self.pressure.take())
            && let Some(pressure) = rows[candidate.at].solved.found.peak_pressure_pa
        {
            right.state.peak_pressure_pa = Some(pressure);
            right.name.push_str(&format!("; largest pressure: {}", candidate.name));
            own_pressure = Some(candidate.at);
        }
        rows.iter_mut().filter_map(|row| row.times.as_mut()).for_each(|times| times.warm /= self.members as f64);
        for (at, row) in rows.iter_mut().enumerate().filter(|(at, _)| own != Some(*at)) {
            row.errors = self.compared.errors(&row.solved.found, &right.state);
            row.errors.pressure = row.errors.pressure.filter(|_| own_pressure != Some(at));
        }
        self.notes.extend(rows.iter().filter_map(failure));
        rows.retain(|row| row.why.is_none());
        let Self { compared, notes, .. } = self;
        Comparison { compared, reference: right.name, state: right.state, rows, notes }
    }

    /// What is right, and the number of the method if it is one.
    fn right(&mut self, rows: &[Row]) -> (Known, Option<usize>) {
        if let Some(exact) = self.exact.take() {
            return (exact, None);
        }
        let answered = |candidate: &&Candidate| rows[candidate.at].why.is_none();
        match self.candidates.iter().find(answered) {
            Some(Candidate { at, name }) => (Known { name: name.clone(), state: rows[*at].solved.found }, Some(*at)),
            None => (Known { name: "none".to_owned(), state: Found::default() }, None),
        }
    }
}

impl Compared {
    /// The errors of what is not prescribed.
    fn errors(self, found: &Found, right: &Found) -> Errors {
        let errors = Errors::of(found, right);
        match self {
            Self::Round => Errors { indentation: None, ..errors },
            Self::Plane | Self::Rough => Errors { force: None, ..errors },
        }
    }
}

/// Why a method gave nothing.
fn failure(row: &Row) -> Option<String> {
    let why = row.why.as_ref()?;
    Some(match (row.setting.springs, row.setting.grid) {
        (Some(springs), _) => format!("{springs} springs: {why}"),
        (_, Some(grid)) => format!("{} on {grid} pixels a side: {why}", row.method),
        _ => why.clone(),
    })
}
