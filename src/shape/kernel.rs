//! Elementary combinations that vanish faster than their terms, and integrals beyond a kink.

use crate::numerics::quadrature;
use std::f64::consts::{FRAC_1_PI, FRAC_2_PI};

/// arcosh(a/r) for r ≤ a, without the loss of digits near r = a; infinite at r = 0.
pub(super) fn arcosh_of_ratio(a: f64, r: f64) -> f64 {
    let gap = (a - r) / r;
    (gap + (gap * (gap + 2.0)).sqrt()).ln_1p()
}

/// √(x²−b²) for x ≥ b, factored; 0 below.
pub(super) fn root_of_difference(x: f64, b: f64) -> f64 {
    ((x - b).max(0.0) * (x + b)).sqrt()
}

/// Below this argument the alternating series of the two functions that follow lose no digit.
const SERIES_END: f64 = 1.0;

/// Σ (−1)^k cₖ y^{2k+3}/(2k+3)! with cₖ given by `weight`, to rounding for y ≤ 1.
fn odd_series(y: f64, weight: impl Fn(f64) -> f64) -> f64 {
    let (mut term, mut order) = (y * y * y / 6.0, 3.0);
    let mut sum = 0.0;
    while order < 24.0 {
        sum += weight(order) * term;
        term *= -y * y / ((order + 1.0) * (order + 2.0));
        order += 2.0;
    }
    sum
}

/// y − sin y.
pub(super) fn arc_minus_sine(y: f64) -> f64 {
    if y < SERIES_END { odd_series(y, |_| 1.0) } else { y - y.sin() }
}

/// sin y − y cos y.
pub(super) fn sine_minus_arc_cosine(y: f64) -> f64 {
    if y < SERIES_END { odd_series(y, |order| order - 1.0) } else { y.sin() - y * y.cos() }
}

/// artanh s − s for 0 ≤ s < 1.
pub(super) fn artanh_minus_argument(s: f64) -> f64 {
    if s > 0.5 {
        return artanh(s, 1.0 - s) - s;
    }
    let (mut power, mut odd) = (s * s * s, 3.0);
    let mut sum = 0.0;
    while power > 1e-18 * sum {
        sum += power / odd;
        power *= s * s;
        odd += 2.0;
    }
    sum
}

/// artanh s from s and 1 − s.
pub(super) fn artanh(s: f64, rest: f64) -> f64 {
    0.5 * (2.0 * s / rest).ln_1p()
}

/// Longest panel in the logarithmic variable: the nearest pole, at iπ/2, leaves 1e-18.
const LONGEST_PANEL: f64 = 4.0;
/// Growth by e^{2u} or more makes what lies this far below the upper end negligible (e^{−40}).
const RANGE: f64 = 20.0;

/// The part of a profile beyond a kink at the radius b, where g′(x)√(x²−b²) is smooth in √(x²−b²).
///
/// `slope` is always that product, as a function of x and q = √(x²−b²). All integrals are sums of
/// terms of one sign after a substitution that takes every root away.
#[derive(Debug, Clone, Copy)]
pub(super) struct OutsideKink(pub f64);

impl OutsideKink {
    /// (1/π)∫ g′ dx/√(x²−r²) over x from max(r, b) to a.
    ///
    /// With m = max(r, b), x² = m² + δ² sinh² u and δ² = |r²−b²| both roots become δ sinh u and
    /// δ cosh u, so that dx/(√(x²−r²)√(x²−b²)) = du/x.
    pub(super) fn pressure(self, slope: impl Fn(f64, f64) -> f64, r: f64, a: f64) -> f64 {
        let b = self.0;
        let (inner, outer) = (r.min(b), r.max(b));
        if outer >= a {
            return 0.0;
        }
        let delta = root_of_difference(outer, inner);
        if delta <= 0.0 && slope(b, 0.0) > 0.0 {
            return f64::INFINITY;
        }
        let delta = delta.max(f64::EPSILON * outer);
        let integrand = |u: f64| {
            let sinh = delta * u.sinh();
            let x = outer.hypot(sinh);
            slope(x, if r < b { sinh } else { delta * u.cosh() }) / x
        };
        let end = (root_of_difference(a, outer) / delta).asinh();
        FRAC_1_PI * quadrature::equal_panels(integrand, (0.0, end), LONGEST_PANEL)
    }

