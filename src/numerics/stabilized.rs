//! Stabilised explicit steps for stiff decay: Runge–Kutta–Chebyshev of second order.
//!
//! A step of s stages is stable up to h ρ = (2/3)(s² − 1)(1 − 2ε/15), ε = 2/13, ρ the largest rate of decay (Sommeijer,
//! Shampine & Verwer 1998, J. Comput. Appl. Math. 88, 315): the work grows with the root of the stiffness, and no
//! system of equations is solved. Every stage is a mean of states and a multiple of rates, so that what is a linear
//! invariant of the rates is one of the steps, to rounding.
//!
//! # Examples
//! ```
//! use springbed::numerics::stabilized::{Flow, Moment};
//!
//! /// Decay at the rates 1 and 1000.
//! struct Decay;
//! impl Flow for Decay {
//!     fn rate(&mut self, state: &[f64], rate: &mut [f64]) {
//!         (rate[0], rate[1]) = (-state[0], -1000.0 * state[1]);
//!     }
//! }
//! let mut moment = Moment::new(&mut Decay, vec![1.0, 1.0]);
//! for _ in 0..100 {
//!     moment = moment.ahead(&mut Decay, 0.01, 1000.0).end;
//! }
//! assert!((moment.state[0] - (-1.0f64).exp()).abs() < 1e-5 && moment.state[1].abs() < 1e-12);
//! ```

/// Damping ε of the stages.
const DAMPING: f64 = 2.0 / 13.0;
/// Most stages of a step.
pub const MOST_STAGES: u32 = 250;

/// What moves a state: dy/dt as a function of y.
pub trait Flow {
    /// Writes the rate of the state `state` into `rate`, of the same length.
    fn rate(&mut self, state: &[f64], rate: &mut [f64]);
}

/// A state with its rate.
#[derive(Debug, Clone, PartialEq)]
pub struct Moment {
    /// The state y.
    pub state: Vec<f64>,
    /// Its rate dy/dt.
    pub rate: Vec<f64>,
}

/// Where a step leads.
#[derive(Debug, Clone, PartialEq)]
pub struct Ahead {
    /// Its end.
    pub end: Moment,
    /// Estimate of its error, of the state: 0.8(y₀ − y₁) + 0.4h(f₀ + f₁).
    pub error: Vec<f64>,
}

/// Number of stages that keeps a step over `rate_time` = hρ stable; at least two.
#[must_use]
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped before")]
pub fn stages(rate_time: f64) -> u32 {
    let needed = (1.0 + 1.54 * rate_time).sqrt().ceil();
    needed.clamp(2.0, f64::from(MOST_STAGES)) as u32
}

/// The longest stable step over the largest rate ρ.
#[must_use]
pub fn longest(rate: f64) -> f64 {
    (f64::from(MOST_STAGES).powi(2) - 1.0) / (1.54 * rate)
}

/// Chebyshev polynomials T, T′ and T″ up to the degree of a step at its point w₀.
struct Polynomials {
    value: Vec<f64>,
    slope: Vec<f64>,
    bend: Vec<f64>,
    at: f64,
}

impl Polynomials {
    fn new(stages: u32) -> Self {
        let at = 1.0 + DAMPING / f64::from(stages).powi(2);
        let (mut value, mut slope, mut bend) = (vec![1.0, at], vec![0.0, 1.0], vec![0.0, 0.0]);
        for j in 2..=stages as usize {
            value.push(2.0 * at * value[j - 1] - value[j - 2]);
            slope.push(2.0 * at * slope[j - 1] - slope[j - 2] + 2.0 * value[j - 1]);
            bend.push(2.0 * at * bend[j - 1] - bend[j - 2] + 4.0 * slope[j - 1]);
        }
        Self { value, slope, bend, at }
    }

    /// bⱼ = T″/T′², the first two that of j = 2.
    fn weight(&self, j: usize) -> f64 {
        let j = j.max(2);
        self.bend[j] / self.slope[j].powi(2)
    }

    /// w₁ = T′ₛ/T″ₛ.
    fn scale(&self) -> f64 {
        let last = self.slope.len() - 1;
        self.slope[last] / self.bend[last]
    }
}

impl Moment {
    /// The state `state` in the flow.
    #[must_use]
    pub fn new(flow: &mut dyn Flow, state: Vec<f64>) -> Self {
        let mut rate = vec![0.0; state.len()];
        flow.rate(&state, &mut rate);
        Self { state, rate }
    }

