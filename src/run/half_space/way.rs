//! Where a stage leads.

use crate::contact::adhesion::equilibrium::Control;
use crate::run::record::Record;
use crate::scene::stage::{Path, Stage};

/// How a stage goes: its path, where it begins, and how long it takes [s].
#[derive(Debug, Clone, Copy)]
pub(super) struct Way {
    path: Path,
    pub(super) from: f64,
    pub(super) over: f64,
}

impl Way {
    /// From a record, or from the force [N] that was asked for when it tore the bodies apart.
    pub(super) fn of(stage: &Stage, control: Control, (present, asked): (&Record, Option<f64>)) -> Self {
        let depth = present.normal.indentation.unwrap_or(0.0);
        let from = match control {
            Control::Indentation => depth,
            Control::Force => asked.unwrap_or(present.normal.force),
        };
        match stage.normal {
            Path::UntilParted { speed } => Self { path: Path::To(0.0), from, over: depth.max(0.0) / speed },
            path @ (Path::To(_) | Path::Stay | Path::Steady { .. } | Path::Wave(_)) => {
                Self { path, from, over: stage.over }
            }
        }
    }

    pub(super) fn at(self, part: f64) -> f64 {
        self.path.at(self.from, part, self.over)
    }
}
