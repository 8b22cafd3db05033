//! A mass that is drawn along the surface.

use super::led::Led;
use super::slips::{self, SlipEvent};
use super::{Errors, Moved, failed, rated};
use crate::contact::error::ContactError;
use crate::contact::state::{Normal, Tangential};
use crate::drive::machine::{Drawn, DrawnMass, RatedMass, SteppedDrawn};
use crate::friction::TangentialMemory;
use crate::run::SimulationError;
use crate::run::follow::Run;
use crate::run::named::Named;
use crate::run::record::{MachineState, Record};
use crate::scene::history::{MachineEntry, MachineMotion};
use crate::scene::law::{FrictionLaw, MachineLaw};
use crate::scene::plan::RoundPlan;

/// Most changes between stick and slip that are recorded beside the records asked for.
const MOST_MOMENTS: usize = 20_000;

/// A motion being recorded.
struct Motion<'r> {
    mass: Box<dyn DrawnMass>,
    /// The normal contact, where it does not stay as it is.
    led: Option<Led>,
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
    let Drawing { motion, error, results, warnings } = match plan.contact.bodies().relaxation() {
        Some(_) => relaxing(plan, law, (before, &last))?,
        None => elastic(plan, law, (before, &last))?,
    };
    let (slips, table) = (slips::results(&motion.slips), slips::table(&motion.slips));
    let tables = if motion.slips.is_empty() { Vec::new() } else { vec![table] };
    let left_out = motion.mass.left_out();
    let warning = (left_out > 0.0).then(|| {
        format!("the mass swings on the sticking contact far faster than the far end is drawn on, and without losses to speak of: {left_out:.2e} J of such swings were left out; expected a damping, or a larger mass, for them to be followed")
    });
    let warnings = warnings.into_iter().chain(warning).collect();
    let results = results.into_iter().chain(slips).collect();
    Ok(Moved {
        warnings,
        records: motion.records,
        tables,
        results,
        moments: Vec::new(),
        errors: Errors::default(),
        error,
        least: None,
    })
}

/// A motion that has been followed.
struct Drawing<'r> {
    motion: Motion<'r>,
    /// How far it is from another run, if there was one, and what that was.
    error: Option<(f64, &'static str)>,
    /// What the friction tells besides.
    results: Vec<Named>,
    warnings: Vec<String>,
}

/// Follows the entries of a machine with a mass, each record in `pieces`.
fn led<'r>(law: &MachineLaw, mut motion: Motion<'r>, pieces: usize) -> Result<Motion<'r>, SimulationError> {
    law.motions.iter().try_for_each(|entry| motion.follow(entry, pieces * entry.records))?;
    Ok(motion)
}

/// On elastic bodies.
fn elastic<'r>(
    plan: &RoundPlan,
    law: &MachineLaw,
    (before, last): (&Run, &'r Record),
) -> Result<Drawing<'r>, SimulationError> {
    let first = law.motions.first().map_or(0, |motion| motion.entry);
    let memory = memory(plan, before).map_err(|source| failed(first)(source.into()))?;
    let Some(friction) = plan.friction.as_ref().and_then(FrictionLaw::rate_state) else {
        let mass = || Motion::new(Box::new(Drawn::new(law.suspension, memory.clone(), law.left)), None, last);
        let (motion, other) = rayon::join(|| led(law, mass(), 1), || led(law, mass(), OTHER_PIECES));
        let motion = motion?;
        // What a mass does after a slip depends on how it swung before: other pieces of the same way show how well that is known.
        let error = if motion.slips.is_empty() { None } else { Some((motion.apart(&other?), PIECES)) };
        return Ok(Drawing { motion, error, results: Vec::new(), warnings: Vec::new() });
    };
    let (found, tolerance) = (rated::contact(before, &memory), rated::tolerance(plan.accuracy()));
    let mass = |tolerance: f64| {
        let mass = RatedMass::new(law.suspension, friction, (found.carried, found.age, tolerance));
        Motion::new(Box::new(mass), None, last)
    };
    let coarse = || led(law, mass(rated::COARSER * tolerance), 1);
    let (motion, other) = rayon::join(|| led(law, mass(tolerance), 1), coarse);
    let motion = motion?;
    let error = motion.apart(&other?);
    let results = rated::results(law, friction, found.carried);
    let warnings = rated::warnings(friction, found.carried);
    Ok(Drawing { motion, error: Some((error, rated::COARSE)), results, warnings })
}

/// Error of a step on springs that relax, in ways at which the contact slides, and how much coarser the second run is that
/// the first is held against: its steps are twice as long.
const OF_STEP: (f64, f64) = (1e-5, 1e-3);
const TWICE_AS_LONG: f64 = 8.0;
/// What the error then stands on.
const LONGER: &str = "motion of the mass in straight steps on springs exact in time: force at the end and times of slips against those in steps twice as long, and the balance of energies";

