//! Which of several models the data are for.
//!
//! Schwarz's criterion −2 ln L + (p + m) ln n over the n points that count in all of them, with L for normal noise whose
//! neighbours may be alike and p parameters, of which m move a jump; exp(−Δ/2) over its sum is the weight of a model
//! (Schwarz 1978, Ann. Stat. 6, 461). A parameter that moves a jump counts twice: its best place is the luckiest of n
//! (Zhang & Siegmund 2007, Biometrics 63, 22). Akaike's 2p takes noise for adhesion: of 120 Hertzian curves with white
//! noise JKR would win 15.

use super::answer::Fit;
use super::curve::Curve;
use super::frame::Frame;
use super::noise::deviance;
use crate::scene::fit::Baseline;

/// Where a model stands among others.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Standing {
    /// Schwarz's criterion over the points that count in all models, less that of the best.
    pub beyond_best: f64,
    /// Weight, one over all models.
    pub weight: f64,
    /// Points that count in all models.
    pub points: usize,
}

/// Where each of the fits of one curve stands; empty if there is none.
#[must_use]
pub fn compared(curve: &Curve, fits: &[&Fit]) -> Vec<Standing> {
    let Some(first) = fits.first() else { return Vec::new() };
    let shared = |at: &usize| fits.iter().all(|fit| fit.used.binary_search(at).is_ok());
    let used: Vec<usize> = first.used.iter().copied().filter(shared).collect();
    let points = used.len();
    let frame = Frame::new(curve.driven(first.led), used, Baseline::Absent);
    let criterion = |fit: &&Fit| {
        let measured = curve.answered(fit.led);
        let rest: Vec<f64> = frame.used.iter().map(|&at| measured[at] - fit.model[at]).collect();
        let counted = fit.parameters.len() + fit.jumping;
        deviance(&frame, &rest) + counted as f64 * (points as f64).ln()
    };
    let criteria: Vec<f64> = fits.iter().map(criterion).collect();
    let best = criteria.iter().copied().fold(f64::INFINITY, f64::min);
    let sum: f64 = criteria.iter().map(|criterion| (-0.5 * (criterion - best)).exp()).sum();
    let standing = |criterion: f64| {
        let beyond_best = criterion - best;
        Standing { beyond_best, weight: (-0.5 * beyond_best).exp() / sum, points }
    };
    criteria.into_iter().map(standing).collect()
}
