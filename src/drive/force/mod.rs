//! A prescribed force, followed in straight pieces of the depth.
//!
//! # Examples
//! ```
//! use springbed::contact::viscoelastic::continuous::ContinuousContact;
//! use springbed::contact::viscoelastic::memory::Memory;
//! use springbed::drive::force::{Ramp, press};
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use springbed::material::{Relaxation, Spectrum};
//! use std::sync::Arc;
//!
//! // A ball, R = 1, on a Maxwell body, E = τ = 1, pressed by a force that grows: it is met to the accuracy asked for.
//! let body = Arc::new(Spectrum::new(&Relaxation { equilibrium: 0.0, terms: vec![(1.0, 1.0)], viscosity: 0.0 }));
//! let ball = Arc::new(Paraboloid { radius: Length::new(1.0)? });
//! let mut contact = ContinuousContact::new(Memory::new(body, ball));
//! let ramp = Ramp { from: 0.0, rate: 0.1, accuracy: 1e-4, scale: 0.1, stiffness: 0.0 };
//! let states = press(&mut contact, &ramp, &[0.5, 1.0])?;
//! assert!((states[0].force - 0.05).abs() < 1e-5 && (states[1].force - 0.1).abs() < 1e-5);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod lying;
mod search;
#[cfg(test)]
mod tests;

use lying::Lying;
pub use search::speed_to;
use search::{EDGES, Goal, LEAST_DEPTH, UNSEEN, damping};

use crate::contact::creep::Creep;
use crate::contact::error::{BedError, ContactError};
use crate::contact::model::{ContactModel, Straight};
use crate::contact::state::Normal;

/// A prescribed force that goes linearly with time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ramp {
    /// Force at the beginning [N].
    pub from: f64,
    /// Rate [N/s].
    pub rate: f64,
    /// Error of the force between the ends of the pieces, relative to `scale`.
    pub accuracy: f64,
    /// Force against which errors are measured [N], or the forces in balance in an adhesive contact where they are larger.
    pub scale: f64,
    /// The largest force so far over the largest depth [N/m]: a damped contact that is let go grows so soft that the force
    /// no longer tells the depth, which is followed as if it were this stiff; zero where there was no depth.
    pub stiffness: f64,
}

impl Ramp {
    /// The force [N] at the time `t` [s].
    #[must_use]
    pub fn force(&self, t: f64) -> f64 {
        self.from + self.rate * t
    }
}

/// A straight piece of the depth under a prescribed force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// Speed [m/s].
    pub speed: f64,
    /// Time of its end [s].
    pub until: f64,
}

/// A contact under a prescribed force.
///
/// Straight pieces of d(t) that meet the force at their ends; a piece is shortened until the force in its middle and at a
/// quarter of it is met to the accuracy asked for, so the force actually applied differs from the prescribed one by no more
/// than that where it bends once in a piece, or once each way. Where the contact has only grown so far, the
/// ends lie on the exact creep curve. A dashpot jumps with the speed at each corner: pieces of a damped
/// contact meet the force in their middles, the implicit midpoint rule, and follow the depth as closely; at
/// a record it is brought to the speed at which the force is met ([`ForceDrive::met`]).
#[derive(Debug, Clone)]
pub struct ForceDrive {
    ramp: Ramp,
    creep: Option<Creep>,
    end: f64,
    now: f64,
    step: f64,
    parted: bool,
    /// The last piece at whose end no speed met the force, if the way there is still ahead.
    unmet: Option<Unmet>,
    /// By how much the last piece tried from here was too far off, in errors allowed.
    failed: Option<f64>,
    pace: Pace,
    /// The largest depth [m] so far.
    deepest: f64,
    lying: Lying,
    /// Whether the bodies were apart at the beginning of the last piece.
    apart: bool,
}

/// A piece at whose end no speed met the force.
#[derive(Debug, Clone, Copy)]
struct Unmet {
    /// Its end [s].
    at: f64,
    /// How long it was [s].
    duration: f64,
}

