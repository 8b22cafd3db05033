//! What is left of bodies that yield.

use crate::halfspace::Solution;
use ndarray::{Array2, Zip};

/// What is left of bodies that yield under the hardness, as if each pixel were pushed in by itself.
#[derive(Debug, Clone)]
pub(super) struct Dent {
    /// Largest pressure \[Pa\].
    pub(super) hardness: f64,
    /// Depth \[m\] on each pixel, for good.
    pub(super) depth: Array2<f64>,
    /// Energy lost so far \[J per m² of a pixel\].
    pub(super) dissipated: f64,
}

impl Dent {
    /// Adds what the surfaces of a contact overlap where it yields.
    pub(super) fn deepen(&mut self, contact: &Solution, heights: &Array2<f64>) {
        let Self { hardness, depth, dissipated } = self;
        Zip::from(depth).and(heights).and(&contact.pressure).and(&contact.displacement).for_each(
            |depth, height, &pressure, displacement| {
                if pressure >= *hardness * (1.0 - ROUNDING) {
                    let overlap = (contact.indentation - (height + *depth) - displacement).max(0.0);
                    *depth += overlap;
                    *dissipated += *hardness * overlap;
                }
            },
        );
    }
}

/// Part of the hardness within which a pressure has reached it.
const ROUNDING: f64 = 1e-12;
