//! How long a computation takes: set-up, first run and the quickest of the warm repeats.

use serde::Serialize;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Least length of a batch that the clock tells well: a thousand times its own reading.
const BATCH: Duration = Duration::from_micros(50);

/// Times of a computation [s].
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Times {
    /// Least time of a warm run.
    #[serde(rename = "time_s")]
    pub warm: f64,
    /// Set-up.
    #[serde(rename = "setup_s")]
    pub setup: f64,
    /// First run after the set-up, caches cold.
    #[serde(rename = "first_s")]
    pub first: f64,
}

/// Sets up and runs a computation; repeats it for about `budget`, at least once more.
///
/// The least time counts: everything else a machine does makes a run longer, never shorter. Runs
/// shorter than the clock tells are timed in batches. `None` if the computation gives no answer.
pub fn timed<T, R: FnMut() -> Option<T>>(prepare: impl FnOnce() -> Option<R>, budget: Duration) -> Option<(T, Times)> {
    let start = Instant::now();
    let mut run = prepare()?;
    let setup = start.elapsed().as_secs_f64();
    let start = Instant::now();
    let answer = run()?;
    let first = start.elapsed();
    let warm = quickest(&mut || black_box(run()).is_some(), first, budget);
    Some((answer, Times { warm, setup, first: first.as_secs_f64() }))
}

/// Least time [s] of one of the runs that fit into the budget.
pub fn quickest(run: &mut dyn FnMut() -> bool, first: Duration, budget: Duration) -> f64 {
    let mut batch = 1u32;
    let mut least = f64::INFINITY;
    let end = Instant::now() + budget;
    loop {
        let start = Instant::now();
        for _ in 0..batch {
            black_box(run());
        }
        let took = start.elapsed();
        least = least.min(took.as_secs_f64() / f64::from(batch));
        if Instant::now() >= end || first > budget {
            return least;
        }
        if took < BATCH {
            batch *= 2;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A run that sleeps takes at least as long as it sleeps, and the first one is told apart.
    #[test]
    fn set_up_first_and_warm_runs_are_told_apart() {
        let prepare = || {
            std::thread::sleep(Duration::from_millis(4));
            let mut left = 8;
            Some(move || {
                std::thread::sleep(Duration::from_millis(left));
                left = 1;
                Some(left)
            })
        };
        let (answer, times) = timed(prepare, Duration::from_millis(10)).unwrap();
        assert_eq!(answer, 1);
        assert!(times.setup >= 4e-3 && times.first >= 8e-3 && times.warm >= 1e-3, "{times:?}");
        assert!(times.warm < times.first, "{times:?}");
    }

    #[test]
    fn a_run_far_below_the_reading_of_the_clock_has_a_time_above_zero() {
        let mut x = 1.0f64;
        let prepare = || {
            Some(move || {
                x = black_box(x) * 1.000_000_1;
                Some(x)
            })
        };
        let (_, times) = timed(prepare, Duration::from_millis(2)).unwrap();
        assert!(times.warm > 0.0 && times.warm < 1e-6, "{times:?}");
    }

    #[test]
    fn no_answer_is_no_time() {
        assert!(timed(|| Some(|| None::<f64>), Duration::ZERO).is_none());
    }
}
