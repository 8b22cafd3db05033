//! Pressure on one grid: preconditioned conjugate gradients on the present contact, which is then
//! corrected pixel by pixel until no pressure pulls, none is above the hardness, and no gap is closed beyond the
//! tolerance. Under the hardness a pixel yields: its pressure stays, and the surfaces overlap by what is dented.

mod step;

use rayon::prelude::*;

use super::grid::Operators;
use super::precision::{Precision, Scratch};
use super::vector::{each, each_mut, fold, total, update};

/// What is prescribed, in the solver's units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Goal {
    /// The approach.
    Approach(f64),
    /// The sum of the pressures.
    Sum(f64),
}

/// The contact on one grid.
pub(super) struct GridContact<'a> {
    /// Pressure → displacement, and back.
    pub(super) operators: &'a Operators,
    /// Heights of the indenter, +∞ where it has no material.
    pub(super) heights: &'a [f64],
    /// What is prescribed.
    pub(super) goal: Goal,
    /// Largest pressure; infinite for bodies that do not yield, and under a prescribed sum.
    pub(super) hardness: f64,
}

/// Work done so far and where it must stop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Budget {
    pub(super) iterations: usize,
    pub(super) products: usize,
    pub(super) limit: usize,
}

/// Outcome on one grid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct GridSolution {
    pub(super) approach: f64,
    pub(super) residual: f64,
    pub(super) converged: bool,
}

/// How far a pressure is from a solution.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Misfit {
    /// Largest |gap| in contact, and the sum of its square.
    gap: f64,
    gap_square: f64,
    /// Largest overlap out of contact, and the sum of the squares of those that count.
    overlap: f64,
    overlap_square: f64,
    /// Sum of the squares of the pressures that pull, or of what is above the hardness.
    pull_square: f64,
    /// Largest displacement in contact, and largest pressure.
    displacement: f64,
    pressure: f64,
}

impl Misfit {
    fn join(self, other: Self) -> Self {
        Self {
            gap: self.gap.max(other.gap),
            gap_square: self.gap_square + other.gap_square,
            overlap: self.overlap.max(other.overlap),
            overlap_square: self.overlap_square + other.overlap_square,
            pull_square: self.pull_square + other.pull_square,
            displacement: self.displacement.max(other.displacement),
            pressure: self.pressure.max(other.pressure),
        }
    }
}

/// Multiple of the contact's own misfit below which the gap inside counts as settled and the contact is
/// corrected. Smaller spends iterations on a wrong contact, larger corrects it from a pressure not yet known.
const SETTLED: f64 = 8.0;

/// Factor on it after each correction, so that a contact that keeps being corrected is solved ever more exactly
/// in between: then each correction is a step of Newton's method and they come to an end.
const PATIENCE: f64 = 0.9;

/// Vectors of the iteration.
struct Iterate {
    /// Displacement + height, i.e. gap + approach.
    lift: Vec<f64>,
    contact: Vec<bool>,
    /// Pixels that yield; none at all where nothing does.
    yields: Vec<bool>,
    /// What steps are made of, in seven digits, is measured in this displacement: what a step is off by, the next one finds in
    /// the lift, and what the lift is off by then, a fresh one.
    unit: f64,
    residual: Vec<f32>,
    direction: Vec<f32>,
    work: Vec<f32>,
    /// Stiffness of the contact against a uniform displacement (prescribed sum only).
    uniform: Vec<f32>,
    /// Its sum.
    uniform_total: f64,
    /// What a uniform pressure on the contact displaces; empty until it is asked for.
    level: Vec<f32>,
    slope: f64,
    /// Overlap too small to count.
    threshold: f64,
    settled: f64,
}

