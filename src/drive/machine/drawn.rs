//! A mass on a contact with friction, drawn along the surface by a spring.

use super::creeping::{Creep, beyond};
use super::sliding::Slide;
use super::{MachineError, Suspension};
use crate::contact::error::ContactError;
use crate::contact::state::Tangential;
use crate::friction::{Corner, Pose, TangentialMemory};
use crate::numerics::extrapolation::{Motion, Stepper};

/// Where the mass is, and what has been done to it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct DrawnState {
    /// Time since the beginning [s].
    pub time: f64,
    /// Tangential displacement x of the mass [m].
    pub slide: f64,
    /// Its speed ẋ [m/s].
    pub speed: f64,
    /// How far the spring is drawn out, X − x [m].
    pub extension: f64,
    /// Work of the far end of the spring so far [J].
    pub work: f64,
    /// Energy lost in the damper so far [J], and in swings that were left out.
    pub damped: f64,
}

/// How a contact changes between stick and slip.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Turnover {
    /// It begins to slide as a whole.
    Slips,
    /// It sticks again.
    Sticks,
}

/// A change between stick and slip, and the state then.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrawnMoment {
    /// What.
    pub what: Turnover,
    /// Where and when.
    pub state: DrawnState,
    /// Force of friction just before [N].
    pub force: f64,
}

/// A mass that a spring draws over a contact: m ẍ + c ẋ + k(x − X) = −F_x, the far end X going on at a steady speed.
///
/// While the contact sticks, in its middle at least, F_x is that of its memory of turning points, and the motion is
/// followed in extrapolated steps that end where the memory loses a turning point and where the mass turns. The last of
/// them is approached in the root of the way left, in which the 3/2 power of Cattaneo and Mindlin is smooth. From there on
/// the contact slides as a whole, under the part `left` = μ_k/μ_s of the force that set it sliding; the motion is then
/// linear, and its end the first zero of a closed form. As it begins to slide, the springs of the contact let go what they
/// carry above μ_k times their load; as it sticks again, they carry that.
/// Check: slow drive, stiff contact, c = 0: jumps of 2(μ_s − μ_k)F/k that last π√(m/k) (Popov, *Contact Mechanics and
/// Friction*, ch. 12).
#[derive(Debug, Clone)]
pub struct Drawn {
    suspension: Suspension,
    memory: TangentialMemory,
    left: f64,
    /// Speed V of the far end [m/s].
    drawn: f64,
    state: DrawnState,
    /// What the displacement is ahead of that in the memory [m].
    offset: f64,
    phase: Phase,
    stepper: Stepper,
    turns: usize,
    /// Steps since the last slip.
    steps: usize,
    /// Energy of swings that were left out although they had not died down [J].
    left_out: f64,
}

#[derive(Debug, Clone, Copy)]
enum Phase {
    /// The middle at least sticks.
    Sticks,
    /// It does, and the mass is in balance all the time.
    Creeps(Creep),
    /// All slides, in the direction 1 or −1, since the state at the beginning; it rests after a time [s].
    Slides { ahead: f64, from: DrawnState, slide: Slide, rest: Option<f64> },
}

/// Relative error of a step.
const TOLERANCE: f64 = 1e-13;
/// Rounding of a force, relative to the greatest friction.
const ROUNDING: f64 = 8.0 * f64::EPSILON;
/// Most turns of the mass between two slips.
const MOST_TURNS: usize = 1_000_000;
/// Steps between two looks whether the mass has come to rest, and those after which a swing is left out that does not die down.
const LOOKS: usize = 32;
const MOST_STEPS: usize = 8192;
/// Radians of the swing of the mass on its spring before the next slip from which on it may be left out: what a mass
/// in balance misses is of the order of the inverse square.
const SLOW: f64 = 1e5;
/// Greatest force, relative to the friction, of a swing that has died down.
const STILL: f64 = 1e-11;
/// Shortest step of an approach, relative to all of it.
const COARSEST: f64 = 1e-3;

/// The forces on a mass whose contact sticks, as a motion in time of displacement, speed, work and loss.
struct Sticking<'m> {
    suspension: Suspension,
    memory: &'m TangentialMemory,
    drawn: f64,
    /// Displacement in the memory and extension of the spring at the beginning of the step [m].
    from: (f64, f64),
}

