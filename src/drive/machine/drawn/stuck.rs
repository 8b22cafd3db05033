//! A mass whose contact sticks, in its middle at least.

use super::super::MachineError;
use super::creeping::{Creep, beyond};
use super::forces::{Approach, Sticking};
use super::{Drawn, DrawnMoment, DrawnState, Phase, TOLERANCE};
use crate::contact::error::ContactError;
use crate::friction::Corner;
use crate::numerics::extrapolation::Stepper;

/// Most turns of the mass between two slips.
const MOST_TURNS: usize = 200_000;
/// Steps between two looks whether the mass has come to rest, and those after which a swing is left out that does not die down.
const LOOKS: usize = 32;
const MOST_STEPS: usize = 2048;
/// Radians of the swing of the mass on its spring up to the next slip from which on its inertia is left out, and those
/// before that slip from which on it is followed again: there the contact gives way within a swing.
const SLOW: f64 = 1000.0;
const RESUMES: f64 = 200.0;
/// Greatest force, relative to the friction, of a swing that has died down.
const STILL: f64 = 1e-11;
/// Shortest step of an approach, relative to all of it.
const COARSEST: f64 = 1e-3;
/// Part of the way that slips a contact as a whole below which there is none left.
const CLOSE: f64 = 1e-13;

impl Drawn {
    fn sticking(&self) -> Sticking<'_> {
        let from = (self.local, self.state.extension);
        Sticking { suspension: self.suspension, memory: &self.memory, drawn: self.drawn, from }
    }

    /// One step of a contact that sticks.
    pub(super) fn stick_on(&mut self, until: f64) -> Result<Option<DrawnMoment>, MachineError> {
        self.steps += 1;
        if self.steps.is_multiple_of(LOOKS) && self.rests()? {
            return Ok(None);
        }
        let ahead = self.direction();
        let corner = self.memory.next_corner(ahead);
        let left = ahead * (corner.slide - self.local);
        if corner.is_last && left <= CLOSE * self.memory.slip_reach() {
            return self.slip(ahead).map(Some);
        }
        let longest = until - self.state.time;
        let near = left <= self.state.speed.abs() * longest.min(self.stepper.next());
        if near && let Some(landed) = self.approach(corner, ahead).filter(|landed| landed.0 <= longest) {
            return self.pass(landed, (corner, ahead));
        }
        let from = [self.local, self.state.speed, self.state.work, self.state.damped];
        let (mut stepper, mut motion) = (self.stepper, self.sticking());
        let Some((step, to)) = stepper.step(&mut motion, &from, longest) else { return Err(self.stalled()) };
        let passes = ahead * (to[0] - corner.slide) > 0.0;
        let turns = from[1] * to[1] < 0.0;
        let turn = if turns { stepper.landing(&mut motion, (&from, &to), (step, 1, 0.0)) } else { None };
        let beyond = turn.is_none_or(|turn| ahead * (turn.1[0] - corner.slide) > 0.0);
        let passed =
            if passes && beyond { stepper.landing(&mut motion, (&from, &to), (step, 0, corner.slide)) } else { None };
        self.stepper = stepper;
        if let Some(landed) = passed {
            return self.pass(landed, (corner, ahead));
        }
        match turn {
            Some(turn) => self.turn(turn)?,
            None => self.moved((step, to), longest, until),
        }
        Ok(None)
    }

    /// Where the mass is going: 1 or −1.
    fn direction(&self) -> f64 {
        if self.state.speed.abs() > 0.0 {
            return self.state.speed.signum();
        }
        let sticking = self.sticking();
        let pulled = sticking.acceleration(0.0, self.local, 0.0);
        if pulled.abs() > 4.0 * sticking.noise() { pulled.signum() } else { 1f64.copysign(self.drawn) }
    }

    /// Whether the mass is in balance, and drawn so slowly that it stays so; it creeps then.
    fn rests(&mut self) -> Result<bool, MachineError> {
        let from = (self.local, self.state.extension, self.state.time);
        let creep = Creep { suspension: self.suspension, drawn: self.drawn, from };
        let ahead = creep.slip_time(&self.memory) - self.state.time;
        if ahead * self.pulse() < SLOW {
            return Ok(false);
        }
        self.remember()?;
        let contact = self.memory.state();
        let forces = (contact.tangential_force, contact.stiffness);
        let energy = beyond(&self.suspension, &self.state, forces, self.drawn);
        let still = STILL * self.memory.limit();
        let dead = energy * (self.suspension.stiffness + contact.stiffness) <= 0.5 * still * still;
        if !dead && self.steps < MOST_STEPS {
            return Ok(false);
        }
        if !dead {
            self.left_out += energy;
        }
        let speed = creep.speed(contact.stiffness);
        self.state.damped += self.suspension.kinetic(self.state.speed) - self.suspension.kinetic(speed);
        self.state.speed = speed;
        self.phase = Phase::Creeps(creep);
        Ok(true)
    }

    /// Frequency [rad/s] of the mass on its spring alone.
    fn pulse(&self) -> f64 {
        (self.suspension.stiffness / self.suspension.mass).sqrt()
    }

    /// On in balance to the time `until` [s], or to shortly before the contact slips as a whole.
    pub(super) fn creep_on(&mut self, until: f64, creep: Creep) -> Result<(), MachineError> {
        let resumes = creep.slip_time(&self.memory) - RESUMES / self.pulse();
        let time = until.min(resumes.max(self.state.time));
        let before = self.energy();
        let to = creep.at(&self.memory, time).map_err(|error| MachineError::Contact(ContactError::from(error)))?;
        let (over, was) = (time - self.state.time, self.state.speed);
        self.state.extension = creep.from.1 + self.drawn * (time - creep.from.2) - (to - creep.from.0);
        (self.local, self.state.slide) = (to, self.offset + to);
        self.state.time = time;
        self.remember()?;
        self.state.speed = creep.speed(self.memory.state().stiffness);
        self.state.damped += self.suspension.damping * over * 0.5 * (was * was + self.state.speed * self.state.speed);
        self.state.work += self.energy() - before;
        if resumes <= until {
            self.phase = Phase::Sticks;
            self.stepper.restart(self.pulse().recip());
        }
        Ok(())
    }

    /// All that is kept or lost of the work of the far end [J].
    fn energy(&self) -> f64 {
        let spring = 0.5 * self.suspension.stiffness * self.state.extension * self.state.extension;
        let contact = self.memory.stored() + self.memory.state().dissipated;
        self.suspension.kinetic(self.state.speed) + spring + contact + self.state.damped
    }

    fn moved(&mut self, (step, to): (f64, [f64; 4]), longest: f64, until: f64) {
        let extension = self.state.extension + self.drawn * step - (to[0] - self.local);
        let time = if step < longest { self.state.time + step } else { until };
        let [slide, speed, work, damped] = to;
        self.local = slide;
        self.state = DrawnState { time, slide: slide + self.offset, speed, extension, work, damped };
    }

    /// The mass turns.
    fn turn(&mut self, (step, to): (f64, [f64; 4])) -> Result<(), MachineError> {
        self.moved((step, to), f64::INFINITY, 0.0);
        self.state.speed = 0.0;
        self.turns += 1;
        if self.turns > MOST_TURNS {
            return Err(MachineError::TooManyTurns { most: MOST_TURNS, time: self.state.time });
        }
        self.remember()
    }

    /// Time and state at the corner, approached in the root of the way to it; `None` where the mass turns before.
    fn approach(&self, corner: Corner, ahead: f64) -> Option<(f64, [f64; 4])> {
        let whole = (ahead * (corner.slide - self.local)).sqrt();
        let mut stepper = Stepper::new(TOLERANCE).no_shorter_than(COARSEST);
        let mut root = whole;
        let mut state = [0.0, self.state.speed, self.state.work, self.state.damped];
        while root > 0.0 {
            let mut motion = Approach { sticking: self.sticking(), corner: corner.slide, ahead, root };
            let (step, next) = stepper.step(&mut motion, &state, root)?;
            root = if step < root { root - step } else { 0.0 };
            state = next;
        }
        let [time, speed, work, damped] = state;
        Some((time, [corner.slide, speed, work, damped]))
    }

    /// The mass comes to a corner of the memory.
    fn pass(
        &mut self,
        landed: (f64, [f64; 4]),
        (corner, ahead): (Corner, f64),
    ) -> Result<Option<DrawnMoment>, MachineError> {
        let (step, [_, speed, work, damped]) = landed;
        self.moved((step, [corner.slide, speed, work, damped]), f64::INFINITY, 0.0);
        self.remember()?;
        if corner.is_last { self.slip(ahead).map(Some) } else { Ok(None) }
    }

    fn stalled(&self) -> MachineError {
        MachineError::Stalled { time: self.state.time }
    }
}
