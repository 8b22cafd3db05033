//! An adhesive contact that sticks everywhere until shear peels it.

use super::peeling::{loaded, sheared};
use super::{Step, TangentialContact};
use crate::contact::adhesion::equilibrium::Control;
use crate::contact::error::FrictionError;
use crate::contact::model::Loading;
use crate::contact::state::{Normal, Tangential};
use crate::friction::peeling::{Prescribed, Sheared, ShearedAdhesion};
use std::f64::consts::PI;

/// An adhesive contact that sticks everywhere (Savkoor & Briggs 1977).
///
/// It is in equilibrium at each displacement u_x: the edge peels by the energy of both loads, and where no radius carries it
/// any more all of it gives way at once: what the bodies have stored beyond the contact without adhesion is lost, and that
/// contact slides freely from there on. Forth and back before that the same states are passed.
#[derive(Debug, Clone)]
pub struct StuckEdge {
    contact: ShearedAdhesion,
    present: Option<HeldFast>,
    slide: f64,
    stick_radius: f64,
    dissipated: f64,
}

/// A state that a slide has come to, and what is prescribed in it.
#[derive(Debug, Clone, Copy)]
struct HeldFast {
    state: Sheared,
    under: Prescribed,
    /// Radius of the contact without shear [m].
    rest: f64,
    /// Displacement at which nothing was sheared [m].
    origin: f64,
    /// Whether the edge has given way.
    gone: bool,
}

impl StuckEdge {
    /// Bodies that just touch.
    #[must_use]
    pub fn new(contact: ShearedAdhesion) -> Self {
        Self { contact, present: None, slide: 0.0, stick_radius: 0.0, dissipated: 0.0 }
    }

    /// What a slide begins from.
    fn outset(&self, step: &Step<'_>) -> HeldFast {
        let normal = step.contact.state();
        let value = match (&self.present, step.control) {
            (Some(present), control) if present.under.control == control => return *present,
            (Some(present), Control::Indentation) => present.state.indentation,
            (Some(present), Control::Force) => self.contact.force_of(&present.state),
            (None, Control::Indentation) => normal.indentation.unwrap_or(0.0),
            (None, Control::Force) => normal.force,
        };
        let under = Prescribed { control: step.control, value };
        if let Some(present) = self.present {
            return HeldFast { under, ..present };
        }
        let rest = normal.contact_radius.unwrap_or(0.0);
        let state = self.contact.at_radius(rest, under, 0.0);
        HeldFast { state, under, rest, origin: step.slide[0], gone: false }
    }

    /// Energy stored in a state [J], with what a prescribed force has left to do.
    fn potential(&self, held: &HeldFast, state: &Sheared) -> f64 {
        let line = &self.contact.line;
        let stored = line.energy(state.contact_radius, state.indentation).stored();
        let load = match held.under.control {
            Control::Indentation => 0.0,
            Control::Force => held.under.value * state.indentation,
        };
        stored + 0.5 * state.tangential_force * state.slide - load
    }

    /// The contact without adhesion that is left where the edge gives way in the state `last`.
    fn given_way(&mut self, held: HeldFast, last: &Sheared) -> Result<HeldFast, FrictionError> {
        let plain = self.contact.without_edge(held.under)?;
        self.dissipated += self.potential(&held, last) - self.potential(&held, &plain);
        Ok(HeldFast { state: plain, gone: true, ..held })
    }
}

impl TangentialContact for StuckEdge {
    fn follow(&mut self, step: &Step<'_>) -> Result<Option<Tangential>, FrictionError> {
        let way = step.slide[1] - step.slide[0];
        if way.abs() <= 0.0 || !step.contact.joined() {
            self.slide = step.slide[1];
            self.stick_radius = self.sheared(step.contact.state()).contact_radius.unwrap_or(0.0);
            return Ok(None);
        }
        let mut held = self.outset(step);
        if !held.gone {
            let slide = step.slide[1] - held.origin;
            let last = self.contact.last_stuck(held.under, held.rest);
            held = if slide.abs() > last.slide {
                self.given_way(held, &last)?
            } else {
                HeldFast { state: self.contact.stuck(held.under, (last, held.rest), slide), ..held }
            };
        }
        self.stick_radius = if held.gone { 0.0 } else { held.state.contact_radius };
        self.present = Some(held);
        self.slide = step.slide[1];
        Ok(None)
    }

    fn let_go(&mut self) {
        self.present = None;
    }

    fn state(&self) -> Tangential {
        let (slide, stick_radius, dissipated) = (self.slide, self.stick_radius, Some(self.dissipated));
        let at_rest = Tangential { slide, stick_radius, dissipated, stored: Some(0.0), ..Tangential::default() };
        let Some(HeldFast { state, rest, gone, .. }) = self.present else { return at_rest };
        Tangential {
            force: state.tangential_force,
            stiffness: if gone { 0.0 } else { self.contact.tangential_stiffness(state.contact_radius) },
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

    /// F_x/(2πa√(a² − r²)), of one displacement all over the contact.
    fn stress(&self, _loading: &dyn Loading, radii: &[f64]) -> Vec<Option<f64>> {
        let Some(HeldFast { state, .. }) = self.present else { return vec![Some(0.0); radii.len()] };
        let (a, force) = (state.contact_radius, state.tangential_force);
        let stress = |&r: &f64| match r {
            r if r < a => Some(force / (2.0 * PI * a * ((a - r) * (a + r)).sqrt())),
            r if r > a || force.abs() <= 0.0 => Some(0.0),
            _ => None,
        };
        radii.iter().map(stress).collect()
    }

    fn copy(&self) -> Box<dyn TangentialContact> {
        Box::new(self.clone())
    }
}
