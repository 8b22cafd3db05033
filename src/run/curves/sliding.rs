//! Curves of sliding: ways to and fro, coefficient of friction over the load, contact area over the speed.
//!
//! # Examples
//! ```
//! use springbed::contact::state::Tangential;
//! use springbed::run::curves::sliding::{SlideDirection, ways};
//!
//! // To and fro: two ways, which share the point at which they turn.
//! let states = [0.0, 1.0, 2.0, 0.5].map(|slide| Tangential { slide, ..Tangential::default() });
//! let ways = ways(&states);
//! assert_eq!((ways[0].0, ways[1].0), (SlideDirection::Forward, SlideDirection::Backward));
//! assert_eq!((ways[0].1.len(), ways[1].1.len()), (3, 2));
//! ```

use crate::contact::adhesion::dmt::DmtBall;
use crate::contact::adhesion::line::EdgeLine;
use crate::contact::loaded::Loaded;
use crate::contact::state::Tangential;
use crate::friction::FrictionError;
use crate::friction::peeling::ShearedAdhesion;
use crate::friction::sliding::{SlidingPoint, amontons_range, friction_curve, full_slip_displacement};
use crate::run::record::Record;
use crate::run::sheared;
use crate::scene::law::{ElasticAdhesion, FrictionLaw, PixelFriction};
use crate::scene::plan::{Plan, RoundPlan, Shared};
use crate::scene::stage::Stage;
use crate::shape::Rim;

/// Deviation of d ln F_x/d ln F from one up to which Amontons' law counts as holding.
const AMONTONS: f64 = 0.01;

/// Which way a body slides.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SlideDirection {
    /// Its displacement grows.
    Forward,
    /// Its displacement falls.
    Backward,
}

/// Runs of states that slide one way; where the force turns suddenly, the turn belongs to the run after.
#[must_use]
pub fn ways(states: &[Tangential]) -> Vec<(SlideDirection, &[Tangential])> {
    let mut found = Vec::new();
    let (mut start, mut turn, mut side) = (0, 0, 0.0);
    for k in 1..states.len() {
        let step = states[k].slide - states[k - 1].slide;
        if step * side < 0.0 {
            found.extend(way(&states[start..=turn]));
            start = turn;
        }
        if step.abs() > 0.0 {
            (turn, side) = (k, step);
        }
    }
    found.extend(states.get(start..).and_then(way));
    found
}

fn way(states: &[Tangential]) -> Option<(SlideDirection, &[Tangential])> {
    let way = states.last()?.slide - states.first()?.slide;
    (way.abs() > 0.0).then_some((if way > 0.0 { SlideDirection::Forward } else { SlideDirection::Backward }, states))
}

/// Coefficient of Coulomb friction.
fn coulomb(plan: &Plan) -> Option<f64> {
    match plan {
        Plan::Round(plan) => plan.friction.as_ref()?.coulomb(),
        Plan::HalfSpace(plan) => match plan.friction.as_ref()? {
            PixelFriction::Partial { coefficient } | PixelFriction::Coupled { coefficient } => Some(*coefficient),
            PixelFriction::Gross(_) => None,
        },
        Plan::Impact(_) | Plan::Plane(_) | Plan::Rough(_) | Plan::RoughImpact(_) | Plan::Pad(_) => None,
    }
}

/// Force [N] that presses a contact beside its load: that of an attraction outside it.
fn attraction(plan: &Plan) -> f64 {
    let (Some(ElasticAdhesion::Outside { work }), Some(ground)) = (plan.direct(), plan.ground()) else { return 0.0 };
    DmtBall::new(ground, work).attraction()
}

