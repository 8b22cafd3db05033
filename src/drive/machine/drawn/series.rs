//! A mass whose contact sticks, by the series of its motion in time, where the load is a power of the depth.
//!
//! The friction F₀ + S(1 − uᵖ), u = 1 − w/W, is a power of a series, whose terms follow from those before (Hairer, Nørsett &
//! Wanner, *Solving Ordinary Differential Equations I*, I.8): j u₀ Pⱼ = Σᵢ (p i − (j − i)) uᵢ Pⱼ₋ᵢ. With them those of the way
//! follow from m ẍ + c ẋ + F = k(e + Vt − x) one by one. A step is as long as the last terms allow; where the mass turns or
//! meets a corner inside it is a zero of a polynomial.

use super::forces::Sticking;
use crate::friction::PowerBranch;
use crate::numerics::{quadrature, root};
use std::sync::LazyLock;

/// Terms of a series.
const TERMS: usize = 25;
/// What the last terms may be of the largest one.
const LAST: f64 = 1e-16;
/// Longest step, in radians of the fastest swing.
const LONGEST: f64 = 2.5;

/// 1/j, for terms that follow from each other without dividing.
const INVERSES: [f64; TERMS] = {
    let (mut inverses, mut j) = ([0.0; TERMS], 1);
    while j < TERMS {
        inverses[j] = 1.0 / j as f64;
        j += 1;
    }
    inverses
};

/// Nodes of the rule for what the damper takes: the square of a speed that is resolved by 25 terms, as far as it is trusted.
const NODES: usize = 16;
/// Pairs (node, weight) on [0, 1].
static RULE: LazyLock<([f64; NODES], [f64; NODES])> = LazyLock::new(|| {
    let rule: [(f64, f64); NODES] = std::array::from_fn(|k| quadrature::node_and_weight(NODES, k));
    (rule.map(|(node, _)| 0.5 + 0.5 * node), rule.map(|(_, weight)| 0.5 * weight))
});

/// The way x [m] of a mass in powers of the time since the beginning of a step over τ, a radian of its fastest swing.
pub(super) struct Series<'s, 'm> {
    sticking: &'s Sticking<'m>,
    radian: f64,
    terms: [f64; TERMS],
}

/// Σ (wᵢ/j − uᵢ)Pᵢ in four sums side by side.
fn summed((weighted, left, powers): (&[f64], &[f64], &[f64]), inverse: f64) -> f64 {
    let mut sums = [0.0; 4];
    let (mut weighted, mut left, mut powers) = (weighted.chunks(4), left.chunks(4), powers.chunks(4));
    while let (Some(weighted), Some(left), Some(powers)) = (weighted.next(), left.next(), powers.next()) {
        for (k, ((weighted, left), power)) in weighted.iter().zip(left).zip(powers).enumerate() {
            sums[k] += (weighted * inverse - left) * power;
        }
    }
    sums.iter().sum()
}

impl<'s, 'm> Series<'s, 'm> {
    /// The motion that begins at the speed `speed` [m/s]; `None` where the load is no power, or has come to its end.
    pub(super) fn new(sticking: &'s Sticking<'m>, speed: f64) -> Option<Self> {
        let branch = sticking.branch?;
        let PowerBranch { share, whole, exponent } = branch.power()?;
        let (radian, suspension) = (sticking.radian(), sticking.suspension);
        // Terms of the way, of u, and (p + 1)i uᵢ: the sum over i is that of ((p + 1)i uᵢ/j − uᵢ)Pⱼ₋ᵢ.
        let (mut way, mut left, mut weighted) = ([0.0; TERMS], [0.0; TERMS], [0.0; TERMS]);
        left[0] = 1.0 - sticking.from.0 / whole;
        if left[0] <= 0.0 {
            return None;
        }
        let power = left[0].powf(exponent);
        (way[1], left[1]) = (speed * radian, -speed * radian / whole);
        let (per_mass, drag) = (radian * radian / suspension.mass, radian * suspension.damping / suspension.mass);
        let inverse = left[0].recip();
        // Powers stand in the reverse order, so that those of a sum lie beside what they are multiplied by.
        let mut reverse = [0.0; TERMS];
        reverse[TERMS - 1] = power;
        for j in 0..TERMS - 2 {
            let order = j as f64;
            let force = if j == 0 {
                sticking.pull(0.0, 0.0) - branch.force(sticking.from.0)
            } else {
                weighted[j] = (exponent + 1.0) * order * left[j];
                let sum = summed((&weighted[1..=j], &left[1..=j], &reverse[TERMS - j..]), INVERSES[j]);
                reverse[TERMS - 1 - j] = sum * inverse;
                let drawn = if j == 1 { sticking.drawn * radian } else { 0.0 };
                suspension.stiffness * (drawn - way[j]) + share * sum * inverse
            };
            let next = (per_mass * force - drag * (order + 1.0) * way[j + 1]) * (INVERSES[j + 1] * INVERSES[j + 2]);
            (way[j + 2], left[j + 2]) = (next, -next / whole);
        }
        way.iter().all(|term| term.is_finite()).then_some(Self { sticking, radian, terms: way })
    }

