//! Normal contacts in closed form, written in the half angle or rapidity of the contact and not in the
//! variables of the kernels, so that a test never gets its own formula back.
//!
//! Every function takes lengths in metres and E* = 1 Pa: multiply forces and pressures by E*. The angle
//! of a profile with a kink at the radius b is φ = arccos(b/a).
//!
//! # Examples
//! ```
//! use springbed::check::closed_forms::hertz;
//!
//! // E* = 1: F = (4/3)√R d^{3/2}, a = √(Rd).
//! let ball = hertz(4.0, 1.0);
//! assert_eq!((ball.radius, ball.force), (2.0, 8.0 / 3.0));
//! ```

use std::f64::consts::{FRAC_PI_2, PI};

/// Indentation and force of a contact without adhesion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ClosedForm {
    /// Contact radius a [m].
    pub radius: f64,
    /// Indentation d [m].
    pub indentation: f64,
    /// F/E* [m²].
    pub force: f64,
}

/// Hertz: a² = Rd, F = (4/3)E*√R d^{3/2} (Johnson 1985, eq. 4.22–4.24), from the indentation.
#[must_use]
pub fn hertz(radius: f64, indentation: f64) -> ClosedForm {
    let force = 4.0 / 3.0 * (radius * indentation).sqrt() * indentation;
    ClosedForm { radius: (radius * indentation).sqrt(), indentation, force }
}

/// Pressure p(r)/E* of Hertz: p₀√(1−(r/a)²) with p₀ = 3F/(2πa²).
#[must_use]
pub fn hertz_pressure(radius: f64, indentation: f64, r: f64) -> f64 {
    let contact = hertz(radius, indentation);
    let mean = contact.force / (PI * contact.radius * contact.radius);
    1.5 * mean * (1.0 - (r / contact.radius).powi(2)).max(0.0).sqrt()
}

/// Exact sphere (Sneddon 1965) by the rapidity t = artanh(a/R): d = Rt tanh t,
/// F = E*R²[t(1+tanh² t) − tanh t]; it loses 1/t² digits for small t.
#[must_use]
pub fn sphere(radius: f64, rapidity: f64) -> ClosedForm {
    let s = rapidity.tanh();
    let force = radius * radius * (rapidity * (1.0 + s * s) - s);
    ClosedForm { radius: radius * s, indentation: radius * rapidity * s, force }
}

/// Exact sphere by its power series, F = E*R² Σ 4k/(4k²−1) (a/R)^{2k+1}, for a/R ≤ 0.6.
#[must_use]
pub fn sphere_force_series(radius: f64, a: f64) -> f64 {
    let s = a / radius;
    let term = |k: i32| 4.0 * f64::from(k) / (4.0 * f64::from(k * k) - 1.0) * s.powi(2 * k + 1);
    radius * radius * (1..45).rev().map(term).sum::<f64>()
}

/// Cone of slope t, from the indentation: F = (2/π)E*d²/t (Sneddon 1965).
#[must_use]
pub fn cone(slope: f64, indentation: f64) -> ClosedForm {
    let radius = indentation / (FRAC_PI_2 * slope);
    ClosedForm { radius, indentation, force: indentation * indentation / (FRAC_PI_2 * slope) }
}

/// Pressure p(r)/E* under a cone: (t/2) ln[a/r + √((a/r)²−1)] (Love 1939).
#[must_use]
pub fn cone_pressure(slope: f64, a: f64, r: f64) -> f64 {
    0.5 * slope * (a / r + ((a / r).powi(2) - 1.0).sqrt()).ln()
}

/// Power law f = c rⁿ (Galin 1946): F = 2n/(n+1) E*da, with the Beta function in place of κₙ:
/// d = (n/2) B(n/2, ½) c aⁿ.
#[must_use]
pub fn power(coefficient: f64, exponent: f64, a: f64) -> ClosedForm {
    let half = 0.5 * exponent;
    let beta = (libm::lgamma(half) + 0.5 * PI.ln() - libm::lgamma(half + 0.5)).exp();
    let indentation = half * beta * coefficient * a.powf(exponent);
    ClosedForm { radius: a, indentation, force: 2.0 * indentation * a / (1.0 + 1.0 / exponent) }
}

/// Flat punch of radius b: F = 2E*bd (Boussinesq 1885).
#[must_use]
pub fn flat_punch(radius: f64, indentation: f64) -> ClosedForm {
    ClosedForm { radius, indentation, force: 2.0 * radius * indentation }
}

/// Truncated cone: d = taφ, F = E*ta²(φ + sin φ cos φ), a = b/cos φ (Popov, Heß & Willert 2019, ch. 2).
#[must_use]
pub fn truncated_cone(flat_radius: f64, slope: f64, angle: f64) -> ClosedForm {
    let (sine, cosine) = angle.sin_cos();
    let radius = flat_radius / cosine;
    ClosedForm { radius, indentation: slope * radius * angle, force: slope * radius * radius * (angle + sine * cosine) }
}

/// Truncated paraboloid: d = a² sin φ/R, F = (2E*a³/3R)(2 + cos² φ) sin φ (Popov, Heß & Willert 2019, ch. 2).
#[must_use]
pub fn truncated_paraboloid(flat_radius: f64, curvature: f64, angle: f64) -> ClosedForm {
    let (sine, cosine) = angle.sin_cos();
    let radius = flat_radius / cosine;
    let force = 2.0 / 3.0 * radius.powi(3) / curvature * (2.0 + cosine * cosine) * sine;
    ClosedForm { radius, indentation: radius * radius * sine / curvature, force }
}

/// Rounded punch: d = (a²/R)(sin φ − φ cos φ), F = (E*a³/3R)[(4 − cos² φ) sin φ − 3φ cos φ]
/// (Popov, Heß & Willert 2019, ch. 2).
#[must_use]
pub fn rounded_punch(flat_radius: f64, edge_radius: f64, angle: f64) -> ClosedForm {
    let (sine, cosine) = angle.sin_cos();
    let radius = flat_radius / cosine;
    let indentation = radius * radius / edge_radius * (sine - angle * cosine);
    let bracket = (4.0 - cosine * cosine) * sine - 3.0 * angle * cosine;
    ClosedForm { radius, indentation, force: radius.powi(3) / (3.0 * edge_radius) * bracket }
}

/// Rounded cone beyond its blend b = Rt: d = ta[φ + (1 − sin φ)/cos φ],
/// F = E*ta²[φ + (4/3)(1 − sin³ φ)/cos φ − sin φ cos φ] (Popov, Heß & Willert 2019, ch. 2).
#[must_use]
pub fn rounded_cone(tip_radius: f64, slope: f64, angle: f64) -> ClosedForm {
    let (sine, cosine) = angle.sin_cos();
    let radius = tip_radius * slope / cosine;
    let bracket = angle + 4.0 / 3.0 * (1.0 - sine.powi(3)) / cosine - sine * cosine;
    let indentation = slope * radius * (angle + (1.0 - sine) / cosine);
    ClosedForm { radius, indentation, force: slope * radius * radius * bracket }
}
