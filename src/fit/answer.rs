//! What a fit says: values, intervals, what the data can tell and what they cannot.

use super::frame::VIRTUAL;
use super::given::Carried;
use super::interval::{Valley, without};
use super::map::{Around, Map};
use super::notes::{self, Heard};
use super::solve::{Found, Task};
use super::sure::{Left, Sure};
use super::verdict::Noise;
use super::{FitError, Question};
use crate::scene::fit::{Baseline, Drive};

/// A parameter and how sure it is.
#[derive(Debug, Clone, PartialEq)]
pub struct Estimate {
    /// Its place in the scene, or `contact_point`, `baseline`, `tilt`.
    pub path: String,
    /// Value [SI unit].
    pub value: f64,
    /// Standard error [SI unit]; `None` where the data say nothing of it.
    pub standard_error: Option<f64>,
    /// Lower end of the 95 % interval [SI unit]; `None` where there is none in the range.
    pub low: Option<f64>,
    /// Upper end.
    pub high: Option<f64>,
    /// SI unit; empty for a pure number.
    pub unit: &'static str,
}

/// What came out of a fit.
#[derive(Debug, Clone, PartialEq)]
pub struct Fit {
    /// Parameters of the scene, then first touch, then the baseline.
    pub parameters: Vec<Estimate>,
    /// Correlations of their errors, in the same order.
    pub correlations: Vec<Vec<f64>>,
    /// Mean square of what is left in contact over that of the noise before it, per degree of freedom; `None` where no
    /// noise is known.
    pub chi2: Option<f64>,
    /// Whether the data speak against the scene.
    pub rejected: bool,
    /// What a user must know.
    pub notes: Vec<String>,
    /// Noise before first touch.
    pub noise: Option<Noise>,
    /// Correlation of what is left at neighbouring points.
    pub correlation: f64,
    /// Root of the mean square of what is left [unit of the response].
    pub deviation: f64,
    /// Akaike's criterion up to a constant of the data: n ln S + 2p; the smaller of two models is the better one.
    pub aic: f64,
    /// What drove.
    pub led: Drive,
    /// Numbers of the points that counted.
    pub used: Vec<usize>,
    /// Free parameters that move a jump of the model and no force alone: those of its adhesion, where it jumps.
    pub jumping: usize,
    /// Numbers of the points that were left out because the model jumps there.
    pub on_jumps: Vec<usize>,
    /// Model and baseline, one per point of the curve.
    pub model: Vec<f64>,
    /// The parameters as text for a scene are at these values.
    pub values: Vec<f64>,
    /// What is known only roughly, and how far that moves the parameters.
    pub carried: Vec<Carried>,
    /// The confidence over two parameters, if it was asked for.
    pub map: Option<Map>,
}

impl Fit {
    /// The parameter of this path.
    #[must_use]
    pub fn parameter(&self, path: &str) -> Option<&Estimate> {
        self.parameters.iter().find(|estimate| estimate.path == path)
    }
}

/// The columns that are fitted: slopes in natural parameters, first touch, the baseline; one value per used point.
pub fn columns(task: &Task<'_>, found: &Found) -> Result<Vec<Vec<f64>>, String> {
    let slopes = task.slopes(&found.place, &found.answer)?;
    let slopes = slopes.iter().map(|slope| task.frame.chosen(slope));
    Ok(slopes.chain(task.frame.columns().iter().cloned()).collect())
}

/// The answer of a question.
pub fn told(question: &Question, task: Task<'_>, found: Found) -> Result<Fit, FitError> {
    let (frame, free, rest) = (task.frame, task.model.free, task.rest(&found.answer));
    let columns = columns(&task, &found).map_err(FitError::Scene)?;
    let baseline = frame.baseline(&rest);
    let off = without(frame, &rest, &baseline);
    let left = Left { task, found: &found, columns: &columns, off: &off, names: &names(question, &task) };
    let sure = Sure::of(&left);
    let parameters = estimates(&left, &sure, &baseline);
    let map = question.map.map(|pair| mapped(&left, &sure, pair));
    let correlations = correlations(columns.len(), &|j, k| sure.covariance(j, k));
    let heard = Heard::of(question, &left, sure.deviation(&off));
    let notes = [notes::search(&found), sure.blind(left.names), notes::ends(free, &found.place.values, &sure)]
        .into_iter()
        .flatten()
        .chain(map.iter().filter_map(|map| map.clone().err()))
        .chain(notes::alike(left.names, &correlations))
        .chain(heard.notes(&left))
        .collect();
    let squares = (found.squares / rest.len() as f64).max(f64::MIN_POSITIVE);
    let model = found.answer.response.iter().enumerate().map(|(at, model)| model + baseline_at(&task, &baseline, at));
    Ok(Fit {
        correlations,
        chi2: heard.verdict.map(|verdict| verdict.chi2),
        rejected: heard.rejects(),
        notes,
        noise: heard.noise,
        correlation: frame.correlation,
        deviation: sure.deviation(&off),
        aic: rest.len() as f64 * squares.ln() + 2.0 * sure.count() as f64,
        led: question.led,
        used: frame.used.clone(),
        jumping: if found.answer.jumps.is_empty() { 0 } else { of_adhesion(free) },
        on_jumps: Vec::new(),
        model: model.collect(),
        parameters,
        carried: Vec::new(),
        map: map.and_then(Result::ok),
        values: found.place.values,
    })
}

