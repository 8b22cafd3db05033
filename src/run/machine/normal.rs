//! A mass that swings or bounces on the contact.

use super::bounces::{self, Bounce};
use super::{Errors, Moved, failed};
use crate::contact::state::Normal;
use crate::drive::machine::{GRAVITY, Happening, Held, Mass, MassMoment, MassState, MovedMass, Suspension};
use crate::numerics::extremum::{Peak, top_through};
use crate::run::SimulationError;
use crate::run::follow::Run;
use crate::run::named::Named;
use crate::run::record::{MachineState, Record};
use crate::run::unit::Unit;
use crate::scene::history::{MachineEntry, MachineMotion};
use crate::scene::law::MachineLaw;
use std::f64::consts::{PI, TAU};

/// Most moments between the records asked for that are recorded too.
const MOST_MOMENTS: usize = 20_000;
/// Most swings or bounces that are followed.
const MOST_TIMES: f64 = 5e4;
/// Greatest speed of a mass that lies, relative to that of its fall.
const LIES: f64 = 1e-5;

/// A motion being recorded.
#[derive(Clone)]
pub(super) struct Motion<'r> {
    pub(super) entry: MachineEntry,
    pub(super) suspension: Suspension,
    pub(super) held: Held,
    /// Time at which the entry begins [s].
    begin: f64,
    /// Where the mass is let go [m].
    pub(super) from: f64,
    /// Speed of the fall at first touch [m/s]; zero of a mass that swings.
    pub(super) fall: f64,
    /// Energy there is at the beginning, contact and spring [J].
    initial: f64,
    pub(super) before: &'r Record,
    records: Vec<Record>,
    moments: Vec<MassMoment>,
    bounces: Vec<Bounce>,
    errors: Errors,
    pull: StrongestPull,
}

/// The strongest pull on the way out, which records pass by.
#[derive(Debug, Clone, Default)]
struct StrongestPull {
    /// Time [s] and pull [N] at the ends of the last steps on the way out.
    steps: Vec<Peak>,
    /// The greatest so far [N].
    greatest: Option<f64>,
}

impl StrongestPull {
    /// A step has ended at the time `time` [s] under the force `force` [N], on the way `out` or not.
    fn note(&mut self, time: f64, force: f64, out: bool) {
        if !out {
            self.steps.clear();
            return;
        }
        self.steps.push(Peak { place: time, value: -force });
        let [.., first, second, third] = self.steps[..] else { return };
        if third.value > 0.0 {
            let top = top_through([first, second, third]).map(|top| top.value);
            self.greatest = [self.greatest, top].into_iter().flatten().reduce(f64::max);
        }
        self.steps.drain(..self.steps.len().saturating_sub(2));
    }
}

/// Moves the mass of a machine along the normal.
///
/// # Errors
/// The bodies are apart, or the motion cannot be followed.
pub(super) fn run(law: &MachineLaw, before: &mut Run) -> Result<Moved, SimulationError> {
    let last = last(before)?;
    let motion = Motion::new(law, &last)?;
    motion.is_short()?;
    let (suspension, held, from) = (law.suspension, motion.held, motion.from);
    motion.told(&mut Mass::new(before.contact.as_mut(), suspension, held, (from, 0.0)))
}

/// The record before the motion.
///
/// # Errors
/// There is none.
pub(super) fn last(before: &Run) -> Result<Record, SimulationError> {
    let last = before.records.last().copied();
    last.ok_or_else(|| SimulationError::Refused("machine: there is no contact".to_owned()))
}

impl Motion<'_> {
    /// Follows the mass, and tells of it.
    pub(super) fn told(mut self, mass: &mut dyn MovedMass) -> Result<Moved, SimulationError> {
        self.begins(mass)?;
        let rest = self.follow(mass)?;
        let mut results = self.results(rest);
        let stiffness = self.suspension.stiffness + self.before.normal.stiffness;
        // An adhesive edge moves along, and makes the contact softer than it is at a given edge.
        let plain = self.before.normal.stored.surface.abs() <= 0.0;
        if let (MachineMotion::Ring { .. }, true) = (self.entry.motion, plain) {
            let frequency = (stiffness / self.suspension.mass).sqrt() / TAU;
            results.push(Named::number("small_frequency", Unit::HERTZ, frequency));
        }
        let tables = if self.bounces.is_empty() { Vec::new() } else { vec![bounces::table(&self.bounces)] };
        let Self { records, moments, errors, pull: StrongestPull { greatest, .. }, .. } = self;
        Ok(Moved {
            records,
            tables,
            results,
            warnings: Vec::new(),
            moments,
            errors,
            error: None,
            least: greatest.map(|pull| -pull),
        })
    }
}

