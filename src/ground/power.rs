//! A half-space whose modulus is a power of the depth.

use super::Ground;
use crate::material::Graded;
use crate::numerics::quadrature;
use crate::shape::Profile;
use libm::tgamma;
use std::f64::consts::{FRAC_1_PI, FRAC_PI_2, PI, SQRT_2};

/// E = E₀(z/z₀)ⁿ: springs k′ = 2E*Cxⁿ/z₀ⁿ with E* = E₀/(1−ν²), under
/// d_e(a) = a^(1−n) ∫₀^a f′(r) (a²−r²)^((n−1)/2) dr (Heß 2016).
///
/// In terms of g it is a mean, with the weight 2(1−t²)^(n/2−1)/B(n/2, ½) of g(at), t from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PowerLaw {
    depth: f64,
    exponent: f64,
    constant: f64,
}

impl From<&Graded> for PowerLaw {
    fn from(graded: &Graded) -> Self {
        let exponent = graded.exponent.si();
        Self { depth: graded.depth.si(), exponent, constant: constant(exponent, graded.poisson.si()) }
    }
}

/// The stiffness C over that of a body of the modulus at z₀ throughout, of Booker, Balaam & Davis (1985): 1 for n = 0.
///
/// C = 2(1+n) cos(πn/2) Γ(1+n/2)/(√π Γ((1+n)/2) βB sin(πβ/2)), β² = (1+n)(1 − nν/(1−ν)),
/// B = 2^(1+n) Γ((3+n+β)/2) Γ((3+n−β)/2)/(πΓ(2+n)); the limit of thousands of layers is the same.
fn constant(n: f64, poisson: f64) -> f64 {
    let beta = ((1.0 + n) * (1.0 - n * poisson / (1.0 - poisson))).sqrt();
    let gammas = tgamma(0.5 * (3.0 + n + beta)) * tgamma(0.5 * (3.0 + n - beta)) / tgamma(2.0 + n);
    let factor = (1.0 + n).exp2() * FRAC_1_PI * gammas;
    let shape = tgamma(1.0 + 0.5 * n) / tgamma(0.5 * (1.0 + n));
    2.0 * (1.0 + n) * (FRAC_PI_2 * n).cos() * shape / (PI.sqrt() * beta * factor * (FRAC_PI_2 * beta).sin())
}

/// Panels towards a place where a power of it is no polynomial, each a quarter of the one before.
const TOWARD: i32 = 6;

impl PowerLaw {
    /// Cxⁿ/z₀ⁿ.
    fn stiffness(&self, x: f64) -> f64 {
        self.constant * (x / self.depth).powf(self.exponent)
    }

    /// A z₀^(−n) = cos(πn/2)/(πC) of the displacement A F/(E*r^(1+n)) round a force, which under the pressures of a flat
    /// punch is 1.
    fn round_force(&self) -> f64 {
        FRAC_1_PI * (FRAC_PI_2 * self.exponent).cos() / self.constant
    }

    /// Cz₀^(−n)/π (a²−r²)^((n−1)/2) with (a²−r²)^½ = `root` [1/m].
    fn punch(&self, root: f64) -> f64 {
        FRAC_1_PI * self.stiffness(root) / root
    }
}

impl Ground for PowerLaw {
    fn scale(&self) -> Option<f64> {
        None
    }

    fn end(&self, _profile: &dyn Profile, _asked: f64) -> f64 {
        f64::INFINITY
    }

    fn measure(&self, a: f64) -> f64 {
        self.stiffness(a) * a / (1.0 + self.exponent)
    }

    fn radius(&self, s: f64) -> f64 {
        self.depth * ((1.0 + self.exponent) * s / (self.constant * self.depth)).powf(1.0 / (1.0 + self.exponent))
    }

    fn density(&self, a: f64) -> f64 {
        self.stiffness(a)
    }

    fn per_density(&self, a: f64) -> f64 {
        self.depth / self.constant * (a / self.depth).powf(1.0 - self.exponent)
    }

    fn growth(&self, _a: f64) -> f64 {
        1.0 + self.exponent
    }

    fn density_growth(&self, _a: f64) -> f64 {
        self.exponent
    }

    fn depth_share(&self, profile: &dyn Profile, a: f64) -> f64 {
        let n = self.exponent;
        if n <= 0.0 {
            return 1.0;
        }
        let high = profile.reduced(a);
        let part = |t: f64| profile.reduced(a * t) / high;
        let breaks: Vec<f64> = profile.breaks(a).into_iter().map(|x| x / a).collect();
        // Γ((n+1)/2)/(Γ(n/2+1)√π) = 2/(nB).
        let scale = tgamma(0.5 * (n + 1.0)) / (tgamma(0.5 * n + 1.0) * PI.sqrt());
        let inner = |t: f64| part(t) * ((1.0 - t) * (1.0 + t)).powf(0.5 * n - 1.0);
        // Near the edge 1 − t² = w^(2/n) takes the weight away.
        let place = |w: f64| (1.0 - w.powf(2.0 / n)).sqrt();
        let outer = |w: f64| part(place(w)) / place(w);
        let turned = |t: f64| ((1.0 - t) * (1.0 + t)).powf(0.5 * n);
        let last = turned(1.0 / SQRT_2);
        let toward = (0..TOWARD).map(|k| last * 0.25f64.powi(k + 1));
        let mut borders: Vec<f64> = breaks.iter().map(|&t| turned(t)).chain(toward).collect();
        borders.sort_by(f64::total_cmp);
        let inside = n * quadrature::panels(inner, (0.0, 1.0 / SQRT_2), &breaks);
        scale * (inside + quadrature::panels(outer, (0.0, last), &borders))
    }

