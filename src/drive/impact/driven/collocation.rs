//! Collocation at Radau's points, with integrals that fade exactly.

use std::array::from_fn;
use std::sync::LazyLock;

/// Points of a step at which m d̈ = −F holds.
pub const NODES: usize = 5;
/// Coefficients of a velocity, and of a function given at the beginning and at the points.
pub const TERMS: usize = NODES + 1;

/// Radau's right points on [0, 1]: zeros of P₅ − P₄ (Hairer & Wanner 1996, ch. IV.5).
pub const RADAU: [f64; NODES] =
    [0.057_104_196_114_517_68, 0.276_843_013_638_123_8, 0.583_590_432_368_916_8, 0.860_240_135_656_219_5, 1.0];

/// Polynomial in θ by its coefficients, the constant first.
pub type Polynomial = [f64; TERMS];

/// Coefficients of the polynomials that are one at one of the points and zero at the others.
static CARDINAL: LazyLock<[[f64; NODES]; NODES]> = LazyLock::new(|| cardinal(&RADAU));
/// The same with the beginning of the step as one more point.
static CARDINAL_FROM_START: LazyLock<[[f64; TERMS]; TERMS]> =
    LazyLock::new(|| cardinal(&from_fn(|k| if k == 0 { 0.0 } else { RADAU[k - 1] })));

/// Row k: coefficients of Π (θ − cⱼ)/(cₖ − cⱼ), j ≠ k.
fn cardinal<const N: usize>(points: &[f64; N]) -> [[f64; N]; N] {
    from_fn(|k| {
        let mut product = [0.0; N];
        product[0] = 1.0;
        for j in (0..N).filter(|&j| j != k) {
            let scale = points[k] - points[j];
            for p in (0..N).rev() {
                let below = if p > 0 { product[p - 1] } else { 0.0 };
                product[p] = (below - points[j] * product[p]) / scale;
            }
        }
        product
    })
}

/// The acceleration through values at the points; the last coefficient is zero.
pub fn through_nodes(values: &[f64; NODES]) -> Polynomial {
    from_fn(|p| if p < NODES { (0..NODES).map(|k| values[k] * CARDINAL[k][p]).sum() } else { 0.0 })
}

/// The polynomial through values at the beginning and at the points.
pub fn through_all(start: f64, values: &[f64; NODES]) -> Polynomial {
    let value = |k: usize| if k == 0 { start } else { values[k - 1] };
    from_fn(|p| (0..TERMS).map(|k| value(k) * CARDINAL_FROM_START[k][p]).sum())
}

/// Value at θ.
pub fn value(polynomial: &Polynomial, theta: f64) -> f64 {
    polynomial.iter().rev().fold(0.0, |sum, c| sum * theta + c)
}

/// ∫₀^θ.
pub fn integral(polynomial: &Polynomial, theta: f64) -> f64 {
    let scaled: Polynomial = from_fn(|p| polynomial[p] / (p + 1) as f64);
    theta * value(&scaled, theta)
}

/// Derivative at θ.
pub fn slope(polynomial: &Polynomial, theta: f64) -> f64 {
    (1..TERMS).rev().fold(0.0, |sum, p| sum * theta + p as f64 * polynomial[p])
}

/// Derivative in time of a polynomial over a step `span` [s].
pub fn rate(polynomial: &Polynomial, span: f64) -> Polynomial {
    from_fn(|p| polynomial.get(p + 1).map_or(0.0, |next| (p + 1) as f64 * next / span))
}

/// ∂(∫₀^θ)/∂(value at node k) for the acceleration: the coefficient p of the velocity, per node.
pub fn velocity_of_node(k: usize, p: usize) -> f64 {
    if p == 0 { 0.0 } else { CARDINAL[k][p - 1] / p as f64 }
}

/// What is left of a fading quantity after θ, and what a motion has added to it.
#[derive(Debug, Clone, Copy)]
pub struct Fading {
    /// e^(−zθ).
    pub kept: f64,
    /// ∫₀^θ e^(−z(θ−σ)) σᵖ dσ.
    pub gained: [f64; TERMS],
}

