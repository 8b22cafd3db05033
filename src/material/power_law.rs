//! Relaxation by a power of time, and the series of exponentials that stands for it.
//!
//! # Examples
//! ```
//! use springbed::material::{PowerLaw, Times};
//!
//! // G(t) = 1 kPa (t/1 s)^(−0.2) from 1 ms to 1000 s, within 1e-6: some thirty terms.
//! let law = PowerLaw { modulus: "1 kPa".parse()?, exponent: "0.2".parse()?, time: "1 s".parse()? };
//! let series = law.series(Times { shortest: 1e-3, longest: 1e3, accuracy: 1e-6 });
//! assert!((series.at(10.0) / 1e3 / 10f64.powf(-0.2) - 1.0).abs() < 1e-6);
//! assert!(series.terms.len() < 45);
//! # Ok::<(), springbed::input::quantity::QuantityError>(())
//! ```

use crate::input::quantity::{Duration, Modulus, RelaxationExponent};
use crate::numerics::discrete::Orthogonal;
use libm::tgamma;
use serde::{Deserialize, Serialize};
use std::f64::consts::{FRAC_2_PI, TAU};

/// Relaxation G(t) = G₀ (t/t₀)^(−β) in shear: of living cells, of many gels and of glassy polymers.
///
/// G₀ modulus [Pa] at the time t₀ [s], exponent 0 < β < 1 (0 a solid, 1 a liquid). Its complex modulus is
/// G′ + iG″ = G₀ Γ(1 − β)(iωt₀)^β, so that G″/G′ = tan(πβ/2) at all frequencies (Fabry et al., Phys. Rev. Lett. 87, 148102,
/// 2001, eq. 1, where β is called x − 1; a viscosity beside it is the additive one of that equation).
/// At once it is infinitely stiff and in the end it carries nothing: what depends on either is refused.
/// Check: β = 0.2 loses 37 % of its modulus in each decade.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct PowerLaw {
    /// G₀ [Pa].
    pub modulus: Modulus,
    /// β.
    pub exponent: RelaxationExponent,
    /// t₀ [s].
    pub time: Duration,
}

/// Times between which a series stands for a power law, and how well.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Times {
    /// The shortest one [s].
    pub shortest: f64,
    /// The longest one [s].
    pub longest: f64,
    /// Largest relative error between them.
    pub accuracy: f64,
}

impl Times {
    /// Largest relative error of a series between them.
    #[must_use]
    pub fn error(self) -> f64 {
        (SHARE * self.accuracy).max(LEAST)
    }

    /// The times at which a body would do the same at the temperature of reference, of a shift `factor` a_T.
    #[must_use]
    pub fn at_reference(self, factor: f64) -> Self {
        Self { shortest: self.shortest / factor, longest: self.longest / factor, ..self }
    }
}

/// A sum of exponentials.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// What does not relax within the times [Pa].
    pub equilibrium: f64,
    /// Moduli [Pa] and times [s], the longest first.
    pub terms: Vec<(f64, f64)>,
}

impl Series {
    /// G(t) [Pa] at the time `t` [s].
    #[must_use]
    pub fn at(&self, t: f64) -> f64 {
        self.equilibrium + self.terms.iter().map(|(modulus, time)| modulus * (-t / time).exp()).sum::<f64>()
    }
}

