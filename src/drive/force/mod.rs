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

mod apart;
mod error;
mod lying;
mod pace;
mod search;
#[cfg(test)]
mod tests;

use apart::draws;
use lying::Lying;
use pace::Pace;
pub use search::speed_to;
use search::{EDGES, Found};

use crate::contact::creep::Creep;
use crate::contact::error::ContactError;
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
    /// How long the last piece was [s], and its error, in those allowed.
    last: Option<(f64, f64)>,
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

/// A contact that is looked at, and its state.
type Watched<'c> = (&'c mut dyn ContactModel, &'c Normal);

/// Part of the accuracy to which the speed of a piece is found on which the force jumps: a shorter one follows.
const CLOSE: f64 = 1e-3;

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
/// The most by which a piece may last longer than the one before.
const LONGER: f64 = 5.0;
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
            last: None,
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
            let is_short = duration <= shortest.max(PARTED * self.end);
            // Behind a dashpot the force is that of the speed, and no shorter piece shows more of it.
            let edges = if is_short || is_damped(contact) { EDGES } else { 1 };
            // Of a piece of two roundings there is none that is shorter by a little.
            let shortest = duration <= shortest || self.now + SHORTER * duration >= until;
            let tells_jumps = joined && !is_short && !shortest && self.pace.is_known();
            let speed = match self.speed((contact, here), until, (edges, tells_jumps))? {
                Found::Speed(speed) => speed,
                Found::Jump => {
                    self.unmet = Some(Unmet { at: until, duration });
                    self.step = BEFORE_JUMP * duration;
                    continue;
                }
                Found::Parted => {
                    self.parted = duration <= PARTED * self.end;
                    self.unmet = Some(Unmet { at: until, duration });
                    self.step = 0.03 * duration;
                    continue;
                }
            };
            let error = self.error((contact, here), speed, duration)?;
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
            self.step = if jumped { AFTER_JUMP * self.end } else { duration * self.lengthened(duration, error) };
            self.last = Some((duration, error)).filter(|_| !jumped);
            self.unmet = self.unmet.filter(|unmet| unmet.at - self.now > PASSED * unmet.duration);
            if let Some(unmet) = self.unmet {
                self.step = self.step.min(TOWARDS * (unmet.at - self.now));
            }
            return Ok(Some(Stretch { speed, until }));
        }
        Ok(None)
    }

    /// Part of a piece made with the error `error`, in those allowed, that the next one may last. Where a shorter one is as far
    /// off as the one before, the contact stands before a jump, and no length is to blame.
    fn lengthened(&self, duration: f64, error: f64) -> f64 {
        let in_vain = self.last.is_some_and(|(longer, was)| duration < longer && error > AS_FAR * was);
        if in_vain && error > SHORTER * SHORTER { LONGER } else { (SHORTER / error.sqrt()).clamp(0.2, LONGER) }
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
        let found = self.speed((contact, &here), self.end, (EDGES, false))?;
        self.parted = found == Found::Parted;
        Ok(if let Found::Speed(speed) = found { Some(Stretch { speed, until: self.end }) } else { None })
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

/// Depth [m] of a contact.
pub(super) fn depth_of(contact: &dyn ContactModel) -> f64 {
    contact.indentation().unwrap_or(0.0)
}

/// The piece at the speed `speed` [m/s] that lasts `duration` [s] from the present on.
pub(super) fn ahead(contact: &dyn ContactModel, speed: f64, duration: f64) -> Straight {
    Straight { to: depth_of(contact) + speed * duration, speed, slide: 0.0, sliding_speed: 0.0, duration }
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
