//! Smooth motion by extrapolation: Gragg's midpoint rule with 2, 4, 6, … substeps, led to the limit of none.
//!
//! The error of the rule has even powers of the substep only, so that each further row of the scheme of Aitken and Neville
//! gains two orders (Gragg 1965; Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*, II.9). A step is
//! repeated with more substeps until the last two of the best column agree to the tolerance, relative to the state and to
//! its change in the step; a motion that is a parabola in time is exact at once, however long the step. The rates must be
//! smooth inside a step: a kink is landed on, not stepped over.
//!
//! # Examples
//! ```
//! use springbed::numerics::extrapolation::Stepper;
//!
//! // x″ = −x from rest at 1: at its first zero the time is π/2.
//! let mut swing = |_: f64, [x, v]: &[f64; 2]| [*v, -x];
//! let mut stepper = Stepper::new(1e-13);
//! let (mut time, mut state) = (0.0, [1.0, 0.0]);
//! loop {
//!     let (step, next) = stepper.step(&mut swing, &state, 10.0).ok_or("no step")?;
//!     if next[0] < 0.0 {
//!         time += stepper.landing(&mut swing, (&state, &next), (step, 0, 0.0)).ok_or("no landing")?.0;
//!         break;
//!     }
//!     (time, state) = (time + step, next);
//! }
//! assert!((time - std::f64::consts::FRAC_PI_2).abs() < 1e-12);
//! # Ok::<(), &str>(())
//! ```

/// Rows of the scheme.
const ROWS: usize = 8;
/// Rows before which no agreement counts: two may agree by chance.
const FIRST: usize = 2;
/// Shortest step unless asked for otherwise, relative to the longest asked for.
const SHORTEST: f64 = 1e-18;
/// Most trials for a landing.
const MOST_TRIALS: usize = 80;

/// Part of the lesser end above which a dip does not come to zero.
const SHALLOW: f64 = 0.25;
/// Part of the step to which the bottom of a dip is looked for: what it is deep changes with the square.
const LOWEST: f64 = 1e-6;

/// What moves a state of N numbers.
pub trait Motion<const N: usize> {
    /// dy/dt at the time `time` since the beginning of the step.
    fn rate(&mut self, time: f64, state: &[f64; N]) -> [f64; N];

    /// How far rates are off by rounding alone: what lies below it is no error of a step.
    fn rounding(&self) -> [f64; N] {
        [0.0; N]
    }
}

impl<const N: usize, F: FnMut(f64, &[f64; N]) -> [f64; N]> Motion<N> for F {
    fn rate(&mut self, time: f64, state: &[f64; N]) -> [f64; N] {
        self(time, state)
    }
}

/// Chooses the steps of a motion by their error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stepper {
    /// Relative error of a step (default of its users 1e-13; larger saves rows, smaller is rounding).
    tolerance: f64,
    /// The next step.
    next: f64,
    /// Shortest step, relative to the longest asked for.
    shortest: f64,
}

/// A state on the way, and its time since the beginning of the step.
struct Base<const N: usize> {
    time: f64,
    state: [f64; N],
}

/// A trial of one step.
struct Trial<const N: usize> {
    end: [f64; N],
    /// Number of the row that agreed with the one before; `None` if none did.
    row: Option<usize>,
}

impl Stepper {
    /// A stepper to the relative error `tolerance` per step.
    #[must_use]
    pub fn new(tolerance: f64) -> Self {
        Self { tolerance, next: f64::INFINITY, shortest: SHORTEST }
    }

    /// One that gives up where a step would be shorter than the part `shortest` of what is asked for.
    #[must_use]
    pub fn no_shorter_than(self, shortest: f64) -> Self {
        Self { shortest, ..self }
    }

    /// Begins again with a step of at most `step`, as behind a kink.
    pub fn restart(&mut self, step: f64) {
        self.next = step;
    }

    /// The step that would be tried next.
    #[must_use]
    pub fn next(&self) -> f64 {
        self.next
    }

