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
pub mod impact;
mod instants;
pub mod machine;

pub use cycle::Loop;

use crate::contact::adhesion::equilibrium::Control;
use crate::contact::creep::Creep;
use crate::contact::error::{BedError, ContactError};
use crate::contact::model::{ContactModel, Pull, Straight};
use crate::contact::state::{Normal, Tangential};
use crate::material::Spectrum;
use chords::Chords;
use course::{Course, Extent, Path};
use cycle::Cycle;
use force::{ForceDrive, Ramp, Stretch, ahead, balanced, depth_of};
use instants::{NotableInstant, Watch, last_of, looks};

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

/// Mean difference of the contact's force from the prescribed one, in errors allowed, from which on it has jumped.
const JUMP: f64 = 4.0;
/// Part of a time by which rounding may delay what was seen to happen.
const LATEST: f64 = 1e-12;

/// A contact being led through the stages of a history.
#[derive(Debug, Clone)]
pub struct Driver {
    accuracy: f64,
    /// Exact creep, as long as the contact has only grown under a prescribed force.
    creep: Option<Creep>,
    /// Largest force so far [N], against which errors are measured.
    largest: f64,
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
    /// Force in the middle of the last chord [N].
    middle: Option<f64>,
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
    Force(ForceDrive),
    /// Nothing is left.
    Done,
}

/// A straight piece of the depth within a stage.
#[derive(Debug, Clone)]
struct Leg {
    from: f64,
    to: f64,
    speed: f64,
    begin: f64,
    end: f64,
    watch: Option<Watch>,
    /// What a contact under a prescribed force has at its beginning.
    outset: Option<Outset>,
}

/// A contact at the beginning of a leg.
#[derive(Debug, Clone, Copy)]
struct Outset {
    /// Energy stored and lost [J].
    accounted: f64,
    joined: bool,
}

impl Leg {
    /// Depth [m] at the time `t` [s] of the stage.
    fn depth(&self, t: f64) -> f64 {
        if t >= self.end { self.to } else { self.from + self.speed * (t - self.begin) }
    }
}

impl ActiveStage {
    /// Tangential displacement [m] at the time `t` [s].
    fn slide_at(&self, t: f64) -> f64 {
        if let Some(shaken) = &self.shaken {
            return shaken.at(t);
        }
        let over = self.course.over;
        self.course.tangential.at(self.slide, if over > 0.0 { t / over } else { 1.0 }, over)
    }

