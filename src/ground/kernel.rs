//! What a load at one place of the bed of a layered body takes from another.

use crate::numerics::chebyshev::Chebyshev;
use crate::numerics::quadrature;
use std::fmt::{self, Debug, Formatter};
use std::sync::{Arc, OnceLock};

/// Nodes per octave: the nearest singularity, of the image at the depth 2h, leaves 7^(−20).
const NODES: usize = 20;
/// What may be left out of κ, which is about one on the axis.
const FLOOR: f64 = 1e-18;
/// Octaves of the distance that are kept; beyond them the integral is taken every time.
const OCTAVES: usize = 12;
/// Most halvings of the wave number from 1 down.
const LOW: i32 = 60;
/// Wave number from which on nothing is left: t²e^(−2t) = 1e-18.
const HIGH: f64 = 24.0;
/// Longest panel in the wave number, for poles at about π/2 from the axis.
const LONGEST: f64 = 2.0;
/// Longest panel in the phase.
const PHASE: f64 = 24.0;
/// Distance up to which the longest panel serves.
const NEAR: f64 = PHASE / LONGEST;
/// Pieces of an octave, which two digits of the mantissa number.
const CELLS: usize = 4;
/// Terms of a piece: an eighth of the distance to the nearest singularity leaves 16^(−14).
const TERMS: usize = 14;

/// κ(y) = ∫₀^∞ (1 − M(t)) cos(ty) dt [1], and the same with J₀(ty), lengths in thicknesses of the top layer.
#[derive(Clone)]
pub(super) struct Kernel {
    /// 1 − M(t).
    lacking: Arc<dyn Fn(f64) -> f64 + Send + Sync>,
    /// A wave number below which M does not change.
    least: f64,
    /// Wave numbers and 1 − M times their weight, for distances up to [`NEAR`].
    near: OnceLock<Vec<(f64, f64)>>,
    straight: Octaves,
    round: Octaves,
}

/// A transform of 1 − M, octave by octave of the distance.
#[derive(Clone)]
struct Octaves {
    wave: fn(f64) -> f64,
    kept: Vec<OnceLock<[Cell; CELLS]>>,
}

/// A piece of an octave in powers of the distance from its middle, in halves of its length.
#[derive(Debug, Clone, Copy)]
struct Cell {
    middle: f64,
    per_half: f64,
    powers: [f64; TERMS],
}

impl Cell {
    /// `function` over the interval.
    fn of(function: &Chebyshev, (low, high): (f64, f64)) -> Self {
        let powers = Chebyshev::of(|y| function.at(y), TERMS, (low, high)).powers();
        let powers = std::array::from_fn(|n| powers.get(n).copied().unwrap_or(0.0));
        Self { middle: 0.5 * (low + high), per_half: 2.0 / (high - low), powers }
    }

    /// Even and odd powers apart, two sums that do not wait for each other.
    fn at(&self, y: f64) -> f64 {
        let t = (y - self.middle) * self.per_half;
        let (square, mut even, mut odd) = (t * t, 0.0, 0.0);
        for pair in self.powers.chunks_exact(2).rev() {
            even = even * square + pair[0];
            odd = odd * square + pair[1];
        }
        even + t * odd
    }
}

impl Octaves {
    fn of(wave: fn(f64) -> f64) -> Self {
        Self { wave, kept: vec![OnceLock::new(); OCTAVES] }
    }
}

impl Debug for Kernel {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.debug_struct("Kernel").finish_non_exhaustive()
    }
}

impl Kernel {
    /// With M(t) that does not change below the wave number `least`.
    pub(super) fn new(lacking: impl Fn(f64) -> f64 + Send + Sync + 'static, least: f64) -> Self {
        let (straight, round) = (Octaves::of(f64::cos), Octaves::of(libm::j0));
        Self { lacking: Arc::new(lacking), least, near: OnceLock::new(), straight, round }
    }

    /// 1 − M at the wave number `t`.
    pub(super) fn lacking(&self, t: f64) -> f64 {
        (self.lacking)(t)
    }

    /// K(x, ξ) = (2/π)∫(1 − M) cos kx cos kξ dk.
    pub(super) fn between(&self, x: f64, other: f64) -> f64 {
        let straight = |y: f64| self.at(y, &self.straight);
        std::f64::consts::FRAC_1_PI * (straight((x - other).abs()) + straight(x + other))
    }

    /// ∫₀^∞ (1 − M(t)) J₀(tr) dt at the distance `r` ≥ 0.
    pub(super) fn around(&self, r: f64) -> f64 {
        self.at(r, &self.round)
    }

    fn at(&self, y: f64, octaves: &Octaves) -> f64 {
        let (octave, cell) = place(y);
        match octaves.kept.get(octave) {
            Some(kept) => kept.get_or_init(|| self.octave(octave, octaves.wave))[cell].at(y),
            None => transformed(&self.samples(y), octaves.wave, y),
        }
    }

    /// The transform over the octave that ends at 2ⁿ; the first one begins at the axis.
    fn octave(&self, octave: usize, wave: fn(f64) -> f64) -> [Cell; CELLS] {
        let high = (octave as f64).exp2();
        let low = if octave == 0 { 0.0 } else { 0.5 * high };
        let far = if high > NEAR { self.samples(high) } else { Vec::new() };
        let samples = if high > NEAR { &far } else { self.near.get_or_init(|| self.samples(NEAR)) };
        let whole = Chebyshev::of(|y| transformed(samples, wave, y), NODES, (low, high)).trimmed(FLOOR);
        let border = |cell: usize| low + (high - low) * cell as f64 / CELLS as f64;
        std::array::from_fn(|cell| Cell::of(&whole, (border(cell), border(cell + 1))))
    }

    /// Wave numbers and 1 − M times their weight, for distances up to `y`.
    fn samples(&self, y: f64) -> Vec<(f64, f64)> {
        let longest = LONGEST.min(PHASE / y);
        let powers = (-LOW..=0).map(|power| f64::from(power).exp2()).filter(|&border| border >= self.least);
        let borders: Vec<f64> = std::iter::once(0.0).chain(powers).chain([HIGH]).collect();
        let mut samples = Vec::new();
        for ends in borders.windows(2) {
            let [low, high] = ends else { continue };
            let count = ((high - low) / longest).ceil().max(1.0);
            let half = 0.5 * (high - low) / count;
            let mut middle = low + half;
            while middle < *high {
                let nodes = quadrature::nodes().iter().map(|&(x, weight)| (middle + half * x, half * weight));
                samples.extend(nodes.map(|(t, weight)| (t, weight * (self.lacking)(t))));
                middle += 2.0 * half;
            }
        }
        samples
    }
}

/// The octave n of `y`, 2^(n−1) ≤ y < 2ⁿ or 0 for y < 1, and the piece of it: exponent and first two digits of the mantissa.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "below four, and eleven binary digits")]
fn place(y: f64) -> (usize, usize) {
    if y < 1.0 {
        return (0, (y * CELLS as f64) as usize);
    }
    let digits = y.to_bits() >> 50;
    ((digits >> 2) as usize - 1022, (digits & 3) as usize)
}

fn transformed(samples: &[(f64, f64)], wave: fn(f64) -> f64, y: f64) -> f64 {
    samples.iter().map(|&(t, lacking)| lacking * wave(t * y)).sum()
}
