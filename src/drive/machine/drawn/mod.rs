//! A mass on a contact with friction, drawn along the surface by a spring.

mod creeping;
mod forces;
mod series;
mod stepped;
mod stuck;

pub use stepped::SteppedDrawn;

use super::sliding::Slide;
use super::{DrawnMass, MachineError, Suspension};
use crate::contact::error::ContactError;
use crate::contact::state::Tangential;
use crate::friction::{Pose, TangentialMemory};
use crate::numerics::extrapolation::Stepper;
use creeping::Creep;

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
    /// It slips fastest, which is told of a contact with rate and state.
    Fastest,
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
    /// The displacement in the memory [m].
    local: f64,
    phase: Phase,
    stepper: Stepper,
    turns: usize,
    /// Steps since the last slip.
    steps: usize,
    /// Energy of swings that were left out although they had not died down [J].
    left_out: f64,
}

#[derive(Debug, Clone)]
enum Phase {
    /// The middle at least sticks.
    Sticks,
    /// It does, and the mass is in balance all the time.
    Creeps(Box<Creep>),
    /// All slides, in the direction 1 or −1, since the state at the beginning; it rests after a time [s].
    Slides { ahead: f64, from: DrawnState, slide: Slide, rest: Option<f64> },
}

/// Relative error of a step.
const TOLERANCE: f64 = 1e-13;
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
            local: slide,
            phase,
            stepper,
            turns: 0,
            steps: 0,
            left_out: 0.0,
        }
    }

    /// Whether the contact slides as a whole.
    #[must_use]
    pub fn is_sliding(&self) -> bool {
        matches!(self.phase, Phase::Slides { .. })
    }

    /// Takes the memory to where the mass is.
    fn remember(&mut self) -> Result<(), MachineError> {
        if !self.is_sliding() {
            let indentation = self.memory.position().indentation;
            let to = Pose { indentation, slide: self.local };
            self.memory.advance(to).map_err(|error| MachineError::Contact(ContactError::from(error)))?;
        }
        Ok(())
    }

    /// The contact begins to slide as a whole.
    fn slip(&mut self, ahead: f64) -> Result<DrawnMoment, MachineError> {
        let force = self.memory.state().tangential_force;
        let given = self.memory.give_way(ahead * self.left);
        given.map_err(|error| MachineError::Contact(ContactError::from(error)))?;
        // However far the contact slides, the digits in the memory are those of partial slip.
        let counted = self.memory.position().slide;
        (self.offset, self.local) = (self.offset + (self.local - counted), counted);
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
}

impl DrawnMass for Drawn {
    fn draw(&mut self, speed: f64) {
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

    fn step(&mut self, until: f64) -> Result<Option<DrawnMoment>, MachineError> {
        while self.state.time < until {
            let moment = match &self.phase {
                &Phase::Slides { ahead, from, slide, rest } => self.slide_on(until, (ahead, from, slide, rest))?,
                Phase::Sticks => self.stick_on(until)?,
                Phase::Creeps(creep) => {
                    let creep = creep.clone();
                    self.creep_on(until, &creep)?;
                    None
                }
            };
            if moment.is_some() {
                return Ok(moment);
            }
        }
        self.remember()?;
        Ok(None)
    }

    fn state(&self) -> DrawnState {
        self.state
    }

    fn suspension(&self) -> Suspension {
        self.suspension
    }

    fn tangential(&self) -> Tangential {
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

    fn left_out(&self) -> f64 {
        self.left_out
    }
}
