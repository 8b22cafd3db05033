//! Where a stage leads.

use crate::contact::adhesion::equilibrium::Control;
use crate::run::record::Record;
use crate::scene::stage::{Path, Stage};

/// Roundings of what is prescribed between two values.
const ROUNDINGS: f64 = 8.0;

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

    /// What is prescribed at a part of it; what rounding leaves of a way through nothing is nothing.
    pub(super) fn at(self, part: f64) -> f64 {
        let at = |part: f64| self.path.at(self.from, part, self.over);
        let (value, most) = (at(part), self.from.abs().max(at(1.0).abs()));
        if value.abs() <= ROUNDINGS * f64::EPSILON * most { 0.0 } else { value }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A force that goes through nothing is none there, whatever the rounding, and next to it what it is.
    #[test]
    fn what_goes_through_nothing_is_none() {
        for (from, to, records) in
            [(-2.811706625951746e-5, 1.9681946381662225e-4, 8.0), (-1e-13, 7e-13, 8.0), (-0.1, 0.2, 3.0)]
        {
            let way = Way { path: Path::To(to), from, over: 1.0 };
            assert_eq!(way.at(1.0 / records).to_bits(), 0.0_f64.to_bits(), "{from}");
            assert!(way.at(1.0 / records + 1e-12) > 0.0 && way.at(1.0 / records - 1e-12) < 0.0, "{from}");
        }
    }
}
