//! A flat punch on a layered body: the integral equation of its line load.
//!
//! q₁(x) − ∫₀^a K(x, ξ)q₁(ξ) dξ = 1 for x ≤ a: the punch of radius a sinks by one. The kernel is smooth and even in x,
//! so that the rule of Gauss over −a … a converges faster than any power of the nodes.

use super::kernel::Kernel;
use crate::numerics::quadrature::node_and_weight;

/// A punch, lengths in thicknesses of the top layer, at the positive nodes of its [`rule`].
#[derive(Debug, Clone)]
pub(super) struct Punch {
    /// s(a) = ∫₀^a q₁ dx = k/2E*.
    pub(super) measure: f64,
    /// q₁(a), at the edge.
    pub(super) edge: f64,
    /// q₁(x).
    pub(super) load: Vec<f64>,
    /// Γ(x), by which q₁ grows with the radius, ∂q₁(x)/∂a = q₁(a)Γ(x): Γ − ∫K Γ dξ = K(x, a).
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
    pub(super) fn new(kernel: &Kernel, a: f64, rule: &[(f64, f64)]) -> Self {
        let places: Vec<f64> = rule.iter().map(|node| a * node.0).collect();
        let roots: Vec<f64> = rule.iter().map(|node| (a * node.1).sqrt()).collect();
        let to_edge: Vec<f64> = places.iter().map(|&x| kernel.between(x, a)).collect();
        // Weighted by the roots the equations are symmetric, and positive: so is the energy.
        let factor = Factor::of(places.len(), |i, j| {
            let same = if i == j { 1.0 } else { 0.0 };
            same - roots[i] * kernel.between(places[i], places[j]) * roots[j]
        });
        let solved = |right: &mut dyn Iterator<Item = f64>| -> Vec<f64> {
            let weighted = right.zip(&roots).map(|(value, root)| value * root).collect();
            factor.solve(weighted).into_iter().zip(&roots).map(|(value, root)| value / root).collect()
        };
        let load = solved(&mut std::iter::repeat_n(1.0, rule.len()));
        let resolvent = solved(&mut to_edge.iter().copied());
        let summed = |values: &[f64]| values.iter().zip(&roots).map(|(value, root)| value * root * root).sum::<f64>();
        Self { measure: summed(&load), edge: 1.0 + summed(&resolvent), load, resolvent }
    }
}

/// The factor L of a positive matrix LLᵀ: the rows up to the diagonal, one after the other.
struct Factor(Vec<Vec<f64>>);

impl Factor {
    /// Of the matrix of `side` rows with `entry(i, j)`, j ≤ i (Cholesky).
    fn of(side: usize, entry: impl Fn(usize, usize) -> f64) -> Self {
        let mut rows: Vec<Vec<f64>> = Vec::with_capacity(side);
        for i in 0..side {
            let mut row: Vec<f64> = Vec::with_capacity(i + 1);
            for (j, other) in rows.iter().enumerate() {
                row.push((entry(i, j) - dot(&row, &other[..j])) / other[j]);
            }
            row.push((entry(i, i) - dot(&row, &row)).sqrt());
            rows.push(row);
        }
        Self(rows)
    }

    /// The solution of LLᵀx = `right`.
    fn solve(&self, mut right: Vec<f64>) -> Vec<f64> {
        for (i, row) in self.0.iter().enumerate() {
            right[i] = (right[i] - dot(&row[..i], &right[..i])) / row[i];
        }
        for (i, row) in self.0.iter().enumerate().rev() {
            right[i] /= row[i];
            let value = right[i];
            right.iter_mut().zip(&row[..i]).for_each(|(entry, factor)| *entry -= value * factor);
        }
        right
    }
}

/// Σaᵢbᵢ, in eight sums that do not wait for each other.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    const LANES: usize = 8;
    let (one, other) = (a.chunks_exact(LANES), b.chunks_exact(LANES));
    let rest: f64 = one.remainder().iter().zip(other.remainder()).map(|(x, y)| x * y).sum();
    let mut sums = [0.0; LANES];
    for (x, y) in one.zip(other) {
        for lane in 0..LANES {
            sums[lane] += x[lane] * y[lane];
        }
    }
    sums.iter().sum::<f64>() + rest
}
