//! The error of each solver, and where it comes from.

use super::compose;
use super::conditioning::moved_edge;
use super::follow::{Run, follow};
use super::{Wanted, viscoelastic};
use crate::contact::adhesion::equilibrium::Control;
use crate::contact::adhesion::line::EdgeLine;
use crate::contact::springs::reach_for;
use crate::contact::state::Normal;
use crate::input::quantity::Accuracy;
use crate::material::Relaxation;
use crate::run::record::{ErrorEstimate, Record};
use crate::scene::law::{ContactLaw, ElasticAdhesion, GRADE, HeldEdge};
use crate::scene::plan::RoundPlan;
use crate::scene::stage::Path;
use std::num::NonZeroUsize;

/// What a few hundred roundings leave of a state, conditioned a thousand times worse than themselves.
const ROUNDING: f64 = 1e-11;

/// The error of the normal contact or of the tangential one, whichever is larger.
#[must_use]
pub fn estimate(plan: &RoundPlan, run: &Run) -> ErrorEstimate {
    beside(plan, run, again(plan).as_deref())
}

/// [`estimate`], by the records of the history gone through [`again`] already.
#[must_use]
pub fn beside(plan: &RoundPlan, run: &Run, again: Option<&[Record]>) -> ErrorEstimate {
    let normal = normal_error(plan, run, again);
    let place = plan.profile.place(largest_radius(&run.records));
    let tangential = plan.friction.as_ref().and_then(|law| compose::friction_error(plan, law, place));
    tangential.filter(|tangential| tangential.relative > normal.relative).unwrap_or(normal)
}

/// Error of a state behind many pieces, each of which has missed its force or depth by no more than one.
const CHORDS: f64 = 2.0;

fn of(relative: f64, basis: &str) -> ErrorEstimate {
    ErrorEstimate { relative, basis: basis.to_owned() }
}

fn normal_error(plan: &RoundPlan, run: &Run, again: Option<&[Record]>) -> ErrorEstimate {
    match &plan.contact {
        ContactLaw::Direct(ElasticAdhesion::Finite { .. }) => {
            of(1e-10, "direct path with roots within roots: rounding, against Maugis' equations over twelve decades")
        }
        ContactLaw::Direct(ElasticAdhesion::Outside { .. }) => {
            of(1e-13, "direct path: rounding, for it is Hertz's contact under the load and the attraction")
        }
        ContactLaw::Direct(ElasticAdhesion::None | ElasticAdhesion::Fading { .. }) => {
            direct_error(plan, 0.0, &run.records)
        }
        ContactLaw::Direct(ElasticAdhesion::Vanishing { work }) => direct_error(plan, *work, &run.records),
        ContactLaw::Springs { count, work } => springs_error(plan, *count, work.unwrap_or(0.0), &run.records),
        ContactLaw::Continuous { edge, .. } => match edge.as_ref().filter(|edge| edge.has_rate()) {
            _ if plan.is_curved() => {
                let pieces = CHORDS * plan.accuracy() * in_balance(run);
                let coarser = CHANCE * again.map_or(0.0, |again| apart(&led(run), again));
                of(
                    sums(run) + pieces.max(coarser),
                    "continuous bed: straight pieces of the depth to the accuracy asked for, of the forces in balance where the bodies attract each other, or what ten times coarser ones change, and what the polynomials of its panels miss",
                )
            }
            Some(_) => rate_error(run, again),
            None => of(sums(run), "continuous bed, exact in time: what the polynomials of its panels miss"),
        },
        ContactLaw::Gliding { .. } => gliding_error(plan, run),
        ContactLaw::Plastic(_) => of(1e-13, "yielding ball in closed form: rounding"),
        ContactLaw::ViscoelasticSprings { count, .. } => viscoelastic_springs_error(plan, run, count.get()),
    }
}