/// All that is fitted, with its errors.
fn estimates(left: &Left<'_>, sure: &Sure, baseline: &[f64]) -> Vec<Estimate> {
    let covariance = |j: usize, k: usize| sure.covariance(j, k);
    let Left { task, found, .. } = *left;
    let valley = Valley { task, found, variance: sure.variance(), covariance: &covariance };
    let told = |(at, name): (usize, &String)| {
        let known = sure.knows(at).then(|| sure.error_and_reach(at));
        estimate(&valley, at, known, name, baseline)
    };
    left.names.iter().enumerate().map(told).collect()
}

/// The confidence over two parameters, or why there is none.
fn mapped(left: &Left<'_>, sure: &Sure, pair: [usize; 2]) -> Result<Map, String> {
    let errors: Vec<f64> = (0..left.task.count()).map(|at| sure.error_and_reach(at).0).collect();
    // As much wider as the intervals of both are.
    let wider: f64 = pair.iter().map(|&at| sure.wider(at)).product();
    let variance = wider * sure.variance();
    Around { task: left.task, found: left.found, errors: &errors, variance, freedom: sure.freedom() }
        .map(pair, left.names)
}

/// How many free parameters are of the adhesion.
fn of_adhesion(free: &[super::Free]) -> usize {
    free.iter().filter(|free| free.path.starts_with("adhesion.")).count()
}

/// Names of all that is fitted.
fn names(question: &Question, task: &Task<'_>) -> Vec<String> {
    let free = task.model.free.iter().map(|free| free.path.clone());
    let lines = match (question.led, question.options.baseline) {
        (Drive::Force, _) => ["contact_point", "tilt"],
        (Drive::Depth, Baseline::Virtual) => ["baseline", VIRTUAL],
        (Drive::Depth | Drive::Speed | Drive::Slide, _) => ["baseline", "tilt"],
    };
    let touch = task.touch.then(|| "contact_point".to_owned());
    free.chain(touch).chain(lines.into_iter().take(task.frame.columns().len()).map(str::to_owned)).collect()
}

/// Estimate number `at`, with its standard error and half of its interval on the natural scale.
fn estimate(valley: &Valley<'_>, at: usize, sure: Option<(f64, f64)>, path: &str, baseline: &[f64]) -> Estimate {
    let Task { model, frame, .. } = valley.task;
    let units = units(model.led);
    if let Some(free) = model.free.get(at) {
        let value = valley.found.place.values[at];
        let end = |sign: f64| {
            let natural = sure.and_then(|(_, reach)| valley.end(at, sign * reach));
            natural.map(|natural| free.value(natural)).filter(|end| (free.low..=free.high).contains(end))
        };
        let rate = if free.is_ratio() { value } else { 1.0 };
        let standard_error = sure.map(|(error, _)| error * rate);
        return Estimate {
            path: path.to_owned(),
            value,
            standard_error,
            low: end(-1.0),
            high: end(1.0),
            unit: free.unit,
        };
    }
    let beyond = at - model.free.len();
    let (value, scale, unit) = match (valley.task.touch, beyond) {
        (true, 0) => (valley.found.place.contact, 1.0, units.0),
        (touch, beyond) => {
            let column = beyond - usize::from(touch);
            let scale = if column == 0 { 1.0 } else { 1.0 / frame.largest };
            let per = if path == VIRTUAL { "" } else { units.2 };
            (baseline[column] * scale, scale, if column == 0 { units.1 } else { per })
        }
    };
    let reach = sure.map(|(_, reach)| reach * scale);
    Estimate {
        path: path.to_owned(),
        value,
        standard_error: sure.map(|(error, _)| error * scale),
        low: reach.map(|reach| value - reach),
        high: reach.map(|reach| value + reach),
        unit,
    }
}

/// Units of what drives, of what answers, and of the tilt of one over the other.
fn units(led: Drive) -> (&'static str, &'static str, &'static str) {
    match led {
        Drive::Depth | Drive::Slide => ("m", "N", "N/m"),
        Drive::Force => ("N", "m", "m/N"),
        Drive::Speed => ("m/s", "", "s/m"),
    }
}

/// Correlations of `count` parameters from their covariances.
pub(super) fn correlations(count: usize, covariance: &dyn Fn(usize, usize) -> f64) -> Vec<Vec<f64>> {
    let one = |j: usize, k: usize| {
        let size = (covariance(j, j) * covariance(k, k)).sqrt();
        if size > 0.0 { covariance(j, k) / size } else { f64::from(u8::from(j == k)) }
    };
    (0..count).map(|j| (0..count).map(|k| one(j, k)).collect()).collect()
}

/// The baseline at a point of the curve.
pub(super) fn baseline_at(task: &Task<'_>, baseline: &[f64], at: usize) -> f64 {
    let drive = task.model.curve.driven(task.model.led)[at] / task.frame.largest;
    baseline.first().copied().unwrap_or(0.0) + baseline.get(1).map_or(0.0, |tilt| tilt * drive)
}
