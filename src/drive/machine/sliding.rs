//! A mass that slides under a constant friction, drawn by a spring: the motion is linear, and known in closed form.

use super::Suspension;
use crate::numerics::root;
use std::f64::consts::{PI, TAU};

/// m z̈ + cż + kz = 0 about the place that moves on with the far end of the spring.
///
/// z is how far the mass is ahead of X − (cV + f)/k, X = X₀ + Vt the far end and f the friction; k > 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Slide {
    /// Speed V of the far end [m/s].
    drawn: f64,
    /// z and ż at the beginning.
    start: (f64, f64),
    decay: Decay,
}

/// The roots of m s² + cs + k.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Decay {
    /// −γ ± iω.
    Swings { rate: f64, pulse: f64 },
    /// −γ twice.
    Critical { rate: f64 },
    /// −slow and −fast.
    Creeps { slow: f64, fast: f64 },
}

impl Decay {
    fn of(suspension: &Suspension) -> Self {
        let Suspension { mass, stiffness, damping } = *suspension;
        let (rate, square) = (0.5 * damping / mass, stiffness / mass);
        // ω² − γ² by its factors, which keeps digits near the critical damping.
        let natural = square.sqrt();
        let split = (natural - rate) * (natural + rate);
        if split > 0.0 {
            Self::Swings { rate, pulse: split.sqrt() }
        } else if split < 0.0 {
            let fast = rate + (-split).sqrt();
            Self::Creeps { slow: square / fast, fast }
        } else {
            Self::Critical { rate }
        }
    }
}

impl Slide {
    /// A mass with the speed `speed` [m/s] under the spring force `pull` [N] and the friction `friction` [N], which acts
    /// against a motion onwards; the far end of the spring goes on at `drawn` [m/s].
    pub(super) fn new(suspension: &Suspension, (pull, speed): (f64, f64), (friction, drawn): (f64, f64)) -> Self {
        // k z = cV + f − pull.
        let ahead = (suspension.damping * drawn + friction - pull) / suspension.stiffness;
        Self { drawn, start: (ahead, speed - drawn), decay: Decay::of(suspension) }
    }

    /// Way [m] since the beginning and speed [m/s] at the time `time` [s].
    pub(super) fn at(&self, time: f64) -> (f64, f64) {
        let (z, w) = self.relative(time);
        (self.drawn * time + (z - self.start.0), self.drawn + w)
    }

    /// z and ż.
    fn relative(&self, t: f64) -> (f64, f64) {
        let (z, w) = self.start;
        match self.decay {
            Decay::Swings { rate, pulse } => {
                let (sine, cosine) = (pulse * t).sin_cos();
                let (fall, b) = ((-rate * t).exp(), (w + rate * z) / pulse);
                let square = rate * rate + pulse * pulse;
                (fall * (z * cosine + b * sine), fall * (w * cosine - (rate * w + square * z) / pulse * sine))
            }
            Decay::Critical { rate } => {
                let (fall, b) = ((-rate * t).exp(), w + rate * z);
                (fall * (z + b * t), fall * (w - rate * b * t))
            }
            Decay::Creeps { slow, fast } => {
                let (one, two) = self.parts(slow, fast);
                let (gentle, steep) = ((-slow * t).exp(), (-fast * t).exp());
                (one * gentle + two * steep, -slow * one * gentle - fast * two * steep)
            }
        }
    }

    /// z = Ae^{−slow t} + Be^{−fast t}.
    fn parts(&self, slow: f64, fast: f64) -> (f64, f64) {
        let (z, w) = self.start;
        ((w + fast * z) / (fast - slow), -(w + slow * z) / (fast - slow))
    }

    /// When a mass that moves on in the direction `ahead`, 1 or −1, comes to rest [s]; `None` if it never does.
    pub(super) fn rest(&self, ahead: f64) -> Option<f64> {
        let onwards = |t: f64| ahead * self.at(t).1;
        let (from, to) = match self.decay {
            Decay::Swings { rate, pulse } => self.falling_half(ahead, (rate, pulse)),
            Decay::Critical { rate } => {
                // ẅ… = 0: z̈ = e^{−γt}(−2γb + γ²z + γ²bt), its zero where the speed is extreme.
                let b = self.start.1 + rate * self.start.0;
                self.monotone(ahead, 2.0 / rate - self.start.0 / b)
            }
            Decay::Creeps { slow, fast } => {
                let (one, two) = self.parts(slow, fast);
                self.monotone(ahead, (-(fast * fast * two) / (slow * slow * one)).ln() / (fast - slow))
            }
        }?;
        // Brackets that rounding leaves open have no root.
        if onwards(from) < 0.0 || onwards(to) > 0.0 {
            return None;
        }
        root::brent(onwards, from, to).ok()
    }