impl PowerLaw {
    /// The series that stands for it between the times `times`, all its moduli above zero.
    ///
    /// t^(−β) = (1/Γ(β)) ∫ e^{βx − t eˣ} dx over all x = −ln τ is summed in steps h. By Poisson's formula that is off by
    /// 2|Γ(β + 2πi/h)|/Γ(β) ≈ e^{−π²/h}, the same at all t (Trefethen & Weideman, SIAM Rev. 56, 385, 2014): h follows
    /// from the error. Times far beyond the longest one are a modulus that does not relax and a few terms of the same
    /// moments (rule of Gauss and Radau), those far below the shortest a few terms by which a steady rate and its changes
    /// are met with the right force (rule of Gauss). An end begins where what it misses is a third of the error.
    /// Beyond the times the series is stiffer in the end and softer at once than the law.
    #[must_use]
    pub fn series(&self, times: Times) -> Series {
        let (beta, longest) = (self.exponent.si(), times.longest);
        let error = times.error();
        let sum = Sum::new(beta, error / 3.0);
        let fast = sum.fast_end((times.shortest / longest).min(1.0), error / 3.0);
        let slow = sum.slow_end(error / 3.0);
        let scale = self.modulus.si() * (longest / self.time.si()).powf(-beta);
        let inner = (slow.after + 1..fast.from).map(|k| (sum.weight(k), sum.rate(k)));
        let terms = slow.terms.into_iter().chain(inner).chain(fast.terms);
        Series {
            equilibrium: scale * slow.equilibrium,
            terms: terms.map(|(weight, rate)| (scale * weight, longest / rate)).collect(),
        }
    }
}

/// Part of the accuracy that the series may take: beside it stands what the solver misses.
const SHARE: f64 = 0.1;
/// A relative error below which rounding takes over.
const LEAST: f64 = 3e-14;
/// The most terms for the slow end, and those for the fast one: five moments right beside the first.
const ENDS: (usize, usize) = (8, 3);
/// Part of the first moment of the fast end from which on it is not summed further.
const TINY: f64 = 1e-17;
/// The most parts of the fast end, which an exponent next to one asks for.
const PARTS: i32 = 20_000;

/// The sum Σ w_k e^{−t s_k} over all whole k, with rates s_k = e^{kh} and weights w_k = h e^{βkh}/Γ(β).
#[derive(Debug, Clone, Copy)]
struct Sum {
    beta: f64,
    step: f64,
    /// h/Γ(β).
    scale: f64,
}

/// Terms whose times are beyond the longest.
struct SlowEnd {
    equilibrium: f64,
    /// Weights and rates.
    terms: Vec<(f64, f64)>,
    /// The last number of the sum that is among them.
    after: i32,
}

/// Terms whose times are below the shortest.
struct FastEnd {
    terms: Vec<(f64, f64)>,
    /// The first number of the sum that is among them.
    from: i32,
}

impl Sum {
    /// The sum whose relative error is at most `error`.
    fn new(beta: f64, error: f64) -> Self {
        let gamma = tgamma(1.0 + beta) / beta;
        // |Γ(β + iy)| ≤ √2π y^{β−1/2} e^{−πy/2 + 1/6y} with y = 2π/h for y ≥ β; the terms after the first are below 1 % of it.
        let mut y = 10.0f64;
        for _ in 0..20 {
            let bound = 1.01 * 2.0 * TAU.sqrt() * y.max(1.0).powf(beta - 0.5) * (1.0 / (6.0 * y)).exp() / gamma;
            y = (FRAC_2_PI * (bound / error).ln()).max(3.0);
        }
        let step = TAU / y;
        Self { beta, step, scale: step / gamma }
    }

    fn rate(&self, k: i32) -> f64 {
        (f64::from(k) * self.step).exp()
    }

    fn weight(&self, k: i32) -> f64 {
        self.scale * (self.beta * f64::from(k) * self.step).exp()
    }

    /// Σ_{k ≤ last} w_k.
    fn weights_up_to(&self, last: i32) -> f64 {
        self.weight(last) / -(-self.beta * self.step).exp_m1()
    }

