//! A mass that is drawn along the surface.

use super::slips::{self, SlipEvent};
use super::{Moved, failed, rated};
use crate::contact::error::ContactError;
use crate::drive::machine::{Drawn, DrawnMass, RatedMass};
use crate::friction::TangentialMemory;
use crate::run::SimulationError;
use crate::run::follow::Run;
use crate::run::record::{MachineState, Record};
use crate::scene::history::{MachineEntry, MachineMotion};
use crate::scene::law::{FrictionLaw, MachineLaw};
use crate::scene::plan::RoundPlan;

/// Most changes between stick and slip that are recorded beside the records asked for.
const MOST_MOMENTS: usize = 20_000;

/// A motion being recorded.
struct Motion<'r> {
    mass: Box<dyn DrawnMass>,
    /// Time at which the first entry begins [s].
    begin: f64,
    /// Time since then at which the present one does [s].
    since: f64,
    /// Energy there is at the beginning, contact and spring [J].
    initial: f64,
    /// Place of the far end beyond the mass at the beginning, and what it has gone since [m].
    far_end: f64,
    before: &'r Record,
    records: Vec<Record>,
    slips: Vec<SlipEvent>,
    moments: usize,
}

/// Pieces of each record of the motion that another one is held against.
const OTHER_PIECES: usize = 3;
/// What the error then stands on.
const PIECES: &str = "motion of the mass in extrapolated steps of 1e-13: force at the end and times of slips against those of the same way in other pieces, and the balance of energies";

/// Draws the mass of a machine along the surface.
///
/// # Errors
/// The bodies are apart, or the motion cannot be followed.
pub(super) fn run(plan: &RoundPlan, law: &MachineLaw, before: &Run) -> Result<Moved, SimulationError> {
    let first = law.motions.first().map_or(0, |motion| motion.entry);
    let Some(last) = before.records.last().copied() else {
        return Err(SimulationError::Refused("machine: there is no contact".to_owned()));
    };
    if last.normal.force <= 0.0 {
        return Err(SimulationError::Refused(format!(
            "history[{first}]: the bodies are apart, and there is no friction: expected an Indent or Press into contact before Drive"
        )));
    }
    let memory = memory(plan, before).map_err(|source| failed(first)(source.into()))?;
    let led = |mass: Box<dyn DrawnMass>, pieces: usize| -> Result<Motion<'_>, SimulationError> {
        let mut motion = Motion::new(mass, &last);
        law.motions.iter().try_for_each(|entry| motion.follow(entry, pieces * entry.records))?;
        Ok(motion)
    };
    let (motion, error, of_friction) = match plan.friction.as_ref().and_then(FrictionLaw::rate_state) {
        Some(friction) => {
            let (found, tolerance) = (rated::contact(before, &memory), rated::tolerance(plan.accuracy()));
            let mass = |tolerance: f64| {
                Box::new(RatedMass::new(law.suspension, friction, (found.carried, found.age, tolerance)))
            };
            let other = || led(mass(rated::COARSER * tolerance), 1);
            let (motion, other) = rayon::join(|| led(mass(tolerance), 1), other);
            let motion = motion?;
            let error = motion.apart(&other?);
            let told = (rated::results(law, friction, found.carried), rated::warnings(friction, found.carried));
            (motion, Some((error, rated::COARSE)), told)
        }
        None => {
            let mass = || Box::new(Drawn::new(law.suspension, memory.clone(), law.left));
            let (motion, other) = rayon::join(|| led(mass(), 1), || led(mass(), OTHER_PIECES));
            let motion = motion?;
            // What a mass does after a slip depends on how it swung before: other pieces of the same way show how well that is known.
            let slipped = !motion.slips.is_empty();
            let error = if slipped { Some((motion.apart(&other?), PIECES)) } else { None };
            (motion, error, (Vec::new(), Vec::new()))
        }
    };
    let (slips, table) = (slips::results(&motion.slips), slips::table(&motion.slips));
    let tables = if motion.slips.is_empty() { Vec::new() } else { vec![table] };
    let left_out = motion.mass.left_out();
    let warning = (left_out > 0.0).then(|| {
        format!("the mass swings on the sticking contact far faster than the far end is drawn on, and without losses to speak of: {left_out:.2e} J of such swings were left out; expected a damping, or a larger mass, for them to be followed")
    });
    let warnings = of_friction.1.into_iter().chain(warning).collect();
    let results = of_friction.0.into_iter().chain(slips).collect();
    Ok(Moved { warnings, records: motion.records, tables, results, moments: Vec::new(), error })
}

