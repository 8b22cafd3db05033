//! Stiff motion by extrapolation: the linearly implicit rule of Euler with 2, 3, 4, … substeps, led to the limit of none.
//!
//! A substep solves (1 − hJ)Δ = h f(y) with the slopes J = ∂f/∂y of the beginning of the step, so that what decays fast
//! decays, however long the step (the rule is L-stable). Its error has all powers of the substep, of which each further row
//! of the scheme of Aitken and Neville takes one away (Deuflhard, Hairer & Zugck 1987; Hairer & Wanner, *Solving Ordinary
//! Differential Equations II*, IV.9). A step ends with the row of which the last two columns agree to the tolerance; the
//! next one is as long as makes the least work per time. Sums over the motion, such as its work, go along.
//!
//! # Examples
//! ```
//! use springbed::numerics::stiff::{Stepper, StiffMotion, Whole};
//!
//! // y′ = −10⁶(y − cos t), t′ = 1 from y = 0: it jumps to cos t, and stays.
//! struct Jump;
//! impl StiffMotion<2, 1> for Jump {
//!     fn rate(&self, [y, t]: &[f64; 2]) -> ([f64; 2], [f64; 1]) {
//!         ([-1e6 * (y - t.cos()), 1.0], [*y])
//!     }
//!     fn slopes(&self, [_, t]: &[f64; 2]) -> [[f64; 2]; 2] {
//!         [[-1e6, -1e6 * t.sin()], [0.0, 0.0]]
//!     }
//!     fn whole(&self, _: &[f64; 2]) -> ([f64; 2], [f64; 1]) {
//!         ([1.0; 2], [1.0])
//!     }
//! }
//! let (mut stepper, mut at, mut steps) = (Stepper::new(1e-10, 1e-6), Whole { state: [0.0; 2], sums: [0.0] }, 0);
//! while at.state[1] < 2.0 {
//!     (_, at) = stepper.step(&Jump, &at, 2.0 - at.state[1]).ok_or("no step")?;
//!     steps += 1;
//! }
//! // What dies down within a step is known less well than what goes on, for it is forgotten again.
//! assert!(steps < 60 && (at.state[0] - (2f64.cos() + 1e-6 * 2f64.sin())).abs() < 1e-7);
//! assert!((at.sums[0] - (2f64.sin() - 1e-6 * 2f64.cos())).abs() < 1e-9);
//! # Ok::<(), &str>(())
//! ```

/// Rows of the scheme.
const ROWS: usize = 10;
/// How much longer a leap is than the step before it, and after how many steps it is tried, at first and at most.
const LEAP: f64 = 8.0;
const PATIENCE: (u32, u32) = (4, 64);
/// Rows before which no agreement counts: two may agree by chance.
const FIRST: usize = 2;
/// Shortest step relative to the longest asked for.
const SHORTEST: f64 = 1e-25;
/// Most and least that a step grows by, and its distance from one that would just do.
const GROWTH: (f64, f64) = (8.0, 0.1);
const SAFETY: f64 = 0.8;
/// What moves a state of N numbers, over which M sums are taken.
pub trait StiffMotion<const N: usize, const M: usize> {
    /// dy/dt, and what is summed.
    fn rate(&self, state: &[f64; N]) -> ([f64; N], [f64; M]);

    /// ∂(dy/dt)ᵢ/∂yⱼ.
    fn slopes(&self, state: &[f64; N]) -> [[f64; N]; N];

    /// What errors of the numbers and of the sums are held against, where the numbers are no larger than `largest`.
    fn whole(&self, largest: &[f64; N]) -> ([f64; N], [f64; M]);
}

/// A state, and what has been summed up to it; or the changes of both.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Whole<const N: usize, const M: usize> {
    /// The numbers.
    pub state: [f64; N],
    /// The sums.
    pub sums: [f64; M],
}

impl<const N: usize, const M: usize> Whole<N, M> {
    const ZERO: Self = Self { state: [0.0; N], sums: [0.0; M] };

    /// This and `part` times the way from `other` to this.
    fn beyond(&self, other: &Self, part: f64) -> Self {
        let state = std::array::from_fn(|i| self.state[i] + part * (self.state[i] - other.state[i]));
        Self { state, sums: std::array::from_fn(|i| self.sums[i] + part * (self.sums[i] - other.sums[i])) }
    }

