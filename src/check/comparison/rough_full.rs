//! The rough surface itself on the full half-space.

use super::rough::{Rough, mean};
use super::{GRIDS, Measured, State, timed};
use crate::halfspace::{
    Boundary, HalfSpaceError, Prescribed, PressedMap, Settings, Solution, Start, bytes_needed, solve,
};
use crate::scene::surface::Source;
use crate::shape::rough::rough_surface;
use crate::shape::{Profile, Rim};
use ndarray::Array2;

/// Relative residual: far below the scatter of surfaces.
const TOLERANCE: f64 = 1e-6;
/// Most pixels of all members on one grid, unless a coarser one would not carry the roughness.
const MOST_PIXELS: usize = 1 << 20;
/// Coarsest map made from a larger one.
const COARSEST: usize = 24;

/// Pixels on the sides of the grids that carry the roughness; what is too large is told.
///
/// Of a height map, every pixel, every second, every fourth.
pub(super) fn grids(rough: &Rough<'_>) -> Result<Vec<usize>, String> {
    if let Source::Map(map) = &rough.surface.source {
        let (rows, columns) = map.heights().dim();
        refused([rows, columns])?;
        let side = rows.min(columns);
        let mut strides: Vec<usize> =
            [4, 2, 1].into_iter().filter(|stride| *stride == 1 || side / stride >= COARSEST).collect();
        strides.dedup();
        return Ok(strides.into_iter().map(|stride| rows.div_ceil(stride)).collect());
    }
    let least = 2 * (rough.surface.rings.variances().len() - 1);
    refused([least, least])?;
    let fine: Vec<usize> = GRIDS.into_iter().filter(|&grid| grid >= least.max(GRIDS[1])).collect();
    let largest = GRIDS[GRIDS.len() - 1];
    if fine.is_empty() {
        return Err(format!(
            "half-space: the shortest wave needs {least}² pixels ({:.1e} bytes); not tried above {largest}²",
            bytes_needed([least; 2], Boundary::Free) as f64
        ));
    }
    let affordable = |grid: usize| grid * grid * rough.seeds().len() <= MOST_PIXELS;
    let first = fine[0];
    Ok(fine.into_iter().filter(|&grid| grid == first || affordable(grid)).collect())
}

/// A grid that does not fit into the memory allowed.
fn refused(size: [usize; 2]) -> Result<(), String> {
    let (needed, limit) = (bytes_needed(size, Boundary::Free), Settings::default().memory_limit);
    let [rows, columns] = size;
    let refusal = HalfSpaceError::Memory { rows, columns, needed, limit };
    if needed > limit { Err(format!("half-space: {refusal}")) } else { Ok(()) }
}

/// The state on a grid, the mean over the members.
pub(super) fn measured(rough: &Rough<'_>, grid: usize) -> Result<Measured, String> {
    let failed = |error: String| format!("half-space on {grid} pixels a side: {error}");
    let (solved, time) = timed(|| rough.seeds().iter().map(|&seed| pressed(rough, (grid, seed))).collect());
    let solved: Result<Vec<(State, Solution)>, String> = solved;
    let solved = solved.map_err(failed)?;
    let states: Vec<State> = solved.iter().map(|(state, _)| *state).collect();
    let bytes = solved.iter().map(|(_, solution)| solution.bytes).max().unwrap_or(0);
    let iterations = solved.iter().map(|(_, solution)| solution.iterations).max();
    Ok(Measured { state: mean(&states), time: time / states.len() as f64, bytes, iterations })
}

fn pressed(rough: &Rough<'_>, (grid, seed): (usize, u64)) -> Result<(State, Solution), String> {
    let (heights, pixel) = heights(rough, (grid, seed))?;
    let touch = heights.iter().copied().fold(f64::INFINITY, f64::min);
    let settings = Settings { tolerance: TOLERANCE, ..Settings::default() };
    let at = |force: f64, start: Start<'_>| {
        let problem = PressedMap {
            heights: heights.view(),
            pixel,
            modulus: rough.setup.pair.normal,
            boundary: Boundary::Free,
            control: Prescribed::Force(force),
        };
        solve(&problem, start, &settings).map_err(|error| error.to_string())
    };
    let [below, here] = rough.forces();
    let here = at(here, Start::Coarser)?;
    let below = at(below, Start::Pressure(here.pressure.view()))?;
    let state = State {
        peak_pressure_pa: Some(here.peak_pressure()),
        area_fraction: Some(here.area_fraction()),
        ..rough.state([below.indentation, here.indentation], touch)
    };
    Ok((state, here))
}

/// Heights of the indenter [m], away from the half-space, and the pixel [m].
fn heights(rough: &Rough<'_>, (grid, seed): (usize, u64)) -> Result<(Array2<f64>, [f64; 2]), String> {
    let spectrum = match &rough.surface.source {
        Source::Spectrum(spectrum) => spectrum,
        Source::Map(map) => {
            let stride = map.heights().nrows().div_ceil(grid);
            let every = map.heights().slice(ndarray::s![..;stride, ..;stride]);
            let pixel = [map.pixel().0 * stride as f64, map.pixel().1 * stride as f64];
            // Peaks of the map reach towards the other body.
            return Ok((every.mapv(|height| -height), pixel));
        }
    };
    let length = rough.surface.length();
    let mut heights = rough_surface(spectrum, length, grid, seed).map_err(|error| error.to_string())?;
    let pixel = length / grid as f64;
    let place = |index: usize| (index as f64 + 0.5) * pixel - 0.5 * length;
    if let Some(profile) = rough.setup.profile() {
        for ((row, column), height) in heights.indexed_iter_mut() {
            *height += smooth(profile, place(row).hypot(place(column)));
        }
    }
    Ok((heights, [pixel; 2]))
}

/// Height of the smooth shape [m]; +∞ where it has no material.
pub(super) fn smooth(profile: &dyn Profile, r: f64) -> f64 {
    match profile.rim() {
        Rim::Wall(end) | Rim::End(end) if r > end => f64::INFINITY,
        _ => profile.height(r),
    }
}
