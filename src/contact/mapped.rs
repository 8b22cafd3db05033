//! A contact whose bed has places that are not its radii, told in its own radius or half width.
//!
//! # Examples
//! ```
//! use springbed::contact::adhesion::line::EdgeLine;
//! use springbed::contact::direct::QuasiStatic;
//! use springbed::contact::foundation::Foundation;
//! use springbed::contact::mapped::MappedContact;
//! use springbed::contact::model::ContactModel;
//! use springbed::input::quantity::Length;
//! use springbed::shape::{Cylinder, Lying, Profile};
//! use std::sync::Arc;
//!
//! // R = E* = 1, at rest at a distance of 1 m: pressed until a = 0.1 m it carries πE*a²/4R per length, and
//! // E*a/2R in the middle.
//! let one = Length::new(1.0)?;
//! let profile = Arc::new(Lying::from(&Cylinder { radius: one, datum: one, width: None }));
//! let bed = QuasiStatic::new(EdgeLine::new(Foundation::new(profile.clone(), 1.0), 0.0));
//! let mut contact = MappedContact::new(Box::new(bed), profile);
//! contact.press(&springbed::contact::model::Pull {
//!     force: 0.0025 * std::f64::consts::PI, slide: 0.0, sliding_speed: 0.0, duration: 1.0,
//! });
//! let state = contact.state();
//! assert!((state.contact_radius.unwrap() - 0.1).abs() < 1e-14);
//! assert!((state.indentation.unwrap() / (0.005 * (20f64.ln() + 0.5)) - 1.0).abs() < 1e-13);
//! assert!((contact.loading().unwrap().pressure(0.0).unwrap() - 0.05).abs() < 1e-14);
//! # Ok::<(), springbed::input::quantity::QuantityError>(())
//! ```

use super::creep::Creep;
use super::error::{BedError, ContactError, PlaneError};
use super::model::{ContactModel, Effort, Event, Glance, Loading, Parting, Pose, Pull, Straight, TangentialBed};
use super::state::{Normal, Tangential};
use crate::material::Spectrum;
use crate::shape::{Profile, Rim};
use std::sync::Arc;

/// The bed of a section or over layers, whose places are turned into half widths or radii as they are told.
///
/// Within, every contact radius is a place of the bed (see [`Lying`](crate::shape::Lying) and
/// [`Grounded`](crate::ground::Grounded)); so is that of a
/// [`Glance`], which drives compare with itself alone.
pub struct MappedContact {
    bed: Box<dyn ContactModel>,
    profile: Arc<dyn Profile>,
}

impl MappedContact {
    /// The contact `bed` under a mapped `profile`.
    #[must_use]
    pub fn new(bed: Box<dyn ContactModel>, profile: Arc<dyn Profile>) -> Self {
        Self { bed, profile }
    }

    fn told(&self, normal: Normal) -> Normal {
        // A closed wave gives no more.
        let closed = normal.contact_radius.is_some_and(|place| is_closed(self.profile.as_ref(), place));
        let stiffness = if closed { f64::INFINITY } else { normal.stiffness };
        let contact_radius = normal.contact_radius.map(|place| self.profile.contact_radius(place));
        Normal { contact_radius, stiffness, ..normal }
    }

    /// Whether a wave can go where a piece leads: no further than to lie flat, to what rounds a great force.
    fn can_go(&self, piece: &Straight) -> Result<(), ContactError> {
        let (Rim::Wall(end), true) = (self.profile.rim(), self.profile.is_plane()) else { return Ok(()) };
        let full = self.profile.reduced(end);
        if piece.to > full * (1.0 + FLAT) {
            return Err(PlaneError::FullContact { indentation: piece.to, full }.into());
        }
        Ok(())
    }

    /// Whether what lies below is known as wide as the contact is.
    fn is_known(&self) -> Result<(), ContactError> {
        let place = self.bed.state().contact_radius.unwrap_or(0.0);
        known(self.profile.as_ref(), self.profile.contact_radius(place)).map_err(ContactError::from)
    }

    fn told_tangential(&self, tangential: Tangential) -> Tangential {
        Tangential { stick_radius: self.profile.contact_radius(tangential.stick_radius), ..tangential }
    }

    fn told_event(&self, event: &Event) -> Event {
        let tangential = event.tangential.map(|tangential| self.told_tangential(tangential));
        Event { before: self.told(event.before), after: self.told(event.after), tangential, ..*event }
    }

    fn told_events(&self, events: &[Event]) -> Vec<Event> {
        events.iter().map(|event| self.told_event(event)).collect()
    }
}

impl ContactModel for MappedContact {
    fn follow(&mut self, piece: &Straight) -> Result<Vec<Event>, ContactError> {
        self.can_go(piece)?;
        let events = self.bed.follow(piece)?;
        self.is_known()?;
        Ok(self.told_events(&events))
    }

    fn look(&mut self, piece: &Straight) -> Result<Glance, ContactError> {
        self.can_go(piece)?;
        self.bed.look(piece)
    }

