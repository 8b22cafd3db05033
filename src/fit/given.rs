//! What is known roughly, such as the radius of a probe, and how far that moves what a fit finds.
//!
//! A number known as g ± s shifts every parameter by [θ(g + s) − θ(g − s)]/2, found by two more searches, each from the
//! answer on; the shifts of several numbers add to the scatter of the noise by their squares.

use super::answer::Fit;
use super::curve::Curve;
use super::free::number;
use super::noise::NORMAL;
use super::solve::{Found, Task};
use super::{Free, Question};
use crate::text::place::{Places, Value};

/// A number of the scene that is known with a standard error.
#[derive(Debug, Clone, PartialEq)]
pub struct Given {
    /// Its place in the scene.
    pub path: String,
    /// Value [SI unit].
    pub value: f64,
    /// Standard error [SI unit].
    pub spread: f64,
    /// SI unit; empty for a pure number.
    pub unit: &'static str,
}

/// Data as they would be if a number of the instrument were one standard error less and more.
#[derive(Debug, Clone, PartialEq)]
pub struct Doubt {
    /// The number.
    pub given: Given,
    /// The curve with it one standard error less, and more.
    pub curves: [Curve; 2],
}

/// A number that is known roughly, and how far one standard error of it moves each parameter of the fit [SI unit].
#[derive(Debug, Clone, PartialEq)]
pub struct Carried {
    /// The number.
    pub given: Given,
    /// Shifts in the order of the parameters.
    pub shifts: Vec<f64>,
}

/// Part of a standard error from the noise beyond which what is given is spoken of.
const WORTH_SAYING: f64 = 1.0;

impl Given {
    /// The number that `text`, `PATH=SPREAD`, names in a scene: a standard error with a unit, or in per cent.
    ///
    /// # Errors
    /// There is no number at the path, or the standard error is none.
    pub fn read(places: &Places, text: &str) -> Result<Self, super::FitError> {
        let wrong = || super::FitError::Free(format!("\"{text}\" {}", RIGHT));
        let (path, spread) = text.split_once('=').ok_or_else(wrong)?;
        let (path, spread) = (path.trim(), spread.trim());
        let value = number(places, path)?;
        let spread = match percent(spread) {
            Some(part) => part * value.abs(),
            None => super::free::end(places, path, spread)?,
        };
        let given = Self { path: path.to_owned(), value, spread, unit: places.unit(path).unwrap_or_default() };
        given.checked(text)
    }

    /// The same if its standard error is one.
    ///
    /// # Errors
    /// It is not above zero, or as large as the number itself.
    pub fn checked(self, text: &str) -> Result<Self, super::FitError> {
        if self.spread > 0.0 && self.spread.is_finite() && (self.value <= 0.0 || self.spread < self.value) {
            return Ok(self);
        }
        let what =
            format!("\"{text}\" {RIGHT}, above zero and less than the number itself, {:?} {}", self.value, self.unit);
        Err(super::FitError::Free(what))
    }
}

const RIGHT: &str = "is no standard error: expected PATH=SPREAD, such as shape.radius=2 % or shape.radius=0.1 um";

/// The part that `text`, such as `2 %`, stands for.
#[must_use]
pub fn percent(text: &str) -> Option<f64> {
    text.trim().strip_suffix('%')?.trim().parse::<f64>().ok().map(|part| part / 100.0)
}

impl Question {
    /// How far what is given only roughly moves the parameters.
    pub(super) fn carried(&self, task: &Task<'_>, found: &Found, doubts: &[Doubt]) -> Result<Vec<Carried>, String> {
        let of_scene = self.given.iter().map(|given| {
            let moved = |sign: f64| {
                let value = Value::from(given.value + sign * given.spread);
                let scene = self.places.with(&[(given.path.as_str(), value)]).map_err(|problem| problem.to_string())?;
                let places = Places::of(&scene).map_err(|problem| problem.to_string())?;
                found_again(task, found, (&places, task.model.curve))
            };
            self.between(given, moved(-1.0), moved(1.0))
        });
        let of_data = doubts.iter().map(|Doubt { given, curves: [below, above] }| {
            let moved = |curve| found_again(task, found, (task.model.places, curve));
            self.between(given, moved(below), moved(above))
        });
        of_scene.chain(of_data).collect()
    }