    /// (2/π)∫_b^a g′ arcsin(x/r) dx for r ≥ a.
    ///
    /// x² = b² + (r²−b²) sin² ψ takes away the roots at x = b and at x = r.
    pub(super) fn displacement(self, slope: impl Fn(f64, f64) -> f64, r: f64, a: f64) -> f64 {
        let b = self.0;
        let span = root_of_difference(r, b);
        if a <= b || span <= 0.0 {
            return 0.0;
        }
        let integrand = |psi: f64| {
            let (q, to_r) = (span * psi.sin(), span * psi.cos());
            let x = b.hypot(q);
            slope(x, q) * x.atan2(to_r) * to_r / x
        };
        let end = root_of_difference(a, b).atan2(root_of_difference(r, a));
        let first = (2.0 * b / span).max(1e-8);
        let breaks: Vec<f64> =
            std::iter::successors(Some(first), |at| Some(8.0 * at)).take_while(|&at| at < end).collect();
        FRAC_2_PI * quadrature::panels(integrand, (0.0, end), &breaks)
    }

    /// ∫_b^a 2g′N dx, where `load` is N as a function of x and q.
    pub(super) fn energy(self, slope: impl Fn(f64, f64) -> f64, load: impl Fn(f64, f64) -> f64, a: f64) -> f64 {
        let b = self.0;
        if a <= b {
            return 0.0;
        }
        let integrand = |u: f64| {
            let (x, q) = (b * u.cosh(), b * u.sinh());
            2.0 * slope(x, q) * load(x, q)
        };
        let end = (root_of_difference(a, b) / b).asinh();
        quadrature::equal_panels(integrand, ((end - RANGE).max(0.0), end), LONGEST_PANEL)
    }

    /// Places below `a` that resolve the root at b: they close in on b from above and then grow with x.
    ///
    /// A number next to b says x − b to 1e-16 b only, so that a plain quadrature of an inverse root
    /// stays at 1e-8 whatever the panels; the integrals above have no such limit.
    pub(super) fn breaks(self, a: f64) -> Vec<f64> {
        let b = self.0;
        let near = (0..14).rev().map(|k| b * (1.0 + 8f64.powi(-k)));
        let far = std::iter::successors(Some(8.0 * b), |at| Some(8.0 * at));
        std::iter::once(b).chain(near).chain(far.take_while(|&at| at < a)).filter(|&at| at < a).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_keep_their_digits() {
        // Leading terms of the series; the next is smaller by y²/10 or less.
        for k in 1..12 {
            let y = 10f64.powi(-k);
            let next = 0.2 * y * y + 4e-16;
            assert!((arc_minus_sine(y) / (y.powi(3) / 6.0) - 1.0).abs() < next);
            assert!((sine_minus_arc_cosine(y) / (y.powi(3) / 3.0) - 1.0).abs() < next);
            assert!((artanh_minus_argument(y) / (y.powi(3) / 3.0) - 1.0).abs() < 4.0 * next);
        }
    }

    #[test]
    fn the_series_joins_the_closed_form() {
        // y = 1 and s = 1/2 computed with 30 digits.
        let below = |x: f64| x * (1.0 - 1e-16);
        for y in [1.0, below(1.0)] {
            assert!((arc_minus_sine(y) / 0.158_529_015_192_103_5 - 1.0).abs() < 1e-15);
            assert!((sine_minus_arc_cosine(y) / 0.301_168_678_939_756_8 - 1.0).abs() < 1e-15);
        }
        for s in [0.5, 0.500_000_000_000_000_1] {
            assert!((artanh_minus_argument(s) / 0.049_306_144_334_054_85 - 1.0).abs() < 6e-15);
        }
    }
}
