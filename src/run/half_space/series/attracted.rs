//! How bodies that attract each other come together before a history, and are drawn apart until nothing holds them.

use super::super::attraction::Attraction;
use super::super::state::State;
use super::{Goal, Series};
use crate::contact::adhesion::equilibrium::Control;
use crate::run::SimulationError;
use crate::run::record::Record;
use crate::scene::stage::Stage;

/// Steps in which bodies that attract each other come from out of reach to their touch.
const APPROACH: u32 = 16;
/// Fewest records of a pull over the range of the attraction.
const EIGHTH: f64 = 8.0;
/// Most records of a pull, in records of its entry.
const PULLED: usize = 100;

impl Series<'_> {
    /// The state at touch; bodies that attract each other have come there from out of reach.
    pub(super) fn touched(&mut self) -> Result<State, SimulationError> {
        let mut state = self.pressing.apart(0.0);
        let Some(attraction) = self.pixels.attraction() else {
            return self.leaking(0, state, || self.pressing.open(0.0));
        };
        let depth = |step: u32| -attraction.reach() * f64::from(APPROACH - step) / f64::from(APPROACH);
        let (control, over, time, slide, entry) = (Control::Indentation, 0.0, 0.0, 0.0, 0);
        for step in 0..=APPROACH {
            let (from, value) = (depth(step.saturating_sub(1)), depth(step));
            state = self.at(Goal { control, from, value, over, time, slide, entry })?;
        }
        // What led here is no part of the history.
        self.jumps.clear();
        self.least = 0.0;
        Ok(state)
    }

    /// Withdraws the indenter until nothing holds it.
    pub(super) fn pull_off(
        &mut self,
        records: &mut Vec<Record>,
        (stage, speed): (&Stage, f64),
        (start, from): (f64, f64),
    ) -> Result<f64, SimulationError> {
        let range = self.pixels.attraction().map_or(0.0, Attraction::range);
        // What only fades has no end: out of the reach from which bodies come, nothing is left to tell.
        let faded = self.pixels.attraction().filter(|pull| pull.fading().is_some()).map(Attraction::reach);
        let step = (from / stage.records as f64).max(range / EIGHTH);
        let mut time = start;
        for number in 1..=PULLED * stage.records {
            let way = step * number as f64;
            time = start + way / speed;
            let (control, slide) = (Control::Indentation, self.slide);
            let (before, value) = (from - step * (number - 1) as f64, from - way);
            let goal = Goal { control, from: before, value, over: step / speed, time, slide, entry: stage.entry };
            let state = self.at(goal)?;
            self.push(records, (stage.entry, time), state);
            if state.parted || state.count == 0 && faded.is_some_and(|reach| goal.value < -reach) {
                break;
            }
        }
        Ok(time)
    }
}
