//! A mass whose contact sticks, in its middle at least.

use super::super::MachineError;
use super::creeping::Creep;
use super::forces::{Approach, Sticking};
use super::series::Series;
use super::{Drawn, DrawnMoment, DrawnState, Phase, TOLERANCE};
use crate::friction::Corner;
use crate::numerics::extrapolation::Stepper;

/// Most turns of the mass between two slips.
const MOST_TURNS: usize = 200_000;
/// Steps between two looks whether the mass has come to rest.
const LOOKS: usize = 32;
/// A swing that has not died down after so many steps is left out where more radians of it lie before the next slip.
const MOST_STEPS: usize = 2048;
const MOST_SWINGS: f64 = 2e5;
/// Greatest force, relative to the friction, of a swing that has died down.
const STILL: f64 = 1e-11;
/// Radians of the fastest swing that a step may take.
const HALF_SWING: f64 = 2.5;
/// A mass surely comes to a corner if it keeps more than 1 over this of its speed.
const SURE: f64 = 2.0;
/// Shortest step of an approach, relative to all of it.
const COARSEST: f64 = 1e-3;
/// Part of the way that slips a contact as a whole below which there is none left.
const CLOSE: f64 = 1e-13;

/// The end of a step: its duration [s], and way, speed, work and loss.
type End = (f64, [f64; 4]);

/// How a step ends.
enum Step {
    /// At a corner of the memory.
    Passes(End),
    /// Where the mass turns.
    Turns(End),
    /// Anywhere.
    Goes(End),
}

