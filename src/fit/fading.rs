//! What is left of a past that is straight in time, for many rates at once.
//!
//! Over a stretch of the length h a rate φ(s) that is a polynomial of degree four adds ∫₀^h e^{−r(h−s)} φ(s) ds to the memory of
//! the rate r, whatever r h: the moments of Legendre's polynomials with an exponential are modified spherical Bessel
//! functions, ∫₀¹ e^{−y(1−x)} P_k(2x − 1) dx = e^{−y/2} i_k(y/2) (Abramowitz & Stegun 10.2.36).

/// Nodes and weights of Gauss and Legendre on (0, 1): five.
pub const NODES: [(f64, f64); 5] = [
    (0.046_910_077_030_668, 0.118_463_442_528_094_54),
    (0.230_765_344_947_158_45, 0.239_314_335_249_683_23),
    (0.5, 0.284_444_444_444_444_44),
    (0.769_234_655_052_841_6, 0.239_314_335_249_683_23),
    (0.953_089_922_969_332, 0.118_463_442_528_094_54),
];

/// Below this y Gauss's rule by itself is right to 1e-13.
const SLOW: f64 = 0.3;
/// Above this argument Bessel functions are found upwards from the first two.
const LARGE: f64 = 12.0;

/// What a stretch does to memories.
#[derive(Debug, Clone)]
pub struct Fading {
    /// Its length h [s].
    pub length: f64,
    /// Per rate: what it keeps, and what it adds of the rate at each node, in parts of h.
    rates: Vec<(f64, [f64; 5])>,
}

impl Fading {
    /// Of a stretch of the length `length` [s], for the rates `rates` [1/s].
    #[must_use]
    pub fn over(rates: &[f64], length: f64) -> Self {
        Self { length, rates: rates.iter().map(|rate| ((-rate * length).exp(), added(rate * length))).collect() }
    }

    /// The memories after a stretch of the length `length` [s] with the values `values` at its nodes.
    pub fn pass(&self, memory: &mut [f64], length: f64, values: [f64; 5]) {
        for (sum, (kept, added)) in memory.iter_mut().zip(&self.rates) {
            let new: f64 = added.iter().zip(values).map(|(part, value)| part * value).sum();
            *sum = *sum * kept + length * new;
        }
    }
}

/// ∫₀¹ e^{−y(1−x)} ℓ_j(x) dx of the polynomials ℓ_j that are one at one node.
fn added(y: f64) -> [f64; 5] {
    if y < SLOW {
        return NODES.map(|(x, weight)| weight * (-y * (1.0 - x)).exp());
    }
    let moments = bessel(0.5 * y);
    NODES.map(|(x, weight)| {
        let x = 2.0 * x - 1.0;
        let (mut before, mut here, mut sum) = (0.0, 1.0, 0.0);
        for (k, moment) in moments.iter().enumerate() {
            let k = k as f64;
            sum += (2.0 * k + 1.0) * moment * here;
            (before, here) = (here, ((2.0 * k + 1.0) * x * here - k * before) / (k + 1.0));
        }
        weight * sum
    })
}

/// e^{−z} i_k(z) for k = 0 to 4, z > 0.
fn bessel(z: f64) -> [f64; 5] {
    let small = -(-2.0 * z).exp_m1();
    let first = 0.5 * small / z;
    let mut values = [first; 5];
    if z > LARGE {
        values[1] = (0.5 * (2.0 - small) - first) / z;
        for k in 1..4 {
            values[k + 1] = values[k - 1] - (2.0 * k as f64 + 1.0) / z * values[k];
        }
        return values;
    }
    // Downwards, where they grow (Miller); i_k falls below 1e-14 of i_4 before k = 16 + 2z.
    let (mut above, mut here) = (0.0, 1e-200);
    #[expect(clippy::cast_possible_truncation, reason = "at most 40")]
    for k in (0..16 + (2.0 * z) as i32).rev() {
        (above, here) = (here, above + (2.0 * f64::from(k) + 3.0) / z * here);
        if let Ok(k) = usize::try_from(k)
            && k < 5
        {
            values[k] = here;
        }
    }
    let scale = first / values[0];
    values.map(|value| scale * value)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫₀¹ e^{−y(1−x)} x⁴ dx against ∫ by parts, at rates from slow to fast.
    #[test]
    fn powers_fade_exactly() {
        for y in [1e-6, 0.1, 0.31, 1.0, 5.0, 23.0, 25.0, 1e3, 1e6] {
            let memory = &mut [0.0];
            Fading::over(&[y], 1.0).pass(memory, 1.0, NODES.map(|(x, _)| x.powi(4)));
            // By parts I_n = (1 − n I_{n−1})/y loses digits at small y: there the series Σ (−y)^k 4!/(k + 5)!.
            let right = if y > 12.0 {
                (1..=4).fold(-(-y).exp_m1() / y, |last, n| (1.0 - f64::from(n) * last) / y)
            } else {
                let mut term = 0.2;
                let mut sum = 0.0;
                for k in 0..80 {
                    sum += term;
                    term *= -y / f64::from(k + 6);
                }
                sum
            };
            assert!((memory[0] / right - 1.0).abs() < 1e-11, "{y}: {:e}", memory[0] / right - 1.0);
        }
    }
}
