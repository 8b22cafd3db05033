//! Struve functions, which the waviness of a paraboloid leads to.
//!
//! # Examples
//! ```
//! use springbed::numerics::special::struve;
//!
//! // Abramowitz & Stegun, table 12.1: H₀(1) = 0.5686566.
//! assert!((struve(1.0).zero - 0.568_656_627_048_288).abs() < 1e-15);
//! ```

use crate::numerics::chebyshev::Chebyshev;
use crate::numerics::quadrature;
use std::f64::consts::{FRAC_2_PI, FRAC_PI_4};
use std::sync::{LazyLock, OnceLock};

/// Struve functions H₀(z) and H₋₁(z) = 2/π − H₁(z) = H₀′(z) for z ≥ 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Struve {
    /// H₀(z).
    pub zero: f64,
    /// H₋₁(z).
    pub minus_one: f64,
}

/// Up to here the alternating power series loses less than one digit.
const SERIES_END: f64 = 4.0;
/// Terms below this part of the sum are left out.
const TINY: f64 = 1e-18;
/// From here on the smallest term of the asymptotic series, about e^{−z}, is below 1e-19.
const ASYMPTOTIC_START: f64 = 45.0;

/// H₀ and H₋₁ at `z` ≥ 0, to a few units of 1e-16 of their amplitude.
///
/// The power series (Abramowitz & Stegun, § 12.1), the integral H₀ = (2/π)∫₀^{π/2} sin(z cos θ) dθ
/// and its derivative, and Y₀ and −Y₁ with the asymptotic series of the difference. Check: H₀(1) = 0.568656627048288.
#[must_use]
pub fn struve(z: f64) -> Struve {
    if z <= SERIES_END {
        series(z)
    } else if z < ASYMPTOTIC_START {
        between(z)
    } else {
        asymptotic(z)
    }
}

/// H₁(z) at `z` ≥ 0, without cancellation at small arguments.
#[must_use]
pub fn struve_one(z: f64) -> f64 {
    if z > SERIES_END { FRAC_2_PI - struve(z).minus_one } else { series_one(z) }
}

/// zH₀(z) − H₁(z) at `z` ≥ 0: the moment ∫₀^z t (tH₀)′ dt of the waves, divided by z.
#[must_use]
pub fn struve_load(z: f64) -> f64 {
    let value = struve(z);
    let one = if z > SERIES_END { FRAC_2_PI - value.minus_one } else { series_one(z) };
    z * value.zero - one
}

fn series_one(z: f64) -> f64 {
    // (2/π) Σ (−1)^k z^{2k+2} / ((2k+1)!! (2k+3)!!)
    let mut term = FRAC_2_PI * z * z / 3.0;
    let mut sum: f64 = 0.0;
    let mut odd = 3.0;
    while term.abs() > TINY * sum.abs() {
        sum += term;
        term *= -z * z / (odd * (odd + 2.0));
        odd += 2.0;
    }
    sum
}

fn series(z: f64) -> Struve {
    let (mut zero, mut minus_one) = (0.0_f64, 0.0_f64);
    // term = (−1)^k z^{2k}/((2k+1)!!)²
    let (mut term, mut odd) = (FRAC_2_PI, 1.0);
    while term.abs() * odd > TINY * FRAC_2_PI {
        zero += term * z;
        minus_one += term * odd;
        odd += 2.0;
        term *= -(z / odd) * (z / odd);
    }
    Struve { zero, minus_one }
}

/// Length of the stretches between both series on which a polynomial stands for the integral: a wave of the length 2π on
/// half of it leaves J₁₈(1) = 3e-22 of 18 coefficients.
const STRETCH: f64 = 2.0;
const COEFFICIENTS: usize = 18;
/// H₀ and H₋₁ on the stretches that have been asked for.
static STRETCHES: [OnceLock<[Chebyshev; 2]>; 21] = [const { OnceLock::new() }; 21];

/// The integral by its polynomial: a tenth of the sines.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between the series, so below 21")]
fn between(z: f64) -> Struve {
    let k = ((z - SERIES_END) / STRETCH) as usize;
    let low = SERIES_END + STRETCH * to_f64(k);
    let made = || {
        let values = [|z| integral(z).zero, |z| integral(z).minus_one];
        values.map(|value| Chebyshev::of(value, COEFFICIENTS, (low, low + STRETCH)))
    };
    STRETCHES.get(k).map_or_else(
        || integral(z),
        |stretch| {
            let [zero, minus_one] = stretch.get_or_init(made);
            Struve { zero: zero.at(z), minus_one: minus_one.at(z) }
        },
    )
}

