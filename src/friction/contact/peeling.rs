//! Sliding of an adhesive contact: the shear stress peels its edge.

use super::held::{HeldShear, ShearedEdge};
use super::sliding::Interface;
use super::{Step, Sudden, TangentialContact};
use crate::contact::adhesion::equilibrium::Control;
use crate::contact::model::Loading;
use crate::contact::state::{Normal, Tangential};
use crate::friction::FrictionError;
use crate::friction::peeling::ShearedAdhesion;

/// An adhesive contact that slides under a uniform shear stress τ (Savkoor & Briggs 1977; Persson et
/// al. 2008, eqs. 5–14 with F_x = πa²τ).
///
/// While the bodies slide or stand sheared, the contact is smaller than without shear.
#[derive(Debug, Clone)]
pub struct Peeling {
    edge: ShearedEdge<Sliding>,
    interface: Interface,
}

/// How a sheared contact slides.
#[derive(Debug, Clone, Copy)]
struct Sliding {
    /// Shear stress against the sliding [Pa].
    stress: f64,
    side: f64,
}

impl Peeling {
    /// Bodies that just touch.
    #[must_use]
    pub fn new(contact: ShearedAdhesion, interface: Interface) -> Self {
        Self { edge: ShearedEdge::new(contact), interface }
    }

    /// The state sheared by the stress of the present speed.
    fn peeled(&self, step: &Step<'_>) -> Result<HeldShear<Sliding>, FrictionError> {
        let (normal, contact) = (step.contact.state(), &self.edge.contact);
        let (rest, under) = (normal.contact_radius.unwrap_or(0.0), self.edge.prescribed(step.control, &normal));
        let stress = self.interface.law(step.speed.abs())?.stress(0.0);
        let state = match under.control {
            Control::Indentation => contact.at_depth(under.value, stress, rest)?,
            Control::Force => contact.under_stress(under.value, stress)?,
        };
        let side = (step.slide[1] - step.slide[0]).signum();
        Ok(HeldShear { state, under, rest, rule: Sliding { stress, side } })
    }
}

impl TangentialContact for Peeling {
    fn follow(&mut self, step: &Step<'_>) -> Result<Vec<Sudden>, FrictionError> {
        let Some(way) = self.edge.way(step) else { return Ok(Vec::new()) };
        let before = self.state().force;
        let present = self.peeled(step)?;
        self.edge.hold(present, 0.0);
        let onset = self.state();
        self.edge.moved_to(step.slide[1]);
        self.edge.dissipated += present.state.tangential_force * way.abs();
        Ok(((onset.force - before).abs() > 0.0).then(|| onset.into()).into_iter().collect())
    }

    fn let_go(&mut self) {
        self.edge.present = None;
    }

    fn state(&self) -> Tangential {
        self.edge.state(|held| (held.rule.side, 0.0))
    }

    fn sheared(&self, normal: Normal) -> Normal {
        self.edge.sheared(normal)
    }

    fn loading(&self) -> Option<Box<dyn Loading + '_>> {
        self.edge.loading()
    }

    fn stress(&self, _loading: &dyn Loading, radii: &[f64]) -> Vec<Option<f64>> {
        let stress = |r: &f64| match &self.edge.present {
            Some(held) if *r <= held.state.contact_radius => held.rule.side * held.rule.stress,
            _ => 0.0,
        };
        radii.iter().map(|r| Some(stress(r))).collect()
    }

    fn copy(&self) -> Box<dyn TangentialContact> {
        Box::new(self.clone())
    }
}
