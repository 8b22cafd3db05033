//! Ting's solution in closed form: a body that relaxes by a power of time, driven in and out at constant speed.
//!
//! # Examples
//! ```
//! use springbed::check::power_law::PowerTriangle;
//!
//! // β = 0.2: t₁ = t − 2^{1.25}(t − T), so that the force is gone at T·2^{1.25}/(2^{1.25} − 1).
//! let triangle = PowerTriangle { scale: 1.0, power: 1.5, exponent: 0.2, speed: 1.0, turn: 1.0 };
//! assert!((triangle.parting() - 1.725_471).abs() < 1e-6);
//! assert!(triangle.force(1.7) > 0.0 && triangle.force(1.73) <= 0.0);
//! ```

use crate::numerics::quadrature;
use libm::tgamma;

/// An indenter F = C E* dⁿ driven to v·T and back at one speed into E*(t) = t^{−β}: d = v·min(t, 2T − t).
///
/// F(t) = C n vⁿ t^{n−β} B(t₁/t; n, 1 − β) with the incomplete beta function B; t₁ = t on the way in (Lee & Radok 1960),
/// and t₁ = t − 2^{1/(1−β)}(t − T) on the way out, from ∫_{t₁}^t E* ḋ ds = 0 (Ting 1966).
/// Of a paraboloid n = 3/2 and C = (4/3)√R, of a cone of the slope m n = 2 and C = 2/(πm).
#[derive(Debug, Clone, Copy)]
pub struct PowerTriangle {
    /// C.
    pub scale: f64,
    /// n.
    pub power: f64,
    /// β.
    pub exponent: f64,
    /// Speed v [m/s].
    pub speed: f64,
    /// Time T of the turn [s].
    pub turn: f64,
}

impl PowerTriangle {
    /// When the force vanishes [s].
    #[must_use]
    pub fn parting(&self) -> f64 {
        let ratio = self.ratio();
        ratio * self.turn / (ratio - 1.0)
    }

    /// 2^{1/(1−β)}.
    fn ratio(&self) -> f64 {
        (1.0 - self.exponent).recip().exp2()
    }

    /// Force at the time `t` [s], of a body of 1 Pa at 1 s [N/Pa].
    #[must_use]
    pub fn force(&self, t: f64) -> f64 {
        let until = if t <= self.turn { t } else { t - self.ratio() * (t - self.turn) };
        if until > 0.0 { self.driven(t, until) } else { 0.0 }
    }

    /// The force at the time `t` of an indenter that has been driven in until the time `until`.
    #[must_use]
    pub fn driven(&self, t: f64, until: f64) -> f64 {
        let Self { scale, power, exponent, speed, .. } = *self;
        scale
            * power
            * speed.powf(power)
            * t.powf(power - exponent)
            * beta((until / t, 1.0 - until / t), power, 1.0 - exponent)
    }
}

/// B(x; a, b) = ∫₀^x u^{a−1}(1 − u)^{b−1} du for x and 1 − x, by the powers of the nearer end as variables.
fn beta((x, rest): (f64, f64), a: f64, b: f64) -> f64 {
    if x > 0.5 {
        return tgamma(a) * tgamma(b) / tgamma(a + b) - if rest > 0.0 { beta((rest, x), b, a) } else { 0.0 };
    }
    quadrature::panel(|v| (1.0 - v.powf(1.0 / a)).powf(b - 1.0), 0.0, x.powf(a)) / a
}
