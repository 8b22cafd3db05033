//! Tangential loops, stick and slip, shear stress, fretting, sliding friction against load.

use super::fields::shown;
use crate::app::figure::{Axis, Guide, Hue, Line, Mark, Marks, Panel, Series};
use crate::contact::adhesion::line::EdgeLine;
use crate::friction::Friction;
use crate::friction::peeling::ShearedAdhesion;
use crate::friction::sliding::{SlidingLaw, SlidingPoint, amontons_range, friction_curve};
use crate::friction::state::Tangential;
use crate::run::record::{Field, FieldRow, Outcome, Record};
use crate::run::sheared;
use crate::scene::Plot;
use crate::scene::history::Entry;
use crate::scene::setup::Setup;

/// Deviation of d ln F_x/d ln F from one up to which Amontons' law counts as holding.
const AMONTONS: f64 = 0.01;

/// What suits a scene with friction that asks for nothing.
pub fn suiting(setup: &Setup, outcome: &Outcome) -> Vec<Plot> {
    match (&setup.scene.friction, &setup.scene.adhesion) {
        (Some(Friction::Coulomb(_)), _) if outcome.fretting.is_empty() => {
            vec![Plot::Friction, Plot::Stick, Plot::Shear]
        }
        (Some(Friction::Coulomb(_)), _) => vec![Plot::Friction, Plot::Stick, Plot::Shear, Plot::Fretting],
        (_, Some(_)) => vec![Plot::Friction, Plot::Area, Plot::Radius, Plot::Pressure],
        (_, None) => vec![Plot::Friction, Plot::Coefficient, Plot::Shear],
    }
}

/// Tangential force against displacement, forwards and backwards.
pub fn loops(setup: &Setup, records: &[Record]) -> Panel {
    let panel = Panel::new(Axis::linear("tangential displacement uₓ", "m"), Axis::linear("tangential force Fₓ", "N"));
    let states: Vec<Tangential> = records.iter().filter_map(|record| record.tangential).collect();
    let panel = ways(&states).into_iter().fold(panel, |panel, (label, way)| {
        panel.with(Series::new(label, way.iter().map(|state| (state.slide, state.force)).collect()).arrow())
    });
    let Some(limit) = limit(setup, records) else { return panel };
    panel.guide(Guide::horizontal(limit, "μF")).guide(Guide::horizontal(-limit, "−μF"))
}

/// μF of Coulomb friction, if the load stays while the body slides and the force comes near it.
fn limit(setup: &Setup, records: &[Record]) -> Option<f64> {
    let Some(Friction::Coulomb(law)) = &setup.scene.friction else { return None };
    let slides = |pair: &&[Record]| match (pair[0].tangential, pair[1].tangential) {
        (Some(before), Some(after)) => (after.slide - before.slide).abs() > 0.0,
        _ => false,
    };
    let loads: Vec<f64> = records.windows(2).filter(slides).map(|pair| pair[1].normal.force).collect();
    let load = *loads.first()?;
    let constant = loads.iter().all(|other| (other - load).abs() <= 1e-9 * load);
    let limit = law.coefficient.si() * load;
    let most = records.iter().filter_map(|record| record.tangential).map(|state| state.force.abs()).fold(0.0, f64::max);
    (constant && most > 0.5 * limit).then_some(limit)
}

