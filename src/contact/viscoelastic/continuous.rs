//! The continuous bed as a contact that is driven piece by piece.

use super::Spectrum;
use super::memory::Memory;
use crate::contact::adhesion::line::Energy;
use crate::contact::creep::Creep;
use crate::contact::error::ContactError;
use crate::contact::model::{ContactModel, Effort, Event, Glance, Loading, Pose, Straight};
use crate::contact::state::Normal;
use std::sync::Arc;

/// A continuous bed on its way along a straight piece.
///
/// Pieces that go on in one line are one motion of the bed, which is made once and for all when the line
/// bends: neither the number of records nor a history cut in two leaves a border behind.
#[derive(Debug, Clone)]
pub struct ContinuousContact {
    /// At the beginning of the present line.
    settled: Memory,
    /// The line so far; of no duration just after a bend.
    line: Straight,
    /// The bed now.
    now: Memory,
}

impl ContinuousContact {
    /// A bed never touched.
    #[must_use]
    pub fn new(bed: Memory) -> Self {
        let line = Straight::between(bed.indentation(), bed.indentation(), 0.0);
        Self { now: bed.clone(), settled: bed, line }
    }

    /// The bed now.
    #[must_use]
    pub fn bed(&self) -> &Memory {
        &self.now
    }

    fn start(&self) -> Pose {
        Pose { indentation: self.settled.indentation(), slide: 0.0 }
    }

    /// The bed from which a piece starts, and the line that leads to its end.
    fn along(&self, piece: &Straight) -> (&Memory, Straight) {
        let piece = Straight { slide: 0.0, ..*piece };
        match self.line.joined_to(self.start(), &piece) {
            Some(line) => (&self.settled, line),
            None => (&self.now, piece),
        }
    }
}

/// A piece that takes no time takes the shortest one in which nothing relaxes; `None` if it leads nowhere.
///
/// # Errors
/// A dashpot lets nothing give at once.
pub(super) fn in_time(spectrum: &Spectrum, from: f64, piece: &Straight) -> Result<Option<Straight>, ContactError> {
    if piece.duration > 0.0 {
        return Ok(Some(*piece));
    }
    if (piece.to - from).abs() <= 0.0 {
        return Ok(None);
    }
    if spectrum.viscosity() > 0.0 {
        return Err(ContactError::Jump { to: piece.to });
    }
    let instant = Straight::between(from, piece.to, spectrum.instant());
    Ok(Some(Straight { slide: piece.slide, ..instant }))
}

impl ContactModel for ContinuousContact {
    fn follow(&mut self, piece: &Straight) -> Result<Vec<Event>, ContactError> {
        let (spectrum, from) = (self.settled.spectrum(), self.now.indentation());
        let Some(piece) = in_time(&spectrum, from, piece)? else { return Ok(Vec::new()) };
        let (start, line) = self.along(&piece);
        let mut bed = start.clone();
        bed.follow_line(&line)?;
        if line.duration <= piece.duration {
            self.settled = self.now.clone();
        }
        (self.now, self.line) = (bed, line);
        Ok(Vec::new())
    }

    fn look(&mut self, piece: &Straight) -> Result<Glance, ContactError> {
        let (spectrum, from) = (self.settled.spectrum(), self.now.indentation());
        let Some(piece) = in_time(&spectrum, from, piece)? else {
            return Ok(Glance { force: self.now.force(), contact_radius: self.now.radius() });
        };
        let (bed, line) = self.along(&piece);
        let (force, contact_radius) = bed.force_after(line.speed, line.duration)?;
        Ok(Glance { force, contact_radius })
    }

    fn state(&self) -> Normal {
        let ledger = self.now.ledger();
        Normal {
            indentation: Some(self.now.indentation()),
            force: self.now.force(),
            contact_radius: Some(self.now.radius()),
            stiffness: self.now.stiffness(),
            stored: Energy { elastic: ledger.stored, surface: 0.0 },
            dissipated: ledger.dissipated,
        }
    }

    fn joined(&self) -> bool {
        self.now.radius() > 0.0
    }

    fn loading(&self) -> Option<Box<dyn Loading + '_>> {
        self.joined().then(|| Box::new(self.now.loaded()) as Box<dyn Loading>)
    }

    fn copy(&self) -> Box<dyn ContactModel> {
        Box::new(self.clone())
    }

    fn memory(&self) -> Option<Arc<Spectrum>> {
        Some(self.settled.spectrum())
    }

    fn effort(&self) -> Effort {
        Effort { springs: 0, bytes: self.now.bytes(), force_error: Some(self.now.force_error()) }
    }

    fn parting(&self, piece: &Straight) -> Result<Option<f64>, ContactError> {
        let (bed, line) = self.along(piece);
        let before = line.duration - piece.duration;
        let parting = bed.parting(line.speed, line.duration)?;
        Ok(parting.map(|time| time - before))
    }

    fn creep(&self) -> Option<Creep> {
        let free = self.now.attraction().is_none() && self.now.strips() == 0 && self.now.time() <= 0.0;
        free.then(|| Creep::new(self.now.spectrum(), self.now.profile()))
    }

    fn leave(&mut self) {
        self.now.leave();
        *self = Self::new(self.now.clone());
    }
}
