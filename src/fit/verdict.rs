//! Whether the data speak against the model.
//!
//! Two questions against the noise before first touch: is more left in contact than noise, and has what is left a smooth
//! shape? Both compare sums of squares of what is white, of known degrees of freedom.

use super::frame::{Frame, dot};
use super::noise::Moments;

/// What is left before first touch, where nothing but noise is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Noise {
    /// Standard deviation [unit of the response].
    pub deviation: f64,
    /// Correlation ρ of neighbours.
    pub correlation: f64,
    /// Points it was read off.
    pub points: usize,
    /// Variance of what is white.
    variance: f64,
}

/// Points before first touch from which on noise is read off them.
pub const ENOUGH: usize = 30;
/// Degrees of the polynomials a misfit is looked for with.
const DEGREES: usize = 8;
/// Part of a column that is left where little of it is taken away.
const LITTLE: f64 = 0.7;
/// Part of a fitted column below which it is a sum of those before.
const ALIKE: f64 = 1e-6;
/// The same of a polynomial: a shape is looked for in no rest that is next to none.
const SHAPE: f64 = 1e-3;
/// Standard deviations beyond which chance is no answer: one in two million.
const SURE: f64 = 5.0;

impl Noise {
    /// Of the residual `rest` at the used points `free` of first touch; `None` where they are too few.
    #[must_use]
    pub fn before(frame: &Frame, rest: &[f64], free: &[usize]) -> Option<Self> {
        if free.len() < ENOUGH {
            return None;
        }
        let part = frame.part(free);
        let rest: Vec<f64> = free.iter().map(|&number| rest[number]).collect();
        let one = vec![vec![1.0; free.len()]];
        let judged = Moments::of(&part, &one, &rest).most_likely();
        let correlation = judged.correlation;
        Some(Self {
            deviation: (judged.variance / (1.0 - correlation * correlation)).sqrt(),
            correlation,
            points: free.len(),
            variance: judged.variance,
        })
    }

    /// The same, not below the numerical error `floor` [unit of the response] of the model.
    #[must_use]
    pub fn not_below(self, floor: f64) -> Self {
        Self { deviation: self.deviation.max(floor), variance: self.variance.max(floor * floor), ..self }
    }
}

/// What the residuals in contact say.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Verdict {
    /// Mean square of what is left in contact over that of the noise, per degree of freedom.
    pub chi2: f64,
    /// How many standard deviations the size of what is left is beyond noise.
    pub size: f64,
    /// How many standard deviations its smooth part is.
    pub shape: f64,
}

impl Verdict {
    /// Of the residual `rest` at the used points `touching`, from which the columns `columns` have been fitted.
    #[must_use]
    pub fn of(frame: &Frame, (columns, rest): (&[Vec<f64>], &[f64]), touching: &[usize], noise: Noise) -> Self {
        let part = frame.part(touching);
        let part = part.with(part.weights.clone(), noise.correlation);
        let chosen = |column: &[f64]| touching.iter().map(|&number| column[number]).collect::<Vec<f64>>();
        let white = part.whitened(&chosen(rest));
        let freedom = white.len().saturating_sub(columns.len()).max(1) as f64;
        let chi2 = dot(&white, &white) / freedom / noise.variance;
        let spread = (2.0 / freedom + 2.0 / noise.points as f64).sqrt();
        let fitted: Vec<Vec<f64>> = columns.iter().map(|column| part.whitened(&chosen(column))).collect();
        let smooth =
            smooth_part(fitted, polynomials(white.len()).into_iter().map(|column| part.whitened(&column)), &white);
        Self { chi2, size: chi2.ln() / spread, shape: deviations(smooth.0 / noise.variance, smooth.1) }
    }

    /// Whether chance is no answer.
    #[must_use]
    pub fn rejects(&self) -> bool {
        is_no_chance(self.size) || is_no_chance(self.shape)
    }
}

/// Whether so many standard deviations are more than chance has.
#[must_use]
pub fn is_no_chance(deviations: f64) -> bool {
    deviations > SURE
}