/// How the depth has followed the force lately: where the next piece is looked for.
#[derive(Debug, Clone, Copy, Default)]
struct Pace {
    /// Speeds [m/s] of the last two pieces and the times [s] of their middles, the newest first.
    speeds: [Option<(f64, f64)>; 2],
    /// By what the force has grown with the way on the last piece [N/m].
    stiffness: Option<f64>,
}

impl Pace {
    /// The speed [m/s] of a piece whose middle is at the time `t` [s], if all goes on as before.
    fn at(&self, t: f64) -> f64 {
        match self.speeds {
            [Some((now, at)), Some((before, then))] if at > then => now + (now - before) * (t - at) / (at - then),
            [Some((now, _)), _] => now,
            _ => 0.0,
        }
    }

    /// Whether more than one piece has told it.
    fn is_known(&self) -> bool {
        self.speeds[1].is_some()
    }

    fn add(&mut self, speed: f64, middle: f64) {
        self.speeds = [Some((speed, middle)), self.speeds[0]];
    }
}

/// A contact that is looked at, and its state.
type Watched<'c> = (&'c mut dyn ContactModel, &'c Normal);

/// Part of the error allowed by which the force may be missed at the end of a piece.
const NEAR: f64 = 1e-2;
/// The same of the last piece, relative to the largest force.
const NEAREST: f64 = 1e-12;
/// Part of the accuracy to which the speed of a piece is found on which the force jumps: a shorter one follows.
const CLOSE: f64 = 1e-3;
/// Looks for a speed from the pace on, before it is searched for from rest.
const MOST_LOOKS: u32 = 8;
/// Part of what a look was off by that the next one may be off by, if the pace leads there.
const CLOSER: f64 = 0.25;

/// Piece, relative to the whole, at whose end no speed meets the force: the bodies part.
const PARTED: f64 = 1e-12;
/// Part of the time left to where no speed met the force that the next piece may take, and the part of the piece that
/// failed that is left where it tells nothing any more.
const TOWARDS: f64 = 0.3;
const PASSED: f64 = 0.1;
/// Error, in those allowed, of a piece on which the contact jumps.
const FAR: f64 = 16.0;
/// Part of the error of a piece that a shorter one has as well where the contact jumps.
const AS_FAR: f64 = 0.9;
/// The next piece, relative to the one that would just be allowed, and at the least that by which one is shortened.
const SHORTER: f64 = 0.8;
/// The shortest time of a material over the instant in which nothing relaxes.
const AT_ONCE: f64 = 1e20;
/// Shortest piece, relative to the whole.
const SHORTEST: f64 = 1e-18;
/// How far beside a speed that ends before a jump the other side of it is, relative to the speed.
const BESIDE: [f64; 4] = [1e-14, 1e-12, 1e-10, 1e-8];
/// Part that is left of a piece on which the contact jumps.
const BEFORE_JUMP: f64 = 0.1;
/// First piece tried after a jump, relative to the whole.
const AFTER_JUMP: f64 = 1e-3;
/// Parts of a gap by which what closes it stays before the touch: no look along it tells that better, and a contact that
/// follows it may touch earlier by its rounding.
const SHORT_OF: [f64; 4] = [1e-14, 1e-13, 1e-12, 1e-11];
/// No gap is longer than this [m].
const FARTHEST: f64 = 1e9;
/// Part of a way on which bodies that draw each other together have met, and next to nothing presses them.
const MEETING: f64 = 1e-9;
/// Places on a leap at which the contact is looked at.
const LOOKS: u32 = 64;
/// Least force asked for without adhesion, relative to the scale.
const TOUCH: f64 = 1e-9;

impl ForceDrive {
    /// A ramp that lasts `end` [s], along the exact creep of a contact that has only grown so far.
    ///
    /// Bodies that a pull has parted stay where they are until it ends, and their springs recover.
    #[must_use]
    pub fn new(ramp: Ramp, end: f64, creep: Option<Creep>, parted: bool) -> Self {
        let (pace, lying) = (Pace::default(), Lying::Unknown);
        Self {
            ramp,
            creep,
            end,
            now: 0.0,
            step: end,
            parted,
            unmet: None,
            failed: None,
            pace,
            deepest: 0.0,
            lying,
            apart: false,
        }
    }

