//! The part of a history in which the contact wears.

use super::profiles::{Kept, PARTS};
use super::{Beginning, coefficient, load_of};
use crate::contact::adhesion::equilibrium::Control;
use crate::contact::error::ContactError;
use crate::contact::state::{Normal, Tangential};
use crate::run::record::{Field, Record};
use crate::run::{SimulationError, Wanted, fields};
use crate::scene::plan::RoundPlan;
use crate::scene::stage::{Path, Stage, Wave};
use crate::wear::{Load, Motion, Rubbed, Rubbing, Wearing};
use std::f64::consts::TAU;

/// Most cycles of which every turn is recorded.
const SHOWN_CYCLES: f64 = 100.0;
/// Records of a shake of more cycles, unless the scene says otherwise.
const FEW: usize = 200;
/// Part of a slide up to which the way until all slips is not worth a word.
const ONSET: f64 = 0.01;

/// A history being followed with wear.
pub(super) struct WornRun<'p> {
    plan: &'p RoundPlan,
    pub wearing: Wearing,
    pub wanted: Wanted,
    rubbing: Rubbing,
    control: Control,
    /// The last record, that of the unworn contact at the beginning.
    last: Record,
    /// Energy lost in the normal motion before anything rubbed [J].
    dissipated: f64,
    /// Energy lost to friction before the present stage [J].
    lost: f64,
    /// Way slid before the present stage, to and fro [m].
    path: f64,
    /// Whether a single stage rubs.
    alone: bool,
    pub records: Vec<Record>,
    pub fields: Vec<Field>,
    pub profiles: Vec<Kept>,
    pub notes: Vec<String>,
}

/// A way of rubbing: where it is at a part of the stage.
struct Way {
    motion: Motion,
    load: Load,
    /// Path of the motion over the whole of it.
    span: f64,
    /// Way of the indenter over the whole of it, to and fro [m].
    length: f64,
    /// Parts of the stage at which records stand.
    recorded: Vec<f64>,
}

/// The tangential springs at the beginning of a way, and what friction has taken by then.
struct Onset {
    springs: Rubbing,
    /// Slide [m] until nothing sticks, and the energy lost on it [J].
    slide: f64,
    lost: f64,
    /// ∫F ds [N m] at the beginning, and F [N].
    rubbed: f64,
    force: f64,
}

impl<'p> WornRun<'p> {
    /// The history behind what has led to `begin`.
    pub fn new(plan: &'p RoundPlan, begin: &Beginning, wearing: Wearing) -> Self {
        let (control, _) = begin.before.ends_with();
        let rubs = |stage: &&Stage| stage.tangential != Path::Stay;
        Self {
            plan,
            wearing,
            wanted: Wanted::NOTHING,
            rubbing: Rubbing::new(plan.grip(coefficient(plan))),
            control,
            last: begin.last,
            dissipated: begin.last.normal.dissipated,
            lost: begin.last.tangential.and_then(|state| state.dissipated).unwrap_or(0.0),
            path: 0.0,
            alone: plan.stages[begin.first..].iter().filter(rubs).count() == 1,
            records: Vec::new(),
            fields: Vec::new(),
            profiles: Vec::new(),
            notes: Vec::new(),
        }
    }

    /// Follows the stages from `first` on.
    pub fn followed(mut self, first: usize) -> Result<Self, SimulationError> {
        let stages = &self.plan.stages;
        for (number, stage) in stages.iter().enumerate().skip(first) {
            self.stage(stage).map_err(|source| SimulationError::Contact { entry: stage.entry, source })?;
            let ends_entry = stages.get(number + 1).is_none_or(|next| next.entry != stage.entry);
            if self.wanted.fields && ends_entry {
                let loading = self.wearing.loading(&self.rubbing);
                let label = format!("end of entry {}", stage.entry + 1);
                self.fields.push(fields::of(&loading, self.last.tangential, (label, self.last.time)));
            }
        }
        Ok(self)
    }

    fn slide(&self) -> f64 {
        self.last.tangential.map_or(0.0, |state| state.slide)
    }

    fn stage(&mut self, stage: &Stage) -> Result<(), ContactError> {
        self.control = stage.control.unwrap_or(self.control);
        self.last.entry = stage.entry;
        match stage.tangential {
            Path::To(to) => self.slide_to(stage, to),
            Path::Steady { speed } => self.slide_to(stage, self.slide() + speed * stage.over),
            Path::Wave(wave) => self.shake(stage, wave),
            Path::Stay | Path::UntilParted { .. } => self.press(stage),
        }
    }

