//! Noise whose neighbours are alike, and what it leaves of the certainty.
//!
//! r_i = ρr_{i−1} + e_i with white e (AR(1)). ρ maximises the restricted likelihood (Patterson & Thompson 1971), which
//! counts what the fitted columns X have taken out of the residuals:
//! −2 ln L = (n − p) ln(S/(n − p)) + ln|XᵀR⁻¹X| − ln(1 − ρ²) − Σ ln c, with S = rᵀR⁻¹r after X, and p columns. Over a gap of g
//! rows what is left goes on by ρ^g: r_i = ρ^g r_{i−g} + e/√c, c = (1 − ρ²)/(1 − ρ^{2g}).

use super::frame::{Frame, dot, over_gap};
use nalgebra::{DMatrix, DVector};
use std::ops::Range;

/// Sums over neighbours from which every ρ is judged without looking at the points again.
#[derive(Debug, Clone)]
pub struct Moments {
    /// Σ a_i a_iᵀ over points with a neighbour before them.
    later: DMatrix<f64>,
    /// The same of the neighbours.
    earlier: DMatrix<f64>,
    /// Σ (a_i a_{i−1}ᵀ + a_{i−1} a_iᵀ).
    crossed: DMatrix<f64>,
    /// The same of the first point.
    first: DMatrix<f64>,
    gaps: Vec<Gap>,
    points: usize,
    /// Scales of the columns, the residual last.
    scales: Vec<f64>,
}

/// The same sums of a point behind a gap and the one before it.
#[derive(Debug, Clone)]
struct Gap {
    steps: i32,
    later: DMatrix<f64>,
    earlier: DMatrix<f64>,
    crossed: DMatrix<f64>,
}

/// Factors of the sums over a gap at a correlation: c, cρ^{2g} and cρ^g.
#[derive(Debug, Clone, Copy)]
struct Over {
    later: f64,
    earlier: f64,
    crossed: f64,
}

impl Over {
    fn of(steps: i32, rho: f64) -> Self {
        let (kept, later) = (rho.powi(steps), 1.0 / over_gap(steps, rho).powi(2));
        Self { later, earlier: later * kept * kept, crossed: later * kept }
    }
}

/// What is known at a correlation.
#[derive(Debug, Clone)]
pub struct Judged {
    /// Correlation ρ of neighbours.
    pub correlation: f64,
    /// Variance of e.
    pub variance: f64,
    /// (XᵀR⁻¹X)⁻¹, to be multiplied by the variance of e; `None` where columns cannot be told apart.
    pub inverse: Option<DMatrix<f64>>,
    /// The normal matrix of columns of length one, whose least eigenvalue tells how well they are told apart.
    pub normal: DMatrix<f64>,
    /// What the columns take of the residual, one coefficient each; empty where they cannot be told apart.
    pub shift: Vec<f64>,
    /// −2 ln L, up to a constant of the columns.
    pub likelihood: f64,
    /// ln(|R||XᵀR⁻¹X|), up to a constant of the columns.
    pub volume: f64,
}

/// The largest correlation looked for.
const LARGEST: f64 = 0.9999;
/// Golden section leaves (√5 − 1)/2 of the interval in a step: forty leave 4e-9.
const STEPS: usize = 40;

impl Moments {
    /// Of the columns `columns` and the residual `rest`, one value per used point of the frame, weighted.
    #[must_use]
    pub fn of(frame: &Frame, columns: &[Vec<f64>], rest: &[f64]) -> Self {
        let all: Vec<Vec<f64>> =
            columns.iter().map(Vec::as_slice).chain([rest]).map(|column| weighted(frame, column)).collect();
        let scales: Vec<f64> = all.iter().map(|column| length(column).max(f64::MIN_POSITIVE)).collect();
        let count = all.len();
        let zero = DMatrix::zeros(count, count);
        let (mut later, mut earlier, mut crossed, mut first) = (zero.clone(), zero.clone(), zero.clone(), zero);
        let runs = runs(frame);
        let gaps = runs.iter().skip(1).map(|run| gap(frame, &all, (&scales, run.start))).collect();
        for j in 0..count {
            for k in 0..=j {
                let scale = 1.0 / (scales[j] * scales[k]);
                let sums = neighbours(&all[j], &all[k], &runs);
                for (matrix, sum) in [&mut later, &mut earlier, &mut crossed, &mut first].into_iter().zip(sums) {
                    matrix[(j, k)] = sum * scale;
                    matrix[(k, j)] = sum * scale;
                }
            }
        }
        Self { later, earlier, crossed, first, gaps, points: frame.len(), scales }
    }