    /// The exact creep at the time `t` [s] of the ramp, where it is known.
    #[must_use]
    pub fn exact(&self, t: f64) -> Option<Creep> {
        self.creep.as_ref().map(|creep| creep.after(self.ramp.force(t), t))
    }

    /// Time [s] up to which the pieces have been handed out.
    #[must_use]
    pub fn now(&self) -> f64 {
        self.now
    }

    /// Errors are measured against the force `scale` [N] from now on.
    pub fn measure_against(&mut self, scale: f64) {
        self.ramp.scale = scale;
    }

    /// The force prescribed at the time `t` [s].
    #[must_use]
    pub fn prescribed(&self, t: f64) -> f64 {
        self.ramp.force(t)
    }

    /// Whether the bodies have parted: no motion meets the force.
    #[must_use]
    pub fn parted(&self) -> bool {
        self.parted
    }

    /// The next piece from the state `here` on, to be made by the caller; `None` at the end, and where the bodies part. Once
    /// they have been let go the next piece is a rest, in which springs recover, until the force pushes again or ends.
    ///
    /// # Errors
    /// The contact would outgrow the profile.
    pub fn next(&mut self, contact: &mut dyn ContactModel, here: &Normal) -> Result<Option<Stretch>, ContactError> {
        if self.parted
            && let Some(rest) = self.wait()
        {
            return Ok(Some(rest));
        }
        self.deepest = self.deepest.max(depth_of(contact));
        if matches!(self.lying, Lying::Unknown | Lying::Led)
            && let Some(way) = self.closes(contact)?
        {
            return Ok(Some(way));
        }
        if let Some(piece) = self.lies(contact, here) {
            return Ok(Some(piece));
        }
        // Bodies that have drawn each other in have jumped, however little force that was found to take.
        let joined = contact.joined();
        if joined && self.apart {
            (self.step, self.pace) = (self.step.max(AFTER_JUMP * self.end), Pace::default());
        }
        self.apart = !joined;
        while self.now < self.end && !self.parted {
            let last = self.end - self.now <= self.step * (1.0 + 1e-9);
            let until = if last { self.end } else { (self.now + self.step).max(self.now.next_up()) };
            let duration = until - self.now;
            // Where the edge jumps a shorter piece tells when, and the shortest where to.
            let shortest = self.shortest(contact);
            let edges = if duration <= shortest.max(PARTED * self.end) { EDGES } else { 1 };
            let Some(speed) = self.speed((contact, here), until, edges)? else {
                self.parted = duration <= PARTED * self.end;
                self.unmet = Some(Unmet { at: until, duration });
                self.step = 0.03 * duration;
                continue;
            };
            let error = self.error((contact, here), speed, duration)?;
            // Of a piece of two roundings there is none that is shorter by a little.
            let shortest = duration <= shortest || self.now + SHORTER * duration >= until;
            if error > 1.0 && !shortest && !self.is_first_touch(contact, speed * duration) {
                // No piece grows so much on the one before that it would be as far off without a jump, and without one a
                // shorter piece is less off.
                let jumps = self.pace.is_known() && error > FAR || self.failed.is_some_and(|was| error > AS_FAR * was);
                self.failed = Some(error);
                if jumps {
                    self.unmet = Some(Unmet { at: until, duration });
                }
                let part = if jumps { BEFORE_JUMP } else { (SHORTER / error.sqrt()).clamp(1e-3, SHORTER) };
                self.step = if draws(contact, speed, duration)? { SHORTEST * self.end } else { part * duration };
                continue;
            }
            let jumped = shortest && error > 1.0;
            let speed = if jumped { self.over_the_jump((contact, here), speed, until)? } else { speed };
            if jumped {
                self.pace = Pace::default();
            } else {
                self.pace.add(speed, self.now + 0.5 * duration);
            }
            (self.now, self.failed) = (until, None);
            self.step =
                if jumped { AFTER_JUMP * self.end } else { duration * (SHORTER / error.sqrt()).clamp(0.2, 5.0) };
            self.unmet = self.unmet.filter(|unmet| unmet.at - self.now > PASSED * unmet.duration);
            if let Some(unmet) = self.unmet {
                self.step = self.step.min(TOWARDS * (unmet.at - self.now));
            }
            return Ok(Some(Stretch { speed, until }));
        }
        Ok(None)
    }

