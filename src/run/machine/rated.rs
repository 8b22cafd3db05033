//! A mass that is drawn along on a contact with rate and state.

use crate::drive::machine::{Carried, Threshold, threshold};
use crate::friction::{RateState, TangentialMemory};
use crate::run::follow::Run;
use crate::run::named::Named;
use crate::run::record::Outcome;
use crate::run::unit::Unit;
use crate::scene::history::MachineMotion;
use crate::scene::law::MachineLaw;
use crate::scene::plan::Plan;
use std::f64::consts::TAU;

/// How much coarser the second run is that the first is held against.
pub(super) const COARSER: f64 = 10.0;
/// What the error then stands on.
pub(super) const COARSE: &str = "motion of the mass in extrapolated implicit steps: force at the end and times of slips against those of steps with ten times the error, and the balance of energies";
/// Error of a step, relative to the accuracy asked for, between rounding and what a slip can be recognised by.
const OF_STEP: f64 = 0.1;
const STEPS: (f64, f64) = (1e-11, 1e-4);

/// Error of a step.
pub(super) fn tolerance(accuracy: f64) -> f64 {
    (OF_STEP * accuracy).clamp(STEPS.0, STEPS.1)
}

/// A contact as the machine finds it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Found {
    pub(super) carried: Carried,
    /// Time [s] since the bodies touched.
    pub(super) age: f64,
}

/// The contact behind the history before.
pub(super) fn contact(before: &Run, memory: &TangentialMemory) -> Found {
    let apart = before.records.iter().rev().find(|record| record.normal.force <= 0.0);
    let (last, touch) = (before.records.last(), apart.map_or(0.0, |record| record.time));
    let force = last.map_or(0.0, |record| record.normal.force);
    let age = last.map_or(0.0, |record| record.time) - touch;
    Found { carried: Carried { force, stiffness: memory.stuck() }, age }
}

/// The last speed at which the far end is drawn on [m/s], if it is.
fn last_speed(law: &MachineLaw) -> Option<f64> {
    law.motions.iter().rev().find_map(|entry| match entry.motion {
        MachineMotion::Drive { speed } if speed.abs() > 0.0 => Some(speed.abs()),
        MachineMotion::Drive { .. } | MachineMotion::Ring { .. } | MachineMotion::Fall { .. } => None,
    })
}

/// Steady sliding at the last speed: its friction, and where it is lost.
pub(super) fn results(law: &MachineLaw, friction: &RateState, carried: Carried) -> Vec<Named> {
    let Some(speed) = last_speed(law) else { return Vec::new() };
    let steady = Named::number("steady_friction_coefficient", Unit::ONE, friction.steady(speed));
    let found = threshold(friction, speed, (&law.suspension, carried));
    let lasts = Named::answer("steady_sliding_lasts", found.is_steady(law.suspension.stiffness));
    let critical = match found {
        Threshold::Never | Threshold::Always => Vec::new(),
        Threshold::At { stiffness, pulse, .. } => vec![
            Named::number("critical_stiffness", Unit::NEWTON_PER_METRE, stiffness),
            Named::number("critical_frequency", Unit::HERTZ, pulse / TAU),
        ],
    };
    [steady, lasts].into_iter().chain(critical).collect()
}

/// Displacement of the contact over D_c, for a change of the friction by b, from which on it is no longer one that slips as a whole.
const GIVES: f64 = 0.1;
/// How far the friction may be from the logarithm.
const CONTINUED: f64 = 1e-6;

/// What a user must know of a contact that is taken for one.
pub(super) fn warnings(friction: &RateState, carried: Carried) -> Vec<String> {
    let given = friction.evolution.si() * carried.force / carried.stiffness / friction.distance.si();
    let soft = given > GIVES;
    let told = soft.then(|| {
        format!(
            "the contact gives by bF/2G*a = {given:.2} of the distance D_c while its state changes: it is taken to slip as a whole and with one state, and in truth its edge goes ahead of its middle"
        )
    });
    let (written, right) = (friction.coefficient.si(), friction.steady(friction.speed.si()));
    let other = right > (1.0 + CONTINUED) * written;
    let continued = other.then(|| {
        format!(
            "a direct effect of {:?} beside a friction of {written:?} is so large that junctions jump back as well: at the speed V* the friction is {right:.4}, and not what the logarithm says",
            friction.direct.si()
        )
    });
    told.into_iter().chain(continued).collect()
}

/// Whether steady sliding lasts, in words; `None` without rate and state.
#[must_use]
pub fn steady_sliding(plan: &Plan, outcome: &Outcome) -> Option<String> {
    let round = plan.round()?;
    let (law, friction) = (round.machine.as_ref()?, round.friction.as_ref()?.rate_state()?);
    let (speed, last) = (last_speed(law)?, outcome.records.last()?);
    let stiffness = 2.0 * round.pair.tangential * last.normal.contact_radius?;
    let found = threshold(friction, speed, (&law.suspension, Carried { force: last.normal.force, stiffness }));
    let own = law.suspension.stiffness;
    let of = format!(
        "at {speed:e} m/s, μ = {:.4}, a spring of {own:.4e} N/m, a contact of {stiffness:.4e} N/m",
        friction.steady(speed)
    );
    Some(match found {
        Threshold::Never => format!("{of}: lasts, whatever the spring, for friction and damper grow with the speed"),
        Threshold::Always => format!("{of}: is lost, whatever the spring, for the contact itself is too soft"),
        Threshold::At { stiffness, pulse, .. } => {
            let (side, becomes) =
                if own > stiffness { ("above", "lasts") } else { ("below", "breaks up into stick and slip") };
            format!(
                "{of}, {side} the critical {stiffness:.4e} N/m: {becomes}; at the threshold it swings with {:.4e} Hz",
                pulse / TAU
            )
        }
    })
}
