//! Pixels whose neighbours do nothing to them, as those of a sheet of springs: pressed without a single iteration.

use super::face::Budget;
use super::run::{ScaledLoad, ScaledSolution};
use super::vector::{each, fold};
use rayon::prelude::*;

/// Springs without neighbours, in the solver's units.
pub(super) struct LonePixels {
    pub(super) heights: Vec<f64>,
    /// Displacement per pressure.
    pub(super) give: f64,
    /// Largest pressure.
    pub(super) hardness: f64,
}

impl LonePixels {
    /// p = (d − f)/c wherever that is above zero, and no more than the hardness.
    pub(super) fn pressed(self, wanted: ScaledLoad) -> ScaledSolution {
        let approach = match wanted {
            ScaledLoad::Approach(approach) => approach,
            ScaledLoad::Force(force) => self.approach(force * self.give),
        };
        let pressed = |height: &f64| ((approach - height) / self.give).clamp(0.0, self.hardness);
        let pressure: Vec<f64> = each(&self.heights).map(pressed).collect();
        let displacement = each(&pressure).map(|pressure| self.give * pressure).collect();
        let effort = Budget { iterations: 0, products: 0, limit: 0 };
        ScaledSolution { pressure, displacement, approach, residual: 0.0, effort }
    }

    /// The approach at which Σ(d − f) of all that touches is `sum`.
    ///
    /// It grows with d and is convex in it: from where all touch the steps of Newton's method come down to the root,
    /// and end with the pixels that touch there.
    fn approach(&self, sum: f64) -> f64 {
        let touching = |approach: f64| {
            let piece = |range: std::ops::Range<usize>| {
                let touch = self.heights[range].iter().filter(|&&height| height < approach);
                touch.fold((0_usize, 0.0), |(count, sum), height| (count + 1, sum + height))
            };
            fold(self.heights.len(), piece, (0, 0.0), |one, other| (one.0 + other.0, one.1 + other.1))
        };
        let (mut count, mut lifted) = touching(f64::INFINITY);
        loop {
            let approach = (sum + lifted) / count.max(1) as f64;
            let (fewer, less) = touching(approach);
            if fewer == count || fewer == 0 {
                return approach;
            }
            (count, lifted) = (fewer, less);
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::ground::{Ground, Springs};
    use crate::halfspace::{Boundary, Prescribed, PressedMap, Settings, Start, SurfaceResponse, solve_on};
    use ndarray::Array2;
    use proptest::prelude::*;
    use std::sync::Arc;

    proptest! {
        #![proptest_config(crate::laws::cases(64))]

        /// p = M(d − f)/h wherever that presses, under a depth and under its force, whatever lies around.
        #[test]
        fn each_pixel_is_a_spring(
            heights in prop::collection::vec(-100i32..100, 12),
            depth in 1i32..300,
            boundary in prop_oneof![Just(Boundary::Free), Just(Boundary::Periodic)],
        ) {
            let heights = Array2::from_shape_vec((3, 4), heights).unwrap().mapv(|height| 1e-3 * f64::from(height));
            let lowest = heights.iter().copied().fold(f64::INFINITY, f64::min);
            let depth = lowest + 1e-3 * f64::from(depth);
            let springs: Arc<dyn Ground> = Arc::new(Springs { thickness: 0.02 });
            let response = SurfaceResponse::over(Some(springs), [3, 4], [0.1, 0.2], boundary);
            let solve = |control| {
                let map = PressedMap { heights: heights.view(), pixel: [0.1, 0.2], modulus: 5.0, boundary, control };
                solve_on(&response, &map, Start::Coarser, &Settings::default()).unwrap()
            };
            let pressed = solve(Prescribed::Indentation(depth));
            for (at, height) in heights.indexed_iter() {
                let exact = 250.0 * (depth - height).max(0.0);
                prop_assert!((pressed.pressure[at] - exact).abs() <= 1e-13 * (250.0 * (depth - lowest)));
                prop_assert!((pressed.displacement[at] - exact / 250.0).abs() <= 1e-13 * (depth - lowest));
            }
            let again = solve(Prescribed::Force(pressed.force()));
            prop_assert!((again.indentation - depth).abs() <= 1e-13 * (depth - lowest + 0.1));
            prop_assert!((again.force() / pressed.force() - 1.0).abs() <= 1e-12);
        }
    }
}