impl Fading {
    /// `z` is the step over the relaxation time. Both recurrences run in their stable direction.
    pub fn new(z: f64, theta: f64) -> Self {
        let x = z * theta;
        let kept = (-x).exp();
        let mut gained = [0.0; TERMS];
        if x > 2.0 {
            gained[0] = (1.0 - kept) / z;
            let mut power = 1.0;
            for p in 1..TERMS {
                power *= theta;
                gained[p] = (power - p as f64 * gained[p - 1]) / z;
            }
            return Self { kept, gained };
        }
        // Σ xᵏ/(k! (p+k+1)) e^(−x), then downwards.
        let (mut term, mut sum) = (1.0, 0.0);
        for k in 0..24 {
            let part = term / (TERMS + k) as f64;
            sum += part;
            if part < 1e-17 * sum {
                break;
            }
            term *= x / (k + 1) as f64;
        }
        let powers: [f64; TERMS + 1] = from_fn(|p| theta.powi(i32::try_from(p).unwrap_or(0)));
        gained[TERMS - 1] = powers[TERMS] * kept * sum;
        for p in (1..TERMS).rev() {
            gained[p - 1] = (powers[p] - z * gained[p]) / p as f64;
        }
        Self { kept, gained }
    }

    /// What a motion whose rate is `polynomial` adds, per unit of time in steps.
    pub fn gain(&self, polynomial: &Polynomial) -> f64 {
        self.gained.iter().zip(polynomial).map(|(m, c)| m * c).sum()
    }
}

/// Solves a small linear system by elimination with row pivots.
pub fn solved(mut matrix: [[f64; NODES]; NODES], mut right: [f64; NODES]) -> [f64; NODES] {
    for k in 0..NODES {
        let pivot = (k..NODES).max_by(|&i, &j| matrix[i][k].abs().total_cmp(&matrix[j][k].abs())).unwrap_or(k);
        matrix.swap(k, pivot);
        right.swap(k, pivot);
        for i in k + 1..NODES {
            let factor = matrix[i][k] / matrix[k][k];
            let row = matrix[k];
            (k..NODES).for_each(|j| matrix[i][j] -= factor * row[j]);
            right[i] -= factor * right[k];
        }
    }
    for k in (0..NODES).rev() {
        let known: f64 = (k + 1..NODES).map(|j| matrix[k][j] * right[j]).sum();
        right[k] = (right[k] - known) / matrix[k][k];
    }
    right
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::quadrature;
    use proptest::prelude::*;

    /// P₅ − P₄ vanishes at the points; bound: the digits they are given with.
    #[test]
    fn points_are_radaus() {
        for c in RADAU {
            let x: f64 = 2.0 * c - 1.0;
            let (p4, p5) =
                ((35.0 * x.powi(4) - 30.0 * x * x + 3.0) / 8.0, (63.0 * x.powi(5) - 70.0 * x.powi(3) + 15.0 * x) / 8.0);
            assert!((p5 - p4).abs() < 1e-14, "{c}");
        }
    }

    #[test]
    fn polynomials_pass_through_their_points() {
        let values = [1.0, -2.0, 3.0, 0.5, 7.0];
        let (nodes, all) = (through_nodes(&values), through_all(4.0, &values));
        for (c, v) in RADAU.iter().zip(values) {
            assert!((value(&nodes, *c) - v).abs() < 1e-12 && (value(&all, *c) - v).abs() < 1e-12);
        }
        assert!((value(&all, 0.0) - 4.0).abs() < 1e-12);
        assert!((integral(&all, 0.7) - quadrature::panel(|t| value(&all, t), 0.0, 0.7)).abs() < 1e-12);
    }

    proptest! {
        /// Against quadrature; bound: rounding of both. Beyond z = 30 only the last stretch counts.
        #[test]
        fn fading_integrals(k in -150i32..150, part in 1i32..100) {
            let (z, theta) = (10f64.powf(0.1 * f64::from(k)), 0.01 * f64::from(part));
            let fading = Fading::new(z, theta);
            let reach = theta.min(40.0 / z);
            for p in 0..6 {
                let at = |back: f64| (-z * back).exp() * (theta - back).powi(p);
                let exact = quadrature::panel(at, 0.0, 0.5 * reach) + quadrature::panel(at, 0.5 * reach, reach);
                prop_assert!((fading.gained[p as usize] / exact - 1.0).abs() < 1e-12, "{p}");
            }
        }
    }
}