    fn edge_pressure(&self, root: f64, _a: f64) -> f64 {
        self.punch(root)
    }

    /// By parts, b² = r² + t²: v(r)(a²−r²)^((n−1)/2) + (1−n)∫(v(r) − v(b))t^(n−2)dt.
    fn pressure(&self, springs: &dyn Fn(f64) -> f64, ends: &[f64], r: f64) -> f64 {
        let Some(&a) = ends.last() else { return 0.0 };
        let (here, all) = (springs(r), ((a - r) * (a + r)).max(0.0).sqrt());
        let fall = |t: f64| (here - springs(r.hypot(t))) * self.punch(t) / t;
        let breaks: Vec<f64> = ends.iter().filter(|&&b| b > r && b < a).map(|b| ((b - r) * (b + r)).sqrt()).collect();
        here * self.punch(all) + (1.0 - self.exponent) * toward_zero(fall, all, &breaks)
    }

    /// u(r) = (2/π) cos(πn/2) ∫₀^a v(x) xⁿ (r²−x²)^(−(1+n)/2) dx, x = r sin θ.
    fn surface(&self, springs: &dyn Fn(f64) -> f64, ends: &[f64], r: f64) -> f64 {
        let Some(&a) = ends.last() else { return 0.0 };
        let n = self.exponent;
        let angle = |x: f64| x.atan2(((r - x) * (r + x)).max(0.0).sqrt());
        let (breaks, last) = (ends.iter().map(|&x| angle(x.min(r))).collect::<Vec<_>>(), angle(a.min(r)));
        let at = |theta: f64| springs(r * theta.sin()) * theta.tan().powf(n);
        // The tangent is a power both towards the axis and towards the edge.
        let middle = 0.5 * last;
        let inner = toward_zero(at, middle, &breaks);
        let from_top: Vec<f64> = breaks.iter().rev().map(|theta| FRAC_PI_2 - theta).collect();
        let outer = |psi: f64| at(FRAC_PI_2 - psi);
        let ends = (FRAC_PI_2 - last, FRAC_PI_2 - middle);
        let toward: Vec<f64> = (1..=4 * TOWARD).map(|k| ends.1 * 0.25f64.powi(k)).collect();
        let mut borders: Vec<f64> = from_top.into_iter().chain(toward).collect();
        borders.sort_by(f64::total_cmp);
        2.0 * FRAC_1_PI * (FRAC_PI_2 * n).cos() * (inner + quadrature::panels(outer, ends, &borders))
    }

    /// The transform of the displacement round a force: 2πA 2^(−n) Γ((1−n)/2)/Γ((1+n)/2) k^(n−1).
    fn wave(&self, k: f64) -> f64 {
        let n = self.exponent;
        let gammas = tgamma(0.5 * (1.0 - n)) / tgamma(0.5 * (1.0 + n));
        2.0 * PI * self.round_force() * (-n).exp2() * gammas * (k * self.depth).powf(n) / k
    }

    /// ∫∫A r^(−1−n)dA of the triangles from the point to the sides of the rectangle.
    fn under_rectangle(&self, away: [f64; 2], sides: [f64; 2], _endless: f64) -> f64 {
        let n = self.exponent;
        let ends = [0, 1].map(|axis| [away[axis] - 0.5 * sides[axis], away[axis] + 0.5 * sides[axis]]);
        let side = |distance: f64, [low, high]: [f64; 2]| {
            let toward = |t: f64| (distance.hypot(t) / self.depth).powf(1.0 - n) / (distance * distance + t * t);
            distance * quadrature::panel(toward, low, high)
        };
        let beyond = |axis: usize| side(ends[axis][1], ends[1 - axis]) - side(ends[axis][0], ends[1 - axis]);
        self.round_force() * self.depth / (1.0 - n) * (beyond(0) + beyond(1))
    }
}

/// ∫₀^`end` of a function that begins as a power.
fn toward_zero(function: impl Fn(f64) -> f64, end: f64, breaks: &[f64]) -> f64 {
    let toward = (1..=4 * TOWARD).map(|k| end * 0.25f64.powi(k));
    let mut borders: Vec<f64> = toward.chain(breaks.iter().copied()).collect();
    borders.sort_by(f64::total_cmp);
    quadrature::panels(function, (0.0, end), &borders)
}
