//! Ways to move a contact: by depth, by force, on a sine, until it parts, by the impact of a mass.
//!
//! A stage is led through a contact of any kind. Of a contact whose state depends on the present alone every
//! record is one straight piece. One that remembers goes through straight pieces chosen before a record is
//! looked at: one for a ramp or a hold, chords of the sine for an oscillation, pieces found by an error
//! estimate for a prescribed force. Records and events cut a piece without bending it.
//!
//! # Examples
//! ```
//! use springbed::contact::adhesion::equilibrium::Control;
//! use springbed::contact::adhesion::line::EdgeLine;
//! use springbed::contact::direct::QuasiStatic;
//! use springbed::drive::Driver;
//! use springbed::drive::course::{Course, Extent, Path};
//! use springbed::contact::foundation::Foundation;
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! // A ball, R = E* = 1, pressed to F = 4/3 in a second: half-way it carries half of that.
//! let ground = Foundation::new(Arc::new(Paraboloid { radius: Length::new(1.0)? }), 1.0);
//! let mut contact = QuasiStatic::new(EdgeLine::new(ground, 0.0));
//! let mut driver = Driver::new(&contact, 1e-6);
//! let (normal, tangential) = (Path::To(4.0 / 3.0), Path::Stay);
//! let course = Course { control: Control::Force, normal, tangential, over: 1.0, extent: Extent::Entry };
//! driver.begin(&mut contact, course, 0.0)?;
//! driver.advance(&mut contact, 0.5)?;
//! assert!((driver.state(&contact).force - 2.0 / 3.0).abs() < 1e-15);
//! driver.advance(&mut contact, 1.0)?;
//! assert!((driver.state(&contact).indentation.unwrap() - 1.0).abs() < 1e-14);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod chords;
pub mod course;
mod cycle;
pub mod force;
mod idle;
pub mod impact;
mod instants;
mod legs;
pub mod machine;
mod parting;
mod piece;

pub use cycle::Loop;

use crate::contact::adhesion::equilibrium::Control;
use crate::contact::creep::Creep;
use crate::contact::error::ContactError;
use crate::contact::model::{ContactModel, Straight};
use crate::contact::state::{Normal, Tangential};
use chords::Chords;
use course::{Course, Extent, Path};
use cycle::Cycle;
use force::{ForceDrive, Ramp, ahead, depth_of};
use legs::Leg;

/// Something that happens between two records, with the state on both sides.
#[derive(Debug, Clone, Copy)]
pub struct Occurrence {
    /// Time since the beginning of the stage [s].
    pub time: f64,
    /// State just before.
    pub before: Normal,
    /// State just after.
    pub after: Normal,
    /// State of the tangential contact.
    pub tangential: Option<Tangential>,
}

/// A contact being led through the stages of a history.
#[derive(Debug, Clone)]
pub struct Driver {
    accuracy: f64,
    /// Exact creep, as long as the contact has only grown under a prescribed force.
    creep: Option<Creep>,
    /// Largest force so far [N], against which errors are measured.
    largest: f64,
    /// Largest depth at the beginning of a stage so far [m].
    deepest: f64,
    /// A pull has parted the bodies.
    parted: bool,
    /// The force [N] prescribed at the end of the present stage; zero where the depth is.
    pull: f64,
    /// What a prescribed force has done in jumps beyond what the contact took [J].
    lost: f64,
    cycle: Cycle,
    stage: ActiveStage,
}

/// The stage a contact is in.
#[derive(Debug, Clone)]
struct ActiveStage {
    course: Course,
    /// What is prescribed, and the tangential displacement [m], at its beginning.
    from: f64,
    slide: f64,
    /// A slide that is a sine, in the chords a contact that remembers takes it in.
    shaken: Option<Chords>,
    /// Time since its beginning [s].
    now: f64,
    remainder: Remainder,
    leg: Option<Leg>,
    /// Force at the beginning of the last chord [N].
    behind: Option<f64>,
    /// Force at the speed of the sine itself [N], at which no chord goes.
    at_speed: Option<f64>,
}

