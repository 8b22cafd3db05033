//! A bed of viscoelastic springs as a contact that is driven piece by piece.
//!
//! # Examples
//! ```
//! use springbed::contact::viscoelastic::{Spectrum, growing::GrowingBed, layout::Layout};
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! // Laid for contacts of 1 mm, pressed to one of 100 mm.
//! let ball = Arc::new(Paraboloid { radius: Length::new(1.0)? });
//! let laid = Layout::graded(ball.as_ref(), (1e-4, 1e-3), 400);
//! let mut bed = GrowingBed::new(Arc::new(Spectrum::elastic(1.0)), ball, laid);
//! bed.advance(0.01, 1.0)?;
//! assert!((bed.bed().force() / (4e-3 / 3.0) - 1.0).abs() < 1e-3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::Spectrum;
use super::continuous::in_time;
use super::layout::{Edge, Layout};
use super::lazy::Lazy;
use crate::contact::adhesion::line::Energy;
use crate::contact::creep::Creep;
use crate::contact::error::{BedError, ContactError};
use crate::contact::loaded::Loaded;
use crate::contact::model::{ContactModel, Effort, Event, Glance, Loading, Parting, Straight};
use crate::contact::spring_loads::{SeenSpring, SpringLoads};
use crate::contact::state::Normal;
use crate::shape::{Profile, Rim};
use std::sync::Arc;

/// A lazy bed that grows with its contact.
///
/// The bed moves to every record, so that a look costs what happens between it and the record before, however
/// many springs there are and however long the piece is.
#[derive(Debug, Clone)]
pub struct GrowingBed {
    bed: Lazy,
    profile: Arc<dyn Profile>,
    /// Largest depth so far [m].
    deepest: f64,
    /// The same when the bed was marked.
    deepest_at_mark: f64,
}

impl GrowingBed {
    /// A bed never touched.
    #[must_use]
    pub fn new(spectrum: Arc<Spectrum>, profile: Arc<dyn Profile>, layout: Layout) -> Self {
        Self { bed: Lazy::new(spectrum, layout), profile, deepest: 0.0, deepest_at_mark: 0.0 }
    }

    /// The springs.
    #[must_use]
    pub fn bed(&self) -> &Lazy {
        &self.bed
    }

    /// Moves at constant `speed` [m/s] for `duration` [s].
    ///
    /// # Errors
    /// The contact would outgrow the profile.
    pub fn advance(&mut self, speed: f64, duration: f64) -> Result<(), BedError> {
        self.widen(self.bed.indentation() + speed * duration)?;
        self.bed.advance(speed, duration);
        self.deepest = self.deepest.max(self.bed.indentation());
        Ok(())
    }

    /// ∫ F dt [N s] over a motion, and whether the bodies touch at its end; taken back.
    ///
    /// # Errors
    /// As of [`advance`](Self::advance).
    pub fn impulse_after(&mut self, speed: f64, duration: f64) -> Result<(f64, bool), BedError> {
        self.widen(self.bed.indentation() + speed * duration)?;
        Ok(self.bed.tried(speed, duration, |bed| (bed.impulse(), bed.pressed() > 0)))
    }

    /// Makes the bed wide enough for the depth `d` [m].
    fn widen(&mut self, d: f64) -> Result<(), BedError> {
        // Springs may stand beyond the end of the profile; a contact may not.
        if matches!(self.profile.rim(), Rim::End(end) if d > self.profile.reduced(end)) {
            return Err(BedError::BeyondProfile { indentation: d });
        }
        if d > self.bed.layout().height.last().copied().unwrap_or(0.0) {
            let a = self.profile.edge(d).ok_or(BedError::BeyondProfile { indentation: d })?;
            if !matches!(self.profile.rim(), Rim::Wall(_)) {
                self.bed.extend(self.profile.as_ref(), 1.25 * a);
            }
        }
        Ok(())
    }

    /// Where the contact ends: between two springs, but where g is the largest depth so far at the farthest, and
    /// there if the bed is as deep as that.
    fn edge(&self) -> Edge {
        let (edge, depth) = (self.bed.edge(), self.bed.indentation());
        let Some(reach) = self.profile.edge(self.deepest.max(depth)) else { return edge };
        if edge.place <= 0.0 {
            edge
        } else if depth >= self.deepest {
            Edge { place: reach, doubt: 0.0 }
        } else {
            Edge { place: edge.place.min(reach), ..edge }
        }
    }
}

impl GrowingBed {
    /// The springs touched so far, as they are now.
    fn springs(&self) -> SpringLoads {
        let layout = self.bed.layout();
        let spring = |j: usize| SeenSpring {
            place: layout.place[j],
            load: self.bed.line_load(j),
            weight: layout.weight[j],
            displacement: self.bed.displacement(j),
        };
        SpringLoads::new(self.profile.clone(), self.bed.indentation(), self.bed.touched(), spring)
            .with_edge(self.bed.radius(), 0.0)
    }
}

