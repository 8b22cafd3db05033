//! A flat punch on a layered body: the integral equation of its line load.
//!
//! q₁(x) − ∫₀^a K(x, ξ)q₁(ξ) dξ = 1 for x ≤ a: the punch of radius a sinks by one. The kernel is smooth and even in x,
//! so that the rule of Gauss over −a … a converges faster than any power of the nodes.

use super::kernel::Kernel;
use crate::numerics::legendre::EvenRule;
use crate::numerics::quadrature::node_and_weight;
use ndarray::{Array1, Array2, Axis, s};

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

/// The positive nodes of Gauss, `half` of them.
pub(super) fn rule(half: usize) -> EvenRule {
    EvenRule::new((half..2 * half).map(|k| node_and_weight(2 * half, k)).collect())
}

impl Punch {
    /// The punch of the radius `a`, by a [`rule`] of [`count`] nodes.
    pub(super) fn new(kernel: &Kernel, a: f64, rule: &EvenRule) -> Self {
        let nodes = rule.nodes();
        let half = nodes.len();
        let places: Vec<f64> = nodes.iter().map(|node| a * node.0).collect();
        let roots: Vec<f64> = nodes.iter().map(|node| (a * node.1).sqrt()).collect();
        let to_edge: Vec<f64> = places.iter().map(|&x| kernel.between(x, a)).collect();
        // Weighted by the roots the equations are symmetric, and positive: so is the energy.
        let mut matrix = Array2::eye(half);
        for i in 0..half {
            for j in 0..=i {
                matrix[[i, j]] -= roots[i] * kernel.between(places[i], places[j]) * roots[j];
            }
        }
        factorize(&mut matrix);
        let solved = |right: &mut dyn Iterator<Item = f64>| -> Vec<f64> {
            let weighted: Array1<f64> = right.zip(&roots).map(|(value, root)| value * root).collect();
            solve(&matrix, weighted).into_iter().zip(&roots).map(|(value, root)| value / root).collect()
        };
        let load = solved(&mut std::iter::repeat_n(1.0, half));
        let resolvent = solved(&mut to_edge.iter().copied());
        let summed = |values: &[f64]| values.iter().zip(&roots).map(|(value, root)| value * root * root).sum::<f64>();
        Self {
            measure: summed(&load),
            edge: 1.0 + summed(&resolvent),
            load: rule.coefficients(&load),
            resolvent: rule.coefficients(&resolvent),
        }
    }
}

/// The factor L of a positive matrix LLᵀ, in its place; entries above the diagonal are not looked at.
fn factorize(matrix: &mut Array2<f64>) {
    for i in 0..matrix.nrows() {
        let (before, mut rest) = matrix.view_mut().split_at(Axis(0), i);
        let mut row = rest.row_mut(0);
        for (j, other) in before.rows().into_iter().enumerate() {
            let sum = row.slice(s![..j]).dot(&other.slice(s![..j]));
            row[j] = (row[j] - sum) / other[j];
        }
        let known = row.slice(s![..i]);
        row[i] = (row[i] - known.dot(&known)).sqrt();
    }
}

/// The solution of LLᵀx = `right`.
fn solve(factor: &Array2<f64>, mut right: Array1<f64>) -> Array1<f64> {
    for (i, row) in factor.rows().into_iter().enumerate() {
        let sum = row.slice(s![..i]).dot(&right.slice(s![..i]));
        right[i] = (right[i] - sum) / row[i];
    }
    for (i, row) in factor.rows().into_iter().enumerate().rev() {
        right[i] /= row[i];
        let value = right[i];
        right.slice_mut(s![..i]).scaled_add(-value, &row.slice(s![..i]));
    }
    right
}
