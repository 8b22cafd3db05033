//! A history as a row of stages: what is prescribed, from when to when, and where records stand.
//!
//! # Examples
//! ```
//! use springbed::contact::adhesion::equilibrium::Control;
//! use springbed::scene::stage::{Path, Stage, Wave};
//!
//! // Records stand at equal times, and where a wave turns.
//! let wave = Path::Wave(Wave { amplitude: 1e-9, frequency: 1.0 });
//! let stage = Stage { normal: wave, over: 1.0, ..Stage::rest(0, 2) };
//! assert_eq!(stage.parts(), [0.25, 0.5, 0.75, 1.0]);
//! assert!(stage.is_curved() && stage.control == Some(Control::Indentation) && stage.force().is_none());
//! ```

use crate::contact::adhesion::equilibrium::Control;
pub use crate::drive::course::{Extent, Path, Wave};

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
    /// A stage of the entry `entry` in which the depth stays and no time passes.
    #[must_use]
    pub fn rest(entry: usize, records: usize) -> Self {
        let (normal, tangential) = (Path::Stay, Path::Stay);
        Self {
            entry,
            control: Some(Control::Indentation),
            normal,
            tangential,
            over: 0.0,
            records,
            extent: Extent::Entry,
        }
    }

    /// Whether depth or slide is a curve in time: under a prescribed force, and in a wave.
    #[must_use]
    pub fn is_curved(&self) -> bool {
        self.control == Some(Control::Force) || self.normal.is_wave() || self.tangential.is_wave()
    }

    /// The force it goes to [N], where one is prescribed.
    #[must_use]
    pub fn force(&self) -> Option<f64> {
        match (self.control?, self.normal) {
            (Control::Force, Path::To(force)) => Some(force),
            (Control::Force, Path::Stay | Path::Steady { .. } | Path::Wave(_) | Path::UntilParted { .. })
            | (Control::Indentation, _) => None,
        }
    }

    /// The tangential displacement it slides to in one way [m].
    #[must_use]
    pub fn slide(&self) -> Option<f64> {
        match self.tangential {
            Path::To(slide) => Some(slide),
            Path::Stay | Path::Steady { .. } | Path::Wave(_) | Path::UntilParted { .. } => None,
        }
    }

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