fn direct_error(plan: &RoundPlan, work: f64, records: &[Record]) -> ErrorEstimate {
    let edge = moved_edge(plan, work, records);
    if edge > ROUNDING {
        return of(
            edge,
            "direct path: the contact radius near a turning point, moved by the rounding of what is prescribed",
        );
    }
    let tables = plan.profile.table_error();
    if tables > ROUNDING {
        return of(
            tables,
            "direct path: stiffness and depth from tables over the radius, against the integral equation",
        );
    }
    of(ROUNDING, "direct path: rounding, against closed forms over twelve decades")
}

/// The error of a bed: second order in the width h of a spring, and what the load q(a) of an adhesive edge
/// does within one spring, q(a)h against the largest force.
fn springs_error(plan: &RoundPlan, springs: NonZeroUsize, work: f64, records: &[Record]) -> ErrorEstimate {
    let largest = |of: fn(&Normal) -> f64| records.iter().map(|record| of(&record.normal).abs()).fold(0.0, f64::max);
    let radius = largest(|normal| normal.contact_radius.unwrap_or(0.0));
    let (a, force) = (plan.profile.place(radius), largest(|normal| normal.force));
    let count = springs.get() as f64;
    let second = (17.0 / 16.0 * 2.0 / count).powi(2).max(1e-11);
    let second = steepness(plan, records).powi(2) * second;
    let width = reach_for(plan.profile.as_ref(), a) / count;
    let line = EdgeLine::new(plan.ground(), work);
    let edge = plan.pair.normal * line.elongation(a) * width / force.max(f64::MIN_POSITIVE);
    if edge > second {
        let basis = format!("bed of {springs} springs: the load of one spring at the adhesive edge, first order");
        return ErrorEstimate { relative: edge.min(1.0), basis };
    }
    let basis = format!("bed of {springs} springs: second order in the spring width, constant at most 4");
    ErrorEstimate { relative: second, basis }
}

/// Part of the forces in balance beside which a force is none.
const NO_FORCE: f64 = 1e-3;

/// The largest force of a run [N], above zero; of a contact that is held by no force, what would be one.
fn largest_force(run: &Run) -> f64 {
    let largest = |of: fn(&Normal) -> f64| run.records.iter().map(|record| of(&record.normal)).fold(0.0, f64::max);
    largest(|normal| normal.force.abs()).max(NO_FORCE * largest(Normal::in_balance)).max(f64::MIN_POSITIVE)
}

/// The largest contact radius among records [m].
fn largest_radius(records: &[Record]) -> f64 {
    records.iter().filter_map(|record| record.normal.contact_radius).fold(0.0, f64::max)
}

/// The largest forces that hold each other in balance, over the largest force; at least one. Pieces of a prescribed force are as
/// good as a part of these.
fn in_balance(run: &Run) -> f64 {
    let most = run.records.iter().map(|record| record.normal.in_balance()).fold(0.0, f64::max);
    (most / largest_force(run)).max(1.0)
}

/// The error of the sums of the continuous bed.
fn sums(run: &Run) -> f64 {
    (run.force_error / largest_force(run)).max(1e-13)
}

fn viscoelastic_springs_error(plan: &RoundPlan, run: &Run, count: usize) -> ErrorEstimate {
    let width = GRADE.recip().asinh() / count as f64;
    let basis = format!(
        "bed of {count} springs: second order in the spring width, constant 1/4, and straight pieces of the depth within {:.0e}; the contact radius between two springs as the loads of four tell, and as the fourth changes it",
        plan.accuracy()
    );
    let (springs, depth) = (0.25 * width * width, felt(plan, run) * kept(plan) * plan.accuracy());
    let (steep, edge) = (steepness(plan, &run.records), edge_between_springs(plan, run));
    let between = run.force_error / largest_force(run);
    ErrorEstimate { relative: steep * (steep * springs.max(edge) + depth) + between, basis }
}