/// Part of the amplitude within which a slide that is a sine is followed: less than friction tells by a thousand springs.
const SHAKEN: f64 = 1e-5;

/// The rest of a stage.
#[derive(Debug, Clone)]
enum Remainder {
    /// From record to record.
    Records,
    /// At constant speed to this depth [m].
    Straight(f64),
    /// Chords of a sine.
    Chords(Chords),
    /// Under a prescribed force.
    Force(Box<ForceDrive>),
    /// A damped contact at no force: the indenter rests on a surface that comes up by itself.
    Idle,
    /// Nothing is left.
    Done,
}

impl ActiveStage {
    /// A stage at its beginning.
    fn new(course: Course, from: f64, slide: f64, remainder: Remainder) -> Self {
        Self { course, from, slide, shaken: None, now: 0.0, remainder, leg: None, behind: None, at_speed: None }
    }

    /// Tangential displacement [m] at the time `t` [s].
    fn slide_at(&self, t: f64) -> f64 {
        if let Some(shaken) = &self.shaken {
            return shaken.at(t);
        }
        let over = self.course.over;
        self.course.tangential.at(self.slide, if over > 0.0 { t / over } else { 1.0 }, over)
    }

    /// Sliding speed u̇_x [m/s] of a stage that slides steadily.
    fn sliding_speed(&self) -> f64 {
        match self.course.tangential {
            Path::To(to) => (to - self.slide) / self.course.over,
            Path::Steady { speed } => speed,
            Path::Stay | Path::Wave(_) | Path::UntilParted { .. } => 0.0,
        }
    }
}

impl Driver {
    /// A driver of a contact that just touches, to the relative accuracy `accuracy`.
    #[must_use]
    pub fn new(contact: &dyn ContactModel, accuracy: f64) -> Self {
        let course = Course {
            control: Control::Indentation,
            normal: Path::Stay,
            tangential: Path::Stay,
            over: 0.0,
            extent: Extent::Entry,
        };
        let stage = ActiveStage::new(course, 0.0, 0.0, Remainder::Done);
        Self {
            accuracy,
            creep: contact.creep(),
            largest: 0.0,
            deepest: 0.0,
            parted: false,
            pull: 0.0,
            lost: 0.0,
            cycle: Cycle::default(),
            stage,
        }
    }

    /// Begins a stage.
    ///
    /// # Errors
    /// The contact cannot follow.
    pub fn begin(&mut self, contact: &mut dyn ContactModel, course: Course, slide: f64) -> Result<(), ContactError> {
        let present = self.corrected(contact, contact.state());
        self.largest = self.largest.max(present.force.abs());
        self.deepest = self.deepest.max(present.indentation.unwrap_or(0.0));
        // Bodies that a pull has parted carry nothing, and the pull goes on.
        let pulled = course.control == Control::Force && present.indentation.is_none();
        let from = if pulled { self.pull } else { prescribed(contact, &present, course.control) };
        self.pull = if course.control == Control::Force { course.normal.at(from, 1.0, course.over) } else { 0.0 };
        let idled = matches!(self.stage.remainder, Remainder::Idle);
        self.stage = ActiveStage::new(course, from, slide, Remainder::Records);
        if contact.memory().is_none() {
            return Ok(());
        }
        if let Path::Wave(wave) = course.tangential {
            self.stage.shaken = Some(Chords::new(slide, wave, course.over, self.accuracy.max(SHAKEN)));
        }
        match course.control {
            Control::Force => self.begin_force(contact, idled)?,
            Control::Indentation => self.begin_depth(contact)?,
        }
        let here = contact.state();
        self.stage.leg = self.next_leg(contact, &here)?;
        Ok(())
    }

