//! A history on pixels: states one after the other, each starting from the pressure of the last.

use super::distribution::Distribution;
use super::state::{Pressing, State, of_disc};
use crate::contact::adhesion::equilibrium::Control;
use crate::halfspace::{HalfSpaceError, Prescribed, Solution, Start};
use crate::run::SimulationError;
use crate::run::record::Record;
use crate::scene::plan::HalfSpacePlan;
use crate::scene::stage::{Path, Stage};
use std::collections::HashMap;

/// How much of each state is looked at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Depth {
    /// All of it.
    Whole,
    /// Where the contact is, and no more.
    Outline,
}

/// States solved so far. Elastic bodies have no past: what was solved once need not be solved again.
pub(super) struct Series<'p> {
    plan: &'p HalfSpacePlan,
    pressing: Pressing<'p>,
    depth: Depth,
    known: HashMap<(bool, u64), State>,
    last: Option<Solution>,
    /// The largest force of all, with what was prescribed.
    pub(super) largest: Option<(Prescribed, Solution)>,
    pub(super) states: Vec<State>,
    pub(super) distributions: Vec<Distribution>,
}

/// Bits of a number in which two that differ by rounding agree.
const ROUNDING: u32 = 12;

fn key(control: Control, value: f64) -> (bool, u64) {
    (control == Control::Force, value.to_bits().wrapping_add(1 << (ROUNDING - 1)) >> ROUNDING)
}

impl<'p> Series<'p> {
    pub(super) fn new(plan: &'p HalfSpacePlan, pressing: Pressing<'p>, depth: Depth) -> Self {
        let (known, states, distributions) = (HashMap::new(), Vec::new(), Vec::new());
        Self { plan, pressing, depth, known, last: None, largest: None, states, distributions }
    }

    /// The records of the history; `done` is told the share of it that is behind.
    pub(super) fn follow(&mut self, done: &(dyn Fn(f64) + Sync)) -> Result<Vec<Record>, SimulationError> {
        let total = self.plan.stages.iter().map(|stage| stage.parts().len()).sum::<usize>() as f64;
        let (mut records, mut control) = (Vec::new(), Control::Indentation);
        let mut time = 0.0;
        self.push(&mut records, (0, 0.0), self.pressing.apart(0.0));
        let mut behind = 0.0;
        for stage in &self.plan.stages {
            control = stage.control.unwrap_or(control);
            let Some(present) = records.last() else { continue };
            let (path, from, over) = way(stage, control, present);
            for part in stage.parts() {
                let state = self.at(control, path.at(from, part, over), stage.entry)?;
                self.push(&mut records, (stage.entry, time + part * over), state);
                behind += 1.0;
                done(behind / total);
            }
            time += over;
        }
        Ok(records)
    }

    fn push(&mut self, records: &mut Vec<Record>, (entry, time): (usize, f64), mut state: State) {
        if self.plan.surface().is_none() {
            // How wide the gap about a tip is in the mean is a matter of the window.
            (state.pixels.mean_gap, state.pixels.gap_percolates) = (None, true);
        }
        let record = Record {
            entry,
            time,
            normal: state.normal,
            tangential: None,
            gliding: None,
            worn: None,
            machine: None,
            pixels: Some(state.pixels),
        };
        if records.last() != Some(&record) {
            records.push(record);
        }
        self.states.push(state);
    }

    /// The state at a depth [m] from first touch or under a force [N].
    fn at(&mut self, control: Control, value: f64, entry: usize) -> Result<State, SimulationError> {
        if value <= 0.0 {
            return Ok(self.pressing.apart(if control == Control::Force { 0.0 } else { value }));
        }
        let key = key(control, value);
        let mut state = match self.known.get(&key) {
            Some(state) => *state,
            None => {
                let state = self.solved(control, value).map_err(|error| self.refused(entry, &error))?;
                self.known.insert(key, state);
                state
            }
        };
        // The last digits are those prescribed.
        match control {
            Control::Indentation => state.normal.indentation = Some(value),
            Control::Force => state.normal.force = value,
        }
        Ok(state)
    }

    fn solved(&mut self, control: Control, value: f64) -> Result<State, HalfSpaceError> {
        let prescribed = match control {
            Control::Indentation => Prescribed::Indentation(self.pressing.touch + value),
            Control::Force => Prescribed::Force(value),
        };
        let start = self.last.as_ref().map_or(Start::Coarser, |last| Start::Pressure(last.pressure.view()));
        let solution = self.pressing.solve(prescribed, start)?;
        let stiffness = if self.depth == Depth::Whole { self.pressing.stiffness(&solution)? } else { 0.0 };
        let mut state = self.pressing.told(&solution, stiffness);
        if self.plan.profile().is_some() && self.plan.surface().is_none() {
            state.normal.contact_radius = of_disc(&self.plan.scene.shape, &solution, &state.pixels);
        }
        if self.depth == Depth::Whole {
            self.distributions.push(Distribution::of(&solution, &self.pressing.gap(&solution), state.normal.force));
        }
        let force = |kept: &(Prescribed, Solution)| kept.1.force();
        if self.largest.as_ref().is_none_or(|kept| solution.force() > force(kept)) {
            self.largest = Some((prescribed, solution.clone()));
        }
        self.last = Some(solution);
        Ok(state)
    }

    fn refused(&self, entry: usize, error: &HalfSpaceError) -> SimulationError {
        SimulationError::Refused(match error {
            HalfSpaceError::FullContact { indentation, mean } => {
                let touch = self.pressing.touch;
                format!(
                    "history[{entry}]: {:.4e} m is deeper than {:.4e} m, at which a surface that repeats is in full contact and its depth no longer decides the load: prescribe the force instead",
                    indentation - touch,
                    mean - touch
                )
            }
            other => format!("history[{entry}]: {other}"),
        })
    }
}

/// How a stage goes: its path, where it begins, and how long it takes [s].
fn way(stage: &Stage, control: Control, present: &Record) -> (Path, f64, f64) {
    let depth = present.normal.indentation.unwrap_or(0.0);
    let from = match control {
        Control::Indentation => depth,
        Control::Force => present.normal.force,
    };
    match stage.normal {
        Path::UntilParted { speed } => (Path::To(0.0), from, depth.max(0.0) / speed),
        path @ (Path::To(_) | Path::Stay | Path::Steady { .. } | Path::Wave(_)) => (path, from, stage.over),
    }
}
