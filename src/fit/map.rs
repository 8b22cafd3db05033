//! How far the sum of squares rises around an answer, over two parameters with all others set free.
//!
//! A pair lies in the region of confidence p where the rise of the sum of squares S, white, stays below
//! ΔS = σ²·ν[(1 − p)^{−2/ν} − 1], with the variance σ² of the noise and ν degrees of freedom left: twice the quantile of
//! Fisher's F for 2 and ν.

use super::model::{Last, Model};
use super::solve::{Found, Place, Task};
use super::{FitError, Question};
use rayon::prelude::*;

/// Confidence over two parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct Map {
    /// Paths of the parameters.
    pub paths: [String; 2],
    /// SI units of the parameters.
    pub units: [&'static str; 2],
    /// Values of the first [SI unit], rising.
    pub x: Vec<f64>,
    /// Values of the second.
    pub y: Vec<f64>,
    /// Rise of the sum of squares in units of the variance of the noise, all y of the first x first; `None` where there is
    /// no answer.
    pub rise: Vec<Option<f64>>,
    /// Degrees of freedom left.
    freedom: f64,
}

/// Values of each parameter.
const SIDE: usize = 33;
/// Standard errors from the answer to the ends.
const REACH: f64 = 4.0;
/// Relative change of parameters or sum of squares at which a search ends.
const TOLERANCE: f64 = 1e-8;

impl Map {
    /// The least confidence of a region that holds a rise.
    #[must_use]
    pub fn confidence(&self, rise: f64) -> f64 {
        -(-0.5 * self.freedom * (rise.max(0.0) / self.freedom).ln_1p()).exp_m1()
    }
}

/// What a map is drawn around: the answer, standard errors on natural scales, variance and degrees of freedom.
pub struct Around<'a> {
    /// The task, in the frame of the noise.
    pub task: Task<'a>,
    /// Its answer.
    pub found: &'a Found,
    /// Standard errors of the parameters on their natural scales.
    pub errors: &'a [f64],
    /// Variance of the noise.
    pub variance: f64,
    /// Degrees of freedom.
    pub freedom: f64,
}

impl Question {
    /// Numbers of the two parameters of a map, such as `bodies.0.young, adhesion.work`; first touch is `contact_point`.
    pub(super) fn pair(&self, text: &str) -> Result<[usize; 2], FitError> {
        let touch = self.touches();
        let names: Vec<&str> =
            self.free.iter().map(|free| free.path.as_str()).chain(touch.then_some("contact_point")).collect();
        let paths: Vec<&str> = text.split(',').map(str::trim).collect();
        let number = |path: &&str| names.iter().position(|name| name == path);
        match paths.iter().map(number).collect::<Option<Vec<_>>>().as_deref() {
            Some(&[one, other]) if one != other => Ok([one, other]),
            _ => Err(FitError::Free(format!(
                "\"{text}\" are no two free parameters: expected PATH,PATH, of {}",
                names.join(", ")
            ))),
        }
    }
}

impl Around<'_> {
    /// The map over the parameters number `pair`.
    pub fn map(&self, pair: [usize; 2], names: &[String]) -> Result<Map, String> {
        let [x, y] = [self.values(pair[0])?, self.values(pair[1])?];
        let columns: Vec<Vec<Option<f64>>> = x.par_iter().map(|&x| self.column(pair, x, &y)).collect();
        let value =
            |at: usize, natural: &f64| self.task.model.free.get(at).map_or(*natural, |free| free.value(*natural));
        let unit = |at: usize| self.task.model.free.get(at).map_or("m", |free| free.unit);
        Ok(Map {
            paths: pair.map(|at| names[at].clone()),
            units: pair.map(unit),
            x: x.iter().map(|natural| value(pair[0], natural)).collect(),
            y: y.iter().map(|natural| value(pair[1], natural)).collect(),
            rise: columns.concat(),
            freedom: self.freedom,
        })
    }

    /// Values of a parameter on its natural scale, within its range.
    fn values(&self, at: usize) -> Result<Vec<f64>, String> {
        let error = self.errors.get(at).copied().filter(|error| *error > 0.0);
        let error = error.ok_or("there is no map: the data do not tell the parameters of it")?;
        let free = self.task.model.free.get(at);
        let (low, high) = free.map_or((f64::NEG_INFINITY, f64::INFINITY), super::Free::ends);
        let here = free.map_or(self.found.place.contact, |free| free.natural(self.found.place.values[at]));
        let (low, high) = ((here - REACH * error).max(low), (here + REACH * error).min(high));
        Ok((0..SIDE).map(|k| low + (high - low) * k as f64 / (SIDE - 1) as f64).collect())
    }

    /// The rises of a column, each search begun where that of its neighbour on the side of the answer ended.
    fn column(&self, pair: [usize; 2], x: f64, y: &[f64]) -> Vec<Option<f64>> {
        let mut rises = vec![None; y.len()];
        // Threads would take the scene that was decided last from each other.
        let last = Last::default();
        let task = Task { model: Model { last: &last, ..self.task.model }, ..self.task };
        let here = self.task.natural(pair[1], &self.found.place);
        let middle = (0..y.len()).min_by(|&a, &b| (y[a] - here).abs().total_cmp(&(y[b] - here).abs())).unwrap_or(0);
        for way in [(middle..y.len()).collect::<Vec<_>>(), (0..middle).rev().collect()] {
            let mut place = task.with(pair[0], x, &self.found.place);
            for row in way {
                let kept = Task { kept: pair.map(Some), ..task };
                let Ok(found) = kept.solved(&task.with(pair[1], y[row], &place), TOLERANCE) else { continue };
                rises[row] = Some((found.squares - self.found.squares).max(0.0) / self.variance);
                place = found.place;
            }
        }
        rises
    }
}

impl Task<'_> {
    /// Parameter number `at` of a place on its natural scale, first touch last.
    #[must_use]
    pub fn natural(&self, at: usize, place: &Place) -> f64 {
        match self.model.free.get(at) {
            Some(free) => free.natural(place.values[at]),
            None => place.contact,
        }
    }

    /// The place with another value, on its natural scale, of parameter number `at`.
    fn with(&self, at: usize, natural: f64, place: &Place) -> Place {
        let mut place = place.clone();
        match self.model.free.get(at) {
            Some(free) => place.values[at] = free.value(natural).clamp(free.low, free.high),
            None => place.contact = natural,
        }
        place
    }
}
