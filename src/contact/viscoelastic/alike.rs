//! What a motion does to all springs that live through it alike.

use super::Spectrum;
use crate::numerics::exponential::{decay, square_remainder};

/// A motion of the speed v for the time t, in which no spring is touched or released, as its springs know it: the
/// exponentials are the same for every one of them.
#[derive(Debug, Clone)]
pub(super) struct Alike {
    pub(super) speed: f64,
    /// Of the Maxwell elements of pressed springs.
    pub(super) elements: Vec<Fading>,
    /// e^(−t/τ) of the modes of free springs.
    pub(super) modes: Vec<f64>,
}

/// What becomes of a Maxwell element.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fading {
    /// What is kept of a load, e^(−t/τ).
    pub(super) kept: f64,
    /// Load [N/m] gained beside it, Evτ(1 − e^(−t/τ)).
    pub(super) gain: f64,
    /// ∫ e^(−t′/τ) dt′ [s].
    lasted: f64,
    /// ∫ of what was gained [N s/m].
    swept: f64,
}

impl Alike {
    pub(super) fn new(spectrum: &Spectrum, speed: f64, duration: f64) -> Self {
        let element = |term: &super::Element| {
            let (y, rate) = (duration / term.time, term.modulus * speed * term.time);
            let (kept, lost) = decay(y);
            let (lasted, swept) = (term.time * lost, rate * (term.time * square_remainder(y, lost)));
            Fading { kept, gain: rate * lost, lasted, swept }
        };
        Self {
            speed,
            elements: spectrum.terms().iter().map(element).collect(),
            modes: spectrum.modes().iter().map(|mode| decay(duration / mode.time).0).collect(),
        }
    }

    /// Element loads after the motion, in place.
    pub(super) fn press(&self, loads: &mut [f64]) {
        loads.iter_mut().zip(&self.elements).for_each(|(s, fading)| *s = fading.kept * *s + fading.gain);
    }

    /// Σ ∫ s dt [N s] of the elements of pressed springs of the weight `weight` [m] that bear `loads` [N] together.
    pub(super) fn impulse(&self, loads: &[f64], weight: f64) -> f64 {
        loads.iter().zip(&self.elements).map(|(s, fading)| s * fading.lasted + weight * fading.swept).sum()
    }
}
