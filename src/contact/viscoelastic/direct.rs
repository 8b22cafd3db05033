//! The plain bed: every spring updated in every step.
//!
//! The twin that the other beds are held against, and the form in which springs may differ.
//!
//! # Examples
//! ```
//! use springbed::contact::viscoelastic::{Spectrum, direct::Direct, layout::Layout};
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! // 1000 springs under a ball, E* = 1: Hertz to −1/4 … 1/8 of (Δx/a)².
//! let ball = Paraboloid { radius: Length::new(1.0)? };
//! let mut bed = Direct::new(Arc::new(Spectrum::elastic(1.0)), Layout::uniform(&ball, 0.2, 1000));
//! bed.advance(0.01, 1.0);
//! assert!((bed.force() / (4e-3 / 3.0) - 1.0).abs() < 0.25 * (2e-4f64 / 0.1).powi(2));
//! assert_eq!(bed.pressed(), 500);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::Spectrum;
use super::layout::Layout;
use super::ledger::Ledger;
use super::spring::{Free, Motion, Spring};
use crate::numerics::exponential::decay;
use ndarray::{Array2, ArrayViewMut1, Axis, s};
use std::sync::Arc;

/// Bed whose states are updated one and all.
///
/// A column of the states belongs to a spring: element loads sᵢ [N/m] while pressed, recovery modes
/// zₘ [m] while free. The pressed springs are a prefix of the bed.
#[derive(Debug, Clone)]
pub struct Direct {
    spectrum: Arc<Spectrum>,
    layout: Layout,
    states: Array2<f64>,
    rest: Vec<f64>,
    pressed: usize,
    touched: usize,
    depth: f64,
    speed: f64,
}

impl Direct {
    /// A bed never touched.
    #[must_use]
    pub fn new(spectrum: Arc<Spectrum>, layout: Layout) -> Self {
        let rows = spectrum.terms().len().max(spectrum.modes().len());
        let states = Array2::zeros((rows, layout.len()));
        let rest = vec![0.0; layout.len()];
        Self { spectrum, layout, states, rest, pressed: 0, touched: 0, depth: 0.0, speed: 0.0 }
    }

    /// Moves at constant `speed` [m/s] for `duration` [s].
    pub fn advance(&mut self, speed: f64, duration: f64) {
        let motion = Motion { start: self.depth, speed, duration };
        let gained = self.gain(&motion);
        // Springs touched and released again carry a finite rest; they are the outer ones.
        let held = (self.pressed..gained).take_while(|&j| !self.rest[j].is_finite()).count();
        let kept = if held > 0 { self.pressed } else { self.lose(&motion) };
        self.press(kept, &motion);
        self.recover(gained.max(self.pressed), duration);
        self.touched = self.touched.max(gained);
        self.pressed = kept + held;
        (self.depth, self.speed) = (motion.end(), speed);
    }

    /// Follows every spring that is touched in the motion; the number of the first one that is not.
    fn gain(&mut self, motion: &Motion) -> usize {
        let mut j = self.pressed;
        while j < self.layout.len() {
            let Spring::Free(free) = self.spring(j) else { break };
            if self.spectrum.touch(&free, &self.seen(j, motion)).is_none() {
                break;
            }
            let after = Spring::Free(free).follow(&self.spectrum, &self.seen(j, motion), &mut |_| {});
            self.put(j, after);
            j += 1;
        }
        j
    }

    /// Follows every pressed spring that is released in the motion; the number of those that are not.
    fn lose(&mut self, motion: &Motion) -> usize {
        let mut kept = self.pressed;
        while let Some(j) = kept.checked_sub(1) {
            let after = self.spring(j).follow(&self.spectrum, &self.seen(j, motion), &mut |_| {});
            if matches!(after, Spring::Pressed(_)) {
                break;
            }
            self.put(j, after);
            kept = j;
        }
        kept
    }

    /// The motion as the spring `j` sees it.
    fn seen(&self, j: usize, motion: &Motion) -> Motion {
        Motion { start: motion.start - self.layout.height[j], ..*motion }
    }

    fn spring(&self, j: usize) -> Spring {
        let column = self.states.column(j);
        if j < self.pressed {
            return Spring::Pressed(column.iter().take(self.spectrum.terms().len()).copied().collect());
        }
        let modes = column.iter().take(self.spectrum.modes().len()).copied().collect();
        Spring::Free(Free { rest: self.rest[j], modes })
    }

