//! Rounds that are guessed ahead.

use ndarray::{Array2, Zip};

/// Change of the attraction, as part of its stress, below which the rounds are mixed: before, they find their branch.
const MIXED: f64 = 0.2;
/// Most rounds that one mixed round may stand for.
const FAR: f64 = 20.0;

/// Rounds that go by themselves after a guess that led astray.
const ALONE: usize = 4;

/// The last round, by which the next one is guessed: what changes by the same part in each round is summed at once
/// (Anderson 1965, of one round).
#[derive(Default)]
pub(super) struct Mixed {
    last: Option<(Array2<f64>, Array2<f64>)>,
    /// The attraction that was not taken for the last guess, and the change that led to it.
    passed_over: Option<(Array2<f64>, f64)>,
    /// Rounds still to be gone by themselves, since the last guess led astray, and how many after the next.
    alone: usize,
    patience: usize,
}

impl Mixed {
    /// The attraction to go on from, after a round that led from `before` to `after`.
    pub(super) fn next(&mut self, before: &Array2<f64>, after: Array2<f64>, change: f64, most: f64) -> Array2<f64> {
        if let Some((safe, _)) = self.passed_over.take().filter(|(_, before)| change > *before) {
            self.patience = (2 * self.patience).max(ALONE);
            self.alone = self.patience;
            self.last = None;
            return safe;
        }
        if change > MIXED || self.alone > 0 {
            self.alone = self.alone.saturating_sub(1);
            self.last = None;
            return after;
        }
        let step = &after - before;
        let Some((last, last_step)) = self.last.replace((after.clone(), step)) else { return after };
        let (mut along, mut square) = (0.0, 0.0);
        let step = &after - before;
        Zip::from(&step).and(&last_step).for_each(|now, then| {
            along += now * (now - then);
            square += (now - then).powi(2);
        });
        let share = if square > 0.0 { (along / square).clamp(-FAR, FAR) } else { 0.0 };
        self.passed_over = Some((after.clone(), change));
        Zip::from(&after).and(&last).map_collect(|&now, &then| (now - share * (now - then)).clamp(0.0, most))
    }
}
