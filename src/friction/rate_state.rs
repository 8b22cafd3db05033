//! Friction that depends on the rate of slip and on what the contact has gone through: rate and state.
//!
//! μ = μ* + a ln(V/V*) + b ln(V*θ/D_c) (Dieterich 1979; Ruina 1983), V the speed of slip and θ the state, a time: the mean age
//! of the junctions between the surfaces. It grows while they rest and falls as they slip over the distance D_c, by
//!
//! - the ageing law (Dieterich) dθ/dt = 1 − Vθ/D_c, or
//! - the slip law (Ruina) dθ/dt = −(Vθ/D_c) ln(Vθ/D_c), under which nothing changes without slip.
//!
//! In steady slip θ = D_c/V and μ = μ* + (a − b) ln(V/V*). The logarithm has no value at V = 0 and the wrong one beyond; what
//! is computed is its smooth continuation μ = a arsinh[(V/2V*) exp((μ* + b ln(V*θ/D_c))/a)] (Rice, Lapusta & Ranjith,
//! *J. Mech. Phys. Solids* **49** (2001) 1865), that of junctions which thermal jumps take forwards and backwards. It is odd
//! in V and differs from the logarithm by a exp(−2μ/a) or less: 1e-26 at μ = 0.6 and a = 0.02.
//!
//! # Examples
//! ```
//! use springbed::friction::RateState;
//! use springbed::input::quantity::{Length, Ratio, Speed};
//!
//! let ratio = |value: f64| Ratio::new(value);
//! let law = RateState {
//!     coefficient: ratio(0.6)?, direct: ratio(0.01)?, evolution: ratio(0.015)?,
//!     distance: Length::new(1e-5)?, speed: Speed::new(1e-6)?, law: None, state: None,
//! };
//! // Ten times as fast it slides on 0.005 ln 10 less.
//! assert!((law.steady(1e-5) - (0.6 - 0.005 * 10f64.ln())).abs() < 1e-15);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::input::quantity::{Duration, Length, Ratio, Speed};
use serde::{Deserialize, Serialize};

/// Friction of rate and state.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct RateState {
    /// Coefficient of friction μ* of steady sliding at the speed V*.
    pub coefficient: Ratio,
    /// Direct effect a: what μ gains at once for a speed e times as large.
    pub direct: Ratio,
    /// Effect b of the state: what μ loses after it, over the distance D_c.
    pub evolution: Ratio,
    /// Distance D_c [m] of slip over which the junctions change.
    pub distance: Length,
    /// Reference speed V* [m/s].
    pub speed: Speed,
    /// Law by which the state changes; the ageing law if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub law: Option<StateLaw>,
    /// State θ [s] of the contact as it is made; D_c/V* if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub state: Option<Duration>,
}

/// Law by which the state of a contact changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename = "Law")]
pub enum StateLaw {
    /// dθ/dt = 1 − Vθ/D_c: the contact strengthens with the time at rest.
    Ageing,
    /// dθ/dt = −(Vθ/D_c) ln(Vθ/D_c): it changes by slip alone.
    Slip,
}

/// Slip of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlipRate {
    /// Its speed V [m/s].
    pub speed: f64,
    /// ln(|V|/V*); −∞ at rest.
    pub log: f64,
    /// ∂V/∂μ [m/s].
    pub by_load: f64,
}

/// Load over the direct effect above which the way back of the junctions is less than rounding.
const ONE_WAY: f64 = 20.0;

impl RateState {
    /// The law of its state.
    #[must_use]
    pub fn of_state(&self) -> StateLaw {
        self.law.unwrap_or(StateLaw::Ageing)
    }

    /// Whether neither rate nor state matters: Coulomb's law.
    #[must_use]
    pub fn is_coulomb(&self) -> bool {
        self.direct.si() <= 0.0 && self.evolution.si() <= 0.0
    }

    /// State θ [s] of a contact that was made the time `age` [s] ago, and has not slipped since.
    #[must_use]
    pub fn rested(&self, age: f64) -> f64 {
        let made = self.state.map_or(self.distance.si() / self.speed.si(), Duration::si);
        match self.of_state() {
            StateLaw::Ageing => made + age,
            StateLaw::Slip => made,
        }
    }

    /// ln(V*θ/D_c) of the state θ [s].
    #[must_use]
    pub fn log_state(&self, state: f64) -> f64 {
        (state / self.distance.si() * self.speed.si()).ln()
    }

    /// State θ [s] of ln(V*θ/D_c).
    #[must_use]
    pub fn state(&self, log: f64) -> f64 {
        self.distance.si() / self.speed.si() * log.exp()
    }

    /// Coefficient of friction at the speed `speed` [m/s], above zero, and ln(V*θ/D_c).
    #[must_use]
    pub fn coefficient(&self, speed: f64, log: f64) -> f64 {
        let a = self.direct.si();
        let x = (0.5 * speed / self.speed.si()).ln() + (self.coefficient.si() + self.evolution.si() * log) / a;
        // arsinh(eˣ)
        if x > 0.0 { a * (x + (1.0 + (-2.0 * x).exp()).sqrt().ln_1p()) } else { a * x.exp().asinh() }
    }