impl Drawn {
    /// The forces while the mass goes on in the direction `ahead`, 1 or −1.
    fn sticking(&self, ahead: f64) -> Sticking<'_> {
        let (memory, suspension, drawn) = (&self.memory, self.suspension, self.drawn);
        let from = (self.local - memory.position().slide, self.state.extension);
        Sticking { suspension, memory, branch: memory.branch(ahead), drawn, from }
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
        if corner.is_last
            && self.surely_comes(left, ahead)
            && let Some(landed) = self.approach(left, ahead).filter(|landed| landed.0 <= longest)
        {
            return self.pass(landed, (corner, ahead));
        }
        let Some(step) = self.one_step(longest, (left, ahead)) else { return Err(self.stalled()) };
        match step {
            Step::Passes(landed) => return self.pass(landed, (corner, ahead)),
            Step::Turns(turn) => self.turn(turn)?,
            Step::Goes(end) => self.moved(end, longest, until),
        }
        Ok(None)
    }

    /// Whether a mass the way `left` [m] before the last corner, in the direction `ahead`, gets there within a step, whatever
    /// the friction does on the way: it grows up to there.
    fn surely_comes(&self, left: f64, ahead: f64) -> bool {
        let (sticking, speed) = (self.sticking(ahead), self.state.speed.abs());
        let suspension = self.suspension;
        let over = SURE * left / speed;
        let pulled = ahead * sticking.pull(0.0, ahead * left) - suspension.stiffness * self.drawn.abs() * over;
        let held = self.memory.limit() + suspension.damping * speed - pulled;
        let end = speed * speed - 2.0 * held / suspension.mass * left;
        over <= SURE * HALF_SWING * sticking.radian() && end > speed * speed / (SURE * SURE)
    }

    /// One step of at most `longest` [s], before a corner the way `left` [m] ahead.
    fn one_step(&mut self, longest: f64, (left, ahead): (f64, f64)) -> Option<Step> {
        let sticking = self.sticking(ahead);
        let Some(series) = Series::new(&sticking, self.state.speed) else {
            return self.extrapolated(longest, (left, ahead));
        };
        let step = series.reach().min(longest);
        let at = |time: f64| {
            let [way, speed, work, damped] = series.at(time);
            (time, [way, speed, self.state.work + work, self.state.damped + damped])
        };
        let turn = series.turns(step, ahead).map(at);
        let end = turn.unwrap_or_else(|| at(step));
        if ahead * end.1[0] > left {
            let mut landed = at(series.meets(ahead * left, end.0));
            landed.1[0] = ahead * left;
            return Some(Step::Passes(landed));
        }
        Some(if turn.is_some() { Step::Turns(end) } else { Step::Goes(end) })
    }

    /// The same by extrapolation, whatever the load.
    fn extrapolated(&mut self, longest: f64, (left, ahead): (f64, f64)) -> Option<Step> {
        let from = [0.0, self.state.speed, self.state.work, self.state.damped];
        let (mut stepper, mut motion) = (self.stepper, self.sticking(ahead));
        let most = longest.min(HALF_SWING * motion.radian());
        let (step, to) = stepper.step(&mut motion, &from, most)?;
        // A mass may turn twice in a step, and a loop of the memory with it.
        let dip = if from[1] * to[1] > 0.0 { stepper.dip(&mut motion, (&from, &to), (step, 1)) } else { None };
        let (step, to) = dip.unwrap_or((step, to));
        let turns = ahead * to[1] < 0.0;
        let turn = if turns { stepper.landing(&mut motion, (&from, &to), (step, 1, 0.0)) } else { None };
        // It may turn behind the corner, and be back before it at the end of the step.
        let (over, end) = turn.unwrap_or((step, to));
        let passes = ahead * end[0] > left;
        let passed = if passes { stepper.landing(&mut motion, (&from, &end), (over, 0, ahead * left)) } else { None };
        self.stepper = stepper;
        Some(passed.map(Step::Passes).or(turn.map(Step::Turns)).unwrap_or(Step::Goes((step, to))))
    }

    /// Where the mass is going: 1 or −1.
    fn direction(&self) -> f64 {
        if self.state.speed.abs() > 0.0 {
            return self.state.speed.signum();
        }
        let sticking = self.sticking(1f64.copysign(self.drawn));
        let pulled = sticking.acceleration(0.0, 0.0, 0.0);
        if pulled.abs() > 4.0 * sticking.noise() { pulled.signum() } else { 1f64.copysign(self.drawn) }
    }

    /// Whether the mass has ceased to swing, and is drawn so slowly that it stays so; it creeps then.
    fn rests(&mut self) -> Result<bool, MachineError> {
        self.remember()?;
        let DrawnState { extension, time, .. } = self.state;
        let creep = Creep::new((self.suspension, self.drawn), &self.memory, (extension, time))?;
        if !creep.is_long() {
            return Ok(false);
        }
        let (slide, speed) = creep.at(time);
        let stiffness = self.suspension.stiffness + self.memory.stuck();
        let (off, fast) = (self.local - slide, self.state.speed - speed);
        let energy = self.suspension.kinetic(fast) + 0.5 * stiffness * off * off;
        let still = STILL * self.memory.limit();
        if energy * stiffness <= 0.5 * still * still {
            self.state.damped += self.suspension.kinetic(self.state.speed) - self.suspension.kinetic(speed);
            self.state.speed = speed;
            self.phase = Phase::Creeps(Box::new(creep));
            return Ok(true);
        }
        if self.steps >= MOST_STEPS && creep.swings() > MOST_SWINGS {
            self.left_out += energy;
            self.still(slide, speed)?;
        }
        Ok(false)
    }

    /// Takes the mass to where it would be if it did not swing; what energy is set free is lost.
    fn still(&mut self, slide: f64, speed: f64) -> Result<(), MachineError> {
        let before = self.energy();
        self.state.extension += self.local - slide;
        (self.local, self.state.slide, self.state.speed) = (slide, self.offset + slide, speed);
        self.remember()?;
        self.state.damped += before - self.energy();
        self.steps = 0;
        self.stepper.restart(f64::INFINITY);
        Ok(())
    }

    /// On in balance to the time `until` [s], or to shortly before the balance changes within a swing.
    pub(super) fn creep_on(&mut self, until: f64, creep: &Creep) -> Result<(), MachineError> {
        let resumes = creep.resumes();
        let time = until.min(resumes.max(self.state.time));
        let before = self.energy();
        let (to, speed) = creep.at(time);
        let (over, was) = (time - self.state.time, self.state.speed);
        self.state.extension += self.drawn * over - (to - self.local);
        (self.local, self.state.slide) = (to, self.offset + to);
        (self.state.time, self.state.speed) = (time, speed);
        self.remember()?;
        self.state.damped += self.suspension.damping * over * 0.5 * (was * was + speed * speed);
        self.state.work += self.energy() - before;
        if resumes <= until {
            self.phase = Phase::Sticks;
            self.stepper.restart(f64::INFINITY);
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
        let [way, speed, work, damped] = to;
        let extension = self.state.extension + (self.drawn * step - way);
        let time = if step < longest { self.state.time + step } else { until };
        self.local += way;
        self.state = DrawnState { time, slide: self.local + self.offset, speed, extension, work, damped };
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

    /// Time and state at a corner the way `whole` [m] ahead, approached in the root of it; `None` where the mass turns before.
    fn approach(&self, whole: f64, ahead: f64) -> Option<(f64, [f64; 4])> {
        let mut stepper = Stepper::new(TOLERANCE).no_shorter_than(COARSEST);
        let mut root = whole.sqrt();
        let mut state = [0.0, self.state.speed, self.state.work, self.state.damped];
        while root > 0.0 {
            let mut motion = Approach { sticking: self.sticking(ahead), whole, ahead, root };
            let (step, next) = stepper.step(&mut motion, &state, root)?;
            root = if step < root { root - step } else { 0.0 };
            state = next;
        }
        let [time, speed, work, damped] = state;
        Some((time, [ahead * whole, speed, work, damped]))
    }

    /// The mass comes to a corner of the memory.
    fn pass(
        &mut self,
        landed: (f64, [f64; 4]),
        (corner, ahead): (Corner, f64),
    ) -> Result<Option<DrawnMoment>, MachineError> {
        self.moved(landed, f64::INFINITY, 0.0);
        (self.local, self.state.slide) = (corner.slide, self.offset + corner.slide);
        self.remember()?;
        if corner.is_last { self.slip(ahead).map(Some) } else { Ok(None) }
    }

    fn stalled(&self) -> MachineError {
        MachineError::Stalled { time: self.state.time }
    }
}
