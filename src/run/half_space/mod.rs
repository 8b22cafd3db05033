//! Scenes on the pixels of a half-space.
//!
//! # Examples
//! ```
//! # #[cfg(feature = "text")] {
//! use springbed::prelude::*;
//!
//! // A ball on 64² pixels: Hertz to some (Δ/a)²/8.
//! let text = r#"(shape: Paraboloid(radius: 1), bodies: (Elastic(young: 1, poisson: 0), Rigid),
//!     solver: HalfSpace(grid: 64), steps: 1, history: [Indent(to: 0.01, over: 1)])"#;
//! let plan = Notation::Ron.plan(text, &InMemory::default()).map_err(|errors| errors[0].clone())?;
//! let force = run(&plan, Wanted::NOTHING)?.records.last().ok_or("a record")?.normal.force;
//! assert!((force / (4e-3 / 3.0) - 1.0).abs() < 2e-3);
//! # }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod attraction;
mod coupled;
mod dent;
mod distribution;
mod heights;
mod ledger;
mod load;
mod lone;
mod memory;
mod mixed;
mod pixels;
mod pressed;
mod rehearsed;
mod rounds;
mod rubbing;
mod series;
mod state;
mod steady;
mod told;
mod way;
mod window;
mod within;

pub use heights::{Heights, ellipsoid, material};
pub use state::radius_of;

use super::named::Named;
use super::record::{ContactMap, Outcome, PixelContact};
use super::unit::Unit;
use super::{SimulationError, Wanted};
use crate::contact::state::Normal;
use crate::halfspace::{HalfSpaceError, Prescribed, Settings, Start, SurfaceResponse};
use crate::scene::parts::Parts;
use crate::scene::plan::HalfSpacePlan;
use pressed::Pressed;
use rehearsed::Rehearsed;
use rubbing::Rubbed;
use series::{Depth, Series};
use state::{Pressing, State};
use steady::Glides;

/// Part of the accuracy asked for that the solver may miss.
const SHARE: f64 = 0.01;

fn settings(plan: &HalfSpacePlan) -> Settings {
    Settings { tolerance: (SHARE * plan.accuracy()).clamp(1e-12, 1e-4), ..Settings::default() }
}

/// Leads a contact on pixels through its history; `done` is told the share behind.
///
/// # Errors
/// The grid does not carry the roughness, or is too large; a depth beyond full contact.
pub(super) fn run(
    plan: &HalfSpacePlan,
    wanted: Wanted,
    done: &(dyn Fn(f64) + Sync),
) -> Result<Outcome, SimulationError> {
    // From within its threads none of the many short loops of a state need wake them.
    rayon::scope(|_| led(plan, wanted, done))
}

fn led(plan: &HalfSpacePlan, wanted: Wanted, done: &(dyn Fn(f64) + Sync)) -> Result<Outcome, SimulationError> {
    let heights = heights(plan)?;
    let response = response(plan, &heights)?;
    let pressing = Pressing::of(plan, &heights, &response);
    let pressing = Pressing { tangential: rubbing::tangential_modulus(plan, &pressing), ..pressing };
    let rehearsed = Rehearsed::of(plan, &pressing);
    let depth = Depth::Whole { told: wanted.instants, energy: rehearsed.energy() };
    let mut series = Series::new(plan, pressing, depth, rehearsed.steps);
    let records = series.follow(done)?;
    let glides = steady::steady(plan, &pressing, &records)?;
    let map = if wanted.fields { map(&pressing, &series, &glides)? } else { None };
    let estimate = rehearsed.estimate(plan, &records, &series);
    let mut results = told::results(plan, &records, &series, &glides);
    results.extend(rehearsed.of_time().map(|of| Named::number("error_of_steps", Unit::ONE, of)));
    Ok(Outcome {
        results,
        fields: Vec::new(),
        tables: distribution::table(&series.distributions).into_iter().chain(glides.table(plan)).collect(),
        error_estimate: glides.at_least(estimate),
        warnings: told::warnings(plan, &heights, (&series, &glides)),
        plan: parts(plan, &heights, &series),
        records,
        map,
    })
}