    /// From the beginning, or an extreme of the speed, to the first extreme at which the mass would go back: the first or the
    /// second one, for later ones are less. A slide that begins in balance has one at its very beginning.
    fn falling_half(&self, ahead: f64, (rate, pulse): (f64, f64)) -> Option<(f64, f64)> {
        // z̈ = 0: ż falls between its extremes, at (w cos − C sin)′ = 0.
        let (z, w) = self.start;
        let square = rate * rate + pulse * pulse;
        let c = (rate * w + square * z) / pulse;
        // ż = e^{−γt}(w cos ωt − c sin ωt); z̈ ∝ −(γw + ωc) cos ωt + (γc − ωw) sin ωt.
        let (p, q) = (-(rate * w + pulse * c), rate * c - pulse * w);
        let phase = (-p).atan2(q);
        // Extremes at phase + nπ.
        let first = phase.rem_euclid(PI) / pulse;
        let half = PI / pulse;
        let extremes = [0.0, first, first + half, first + 2.0 * half];
        let between = extremes.windows(2).find(|pair| ahead * self.at(pair[1]).1 < 0.0)?;
        Some((between[0], between[1]))
    }

    /// A bracket for a speed with one extreme at most, at `extreme` [s].
    fn monotone(&self, ahead: f64, extreme: f64) -> Option<(f64, f64)> {
        let onwards = |t: f64| ahead * self.at(t).1;
        let turns = extreme.is_finite() && extreme > 0.0;
        if turns && onwards(extreme) < 0.0 {
            return Some((0.0, extreme));
        }
        // Behind the extreme the speed tends to that of the far end.
        if ahead * self.drawn > 0.0 || (ahead * self.drawn >= 0.0 && (!turns || onwards(extreme) > 0.0)) {
            return None;
        }
        let from = if turns { extreme } else { 0.0 };
        let mut to = from + self.time();
        for _ in 0..64 {
            if onwards(to) < 0.0 {
                return Some((from, to));
            }
            to += to - from;
        }
        None
    }

    /// The slowest time of the decay [s].
    fn time(&self) -> f64 {
        match self.decay {
            Decay::Swings { pulse, .. } => TAU / pulse,
            Decay::Critical { rate } => rate.recip(),
            Decay::Creeps { slow, .. } => slow.recip(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A mass that starts from rest under a drawn-out spring and no drive goes twice the way to its rest, in half a period.
    #[test]
    fn without_drive_a_slide_is_half_a_swing() {
        let suspension = Suspension { mass: 2.0, stiffness: 8.0, damping: 0.0 };
        let slide = Slide::new(&suspension, (5.0, 0.0), (3.0, 0.0));
        let rest = slide.rest(1.0).unwrap();
        assert!((rest - PI / 2.0).abs() < 1e-15, "{rest:e}");
        assert!((slide.at(rest).0 - 2.0 * (5.0 - 3.0) / 8.0).abs() < 1e-15);
    }

    /// A slide in balance whose far end turns round: the speed falls from an extreme at the beginning, and the mass comes to
    /// rest and no further.
    #[test]
    fn a_slide_in_balance_turns_round() {
        for damping in [0.01, 0.1, 0.63, 3.0] {
            for friction in [0.1, 0.26666666666666666, 0.7] {
                let (drawn, suspension) = (0.0316, Suspension { mass: 0.141, stiffness: 0.708, damping });
                let slide = Slide::new(&suspension, (friction + damping * drawn, drawn), (friction, -drawn));
                let rest = slide.rest(1.0).unwrap();
                assert!(rest > 0.0 && slide.at(rest).1.abs() < 1e-12, "{damping} {friction}: {rest}");
            }
        }
    }

    /// Whatever the damping, way and speed obey the equation of motion, and the rest is the first.
    #[test]
    fn slides_obey_their_equation() {
        for damping in [0.0, 0.3, 3.9, 4.0, 4.1, 40.0] {
            for (speed, drawn, ahead) in [(0.0, 0.1, 1.0), (0.5, 0.1, 1.0), (0.5, -0.1, 1.0), (-0.5, 0.1, -1.0)] {
                let suspension = Suspension { mass: 1.0, stiffness: 4.0, damping };
                let (pull, friction) = (ahead * 2.0, ahead);
                let slide = Slide::new(&suspension, (pull, speed), (friction, drawn));
                let step = 1e-4;
                for k in 0..50 {
                    let t = 0.05 * f64::from(k) + step;
                    let ((before, _), (way, fast), (behind, _)) = (slide.at(t - step), slide.at(t), slide.at(t + step));
                    let second = (before - 2.0 * way + behind) / (step * step);
                    let off = second + damping * fast + 4.0 * (way - drawn * t) - pull + friction;
                    assert!(off.abs() < 1e-4 * (1.0 + damping), "{damping} {t}: {off:e}");
                }
                let rest = slide.rest(ahead);
                let until = rest.unwrap_or(30.0);
                let grid = (1..3000).map(|k| until * f64::from(k) / 3000.0);
                for t in grid {
                    assert!(ahead * slide.at(t).1 > -1e-12, "{damping} {speed} {drawn}: {t} of {rest:?}");
                }
                if let Some(rest) = rest {
                    assert!(slide.at(rest).1.abs() < 1e-12 && rest > 0.0, "{damping} {rest:e}");
                }
            }
        }
    }
}
