//! One step of the motion, as polynomials between its ends.

use super::collocation::{Fading, NODES, Polynomial, RADAU, integral, slope, through_all, value};
use crate::contact::viscoelastic::Spectrum;

/// The motion at one time.
#[derive(Debug, Clone, Default)]
pub struct MotionState {
    /// Time [s].
    pub time: f64,
    /// Depth [m].
    pub depth: f64,
    /// Speed [m/s].
    pub speed: f64,
    /// Acceleration [m/s²].
    pub acceleration: f64,
    /// Hᵢ = ∫ Eᵢ e^(−(t−s)/τᵢ) ḋ ds [N/m], of a spring touched at the beginning.
    pub memory: Vec<f64>,
    /// Sᵢ = ∫ Eᵢ e^(−(t−s)/τᵢ) 2aḋ ds [N], of all springs while the contact grows.
    pub sums: Vec<f64>,
}

/// A step of the motion, θ from 0 to 1.
#[derive(Debug, Clone)]
pub struct MotionPiece {
    /// Its beginning.
    pub start: MotionState,
    /// Its duration h [s].
    pub span: f64,
    /// ḋ(θ) [m/s].
    pub velocity: Polynomial,
    /// 2aḋ(θ) [m²/s] while the contact grows.
    pub flow: Polynomial,
    /// When the spring at the edge was touched [s], at the points of the step.
    pub touched: [f64; NODES],
    /// The same at its beginning.
    pub touched_first: f64,
    /// Estimate of what it misses of the speed [m/s].
    pub missed: f64,
}

impl MotionPiece {
    /// Its end [s].
    pub fn end(&self) -> f64 {
        self.start.time + self.span
    }

    /// θ at the time `t` [s].
    pub fn part(&self, t: f64) -> f64 {
        ((t - self.start.time) / self.span).clamp(0.0, 1.0)
    }

    /// Depth [m].
    pub fn depth(&self, theta: f64) -> f64 {
        self.start.depth + self.span * integral(&self.velocity, theta)
    }

    /// Speed [m/s].
    pub fn speed(&self, theta: f64) -> f64 {
        value(&self.velocity, theta)
    }

    /// Acceleration [m/s²].
    pub fn acceleration(&self, theta: f64) -> f64 {
        slope(&self.velocity, theta) / self.span
    }

    /// About when the spring at the edge was touched [s].
    pub fn touched_at(&self, theta: f64) -> f64 {
        value(&through_all(self.touched_first, &self.touched), theta)
    }

    /// When the spring at the edge was touched [s] at the last point before θ.
    pub fn touched_before(&self, theta: f64) -> f64 {
        let before = RADAU.iter().zip(&self.touched).rev().find(|(c, _)| **c < theta);
        before.map_or(self.touched_first, |(_, touched)| *touched)
    }

    /// Hᵢ [N/m].
    pub fn memory(&self, spectrum: &Spectrum, theta: f64) -> Vec<f64> {
        self.faded(spectrum, theta).map(|(fading, modulus, k)| self.memory_of(&fading, modulus, k)).collect()
    }

    /// Sᵢ [N] while the contact grows.
    pub fn sums(&self, spectrum: &Spectrum, theta: f64) -> Vec<f64> {
        self.faded(spectrum, theta).map(|(fading, modulus, k)| self.sum_of(&fading, modulus, k)).collect()
    }

    fn faded<'s>(&self, spectrum: &'s Spectrum, theta: f64) -> impl Iterator<Item = (Fading, f64, usize)> + use<'s> {
        let span = self.span;
        let terms = spectrum.terms().iter().enumerate();
        terms.map(move |(k, term)| (Fading::new(span / term.time, theta), term.modulus, k))
    }

    /// Hᵢ of the term `k` of the modulus given.
    pub fn memory_of(&self, fading: &Fading, modulus: f64, k: usize) -> f64 {
        fading.kept * self.start.memory[k] + modulus * self.span * fading.gain(&self.velocity)
    }

    /// Sᵢ of the term `k` of the modulus given.
    pub fn sum_of(&self, fading: &Fading, modulus: f64, k: usize) -> f64 {
        fading.kept * self.start.sums[k] + modulus * self.span * fading.gain(&self.flow)
    }
}

/// The piece that holds the time `t` [s].
pub fn at(pieces: &[MotionPiece], t: f64) -> Option<&MotionPiece> {
    let next = pieces.partition_point(|piece| piece.end() < t).min(pieces.len().saturating_sub(1));
    pieces.get(next)
}