impl<'r> Motion<'r> {
    pub(super) fn new(law: &MachineLaw, before: &'r Record) -> Result<Self, SimulationError> {
        let Some(&entry) = law.motions.first() else {
            return Err(SimulationError::Refused("machine: there is no motion".to_owned()));
        };
        let suspension = law.suspension;
        let depth = before.normal.indentation.unwrap_or(0.0);
        let (held, from, fall) = match entry.motion {
            MachineMotion::Ring { amplitude } => {
                let push = before.normal.force;
                if before.normal.contact_radius.is_none_or(|a| a <= 0.0) {
                    return Err(SimulationError::Refused(format!(
                        "history[{}]: the bodies are apart, and nothing holds the mass about a depth: expected an Indent or Press into contact before Ring",
                        entry.entry
                    )));
                }
                (Held { depth, push }, depth + amplitude, 0.0)
            }
            MachineMotion::Fall { height } => {
                let push = suspension.mass * GRAVITY;
                (Held { depth: 0.0, push }, -height, (2.0 * GRAVITY * height).sqrt())
            }
            MachineMotion::Drive { .. } => {
                return Err(SimulationError::Refused("machine: Drive moves along the surface".to_owned()));
            }
        };
        let (records, moments, bounces) = (Vec::new(), Vec::new(), Vec::new());
        let (begin, initial, errors, pull) = (before.time, 0.0, Errors::default(), StrongestPull::default());
        Ok(Self {
            entry,
            suspension,
            held,
            begin,
            from,
            fall,
            initial,
            before,
            records,
            moments,
            bounces,
            errors,
            pull,
        })
    }

    /// Whether it can be followed to its end.
    pub(super) fn is_short(&self) -> Result<(), SimulationError> {
        let Suspension { mass, stiffness, damping } = self.suspension;
        let (what, times) = match self.entry.motion {
            MachineMotion::Ring { .. } => {
                ("swings", self.entry.over * ((stiffness + self.before.normal.stiffness) / mass).sqrt() / TAU)
            }
            // What a damper or a body that relaxes takes makes bounces fewer and shorter.
            MachineMotion::Fall { .. } if damping <= 0.0 => ("bounces", 0.5 * self.entry.over * GRAVITY / self.fall),
            MachineMotion::Fall { .. } | MachineMotion::Drive { .. } => return Ok(()),
        };
        if times > MOST_TIMES {
            return Err(SimulationError::Refused(format!(
                "history[{}].over: the mass {what} some {times:.1e} times in it: expected a duration of at most {:.1e} s",
                self.entry.entry,
                self.entry.over * MOST_TIMES / times
            )));
        }
        Ok(())
    }

    /// The state as the mass is let go.
    fn begins(&mut self, mass: &mut dyn MovedMass) -> Result<(), SimulationError> {
        let normal = self.normal(mass)?;
        self.initial = normal.stored.stored() + normal.dissipated + self.energies(&mass.state()).1;
        let state = mass.state();
        // It is let go where it turns.
        self.moments.push(MassMoment { what: Happening::Turns, state });
        self.push(normal, state);
        Ok(())
    }

    /// Moves to the end of the entry, or to where the mass lies, and says from which time [s] of the entry on it does or creeps.
    fn follow(&mut self, mass: &mut dyn MovedMass) -> Result<Option<f64>, SimulationError> {
        let fault = failed(self.entry.entry);
        for k in 1..=self.entry.records {
            let until = self.entry.over * k as f64 / self.entry.records as f64;
            while mass.state().time < until {
                let moment = mass.step(until).map_err(&fault)?;
                self.pulls(mass)?;
                let Some(moment) = moment else { continue };
                let normal = self.normal(mass)?;
                self.happens(moment, &normal);
                if self.moments.len() < MOST_MOMENTS {
                    self.push(touching(normal, moment.what), moment.state);
                }
                if self.lies() {
                    return Ok(Some(moment.state.time));
                }
            }
            let normal = self.normal(mass)?;
            self.push(normal, mass.state());
        }
        Ok(mass.creeps_since())
    }

    fn normal(&mut self, mass: &mut dyn MovedMass) -> Result<Normal, SimulationError> {
        let contact = mass.contact().map_err(|source| failed(self.entry.entry)(source.into()))?;
        self.errors.note(&contact.effort());
        Ok(contact.state())
    }

