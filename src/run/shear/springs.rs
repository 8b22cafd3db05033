//! Coulomb friction in a run, by the plain bed of springs.

use super::{Step, TangentialContact};
use crate::friction::state::Tangential;
use crate::friction::{CoulombBed, FrettingMap, FrictionError, Grip, Pose};
use crate::run::contact::{ContactError, NormalContact};
use crate::shape::Profile;
use std::num::NonZeroUsize;

/// The bed of Coulomb springs with the energy each of them loses: the twin of the memory.
#[derive(Debug)]
pub struct Springs {
    bed: CoulombBed,
    map: FrettingMap,
    grip: Grip,
    width: f64,
    accuracy: f64,
    at: Pose,
    force: f64,
}

impl Springs {
    /// A bed of `springs` springs out to `radius` [m], bodies just touching.
    ///
    /// # Errors
    /// The profile ends before `radius`.
    #[expect(clippy::cast_precision_loss, reason = "no bed has 2^53 springs")]
    pub fn new(
        (profile, grip): (&dyn Profile, Grip),
        (springs, radius): (NonZeroUsize, f64),
        accuracy: f64,
    ) -> Result<Self, FrictionError> {
        let width = radius / springs.get() as f64;
        let places: Vec<f64> = (0..springs.get()).map(|k| (k as f64 + 0.5) * width).collect();
        let bed = CoulombBed::new(profile, grip, springs, radius)?;
        let map = FrettingMap::new(profile, grip, &places);
        Ok(Self { bed, map, grip, width, accuracy, at: Pose::default(), force: 0.0 })
    }

    /// Number of springs in contact, and of those of them inside the first one that slips.
    fn held(&self) -> (usize, usize) {
        let reach = self.grip.reach();
        let limits = self.bed.depths().iter().map(|depth| reach * (self.at.indentation - depth));
        let limits: Vec<f64> = limits.take_while(|limit| *limit > 0.0).collect();
        // A spring at its limit has been put there, to rounding of the slide.
        let slips = |(v, limit): (f64, &f64)| v.abs() >= (1.0 - 1e-9) * limit;
        let stuck = self.bed.displacements().into_iter().zip(&limits).position(slips);
        (limits.len(), stuck.unwrap_or(limits.len()))
    }
}

impl TangentialContact for Springs {
    fn advance(&mut self, step: &Step<'_>) -> Result<Option<Tangential>, ContactError> {
        let path = step.positions(self.at, self.accuracy);
        for &to in &path {
            self.map.advance(to);
        }
        self.force = self.bed.advance(&path).last().copied().unwrap_or(self.force);
        self.at = path.last().copied().unwrap_or(self.at);
        Ok(None)
    }

    #[expect(clippy::cast_precision_loss, reason = "no bed has 2^53 springs")]
    fn state(&self) -> Tangential {
        let stick_radius = self.held().1 as f64 * self.width;
        let squares: f64 = self.bed.displacements().iter().map(|v| v * v).sum();
        Tangential {
            slide: self.at.slide,
            force: self.force,
            stick_radius,
            stiffness: 2.0 * self.grip.tangential_modulus * stick_radius,
            stored: Some(self.grip.tangential_modulus * self.width * squares),
            dissipated: Some(self.width * self.map.energy().iter().sum::<f64>()),
            area_ratio: None,
        }
    }

    fn stress(&self, _contact: &dyn NormalContact, radii: &[f64]) -> Vec<Option<f64>> {
        vec![None; radii.len()]
    }
}
