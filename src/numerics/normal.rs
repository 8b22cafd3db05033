//! The normal distribution below a bound, and its repeated integrals.
//!
//! # Examples
//! ```
//! use springbed::numerics::normal::{Below, density};
//!
//! // Half of all lies below the mean, on average 1/√(2π) below it.
//! let half = Below::of(0.0);
//! assert!((half.share - 0.5).abs() < 1e-16);
//! assert!((half.first - density(0.0)).abs() < 1e-16);
//! ```

use std::f64::consts::{FRAC_1_SQRT_2, TAU};

/// Density φ(t) = e^{−t²/2}/√(2π) of the normal distribution.
#[must_use]
pub fn density(t: f64) -> f64 {
    (-0.5 * t * t).exp() / TAU.sqrt()
}

/// The part of a normal distribution below t, with its moments about t.
///
/// ∫_{−∞}^t (t − z)ⁿ φ(z) dz for n = 0, 1, 2: Φ, φ + tΦ and (1 + t²)Φ + tφ. Below t = −2, where these cancel, from the
/// continued fraction of their ratios (the minimal solution of m_{n+1} = n m_{n−1} + t m_n, taken backwards).
/// By hand: t = 0 gives ½, 1/√(2π), ½. Relative error below 1e-14 for t ≥ −8.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Below {
    /// The share Φ(t).
    pub share: f64,
    /// First moment ∫ (t − z) φ dz.
    pub first: f64,
    /// Second moment ∫ (t − z)² φ dz.
    pub second: f64,
}

/// Below this bound the closed forms cancel.
const DEEP: f64 = -2.0;
/// Terms of the continued fraction: at t = −2 the last one counts for less than rounding.
const TERMS: u32 = 160;

impl Below {
    /// The part below `t`.
    #[must_use]
    pub fn of(t: f64) -> Self {
        let phi = density(t);
        if t >= DEEP {
            let share = 0.5 * libm::erfc(-t * FRAC_1_SQRT_2);
            return Self { share, first: phi + t * share, second: (1.0 + t * t) * share + t * phi };
        }
        // r_n = m_n/m_{n−1} = n/(|t| + r_{n+1}); m₁ = 1 − |t| m₀ closes it.
        let ratio = |after: f64, n: u32| f64::from(n) / (after - t);
        let second = (3..TERMS).rev().fold(0.0, ratio);
        let (second, first) = (ratio(second, 2), ratio(ratio(second, 2), 1));
        let share = phi / (first - t);
        Self { share, first: share * first, second: share * first * second }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::quadrature;
    use proptest::prelude::*;

    proptest! {
        /// The moments are the sums of positive terms that they stand for.
        #[test]
        fn moments_are_their_integrals(k in -160i32..80) {
            let t = 0.05 * f64::from(k);
            let below = Below::of(t);
            let moment = |n: i32| quadrature::equal_panels(|s| s.powi(n) * density(t - s), (0.0, t.max(0.0) + 12.0), 0.5);
            for (n, found) in [(0, below.share), (1, below.first), (2, below.second)] {
                prop_assert!((found / moment(n) - 1.0).abs() < 3e-14, "{n} at {t}: {found} {}", moment(n));
            }
        }
    }

    /// Both ways meet where one is left for the other.
    #[test]
    fn closed_forms_and_fraction_meet() {
        let (one, other) = (Below::of(DEEP), Below::of(DEEP * (1.0 + 1e-15)));
        for (one, other) in [(one.share, other.share), (one.first, other.first), (one.second, other.second)] {
            assert!((one / other - 1.0).abs() < 3e-14, "{one} {other}");
        }
    }
}