    /// Stores a spring; its rest is NaN while it is pressed.
    fn put(&mut self, j: usize, spring: Spring) {
        let (rest, values) = match spring {
            Spring::Pressed(loads) => (f64::NAN, loads),
            Spring::Free(free) => (free.rest, free.modes),
        };
        self.rest[j] = rest;
        self.states.column_mut(j).iter_mut().zip(values).for_each(|(state, value)| *state = value);
    }

    /// All springs that stay pressed: one multiplication and one addition per spring and term.
    fn press(&mut self, kept: usize, motion: &Motion) {
        let Self { spectrum, states, .. } = self;
        for (term, row) in spectrum.terms().iter().zip(states.axis_iter_mut(Axis(0))) {
            let (keep, lost) = decay(motion.duration / term.time);
            shift(row, kept, keep, term.modulus * motion.speed * term.time * lost);
        }
    }

    /// All springs that stay free.
    fn recover(&mut self, from: usize, duration: f64) {
        let Self { spectrum, states, touched, .. } = self;
        for (mode, mut row) in spectrum.modes().iter().zip(states.axis_iter_mut(Axis(0))) {
            let keep = decay(duration / mode.time).0;
            row.slice_mut(s![from..(*touched).max(from)]).mapv_inplace(|z| keep * z);
        }
    }

    /// Normal force F = Σ 2Δx q [N].
    #[must_use]
    pub fn force(&self) -> f64 {
        (0..self.pressed).map(|j| self.layout.weight[j] * self.line_load(j)).sum()
    }

    /// Line load of the pressed spring `j` [N/m].
    fn line_load(&self, j: usize) -> f64 {
        let elements: f64 = self.states.column(j).iter().take(self.spectrum.terms().len()).sum();
        let u = self.depth - self.layout.height[j];
        self.spectrum.equilibrium() * u + elements + self.spectrum.viscosity() * self.speed
    }

    /// Contact radius [m], between two springs.
    #[must_use]
    pub fn radius(&self) -> f64 {
        let sign = |j: usize| match self.spring(j) {
            Spring::Pressed(_) => self.line_load(j),
            Spring::Free(free) => self.depth - self.layout.height[j] - self.spectrum.recovered(&free, 0.0),
        };
        self.layout.edge(self.pressed, sign).place
    }

    /// Number of springs pressed.
    #[must_use]
    pub fn pressed(&self) -> usize {
        self.pressed
    }

    /// Indentation [m].
    #[must_use]
    pub fn indentation(&self) -> f64 {
        self.depth
    }

    /// Energy in the springs [J].
    #[must_use]
    pub fn stored(&self) -> f64 {
        let energy = |j: usize| match self.spring(j) {
            Spring::Pressed(s) => self.spectrum.stored_pressed(self.depth - self.layout.height[j], &s),
            Spring::Free(free) => self.spectrum.stored_free(&free),
        };
        (0..self.touched).map(|j| self.layout.weight[j] * energy(j)).sum()
    }

    /// Work and heat [J] of a motion not yet made, spring by spring in closed form.
    #[must_use]
    pub fn audit(&self, speed: f64, duration: f64) -> Ledger {
        let motion = Motion { start: self.depth, speed, duration };
        let mut total = Ledger::default();
        for j in 0..self.layout.len() {
            let mut ledger = Ledger::default();
            let watch = &mut |piece: &super::spring::Piece<'_>| self.spectrum.account(piece, &mut ledger);
            let _ = self.spring(j).follow(&self.spectrum, &self.seen(j, &motion), watch);
            total.work += self.layout.weight[j] * ledger.work;
            total.dissipated += self.layout.weight[j] * ledger.dissipated;
        }
        total
    }

    /// Bytes of state.
    #[must_use]
    pub fn bytes(&self) -> usize {
        size_of::<f64>() * (self.states.len() + 4 * self.layout.len())
    }
}

/// row ← keep·row + gain, over the pressed springs.
fn shift(mut row: ArrayViewMut1<'_, f64>, pressed: usize, keep: f64, gain: f64) {
    row.slice_mut(s![..pressed]).mapv_inplace(|s| keep * s + gain);
}
