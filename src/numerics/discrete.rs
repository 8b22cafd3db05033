//! Gauss's rule of a sum: many positive weights made few that give the same moments.
//!
//! # Examples
//! ```
//! use springbed::numerics::discrete::Orthogonal;
//!
//! // Weights 1 at 0, 1/2 and 1: two nodes have the same moments up to the third.
//! let few = Orthogonal::new(&[(0.0, 1.0), (0.5, 1.0), (1.0, 1.0)], 2).rule(2);
//! let moment = |power: i32| few.iter().map(|(node, weight)| weight * node.powi(power)).sum::<f64>();
//! assert!((moment(0) - 3.0).abs() < 1e-14 && (moment(3) - 1.125).abs() < 1e-14);
//! ```

use crate::numerics::root;

/// Monic polynomials π_p that are orthogonal over a sum of positive weights,
/// π_{p+1}(x) = (x − α_p) π_p(x) − β_p π_{p−1}(x) (Stieltjes; Gautschi 2004, § 2.2.3.1).
#[derive(Debug, Clone)]
pub struct Orthogonal {
    alpha: Vec<f64>,
    /// Σ w π_p², the zeroth one the sum of the weights.
    squares: Vec<f64>,
    low: f64,
    high: f64,
}

impl Orthogonal {
    /// Those of the pairs (node, weight > 0) `points` up to the degree `most`, below the number of points.
    #[must_use]
    pub fn new(points: &[(f64, f64)], most: usize) -> Self {
        let mut before = vec![0.0; points.len()];
        let mut here = vec![1.0; points.len()];
        let (mut alpha, mut squares) = (Vec::new(), Vec::new());
        for degree in 0..=most {
            let sum = |of: &dyn Fn(usize) -> f64| (0..points.len()).map(of).sum::<f64>();
            let square = sum(&|k| points[k].1 * here[k] * here[k]);
            let mean = sum(&|k| points[k].1 * points[k].0 * here[k] * here[k]) / square;
            let beta = squares.last().map_or(0.0, |last| square / last);
            alpha.push(mean);
            squares.push(square);
            if degree < most {
                for (k, (node, _)) in points.iter().enumerate() {
                    let next = (node - mean) * here[k] - beta * before[k];
                    before[k] = here[k];
                    here[k] = next;
                }
            }
        }
        let ends = points.iter().fold((f64::MAX, f64::MIN), |(low, high), point| (low.min(point.0), high.max(point.0)));
        Self { alpha, squares, low: ends.0, high: ends.1 }
    }

    /// Σ w π_p² of the degree `degree`: what Gauss's rule of as many nodes misses of a function is that times a value of
    /// f⁽²ᵖ⁾/(2p)!.
    #[must_use]
    pub fn square(&self, degree: usize) -> f64 {
        self.squares[degree]
    }

    /// π_p(x).
    fn at(&self, degree: usize, x: f64) -> f64 {
        self.values(degree, x).last().unwrap_or(1.0)
    }

    /// π_0(x) to π_p(x).
    fn values(&self, degree: usize, x: f64) -> impl Iterator<Item = f64> {
        let mut pair = (0.0, 1.0);
        (0..=degree).map(move |at| {
            if at > 0 {
                let beta = if at > 1 { self.squares[at - 1] / self.squares[at - 2] } else { 0.0 };
                pair = (pair.1, (x - self.alpha[at - 1]) * pair.1 - beta * pair.0);
            }
            pair.1
        })
    }

    /// Nodes and weights of Gauss's rule with `count` of them, in ascending order: moments up to 2·count − 1 are right.
    #[must_use]
    pub fn rule(&self, count: usize) -> Vec<(f64, f64)> {
        let mut roots: Vec<f64> = Vec::new();
        // The roots of one degree part those of the next (Szegő 1939, § 3.3).
        for degree in 1..=count {
            let ends: Vec<f64> = std::iter::once(self.low).chain(roots).chain([self.high]).collect();
            let side = |at: usize| if (degree + at).is_multiple_of(2) { 1.0 } else { -1.0 };
            let between =
                |(at, pair): (usize, &[f64])| root::within(|x| -side(at) * self.at(degree, x), pair[0], pair[1]);
            roots = ends.windows(2).enumerate().map(between).collect();
        }
        let weight =
            |x: f64| self.values(count - 1, x).zip(&self.squares).map(|(value, square)| value * value / square);
        roots.into_iter().map(|x| (x, weight(x).sum::<f64>().recip())).collect()
    }
}
