//! Rounds that go on as they went.

use super::memory::dot;
use ndarray::Array2;

/// Change of the attraction, as part of its stress, below which the rounds gather way: before, they find their branch.
const GATHERED: f64 = 0.2;

/// Rounds that gather way: each begins beyond the last one's end by a part of what that moved, which grows from round to
/// round until a step points back (Nesterov 1983; O'Donoghue & Candès 2015). A round whose step shrinks by the part 1 − κ
/// comes to its end in some 1/√κ of them, and a contact that creeps to where it snaps off is there sooner.
#[derive(Default)]
pub(super) struct Momentum {
    last: Option<Array2<f64>>,
    /// Nesterov's t, from round to round since the way was lost, less its first, which is 1.
    gathered: f64,
}

impl Momentum {
    /// The attraction, at most `most`, to go on from, after a round that led from `before` to `after`.
    pub(super) fn next(&mut self, before: &Array2<f64>, after: Array2<f64>, change: f64, most: f64) -> Array2<f64> {
        let last = self.last.replace(after.clone());
        let moved = last.filter(|_| change <= GATHERED).map(|last| &after - &last);
        let Some(moved) = moved.filter(|moved| dot(&(&after - before), moved) > 0.0) else {
            self.gathered = 0.0;
            return after;
        };
        let t = 1.0 + self.gathered;
        let next = 0.5 * (1.0 + (1.0 + 4.0 * t * t).sqrt());
        self.gathered = next - 1.0;
        (after + moved * ((t - 1.0) / next)).mapv_into(|pull| pull.clamp(0.0, most))
    }
}
