//! A function over the places of a bed, smooth between borders.

use super::kernel::Kernel;
use crate::numerics::quadrature;

/// A function by its values at the nodes of Gauss of its panels, the first of which begins at the axis; lengths in
/// thicknesses of the top layer.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct LineLoad {
    /// Upper borders of the panels.
    pub(super) borders: Vec<f64>,
    panels: Vec<Vec<f64>>,
}

impl LineLoad {
    pub(super) fn of(borders: &[f64], function: impl Fn(f64) -> f64) -> Self {
        let panels = spans(borders).map(|(low, high)| nodes(low, high).map(|(x, _)| function(x)).collect());
        Self { panels: panels.collect(), borders: borders.to_vec() }
    }

    /// Where it ends.
    pub(super) fn end(&self) -> f64 {
        self.borders.last().copied().unwrap_or(0.0)
    }

    /// Places and weights of its nodes.
    pub(super) fn nodes(&self) -> impl Iterator<Item = (f64, f64)> {
        spans(&self.borders).flat_map(|(low, high)| nodes(low, high))
    }

    /// Its values there.
    pub(super) fn values(&self) -> impl Iterator<Item = f64> {
        self.panels.iter().flatten().copied()
    }

    /// Its value at `x`, by the barycentric formula of the second kind: the nodes of Gauss have the weights
    /// (−1)ⁿ√((1−t²)w).
    pub(super) fn at(&self, x: f64) -> f64 {
        let last = self.borders.len().saturating_sub(1);
        let panel = self.borders.partition_point(|&border| border < x).min(last);
        let (Some((low, high)), Some(values)) = (spans(&self.borders).nth(panel), self.panels.get(panel)) else {
            return 0.0;
        };
        let place = (x - 0.5 * (low + high)) / (0.5 * (high - low));
        let (mut sum, mut whole, mut sign) = (0.0, 0.0, 1.0);
        for (&(t, weight), value) in quadrature::nodes().iter().zip(values) {
            if (place - t).abs() <= 0.0 {
                return *value;
            }
            let share = sign * ((1.0 - t) * (1.0 + t) * weight).sqrt() / (place - t);
            (sum, whole, sign) = (sum + share * value, whole + share, -sign);
        }
        sum / whole
    }

    /// ∫K(x, ξ) times it dξ.
    pub(super) fn taken(&self, kernel: &Kernel, x: f64) -> f64 {
        self.nodes().zip(self.values()).map(|((place, weight), value)| weight * value * kernel.between(x, place)).sum()
    }
}

fn spans(borders: &[f64]) -> impl Iterator<Item = (f64, f64)> {
    std::iter::once(0.0).chain(borders.iter().copied()).zip(borders.iter().copied())
}

fn nodes(low: f64, high: f64) -> impl Iterator<Item = (f64, f64)> {
    let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
    quadrature::nodes().iter().map(move |&(t, weight)| (middle + half * t, half * weight))
}