    /// How short a piece [s] tells when the contact jumps: nothing relaxes in it that would count.
    fn shortest(&self, contact: &dyn ContactModel) -> f64 {
        let fastest = contact.memory().map_or(0.0, |spectrum| AT_ONCE * spectrum.instant());
        let counts = if is_damped(contact) { 0.0 } else { CLOSE * self.ramp.accuracy * fastest.min(self.end) };
        counts.max(SHORTEST * self.end)
    }

    /// The speed on the far side of a jump of the force that a search has come to from either: else the contact stays before
    /// it for ever.
    fn over_the_jump(&self, (contact, here): Watched<'_>, speed: f64, until: f64) -> Result<f64, ContactError> {
        let (force, duration) = (self.target(here, until), until - self.now);
        let mut lacks =
            |speed: f64| Ok::<f64, ContactError>(force - contact.look(&ahead(contact, speed, duration))?.force);
        let lack = lacks(speed)?;
        // The speed is known to a part of itself, and the jump may be as far off.
        for part in BESIDE.into_iter().chain([2.0 * CLOSE * self.ramp.accuracy]) {
            let beyond = speed + part * speed.abs().copysign(lack);
            if lacks(beyond)? * lack < 0.0 {
                return Ok(beyond);
            }
        }
        Ok(speed)
    }

    /// The rest of bodies apart, until the force pushes them together or ends; `None` where there is nothing to wait for.
    fn wait(&mut self) -> Option<Stretch> {
        let pushes = if self.ramp.rate > 0.0 { -self.ramp.from / self.ramp.rate } else { f64::INFINITY };
        // A force that comes back to none at the end does not push by its rounding.
        let pushes = if pushes < self.end * (1.0 - PARTED) { pushes } else { f64::INFINITY };
        let until = pushes.min(self.end);
        (self.parted, self.step, self.pace) = (pushes >= self.end, self.end, Pace::default());
        (until > self.now).then(|| {
            self.now = until;
            Stretch { speed: 0.0, until }
        })
    }

    /// The way of bodies apart to where they all but touch, in no time: a dashpot would feel how fast they come, and a search
    /// that begins so far away would lead bodies that draw each other in beyond where they balance. A dent that is not yet
    /// filled up is part of the way.
    fn closes(&mut self, contact: &mut dyn ContactModel) -> Result<Option<Stretch>, ContactError> {
        if contact.joined() || contact.memory().is_none() || self.parted || self.now >= self.end {
            return Ok(None);
        }
        let until = (self.now + SHORTEST * self.end).max(self.now.next_up());
        let duration = until - self.now;
        let depth = depth_of(contact);
        let meets = |way: f64| match contact.look(&ahead(contact, way / duration, duration)) {
            Ok(seen) => seen.contact_radius > 0.0,
            Err(_) => true,
        };
        let gap = way_to_touch(meets, (-depth).max(LEAST_DEPTH), 0.0);
        let stays_apart = |way: &f64| {
            let mut copy = contact.copy();
            copy.follow(&ahead(contact, way / duration, duration)).is_ok() && !copy.joined()
        };
        let way = SHORT_OF.map(|part| (1.0 - part) * gap).into_iter().find(stays_apart).unwrap_or(0.0);
        Ok((way > LEAST_DEPTH.max(UNSEEN * depth.abs())).then(|| {
            self.now = until;
            Stretch { speed: way / duration, until }
        }))
    }

