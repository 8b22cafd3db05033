//! Functions as polynomials, piece by piece.
//!
//! # Examples
//! ```
//! use springbed::numerics::chebyshev;
//!
//! // A root at the end asks for pieces that shrink towards it.
//! let pieces = chebyshev::pieces(f64::sqrt, &[0.0, 1.0], 1e-10, 100);
//! let piece = pieces.iter().find(|piece| piece.high() >= 0.01).unwrap();
//! assert!((piece.at(0.01) - 0.1).abs() < 1e-8 && pieces.len() > 10);
//! // A straight line is one piece of the degree one.
//! assert_eq!(chebyshev::pieces(|x| 1.0 + x, &[0.0, 1.0], 1e-10, 100)[0].degree(), 1);
//! ```

use std::f64::consts::PI;
use std::sync::LazyLock;

/// Places at which a function is read: degree 11, enough for a smooth piece, few enough to be summed at every node.
const NODES: usize = 12;

/// cos(kπ(j+½)/n) for all k, j.
static COSINES: LazyLock<[[f64; NODES]; NODES]> = LazyLock::new(|| {
    let angle = |k: usize, j: usize| k as f64 * PI * (j as f64 + 0.5) / NODES as f64;
    std::array::from_fn(|k| std::array::from_fn(|j| libm::cos(angle(k, j))))
});

/// A polynomial Σ c_k T_k on an interval.
#[derive(Debug, Clone, PartialEq)]
pub struct Chebyshev {
    middle: f64,
    half: f64,
    coefficients: Vec<f64>,
}

impl Chebyshev {
    /// The polynomial through `f` at the Chebyshev nodes of `[low, high]`, none of which is an end.
    pub fn through(mut f: impl FnMut(f64) -> f64, low: f64, high: f64) -> Self {
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
        let values: [f64; NODES] = std::array::from_fn(|j| f(middle + half * COSINES[1][j]));
        let coefficient = |k: usize| {
            let sum: f64 = COSINES[k].iter().zip(values).map(|(cosine, value)| cosine * value).sum();
            if k == 0 { sum / NODES as f64 } else { 2.0 * sum / NODES as f64 }
        };
        Self { middle, half, coefficients: (0..NODES).map(coefficient).collect() }
    }

    /// The `count` nodes in the interval, ascending: cos((k + ½)π/n), none of which is an end.
    pub fn nodes(count: usize, (low, high): (f64, f64)) -> impl Iterator<Item = f64> {
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
        (0..count).map(move |k| middle - half * libm::cos(PI * (k as f64 + 0.5) / count as f64))
    }

    /// The polynomial through `values` at the [`nodes`](Self::nodes) of the interval.
    #[must_use]
    pub fn met(values: &[f64], (low, high): (f64, f64)) -> Self {
        let count = values.len();
        // All angles are multiples of π/2n.
        let cosines: Vec<f64> = (0..4 * count).map(|k| libm::cos(0.5 * PI * k as f64 / count as f64)).collect();
        let coefficient = |n: usize| {
            let cosine = |k: usize| cosines[(n * (2 * (count - k) - 1)) % (4 * count)];
            let sum: f64 = values.iter().enumerate().map(|(k, value)| value * cosine(k)).sum();
            sum * if n == 0 { 1.0 } else { 2.0 } / count as f64
        };
        let coefficients = (0..count).map(coefficient).collect();
        Self { middle: 0.5 * (low + high), half: 0.5 * (high - low), coefficients }
    }

    /// The polynomial through `function` at `count` nodes of the interval.
    #[must_use]
    pub fn of(function: impl FnMut(f64) -> f64, count: usize, interval: (f64, f64)) -> Self {
        let values: Vec<f64> = Self::nodes(count, interval).map(function).collect();
        Self::met(&values, interval)
    }

    /// Lower end of the interval.
    #[must_use]
    pub fn low(&self) -> f64 {
        self.middle - self.half
    }

    /// Upper end of the interval.
    #[must_use]
    pub fn high(&self) -> f64 {
        self.middle + self.half
    }

