//! How far the surface slips over springs that slip.

use super::rings::{Rings, dot};
use std::f64::consts::FRAC_PI_2;

/// The mean slip of the rings from the slips of the cells.
///
/// S(r) = (2/π)∫₀^r s(x) dx/√(r²−x²), s constant in each cell, and its mean over a ring; weights above zero that sum to
/// one.
#[derive(Debug, Clone, Default)]
pub struct Slips {
    /// Rows, one after the other: the row j has j + 2 numbers.
    weights: Vec<f64>,
    rows: usize,
}

impl Slips {
    /// Adds the rows of rings that have come since.
    pub fn fill(&mut self, rings: &Rings) {
        let cells = rings.cells();
        for j in self.rows..rings.len() {
            let (inner, outer) = (rings.rings()[j], rings.rings()[j + 1]);
            let share = |i: usize| {
                let (from, to) = (cells[i.min(rings.len())], cells[(i + 1).min(rings.len())]);
                segment(outer, (from, to)) - segment(inner, (from, to))
            };
            let scale = 4.0 / rings.areas()[j];
            self.weights.extend((0..j + 2).map(|i| scale * share(i)));
            self.rows = j + 1;
        }
    }

    /// Slips of the rings under the slips `cells` of the cells.
    pub fn of(&self, cells: &[f64], rings: &mut [f64]) {
        let mut from = 0;
        for (j, ring) in rings.iter_mut().enumerate().take(self.rows) {
            *ring = dot(&self.weights[from..from + j + 2], cells);
            from += j + 2;
        }
    }

    /// Bytes of all.
    pub fn bytes(&self) -> usize {
        size_of::<f64>() * self.weights.len()
    }
}

/// ∫ √(r² − x²)₊ dx between two places.
fn segment(r: f64, (from, to): (f64, f64)) -> f64 {
    if r <= 0.0 {
        return 0.0;
    }
    let part = |x: f64| {
        let t = x / r;
        if t >= 1.0 { FRAC_PI_2 } else { t.asin() + t * ((1.0 - t) * (1.0 + t)).sqrt() }
    };
    0.5 * r * r * (part(to) - part(from))
}
