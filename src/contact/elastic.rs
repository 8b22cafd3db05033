//! The direct path and the classical bed as contacts that are driven.

use super::adhesion::equilibrium::{Balance, Control};
use super::adhesion::line::Energy;
use super::direct::{Jump, QuasiStatic};
use super::error::ContactError;
use super::model::{ContactModel, Effort, Event, Glance, Loading, Pull, Straight};
use super::springs::SpringBed;
use super::state::Normal;

/// The state of the direct path with the equilibrium `balance` and what it has stored and lost.
fn normal(contact: &QuasiStatic, balance: &Balance, stored: Energy, dissipated: f64) -> Normal {
    Normal {
        indentation: (!balance.indentation.is_nan()).then_some(balance.indentation),
        force: balance.force,
        contact_radius: Some(balance.contact_radius),
        stiffness: contact.stiffness_at(balance.contact_radius),
        stored,
        dissipated,
    }
}

/// The jumps of a motion, before which `lost` [J] had been lost; under a prescribed depth also the states
/// between them at which the force turns: pull-off is no matter of records.
struct EventLog<'c> {
    contact: &'c mut QuasiStatic,
    lost: f64,
    events: Vec<Event>,
}

impl EventLog<'_> {
    fn turns(&mut self, from: f64, to: f64) -> Result<(), ContactError> {
        for balance in self.contact.force_turns(from, to)? {
            let state = normal(self.contact, &balance, self.contact.energy_at(&balance), self.lost);
            self.push(self.contact.far_end(&balance), state, state);
        }
        Ok(())
    }

    fn jump(&mut self, jump: &Jump) {
        let before = normal(self.contact, &jump.before, jump.stored.0, self.lost);
        self.lost += jump.dissipated;
        let by_depth = jump.control == Control::Indentation;
        let at = jump.at;
        let indentation = if by_depth { at } else { f64::NAN };
        let parted = Balance { contact_radius: 0.0, reach: 0.0, indentation, force: 0.0 };
        let after = normal(self.contact, &jump.after.unwrap_or(parted), jump.stored.1, self.lost);
        self.push(at, before, after);
    }

    fn push(&mut self, at: f64, before: Normal, after: Normal) {
        self.events.push(Event { at, before, after, tangential: None });
    }
}

impl ContactModel for QuasiStatic {
    fn follow(&mut self, piece: &Straight) -> Result<Vec<Event>, ContactError> {
        let (mut from, lost) = (self.present().balance.reach, self.dissipated());
        let jumps = self.indent(piece.to)?;
        let end = self.present().balance.reach;
        let mut course = EventLog { contact: self, lost, events: Vec::new() };
        for jump in &jumps {
            course.turns(from, jump.before.reach)?;
            from = jump.after.map_or(0.0, |balance| balance.reach);
            course.jump(jump);
        }
        course.turns(from, end)?;
        Ok(course.events)
    }

    fn look(&mut self, piece: &Straight) -> Result<Glance, ContactError> {
        let mut probe = self.clone();
        probe.indent(piece.to)?;
        let balance = probe.present().balance;
        Ok(Glance { force: balance.force, contact_radius: balance.contact_radius })
    }

    fn state(&self) -> Normal {
        normal(self, &self.present().balance, self.energy(), self.dissipated())
    }

    fn position(&self) -> Option<f64> {
        QuasiStatic::position(self)
    }

    fn joined(&self) -> bool {
        self.present().joined
    }

    fn loading(&self) -> Option<Box<dyn Loading + '_>> {
        self.present().joined.then(|| Box::new(self.loaded()) as Box<dyn Loading>)
    }

    fn copy(&self) -> Box<dyn ContactModel> {
        Box::new(self.clone())
    }

    fn press(&mut self, pull: &Pull) -> Option<Result<Vec<Event>, ContactError>> {
        let lost = self.dissipated();
        let jumps = match QuasiStatic::press(self, pull.force) {
            Ok(jumps) => jumps,
            Err(error) => return Some(Err(error.into())),
        };
        let mut course = EventLog { contact: self, lost, events: Vec::new() };
        jumps.iter().for_each(|jump| course.jump(jump));
        Some(Ok(course.events))
    }

    fn last_depth(&self) -> Option<Result<f64, ContactError>> {
        Some(QuasiStatic::last_depth(self).map_err(ContactError::from))
    }
}

impl ContactModel for SpringBed {
    fn follow(&mut self, piece: &Straight) -> Result<Vec<Event>, ContactError> {
        let turn = self.least_force_above(piece.to).map(|depth| {
            self.indent(depth);
            let state = self.state();
            Event { at: depth, before: state, after: state, tangential: None }
        });
        self.indent(piece.to);
        Ok(turn.into_iter().collect())
    }

    fn look(&mut self, piece: &Straight) -> Result<Glance, ContactError> {
        let mut probe = self.clone();
        probe.indent(piece.to);
        Ok(Glance { force: probe.force(), contact_radius: probe.contact_radius() })
    }

    fn state(&self) -> Normal {
        let a = self.contact_radius();
        let stored = Energy { elastic: self.elastic_energy(), surface: self.surface_energy() };
        Normal {
            indentation: (!self.is_parted()).then_some(self.indentation()),
            force: self.force(),
            contact_radius: Some(a),
            stiffness: self.stiffness(),
            stored,
            dissipated: self.work() - stored.stored(),
        }
    }

    fn joined(&self) -> bool {
        self.contact_radius() > 0.0
    }

    fn loading(&self) -> Option<Box<dyn Loading + '_>> {
        self.joined().then(|| Box::new(self.spring_loads()) as Box<dyn Loading>)
    }

    fn copy(&self) -> Box<dyn ContactModel> {
        Box::new(self.clone())
    }

    fn effort(&self) -> Effort {
        Effort { springs: self.springs(), bytes: self.bytes(), force_error: None, radius_error: None }
    }

    fn press(&mut self, pull: &Pull) -> Option<Result<Vec<Event>, ContactError>> {
        SpringBed::press(self, pull.force);
        Some(Ok(Vec::new()))
    }

    fn last_depth(&self) -> Option<Result<f64, ContactError>> {
        Some(Ok(SpringBed::last_depth(self)))
    }
}
