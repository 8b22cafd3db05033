//! What a fit says: values, intervals, what the data can tell and what they cannot.

use super::frame::{Frame, VIRTUAL};
use super::given::Carried;
use super::interval::{Valley, without};
use super::map::{Around, Map};
use super::noise::{Moments, student};
use super::solve::{Found, Task};
use super::unsure::Unsure;
use super::verdict::{Noise, Verdict};
use super::{FitError, Question};
use crate::contact::adhesion::equilibrium::Control;
use crate::scene::fit::Baseline;
use nalgebra::{DMatrix, SymmetricEigen};

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
    pub control: Control,
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

/// Least eigenvalue of the correlated normal matrix below which a direction is not told by the data.
const BLIND: f64 = 1e-12;
/// Correlation from which on it is spoken of.
const ALIKE: f64 = 0.99;
/// Part of half of a range within which a parameter sits at its end.
const AT_END: f64 = 1e-5;

/// The columns that are fitted: slopes in natural parameters, first touch, the baseline; one value per used point.
pub fn columns(task: &Task<'_>, found: &Found) -> Result<Vec<Vec<f64>>, String> {
    let slopes = task.slopes(&found.place, &found.answer)?;
    let slopes = slopes.iter().map(|slope| task.frame.chosen(slope));
    Ok(slopes.chain(task.frame.columns().iter().cloned()).collect())
}