    /// A step of the length `h`; `largest` is an upper bound of the rates of decay, within reach of
    /// [`longest`].
    #[must_use]
    pub fn ahead(&self, flow: &mut dyn Flow, h: f64, largest: f64) -> Ahead {
        let state = self.stage_by_stage(flow, h, stages(h * largest));
        let end = Self::new(flow, state);
        let of = |k: usize| 0.8 * (self.state[k] - end.state[k]) + 0.4 * h * (self.rate[k] + end.rate[k]);
        let error = (0..self.state.len()).map(of).collect();
        Ahead { end, error }
    }

    fn stage_by_stage(&self, flow: &mut dyn Flow, h: f64, stages: u32) -> Vec<f64> {
        let polynomials = Polynomials::new(stages);
        let (scale, weight) = (polynomials.scale(), |j| polynomials.weight(j));
        let first = weight(1) * scale * h;
        let mut before = self.state.clone();
        let mut last: Vec<f64> = self.state.iter().zip(&self.rate).map(|(y, f)| y + first * f).collect();
        let mut rate = vec![0.0; last.len()];
        for j in 2..=stages as usize {
            flow.rate(&last, &mut rate);
            let mu = 2.0 * weight(j) * polynomials.at / weight(j - 1);
            let nu = -weight(j) / weight(j - 2);
            let step = 2.0 * weight(j) * scale / weight(j - 1) * h;
            let back = -(1.0 - weight(j - 1) * polynomials.value[j - 1]) * step;
            for (k, before) in before.iter_mut().enumerate() {
                let start = self.state[k];
                let moved = mu * (last[k] - start) + nu * (*before - start) + step * rate[k] + back * self.rate[k];
                *before = start + moved;
            }
            std::mem::swap(&mut before, &mut last);
        }
        last
    }
}

/// Value at the part `part` of a step of the length `h` from `start` to `end`: Hermite's cubic, one number after the other.
#[must_use]
pub fn between(start: &Moment, end: &Moment, h: f64, part: f64) -> Vec<f64> {
    if part >= 1.0 {
        return end.state.clone();
    }
    let (t, rest) = (part, 1.0 - part);
    let (into, out, leap) = (h * t * rest * rest, -h * t * t * rest, t * t * (1.0 + 2.0 * rest));
    let of = |k: usize| {
        let (y, f) = (start.state[k], start.rate[k]);
        y + leap * (end.state[k] - y) + into * f + out * end.rate[k]
    };
    (0..start.state.len()).map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// dy/dt = −y² from 1: y = 1/(1+t); and beside it a fast decay.
    struct Falling;

    impl Flow for Falling {
        fn rate(&mut self, state: &[f64], rate: &mut [f64]) {
            (rate[0], rate[1]) = (-state[0] * state[0], 1e3 * (1.0 - state[1]));
        }
    }

    fn error(steps: u32) -> f64 {
        let h = 1.0 / f64::from(steps);
        let mut moment = Moment::new(&mut Falling, vec![1.0, 0.0]);
        for _ in 0..steps {
            moment = moment.ahead(&mut Falling, h, 1e3).end;
        }
        (moment.state[0] - 0.5).abs()
    }

    /// Second order in steps a hundred times longer than the fast rate.
    #[test]
    fn halving_the_step_quarters_the_error() {
        for steps in [20, 40, 80] {
            let ratio = error(steps) / error(2 * steps);
            assert!((3.0..5.5).contains(&ratio), "{steps}: {ratio}");
        }
    }

    /// Stable over the whole range it claims: a mode at every rate up to the largest decays.
    #[test]
    fn all_rates_decay() {
        struct Mode(f64);
        impl Flow for Mode {
            fn rate(&mut self, state: &[f64], rate: &mut [f64]) {
                rate[0] = -self.0 * state[0];
            }
        }
        for stiffness in [3.0, 30.0, 1e3, 4e4] {
            for k in 1..=400 {
                let mut mode = Mode(stiffness * f64::from(k) / 400.0);
                let end = Moment::new(&mut mode, vec![1.0]).ahead(&mut mode, 1.0, stiffness).end;
                assert!(end.state[0].abs() < 1.0, "{stiffness} {k}: {}", end.state[0]);
            }
        }
    }

    #[test]
    fn the_cubic_meets_both_ends() {
        let start = Moment::new(&mut Falling, vec![1.0, 0.5]);
        let end = start.ahead(&mut Falling, 0.01, 1e3).end;
        assert_eq!(between(&start, &end, 0.01, 0.0), start.state);
        assert_eq!(between(&start, &end, 0.01, 1.0), end.state);
        assert!((between(&start, &end, 0.01, 0.5)[0] - 1.0 / 1.005).abs() < 1e-6);
    }
}
