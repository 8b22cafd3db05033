//! Even functions on [−1, 1] as sums of Legendre polynomials.
//!
//! # Examples
//! ```
//! use springbed::numerics::{legendre, quadrature::node_and_weight};
//!
//! // x² = P₀/3 + 2P₂/3, by the rule of four nodes.
//! let nodes: Vec<(f64, f64)> = (2..4).map(|k| node_and_weight(4, k)).collect();
//! let squares: Vec<f64> = nodes.iter().map(|node| node.0 * node.0).collect();
//! let sum = legendre::EvenRule::new(nodes).coefficients(&squares);
//! assert!((sum[0] - 1.0 / 3.0).abs() < 1e-15 && (sum[1] - 2.0 / 3.0).abs() < 1e-15);
//! assert!((legendre::even_sum(&sum, 0.3) - 0.09).abs() < 1e-15);
//! ```

use ndarray::{Array2, ArrayView1};

/// P₀, P₂, P₄ … at the places `x`.
fn even<const N: usize>(x: [f64; N]) -> impl Iterator<Item = [f64; N]> {
    let mut degree = 0.0;
    let (mut value, mut next) = ([1.0; N], x);
    std::iter::from_fn(move || {
        let here = value;
        for _ in 0..2 {
            degree += 1.0;
            let (up, down) = ((2.0 * degree + 1.0) / (degree + 1.0), degree / (degree + 1.0));
            let after = std::array::from_fn(|k| up * x[k] * next[k] - down * value[k]);
            (value, next) = (next, after);
        }
        Some(here)
    })
}

/// The positive nodes of a rule of Gauss, by which even functions are summed and developed.
#[derive(Debug, Clone)]
pub struct EvenRule {
    nodes: Vec<(f64, f64)>,
    /// (4m + 1)wᵢP₂ₘ(xᵢ), row by row of m.
    projection: Array2<f64>,
}

impl EvenRule {
    /// Of the positive nodes with their weights.
    #[must_use]
    pub fn new(nodes: Vec<(f64, f64)>) -> Self {
        let mut projection = Array2::zeros((nodes.len(), nodes.len()));
        for (i, &(x, weight)) in nodes.iter().enumerate() {
            for (m, ([p], entry)) in even([x]).zip(projection.column_mut(i)).enumerate() {
                *entry = (4.0 * m as f64 + 1.0) * weight * p;
            }
        }
        Self { nodes, projection }
    }

    /// The positive nodes with their weights.
    #[must_use]
    pub fn nodes(&self) -> &[(f64, f64)] {
        &self.nodes
    }

    /// The coefficients of P₀, P₂ … of an even function from its `values` at the nodes; as many as nodes.
    #[must_use]
    pub fn coefficients(&self, values: &[f64]) -> Vec<f64> {
        self.projection.dot(&ArrayView1::from(values)).to_vec()
    }
}

/// Σ cₘP₂ₘ(x).
#[must_use]
pub fn even_sum(coefficients: &[f64], x: f64) -> f64 {
    let [sum] = even_sums(coefficients, [x]);
    sum
}

/// Σ cₘP₂ₘ(x) at several places, which costs little more than at one.
#[must_use]
pub fn even_sums<const N: usize>(coefficients: &[f64], x: [f64; N]) -> [f64; N] {
    coefficients.iter().zip(even(x)).fold([0.0; N], |sums, (c, p)| std::array::from_fn(|k| sums[k] + c * p[k]))
}

/// 1/P₂ₘ(0), m = 0, 1, 2 …: −1, 3/8 … turned over.
pub fn inverses_in_the_middle() -> impl Iterator<Item = f64> {
    let mut value = 1.0;
    (1u32..).map(move |m| {
        let here = value;
        value *= -2.0 * f64::from(m) / (2.0 * f64::from(m) - 1.0);
        here
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_middle_is_that_of_the_polynomials() {
        for (inverse, [p]) in inverses_in_the_middle().zip(even([0.0])).take(60) {
            assert!((inverse * p - 1.0).abs() < 1e-13);
        }
    }

    proptest! {
        /// Even polynomials of lower degree are met.
        #[test]
        fn even_polynomials_are_met(coefficients in prop::collection::vec(-9i32..9, 1..9), k in 0i32..=100) {
            let value = |x: f64| coefficients.iter().rev().fold(0.0, |sum, &c| sum * x * x + f64::from(c));
            let nodes: Vec<(f64, f64)> = (9..18).map(|k| crate::numerics::quadrature::node_and_weight(18, k)).collect();
            let values: Vec<f64> = nodes.iter().map(|node| value(node.0)).collect();
            let x = 0.01 * f64::from(k);
            prop_assert!((even_sum(&EvenRule::new(nodes).coefficients(&values), x) - value(x)).abs() < 1e-12);
        }
    }
}
