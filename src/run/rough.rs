//! Rough shapes: the bed of a rough line, one member of an ensemble after the other.

use super::contact::{ContactError, Event, NormalContact};
use super::ensemble::{self, Ensemble};
use super::follow::follow;
use super::named::Named;
use super::record::{ErrorEstimate, Outcome, Record};
use super::unit::Unit;
use super::{Contact, SimulationError, Wanted};
use crate::contact::adhesion::equilibrium::Control;
use crate::contact::adhesion::line::Energy;
use crate::contact::state::Normal;
use crate::scene::plan::RoughPlan;
use crate::scene::surface::Surface;
use crate::shape::rough::{BedState, RoughBed, RoughError, RoughLine, VALIDITY};
use crate::shape::{Profile, Rim};
use rayon::prelude::*;
use std::sync::Arc;

/// Part of the line at either end that a contact on a curved shape must not reach.
const MARGIN: f64 = 1.0 / 16.0;

/// The contact grows out of the line.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error(
    "at an indentation of {indentation:e} m the contact reaches the ends of the rough line: expected a `length` well above {length:e} m"
)]
pub struct LineTooShort {
    /// Indentation [m].
    pub indentation: f64,
    /// Length of the line [m].
    pub length: f64,
}

/// The bed of a rough line; indentation counts from first touch.
#[derive(Debug, Clone)]
struct RoughContact {
    bed: Arc<RoughBed>,
    state: BedState,
    /// Indentation from first touch [m].
    depth: f64,
    /// Least gap near the ends of a line on a curved shape [m], and the length of the line [m].
    ends: (f64, f64),
}

impl RoughContact {
    fn new(plan: &RoughPlan, seed: u64) -> Result<Self, RoughError> {
        let surface = &plan.surface;
        let line = RoughLine::new(&surface.rings, seed);
        let bed = RoughBed::under(&line, surface.points, plan.pair.normal, |x| plan.reduced(x))?;
        let state = bed.at_indentation(bed.first_touch());
        let ends = (least_gap_at_ends(plan.base.as_deref(), &line, surface.points)?, line.length());
        Ok(Self { bed: Arc::new(bed), state, depth: 0.0, ends })
    }
}

/// Least gap near the ends of the line; infinite over a flat, whose edge the contact may reach.
fn least_gap_at_ends(base: Option<&dyn Profile>, line: &RoughLine, points: usize) -> Result<f64, RoughError> {
    let Some(profile) = base else { return Ok(f64::INFINITY) };
    let half = 0.5 * line.length();
    if matches!(profile.rim(), Rim::Wall(end) if end <= half) {
        return Ok(f64::INFINITY);
    }
    let places = line.places(points);
    let near = places.iter().zip(line.heights(points)?).filter(|(x, _)| x.abs() > (1.0 - MARGIN) * half);
    Ok(near.map(|(x, z)| profile.reduced(x.abs()) + z).fold(f64::INFINITY, f64::min))
}

impl NormalContact for RoughContact {
    fn advance(&mut self, control: Control, to: f64, _until: f64) -> Result<Vec<Event>, ContactError> {
        let touch = self.bed.first_touch();
        (self.state, self.depth) = match control {
            Control::Indentation => (self.bed.at_indentation(touch + to), to),
            Control::Force => {
                let state = self.bed.at_force(to);
                (state, state.indentation - touch)
            }
        };
        if self.state.indentation > self.ends.0 {
            return Err(LineTooShort { indentation: self.depth, length: self.ends.1 }.into());
        }
        Ok(Vec::new())
    }

    fn state(&self) -> Normal {
        Normal {
            indentation: Some(self.depth),
            force: self.state.force,
            contact_radius: None,
            stiffness: self.state.stiffness,
            stored: Energy { elastic: self.state.energy, surface: 0.0 },
            dissipated: 0.0,
        }
    }

    fn last_depth(&self, _speed: f64) -> Result<f64, ContactError> {
        Ok(0.0)
    }

    fn pressure(&self, _r: f64) -> Option<f64> {
        None
    }

    fn surface(&self, _r: f64) -> Option<f64> {
        None
    }

    fn stress_intensity(&self) -> Option<f64> {
        None
    }

    fn joined(&self) -> bool {
        self.state.force > 0.0
    }

    fn reach(&self) -> f64 {
        0.0
    }

    fn snapshot(&self) -> Box<dyn NormalContact + '_> {
        Box::new(self.clone())
    }
}

/// Runs a scene with a rough shape, all members of its ensemble in parallel; `done` is told the share behind.
pub(super) fn run(plan: &RoughPlan, done: &(dyn Fn(f64) + Sync)) -> Result<Outcome, SimulationError> {
    let surface = &plan.surface;
    let behind = std::sync::atomic::AtomicUsize::new(0);
    let member = |&seed: &u64| {
        let records = member(plan, seed);
        let count = behind.fetch_add(1, std::sync::atomic::Ordering::Relaxed) + 1;
        done(count as f64 / surface.seeds.len() as f64);
        records
    };
    let members: Vec<Result<_, SimulationError>> = surface.seeds.par_iter().map(member).collect();
    let members = members.into_iter().collect::<Result<Vec<_>, _>>()?;
    let ensemble = Ensemble::of(&members);
    let records = ensemble::mean(&members);
    Ok(Outcome {
        results: named(surface, &records, ensemble.as_ref()),
        records,
        fields: Vec::new(),
        tables: ensemble.iter().map(Ensemble::table).collect(),
        error_estimate: estimate(),
        warnings: vec![format!("{VALIDITY}; indentation counts from first touch")],
        plan: plan.parts(),
    })
}

fn member(plan: &RoughPlan, seed: u64) -> Result<Vec<Record>, SimulationError> {
    let contact = RoughContact::new(plan, seed);
    let contact = contact.map_err(|error| SimulationError::Refused(format!("shape, seed {seed}: {error}")))?;
    let run = follow(&plan.stages, Contact { normal: Box::new(contact), tangential: None }, Wanted::NOTHING)?;
    Ok(run.records)
}

/// The named results, those of an ensemble with their deviation.
fn named(surface: &Surface, records: &[Record], ensemble: Option<&Ensemble>) -> Vec<Named> {
    let largest = |of: fn(&Record) -> f64| records.iter().map(of).fold(f64::NEG_INFINITY, f64::max);
    let depth = |record: &Record| record.normal.indentation.unwrap_or(f64::NEG_INFINITY);
    let roughness = surface.roughness();
    let mut results = vec![
        Named::number("largest_force", Unit::NEWTON, largest(|record| record.normal.force)),
        Named::number("largest_indentation", Unit::METRE, largest(depth)),
        Named::number("largest_stiffness", Unit::NEWTON_PER_METRE, largest(|record| record.normal.stiffness)),
        Named::number("largest_stored_elastic", Unit::JOULE, largest(|record| record.normal.stored.elastic)),
        Named::number("rms_height", Unit::METRE, roughness.rms_height),
        Named::number("rms_slope", Unit::ONE, roughness.rms_slope),
        Named::number("rms_curvature", Unit::PER_METRE, roughness.rms_curvature),
    ];
    results.extend(roughness.peak_to_valley.map(|height| Named::number("peak_to_valley", Unit::METRE, height)));
    results.extend(ensemble.iter().flat_map(|ensemble| ensemble.results()));
    results
}

fn estimate() -> ErrorEstimate {
    ErrorEstimate {
        relative: 0.2,
        basis: "approximate: stiffness against the full half-space over H = 0.2 to 0.9; sums of the bed are exact to rounding".to_owned(),
    }
}
