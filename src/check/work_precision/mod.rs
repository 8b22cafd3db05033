//! Error against run time, for every solver that can answer a case.
//!
//! A [`Study`] is a case with its exact answer and the solvers that can give it, each at several
//! settings. A method is set up once, run once cold and then warm for a while; the error is that of
//! the answer, the time the least of the warm runs.

mod adhesion;
mod creep;
mod elastic;
mod friction;
#[cfg(feature = "half-space")]
mod grid;
mod impact;
mod rough;
mod scene;
mod time;

pub use scene::study as scene;

use super::clock::{Times, timed};
use serde::Serialize;
use std::time::Duration;

/// What a solver gives for a case.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Answer {
    /// The numbers compared, such as the forces of a loop.
    pub values: Vec<f64>,
    /// Contact radius [m].
    pub radius: Option<f64>,
    /// Pressure at the centre [Pa].
    pub pressure: Option<f64>,
    /// Bytes of state.
    pub bytes: usize,
    /// Iterations, of a solver that iterates.
    pub iterations: Option<usize>,
}

/// A solver set up; each call runs it once. `None` if it fails.
pub type Run = Box<dyn FnMut() -> Option<Answer>>;

/// How fine a solver works.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Default)]
pub struct Setting {
    /// Number of springs of half the bed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub springs: Option<usize>,
    /// Pixels along the side of the grid.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub grid: Option<usize>,
    /// Steps in time.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub steps: Option<usize>,
}

impl Setting {
    /// Nothing to choose.
    const FREE: Self = Self { springs: None, grid: None, steps: None };

    fn springs(count: usize) -> Self {
        Self { springs: Some(count), ..Self::FREE }
    }

    fn steps(count: usize) -> Self {
        Self { steps: Some(count), ..Self::FREE }
    }
}

/// A solver at one setting.
pub struct Method {
    name: &'static str,
    setting: Setting,
    prepare: Box<dyn Fn() -> Option<Run>>,
}

impl Method {
    fn new<R: FnMut() -> Option<Answer> + 'static>(
        name: &'static str,
        setting: Setting,
        prepare: impl Fn() -> Option<R> + 'static,
    ) -> Self {
        Self { name, setting, prepare: Box::new(move || prepare().map(|run| Box::new(run) as Run)) }
    }
}

/// A case and the solvers that can answer it.
pub struct Study {
    /// Name, such as `hertz`.
    pub case: &'static str,
    /// What is computed, in words.
    pub about: String,
    /// The quantity whose error is shown, such as "force".
    pub quantity: &'static str,
    /// What the error is measured against.
    pub reference: String,
    /// Orders of convergence p drawn as reference slopes, time ∝ error^(−1/p).
    pub orders: &'static [f64],
    exact: Answer,
    methods: Vec<Method>,
}

/// Error and time of one solver at one setting.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Point {
    /// Name of the case.
    pub case: &'static str,
    /// The solver.
    pub method: &'static str,
    /// How fine it works.
    #[serde(flatten)]
    pub setting: Setting,
    /// Error of the case's quantity, relative to its largest value.
    pub error: f64,
    /// Relative error of the contact radius.
    pub radius_error: Option<f64>,
    /// Relative error of the pressure at the centre.
    pub pressure_error: Option<f64>,
    /// Run times.
    #[serde(flatten)]
    pub times: Times,
    /// Bytes of state.
    pub bytes: usize,
    /// Iterations, of a solver that iterates.
    pub iterations: Option<usize>,
}

/// How much is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Effort {
    /// Under a minute for all cases.
    Brief,
    /// Finer settings and longer repeats.
    Thorough,
}

impl Effort {
    /// The settings worth their time: powers of ten from `low` to `high`, two decades less if brief.
    fn decades(self, low: u32, high: u32) -> impl Iterator<Item = usize> {
        let end = if self == Self::Brief { high.saturating_sub(1) } else { high };
        (low..=end).map(|k| 10usize.pow(k))
    }

    /// Time for the repeats of one measurement.
    #[must_use]
    pub fn budget(self) -> Duration {
        Duration::from_millis(if self == Self::Brief { 40 } else { 400 })
    }
}

/// All studies.
#[must_use]
pub fn all(effort: Effort) -> Vec<Study> {
    let studies = [
        elastic::hertz(effort),
        adhesion::pull_off(effort),
        elastic::cone(effort),
        time::ting(effort),
        creep::ball(effort),
        impact::hertz(effort),
        friction::mindlin_loop(effort),
        rough::line(effort),
    ];
    studies.into_iter().flatten().collect()
}

impl Study {
    /// Number of points.
    #[must_use]
    pub fn len(&self) -> usize {
        self.methods.len()
    }

    /// Whether there is no solver for the case.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.methods.is_empty()
    }

    /// Measures all points in order, one at a time; `done` is called after each. A solver that fails
    /// has a NaN for its error.
    pub fn points(&self, effort: Effort, mut done: impl FnMut()) -> Vec<Point> {
        let measured = |method: &Method| {
            let point = self.point(method, effort);
            done();
            point
        };
        self.methods.iter().map(measured).collect()
    }

    fn point(&self, method: &Method, effort: Effort) -> Point {
        let nothing = || (Answer::default(), Times { warm: f64::NAN, setup: f64::NAN, first: f64::NAN });
        let (answer, times) = timed(|| (method.prepare)(), effort.budget()).unwrap_or_else(nothing);
        let one = |value: Option<f64>, exact: Option<f64>| Some((value? / exact? - 1.0).abs());
        Point {
            case: self.case,
            method: method.name,
            setting: method.setting,
            error: difference(&answer.values, &self.exact.values),
            radius_error: one(answer.radius, self.exact.radius),
            pressure_error: one(answer.pressure, self.exact.pressure),
            times,
            bytes: answer.bytes,
            iterations: answer.iterations,
        }
    }
}

/// Largest difference, relative to the largest value; NaN if a value is missing.
fn difference(values: &[f64], exact: &[f64]) -> f64 {
    if values.len() != exact.len() {
        return f64::NAN;
    }
    let scale = exact.iter().fold(0.0f64, |most, value| most.max(value.abs()));
    let apart = values.iter().zip(exact).map(|(value, right)| (value - right).abs());
    apart.fold(0.0, |most: f64, next| if next > most || next.is_nan() { next } else { most }) / scale
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every solver answers, and the finest is well better than the coarsest of its kind.
    #[test]
    fn every_method_answers_and_converges() {
        for study in all(Effort::Brief) {
            let cheap: Vec<&Method> = study.methods.iter().filter(|method| cheap(method.setting)).collect();
            for kind in cheap.chunk_by(|one, next| one.name == next.name) {
                let points: Vec<Point> = kind.iter().map(|method| study.point(method, Effort::Brief)).collect();
                assert!(points.iter().all(|point| point.error < 0.1), "{points:?}");
                if let [first, .., last] = &points[..] {
                    assert!(last.error < 0.2 * first.error, "{first:?} {last:?}");
                }
            }
        }
    }

    fn cheap(setting: Setting) -> bool {
        setting.grid.is_none_or(|n| n <= 128)
            && setting.springs.is_none_or(|n| n <= 10_000)
            && setting.steps.is_none_or(|n| n <= 10_000)
    }

    #[test]
    fn a_missing_value_is_no_agreement() {
        assert!(difference(&[], &[1.0]).is_nan() && difference(&[f64::NAN, 1.0], &[1.0, 1.0]).is_nan());
        assert!((difference(&[1.0, 2.5], &[1.0, 2.0]) - 0.25).abs() < 1e-15);
    }
}