/// On bodies that relax.
fn relaxing<'r>(
    plan: &RoundPlan,
    law: &MachineLaw,
    (before, last): (&Run, &'r Record),
) -> Result<Drawing<'r>, SimulationError> {
    let Some((normal, springs)) = before.contact.separate() else {
        return Err(SimulationError::Refused("machine: this friction knows no springs that relax".to_owned()));
    };
    let tolerance = plan.accuracy().clamp(OF_STEP.0, OF_STEP.1);
    let mass = |tolerance: f64| {
        let mass = SteppedDrawn::new(springs.copy(), law.suspension, law.left, tolerance);
        Motion::new(Box::new(mass), Some(Led::new(before, normal.copy())), last)
    };
    let (fine, coarse) = (mass(tolerance), mass(TWICE_AS_LONG * tolerance));
    let (motion, other) = rayon::join(|| led(law, fine, 1), || led(law, coarse, 1));
    let motion = motion?;
    let error = motion.apart(&other?);
    Ok(Drawing { motion, error: Some((error, LONGER)), results: Vec::new(), warnings: Vec::new() })
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
    fn new(mass: Box<dyn DrawnMass>, led: Option<Led>, before: &'r Record) -> Self {
        let state = mass.state();
        let far_end = state.slide + state.extension;
        let (records, slips) = (Vec::new(), Vec::new());
        let mut motion = Self {
            mass,
            led,
            begin: before.time,
            since: 0.0,
            initial: 0.0,
            far_end,
            before,
            records,
            slips,
            moments: 0,
        };
        let tangential = motion.mass.tangential();
        let (machine, rubbed) = (motion.machine(&tangential, 0.0), tangential.dissipated.unwrap_or(0.0));
        let normal = before.normal.stored.stored() + before.normal.dissipated;
        motion.initial = machine.spring + machine.sheared.unwrap_or(0.0) + rubbed + normal;
        motion
    }

    fn follow(&mut self, entry: &MachineEntry, records: usize) -> Result<(), SimulationError> {
        let MachineMotion::Drive { speed } = entry.motion else {
            return Err(SimulationError::Refused("machine: only Drive moves along the surface".to_owned()));
        };
        self.mass.draw(speed);
        if let Some(led) = &mut self.led {
            led.begin(entry.over).map_err(|source| failed(entry.entry)(source.into()))?;
        }
        self.push(entry)?;
        let chords = self.led.as_ref().map_or_else(Vec::new, Led::chords);
        let mut chords = chords.into_iter().peekable();
        for part in (1..=records).map(|k| k as f64 / records as f64) {
            while let Some(end) = chords.next_if(|&end| end < part) {
                self.follow_to(entry, end)?;
            }
            self.follow_to(entry, part)?;
            self.push(entry)?;
        }
        self.since += entry.over;
        Ok(())
    }

    /// On to the part `part` of an entry, with all changes between stick and slip on the way.
    fn follow_to(&mut self, entry: &MachineEntry, part: f64) -> Result<(), SimulationError> {
        let failed = failed(entry.entry);
        if let Some(led) = &mut self.led {
            let speed = led.lead(part).map_err(|source| failed(source.into()))?;
            self.mass.lead(speed);
        }
        let until = self.since + entry.over * part;
        while self.mass.state().time < until {
            let Some(moment) = self.mass.step(until).map_err(&failed)? else { continue };
            let speed = self.mass.rated().map(|rated| rated.speed.abs());
            slips::note(&mut self.slips, self.begin, (&moment, speed));
            self.moments += 1;
            if self.moments < MOST_MOMENTS {
                self.push(entry)?;
            }
        }
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

    /// The machine on a contact in the state `tangential`, where the force has done the work `pushed` [J].
    fn machine(&self, tangential: &Tangential, pushed: f64) -> MachineState {
        let (state, suspension) = (self.mass.state(), self.mass.suspension());
        MachineState {
            speed: state.speed,
            drawn: Some(state.slide + state.extension - self.far_end),
            spring_force: self.mass.pull(),
            kinetic: suspension.kinetic(state.speed),
            spring: 0.5 * suspension.stiffness * state.extension * state.extension,
            sheared: tangential.stored,
            rated: self.mass.rated(),
            work: self.initial + state.work + pushed,
            damped: state.damped,
        }
    }

    fn push(&mut self, entry: &MachineEntry) -> Result<(), SimulationError> {
        let time = self.mass.state().time;
        let part = if entry.over > 0.0 { (time - self.since) / entry.over } else { 1.0 };
        let at = self.led.as_ref().map(|led| led.at(part)).transpose();
        let (normal, pushed) =
            at.map_err(|source| failed(entry.entry)(source.into()))?.unwrap_or((self.before.normal, 0.0));
        let normal = Normal { dissipated: normal.dissipated + self.mass.relaxed(), ..normal };
        let tangential = self.mass.tangential();
        let (machine, tangential) = (Some(self.machine(&tangential, pushed)), Some(tangential));
        let record =
            Record { entry: entry.entry, time: self.begin + time, machine, tangential, normal, ..*self.before };
        if self.records.last() != Some(&record) {
            self.records.push(record);
        }
        Ok(())
    }
}
