//! Ends of the 95 % interval of a parameter.

use super::frame::{Frame, dot};
use super::solve::{Found, Place, Task};

/// Deviation of the sum of squares from its parabola up to which the parabola is taken at its word: 7 % of an interval.
const STRAIGHT: f64 = 0.15;
/// The most steps by which an end is searched for.
const STEPS: usize = 8;
/// Part of an interval to which its end is found.
const CLOSE: f64 = 0.01;

/// What ends are read off.
pub struct Valley<'v> {
    /// The task, in the frame of the noise.
    pub task: Task<'v>,
    /// Its answer.
    pub found: &'v Found,
    /// Variance of the noise.
    pub variance: f64,
    /// Covariances of natural parameters, first touch last.
    pub covariance: &'v dyn Fn(usize, usize) -> f64,
}

impl Valley<'_> {
    /// The end of parameter `at` on the natural scale, `reach` its distance by the parabola, with its sign; the
    /// parabola's own where it is good enough, `None` where the range ends first. The sum of squares rises to it by the
    /// variance times the square of the distance in standard errors.
    #[must_use]
    pub fn end(&self, at: usize, reach: f64) -> Option<f64> {
        let here = self.task.natural(at, &self.found.place);
        let beside = |share: f64| self.beside(at, share * reach);
        let whole = self.variance * reach * reach / (self.covariance)(at, at);
        if whole.is_nan() || whole <= 0.0 {
            return Some(here + reach);
        }
        let rise = self.risen(&beside(1.0)?)? / whole;
        if (rise - 1.0).abs() <= STRAIGHT {
            return Some(here + reach);
        }
        // The others are set free and the end is searched for by √rise, which is straight in a parabola.
        let (mut low, mut at_low) = (0.0, 0.0);
        let mut share = (1.0 / rise.max(0.0625).sqrt()).clamp(0.25, 4.0);
        let mut place = beside(share)?;
        // A tenth of what an end may be off.
        let tolerance = 0.2 * CLOSE * whole / (self.found.squares + whole);
        for _ in 0..STEPS {
            let freed = Task { kept: [Some(at), None], ..self.task }.solved(&place, tolerance).ok()?;
            let root = (freed.squares - self.found.squares).max(0.0).sqrt() / whole.sqrt();
            if (root - 1.0).abs() < CLOSE {
                break;
            }
            let slope = (root - at_low) / (share - low);
            (low, at_low) = (share, root);
            let next = share + (1.0 - root) / slope;
            share = if next.is_finite() && slope > 0.0 { next.clamp(0.3 * share, 3.0 * share) } else { 2.0 * share };
            place = self.farther(at, &freed.place, share / low)?;
        }
        Some(here + share * reach)
    }

    /// The place at which parameter `at` is moved by `by` and the others go with it as they are correlated.
    fn beside(&self, at: usize, by: f64) -> Option<Place> {
        self.moved(at, |number| by * (self.covariance)(number, at) / (self.covariance)(at, at))
    }

    /// The place `times` as far from the answer as another one is.
    fn farther(&self, at: usize, place: &Place, times: f64) -> Option<Place> {
        let natural = |number: usize, place: &Place| self.task.natural(number, place);
        self.moved(at, |number| times * (natural(number, place) - natural(number, &self.found.place)))
    }

    /// The place at which each parameter is moved by so much; `None` where parameter `at` leaves its range.
    fn moved(&self, at: usize, by: impl Fn(usize) -> f64) -> Option<Place> {
        let mut place = self.found.place.clone();
        for number in 0..self.task.count() {
            match self.task.model.free.get(number) {
                Some(free) => {
                    let natural = free.natural(place.values[number]) + by(number);
                    if number == at && !(free.ends().0..=free.ends().1).contains(&natural) {
                        return None;
                    }
                    place.values[number] = free.value(natural).clamp(free.low, free.high);
                }
                None => place.contact += by(number),
            }
        }
        Some(place)
    }

    /// The rise of the sum of squares at a place.
    fn risen(&self, place: &Place) -> Option<f64> {
        let rest = self.task.residual(&self.task.answer(place).ok()?);
        Some(dot(&rest, &rest) - self.found.squares)
    }
}

/// Weights of points far off, by their distance in standard deviations (Huber 1964), times those they have: their roots.
#[must_use]
pub fn huber(frame: &Frame, rest: &[f64], baseline: &[f64]) -> Vec<f64> {
    /// 95 % efficiency on normal noise.
    const FAR: f64 = 1.345;
    /// Median of the size of normal noise to its standard deviation.
    const MEDIAN: f64 = 1.4826;
    let off: Vec<f64> =
        without(frame, rest, baseline).iter().zip(&frame.weights).map(|(off, weight)| off * weight).collect();
    let mut sizes: Vec<f64> = off.iter().map(|x| x.abs()).collect();
    sizes.sort_by(f64::total_cmp);
    let deviation = (MEDIAN * sizes.get(sizes.len() / 2).copied().unwrap_or(0.0)).max(f64::MIN_POSITIVE);
    let near = |x: f64| (FAR * deviation / x.abs().max(f64::MIN_POSITIVE)).min(1.0).sqrt();
    off.iter().zip(&frame.weights).map(|(x, weight)| weight * near(*x)).collect()
}

/// The residual without the baseline of the coefficients `baseline`.
#[must_use]
pub fn without(frame: &Frame, rest: &[f64], baseline: &[f64]) -> Vec<f64> {
    let line = |number: usize| frame.columns().iter().zip(baseline).map(|(column, c)| c * column[number]).sum::<f64>();
    rest.iter().enumerate().map(|(number, value)| value - line(number)).collect()
}
