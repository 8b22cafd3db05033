//! Coulomb friction of viscoelastic bodies: a bed beside the normal contact.

use super::{Step, TangentialContact};
use crate::contact::model::Effort;
use crate::contact::state::Tangential;
use crate::friction::{FrictionError, ViscoelasticBed};

/// A bed of viscoelastic springs with friction, driven along the depth of the normal contact.
///
/// Exact in time for depth and slide that are straight in each step. What springs lose by slip is told apart from what
/// they lose by relaxing; what they store is not.
#[derive(Debug, Clone)]
pub struct ViscoelasticFriction {
    bed: ViscoelasticBed,
    tangential_modulus: f64,
    slide: f64,
}

impl ViscoelasticFriction {
    /// The bed `bed`, never touched, of bodies with the instantaneous tangential modulus `tangential_modulus` G* [Pa].
    #[must_use]
    pub fn new(bed: ViscoelasticBed, tangential_modulus: f64) -> Self {
        Self { bed, tangential_modulus, slide: 0.0 }
    }
}

impl TangentialContact for ViscoelasticFriction {
    fn follow(&mut self, step: &Step<'_>) -> Result<Option<Tangential>, FrictionError> {
        let depth = step.prescribed[1];
        let (down, way) = (depth - self.bed.depth(), step.slide[1] - self.slide);
        self.slide = step.slide[1];
        let over = if step.over > 0.0 { step.over } else { self.bed.instant() };
        if step.over > 0.0 || down.abs() > 0.0 || way.abs() > 0.0 {
            self.bed.advance((down / over, way / over), over);
        }
        Ok(None)
    }

    fn state(&self) -> Tangential {
        let stick_radius = self.bed.stick_radius();
        Tangential {
            slide: self.slide,
            force: self.bed.forces().1,
            stick_radius,
            stiffness: 2.0 * self.tangential_modulus * stick_radius,
            stored: None,
            dissipated: Some(self.bed.dissipated()),
            area_ratio: None,
        }
    }

    fn copy(&self) -> Box<dyn TangentialContact> {
        Box::new(self.clone())
    }

    fn effort(&self) -> Effort {
        Effort { bytes: self.bed.bytes(), springs: self.bed.springs(), force_error: None }
    }
}
