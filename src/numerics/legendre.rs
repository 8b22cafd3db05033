//! Even functions on [−1, 1] as sums of Legendre polynomials.
//!
//! # Examples
//! ```
//! use springbed::numerics::{legendre, quadrature::node_and_weight};
//!
//! // x² = P₀/3 + 2P₂/3, by the rule of four nodes.
//! let nodes: Vec<(f64, f64)> = (2..4).map(|k| node_and_weight(4, k)).collect();
//! let squares: Vec<f64> = nodes.iter().map(|node| node.0 * node.0).collect();
//! let sum = legendre::even_coefficients(&nodes, &squares);
//! assert!((sum[0] - 1.0 / 3.0).abs() < 1e-15 && (sum[1] - 2.0 / 3.0).abs() < 1e-15);
//! assert!((legendre::even_sum(&sum, 0.3) - 0.09).abs() < 1e-15);
//! ```

/// P₀, P₂, P₄ … at `x`.
fn even(x: f64) -> impl Iterator<Item = f64> {
    let mut degree = 0.0;
    let (mut value, mut next) = (1.0, x);
    std::iter::from_fn(move || {
        let here = value;
        for _ in 0..2 {
            degree += 1.0;
            (value, next) = (next, ((2.0 * degree + 1.0) * x * next - degree * value) / (degree + 1.0));
        }
        Some(here)
    })
}

/// The coefficients of P₀, P₂ … of an even function from its `values` at `nodes`, the positive ones of a rule of Gauss
/// with their weights; as many as nodes.
#[must_use]
pub fn even_coefficients(nodes: &[(f64, f64)], values: &[f64]) -> Vec<f64> {
    let mut sums = vec![0.0; nodes.len()];
    for (&(x, weight), value) in nodes.iter().zip(values) {
        for (m, (sum, p)) in sums.iter_mut().zip(even(x)).enumerate() {
            *sum += (4.0 * m as f64 + 1.0) * weight * value * p;
        }
    }
    sums
}

/// Σ cₘP₂ₘ(x).
#[must_use]
pub fn even_sum(coefficients: &[f64], x: f64) -> f64 {
    coefficients.iter().zip(even(x)).map(|(c, p)| c * p).sum()
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
        for (inverse, p) in inverses_in_the_middle().zip(even(0.0)).take(60) {
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
            prop_assert!((even_sum(&even_coefficients(&nodes, &values), x) - value(x)).abs() < 1e-12);
        }
    }
}
