//! How long a computation takes: set-up, first run and the quickest of the warm repeats.

use super::attempt::Attempt;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Least length of a batch that the clock tells well: a thousand times its own reading.
const BATCH: Duration = Duration::from_micros(50);
/// A first run this many times longer than the budget is not repeated: it has warmed up on its way.
const LONG: u32 = 10;

/// Times of a computation [s].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Times {
    /// Least time of a warm run.
    pub warm: f64,
    /// Set-up.
    pub setup: f64,
    /// First run after the set-up, caches cold.
    pub first: f64,
}

/// Sets up and runs a computation; repeats it for about `budget`.
///
/// The least time counts: everything else a machine does makes a run longer, never shorter. Runs
/// shorter than the clock tells are timed in batches.
///
/// # Errors
/// What the set-up or a run fails with.
pub fn timed<T, R: FnMut() -> Attempt<T>>(
    prepare: impl FnOnce() -> Attempt<R>,
    budget: Duration,
) -> Attempt<(T, Times)> {
    let start = Instant::now();
    let mut run = prepare()?;
    let setup = start.elapsed().as_secs_f64();
    let start = Instant::now();
    let answer = run()?;
    let first = start.elapsed();
    let warm = if first > LONG * budget { first.as_secs_f64() } else { quickest(run, first, budget)? };
    Ok((answer, Times { warm, setup, first: first.as_secs_f64() }))
}

/// Least time [s] of one of the runs that fit into the budget, at least one.
fn quickest<T>(mut run: impl FnMut() -> Attempt<T>, first: Duration, budget: Duration) -> Attempt<f64> {
    let mut batch = 1u32;
    let mut least = f64::INFINITY;
    let end = Instant::now() + budget;
    loop {
        let start = Instant::now();
        for _ in 0..batch {
            black_box(run()?);
        }
        let took = start.elapsed();
        least = least.min(took.as_secs_f64() / f64::from(batch));
        if Instant::now() >= end || first > budget {
            return Ok(least);
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
            Ok(move || {
                std::thread::sleep(Duration::from_millis(left));
                left = 1;
                Ok(left)
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
            Ok(move || {
                x = black_box(x) * 1.000_000_1;
                Ok(x)
            })
        };
        let (_, times) = timed(prepare, Duration::from_millis(2)).unwrap();
        assert!(times.warm > 0.0 && times.warm < 1e-6, "{times:?}");
    }

    #[test]
    fn a_failure_is_no_time_but_its_reason() {
        let failed = timed(|| Ok(|| Err::<f64, _>("no contact".into())), Duration::ZERO);
        assert_eq!(failed.unwrap_err().to_string(), "no contact");
    }

    #[test]
    fn a_long_run_is_not_repeated() {
        let runs = std::cell::Cell::new(0);
        let long = || {
            Ok(|| {
                runs.set(runs.get() + 1);
                std::thread::sleep(Duration::from_millis(11));
                Ok(())
            })
        };
        let (_, times) = timed(long, Duration::from_millis(1)).unwrap();
        assert!(runs.get() == 1 && (times.first - times.warm).abs() <= 0.0);
    }
}
