//! The continuous bed as a contact that is driven piece by piece.
//!
//! # Examples
//! ```
//! use springbed::contact::model::{ContactModel, Straight};
//! use springbed::contact::viscoelastic::{Spectrum, continuous::ContinuousContact, memory::Memory};
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! // A body that does not relax, E* = 1: Hertz, F = 4/3 √R d^{3/2}.
//! let ball = Arc::new(Paraboloid { radius: Length::new(1.0)? });
//! let mut contact = ContinuousContact::new(Memory::new(Arc::new(Spectrum::elastic(1.0)), ball));
//! contact.follow(&Straight::between(0.0, 0.01, 1.0))?;
//! assert!((contact.state().force / (4e-3 / 3.0) - 1.0).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::Spectrum;
use super::attraction::Attraction;
use super::memory::Memory;
use crate::contact::adhesion::line::Energy;
use crate::contact::creep::Creep;
use crate::contact::error::ContactError;
use crate::contact::loaded::Loaded;
use crate::contact::model::{ContactModel, Effort, Event, Glance, Loading, Parting, Straight};
use crate::contact::state::Normal;
use std::sync::Arc;

/// A continuous bed, driven piece by piece.
///
/// It moves to every record: a piece cut in two leaves no border behind that counts.
#[derive(Debug, Clone)]
pub struct ContinuousContact {
    bed: Memory,
    /// The bed near the edge as looks from here on see it, once there has been one.
    near: Option<Box<Memory>>,
}

impl ContinuousContact {
    /// A contact of a bed.
    #[must_use]
    pub fn new(bed: Memory) -> Self {
        Self { bed, near: None }
    }

    /// The bed now.
    #[must_use]
    pub fn bed(&self) -> &Memory {
        &self.bed
    }
}

/// A piece that takes no time takes the shortest one in which nothing relaxes; `None` if it leads nowhere.
///
/// # Errors
/// A dashpot lets nothing give at once; what is drawn away from it at once leaves it.
pub(in crate::contact) fn in_time(
    spectrum: &Spectrum,
    from: f64,
    piece: &Straight,
) -> Result<Option<Straight>, ContactError> {
    if piece.duration > 0.0 {
        return Ok(Some(*piece));
    }
    if (piece.to - from).abs() <= 0.0 {
        return Ok(None);
    }
    if spectrum.viscosity() > 0.0 && piece.to > from {
        return Err(ContactError::Jump { to: piece.to });
    }
    let instant = Straight::between(from, piece.to, spectrum.instant());
    Ok(Some(Straight { slide: piece.slide, ..instant }))
}

/// Part of the error of a step of an edge with a rate by which its looks differ.
const UNTOLD: f64 = 0.1;

impl ContactModel for ContinuousContact {
    fn follow(&mut self, piece: &Straight) -> Result<Vec<Event>, ContactError> {
        if let Some(piece) = in_time(&self.bed.spectrum(), self.bed.indentation(), piece)? {
            self.near = None;
            self.bed.follow_line(&piece)?;
        }
        Ok(Vec::new())
    }

    fn look(&mut self, piece: &Straight) -> Result<Glance, ContactError> {
        let Some(piece) = in_time(&self.bed.spectrum(), self.bed.indentation(), piece)? else {
            return Ok(Glance { force: self.bed.force(), contact_radius: self.bed.radius() });
        };
        let near = self.near.get_or_insert_with(|| Box::new(self.bed.near()));
        let (force, contact_radius) = self.bed.force_seen(near, piece.speed, piece.duration)?;
        Ok(Glance { force, contact_radius })
    }

    fn state(&self) -> Normal {
        let ledger = self.bed.ledger();
        Normal {
            indentation: Some(self.bed.indentation()),
            force: self.bed.force(),
            contact_radius: Some(self.bed.radius()),
            stiffness: self.bed.stiffness(),
            stored: Energy { elastic: ledger.stored, surface: self.bed.surface_energy() },
            dissipated: ledger.dissipated - self.bed.surface_energy(),
        }
    }

    fn indentation(&self) -> Option<f64> {
        Some(self.bed.indentation())
    }

    fn joined(&self) -> bool {
        self.bed.radius() > 0.0
    }

    fn loading(&self) -> Option<Box<dyn Loading + '_>> {
        self.joined().then(|| Box::new(self.bed.loaded()) as Box<dyn Loading>)
    }

    fn bed(&self) -> Option<Loaded> {
        (!self.bed.is_untouched()).then(|| self.bed.loaded())
    }

    fn copy(&self) -> Box<dyn ContactModel> {
        Box::new(self.clone())
    }

    fn memory(&self) -> Option<Arc<Spectrum>> {
        Some(self.bed.spectrum())
    }

    fn effort(&self) -> Effort {
        Effort { springs: 0, bytes: self.bed.bytes(), force_error: Some(self.bed.force_error()), radius_error: None }
    }

    fn doubt(&self) -> f64 {
        self.bed.attraction().and_then(Attraction::step_error).map_or(0.0, |error| UNTOLD * error)
    }

    fn parting(&self, piece: &Straight) -> Result<Option<Parting>, ContactError> {
        let attraction = self.bed.attraction();
        let (suddenly, step) = (attraction.is_some(), attraction.and_then(Attraction::step_error).unwrap_or(0.0));
        let time = self.bed.parting(piece.speed, piece.duration)?;
        Ok(time.map(|time| Parting { time, doubt: step * time, suddenly }))
    }

    fn creep(&self) -> Option<Creep> {
        let free = self.bed.attraction().is_none() && self.bed.is_untouched() && self.bed.time() <= 0.0;
        free.then(|| Creep::new(self.bed.spectrum(), self.bed.profile()))
    }

    fn leave(&mut self) -> Option<f64> {
        self.near = None;
        self.bed.leave()
    }
}
