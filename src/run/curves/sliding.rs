//! Curves of sliding: ways to and fro, coefficient of friction over the load, contact area over the speed.

use crate::contact::adhesion::line::EdgeLine;
use crate::contact::state::Tangential;
use crate::friction::peeling::ShearedAdhesion;
use crate::friction::sliding::{SlidingLaw, SlidingPoint, amontons_range, friction_curve};
use crate::run::record::Record;
use crate::run::sheared;
use crate::scene::history::Entry;
use crate::scene::law::FrictionLaw;
use crate::scene::plan::Plan;

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

/// μF of Coulomb friction [N], if the load stays while the body slides and the force comes near it.
#[must_use]
pub fn limit(plan: &Plan, records: &[Record]) -> Option<f64> {
    let coefficient = plan.round()?.friction.as_ref()?.coulomb()?;
    let slides = |pair: &&[Record]| match (pair[0].tangential, pair[1].tangential) {
        (Some(before), Some(after)) => (after.slide - before.slide).abs() > 0.0,
        _ => false,
    };
    let loads: Vec<f64> = records.windows(2).filter(slides).map(|pair| pair[1].normal.force).collect();
    let load = *loads.first()?;
    let constant = loads.iter().all(|other| (other - load).abs() <= 1e-9 * load);
    let limit = coefficient * load;
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
/// far as the profile goes; empty without a law.
#[must_use]
pub fn coefficient(plan: &Plan, records: &[Record]) -> Vec<SlidingPoint> {
    let (Some(ground), Some(law)) = (plan.ground(), law_of_last_slide(plan)) else { return Vec::new() };
    let line = EdgeLine::new(ground, 0.0);
    let contact = ShearedAdhesion { line, ratio: plan.pair.tangential / plan.pair.normal };
    let load = records.iter().filter_map(slid).map(|point| point.0).fold(0.0, f64::max);
    let loads = (0..=96).map(|k| load * 10f64.powf(f64::from(k) / 12.0 - 6.0));
    loads.map_while(|load| friction_curve(&contact, law.as_ref(), &[load]).ok()).flatten().collect()
}

/// Loads [N] between which Amontons' law holds on the curve, d ln F_x/d ln F within 1 % of one; an end is `None`
/// where it is that of the curve.
#[must_use]
pub fn amontons(curve: &[SlidingPoint]) -> Option<(Option<f64>, Option<f64>)> {
    let (low, high) = amontons_range(curve, AMONTONS)?;
    let (first, last) = (curve.first()?.force, curve.last()?.force);
    Some((Some(low).filter(|low| *low > first), Some(high).filter(|high| *high < last)))
}

fn law_of_last_slide(plan: &Plan) -> Option<Box<dyn SlidingLaw>> {
    let interface = plan.round()?.friction.as_ref()?.interface()?;
    let speed = speeds(plan).into_iter().rfind(|speed| *speed > 0.0).unwrap_or(0.0);
    interface.law(speed).ok()
}

/// Sliding speed [m/s] of every entry, zero of those that do not slide.
fn speeds(plan: &Plan) -> Vec<f64> {
    let mut at = 0.0;
    let mut speed = |entry: &Entry| {
        let Entry::Slide(slide) = entry else { return 0.0 };
        let way = slide.to.si() - std::mem::replace(&mut at, slide.to.si());
        way.abs() / slide.over.si()
    };
    plan.scene.history.iter().map(&mut speed).collect()
}

/// A/A_JKR of the records of a sheared adhesive contact that slide, over the sliding speed [m/s], and the force
/// [N] of the last of them; `None` if none does.
#[must_use]
pub fn area(plan: &Plan, records: &[Record]) -> Option<(Vec<(f64, f64)>, f64)> {
    let speeds = speeds(plan);
    let point = |record: &Record| Some((*speeds.get(record.entry)?, record.tangential?.area_ratio?));
    let force = records.iter().rev().find(|record| point(record).is_some())?.normal.force;
    Some((records.iter().filter_map(point).filter(|point| point.0 > 0.0).collect(), force))
}

/// A/A_JKR over the speeds [m/s] of the table of shear strength, under the force `force` [N] (Savkoor & Briggs).
#[must_use]
pub fn area_in_theory(plan: &Plan, force: f64) -> Vec<(f64, f64)> {
    let Some(plan) = plan.round() else { return Vec::new() };
    let interface = plan.friction.as_ref().and_then(FrictionLaw::interface);
    let (Some(contact), Some(interface)) = (sheared(plan), interface) else { return Vec::new() };
    let Some((least, most)) = interface.strength.as_ref().map(|curve| curve.range()) else { return Vec::new() };
    let speed = |k: i32| least * (most / least).powf(f64::from(k) / 200.0);
    let ratio = |speed: f64| {
        let stress = interface.law(speed).ok()?.stress(0.0);
        let rest = contact.under_stress(force, 0.0).ok()?.contact_radius;
        Some((speed, (contact.under_stress(force, stress).ok()?.contact_radius / rest).powi(2)))
    };
    (0..=200).filter_map(|k| ratio(speed(k))).collect()
}
