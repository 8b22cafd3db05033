//! Guarded root finding: Brent's method on a bracket.
//!
//! # Examples
//! ```
//! use springbed::numerics::root::{self, RootError};
//!
//! let edge = root::brent(|x: f64| x * x - 2.0, 1.0, 2.0)?;
//! assert!((edge - 2f64.sqrt()).abs() < 1e-15);
//! assert!(root::brent(|x: f64| x * x + 1.0, 0.0, 1.0).is_err());
//! # Ok::<(), RootError>(())
//! ```

/// Why no root was found.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum RootError {
    /// The function has the same sign at both ends of the bracket.
    #[error("no sign change between {low:e} and {high:e}")]
    NoSignChange {
        /// Lower end of the bracket.
        low: f64,
        /// Upper end of the bracket.
        high: f64,
    },
    /// The function gave NaN inside the bracket.
    #[error("the function has no value at {at:e}")]
    NotANumber {
        /// Where.
        at: f64,
    },
}

/// The root of a continuous function in `[low, high]`, to the last bits of the argument.
///
/// Brent's method (Brent 1973, ch. 4): inverse quadratic interpolation guarded by bisection, in
/// practice 6 to 12 evaluations. The tolerance is two units in the last place of the root:
/// nothing finer can be told apart.
///
/// # Errors
/// The ends have the same sign, or the function gave NaN.
pub fn brent(mut function: impl FnMut(f64) -> f64, low: f64, high: f64) -> Result<f64, RootError> {
    let ends = [low, high].map(|x| (x, function(x)));
    brent_from(function, ends, 0.0)
}

/// The same between two ends `(argument, value)` that are known, to the part `relative` of the root where that is more than
/// the last bits.
///
/// # Errors
/// As [`brent`].
pub fn brent_from(
    mut function: impl FnMut(f64) -> f64,
    [(low, at_low), (high, at_high)]: [(f64, f64); 2],
    relative: f64,
) -> Result<f64, RootError> {
    let mut counter = Evaluation::known(low, at_low)?;
    let mut best = Evaluation::known(high, at_high)?;
    if counter.is_root() || best.is_root() {
        return Ok(if best.is_root() { best.x } else { counter.x });
    }
    if best.same_side(counter) {
        return Err(RootError::NoSignChange { low, high });
    }
    let mut last = counter;
    let (mut step, mut step_before) = (best.x - last.x, best.x - last.x);
    for _ in 0..MOST_EVALUATIONS {
        if best.same_side(counter) {
            counter = last;
            (step, step_before) = (best.x - last.x, best.x - last.x);
        }
        if counter.y.abs() < best.y.abs() {
            (last, best, counter) = (best, counter, best);
        }
        let tolerance = relative.max(2.0 * f64::EPSILON) * best.x.abs() + f64::MIN_POSITIVE;
        let half = 0.5 * (counter.x - best.x);
        if half.abs() <= tolerance || best.is_root() {
            break;
        }
        (step, step_before) = next_step((last, best, counter), (step, step_before), tolerance);
        last = best;
        let moved = if step.abs() > tolerance { step } else { tolerance.copysign(half) };
        let x = best.x + moved;
        best = Evaluation::known(x, function(x))?;
    }
    Ok(best.x)
}

/// More than any bracket of finite numbers needs: 2100 halvings span all of `f64`.
const MOST_EVALUATIONS: usize = 2200;

#[derive(Clone, Copy)]
struct Evaluation {
    x: f64,
    y: f64,
}

impl Evaluation {
    fn known(x: f64, y: f64) -> Result<Self, RootError> {
        if y.is_nan() { Err(RootError::NotANumber { at: x }) } else { Ok(Self { x, y }) }
    }

    fn is_root(self) -> bool {
        self.y.abs() <= 0.0
    }

    fn same_side(self, other: Self) -> bool {
        (self.y > 0.0) == (other.y > 0.0)
    }
}

/// The next step and the one before it: interpolation where it stays inside and shrinks fast
/// enough, bisection elsewhere.
fn next_step(points: (Evaluation, Evaluation, Evaluation), steps: (f64, f64), tolerance: f64) -> (f64, f64) {
    let (_, best, counter) = points;
    let half = 0.5 * (counter.x - best.x);
    match interpolated(points) {
        Some(trial)
            if steps.1.abs() >= tolerance
                && trial * half > 0.0
                && trial.abs() < 1.5 * half.abs()
                && trial.abs() < 0.5 * steps.1.abs() =>
        {
            (trial, steps.0)
        }
        _ => (half, half),
    }
}

/// Step from the best point by the secant or by inverse quadratic interpolation.
fn interpolated((last, best, counter): (Evaluation, Evaluation, Evaluation)) -> Option<f64> {
    let s = best.y / last.y;
    if !s.is_finite() || s.abs() >= 1.0 {
        return None;
    }
    let gap = counter.x - best.x;
    let (p, q) = if (last.x - counter.x).abs() <= 0.0 {
        (gap * s, 1.0 - s)
    } else {
        let (q, r) = (last.y / counter.y, best.y / counter.y);
        (s * (gap * q * (q - r) - (best.x - last.x) * (r - 1.0)), (q - 1.0) * (r - 1.0) * (s - 1.0))
    };
    let trial = -p / q;
    trial.is_finite().then_some(trial)
}

/// Brackets the first sign change of a function negative at `low`, by doubling `high` up to `limit`.
///
/// `None` if the function is still negative at `limit`.
pub fn bracket_upwards(mut function: impl FnMut(f64) -> f64, low: f64, high: f64, limit: f64) -> Option<(f64, f64)> {
    let (mut low, mut high) = (low, high.min(limit));
    while function(high) < 0.0 {
        if high >= limit {
            return None;
        }
        (low, high) = (high, (2.0 * high).min(limit));
    }
    Some((low, high))
}

/// The root of a growing function known to lie in `[low, high]` up to rounding.
///
/// Where rounding hides the change of sign the root is one of the ends to the last bits.
pub fn within(mut function: impl FnMut(f64) -> f64, low: f64, high: f64) -> f64 {
    brent(&mut function, low, high).unwrap_or_else(|_| if function(low) > 0.0 { low } else { high })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn no_sign_change_is_an_error() {
        assert!(matches!(brent(|x| x * x + 1.0, -1.0, 1.0), Err(RootError::NoSignChange { .. })));
        assert!(matches!(brent(|_| f64::NAN, -1.0, 1.0), Err(RootError::NotANumber { .. })));
    }

    #[test]
    fn a_smooth_root_takes_few_evaluations() {
        let mut count = 0;
        let function = |x: f64| {
            count += 1;
            x * x - 2.0
        };
        let root = brent(function, 0.0, 2.0).unwrap();
        assert!((root - 2f64.sqrt()).abs() <= 4.0 * f64::EPSILON);
        assert!(count <= 12, "{count}");
    }

    proptest! {
        /// x^n = c over 60 decades: bisection guards the flat and the steep alike.
        #[test]
        fn powers_over_sixty_decades(k in -300i32..300, n in 1i32..12) {
            let c = 10f64.powf(f64::from(k) * 0.1);
            let root = brent(|x| x.powi(n) - c, 0.0, 1e31).unwrap();
            prop_assert!((root / c.powf(1.0 / f64::from(n)) - 1.0).abs() < 1e-13);
        }
    }
}
