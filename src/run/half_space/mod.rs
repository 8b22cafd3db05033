//! Scenes on the pixels of a half-space.

mod attraction;
mod dent;
mod distribution;
mod error;
mod heights;
mod ledger;
mod memory;
mod mixed;
mod pixels;
mod pressed;
mod rehearsed;
mod series;
mod state;
mod steady;
mod told;
mod way;
mod window;

pub use heights::{Heights, ellipsoid, material};
pub use state::radius_of;

use super::record::{ContactMap, Outcome, PixelContact};
use super::{SimulationError, Wanted};
use crate::contact::state::Normal;
use crate::halfspace::{HalfSpaceError, Prescribed, Settings, Start};
use crate::scene::parts::Parts;
use crate::scene::plan::HalfSpacePlan;
use pressed::Pressed;
use rehearsed::Rehearsed;
use series::{Depth, Series};
use state::{Pressing, State};

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
    let response = state::response(plan, &heights);
    let pressing = Pressing::of(plan, &heights, response.as_ref());
    let rehearsed = Rehearsed::of(plan, &pressing);
    let mut series = Series::new(plan, pressing, Depth::Whole, rehearsed.as_ref().map_or(1, |coarse| coarse.steps));
    let records = series.follow(done)?;
    let glides = steady::steady(plan, &pressing, &records)?;
    let of =
        |(pressure, gap, force)| ContactMap { pressure, gap, pixel: heights.pixel, boundary: plan.boundary, force };
    let resting =
        || series.largest.as_ref().map(|(_, pressed)| (pressed.pressure(), pressed.gap.clone(), pressed.force()));
    let gliding = glides.last.as_ref().map(|last| (last.pressure.clone(), pressing.gap(last), last.force()));
    let map = wanted.fields.then(|| gliding.or_else(resting)).flatten().map(of);
    let estimate = match &rehearsed {
        Some(coarse) => coarse.estimate(&records, &heights),
        None => error::estimate(plan, &pressing, &series),
    };
    Ok(Outcome {
        results: told::results(plan, &records, &series, &glides),
        fields: Vec::new(),
        tables: distribution::table(&series.distributions).into_iter().chain(glides.table(plan)).collect(),
        error_estimate: glides.at_least(estimate),
        warnings: told::warnings(plan, &heights, (&series, &glides)),
        plan: parts(plan, &heights, &series),
        records,
        map,
    })
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
    let response = state::response(plan, &heights);
    let pressing = Pressing::of(plan, &heights, response.as_ref());
    let refused = |error: HalfSpaceError| SimulationError::Refused(error.to_string());
    let solution = pressing.solve(Prescribed::Force(force), Start::Coarser).map_err(refused)?;
    let (bytes, iterations) = (solution.bytes, solution.iterations);
    let stiffness = pressing.stiffness(&solution).map_err(refused)?;
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

/// The plan in words, with the window found.
fn parts(plan: &HalfSpacePlan, heights: &Heights, series: &Series<'_>) -> Parts {
    let [x, y] = heights.sides();
    let parts = plan.parts();
    let bytes = series.largest.as_ref().map(|(_, pressed)| pressed.contact.bytes);
    let state_bytes = bytes.and_then(|bytes| usize::try_from(bytes).ok()).unwrap_or(parts.state_bytes);
    let state_bytes = state_bytes.saturating_add(series.pixels().bytes());
    Parts { reason: format!("{}; the window is {x:.4e} m × {y:.4e} m", parts.reason), state_bytes, ..parts }
}
