//! Error against run time, for every method that can answer a case.
//!
//! A method is set up once, run once cold and then warm for a while; the error is that of its answer,
//! the time the least of the warm runs.
//!
//! # Examples
//! ```
//! # #[cfg(feature = "text")] {
//! use springbed::prelude::*;
//! use springbed::check::study::Thoroughness;
//! use springbed::check::ways;
//!
//! let text = r#"(shape: Paraboloid(radius: 1), bodies: (Elastic(young: 1, poisson: 0), Rigid),
//!     history: [Indent(to: 1, over: 1)])"#;
//! let plan = Notation::Ron.plan(text, &InMemory::default()).map_err(|errors| errors[0].clone())?;
//! let study = ways::scene(&plan, Thoroughness::Brief).map_err(|why| why.to_string())?;
//! let rows = study.rows(Thoroughness::Brief, &mut |_| ());
//! assert!(rows[0].error.unwrap() < 1e-9 && rows.last().unwrap().error.unwrap() < 1e-2);
//! # }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::attempt::Attempt;
use super::clock::timed;
use super::row::{Computed, Errors, Row, Setting};
use std::time::Duration;

/// How much is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Thoroughness {
    /// Under a minute for all cases.
    Brief,
    /// Finer settings and longer repeats.
    Thorough,
}

impl Thoroughness {
    /// The settings worth their time: powers of ten from `low` to `high`, a decade less if brief.
    pub(super) fn decades(self, low: u32, high: u32) -> impl Iterator<Item = usize> {
        let end = if self == Self::Brief { high.saturating_sub(1) } else { high };
        (low..=end).map(|k| 10usize.pow(k))
    }

    /// Time for the repeats of one measurement.
    #[must_use]
    pub fn budget(self) -> Duration {
        Duration::from_millis(if self == Self::Brief { 40 } else { 400 })
    }
}

/// A method set up; each call runs it once.
type Prepared<T> = Box<dyn FnMut() -> Attempt<T>>;

/// A method at one setting, giving a `T` in each run.
pub struct Method<T = Computed> {
    /// Name.
    pub name: &'static str,
    /// How fine it works.
    pub setting: Setting,
    prepare: Box<dyn Fn() -> Attempt<Prepared<T>>>,
}

impl<T: 'static> Method<T> {
    /// A method by its set-up, which gives what is run.
    pub(super) fn new<R: FnMut() -> Attempt<T> + 'static>(
        name: &'static str,
        setting: Setting,
        prepare: impl Fn() -> Attempt<R> + 'static,
    ) -> Self {
        Self { name, setting, prepare: Box::new(move || prepare().map(|run| Box::new(run) as Prepared<T>)) }
    }

    /// A method that has nothing to set up but its own copy of `from`.
    pub(super) fn of<S: Clone + 'static>(
        name: &'static str,
        setting: Setting,
        from: &S,
        solved: impl Fn(&S) -> Attempt<T> + Copy + 'static,
    ) -> Self {
        let from = from.clone();
        Self::new(name, setting, move || {
            let from = from.clone();
            Ok(move || solved(&from))
        })
    }

    /// What the method gives, and how long it takes.
    pub(super) fn row(&self, budget: Duration, into: impl FnOnce(T) -> Computed) -> Row {
        let row = Row { method: self.name, setting: self.setting, ..Row::default() };
        match timed(|| (self.prepare)(), budget) {
            Ok((answer, times)) => Row { solved: into(answer), times: Some(times), ..row },
            Err(why) => Row { why: Some(why.to_string()), ..row },
        }
    }
}

/// Measures methods one by one; `done` is told the share of the work that is behind.
pub(super) fn measured(methods: &[Method], budget: Duration, done: &mut dyn FnMut(f64)) -> Vec<Row> {
    let all: f64 = methods.iter().map(|method| cost(&method.setting)).sum();
    let mut behind = 0.0;
    let one = |method: &Method| {
        let row = method.row(budget, |solved| solved);
        behind += cost(&method.setting);
        done(behind / all);
        row
    };
    methods.iter().map(one).collect()
}