/// Runs of states that slide one way; where the force turns suddenly, the turn belongs to the run after.
fn ways(states: &[Tangential]) -> Vec<(&'static str, &[Tangential])> {
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

fn way(states: &[Tangential]) -> Option<(&'static str, &[Tangential])> {
    let way = states.last()?.slide - states.first()?.slide;
    (way.abs() > 0.0).then_some((if way > 0.0 { "forward" } else { "backward" }, states))
}

/// Radius of the contact and of its sticking part over time from the first slide on; between them is
/// the slip annulus.
pub fn stick(records: &[Record]) -> Panel {
    let slides = |record: &Record| record.tangential.is_some_and(|state| state.slide.abs() > 0.0);
    let first = records.iter().position(slides).map_or(0, |first| first.saturating_sub(1));
    let records = &records[first..];
    let of = |radius: &dyn Fn(&Record) -> Option<f64>| {
        records.iter().map(|record| (record.time, radius(record).unwrap_or(f64::NAN))).collect::<Vec<_>>()
    };
    Panel::new(Axis::linear("time t", "s"), Axis::linear("radius", "m").from(0.0))
        .with(Series::new("contact a", of(&|record| record.normal.contact_radius)))
        .with(Series::new("stick c", of(&|record| Some(record.tangential?.stick_radius))))
}

/// Shear stress over the radius at the ends of the last entries, with the limit the pressure sets.
pub fn stress(setup: &Setup, outcome: &Outcome) -> Option<Panel> {
    let rubs = |field: &&&Field| field.rows.iter().any(|row| row.shear.is_some_and(|tau| tau.abs() > 0.0));
    let all = shown(&outcome.fields);
    let fields: Vec<&&Field> = all.iter().filter(rubs).take(3).collect();
    let panel = Panel::new(Axis::linear("radius r", "m").from(0.0), Axis::linear("shear stress τ", "Pa"));
    let panel = fields.iter().fold(panel, |panel, field| {
        let inside = field.rows.iter().filter(|row| row.radius <= 1.2 * field.contact_radius);
        panel.with(Series::new(
            field.label.clone(),
            inside.map(|row| (row.radius, row.shear.unwrap_or(f64::NAN))).collect(),
        ))
    });
    let field = fields.first()?;
    let Some(Friction::Coulomb(law)) = &setup.scene.friction else { return Some(panel) };
    let largest = field.rows.iter().filter_map(|row| row.shear).max_by(|x, y| x.abs().total_cmp(&y.abs()))?;
    let coefficient = law.coefficient.si() * largest.signum();
    let limit = |row: &FieldRow| (row.radius, coefficient * row.pressure.unwrap_or(f64::NAN));
    let inside = field.rows.iter().filter(|row| row.radius <= field.contact_radius);
    let series = Series::new("limit μp", inside.map(limit).collect());
    Some(panel.with(series.line(Line::Dotted).colour(Hue::Black)))
}

/// Energy lost at the surface over the radius.
pub fn fretting(outcome: &Outcome) -> Option<Panel> {
    let points: Vec<(f64, f64)> = outcome.fretting.iter().map(|row| (row.position, row.per_area)).collect();
    let axes = (Axis::linear("radius r", "m").from(0.0), Axis::linear("energy lost per area", "J/m^2").from(0.0));
    (!points.is_empty()).then(|| {
        Panel::new(axes.0, axes.1).with(Series::new("", points)).note("Wear by Archard's law is proportional to it.")
    })
}

/// Coefficient of friction over the load, and where Amontons' law holds.
pub fn coefficient(setup: &Setup, outcome: &Outcome) -> Option<Panel> {
    let line = EdgeLine::new(setup.ground(), 0.0);
    let contact = ShearedAdhesion { line, ratio: setup.pair.tangential / setup.pair.normal };
    let law = law_of_last_slide(setup)?;
    let slid: Vec<(f64, f64)> = outcome.records.iter().filter_map(slid).collect();
    let load = slid.iter().map(|point| point.0).fold(0.0, f64::max);
    let curve = curve(&contact, law.as_ref(), load);
    let panel = Panel::new(Axis::log("normal force F", "N"), Axis::log("friction coefficient Fₓ/F", "1"))
        .with(Series::new("law", curve.iter().map(|point| (point.force, point.coefficient)).collect()))
        .with(Series::new("this scene", slid).line(Line::Absent).marks(Marks::As(Mark::Disc)));
    Some(amontons(panel, &curve))
}

/// Load and coefficient of a record that slides.
fn slid(record: &Record) -> Option<(f64, f64)> {
    let state = record.tangential.filter(|state| state.stick_radius <= 0.0 && state.force.abs() > 0.0)?;
    (record.normal.force > 0.0).then_some((record.normal.force, state.force.abs() / record.normal.force))
}

/// Six decades below the load to two above it, as far as the profile goes.
fn curve(contact: &ShearedAdhesion, law: &dyn SlidingLaw, load: f64) -> Vec<SlidingPoint> {
    let loads = (0..=96).map(|k| load * 10f64.powf(f64::from(k) / 12.0 - 6.0));
    loads.map_while(|load| friction_curve(contact, law, &[load]).ok()).flatten().collect()
}

fn amontons(panel: Panel, curve: &[SlidingPoint]) -> Panel {
    let range = amontons_range(curve, AMONTONS).zip(curve.first().zip(curve.last()));
    let Some(((low, high), (first, last))) = range else {
        return panel.note("Amontons' law holds nowhere here: d ln Fₓ/d ln F differs from 1 by more than 1 %.");
    };
    let panel = if low > first.force { panel.guide(Guide::vertical(low, "Amontons' law from here")) } else { panel };
    let panel = if high < last.force { panel.guide(Guide::vertical(high, "Amontons' law up to here")) } else { panel };
    panel.note("Amontons' law counts as holding while d ln Fₓ/d ln F is within 1 % of 1.")
}

fn law_of_last_slide(setup: &Setup) -> Option<Box<dyn SlidingLaw>> {
    let friction = setup.scene.friction.as_ref()?;
    let speed = speeds(setup).into_iter().rfind(|speed| *speed > 0.0).unwrap_or(0.0);
    friction.law(speed, setup.strength.as_ref()).ok()
}

/// Sliding speed [m/s] of every entry, zero of those that do not slide.
fn speeds(setup: &Setup) -> Vec<f64> {
    let mut at = 0.0;
    let mut speed = |entry: &Entry| {
        let Entry::Slide(slide) = entry else { return 0.0 };
        let way = slide.to.si() - std::mem::replace(&mut at, slide.to.si());
        way.abs() / slide.over.si()
    };
    setup.scene.history.iter().map(&mut speed).collect()
}

/// A/A_JKR of a sheared adhesive contact: over the sliding speed if there are several, else over time.
pub fn area(setup: &Setup, outcome: &Outcome) -> Option<Panel> {
    let hertz = outcome.number("hertz_area_ratio")?;
    let speeds = speeds(setup);
    let point = |record: &Record| Some((*speeds.get(record.entry)?, record.tangential?.area_ratio?));
    let points: Vec<(f64, f64)> = outcome.records.iter().filter_map(point).filter(|point| point.0 > 0.0).collect();
    let ratio = Axis::linear("area of contact over area at rest A/A₀", "1").from((hertz - 0.02).max(0.0)).to(1.02);
    let panel = Panel::new(Axis::log("sliding speed v", "m/s"), ratio)
        .guide(Guide::horizontal(1.0, "JKR"))
        .guide(Guide::horizontal(hertz, "Hertz"));
    let force = outcome.records.iter().rev().find(|record| point(record).is_some())?.normal.force;
    let panel = match theory(setup, force) {
        line if line.is_empty() => panel,
        line => panel.with(Series::new("Savkoor & Briggs", line)),
    };
    Some(panel.with(Series::new("this scene", points).line(Line::Absent).marks(Marks::As(Mark::Disc))))
}

/// A/A_JKR over the speeds of the table of shear strength, under the force of the scene.
fn theory(setup: &Setup, force: f64) -> Vec<(f64, f64)> {
    let (Some(contact), Some(friction), Some(curve)) = (sheared(setup), &setup.scene.friction, &setup.strength) else {
        return Vec::new();
    };
    let (least, most) = curve.range();
    let speed = |k: i32| least * (most / least).powf(f64::from(k) / 200.0);
    let ratio = |speed: f64| {
        let stress = friction.law(speed, Some(curve)).ok()?.stress(0.0);
        let rest = contact.under_stress(force, 0.0).ok()?.contact_radius;
        Some((speed, (contact.under_stress(force, stress).ok()?.contact_radius / rest).powi(2)))
    };
    (0..=200).filter_map(|k| ratio(speed(k))).collect()
}
