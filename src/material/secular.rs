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
        poles.iter().map(move |pole| self.gap(poles, pole))
    }

    /// λ − τᵢ [s] for one pole.
    fn gap(self, poles: &[Pole], pole: &Pole) -> f64 {
        (poles[self.pole].time - pole.time) + self.distance
    }
}

/// Compliances Jₘ = Πᵢ |λₘ − τᵢ| / (F λₘ Π_{j≠m} |λₘ − λⱼ|) [1/Pa], the residues of 1/E(p) at all its
/// zeros; F is `floor`, or Σ Wᵢ for a liquid.
///
/// Not the sum Jₘ = 1/(λₘ Σ Wᵢ/(λₘ−τᵢ)²): about a pole of small weight stand two zeros whose distances
/// from it feel the rounding of E(p) many times over, and their residues by the sum do not add up.
/// The product gives those of the one material that has these zeros, and its weights are the given
/// ones to rounding (Gu & Eisenstat 1994, SIAM J. Matrix Anal. Appl. 15, 1266).
pub(super) fn compliances(poles: &[Pole], floor: f64, zeros: &[Zero]) -> Vec<f64> {
    (0..zeros.len()).map(|m| compliance(poles, floor, zeros, m)).collect()
}

/// Jₘ as quotients near one; a pole stands between two zeros, so every λₘ − λⱼ is a sum of like signs.
fn compliance(poles: &[Pole], floor: f64, zeros: &[Zero], m: usize) -> f64 {
    let gap = |pole: usize| zeros[m].gap(poles, &poles[pole]);
    let between = |other: usize| {
        let pole = m.max(other);
        gap(other) / (gap(pole) - zeros[other].gap(poles, &poles[pole]))
    };
    let others: f64 = (0..zeros.len()).filter(|&other| other != m).map(between).product();
    let scale = if floor > 0.0 {
        floor.recip()
    } else {
        -gap(poles.len() - 1) / poles.iter().map(|pole| pole.weight).sum::<f64>()
    };
    gap(m) / zeros[m].value(poles) * others * scale
}

/// The zero between the poles `k − 1` and `k`.
fn between(poles: &[Pole], floor: f64, k: usize) -> Zero {
    let (below, above) = (poles[k - 1].time, poles[k].time);
    let middle = 0.5 * (above - below);
    // Beyond the middle, should the zero be there: with equal weights it is, and rounding picks a side.
    let most = 1.5 * middle;
    if operational(poles, floor, Zero { pole: k - 1, distance: middle }) > 0.0 {
        let pull: f64 = poles[k..].iter().map(|p| p.weight / ((p.time - below) - middle)).sum();
        let least = 0.5 * poles[k - 1].weight / (floor + pull);
        return settled(poles, floor, Zero { pole: k - 1, distance: 1.0 }, (least, most));
    }
    let pull: f64 = poles[..k].iter().map(|p| p.weight / ((above - p.time) - middle)).sum();
    settled(poles, floor, Zero { pole: k, distance: -1.0 }, (0.5 * poles[k].weight / pull, most))
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