/// μF of Coulomb friction [N], with what attracts the bodies outside the contact, if the load stays while the body slides and the force comes near it.
#[must_use]
pub fn limit(plan: &Plan, records: &[Record]) -> Option<f64> {
    let coefficient = coulomb(plan)?;
    let slides = |pair: &&[Record]| match (pair[0].tangential, pair[1].tangential) {
        (Some(before), Some(after)) => (after.slide - before.slide).abs() > 0.0,
        _ => false,
    };
    let loads: Vec<f64> = records.windows(2).filter(slides).map(|pair| pair[1].normal.force).collect();
    let load = *loads.first()?;
    let constant = loads.iter().all(|other| (other - load).abs() <= 1e-9 * load);
    let limit = coefficient * (load + attraction(plan));
    let most = records.iter().filter_map(|record| record.tangential).map(|state| state.force.abs()).fold(0.0, f64::max);
    (constant && most > 0.5 * limit).then_some(limit)
}

/// Load F [N] and coefficient F_x/F of a record that slides.
#[must_use]
pub fn slid(record: &Record) -> Option<(f64, f64)> {
    let state = record.tangential.filter(|state| state.stick_radius <= 0.0 && state.force.abs() > 0.0)?;
    (record.normal.force > 0.0).then_some((record.normal.force, state.force.abs() / record.normal.force))
}

/// Coefficient of friction of the last slide's law, from six decades below the greatest load to two above it, as
/// far as the profile goes; empty without a law or where nothing slid.
///
/// # Errors
/// The law has no strength at the speed of the slide; no contact carries a load.
pub fn coefficient(plan: &Plan, records: &[Record]) -> Result<Vec<SlidingPoint>, FrictionError> {
    let load = records.iter().filter_map(slid).map(|point| point.0).fold(0.0, f64::max);
    let interface = plan.round().and_then(|round| round.friction.as_ref()?.interface()).filter(|_| load > 0.0);
    // An attraction presses too, and F_x/F is no number of the interface.
    let interface = interface.filter(|_| !plan.adheres());
    let (Some(ground), Some(interface)) = (plan.ground(), interface) else { return Ok(Vec::new()) };
    let speed = speeds(plan).rev().map(|(_, speed)| speed).find(|speed| *speed > 0.0).unwrap_or(0.0);
    let law = interface.law(speed)?;
    let contact = ShearedAdhesion { line: EdgeLine::new(ground, 0.0), ratio: plan.pair.tangential / plan.pair.normal };
    let mut curve = Vec::new();
    for load in (0..=96).map(|k| load * 10f64.powf(f64::from(k) / 12.0 - 6.0)) {
        match friction_curve(&contact, law.as_ref(), &[load]) {
            Ok(point) => curve.extend(point),
            Err(FrictionError::ForceBeyondProfile { .. }) => break,
            Err(why) => return Err(why),
        }
    }
    Ok(curve)
}

/// Loads [N] between which Amontons' law holds on the curve, d ln F_x/d ln F within 1 % of one; an end is `None`
/// where it is that of the curve.
#[must_use]
pub fn amontons(curve: &[SlidingPoint]) -> Option<(Option<f64>, Option<f64>)> {
    let (low, high) = amontons_range(curve, AMONTONS)?;
    let (first, last) = (curve.first()?.force, curve.last()?.force);
    Some((Some(low).filter(|low| *low > first), Some(high).filter(|high| *high < last)))
}

/// What is to be said of slides too short for the gross sliding that the law of friction takes for granted.
#[must_use]
pub fn short_slides(plan: &RoundPlan, records: &[Record]) -> Vec<String> {
    let interface = plan.friction.as_ref().and_then(FrictionLaw::interface);
    let speeds = speeds(plan).filter(|(_, speed)| *speed > 0.0);
    let told = |(entry, speed): (usize, f64)| {
        let law = interface?.law(speed).ok()?;
        let end = records.iter().rfind(|record| record.entry == entry)?;
        let before = records.iter().rfind(|record| record.entry < entry)?;
        let way = (end.tangential?.slide - before.tangential?.slide).abs();
        let turned = end.tangential?.force * before.tangential?.force < 0.0;
        let once = full_slip_displacement(&loaded(plan, end)?, law.as_ref(), plan.pair.tangential);
        let needed = if turned { 2.0 * once } else { once };
        (way < needed).then(|| {
            format!(
                "history[{entry}]: a slide of {way:.3e} m is too short for gross sliding, which takes {needed:.3e} m: in truth the middle of the contact sticks, and the tangential force given is too large"
            )
        })
    };
    speeds.filter_map(told).collect()
}