    fn state(&self) -> Normal {
        self.told(self.bed.state())
    }

    fn indentation(&self) -> Option<f64> {
        self.bed.indentation()
    }

    fn position(&self) -> Option<f64> {
        self.bed.position()
    }

    fn joined(&self) -> bool {
        self.bed.joined()
    }

    fn loading(&self) -> Option<Box<dyn Loading + '_>> {
        let bed = self.bed.loading()?;
        Some(Box::new(MappedLoading { bed, profile: self.profile.as_ref() }))
    }

    fn copy(&self) -> Box<dyn ContactModel> {
        Box::new(Self::new(self.bed.copy(), self.profile.clone()))
    }

    fn mark(&mut self) -> bool {
        self.bed.mark()
    }

    fn unmark(&mut self) {
        self.bed.unmark();
    }

    fn at_mark(&self) -> Option<Box<dyn ContactModel>> {
        Some(Box::new(Self::new(self.bed.at_mark()?, self.profile.clone())))
    }

    fn tangential(&self) -> Option<Tangential> {
        self.bed.tangential().map(|tangential| self.told_tangential(tangential))
    }

    fn separate(&self) -> Option<(Box<dyn ContactModel>, Box<dyn TangentialBed>)> {
        let (normal, springs) = self.bed.separate()?;
        Some((Box::new(Self::new(normal, self.profile.clone())), springs))
    }

    fn sheared(&self) -> Normal {
        self.told(self.bed.sheared())
    }

    fn settle(&mut self) -> Result<(), ContactError> {
        self.bed.settle()
    }

    fn path(&self) -> &[Pose] {
        self.bed.path()
    }

    fn memory(&self) -> Option<Arc<Spectrum>> {
        self.bed.memory()
    }

    fn effort(&self) -> Effort {
        self.bed.effort()
    }

    fn press(&mut self, pull: &Pull) -> Option<Result<Vec<Event>, ContactError>> {
        let events = self.bed.press(pull)?;
        Some(events.and_then(|events| self.is_known().map(|()| self.told_events(&events))))
    }

    fn last_depth(&self) -> Option<Result<f64, ContactError>> {
        self.bed.last_depth()
    }

    fn doubt(&self) -> f64 {
        self.bed.doubt()
    }

    fn parting(&self, piece: &Straight) -> Result<Option<Parting>, ContactError> {
        self.bed.parting(piece)
    }

    fn creep(&self) -> Option<Creep> {
        self.bed.creep()
    }

    fn leave(&mut self) -> Option<f64> {
        self.bed.leave()
    }
}

/// Whether a contact of the radius `radius` [m] is known over what lies below it.
///
/// # Errors
/// It is wider than layers are known.
pub fn known(profile: &dyn Profile, radius: f64) -> Result<(), BedError> {
    let known = profile.known_to(radius);
    if radius > known { Err(BedError::Wide { radius, known }) } else { Ok(()) }
}

/// How much deeper, as a part, a closed wave is taken to be under a force.
const FLAT: f64 = 1e-9;

/// Places beyond this part of a closed bed are as good as its end: y = 1e-8 where the bed ends at 1e-12.
const LAST: f64 = 1e-4;

/// Whether nothing is open any more of a contact whose bed ends at a place [m].
fn is_closed(profile: &dyn Profile, place: f64) -> bool {
    profile.is_plane() && matches!(profile.rim(), Rim::Wall(end) if place >= end)
}

/// The load over the distance from the middle.
struct MappedLoading<'c> {
    bed: Box<dyn Loading + 'c>,
    profile: &'c dyn Profile,
}

impl Loading for MappedLoading<'_> {
    fn contact_radius(&self) -> f64 {
        self.profile.contact_radius(self.bed.contact_radius())
    }

    /// Of a closed wave it is smooth, and what is a hundredth of a thousandth of the wave away stands for the last place.
    fn pressure(&self, r: f64) -> Option<f64> {
        if self.contact_radius() > self.profile.fields_known_to() {
            return None;
        }
        let end = self.bed.contact_radius();
        let place = if (r - self.contact_radius()).abs() <= 0.0 { end } else { self.profile.place(r) };
        self.bed.pressure(if is_closed(self.profile, end) { place.min(LAST * end) } else { place })
    }

    /// Not told from the place on at which a strip has no stiffness: there the half-plane has long been at rest; nor over
    /// layers of which the springs alone are known.
    fn surface(&self, r: f64) -> Option<f64> {
        let place = self.profile.place(r);
        let is_known = place.is_finite() && self.contact_radius() <= self.profile.fields_known_to();
        if is_known { self.bed.surface(place) } else { None }
    }

    fn stress_intensity(&self) -> Option<f64> {
        self.bed.stress_intensity().filter(|_| !is_closed(self.profile, self.bed.contact_radius()))
    }

    fn shear(&self, radii: &[f64]) -> Vec<Option<f64>> {
        let places: Vec<f64> = radii.iter().map(|&radius| self.profile.place(radius)).collect();
        self.bed.shear(&places)
    }
}