    fn plus(&self, change: &Self) -> Self {
        let state = std::array::from_fn(|i| self.state[i] + change.state[i]);
        Self { state, sums: std::array::from_fn(|i| self.sums[i] + change.sums[i]) }
    }
}

/// Chooses the steps of a motion by their error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stepper {
    /// Error of a step relative to the whole: larger saves steps, below 1e-13 it is rounding.
    tolerance: f64,
    /// The next step, and the row it is meant for.
    next: f64,
    row: usize,
    /// Steps to the next leap, and how many there will be to the one after it.
    leaps: (u32, u32),
}

/// Rates and slopes at the beginning of a step.
struct Begin<const N: usize, const M: usize> {
    from: Whole<N, M>,
    rate: [f64; N],
    slopes: [[f64; N]; N],
}

/// A trial that is good enough: its end, the next step and the row meant for it.
struct Done<const N: usize, const M: usize> {
    change: Whole<N, M>,
    next: f64,
    row: usize,
}

/// Substeps of a row.
const fn substeps(row: usize) -> usize {
    row + 2
}

/// Work of all rows up to one, in solved substeps; slopes and their elimination count as two each.
fn work(row: usize) -> f64 {
    (0..=row).map(|row| substeps(row) as f64 + 2.0).sum::<f64>() + 2.0
}

impl Stepper {
    /// A stepper to the error `tolerance` per step, the first of which is `first`.
    #[must_use]
    pub fn new(tolerance: f64, first: f64) -> Self {
        Self { tolerance, next: first, row: ROWS / 2, leaps: (PATIENCE.0, PATIENCE.0) }
    }

    /// The step that would be tried next.
    #[must_use]
    pub fn next(&self) -> f64 {
        self.next
    }

    /// Begins again with a step of `step`, as behind a kink.
    pub fn restart(&mut self, step: f64) {
        (self.next, self.row, self.leaps) = (step, ROWS / 2, (PATIENCE.0, PATIENCE.0));
    }

    /// One step of at most `longest` from `from`, with its length and its end; `None` where no step is short enough.
    pub fn step<const N: usize, const M: usize>(
        &mut self,
        motion: &impl StiffMotion<N, M>,
        from: &Whole<N, M>,
        longest: f64,
    ) -> Option<(f64, Whole<N, M>)> {
        let begin = Begin { from: *from, rate: motion.rate(&from.state).0, slopes: motion.slopes(&from.state) };
        if let Some(done) = self.leap(motion, &begin, longest) {
            return Some((done.0, from.plus(&done.1)));
        }
        let mut step = self.next.min(longest);
        while step > SHORTEST * longest {
            match self.trial(motion, &begin, step) {
                Ok(done) => {
                    (self.next, self.row) = (done.next, done.row);
                    return Some((step, from.plus(&done.change)));
                }
                Err(part) => step *= part,
            }
        }
        None
    }

    /// A step far longer than the last ones, tried from time to time: where a fast swing is still, the error of the scheme has a
    /// rise at a radian of it, behind which it is as small as before.
    fn leap<const N: usize, const M: usize>(
        &mut self,
        motion: &impl StiffMotion<N, M>,
        begin: &Begin<N, M>,
        longest: f64,
    ) -> Option<(f64, Whole<N, M>)> {
        self.leaps.0 = self.leaps.0.saturating_sub(1);
        let step = LEAP * self.next;
        if self.leaps.0 > 0 || step > longest {
            return None;
        }
        let leaping = Self { row: ROWS, ..*self };
        let Ok(done) = leaping.trial(motion, begin, step) else {
            self.leaps = (self.leaps.1, (2 * self.leaps.1).min(PATIENCE.1));
            return None;
        };
        *self = Self { next: done.next.max(step), row: done.row, leaps: (PATIENCE.0, PATIENCE.0), ..*self };
        Some((step, done.change))
    }

