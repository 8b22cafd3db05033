//! Gauss–Legendre quadrature over panels.
//!
//! The nodes are computed here, in twenty lines; a crate for them brings a linear-algebra library along.
//!
//! # Examples
//! ```
//! use springbed::numerics::quadrature;
//!
//! // A panel takes a smooth integrand to rounding; breaks stand where it has a corner.
//! assert!((quadrature::panel(f64::exp, 0.0, 1.0) - 1.0f64.exp_m1()).abs() < 1e-14);
//! assert!((quadrature::panels(|x: f64| (x - 0.3).abs(), (0.0, 1.0), &[0.3]) - 0.29).abs() < 1e-15);
//! ```

use std::f64::consts::PI;
use std::sync::LazyLock;

/// Nodes per panel: exact for polynomials of degree 63, so a smooth integrand is at rounding.
pub const NODES: usize = 32;

static RULE: LazyLock<[(f64, f64); NODES]> = LazyLock::new(|| std::array::from_fn(|k| node_and_weight(NODES, k)));

/// The `k`-th node and weight of the Gauss–Legendre rule with `n` nodes on [-1, 1].
///
/// Newton's iteration on the Legendre polynomial Pₙ from Tricomi's start; weight 2/((1−x²)Pₙ′²)
/// (Abramowitz & Stegun 25.4.29).
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "the number of nodes is far below 2^53")]
pub fn node_and_weight(n: usize, k: usize) -> (f64, f64) {
    let count = n as f64;
    let mut x = -((k as f64 + 0.75) * PI / (count + 0.5)).cos();
    let mut derivative = 1.0;
    for _ in 0..8 {
        let (mut p, mut p_before) = (x, 1.0);
        for j in 2..=n {
            let j = j as f64;
            (p, p_before) = (((2.0 * j - 1.0) * x * p - (j - 1.0) * p_before) / j, p);
        }
        derivative = count * (x * p - p_before) / (x * x - 1.0);
        x -= p / derivative;
    }
    (x, 2.0 / ((1.0 - x * x) * derivative * derivative))
}

/// Nodes and weights of a panel on [-1, 1], for integrands of more than one number.
pub fn nodes() -> &'static [(f64, f64)] {
    &*RULE
}

/// ∫ f dx over `[low, high]` by one panel of 32 nodes.
pub fn panel(mut f: impl FnMut(f64) -> f64, low: f64, high: f64) -> f64 {
    let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
    half * RULE.iter().map(|&(x, w)| w * f(middle + half * x)).sum::<f64>()
}

/// ∫ f dx over `[low, high]`, one panel between neighbouring `breaks` that lie inside.
///
/// Breaks are places where the integrand or a derivative jumps, in ascending order.
pub fn panels(mut f: impl FnMut(f64) -> f64, (low, high): (f64, f64), breaks: &[f64]) -> f64 {
    let mut sum = 0.0;
    let mut from = low;
    for &at in breaks.iter().filter(|&&at| at > low && at < high).chain(std::iter::once(&high)) {
        sum += panel(&mut f, from, at);
        from = at;
    }
    sum
}

/// The same of an integrand that is cheaper at all the nodes of a panel together.
pub fn panels_at_once(mut f: impl FnMut([f64; NODES]) -> [f64; NODES], (low, high): (f64, f64), breaks: &[f64]) -> f64 {
    let mut from = low;
    let mut panel = |to: f64| {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        from = to;
        let values = f(std::array::from_fn(|k| middle + half * RULE[k].0));
        half * RULE.iter().zip(values).map(|(&(_, weight), value)| weight * value).sum::<f64>()
    };
    breaks.iter().filter(|&&at| at > low && at < high).chain([&high]).map(|&at| panel(at)).sum()
}

/// ∫ f dx over `[low, high]` by equal panels no longer than `longest`.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the number of panels is checked to be small"
)]
pub fn equal_panels(mut f: impl FnMut(f64) -> f64, (low, high): (f64, f64), longest: f64) -> f64 {
    let count = ((high - low) / longest).ceil().clamp(1.0, MOST_PANELS);
    let length = (high - low) / count;
    (0..count as u32).map(|k| low + length * f64::from(k)).map(|from| panel(&mut f, from, from + length)).sum()
}

/// More panels than any integral here asks for.
const MOST_PANELS: f64 = 1e6;

/// ∫ f dx over `[low, high]` where f may have a root or inverse-root singularity at either end.
///
/// The substitution x = middle − half·cos(φ), dx = half·sin(φ) dφ makes (x−low)^{±1/2} and
/// (high−x)^{±1/2} smooth. The integrand is called with `(x − low, high − x)`, both free of
/// cancellation.
pub fn panel_with_root_ends(mut f: impl FnMut(f64, f64) -> f64, length: f64) -> f64 {
    panel(
        |phi| {
            let (sine, cosine) = (0.5 * phi).sin_cos();
            length * sine * cosine * f(length * sine * sine, length * cosine * cosine)
        },
        0.0,
        PI,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The rule of n nodes exact to the degree 2n − 1 is one and only: powers, and the published digits.
    #[test]
    fn nodes_are_those_of_gauss() {
        for power in 0..64 {
            let exact = if power % 2 == 0 { 2.0 / f64::from(power + 1) } else { 0.0 };
            let sum = panel(|x| x.powi(power), -1.0, 1.0);
            assert!((sum - exact).abs() < 1e-15, "{power}: {sum:e} {exact:e}");
        }
        // Abramowitz & Stegun, table 25.4, n = 32.
        for (k, node, weight) in [
            (16, 0.048_307_665_687_738_32, 0.096_540_088_514_727_8),
            (24, 0.732_182_118_740_289_7, 0.065_822_222_776_361_85),
            (31, 0.997_263_861_849_481_6, 0.007_018_610_009_470_097),
        ] {
            let (x, w) = node_and_weight(NODES, k);
            assert!((x - node).abs() < 2e-16 && (w - weight).abs() < 2e-16, "{k}: {x:.17} {w:.17}");
        }
    }

    #[test]
    fn smooth_integrands_are_at_rounding() {
        let (e, third) = (1f64.exp(), 2.0 / 9.0 * 9f64.sin());
        assert!((panel(f64::exp, -1.0, 1.0) - (e - e.recip())).abs() < 1e-14);
        assert!((panel(|x| 1.0 / (1.5 + x), -1.0, 1.0) - 5f64.ln()).abs() < 1e-14);
        assert!((panel(|x| (9.0 * x).cos(), -1.0, 1.0) - third).abs() < 1e-14);
    }

    #[test]
    fn root_ends_are_exact() {
        // Both singularities at once: ∫₀¹ dx/√(x(1−x)) = π.
        let value = panel_with_root_ends(|x, y| 1.0 / (x * y).sqrt(), 1.0);
        assert!((value / PI - 1.0).abs() < 1e-15, "{value}");
    }

    #[test]
    fn a_break_is_honoured() {
        let value = panels(|x| if x < 0.3 { 0.0 } else { x - 0.3 }, (0.0, 1.0), &[0.3]);
        assert!((value - 0.245).abs() < 1e-16);
    }
}
