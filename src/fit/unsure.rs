//! What is not known of fitted columns whose noise is alike by an unknown correlation.
//!
//! Given ρ and restricted likelihood L(ρ), a parameter has Student's law of n − p degrees of freedom around β(ρ) with the
//! error s(ρ); ρ itself has the density L(ρ)(1 − ρ²)^{−1/2}, by the reference prior of AR(1) (Berger & Yang 1994, Econometric
//! Theory 10, 461). Over both the parameter has a mixture of Student's laws: as wide as the one at the most likely ρ while
//! ρ is well known, wider and with longer tails where few correlation lengths fit into the data.

use super::noise::Moments;
use crate::numerics::root;
use std::f64::consts::FRAC_1_SQRT_2;

/// Errors of fitted columns, in their order.
#[derive(Debug, Clone)]
pub struct Unsure {
    laws: Vec<Mixture>,
}

/// Student's laws of one parameter and their weights.
#[derive(Debug, Clone)]
struct Mixture {
    /// Weight, distance from the estimate, error.
    parts: Vec<(f64, f64, f64)>,
    freedom: f64,
}

/// Part of what is expected to be the width of the density of ρ by which it is sampled: the trapezoidal rule is off by
/// e^{−2π²/h²} of a bell.
const STEP: f64 = 0.6;
/// Part of the largest density below which it is cut off.
const FAINT: f64 = 1e-5;
/// The most samples to a side.
const MOST: usize = 60;
/// Part of probability in an interval.
const INSIDE: f64 = 0.95;
impl Unsure {
    /// Of the columns of `moments`, wherever in them the estimate is; `None` where columns cannot be told apart.
    #[must_use]
    pub fn of(moments: &Moments) -> Option<Self> {
        let peak = moments.peak();
        let likely = peak.tanh();
        let here = moments.judged(likely);
        let width = 1.0 / (moments.points() as f64 * (1.0 - likely * likely)).sqrt();
        let step = STEP * width.min(0.5);
        let weight = |rho: f64, likelihood: f64| {
            ((1.0 - rho * rho) / (1.0 - likely * likely)).sqrt() * (-0.5 * (likelihood - here.likelihood)).exp()
        };
        let mut laws: Vec<Mixture> = Vec::new();
        let freedom = moments.freedom();
        for way in [1.0, -1.0] {
            for k in usize::from(way < 0.0)..MOST {
                let x = peak + way * step * k as f64;
                if x.abs() > Moments::farthest() {
                    break;
                }
                let there = moments.judged(x.tanh());
                let weight = weight(there.correlation, there.likelihood);
                if weight < FAINT {
                    break;
                }
                let inverse = there.inverse.as_ref()?;
                laws.resize_with(inverse.nrows(), || Mixture { parts: Vec::new(), freedom });
                for (at, law) in laws.iter_mut().enumerate() {
                    law.parts.push((weight, there.shift[at], (there.variance * inverse[(at, at)]).sqrt()));
                }
            }
        }
        laws.iter_mut().for_each(Mixture::normalise);
        Some(Self { laws })
    }

    /// Standard error of the column number `at`, and half of the 95 % interval around its estimate.
    #[must_use]
    pub fn error_and_reach(&self, at: usize) -> (f64, f64) {
        self.laws.get(at).map_or((0.0, 0.0), |law| (law.error(), law.reach()))
    }
}

impl Mixture {
    fn normalise(&mut self) {
        let whole: f64 = self.parts.iter().map(|part| part.0).sum();
        self.parts.iter_mut().for_each(|part| part.0 /= whole);
    }

    /// Root of the mean square of the distance, of laws as wide as normal ones of the same error.
    fn error(&self) -> f64 {
        self.parts.iter().map(|(weight, shift, error)| weight * (shift * shift + error * error)).sum::<f64>().sqrt()
    }

    /// Distance from the estimate within which `INSIDE` of the probability lies.
    fn reach(&self) -> f64 {
        let farthest = self.parts.iter().map(|(_, shift, error)| shift.abs() + FARTHEST * error).fold(0.0, f64::max);
        let missing = |c: f64| self.parts.iter().map(|part| part.0 * self.within(c, *part)).sum::<f64>() - INSIDE;
        if farthest > 0.0 { root::brent(missing, 0.0, farthest).unwrap_or(farthest) } else { 0.0 }
    }

    /// Probability of a part within the distance `c`.
    fn within(&self, c: f64, (_, shift, error): (f64, f64, f64)) -> f64 {
        if error <= 0.0 {
            return f64::from(u8::from(shift.abs() <= c));
        }
        self.below((c - shift) / error) - self.below((-c - shift) / error)
    }

    /// Student's distribution, by that of the normal law at (8ν + 1)/(8ν + 3)·√(ν ln(1 + t²/ν)): quantiles within 3e-3 from five
    /// degrees of freedom on (Wallace 1959, Ann. Math. Stat. 30, 1124).
    fn below(&self, t: f64) -> f64 {
        let nu = self.freedom;
        let z = (8.0 * nu + 1.0) / (8.0 * nu + 3.0) * (nu * (t * t / nu).ln_1p()).sqrt();
        0.5 * libm::erfc(-z.copysign(t) * FRAC_1_SQRT_2)
    }
}

/// Errors within which 95 % lie for any law of one degree of freedom or more: 12.7 for one.
const FARTHEST: f64 = 16.0;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::noise::student;

    /// One law alone: tables of Student's t.
    #[test]
    fn one_law_is_students() {
        for (freedom, t) in [(5.0, 2.570_582), (10.0, 2.228_139), (30.0, 2.042_272), (1000.0, 1.962_339)] {
            let law = Mixture { parts: vec![(1.0, 0.0, 2.0)], freedom };
            assert!((law.reach() / (2.0 * t) - 1.0).abs() < 3e-3, "{freedom} {}", law.reach());
            assert!((law.reach() / (2.0 * student(freedom)) - 1.0).abs() < 3e-3);
            assert!((law.error() - 2.0).abs() < 1e-15);
        }
    }

    /// Two sharp laws: the interval reaches the farther one, and is as wide as needed to hold 95 %.
    #[test]
    fn two_laws_hold_both() {
        let mut law = Mixture { parts: vec![(9.0, 0.0, 1e-6), (1.0, 3.0, 1e-6)], freedom: 100.0 };
        law.normalise();
        // Half of the second: its middle.
        assert!((law.reach() - 3.0).abs() < 1e-5, "{}", law.reach());
        assert!((law.error() - (0.1f64 * 9.0).sqrt()).abs() < 1e-5);
    }
}
