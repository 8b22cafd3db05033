//! The full half-space under the shape of a scene.

use crate::check::case::Attempt;
use crate::check::row::{Computed, Found};
use crate::contact::elliptic::EllipticHertz;
use crate::halfspace::{Boundary, Prescribed, PressedMap, Settings, Solution, Start, solve};
use crate::scene::plan::Plan;
use crate::shape::{Profile, Shape};
use ndarray::Array2;
use std::f64::consts::PI;

/// Side of the window in contact radii.
const WINDOW: f64 = 3.0;

/// A shape at a depth [m] on `grid` × `grid` pixels; what the solver refuses is told.
pub(super) fn pressed(plan: &Plan, contact_radius: f64, depth: f64, grid: usize) -> Attempt<Computed> {
    let pixel = semi_axes(&plan.scene.shape, contact_radius, depth)?.map(|side| WINDOW * side / grid as f64);
    let place = |index: usize, pixel: f64| (index as f64 - (grid / 2) as f64) * pixel;
    let height = |(row, column): (usize, usize)| height(plan, place(column, pixel[0]), place(row, pixel[1]));
    let heights = Array2::from_shape_fn((grid, grid), height);
    let problem = PressedMap {
        heights: heights.view(),
        pixel,
        modulus: plan.pair.normal,
        boundary: Boundary::Free,
        control: Prescribed::Indentation(depth),
    };
    let solution = solve(&problem, Start::Coarser, &Settings::default())?;
    let found = Found {
        indentation_m: Some(depth),
        force_n: Some(solution.force()),
        contact_radius_m: Some(radius(&plan.scene.shape, &solution)),
        peak_pressure_pa: Some(solution.peak_pressure()),
        ..Found::default()
    };
    let (bytes, iterations) = (usize::try_from(solution.bytes)?, Some(solution.iterations));
    Ok(Computed { found, bytes, iterations, ..Computed::default() })
}

/// Semi-axes of the contact along x and y [m]; the true ones of an ellipsoid.
fn semi_axes(shape: &Shape, contact_radius: f64, depth: f64) -> Attempt<[f64; 2]> {
    let Shape::Ellipsoid(ellipsoid) = shape else { return Ok([contact_radius; 2]) };
    let radii = [ellipsoid.radius_x.si(), ellipsoid.radius_y.si()];
    let [larger, smaller] = EllipticHertz::at_indentation(radii, 1.0, depth)?.semi_axes;
    Ok(if radii[0] >= radii[1] { [larger, smaller] } else { [smaller, larger] })
}

/// Height of the indenter [m]; +∞ where it has no material.
fn height(plan: &Plan, x: f64, y: f64) -> f64 {
    if let Shape::Ellipsoid(ellipsoid) = &plan.scene.shape {
        return 0.5 * (x * x / ellipsoid.radius_x.si() + y * y / ellipsoid.radius_y.si());
    }
    plan.profile().map_or(0.0, |profile| smooth(profile, x.hypot(y)))
}

/// Height of a smooth shape [m]; +∞ where it has no material.
pub(super) fn smooth(profile: &dyn Profile, r: f64) -> f64 {
    if r > profile.rim().radius() { f64::INFINITY } else { profile.height(r) }
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
