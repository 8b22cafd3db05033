//! Stiff and extreme scenes, each against its exact answer or a law.

mod adhesion;
mod elastic;
mod friction;
mod long;
mod time;

use rayon::prelude::*;
use serde::Serialize;

/// What trying many scenes of one kind gave.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Found {
    /// Largest error, in the measure of the trial.
    pub worst: f64,
    /// Scenes tried.
    pub tried: usize,
    /// Scenes in which a law was broken.
    pub broken: usize,
}

/// Whose way is tried.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Whose {
    /// Ours: held to its bound.
    Ours,
    /// The usual one: shown beside ours.
    Usual,
}

/// Scenes of one kind over a range of values.
#[derive(Debug, Clone, Copy)]
pub struct Trial {
    /// What is extreme.
    pub name: &'static str,
    /// Range of values.
    pub range: &'static str,
    /// Exact answer or law it is held against.
    pub against: &'static str,
    /// Largest error allowed.
    pub bound: f64,
    /// Why this bound.
    pub reason: &'static str,
    /// Whose way it is.
    pub whose: Whose,
    run: fn() -> Option<Found>,
}

/// A trial with what it gave.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Row {
    /// What is extreme.
    pub name: &'static str,
    /// Range of values.
    pub range: &'static str,
    /// Exact answer or law.
    pub against: &'static str,
    /// Whose way it is.
    pub whose: Whose,
    /// Scenes tried.
    pub tried: usize,
    /// Largest error.
    pub worst: f64,
    /// Largest error allowed.
    pub bound: f64,
    /// Scenes in which a law was broken.
    pub broken: usize,
    /// Whether error and laws are as they should be; of the usual way it is not asked.
    pub passed: bool,
}

/// All trials.
#[must_use]
pub fn all() -> Vec<Trial> {
    [elastic::TRIALS, adhesion::TRIALS, time::TRIALS, friction::TRIALS, long::TRIALS].concat()
}

/// Runs trials in parallel; rows in their order. `done` is called after each, from any thread.
pub fn rows(trials: &[Trial], done: impl Fn() + Sync) -> Vec<Row> {
    let row = |trial: &Trial| {
        let row = trial.row();
        done();
        row
    };
    trials.par_iter().map(row).collect()
}

impl Trial {
    /// Runs the trial; a scene that gives no answer is an error without end.
    #[must_use]
    pub fn row(&self) -> Row {
        let found = (self.run)().unwrap_or(Found { worst: f64::NAN, tried: 0, broken: 0 });
        // Written so that a NaN fails.
        let kept = found.worst <= self.bound && found.broken == 0 && found.tried > 0;
        Row {
            name: self.name,
            range: self.range,
            against: self.against,
            whose: self.whose,
            tried: found.tried,
            worst: found.worst,
            bound: self.bound,
            broken: found.broken,
            passed: kept || self.whose == Whose::Usual,
        }
    }
}

impl Found {
    /// One more scene with its error.
    fn error(&mut self, error: f64) {
        self.tried += 1;
        self.worst = if error > self.worst || error.is_nan() { error } else { self.worst };
    }

    /// One more scene with a value and the right one.
    fn pair(&mut self, value: f64, right: f64) {
        self.error((value / right - 1.0).abs());
    }

    /// One more scene in which a law holds or not.
    fn law(&mut self, holds: bool) {
        self.tried += 1;
        self.broken += usize::from(!holds);
    }
}

/// Powers 10^(low), 10^(low + step), … up to 10^high.
fn powers(low: f64, high: f64, step: f64) -> impl Iterator<Item = f64> + Clone {
    #[expect(clippy::cast_possible_truncation, reason = "a few hundred steps")]
    let count = ((high - low) / step + 1e-9).floor() as i32;
    (0..=count).map(move |k| 10f64.powf(low + step * f64::from(k)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ours_keeps_every_bound_and_law() {
        let failed: Vec<Row> = rows(&all(), || ()).into_iter().filter(|row| !row.passed).collect();
        assert!(failed.is_empty(), "{failed:#?}");
    }

    #[test]
    fn a_trial_beyond_its_bound_or_without_answer_fails() {
        let trial = |run| Trial { run, bound: 0.1, ..elastic::TRIALS[0] };
        assert!(!trial(|| None).row().passed);
        assert!(!trial(|| Some(Found { worst: 0.2, tried: 1, broken: 0 })).row().passed);
        assert!(!trial(|| Some(Found { worst: 0.0, tried: 1, broken: 1 })).row().passed);
        assert!(!trial(|| Some(Found { worst: f64::NAN, tried: 1, broken: 0 })).row().passed);
        assert!(trial(|| Some(Found { worst: 0.1, tried: 1, broken: 0 })).row().passed);
    }

    #[test]
    fn powers_reach_both_ends() {
        let all: Vec<f64> = powers(-9.0, 3.0, 2.0).collect();
        assert!(all.len() == 7 && (all[0] / 1e-9 - 1.0).abs() < 1e-14 && (all[6] / 1e3 - 1.0).abs() < 1e-14);
    }
}