    /// Sliding speed [m/s] of a stage that slides steadily.
    fn sliding_speed(&self) -> f64 {
        match self.course.tangential {
            Path::To(to) => (to - self.slide).abs() / self.course.over,
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
        let stage = ActiveStage {
            course,
            from: 0.0,
            slide: 0.0,
            shaken: None,
            now: 0.0,
            remainder: Remainder::Done,
            leg: None,
            middle: None,
        };
        Self {
            accuracy,
            creep: contact.creep(),
            largest: 0.0,
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
        // Bodies that a pull has parted carry nothing, and the pull goes on.
        let pulled = course.control == Control::Force && present.indentation.is_none();
        let from = if pulled { self.pull } else { prescribed(contact, &present, course.control) };
        self.pull = if course.control == Control::Force { course.normal.at(from, 1.0, course.over) } else { 0.0 };
        let remainder = Remainder::Records;
        self.stage = ActiveStage { course, from, slide, shaken: None, now: 0.0, remainder, leg: None, middle: None };
        if contact.memory().is_none() {
            return Ok(());
        }
        if let Path::Wave(wave) = course.tangential {
            self.stage.shaken = Some(Chords::new(slide, wave, course.over, self.accuracy.max(SHAKEN)));
        }
        match course.control {
            Control::Force => self.begin_force(contact)?,
            Control::Indentation => self.begin_depth(contact)?,
        }
        self.stage.leg = self.next_leg(contact)?;
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

    fn begin_force(&mut self, contact: &mut dyn ContactModel) -> Result<(), ContactError> {
        let (course, from) = (self.stage.course, self.stage.from);
        let to = if let Path::To(to) = course.normal { to } else { from };
        self.creep = self.creep.take().filter(|creep| to >= creep.force());
        self.largest = self.largest.max(from.abs()).max(to.abs());
        let instant = contact.memory().map_or(0.0, |spectrum| spectrum.instant());
        let duration = if course.over > 0.0 { course.over } else { instant };
        let ramp = Ramp { from, rate: (to - from) / duration, accuracy: self.accuracy, scale: self.largest };
        // A pull does not bring together what only touches.
        if !contact.joined() && from <= 0.0 && to < from {
            contact.leave();
            self.parted = true;
        }
        let along = self.creep.take();
        self.creep = along.as_ref().map(|creep| creep.after(to, course.over));
        self.stage.remainder = Remainder::Force(ForceDrive::new(ramp, duration, along, self.parted));
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

    /// The leg of a piece under a prescribed force that begins here.
    fn stretched(&self, contact: &dyn ContactModel, Stretch { speed, until }: Stretch) -> Leg {
        let (from, begin) = (depth_of(contact), self.stage.now);
        let to = from + speed * (until - begin);
        let outset = Outset { accounted: accounted(contact), joined: contact.joined() };
        Leg { from, to, speed, begin, end: until, watch: None, outset: Some(outset) }
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
        let until = part * self.stage.course.over;
        if let Remainder::Records = self.stage.remainder {
            self.step(contact, part, &mut occurrences)?;
        } else {
            self.walk(contact, until, &mut occurrences)?;
            self.meet(contact, until)?;
        }
        self.stage.now = until;
        contact.settle()?;
        Ok(occurrences)
    }

    /// At the time `until` [s], to the speed at which a damped contact carries what is prescribed.
    fn meet(&self, contact: &mut dyn ContactModel, until: f64) -> Result<(), ContactError> {
        let Remainder::Force(force) = &self.stage.remainder else { return Ok(()) };
        if let Some(instant) = force.met(contact, until)? {
            let slide = self.stage.slide_at(until);
            contact.follow(&Straight { slide, ..instant })?;
        }
        Ok(())
    }

    /// One straight piece to the next record.
    fn step(
        &mut self,
        contact: &mut dyn ContactModel,
        part: f64,
        occurrences: &mut Vec<Occurrence>,
    ) -> Result<(), ContactError> {
        let stage = &self.stage;
        let Course { control, normal, tangential, over, .. } = stage.course;
        let (to, slide) = (normal.at(stage.from, part, over), tangential.at(stage.slide, part, over));
        // Of bodies that a pull has parted the state does not know what pulls them.
        let pulled = control == Control::Force && contact.state().indentation.is_none();
        let behind = if over > 0.0 { stage.now / over } else { 0.0 };
        let from =
            if pulled { normal.at(stage.from, behind, over) } else { prescribed(contact, &contact.state(), control) };
        let (duration, sliding_speed) = (part * over - stage.now, stage.sliding_speed());
        let before = contact.tangential();
        let events = match control {
            Control::Indentation => {
                let piece = Straight { slide, sliding_speed, ..Straight::between(from, to, duration) };
                contact.follow(&piece)?
            }
            // Without a push they stay apart.
            Control::Force if pulled && to <= 0.0 => {
                // What rubs is told where it goes all the same.
                let force = to.min(-f64::MIN_POSITIVE);
                let past = before.and_then(|_| contact.press(&Pull { force, slide, sliding_speed, duration }));
                past.unwrap_or_else(|| Ok(Vec::new()))?
            }
            Control::Force => {
                let pull = Pull { force: to, slide, sliding_speed, duration };
                contact.press(&pull).unwrap_or_else(|| Ok(Vec::new()))?
            }
        };
        let time = |at: f64| if (to - from).abs() > 0.0 { ((at - from) / (to - from)).clamp(0.0, 1.0) } else { 0.0 };
        occurrences.extend(events.iter().map(|event| Occurrence {
            time: stage.now + time(event.at) * duration,
            before: event.before,
            after: event.after,
            tangential: event.tangential.or(before),
        }));
        Ok(())
    }

    /// Through the legs of the stage up to the time `until` [s].
    fn walk(
        &mut self,
        contact: &mut dyn ContactModel,
        until: f64,
        occurrences: &mut Vec<Occurrence>,
    ) -> Result<(), ContactError> {
        loop {
            self.walk_legs(contact, until, occurrences)?;
            self.parted &= !contact.joined();
            let Remainder::Force(force) = &self.stage.remainder else { break };
            if self.parted || !force.parted() {
                break;
            }
            occurrences.push(self.let_go(contact, force.now()));
            self.parted = true;
            // What is left of the stage passes for them all the same.
            self.stage.leg = self.next_leg(contact)?;
        }
        Ok(())
    }

    /// Through the legs up to the time `until` [s], as long as the bodies are not to be let go.
    fn walk_legs(
        &mut self,
        contact: &mut dyn ContactModel,
        until: f64,
        occurrences: &mut Vec<Occurrence>,
    ) -> Result<(), ContactError> {
        while let Some(mut leg) = self.stage.leg.take() {
            let stop = until.min(leg.end);
            self.walk_leg(contact, &mut leg, stop, occurrences)?;
            if until < leg.end {
                self.stage.leg = Some(leg);
                break;
            }
            self.stage.now = leg.end;
            self.note_jump(contact, &leg);
            self.stage.leg = self.next_leg(contact)?;
        }
        Ok(())
    }

    /// What the prescribed force has done on a leg that is over beyond what the contact took, if the contact jumped: it
    /// had another force on the way. Bodies that come together have met at no force, and their way until then is none.
    fn note_jump(&mut self, contact: &dyn ContactModel, leg: &Leg) {
        let (Some(outset), Remainder::Force(force)) = (leg.outset, &self.stage.remainder) else { return };
        let mean = 0.5 * (force.prescribed(leg.begin) + force.prescribed(leg.end));
        let way = if outset.joined { leg.to - leg.from } else { 0.0 };
        let lost = mean * way - (accounted(contact) - outset.accounted);
        if lost > JUMP * self.accuracy * self.largest.max(balanced(contact)) * way.abs() {
            self.lost += lost;
        }
    }

    /// Along a leg up to the time `until` [s], from look to look.
    fn walk_leg(
        &mut self,
        contact: &mut dyn ContactModel,
        leg: &mut Leg,
        until: f64,
        occurrences: &mut Vec<Occurrence>,
    ) -> Result<(), ContactError> {
        loop {
            let look = leg.watch.as_ref().and_then(Watch::next_stop).map(|stop| leg.begin + stop);
            let stop = look.unwrap_or(until).min(until);
            while let Some(instant) = leg.watch.as_mut().and_then(|watch| watch.take_until(stop - leg.begin)) {
                let before = match instant.just_before {
                    Some(time) => {
                        self.move_to(contact, leg, leg.begin + time)?;
                        Some(self.state(contact))
                    }
                    None => None,
                };
                let time = self.move_past(contact, leg, &instant, stop)?;
                let after = self.state(contact);
                let before = before.unwrap_or(after);
                occurrences.push(Occurrence { time, before, after, tangential: contact.tangential() });
            }
            self.move_to(contact, leg, stop)?;
            match (look.is_some_and(|look| look <= stop), &mut leg.watch) {
                (true, Some(watch)) => watch.stop(contact)?,
                _ => return Ok(()),
            }
        }
    }

    /// On along a leg until an instant has passed, not beyond `stop` [s]; the time [s] it is then.
    ///
    /// It was found by looking from a little earlier: where bodies touch or part, rounding on the way here may
    /// delay it.
    fn move_past(
        &mut self,
        contact: &mut dyn ContactModel,
        leg: &Leg,
        instant: &NotableInstant,
        stop: f64,
    ) -> Result<f64, ContactError> {
        let mut time = (leg.begin + instant.time).min(stop);
        let mut later = f64::EPSILON * time;
        self.move_to(contact, leg, time)?;
        while let Some(touching) = instant.touching
            && later < LATEST * time
            && (contact.state().contact_radius > Some(0.0)) != touching
        {
            time = (time + later).min(stop);
            later *= 2.0;
            self.move_to(contact, leg, time)?;
        }
        Ok(time)
    }

    /// On along a leg to the time `time` [s], from corner to corner of the slide.
    fn move_to(&mut self, contact: &mut dyn ContactModel, leg: &Leg, time: f64) -> Result<(), ContactError> {
        while self.stage.now < time {
            let corner = self.stage.shaken.as_ref().map_or(time, |shaken| shaken.next_corner(self.stage.now));
            let stop = corner.min(time);
            let (slide, sliding_speed) = (self.stage.slide_at(stop), self.stage.sliding_speed());
            let duration = stop - self.stage.now;
            contact.follow(&Straight { to: leg.depth(stop), speed: leg.speed, slide, sliding_speed, duration })?;
            self.stage.now = stop;
        }
        Ok(())
    }

    /// The next leg of the stage, with a watch over what happens on it.
    fn next_leg(&mut self, contact: &mut dyn ContactModel) -> Result<Option<Leg>, ContactError> {
        let begin = self.stage.now;
        let depth = depth_of(contact);
        let (to, end) = match &mut self.stage.remainder {
            Remainder::Records | Remainder::Done => return Ok(None),
            &mut Remainder::Straight(to) => {
                self.stage.remainder = Remainder::Done;
                (to, self.stage.course.over)
            }
            Remainder::Chords(chords) => match chords.next() {
                Some(chord) => chord,
                None => return Ok(None),
            },
            Remainder::Force(force) => match force.next(contact)? {
                Some(stretch) => return Ok(Some(self.stretched(contact, stretch))),
                None => return Ok(None),
            },
        };
        let speed = (to - depth) / (end - begin);
        let mut leg = Leg { from: depth, to, speed, begin, end, watch: None, outset: None };
        leg.watch = self.watch(contact, &leg)?;
        Ok(Some(leg))
    }

    /// The watch over a leg that begins here.
    fn watch(&mut self, contact: &mut dyn ContactModel, leg: &Leg) -> Result<Option<Watch>, ContactError> {
        let duration = leg.end - leg.begin;
        let Some(spectrum) = contact.memory().filter(|_| duration > 0.0) else { return Ok(None) };
        let Remainder::Chords(chords) = &self.stage.remainder else {
            let times = match self.stage.course.extent {
                Extent::Row => vec![0.5 * duration, duration],
                Extent::Entry => looks(duration, 1e20 * spectrum.instant()),
            };
            return Watch::new(contact, leg.speed, times).map(Some);
        };
        let mut watch = Watch::new(contact, leg.speed, vec![0.5 * duration, duration])?;
        self.cycle.watch(contact, chords, (leg.speed, duration))?;
        // The force of a path with corners turns at the corners more often than between them.
        let here = contact.state().force;
        let middle = watch.first_force_ahead().unwrap_or(here);
        let before = self.stage.middle.replace(middle);
        if before.is_some_and(|before| (here - before) * (here - middle) > 0.0) {
            watch.note_beginning();
        }
        Ok(Some(watch))
    }

    /// The bodies part under a pull, and the indenter is taken away: the pull acts until they do, and until it has done
    /// what springs that give at once do not give of the work of adhesion. The rest of its work is lost.
    fn let_go(&mut self, contact: &mut dyn ContactModel, time: f64) -> Occurrence {
        let (before, had) = (self.state(contact), accounted(contact));
        let last = contact.leave();
        let way = last.zip(before.indentation).map_or(0.0, |(last, depth)| last - depth);
        let spare = before.force * way - (accounted(contact) - had);
        let owed = before.dissipated - self.state(contact).dissipated;
        self.lost += spare.max(owed).max(0.0);
        let after = Normal { indentation: None, ..self.state(contact) };
        Occurrence { time, before, after, tangential: contact.tangential() }
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

    /// Depth [m] at which a retraction from here at the speed `speed` [m/s] parts the bodies.
    ///
    /// # Errors
    /// The contact cannot follow, or the bodies never part: a liquid that is stretched steadily bears v ΣEᵢτᵢ, which may be
    /// less than its edge holds.
    pub fn last_depth(&self, contact: &mut dyn ContactModel, speed: f64) -> Result<f64, ContactError> {
        if let Some(depth) = contact.last_depth() {
            return depth;
        }
        let start = depth_of(contact);
        let held = |contact: &mut dyn ContactModel, time: f64| {
            Ok::<_, ContactError>(contact.look(&ahead(contact, -speed, time))?.contact_radius > 0.0)
        };
        let mut high = start.abs().max(1e-300) / speed;
        let steady = contact.memory().as_deref().and_then(steady_after);
        while held(contact, high)? {
            if steady.is_some_and(|steady| high > steady && high * speed > start.abs()) {
                return Err(BedError::NeverParts { speed }.into());
            }
            high *= 2.0;
        }
        let known = contact.parting(&ahead(contact, -speed, high))?.map(|parting| parting.time);
        let (last, _) = last_of(|time| held(contact, time), (0.0, high), known)?;
        Ok(start - speed * last)
    }

    /// Parts the bodies at the last depth of a retraction at the speed `speed` [m/s]; the state after.
    ///
    /// # Errors
    /// The contact cannot follow.
    pub fn part(&mut self, contact: &mut dyn ContactModel, speed: f64) -> Result<Normal, ContactError> {
        let depth = contact.position().unwrap_or(0.0);
        if contact.memory().is_none() {
            let jumps = contact.follow(&Straight::between(depth, depth.next_down(), 0.0))?;
            let after = jumps.last().map_or_else(|| contact.state(), |jump| jump.after);
            return Ok(Normal { indentation: Some(depth), ..after });
        }
        // On at the same speed for as short a time as it takes.
        let mut duration = f64::EPSILON * self.stage.now;
        while contact.look(&ahead(contact, -speed, duration))?.contact_radius > 0.0 && duration < self.stage.now {
            duration *= 2.0;
        }
        contact.follow(&ahead(contact, -speed, duration))?;
        Ok(Normal { indentation: Some(depth), ..self.state(contact) })
    }

    /// The last cycle of the last oscillation of a contact that remembers.
    #[must_use]
    pub fn last_loop(&self) -> Option<Loop> {
        self.cycle.moduli()
    }
}

/// Parts of the slowest time after which nothing of a start is left, e^−64.
const FADED: f64 = 64.0;

/// The time [s] after which a liquid that is stretched steadily has the same load for ever; `None` of a solid, whose load
/// grows.
fn steady_after(spectrum: &Spectrum) -> Option<f64> {
    let slowest = spectrum.terms().iter().map(|term| term.time).fold(0.0, f64::max);
    (spectrum.equilibrium() <= 0.0).then_some(FADED * slowest)
}

/// Energy stored and lost [J].
fn accounted(contact: &dyn ContactModel) -> f64 {
    let state = contact.state();
    state.stored.stored() + state.dissipated
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
mod tests {
    use super::course::Wave;
    use super::*;
    use crate::contact::viscoelastic::Spectrum;
    use crate::contact::viscoelastic::continuous::ContinuousContact;
    use crate::contact::viscoelastic::growing::GrowingBed;
    use crate::contact::viscoelastic::layout::Layout;
    use crate::contact::viscoelastic::memory::Memory;
    use crate::input::quantity::Length;
    use crate::material::Relaxation;
    use crate::shape::{FlatPunch, Paraboloid, Profile};
    use std::f64::consts::TAU;
    use std::sync::Arc;

    fn by_depth(normal: Path, over: f64) -> Course {
        let (control, tangential) = (Control::Indentation, Path::Stay);
        Course { control, normal, tangential, over, extent: Extent::Entry }
    }

    /// A flat punch is linear: F = F₀ + 2bA(E′ sin ωt + E″ cos ωt) once the start is forgotten.
    #[test]
    fn oscillation_gives_storage_and_loss() {
        let terms = vec![(3.0, 0.05), (2.0, 0.4)];
        let spectrum = Arc::new(Spectrum::new(&Relaxation { equilibrium: 1.0, terms, viscosity: 0.02 }));
        let punch: Arc<dyn Profile> = Arc::new(FlatPunch { radius: Length::new(0.5).unwrap() });
        let layout = Layout::uniform(punch.as_ref(), 0.5, 10);
        let mut bed = GrowingBed::new(spectrum.clone(), punch, layout);
        let mut driver = Driver::new(&bed, 1e-7);
        for course in [by_depth(Path::To(1.0), 1.0), by_depth(Path::Stay, 100.0)] {
            driver.begin(&mut bed, course, 0.0).unwrap();
            driver.advance(&mut bed, 1.0).unwrap();
        }
        let wave = Wave { amplitude: 0.01, frequency: 1.0 };
        // A chord within 1e-7 of the depth spans the angle α; its speed is off by Aωα/2, which a dashpot feels.
        let speed = 0.5 * wave.amplitude * TAU * (8.0 * 1e-7 / wave.amplitude).sqrt();
        driver.begin(&mut bed, by_depth(Path::Wave(wave), 10.0), 0.0).unwrap();
        for k in 1..=400 {
            let t = f64::from(k) / 40.0;
            driver.advance(&mut bed, t / 10.0).unwrap();
            let part = 0.01 * (spectrum.storage(TAU) * (TAU * t).sin() + spectrum.loss(TAU) * (TAU * t).cos());
            let off = driver.state(&bed).force - 1.0 - part;
            assert!(k <= 360 || off.abs() < 6.0 * 1e-7 + 0.02 * speed, "{t}: {off}");
        }
        let found = driver.last_loop().unwrap();
        assert!((found.storage / spectrum.storage(TAU) - 1.0).abs() < 1e-3, "{found:?}");
    }

    /// A ramp cut anywhere into entries, and however many records there are: the same contact, to rounding.
    #[test]
    fn neither_cuts_nor_records_change_a_contact() {
        let terms = vec![(3.0, 0.3), (2.0, 5.0)];
        let spectrum = Arc::new(Spectrum::new(&Relaxation { equilibrium: 1.0, terms, viscosity: 0.0 }));
        let ball: Arc<dyn Profile> = Arc::new(Paraboloid { radius: Length::new(1.0).unwrap() });
        let layout = Layout::graded(ball.as_ref(), (1e-3, 0.1), 500);
        let springs = GrowingBed::new(spectrum.clone(), ball.clone(), layout);
        let continuous = ContinuousContact::new(Memory::new(spectrum, ball));
        let contacts: [Box<dyn ContactModel>; 2] = [Box::new(springs), Box::new(continuous)];
        for contact in contacts {
            let led = |cuts: u32, records: u32| {
                let (mut contact, mut driver) = (contact.copy(), Driver::new(contact.as_ref(), 1e-6));
                for (from, to) in [(0.0, 0.01), (0.01, 0.004), (0.004, 0.009)] {
                    for cut in 1..=cuts {
                        let depth = from + (to - from) * f64::from(cut) / f64::from(cuts);
                        let over = 1.0 / f64::from(cuts);
                        driver.begin(contact.as_mut(), by_depth(Path::To(depth), over), 0.0).unwrap();
                        for k in 1..=records {
                            driver.advance(contact.as_mut(), f64::from(k) / f64::from(records)).unwrap();
                        }
                    }
                }
                contact.state()
            };
            let once = led(1, 1);
            for (cuts, records) in [(1, 97), (7, 1), (5, 13)] {
                let often = led(cuts, records);
                assert!((often.force / once.force - 1.0).abs() < 1e-12, "{cuts} {records}: {often:?} {once:?}");
                let (a, b) = (often.contact_radius.unwrap(), once.contact_radius.unwrap());
                assert!((a / b - 1.0).abs() < 1e-12, "{cuts} {records}: {often:?} {once:?}");
            }
        }
    }
}