    /// Degree of the polynomial.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.coefficients.len().saturating_sub(1)
    }

    /// Value at `x` (Clenshaw 1955), even and odd terms apart, two sums that do not wait for each other: T₂ₖ(s) is Tₖ(t),
    /// t = 2s² − 1, and T₂ₖ₊₁(s)/s obeys the same recurrence in t.
    #[must_use]
    pub fn at(&self, x: f64) -> f64 {
        let s = (x - self.middle) / self.half;
        let t = 2.0 * s * s - 1.0;
        let twice = 2.0 * t;
        let (pairs, last) = self.coefficients.as_chunks::<2>();
        let (mut even, mut even_before) = (last.first().copied().unwrap_or(0.0), 0.0);
        let (mut odd, mut odd_before) = (0.0, 0.0);
        for [of_even, of_odd] in pairs.iter().rev() {
            (even, even_before) = ((of_even - even_before) + twice * even, even);
            (odd, odd_before) = ((of_odd - odd_before) + twice * odd, odd);
        }
        (even - t * even_before) + s * (odd - odd_before)
    }

    /// Its value and its slope at `x`.
    #[must_use]
    pub fn with_slope(&self, x: f64) -> (f64, f64) {
        let t = (x - self.middle) / self.half;
        let (mut next, mut beyond, mut slope, mut slope_beyond) = (0.0, 0.0, 0.0, 0.0);
        let Some((first, rest)) = self.coefficients.split_first() else { return (0.0, 0.0) };
        let twice = 2.0 * t;
        for c in rest.iter().rev() {
            (slope, slope_beyond) = ((2.0 * next - slope_beyond) + twice * slope, slope);
            (next, beyond) = ((c - beyond) + twice * next, next);
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

    /// The derivative.
    #[must_use]
    pub fn slope(&self) -> Self {
        let degree = self.degree();
        let mut slopes = vec![0.0; degree.max(1)];
        for k in (1..=degree).rev() {
            let above = slopes.get(k + 1).copied().unwrap_or(0.0);
            slopes[k - 1] = above + 2.0 * k as f64 * self.coefficients[k];
        }
        slopes[0] *= 0.5;
        slopes.iter_mut().for_each(|slope| *slope /= self.half);
        Self { coefficients: slopes, ..*self }
    }

    /// The antiderivative that is `start` at the lower end: ∫T_k = T_{k+1}/2(k+1) − T_{k−1}/2(k−1).
    ///
    /// ```
    /// # use springbed::numerics::chebyshev::Chebyshev;
    /// let sine = Chebyshev::of(f64::cos, 24, (0.0, 1.0)).integral(0.0);
    /// assert!((sine.at(0.5) - 0.5f64.sin()).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn integral(&self, start: f64) -> Self {
        let of = |k: usize| self.coefficients.get(k).copied().unwrap_or(0.0);
        let term = |k: usize| {
            let below = if k == 1 { 2.0 * of(0) } else { of(k - 1) };
            0.5 * self.half * (below - of(k + 1)) / k as f64
        };
        let mut coefficients: Vec<f64> = std::iter::once(0.0).chain((1..=self.coefficients.len()).map(term)).collect();
        // T_k = (−1)^k at the lower end.
        let low: f64 = coefficients.iter().enumerate().map(|(k, c)| if k % 2 == 0 { *c } else { -c }).sum();
        if let Some(first) = coefficients.first_mut() {
            *first = start - low;
        }
        Self { coefficients, ..*self }
    }

    /// Coefficients of the powers of (x − middle)/half, for series that fall off fast.
    #[must_use]
    pub fn powers(&self) -> Vec<f64> {
        let count = self.coefficients.len();
        let (mut sum, mut here, mut next) = (vec![0.0; count], vec![0.0; count], vec![0.0; count]);
        here.iter_mut().take(1).for_each(|one| *one = 1.0);
        next.iter_mut().skip(1).take(1).for_each(|one| *one = 1.0);
        for c in &self.coefficients {
            sum.iter_mut().zip(&here).for_each(|(sum, power)| *sum += c * power);
            let shifted = std::iter::once(0.0).chain(next.iter().map(|power| 2.0 * power));
            let after = shifted.zip(&here).map(|(up, down)| up - down).collect();
            here = std::mem::replace(&mut next, after);
        }
        sum
    }

    /// The same times a number.
    #[must_use]
    pub fn scaled(mut self, factor: f64) -> Self {
        self.coefficients.iter_mut().for_each(|coefficient| *coefficient *= factor);
        self
    }

    /// What the last terms hold: how far it may be from a smooth function.
    fn tail(&self) -> f64 {
        self.coefficients.iter().rev().take(2).map(|coefficient| coefficient.abs()).sum()
    }

    /// The same without the terms at its end that hold no more than `tolerance` together.
    #[must_use]
    pub fn trimmed(mut self, tolerance: f64) -> Self {
        let mut dropped = 0.0;
        while let [_, .., last] = self.coefficients[..] {
            dropped += last.abs();
            if dropped > tolerance {
                break;
            }
            self.coefficients.pop();
        }
        self
    }
}

