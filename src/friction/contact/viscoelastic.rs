//! Coulomb friction of viscoelastic bodies: a bed beside the normal contact.

use super::{Step, TangentialContact};
use crate::contact::model::{Effort, Loading};
use crate::contact::state::Tangential;
use crate::contact::viscoelastic::Spectrum;
use crate::friction::{FrictionError, Grip, ViscoelasticBed};
use crate::shape::Profile;
use std::num::NonZeroUsize;
use std::sync::Arc;

/// A bed of viscoelastic springs with friction, driven along the depth of the normal contact.
///
/// Exact in time for depth and slide that are straight in each step. What springs lose by slip is not told apart
/// from what they lose by relaxing, so that no energy is given.
#[derive(Debug, Clone)]
pub struct ViscoelasticFriction {
    bed: ViscoelasticBed,
    /// Shortest time in which nothing relaxes [s], for a jump of the depth.
    instant: f64,
    tangential_modulus: f64,
    width: f64,
    slide: f64,
}

impl ViscoelasticFriction {
    /// A bed of `springs` springs out to `radius` [m], never touched.
    ///
    /// # Errors
    /// The profile ends before the bed.
    pub fn new(
        profile: &dyn Profile,
        spectrum: Arc<Spectrum>,
        grip: Grip,
        (springs, radius): (NonZeroUsize, f64),
    ) -> Result<Self, FrictionError> {
        let instant = spectrum.instant();
        let bed = ViscoelasticBed::new(profile, spectrum, grip, springs, radius)?;
        let width = radius / springs.get() as f64;
        Ok(Self { bed, instant, tangential_modulus: grip.tangential_modulus, width, slide: 0.0 })
    }
}

impl TangentialContact for ViscoelasticFriction {
    fn follow(&mut self, step: &Step<'_>) -> Result<Option<Tangential>, FrictionError> {
        let depth = step.prescribed[1];
        let (down, way) = (depth - self.bed.depth(), step.slide[1] - self.slide);
        self.slide = step.slide[1];
        let over = if step.over > 0.0 { step.over } else { self.instant };
        if step.over > 0.0 || down.abs() > 0.0 || way.abs() > 0.0 {
            self.bed.advance((down / over, way / over), over);
        }
        Ok(None)
    }

    fn state(&self) -> Tangential {
        let stick_radius = self.bed.held().1 as f64 * self.width;
        Tangential {
            slide: self.slide,
            force: self.bed.forces().1,
            stick_radius,
            stiffness: 2.0 * self.tangential_modulus * stick_radius,
            stored: None,
            dissipated: None,
            area_ratio: None,
        }
    }

    fn stress(&self, _loading: &dyn Loading, radii: &[f64]) -> Vec<Option<f64>> {
        vec![None; radii.len()]
    }

    fn copy(&self) -> Box<dyn TangentialContact> {
        Box::new(self.clone())
    }

    fn effort(&self) -> Effort {
        Effort { bytes: self.bed.bytes(), springs: self.bed.springs(), force_error: None }
    }
}
