//! A flat punch on a layered body: the integral equation of its line load.
//!
//! q₁(x) − ∫₀^a K(x, ξ)q₁(ξ) dξ = 1 for x ≤ a: the punch of radius a sinks by one. The kernel is smooth and even in x,
//! so that the rule of Gauss over −a … a converges faster than any power of the nodes.

use super::kernel::Kernel;
use crate::numerics::legendre;
use crate::numerics::quadrature::node_and_weight;

/// A punch, lengths in thicknesses of the top layer.
#[derive(Debug, Clone)]
pub(super) struct Punch {
    /// s(a) = ∫₀^a q₁ dx = k/2E*.
    pub(super) measure: f64,
    /// q₁(a), at the edge.
    pub(super) edge: f64,
    /// q₁(x) as a sum of P₂ₘ(x/a).
    pub(super) load: Vec<f64>,
    /// Γ(x), by which q₁ grows with the radius, ∂q₁(x)/∂a = q₁(a)Γ(x), as a sum of P₂ₘ(x/a): Γ − ∫K Γ dξ = K(x, a).
    pub(super) resolvent: Vec<f64>,
}

/// Nodes on one half of the punch: the image of a load at the depth 2h leaves e^(−4n arsinh(2h/a)), here 1e-16.
pub(super) fn count(a: f64) -> usize {
    let count = (9.0 / (2.0 / a).asinh()).ceil().max(0.0);
    // The widest punch has a few hundred.
    (4..1 << 16).find(|&n| f64::from(n) >= count + 4.0).unwrap_or(1 << 16) as usize
}

/// The positive nodes of Gauss with their weights, `half` of them.
pub(super) fn rule(half: usize) -> Vec<(f64, f64)> {
    (half..2 * half).map(|k| node_and_weight(2 * half, k)).collect()
}

impl Punch {
    /// The punch of the radius `a`, by a [`rule`] of [`count`] nodes.
    pub(super) fn new(kernel: &Kernel, a: f64, nodes: &[(f64, f64)]) -> Self {
        let half = nodes.len();
        let places: Vec<f64> = nodes.iter().map(|node| a * node.0).collect();
        let roots: Vec<f64> = nodes.iter().map(|node| (a * node.1).sqrt()).collect();
        let to_edge: Vec<f64> = places.iter().map(|&x| kernel.between(x, a)).collect();
        // Weighted by the roots the equations are symmetric, and positive: so is the energy.
        let mut matrix = vec![vec![0.0; half]; half];
        for (i, row) in matrix.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate().take(i + 1) {
                let one = if i == j { 1.0 } else { 0.0 };
                *entry = one - roots[i] * kernel.between(places[i], places[j]) * roots[j];
            }
        }
        factorize(&mut matrix);
        let solved = |right: &mut dyn Iterator<Item = f64>| -> Vec<f64> {
            let weighted: Vec<f64> = right.zip(&roots).map(|(value, root)| value * root).collect();
            solve(&matrix, weighted).into_iter().zip(&roots).map(|(value, root)| value / root).collect()
        };
        let load = solved(&mut std::iter::repeat_n(1.0, half));
        let resolvent = solved(&mut to_edge.iter().copied());
        let summed = |values: &[f64]| values.iter().zip(&roots).map(|(value, root)| value * root * root).sum::<f64>();
        Self {
            measure: summed(&load),
            edge: 1.0 + summed(&resolvent),
            load: legendre::even_coefficients(nodes, &load),
            resolvent: legendre::even_coefficients(nodes, &resolvent),
        }
    }
}

/// The factor L of a positive matrix LLᵀ, in its place; entries above the diagonal are not looked at.
fn factorize(matrix: &mut [Vec<f64>]) {
    for i in 0..matrix.len() {
        let (before, rest) = matrix.split_at_mut(i);
        let Some(row) = rest.first_mut() else { return };
        for (j, other) in before.iter().enumerate() {
            let sum: f64 = row.iter().zip(other).take(j).map(|(a, b)| a * b).sum();
            row[j] = (row[j] - sum) / other[j];
        }
        let squares: f64 = row.iter().take(i).map(|a| a * a).sum();
        row[i] = (row[i] - squares).sqrt();
    }
}

/// The solution of LLᵀx = `right`.
fn solve(factor: &[Vec<f64>], mut right: Vec<f64>) -> Vec<f64> {
    for (i, row) in factor.iter().enumerate() {
        let sum: f64 = row.iter().zip(&right).take(i).map(|(a, b)| a * b).sum();
        right[i] = (right[i] - sum) / row[i];
    }
    for (i, row) in factor.iter().enumerate().rev() {
        right[i] /= row[i];
        let value = right[i];
        for (earlier, a) in right.iter_mut().zip(row).take(i) {
            *earlier -= a * value;
        }
    }
    right
}