/// The answer of a question.
pub fn told(question: &Question, task: Task<'_>, found: Found) -> Result<Fit, FitError> {
    let (frame, free) = (task.frame, task.model.free);
    let columns = columns(&task, &found).map_err(FitError::Scene)?;
    let ends: Vec<bool> = free.iter().zip(&found.place.values).map(|(free, &value)| at_end(free, value)).collect();
    let moving: Vec<usize> = (0..columns.len()).filter(|&at| !ends.get(at).copied().unwrap_or(false)).collect();
    let chosen: Vec<Vec<f64>> = moving.iter().map(|&at| columns[at].clone()).collect();
    let rest = task.rest(&found.answer);
    let baseline = frame.baseline(&rest);
    let off = without(frame, &rest, &baseline);
    let moments = Moments::of(frame, &chosen, &off);
    let judged = moments.judged(frame.correlation);
    let freedom = rest.len().saturating_sub(moving.len()).max(1) as f64;
    let quantile = student(freedom);
    let mut notes = Vec::new();
    if !found.converged {
        notes.push("the search has not come to an end: the values are where it stopped".to_owned());
    }
    let names = names(question, &task);
    let blind = blind(&judged.normal);
    if !blind.is_empty() {
        let alike: Vec<&str> = blind.iter().filter_map(|&at| names.get(moving[at]).map(String::as_str)).collect();
        notes.push(match &alike[..] {
            [one] => format!("the data say nothing of {one}"),
            _ => format!("the data cannot tell {} apart: only a combination of them is known", alike.join(" and ")),
        });
    }
    let inverse = judged.inverse.filter(|_| blind.is_empty());
    let place_of = |at: usize| moving.iter().position(|&other| other == at);
    let covariance = |j: usize, k: usize| match (&inverse, place_of(j), place_of(k)) {
        (Some(inverse), Some(j), Some(k)) => judged.variance * inverse[(j, k)],
        _ => 0.0,
    };
    let unsure = inverse.as_ref().and_then(|_| Unsure::of(&moments));
    let error_and_reach = |at: usize| {
        let plain = covariance(at, at).sqrt();
        unsure.as_ref().zip(place_of(at)).map_or((plain, quantile * plain), |(unsure, at)| unsure.error_and_reach(at))
    };
    let valley = Valley { task, found: &found, variance: judged.variance, covariance: &covariance };
    let told = |at: usize| {
        let known = inverse.is_some() && place_of(at).is_some();
        estimate(&valley, at, known.then(|| error_and_reach(at)), &names[at], &baseline)
    };
    let parameters: Vec<Estimate> = (0..columns.len()).map(told).collect();
    for (free, _) in free.iter().zip(&ends).filter(|(_, end)| **end) {
        let value = parameters.iter().find(|one| one.path == free.path).map_or(0.0, |one| one.value);
        notes.push(format!("{} sits at the end of its range, {value:?} {}: widen it", free.path, free.unit));
    }
    let errors: Vec<f64> = (0..task.count()).map(|at| error_and_reach(at).0).collect();
    let map = question.map.and_then(|pair| {
        // As much wider as the intervals of both are.
        let wider: f64 =
            pair.iter().map(|&at| error_and_reach(at).1 / (quantile * covariance(at, at).sqrt())).product();
        let around = Around { task, found: &found, errors: &errors, variance: wider * judged.variance, freedom };
        around.map(pair, &names).map_err(|why| notes.push(why)).ok()
    });
    let correlations = correlations(columns.len(), &covariance);
    notes.extend(alike(&names, &correlations));
    let deviation = (off.iter().map(|x| x * x).sum::<f64>() / freedom).sqrt();
    let largest = found.answer.response.iter().fold(0.0f64, |largest, x| largest.max(x.abs()));
    let floor = question.floor() * largest;
    let touching: Vec<usize> = (0..rest.len()).filter(|&n| found.answer.response[frame.used[n]].abs() > 0.0).collect();
    let apart: Vec<usize> = (0..rest.len()).filter(|&n| found.answer.response[frame.used[n]].abs() <= 0.0).collect();
    let noise = Noise::before(frame, &off, &apart).map(|noise| noise.not_below(floor));
    // A depth made of a deflection has the noise of the force in it: what is left has a shape by itself.
    let verdict = noise
        .filter(|_| question.options.baseline != Baseline::Virtual)
        .filter(|_| touching.len() > columns.len() + 10)
        .map(|noise| Verdict::of(frame, (&columns, &off), &touching, noise));
    let rejected = verdict.is_some_and(|verdict| verdict.rejects());
    if let Some(verdict) = verdict.filter(Verdict::rejects) {
        notes.push(format!(
            "the data speak against the scene: in contact what is left is {:.3} times the noise before it and has a shape ({:.0} standard deviations)",
            verdict.chi2.sqrt(),
            verdict.size.max(verdict.shape),
        ));
    } else if noise.is_none() && deviation > floor && frame.correlation > 0.3 {
        notes.push(format!(
            "neighbouring residuals are alike (correlation {:.3}): the noise is, or the scene is not quite right; the intervals are widened for it, but no noise before first touch is there to tell which",
            frame.correlation
        ));
    }
    if task.frame.columns().len() == 1 && tilted(&task, frame, &off, &apart) {
        notes.push("the baseline before first touch is tilted: try --baseline linear".to_owned());
    }
    let squares = (found.squares / rest.len() as f64).max(f64::MIN_POSITIVE);
    let line = |at: usize| baseline_at(&task, &baseline, at);
    Ok(Fit {
        correlations,
        chi2: verdict.map(|verdict| verdict.chi2),
        rejected,
        notes,
        noise,
        correlation: frame.correlation,
        deviation,
        aic: rest.len() as f64 * squares.ln() + 2.0 * moving.len() as f64,
        control: question.control,
        used: frame.used.clone(),
        jumping: if found.answer.jumps.is_empty() { 0 } else { of_adhesion(free) },
        on_jumps: Vec::new(),
        model: found.answer.response.iter().enumerate().map(|(at, model)| model + line(at)).collect(),
        values: found.place.values,
        parameters,
        carried: Vec::new(),
        map,
    })
}

/// How many free parameters are of the adhesion.
fn of_adhesion(free: &[super::Free]) -> usize {
    free.iter().filter(|free| free.path.starts_with("adhesion.")).count()
}

fn at_end(free: &super::Free, value: f64) -> bool {
    let ((low, high), here) = (free.ends(), free.natural(value));
    (here - low).min(high - here) < AT_END * 0.5 * (high - low)
}

/// Names of all that is fitted.
fn names(question: &Question, task: &Task<'_>) -> Vec<String> {
    let free = task.model.free.iter().map(|free| free.path.clone());
    let lines = match (question.control, question.options.baseline) {
        (Control::Force, _) => ["contact_point", "tilt"],
        (Control::Indentation, Baseline::Virtual) => ["baseline", VIRTUAL],
        (Control::Indentation, Baseline::Absent | Baseline::Constant | Baseline::Linear) => ["baseline", "tilt"],
    };
    let touch = task.touch.then(|| "contact_point".to_owned());
    free.chain(touch).chain(lines.into_iter().take(task.frame.columns().len()).map(str::to_owned)).collect()
}