/// The largest error of the place of the edge between two springs, as a part of the place of the largest contact.
fn edge_between_springs(plan: &RoundPlan, run: &Run) -> f64 {
    let radius = largest_radius(&run.records);
    if radius > 0.0 { run.radius_error / plan.profile.place(radius) } else { 0.0 }
}

/// d ln a/d ln x of the contact radius a over the place x of the edge in the bed, at the largest contact: one under a
/// round body; under a lying one, whose half width grows nearly as e to the place, several. An error of the place is
/// that many times one of the radius, and the load beside the edge, by which the place is found between two springs,
/// bends that much more.
fn steepness(plan: &RoundPlan, records: &[Record]) -> f64 {
    const STEP: f64 = 1e-3;
    let radius = largest_radius(records);
    let inside = plan.profile.contact_radius(plan.profile.place(radius) * (1.0 - STEP));
    let steep = (1.0 - inside / radius) / STEP;
    if steep.is_finite() && steep > 1.0 + 1e-9 { steep } else { 1.0 }
}

/// What the largest force feels of a depth off by a part of itself, 2E(0)a·d/F, where the depth is followed in
/// chords; one where the force itself is met.
fn felt(plan: &RoundPlan, run: &Run) -> f64 {
    let chords = plan.stages.iter().any(|stage| matches!(stage.normal, Path::Wave(_)));
    let normal = run.records.iter().map(|record| &record.normal).max_by(|a, b| a.force.total_cmp(&b.force));
    let part = normal.and_then(|normal| Some(normal.stiffness * normal.indentation? / normal.force));
    part.filter(|part| chords && part.is_finite()).unwrap_or(1.0).max(1.0)
}

/// How many of what a piece may miss a state is off: one that is led on by its depth keeps what the force has missed before.
fn kept(plan: &RoundPlan) -> f64 {
    let controls = || plan.stages.iter().filter_map(|stage| stage.control);
    let led_on = controls().skip_while(|&control| control != Control::Force).any(|control| control != Control::Force);
    if led_on { CHORDS } else { 1.0 }
}

/// The records up to where a machine moves the contact, which a history that is followed again has.
fn led(run: &Run) -> Vec<Record> {
    run.records.iter().filter(|record| record.machine.is_none()).copied().collect()
}

/// How much coarser the pieces are that tell the error of fine ones: no less than it, should it fall with the root of the
/// accuracy alone, or should one of the two lose a contact that the other keeps.
const COARSER: f64 = 10.0;
/// What errors that fall with the root of the accuracy, and by chance not at all, may be beside the change they make.
const CHANCE: f64 = 1.5;
/// The largest accuracy that a scene may ask for.
const COARSEST: f64 = 0.1;

/// How a history is gone through again to tell its error.
enum Twice<'p> {
    /// An edge that obeys a rate law, under a prescribed depth: followed better.
    Finer(&'p Relaxation, &'p HeldEdge),
    /// Pieces of a depth between bodies that attract each other, whose edge may turn on next to nothing: in coarser ones, and
    /// one that obeys a rate law not as well either.
    Coarser,
}

/// How it is, if it takes that.
fn twice(plan: &RoundPlan) -> Option<Twice<'_>> {
    let ContactLaw::Continuous { relaxation, edge: Some(edge) } = &plan.contact else { return None };
    if plan.is_curved() { Some(Twice::Coarser) } else { edge.has_rate().then_some(Twice::Finer(relaxation, edge)) }
}

/// Whether the error of a history is told by going through it again.
#[must_use]
pub fn goes_twice(plan: &RoundPlan) -> bool {
    twice(plan).is_some()
}

