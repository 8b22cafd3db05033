//! Zeros of the operational modulus: from relaxation times to retardation times.

use crate::numerics::root;

/// A pole at the time τᵢ [s] with the weight Wᵢ = Eᵢτᵢ [Pa s].
#[derive(Debug, Clone, Copy)]
pub(super) struct Pole {
    pub time: f64,
    pub weight: f64,
}

/// A zero λ = τ_k + δ, kept as its distance δ [s] from the pole next to it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Zero {
    pole: usize,
    distance: f64,
}

/// The zeros of h(λ) = floor + Σ Wᵢ/(τᵢ − λ), λ > τ₁, in ascending order.
///
/// h is the operational modulus E(p) at p = −1/λ. It grows from −∞ to ∞ between neighbouring poles,
/// so there is one zero between each two, and one beyond the last pole if `floor` > 0. Each is
/// sought as the logarithm of its distance from the nearer pole: over any number of decades no
/// difference of near numbers is formed (the shifted origins of LAPACK's `dlaed4`).
pub(super) fn roots(poles: &[Pole], floor: f64) -> Vec<Zero> {
    let inner = (1..poles.len()).map(|k| between(poles, floor, k));
    let last = (floor > 0.0 && !poles.is_empty()).then(|| beyond(poles, floor));
    inner.chain(last).collect()
}

impl Zero {
    /// λ [s].
    pub(super) fn value(self, poles: &[Pole]) -> f64 {
        poles[self.pole].time + self.distance
    }

    /// λ − τᵢ [s] for every pole.
    pub(super) fn gaps(self, poles: &[Pole]) -> impl Iterator<Item = f64> {
        let origin = poles[self.pole].time;
        poles.iter().map(move |pole| (origin - pole.time) + self.distance)
    }

    /// Compliance 1/(λ Σ Wᵢ/(λ−τᵢ)²) [1/Pa], the residue of 1/E(p) at the zero.
    pub(super) fn compliance(self, poles: &[Pole]) -> f64 {
        let sum: f64 = poles.iter().zip(self.gaps(poles)).map(|(pole, gap)| pole.weight / gap / gap).sum();
        (self.value(poles) * sum).recip()
    }
}

/// The zero between the poles `k − 1` and `k`.
fn between(poles: &[Pole], floor: f64, k: usize) -> Zero {
    let (below, above) = (poles[k - 1].time, poles[k].time);
    let gap = above - below;
    let middle = 0.5 * gap;
    if operational(poles, floor, Zero { pole: k - 1, distance: middle }) > 0.0 {
        let pull: f64 = poles[k..].iter().map(|p| p.weight / ((p.time - below) - middle)).sum();
        let least = 0.5 * poles[k - 1].weight / (floor + pull);
        return settled(poles, floor, Zero { pole: k - 1, distance: 1.0 }, (least, middle));
    }
    let pull: f64 = poles[..k].iter().map(|p| p.weight / ((above - p.time) - middle)).sum();
    settled(poles, floor, Zero { pole: k, distance: -1.0 }, (0.5 * poles[k].weight / pull, middle))
}

/// The zero beyond the last pole.
fn beyond(poles: &[Pole], floor: f64) -> Zero {
    let pole = poles.len() - 1;
    let total: f64 = poles.iter().map(|p| p.weight).sum();
    let most = (2.0 * (total / floor)).min(f64::MAX / 1e9);
    settled(poles, floor, Zero { pole, distance: 1.0 }, (0.5 * (poles[pole].weight / floor).min(most), most))
}

/// The zero on the side of its pole that `side.distance` = ±1 names, between two distances.
fn settled(poles: &[Pole], floor: f64, side: Zero, (least, most): (f64, f64)) -> Zero {
    let at = |distance: f64| Zero { pole: side.pole, distance: distance * side.distance };
    let scaled = |log: f64| log.exp() * operational(poles, floor, at(log.exp()));
    let distance = root::brent(scaled, least.min(most).ln(), most.ln()).map_or(least, f64::exp);
    (0..3).fold(at(distance), |zero, _| polished(poles, floor, zero))
}

/// One step of Newton on δ·h(τ_k + δ), which is close to a straight line near its pole.
fn polished(poles: &[Pole], floor: f64, zero: Zero) -> Zero {
    let h = operational(poles, floor, zero);
    let slope: f64 = poles.iter().zip(zero.gaps(poles)).map(|(pole, gap)| pole.weight / gap / gap).sum();
    let step = zero.distance * h / (h + zero.distance * slope);
    let better = step.is_finite() && step.abs() < 1e-6 * zero.distance.abs();
    Zero { distance: if better { zero.distance - step } else { zero.distance }, ..zero }
}

/// h(λ) at a zero's place.
fn operational(poles: &[Pole], floor: f64, at: Zero) -> f64 {
    floor - poles.iter().zip(at.gaps(poles)).map(|(pole, gap)| pole.weight / gap).sum::<f64>()
}