    /// The one piece of a force that jumps, to be made by the caller: what lies between takes no time. `None` where
    /// the bodies part, or stay parted.
    ///
    /// # Errors
    /// As [`next`](Self::next).
    pub fn leap(&mut self, contact: &mut dyn ContactModel) -> Result<Option<Stretch>, ContactError> {
        if self.parted && self.ramp.force(self.end) <= 0.0 {
            return Ok(None);
        }
        let here = contact.state();
        let speed = self.speed((contact, &here), self.end, EDGES)?;
        self.parted = speed.is_none();
        Ok(speed.map(|speed| Stretch { speed, until: self.end }))
    }

    /// What the force does on its [`leap`](Self::leap) beyond what the contact takes [J]: where the contact would give
    /// way it keeps the force it had.
    ///
    /// # Errors
    /// As [`next`](Self::next).
    pub fn lost_on_leap(&self, contact: &mut dyn ContactModel, leap: Stretch) -> Result<f64, ContactError> {
        let (length, way) = (leap.until / f64::from(LOOKS), leap.speed.signum());
        let (mut kept, mut sum) = (self.ramp.from, 0.0);
        // In the middles: bodies that jump into contact do so at the very beginning.
        for k in 0..LOOKS {
            let force = contact.look(&ahead(contact, leap.speed, length * (f64::from(k) + 0.5)))?.force;
            kept = if way * force > way * kept { force } else { kept };
            sum += way * (kept - force);
        }
        Ok(sum * leap.speed.abs() * length)
    }

    /// An instant at the speed at which a damped contact meets the force of the time `t` [s], to be made by the caller where the
    /// contact is looked at; `None` where pieces meet the force at their ends.
    ///
    /// # Errors
    /// As [`next`](Self::next).
    pub fn met(&self, contact: &mut dyn ContactModel, t: f64) -> Result<Option<Straight>, ContactError> {
        if self.parted || self.exact(t).is_some() || !is_damped(contact) {
            return Ok(None);
        }
        let instant = contact.memory().map_or(0.0, |spectrum| spectrum.instant());
        let force = self.target(&contact.state(), t);
        let speed = speed_to(contact, force, instant)?;
        Ok(speed.map(|speed| ahead(contact, speed, instant)))
    }

    /// Error of the force on a piece over the error allowed, in its middle and before it; of a damped contact that of its chord.
    ///
    /// Beside the exact creep it is that of the depth, F being about d^{3/2}: there the bed need not be asked.
    fn error(&self, (contact, here): Watched<'_>, speed: f64, duration: f64) -> Result<f64, ContactError> {
        let half = 0.5 * duration;
        let middle = self.now + half;
        let allowed = self.allowed((contact, here), middle);
        let off = match self.exact(middle).and_then(|creep| creep.indentation()) {
            // From the speed at its beginning on the depth bends by d″h²/8 away from the chord, d″h/2 = v − v₀; so much
            // towards its end too, or more, where something is met on the way.
            _ if self.meets_in_the_middle(contact) => {
                let bend =
                    (speed - self.pace.at(self.now)).abs().max(self.bend_at_end((contact, here), speed, duration)?);
                0.5 * felt(here).max(self.ramp.stiffness) * bend * half
            }
            Some(depth) if depth > 0.0 => {
                let chord = depth_of(contact) + speed * half;
                1.5 * self.target(here, middle) * (1.0 - chord / depth)
            }
            _ => {
                let mut missed = |part: f64| -> Result<f64, ContactError> {
                    let seen = contact.look(&ahead(contact, speed, part * duration))?.force;
                    Ok(seen - self.target(here, self.now + part * duration))
                };
                let middle = missed(0.5)?;
                // What bends there and back again is nothing in the middle.
                if middle.abs() > allowed { middle } else { middle.abs().max(missed(0.25)?.abs()) }
            }
        };
        Ok(off.abs() / allowed)
    }

    /// By what the speed [m/s] of a damped contact would have to change at the end of a piece to meet the force there.
    fn bend_at_end(&self, (contact, here): Watched<'_>, speed: f64, duration: f64) -> Result<f64, ContactError> {
        let end = contact.look(&ahead(contact, speed, duration))?.force;
        let missed = end - self.target(here, self.now + duration);
        let stiffness = here.stiffness;
        // A dashpot alone: its force is that of the speed.
        let damping = if stiffness > 0.0 { damping(contact, stiffness) } else { (end / speed).abs() };
        let bend = missed.abs() / (damping + 0.5 * stiffness * duration);
        Ok(if bend.is_finite() { bend } else { 0.0 })
    }