    /// What is known if neighbours have the correlation `rho`.
    #[must_use]
    pub fn judged(&self, rho: f64) -> Judged {
        let mut whole =
            &self.later + &self.earlier * (rho * rho) - &self.crossed * rho + &self.first * (1.0 - rho * rho);
        for gap in &self.gaps {
            let over = Over::of(gap.steps, rho);
            whole += &gap.later * over.later + &gap.earlier * over.earlier - &gap.crossed * over.crossed;
        }
        let p = self.scales.len() - 1;
        let normal = whole.view((0, 0), (p, p)).clone_owned();
        let tail = whole.view((0, p), (p, 1)).clone_owned();
        let cholesky = normal.clone().cholesky();
        let taken = cholesky.as_ref().map_or(0.0, |root| (tail.transpose() * root.solve(&tail))[(0, 0)]);
        let freedom = self.freedom();
        let squares = (whole[(p, p)] - taken).max(0.0);
        let determinant = cholesky.as_ref().map_or(0.0, |root| root.l().diagonal().iter().map(|x| 2.0 * x.ln()).sum());
        let variance = squares * self.scales[p].powi(2) / freedom;
        let volume = determinant + self.of_noise(rho);
        let likelihood = freedom * squares.max(f64::MIN_POSITIVE).ln() + volume;
        let unscaled = |at: usize, x: f64| x * self.scales[p] / self.scales[at];
        let shift = cholesky.as_ref().map_or_else(Vec::new, |root| {
            root.solve(&tail).iter().enumerate().map(|(at, &x)| unscaled(at, x)).collect()
        });
        let inverse = cholesky.map(|root| {
            let scale = DMatrix::from_diagonal(&DVector::from_iterator(p, self.scales[..p].iter().map(|s| 1.0 / s)));
            &scale * root.inverse() * &scale
        });
        Judged { correlation: rho, variance, inverse, normal: correlated(&normal), shift, likelihood, volume }
    }

    /// The most likely correlation, zero unless it is more than two standard errors from it.
    #[must_use]
    pub fn most_likely(&self) -> Judged {
        let (white, peak) = (self.judged(0.0), self.judged(self.peak().tanh()));
        // Twice the standard error is a likelihood ratio of 4.
        if peak.likelihood < white.likelihood - 4.0 { peak } else { white }
    }

    /// atanh of the most likely correlation.
    #[must_use]
    pub fn peak(&self) -> f64 {
        let mut triangle = Vec::new();
        let mut at = |x: f64| (x.tanh(), self.likelihood(x.tanh(), &mut triangle));
        let (mut low, mut high) = (-LARGEST.atanh(), LARGEST.atanh());
        let golden = 0.5 * (5f64.sqrt() - 1.0);
        let (mut left, mut right) = (high - golden * (high - low), low + golden * (high - low));
        let (mut at_left, mut at_right) = (at(left), at(right));
        for _ in 0..STEPS {
            if at_left.1 < at_right.1 {
                (high, right, at_right) = (right, left, at_left);
                left = high - golden * (high - low);
                at_left = at(left);
            } else {
                (low, left, at_left) = (left, right, at_right);
                right = low + golden * (high - low);
                at_right = at(right);
            }
        }
        at_left.0.atanh()
    }

    /// ln|R| in units of the variance of e.
    fn of_noise(&self, rho: f64) -> f64 {
        let gaps = self.gaps.iter().map(|gap| 2.0 * over_gap(gap.steps, rho).ln()).sum::<f64>();
        gaps - (1.0 - rho * rho).ln()
    }

    /// Number of points.
    #[must_use]
    pub fn points(&self) -> usize {
        self.points
    }

    /// Degrees of freedom left by the columns.
    #[must_use]
    pub fn freedom(&self) -> f64 {
        self.points.saturating_sub(self.scales.len() - 1).max(1) as f64
    }

    /// atanh of the largest correlation looked for.
    #[must_use]
    pub fn farthest() -> f64 {
        LARGEST.atanh()
    }

