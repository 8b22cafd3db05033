//! A normal contact with friction on top of it.
//!
//! # Examples
//! ```
//! use springbed::contact::adhesion::line::EdgeLine;
//! use springbed::contact::direct::QuasiStatic;
//! use springbed::contact::foundation::Foundation;
//! use springbed::contact::model::{ContactModel, Straight};
//! use springbed::friction::Grip;
//! use springbed::friction::contact::{CoulombMemory, FrictionalContact};
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! // A normal contact with friction on top is a contact again: pressed to d = 1, then slid by 1.
//! let ball = Arc::new(Paraboloid { radius: Length::new(1.0)? });
//! let normal = QuasiStatic::new(EdgeLine::new(Foundation::new(ball.clone(), 1.0), 0.0));
//! let grip = Grip { normal_modulus: 1.0, tangential_modulus: 1.0, coefficient: 0.3 };
//! let friction = CoulombMemory::new(ball, grip, 1e-6);
//! let mut contact = FrictionalContact::new(Box::new(normal), Box::new(friction));
//! contact.follow(&Straight::between(0.0, 1.0, 1.0))?;
//! contact.follow(&Straight { slide: 1.0, ..Straight::between(1.0, 1.0, 1.0) })?;
//! contact.settle()?;
//! assert!((contact.tangential().unwrap().force - 0.4).abs() < 1e-14);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod held;
mod memory;
mod peeling;
mod sliding;
mod springs;
mod stuck;
mod viscoelastic;

pub use memory::CoulombMemory;
pub use peeling::Peeling;
pub use sliding::{GrossSlip, Interface, SlidingContact};
pub use springs::CoulombSprings;
pub use stuck::StuckEdge;
pub use viscoelastic::ViscoelasticFriction;

use super::FrictionError;
use super::driven::chords;
use crate::contact::adhesion::equilibrium::Control;
use crate::contact::creep::Creep;
use crate::contact::error::ContactError;
use crate::contact::loaded::Loaded;
use crate::contact::model::{
    ContactModel, Effort, Event, Glance, Loading, Parting, Pose, Pull, Straight, TangentialBed,
};
use crate::contact::state::{Normal, Tangential};
use crate::contact::viscoelastic::Spectrum;
use std::sync::Arc;

/// A step of a history, seen after the normal contact has taken it.
#[derive(Clone, Copy)]
pub struct Step<'c> {
    /// The normal contact at the end of the step.
    pub contact: &'c dyn ContactModel,
    /// What is prescribed.
    pub control: Control,
    /// Its values at the beginning and the end; between them it is linear in time.
    pub prescribed: [f64; 2],
    /// Tangential displacements at the beginning and the end [m], linear in time too.
    pub slide: [f64; 2],
    /// Sliding speed u̇_x [m/s].
    pub speed: f64,
    /// Speed of the depth [m/s]; zero under a force.
    pub sinking: f64,
    /// Duration [s].
    pub over: f64,
}

/// A sudden change on a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sudden {
    /// The tangential contact where it happens.
    pub tangential: Tangential,
    /// The normal contact under shear there, where it is another one afterwards.
    pub normal: Option<Normal>,
}

impl From<Tangential> for Sudden {
    fn from(tangential: Tangential) -> Self {
        Self { tangential, normal: None }
    }
}

/// What slides, sticks and rubs while a normal contact moves.
pub trait TangentialContact: Send {
    /// Follows a step; what changes suddenly, at its beginning or on it.
    ///
    /// # Errors
    /// There is no state of the contact at its end.
    fn follow(&mut self, step: &Step<'_>) -> Result<Vec<Sudden>, FrictionError>;

    /// Present state.
    fn state(&self) -> Tangential;

    /// Shear stress τ [Pa] at the radii `radii` [m] under the load `loading`; `None` where it is singular or not known.
    fn stress(&self, _loading: &dyn Loading, radii: &[f64]) -> Vec<Option<f64>> {
        vec![None; radii.len()]
    }

    /// Energy [J] its springs have lost so far as they relax.
    fn relaxed(&self) -> f64 {
        0.0
    }

    /// The contact as it is, on its own.
    fn copy(&self) -> Box<dyn TangentialContact>;

    /// Its springs on their own, if it is a bed that asks nothing but the depth.
    fn bed(&self) -> Option<Box<dyn TangentialBed>> {
        None
    }

    /// Told before the normal contact moves.
    fn let_go(&mut self) {}

    /// The state of the normal contact under shear, from the one without.
    fn sheared(&self, normal: Normal) -> Normal {
        normal
    }

    /// The load of the normal contact under shear, where that changes it.
    fn loading(&self) -> Option<Box<dyn Loading + '_>> {
        None
    }

    /// What the tangential contact takes.
    fn effort(&self) -> Effort {
        Effort::default()
    }

    /// The straight steps taken so far, if they were kept.
    fn path(&self) -> &[Pose] {
        &[]
    }
}