    /// One step of at most `longest` from `from`, with its length and its end. `None` where no step is short enough: the rates are not smooth, or not finite.
    pub fn step<const N: usize>(
        &mut self,
        motion: &mut impl Motion<N>,
        from: &[f64; N],
        longest: f64,
    ) -> Option<(f64, [f64; N])> {
        let base = Base { time: 0.0, state: *from };
        let slope = motion.rate(0.0, from);
        let mut step = self.next.min(longest);
        while step > self.shortest * longest {
            let trial = self.trial(motion, (&base, &slope), step);
            if let Some(row) = trial.row {
                let growth = [8.0, 8.0, 8.0, 4.0, 2.5, 1.5, 1.0, 0.75][row];
                // A step cut short by its user says nothing against a longer one.
                let cut = step < self.next;
                self.next = if cut { self.next.min(1e3 * step).max(growth * step) } else { growth * step };
                return Some((step, trial.end));
            }
            step *= 0.35;
            self.next = step;
        }
        None
    }

    /// Where inside a step from `from` to `to` of the length `span` the number `at` of the state comes to `target`, given as
    /// `(span, at, target)`: by Newton's method, guarded by halving, each trial a step from the one before.
    ///
    /// The state before the step and after it must lie on different sides of the target.
    pub fn landing<const N: usize>(
        &self,
        motion: &mut impl Motion<N>,
        (from, to): (&[f64; N], &[f64; N]),
        (span, at, target): (f64, usize, f64),
    ) -> Option<(f64, [f64; N])> {
        let (mut low, mut high) = (0.0, span);
        // The way may begin at the target, and leave it before it comes back.
        let rises = to[at] > target;
        let secant = span * (target - from[at]) / (to[at] - from[at]);
        let mut next = if secant > 0.0 && secant < span { secant } else { 0.5 * span };
        let mut base = Base { time: 0.0, state: *from };
        for _ in 0..MOST_TRIALS {
            base = self.onwards(motion, &base, next);
            let off = base.state[at] - target;
            if (off > 0.0) == rises {
                high = base.time
            } else {
                low = base.time
            }
            let newton = base.time - off / motion.rate(base.time, &base.state)[at];
            next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if (next - base.time).abs() <= 2.0 * f64::EPSILON * span || off.abs() <= 0.0 {
                break;
            }
        }
        Some((base.time, base.state))
    }

    /// Where inside a step, at both ends of which the number `at` has the same sign, it has the other, given as `(span, at)`:
    /// a dip through zero and back, which the ends do not show. `None` if there is none.
    ///
    /// The tangents at both ends meet below a dip that is convex; where they meet well above zero no step is tried.
    pub fn dip<const N: usize>(
        &self,
        motion: &mut impl Motion<N>,
        (from, to): (&[f64; N], &[f64; N]),
        (span, at): (f64, usize),
    ) -> Option<(f64, [f64; N])> {
        let side = from[at].signum();
        let (mut low, mut high) = (0.0, span);
        let (mut falls, mut rises) = (side * motion.rate(0.0, from)[at], side * motion.rate(span, to)[at]);
        if falls >= 0.0 || rises <= 0.0 {
            return None;
        }
        let (begin, end) = (side * from[at], side * to[at]);
        let meet = (begin - end + rises * span) / (rises - falls);
        if begin + falls * meet > SHALLOW * begin.min(end) {
            return None;
        }
        let mut base = Base { time: 0.0, state: *from };
        for k in 0..MOST_TRIALS {
            // By the secant, which of a slope that bends may leave one end for ever, and by halves in turn.
            let secant = (low * rises - high * falls) / (rises - falls);
            let next = if k % 3 == 2 { 0.5 * (low + high) } else { secant };
            base = self.onwards(motion, &base, next);
            if side * base.state[at] < 0.0 {
                return Some((base.time, base.state));
            }
            let slope = side * motion.rate(base.time, &base.state)[at];
            if slope < 0.0 {
                (low, falls) = (base.time, slope);
            } else {
                (high, rises) = (base.time, slope);
            }
            if high - low <= LOWEST * span || slope.abs() <= 0.0 {
                break;
            }
        }
        None
    }

    /// From `base` to the time `time`, before it or after it.
    fn onwards<const N: usize>(&self, motion: &mut impl Motion<N>, base: &Base<N>, time: f64) -> Base<N> {
        let slope = motion.rate(base.time, &base.state);
        Base { time, state: self.trial(motion, (base, &slope), time - base.time).end }
    }