    /// −2 ln L at the correlation `rho`, as of [`judged`](Self::judged): the root of the bordered normal matrix, row by row
    /// in `triangle`, has the determinant and, last of all, what is left after the columns.
    fn likelihood(&self, rho: f64, triangle: &mut Vec<f64>) -> f64 {
        let count = self.scales.len();
        let over: Vec<Over> = self.gaps.iter().map(|gap| Over::of(gap.steps, rho)).collect();
        triangle.clear();
        let mut determinant = 0.0;
        let mut squares = 0.0;
        for j in 0..count {
            let row = triangle.len();
            for k in 0..=j {
                let behind = self.gaps.iter().zip(&over).map(|(gap, over)| {
                    gap.later[(j, k)] * over.later + gap.earlier[(j, k)] * over.earlier
                        - gap.crossed[(j, k)] * over.crossed
                });
                let whole = self.later[(j, k)] + rho * rho * (self.earlier[(j, k)] - self.first[(j, k)])
                    - rho * self.crossed[(j, k)]
                    + self.first[(j, k)]
                    + behind.sum::<f64>();
                let above = k * (k + 1) / 2;
                let taken: f64 =
                    triangle[row..].iter().zip(&triangle[above..]).take(k).map(|(one, other)| one * other).sum();
                let rest = whole - taken;
                if k < j {
                    triangle.push(rest / triangle[above + k]);
                } else if j + 1 == count {
                    squares = rest.max(0.0);
                } else if rest > 0.0 {
                    determinant += rest.ln();
                    triangle.push(rest.sqrt());
                } else {
                    // Columns that cannot be told apart.
                    return self.judged(rho).likelihood;
                }
            }
        }
        let freedom = self.freedom();
        freedom * squares.max(f64::MIN_POSITIVE).ln() + determinant + self.of_noise(rho)
    }
}

/// The sums of the point number `at` behind a gap and the one before it.
fn gap(frame: &Frame, all: &[Vec<f64>], (scales, at): (&[f64], usize)) -> Gap {
    let of = |product: &dyn Fn(&[f64], &[f64]) -> f64| {
        DMatrix::from_fn(all.len(), all.len(), |j, k| product(&all[j], &all[k]) / (scales[j] * scales[k]))
    };
    Gap {
        steps: frame.steps(at),
        later: of(&|a, b| a[at] * b[at]),
        earlier: of(&|a, b| a[at - 1] * b[at - 1]),
        crossed: of(&|a, b| a[at] * b[at - 1] + a[at - 1] * b[at]),
    }
}

/// Runs of used points without a gap.
fn runs(frame: &Frame) -> Vec<Range<usize>> {
    let starts: Vec<usize> = (0..frame.len()).filter(|&i| !frame.follows(i)).collect();
    let ends = starts.iter().skip(1).copied().chain([frame.len()]);
    starts.iter().zip(ends).map(|(&start, end)| start..end).collect()
}

/// Σ ab over points with a neighbour before them, over those neighbours, of each with the other's neighbour, and of the
/// first point.
fn neighbours(a: &[f64], b: &[f64], runs: &[Range<usize>]) -> [f64; 4] {
    let mut sums = [0.0; 4];
    for run in runs {
        let (a, b) = (&a[run.clone()], &b[run.clone()]);
        let last = a.len() - 1;
        sums[0] += dot(&a[1..], &b[1..]);
        sums[1] += dot(&a[..last], &b[..last]);
        sums[2] += dot(&a[1..], &b[..last]) + dot(&a[..last], &b[1..]);
        if run.start == 0 {
            sums[3] = a[0] * b[0];
        }
    }
    sums
}

/// −2 ln L of what is left at the used points, for normal noise of the deviation and the correlation that make it least,
/// up to a constant of the number of points.
#[must_use]
pub fn deviance(frame: &Frame, rest: &[f64]) -> f64 {
    let moments = Moments::of(frame, &[], rest);
    moments.most_likely().likelihood + 2.0 * rest.len() as f64 * moments.scales[0].ln()
}

/// A normal matrix with ones on its diagonal.
fn correlated(normal: &DMatrix<f64>) -> DMatrix<f64> {
    DMatrix::from_fn(normal.nrows(), normal.ncols(), |j, k| {
        let scale = (normal[(j, j)] * normal[(k, k)]).sqrt();
        if scale > 0.0 { normal[(j, k)] / scale } else { f64::from(u8::from(j == k)) }
    })
}

