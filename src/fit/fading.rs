//! What is left of a past that is straight in time, for many rates at once.
//!
//! Over a stretch of the length h a rate φ(s) that is a polynomial of degree four adds ∫₀^h e^{−r(h−s)} φ(s) ds to the memory of
//! the rate r, whatever r h: the moments of Legendre's polynomials with an exponential are modified spherical Bessel
//! functions, ∫₀¹ e^{−y(1−x)} P_k(2x − 1) dx = e^{−y/2} i_k(y/2) (Abramowitz & Stegun 10.2.36).

use super::slopes::Number;

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
pub struct Fading<N> {
    /// Its length h [s].
    pub length: f64,
    /// Per rate: what it keeps, and what it adds of the rate at each node [s].
    rates: Vec<(N, [N; 5])>,
}

impl<N: Number> Fading<N> {
    /// Of a stretch of the length `length` [s], for the rates `rates` [1/s].
    #[must_use]
    pub fn over(rates: &[N], length: f64) -> Self {
        let one = |rate: &N| (rate.faded(length), added(*rate, length));
        Self { length, rates: rates.iter().map(one).collect() }
    }

    /// The memories after the stretch with the values `values` at its nodes, all of them times `factor`.
    pub fn pass(&self, memory: &mut [N], values: [f64; 5], factor: N) {
        for (sum, (kept, added)) in memory.iter_mut().zip(&self.rates) {
            let [a, b, c, d, e] = *added;
            let [v, w, x, y, z] = values;
            *sum = *sum * *kept + (a * v + b * w + c * x + d * y + e * z) * factor;
        }
    }
}

/// Terms of the series of an exponential: 0.3¹²/12! is 1e-15.
const TERMS: usize = 12;

/// Values at the nodes of a stretch that is passed once.
pub struct Passing {
    length: f64,
    values: [f64; 5],
    /// Σ_j w_j (−(1 − x_j))^m values_j/m!: moments for what fades slowly.
    moments: [f64; TERMS],
}

impl Passing {
    /// Of a stretch of the length `length` [s].
    #[must_use]
    pub fn new(length: f64, values: [f64; 5]) -> Self {
        let mut moments = [0.0; TERMS];
        for ((x, weight), value) in NODES.iter().zip(values) {
            let mut part = weight * value;
            for (m, moment) in moments.iter_mut().enumerate() {
                *moment += part;
                part *= -(1.0 - x) / (m + 1) as f64;
            }
        }
        Self { length, values, moments }
    }

    /// The memory of a rate after the stretch, all values times `factor`.
    #[must_use]
    pub fn after<N: Number>(&self, rate: N, memory: N, factor: N) -> N {
        let y = rate.value() * self.length;
        memory * rate.faded(self.length) + self.added(rate, y) * factor
    }

    fn added<N: Number>(&self, rate: N, y: f64) -> N {
        if y >= SLOW {
            let [a, b, c, d, e] = added(rate, self.length);
            let [v, w, x, y, z] = self.values;
            return a * v + b * w + c * x + d * y + e * z;
        }
        let (mut sum, mut slope) = (0.0, 0.0);
        for moment in self.moments.iter().rev() {
            slope = slope * y + sum;
            sum = sum * y + moment;
        }
        rate.then(self.length * sum, self.length * self.length * slope)
    }
}

/// ∫₀^h e^{−r(h−s)} ℓ_j(s/h) ds of the polynomials ℓ_j that are one at one node.
fn added<N: Number>(rate: N, length: f64) -> [N; 5] {
    let y = rate.value() * length;
    let told = |part: f64, slope: f64| rate.then(length * part, length * length * slope);
    if y < SLOW {
        return NODES.map(|(x, weight)| {
            let part = weight * (-y * (1.0 - x)).exp();
            told(part, -(1.0 - x) * part)
        });
    }
    let z = 0.5 * y;
    let moments = bessel(z);
    let mut slopes = [0.0; 5];
    if N::SLOPES {
        // d(e^{−z} i_k)/dy = ½e^{−z}(i_{k−1} − (k + 1)i_k/z − i_k), with i_0′ = i_1.
        slopes[0] = 0.5 * (moments[1] - moments[0]);
        for k in 1..5 {
            slopes[k] = 0.5 * (moments[k - 1] - (1.0 + (k as f64 + 1.0) / z) * moments[k]);
        }
    }
    NODES.map(|(x, weight)| {
        let x = 2.0 * x - 1.0;
        let (mut before, mut here, mut sum, mut slope) = (0.0, 1.0, 0.0, 0.0);
        for (k, (moment, change)) in moments.iter().zip(slopes).enumerate() {
            let k = k as f64;
            sum += (2.0 * k + 1.0) * moment * here;
            slope += (2.0 * k + 1.0) * change * here;
            (before, here) = (here, ((2.0 * k + 1.0) * x * here - k * before) / (k + 1.0));
        }
        told(weight * sum, weight * slope)
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
    use super::super::slopes::Sloped;
    use super::*;

    /// ∫₀¹ e^{−y(1−x)} x⁴ dx against ∫ by parts, at rates from slow to fast.
    #[test]
    fn powers_fade_exactly() {
        for y in [1e-6, 0.1, 0.31, 1.0, 5.0, 23.0, 25.0, 1e3, 1e6] {
            let memory = &mut [0.0];
            let values = NODES.map(|(x, _)| x.powi(4));
            Fading::over(&[y], 1.0).pass(memory, values, 1.0);
            let once = Passing::new(1.0, values).after(y, 0.0, 1.0);
            assert!((once / memory[0] - 1.0).abs() < 1e-14, "{y}: {once} {}", memory[0]);
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

    /// Slopes in the rate against central differences.
    #[test]
    fn slopes_are_those_of_differences() {
        let values = [0.3, -0.2, 1.0, 0.7, 0.4];
        for y in [1e-3, 0.2, 0.31, 2.0, 20.0, 30.0, 300.0] {
            let h = 1e-4 * y;
            let table = |rate: f64| {
                let memory = &mut [Sloped::constant(0.7)];
                Fading::over(&[Sloped::rate(rate)], 1.0).pass(memory, values, Sloped::speed(1.5));
                memory[0]
            };
            let once = Passing::new(1.0, values).after(Sloped::rate(y), Sloped::constant(0.7), Sloped::speed(1.5));
            let slope = (table(y + h).value - table(y - h).value) / (2.0 * h);
            for found in [table(y), once] {
                // h²/6 of the third slope, which is no more than six times the slope over y².
                assert!((found.by_rate - slope).abs() < 2e-8 * (slope.abs() + 1.0 / y), "{y}: {found:?} {slope}");
                let without = 0.7 * (-y).exp();
                assert!((found.by_speed - (found.value - without) / 1.5).abs() < 1e-14, "{y}: {found:?}");
            }
        }
    }
}