/// How many standard deviations the smooth part of the residual `rest` over what drives is beyond what scatters from point to
/// point, for points that were measured each by itself: F = (S/ν)/(R/μ) of the sums of squares S of the smooth part and R of
/// the others, by its cube root (Paulson 1942, Ann. Math. Stat. 13, 233).
#[must_use]
pub fn shape_of_scatter((drive, weights): (&[f64], &[f64]), columns: &[Vec<f64>], rest: &[f64]) -> f64 {
    let mut order: Vec<usize> = (0..rest.len()).collect();
    order.sort_by(|&a, &b| drive[a].total_cmp(&drive[b]));
    let chosen = |column: &[f64]| order.iter().map(|&number| weights[number] * column[number]).collect::<Vec<f64>>();
    let left = chosen(rest);
    let fitted = columns.iter().map(|column| chosen(column)).collect();
    let weighed = |column: Vec<f64>| order.iter().zip(&column).map(|(&number, x)| weights[number] * x).collect();
    let (smooth, freedom) = smooth_part(fitted, polynomials(left.len()).into_iter().map(weighed), &left);
    let others = left.len() as f64 - columns.len() as f64 - freedom;
    let rough = dot(&left, &left) - smooth;
    if freedom < 1.0 || others < 1.0 || rough <= 0.0 {
        return 0.0;
    }
    let root = (smooth / freedom / (rough / others)).cbrt();
    let (mine, theirs) = (2.0 / (9.0 * freedom), 2.0 / (9.0 * others));
    (root * (1.0 - theirs) - (1.0 - mine)) / (mine + theirs * root * root).sqrt()
}

/// Legendre polynomials over the order of `count` points, by Bonnet's rule.
fn polynomials(count: usize) -> Vec<Vec<f64>> {
    let x: Vec<f64> = (0..count).map(|number| 2.0 * (number as f64 + 0.5) / count as f64 - 1.0).collect();
    let mut all = vec![vec![1.0; count], x.clone()];
    for degree in 1..DEGREES {
        let n = degree as f64;
        let (before, here) = (&all[degree - 1], &all[degree]);
        let next = |((x, before), here): ((&f64, &f64), &f64)| ((2.0 * n + 1.0) * x * here - n * before) / (n + 1.0);
        all.push(x.iter().zip(before).zip(here).map(next).collect());
    }
    all
}

/// Square of the part of `white` in the columns `smooth` that is not in `fitted`, and its degrees of freedom.
fn smooth_part(fitted: Vec<Vec<f64>>, smooth: impl Iterator<Item = Vec<f64>>, white: &[f64]) -> (f64, f64) {
    let mut basis: Vec<Vec<f64>> = Vec::new();
    let mut add = |mut column: Vec<f64>, least: f64| {
        let whole = dot(&column, &column).sqrt();
        let mut size = whole;
        // Twice is enough, and once where little is taken away (Daniel et al. 1976; Giraud et al. 2005).
        for _ in 0..2 {
            let before = size;
            for known in &basis {
                let part = dot(known, &column);
                column.iter_mut().zip(known).for_each(|(value, a)| *value -= part * a);
            }
            size = dot(&column, &column).sqrt();
            if size > LITTLE * before {
                break;
            }
        }
        let new = size > least * whole;
        if new {
            column.iter_mut().for_each(|value| *value /= size);
            basis.push(column.clone());
        }
        new.then_some(column)
    };
    fitted.into_iter().for_each(|column| drop(add(column, ALIKE)));
    let parts: Vec<f64> =
        smooth.filter_map(|column| add(column, SHAPE)).map(|column| dot(&column, white).powi(2)).collect();
    (parts.iter().sum(), parts.len() as f64)
}

/// How many standard deviations a χ² of `freedom` degrees is beyond its mean (Wilson & Hilferty 1931).
fn deviations(chi2: f64, freedom: f64) -> f64 {
    if freedom < 1.0 {
        return 0.0;
    }
    let width = 2.0 / (9.0 * freedom);
    ((chi2 / freedom).cbrt() - (1.0 - width)) / width.sqrt()
}