    /// The slow end of the fewest terms: with p nodes beside the one at rest it misses at most
    /// t^{2p+1}/(2p+1)! Σ w s π_p² (Gauss & Radau), most of all at t = 1, the longest time.
    fn slow_end(&self, error: f64) -> SlowEnd {
        // With the fastest rate as its unit it looks the same wherever it begins.
        let rates = 1.0 + self.beta;
        let count = (-TINY.ln() / (rates * self.step)).ceil();
        let parts: Vec<(f64, f64)> = (0..)
            .take_while(|&k| f64::from(k) <= count)
            .map(|k| (self.rate(-k), self.weight(-k) * self.rate(-k)))
            .collect();
        let orthogonal = Orthogonal::new(&parts, ENDS.0.min(parts.len() - 1));
        let after = |nodes: usize| {
            let odd = 2 * nodes + 1;
            let factorial: f64 = (1..=odd).map(|k| k as f64).product();
            let missed = orthogonal.square(nodes) / factorial;
            whole((error / missed).ln() / ((odd as f64 + self.beta) * self.step))
        };
        let cost = |nodes: &usize| nodes_as(*nodes) - after(*nodes);
        let nodes = (0..=ENDS.0.min(parts.len() - 1)).min_by_key(cost).unwrap_or(0);
        let last = after(nodes);
        let (unit, scale) = (self.rate(last), (self.beta * f64::from(last) * self.step).exp());
        let rule = if nodes == 0 { Vec::new() } else { orthogonal.rule(nodes) };
        let terms: Vec<(f64, f64)> =
            rule.into_iter().map(|(rate, weight)| (scale * weight / rate, unit * rate)).collect();
        let equilibrium = self.weights_up_to(last) - terms.iter().map(|term| term.0).sum::<f64>();
        SlowEnd { equilibrium: equilibrium.max(0.0), terms, after: last }
    }

    /// The fast end that begins where neither it nor what stands for it is felt at the time `shortest` any more.
    fn fast_end(&self, shortest: f64, error: f64) -> FastEnd {
        let law = shortest.powf(-self.beta);
        let rule = self.fast_rule();
        let felt = |terms: &mut dyn Iterator<Item = (f64, f64)>| {
            terms.map(|(weight, rate)| weight * (-shortest * rate).exp()).sum::<f64>()
        };
        let mut from = whole(-shortest.ln() / self.step);
        loop {
            let (unit, scale) = (self.rate(from), (self.beta * f64::from(from) * self.step).exp());
            let terms: Vec<(f64, f64)> = rule.iter().map(|(weight, rate)| (scale * weight, unit * rate)).collect();
            let left_out = felt(&mut (from..from + 64).map(|k| (self.weight(k), self.rate(k))));
            let still_felt = left_out + felt(&mut terms.iter().copied()) > error * law;
            if !still_felt {
                return FastEnd { terms, from };
            }
            from += 1;
        }
    }

    /// Weights and rates of the fast end that begins at k = 0: Gauss's rule over the times, of weights w τ.
    fn fast_rule(&self) -> Vec<(f64, f64)> {
        let count = whole((-TINY.ln() / ((1.0 - self.beta) * self.step)).min(f64::from(PARTS)));
        let impulse = |k: i32| self.scale * ((self.beta - 1.0) * f64::from(k) * self.step).exp();
        let mut parts: Vec<(f64, f64)> = (0..=count).map(|k| (self.rate(-k), impulse(k))).collect();
        // What is left has the last time.
        if let Some(last) = parts.last_mut() {
            last.1 /= -(-(1.0 - self.beta) * self.step).exp_m1();
        }
        let rule = Orthogonal::new(&parts, ENDS.1).rule(ENDS.1);
        rule.into_iter().map(|(time, weight)| (weight / time, 1.0 / time)).collect()
    }
}

/// The largest whole number that is not above.
#[expect(clippy::cast_possible_truncation, reason = "logarithms of numbers, over steps of some tenths")]
fn whole(value: f64) -> i32 {
    value.floor() as i32
}

