//! Pixels that remember: Maxwell elements under every one of them.

use crate::material::Relaxation;
use crate::numerics::exponential::{cubic_remainder, decay, square_remainder};
use ndarray::{Array2, Zip};
use std::sync::Arc;

/// Most of the last step that one which goes on from it may be.
const LONGER: f64 = 2.0;

/// What the pixels have been through.
///
/// The surface of a body with E*(t) moves as u(t) = G P(t), where G is the influence of an elastic one with E* = 1 and P
/// the pressure \[per Pa\] that would move that one as far; the pressure itself is p(t) = ∫E*(t−s) dP(s), on every pixel
/// by itself (Lee & Radok 1960, for a constant Poisson's ratio). With E*(t) = E∞ + ΣEᵢ e^(−t/τᵢ) that is
/// p = E∞P + Σqᵢ + ηṖ with Maxwell's q̇ᵢ = EᵢṖ − qᵢ/τᵢ. In a step P is straight, and everything else is exact: a depth
/// that is held relaxes without error however long the step. Where a step goes on as the last one did, P is bent by as much
/// as its rates have changed from one to the other, so that what follows the rate at the end of a step, as a dashpot does, is
/// known to the second order (as in the backward differences of Curtiss & Hirschfelder 1952). What G makes of each part is
/// known from the displacements of the contacts and goes through the same sums.
#[derive(Debug, Clone)]
pub(super) struct Memory {
    relaxation: Arc<Relaxation>,
    /// P on each pixel.
    strain: Array2<f64>,
    /// G P, the displacement \[m\].
    moved: Array2<f64>,
    elements: Vec<Element>,
    /// What the last step changed, if the next goes on as it did, and how long it took \[s\].
    before: Option<(Change, f64)>,
    /// Modulus \[Pa\] in no time of bodies that are dashpots alone, which do not move then.
    rigid: f64,
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
    /// G B \[m Pa\].
    moved: Array2<f64>,
}

impl Step {
    /// The displacement \[m\] without any pressure.
    pub(super) fn free(&self) -> Array2<f64> {
        &self.moved * -self.modulus.recip()
    }
}

/// What a step changed: P, and G P \[m\].
#[derive(Debug, Clone)]
struct Change {
    strain: Array2<f64>,
    moved: Array2<f64>,
}

/// How a step goes on from the last one: of its end the rate is (1+b)m − bm′, where m and m′ are the mean rates of both.
#[derive(Debug, Clone, Copy, Default)]
struct Bend {
    /// b = ω/(1+ω), where ω is this step over the last.
    part: f64,
    /// ω.
    longer: f64,
}

/// Shares of a Maxwell element in a step: what is kept of its pressure, what is lost of it, the modulus it has against the
/// change of the step, Eᵢ(1−e)/y where that is straight, and against the change of the last step.
#[derive(Debug, Clone, Copy)]
struct Shares {
    kept: f64,
    lost: f64,
    /// Step over relaxation time.
    part: f64,
    modulus: f64,
    before: f64,
}

