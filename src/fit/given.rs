//! What is known roughly, such as the radius of a probe, and how far that moves what a fit finds.
//!
//! A number known as g ± s shifts every parameter by [θ(g + s) − θ(g − s)]/2, found by two more searches, each from the
//! answer on; the shifts of several numbers add to the scatter of the noise by their squares.

use super::curve::Curve;
use super::free::{end, number};
use super::model::{Last, Model};
use super::solve::{Found, Task};
use super::{FitError, Question, TOLERANCE};
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

impl Given {
    /// The number that `text`, `PATH=SPREAD`, names in a scene: a standard error with a unit, or in per cent.
    ///
    /// # Errors
    /// There is no number at the path, or the standard error is none.
    pub fn read(places: &Places, text: &str) -> Result<Self, FitError> {
        let wrong = || FitError::Free(format!("\"{text}\" {RIGHT}"));
        let (path, spread) = text.split_once('=').ok_or_else(wrong)?;
        let (path, spread) = (path.trim(), spread.trim());
        let value = number(places, path)?;
        let spread = match percent(spread) {
            Some(part) => part * value.abs(),
            None => end(places, path, spread)?,
        };
        let given = Self { path: path.to_owned(), value, spread, unit: places.unit(path).unwrap_or_default() };
        given.checked(text)
    }

    /// The same if its standard error is one.
    ///
    /// # Errors
    /// It is not above zero, or as large as the number itself.
    pub fn checked(self, text: &str) -> Result<Self, FitError> {
        if self.spread > 0.0 && self.spread.is_finite() && (self.value <= 0.0 || self.spread < self.value) {
            return Ok(self);
        }
        let what =
            format!("\"{text}\" {RIGHT}, above zero and less than the number itself, {:?} {}", self.value, self.unit);
        Err(FitError::Free(what))
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
    let last = Last::default();
    let model = Model { places, curve, last: &last, ..task.model };
    let task = Task { model, ..*task };
    let again = task.solved(&found.place, TOLERANCE)?;
    let rest = task.rest(&again.answer);
    let baseline = task.frame.baseline(&rest);
    let scales = [1.0, 1.0 / task.frame.largest];
    let mut all = again.place.values;
    all.extend(task.touch.then_some(again.place.contact));
    all.extend(baseline.iter().zip(scales).map(|(value, scale)| value * scale));
    Ok(all)
}
