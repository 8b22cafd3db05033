//! Sums over a part of the bed, and how they change when all its springs move alike.

use super::Spectrum;
use super::alike::{Alike, Fading};
use super::spring::Spring;
use smallvec::{SmallVec, smallvec};

/// One number per Maxwell element or mode; up to four of them stand where they are kept.
pub(super) type Numbers = SmallVec<[f64; 4]>;

/// Σ w sᵢ and Σ w sᵢ² over pressed springs, Σ w zₘ² over free ones; w is the weight of a spring [m].
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Totals {
    /// Σ w sᵢ [N].
    pub loads: Numbers,
    /// Σ w sᵢ² [N²/m].
    pub squares: Numbers,
    /// Σ w zₘ² [m³].
    pub modes: Numbers,
}

impl Totals {
    pub(super) fn new(spectrum: &Spectrum) -> Self {
        let zeros: Numbers = smallvec![0.0; spectrum.terms().len()];
        Self { loads: zeros.clone(), squares: zeros, modes: smallvec![0.0; spectrum.modes().len()] }
    }

    /// Adds a spring of the weight `w`.
    pub(super) fn add(&mut self, spring: &Spring, w: f64) {
        match spring {
            Spring::Pressed(loads) => {
                for ((sum, square), s) in self.loads.iter_mut().zip(&mut self.squares).zip(loads) {
                    *sum += w * s;
                    *square += w * s * s;
                }
            }
            Spring::Free(free) => {
                self.modes.iter_mut().zip(&free.modes).for_each(|(sum, z)| *sum += w * z * z);
            }
        }
    }

    /// Adds the sums over other springs.
    pub(super) fn join(&mut self, others: &Self) {
        let pairs =
            [(&mut self.loads, &others.loads), (&mut self.squares, &others.squares), (&mut self.modes, &others.modes)];
        for (sums, added) in pairs {
            sums.iter_mut().zip(added).for_each(|(sum, more)| *sum += more);
        }
    }

    /// A motion in which no spring is touched or released; `weight` = Σ w of the pressed.
    pub(super) fn evolve(&mut self, motion: &Alike, weight: f64) {
        let sums = self.loads.iter_mut().zip(&mut self.squares);
        for ((load, square), &Fading { kept, gain, .. }) in sums.zip(&motion.elements) {
            let sum = kept * *load;
            *square = kept * kept * *square + gain * (2.0 * sum + weight * gain);
            *load = sum + weight * gain;
        }
        self.modes.iter_mut().zip(&motion.modes).for_each(|(sum, kept)| *sum *= kept * kept);
    }

    /// Σ of the energy in the Maxwell elements of the pressed springs and in the free ones [J].
    pub(super) fn stored(&self, spectrum: &Spectrum) -> f64 {
        let pressed = spectrum.terms().iter().zip(&self.squares).map(|(term, square)| 0.5 * square / term.modulus);
        let free = spectrum.modes().iter().zip(&self.modes).map(|(mode, square)| 0.5 * square / mode.compliance);
        pressed.sum::<f64>() + free.sum::<f64>()
    }
}