    /// Notes how the contact pulls at the end of a step.
    fn pulls(&mut self, mass: &mut dyn MovedMass) -> Result<(), SimulationError> {
        let MassState { time, speed, .. } = mass.state();
        let contact = mass.contact().map_err(|source| failed(self.entry.entry)(source.into()))?;
        let out = speed < 0.0 && contact.joined();
        self.pull.note(time, if out { contact.state().force } else { 0.0 }, out);
        Ok(())
    }

    fn happens(&mut self, moment: MassMoment, normal: &Normal) {
        match (moment.what, self.bounces.last_mut()) {
            (Happening::Touches, _) => self.bounces.push(Bounce::new(self.begin, &moment.state)),
            (Happening::Parts, Some(bounce)) => bounce.ends(self.begin, &moment.state),
            (Happening::Turns, Some(bounce)) => bounce.turns(&moment.state, normal.force),
            (Happening::Parts | Happening::Turns, None) => {}
        }
        self.moments.push(moment);
    }

    /// Whether a mass that has fallen swings in contact with next to nothing of its energy.
    fn lies(&self) -> bool {
        let [.., one, two, last] = &self.moments[..] else { return false };
        let swings = [one, two, last].iter().all(|moment| moment.what == Happening::Turns);
        let (way, time) = ((last.state.depth - two.state.depth).abs(), last.state.time - two.state.time);
        swings && 0.5 * PI * way / time < LIES * self.fall
    }

    /// Kinetic energy, that of the spring, and the work of the weight since the beginning [J].
    fn energies(&self, state: &MassState) -> (f64, f64, f64) {
        let kinetic = self.suspension.kinetic(state.speed);
        let Suspension { stiffness, .. } = self.suspension;
        if stiffness > 0.0 {
            let push = self.suspension.push(self.held, state.depth);
            return (kinetic, 0.5 * push * push / stiffness, 0.0);
        }
        (kinetic, 0.0, self.held.push * (state.depth - self.from))
    }

    fn push(&mut self, normal: Normal, state: MassState) {
        // In flight the depth is that of the mass.
        let apart = normal.contact_radius.is_none_or(|radius| radius <= 0.0);
        let indentation = if apart { Some(state.depth) } else { normal.indentation };
        let normal = Normal { indentation, ..normal };
        let (kinetic, spring, weight) = self.energies(&state);
        let spring_force = self.suspension.push(self.held, state.depth);
        let work = self.initial + weight;
        let (speed, damped) = (state.speed, state.damped);
        let machine = MachineState {
            speed,
            drawn: None,
            spring_force,
            kinetic,
            spring,
            sheared: None,
            rated: None,
            work,
            damped,
        };
        let (entry, time) = (self.entry.entry, self.begin + state.time);
        self.records.push(Record { entry, time, normal, machine: Some(machine), ..*self.before });
    }

    fn results(&self, rest: Option<f64>) -> Vec<Named> {
        match self.entry.motion {
            MachineMotion::Ring { .. } => swing(&self.moments, self.held.depth),
            MachineMotion::Fall { .. } => {
                let mut results =
                    vec![Named::count("bounces", self.bounces.len()), Named::answer("lies", rest.is_some())];
                results.extend(rest.map(|time| Named::number("rest_time", Unit::SECOND, self.begin + time)));
                results
            }
            MachineMotion::Drive { .. } => Vec::new(),
        }
    }
}

/// A contact at what happens: where bodies that do not adhere touch, it carries nothing yet, however a dashpot answers to the
/// rounding by which it is deeper.
fn touching(normal: Normal, what: Happening) -> Normal {
    if what != Happening::Touches || normal.stored.surface.abs() > 0.0 {
        return normal;
    }
    Normal { force: 0.0, contact_radius: Some(0.0), stiffness: 0.0, ..normal }
}

/// Frequency of a swing between the deepest points, and its damping ratio from their heights above the rest `depth` [m].
fn swing(moments: &[MassMoment], depth: f64) -> Vec<Named> {
    let turns: Vec<&MassState> =
        moments.iter().filter(|moment| moment.what == Happening::Turns).map(|moment| &moment.state).collect();
    let deep: Vec<&&MassState> = turns.iter().filter(|state| state.depth > depth).collect();
    let mut results = vec![Named::count("swings", deep.len().saturating_sub(1))];
    let ([first, .., last], swings) = (&deep[..], deep.len() - usize::from(!deep.is_empty())) else { return results };
    let count = swings as f64;
    let frequency = count / (last.time - first.time);
    results.push(Named::number("frequency", Unit::HERTZ, frequency));
    let decrement = ((first.depth - depth) / (last.depth - depth)).ln() / count;
    results.push(Named::number("damping_ratio", Unit::ONE, decrement / TAU.hypot(decrement)));
    results
}
