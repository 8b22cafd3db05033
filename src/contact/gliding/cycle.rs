//! The state of a spring that comes back to where it was, period after period.
//!
//! A spring under a periodic line is pressed at its highest point, there it begins. With s the loads of its elements there and
//! P(s) those a period later the steady state is s = P(s). After many periods it would come of itself, after as many as the
//! longest time has periods. Newton's method is there at once: the derivative of P is known, for between two events the
//! loads and the modes of recovery fade each with its time, and
//! at an event the spring changes from one motion to another where its load, or its distance from the profile, is zero.

use super::kernel::Kernel;
use super::sweep::swept;
use super::tally::{Diary, Episode, Tally};
use super::track::Track;
use crate::contact::viscoelastic::Spectrum;
use crate::contact::viscoelastic::spring::Spring;
use crate::numerics::exponential::decay;
use ndarray::{Array1, Array2, ArrayViewMut2, Axis, s};

/// Most periods gone through.
const MOST_PERIODS: usize = 200;
/// Part of the load at once of the way up and down by which the load of an element may be off in the end.
const CLOSE: f64 = 1e-11;
/// Roundings of the greatest depth below which nothing is told apart.
const ROUNDINGS: f64 = 64.0;

/// One period of a spring in the steady state: its sums; `None` if the state is not found.
///
/// `loads` are where the search begins and, in the end, those that come back.
pub(super) fn steady(kernel: &mut Kernel, track: &Track, (speed, loads): (f64, &mut Vec<f64>)) -> Option<Tally> {
    let depth = track.depths.first().copied()?;
    let lowest = track.depths.iter().copied().fold(depth, f64::min).max(0.0);
    let swing = depth - lowest;
    let close = (CLOSE * swing).max(ROUNDINGS * f64::EPSILON * depth);
    let moduli: Vec<f64> = kernel.spectrum().terms().iter().map(|term| term.modulus).collect();
    let period: f64 = track.steps.iter().sum::<f64>() / speed;
    loads.resize(kernel.spectrum().terms().len(), 0.0);
    let mut last = f64::INFINITY;
    let mut before = loads.clone();
    for _ in 0..MOST_PERIODS {
        let (after, tally) = round(kernel, track, (speed, loads))?;
        let moved = correction(kernel.spectrum(), (loads, &after), (period, tally.diary.as_ref()?))?;
        let off = moved.iter().zip(&moduli).map(|(moved, modulus)| (moved / modulus).abs()).fold(0.0, f64::max);
        if off <= close {
            return Some(tally);
        }
        // A step that leads further away is halved.
        if off > 2.0 * last {
            loads.iter_mut().zip(&before).for_each(|(load, before)| *load = 0.5 * (*load + before));
            last = f64::INFINITY;
            continue;
        }
        (last, before) = (off, loads.clone());
        loads.iter_mut().zip(moved).for_each(|(load, moved)| *load += moved);
    }
    None
}

/// The loads of a spring after a period that it began at the highest point with `loads`.
fn round(kernel: &mut Kernel, track: &Track, (speed, loads): (f64, &[f64])) -> Option<(Vec<f64>, Tally)> {
    let mut tally = Tally { diary: Some(Diary::of(kernel.spectrum())), ..Tally::default() };
    match swept(kernel, track, (speed, Spring::Pressed(loads.to_vec())), &mut tally) {
        Spring::Pressed(after) => Some((after, tally)),
        Spring::Free(_) => None,
    }
}

/// Newton's step towards loads that come back.
///
/// Of an element that forgets within a period, P(s) − s is taken as it is; of one that does not it would be the
/// difference of two numbers that hardly differ, and is −∫ s dt/τ, for the displacement comes back.
fn correction(
    spectrum: &Spectrum,
    (before, after): (&[f64], &[f64]),
    (period, diary): (f64, &Diary),
) -> Option<Vec<f64>> {
    let Derivative { ends, integrals } = Derivative::of(spectrum, &diary.episodes);
    let means = diary.integrals(spectrum);
    let count = before.len();
    let (mut matrix, mut right) = (Array2::zeros((count, count)), Array1::zeros(count));
    for (i, term) in spectrum.terms().iter().enumerate() {
        let forgets = period > term.time;
        let row = if forgets { -&ends.row(i) } else { &integrals.row(i) / term.time };
        matrix.row_mut(i).assign(&row);
        if forgets {
            matrix[[i, i]] += 1.0;
        }
        right[i] = if forgets { after[i] - before[i] } else { -means[i] / term.time };
    }
    solved(matrix, right)
}

