//! The opening edge of an adhesive contact.
//!
//! The edge springs hold while q(a)² < 2πa E_c w_eff. What E_c and w_eff are is a choice: the relaxed
//! modulus E∞ with w (a process zone long against the relaxation), the instantaneous modulus E(0)
//! with w (a process zone of no length), or E∞ with w[1 + (v/v₀)ⁿ] for an edge that opens at the speed
//! v (Gent & Schultz 1972). A closing edge attaches where the indenter touches a spring.

use super::Spectrum;
use super::memory::Memory;
use super::spring::Motion;
use crate::numerics::root;
use std::f64::consts::TAU;

/// What holds an opening edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attraction {
    /// Work of adhesion w [J/m²].
    work: f64,
    /// Modulus E_c [Pa].
    modulus: f64,
    /// Reference speed v₀ [m/s] and exponent n of the rate law.
    rate: Option<(f64, f64)>,
    /// Least number of steps in which an opening edge is followed; default 64.
    steps: f64,
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

/// When the springs under the heights c of the indenter were torn off: c falls, time grows.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tear(Vec<(f64, f64)>);

impl Tear {
    /// Time [s] in the motion at which the spring under the height `c` was torn off.
    pub(super) fn time(&self, c: f64) -> f64 {
        let k = self.0.partition_point(|&(height, _)| height > c).clamp(1, self.0.len().max(2) - 1);
        let (Some(&(high, early)), Some(&(low, late))) = (self.0.get(k - 1), self.0.get(k)) else { return 0.0 };
        let part = if high > low { ((high - c) / (high - low)).clamp(0.0, 1.0) } else { 1.0 };
        early + part * (late - early)
    }
}

/// How the edge opens in a motion.
#[derive(Debug, Clone)]
pub(super) struct Opening {
    /// Radius at the end [m].
    pub left: f64,
    /// Times [s] and radii [m].
    path: Vec<(f64, f64)>,
}

impl Opening {
    pub(super) fn tear(&self, height: impl Fn(f64) -> f64) -> Tear {
        Tear(self.path.iter().map(|&(t, a)| (height(a), t)).collect())
    }

    /// When the bodies part [s].
    pub(super) fn parting(&self) -> Option<f64> {
        self.path.iter().find(|&&(_, a)| a <= 0.0).map(|&(t, _)| t)
    }
}

/// Steps in which an opening edge is followed, unless a finer path is asked for.
const STEPS: f64 = 64.0;
/// Relative change of the radius beyond which a step is halved, and the step that is not.
const LEAP: f64 = 0.02;

/// Follows the edge from `reached` inwards.
///
/// Steps are halved until the radius changes by little; what changes at once in a step of no
/// duration is a jump.
pub(super) fn opening(bed: &Memory, attraction: &Attraction, motion: &Motion, reached: f64) -> Opening {
    let mut path = vec![(0.0, reached)];
    let (mut now, mut a, mut step) = (0.0, reached, motion.duration / attraction.steps);
    while now < motion.duration && a > 0.0 {
        let until = if motion.duration - now <= step * (1.0 + 1e-9) { motion.duration } else { now + step };
        let next = advanced(bed, (attraction, motion), (now, a), until);
        let bit = 4.0 * f64::EPSILON * motion.duration;
        if a - next > LEAP * a && until - now > bit {
            step = 0.5 * (until - now);
            continue;
        }
        if next < a {
            path.push((now, a));
            path.push((until, next));
        }
        (now, a) = (until, next);
        step = (1.5 * step).max(bit).min(motion.duration / attraction.steps);
    }
    Opening { left: a, path }
}

/// The edge after one step; with a rate law, two half steps and one whole one extrapolated.
fn advanced(bed: &Memory, law: (&Attraction, &Motion), (now, a): (f64, f64), until: f64) -> f64 {
    let whole = stepped(bed, law, (now, a), until);
    if law.0.rate.is_none() || whole >= a || whole <= 0.0 {
        return whole;
    }
    let middle = stepped(bed, law, (now, a), 0.5 * (now + until));
    let halves = stepped(bed, law, (0.5 * (now + until), middle), until);
    if halves > 0.0 { (2.0 * halves - whole).clamp(0.0, a) } else { 0.0 }
}

/// The largest radius not above `a` that holds at the time `until` (implicit in the speed of the edge).
fn stepped(bed: &Memory, (attraction, motion): (&Attraction, &Motion), (now, a): (f64, f64), until: f64) -> f64 {
    let seen = Motion { duration: until, ..*motion };
    let margin = |x: f64| bed.continued_load(x, &seen) + attraction.strength(x, (a - x) / (until - now));
    if margin(a) >= 0.0 {
        return a;
    }
    let (mut outer, mut reach) = (a, 1e-5 * a);
    let mut best = (a, a, margin(a));
    while outer > 0.0 {
        let inner = (outer - reach).max(0.0);
        let found = margin(inner);
        if found >= 0.0 && inner > 0.0 {
            return root::brent(margin, inner, outer).unwrap_or(inner);
        }
        if found > best.2 {
            best = (inner, outer, found);
        }
        (outer, reach) = (inner, (1.5 * reach).min(a / 64.0));
    }
    last_hold(&margin, (best.0 - (best.1 - best.0).max(1e-5 * a), best.1))
}

/// Just before the edge gives way, the stretch that holds is narrower than any step: the greatest
/// margin between the neighbours of the best place seen, by the golden section.
fn last_hold(margin: &impl Fn(f64) -> f64, (mut low, mut high): (f64, f64)) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let outer = high;
    let (mut left, mut right) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
    let (mut at_left, mut at_right) = (margin(left), margin(right));
    for _ in 0..60 {
        if at_left.max(at_right) >= 0.0 {
            let holds = if at_right >= 0.0 { right } else { left };
            return root::brent(margin, holds, outer).unwrap_or(holds);
        }
        if at_left > at_right {
            (high, right, at_right) = (right, left, at_left);
            left = high - GOLDEN * (high - low);
            at_left = margin(left);
        } else {
            (low, left, at_left) = (left, right, at_right);
            right = low + GOLDEN * (high - low);
            at_right = margin(right);
        }
    }
    0.0
}