impl Step<'_> {
    /// The step as straight ones that start from `from`.
    ///
    /// Under a prescribed depth there is one. Under a prescribed force the depth is a curve in time:
    /// it is replaced by chords within `accuracy` of it, for the memory of friction holds how slide
    /// and depth grew together. A body that comes back under a force first touches where it is.
    #[must_use]
    pub fn positions(&self, from: Pose, accuracy: f64) -> Vec<Pose> {
        let end = self.contact.state().indentation.unwrap_or(0.0);
        if self.control == Control::Indentation {
            return vec![Pose { indentation: end, slide: self.slide[1] }];
        }
        let from = Pose { indentation: from.indentation.max(0.0), ..from };
        if from.indentation <= 0.0 && !self.contact.joined() {
            // Bodies apart slide past each other.
            return vec![Pose { indentation: 0.0, slide: self.slide[1] }];
        }
        let depth = |t: f64| match t {
            t if t <= 0.0 => from.indentation,
            t if t >= 1.0 => end,
            t => self.depth(t).unwrap_or(f64::NAN),
        };
        std::iter::once(from).chain(chords(&depth, (self.slide[0], self.slide[1]), accuracy)).collect()
    }

    /// Depth [m] at the fraction `t` of a step under a prescribed force. Where there is friction
    /// inside a contact it depends on the present force alone.
    fn depth(&self, t: f64) -> Option<f64> {
        let mut probe = self.contact.copy();
        let mut press = |force| probe.press(&Pull { force, slide: 0.0, sliding_speed: 0.0, duration: 0.0 });
        if !self.contact.joined() {
            // What has parted by the end was in contact on the way.
            press(0.0)?.ok()?;
        }
        press(self.prescribed[0] + t * (self.prescribed[1] - self.prescribed[0]))?.ok()?;
        Some(probe.state().indentation.unwrap_or(0.0))
    }
}

/// A contact with friction.
///
/// The normal contact goes first, for nothing it does depends on friction (the bodies are taken as elastically
/// similar); the tangential contact follows along the depths the normal one has gone through. Of bodies that
/// remember, pieces in one line are one step of the tangential contact.
pub struct FrictionalContact {
    normal: Box<dyn ContactModel>,
    friction: Box<dyn TangentialContact>,
    slide: f64,
    /// Where the tangential contact has been left behind, and the line along which it is to follow.
    behind: Option<(Pose, Straight)>,
}

impl FrictionalContact {
    /// Bodies that just touch.
    #[must_use]
    pub fn new(normal: Box<dyn ContactModel>, friction: Box<dyn TangentialContact>) -> Self {
        Self { normal, friction, slide: 0.0, behind: None }
    }

    fn depth(&self) -> f64 {
        self.normal.state().indentation.unwrap_or(0.0)
    }

    /// Takes the tangential contact along a piece that the normal one has followed from `start`.
    fn drag(&mut self, start: Pose, piece: &Straight) -> Result<Vec<Event>, ContactError> {
        let step = Step {
            contact: self.normal.as_ref(),
            control: Control::Indentation,
            prescribed: [start.indentation, piece.to],
            slide: [start.slide, piece.slide],
            speed: piece.sliding_speed,
            sinking: piece.speed,
            over: piece.duration,
        };
        let sudden = self.friction.follow(&step)?;
        let prescribed = [start.indentation, piece.to];
        Ok(sudden.into_iter().map(|sudden| self.event(prescribed, [start.slide, piece.slide], sudden)).collect())
    }

    /// What is left of the tangential contact where the bodies part with no area left: it has slipped everywhere.
    fn parts(&self, events: &mut [Event], prescribed: [f64; 2], slides: [f64; 2]) {
        let gone = |normal: &Normal| normal.contact_radius == Some(0.0);
        for event in events.iter_mut().filter(|event| gone(&event.before) && gone(&event.after)) {
            let part = (event.at - prescribed[0]) / (prescribed[1] - prescribed[0]);
            let slide = slides[0] + part * (slides[1] - slides[0]);
            event.tangential = Some(Tangential { slide, ..self.friction.state() });
        }
    }

    /// A sudden change of the tangential contact on a step.
    fn event(&self, prescribed: [f64; 2], slides: [f64; 2], Sudden { tangential, normal }: Sudden) -> Event {
        let way = slides[1] - slides[0];
        let part = if way.abs() > 0.0 { (tangential.slide - slides[0]) / way } else { 0.0 };
        let at = prescribed[0] + part * (prescribed[1] - prescribed[0]);
        let normal = normal.unwrap_or_else(|| self.sheared());
        Event { at, before: normal, after: normal, tangential: Some(tangential) }
    }
}