impl Sticking<'_> {
    fn friction(&self, slide: f64) -> f64 {
        let indentation = self.memory.position().indentation;
        self.memory.force_at(Pose { indentation, slide }).unwrap_or(f64::NAN)
    }

    fn pull(&self, time: f64, slide: f64) -> f64 {
        self.suspension.stiffness * (self.from.1 + self.drawn * time - (slide - self.from.0))
    }

    /// Acceleration [m/s²].
    fn acceleration(&self, time: f64, slide: f64, speed: f64) -> f64 {
        let drag = self.suspension.damping * speed;
        (self.pull(time, slide) - drag - self.friction(slide)) / self.suspension.mass
    }

    /// Greatest rounding of the acceleration [m/s²].
    fn noise(&self) -> f64 {
        let limit = self.memory.limit().max(self.suspension.stiffness * self.from.1.abs());
        ROUNDING * limit / self.suspension.mass
    }
}

impl Motion<4> for Sticking<'_> {
    fn rate(&mut self, time: f64, &[slide, speed, _, _]: &[f64; 4]) -> [f64; 4] {
        let work = self.pull(time, slide) * self.drawn;
        [speed, self.acceleration(time, slide, speed), work, self.suspension.damping * speed * speed]
    }

    fn rounding(&self) -> [f64; 4] {
        [0.0, self.noise(), 0.0, 0.0]
    }
}

/// The same over the root σ of the way to a corner, from σ₀ down: time, speed, work and loss.
struct Approach<'m> {
    sticking: Sticking<'m>,
    corner: f64,
    ahead: f64,
    /// σ at the beginning of the step.
    root: f64,
}

impl Motion<4> for Approach<'_> {
    fn rate(&mut self, since: f64, &[time, speed, _, _]: &[f64; 4]) -> [f64; 4] {
        let root = self.root - since;
        let slide = self.corner - self.ahead * root * root;
        let onwards = self.ahead * speed;
        if onwards <= 0.0 {
            return [f64::NAN; 4];
        }
        let pace = 2.0 * root / onwards;
        let work = self.sticking.pull(time, slide) * self.sticking.drawn;
        let loss = self.sticking.suspension.damping * speed * speed;
        [pace, pace * self.sticking.acceleration(time, slide, speed), pace * work, pace * loss]
    }
}

impl Drawn {
    /// A mass at rest on a contact with the memory `memory`, the spring in balance with its friction; `left` is μ_k/μ_s.
    #[must_use]
    pub fn new(suspension: Suspension, memory: TangentialMemory, left: f64) -> Self {
        let extension = memory.state().tangential_force / suspension.stiffness;
        let slide = memory.position().slide;
        let state = DrawnState { extension, slide, ..DrawnState::default() };
        let (phase, stepper) = (Phase::Sticks, Stepper::new(TOLERANCE));
        Self {
            suspension,
            memory,
            left,
            drawn: 0.0,
            state,
            offset: 0.0,
            phase,
            stepper,
            turns: 0,
            steps: 0,
            left_out: 0.0,
        }
    }

    /// Draws on at the speed `speed` [m/s] from now on.
    pub fn draw(&mut self, speed: f64) {
        self.drawn = speed;
        match self.phase {
            Phase::Slides { ahead, .. } => {
                self.rubbed();
                self.slides(ahead);
            }
            Phase::Creeps(_) => self.phase = Phase::Sticks,
            Phase::Sticks => {}
        }
        self.steps = 0;
        self.stepper.restart(f64::INFINITY);
    }

    /// Where it is.
    #[must_use]
    pub fn state(&self) -> DrawnState {
        self.state
    }

    /// Force of the spring [N].
    #[must_use]
    pub fn pull(&self) -> f64 {
        self.suspension.stiffness * self.state.extension
    }

    /// Whether the contact slides as a whole.
    #[must_use]
    pub fn is_sliding(&self) -> bool {
        matches!(self.phase, Phase::Slides { .. })
    }

    /// State of the contact.
    #[must_use]
    pub fn tangential(&self) -> Tangential {
        let state = self.memory.state();
        let rubbed = match &self.phase {
            Phase::Sticks | Phase::Creeps(_) => 0.0,
            Phase::Slides { from, .. } => (state.tangential_force * (self.state.slide - from.slide)).abs(),
        };
        Tangential {
            slide: self.state.slide,
            force: state.tangential_force,
            stick_radius: if self.is_sliding() { 0.0 } else { state.stick_radius },
            stiffness: if self.is_sliding() { 0.0 } else { state.stiffness },
            stored: Some(self.memory.stored()),
            dissipated: Some(state.dissipated + rubbed),
            area_ratio: None,
        }
    }