impl GridContact<'_> {
    /// Pressure that solves the contact to the relative tolerance, from a start ≥ 0.
    pub(super) fn solve(
        &self,
        pressure: &mut [f64],
        tolerance: f64,
        effort: &mut Budget,
        scratch: &mut Scratch,
    ) -> GridSolution {
        let mut state = self.start(pressure, effort, scratch);
        loop {
            let approach = self.approach(&state);
            let misfit = self.misfit(pressure, &state, approach);
            let scale = misfit.displacement.max(self.operators.compliance * misfit.pressure).max(f64::MIN_POSITIVE);
            let residual = misfit.gap.max(misfit.overlap) / scale;
            let pulls = misfit.pull_square > 0.0;
            let converged = residual <= tolerance && !pulls;
            if converged || effort.iterations >= effort.limit {
                return GridSolution { approach, residual, converged };
            }
            state.threshold = 0.5 * tolerance * scale;
            if state.unit <= 0.0 {
                state.unit = scale.max(misfit.gap).max(misfit.overlap);
            }
            let wrong =
                misfit.overlap_square + (self.operators.compliance * self.operators.compliance) * misfit.pull_square;
            if residual <= tolerance || misfit.gap_square <= state.settled * state.settled * wrong {
                self.correct(pressure, &mut state, approach);
                self.open(pressure, &mut state);
                if pulls {
                    self.refresh(pressure, &mut state, effort, scratch);
                }
                self.stiffen(&mut state, scratch);
            }
            self.step(pressure, &mut state, effort, scratch);
        }
    }

    fn start(&self, pressure: &mut [f64], effort: &mut Budget, scratch: &mut Scratch) -> Iterate {
        let pixels = pressure.len();
        let prescribed_sum = matches!(self.goal, Goal::Sum(_));
        let mut state = Iterate {
            lift: vec![0.0; pixels],
            contact: each(pressure).map(|&p| p > 0.0).collect(),
            yields: if self.hardness.is_finite() { vec![false; pixels] } else { Vec::new() },
            unit: 0.0,
            residual: vec![0.0; pixels],
            direction: vec![0.0; pixels],
            work: vec![0.0; pixels],
            uniform: if prescribed_sum { vec![0.0; pixels] } else { Vec::new() },
            uniform_total: 0.0,
            level: Vec::new(),
            slope: 0.0,
            threshold: 0.0,
            settled: SETTLED,
        };
        self.yield_above(pressure, &mut state);
        self.lift(pressure, &mut state, effort, scratch);
        let approach = self.approach(&state);
        let yields = |index: usize| state.yields.get(index).is_some_and(|&yields| yields);
        each_mut(&mut state.contact).zip(&state.lift).enumerate().for_each(|(index, (contact, lift))| {
            *contact |= *lift < approach && !yields(index);
        });
        self.open(pressure, &mut state);
        self.stiffen(&mut state, scratch);
        state
    }

    /// Opens a contact that is closed everywhere, at an approach that leaves a mean gap, where it is pressed least. What is
    /// taken off the pressure displaces nothing.
    fn open(&self, pressure: &mut [f64], state: &mut Iterate) {
        let is_given = matches!(self.goal, Goal::Approach(_));
        if !(self.operators.floats && is_given && state.contact.iter().all(|&contact| contact)) {
            return;
        }
        let least = pressure.iter().copied().fold(f64::INFINITY, f64::min);
        update(pressure, self.heights, |p, _| *p -= least);
        each_mut(&mut state.contact).zip(&*pressure).for_each(|(contact, p)| *contact = *p > 0.0);
    }

    /// Lift of the present pressure, computed afresh.
    fn lift(&self, pressure: &[f64], state: &mut Iterate, effort: &mut Budget, scratch: &mut Scratch) {
        self.operators.influence.apply(pressure, &mut state.lift, scratch);
        update(&mut state.lift, self.heights, |lift, height| *lift += height);
        effort.products += 1;
    }

    /// Prescribed approach, or the one that leaves no mean gap in the contact.
    fn approach(&self, state: &Iterate) -> f64 {
        match self.goal {
            Goal::Approach(approach) => approach,
            Goal::Sum(_) => mean_where(&state.lift, &state.contact),
        }
    }

    /// Pressures above the hardness are the hardness: their pixels yield.
    fn yield_above(&self, pressure: &mut [f64], state: &mut Iterate) {
        let all = pressure.iter_mut().zip(&mut state.contact).zip(&mut state.yields);
        for ((p, contact), yields) in all.filter(|((p, _), _)| **p >= self.hardness) {
            (*p, *contact, *yields) = (self.hardness, false, true);
        }
    }

    fn misfit(&self, pressure: &[f64], state: &Iterate, approach: f64) -> Misfit {
        let piece = |range: std::ops::Range<usize>| {
            let mut misfit = Misfit::default();
            for index in range {
                let gap = state.lift[index] - approach;
                if state.contact[index] {
                    misfit.add_contact(gap, pressure[index], state.lift[index] - self.heights[index]);
                    misfit.pull_square += (pressure[index] - self.hardness).max(0.0).powi(2);
                } else if state.yields.get(index).is_some_and(|&yields| yields) {
                    misfit.add_yielding(gap.max(0.0), pressure[index], state.lift[index] - self.heights[index]);
                } else if -gap > state.threshold {
                    misfit.overlap = misfit.overlap.max(-gap);
                    misfit.overlap_square += gap * gap;
                }
            }
            misfit
        };
        fold(pressure.len(), piece, Misfit::default(), Misfit::join)
    }

    /// Contact from the present pressure and gap: pulling pixels leave it, overlapping ones join. What that cuts off the
    /// pressure goes to the residual.
    fn correct(&self, pressure: &mut [f64], state: &mut Iterate, approach: f64) {
        each_mut(&mut state.residual).for_each(|cut| *cut = 0.0);
        self.correct_yielding(pressure, state, approach);
        let Iterate { contact, residual, lift, threshold, yields, unit, .. } = state;
        let (threshold, unit) = (*threshold, *unit);
        let pixels = each_mut(contact).zip(pressure.par_iter_mut()).zip(residual.par_iter_mut());
        pixels.enumerate().for_each(|(index, ((contact, p), cut))| {
            if !yields.get(index).is_some_and(|&yields| yields) {
                *contact = if *contact { *p >= 0.0 } else { lift[index] - approach < -threshold };
                if *p < 0.0 {
                    *cut = f32::nearest(-*p / unit);
                    *p = 0.0;
                }
            }
        });
        state.slope = 0.0;
        state.settled *= PATIENCE;
    }

    /// Pixels above the hardness yield, and those that have been left behind no longer do.
    fn correct_yielding(&self, pressure: &mut [f64], state: &mut Iterate, approach: f64) {
        let Iterate { contact, yields, lift, threshold, residual, unit, .. } = state;
        for (index, yields) in yields.iter_mut().enumerate() {
            if contact[index] && pressure[index] > self.hardness {
                residual[index] = f32::nearest((self.hardness - pressure[index]) / *unit);
                (pressure[index], contact[index], *yields) = (self.hardness, false, true);
            } else if *yields && lift[index] - approach > *threshold {
                (contact[index], *yields) = (true, false);
            }
        }
    }

    /// Everything that follows from a pressure of which a part, the residual, was cut off.
    fn refresh(&self, pressure: &mut [f64], state: &mut Iterate, effort: &mut Budget, scratch: &mut Scratch) {
        self.operators.swift.apply(&state.residual, &mut state.work, scratch);
        effort.products += 1;
        let unit = state.unit;
        update(&mut state.lift, &state.work, |lift, change| *lift += unit * f64::from(change));
        if let Goal::Sum(wanted) = self.goal {
            self.rescale(pressure, &mut state.lift, wanted / total(pressure));
        }
    }
}