impl ContactModel for FrictionalContact {
    fn follow(&mut self, piece: &Straight) -> Result<Vec<Event>, ContactError> {
        let start = Pose { indentation: self.depth(), slide: self.slide };
        if (piece.to - start.indentation).abs() > 0.0 {
            self.friction.let_go();
        }
        let joined = self.behind.as_ref().and_then(|(from, line)| Some((*from, line.joined_to(*from, piece)?)));
        if joined.is_none() {
            self.settle()?;
        }
        let mut events = self.normal.follow(piece)?;
        self.slide = piece.slide;
        if self.normal.memory().is_some() {
            self.behind = joined.or(Some((start, *piece)));
        } else {
            let onset = self.drag(start, piece)?;
            self.parts(&mut events, [start.indentation, piece.to], [start.slide, piece.slide]);
            events.extend(onset);
        }
        Ok(events)
    }

    fn look(&mut self, piece: &Straight) -> Result<Glance, ContactError> {
        self.normal.look(piece)
    }

    fn state(&self) -> Normal {
        self.normal.state()
    }

    fn joined(&self) -> bool {
        self.normal.joined()
    }

    fn loading(&self) -> Option<Box<dyn Loading + '_>> {
        let normal = self.friction.loading().or_else(|| self.normal.loading())?;
        Some(Box::new(Rubbed { normal, friction: self.friction.as_ref() }))
    }

    fn bed(&self) -> Option<Loaded> {
        match self.friction.loading() {
            Some(sheared) => sheared.loaded(),
            None => self.normal.bed(),
        }
    }

    fn copy(&self) -> Box<dyn ContactModel> {
        let (normal, friction) = (self.normal.copy(), self.friction.copy());
        Box::new(Self { normal, friction, slide: self.slide, behind: self.behind })
    }

    fn tangential(&self) -> Option<Tangential> {
        Some(self.friction.state())
    }

    fn separate(&self) -> Option<(Box<dyn ContactModel>, Box<dyn TangentialBed>)> {
        Some((self.normal.copy(), self.friction.bed()?))
    }

    fn sheared(&self) -> Normal {
        let normal = self.friction.sheared(self.normal.state());
        Normal { dissipated: normal.dissipated + self.friction.relaxed(), ..normal }
    }

    fn settle(&mut self) -> Result<(), ContactError> {
        let Some((start, line)) = self.behind.take() else { return Ok(()) };
        self.drag(start, &line).map(|_| ())
    }

    fn path(&self) -> &[Pose] {
        self.friction.path()
    }

    fn memory(&self) -> Option<Arc<Spectrum>> {
        self.normal.memory()
    }

    fn effort(&self) -> Effort {
        let (normal, friction) = (self.normal.effort(), self.friction.effort());
        let (springs, bytes) = (normal.springs + friction.springs, normal.bytes + friction.bytes);
        Effort { springs, bytes, ..normal }
    }

    fn press(&mut self, pull: &Pull) -> Option<Result<Vec<Event>, ContactError>> {
        let from = self.normal.state().force;
        if (pull.force - from).abs() > 0.0 {
            self.friction.let_go();
        }
        let mut events = match self.normal.press(pull)? {
            Ok(events) => events,
            Err(error) => return Some(Err(error)),
        };
        let step = Step {
            contact: self.normal.as_ref(),
            control: Control::Force,
            prescribed: [from, pull.force],
            slide: [self.slide, pull.slide],
            speed: pull.sliding_speed,
            sinking: 0.0,
            over: pull.duration,
        };
        let sudden = self.friction.follow(&step);
        let slides = [std::mem::replace(&mut self.slide, pull.slide), pull.slide];
        self.parts(&mut events, [from, pull.force], slides);
        Some(sudden.map_err(ContactError::from).map(|sudden| {
            events.extend(sudden.into_iter().map(|sudden| self.event([from, pull.force], slides, sudden)));
            events
        }))
    }

    fn last_depth(&self) -> Option<Result<f64, ContactError>> {
        self.normal.last_depth()
    }

    fn doubt(&self) -> f64 {
        self.normal.doubt()
    }

    fn parting(&self, piece: &Straight) -> Result<Option<Parting>, ContactError> {
        self.normal.parting(piece)
    }

    fn creep(&self) -> Option<Creep> {
        self.normal.creep()
    }

    fn leave(&mut self) -> Option<f64> {
        self.normal.leave()
    }
}

/// A load with the shear of the friction under it.
struct Rubbed<'c> {
    normal: Box<dyn Loading + 'c>,
    friction: &'c dyn TangentialContact,
}

impl Loading for Rubbed<'_> {
    fn contact_radius(&self) -> f64 {
        self.normal.contact_radius()
    }

    fn reach(&self) -> f64 {
        self.normal.reach()
    }

    fn pressure(&self, r: f64) -> Option<f64> {
        self.normal.pressure(r)
    }

    fn surface(&self, r: f64) -> Option<f64> {
        self.normal.surface(r)
    }

    fn stress_intensity(&self) -> Option<f64> {
        self.normal.stress_intensity()
    }

    fn loaded(&self) -> Option<Loaded> {
        self.normal.loaded()
    }

    fn shear(&self, radii: &[f64]) -> Vec<Option<f64>> {
        self.friction.stress(self.normal.as_ref(), radii)
    }
}