/// The load of the elastic contact of a record; `None` where the bodies are apart.
fn loaded(plan: &RoundPlan, record: &Record) -> Option<Loaded> {
    let ground = plan.ground();
    let radius = ground.profile().place(record.normal.contact_radius.filter(|&a| a > 0.0)?);
    let edge_load = match (ground.profile().rim(), plan.contact.bodies().edge_work().is_some()) {
        (Rim::Wall(_), _) | (_, true) => {
            ground.modulus() * (record.normal.indentation? - ground.profile().reduced(radius))
        }
        (Rim::None | Rim::End(_), false) => 0.0,
    };
    Some(Loaded::elastic(ground, radius, edge_load))
}

/// Entry and sliding speed [m/s] of every stage; zero where the body does not slide one way.
fn speeds(plan: &Shared) -> impl DoubleEndedIterator<Item = (usize, f64)> {
    let mut at = 0.0;
    let mut speed = |stage: &Stage| {
        let from = at;
        at = stage.tangential.at(from, 1.0, stage.over);
        let way = stage.slide().map_or(0.0, |to| (to - from).abs());
        (stage.entry, if way > 0.0 { way / stage.over } else { 0.0 })
    };
    plan.stages.iter().map(&mut speed).collect::<Vec<_>>().into_iter()
}

/// A/A_JKR of the records of a sheared adhesive contact that slide, over the sliding speed [m/s], and the force
/// [N] of the last of them; `None` if none does. The rows of a table, each with a speed of its own, are no points.
#[must_use]
pub fn area(plan: &Plan, records: &[Record]) -> Option<(Vec<(f64, f64)>, f64)> {
    let speeds: Vec<(usize, f64)> = speeds(plan).collect();
    let speed = |entry: usize| {
        let mut own = speeds.iter().filter(|(of, _)| *of == entry);
        own.next().filter(|_| own.next().is_none()).map(|(_, speed)| *speed)
    };
    let point = |record: &Record| Some((speed(record.entry)?, record.tangential?.area_ratio?));
    let force = records.iter().rev().find(|record| point(record).is_some())?.normal.force;
    Some((records.iter().filter_map(point).filter(|point| point.0 > 0.0).collect(), force))
}

/// A/A_JKR over the speeds [m/s] of the table of shear strength, under the force `force` [N] (Savkoor & Briggs), as far
/// as the shear does not peel the contact off; empty without a table.
///
/// # Errors
/// No contact carries the force.
pub fn area_in_theory(plan: &Plan, force: f64) -> Result<Vec<(f64, f64)>, FrictionError> {
    let Some(plan) = plan.round() else { return Ok(Vec::new()) };
    let interface = plan.friction.as_ref().and_then(FrictionLaw::interface);
    let (Some(contact), Some(interface)) = (sheared(plan), interface) else { return Ok(Vec::new()) };
    let Some((least, most)) = interface.strength.as_ref().map(|curve| curve.range()) else { return Ok(Vec::new()) };
    let rest = contact.under_stress(force, 0.0)?.contact_radius;
    let ratio = |speed: f64| match contact.under_stress(force, interface.law(speed)?.stress(0.0)) {
        Ok(state) => Ok(Some((speed, (state.contact_radius / rest).powi(2)))),
        Err(FrictionError::Peeled { .. }) => Ok(None),
        Err(why) => Err(why),
    };
    let speed = |k: i32| least * (most / least).powf(f64::from(k) / 200.0);
    (0..=200).filter_map(|k| ratio(speed(k)).transpose()).collect()
}
