//! Gross sliding under laws that act on the pressure.

use super::{Step, TangentialContact};
use crate::contact::error::OutsideTable;
use crate::contact::foundation::Foundation;
use crate::contact::loaded::Loaded;
use crate::contact::model::Loading;
use crate::contact::state::{Normal, Tangential};
use crate::friction::sliding::{SlidingLaw, sliding_force};
use crate::friction::strength::StrengthCurve;
use crate::friction::{Friction, FrictionError};
use crate::shape::Rim;
use std::sync::Arc;

/// A contact that slips everywhere at once, or stands.
///
/// While it slides, F_x = 2π∫τ(p) r dr against the sliding. While it stands it keeps the tangential
/// force it was left with, as far as the present load can hold it. Elastic tangential displacements are
/// left out. Valid without adhesion.
#[derive(Clone)]
pub struct SlidingContact {
    ground: Foundation,
    interface: Interface,
    law: Option<Arc<dyn SlidingLaw>>,
    state: Tangential,
    /// Largest tangential force the present load can hold [N].
    limit: f64,
}

/// A friction that slips as a whole, with its table read.
#[derive(Debug, Clone, PartialEq)]
pub struct Interface {
    /// The law.
    pub friction: Friction,
    /// Shear strength over the sliding speed, if the law names a table.
    pub strength: Option<Arc<StrengthCurve>>,
}

impl Interface {
    /// The law at the sliding speed `speed` [m/s].
    ///
    /// # Errors
    /// The speed lies outside the table.
    pub fn law(&self, speed: f64) -> Result<Box<dyn SlidingLaw>, OutsideTable> {
        self.friction.law(speed, self.strength.as_deref())
    }
}

impl SlidingContact {
    /// Bodies that just touch.
    #[must_use]
    pub fn new(ground: Foundation, interface: Interface) -> Self {
        let state = Tangential { stored: Some(0.0), dissipated: Some(0.0), ..Tangential::default() };
        Self { ground, interface, law: None, state, limit: 0.0 }
    }

    /// Friction force [N] of the whole contact; only a wall carries a load at the edge.
    fn limit_of(&self, law: &dyn SlidingLaw, normal: &Normal) -> f64 {
        let Some(a) = normal.contact_radius.filter(|&a| a > 0.0) else { return 0.0 };
        let profile = self.ground.profile();
        let edge_load = match (profile.rim(), normal.indentation) {
            (Rim::Wall(end), Some(depth)) if a >= end => self.ground.modulus() * (depth - profile.reduced(a)),
            _ => 0.0,
        };
        sliding_force(&Loaded::elastic(self.ground.clone(), a, edge_load), law)
    }

    /// Slides on from the slide it has to `to` [m].
    fn slide(&mut self, to: f64, step: &Step<'_>) -> Result<(), FrictionError> {
        let law = self.interface.law(step.speed)?;
        self.limit = self.limit_of(law.as_ref(), &step.contact.state());
        self.law = Some(law.into());
        self.state.force = (to - self.state.slide).signum() * self.limit;
        self.state.stick_radius = 0.0;
        Ok(())
    }

    /// Stands while the load changes.
    fn stand(&mut self, step: &Step<'_>) {
        let normal = step.contact.state();
        self.limit = self.law.as_ref().map_or(0.0, |law| self.limit_of(law.as_ref(), &normal));
        self.state.force = self.state.force.clamp(-self.limit, self.limit);
        self.state.stick_radius = normal.contact_radius.unwrap_or(0.0);
    }
}

impl TangentialContact for SlidingContact {
    fn follow(&mut self, step: &Step<'_>) -> Result<Option<Tangential>, FrictionError> {
        let way = step.slide[1] - step.slide[0];
        if way.abs() <= 0.0 {
            self.stand(step);
            return Ok(None);
        }
        let before = self.state.force;
        self.slide(step.slide[1], step)?;
        let begins = (before - self.state.force).abs() > 0.0;
        let onset = begins.then_some(self.state);
        self.state.slide = step.slide[1];
        *self.state.dissipated.get_or_insert(0.0) += self.limit * way.abs();
        Ok(onset)
    }

    fn state(&self) -> Tangential {
        self.state
    }

    fn stress(&self, loading: &dyn Loading, radii: &[f64]) -> Vec<Option<f64>> {
        // A contact that has been let go below its limit has slipped somewhere; how much is not known.
        let at_limit = self.state.force.abs() >= self.limit;
        let a = loading.contact_radius();
        let stress = |&r: &f64| match &self.law {
            _ if r > a => Some(0.0),
            Some(law) if at_limit => Some(self.state.force.signum() * law.stress(loading.pressure(r)?)),
            Some(_) => None,
            None => Some(0.0),
        };
        radii.iter().map(stress).collect()
    }

    fn copy(&self) -> Box<dyn TangentialContact> {
        Box::new(self.clone())
    }
}