    /// Half of the way from the parameters `below` to those `above`, on their natural scales.
    fn between(
        &self,
        given: &Given,
        below: Result<Vec<f64>, String>,
        above: Result<Vec<f64>, String>,
    ) -> Result<Carried, String> {
        let told = |error: String| format!("with {} one standard error off: {error}", given.path);
        let (below, above) = (below.map_err(told)?, above.map_err(told)?);
        let shift = |(at, (&below, &above)): (usize, (&f64, &f64))| match self.free.get(at) {
            Some(free) if free.is_ratio() => 0.5 * (above / below).ln() * (above * below).sqrt(),
            _ => 0.5 * (above - below),
        };
        Ok(Carried { given: given.clone(), shifts: below.iter().zip(&above).enumerate().map(shift).collect() })
    }
}

/// All parameters, those of the baseline last, in another scene or of another curve.
fn found_again(task: &Task<'_>, found: &Found, (places, curve): (&Places, &Curve)) -> Result<Vec<f64>, String> {
    let model = super::model::Model { places, curve, ..task.model };
    let task = Task { model, ..*task };
    let again = task.solved(&found.place, super::TOLERANCE)?;
    let rest = task.rest(&again.answer);
    let baseline = task.frame.baseline(&rest);
    let scales = [1.0, 1.0 / task.frame.largest];
    let mut all = again.place.values;
    all.extend(task.touch.then_some(again.place.contact));
    all.extend(baseline.iter().zip(scales).map(|(value, scale)| value * scale));
    Ok(all)
}

impl Fit {
    /// The fit with the intervals widened by what is known only roughly.
    #[must_use]
    pub(super) fn widened(mut self, free: &[Free], carried: Vec<Carried>) -> Self {
        if carried.is_empty() {
            return self;
        }
        let errors: Vec<f64> = self.parameters.iter().map(|one| one.standard_error.unwrap_or(0.0)).collect();
        let shifted = |j: usize, k: usize| carried.iter().map(|one| one.shifts[j] * one.shifts[k]).sum::<f64>();
        let covariance = |j: usize, k: usize| self.correlations[j][k] * errors[j] * errors[k] + shifted(j, k);
        self.correlations = super::answer::correlations(errors.len(), &covariance);
        for (at, one) in self.parameters.iter_mut().enumerate() {
            let (spread, ratio) = (shifted(at, at).sqrt(), free.get(at).is_some_and(Free::is_ratio));
            one.low =
                one.low.and_then(|low| wider((one.value, low), spread, ratio)).filter(|&low| reached(free, at, low));
            one.high = one
                .high
                .and_then(|high| wider((one.value, high), spread, ratio))
                .filter(|&high| reached(free, at, high));
            one.standard_error = one.standard_error.map(|error| error.hypot(spread));
        }
        let notes: Vec<String> = carried.iter().filter_map(|one| one.told(&self, &errors)).collect();
        self.notes.extend(notes);
        self.carried = carried;
        self
    }
}

fn reached(free: &[Free], at: usize, end: f64) -> bool {
    free.get(at).is_none_or(|free| (free.low..=free.high).contains(&end))
}

/// The end of an interval, its distance from the value and that of a shift added by their squares; in ratios or as they
/// are.
fn wider((value, end): (f64, f64), spread: f64, ratio: bool) -> Option<f64> {
    if spread <= 0.0 {
        return Some(end);
    }
    let far = if ratio { (end / value).ln() } else { end - value };
    let also = NORMAL * if ratio { spread / value } else { spread };
    let far = far.signum() * far.hypot(also);
    let end = if ratio { value * far.exp() } else { value + far };
    end.is_finite().then_some(end)
}

impl Carried {
    /// The parameter of which most is due to what is given, where that is more than the noise.
    fn told(&self, fit: &Fit, errors: &[f64]) -> Option<String> {
        let share = |at: usize| self.shifts[at].abs() / errors[at].max(f64::MIN_POSITIVE);
        let most = (0..errors.len()).filter(|&at| errors[at] > 0.0).max_by(|&a, &b| share(a).total_cmp(&share(b)))?;
        let (one, given) = (&fit.parameters[most], &self.given);
        (share(most) > WORTH_SAYING).then(|| {
            format!(
                "{} is known to {:.3} %: that moves {} by {:.3} %, more than the noise does",
                given.path,
                100.0 * given.spread / given.value.abs(),
                one.path,
                100.0 * (self.shifts[most] / one.value).abs(),
            )
        })
    }
}
