//! Impacts of rough bodies, one member of an ensemble after the other.

use super::steps::{ELASTIC, Struck};
use super::table::{self, ImpactRow};
use super::{RECORDS, failed, results};
use crate::contact::error::ContactError;
use crate::contact::model::{ContactModel, Straight};
use crate::contact::state::Normal;
use crate::drive::impact::{Projectile, Rebound, SpringPassage};
use crate::run::SimulationError;
use crate::run::compose::{self, RoughNormal};
use crate::run::ensemble::{self, Ensemble};
use crate::run::named::Named;
use crate::run::record::{ErrorEstimate, Outcome, Record};
use crate::run::rough::{estimate, members, of_surface, remarks, without_surface};
use crate::scene::parts::Parts;
use crate::scene::plan::RoughImpactPlan;
use crate::shape::rough::RoughError;
use std::num::NonZeroUsize;

/// What is known of the impacts on one surface.
struct Member {
    /// One per speed.
    rows: Vec<ImpactRow>,
    /// Of the fastest impact.
    records: Vec<Record>,
    pull_off_force: f64,
    bytes: usize,
}

/// What is followed of one impact.
struct Struggle {
    rebound: Rebound,
    moments: Vec<(f64, Normal)>,
    pull_off_force: f64,
    bytes: usize,
}

/// Runs the impacts of a scene with a rough shape on all members of its ensemble in parallel; `done` is told the share
/// behind.
///
/// # Errors
/// The surface cannot be made; the contact would reach the ends of its line.
pub fn run(plan: &RoughImpactPlan, done: &(dyn Fn(f64) + Sync)) -> Result<Outcome, SimulationError> {
    let surface = &plan.rough.surface;
    let count = surface.seeds.len();
    let all = members(surface, done, |seed| member(plan, seed))?;
    let (own, bytes) = (&all[..count], all.iter().map(|member| member.bytes).max().unwrap_or(0));
    let rows: Vec<Vec<ImpactRow>> = own.iter().map(|member| member.rows.clone()).collect();
    let pulls: Option<Vec<f64>> = plan.rough.works.map(|_| own.iter().map(|member| member.pull_off_force).collect());
    let error = rows.iter().flatten().map(|row| row.rebound.error).fold(0.0, f64::max);
    let all: Vec<Vec<Record>> = all.into_iter().map(|member| member.records).collect();
    let ensemble = Ensemble::of(&all[..count]);
    let records = ensemble::mean(&all[..count]);
    let mut results = results::of_surfaces(&rows, &records, pulls.as_deref());
    let (roughness, peak_to_valley) = of_surface(surface);
    results.extend(roughness.into_iter().chain(peak_to_valley));
    results.extend(ensemble.as_ref().map(|_| Named::count("members", count)));
    let parts = plan.parts();
    Ok(Outcome {
        map: None,
        results,
        records,
        fields: Vec::new(),
        tables: ensemble.iter().map(Ensemble::table).chain([table::scattered(&rows)]).collect(),
        error_estimate: at_least(estimate(&all, count), error),
        warnings: remarks(&plan.rough),
        plan: Parts { state_bytes: parts.state_bytes + bytes, ..parts },
    })
}

/// The estimate, unless the steps of the motion are coarser still.
fn at_least(estimate: ErrorEstimate, of_steps: f64) -> ErrorEstimate {
    if of_steps <= estimate.relative {
        return estimate;
    }
    let basis = "straight steps of the depth, their limit against that of steps twice as long".to_owned();
    ErrorEstimate { relative: of_steps, basis }
}

/// All impacts on a surface of the scene; on one that is only like it the fastest.
fn member(plan: &RoughImpactPlan, seed: u64) -> Result<Member, SimulationError> {
    let contact = compose::rough_normal(&plan.rough, seed).map_err(|error| without_surface(seed, &error))?;
    let fastest = plan.impact.speed.iter().map(|speed| speed.si()).fold(0.0, f64::max);
    let own = plan.rough.surface.seeds.contains(&seed);
    let mut member = Member { rows: Vec::new(), records: Vec::new(), pull_off_force: 0.0, bytes: 0 };
    for speed in plan.impact.speed.iter().map(|speed| speed.si()).filter(|speed| own || *speed >= fastest) {
        let impact = Projectile { mass: plan.impact.mass.si(), speed };
        let count = (speed >= fastest).then(|| plan.scene.steps.map_or(RECORDS, NonZeroUsize::get));
        let one = follow(plan, &contact, impact, count)?;
        member.rows.push(ImpactRow { speed, rebound: one.rebound, peak_pressure: None, oblique: None });
        member.bytes = member.bytes.max(one.bytes);
        if speed >= fastest {
            let record = |(time, normal)| Record {
                entry: 0,
                time,
                normal,
                tangential: None,
                gliding: None,
                worn: None,
                joined: None,
                machine: None,
                spring: None,
                pixels: None,
            };
            member.records = one.moments.into_iter().map(record).collect();
            member.pull_off_force = one.pull_off_force;
        }
    }
    Ok(member)
}

/// Follows an impact; `count` records where they are wanted.
fn follow(
    plan: &RoughImpactPlan,
    contact: &RoughNormal,
    impact: Projectile,
    count: Option<usize>,
) -> Result<Struggle, SimulationError> {
    let refused = |source: ContactError| failed(source.into());
    match contact {
        RoughNormal::Elastic(contact) => {
            let passage = SpringPassage::elastic(contact.bed(), impact);
            passed(&passage, contact, count).map_err(refused)
        }
        RoughNormal::Adhesive(contact) => {
            let passage = SpringPassage::adhesive(contact, impact).map_err(refused)?;
            passed(&passage, contact, count).map_err(refused)
        }
        RoughNormal::Relaxing(contact) => {
            stepped(plan, contact.as_ref(), (impact, contact.stopped_at(impact.energy(), impact.speed)), count)
        }
        RoughNormal::Yielding(contact) => {
            stepped(plan, contact.as_ref(), (impact, contact.stopped_at(impact.energy())), count)
        }
    }
}

/// An impact in steps, and the depth [m] that the mass does not pass if nothing relaxes or yields.
fn stepped(
    plan: &RoughImpactPlan,
    contact: &dyn ContactModel,
    (impact, stopped_at): (Projectile, Result<f64, RoughError>),
    count: Option<usize>,
) -> Result<Struggle, SimulationError> {
    let refused = |source: ContactError| failed(source.into());
    let depth = stopped_at.map_err(|error| SimulationError::Refused(error.to_string()))?;
    let struck = Struck { contact, impact, time: ELASTIC * depth / impact.speed };
    let run = struck.settled(plan.accuracy(), plan.scene.accuracy.is_some()).map_err(refused)?;
    let moments = count.map(|count| struck.again(&run, count)).transpose().map_err(refused)?;
    let pull_off_force = run.states.iter().map(|state| state.force).fold(0.0, f64::min);
    Ok(Struggle { rebound: run.rebound, moments: moments.unwrap_or_default(), pull_off_force, bytes: run.bytes })
}

/// A way through elastic springs, seen on a contact.
fn passed(passage: &SpringPassage, contact: &dyn ContactModel, count: Option<usize>) -> Result<Struggle, ContactError> {
    let rebound = passage.rebound();
    // Whether the line is long enough.
    contact.copy().follow(&Straight::between(0.0, rebound.greatest_depth, 0.0))?;
    let moments = count.map(|count| passage.moments(contact.copy().as_mut(), count)).transpose()?;
    let moments = moments.unwrap_or_default();
    Ok(Struggle { rebound, moments, pull_off_force: passage.pull_off_force(), bytes: passage.bytes() })
}
