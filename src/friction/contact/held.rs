//! An adhesive contact held in shear, whatever holds it.

use super::Step;
use crate::contact::adhesion::equilibrium::Control;
use crate::contact::loaded::Loaded;
use crate::contact::model::Loading;
use crate::contact::state::{Normal, Tangential};
use crate::friction::peeling::{Prescribed, Sheared, ShearedAdhesion};

/// A sheared state, what is prescribed in it, and what else the rule that came to it knows.
#[derive(Debug, Clone, Copy)]
pub(super) struct HeldShear<Rule> {
    pub(super) state: Sheared,
    pub(super) under: Prescribed,
    /// Radius of the contact without shear [m].
    pub(super) rest: f64,
    pub(super) rule: Rule,
}

/// An adhesive contact that shear may hold, smaller than without it.
///
/// As soon as the normal contact moves again it is let go: the tangential force is gone and the edge closes.
#[derive(Debug, Clone)]
pub(super) struct ShearedEdge<Rule> {
    pub(super) contact: ShearedAdhesion,
    pub(super) present: Option<HeldShear<Rule>>,
    slide: f64,
    stick_radius: f64,
    /// What was lost so far [J].
    pub(super) dissipated: f64,
}

impl<Rule: Copy> ShearedEdge<Rule> {
    /// Bodies that just touch.
    pub(super) fn new(contact: ShearedAdhesion) -> Self {
        Self { contact, present: None, slide: 0.0, stick_radius: 0.0, dissipated: 0.0 }
    }

    /// The way [m] of a step along the surface; `None` where nothing is sheared on it, which is then all of the step.
    pub(super) fn way(&mut self, step: &Step<'_>) -> Option<f64> {
        let way = step.slide[1] - step.slide[0];
        if way.abs() > 0.0 && step.contact.joined() {
            return Some(way);
        }
        self.slide = step.slide[1];
        self.stick_radius = self.sheared(step.contact.state()).contact_radius.unwrap_or(0.0);
        None
    }

    /// What is prescribed in a step: at its sheared value where the contact is sheared.
    pub(super) fn prescribed(&self, control: Control, normal: &Normal) -> Prescribed {
        let value = match (&self.present, control) {
            (Some(present), control) if present.under.control == control => present.under.value,
            (Some(present), Control::Indentation) => present.state.indentation,
            (Some(present), Control::Force) => self.contact.force_of(&present.state),
            (None, Control::Indentation) => normal.indentation.unwrap_or(0.0),
            (None, Control::Force) => normal.force,
        };
        Prescribed { control, value }
    }

    /// Holds a state that a step has come to, stuck within `stick_radius` [m].
    pub(super) fn hold(&mut self, present: HeldShear<Rule>, stick_radius: f64) {
        (self.present, self.stick_radius) = (Some(present), stick_radius);
    }

    /// Where the far end of the slide is now [m].
    pub(super) fn moved_to(&mut self, slide: f64) {
        self.slide = slide;
    }

    /// The tangential contact; `told` says side and stiffness of the force of a state.
    pub(super) fn state(&self, told: impl Fn(&HeldShear<Rule>) -> (f64, f64)) -> Tangential {
        let (slide, stick_radius, dissipated) = (self.slide, self.stick_radius, Some(self.dissipated));
        let at_rest = Tangential { slide, stick_radius, dissipated, stored: Some(0.0), ..Tangential::default() };
        let Some(held) = &self.present else { return at_rest };
        let (state, (side, stiffness)) = (held.state, told(held));
        Tangential {
            force: side * state.tangential_force,
            stiffness,
            stored: Some(0.5 * state.tangential_force * state.slide),
            area_ratio: Some((state.contact_radius / held.rest).powi(2)),
            ..at_rest
        }
    }

    /// The normal contact as the shear has left it.
    pub(super) fn sheared(&self, normal: Normal) -> Normal {
        let Some(HeldShear { state, .. }) = &self.present else { return normal };
        let (a, line) = (state.contact_radius, &self.contact.line);
        Normal {
            indentation: Some(state.indentation),
            force: self.contact.force_of(state),
            contact_radius: Some(a),
            stiffness: 2.0 * line.ground().modulus() * a,
            stored: line.energy(a, state.indentation),
            ..normal
        }
    }

    /// The load of the normal contact as the shear has left it.
    pub(super) fn loading(&self) -> Option<Box<dyn Loading + '_>> {
        let state = self.present.as_ref()?.state;
        if state.contact_radius <= 0.0 {
            return None;
        }
        let ground = self.contact.line.ground();
        let edge = state.indentation - ground.profile().reduced(state.contact_radius);
        // Where no adhesion is left the edge is that of the plain contact, to rounding.
        let edge_load = if edge < 0.0 { ground.modulus() * edge } else { 0.0 };
        Some(Box::new(Loaded::elastic(ground.clone(), state.contact_radius, edge_load)))
    }
}
