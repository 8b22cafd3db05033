//! The full half-space on grids of pixels.

use super::{Answer, Effort, Method, Setting};
use crate::halfspace::{self, Boundary, Prescribed, PressedMap, Settings, Start};
use ndarray::Array2;

/// The half-space under the profile `height`(r), E* = 1, in a window of three contact radii.
pub(super) fn methods(
    height: impl Fn(f64) -> f64 + Copy + 'static,
    (effort, depth, contact_radius): (Effort, f64, f64),
) -> Vec<Method> {
    let finest = if effort == Effort::Brief { 8 } else { 10 };
    let method = |n: usize| {
        let prepare = move || {
            let pixel = 3.0 * contact_radius / as_f64(n);
            let place = |index: usize| (as_f64(index) - as_f64(n / 2)) * pixel;
            let heights = Array2::from_shape_fn((n, n), |(row, column)| height(place(row).hypot(place(column))));
            Some(move || solved(&heights, pixel, depth))
        };
        Method::new("half-space", Setting { grid: Some(n), ..Setting::FREE }, prepare)
    };
    (5..=finest).map(|k| method(1 << k)).collect()
}

fn solved(heights: &Array2<f64>, pixel: f64, depth: f64) -> Option<Answer> {
    let control = Prescribed::Indentation(depth);
    let problem =
        PressedMap { heights: heights.view(), pixel: [pixel; 2], modulus: 1.0, boundary: Boundary::Free, control };
    let solution = halfspace::solve(&problem, Start::Coarser, &Settings::default()).ok()?;
    Some(Answer {
        values: vec![solution.force()],
        radius: Some(solution.contact_radius()),
        pressure: Some(solution.peak_pressure()),
        bytes: usize::try_from(solution.bytes).ok()?,
        iterations: Some(solution.iterations),
    })
}

#[expect(clippy::cast_precision_loss, reason = "grids are far below 2^53")]
fn as_f64(n: usize) -> f64 {
    n as f64
}