#[expect(clippy::cast_possible_truncation, clippy::cast_possible_wrap, reason = "at most eight")]
fn nodes_as(nodes: usize) -> i32 {
    nodes as i32
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::f64::consts::PI;

    fn law(beta: f64) -> PowerLaw {
        PowerLaw {
            modulus: Modulus::new(1.0).unwrap(),
            exponent: RelaxationExponent::new(beta).unwrap(),
            time: Duration::new(1.0).unwrap(),
        }
    }

    /// Greatest relative error over the times, at 400 of them.
    fn off(beta: f64, times: Times, series: &Series) -> f64 {
        let ratio = (times.longest / times.shortest).ln();
        let at = |k: i32| times.shortest * (ratio * f64::from(k) / 400.0).exp();
        (0..=400).map(at).map(|t| (series.at(t) * t.powf(beta) - 1.0).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn eight_decades_take_tens_of_terms() {
        for (accuracy, most) in [(1e-4, 30), (1e-6, 45), (1e-9, 62), (1e-12, 80)] {
            let times = Times { shortest: 1e-4, longest: 1e4, accuracy };
            let series = law(0.2).series(times);
            let off = off(0.2, times, &series);
            println!("{accuracy:e}: {} terms, {off:e}", series.terms.len());
            assert!(off < accuracy && series.terms.len() <= most, "{accuracy:e}: {} terms", series.terms.len());
        }
    }

    /// ∫₀^t G over a steady rate is t^{1−β}/(1−β), although the series ends at a shortest time.
    #[test]
    fn a_steady_rate_meets_the_right_force() {
        for beta in [0.05, 0.2, 0.5, 0.8, 0.95] {
            let times = Times { shortest: 1e-3, longest: 1.0, accuracy: 1e-9 };
            let series = law(beta).series(times);
            for t in [1e-3, 1e-2, 0.1, 1.0] {
                let part = |&(modulus, time): &(f64, f64)| -modulus * time * (-t / time).exp_m1();
                let force = series.equilibrium * t + series.terms.iter().map(part).sum::<f64>();
                let right = t.powf(1.0 - beta) / (1.0 - beta);
                assert!((force / right - 1.0).abs() < 1e-9, "{beta} {t}: {:e}", force / right - 1.0);
            }
        }
    }

    proptest! {
        /// The error asked for at all times between, whatever exponent, span and accuracy; moduli above zero.
        #[test]
        fn the_law_is_met_at_all_times_between(
            beta in 1i32..1000, decades in 1i32..160, from in -90i32..90, accuracy in 2i32..130,
        ) {
            let beta = f64::from(beta) * 1e-3;
            let shortest = 10f64.powf(0.1 * f64::from(from));
            let longest = shortest * 10f64.powf(0.1 * f64::from(decades));
            let times = Times { shortest, longest, accuracy: 10f64.powf(-0.1 * f64::from(accuracy)).min(0.1) };
            let series = law(beta).series(times);
            let off = off(beta, times, &series);
            // Below 1e-12 the powers themselves are rounded.
            prop_assert!(off < times.accuracy.max(1e-12), "{off:e} of {times:?}");
            prop_assert!(series.equilibrium >= 0.0 && series.terms.iter().all(|term| term.0 > 0.0 && term.1 > 0.0));
        }

        /// G′ + iG″ = Γ(1 − β)(iω)^β at frequencies between.
        #[test]
        fn moduli_of_a_steady_oscillation(beta in 1i32..100, at in 1i32..40) {
            let beta = 0.01 * f64::from(beta).min(99.0);
            let series = law(beta).series(Times { shortest: 1e-3, longest: 1e3, accuracy: 1e-6 });
            let omega = 10f64.powf(0.1 * f64::from(at) - 2.0);
            let part = |&(modulus, time): &(f64, f64)| {
                let x = omega * time;
                (modulus / (1.0 + x.powi(-2)), modulus / (x + x.recip()))
            };
            let parts = series.terms.iter().map(part);
            let (storage, loss) = parts.fold((series.equilibrium, 0.0), |sum, part| (sum.0 + part.0, sum.1 + part.1));
            let (size, angle) = (tgamma(1.0 - beta) * omega.powf(beta), 0.5 * PI * beta);
            // Both ends of the span are a decade away: an oscillation feels what is beyond them by a power of that.
            prop_assert!((storage - size * angle.cos()).abs() < 1e-2 * size, "{storage} {}", size * angle.cos());
            prop_assert!((loss - size * angle.sin()).abs() < 1e-2 * size, "{loss}");
        }
    }
}
