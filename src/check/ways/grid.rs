//! The full half-space on grids of pixels.

use crate::check::case::Attempt;
use crate::check::closed_forms::ClosedForm;
use crate::check::row::{Computed, Found, Setting};
use crate::check::study::{Method, Thoroughness};
use crate::halfspace::{self, Boundary, Prescribed, PressedMap, Settings, Start};
use crate::shape::Profile;
use ndarray::Array2;
use std::sync::Arc;

/// The half-space under a shape, E* = 1, in a window of three contact radii.
pub fn methods<P: Profile + 'static>(shape: &Arc<P>, exact: ClosedForm, effort: Thoroughness) -> Vec<Method> {
    let finest = if effort == Thoroughness::Brief { 8 } else { 10 };
    let method = |n: usize| {
        let shape = shape.clone();
        let prepare = move || {
            let pixel = 3.0 * exact.radius / as_f64(n);
            let place = |index: usize| (as_f64(index) - as_f64(n / 2)) * pixel;
            let height = |(row, column)| shape.height(place(row).hypot(place(column)));
            let heights = Array2::from_shape_fn((n, n), height);
            Ok(move || solved(&heights, pixel, exact.indentation))
        };
        Method::new("half-space", Setting::grid(n), prepare)
    };
    (5..=finest).map(|k| method(1 << k)).collect()
}

fn solved(heights: &Array2<f64>, pixel: f64, depth: f64) -> Attempt<Computed> {
    let control = Prescribed::Indentation(depth);
    let problem =
        PressedMap { heights: heights.view(), pixel: [pixel; 2], modulus: 1.0, boundary: Boundary::Free, control };
    let solution = halfspace::solve(&problem, Start::Coarser, &Settings::default())?;
    let found = Found {
        contact_radius_m: Some(solution.contact_radius()),
        peak_pressure_pa: Some(solution.peak_pressure()),
        ..Found::default()
    };
    let (bytes, iterations) = (usize::try_from(solution.bytes)?, Some(solution.iterations));
    Ok(Computed { values: vec![solution.force()], found, bytes, iterations })
}

#[expect(clippy::cast_precision_loss, reason = "grids are far below 2^53")]
fn as_f64(n: usize) -> f64 {
    n as f64
}
