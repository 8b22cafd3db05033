//! A history as a row of stages: what is prescribed, from when to when, and where records stand.

use crate::contact::adhesion::equilibrium::Control;
use crate::scene::history::{Driven, Entry, Motion};
use std::f64::consts::PI;

/// Records per ramp unless the scene says otherwise: a smooth curve on paper.
const RECORDS_PER_RAMP: usize = 100;
/// Records per cycle of an oscillation.
const RECORDS_PER_CYCLE: usize = 64;

/// How a prescribed quantity moves during a stage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Path {
    /// Linearly to this value.
    To(f64),
    /// Stays.
    Stay,
    /// amplitude·sin(2π·frequency·t) about the present value.
    Wave {
        /// Amplitude [m].
        amplitude: f64,
        /// Frequency [Hz].
        frequency: f64,
    },
    /// Back at this speed [m/s] until the bodies part.
    UntilParted {
        /// Speed [m/s].
        speed: f64,
    },
}

impl Path {
    /// The value that starts at `from` at the part `part` of a stage that lasts `over` [s].
    #[must_use]
    pub fn at(self, from: f64, (part, over): (f64, f64)) -> f64 {
        match self {
            Self::To(to) if part >= 1.0 => to,
            Self::To(to) => from + part * (to - from),
            Self::Stay | Self::UntilParted { .. } => from,
            Self::Wave { amplitude, frequency } => {
                from + amplitude * (2.0 * PI * (part * over * frequency).fract()).sin()
            }
        }
    }

    /// The parts of a stage of `over` [s] at which the path turns.
    fn turns(self, over: f64) -> Vec<f64> {
        let Self::Wave { frequency, .. } = self else { return Vec::new() };
        let turn = |j: u32| (0.5 * f64::from(j) + 0.25) / (frequency * over);
        (0..u32::MAX).map(turn).take_while(|part| *part < 1.0).collect()
    }
}

/// How much of a history a stage is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Extent {
    /// A whole entry.
    Entry,
    /// One row of a table.
    Row,
}

/// A part of the history in which everything moves along one path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stage {
    /// Number of the history entry.
    pub entry: usize,
    /// What is prescribed; `None` keeps what was prescribed before.
    pub control: Option<Control>,
    /// How it moves.
    pub normal: Path,
    /// How the tangential displacement moves.
    pub tangential: Path,
    /// Duration [s]; not known beforehand for a retraction.
    pub over: f64,
    /// Number of records, at equal times.
    pub records: usize,
    /// How much of the history it is.
    pub extent: Extent,
}

/// Two records closer than this part of a stage are one.
const SAME: f64 = 1e-12;

impl Stage {
    /// The parts of the stage, up to 1, at which records stand: at equal times, and where a path turns.
    #[must_use]
    pub fn parts(&self) -> Vec<f64> {
        let even = (1..=self.records).map(|k| k as f64 / self.records as f64);
        let mut parts: Vec<f64> = self.tangential.turns(self.over);
        parts.extend(self.normal.turns(self.over));
        parts.extend(even);
        parts.sort_by(f64::total_cmp);
        // The end stays as it is, and of two others the first.
        parts.dedup_by(|next, kept| *next < 1.0 && *next - *kept < SAME);
        parts
    }
}

/// The stages of the history entries; `steps` overrides the number of records per entry.
#[must_use]
pub fn stages<'e>(entries: impl Iterator<Item = (&'e Entry, Option<&'e Motion>)>, steps: Option<usize>) -> Vec<Stage> {
    let mut all = Vec::new();
    for (number, (entry, motion)) in entries.enumerate() {
        match (entry, motion) {
            (Entry::Table(_), Some(motion)) => all.extend(of_motion(number, motion)),
            _ => all.extend(of_entry(number, entry, steps)),
        }
    }
    all
}

fn of_entry(number: usize, entry: &Entry, steps: Option<usize>) -> Option<Stage> {
    let ramp = Stage {
        entry: number,
        control: Some(Control::Indentation),
        normal: Path::Stay,
        tangential: Path::Stay,
        over: 0.0,
        records: steps.unwrap_or(RECORDS_PER_RAMP),
        extent: Extent::Entry,
    };
    let stage = match entry {
        Entry::Indent(indent) => Stage { normal: Path::To(indent.to.si()), over: indent.over.si(), ..ramp },
        Entry::Press(press) => {
            Stage { control: Some(Control::Force), normal: Path::To(press.to.si()), over: press.over.si(), ..ramp }
        }
        Entry::Hold(hold) => Stage { over: hold.over.si(), ..ramp },
        Entry::HoldForce(hold) => Stage { control: Some(Control::Force), over: hold.over.si(), ..ramp },
        Entry::Slide(slide) => {
            Stage { control: None, tangential: Path::To(slide.to.si()), over: slide.over.si(), ..ramp }
        }
        Entry::Oscillate(wave) => {
            Stage { normal: wave.path(), over: wave.over(), records: wave.records(steps), ..ramp }
        }
        Entry::Shake(wave) => {
            Stage { control: None, tangential: wave.path(), over: wave.over(), records: wave.records(steps), ..ramp }
        }
        Entry::Retract(retract) => Stage { normal: Path::UntilParted { speed: retract.speed.si() }, ..ramp },
        Entry::Impact(_) | Entry::Table(_) => return None,
    };
    Some(stage)
}

impl crate::scene::history::Oscillate {
    fn path(&self) -> Path {
        Path::Wave { amplitude: self.amplitude.si(), frequency: self.frequency.si() }
    }

    fn over(&self) -> f64 {
        self.cycles.si() / self.frequency.si()
    }

    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "clamped before"
    )]
    fn records(&self, steps: Option<usize>) -> usize {
        steps.unwrap_or((self.cycles.si() * RECORDS_PER_CYCLE as f64).ceil().clamp(1.0, 1e6) as usize)
    }
}

/// One stage per row: the first row is reached at once, the others linearly.
fn of_motion(number: usize, motion: &Motion) -> Vec<Stage> {
    let (control, values) = match &motion.control {
        Driven::Indentation(values) => (Control::Indentation, values),
        Driven::Force(values) => (Control::Force, values),
    };
    let stage = |row: usize| Stage {
        entry: number,
        control: Some(control),
        normal: Path::To(values[row]),
        tangential: motion.slide.as_ref().map_or(Path::Stay, |slide| Path::To(slide[row])),
        over: if row == 0 { motion.time[0].max(0.0) } else { motion.time[row] - motion.time[row - 1] },
        records: 1,
        extent: Extent::Row,
    };
    (0..values.len()).map(stage).collect()
}
