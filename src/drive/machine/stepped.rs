//! A mass on a contact that remembers or adheres, along the normal, in straight steps of the depth.

use super::mass::{Happening, MassMoment, MassState};
use super::{Held, MachineError, MovedMass, Suspension};
use crate::contact::error::ContactError;
use crate::contact::model::{ContactModel, Straight};
use crate::drive::force::{ForceDrive, Ramp, Stretch, ahead, depth_of};
use crate::numerics::extrapolation::Stepper;

/// A mass that drives any contact in straight pieces of its depth, in flight on the parabola of its fall.
///
/// In a step of the duration h the depth goes straight, with the mean w of the speeds at both ends:
/// m(v₁ − v₀) = ∫(W − k(d − D) − cw − F)dt, that of the contact along the piece by Simpson's rule. Times w it is the balance
/// of energies, to the error of that rule however long the steps; of second order in h. Steps begin short where the bodies
/// touch, part or the mass turns. A mass that falls on bodies that remember comes to creep, if they are asked about
/// ([`until_it_creeps`](Self::until_it_creeps)): its inertia is next to nothing then, and what it weighs leads the depth.
/// Where bodies that attract each other part, the force goes as the root of the depth that is left: steps halve what is left.
pub struct SteppedMachine<'c> {
    contact: &'c mut dyn ContactModel,
    suspension: Suspension,
    held: Held,
    longest: f64,
    state: MassState,
    /// Time since the last touch or parting [s].
    since: f64,
    /// Acceleration in the last step [m/s²].
    pace: f64,
    steps: usize,
    /// Steps in which the inertia was next to nothing.
    idle: usize,
    /// The largest of it in the second half of these, as a part of the forces in balance: a swing has its most there too.
    left_out: f64,
    /// Error of the force on a mass that creeps, relative to the forces in balance, and the end of its motion [s], if its weight is to
    /// lead it.
    creep: Option<(f64, f64)>,
    creeping: Option<CreepingMass>,
}

/// A mass that creeps: what it weighs leads the depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Creeping {
    /// Time from which on it does [s].
    pub since: f64,
    /// The inertia just before, at its most, as a part of the forces in balance: it is left out.
    pub inertia: f64,
}

/// A mass that creeps, on its way.
struct CreepingMass {
    told: Creeping,
    drive: ForceDrive,
    /// Time since it creeps [s]: a jump to where the weight is borne lasts less than the rounding of that of the motion.
    now: f64,
    /// What is left of a piece in which a record lies.
    piece: Option<Stretch>,
}

/// Inertia, as a part of the forces in balance, that is next to nothing, and for how many steps it must have been so: more
/// than a swing has in a half of it.
const IDLE: f64 = 1e-3;
const IDLE_STEPS: usize = 256;

/// First step, relative to the longest.
const FIRST: f64 = 1e-3;
/// Growth of the steps at first, relative to the time that has passed.
const GROWTH: f64 = 0.2;
/// Change of the mean speed, relative to the speeds in a step, after which the next is of no account.
const SETTLED: f64 = 1e-11;
/// Speed by rounding, relative to that which the push gives in the longest step.
const STILL: f64 = 1e-10;
/// Time before bodies that attract each other part, relative to the longest step, that is gone in one step, and the halvings
/// that tell it from none.
const NEAR: f64 = 1e-4;
const ROUGHLY: usize = 14;
/// Most iterations of a step, halvings of one that parts the bodies, corrections of one that ends where the mass turns.
const MOST: usize = 40;
const HALVINGS: usize = 48;
const CORRECTIONS: usize = 4;
/// Most steps.
const MOST_STEPS: usize = 5_000_000;

impl<'c> SteppedMachine<'c> {
    /// A mass on `contact`, let go from rest where the contact is, or above it at the depth `depth` [m]; no step is
    /// longer than `longest` [s].
    pub fn new(
        contact: &'c mut dyn ContactModel,
        suspension: Suspension,
        held: Held,
        (depth, longest): (f64, f64),
    ) -> Self {
        let state = MassState { depth, ..MassState::default() };
        Self {
            contact,
            suspension,
            held,
            longest,
            state,
            since: 0.0,
            pace: 0.0,
            steps: 0,
            idle: 0,
            left_out: 0.0,
            creep: None,
            creeping: None,
        }
    }