    /// One trial, or the part of its step to be tried next.
    fn trial<const N: usize, const M: usize>(
        &self,
        motion: &impl StiffMotion<N, M>,
        begin: &Begin<N, M>,
        step: f64,
    ) -> Result<Done<N, M>, f64> {
        let mut columns = [Whole::ZERO; ROWS];
        let mut lengths = [0.0; ROWS];
        let mut last = f64::INFINITY;
        let soft = Eliminated::new(&begin.slopes, step / substeps(0) as f64).ok_or(GROWTH.1)?;
        for row in 0..ROWS {
            let mut change = euler(motion, begin, (step, substeps(row))).ok_or(GROWTH.1)?;
            // The columns are those of the row before, each until it has made the next one of this row.
            for k in 1..=row {
                let ratio = substeps(row) as f64 / substeps(row - k) as f64;
                let better = change.beyond(&columns[k - 1], (ratio - 1.0).recip());
                (columns[k - 1], change) = (change, better);
            }
            columns[row] = change;
            if row > 0 {
                let error = apart(motion, (begin, &soft), (&change, &columns[row - 1])) / self.tolerance;
                lengths[row] = step * grown(error, row);
                if error <= 1.0 && row >= FIRST {
                    let (next, aim) = best(&lengths, row);
                    return Ok(Done { change, next, row: aim });
                }
                // What grows from row to row, or is too far off where the step was to end, will not agree.
                let hopeless = !error.is_finite() || row > FIRST && error > last || row > self.row + 1;
                if hopeless || row + 1 == ROWS {
                    return Err(grown(error, row).clamp(GROWTH.1, 0.5));
                }
                last = error;
            }
        }
        Err(0.5)
    }
}

/// What a step may be of the present one for the error `error`, relative to the tolerance, of a row to become just right.
fn grown(error: f64, row: usize) -> f64 {
    (SAFETY * error.max(f64::MIN_POSITIVE).powf(-1.0 / (row + 1) as f64)).clamp(GROWTH.1, GROWTH.0)
}

/// Length and row of the next step that makes least work per time, the rows up to `row` having asked for `lengths`.
fn best(lengths: &[f64; ROWS], row: usize) -> (f64, usize) {
    let cost = |row: usize| work(row) / lengths[row];
    let least = (FIRST..=row).min_by(|&one, &other| cost(one).total_cmp(&cost(other))).unwrap_or(row);
    // Where each row has paid so far, so may one more.
    if least == row && row + 2 < ROWS && (row == FIRST || cost(row) < 0.9 * cost(row - 1)) {
        return (lengths[row] * work(row + 1) / work(row), row + 1);
    }
    (lengths[least], least)
}

/// Greatest part by which two changes differ of the whole, but for what dies down within the step: a substep takes it away.
fn apart<const N: usize, const M: usize>(
    motion: &impl StiffMotion<N, M>,
    (begin, soft): (&Begin<N, M>, &Eliminated<N>),
    (one, other): (&Whole<N, M>, &Whole<N, M>),
) -> f64 {
    let end = begin.from.plus(one).state;
    let largest = std::array::from_fn(|i| begin.from.state[i].abs().max(end[i].abs()));
    let (state, sums) = motion.whole(&largest);
    let left = soft.solve(&std::array::from_fn(|i| one.state[i] - other.state[i]));
    let of_state = (0..N).map(|i| left[i].abs() / state[i]);
    let of_sums = (0..M).map(|i| (one.sums[i] - other.sums[i]).abs() / sums[i]);
    // What is not a number is no agreement.
    of_state.chain(of_sums).fold(0.0, |most, off| if off <= most { most } else { off })
}

/// The change in `substeps` linearly implicit substeps, given as `(step, substeps)`; `None` if it is not finite.
fn euler<const N: usize, const M: usize>(
    motion: &impl StiffMotion<N, M>,
    begin: &Begin<N, M>,
    (step, substeps): (f64, usize),
) -> Option<Whole<N, M>> {
    let part = step / substeps as f64;
    let matrix = Eliminated::new(&begin.slopes, part)?;
    let (mut change, mut rate) = (Whole::ZERO, begin.rate);
    for _ in 0..substeps {
        let way = matrix.solve(&rate.map(|rate| part * rate));
        (0..N).for_each(|i| change.state[i] += way[i]);
        let summed;
        (rate, summed) = motion.rate(&std::array::from_fn(|i| begin.from.state[i] + change.state[i]));
        (0..M).for_each(|i| change.sums[i] += part * summed[i]);
    }
    change.state.iter().chain(&change.sums).all(|number| number.is_finite()).then_some(change)
}