#[expect(clippy::cast_precision_loss, reason = "a small number of stretches")]
fn to_f64(k: usize) -> f64 {
    k as f64
}

/// cos θ and weights of one panel over [0, π/2], and of two.
static ONE_PANEL: LazyLock<Vec<(f64, f64)>> = LazyLock::new(|| nodes(1));
static TWO_PANELS: LazyLock<Vec<(f64, f64)>> = LazyLock::new(|| nodes(2));

fn nodes(panels: u32) -> Vec<(f64, f64)> {
    let half = FRAC_PI_4 / f64::from(panels);
    let rule: Vec<(f64, f64)> = (0..32).map(|k| quadrature::node_and_weight(32, k)).collect();
    let at = |panel: u32, node: f64| (half * (f64::from(2 * panel + 1) + node)).cos();
    (0..panels).flat_map(|panel| rule.iter().map(move |&(node, w)| (at(panel, node), half * w))).collect()
}

fn integral(z: f64) -> Struve {
    let nodes = if z > 20.0 { &TWO_PANELS } else { &ONE_PANEL };
    let (mut zero, mut minus_one) = (0.0, 0.0);
    for &(cosine, weight) in nodes.iter() {
        let (sine_of, cosine_of) = (z * cosine).sin_cos();
        zero += weight * sine_of;
        minus_one += weight * cosine * cosine_of;
    }
    Struve { zero: FRAC_2_PI * zero, minus_one: FRAC_2_PI * minus_one }
}

fn asymptotic(z: f64) -> Struve {
    let (mut zero, mut minus_one) = (0.0_f64, 0.0_f64);
    // term = (−1)^k ((2k−1)!!)²/z^{2k+1}
    let (mut term, mut odd) = (FRAC_2_PI / z, 1.0);
    while term.abs() > TINY * zero.abs() {
        zero += term;
        minus_one -= odd * term / z;
        term *= -(odd / z) * (odd / z);
        odd += 2.0;
    }
    Struve { zero: libm::y0(z) + zero, minus_one: minus_one - libm::y1(z) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// z, H₀, H₋₁, H₁, computed with 30 digits.
    const TABLE: [(f64, f64, f64, f64); 12] = [
        (1e-8, 6.366197723675813e-09, 0.6366197723675813, 2.122065907891938e-17),
        (0.3, 0.18908293527227688, 0.6176354765121372, 0.018984295855444054),
        (1.0, 0.5686566270482879, 0.43816243616563694, 0.1984573362019444),
        (3.9, 0.178931155604483, -0.44465637918648426, 1.0812761515540656),
        (4.1, 0.09242078160245881, -0.4182281738698062, 1.0548479462373876),
        (7.5, 0.20086479668164503, 0.24830669236337574, 0.3883130800042056),
        (19.9, 0.07767398640881139, 0.17018719869684526, 0.4664325736707361),
        (20.1, 0.11040647164824206, 0.15606152750357283, 0.4805582448640085),
        (39.9, 0.14067304106592923, 0.017968314474729484, 0.6186514578928518),
        (40.1, 0.14175143273425292, -0.007201996725942004, 0.6438217690935234),
        (123.4, -0.0014024843521499295, -0.07154133824062633, 0.7081611106082076),
        (98765.4, -0.0017704715327302866, 0.001813387590082725, 0.6348063847774986),
    ];

    #[test]
    fn struve_functions_in_every_regime() {
        for (z, zero, minus_one, one) in TABLE {
            let value = struve(z);
            // Rounding of z moves the phase by z·2⁻⁵³ at an amplitude of √(2/πz); the rest are units of 1e-16.
            let bound = 1e-15 + 1.2e-16 * z.sqrt();
            assert!((value.zero - zero).abs() < bound * zero.abs().max(1.0), "{z} {value:?}");
            assert!((value.minus_one - minus_one).abs() < bound, "{z} {value:?}");
            assert!((struve_one(z) / one - 1.0).abs() < 4.0 * bound, "{z}");
        }
        assert!((struve(1e-8).zero / TABLE[0].1 - 1.0).abs() < 4e-16);
    }

    #[test]
    fn polynomials_between_the_series_are_the_integral() {
        for k in 0..4100 {
            let z = SERIES_END + 0.01 * f64::from(k) + 1e-9;
            let (value, right) = (struve(z), integral(z));
            assert!((value.zero - right.zero).abs() < 1.5e-15, "{z} {value:?} {right:?}");
            assert!((value.minus_one - right.minus_one).abs() < 1.5e-15, "{z} {value:?} {right:?}");
        }
    }
}
