//! Coulomb friction in a run, by the memory of turning points.

use super::{Step, TangentialContact};
use crate::friction::state::Tangential;
use crate::friction::{Grip, Pose, TangentialMemory};
use crate::run::contact::{ContactError, NormalContact};
use crate::shape::Profile;
use std::sync::Arc;

/// Stick and slip under Coulomb friction, exact for any history of depth and slide.
#[derive(Debug)]
pub struct Sticking {
    memory: TangentialMemory,
    accuracy: f64,
    kept: Option<Vec<Pose>>,
}

impl Sticking {
    /// Bodies that just touch; curved steps are followed to `accuracy`, and kept if there is room.
    #[must_use]
    pub fn new((profile, grip): (Arc<dyn Profile>, Grip), accuracy: f64, kept: Option<Vec<Pose>>) -> Self {
        Self { memory: TangentialMemory::new(profile, grip), accuracy, kept }
    }
}

impl TangentialContact for Sticking {
    fn advance(&mut self, step: &Step<'_>) -> Result<Option<Tangential>, ContactError> {
        for to in step.positions(self.memory.position(), self.accuracy) {
            self.memory.advance(to)?;
            self.kept.iter_mut().for_each(|path| path.push(to));
        }
        Ok(None)
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

    fn stress(&self, _contact: &dyn NormalContact, radii: &[f64]) -> Vec<Option<f64>> {
        self.memory.shear_stress(radii).into_iter().map(|stress| Some(stress).filter(|tau| tau.is_finite())).collect()
    }

    fn path(&self) -> &[Pose] {
        self.kept.as_deref().unwrap_or(&[])
    }
}
