//! Punches of neighbouring radii, weighted by a polynomial.

use crate::contact::punch::{Point, Stresses};
use crate::numerics::chebyshev::Chebyshev;
use crate::numerics::complex::Complex;
use crate::numerics::quadrature::node_and_weight;
use std::sync::{LazyLock, OnceLock};

/// Nodes of a panel in t. Its half-length is at most [`PANEL`], the poles stand π/2 aside: the error falls as 3.0⁻²ⁿ.
const NODES: usize = 16;
/// Half the greatest length of a panel in t.
const PANEL: f64 = 1.2;
/// For points farther than so many half-lengths: the degree in x that the punch then has to rounding, (D + √(D²−1))⁻ᵐ.
const FAR: [(f64, usize); 3] = [(100.0, 6), (12.0, 10), (3.0, 19)];

/// Part of a weight that is only rounding.
const ROUNDED: f64 = 1e-14;

static RULE: LazyLock<[(f64, f64); NODES]> = LazyLock::new(|| std::array::from_fn(|k| node_and_weight(NODES, k)));

/// The punches of the radii x = √(b² + s²) between two places s, with the weight −dq/ds [Pa]; b is zero where there is no
/// kink, so that s is x. Lengths in the scale of the field.
#[derive(Debug, Clone)]
pub(super) struct Piece {
    weight: Chebyshev,
    kink: f64,
    /// Radii and weights of the sums that stand for the piece from afar, once they are asked for.
    far: OnceLock<[Vec<(f64, f64)>; FAR.len()]>,
}

impl Piece {
    pub(super) fn new(weight: Chebyshev, kink: f64) -> Self {
        Self { weight, kink, far: OnceLock::new() }
    }

    fn far(&self) -> [Vec<(f64, f64)>; FAR.len()] {
        let (weight, kink) = (&self.weight, self.kink);
        FAR.map(|(_, degree)| {
            let count = (weight.degree() + degree) / 2 + 1;
            let (middle, half) = (0.5 * (weight.low() + weight.high()), 0.5 * (weight.high() - weight.low()));
            let node = |k| {
                let (s, part) = node_and_weight(count, k);
                let s = middle + half * s;
                (kink.hypot(s), half * part * weight.at(s))
            };
            (0..count).map(node).collect()
        })
    }

    /// Its weight over x [Pa], if that grows in proportion to x from the axis on.
    pub(super) fn proportional(&self) -> Option<f64> {
        let (low, high) = (self.weight.low(), self.weight.high());
        let [start, end] = [low, high].map(|x| self.weight.at(x).abs());
        let straight = self.weight.clone().trimmed(ROUNDED * end).degree() == 1;
        let is_so = straight && self.kink <= 0.0 && low.abs() <= 0.0 && start <= ROUNDED * end;
        is_so.then(|| self.weight.at(high) / high)
    }

    /// The pole of the punches, x = r + iz, in the place of the piece.
    fn pole(&self, point: &Point) -> Complex {
        let (r, z, b) = (point.radius, point.depth, self.kink);
        if b > 0.0 {
            Complex { re: (r - b) * (r + b) - z * z, im: 2.0 * r * z }.sqrt()
        } else {
            Complex { re: r, im: z }
        }
    }

    /// The stresses [Pa] of all its punches at a point.
    pub(super) fn stresses(&self, point: &Point, punch: &impl Fn(f64) -> Stresses) -> Stresses {
        let (low, high) = (self.weight.low(), self.weight.high());
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
        let pole = self.pole(point);
        let distance = (pole.re - middle).hypot(pole.im);
        let far = FAR.iter().zip(self.far.get_or_init(|| self.far())).find(|((away, _), _)| distance > away * half);
        match far {
            Some((_, nodes)) => nodes.iter().fold(Stresses::default(), |sum, &(x, weight)| sum + weight * punch(x)),
            None => self.near(pole, punch),
        }
    }

    /// The same in t, s = r + z sinh t with the pole at r + iz.
    fn near(&self, pole: Complex, punch: &impl Fn(f64) -> Stresses) -> Stresses {
        let (r, z) = (pole.re, pole.im);
        let turned = |s: f64| libm::asinh((s - r) / z);
        let (low, high) = (turned(self.weight.low()), turned(self.weight.high()));
        let count = (0.5 * (high - low) / PANEL).ceil().max(1.0);
        let half = 0.5 * (high - low) / count;
        // e^(half·node), the same in every panel; the nodes lie symmetrically.
        let mut steps = [1.0; NODES];
        for (k, (node, _)) in RULE.iter().enumerate().skip(NODES / 2) {
            let step = libm::exp(half * node);
            steps[k] = step;
            steps[NODES - 1 - k] = step.recip();
        }
        let mut sum = Stresses::default();
        let mut middle = low + half;
        while middle < high {
            let base = libm::exp(middle);
            for (step, (_, weight)) in steps.iter().zip(&*RULE) {
                let (grown, shrunk) = (base * step, (base * step).recip());
                let (sinh, cosh) = (0.5 * (grown - shrunk), 0.5 * (grown + shrunk));
                let s = r + z * sinh;
                let x = if self.kink > 0.0 { self.kink.hypot(s) } else { s };
                sum = sum + (half * weight * z * cosh * self.weight.at(s)) * punch(x);
            }
            middle += 2.0 * half;
        }
        sum
    }
}
