//! Pixels that remember: Maxwell elements under every one of them.

use crate::halfspace::SurfaceResponse;
use crate::material::Relaxation;
use crate::numerics::exponential::{cubic_remainder, decay};
use ndarray::{Array2, Zip};
use std::sync::Arc;

/// What the pixels have been through.
///
/// The surface of a body with E*(t) moves as u(t) = G P(t), where G is the influence of an elastic one with E* = 1 and P
/// the pressure \[per Pa\] that would move that one as far; the pressure itself is p(t) = ∫E*(t−s) dP(s), on every pixel
/// by itself (Lee & Radok 1960, for a constant Poisson's ratio). With E*(t) = E∞ + ΣEᵢ e^(−t/τᵢ) that is
/// p = E∞P + Σqᵢ + ηṖ with Maxwell's q̇ᵢ = EᵢṖ − qᵢ/τᵢ. In a step P is straight, and everything else is exact: a depth
/// that is held relaxes without error however long the step.
#[derive(Debug, Clone)]
pub(super) struct Memory {
    relaxation: Arc<Relaxation>,
    /// P on each pixel.
    strain: Array2<f64>,
    elements: Vec<Element>,
    /// Energy lost so far \[J\].
    dissipated: f64,
}

/// One Maxwell element under every pixel.
#[derive(Debug, Clone)]
struct Element {
    /// Its pressure q \[Pa\].
    pressure: Array2<f64>,
    /// G q \[m Pa\].
    moved: Array2<f64>,
}

/// A step of the time: within it p = A P + B.
#[derive(Debug)]
pub(super) struct Step {
    over: f64,
    /// A \[Pa\].
    pub(super) modulus: f64,
    /// B \[Pa\].
    pub(super) kept: Array2<f64>,
}

/// Shares of a Maxwell element in a step: what is kept of its pressure, what is lost of it, and the modulus Eᵢ(1−e)/y
/// against a straight change.
#[derive(Debug, Clone, Copy)]
struct Shares {
    kept: f64,
    lost: f64,
    /// Step over relaxation time.
    part: f64,
    modulus: f64,
}

impl Shares {
    fn of(&(modulus, time): &(f64, f64), over: f64) -> Self {
        let part = over / time;
        let (kept, lost) = decay(part);
        Self { kept, lost, part, modulus: if part > 0.0 { modulus * lost / part } else { modulus } }
    }

    /// ∫(q·Gq) over the step, over τ, from q·Gq, c·Gq and c·Gc, where c is what was added to q: q(s) goes from q as
    /// q e^(−s/τ) + c (1−e^(−s/τ))/(1−e).
    fn integral(self, [own, mixed, added]: [f64; 3]) -> f64 {
        let square =
            if self.lost > 0.0 { cubic_remainder(self.part, self.lost) / (self.lost * self.lost) } else { 0.0 };
        0.5 * self.lost * (1.0 + self.kept) * own + self.lost * mixed + square * added
    }
}

impl Memory {
    pub(super) fn new(relaxation: Arc<Relaxation>, pixels: (usize, usize)) -> Self {
        let nothing = || Array2::zeros(pixels);
        let elements = relaxation.terms.iter().map(|_| Element { pressure: nothing(), moved: nothing() }).collect();
        Self { relaxation, strain: nothing(), elements, dissipated: 0.0 }
    }

    /// Numbers kept on each pixel.
    pub(super) fn fields(&self) -> usize {
        1 + 2 * self.elements.len()
    }

    fn shares(&self, over: f64) -> impl Iterator<Item = Shares> {
        self.relaxation.terms.iter().map(move |term| Shares::of(term, over))
    }

    /// Modulus of the parallel dashpot in a step \[Pa\].
    fn drag(&self, over: f64) -> f64 {
        if self.relaxation.viscosity > 0.0 && over > 0.0 { self.relaxation.viscosity / over } else { 0.0 }
    }

    /// What the next `over` \[s\] answer with.
    pub(super) fn step(&self, over: f64) -> Step {
        let changing = self.shares(over).map(|shares| shares.modulus).sum::<f64>() + self.drag(over);
        let mut kept = &self.strain * -changing;
        for (element, shares) in self.elements.iter().zip(self.shares(over)) {
            kept.scaled_add(shares.kept, &element.pressure);
        }
        Step { over, modulus: self.relaxation.equilibrium + changing, kept }
    }

    /// Ends a step under the pressure `pressure` \[Pa\], pulls included.
    pub(super) fn take(&mut self, step: &Step, pressure: &Array2<f64>, response: &SurfaceResponse) {
        let strain = (pressure - &step.kept) / step.modulus;
        let change = &strain - &self.strain;
        let steps: Vec<Shares> = self.shares(step.over).collect();
        for ((element, shares), (modulus, _)) in self.elements.iter_mut().zip(steps).zip(&self.relaxation.terms) {
            let lost = element.take(shares, &change, response);
            self.dissipated += if *modulus > 0.0 { lost / modulus } else { 0.0 };
        }
        let drag = self.drag(step.over);
        if drag > 0.0 {
            self.dissipated += drag * dot(&change, &response.displacement(change.view(), 1.0));
        }
        self.strain = strain;
    }

    /// Energy stored \[J per m² of a pixel\], where the surface is displaced by `displacement` \[m\].
    pub(super) fn stored(&self, displacement: &Array2<f64>) -> f64 {
        let lasting = self.relaxation.equilibrium * dot(&self.strain, displacement);
        let terms = self.elements.iter().zip(&self.relaxation.terms).filter(|(_, (modulus, _))| *modulus > 0.0);
        0.5 * (lasting
            + terms.map(|(element, (modulus, _))| dot(&element.pressure, &element.moved) / modulus).sum::<f64>())
    }

    /// Energy lost so far \[J per m² of a pixel\].
    pub(super) fn dissipated(&self) -> f64 {
        self.dissipated
    }
}

impl Element {
    /// Ends a step in which P changed by `change`; Eᵢ times the energy lost in it.
    fn take(&mut self, shares: Shares, change: &Array2<f64>, response: &SurfaceResponse) -> f64 {
        let before = self.clone();
        Zip::from(&mut self.pressure).and(change).for_each(|q, dp| *q = shares.kept * *q + shares.modulus * dp);
        self.moved = response.displacement(self.pressure.view(), 1.0);
        let added = |after: &Array2<f64>, before: &Array2<f64>| after - &(before * shares.kept);
        let (pressure, moved) = (added(&self.pressure, &before.pressure), added(&self.moved, &before.moved));
        shares.integral([dot(&before.pressure, &before.moved), dot(&pressure, &before.moved), dot(&pressure, &moved)])
    }
}

fn dot(one: &Array2<f64>, other: &Array2<f64>) -> f64 {
    Zip::from(one).and(other).fold(0.0, |sum, one, other| sum + one * other)
}
