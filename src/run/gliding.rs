//! Bodies that glide or roll over a bed with memory: their steady states, and what is named of them.

use super::SimulationError;
use super::named::Named;
use super::record::{ErrorEstimate, Record};
use super::table::{Column, Table};
use super::unit::Unit;
use crate::contact::adhesion::equilibrium::Control;
use crate::contact::gliding::{SteadyGlide, SteadyState};
use crate::contact::rough::{PerssonGlide, gliding_line};
use crate::contact::viscoelastic::Spectrum;
use crate::scene::history::Motion;
use crate::scene::law::{Start, Travel};
use crate::scene::plan::{RoughPlan, RoundPlan, Shared};
use crate::scene::surface::Surface;
use crate::shape::rough::{RoughError, RoughLine};
use rayon::prelude::*;
use std::sync::Arc;

const SPEED: Column<SteadyState> = Column::new("speed", Unit::METRE_PER_SECOND, "speed v", |state| Some(state.speed));
const COEFFICIENT: Column<SteadyState> =
    Column::new("resistance_coefficient", Unit::ONE, "resistance coefficient μ", SteadyState::coefficient);

const COLUMNS: [Column<SteadyState>; 7] = [
    SPEED,
    COEFFICIENT,
    Column::new("tangential_force", Unit::NEWTON, "tangential force Fₓ", |state| Some(state.resistance)),
    Column::new("force", Unit::NEWTON, "force F", |state| Some(state.force)),
    Column::new("indentation", Unit::METRE, "indentation d", |state| Some(state.indentation)),
    Column::new("leading_edge", Unit::METRE, "leading edge", |state| state.leading_edge),
    Column::new("trailing_edge", Unit::METRE, "trailing edge", |state| state.trailing_edge),
];

/// The last record of the history up to the entry `entry`.
pub(super) fn last_of(records: &[Record], entry: usize) -> Option<&Record> {
    records.iter().rfind(|record| record.entry <= entry)
}

/// What is held while a body moves along: the depth [m] or the force [N] to which its history has led.
pub(super) fn held(plan: &Shared, travel: &Travel, records: &[Record]) -> (Control, f64) {
    let before = plan.stages.iter().rev().filter(|stage| stage.entry < travel.entry);
    let control = before.filter_map(|stage| stage.control).next().unwrap_or(Control::Indentation);
    let last = last_of(records, travel.entry).map(|record| record.normal).unwrap_or_default();
    match control {
        Control::Indentation => (control, last.indentation.unwrap_or(0.0)),
        Control::Force => (control, last.force),
    }
}

/// The steady states of a scene, one per speed, in parallel.
///
/// # Errors
/// The contact would outgrow its profile.
pub fn steady(plan: &RoundPlan, records: &[Record]) -> Result<Vec<SteadyState>, SimulationError> {
    let Some(travel) = &plan.travel else { return Ok(Vec::new()) };
    let spectrum = Arc::new(Spectrum::new(&travel.relaxation));
    let glide = SteadyGlide::round(spectrum, plan.profile.clone(), plan.accuracy());
    at_speeds(plan, &glide, (travel, records))
}

/// The steady states of the line of a rough scene, one per speed; depths count from its own first touch.
///
/// # Errors
/// The contact would reach the ends of the line.
pub fn steady_line(
    plan: &RoughPlan,
    line: &RoughLine,
    records: &[Record],
) -> Result<Vec<SteadyState>, SimulationError> {
    let Some(travel) = &plan.travel else { return Ok(Vec::new()) };
    let refused = |error: RoughError| SimulationError::Refused(format!("shape: {error}"));
    let line = gliding_line(line, plan.surface.points, plan.base.as_deref()).map_err(refused)?;
    let glide = SteadyGlide::line(Arc::new(Spectrum::new(&travel.relaxation)), Arc::new(line));
    at_speeds(plan, &glide, (travel, records))
}