    /// Moves the bodies across the surface, up to the record at every part of the stage.
    fn press(&mut self, stage: &Stage) -> Result<(), ContactError> {
        let (start, slide) = (self.last.time, self.slide());
        let (mut path, mut over) = (stage.normal, stage.over);
        if let Path::UntilParted { speed } = stage.normal {
            let (from, to) = (self.last.normal.indentation.unwrap_or(0.0), self.wearing.touch());
            (path, over) = (Path::To(to), (from - to).abs() / speed);
        }
        let from = load_of(self.control, &self.last);
        for part in stage.parts() {
            let load = match from {
                Load::Indentation(depth) => Load::Indentation(path.at(depth, part, over)),
                Load::Force(force) => Load::Force(path.at(force, part, over)),
            };
            self.wearing.press(load)?;
            let (springs, state) = self.wearing.rub(&self.rubbing, 0.0);
            self.rubbing = springs;
            self.lost += state.lost;
            self.record(start + part * over, tangential(state, slide, self.lost));
        }
        Ok(())
    }

    /// Slides one way as a whole.
    fn slide_to(&mut self, stage: &Stage, to: f64) -> Result<(), ContactError> {
        let (from, load) = (self.slide(), load_of(self.control, &self.last));
        let (way, recorded) = (to - from, stage.parts());
        let onset = self.onset(load, way)?;
        self.note_onset(stage, &onset, way);
        let length = way.abs();
        let state = |run: &Self, part: f64| {
            let (springs, state) = run.wearing.rub(&onset.springs, part * way);
            let lost = if part * length <= onset.slide {
                state.lost
            } else {
                let gross = run.wearing.friction() - onset.rubbed - onset.slide * onset.force;
                onset.lost + run.rubbing.grip().coefficient * gross
            };
            let slide = if part >= 1.0 { to } else { from + part * way };
            (springs, tangential(state, slide, run.lost + lost))
        };
        self.rub(stage, Way { motion: Motion::Slide, load, span: length, length, recorded }, &state)
    }

    /// Slides to and fro.
    fn shake(&mut self, stage: &Stage, wave: Wave) -> Result<(), ContactError> {
        let (middle, load, cycles) = (self.slide(), load_of(self.control, &self.last), stage.over * wave.frequency);
        let grip = self.rubbing.grip();
        let motion = Motion::Shake { amplitude: wave.amplitude, reach: grip.reach() };
        let springs = self.onset(load, 0.0)?.springs;
        let rubbed = self.wearing.friction();
        let recorded = if cycles <= SHOWN_CYCLES { stage.parts() } else { whole_cycles(cycles, self.few()) };
        let state = |run: &Self, part: f64| {
            let (springs, mut state) = (springs.clone(), Rubbed::default());
            let (mut springs, mut at) = (springs, 0.0);
            for to in turns(wave, part * cycles) {
                (springs, state) = run.wearing.rub(&springs, to - at);
                at = to;
            }
            let lost = run.lost + grip.coefficient * (run.wearing.friction() - rubbed);
            (springs, tangential(state, middle + at, lost))
        };
        let length = 4.0 * wave.amplitude * cycles;
        self.rub(stage, Way { motion, load, span: cycles, length, recorded }, &state)
    }

    fn few(&self) -> usize {
        self.plan.scene.steps.map_or(FEW, std::num::NonZeroUsize::get)
    }

    /// The springs as a way begins.
    fn onset(&mut self, load: Load, way: f64) -> Result<Onset, ContactError> {
        self.wearing.press(load)?;
        let springs = self.rubbing.clone();
        let slide = self.wearing.onset(&springs, way);
        let (_, state) = self.wearing.rub(&springs, slide * way.signum());
        let (rubbed, force) = (self.wearing.friction(), self.wearing.normal().force);
        Ok(Onset { springs, slide, lost: state.lost, rubbed, force })
    }

