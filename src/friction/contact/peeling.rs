//! Sliding of an adhesive contact: the shear stress peels its edge.

use super::sliding::Interface;
use super::{Step, TangentialContact};
use crate::contact::adhesion::equilibrium::Control;
use crate::contact::loaded::Loaded;
use crate::contact::model::Loading;
use crate::contact::state::{Normal, Tangential};
use crate::friction::FrictionError;
use crate::friction::peeling::{Sheared, ShearedAdhesion};

/// An adhesive contact that slides under a uniform shear stress τ (Savkoor & Briggs 1977; Persson et
/// al. 2008, eqs. 5–14 with F_x = πa²τ).
///
/// While the bodies slide or stand sheared, the contact is smaller than without shear. As soon as the
/// normal contact moves again it is let go: the tangential force is gone and the edge closes.
#[derive(Debug, Clone)]
pub struct Peeling {
    contact: ShearedAdhesion,
    interface: Interface,
    present: Option<HeldShear>,
    slide: f64,
    stick_radius: f64,
    dissipated: f64,
}

/// A sheared state and what holds it.
#[derive(Debug, Clone, Copy)]
struct HeldShear {
    state: Sheared,
    /// Shear stress against the sliding [Pa].
    stress: f64,
    side: f64,
    under: Held,
    /// Radius of the contact without shear [m].
    rest: f64,
}

/// What is prescribed while a contact is sheared, and its value.
#[derive(Debug, Clone, Copy)]
struct Held {
    control: Control,
    value: f64,
}

impl Peeling {
    /// Bodies that just touch.
    #[must_use]
    pub fn new(contact: ShearedAdhesion, interface: Interface) -> Self {
        Self { contact, interface, present: None, slide: 0.0, stick_radius: 0.0, dissipated: 0.0 }
    }

    /// What holds the contact: what is prescribed, at its sheared value if it was sheared before.
    fn held(&self, control: Control, normal: &Normal) -> Held {
        let value = match (&self.present, control) {
            (Some(present), control) if present.under.control == control => present.under.value,
            (Some(present), Control::Indentation) => present.state.indentation,
            (None, Control::Indentation) => normal.indentation.unwrap_or(0.0),
            (_, Control::Force) => normal.force,
        };
        Held { control, value }
    }

    /// The state sheared by the stress of the present speed.
    fn peeled(&self, step: &Step<'_>) -> Result<HeldShear, FrictionError> {
        let normal = step.contact.state();
        let (rest, under) = (normal.contact_radius.unwrap_or(0.0), self.held(step.control, &normal));
        let stress = self.interface.law(step.speed)?.stress(0.0);
        let state = match under.control {
            Control::Indentation => self.contact.at_depth(under.value, stress, rest)?,
            Control::Force => self.contact.under_stress(under.value, stress)?,
        };
        let side = (step.slide[1] - step.slide[0]).signum();
        Ok(HeldShear { state, stress, side, under, rest })
    }
}

/// The normal contact in the sheared state `state`.
pub(super) fn sheared(contact: &ShearedAdhesion, state: &Sheared, normal: Normal) -> Normal {
    let (a, line) = (state.contact_radius, &contact.line);
    Normal {
        indentation: Some(state.indentation),
        force: contact.force_of(state),
        contact_radius: Some(a),
        stiffness: 2.0 * line.ground().modulus() * a,
        stored: line.energy(a, state.indentation),
        ..normal
    }
}

/// The load of the normal contact in the sheared state `state`.
pub(super) fn loaded(contact: &ShearedAdhesion, state: &Sheared) -> Loaded {
    let ground = contact.line.ground();
    let edge = state.indentation - ground.profile().reduced(state.contact_radius);
    // Where no adhesion is left the edge is that of the plain contact, to rounding.
    let edge_load = if edge < 0.0 { ground.modulus() * edge } else { 0.0 };
    Loaded::elastic(ground.clone(), state.contact_radius, edge_load)
}

impl TangentialContact for Peeling {
    fn follow(&mut self, step: &Step<'_>) -> Result<Option<Tangential>, FrictionError> {
        let way = step.slide[1] - step.slide[0];
        if way.abs() <= 0.0 || !step.contact.joined() {
            self.slide = step.slide[1];
            self.stick_radius = self.sheared(step.contact.state()).contact_radius.unwrap_or(0.0);
            return Ok(None);
        }
        let before = self.state().force;
        let present = self.peeled(step)?;
        self.present = Some(present);
        self.stick_radius = 0.0;
        let onset = self.state();
        self.slide = step.slide[1];
        self.dissipated += present.state.tangential_force * way.abs();
        Ok(((onset.force - before).abs() > 0.0).then_some(onset))
    }

    fn let_go(&mut self) {
        self.present = None;
    }

    fn state(&self) -> Tangential {
        let (slide, stick_radius, dissipated) = (self.slide, self.stick_radius, Some(self.dissipated));
        let at_rest = Tangential { slide, stick_radius, dissipated, stored: Some(0.0), ..Tangential::default() };
        let Some(HeldShear { state, side, rest, .. }) = self.present else { return at_rest };
        Tangential {
            force: side * state.tangential_force,
            stored: Some(0.5 * state.tangential_force * state.slide),
            area_ratio: Some((state.contact_radius / rest).powi(2)),
            ..at_rest
        }
    }

    fn sheared(&self, normal: Normal) -> Normal {
        self.present.map_or(normal, |present| sheared(&self.contact, &present.state, normal))
    }

    fn loading(&self) -> Option<Box<dyn Loading + '_>> {
        self.present.map(|present| Box::new(loaded(&self.contact, &present.state)) as Box<dyn Loading>)
    }

    fn stress(&self, _loading: &dyn Loading, radii: &[f64]) -> Vec<Option<f64>> {
        let stress = |r: &f64| match &self.present {
            Some(present) if *r <= present.state.contact_radius => present.side * present.stress,
            _ => 0.0,
        };
        radii.iter().map(|r| Some(stress(r))).collect()
    }

    fn copy(&self) -> Box<dyn TangentialContact> {
        Box::new(self.clone())
    }
}
