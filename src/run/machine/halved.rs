//! A mass on bodies that remember or adhere, with steps halved until the motion agrees.

use super::normal::{Motion, last};
use super::{Moved, failed};
use crate::contact::model::{ContactModel, Straight};
use crate::contact::viscoelastic::Spectrum;
use crate::drive::impact::{Projectile, StruckHalfSpace};
use crate::drive::machine::{Creeping, SteppedMachine, Suspension};
use crate::material::Relaxation;
use crate::run::follow::Run;
use crate::run::record::Record;
use crate::run::{SimulationError, error};
use crate::scene::law::MachineLaw;
use crate::scene::plan::RoundPlan;
use std::f64::consts::PI;
use std::sync::Arc;

/// What the error stands on.
const TWICE_AS_LONG: &str = "motion of the mass in straight steps of the depth: times and speeds of what happens, and the records of a swing and of a mass in contact, against those in steps twice as long, the inertia that is left out of a creep, and the balance of energies";
/// Longest steps of the first run, in the time of an elastic impact or of a radian of the swing, and how often they are halved.
const STEPS: f64 = 25.0;
const HALVINGS: usize = 2;
/// The same on elastic bodies, a look at which costs next to nothing.
const HALVINGS_OF_ELASTIC: usize = 5;
/// Error of the force on a mass that creeps in the first run; it falls with the square of the steps.
const CREEPS: f64 = 1e-4;
/// Time of an elastic impact in depths over speeds.
const ELASTIC: f64 = 2.94;

/// Moves the mass of a machine along the normal of bodies that remember or adhere, with steps halved until the motion agrees.
///
/// # Errors
/// The bodies are apart, or the motion cannot be followed.
pub(super) fn run(
    plan: &RoundPlan,
    relaxation: &Arc<Relaxation>,
    (law, before): (&MachineLaw, &Run),
) -> Result<Moved, SimulationError> {
    let last = last(before)?;
    let motion = Motion::new(law, &last)?;
    // A ball comes to lie, however long it may fall.
    if !law.falls() {
        motion.is_short()?;
    }
    let most = if plan.contact.bodies().relaxation().is_some() { HALVINGS } else { HALVINGS_OF_ELASTIC };
    let first = time(plan, relaxation, &motion)? / STEPS;
    let mut longest = first;
    let start = before.contact.copy();
    let led_by = |longest: f64| {
        let mut contact = start.copy();
        led(contact.as_mut(), &motion, (longest, CREEPS * (longest / first).powi(2)))
    };
    let (mut coarse, _) = led_by(longest)?;
    let mut done = 0;
    loop {
        longest *= 0.5;
        let (mut fine, creeping) = led_by(longest)?;
        done += 1;
        let error = apart(&coarse, &fine).max(records_apart(&coarse, &fine, law));
        if done >= most || error <= plan.accuracy() {
            let left_out = creeping.map_or(0.0, |creeping| creeping.inertia);
            fine.error = Some((error.max(left_out), TWICE_AS_LONG));
            return Ok(fine);
        }
        coarse = fine;
    }
}

/// One run with steps no longer than `longest` [s], and since when the mass creeps, if it does, led to `accuracy`.
fn led(
    contact: &mut dyn ContactModel,
    motion: &Motion<'_>,
    (longest, accuracy): (f64, f64),
) -> Result<(Moved, Option<Creeping>), SimulationError> {
    let depth = contact.state().indentation.unwrap_or(0.0);
    // The motion begins where the contact is led to first, at once.
    let jump = Straight::between(depth, motion.from, 0.0);
    contact.follow(&jump).map_err(|source| failed(motion.entry.entry)(source.into()))?;
    let (suspension, held) = (motion.suspension, motion.held);
    let mass = SteppedMachine::new(contact, suspension, held, (motion.from, longest));
    let mut mass = if motion.fall > 0.0 { mass.until_it_creeps(accuracy, motion.entry.over) } else { mass };
    let moved = motion.clone().told(&mut mass)?;
    Ok((moved, mass.creeping()))
}

/// How far what happens in two runs is apart: times relative to the time behind them, speeds to the largest.
fn apart(coarse: &Moved, fine: &Moved) -> f64 {
    let (one, other) = (&coarse.moments, &fine.moments);
    let times = one.iter().zip(other).map(|(one, other)| (one.state.time - other.state.time).abs());
    let last = other.last().map_or(f64::MIN_POSITIVE, |moment| moment.state.time.max(f64::MIN_POSITIVE));
    let speeds = one.iter().zip(other).map(|(one, other)| (one.state.speed - other.state.speed).abs());
    let fastest = other.iter().map(|moment| moment.state.speed.abs()).fold(f64::MIN_POSITIVE, f64::max);
    // One happening more or less is one of a mass that all but lies.
    times.fold(0.0, f64::max) / last + speeds.fold(0.0, f64::max) / fastest
}

/// How far the records of two runs are apart; those of a ball that bounces where either has it in contact, for in flight
/// they tell nothing.
fn records_apart(coarse: &Moved, fine: &Moved, law: &MachineLaw) -> f64 {
    let touching = |record: &&Record| !law.falls() || record.normal.contact_radius.is_some_and(|radius| radius > 0.0);
    let of = |records: &[Record]| -> Vec<Record> { records.iter().filter(touching).copied().collect() };
    let [one, other] = [&coarse.records, &fine.records];
    error::apart(one, &of(other)).max(error::apart(other, &of(one)))
}

/// The time in which the contact moves fastest [s].
fn time(plan: &RoundPlan, relaxation: &Arc<Relaxation>, motion: &Motion<'_>) -> Result<f64, SimulationError> {
    let Suspension { mass, stiffness, .. } = motion.suspension;
    if motion.fall > 0.0 {
        let ground = StruckHalfSpace { spectrum: Arc::new(Spectrum::new(relaxation)), profile: plan.profile.clone() };
        let impact = Projectile { mass, speed: motion.fall };
        return Ok(ELASTIC * ground.depth_scale(&impact)? / motion.fall);
    }
    let contact = 2.0 * plan.pair.normal * motion.before.normal.contact_radius.unwrap_or(0.0);
    Ok((mass / (contact + stiffness)).sqrt() * PI)
}
