//! A history on pixels: states one after the other, each starting from the pressure of the last.

mod attracted;
mod jumps;

use super::distribution::Distribution;
use super::ledger::Ledger;
use super::pixels::Pixels;
use super::pressed::Pressed;
use super::rubbing::{Rubbed, Rubbing, Sheared, Stroke};
use super::state::{Pressing, State, of_disc};
use super::way::Way;
use crate::contact::adhesion::equilibrium::Control;
use crate::halfspace::{HalfSpaceError, Prescribed};
use crate::run::SimulationError;
use crate::run::record::Record;
use crate::scene::plan::HalfSpacePlan;
use crate::scene::stage::{Path, Stage};
use ndarray::Array2;
use std::collections::HashMap;

/// How much of each state is looked at.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Depth {
    /// All of it, with the jumps between records.
    Whole {
        /// Whether they are records too.
        told: bool,
        /// An energy \[J\] beside which what they lose is counted.
        energy: f64,
    },
    /// Where the contact is, and no more.
    Outline,
}

/// States solved so far.
pub(super) struct Series<'p> {
    plan: &'p HalfSpacePlan,
    pressing: Pressing<'p>,
    depth: Depth,
    /// Steps of the time from record to record, of bodies that remember.
    steps: u32,
    /// Elastic bodies have no past: what was solved once need not be solved again.
    known: HashMap<(bool, u64), State>,
    pixels: Pixels<'p>,
    ledger: Ledger,
    /// Entry, time [s] and state on both sides of jumps since the last record.
    jumps: Vec<(usize, f64, State)>,
    rubbing: Option<Rubbing<'p>>,
    /// Pressures under the last flat punch of a contact's outline.
    punch: Option<Array2<f64>>,
    /// Where the body has slid [m].
    slide: f64,
    /// The largest force along the surface [N], with the shear under it.
    sheared: Option<(f64, Sheared)>,
    /// The least force [N] of all that are known, between records too.
    pub(super) least: f64,
    /// The largest force of all, or area under an attraction, with what was prescribed.
    pub(super) largest: Option<(Prescribed, Pressed)>,
    pub(super) states: Vec<State>,
    pub(super) distributions: Vec<Distribution>,
}

/// Bits of a number in which two that differ by rounding agree.
const ROUNDING: u32 = 12;

fn key(control: Control, value: f64) -> (bool, u64) {
    (control == Control::Force, value.to_bits().wrapping_add(1 << (ROUNDING - 1)) >> ROUNDING)
}

/// A step: what is prescribed where it begins and ends, how long it takes, and when it ends [s].
#[derive(Debug, Clone, Copy)]
struct Goal {
    control: Control,
    from: f64,
    value: f64,
    over: f64,
    time: f64,
    /// Slide [m].
    slide: f64,
    entry: usize,
}

impl<'p> Series<'p> {
    pub(super) fn new(plan: &'p HalfSpacePlan, pressing: Pressing<'p>, depth: Depth, steps: u32) -> Self {
        let (known, states, distributions) = (HashMap::new(), Vec::new(), Vec::new());
        let (pixels, jumps) = (Pixels::new(plan, pressing), Vec::new());
        let ledger = match depth {
            Depth::Whole { energy, .. } => Ledger::beside(energy),
            Depth::Outline => Ledger::default(),
        };
        let (rubbing, slide, sheared) = (Rubbing::of(plan, pressing), 0.0, None);
        Self {
            plan,
            pressing,
            depth,
            steps,
            known,
            pixels,
            ledger,
            jumps,
            rubbing,
            punch: None,
            slide,
            sheared,
            least: 0.0,
            largest: None,
            states,
            distributions,
        }
    }

    /// Bytes of what is kept from state to state.
    pub(super) fn bytes(&self) -> usize {
        self.pixels.bytes() + self.rubbing.as_ref().map_or(0, Rubbing::bytes)
    }

    /// Pressures and shear under the largest force along the surface, if there is one.
    pub(super) fn rubbed(&self) -> Result<Option<Rubbed>, HalfSpaceError> {
        match (&self.rubbing, &self.sheared) {
            (Some(rubbing), Some((_, sheared))) => rubbing.shown(sheared),
            _ => Ok(None),
        }
    }

    /// Rows and columns.
    pub(super) fn size(&self) -> (usize, usize) {
        self.pressing.heights.values.dim()
    }

    /// How much earlier \[m\] the surface may touch between its pixels.
    pub(super) fn below_touch(&self) -> f64 {
        self.pressing.heights.below_touch(self.pressing.boundary)
    }

    /// Width and height of a pixel \[m\].
    pub(super) fn pixel(&self) -> [f64; 2] {
        self.pressing.heights.pixel
    }

