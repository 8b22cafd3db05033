//! The exact sphere.

use super::kernel::{artanh, artanh_minus_argument, root_of_difference};
use super::{Profile, Rim};
use crate::input::quantity::Length;
use crate::numerics::quadrature;
use serde::{Deserialize, Serialize};

/// Sphere f(r) = R − √(R²−r²) for r < R, g(x) = x artanh(x/R).
///
/// R is the radius [m]. Sneddon's solution (Sneddon 1965; Popov & Heß 2015, ch. 3):
/// d = (a/2) ln((R+a)/(R−a)), F = E*[(R²+a²)/2 · ln((R+a)/(R−a)) − aR]. The half-space it is pressed
/// into keeps its flat boundary conditions, so the gain over the [`Paraboloid`](super::Paraboloid)
/// is that of the shape alone. Check: E* = R = 1, a = 0.6 gives d = 0.4158883083359672.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Sphere {
    /// Radius.
    pub radius: Length,
}

/// Terms of the energy's power series; the first neglected one is below 8^{−20}.
const TERMS: usize = 20;

/// Coefficients eₖ of E/R³ = s⁵ Σ eₖ s^{2k}, from the series of g′ and N.
static ENERGY: [f64; TERMS] = energy_coefficients();

#[expect(clippy::cast_precision_loss, reason = "small whole numbers")]
const fn energy_coefficients() -> [f64; TERMS] {
    let mut sum = [0.0; TERMS];
    let mut k = 1;
    while k <= TERMS {
        let mut l = 1;
        while k + l - 2 < TERMS {
            let (i, j) = (k as f64, l as f64);
            // g′ = Σ 2k/(2k−1) s^{2k−1}, N = Σ 2l/(4l²−1) s^{2l+1}.
            let product = 2.0 * (2.0 * i / (2.0 * i - 1.0)) * (2.0 * j / (4.0 * j * j - 1.0));
            sum[k + l - 2] += product / (2.0 * (i + j) + 1.0);
            l += 1;
        }
        k += 1;
    }
    sum
}

/// N/R² = ½[(1+s²) artanh s − s], arranged as a sum of positive terms.
fn load(s: f64) -> f64 {
    0.5 * (artanh_minus_argument(s) * (1.0 + s * s) + s * s * s)
}

/// E/R³ by the power series, s² ≤ 1/8.
fn energy_near_apex(s: f64) -> f64 {
    s.powi(5) * ENERGY.iter().rev().fold(0.0, |sum, e| sum * (s * s) + e)
}

/// E/R³ = 2∫(t sech² t + tanh t) N(tanh t) dt: with s = tanh t the pole at the equator is gone.
fn energy_by_integral(s: f64) -> f64 {
    let end = artanh(s, 1.0 - s);
    let integrand = |t: f64| {
        let (tanh, cosh) = (t.tanh(), t.cosh());
        2.0 * (t / (cosh * cosh) + tanh) * load(tanh)
    };
    quadrature::equal_panels(integrand, (0.0, end), 2.0)
}

impl Profile for Sphere {
    fn height(&self, r: f64) -> f64 {
        let radius = self.radius.si();
        if r > radius {
            return f64::INFINITY;
        }
        r * (r / (radius + root_of_difference(radius, r)))
    }

    fn reduced(&self, x: f64) -> f64 {
        let radius = self.radius.si();
        if x >= radius { f64::INFINITY } else { x * artanh(x / radius, (radius - x) / radius) }
    }

    fn reduced_slope(&self, x: f64) -> f64 {
        let radius = self.radius.si();
        if x >= radius {
            return f64::INFINITY;
        }
        let (s, rest) = (x / radius, (radius - x) / radius);
        artanh(s, rest) + s / (rest * (1.0 + s))
    }

    fn load_integral(&self, a: f64) -> f64 {
        self.radius.si() * self.radius.si() * load(a / self.radius.si())
    }

    fn energy_integral(&self, a: f64) -> f64 {
        let s = a / self.radius.si();
        let value = if s * s <= 0.125 { energy_near_apex(s) } else { energy_by_integral(s) };
        self.radius.si().powi(3) * value
    }

    fn edge(&self, d: f64) -> Option<f64> {
        let radius = self.radius.si();
        let depth = d.max(0.0) / radius;
        // t tanh t = d/R by Newton from above; a = R tanh t.
        let mut t = (depth * (1.0 + depth)).sqrt();
        for _ in 0..20 {
            let (tanh, cosh) = (t.tanh(), t.cosh());
            let step = (t * tanh - depth) / (tanh + t / (cosh * cosh));
            if step.abs() <= f64::EPSILON * t || step.is_nan() {
                break;
            }
            t -= step;
        }
        let a = radius * t.tanh();
        (a < radius).then_some(a)
    }

    fn rim(&self) -> Rim {
        Rim::End(self.radius.si())
    }

    fn scale(&self) -> f64 {
        self.radius.si()
    }

    fn breaks(&self, a: f64) -> Vec<f64> {
        // Steps in artanh(x/R) keep the pole at the equator away from every panel.
        (1..20).map(|k| self.radius.si() * f64::from(k).tanh()).take_while(|&x| x < a).collect()
    }
}
