//! The opening edge of an adhesive contact.
//!
//! The edge springs hold while q(a)² < 2πa E_c w_eff. What E_c and w_eff are is a choice: the relaxed
//! modulus E∞ with w (a process zone long against the relaxation), the instantaneous modulus E(0)
//! with w (a process zone of no length), or E∞ with w[1 + (v/v₀)ⁿ] for an edge that opens at the speed
//! v (Gent & Schultz 1972). A closing edge attaches where the indenter touches a spring.

use super::Spectrum;
use std::f64::consts::TAU;

/// What holds an opening edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attraction {
    /// Work of adhesion w [J/m²].
    work: f64,
    /// Modulus E_c [Pa].
    modulus: f64,
    /// Reference speed v₀ [m/s] and exponent n of the rate law.
    pub(super) rate: Option<(f64, f64)>,
    /// Least number of steps in which an opening edge is followed; default 64.
    pub(super) steps: f64,
}

impl Attraction {
    /// E_c = E∞, for a work of adhesion w [J/m²]. A liquid does not hold by this rule.
    #[must_use]
    pub fn relaxed(work: f64, spectrum: &Spectrum) -> Self {
        Self { work, modulus: spectrum.equilibrium(), rate: None, steps: STEPS }
    }

    /// E_c = E(0), for a work of adhesion w [J/m²].
    #[must_use]
    pub fn instantaneous(work: f64, spectrum: &Spectrum) -> Self {
        Self { work, modulus: spectrum.instantaneous(), rate: None, steps: STEPS }
    }

    /// E_c = E∞ and w[1 + (v/v₀)ⁿ], with the reference speed v₀ [m/s] and the exponent n.
    #[must_use]
    pub fn with_rate(work: f64, spectrum: &Spectrum, (speed, exponent): (f64, f64)) -> Self {
        Self { work, modulus: spectrum.equilibrium(), rate: Some((speed, exponent)), steps: STEPS }
    }

    /// The same, an opening edge followed in half the steps: to tell the error of following it.
    #[must_use]
    pub fn refined(self) -> Self {
        Self { steps: 2.0 * self.steps, ..self }
    }

    /// What is left when the edge is let go at once.
    #[must_use]
    pub fn without_work(self) -> Self {
        Self { work: 0.0, ..self }
    }

    /// Line load √(2πa E_c w_eff) [N/m] that an edge at `a`, opening at the speed `v`, withstands.
    #[must_use]
    pub fn strength(&self, a: f64, v: f64) -> f64 {
        let enhanced = self.rate.map_or(1.0, |(speed, exponent)| 1.0 + (v / speed).powf(exponent));
        (TAU * a * self.modulus * self.work * enhanced).sqrt()
    }
}

/// Steps in which an opening edge is followed, unless a finer path is asked for.
const STEPS: f64 = 64.0;

/// When the springs under the heights c of the indenter were torn off: c falls, time grows.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tear(pub(super) Vec<(f64, f64)>);

impl Tear {
    /// Time [s] in the motion at which the spring under the height `c` was torn off.
    pub(super) fn time(&self, c: f64) -> f64 {
        let k = self.0.partition_point(|&(height, _)| height > c).clamp(1, self.0.len().max(2) - 1);
        let (Some(&(high, early)), Some(&(low, late))) = (self.0.get(k - 1), self.0.get(k)) else { return 0.0 };
        let part = if high > low { ((high - c) / (high - low)).clamp(0.0, 1.0) } else { 1.0 };
        early + part * (late - early)
    }
}