    /// How far it may be trusted [s].
    pub(super) fn reach(&self) -> f64 {
        let largest = self.terms.iter().fold(0.0, |most: f64, term| most.max(term.abs()));
        let allowed = |j: usize| (LAST * largest / self.terms[j].abs()).powf((j as f64).recip());
        self.radian * allowed(TERMS - 1).min(allowed(TERMS - 2)).min(LONGEST)
    }

    /// Way [m] after the time `at`, in τ.
    fn way(&self, at: f64) -> f64 {
        self.terms.iter().rev().fold(0.0, |sum, term| sum * at + term)
    }

    /// dx/ds, which is τẋ, where `from` is 1; without its first term and over s, where `from` is 2.
    fn slope(&self, at: f64, from: usize) -> f64 {
        (from..TERMS).rev().fold(0.0, |sum, j| sum * at + j as f64 * self.terms[j])
    }

    /// d²x/ds².
    fn bend(&self, at: f64) -> f64 {
        (2..TERMS).rev().fold(0.0, |sum, j| sum * at + (j * (j - 1)) as f64 * self.terms[j])
    }

    /// Way [m], speed [m/s], work of the far end and loss in the damper [J] after the time `time` [s].
    pub(super) fn at(&self, time: f64) -> [f64; 4] {
        let at = time / self.radian;
        let (stiffness, drawn) = (self.sticking.suspension.stiffness, self.sticking.drawn);
        let sum = (0..TERMS).rev().fold(0.0, |sum, j| sum * at + self.terms[j] / (j + 1) as f64);
        let work = stiffness * drawn * time * (self.sticking.from.1 + (0.5 * drawn * time - sum));
        let damping = self.sticking.suspension.damping;
        let lost = if damping > 0.0 { damping / self.radian * self.square(at) } else { 0.0 };
        [self.way(at), self.slope(at, 1) / self.radian, work, lost]
    }

    /// ∫(dx/ds)² ds up to `to`.
    fn square(&self, to: f64) -> f64 {
        let (nodes, weights) = &*RULE;
        let (at, mut slopes) = (nodes.map(|node| to * node), [0.0; NODES]);
        for j in (1..TERMS).rev() {
            let term = j as f64 * self.terms[j];
            slopes.iter_mut().zip(&at).for_each(|(slope, at)| *slope = *slope * at + term);
        }
        to * slopes.iter().zip(weights).map(|(slope, weight)| weight * slope * slope).sum::<f64>()
    }

    /// The first time [s] up to `until` [s] at which a mass going on in the direction `ahead`, 1 or −1, turns.
    pub(super) fn turns(&self, until: f64, ahead: f64) -> Option<f64> {
        let to = until / self.radian;
        // A motion from rest has its zero at the beginning taken away.
        let from = if self.terms[1].abs() > 0.0 { 1 } else { 2 };
        let onwards = |at: f64| ahead * self.slope(at, from);
        let end = if onwards(to) < 0.0 { to } else { self.dips(to, ahead).filter(|&at| onwards(at) < 0.0)? };
        root::brent(onwards, 0.0, end).ok().map(|at| at * self.radian)
    }

    /// Where the speed is least between two falls of it.
    fn dips(&self, to: f64, ahead: f64) -> Option<f64> {
        let falls = |at: f64| -ahead * self.bend(at);
        (falls(0.0) > 0.0 && falls(to) < 0.0).then(|| root::brent(falls, 0.0, to).ok())?
    }

    /// The time [s] up to `until` [s] at which the way is `way` [m], short of which it is at the beginning and beyond which at the end.
    pub(super) fn meets(&self, way: f64, until: f64) -> f64 {
        let side = way.signum();
        self.radian * root::within(|at| side * (self.way(at) - way), 0.0, until / self.radian)
    }
}
