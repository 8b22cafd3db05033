//! The bed of a body that moves along as a contact that is driven piece by piece.

use super::GlidingBed;
use super::outline::Outline;
use crate::contact::adhesion::line::Energy;
use crate::contact::error::ContactError;
use crate::contact::model::{ContactModel, Effort, Event, Glance, Loading, Pull, Straight};
use crate::contact::state::{Gliding, Normal};
use crate::contact::viscoelastic::continuous::in_time;

impl ContactModel for GlidingBed {
    fn follow(&mut self, piece: &Straight) -> Result<Vec<Event>, ContactError> {
        if let Some(piece) = in_time(self.spectrum(), self.now.depth, piece)? {
            self.advance(piece.to, piece.slide, piece.duration)?;
        }
        Ok(Vec::new())
    }

    fn look(&mut self, piece: &Straight) -> Result<Glance, ContactError> {
        let mut ahead = self.clone();
        ahead.follow(piece)?;
        let state = ahead.state();
        Ok(Glance { force: state.force, contact_radius: state.contact_radius.unwrap_or(0.0) })
    }

    fn state(&self) -> Normal {
        let stored = self.stored();
        Normal {
            indentation: Some(self.now.depth),
            force: self.force(),
            contact_radius: match self.outline {
                Outline::Round { .. } => Some(self.edges().map_or(0.0, |(front, rear)| 0.5 * (front - rear))),
                Outline::Line(_) => None,
            },
            stiffness: self.stiffness(),
            stored: Energy { elastic: stored, surface: 0.0 },
            dissipated: self.work - stored,
        }
    }

    fn joined(&self) -> bool {
        self.pressed().next().is_some()
    }

    fn loading(&self) -> Option<Box<dyn Loading + '_>> {
        None
    }

    fn copy(&self) -> Box<dyn ContactModel> {
        Box::new(self.clone())
    }

    fn gliding(&self) -> Option<Gliding> {
        let (_, resistance) = self.forces();
        let edges = self.edges();
        Some(Gliding {
            slide: self.now.place,
            resistance,
            leading_edge: edges.map(|(front, _)| front),
            trailing_edge: edges.map(|(_, rear)| rear),
        })
    }

    fn press(&mut self, pull: &Pull) -> Option<Result<Vec<Event>, ContactError>> {
        Some(self.pull(pull).map(|()| Vec::new()))
    }

    fn effort(&self) -> Effort {
        let numbers = self.spectrum().terms().len().max(self.spectrum().modes().len()) + 8;
        Effort {
            springs: self.springs.len(),
            bytes: self.springs.len() * numbers * size_of::<f64>(),
            force_error: None,
            radius_error: None,
        }
    }
}