    fn begin_depth(&mut self, contact: &mut dyn ContactModel) -> Result<(), ContactError> {
        let course = self.stage.course;
        // What a pull has parted is led from first touch, as elastic bodies are; what is to be parted is so already.
        if self.parted && !matches!(course.normal, Path::UntilParted { .. }) {
            contact.follow(&Straight::between(depth_of(contact), 0.0, 0.0))?;
        }
        (self.creep, self.parted) = (None, false);
        let depth = depth_of(contact);
        self.stage.remainder = match course.normal {
            Path::Wave(wave) => Remainder::Chords(Chords::new(depth, wave, course.over, self.accuracy)),
            Path::To(to) if course.over <= 0.0 => {
                let slide = self.stage.slide_at(course.over);
                contact.follow(&Straight { slide, ..Straight::between(depth, to, 0.0) })?;
                Remainder::Done
            }
            Path::To(to) => Remainder::Straight(to),
            Path::Steady { speed } => Remainder::Straight(depth + speed * course.over),
            Path::Stay | Path::UntilParted { .. } => Remainder::Straight(depth),
        };
        Ok(())
    }

    /// What has `idled` in the stage before goes on so, whether it still touches or not.
    fn begin_force(&mut self, contact: &mut dyn ContactModel, idled: bool) -> Result<(), ContactError> {
        let (course, from) = (self.stage.course, self.stage.from);
        let to = if let Path::To(to) = course.normal { to } else { from };
        self.creep = self.creep.take().filter(|creep| creep.grows_until(to));
        self.largest = self.largest.max(from.abs()).max(to.abs());
        let instant = contact.memory().map_or(0.0, |spectrum| spectrum.instant());
        let duration = if course.over > 0.0 { course.over } else { instant };
        let stiffness = if self.deepest > 0.0 { self.largest / self.deepest } else { 0.0 };
        let (rate, scale) = ((to - from) / duration, self.largest);
        let ramp = Ramp { from, rate, accuracy: self.accuracy, scale, stiffness };
        // A pull does not bring together what only touches.
        if !contact.joined() && from <= 0.0 && to < from {
            contact.leave();
            self.parted = true;
        }
        if course.over > 0.0 && idle::at_no_force((from, to), scale) && (idled || idle::rests(contact)) {
            self.stage.remainder = Remainder::Idle;
            return Ok(());
        }
        let along = self.creep.take();
        self.creep = along.as_ref().map(|creep| creep.after(to, course.over));
        self.stage.remainder = Remainder::Force(Box::new(ForceDrive::new(ramp, duration, along, self.parted)));
        if course.over <= 0.0 { self.leap(contact) } else { Ok(()) }
    }

    /// The whole of a stage that takes no time, under a prescribed force; left to the walk where the bodies part.
    fn leap(&mut self, contact: &mut dyn ContactModel) -> Result<(), ContactError> {
        let Remainder::Force(force) = &mut self.stage.remainder else { return Ok(()) };
        if let Some(stretch) = force.leap(contact)? {
            self.lost += force.lost_on_leap(contact, stretch)?;
            let slide = self.stage.slide_at(self.stage.course.over);
            contact.follow(&Straight { slide, ..ahead(contact, stretch.speed, stretch.until) })?;
            self.stage.remainder = Remainder::Done;
        }
        Ok(())
    }

    /// What is prescribed at the part `part` of the stage: depth [m] or force [N].
    #[must_use]
    pub fn prescribed_at(&self, part: f64) -> f64 {
        self.stage.course.normal.at(self.stage.from, part, self.stage.course.over)
    }

    /// Leads the contact on to the part `part` of the stage; what happens on the way.
    ///
    /// # Errors
    /// The contact cannot follow.
    pub fn advance(&mut self, contact: &mut dyn ContactModel, part: f64) -> Result<Vec<Occurrence>, ContactError> {
        let mut occurrences = Vec::new();
        self.stage.at_speed = None;
        let until = part * self.stage.course.over;
        match self.stage.remainder {
            Remainder::Records => self.step(contact, part, &mut occurrences)?,
            Remainder::Idle => self.idle(contact, until)?,
            Remainder::Straight(_) | Remainder::Chords(_) | Remainder::Force(_) | Remainder::Done => {
                self.walk(contact, until, &mut occurrences)?;
                self.meet(contact, until)?;
            }
        }
        self.stage.now = until;
        contact.settle()?;
        Ok(occurrences)
    }

