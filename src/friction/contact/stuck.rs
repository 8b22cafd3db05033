//! An adhesive contact that sticks everywhere until shear peels it.

use super::held::{HeldShear, ShearedEdge};
use super::{Step, Sudden, TangentialContact};
use crate::contact::adhesion::equilibrium::Control;
use crate::contact::error::FrictionError;
use crate::contact::model::Loading;
use crate::contact::state::{Normal, Tangential};
use crate::friction::peeling::{Sheared, ShearedAdhesion};
use std::f64::consts::PI;

/// An adhesive contact that sticks everywhere (Savkoor & Briggs 1977).
///
/// It is in equilibrium at each displacement u_x: the edge peels by the energy of both loads, and where no radius carries it
/// any more all of it gives way at once: what the bodies have stored beyond the contact without adhesion is lost, and that
/// contact slides freely from there on. Forth and back before that the same states are passed.
#[derive(Debug, Clone)]
pub struct StuckEdge {
    edge: ShearedEdge<HeldFast>,
}

/// How a contact that sticks is sheared.
#[derive(Debug, Clone, Copy)]
struct HeldFast {
    /// Displacement at which nothing was sheared [m].
    origin: f64,
    /// Whether the edge has given way.
    gone: bool,
}

impl StuckEdge {
    /// Bodies that just touch.
    #[must_use]
    pub fn new(contact: ShearedAdhesion) -> Self {
        Self { edge: ShearedEdge::new(contact) }
    }

    /// What a slide begins from.
    fn outset(&self, step: &Step<'_>) -> HeldShear<HeldFast> {
        let normal = step.contact.state();
        let under = self.edge.prescribed(step.control, &normal);
        if let Some(present) = self.edge.present {
            return HeldShear { under, ..present };
        }
        let rest = normal.contact_radius.unwrap_or(0.0);
        let state = self.edge.contact.at_radius(rest, under, 0.0);
        HeldShear { state, under, rest, rule: HeldFast { origin: step.slide[0], gone: false } }
    }

    /// Energy stored in a state [J], with what a prescribed force has left to do.
    fn potential(&self, held: &HeldShear<HeldFast>, state: &Sheared) -> f64 {
        let line = &self.edge.contact.line;
        let stored = line.energy(state.contact_radius, state.indentation).stored();
        let load = match held.under.control {
            Control::Indentation => 0.0,
            Control::Force => held.under.value * state.indentation,
        };
        stored + 0.5 * state.tangential_force * state.slide - load
    }

    /// The contact as it would be held, with the far end of the slide at `slide` [m], on the contact `normal` without shear.
    fn with(&self, held: HeldShear<HeldFast>, normal: Normal, slide: f64) -> Sudden {
        let mut with = self.clone();
        with.hold(held, slide);
        Sudden { normal: Some(with.sheared(normal)), tangential: with.state() }
    }

    fn hold(&mut self, held: HeldShear<HeldFast>, slide: f64) {
        self.edge.hold(held, if held.rule.gone { 0.0 } else { held.state.contact_radius });
        self.edge.moved_to(slide);
    }

    /// The contact without adhesion that is left where the edge gives way in the state `last`.
    fn given_way(&mut self, held: HeldShear<HeldFast>, last: &Sheared) -> Result<HeldShear<HeldFast>, FrictionError> {
        let plain = self.edge.contact.without_edge(held.under)?;
        self.edge.dissipated += self.potential(&held, last) - self.potential(&held, &plain);
        Ok(HeldShear { state: plain, rule: HeldFast { gone: true, ..held.rule }, ..held })
    }
}

impl TangentialContact for StuckEdge {
    fn follow(&mut self, step: &Step<'_>) -> Result<Vec<Sudden>, FrictionError> {
        if self.edge.way(step).is_none() {
            return Ok(Vec::new());
        }
        let mut held = self.outset(step);
        let mut sudden = Vec::new();
        if !held.rule.gone {
            let (slide, contact) = (step.slide[1] - held.rule.origin, &self.edge.contact);
            let last = contact.last_stuck(held.under, held.rest);
            held = if slide.abs() > last.slide {
                let (normal, way) = (step.contact.state(), slide.signum() * last.slide);
                let end = held.rule.origin + way;
                let last = contact.at_radius(last.contact_radius, held.under, way);
                sudden.push(self.with(HeldShear { state: last, ..held }, normal, end));
                let gone = self.given_way(held, &last)?;
                sudden.push(self.with(gone, normal, end));
                gone
            } else {
                HeldShear { state: contact.stuck(held.under, (last, held.rest), slide), ..held }
            };
        }
        self.hold(held, step.slide[1]);
        Ok(sudden)
    }

    fn let_go(&mut self) {
        self.edge.present = None;
    }

    fn state(&self) -> Tangential {
        let stiffness = |held: &HeldShear<HeldFast>| match held.rule.gone {
            true => 0.0,
            false => self.edge.contact.tangential_stiffness(held.state.contact_radius),
        };
        self.edge.state(|held| (1.0, stiffness(held)))
    }

    fn sheared(&self, normal: Normal) -> Normal {
        self.edge.sheared(normal)
    }

    fn loading(&self) -> Option<Box<dyn Loading + '_>> {
        self.edge.loading()
    }

    /// F_x/(2πa√(a² − r²)), of one displacement all over the contact.
    fn stress(&self, _loading: &dyn Loading, radii: &[f64]) -> Vec<Option<f64>> {
        let Some(HeldShear { state, .. }) = self.edge.present else { return vec![Some(0.0); radii.len()] };
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
