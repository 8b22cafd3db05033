//! Sinusoidal motions.

use crate::input::quantity::{Amplitude, Frequency, Positive};
use crate::scene::stage::{Path, Stage, Wave};
use serde::{Deserialize, Serialize};

/// Records per cycle of an oscillation unless the scene says otherwise.
const RECORDS_PER_CYCLE: f64 = 64.0;

/// Sinusoidal motion about the present position.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Oscillate {
    /// Amplitude [m].
    pub amplitude: Amplitude,
    /// Frequency [Hz].
    pub frequency: Frequency,
    /// Number of cycles.
    pub cycles: Positive,
}

impl Oscillate {
    /// The depth oscillates.
    pub(super) fn deep(&self, rest: Stage) -> Stage {
        Stage { normal: self.path(), over: self.over(), ..rest }
    }

    /// The tangential displacement oscillates.
    pub(super) fn along(&self, rest: Stage) -> Stage {
        Stage { control: None, tangential: self.path(), over: self.over(), ..rest }
    }

    /// Records unless the scene says how many; not more than a million, which is refused anyway.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped before")]
    pub(super) fn records(&self) -> usize {
        (self.cycles.si() * RECORDS_PER_CYCLE).ceil().clamp(1.0, 1e6) as usize
    }

    /// Least number of records: one at each of its turns beside those asked for.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a saturating cast is meant")]
    pub(super) fn least_records(&self, steps: Option<usize>) -> usize {
        let cycles = self.cycles.si();
        let turns = (2.0 * cycles) as usize;
        steps.map_or((RECORDS_PER_CYCLE * cycles) as usize, |steps| steps.saturating_add(turns))
    }

    fn path(&self) -> Path {
        Path::Wave(Wave { amplitude: self.amplitude.si(), frequency: self.frequency.si() })
    }

    fn over(&self) -> f64 {
        self.cycles.si() / self.frequency.si()
    }
}
