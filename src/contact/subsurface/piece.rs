//! Punches of neighbouring radii, weighted by a polynomial.

use crate::contact::punch::{Point, Stresses};
use crate::numerics::chebyshev::Chebyshev;
use crate::numerics::quadrature::node_and_weight;
use std::sync::LazyLock;

/// Nodes of a panel in t. Its half-length is at most [`PANEL`], the poles stand π/2 aside: the error falls as 3.0⁻²ⁿ.
const NODES: usize = 16;
/// Half the greatest length of a panel in t.
const PANEL: f64 = 1.2;
/// For points farther than so many half-lengths: the degree in x that the punch then has to rounding, (D + √(D²−1))⁻ᵐ.
const FAR: [(f64, usize); 3] = [(100.0, 6), (12.0, 10), (3.0, 19)];

static RULE: LazyLock<[(f64, f64); NODES]> = LazyLock::new(|| std::array::from_fn(|k| node_and_weight(NODES, k)));

/// The punches of the radii between two places, with the weight −q′ [Pa]; lengths in the scale of the field.
#[derive(Debug, Clone)]
pub(super) struct Piece {
    weight: Chebyshev,
    /// Radii and weights of the sums that stand for the piece from afar.
    far: [Vec<(f64, f64)>; FAR.len()],
}

impl Piece {
    pub(super) fn new(weight: Chebyshev) -> Self {
        let far = FAR.map(|(_, degree)| {
            let count = (weight.degree() + degree) / 2 + 1;
            let (middle, half) = (0.5 * (weight.low() + weight.high()), 0.5 * (weight.high() - weight.low()));
            let node = |k| {
                let (s, part) = node_and_weight(count, k);
                let x = middle + half * s;
                (x, half * part * weight.at(x))
            };
            (0..count).map(node).collect()
        });
        Self { weight, far }
    }

    /// The stresses [Pa] of all its punches at a point.
    pub(super) fn stresses(&self, point: &Point, punch: &impl Fn(f64) -> Stresses) -> Stresses {
        let (low, high) = (self.weight.low(), self.weight.high());
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
        let distance = (point.radius - middle).hypot(point.depth);
        let far = FAR.iter().zip(&self.far).find(|((away, _), _)| distance > away * half);
        match far {
            Some((_, nodes)) => {
                nodes.iter().fold(Stresses::default(), |sum, &(x, weight)| sum + weight * punch(x))
            }
            None => self.near(point, punch),
        }
    }

    /// The same in t, x = r + z sinh t.
    fn near(&self, point: &Point, punch: &impl Fn(f64) -> Stresses) -> Stresses {
        let (r, z) = (point.radius, point.depth);
        let turned = |x: f64| libm::asinh((x - r) / z);
        let (low, high) = (turned(self.weight.low()), turned(self.weight.high()));
        let count = (0.5 * (high - low) / PANEL).ceil().max(1.0);
        let half = 0.5 * (high - low) / count;
        let mut sum = Stresses::default();
        let mut middle = low + half;
        while middle < high {
            for &(node, weight) in &*RULE {
                let grown = libm::exp(middle + half * node);
                let (sinh, cosh) = (0.5 * (grown - 1.0 / grown), 0.5 * (grown + 1.0 / grown));
                let x = r + z * sinh;
                sum = sum + (half * weight * z * cosh * self.weight.at(x)) * punch(x);
            }
            middle += 2.0 * half;
        }
        sum
    }
}