/// `f` between neighbouring `ends`, ascending, as polynomials whose error times their length is below `tolerance`, as far
/// as `most` pieces suffice: the worst is halved first.
pub fn pieces(mut f: impl FnMut(f64) -> f64, ends: &[f64], tolerance: f64, most: usize) -> Vec<Chebyshev> {
    let whole = ends.windows(2).filter(|pair| pair[1] > pair[0]);
    let mut pieces: Vec<Chebyshev> = whole.map(|pair| Chebyshev::through(&mut f, pair[0], pair[1])).collect();
    let error = |piece: &Chebyshev| piece.tail() * 2.0 * piece.half;
    while pieces.len() < most {
        let worst = (0..pieces.len()).max_by(|&i, &j| error(&pieces[i]).total_cmp(&error(&pieces[j])));
        let Some(worst) = worst.filter(|&worst| error(&pieces[worst]) > tolerance) else { break };
        let (low, middle, high) = (pieces[worst].low(), pieces[worst].middle, pieces[worst].high());
        if middle <= low || middle >= high {
            break;
        }
        let halves = [Chebyshev::through(&mut f, low, middle), Chebyshev::through(&mut f, middle, high)];
        pieces.splice(worst..=worst, halves);
    }
    let allowed = |piece: &Chebyshev| 0.1 * tolerance / (2.0 * piece.half);
    pieces
        .into_iter()
        .map(|piece| {
            let allowed = allowed(&piece);
            piece.trimmed(allowed)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn values_and_slopes_of_smooth_functions() {
        let wave = Chebyshev::through(f64::sin, 0.2, 1.1);
        let slope = wave.slope();
        for x in [0.2, 0.31, 0.77, 1.1] {
            assert!((wave.at(x) - x.sin()).abs() < 1e-14, "{x}");
            assert!((slope.at(x) - x.cos()).abs() < 1e-11, "{x}");
        }
    }

    #[test]
    fn powers_and_integrals_are_the_function() {
        let wave = Chebyshev::of(f64::sin, 16, (0.2, 1.1));
        let (powers, integral) = (wave.powers(), wave.integral(0.0));
        for x in [0.2, 0.31, 0.77, 1.1] {
            let t = (x - 0.65) / 0.45;
            assert!((powers.iter().rev().fold(0.0, |sum, c| sum * t + c) - x.sin()).abs() < 1e-14, "{x}");
            assert!((integral.at(x) - (0.2f64.cos() - x.cos())).abs() < 1e-15, "{x}");
        }
    }

    #[test]
    fn a_corner_costs_no_more_than_allowed() {
        let corner = |x: f64| (x - 0.3).abs();
        assert_eq!(pieces(corner, &[0.0, 1.0], 1e-300, 40).len(), 40);
        assert_eq!(pieces(corner, &[0.0, 0.3, 1.0], 1e-12, 40).len(), 2);
    }

    proptest! {
        /// Polynomials of lower degree are met at every place, with their slope.
        #[test]
        fn polynomials_are_met(coefficients in prop::collection::vec(-9i32..9, 1..9), k in 0i32..=100, shift in -5i32..5) {
            let low = f64::from(shift);
            let (value, slope) = (
                |x: f64| coefficients.iter().rev().fold(0.0, |sum, &c| sum * (x - low) + f64::from(c)),
                |x: f64| {
                    let powers = (0i32..).zip(&coefficients).skip(1);
                    powers.map(|(n, &c)| f64::from(c) * f64::from(n) * (x - low).powi(n - 1)).sum::<f64>()
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
