//! The normal contact of bodies that relax, while a mass is drawn along it.

use crate::contact::adhesion::equilibrium::Control;
use crate::contact::error::ContactError;
use crate::contact::model::ContactModel;
use crate::contact::state::Normal;
use crate::drive::Driver;
use crate::drive::course::{Course, Extent, Path};
use crate::run::follow::Run;

/// A normal contact that goes on under the depth or the force the history has left it with.
///
/// It does not ask what goes along the surface. Under a force its depth is a curve in time, which the friction follows in
/// chords.
pub(super) struct Led {
    course: Course,
    slide: f64,
    /// The contact at the beginning and at the end of the present chord.
    here: Place,
    ahead: Place,
    /// Depth at the beginning of the entry [m], and the work of the force before [J].
    from: f64,
    work: f64,
}

/// A contact being led, at a part of an entry.
struct Place {
    part: f64,
    contact: Box<dyn ContactModel>,
    driver: Driver,
}

/// Chords of an entry end where they have this ratio to each other in time, and begin at this part of it: what creeps as the
/// logarithm of the time is then within 1e-4 of its depth.
const RATIO: f64 = 1.1;
const FIRST: f64 = 1e-6;

impl Place {
    fn copy(&self) -> Self {
        Self { part: self.part, contact: self.contact.copy(), driver: self.driver.clone() }
    }

    fn advance(&mut self, part: f64) -> Result<(), ContactError> {
        if part > self.part {
            self.driver.advance(self.contact.as_mut(), part)?;
            self.part = part;
        }
        Ok(())
    }

    fn state(&self) -> Normal {
        self.driver.state(self.contact.as_ref())
    }

    fn depth(&self) -> f64 {
        self.state().indentation.unwrap_or(0.0)
    }
}

impl Led {
    /// The normal contact `contact` of a history, behind it.
    pub(super) fn new(before: &Run, contact: Box<dyn ContactModel>) -> Self {
        let (normal, tangential) = (Path::Stay, Path::Stay);
        let course = Course { control: before.control(), normal, tangential, over: 0.0, extent: Extent::Entry };
        let here = Place { part: 1.0, contact, driver: before.driver().clone() };
        let (slide, from) = (before.slide(), here.depth());
        Self { course, slide, ahead: here.copy(), here, from, work: 0.0 }
    }

    /// Parts of an entry at which a chord of the depth ends, in order, beside those at which a record is asked for.
    pub(super) fn chords(&self) -> Vec<f64> {
        let ends = std::iter::successors(Some(FIRST), |part| Some(RATIO * part)).take_while(|&part| part < 1.0);
        if self.course.control == Control::Force { ends.collect() } else { Vec::new() }
    }

    /// Begins an entry that goes on for `over` [s].
    ///
    /// # Errors
    /// The contact cannot follow.
    pub(super) fn begin(&mut self, over: f64) -> Result<(), ContactError> {
        self.work = self.work_to(self.ahead.depth());
        self.course.over = over;
        self.ahead.driver.begin(self.ahead.contact.as_mut(), self.course, self.slide)?;
        self.ahead.part = 0.0;
        self.here = self.ahead.copy();
        self.from = self.here.depth();
        Ok(())
    }

    /// A chord from the end of the last one to the part `part` of the entry; the speed of the depth along it [m/s].
    ///
    /// # Errors
    /// The contact cannot follow.
    pub(super) fn lead(&mut self, part: f64) -> Result<f64, ContactError> {
        self.here = self.ahead.copy();
        self.ahead.advance(part)?;
        let over = (part - self.here.part) * self.course.over;
        Ok(if over > 0.0 { (self.ahead.depth() - self.here.depth()) / over } else { 0.0 })
    }

    /// State at the part `part` of the entry, on the present chord, and the work of the force so far [J].
    ///
    /// # Errors
    /// The contact cannot follow.
    pub(super) fn at(&self, part: f64) -> Result<(Normal, f64), ContactError> {
        let state = if part >= self.ahead.part {
            self.ahead.state()
        } else {
            let mut place = self.here.copy();
            place.advance(part)?;
            place.state()
        };
        Ok((state, self.work_to(state.indentation.unwrap_or(0.0))))
    }

    /// Work of the force so far where the depth is `depth` [m].
    fn work_to(&self, depth: f64) -> f64 {
        let force = if self.course.control == Control::Force { self.ahead.driver.prescribed_at(1.0) } else { 0.0 };
        self.work + force * (depth - self.from)
    }
}