    /// On to the time `until` [s], or to the next change between stick and slip, which is told.
    ///
    /// # Errors
    /// The contact cannot follow, or the mass turns too often.
    pub fn step(&mut self, until: f64) -> Result<Option<DrawnMoment>, MachineError> {
        while self.state.time < until {
            let moment = match self.phase {
                Phase::Slides { ahead, from, slide, rest } => self.slide_on(until, (ahead, from, slide, rest))?,
                Phase::Sticks => self.stick_on(until)?,
                Phase::Creeps(creep) => self.creep_on(until, creep)?,
            };
            if moment.is_some() {
                return Ok(moment);
            }
        }
        self.remember()?;
        Ok(None)
    }

    /// Displacement in the memory [m].
    fn local(&self) -> f64 {
        self.state.slide - self.offset
    }

    fn sticking(&self) -> Sticking<'_> {
        let from = (self.local(), self.state.extension);
        Sticking { suspension: self.suspension, memory: &self.memory, drawn: self.drawn, from }
    }

    /// Takes the memory to where the mass is.
    fn remember(&mut self) -> Result<(), MachineError> {
        if !self.is_sliding() {
            let indentation = self.memory.position().indentation;
            let to = Pose { indentation, slide: self.local() };
            self.memory.advance(to).map_err(|error| MachineError::Contact(ContactError::from(error)))?;
        }
        Ok(())
    }

    /// One step of a contact that sticks.
    fn stick_on(&mut self, until: f64) -> Result<Option<DrawnMoment>, MachineError> {
        self.steps += 1;
        if self.steps.is_multiple_of(LOOKS) && self.rests()? {
            return Ok(None);
        }
        let ahead = self.direction();
        let corner = self.memory.next_corner(ahead);
        let left = ahead * (corner.slide - self.local());
        if corner.is_last && left <= CLOSE * self.memory.slip_reach() {
            return self.slip(ahead).map(Some);
        }
        let longest = until - self.state.time;
        let near = left <= self.state.speed.abs() * longest.min(self.stepper.next());
        if near && let Some(landed) = self.approach(corner, ahead).filter(|landed| landed.0 <= longest) {
            return self.pass(landed, (corner, ahead));
        }
        let from = [self.local(), self.state.speed, self.state.work, self.state.damped];
        let (mut stepper, mut motion) = (self.stepper, self.sticking());
        let Some((step, to)) = stepper.step(&mut motion, &from, longest) else { return Err(self.stalled()) };
        let passes = ahead * (to[0] - corner.slide) > 0.0;
        let turns = from[1] * to[1] < 0.0;
        let turn = if turns { stepper.landing(&mut motion, &from, (step, 1, 0.0)) } else { None };
        let beyond = turn.is_none_or(|turn| ahead * (turn.1[0] - corner.slide) > 0.0);
        let passed = if passes && beyond { stepper.landing(&mut motion, &from, (step, 0, corner.slide)) } else { None };
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
        let pulled = sticking.acceleration(0.0, self.local(), 0.0);
        if pulled.abs() > 4.0 * sticking.noise() { pulled.signum() } else { 1f64.copysign(self.drawn) }
    }

    /// Whether the mass is in balance, and drawn so slowly that it stays so; it creeps then.
    fn rests(&mut self) -> Result<bool, MachineError> {
        if self.drawn.abs() <= 0.0 {
            return Ok(false);
        }
        let from = (self.local(), self.state.extension, self.state.time);
        let creep = Creep { suspension: self.suspension, drawn: self.drawn, from };
        let ahead = creep.slip(&self.memory).2 - self.state.time;
        if ahead * (self.suspension.stiffness / self.suspension.mass).sqrt() < SLOW {
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

    /// Energy [J] of swings that were left out although they had not died down.
    #[must_use]
    pub fn left_out(&self) -> f64 {
        self.left_out
    }

    /// On in balance to the time `until` [s], or to where the contact slips as a whole.
    fn creep_on(&mut self, until: f64, creep: Creep) -> Result<Option<DrawnMoment>, MachineError> {
        let (last, extension, time) = creep.slip(&self.memory);
        let fault = |error| MachineError::Contact(ContactError::from(error));
        let slips = time <= until;
        let before = self.energy();
        let (time, to) = if slips { (time, last) } else { (until, creep.at(&self.memory, until).map_err(fault)?) };
        let (over, was) = (time - self.state.time, self.state.speed);
        let drawn_out = creep.from.1 + self.drawn * (time - creep.from.2) - (to - creep.from.0);
        self.state.slide = self.offset + to;
        self.state.time = time;
        self.state.extension = if slips { extension } else { drawn_out };
        self.remember()?;
        self.state.speed = if slips { self.drawn } else { creep.speed(self.memory.state().stiffness) };
        let damped = self.suspension.damping * over * 0.5 * (was * was + self.state.speed * self.state.speed);
        self.state.damped += damped;
        self.state.work += self.energy() - before;
        if slips { self.slip(1f64.copysign(self.drawn)).map(Some) } else { Ok(None) }
    }

    /// All that is kept or lost of the work of the far end [J].
    fn energy(&self) -> f64 {
        let spring = 0.5 * self.suspension.stiffness * self.state.extension * self.state.extension;
        let contact = self.memory.stored() + self.memory.state().dissipated;
        self.suspension.kinetic(self.state.speed) + spring + contact + self.state.damped
    }

    fn moved(&mut self, (step, to): (f64, [f64; 4]), longest: f64, until: f64) {
        let extension = self.state.extension + self.drawn * step - (to[0] - self.local());
        let time = if step < longest { self.state.time + step } else { until };
        let [slide, speed, work, damped] = to;
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
        let whole = (ahead * (corner.slide - self.local())).sqrt();
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

    /// The contact begins to slide as a whole.
    fn slip(&mut self, ahead: f64) -> Result<DrawnMoment, MachineError> {
        let force = self.memory.state().tangential_force;
        let given = self.memory.give_way(ahead * self.left);
        given.map_err(|error| MachineError::Contact(ContactError::from(error)))?;
        (self.turns, self.steps) = (0, 0);
        self.slides(ahead);
        Ok(DrawnMoment { what: Turnover::Slips, state: self.state, force })
    }

    fn slides(&mut self, ahead: f64) {
        let friction = self.memory.state().tangential_force;
        let slide = Slide::new(&self.suspension, (self.pull(), self.state.speed), (friction, self.drawn));
        self.phase = Phase::Slides { ahead, from: self.state, slide, rest: slide.rest(ahead) };
    }

    /// What friction has taken since the slide began, into the memory.
    fn rubbed(&mut self) {
        if let Phase::Slides { from, .. } = self.phase {
            let way = self.state.slide - from.slide;
            self.memory.rub(way);
            self.offset += way;
        }
    }

    /// On in a slide to the time `until` [s], or to its end.
    fn slide_on(
        &mut self,
        until: f64,
        (_, from, slide, rest): (f64, DrawnState, Slide, Option<f64>),
    ) -> Result<Option<DrawnMoment>, MachineError> {
        let rests = rest.filter(|rest| from.time + rest <= until);
        let over = rests.unwrap_or(until - from.time);
        let (way, speed) = slide.at(over);
        let speed = if rests.is_some() { 0.0 } else { speed };
        let force = self.memory.state().tangential_force;
        let Suspension { mass, stiffness, damping } = self.suspension;
        let extension = from.extension + (self.drawn * over - way);
        let work = self.drawn * (mass * (speed - from.speed) + damping * way + force * over);
        let kinetic = 0.5 * mass * (speed - from.speed) * (speed + from.speed);
        let spring = 0.5 * stiffness * (extension - from.extension) * (extension + from.extension);
        let damped = if damping > 0.0 { work - kinetic - spring - force * way } else { 0.0 };
        self.state = DrawnState {
            time: if rests.is_some() { from.time + over } else { until },
            slide: from.slide + way,
            speed,
            extension,
            work: from.work + work,
            damped: from.damped + damped,
        };
        if rests.is_none() {
            return Ok(None);
        }
        self.rubbed();
        self.phase = Phase::Sticks;
        self.stepper.restart(f64::INFINITY);
        Ok(Some(DrawnMoment { what: Turnover::Sticks, state: self.state, force }))
    }

    fn stalled(&self) -> MachineError {
        MachineError::Stalled { time: self.state.time }
    }
}

/// Part of the way that slips a contact as a whole below which there is none left.
const CLOSE: f64 = 1e-13;