/// How the loads of a spring at the end of a period, and their integrals over it, depend on those at the beginning.
struct Derivative {
    ends: Array2<f64>,
    integrals: Array2<f64>,
}

impl Derivative {
    fn of(spectrum: &Spectrum, episodes: &[Episode]) -> Self {
        let count = spectrum.terms().len();
        let mut derivative = Self { ends: Array2::eye(count), integrals: Array2::zeros((count, count)) };
        for episode in episodes {
            match *episode {
                Episode::Pressed(duration) => derivative.press(spectrum, duration),
                Episode::Free(duration) => derivative.recover(spectrum, duration),
            }
        }
        derivative
    }

    fn press(&mut self, spectrum: &Spectrum, duration: f64) {
        for (i, term) in spectrum.terms().iter().enumerate() {
            let (keep, lost) = decay(duration / term.time);
            let mut row = self.ends.row_mut(i);
            self.integrals.row_mut(i).scaled_add(term.time * lost, &row);
            row *= keep;
        }
    }

    /// Let go, recovery, touch.
    fn recover(&mut self, spectrum: &Spectrum, duration: f64) {
        let mut modes = let_go(spectrum, self.ends.view_mut());
        for (mode, mut row) in spectrum.modes().iter().zip(modes.rows_mut()) {
            let (keep, lost) = decay(duration / mode.time);
            for (i, term) in spectrum.terms().iter().enumerate() {
                let part = -term.modulus * term.time * mode.inverse_gaps[i] * mode.time * lost;
                self.integrals.row_mut(i).scaled_add(part, &row);
            }
            row *= keep;
        }
        // At the touch the displacement is that of the profile again: a spring that is further out is touched earlier.
        let displacement = modes.sum_axis(Axis(0));
        for (i, term) in spectrum.terms().iter().enumerate() {
            let mut row = self.ends.row_mut(i);
            row.assign(&(&displacement * -term.modulus));
            for (mode, z) in spectrum.modes().iter().zip(modes.rows()) {
                row.scaled_add(-term.modulus * term.time * mode.inverse_gaps[i], &z);
            }
        }
    }
}

/// How the modes of a spring that is let go depend on what its `loads` depended on.
///
/// Without a dashpot a load that is larger is let go later, when the profile has gone further: the load is zero
/// then. With one the spring leaves at the speed of the profile, and the instant does not count.
fn let_go(spectrum: &Spectrum, mut loads: ArrayViewMut2<'_, f64>) -> Array2<f64> {
    let mut displacement = Array1::zeros(loads.ncols());
    if spectrum.viscosity() <= 0.0 {
        displacement = loads.sum_axis(Axis(0)) / -spectrum.instantaneous();
        for (term, mut row) in spectrum.terms().iter().zip(loads.rows_mut()) {
            row.scaled_add(term.modulus, &displacement);
        }
    }
    let mut modes = Array2::zeros((spectrum.modes().len(), loads.ncols()));
    for (mode, mut z) in spectrum.modes().iter().zip(modes.rows_mut()) {
        z.scaled_add(mode.compliance * spectrum.equilibrium(), &displacement);
        for ((term, row), gap) in spectrum.terms().iter().zip(loads.rows()).zip(&mode.inverse_gaps) {
            z.scaled_add(-mode.compliance * term.time * gap, &row);
        }
    }
    modes
}

/// The solution of a set of linear equations by elimination with row pivots; `None` of a singular one.
fn solved(mut matrix: Array2<f64>, mut right: Array1<f64>) -> Option<Vec<f64>> {
    let count = right.len();
    for i in 0..count {
        let size = |row: &usize| matrix[[*row, i]].abs();
        let pivot = (i..count).max_by(|one, other| size(one).total_cmp(&size(other)))?;
        if matrix[[pivot, i]].abs() <= 0.0 || !matrix[[pivot, i]].is_finite() {
            return None;
        }
        right.swap(i, pivot);
        (0..count).for_each(|column| matrix.swap([i, column], [pivot, column]));
        let (above, mut below) = matrix.view_mut().split_at(Axis(0), i + 1);
        let above = above.row(i);
        for (k, mut row) in below.rows_mut().into_iter().enumerate() {
            let factor = row[i] / above[i];
            row.slice_mut(s![i..]).scaled_add(-factor, &above.slice(s![i..]));
            right[i + 1 + k] -= factor * right[i];
        }
    }
    for i in (0..count).rev() {
        let known: f64 = (i + 1..count).map(|k| matrix[[i, k]] * right[k]).sum();
        right[i] = (right[i] - known) / matrix[[i, i]];
    }
    right.iter().all(|value| value.is_finite()).then(|| right.to_vec())
}
