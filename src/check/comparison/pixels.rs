//! The full half-space under the shape of a scene.

use crate::check::case::Attempt;
use crate::check::row::{Computed, Found};
use crate::contact::elliptic::EllipticHertz;
use crate::halfspace::{Boundary, Prescribed, PressedMap, Settings, Start, solve};
use crate::input::quantity::Length;
use crate::run::half_space::{Heights, ellipsoid, material, radius_of};
use crate::scene::plan::Plan;
use crate::shape::Shape;

/// Side of the window in contact radii.
const WINDOW: f64 = 3.0;

/// A shape at a depth [m] on `grid` × `grid` pixels; what the solver refuses is told.
pub(super) fn pressed(plan: &Plan, contact_radius: f64, depth: f64, grid: usize) -> Attempt<Computed> {
    let pixel = semi_axes(&plan.scene.shape, contact_radius, depth)?.map(|side| WINDOW * side / grid as f64);
    let heights = match (&plan.scene.shape, plan.profile()) {
        (Shape::Ellipsoid(of), _) => {
            Heights::about_tip([grid; 2], pixel, ellipsoid([of.radius_x, of.radius_y].map(Length::si)))
        }
        (_, Some(profile)) => Heights::about_tip([grid; 2], pixel, |x, y| material(profile, x.hypot(y))),
        (_, None) => return Err("the shape has no profile over a radius".into()),
    };
    let problem = PressedMap {
        heights: heights.values.view(),
        pixel,
        modulus: plan.pair.normal,
        boundary: Boundary::Free,
        control: Prescribed::Indentation(depth),
    };
    let solution = solve(&problem, Start::Coarser, &Settings::default())?;
    let found = Found {
        indentation_m: Some(depth),
        force_n: Some(solution.force()),
        contact_radius_m: Some(radius_of(&plan.scene.shape, &solution)),
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