/// The records of the history gone through again, if its error is told by them and it can be.
#[must_use]
pub fn again(plan: &RoundPlan) -> Option<Vec<Record>> {
    let finer = |relaxation, edge| compose::told(&plan.profile, viscoelastic::refined(plan, relaxation, edge));
    let (accuracy, refined) = match twice(plan)? {
        Twice::Coarser => ((COARSER * plan.accuracy()).min(COARSEST), None),
        Twice::Finer(relaxation, edge) => (plan.accuracy(), Some(finer(relaxation, edge))),
    };
    let mut plan = plan.clone();
    plan.shared.scene.accuracy = Some(Accuracy::new(accuracy).ok()?);
    let contact = refined.map_or_else(|| compose::contact(&plan, Wanted::NOTHING), Ok).ok()?;
    Some(follow(&plan, contact, Wanted::NOTHING).ok()?.records)
}

/// The error of an edge that obeys a rate law under a prescribed depth.
fn rate_error(run: &Run, again: Option<&[Record]>) -> ErrorEstimate {
    let off = again.map_or(f64::NAN, |again| apart(&led(run), again));
    of(
        sums(run) + 2.0 * off,
        "continuous bed: what the polynomials of its panels miss, and forces and energies with the opening edge followed better",
    )
}

/// The error of the bed under a body that moves along, against the largest contact.
fn gliding_error(plan: &RoundPlan, run: &Run) -> ErrorEstimate {
    let part = compose::springs_of_gliding(plan).recip();
    ErrorEstimate {
        relative: part * part + CHORDS * plan.accuracy() + run.force_error,
        basis: "bed of springs under a polygon: second order in their width, and straight pieces of the depth to the accuracy asked for; the tangential force within that part of the normal one times the slope at the edge".to_owned(),
    }
}

/// When the last record of an entry is [s], or would be.
fn end_of(records: &[Record], entry: usize) -> f64 {
    let ended = records.partition_point(|record| record.entry <= entry);
    ended.checked_sub(1).map_or(0.0, |last| records[last].time)
}

/// Whether a contact jumps at the record of that number: there are two of one time.
fn jumps_at(records: &[Record], number: usize) -> bool {
    let time = |number: usize| records.get(number).map_or(f64::NAN, |record| record.time);
    let now = time(number);
    now <= number.checked_sub(1).map_or(f64::NAN, time) || now >= time(number + 1)
}

/// How far the records of two runs are apart that have one time, or, but for the instant of a jump itself, one that may have
/// shifted where an entry ends at another time, as a pull that parts the bodies: forces and contact radii as parts of the
/// largest, energies of the largest sum.
pub(super) fn apart(one: &[Record], two: &[Record]) -> f64 {
    let energies = |record: &Record| {
        let Normal { stored, dissipated, .. } = record.normal;
        stored.elastic.abs() + stored.surface.abs() + dissipated.abs()
    };
    let radius = |record: &Record| record.normal.contact_radius.unwrap_or(0.0);
    let most = |of: &dyn Fn(&Record) -> f64| one.iter().map(of).fold(f64::MIN_POSITIVE, f64::max);
    let (force, width, energy) = (most(&|record| record.normal.force.abs()), most(&radius), most(&energies));
    let off = |one: &Record, two: &Record| {
        let (a, b) = (&one.normal, &two.normal);
        let energies = (a.stored.stored() - b.stored.stored()).abs().max((a.dissipated - b.dissipated).abs());
        let radii = (radius(one) - radius(two)).abs();
        ((a.force - b.force).abs() / force).max(radii / width).max(energies / energy)
    };
    let beside = |records: &[Record], others: &[Record], number: usize| {
        let record = &records[number];
        let from = |time: f64| others.partition_point(|other| other.time < time);
        let nearest = |shift: f64| {
            let near = others[from(record.time - shift)..].iter().take_while(|other| other.time <= record.time + shift);
            near.map(|other| off(other, record)).reduce(f64::min)
        };
        let shift = (end_of(records, record.entry) - end_of(others, record.entry)).abs();
        nearest(0.0).or_else(|| if jumps_at(records, number) { None } else { nearest(shift) })
    };
    let all = |records: &[Record], others: &[Record]| {
        (0..records.len()).filter_map(|number| beside(records, others, number)).fold(0.0, f64::max)
    };
    all(one, two).max(all(two, one))
}
