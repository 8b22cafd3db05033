//! The force of the bed while the contact grows and while it shrinks.
//!
//! A spring touched at t_c has the element loads sᵢ = Hᵢ(t) − e^(−(t−t_c)/τᵢ) Hᵢ(t_c). So while the
//! contact grows the force is 2E∞N(a) + Σ Sᵢ + 2aηḋ, and while it shrinks, with the spring at the edge
//! touched at t₁, 2E∞[N(a) + a(d − g(a))] + Σ {e^(−(t−t₁)/τᵢ) Sᵢ(t₁) + 2a sᵢ} + 2aηḋ, everything at t₁
//! being that of the growing contact. The edge is where its spring is let go: at q = 0 (Ting 1966; Lee & Radok 1960).

use super::StruckHalfSpace;
use super::collocation::Fading;
use super::piece::{MotionPiece, at};
use crate::numerics::root;
use crate::shape::Rim;

/// What the bed does at one time.
#[derive(Debug, Clone, Copy, Default)]
pub struct BedResponse {
    /// Force [N].
    pub force: f64,
    /// Contact radius [m].
    pub radius: f64,
    /// When the spring at the edge was touched [s].
    pub touched: f64,
    /// Whether the bodies touch.
    pub joined: bool,
}

/// Where the indenter is, and what it has left in a spring touched at the beginning.
#[derive(Debug, Clone, Copy)]
pub struct Kinematics<'m> {
    /// Time [s].
    pub time: f64,
    /// Depth [m].
    pub depth: f64,
    /// Speed [m/s].
    pub speed: f64,
    /// Hᵢ [N/m].
    pub memory: &'m [f64],
}

/// The load of one spring and how it depends on the time at which it was touched.
struct Load {
    /// q [N/m].
    load: f64,
    /// E(t − t_c) [Pa].
    stiffness: f64,
    /// Height g of the indenter above the spring [m], and ḋ as it was touched.
    height: f64,
    speed: f64,
}

/// A contact that has stopped growing.
#[derive(Debug, Clone, Copy)]
pub struct Shrinking<'p> {
    /// What the bed is made of.
    pub model: &'p StruckHalfSpace,
    /// How it was loaded.
    pub loading: &'p [MotionPiece],
    /// When the outermost spring was touched [s]: the end of the loading, or before it under a wall.
    pub full: f64,
}

impl<'p> Shrinking<'p> {
    /// The contact of a bed that was loaded so.
    pub fn new(model: &'p StruckHalfSpace, loading: &'p [MotionPiece]) -> Self {
        let turn = loading.last().map_or(0.0, MotionPiece::end);
        let full = match model.profile.rim() {
            Rim::Wall(end) => touch_of(model, loading, end).0.min(turn),
            Rim::None | Rim::End(_) => turn,
        };
        Self { model, loading, full }
    }

    /// Load at `place` of the spring touched at the time `touched`.
    fn load(&self, place: &Kinematics<'_>, touched: f64) -> Load {
        let spectrum = &self.model.spectrum;
        let Some(piece) = at(self.loading, touched) else {
            return Load { load: 0.0, stiffness: 0.0, height: 0.0, speed: 0.0 };
        };
        let (theta, age) = (piece.part(touched), place.time - touched);
        let height = piece.depth(theta);
        let mut load = spectrum.equilibrium() * (place.depth - height) + spectrum.viscosity() * place.speed;
        let mut stiffness = spectrum.equilibrium();
        for (k, term) in spectrum.terms().iter().enumerate() {
            let fading = Fading::new(piece.span / term.time, theta);
            let kept = (-age / term.time).exp();
            load += place.memory[k] - kept * piece.memory_of(&fading, term.modulus, k);
            stiffness += kept * term.modulus;
        }
        Load { load, stiffness, height, speed: piece.speed(theta) }
    }

    /// The load of the first spring touched: negative once the bodies have parted, if nothing holds them.
    pub fn first(&self, place: &Kinematics<'_>) -> f64 {
        let spectrum = &self.model.spectrum;
        spectrum.equilibrium() * place.depth + place.memory.iter().sum::<f64>() + spectrum.viscosity() * place.speed
    }

    /// The contact at `place`; `hint` is when the spring at the edge may have been touched.
    pub fn answer(&self, place: &Kinematics<'_>, hint: f64) -> BedResponse {
        self.released(place, hint).map_or_else(BedResponse::default, |touched| self.held(place, touched))
    }

    /// When the spring just let go was touched; `None` if all are.
    fn released(&self, place: &Kinematics<'_>, hint: f64) -> Option<f64> {
        if self.first(place) <= 0.0 {
            return None;
        }
        if self.load(place, self.full).load >= 0.0 {
            return Some(self.full);
        }
        let (mut low, mut high) = (0.0, self.full);
        let mut t = hint.clamp(low, high);
        for _ in 0..100 {
            let seen = self.load(place, t);
            *(if seen.load > 0.0 { &mut low } else { &mut high }) = t;
            let mut next = t + seen.load / (seen.speed * seen.stiffness);
            if !(low < next && next < high) {
                next = 0.5 * (low + high);
            }
            if (next - t).abs() <= 1e-15 * high || seen.load.abs() <= 0.0 {
                break;
            }
            t = next;
        }
        Some(t)
    }

    /// Force with the edge at the spring touched at the time `touched`.
    fn held(&self, place: &Kinematics<'_>, touched: f64) -> BedResponse {
        let (spectrum, profile) = (&self.model.spectrum, &self.model.profile);
        let Some(piece) = at(self.loading, touched) else { return BedResponse::default() };
        let theta = piece.part(touched);
        let edge = self.load(place, touched);
        let radius = profile.edge(edge.height).unwrap_or(0.0);
        let mut force = 2.0 * (spectrum.equilibrium() * profile.load_integral(radius) + radius * edge.load);
        for (k, term) in spectrum.terms().iter().enumerate() {
            let fading = Fading::new(piece.span / term.time, theta);
            let kept = (-(place.time - touched) / term.time).exp();
            force += kept * piece.sum_of(&fading, term.modulus, k);
        }
        BedResponse { force, radius, touched, joined: true }
    }
}

/// When the spring at the distance `x` from the axis was touched, and the height g above it.
pub fn touch_of(model: &StruckHalfSpace, loading: &[MotionPiece], x: f64) -> (f64, f64) {
    let height = model.profile.reduced(x);
    let number = loading.partition_point(|piece| piece.depth(1.0) < height).min(loading.len().saturating_sub(1));
    let Some(piece) = loading.get(number).filter(|_| height > 0.0) else { return (0.0, height) };
    let theta = root::within(|theta| piece.depth(theta) - height, 0.0, 1.0);
    (piece.start.time + theta * piece.span, height)
}