/// 1 − hJ, its columns eliminated one by one; rows are exchanged for the largest pivot.
struct Eliminated<const N: usize> {
    matrix: [[f64; N]; N],
    /// 1 over the pivots.
    pivots: [f64; N],
    order: [usize; N],
}

impl<const N: usize> Eliminated<N> {
    fn new(slopes: &[[f64; N]; N], step: f64) -> Option<Self> {
        let one = |i: usize, j: usize| if i == j { 1.0 } else { 0.0 };
        let mut matrix: [[f64; N]; N] =
            std::array::from_fn(|i| std::array::from_fn(|j| one(i, j) - step * slopes[i][j]));
        let mut order = std::array::from_fn(|i| i);
        for k in 0..N {
            let pivot = (k..N).max_by(|&i, &j| matrix[i][k].abs().total_cmp(&matrix[j][k].abs()))?;
            matrix.swap(k, pivot);
            order.swap(k, pivot);
            if matrix[k][k].abs() <= 0.0 || !matrix[k][k].is_finite() {
                return None;
            }
            let above = matrix[k];
            for row in matrix.iter_mut().skip(k + 1) {
                row[k] /= above[k];
                let part = row[k];
                row.iter_mut().zip(above).skip(k + 1).for_each(|(number, above)| *number -= part * above);
            }
        }
        let pivots = std::array::from_fn(|k| matrix[k][k].recip());
        Some(Self { matrix, pivots, order })
    }

    fn solve(&self, right: &[f64; N]) -> [f64; N] {
        let mut way = self.order.map(|row| right[row]);
        for i in 1..N {
            way[i] -= (0..i).map(|j| self.matrix[i][j] * way[j]).sum::<f64>();
        }
        for i in (0..N).rev() {
            let known: f64 = (i + 1..N).map(|j| self.matrix[i][j] * way[j]).sum();
            way[i] = (way[i] - known) * self.pivots[i];
        }
        way
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// y″ = −y, with ∫y dt.
    struct Swing;

    impl StiffMotion<2, 1> for Swing {
        fn rate(&self, [x, v]: &[f64; 2]) -> ([f64; 2], [f64; 1]) {
            ([*v, -x], [*x])
        }

        fn slopes(&self, _: &[f64; 2]) -> [[f64; 2]; 2] {
            [[0.0, 1.0], [-1.0, 0.0]]
        }

        fn whole(&self, _: &[f64; 2]) -> ([f64; 2], [f64; 1]) {
            ([1.0; 2], [1.0])
        }
    }

    fn swung(tolerance: f64) -> (usize, f64) {
        let (mut stepper, mut time, mut steps) = (Stepper::new(tolerance, 1.0), 0.0, 0);
        let mut at = Whole { state: [0.0, 1.0], sums: [0.0] };
        while time < 20.0 {
            let (step, next) = stepper.step(&Swing, &at, 20.0 - time).unwrap();
            (time, at, steps) = (time + step, next, steps + 1);
        }
        let off = [at.state[0] - 20f64.sin(), at.state[1] - 20f64.cos(), at.sums[0] - (1.0 - 20f64.cos())];
        (steps, off.iter().fold(0.0, |most, off| off.abs().max(most)))
    }

    #[test]
    fn a_swing_is_followed_to_the_tolerance() {
        for (tolerance, most) in [(1e-6, 40), (1e-9, 50), (1e-12, 120)] {
            let (steps, off) = swung(tolerance);
            assert!(steps < most && off < 30.0 * tolerance, "{tolerance:e}: {steps} steps, {off:e}");
        }
    }

    #[test]
    fn rows_are_exchanged_for_the_largest_pivot() {
        // 1 − J = ((0, 2), (4, 1)).
        let matrix = Eliminated::new(&[[1.0, -2.0], [-4.0, 0.0]], 1.0).unwrap();
        let [x, y] = matrix.solve(&[6.0, 11.0]);
        assert!((x - 2.0).abs() + (y - 3.0).abs() <= 0.0, "{x} {y}");
        assert!(Eliminated::new(&[[1.0, 0.0], [0.0, 1.0]], 1.0).is_none());
    }
}
