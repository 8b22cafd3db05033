//! The state on the full half-space.

use super::methods::Scenario;
use super::{Measured, State, timed};
use crate::contact::elliptic::EllipticHertz;
use crate::halfspace::{Boundary, HalfSpaceError, Prescribed, PressedMap, Settings, Solution, Start, solve};
use crate::shape::Shape;
use ndarray::Array2;
use std::f64::consts::PI;

/// Side of the window in contact radii.
const WINDOW: f64 = 3.0;

/// The state on a grid of `grid` × `grid` pixels; what the solver refuses is told.
pub(super) fn measured(scenario: &Scenario<'_>, grid: usize) -> Result<Measured, String> {
    let (solution, time) = timed(|| solved(scenario, grid));
    let solution = solution.map_err(|error| format!("half-space on {grid}² pixels: {error}"))?;
    let state = State {
        force_n: solution.force(),
        contact_radius_m: Some(radius(&scenario.setup.scene.shape, &solution)),
        peak_pressure_pa: scenario.peak_at.map(|_| solution.peak_pressure()),
        ..scenario.most
    };
    Ok(Measured { state, time, bytes: solution.bytes, iterations: Some(solution.iterations) })
}

fn solved(scenario: &Scenario<'_>, grid: usize) -> Result<Solution, HalfSpaceError> {
    let pixel = semi_axes(scenario).map(|side| WINDOW * side / grid as f64);
    let place = |index: usize, pixel: f64| (index as f64 - (grid / 2) as f64) * pixel;
    let height = |(row, column): (usize, usize)| height(scenario, place(column, pixel[0]), place(row, pixel[1]));
    let heights = Array2::from_shape_fn((grid, grid), height);
    let problem = PressedMap {
        heights: heights.view(),
        pixel,
        modulus: scenario.setup.pair.normal,
        boundary: Boundary::Free,
        control: Prescribed::Indentation(scenario.most.indentation_m),
    };
    solve(&problem, Start::Coarser, &Settings::default())
}

/// Semi-axes of the contact along x and y [m]; the true ones of an ellipsoid.
fn semi_axes(scenario: &Scenario<'_>) -> [f64; 2] {
    let round = [scenario.most.contact_radius_m.unwrap_or(0.0); 2];
    let Shape::Ellipsoid(ellipsoid) = &scenario.setup.scene.shape else { return round };
    let radii = [ellipsoid.radius_x.si(), ellipsoid.radius_y.si()];
    let exact = EllipticHertz::at_indentation(radii, 1.0, scenario.most.indentation_m);
    exact.map_or(round, |contact| {
        let [larger, smaller] = contact.semi_axes;
        if radii[0] >= radii[1] { [larger, smaller] } else { [smaller, larger] }
    })
}

/// Height of the indenter [m]; +∞ where it has no material.
fn height(scenario: &Scenario<'_>, x: f64, y: f64) -> f64 {
    if let Shape::Ellipsoid(ellipsoid) = &scenario.setup.scene.shape {
        return 0.5 * (x * x / ellipsoid.radius_x.si() + y * y / ellipsoid.radius_y.si());
    }
    scenario.setup.profile().map_or(0.0, |profile| super::rough_full::smooth(profile, x.hypot(y)))
}

/// Contact radius [m]: of Hertzian pressures from their second moments, else from the area.
fn radius(shape: &Shape, solution: &Solution) -> f64 {
    match shape {
        Shape::Paraboloid(_) | Shape::Ellipsoid(_) => {
            let [a, b] = solution.hertzian_semi_axes();
            (a * b).sqrt()
        }
        Shape::FlatPunch(_) => solution.contact_radius(),
        _ => (solution.corrected_area().max(0.0) / PI).sqrt(),
    }
}