    pub(super) fn pixels(&self) -> &Pixels<'p> {
        &self.pixels
    }

    /// The records of the history; `done` is told the share of it that is behind.
    pub(super) fn follow(&mut self, done: &(dyn Fn(f64) + Sync)) -> Result<Vec<Record>, SimulationError> {
        let total = self.plan.stages.iter().map(|stage| stage.parts().len()).sum::<usize>() as f64;
        let (mut records, mut control) = (Vec::new(), Control::Indentation);
        let (mut time, mut behind, mut asked) = (0.0, 0.0, None);
        let first = self.touched()?;
        let first = self.rub(0, first, Stroke::NONE)?;
        self.push(&mut records, (0, 0.0), first);
        for stage in &self.plan.stages {
            control = stage.control.unwrap_or(control);
            let Some(present) = records.last() else { continue };
            let way = Way::of(stage, control, (present, asked));
            if let (Path::UntilParted { speed }, Some(_)) = (stage.normal, self.pixels.attraction()) {
                time = self.pull_off(&mut records, (stage, speed), (time, way.from))?;
                continue;
            }
            let (mut reached, from) = (0.0, self.slide);
            self.pixels.turn();
            for part in stage.parts() {
                let state = self.stretch((stage, control, time), (&way, from), [reached, part])?;
                asked = (control == Control::Force && state.parted).then(|| way.at(part));
                reached = part;
                self.push(&mut records, (stage.entry, time + part * way.over), state);
                behind += 1.0;
                done(behind / total);
            }
            time += way.over;
        }
        Ok(records)
    }

    /// The state at the end of a part of a stage, come to in equal steps from where the last part ended.
    ///
    /// `began` is the time \[s\] and `from` the slide \[m\] the stage began with, `part` the shares of it between which the
    /// way leads.
    fn stretch(
        &mut self,
        (stage, control, began): (&Stage, Control, f64),
        (way, from): (&Way, f64),
        part: [f64; 2],
    ) -> Result<State, SimulationError> {
        let over = (part[1] - part[0]) * way.over;
        let slide = |part: f64| stage.tangential.at(from, part, way.over);
        let steps = f64::from(self.steps);
        // Where a way begins what remembers moves fastest.
        let share = |step: u32| (f64::from(step) / steps).powi(if part[0] > 0.0 { 1 } else { 2 });
        let after = |step: u32| part[0] + (part[1] - part[0]) * share(step);
        let goal = |[start, end]: [f64; 2]| Goal {
            control,
            from: way.at(start),
            value: way.at(end),
            over: (end - start) * way.over,
            time: began + end * way.over,
            slide: slide(end),
            entry: stage.entry,
        };
        for step in 1..self.steps {
            self.led(goal([step - 1, step].map(after)))?;
        }
        let state = self.at(goal([after(self.steps - 1), part[1]]))?;
        let stroke =
            Stroke { control, values: part.map(|part| way.at(part)), slide: [self.slide, slide(part[1])], over };
        self.rub(stage.entry, state, stroke)
    }

    /// What holds the body back along the surface in a state, and what has led there.
    fn rub(&mut self, entry: usize, mut state: State, stroke: Stroke) -> Result<State, SimulationError> {
        let Some(rubbing) = &mut self.rubbing else { return Ok(state) };
        let refused = |why| SimulationError::Refused(format!("history[{entry}]: {why}"));
        let tangential = rubbing.follow(stroke, &state, &self.pressing).map_err(refused)?;
        self.slide = stroke.slide[1];
        state.tangential = Some(tangential);
        let force = tangential.force.abs();
        if self.depth != Depth::Outline && force > self.sheared.as_ref().map_or(0.0, |sheared| sheared.0) {
            self.sheared = rubbing.sheared().map(|sheared| (force, sheared)).or(self.sheared.take());
        }
        Ok(state)
    }

    /// A record, after those of the jumps on the way.
    fn push(&mut self, records: &mut Vec<Record>, (entry, time): (usize, f64), state: State) {
        for (entry, time, state) in std::mem::take(&mut self.jumps) {
            self.record(records, (entry, time), state);
        }
        self.record(records, (entry, time), state);
    }

    fn record(&mut self, records: &mut Vec<Record>, (entry, time): (usize, f64), mut state: State) {
        if self.plan.surface().is_none() {
            // How wide the gap about a tip is in the mean is a matter of the window.
            (state.pixels.mean_gap, state.pixels.gap_percolates) = (None, true);
        }
        let record = Record {
            entry,
            time,
            normal: state.normal,
            tangential: state.tangential,
            gliding: None,
            worn: None,
            joined: None,
            machine: None,
            spring: None,
            pixels: Some(state.pixels),
        };
        if records.last() != Some(&record) {
            records.push(record);
        }
        self.states.push(state);
    }

    /// The state at a depth [m] from first touch or under a force [N].
    fn at(&mut self, goal: Goal) -> Result<State, SimulationError> {
        let Goal { control, value, .. } = goal;
        let mut state = if self.pixels.has_past() {
            self.solved(goal)?
        } else if value <= 0.0 {
            let depth = if control == Control::Force { 0.0 } else { value };
            let state = self.pressing.apart(depth);
            self.rubbing.iter_mut().for_each(|rubbing| rubbing.press(None));
            return self.leaking(goal.entry, state, || self.pressing.open(depth));
        } else {
            let acts_on_pressures = self.rubbing.as_ref().is_some_and(|rubbing| !rubbing.is_partial());
            match self.known.get(&key(control, value)).filter(|_| !acts_on_pressures) {
                Some(state) => *state,
                None => {
                    let state = self.solved(goal)?;
                    self.known.insert(key(control, value), state);
                    state
                }
            }
        };
        goal.round(&mut state);
        Ok(state)
    }

    fn solved(&mut self, goal: Goal) -> Result<State, SimulationError> {
        let Some(pressed) = self.led(goal)? else { return Ok(self.torn_off()) };
        self.rubbing.iter_mut().for_each(|rubbing| rubbing.press(Some(&pressed)));
        let state = self.told(goal.entry, &pressed, self.ledger.lost())?;
        let attracts = self.pixels.attraction().is_some();
        let size = |pressed: &Pressed| if attracts { pressed.contact.contact_area() } else { pressed.force() };
        if self.largest.as_ref().is_none_or(|kept| size(&pressed) > size(&kept.1)) {
            self.largest = Some((self.prescribed(goal), pressed));
        }
        Ok(state)
    }

    /// What is told of a contact, after jumps that have lost `lost` \[J\].
    fn told(&mut self, entry: usize, pressed: &Pressed, lost: f64) -> Result<State, SimulationError> {
        let partial = self.rubbing.as_ref().is_some_and(Rubbing::is_partial);
        let stiffness = if self.depth != Depth::Outline || partial {
            self.pressing.stiffness(&pressed.contact, &mut self.punch).map_err(|error| self.refused(entry, &error))?
        } else {
            0.0
        };
        let mut state = self.pressing.told(pressed, stiffness);
        state.normal.dissipated += lost;
        if self.plan.profile().is_some() && self.plan.surface().is_none() {
            state.normal.contact_radius = self.radius(pressed, &state);
        }
        state = self.leaking(entry, state, || pressed.gap.clone())?;
        if self.depth != Depth::Outline {
            self.distributions.push(Distribution::of(pressed, state.normal.force));
        }
        Ok(state)
    }

    /// The state with what its gap lets through, if that is asked for.
    fn leaking(
        &self,
        entry: usize,
        mut state: State,
        gap: impl FnOnce() -> Array2<f64>,
    ) -> Result<State, SimulationError> {
        if let (Some(fluid), Depth::Whole { .. }) = (self.plan.leak, self.depth) {
            let through = self.pressing.leaks(&gap(), fluid).map_err(|error| self.refused(entry, &error))?;
            state.pixels.leak = through.map(|[fine, _]| fine);
            state.leak_apart =
                through.map_or(0.0, |[fine, coarse]| (fine - coarse).abs() / fine.max(coarse).max(f64::MIN_POSITIVE));
        }
        Ok(state)
    }

    /// Whether the pressures of a ball are those of Hertz.
    fn is_hertzian(&self) -> bool {
        !self.pixels.has_past() && self.plan.ground.is_none()
    }

    /// Radius of one disc [m]; Hertz' pressures have second moments that those of other contacts have not.
    fn radius(&self, pressed: &Pressed, state: &State) -> Option<f64> {
        of_disc(self.is_hertzian().then_some(&self.plan.scene.shape), &pressed.contact, &state.pixels)
    }

    /// Bodies that the force has torn apart.
    fn torn_off(&mut self) -> State {
        let mut state = self.pressing.apart(0.0);
        state.normal.indentation = None;
        state.pixels.mean_gap = None;
        state.normal.stored.elastic = self.pixels.stored_apart();
        state.normal.dissipated = self.pixels.dissipated() + self.ledger.lost();
        state
    }

    fn refused(&self, entry: usize, error: &HalfSpaceError) -> SimulationError {
        SimulationError::Refused(if let HalfSpaceError::FullContact { indentation, mean } = error {
            let touch = self.pressing.touch;
            format!(
                "history[{entry}]: {:.4e} m is deeper than {:.4e} m, at which a surface that repeats is in full contact and its depth no longer decides the load: prescribe the force instead",
                indentation - touch,
                mean - touch
            )
        } else {
            format!("history[{entry}]: {error}")
        })
    }
}