/// Force [N] of the springs, and of the part of one over which a contact is wider or narrower than they are.
fn force(bed: &Lazy) -> f64 {
    bed.force() + bed.force_beside_edge()
}

impl ContactModel for GrowingBed {
    fn follow(&mut self, piece: &Straight) -> Result<Vec<Event>, ContactError> {
        let Some(piece) = in_time(self.bed.spectrum(), self.bed.indentation(), piece)? else { return Ok(Vec::new()) };
        self.widen(piece.to)?;
        self.bed.follow_line(&piece);
        self.deepest = self.deepest.max(piece.to);
        Ok(Vec::new())
    }

    fn look(&mut self, piece: &Straight) -> Result<Glance, ContactError> {
        let from = self.bed.indentation();
        let Some(piece) = in_time(self.bed.spectrum(), from, piece)? else {
            return Ok(Glance { force: force(&self.bed), contact_radius: self.bed.radius() });
        };
        self.widen(piece.to)?;
        let see = |bed: &Lazy| Glance { force: force(bed), contact_radius: bed.radius() };
        Ok(self.bed.glanced(piece.speed, piece.duration, see))
    }

    fn parting(&self, piece: &Straight) -> Result<Option<Parting>, ContactError> {
        let Some(piece) = in_time(self.bed.spectrum(), self.bed.indentation(), piece)? else { return Ok(None) };
        let time = self.bed.parting(piece.speed, piece.duration);
        Ok(time.map(|time| Parting { time, doubt: 0.0, suddenly: false }))
    }

    fn state(&self) -> Normal {
        let (ledger, contact_radius) = (self.bed.ledger(), self.edge().place);
        Normal {
            indentation: Some(self.bed.indentation()),
            force: force(&self.bed),
            contact_radius: Some(contact_radius),
            stiffness: 2.0 * self.bed.spectrum().instantaneous() * contact_radius,
            stored: Energy { elastic: ledger.stored, surface: 0.0 },
            dissipated: ledger.dissipated,
        }
    }

    fn joined(&self) -> bool {
        self.bed.pressed() > 0
    }

    fn loading(&self) -> Option<Box<dyn Loading + '_>> {
        self.joined().then(|| Box::new(self.springs()) as Box<dyn Loading>)
    }

    fn bed(&self) -> Option<Loaded> {
        if self.bed.touched() > 0 { self.springs().loaded() } else { None }
    }

    fn copy(&self) -> Box<dyn ContactModel> {
        Box::new(self.clone())
    }

    fn mark(&mut self) -> bool {
        self.bed.mark();
        self.deepest_at_mark = self.deepest;
        true
    }

    fn unmark(&mut self) {
        self.bed.unmark();
    }

    fn at_mark(&self) -> Option<Box<dyn ContactModel>> {
        let (bed, profile) = (self.bed.at_mark()?, self.profile.clone());
        let deepest = self.deepest_at_mark;
        Some(Box::new(Self { bed, profile, deepest, deepest_at_mark: deepest }))
    }

    fn memory(&self) -> Option<Arc<Spectrum>> {
        Some(self.bed.shared_spectrum())
    }

    fn effort(&self) -> Effort {
        let force_error = Some(self.bed.force_between_springs());
        Effort { force_error, radius_error: Some(self.edge().doubt), ..self.bed.effort() }
    }

    fn creep(&self) -> Option<Creep> {
        (self.bed.touched() == 0 && self.bed.indentation() <= 0.0)
            .then(|| Creep::new(self.bed.shared_spectrum(), self.profile.clone()))
    }

    fn leave(&mut self) -> Option<f64> {
        self.bed.leave();
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::viscoelastic::laws::unit_ball;
    use crate::material::Relaxation;

    /// A front that closes over a dashpot, wherever between two springs it is: F = 4/3 d^(3/2) + 2ηvd^(1/2) on the unit
    /// ball, to second order, the constant 1/4 of the springs and as much again for what is beside the edge.
    #[test]
    fn a_front_over_a_dashpot_is_of_second_order_too() {
        for viscosity in [1e-3, 1.0, 1e3] {
            for springs in [32, 128] {
                let relaxation = Relaxation { equilibrium: 1.0, terms: vec![], viscosity };
                let spectrum = Arc::new(Spectrum::new(&relaxation));
                let layout = Layout::uniform(&unit_ball(), 1.25, springs);
                let mut bed = GrowingBed::new(spectrum, Arc::new(unit_ball()), layout);
                bed.advance(0.2, 1.0).unwrap();
                for step in 1..70 {
                    bed.advance(0.01, 1.0).unwrap();
                    let depth = 0.2 + 0.01 * f64::from(step);
                    let exact = 4.0 / 3.0 * depth.powf(1.5) + 2.0 * viscosity * 0.01 * depth.sqrt();
                    let off = bed.state().force / exact - 1.0;
                    let width = 1.25 / f64::from(u32::try_from(springs).unwrap());
                    assert!(off.abs() < 0.5 * width * width / depth, "{viscosity} {springs} {depth}: {off:e}");
                }
            }
        }
    }
}