    /// At the time `until` [s], to the speed at which a damped contact carries what is prescribed.
    fn meet(&mut self, contact: &mut dyn ContactModel, until: f64) -> Result<(), ContactError> {
        self.stage.at_speed = self.at_speed(contact, until)?;
        let Remainder::Force(force) = &self.stage.remainder else { return Ok(()) };
        if let Some(instant) = force.met(contact, until)? {
            let shaken = self.stage.shaken.as_ref().map(|shaken| shaken.speed_until(until));
            let sliding_speed = shaken.unwrap_or_else(|| self.stage.sliding_speed());
            contact.follow(&Straight { slide: self.stage.slide_at(until), sliding_speed, ..instant })?;
        }
        Ok(())
    }

    /// Force [N] of a damped contact at the speed that a sine has at the time `t` [s]: that of a chord differs from it by as
    /// much as the root of the accuracy.
    fn at_speed(&self, contact: &mut dyn ContactModel, t: f64) -> Result<Option<f64>, ContactError> {
        let Path::Wave(wave) = self.stage.course.normal else { return Ok(None) };
        if !force::is_damped(contact) {
            return Ok(None);
        }
        let instant = contact.memory().map_or(0.0, |spectrum| spectrum.instant());
        contact.look(&ahead(contact, wave.speed_at(t), instant)).map(|seen| Some(seen.force))
    }

    /// Present state, with depth and force exact where the creep is.
    #[must_use]
    pub fn state(&self, contact: &dyn ContactModel) -> Normal {
        self.corrected(contact, contact.sheared())
    }

    /// By what part of itself the contact radius may be off at present because a prescribed force is met to the accuracy
    /// asked for only: F grows as a² at least where nothing attracts, so by half the part of the force that is missed, and
    /// by all of it where the force is next to none.
    #[must_use]
    pub fn missed(&self, contact: &dyn ContactModel) -> f64 {
        let Remainder::Force(force) = &self.stage.remainder else { return 0.0 };
        let (told, state) = (force.prescribed(self.stage.now), contact.state());
        let missed = (state.force - told).abs();
        let is_met = self.parted || force.exact(self.stage.now).is_some() || missed <= 0.0;
        if is_met || state.stored.surface < 0.0 { 0.0 } else { (0.5 * missed / told.abs()).min(1.0) }
    }

    fn corrected(&self, contact: &dyn ContactModel, state: Normal) -> Normal {
        let state = Normal { dissipated: state.dissipated + self.lost, ..state };
        if self.parted {
            return Normal { indentation: None, ..state };
        }
        let state = Normal { force: self.stage.at_speed.unwrap_or(state.force), ..state };
        let (Remainder::Force(force), Some(spectrum)) = (&self.stage.remainder, contact.memory()) else { return state };
        let creep = force.exact(self.stage.now);
        let told = |creep: Creep| Some((creep.indented()?, creep));
        let Some(((indentation, place), creep)) = creep.and_then(told) else { return state };
        Normal {
            indentation: Some(indentation),
            force: force.prescribed(self.stage.now),
            contact_radius: Some(creep.profile().contact_radius(place)),
            stiffness: 2.0 * spectrum.instantaneous() * place,
            ..state
        }
    }

    /// The last cycle of the last oscillation of a contact that remembers.
    #[must_use]
    pub fn last_loop(&self) -> Option<Loop> {
        self.cycle.moduli()
    }
}

/// Value of what is prescribed; a body that has come free starts again from first touch.
fn prescribed(contact: &dyn ContactModel, state: &Normal, control: Control) -> f64 {
    match control {
        Control::Indentation => contact.position().unwrap_or(0.0),
        Control::Force => state.force,
    }
}

#[cfg(test)]
mod parting_tests;

#[cfg(test)]
mod tests;