/// The map of the last speed of what glides, of the largest force along the surface, or of the largest force.
fn map(pressing: &Pressing<'_>, series: &Series<'_>, glides: &Glides) -> Result<Option<ContactMap>, SimulationError> {
    let gliding = glides.last.as_ref().map(|last| (last.pressure.clone(), pressing.gap(last), None, last.force()));
    let rubbed = series.rubbed().map_err(|error| SimulationError::Refused(error.to_string()))?;
    let rubbed = rubbed.map(|Rubbed { contact, shear }| {
        let (gap, force) = (pressing.gap(&contact), contact.force());
        (contact.pressure, gap, Some(shear), force)
    });
    let resting = || {
        let (_, pressed) = series.largest.as_ref()?;
        Some((pressed.pressure(), pressed.gap.clone(), None, pressed.force()))
    };
    let (pixel, boundary) = (pressing.heights.pixel, pressing.boundary);
    let of = |(pressure, gap, shear, force)| ContactMap { pressure, gap, shear, pixel, boundary, force };
    Ok(gliding.or(rubbed).or_else(resting).map(of))
}

/// One state of a contact on pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solved {
    /// The normal contact.
    pub normal: Normal,
    /// The real contact.
    pub pixels: PixelContact,
    /// Upper bound of the bytes used.
    pub bytes: u64,
    /// Iterations of the solver.
    pub iterations: usize,
}

/// The state under a force [N].
///
/// # Errors
/// As for a run.
pub fn under(plan: &HalfSpacePlan, force: f64) -> Result<Solved, SimulationError> {
    let heights = heights(plan)?;
    let refused = |error: HalfSpaceError| SimulationError::Refused(error.to_string());
    let response = response(plan, &heights)?;
    let pressing = Pressing::of(plan, &heights, &response);
    let solution = pressing.solve(Prescribed::Force(force), Start::Coarser).map_err(refused)?;
    let (bytes, iterations) = (solution.bytes, solution.iterations);
    let stiffness = pressing.stiffness(&solution, &mut None).map_err(refused)?;
    let gap = pressing.gap(&solution);
    let State { normal, pixels, .. } = pressing.told(&Pressed::elastic(solution, gap), stiffness);
    Ok(Solved { normal, pixels, bytes, iterations })
}

/// The heights of a plan: those of its surface, or of its tip in a window wide enough.
fn heights(plan: &HalfSpacePlan) -> Result<Heights, SimulationError> {
    let refused = |error: crate::shape::rough::RoughError| SimulationError::Refused(format!("solver.grid: {error}"));
    if let Some(surface) = heights::of_surface(plan).map_err(refused)? {
        return Ok(surface);
    }
    let window = window::of_history(plan)?;
    heights::of_tip(&plan.indenter, plan.size, window)
        .ok_or_else(|| SimulationError::Refused("shape: has no heights".to_owned()))
}

/// What pressures do to pixels that fit into memory.
fn response(plan: &HalfSpacePlan, heights: &Heights) -> Result<SurfaceResponse, SimulationError> {
    state::response(plan, heights).map_err(|error| SimulationError::Refused(format!("solver.grid: {error}")))
}

/// The plan in words, with the window found.
fn parts(plan: &HalfSpacePlan, heights: &Heights, series: &Series<'_>) -> Parts {
    let [x, y] = heights.sides();
    let parts = plan.parts();
    let bytes = series.largest.as_ref().map(|(_, pressed)| pressed.contact.bytes);
    let state_bytes = bytes.and_then(|bytes| usize::try_from(bytes).ok()).unwrap_or(parts.state_bytes);
    let state_bytes = state_bytes.saturating_add(series.bytes());
    Parts { reason: format!("{}; the window is {x:.4e} m × {y:.4e} m", parts.reason), state_bytes, ..parts }
}