    /// Coefficient of friction μ_ss(V) of steady sliding at the speed `speed` [m/s], above zero.
    #[must_use]
    pub fn steady(&self, speed: f64) -> f64 {
        if self.is_coulomb() {
            return self.coefficient.si();
        }
        self.coefficient(speed, -(speed / self.speed.si()).ln())
    }

    /// How fast a contact slips under the part `load` of its normal force, by ln(V*θ/D_c).
    #[must_use]
    pub fn slip(&self, load: f64, log: f64) -> SlipRate {
        let steep = self.direct.si().recip();
        let forth = load.abs() * steep;
        let log = forth - (self.coefficient.si() + self.evolution.si() * log) * steep;
        let whole = self.speed.si() * log.exp();
        let (back, left) = if forth < ONE_WAY { ((-2.0 * forth).exp(), -(-2.0 * forth).exp_m1()) } else { (0.0, 1.0) };
        let log = if forth < ONE_WAY { log + left.ln() } else { log };
        SlipRate { speed: (whole * left).copysign(load), log, by_load: whole * (1.0 + back) * steep }
    }

    /// d ln θ/dt [1/s] of a contact that slips by `slip`.
    #[must_use]
    pub fn evolves(&self, slip: &SlipRate, log: f64) -> f64 {
        let along = self.distance.si().recip();
        let rate = slip.speed.abs() * along;
        match self.of_state() {
            StateLaw::Ageing => self.speed.si() * along * (-log).exp() - rate,
            // V ln V vanishes with V.
            StateLaw::Slip if rate > 0.0 => -rate * (slip.log + log),
            StateLaw::Slip => 0.0,
        }
    }

    /// The slopes of d ln θ/dt over the load and over ln θ [1/s].
    #[must_use]
    pub fn evolution_slopes(&self, slip: &SlipRate, log: f64) -> [f64; 2] {
        let (a, b, distance) = (self.direct.si(), self.evolution.si(), self.distance.si());
        let rate = slip.speed.abs() / distance;
        let by_load = slip.by_load.copysign(slip.speed) / distance;
        match self.of_state() {
            StateLaw::Ageing => [-by_load, rate * b / a - self.speed.si() / distance * (-log).exp()],
            StateLaw::Slip if rate > 0.0 => {
                let far = slip.log + log;
                [-by_load * (far + 1.0), rate * (b / a * far + (b / a - 1.0))]
            }
            StateLaw::Slip => [0.0; 2],
        }
    }

    /// Slopes of the friction of steady sliding at the speed `speed` [m/s] over ln V, at once and by the state: a and b, but for
    /// the jumps of junctions backwards.
    #[must_use]
    pub fn effects(&self, speed: f64) -> (f64, f64) {
        let (a, b) = (self.direct.si(), self.evolution.si());
        let part = (self.steady(speed) / a).tanh();
        (a * part, b * part)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn law(of_state: StateLaw) -> RateState {
        RateState {
            coefficient: Ratio::new(0.6).unwrap(),
            direct: Ratio::new(0.05).unwrap(),
            evolution: Ratio::new(0.07).unwrap(),
            distance: Length::new(2e-5).unwrap(),
            speed: Speed::new(1e-6).unwrap(),
            law: Some(of_state),
            state: None,
        }
    }

    /// Friction at a speed, and the speed under that friction, are one relation.
    #[test]
    fn speed_and_friction_are_inverse() {
        let law = law(StateLaw::Ageing);
        for (exponent, log) in [(-30, 1.0), (-9, -3.0), (-6, 0.0), (0, -14.0), (3, -20.0)] {
            let speed = 10f64.powi(exponent);
            let slip = law.slip(law.coefficient(speed, log), log);
            assert!((slip.speed / speed - 1.0).abs() < 1e-12, "{exponent}: {slip:?}");
            let back = law.slip(-law.coefficient(speed, log), log);
            assert!((back.speed + slip.speed).abs() <= 0.0 && (slip.log - (speed / 1e-6).ln()).abs() < 1e-12);
        }
        assert!(law.slip(0.0, 3.0).speed.abs() <= 0.0);
    }

    /// The slopes are those of differences, forwards, backwards and near rest.
    #[test]
    fn slopes_are_those_of_differences() {
        for of_state in [StateLaw::Ageing, StateLaw::Slip] {
            let law = law(of_state);
            for load in [-0.7, -0.02, 1e-3, 0.1, 0.55, 0.9] {
                for log in [-4.0, 0.0, 2.0] {
                    let step = 1e-6;
                    let of = |load: f64, log: f64| (law.slip(load, log), law.evolves(&law.slip(load, log), log));
                    let [by_load, by_log] = law.evolution_slopes(&law.slip(load, log), log);
                    let ((up, risen), (down, fallen)) = (of(load + step, log), of(load - step, log));
                    let (slope, right) = ((up.speed - down.speed) / (2.0 * step), law.slip(load, log).by_load);
                    assert!((slope / right - 1.0).abs() < 1e-7, "{load} {log}: {slope:e} {right:e}");
                    let scale = by_load.abs() + by_log.abs();
                    assert!(((risen - fallen) / (2.0 * step) - by_load).abs() < 1e-7 * scale, "{load} {log}");
                    let ((_, risen), (_, fallen)) = (of(load, log + step), of(load, log - step));
                    assert!(((risen - fallen) / (2.0 * step) - by_log).abs() < 1e-7 * scale, "{load} {log} {by_log:e}");
                }
            }
        }
    }
}
