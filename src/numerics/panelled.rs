//! A function that is smooth on each of a row of panels, and its values at the nodes of Gauss and Legendre on them.
//!
//! # Examples
//! ```
//! use springbed::numerics::panelled::PanelledCurve;
//!
//! // A roof over [0, 2].
//! let roof = PanelledCurve::new(|x: f64| 1.0 - (x - 1.0).abs(), vec![1.0, 2.0]);
//! assert!((roof.integral() - 1.0).abs() < 1e-15 && roof.panels().count() == 2);
//! assert!((roof.less(0.5).integral()).abs() < 1e-15);
//! ```

use super::quadrature::{self, NODES};
use std::fmt::{self, Debug, Formatter};
use std::sync::{Arc, OnceLock};

/// Part of a panel's length from which on a root or a pole beside it does no harm: the rule of 32 nodes is at rounding
/// where the singularity lies on an ellipse with the foci at its ends whose half axes sum up to 1.78 half lengths, since
/// 1.78⁻⁶⁴ = 1e-16, and 0.5 (1.78 + 1/1.78) − 1 half lengths are 0.086 of it.
const FAR: f64 = 0.1;

/// A place in a panel, what a value there counts in an integral over it, and the value of the function.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Node {
    /// Where it is.
    pub place: f64,
    /// What it counts.
    pub weight: f64,
    /// The value of the function there.
    pub value: f64,
}

/// A stretch on which the function is smooth.
#[derive(Debug, Clone, Copy)]
pub struct SmoothStretch<'c> {
    /// Where it begins.
    pub low: f64,
    /// Where it ends.
    pub high: f64,
    nodes: &'c [Node; NODES],
    offset: f64,
}

impl SmoothStretch<'_> {
    /// Whether a kernel with a singularity at `x` is smooth on it.
    #[must_use]
    pub fn is_far_from(&self, x: f64) -> bool {
        (self.low - x).max(x - self.high) >= FAR * (self.high - self.low)
    }

    /// Σ w `kernel`(x, f(x)), which is ∫ kernel(x, f(x)) dx where the kernel is smooth on it.
    pub fn sum(&self, mut kernel: impl FnMut(f64, f64) -> f64) -> f64 {
        self.nodes.iter().map(|node| node.weight * kernel(node.place, node.value - self.offset)).sum()
    }
}

/// A function from zero on, smooth between the ends of its panels and of no account beyond the last.
#[derive(Clone)]
pub struct PanelledCurve<'f> {
    of: Arc<dyn Fn(f64) -> f64 + Send + Sync + 'f>,
    ends: Arc<[f64]>,
    offset: f64,
    nodes: Arc<OnceLock<Vec<[Node; NODES]>>>,
}

impl<'f> PanelledCurve<'f> {
    /// The curve `of`(x); `ends` are the borders of the panels, ascending; the first begins at zero.
    pub fn new(of: impl Fn(f64) -> f64 + Send + Sync + 'f, ends: Vec<f64>) -> Self {
        Self { of: Arc::new(of), ends: ends.into(), offset: 0.0, nodes: Arc::default() }
    }

    /// The same, lower by a constant.
    #[must_use]
    pub fn less(&self, constant: f64) -> Self {
        Self { offset: self.offset + constant, ..self.clone() }
    }

    /// Borders of the panels.
    #[must_use]
    pub fn ends(&self) -> &[f64] {
        &self.ends
    }

    /// The value at `x`.
    #[must_use]
    pub fn at(&self, x: f64) -> f64 {
        (self.of)(x) - self.offset
    }

    /// The panels from zero to the last end, those of no length left out.
    pub fn panels(&self) -> impl Iterator<Item = SmoothStretch<'_>> {
        let borders = self.borders();
        let nodes = self.nodes.get_or_init(|| self.borders().map(|border| self.sampled(border)).collect());
        borders.zip(nodes).map(|((low, high), nodes)| SmoothStretch { low, high, nodes, offset: self.offset })
    }

    /// ∫ f dx from zero to the last end.
    #[must_use]
    pub fn integral(&self) -> f64 {
        self.panels().map(|panel| panel.sum(|_, value| value)).sum()
    }

    fn borders(&self) -> impl Iterator<Item = (f64, f64)> {
        let lows = std::iter::once(0.0).chain(self.ends.iter().copied());
        lows.zip(self.ends.iter().copied()).filter(|(low, high)| high > low)
    }

    fn sampled(&self, (low, high): (f64, f64)) -> [Node; NODES] {
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
        std::array::from_fn(|k| {
            let (node, weight) = quadrature::nodes()[k];
            let place = middle + half * node;
            Node { place, weight: half * weight, value: (self.of)(place) }
        })
    }
}

impl Debug for PanelledCurve<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.debug_struct("PanelledCurve").field("ends", &self.ends).finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// ∫ x dx/(x² − r²)^½ over a panel nearly as near to r as it may be, and farther, is √(b² − r²) − √(a² − r²).
        #[test]
        fn a_root_beside_a_panel_does_no_harm(place in 0..1000u32, apart in 1..1000u32) {
            let (r, length) = (1e-3 * f64::from(place), 1.0);
            let low = r + FAR * length * (1.0 + 1e-2 * f64::from(apart));
            let curve = PanelledCurve::new(|x| x, vec![low, low + length]);
            let panel = curve.panels().last().unwrap();
            prop_assert!(panel.is_far_from(r));
            let root = |x: f64| ((x - r) * (x + r)).sqrt();
            let exact = root(panel.high) - root(panel.low);
            let found = panel.sum(|x, value| value / root(x));
            prop_assert!((found / exact - 1.0).abs() < 4e-14, "{}", found / exact - 1.0);
        }
    }
}