    /// Error of the force [N] allowed at the time `t` [s]: the accuracy times the largest force, and of a contact that has
    /// shrunk so much less that its radius is as well known as the largest, for a grows as ∛F.
    ///
    /// A dashpot keeps the depth of a contact whatever its force has become.
    fn allowed(&self, (contact, here): (&dyn ContactModel, &Normal), t: f64) -> f64 {
        let held = here.in_balance();
        let scale = held.max(self.ramp.scale).max(f64::MIN_POSITIVE);
        if self.exact(t).is_some() || is_damped(contact) {
            return self.ramp.accuracy * scale;
        }
        let part = self.target(here, t).abs().max(held) / scale;
        self.ramp.accuracy * scale * part.min(1.0).powf(2.0 / 3.0).max(self.ramp.accuracy.powi(2))
    }

    /// A first piece this short leaves no trace in what follows.
    fn is_first_touch(&self, contact: &dyn ContactModel, rise: f64) -> bool {
        let full = self.exact(self.end).and_then(|creep| creep.indentation());
        !contact.joined() && full.is_some_and(|full| rise <= self.ramp.accuracy * full)
    }

    /// The force to be met at the time `t` [s]: without adhesion the bodies just touch where there is none.
    fn target(&self, here: &Normal, t: f64) -> f64 {
        let (force, least) = (self.ramp.force(t), TOUCH * self.ramp.scale);
        if force.abs() < least && here.stored.surface >= 0.0 { least } else { force }
    }

    /// The speed that leads to the force at the time `until`, over no more than so many places of the edge; `None` if none
    /// does.
    fn speed(&mut self, (contact, here): Watched<'_>, until: f64, edges: u32) -> Result<Option<f64>, ContactError> {
        let duration = until - self.now;
        match self.exact(until) {
            Some(creep) => {
                let depth = creep.indentation().ok_or(BedError::Overloaded { force: creep.force() })?;
                Ok(Some((depth - depth_of(contact)) / duration))
            }
            None => {
                let until = if self.meets_in_the_middle(contact) { self.now + 0.5 * duration } else { until };
                match self.paced((contact, here), until) {
                    Some(speed) => Ok(Some(speed)),
                    None => {
                        let (force, within) = (self.target(here, until), self.within((contact, here), until));
                        let relative =
                            if until - self.now > PARTED * self.end { CLOSE * self.ramp.accuracy } else { 0.0 };
                        Goal { force, within, relative, edges }.speed(contact, here, until - self.now)
                    }
                }
            }
        }
    }

    /// By how much the force [N] may be missed at the time `until` [s].
    fn within(&self, (contact, here): (&dyn ContactModel, &Normal), until: f64) -> f64 {
        let scale = self.ramp.scale.max(here.in_balance());
        if until < self.end { NEAR * self.allowed((contact, here), until) } else { NEAREST * scale }
    }

    /// Whether pieces meet the force in their middles.
    fn meets_in_the_middle(&self, contact: &dyn ContactModel) -> bool {
        self.exact(self.now).is_none() && is_damped(contact)
    }

    /// The same by secants from the pace on; `None` where they lead nowhere soon.
    fn paced(&mut self, (contact, here): Watched<'_>, until: f64) -> Option<f64> {
        let (force, duration) = (self.target(here, until), until - self.now);
        let within = self.within((contact, here), until);
        let stiffness = self.pace.stiffness.unwrap_or(here.stiffness);
        let (mut speed, mut slope) = (self.pace.at(self.now + 0.5 * duration), stiffness * duration);
        let mut before: Option<(f64, f64)> = None;
        for _ in 0..MOST_LOOKS {
            let seen = contact.look(&ahead(contact, speed, duration)).ok()?;
            let off = seen.force - force;
            if let Some((then, was)) = before {
                slope = (off - was) / (speed - then);
            }
            if seen.contact_radius <= 0.0 || slope.is_nan() || slope <= 0.0 {
                return None;
            }
            if off.abs() <= within {
                self.pace.stiffness = Some(slope / duration);
                return Some(speed);
            }
            if before.is_some_and(|(_, was)| off.abs() > CLOSER * was.abs()) {
                return None;
            }
            before = Some((speed, off));
            speed -= off / slope;
        }
        None
    }
}