fn at_speeds(
    plan: &Shared,
    glide: &SteadyGlide,
    (travel, records): (&Travel, &[Record]),
) -> Result<Vec<SteadyState>, SimulationError> {
    let (held, entry) = (held(plan, travel, records), travel.entry);
    let one = |&speed: &f64| {
        let state = match held {
            (Control::Indentation, depth) => glide.at_depth(speed, depth),
            (Control::Force, force) => glide.at_force(speed, force),
        };
        state.map_err(|source| SimulationError::Contact { entry, source })
    };
    let states: Vec<Result<SteadyState, SimulationError>> = travel.speeds.par_iter().map(one).collect();
    states.into_iter().collect()
}

/// The mean of the members of an ensemble, speed by speed.
#[must_use]
pub fn mean(members: &[Vec<SteadyState>]) -> Vec<SteadyState> {
    let over = |row: usize| {
        let states: Vec<&SteadyState> = members.iter().filter_map(|states| states.get(row)).collect();
        let mean =
            |of: fn(&SteadyState) -> f64| states.iter().map(|state| of(state)).sum::<f64>() / (states.len() as f64);
        Some(SteadyState {
            indentation: mean(|state| state.indentation),
            force: mean(|state| state.force),
            resistance: mean(|state| state.resistance),
            work: mean(|state| state.work),
            rms_slope: states
                .iter()
                .map(|state| state.rms_slope)
                .sum::<Option<f64>>()
                .map(|sum| sum / states.len() as f64),
            ..**states.first()?
        })
    };
    let rows = members.iter().map(Vec::len).min().unwrap_or(0);
    (0..rows).filter_map(over).collect()
}

/// The steady states as a table, one row per speed.
#[must_use]
pub fn table(states: &[SteadyState]) -> Option<Table> {
    (!states.is_empty()).then(|| Table::new("glides").with(&COLUMNS, states.iter()))
}

/// A steady state on rough ground, and the area [m²] over which its heat is spread.
pub(super) type Rubbing = (SteadyState, f64);

/// Columns of a rough body that glides: the heat is F_x v/A, that of the area of contact or else the nominal one.
pub(super) const ROUGH: [Column<Rubbing>; 2] = [
    Column::new("contact_rms_slope", Unit::ONE, "root mean square slope in contact", |(state, _)| state.rms_slope),
    Column::new("heat_per_area", Unit::WATT_PER_SQUARE_METRE, "heat per area", |(state, area)| {
        (*area > 0.0).then(|| state.resistance * state.speed / area)
    }),
];

/// The named results of a rough body at one speed, or its greatest heat of many.
pub(super) fn results_of_rough(travel: Option<&Travel>, rubbing: &[Rubbing]) -> Vec<Named> {
    match (travel.map(|travel| travel.start), rubbing) {
        (Some(Start::LeftOut | Start::Followed), [one]) => {
            ROUGH.iter().filter_map(|column| column.named(one)).collect()
        }
        (Some(_), all) => {
            let heats = all.iter().filter_map(|one| (ROUGH[1].of)(one));
            let most = heats.reduce(f64::max);
            let named = |most| Named::number("largest_heat_per_area", Unit::WATT_PER_SQUARE_METRE, most);
            most.map(named).into_iter().collect()
        }
        (None, _) => Vec::new(),
    }
}

/// The steady states of a rough line with the nominal area of its surface, over which its heat is spread.
#[must_use]
pub fn rubbing(plan: &RoughPlan, states: &[SteadyState]) -> Vec<Rubbing> {
    let area = plan.surface.length().powi(2);
    states.iter().map(|&state| (state, area)).collect()
}

/// A speed on rough ground with the coefficient that Persson's theory has for it.
type Beside = (f64, Option<f64>);

const PERSSON: Column<Beside> =
    Column::new("persson_coefficient", Unit::ONE, "resistance coefficient μ", |beside| beside.1);

/// The steady states of a rough line, and beside them Persson's theory of the surface it stands for, under the same
/// nominal pressure; of a nominally flat surface.
#[must_use]
pub fn table_beside_theory(plan: &RoughPlan, states: &[SteadyState]) -> Option<Table> {
    let (table, travel) = (table(states)?.with(&ROUGH, rubbing(plan, states).iter()), plan.travel.as_ref()?);
    if plan.base.is_some() {
        return Some(table);
    }
    Some(beside_theory(table, (&plan.surface, travel), states))
}

