//! Exponentials that fade, and what is left of them near zero, to full relative accuracy.
//!
//! # Examples
//! ```
//! use springbed::numerics::exponential::{decay, square_remainder};
//!
//! let (kept, lost) = decay(1e-20);
//! assert_eq!((kept, lost), (1.0, 1e-20));
//! // y − (1 − e^(−y)) = y²/2 − y³/6 + …
//! assert!((square_remainder(1e-6, decay(1e-6).1) / (0.5e-12 - 1e-18 / 6.0 + 1e-24 / 24.0) - 1.0).abs() < 1e-14);
//! ```

/// e^(−y) and 1 − e^(−y), both to full relative accuracy near y = 0.
#[must_use]
pub fn decay(y: f64) -> (f64, f64) {
    if y > 0.5 {
        let e = (-y).exp();
        return (e, 1.0 - e);
    }
    let lost = -(-y).exp_m1();
    (1.0 - lost, lost)
}

/// y − a with a = 1 − e^(−y): Σ aᵏ/k from k = 2.
#[must_use]
pub fn square_remainder(y: f64, a: f64) -> f64 {
    if a > 0.3 { y - a } else { tail(a, 2) }
}

/// y − a − a²/2 with a = 1 − e^(−y): Σ aᵏ/k from k = 3.
#[must_use]
pub fn cubic_remainder(y: f64, a: f64) -> f64 {
    if a > 0.3 { y - a - 0.5 * a * a } else { tail(a, 3) }
}

/// Σ aᵏ/k from k = `first`; 32 terms leave 0.3³² < 1e-16, sixteen 0.08¹⁶, ten 0.018¹⁰, six 0.001⁶.
fn tail(a: f64, first: u8) -> f64 {
    let terms = match a {
        ..=0.001 => 6,
        ..=0.018 => 10,
        ..=0.08 => 16,
        _ => 32,
    };
    let sum = (first..first + terms).rev().fold(0.0, |sum, k| sum * a + f64::from(k).recip());
    sum * a.powi(i32::from(first))
}