    fn note_onset(&mut self, stage: &Stage, onset: &Onset, way: f64) {
        let way = way.abs();
        if way > 0.0 && onset.slide > ONSET * way {
            self.notes.push(format!(
                "history[{}]: the contact slips as a whole after a slide of {:.3e} m; wear is computed as if it did from the beginning, and a slide of {way:.3e} m is not long against that",
                stage.entry, onset.slide
            ));
        }
    }

    /// Rubs from mark to mark.
    fn rub(
        &mut self,
        stage: &Stage,
        way: Way,
        state: &dyn Fn(&Self, f64) -> (Rubbing, Tangential),
    ) -> Result<(), ContactError> {
        let (start, path) = (self.last.time, self.path);
        self.wearing.begin(way.motion, way.load, way.span)?;
        self.keep(start, path);
        let shown = if self.alone { &PARTS[..] } else { &PARTS[PARTS.len() - 1..] };
        let mut springs = self.rubbing.clone();
        for (part, recorded) in marks(&way.recorded, shown) {
            self.wearing.advance(part * way.span)?;
            let time = start + part * stage.over;
            if recorded {
                let (next, tangential) = state(self, part);
                springs = next;
                self.record(time, tangential);
            }
            if shown.contains(&part) {
                self.keep(time, path + part * way.length);
            }
        }
        if !self.wearing.is_in_one_piece() {
            self.notes.push(format!(
                "history[{}]: the worn contact is not in one piece, and the mapping is exact for contacts in one piece only",
                stage.entry
            ));
        }
        (self.rubbing, self.path) = (springs, path + way.length);
        self.lost = self.last.tangential.and_then(|state| state.dissipated).unwrap_or(self.lost);
        Ok(())
    }

    /// Keeps the present profile, unless it is that of the one before.
    fn keep(&mut self, time: f64, path: f64) {
        if self.profiles.last().is_none_or(|kept| kept.path < path) {
            self.profiles.push(Kept { time, path, rings: self.wearing.surface() });
        }
    }

    fn record(&mut self, time: f64, tangential: Tangential) {
        let normal = self.wearing.normal();
        let normal = Normal { dissipated: self.dissipated + normal.dissipated, ..normal };
        let (tangential, worn) = (Some(tangential), Some(self.wearing.worn()));
        self.last = Record {
            entry: self.last.entry,
            time,
            normal,
            tangential,
            gliding: None,
            worn,
            pixels: None,
            joined: None,
            machine: None,
            spring: None,
        };
        self.records.push(self.last);
    }
}

fn tangential(state: Rubbed, slide: f64, lost: f64) -> Tangential {
    Tangential {
        slide,
        force: state.force,
        stick_radius: state.stick_radius,
        stiffness: state.stiffness,
        stored: Some(state.stored),
        dissipated: Some(lost),
        area_ratio: None,
    }
}

/// The parts at which something is kept, in order, and whether a record stands there.
fn marks(recorded: &[f64], shown: &[f64]) -> Vec<(f64, bool)> {
    let mut marks: Vec<(f64, bool)> = recorded.iter().map(|&part| (part, true)).collect();
    marks.extend(shown.iter().filter(|part| !recorded.contains(part)).map(|&part| (part, false)));
    marks.sort_by(|one, other| one.0.total_cmp(&other.0));
    marks
}

/// Parts of a shake of many cycles, at ends of cycles, each about as many times later than the one before.
fn whole_cycles(cycles: f64, count: usize) -> Vec<f64> {
    let mut parts: Vec<f64> = (1..=count).map(|k| cycles.powf(k as f64 / count as f64).round() / cycles).collect();
    if let Some(last) = parts.last_mut() {
        *last = 1.0;
    }
    parts.dedup_by(|next, kept| next <= kept);
    parts
}

/// Where a sine turns, and where it is [m], after `cycles` cycles: the last turns are enough, for they wipe out those before.
fn turns(wave: Wave, cycles: f64) -> Vec<f64> {
    let amplitude = wave.amplitude;
    let whole = (cycles - cycles.round()).abs() <= 1e-9 * cycles;
    let phase = if whole { 0.0 } else { cycles.fract() };
    let mut way = Vec::with_capacity(5);
    if cycles >= 1.0 {
        way.extend([amplitude, -amplitude]);
    }
    if phase > 0.25 {
        way.push(amplitude);
    }
    if phase > 0.75 {
        way.push(-amplitude);
    }
    way.push(if whole { 0.0 } else { amplitude * (TAU * phase).sin() });
    way
}