fn weighted(frame: &Frame, column: &[f64]) -> Vec<f64> {
    column.iter().zip(&frame.weights).map(|(value, weight)| value * weight).collect()
}

fn length(column: &[f64]) -> f64 {
    dot(column, column).sqrt()
}

/// Quantile of Student's t for 97.5 %, with `freedom` degrees of freedom (expansion of Cornish & Fisher 1938).
///
/// Within 3e-4 from 5 degrees of freedom on (Abramowitz & Stegun 26.7.5).
#[must_use]
pub fn student(freedom: f64) -> f64 {
    let (z, nu) = (NORMAL, freedom.max(1.0));
    let terms = [
        z,
        (z.powi(3) + z) / 4.0,
        (5.0 * z.powi(5) + 16.0 * z.powi(3) + 3.0 * z) / 96.0,
        (3.0 * z.powi(7) + 19.0 * z.powi(5) + 17.0 * z.powi(3) - 15.0 * z) / 384.0,
        (79.0 * z.powi(9) + 776.0 * z.powi(7) + 1482.0 * z.powi(5) - 1920.0 * z.powi(3) - 945.0 * z) / 92160.0,
    ];
    terms.iter().rev().fold(0.0, |sum, term| sum / nu + term)
}

/// Quantile of the normal distribution for 97.5 %.
pub const NORMAL: f64 = 1.959_963_984_540_054;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::fit::Baseline;

    /// Tables of Student's t.
    #[test]
    fn quantiles() {
        for (freedom, t) in [(5.0, 2.570582), (10.0, 2.228139), (30.0, 2.042272), (1000.0, 1.962339)] {
            assert!((student(freedom) - t).abs() < 3e-4, "{freedom} {}", student(freedom));
        }
    }

    /// Numbers in (−1/2, 1/2) of a linear congruential generator.
    fn noise(count: usize, rho: f64) -> Vec<f64> {
        let (mut seed, mut last) = (7u64, 0.0);
        let mut draw = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        let mut next = || {
            last = rho * last + draw();
            last
        };
        (0..count).map(|_| next()).collect()
    }

    /// The sums against white columns, and the determinant against that of the whole matrix, with gaps.
    #[test]
    fn noise_goes_on_behind_gaps() {
        let used = vec![0, 1, 2, 5, 6, 10, 11, 12, 13];
        let count = used.len();
        let values = noise(count, 0.0);
        let frame = Frame::new(&[0.0; 14], used.clone(), Baseline::Absent);
        for rho in [0.0, 0.3, 0.9, -0.5] {
            let judged = Moments::of(&frame, &[], &values).judged(rho);
            let white = frame.with(vec![1.0; count], rho).whitened(&values);
            let scale = length(&values);
            assert!((judged.variance * count as f64 / dot(&white, &white) - 1.0).abs() < 1e-12);
            // R_ij = ρ^{|i − j|}/(1 − ρ²).
            let apart = |i: usize, j: usize| i32::try_from(used[i].abs_diff(used[j])).unwrap();
            let whole = DMatrix::from_fn(count, count, |i, j| rho.powi(apart(i, j)) / (1.0 - rho * rho));
            let rest = DVector::from_vec(values.clone());
            let squares = rest.dot(&whole.clone().lu().solve(&rest).unwrap());
            assert!((squares / dot(&white, &white) - 1.0).abs() < 1e-12, "{rho}");
            let exact = count as f64 * (squares / (scale * scale)).ln() + whole.determinant().ln();
            assert!((judged.likelihood - exact).abs() < 1e-10, "{rho} {} {exact}", judged.likelihood);
        }
    }

    #[test]
    fn the_correlation_is_found() {
        for rho in [0.0, 0.5, 0.9, 0.99] {
            let frame = Frame::new(&vec![0.0; 20_000], (0..20_000).collect(), Baseline::Constant);
            let found = Moments::of(&frame, frame.columns(), &noise(20_000, rho)).most_likely();
            // Standard error of ρ: √((1 − ρ²)/n), four of them.
            assert!((found.correlation - rho).abs() <= 4.0 * ((1.0 - rho * rho) / 2e4f64).sqrt(), "{found:?}");
            assert!((found.variance * 12.0 - 1.0).abs() < 0.05, "{found:?}");
        }
    }
}
