//! Smooth functions as sums of Chebyshev polynomials.
//!
//! # Examples
//! ```
//! use springbed::numerics::chebyshev::Chebyshev;
//!
//! let nodes: Vec<f64> = Chebyshev::nodes(20, (1.0, 2.0)).collect();
//! let root = Chebyshev::through(&nodes.iter().map(|x| x.sqrt()).collect::<Vec<_>>(), (1.0, 2.0));
//! assert!((root.at(1.3) - 1.3f64.sqrt()).abs() < 1e-15);
//! assert!((root.with_slope(1.3).1 - 0.5 / 1.3f64.sqrt()).abs() < 1e-13);
//! ```

use std::f64::consts::PI;

/// Σ cₙTₙ(t) over an interval, t from −1 to 1.
#[derive(Debug, Clone, PartialEq)]
pub struct Chebyshev {
    middle: f64,
    half: f64,
    coefficients: Vec<f64>,
}

impl Chebyshev {
    /// The `count` nodes in the interval, ascending: cos((k + ½)π/n).
    pub fn nodes(count: usize, (low, high): (f64, f64)) -> impl Iterator<Item = f64> {
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
        (0..count).map(move |k| middle - half * (PI * (k as f64 + 0.5) / count as f64).cos())
    }

    /// The polynomial through `values` at the [`nodes`](Self::nodes) of the interval.
    #[must_use]
    pub fn through(values: &[f64], (low, high): (f64, f64)) -> Self {
        let count = values.len() as f64;
        let coefficient = |n: usize| {
            let angle = |k: usize| PI * (1.0 - (k as f64 + 0.5) / count) * n as f64;
            let sum: f64 = values.iter().enumerate().map(|(k, value)| value * angle(k).cos()).sum();
            sum * if n == 0 { 1.0 } else { 2.0 } / count
        };
        let coefficients = (0..values.len()).map(coefficient).collect();
        Self { middle: 0.5 * (low + high), half: 0.5 * (high - low), coefficients }
    }

    /// The polynomial through `function` at `count` nodes.
    #[must_use]
    pub fn of(function: impl FnMut(f64) -> f64, count: usize, interval: (f64, f64)) -> Self {
        let values: Vec<f64> = Self::nodes(count, interval).map(function).collect();
        Self::through(&values, interval)
    }

    /// Its value at `x`, by Clenshaw's sum.
    #[must_use]
    pub fn at(&self, x: f64) -> f64 {
        let t = (x - self.middle) / self.half;
        let (mut next, mut beyond) = (0.0, 0.0);
        let Some((first, rest)) = self.coefficients.split_first() else { return 0.0 };
        for c in rest.iter().rev() {
            (next, beyond) = (2.0 * t * next - beyond + c, next);
        }
        t * next - beyond + first
    }

    /// Its value and its slope at `x`.
    #[must_use]
    pub fn with_slope(&self, x: f64) -> (f64, f64) {
        let t = (x - self.middle) / self.half;
        let (mut next, mut beyond, mut slope, mut slope_beyond) = (0.0, 0.0, 0.0, 0.0);
        let Some((first, rest)) = self.coefficients.split_first() else { return (0.0, 0.0) };
        for c in rest.iter().rev() {
            (slope, slope_beyond) = (2.0 * t * slope + 2.0 * next - slope_beyond, slope);
            (next, beyond) = (2.0 * t * next - beyond + c, next);
        }
        (t * next - beyond + first, (t * slope + next - slope_beyond) / self.half)
    }

    /// What its last coefficients are of its largest: about the relative error of a function that is not yet resolved.
    #[must_use]
    pub fn unresolved(&self) -> f64 {
        let largest = self.coefficients.iter().fold(0.0f64, |most, c| most.max(c.abs()));
        let last = self.coefficients.iter().rev().take(3).fold(0.0f64, |most, c| most.max(c.abs()));
        if largest > 0.0 { last / largest } else { 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Polynomials of lower degree are met at every place, with their slope.
        #[test]
        fn polynomials_are_met(coefficients in prop::collection::vec(-9i32..9, 1..9), k in 0i32..=100, shift in -5i32..5) {
            let low = f64::from(shift);
            let (value, slope) = (
                |x: f64| coefficients.iter().rev().fold(0.0, |sum, &c| sum * (x - low) + f64::from(c)),
                |x: f64| {
                    let powers = coefficients.iter().enumerate().skip(1);
                    powers.map(|(n, &c)| f64::from(c) * n as f64 * (x - low).powi(n as i32 - 1)).sum::<f64>()
                },
            );
            let met = Chebyshev::of(value, 9, (low, low + 2.0));
            let x = low + 0.02 * f64::from(k);
            let (found, steep) = met.with_slope(x);
            // Coefficients below 9 over [0, 2]: at most 9·2⁹, and n² times that for the slope.
            prop_assert!((found - value(x)).abs() < 1e-11 && (met.at(x) - found).abs() < 1e-11);
            prop_assert!((steep - slope(x)).abs() < 1e-9);
        }
    }
}