/// Columns that take part in a direction the data do not tell.
fn blind(normal: &DMatrix<f64>) -> Vec<usize> {
    if normal.nrows() == 0 {
        return Vec::new();
    }
    let eigen = SymmetricEigen::new(normal.clone());
    let Some((least, value)) = eigen.eigenvalues.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1)) else {
        return Vec::new();
    };
    if *value > BLIND {
        return Vec::new();
    }
    let direction = eigen.eigenvectors.column(least);
    (0..normal.nrows()).filter(|&at| direction[at].abs() > 0.1).collect()
}

/// Estimate number `at`, with its standard error and half of its interval on the natural scale.
fn estimate(valley: &Valley<'_>, at: usize, sure: Option<(f64, f64)>, path: &str, baseline: &[f64]) -> Estimate {
    let Task { model, frame, .. } = valley.task;
    let (drive, response) = if model.control == Control::Force { ("N", "m") } else { ("m", "N") };
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
        (true, 0) => (valley.found.place.contact, 1.0, drive),
        (touch, beyond) => {
            let column = beyond - usize::from(touch);
            let scale = if column == 0 { 1.0 } else { 1.0 / frame.largest };
            let per = match model.control {
                _ if path == VIRTUAL => "",
                Control::Force => "m/N",
                Control::Indentation => "N/m",
            };
            (baseline[column] * scale, scale, if column == 0 { response } else { per })
        }
    };
    let standard_error = sure.map(|(error, _)| error * scale);
    let reach = sure.map(|(_, reach)| reach * scale);
    Estimate {
        path: path.to_owned(),
        value,
        standard_error,
        low: reach.map(|reach| value - reach),
        high: reach.map(|reach| value + reach),
        unit,
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

fn alike(names: &[String], correlations: &[Vec<f64>]) -> Vec<String> {
    let pairs = (0..names.len()).flat_map(|j| (0..j).map(move |k| (k, j)));
    let close = pairs.filter(|&(k, j)| correlations[k][j].abs() > ALIKE);
    let told = close.map(|(k, j)| {
        let correlation = correlations[k][j];
        format!("{} and {} are hardly told apart (correlation {correlation:.4})", names[k], names[j])
    });
    told.collect()
}

/// Standard errors from zero from which on a tilt before first touch is spoken of.
const TILTED: f64 = 5.0;

/// Whether what is left before first touch rises or falls with the drive.
fn tilted(task: &Task<'_>, frame: &Frame, off: &[f64], apart: &[usize]) -> bool {
    if apart.len() < super::verdict::ENOUGH {
        return false;
    }
    let drive = task.model.curve.driven(task.model.control);
    let part = frame.part(apart);
    let rest: Vec<f64> = apart.iter().map(|&number| off[number]).collect();
    let tilt: Vec<f64> = part.used.iter().map(|&at| drive[at]).collect();
    let judged = Moments::of(&part, &[vec![1.0; rest.len()], tilt.clone()], &rest).most_likely();
    let Some(inverse) = judged.inverse else { return false };
    let part = part.with(part.weights.clone(), judged.correlation);
    let (one, tilt, rest) = (part.whitened(&vec![1.0; rest.len()]), part.whitened(&tilt), part.whitened(&rest));
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let slope = inverse[(1, 0)] * dot(&one, &rest) + inverse[(1, 1)] * dot(&tilt, &rest);
    slope.abs() > TILTED * (judged.variance * inverse[(1, 1)]).sqrt()
}

/// The baseline at a point of the curve.
pub(super) fn baseline_at(task: &Task<'_>, baseline: &[f64], at: usize) -> f64 {
    let drive = task.model.curve.driven(task.model.control)[at] / task.frame.largest;
    baseline.first().copied().unwrap_or(0.0) + baseline.get(1).map_or(0.0, |tilt| tilt * drive)
}