/// Least force [N] asked for without adhesion, of forces up to `scale` [N]: where there is none the bodies just touch.
pub(super) fn touching(scale: f64) -> f64 {
    TOUCH * scale
}

/// Whether the force of a contact jumps with its speed.
pub(super) fn is_damped(contact: &dyn ContactModel) -> bool {
    contact.joined() && has_dashpot(contact)
}

/// Whether the bodies of a contact have a dashpot of their own, without a spring in a row with it.
fn has_dashpot(contact: &dyn ContactModel) -> bool {
    contact.memory().is_some_and(|spectrum| spectrum.viscosity() > 0.0)
}

/// The longest way [m] on which bodies apart do not yet meet, about as long as `guess` [m], to `within` [m] at the best.
fn way_to_touch(mut meets: impl FnMut(f64) -> bool, guess: f64, within: f64) -> f64 {
    let (mut near, mut far) = (0.0, guess);
    while far < FARTHEST && !meets(far) {
        (near, far) = (far, 2.0 * far);
    }
    while far > LEAST_DEPTH && far - near > within.max(UNSEEN * far) {
        let middle = 0.5 * (near + far);
        *(if meets(middle) { &mut far } else { &mut near }) = middle;
    }
    near
}

/// Depth [m] of a contact.
pub(super) fn depth_of(contact: &dyn ContactModel) -> f64 {
    contact.indentation().unwrap_or(0.0)
}

/// The piece at the speed `speed` [m/s] that lasts `duration` [s] from the present on.
pub(super) fn ahead(contact: &dyn ContactModel, speed: f64, duration: f64) -> Straight {
    Straight { to: depth_of(contact) + speed * duration, speed, slide: 0.0, sliding_speed: 0.0, duration }
}

/// Whether bodies apart jump into contact as they meet: no time is so short that it would not be within it.
fn draws(contact: &mut dyn ContactModel, speed: f64, duration: f64) -> Result<bool, ContactError> {
    Ok(!contact.joined() && contact.look(&ahead(contact, MEETING * speed, duration))?.force < 0.0)
}

/// How much force [N/m] a way is worth: by the stiffness, and where there is none, on a dashpot alone, as a part of the
/// force what the way is of the depth. An edge that pulls is there at no depth too: then of the way on which the force does
/// as much as the surfaces.
fn felt(state: &Normal) -> f64 {
    let force = state.force.abs();
    let pulls = if force > 0.0 { (-state.stored.surface).max(0.0) / force } else { 0.0 };
    let depth = state.indentation.filter(|&depth| depth > 0.0);
    let as_part = depth.map_or(0.0, |depth| force / depth.max(pulls));
    state.stiffness.max(as_part)
}

/// States at the times `records` [s] of a contact under a ramp of the force; the last one ends it.
///
/// # Errors
/// The contact would outgrow the profile.
pub fn press(contact: &mut dyn ContactModel, ramp: &Ramp, records: &[f64]) -> Result<Vec<Normal>, ContactError> {
    let end = records.last().copied().unwrap_or(0.0);
    let mut drive = ForceDrive::new(*ramp, end, None, false);
    let mut states = Vec::with_capacity(records.len());
    let mut now = 0.0;
    loop {
        let here = contact.state();
        let Some(piece) = drive.next(contact, &here)? else { break };
        while let Some(&t) = records.get(states.len()).filter(|&&t| t < piece.until) {
            contact.follow(&ahead(contact, piece.speed, t - now))?;
            now = t;
            states.push(contact.state());
        }
        contact.follow(&ahead(contact, piece.speed, piece.until - now))?;
        now = piece.until;
    }
    states.resize(records.len(), contact.state());
    Ok(states)
}