/// Rough work of a method, in springs or pixels.
#[expect(clippy::cast_precision_loss, reason = "springs and pixels are far below 2^53")]
fn cost(setting: &Setting) -> f64 {
    let springs = setting.springs.unwrap_or(1000).max(1000) as f64;
    springs + setting.grid.map_or(0.0, |n| (n * n) as f64)
}

/// A case and the methods that can answer it.
pub struct Study {
    /// Name in tables and files, such as `hertz`.
    pub case: &'static str,
    /// What is computed, in words.
    pub about: String,
    /// The quantity whose error is shown, such as "force".
    pub quantity: &'static str,
    /// What the error is measured against.
    pub reference: String,
    /// The right answer.
    pub exact: Computed,
    /// The methods, coarse before fine.
    pub methods: Vec<Method>,
}

impl Study {
    /// Error and time of every method, in order; `done` is told the share that is behind.
    pub fn rows(&self, effort: Thoroughness, done: &mut dyn FnMut(f64)) -> Vec<Row> {
        let rows = measured(&self.methods, effort.budget(), done);
        rows.into_iter().map(|row| self.judged(row)).collect()
    }

    fn judged(&self, row: Row) -> Row {
        let row = Row { case: self.case, ..row };
        if row.why.is_some() {
            return row;
        }
        let errors = Errors::of(&row.solved.found, &self.exact.found);
        match difference(&row.solved.values, &self.exact.values) {
            Ok(error) => Row { error: Some(error), errors, ..row },
            Err(why) => Row { why: Some(why.to_string()), ..row },
        }
    }
}

/// Largest difference, relative to the largest right value.
fn difference(values: &[f64], exact: &[f64]) -> Attempt<f64> {
    if values.len() != exact.len() {
        return Err(format!("{} values where {} are right", values.len(), exact.len()).into());
    }
    let scale = exact.iter().fold(0.0f64, |most, value| most.max(value.abs()));
    let pairs: Vec<_> = values.iter().zip(exact).map(|(value, right)| ((value - right) / scale, 0.0)).collect();
    Ok(super::attempt::worst(&pairs))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::cases;

    /// Every method answers, and the finest is well better than the coarsest of its kind.
    #[test]
    fn every_method_answers_and_converges() {
        for study in cases::studies(Thoroughness::Brief).unwrap() {
            let cheap: Vec<&Method> = study.methods.iter().filter(|method| cheap(&method.setting)).collect();
            for kind in cheap.chunk_by(|one, next| one.name == next.name) {
                let rows: Vec<Row> =
                    kind.iter().map(|method| study.judged(method.row(Duration::ZERO, |solved| solved))).collect();
                let errors: Option<Vec<f64>> = rows.iter().map(|row| row.error).collect();
                let errors = errors.unwrap_or_else(|| panic!("{rows:?}"));
                // How far off is what is usually taken for layers and films is for the study to show.
                let usual = ["series", "weights"].iter().any(|word| kind[0].name.starts_with(word));
                assert!(usual || errors.iter().all(|error| *error < 0.1), "{rows:?}");
                if let [first, .., last] = errors[..] {
                    assert!(last < 0.2 * first, "{rows:?}");
                }
            }
        }
    }

    fn cheap(setting: &Setting) -> bool {
        setting.grid.is_none_or(|n| n <= 128)
            && setting.springs.is_none_or(|n| n <= 10_000)
            && setting.steps.is_none_or(|n| n <= 10_000)
    }

    #[test]
    fn a_missing_value_is_no_agreement() {
        assert!(difference(&[], &[1.0]).is_err() && difference(&[f64::NAN, 1.0], &[1.0, 1.0]).unwrap().is_nan());
        assert!((difference(&[1.0, 2.5], &[1.0, 2.0]).unwrap() - 0.25).abs() < 1e-15);
    }
}