    /// The same; once its inertia is next to nothing its weight alone leads the depth, of a mass that neither a spring nor a
    /// damper holds: it is borne to `accuracy`, relative to the forces in balance, up to the time `end` [s].
    #[must_use]
    pub fn until_it_creeps(self, accuracy: f64, end: f64) -> Self {
        let Suspension { stiffness, damping, .. } = self.suspension;
        let free = stiffness <= 0.0 && damping <= 0.0 && self.held.push > 0.0;
        let creep = (free && self.contact.memory().is_some()).then_some((accuracy, end));
        Self { creep, ..self }
    }

    /// Since when the mass creeps, if it does.
    #[must_use]
    pub fn creeping(&self) -> Option<Creeping> {
        self.creeping.as_ref().map(|creeping| creeping.told)
    }
}

impl MovedMass for SteppedMachine<'_> {
    fn state(&self) -> MassState {
        self.state
    }

    fn contact(&mut self) -> Result<&dyn ContactModel, ContactError> {
        Ok(&*self.contact)
    }

    fn creeps_since(&self) -> Option<f64> {
        self.creeping().map(|creeping| creeping.since)
    }

    fn step(&mut self, until: f64) -> Result<Option<MassMoment>, MachineError> {
        if let Some(creeping) = self.creeping.take() {
            return self.creep(creeping, until).map(|()| None);
        }
        self.steps += 1;
        if self.steps > MOST_STEPS {
            return Err(MachineError::TooManyTurns { most: MOST_STEPS, time: self.state.time });
        }
        let joined = self.contact.joined();
        if self.state.depth < 0.0 && !joined {
            return self.fly(until);
        }
        let short = (GROWTH * self.since + FIRST * self.longest).min(self.longest);
        let left = until - self.state.time;
        let (step, ends) = if short < left { (short, None) } else { (left, Some(until)) };
        let mean = self.mean_speed(step)?;
        let end = self.contact.look(&ahead(self.contact, mean, step))?;
        let touches = end.contact_radius > 0.0;
        let may_part = joined && mean < 0.0 && (end.force < 0.0 || !touches);
        if may_part && let Some(half) = self.halfway(mean, 2.0 * step)?.filter(|&half| half < step) {
            let mean = self.mean_speed(half)?;
            return self.go_on(mean, half, None);
        }
        if joined == touches {
            return self.go_on(mean, step, ends);
        }
        self.turn_over(mean, step, joined)
    }
}

