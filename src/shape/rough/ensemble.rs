//! Many random surfaces at once.

use rayon::prelude::*;

/// Mean and scatter of one result over an ensemble.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scatter {
    /// Mean over the members.
    pub mean: f64,
    /// Standard deviation between the members, √(Σ(x − mean)²/(n − 1)); zero for one member.
    pub deviation: f64,
    /// Standard error of the mean, deviation/√n.
    pub standard_error: f64,
    /// Least and greatest member.
    pub range: (f64, f64),
}

impl Scatter {
    /// Mean and scatter of values, summed in their order; `None` for no value.
    #[must_use]
    pub fn of(values: &[f64]) -> Option<Self> {
        let first = *values.first()?;
        #[expect(clippy::cast_precision_loss, reason = "members are far fewer than 2^53")]
        let n = values.len() as f64;
        let mean = first + values.iter().map(|x| x - first).sum::<f64>() / n;
        let squares: f64 = values.iter().map(|x| (x - mean) * (x - mean)).sum();
        let deviation = (squares / (n - 1.0).max(1.0)).sqrt();
        let range = values.iter().fold((first, first), |r, x| (r.0.min(*x), r.1.max(*x)));
        Some(Self { mean, deviation, standard_error: deviation / n.sqrt(), range })
    }
}

/// Runs `member` for every seed in parallel and gathers each of its results over the ensemble.
///
/// `member` maps a seed to a row of results of the same length, for instance force and stiffness at given approaches.
/// `done` is called after each member, from any thread. Rows are summed in the order of the seeds, so
/// the answer does not depend on the number of threads.
///
/// # Errors
/// The error of the first seed, in the order given, whose member failed.
pub fn ensemble<E: Send>(
    seeds: &[u64],
    member: impl Fn(u64) -> Result<Vec<f64>, E> + Sync,
    done: impl Fn(u64) + Sync,
) -> Result<Vec<Scatter>, E> {
    let run = |&seed: &u64| {
        let row = member(seed);
        done(seed);
        row
    };
    let outcomes: Vec<_> = seeds.par_iter().map(run).collect();
    let rows = outcomes.into_iter().collect::<Result<Vec<_>, E>>()?;
    let width = rows.iter().map(Vec::len).min().unwrap_or(0);
    let column = |at: usize| Scatter::of(&rows.iter().map(|row| row[at]).collect::<Vec<_>>());
    Ok((0..width).filter_map(column).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicUsize, Ordering};

    #[test]
    fn mean_and_deviation_of_known_numbers() {
        let s = Scatter::of(&[2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0]).unwrap();
        assert!((s.mean - 5.0).abs() < 1e-15 && (s.deviation - (32.0f64 / 7.0).sqrt()).abs() < 1e-15);
        assert_eq!(s.range, (2.0, 9.0));
        assert_eq!(Scatter::of(&[3.0]).unwrap().deviation.to_bits(), 0);
        assert_eq!(Scatter::of(&[]), None);
    }

    #[test]
    fn any_number_of_threads_gives_the_same_bits() {
        let member = |seed: u64| Ok::<_, ()>(vec![(seed as f64).sin(), 1.0 / (1.0 + seed as f64)]);
        let seeds: Vec<_> = (0..200).collect();
        let with = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let count = AtomicUsize::new(0);
            let answer = pool.install(|| {
                ensemble(&seeds, member, |_| {
                    count.fetch_add(1, Ordering::Relaxed);
                })
            });
            assert_eq!(count.load(Ordering::Relaxed), 200);
            answer
        };
        assert_eq!(with(1), with(3));
    }

    #[test]
    fn the_first_failing_seed_is_reported() {
        let member = |seed: u64| if seed > 4 { Err(seed) } else { Ok(vec![0.0]) };
        assert_eq!(ensemble(&[1, 9, 7], member, |_| ()), Err(9));
    }
}