impl Shares {
    fn of(&(modulus, time): &(f64, f64), over: f64, bend: Bend) -> Self {
        let part = over / time;
        let (kept, lost) = decay(part);
        if part <= 0.0 {
            return Self { kept, lost, part, modulus, before: 0.0 };
        }
        // y − a − ay/2 with a = 1 − e^(−y), over y: what a rate that rises by one over the step adds.
        let rising = (cubic_remainder(part, lost) - 0.5 * lost * square_remainder(part, lost)) / part;
        let bent = 2.0 * bend.part * rising * modulus / part;
        Self { kept, lost, part, modulus: modulus * lost / part + bent, before: -bent * bend.longer }
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
    /// Pixels at rest; what takes no time finds bodies that are dashpots alone of the modulus `rigid` \[Pa\].
    pub(super) fn new(relaxation: Arc<Relaxation>, pixels: (usize, usize), rigid: f64) -> Self {
        let nothing = || Array2::zeros(pixels);
        let elements = relaxation.terms.iter().map(|_| Element { pressure: nothing(), moved: nothing() }).collect();
        Self { relaxation, strain: nothing(), moved: nothing(), elements, before: None, rigid, dissipated: 0.0 }
    }

    /// Numbers kept on each pixel.
    pub(super) fn fields(&self) -> usize {
        4 + 2 * self.elements.len()
    }

    /// The motion turns, and the next step does not go on as the last one.
    pub(super) fn turn(&mut self) {
        self.before = None;
    }

    /// How a step goes on from the last one, which it may be twice as long as.
    fn bend(&self, over: f64) -> Bend {
        let longer = self.before.as_ref().map_or(0.0, |(_, took)| over / took);
        if longer > LONGER { Bend::default() } else { Bend { part: longer / (1.0 + longer), longer } }
    }

    fn shares(&self, over: f64) -> impl Iterator<Item = Shares> {
        let bend = self.bend(over);
        self.relaxation.terms.iter().map(move |term| Shares::of(term, over, bend))
    }

    /// Modulus of the parallel dashpot in a step \[Pa\].
    fn drag(&self, over: f64) -> f64 {
        if self.relaxation.viscosity > 0.0 && over > 0.0 { self.relaxation.viscosity / over } else { 0.0 }
    }

    /// What the next `over` \[s\] answer with.
    pub(super) fn step(&self, over: f64) -> Step {
        let (bend, drag) = (self.bend(over), self.drag(over));
        let changing = self.shares(over).map(|shares| shares.modulus).sum::<f64>() + drag * (1.0 + bend.part);
        let (mut kept, mut moved) = (&self.strain * -changing, &self.moved * -changing);
        if let Some((before, _)) = self.before.as_ref().filter(|_| bend.part > 0.0) {
            let from = self.shares(over).map(|shares| shares.before).sum::<f64>() - drag * bend.part * bend.longer;
            kept.scaled_add(from, &before.strain);
            moved.scaled_add(from, &before.moved);
        }
        for (element, shares) in self.elements.iter().zip(self.shares(over)) {
            kept.scaled_add(shares.kept, &element.pressure);
            moved.scaled_add(shares.kept, &element.moved);
        }
        let modulus = self.relaxation.equilibrium + changing;
        Step { over, modulus: if modulus > 0.0 { modulus } else { self.rigid }, kept, moved }
    }

    /// Ends a step under the pressure `pressure` \[Pa\], pulls included, with the displacement `moved` \[m\].
    pub(super) fn take(&mut self, step: &Step, pressure: &Array2<f64>, moved: Array2<f64>) {
        let strain = (pressure - &step.kept) / step.modulus;
        let change = Change { strain: &strain - &self.strain, moved: &moved - &self.moved };
        let steps: Vec<Shares> = self.shares(step.over).collect();
        for ((element, shares), (modulus, _)) in self.elements.iter_mut().zip(steps).zip(&self.relaxation.terms) {
            let lost = element.take(shares, &change, self.before.as_ref().map(|(before, _)| before));
            self.dissipated += if *modulus > 0.0 { lost / modulus } else { 0.0 };
        }
        let drag = self.drag(step.over);
        if drag > 0.0 {
            self.dissipated += drag * dot(&change.strain, &change.moved);
        }
        (self.strain, self.moved) = (strain, moved);
        self.before = (step.over > 0.0).then_some((change, step.over));
    }

    /// Energy stored \[J per m² of a pixel\], where the surface is displaced by `displacement` \[m\].
    pub(super) fn stored(&self, displacement: &Array2<f64>) -> f64 {
        let lasting = self.relaxation.equilibrium * dot(&self.strain, displacement);
        let terms = self.elements.iter().zip(&self.relaxation.terms).filter(|(_, (modulus, _))| *modulus > 0.0);
        0.5 * (lasting
            + terms.map(|(element, (modulus, _))| dot(&element.pressure, &element.moved) / modulus).sum::<f64>())
    }

    /// The same where it is displaced by what is left of the past.
    pub(super) fn stored_apart(&self) -> f64 {
        self.stored(&self.moved)
    }

    /// Energy lost so far \[J per m² of a pixel\].
    pub(super) fn dissipated(&self) -> f64 {
        self.dissipated
    }
}

impl Element {
    /// Ends a step with its change after that of the last; Eᵢ times the energy lost in it.
    fn take(&mut self, shares: Shares, change: &Change, before: Option<&Change>) -> f64 {
        let mut added = Change { strain: &change.strain * shares.modulus, moved: &change.moved * shares.modulus };
        if let Some(before) = before.filter(|_| shares.before.abs() > 0.0) {
            added.strain.scaled_add(shares.before, &before.strain);
            added.moved.scaled_add(shares.before, &before.moved);
        }
        let (own, mixed) = (dot(&self.pressure, &self.moved), dot(&added.strain, &self.moved));
        let lost = shares.integral([own, mixed, dot(&added.strain, &added.moved)]);
        for (kept, added) in [(&mut self.pressure, &added.strain), (&mut self.moved, &added.moved)] {
            Zip::from(kept).and(added).for_each(|kept, added| *kept = shares.kept * *kept + added);
        }
        lost
    }
}

/// The sum of the products, pixel by pixel.
pub(super) fn dot(one: &Array2<f64>, other: &Array2<f64>) -> f64 {
    Zip::from(one).and(other).fold(0.0, |sum, one, other| sum + one * other)
}
