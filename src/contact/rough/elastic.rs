//! A rough line on elastic bodies.
//!
//! # Examples
//! ```
//! use springbed::contact::model::{ContactModel, Straight};
//! use springbed::contact::rough::RoughContact;
//! use springbed::shape::rough::{Rings, RoughLine, RoughnessSpectrum};
//!
//! // Pressed until every spring carries, a line is a flat: k = E*L.
//! let spectrum = RoughnessSpectrum::table(&[(6.4, 1e-12), (64.0, 1e-15)])?;
//! let line = RoughLine::new(&Rings::of(&spectrum, 1.0, 1000)?, 7);
//! let mut contact = RoughContact::new(&line, 1000, 2.0, None)?;
//! contact.follow(&Straight::between(0.0, 1.0, 1.0))?;
//! assert!((contact.state().stiffness - 2.0).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::bed::{BedState, RoughBed};
use super::ends::LineEnds;
use crate::contact::adhesion::line::Energy;
use crate::contact::error::ContactError;
use crate::contact::model::{ContactModel, Effort, Event, Glance, Loading, Pull, Straight};
use crate::contact::state::Normal;
use crate::shape::Profile;
use crate::shape::rough::{RoughError, RoughLine};
use std::sync::Arc;

/// A rough line pressed on its bed; indentation counts from first touch.
#[derive(Debug, Clone)]
pub struct RoughContact {
    bed: Arc<RoughBed>,
    state: BedState,
    /// Indentation from first touch [m].
    depth: f64,
    ends: LineEnds,
}

impl RoughContact {
    /// A line of `points` springs on the profile `base`, none under a nominally flat surface, over a half-space of the
    /// modulus E* [Pa], just touching.
    ///
    /// # Errors
    /// As of [`RoughBed::under`].
    pub fn new(line: &RoughLine, points: usize, modulus: f64, base: Option<&dyn Profile>) -> Result<Self, RoughError> {
        let bed = RoughBed::under(line, points, modulus, |x| base.map_or(0.0, |base| base.reduced(x)))?;
        let state = bed.at_indentation(bed.first_touch());
        let ends = LineEnds::of(line, points, base, bed.first_touch())?;
        Ok(Self { bed: Arc::new(bed), state, depth: 0.0, ends })
    }

    /// The springs.
    #[must_use]
    pub fn bed(&self) -> &RoughBed {
        &self.bed
    }
}

impl ContactModel for RoughContact {
    fn follow(&mut self, piece: &Straight) -> Result<Vec<Event>, ContactError> {
        (self.state, self.depth) = (self.bed.at_indentation(self.bed.first_touch() + piece.to), piece.to);
        self.ends.hold(self.depth).map(|()| Vec::new())
    }

    fn look(&mut self, piece: &Straight) -> Result<Glance, ContactError> {
        let state = self.bed.at_indentation(self.bed.first_touch() + piece.to);
        Ok(Glance { force: state.force, contact_radius: 0.0 })
    }

    fn state(&self) -> Normal {
        Normal {
            indentation: Some(self.depth),
            force: self.state.force,
            contact_radius: None,
            stiffness: self.state.stiffness,
            stored: Energy { elastic: self.state.energy, surface: 0.0 },
            dissipated: 0.0,
        }
    }

    fn joined(&self) -> bool {
        self.state.force > 0.0
    }

    fn loading(&self) -> Option<Box<dyn Loading + '_>> {
        None
    }

    fn copy(&self) -> Box<dyn ContactModel> {
        Box::new(self.clone())
    }

    fn effort(&self) -> Effort {
        Effort { springs: self.bed.springs(), ..Effort::default() }
    }

    fn press(&mut self, pull: &Pull) -> Option<Result<Vec<Event>, ContactError>> {
        self.state = self.bed.at_force(pull.force);
        self.depth = self.state.indentation - self.bed.first_touch();
        Some(self.ends.hold(self.depth).map(|()| Vec::new()))
    }

    fn last_depth(&self) -> Option<Result<f64, ContactError>> {
        Some(Ok(0.0))
    }
}
