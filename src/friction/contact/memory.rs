//! Coulomb friction by the memory of turning points.

use super::{Step, Sudden, TangentialContact};
use crate::contact::model::{Effort, Loading, Pose};
use crate::contact::state::Tangential;
use crate::friction::{FrictionError, Grip, TangentialMemory};
use crate::shape::Profile;
use std::sync::Arc;

/// Stick and slip under Coulomb friction, exact for any history of depth and slide.
#[derive(Debug, Clone)]
pub struct CoulombMemory {
    memory: TangentialMemory,
    accuracy: f64,
    kept: Option<Vec<Pose>>,
}

impl CoulombMemory {
    /// Bodies that just touch; curved steps are followed to `accuracy`.
    #[must_use]
    pub fn new(profile: Arc<dyn Profile>, grip: Grip, accuracy: f64) -> Self {
        Self { memory: TangentialMemory::new(profile, grip), accuracy, kept: None }
    }

    /// The same, which keeps the straight steps it takes.
    #[must_use]
    pub fn keeping_its_path(self) -> Self {
        Self { kept: Some(Vec::new()), ..self }
    }
}

impl TangentialContact for CoulombMemory {
    fn follow(&mut self, step: &Step<'_>) -> Result<Vec<Sudden>, FrictionError> {
        for to in step.positions(self.memory.position(), self.accuracy) {
            self.memory.advance(to)?;
            self.kept.iter_mut().for_each(|path| path.push(to));
        }
        Ok(Vec::new())
    }

    fn state(&self) -> Tangential {
        let state = self.memory.state();
        Tangential {
            slide: self.memory.position().slide,
            force: state.tangential_force,
            stick_radius: state.stick_radius,
            stiffness: state.stiffness,
            stored: Some(self.memory.stored()),
            dissipated: Some(state.dissipated),
            area_ratio: None,
        }
    }

    fn stress(&self, _loading: &dyn Loading, radii: &[f64]) -> Vec<Option<f64>> {
        self.memory.shear_stress(radii).into_iter().map(|stress| Some(stress).filter(|tau| tau.is_finite())).collect()
    }

    fn copy(&self) -> Box<dyn TangentialContact> {
        Box::new(self.clone())
    }

    fn effort(&self) -> Effort {
        let bytes = size_of::<Self>() + self.memory.turning_points() * TangentialMemory::BYTES_PER_TURN;
        Effort { bytes, ..Effort::default() }
    }

    fn path(&self) -> &[Pose] {
        self.kept.as_deref().unwrap_or(&[])
    }
}