impl SteppedMachine<'_> {
    /// Half of the time [s] after which bodies that pull at each other part, if that is within `step` and not near yet.
    fn halfway(&mut self, mean: f64, step: f64) -> Result<Option<f64>, MachineError> {
        if self.joined_after(mean, step)? {
            return Ok(None);
        }
        let (left, _) = self.change(mean, step, true, ROUGHLY)?;
        let is_far = left > NEAR * self.longest;
        let pulls = is_far && self.contact.look(&ahead(self.contact, mean, left))?.force < 0.0;
        Ok(pulls.then_some(0.5 * left))
    }

    /// The bodies touch or part in a step, which ends there.
    fn turn_over(&mut self, mean: f64, step: f64, joined: bool) -> Result<Option<MassMoment>, MachineError> {
        let (low, high) = self.change(mean, step, joined, HALVINGS)?;
        let mean = if low > 0.0 { self.mean_speed(low)? } else { mean };
        self.go(mean, low, None)?;
        // Over the last bit, in which nothing acts; bodies that by rounding do not touch yet where a look at them did go on.
        let (mut bit, mut left) = (high - low, step - low);
        loop {
            self.contact.follow(&ahead(self.contact, mean, bit))?;
            (self.state.time, self.state.depth) = (self.state.time + bit, depth_of(self.contact));
            left -= bit;
            if joined || self.contact.joined() || left <= 0.0 || bit <= 0.0 {
                break;
            }
            bit *= 2.0;
        }
        // The way differs a little from the one that was looked at.
        if joined && self.contact.joined() {
            self.contact.leave();
        }
        self.since = 0.0;
        let what = if joined { Happening::Parts } else { Happening::Touches };
        Ok((self.contact.joined() != joined).then_some(MassMoment { what, state: self.state }))
    }

    /// A step in which the bodies neither touch nor part; it ends where the mass turns.
    fn go_on(&mut self, mean: f64, step: f64, ends: Option<f64>) -> Result<Option<MassMoment>, MachineError> {
        let from = self.state.speed;
        let to = 2.0 * mean - from;
        // A mass at rest has a speed by rounding alone.
        let still = STILL * self.longest * self.held.push.abs() / self.suspension.mass;
        if from * to >= 0.0 || from.abs() <= still || !self.contact.joined() {
            self.go(mean, step, ends)?;
            return Ok(None);
        }
        let (mut time, mut mean) = (step, mean);
        for _ in 0..CORRECTIONS {
            time *= from / (from - (2.0 * mean - from));
            mean = self.mean_speed(time)?;
        }
        self.go(mean, time, None)?;
        self.state.speed = 0.0;
        Ok(Some(MassMoment { what: Happening::Turns, state: self.state }))
    }

    /// Follows a piece at the mean speed `mean` [m/s].
    fn go(&mut self, mean: f64, step: f64, ends: Option<f64>) -> Result<(), MachineError> {
        if step <= 0.0 {
            return Ok(());
        }
        let MassState { time, depth, speed, damped } = self.state;
        self.contact.follow(&ahead(self.contact, mean, step))?;
        let lost = self.suspension.damping * mean * mean * step;
        self.state = MassState {
            time: ends.unwrap_or(time + step),
            depth: depth + mean * step,
            speed: 2.0 * mean - speed,
            damped: damped + lost,
        };
        self.since += step;
        self.pace = 2.0 * (mean - speed) / step;
        self.rests()
    }

    /// Whether the mass has come to creep: for as long as a swing takes its inertia has been next to nothing beside what
    /// carries it.
    fn rests(&mut self) -> Result<(), MachineError> {
        let Some((accuracy, end)) = self.creep else { return Ok(()) };
        let carried = self.carried()?;
        let inertia = self.suspension.mass * self.pace.abs() / carried;
        self.idle = if inertia <= IDLE && self.contact.joined() { self.idle + 1 } else { 0 };
        self.left_out = if self.idle > IDLE_STEPS / 2 { self.left_out.max(inertia) } else { 0.0 };
        if self.idle >= IDLE_STEPS {
            let inertia = self.left_out;
            let MassState { time: since, depth, .. } = self.state;
            let (from, stiffness) = (self.held.push, carried / depth.abs().max(f64::MIN_POSITIVE));
            let ramp = Ramp { from, rate: 0.0, accuracy, scale: carried, stiffness };
            let drive = ForceDrive::new(ramp, end - since, None, false);
            self.creeping = Some(CreepingMass { told: Creeping { since, inertia }, drive, now: 0.0, piece: None });
        }
        Ok(())
    }

    /// The forces in balance on the mass [N]: its weight, or what the contact bears at rest.
    fn carried(&mut self) -> Result<f64, MachineError> {
        let instant = self.contact.memory().map_or(0.0, |spectrum| spectrum.instant());
        let rest = ahead(self.contact, 0.0, instant);
        Ok(self.contact.look(&rest)?.force.abs().max(self.held.push))
    }

    /// Creeps under its weight to the time `until` [s].
    fn creep(&mut self, mut creeping: CreepingMass, until: f64) -> Result<(), MachineError> {
        creeping.drive.measure_against(self.carried()?);
        let goal = until - creeping.told.since;
        while creeping.now < goal {
            let here = self.contact.state();
            let taken = creeping.piece.take().map(|piece| Ok(Some(piece)));
            let piece = taken.unwrap_or_else(|| creeping.drive.next(self.contact, &here))?;
            let Some(piece) = piece else { break };
            let end = piece.until.min(goal);
            self.contact.follow(&ahead(self.contact, piece.speed, end - creeping.now))?;
            creeping.piece = (piece.until > goal).then_some(piece);
            (creeping.now, self.state.speed) = (end, piece.speed);
        }
        if let Some(met) = creeping.drive.met(self.contact, creeping.now)? {
            self.contact.follow(&met)?;
            self.state.speed = met.speed;
        }
        (self.state.time, self.state.depth) = (until, depth_of(self.contact));
        self.creeping = Some(creeping);
        Ok(())
    }

    /// In flight, up to where the depth is zero again.
    fn fly(&mut self, until: f64) -> Result<Option<MassMoment>, MachineError> {
        let Suspension { mass, damping, .. } = self.suspension;
        let (suspension, held) = (self.suspension, self.held);
        let mut motion = |_: f64, &[depth, speed, _]: &[f64; 3]| {
            let drag = damping * speed;
            [speed, (suspension.push(held, depth) - drag) / mass, drag * speed]
        };
        let MassState { time, depth, speed, damped } = self.state;
        let (mut stepper, from) = (Stepper::new(1e-13), [depth, speed, damped]);
        let stalled = MachineError::Stalled { time };
        let (step, to) = stepper.step(&mut motion, &from, until - time).ok_or(stalled)?;
        let lands = to[0] >= 0.0;
        let (step, to) =
            if lands { stepper.landing(&mut motion, (&from, &to), (step, 0, 0.0)).ok_or(stalled)? } else { (step, to) };
        let depth = if lands { 0.0 } else { to[0] };
        let present = depth_of(self.contact);
        let piece = ahead(self.contact, (depth - present) / step, step);
        self.contact.follow(&Straight { to: depth, ..piece })?;
        let time = if step < until - time { time + step } else { until };
        self.state = MassState { time, depth, speed: to[1], damped: to[2] };
        self.since = 0.0;
        // An adhesive contact joins where the bodies touch.
        let what = Happening::Touches;
        Ok((lands && self.contact.joined()).then_some(MassMoment { what, state: self.state }))
    }

    /// Mean speed [m/s] of a step of the duration `step` [s].
    fn mean_speed(&mut self, step: f64) -> Result<f64, MachineError> {
        let from = self.state.speed;
        let scale =
            from.abs() + step * (self.held.push.abs() + self.contact.state().force.abs()) / self.suspension.mass;
        let mut mean = from + 0.5 * self.pace * step;
        let mut last: Option<(f64, f64)> = None;
        for _ in 0..MOST {
            let miss = from + 0.5 * self.impulse(mean, step)? / self.suspension.mass - mean;
            let slope = last.map_or(-1.0, |(before, was)| (miss - was) / (mean - before));
            last = Some((mean, miss));
            let better = mean - miss / if slope.is_finite() && slope < -0.5 { slope } else { -1.0 };
            let settled = (better - mean).abs() <= SETTLED * scale;
            mean = better;
            if settled {
                break;
            }
        }
        Ok(mean)
    }

    /// ∫(W − k(d − D) − cw − F)dt [N s] over a piece at the speed `mean` [m/s].
    fn impulse(&mut self, mean: f64, step: f64) -> Result<f64, MachineError> {
        let mut force = |part: f64| {
            let piece = ahead(self.contact, mean, part * step);
            Ok::<_, MachineError>(self.contact.look(&piece)?.force)
        };
        // A dashpot takes the new speed on at once: the beginning is just after it.
        let held = step / 6.0 * (force(f64::EPSILON)? + 4.0 * force(0.5)? + force(1.0)?);
        let outside =
            self.suspension.push(self.held, self.state.depth + 0.5 * mean * step) - self.suspension.damping * mean;
        Ok(step * outside - held)
    }

    fn joined_after(&mut self, mean: f64, step: f64) -> Result<bool, MachineError> {
        let piece = ahead(self.contact, mean, step);
        Ok(self.contact.look(&piece)?.contact_radius > 0.0)
    }

    /// The last time in a step at which the bodies are `joined` as they are now, and the first at which they are not.
    fn change(&mut self, mean: f64, step: f64, joined: bool, halvings: usize) -> Result<(f64, f64), MachineError> {
        let (mut low, mut high) = (0.0, step);
        for _ in 0..halvings {
            let middle = 0.5 * (low + high);
            *(if self.joined_after(mean, middle)? == joined { &mut low } else { &mut high }) = middle;
        }
        Ok((low, high))
    }
}