impl Misfit {
    /// A pixel that yields may overlap; what has been left behind by `gap` counts.
    fn add_yielding(&mut self, gap: f64, pressure: f64, displacement: f64) {
        self.overlap = self.overlap.max(gap);
        self.overlap_square += gap * gap;
        self.displacement = self.displacement.max(displacement.abs());
        self.pressure = self.pressure.max(pressure);
    }

    fn add_contact(&mut self, gap: f64, pressure: f64, displacement: f64) {
        self.gap = self.gap.max(gap.abs());
        self.gap_square += gap * gap;
        self.pull_square += pressure.min(0.0).powi(2);
        self.displacement = self.displacement.max(displacement.abs());
        self.pressure = self.pressure.max(pressure);
    }
}

/// Mean over the contact, 0 where there is none.
fn mean_where(values: &[f64], contact: &[bool]) -> f64 {
    let part = |range: std::ops::Range<usize>| {
        let pairs = values[range.clone()].iter().zip(&contact[range]);
        pairs.fold((0.0, 0_u64), |(sum, count), (value, &contact)| {
            (sum + if contact { *value } else { 0.0 }, count + u64::from(contact))
        })
    };
    let (sum, count) = fold(values.len(), part, (0.0, 0), |(sum, count), (more, others)| (sum + more, count + others));
    sum / count.max(1) as f64
}