    fn trial<const N: usize>(
        &self,
        motion: &mut impl Motion<N>,
        (base, slope): (&Base<N>, &[f64; N]),
        step: f64,
    ) -> Trial<N> {
        let (rounding, from) = (motion.rounding(), &base.state);
        let mut before = [[0.0; N]; ROWS];
        let mut end = *from;
        for row in 0..ROWS {
            let mut present = [[0.0; N]; ROWS];
            present[0] = midpoint(motion, (base, slope), (step, row + 1));
            for k in 1..=row {
                let ratio = (row + 1) as f64 / (row + 1 - k) as f64;
                let weight = (ratio * ratio - 1.0).recip();
                for i in 0..N {
                    present[k][i] = present[k - 1][i] + weight * (present[k - 1][i] - before[k - 1][i]);
                }
            }
            end = present[row];
            if row >= FIRST {
                let mut agree = (0..N).map(|i| {
                    let scale = end[i].abs().max(from[i].abs()) + (step * slope[i]).abs();
                    (end[i] - present[row - 1][i]).abs() <= self.tolerance * scale + rounding[i] * step.abs()
                });
                // A NaN agrees with nothing.
                if agree.all(|agrees| agrees) {
                    return Trial { end, row: Some(row) };
                }
            }
            before = present;
        }
        Trial { end, row: None }
    }
}

/// The midpoint rule with twice `pairs` substeps, smoothed at its end.
fn midpoint<const N: usize>(
    motion: &mut impl Motion<N>,
    (begin, slope): (&Base<N>, &[f64; N]),
    (step, pairs): (f64, usize),
) -> [f64; N] {
    let Base { time, state: from } = begin;
    let count = 2 * pairs;
    let short = step / count as f64;
    let ahead = |base: &[f64; N], slope: &[f64; N], by: f64| std::array::from_fn(|i| base[i] + by * slope[i]);
    let (mut last, mut now): ([f64; N], [f64; N]) = (*from, ahead(from, slope, short));
    for k in 1..count {
        let slope = motion.rate(time + k as f64 * short, &now);
        (last, now) = (now, ahead(&last, &slope, 2.0 * short));
    }
    let end = motion.rate(time + step, &now);
    std::array::from_fn(|i| 0.5 * (now[i] + last[i] + short * end[i]))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A thousand periods of a pendulum of small swing keep energy and phase.
    #[test]
    fn a_swing_is_followed_for_long() {
        let mut swing = |_: f64, [x, v]: &[f64; 2]| [*v, -x];
        let mut stepper = Stepper::new(1e-13);
        let (mut time, mut state) = (0.0, [1.0, 0.0]);
        let end = 1000.0 * std::f64::consts::TAU;
        while time < end {
            let (step, next) = stepper.step(&mut swing, &state, end - time).unwrap();
            (time, state) = (if step < end - time { time + step } else { end }, next);
        }
        assert!((state[0] - 1.0).abs() < 1e-9 && state[1].abs() < 1e-9, "{state:?}");
    }

    /// A speed that dips below zero inside a step, by however little, is found; one that stays above is not.
    #[test]
    fn a_dip_is_found() {
        for k in 0..40 {
            let deep = 0.05 * 10f64.powf(-0.2 * f64::from(k));
            for (lowest, found) in [(-deep, true), (deep, false)] {
                // v = lowest + s² + s³, s = t − 0.3.
                let mut motion = |t: f64, _: &[f64; 1]| [2.0 * (t - 0.3) + 3.0 * (t - 0.3) * (t - 0.3)];
                let at = |t: f64| [lowest + (t - 0.3f64).powi(2) * (0.7 + t)];
                let dip = Stepper::new(1e-13).dip(&mut motion, (&at(0.0), &at(1.3)), (1.3, 0));
                assert_eq!(dip.map(|dip| dip.1[0] < 0.0), found.then_some(true), "{lowest:e} {dip:?}");
            }
        }
    }

    /// A parabola takes one step.
    #[test]
    fn a_throw_is_one_step() {
        let mut throw = |_: f64, [_, v]: &[f64; 2]| [*v, -10.0];
        let (step, end) = Stepper::new(1e-13).step(&mut throw, &[0.0, 5.0], 1.0).unwrap();
        assert!(step >= 1.0, "{step}");
        assert!(end[0].abs() < 1e-14 && (end[1] + 5.0).abs() < 1e-14, "{end:?}");
    }

    /// Rates that are not numbers stop the motion instead of going on for ever.
    #[test]
    fn what_has_no_rate_has_no_step() {
        let mut nothing = |_: f64, _: &[f64; 1]| [f64::NAN];
        assert!(Stepper::new(1e-12).step(&mut nothing, &[1.0], 1.0).is_none());
    }
}
