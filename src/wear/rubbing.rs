//! The tangential springs of a worn bed.

use super::bed::{Pressed, WornBed};
use crate::friction::Grip;

/// Stick and slip of the cells of a worn bed: |G*v| ≤ μq.
#[derive(Debug, Clone)]
pub struct Rubbing {
    grip: Grip,
    /// Tangential displacements v of the springs [m].
    displaced: Vec<f64>,
}

/// State of the tangential springs.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Rubbed {
    /// Tangential force [N].
    pub force: f64,
    /// Radius up to which all sticks [m].
    pub stick_radius: f64,
    /// dF_x/du_x [N/m] while the slide goes on.
    pub stiffness: f64,
    /// Elastic energy [J].
    pub stored: f64,
    /// Energy lost on the way [J].
    pub lost: f64,
}

impl Rubbing {
    /// Springs without tangential load.
    #[must_use]
    pub fn new(grip: Grip) -> Self {
        Self { grip, displaced: Vec::new() }
    }

    /// Moduli and friction.
    #[must_use]
    pub fn grip(&self) -> Grip {
        self.grip
    }

    fn displaced(&self, i: usize) -> f64 {
        self.displaced.get(i).copied().unwrap_or(0.0)
    }

    /// Tangential line loads G*v [N/m] of `count` cells.
    pub(super) fn loads(&self, count: usize) -> Vec<f64> {
        (0..count).map(|i| self.grip.tangential_modulus * self.displaced(i)).collect()
    }

    /// Displacement [m] at which the spring of the cell `i` slips.
    fn limit(&self, pressed: &Pressed, i: usize) -> f64 {
        self.grip.coefficient * pressed.loads[i] / self.grip.tangential_modulus
    }

    /// The slide [m] towards the side of `way` after which nothing sticks.
    pub(super) fn onset(&self, pressed: &Pressed, way: f64) -> f64 {
        let left = |i: usize| self.limit(pressed, i) - way.signum() * self.displaced(i);
        (0..pressed.loads.len()).map(left).fold(0.0, f64::max)
    }

    /// The springs after a straight slide by `way` [m], as the bed is pressed now, and their state.
    pub(super) fn led(&self, bed: &WornBed, pressed: &Pressed, way: f64) -> (Self, Rubbed) {
        let modulus = self.grip.tangential_modulus;
        let (mut next, mut state) = (self.clone(), Rubbed::default());
        next.displaced.resize(pressed.loads.len(), 0.0);
        // Where a spring would be beyond its limit, by how much; it sticks below zero.
        let mut beyond = Vec::with_capacity(pressed.loads.len());
        for i in 0..pressed.loads.len() {
            let (free, limit, width) = (self.displaced(i) + way, self.limit(pressed, i), bed.rings.width(i));
            let held = free.clamp(-limit, limit);
            next.displaced[i] = held;
            state.force += 2.0 * width * modulus * held;
            state.stored += width * modulus * held * held;
            state.lost += 2.0 * width * modulus * limit * (free - held).abs();
            beyond.push(free.abs() - limit);
        }
        state.stick_radius = border(bed, &beyond).min(bed.contact_radius(pressed));
        state.stiffness = 2.0 * modulus * state.stick_radius;
        (next, state)
    }
}

/// The radius [m] at which what springs are beyond their limit passes zero.
fn border(bed: &WornBed, beyond: &[f64]) -> f64 {
    let middle = |i: usize| 0.5 * (bed.rings.cells()[i] + bed.rings.cells()[i + 1]);
    match beyond.iter().position(|&beyond| beyond >= 0.0) {
        None => bed.rings.outer(),
        Some(0) => 0.0,
        Some(k) => {
            let part = beyond[k - 1] / (beyond[k - 1] - beyond[k]);
            middle(k - 1) + part * (middle(k) - middle(k - 1))
        }
    }
}
