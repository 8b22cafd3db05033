//! Energy of one spring: the work done on it, what it stores, what its dashpots turn into heat.
//!
//! All per unit length of the bed, in closed form, each independent of the others.
//!
//! # Examples
//! ```
//! use springbed::contact::viscoelastic::Spectrum;
//! use springbed::material::Relaxation;
//!
//! // ½E∞u² + s²/2E: 2 of the spring of E∞ = 1 drawn by 2, and 2.25 of the element of E = 2 that bears 3.
//! let spring = Spectrum::new(&Relaxation { equilibrium: 1.0, terms: vec![(2.0, 1.0)], viscosity: 0.0 });
//! assert!((spring.stored_pressed(2.0, &[3.0]) - 4.25).abs() < 1e-15);
//! ```

use super::spring::{Free, Piece};
use super::{Element, Mode, Spectrum};
use crate::numerics::exponential::{cubic_remainder, decay, square_remainder};

/// Energies of a bed [J], or of one spring per unit length [J/m].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Ledger {
    /// Work done by the indenter.
    pub work: f64,
    /// Energy in the elastic parts.
    pub stored: f64,
    /// Energy turned into heat.
    pub dissipated: f64,
}

impl Spectrum {
    /// Energy ½E∞u² + Σ sᵢ²/2Eᵢ in a pressed spring.
    pub fn stored_pressed(&self, u: f64, s: &[f64]) -> f64 {
        let elements = self.terms().iter().zip(s).map(|(term, s)| 0.5 * s * (s / term.modulus));
        0.5 * self.equilibrium() * u * u + elements.sum::<f64>()
    }

    /// Energy Σ zₘ²/2Jₘ in a free spring.
    pub fn stored_free(&self, free: &Free) -> f64 {
        self.modes().iter().zip(&free.modes).map(|(mode, z)| 0.5 * z * (z / mode.compliance)).sum()
    }

    /// ∫ q dt [N s/m] over one piece of a spring's life.
    pub fn impulse(&self, piece: &Piece<'_>) -> f64 {
        let Piece::Pressed { u, s, speed, duration } = *piece else { return 0.0 };
        let element = |(term, s): (&Element, &f64)| impulse(term, *s, speed, duration);
        let elements: f64 = self.terms().iter().zip(s).map(element).sum();
        let steady = self.equilibrium() * (u + 0.5 * speed * duration) + self.viscosity() * speed;
        steady * duration + elements
    }

    /// Adds the work and the heat of one piece of a spring's life.
    pub fn account(&self, piece: &Piece<'_>, ledger: &mut Ledger) {
        match *piece {
            Piece::Pressed { s, speed, duration, .. } => {
                ledger.work += speed * self.impulse(piece);
                ledger.dissipated += self.heat_pressed(s, speed, duration);
            }
            Piece::Free { free, duration } => ledger.dissipated += self.heat_free(free, duration),
        }
    }

    /// Heat ηv²t + Σ ∫ sᵢ² dt/(Eᵢτᵢ) of a pressed spring.
    fn heat_pressed(&self, s: &[f64], v: f64, t: f64) -> f64 {
        let element = |(term, s): (&Element, &f64)| {
            let (a, ev) = (decay(t / term.time).1, term.modulus * v);
            let squares = 0.5 * s * s * a * (2.0 - a) + s * ev * term.time * a * a;
            squares / term.modulus + ev * v * term.time * term.time * cubic_remainder(t / term.time, a)
        };
        self.viscosity() * v * v * t + self.terms().iter().zip(s).map(element).sum::<f64>()
    }

    fn heat_free(&self, free: &Free, t: f64) -> f64 {
        let part = |(mode, z): (&Mode, &f64)| 0.5 * z * (z / mode.compliance) * decay(2.0 * t / mode.time).1;
        self.modes().iter().zip(&free.modes).map(part).sum()
    }
}

/// Load s [N/m] of a Maxwell element that was at rest and has moved at the speed `v` for the time `t`, and what ∫ s dt
/// is then.
pub(super) fn first_load(term: &Element, v: f64, t: f64) -> (f64, impl FnOnce() -> f64) {
    let y = t / term.time;
    let lost = decay(y).1;
    let (time, steady) = (term.time, term.modulus * v * term.time);
    (steady * lost, move || steady * (time * square_remainder(y, lost)))
}

/// ∫ s dt of a Maxwell element that starts at the load `s` and moves at the speed `v` for the time `t`.
pub(in crate::contact) fn impulse(term: &Element, s: f64, v: f64, t: f64) -> f64 {
    let y = t / term.time;
    let lost = decay(y).1;
    s * term.time * lost + term.modulus * v * term.time * (term.time * square_remainder(y, lost))
}