/// What the friction remembers of the history before.
fn memory(plan: &RoundPlan, before: &Run) -> Result<TangentialMemory, ContactError> {
    let coefficient = plan.friction.as_ref().and_then(FrictionLaw::coulomb).unwrap_or(0.0);
    let mut memory = TangentialMemory::new(plan.profile.clone(), plan.grip(coefficient));
    for pose in before.path() {
        memory.advance(*pose)?;
    }
    Ok(memory)
}

impl<'r> Motion<'r> {
    fn new(mass: Box<dyn DrawnMass>, before: &'r Record) -> Self {
        let state = mass.state();
        let far_end = state.slide + state.extension;
        let (records, slips) = (Vec::new(), Vec::new());
        let mut motion =
            Self { mass, begin: before.time, since: 0.0, initial: 0.0, far_end, before, records, slips, moments: 0 };
        let machine = motion.machine();
        let rubbed = motion.mass.tangential().dissipated.unwrap_or(0.0);
        let normal = before.normal.stored.stored() + before.normal.dissipated;
        motion.initial = machine.spring + machine.sheared.unwrap_or(0.0) + rubbed + normal;
        motion
    }

    fn follow(&mut self, entry: &MachineEntry, records: usize) -> Result<(), SimulationError> {
        let MachineMotion::Drive { speed } = entry.motion else {
            return Err(SimulationError::Refused("machine: only Drive moves along the surface".to_owned()));
        };
        self.mass.draw(speed);
        self.push(entry.entry);
        for k in 1..=records {
            let until = self.since + entry.over * k as f64 / records as f64;
            while self.mass.state().time < until {
                let Some(moment) = self.mass.step(until).map_err(failed(entry.entry))? else { continue };
                let speed = self.mass.rated().map(|rated| rated.speed.abs());
                slips::note(&mut self.slips, self.begin, (&moment, speed));
                self.moments += 1;
                if self.moments < MOST_MOMENTS {
                    self.push(entry.entry);
                }
            }
            self.push(entry.entry);
        }
        self.since += entry.over;
        Ok(())
    }

    /// How far the end is from that of the same way in other pieces: force, and times of slips, as parts of the largest.
    fn apart(&self, other: &Self) -> f64 {
        let pull = |motion: &Self| motion.mass.tangential().force;
        let most = self.records.iter().filter_map(|record| Some(record.tangential?.force.abs())).fold(0.0, f64::max);
        let times = self.slips.iter().zip(&other.slips).map(|(one, other)| (one.start / other.start - 1.0).abs());
        let force = if most > 0.0 { (pull(self) - pull(other)).abs() / most } else { 0.0 };
        if self.slips.len() == other.slips.len() { times.fold(force, f64::max) } else { 1.0 }
    }

    fn machine(&self) -> MachineState {
        let (state, suspension) = (self.mass.state(), self.mass.suspension());
        MachineState {
            speed: state.speed,
            drawn: Some(state.slide + state.extension - self.far_end),
            spring_force: self.mass.pull(),
            kinetic: suspension.kinetic(state.speed),
            spring: 0.5 * suspension.stiffness * state.extension * state.extension,
            sheared: self.mass.tangential().stored,
            rated: self.mass.rated(),
            work: self.initial + state.work,
            damped: state.damped,
        }
    }

    fn push(&mut self, entry: usize) {
        let time = self.begin + self.mass.state().time;
        let (machine, tangential) = (Some(self.machine()), Some(self.mass.tangential()));
        let record = Record { entry, time, machine, tangential, ..*self.before };
        if self.records.last() != Some(&record) {
            self.records.push(record);
        }
    }
}