/// The `table` of steady states on a nominally flat `surface`, and beside it Persson's theory.
#[must_use]
pub(super) fn beside_theory(table: Table, (surface, travel): (&Surface, &Travel), states: &[SteadyState]) -> Table {
    let (spectrum, rings) = (Spectrum::new(&travel.relaxation), &surface.rings);
    let beside = |state: &SteadyState| {
        let pressure = state.force / surface.length().powi(2);
        let theory = PerssonGlide { rings, spectrum: &spectrum, pressure };
        (state.speed, (pressure > 0.0).then(|| theory.coefficient(state.speed)))
    };
    let rows: Vec<Beside> = states.iter().map(beside).collect();
    table.with(&[PERSSON], rows.iter())
}

/// The named results.
#[must_use]
pub fn results(travel: Option<&Travel>, records: &[Record], states: &[SteadyState]) -> Vec<Named> {
    let Some(travel) = travel else { return Vec::new() };
    match (travel.start, states) {
        (Start::Followed, states) => followed(travel, records, states),
        (Start::LeftOut, [state]) => {
            COLUMNS.iter().filter(|column| is_own(column)).filter_map(|column| column.named(state)).collect()
        }
        (Start::LeftOut, states) => largest(states),
    }
}

/// Whether a column is not a result of the history already.
fn is_own(column: &Column<SteadyState>) -> bool {
    !["speed", "force", "indentation"].contains(&column.quantity)
}

/// Of a start that has been followed: the state at its end, and the one it tends to.
fn followed(travel: &Travel, records: &[Record], states: &[SteadyState]) -> Vec<Named> {
    let last =
        last_of(records, travel.entry).and_then(|record| Some((record.tangential_force()?, record.normal.force)));
    let coefficient = last.filter(|(_, force)| *force > 0.0).map(|(resistance, force)| resistance / force);
    let largest = records.iter().filter_map(Record::tangential_force).reduce(f64::max);
    let found = [
        ("resistance_coefficient", Unit::ONE, coefficient),
        ("steady_resistance_coefficient", Unit::ONE, states.last().and_then(SteadyState::coefficient)),
        ("tangential_force", Unit::NEWTON, last.map(|(resistance, _)| resistance)),
        ("steady_tangential_force", Unit::NEWTON, states.last().map(|state| state.resistance)),
        ("largest_tangential_force", Unit::NEWTON, largest),
    ];
    found.into_iter().filter_map(|(name, unit, number)| Some(Named::number(name, unit, number?))).collect()
}

/// Of many speeds: where the resistance is largest.
fn largest(states: &[SteadyState]) -> Vec<Named> {
    let known = states.iter().filter_map(|state| Some((state.coefficient()?, state)));
    let Some((coefficient, state)) = known.max_by(|one, other| one.0.total_cmp(&other.0)) else { return Vec::new() };
    vec![
        Named::number("largest_resistance_coefficient", Unit::ONE, coefficient),
        Named::number("speed_of_largest_resistance", Unit::METRE_PER_SECOND, state.speed),
        Named::number("largest_tangential_force", Unit::NEWTON, state.resistance),
    ]
}

/// What the error of a steady state on a bed is.
pub const OF_CHORDS: &str =
    "steady motion: force, resistance and depth against those with half as many chords of the profile";

/// The estimate, unless a steady state is known less well; `basis` says from what that is known.
#[must_use]
pub fn at_least(estimate: ErrorEstimate, states: &[SteadyState], basis: &str) -> ErrorEstimate {
    let error = states.iter().map(|state| state.error).fold(0.0, f64::max);
    if error <= estimate.relative {
        return estimate;
    }
    ErrorEstimate { relative: error, basis: basis.to_owned() }
}

/// What a bed says of a round body that moves along.
#[must_use]
pub fn remark(plan: &RoundPlan) -> Option<String> {
    let name = match plan.travel.as_ref()?.motion {
        Motion::Glides => "glides",
        Motion::Rolls => "rolls",
    };
    Some(format!(
        "the contact of a body that {name} is not round: its one-dimensional profile on a bed gives the resistance in its order of size and its course over the speed, not exactly (Popov & Heß 2015, ch. 7): under a ball twice that of the half-space at low speeds, the same at high ones; `solver: HalfSpace()` computes it"
    ))
}
