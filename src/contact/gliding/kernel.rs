//! A spring over a straight piece of its way, with what depends on the duration alone computed once.

use super::tally::Tally;
use crate::contact::viscoelastic::spring::{Free, Motion, Spring};
use crate::contact::viscoelastic::{Element, Mode, Spectrum};
use crate::numerics::exponential::{cubic_remainder, decay, square_remainder};
use std::sync::Arc;

/// The steps of springs of one material.
#[derive(Debug, Clone)]
pub(super) struct Kernel {
    spectrum: Arc<Spectrum>,
    duration: f64,
    elements: Vec<Held>,
    modes: Vec<Fading>,
}

/// What a duration makes of a Maxwell element of the load s under the speed u̇.
#[derive(Debug, Clone, Copy)]
struct Held {
    /// e^(−h/τ): what is kept of s.
    keep: f64,
    /// Eτ(1 − e^(−h/τ)): what u̇ adds.
    push: f64,
    /// ∫ s dt over s, and over u̇.
    impulse: [f64; 2],
    /// Heat over s², s u̇ and u̇².
    heat: [f64; 3],
}

/// What a duration makes of a mode of recovery z.
#[derive(Debug, Clone, Copy)]
struct Fading {
    keep: f64,
    /// ∫ z dt over z.
    integral: f64,
    /// Heat over z².
    heat: f64,
}

impl Held {
    fn of(element: &Element, duration: f64) -> Self {
        let Element { modulus, time } = *element;
        let y = duration / time;
        let (keep, lost) = decay(y);
        Self {
            keep,
            push: modulus * time * lost,
            impulse: [time * lost, modulus * time * (time * square_remainder(y, lost))],
            heat: [
                0.5 * lost * (2.0 - lost) / modulus,
                time * lost * lost,
                modulus * time * (time * cubic_remainder(y, lost)),
            ],
        }
    }
}

impl Fading {
    fn of(mode: &Mode, duration: f64) -> Self {
        let y = duration / mode.time;
        let (keep, lost) = decay(y);
        Self { keep, integral: mode.time * lost, heat: 0.5 * decay(2.0 * y).1 / mode.compliance }
    }
}

impl Kernel {
    pub fn new(spectrum: Arc<Spectrum>) -> Self {
        Self { spectrum, duration: f64::NAN, elements: Vec::new(), modes: Vec::new() }
    }

    pub fn spectrum(&self) -> &Spectrum {
        &self.spectrum
    }

    /// Makes ready for pieces of the duration `duration` [s].
    pub fn prepare(&mut self, duration: f64) {
        if self.duration.total_cmp(&duration).is_ne() {
            self.duration = duration;
            self.elements.clear();
            self.elements.extend(self.spectrum.terms().iter().map(|element| Held::of(element, duration)));
            self.modes.clear();
            self.modes.extend(self.spectrum.modes().iter().map(|mode| Fading::of(mode, duration)));
        }
    }

    /// Takes a spring through a motion of the duration made ready.
    pub fn step(&self, spring: &mut Spring, motion: &Motion, tally: &mut Tally) {
        match spring {
            Spring::Pressed(loads) if self.stays_pressed(loads, motion) => self.press(loads, motion, tally),
            Spring::Free(free) if self.stays_free(free, motion) => self.recover(free, tally),
            Spring::Pressed(_) | Spring::Free(_) => {
                let before = std::mem::replace(spring, Spring::Pressed(Vec::new()));
                *spring = before.follow(&self.spectrum, motion, &mut |piece| tally.note(&self.spectrum, piece));
            }
        }
    }

    /// Whether a pressed spring carries at the end: its load changes sign at most once.
    fn stays_pressed(&self, loads: &[f64], motion: &Motion) -> bool {
        if motion.speed >= 0.0 {
            return true;
        }
        let moved = self.elements.iter().zip(loads).map(|(held, s)| held.keep * s + held.push * motion.speed);
        let steady = self.spectrum.equilibrium() * motion.end() + self.spectrum.viscosity() * motion.speed;
        steady + moved.sum::<f64>() >= 0.0
    }

    fn press(&self, loads: &mut [f64], motion: &Motion, tally: &mut Tally) {
        let Motion { start, speed, duration } = *motion;
        let (mut impulse, mut heat) = (0.0, 0.0);
        for (element, (held, s)) in self.elements.iter().zip(loads).enumerate() {
            let integral = held.impulse[0] * *s + held.impulse[1] * speed;
            if let Some(diary) = &mut tally.diary {
                diary.load(element, integral);
            }
            impulse += integral;
            heat += *s * (held.heat[0] * *s + held.heat[1] * speed) + held.heat[2] * speed * speed;
            *s = held.keep * *s + held.push * speed;
        }
        let dashpot = self.spectrum.viscosity() * speed;
        impulse += (self.spectrum.equilibrium() * (start + 0.5 * speed * duration) + dashpot) * duration;
        heat += dashpot * speed * duration;
        tally.press((speed, duration), (impulse, heat));
    }

    /// Whether the profile is above a free spring at both ends, and cannot have met it between them: u is convex.
    fn stays_free(&self, free: &Free, motion: &Motion) -> bool {
        let (mut before, mut after) = (free.rest, free.rest);
        let (mut first, mut last) = (0.0, 0.0);
        for ((mode, fading), z) in self.spectrum.modes().iter().zip(&self.modes).zip(&free.modes) {
            let (kept, rate) = (fading.keep * z, mode.time.recip());
            (before, after) = (before + z, after + kept);
            (first, last) = (first - z * rate, last - kept * rate);
        }
        let apart = before > motion.start && after > motion.end();
        apart && (motion.speed >= 0.0 || first >= motion.speed || last <= motion.speed)
    }

    fn recover(&self, free: &mut Free, tally: &mut Tally) {
        let mut heat = 0.0;
        for (mode, (fading, z)) in self.modes.iter().zip(&mut free.modes).enumerate() {
            if let Some(diary) = &mut tally.diary {
                diary.mode(mode, fading.integral * *z);
            }
            heat += fading.heat * *z * *z;
            *z *= fading.keep;
        }
        tally.free(self.duration, heat);
    }
}
