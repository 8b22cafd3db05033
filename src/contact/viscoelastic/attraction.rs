//! What holds the edge of an adhesive contact.
//!
//! An edge spring at which the area grows by A′ = 2πa holds as long as |q| ≤ √(2πa E_c w) when pulled, and a free one joins as soon as the
//! tip is nearer to it than Δl = √(2πa w/E_c): one limit for both directions, √(2πaw/E_c) in lengths.
//! Joining and leaving move the spring by E_c alone, so that each costs or gives exactly w. What E_c and w are is
//! a choice: the relaxed modulus E∞ with w (a process zone long against the relaxation: the Maxwell elements keep
//! their state), the instantaneous modulus E(0) with w (a process zone of no length: they take their share), or E∞
//! with w[1 + (v/v₀)ⁿ] for an edge that opens at the speed v (Gent & Schultz 1972). A closing edge may have a
//! smaller work than an opening one; between the two limits it stands still.
//!
//! By E∞ a leaving spring moves by Q/E∞ under the loads s of its elements, whose dashpots do the work −ΣsQ/E∞ then: none
//! where the elements have relaxed, but where a pull faster than that has stretched them (s < 0) more than is lost
//! elsewhere. Quick pulls are beyond this rule, the balance of a run shows how far; by E(0) nothing is gained at any speed.
//! What a dashpot beside E∞ bears when the bodies are torn apart moves no spring: with it, one that leaves moves by the
//! limit at most.
//!
//! # Examples
//! ```
//! use springbed::contact::viscoelastic::{Spectrum, attraction::Attraction};
//! use std::f64::consts::TAU;
//!
//! // w = 50 mJ/m², E_c = 1 MPa, a = 0.1 mm: the edge holds √(2πa E_c w) = 5.6 N/m.
//! let edge = Attraction::relaxed(0.05, &Spectrum::elastic(1e6));
//! assert!((edge.strength(TAU * 1e-4, 0.0) - 31.415926535897932f64.sqrt()).abs() < 1e-12);
//! ```

use super::Spectrum;
use super::spring::Free;

/// What holds an edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attraction {
    /// Work of adhesion w [J/m²] of an opening edge.
    work: f64,
    /// Work of adhesion [J/m²] of a closing edge.
    closing: f64,
    /// Modulus E_c [Pa].
    modulus: f64,
    /// Whether the Maxwell elements take their share of a joining or leaving.
    shared: bool,
    /// Reference speed v₀ [m/s] and exponent n of the rate law.
    rate: Option<(f64, f64)>,
    /// Relative error of a step of an edge that obeys the rate law.
    accuracy: f64,
    /// Longest step of such an edge, as a part of a motion.
    longest: f64,
}

/// Relative error of a step of an edge that obeys a rate law, unless another is asked for.
const ACCURACY: f64 = 1e-7;

impl Attraction {
    /// E_c = E∞, for a work of adhesion w [J/m²]. A liquid does not hold by this rule.
    #[must_use]
    pub fn relaxed(work: f64, spectrum: &Spectrum) -> Self {
        let modulus = spectrum.equilibrium();
        Self { work, closing: work, modulus, shared: false, rate: None, accuracy: ACCURACY, longest: 1.0 }
    }

    /// E_c = E(0), for a work of adhesion w [J/m²].
    #[must_use]
    pub fn instantaneous(work: f64, spectrum: &Spectrum) -> Self {
        Self { modulus: spectrum.instantaneous(), shared: true, ..Self::relaxed(work, spectrum) }
    }

    /// E_c = E∞ and w[1 + (v/v₀)ⁿ], with the reference speed v₀ [m/s] and the exponent n.
    #[must_use]
    pub fn with_rate(work: f64, spectrum: &Spectrum, (speed, exponent): (f64, f64)) -> Self {
        Self { rate: Some((speed, exponent)), ..Self::relaxed(work, spectrum) }
    }

    /// The same with the work of adhesion `closing` [J/m²] of a closing edge, not above that of an opening one.
    #[must_use]
    pub fn closing(self, closing: f64) -> Self {
        Self { closing: closing.min(self.work), ..self }
    }

    /// The same, an edge that obeys the rate law followed to a relative error of `accuracy` per step.
    #[must_use]
    pub fn to_accuracy(self, accuracy: f64) -> Self {
        Self { accuracy, ..self }
    }

    /// The same, such an edge followed in steps no longer than this part of a motion: however smooth its way seems, it is
    /// then followed better than without.
    #[must_use]
    pub fn in_steps(self, longest: f64) -> Self {
        Self { longest, ..self }
    }

    /// Work of adhesion w [J/m²].
    #[must_use]
    pub fn work(&self) -> f64 {
        self.work
    }

    /// Whether the strength of an opening edge depends on its speed.
    pub(super) fn has_rate(&self) -> bool {
        self.rate.is_some() && self.work > 0.0
    }

    /// Relative error of a step of an edge that obeys the rate law.
    pub(super) fn accuracy(&self) -> f64 {
        self.accuracy
    }

    /// The same, if the edge obeys a rate law.
    pub(super) fn step_error(&self) -> Option<f64> {
        self.rate.map(|_| self.accuracy)
    }

    /// Longest step of such an edge, as a part of a motion.
    pub(super) fn longest(&self) -> f64 {
        self.longest
    }

    /// Line load √(A′E_c w_eff) [N/m] that an edge withstands that opens at the speed `v`; `slope` is A′ = 2πa [m], by
    /// which the area grows with the bed.
    #[must_use]
    pub fn strength(&self, slope: f64, v: f64) -> f64 {
        let enhanced = self.rate.map_or(1.0, |(speed, exponent)| 1.0 + (v / speed).powf(exponent));
        (slope * self.modulus * self.work * enhanced).sqrt()
    }

    /// Distance √(A′w/E_c) [m] over which an edge draws the next spring to it; `slope` is A′ = 2πa [m].
    #[must_use]
    pub fn reach(&self, slope: f64) -> f64 {
        if self.closing > 0.0 { (slope * self.closing / self.modulus).sqrt() } else { 0.0 }
    }

    /// A spring of the displacement `from`, its elements' loads `s`, moved by E_c alone to `to`.
    pub(super) fn moved(&self, spectrum: &Spectrum, (from, to): (f64, f64), s: &mut [f64]) {
        if self.shared {
            s.iter_mut().zip(spectrum.terms()).for_each(|(s, term)| *s += term.modulus * (to - from));
        }
    }

    /// A spring at `u` that carries the load `q` [N/m] let go where the area grows by `slope` [m]: it moves by E_c alone until
    /// it carries none. Behind a dashpot it moves no further than an edge at rest would draw it: whatever it is torn off with
    /// beyond that is of the speed, and ends with it.
    pub(super) fn let_go(&self, spectrum: &Spectrum, u: f64, (q, slope): (f64, f64), s: &mut [f64]) -> Free {
        let drawn = if spectrum.viscosity() > 0.0 { q.max(-self.strength(slope, 0.0)) } else { q };
        let to = u - drawn / self.modulus;
        self.moved(spectrum, (u, to), s);
        spectrum.let_go(to, s)
    }
}
