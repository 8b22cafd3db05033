//! Gross sliding under laws that act on the pressure.

use super::{Step, Sudden, TangentialContact};
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

/// A round contact that slips everywhere at once, or stands. Valid without adhesion.
#[derive(Clone)]
pub struct SlidingContact {
    ground: Foundation,
    slip: GrossSlip,
}

/// What slips everywhere at once, or stands.
///
/// While it slides, F_x = ∫τ(p) dA against the sliding. While it stands it keeps the tangential
/// force it was left with, as far as the present load can hold it. Elastic tangential displacements are
/// left out. Valid without adhesion.
#[derive(Clone)]
pub struct GrossSlip {
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

impl GrossSlip {
    /// Bodies that just touch.
    #[must_use]
    pub fn new(interface: Interface) -> Self {
        let state = Tangential { stored: Some(0.0), dissipated: Some(0.0), ..Tangential::default() };
        Self { interface, law: None, state, limit: 0.0 }
    }

    /// Slides from one tangential displacement [m] to another at the speed `speed` [m/s], or stands, on a contact of the
    /// radius `radius` [m] whose friction `limit` \[N\] tells of a law; returns the state in which it sets off.
    ///
    /// # Errors
    /// The speed lies outside the table.
    pub fn follow(
        &mut self,
        (slide, speed): ([f64; 2], f64),
        radius: f64,
        limit: impl Fn(&dyn SlidingLaw) -> f64,
    ) -> Result<Option<Tangential>, FrictionError> {
        let way = slide[1] - slide[0];
        if way.abs() <= 0.0 {
            self.limit = self.law.as_ref().map_or(0.0, |law| limit(law.as_ref()));
            self.state.force = self.state.force.clamp(-self.limit, self.limit);
            self.state.stick_radius = radius;
            return Ok(None);
        }
        let before = self.state.force;
        let law = self.interface.law(speed)?;
        self.limit = limit(law.as_ref());
        self.law = Some(law.into());
        self.state = Tangential { force: way.signum() * self.limit, stick_radius: 0.0, ..self.state };
        let begins = (before - self.state.force).abs() > 0.0;
        let onset = begins.then_some(self.state);
        self.state.slide = slide[1];
        *self.state.dissipated.get_or_insert(0.0) += self.limit * way.abs();
        Ok(onset)
    }

    /// Present state.
    #[must_use]
    pub fn state(&self) -> Tangential {
        self.state
    }

    /// Shear stress [Pa] under the pressure `pressure` [Pa] inside the contact; `None` where the pressure is, and of a contact
    /// that has been let go below its limit, for it has slipped somewhere, and how much is not known.
    #[must_use]
    pub fn stress(&self, pressure: Option<f64>) -> Option<f64> {
        match &self.law {
            Some(law) if self.state.force.abs() >= self.limit => {
                Some(self.state.force.signum() * law.stress(pressure?))
            }
            Some(_) => None,
            None => Some(0.0),
        }
    }
}

impl SlidingContact {
    /// Bodies that just touch.
    #[must_use]
    pub fn new(ground: Foundation, interface: Interface) -> Self {
        Self { ground, slip: GrossSlip::new(interface) }
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
}

impl TangentialContact for SlidingContact {
    fn follow(&mut self, step: &Step<'_>) -> Result<Vec<Sudden>, FrictionError> {
        let normal = step.contact.state();
        let mut slip = self.slip.clone();
        let radius = normal.contact_radius.unwrap_or(0.0);
        let onset = slip.follow((step.slide, step.speed.abs()), radius, |law| self.limit_of(law, &normal))?;
        self.slip = slip;
        Ok(onset.into_iter().map(Sudden::from).collect())
    }

    fn state(&self) -> Tangential {
        self.slip.state()
    }

    fn stress(&self, loading: &dyn Loading, radii: &[f64]) -> Vec<Option<f64>> {
        let a = loading.contact_radius();
        let stress = |&r: &f64| if r > a { Some(0.0) } else { self.slip.stress(loading.pressure(r)) };
        radii.iter().map(stress).collect()
    }

    fn copy(&self) -> Box<dyn TangentialContact> {
        Box::new(self.clone())
    }
}
