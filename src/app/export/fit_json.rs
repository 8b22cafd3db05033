//! Fits as JSON.

use super::fitted::{Fitted, Tried};
use crate::fit::{Carried, Estimate, Given, Noise};
use crate::scene::Scene;
use crate::scene::fit::Drive;
use serde::Serialize;

#[derive(Serialize)]
struct Summary<'f> {
    data: &'f str,
    scene: Described<'f>,
    parameters: Vec<Parameter<'f>>,
    correlations: &'f [Vec<f64>],
    chi2: Option<f64>,
    rejected: bool,
    notes: Vec<&'f str>,
    points: usize,
    /// Rows that were left out because the model jumps there.
    rows_on_jumps: Vec<usize>,
    driven_by: &'static str,
    residual_deviation: f64,
    residual_correlation: f64,
    noise_before_contact: Option<NoiseRow>,
    aic: f64,
    /// What is known only roughly, and how far one standard error of it moves each parameter.
    given: Vec<GivenRow<'f>>,
    /// The models that were compared.
    models: Vec<ModelRow<'f>>,
}

#[derive(Serialize)]
struct GivenRow<'f> {
    path: &'f str,
    value: f64,
    standard_error: f64,
    unit: &'f str,
    moves: Vec<f64>,
}

#[derive(Serialize)]
pub(super) struct ModelRow<'f> {
    pub model: &'f str,
    pub bic_beyond_best: Option<f64>,
    pub weight: Option<f64>,
    pub chi2: Option<f64>,
    pub rejected: Option<bool>,
    pub tabor_parameter: Option<f64>,
    pub parameters: Vec<Parameter<'f>>,
    pub notes: Vec<&'f str>,
}

impl<'f> ModelRow<'f> {
    pub fn of(tried: &'f Tried) -> Self {
        let answer = tried.answer.as_ref();
        let fit = answer.ok().map(|answered| &answered.fit);
        Self {
            model: &tried.name,
            bic_beyond_best: tried.standing.map(|standing| standing.beyond_best),
            weight: tried.standing.map(|standing| standing.weight),
            chi2: fit.and_then(|fit| fit.chi2),
            rejected: fit.map(|fit| fit.rejected),
            tabor_parameter: answer.ok().and_then(|answered| answered.tabor),
            parameters: fit.iter().flat_map(|fit| &fit.parameters).map(Parameter::of).collect(),
            notes: answer
                .map_or_else(|why| vec![why.as_str()], |one| one.fit.notes.iter().map(String::as_str).collect()),
        }
    }
}

impl<'f> GivenRow<'f> {
    fn of(carried: &'f Carried) -> Self {
        let Given { path, value, spread, unit } = &carried.given;
        Self { path, value: *value, standard_error: *spread, unit, moves: carried.shifts.clone() }
    }
}

#[derive(Serialize)]
struct Described<'f> {
    title: &'f str,
    resolved: &'f Scene,
}

#[derive(Serialize)]
pub(super) struct Parameter<'f> {
    pub path: &'f str,
    pub value: f64,
    pub standard_error: Option<f64>,
    pub low: Option<f64>,
    pub high: Option<f64>,
    pub unit: &'f str,
}

#[derive(Serialize)]
struct NoiseRow {
    deviation: f64,
    correlation: f64,
    points: usize,
}

impl<'f> Summary<'f> {
    fn of(fitted: &'f Fitted) -> Self {
        let Fitted { file, scene, fit, data_notes, curve, models } = fitted;
        let noise = |noise: Noise| NoiseRow {
            deviation: noise.deviation,
            correlation: noise.correlation,
            points: noise.points,
        };
        Self {
            data: file,
            scene: Described { title: &scene.title, resolved: scene },
            parameters: fit.parameters.iter().map(Parameter::of).collect(),
            correlations: &fit.correlations,
            chi2: fit.chi2,
            rejected: fit.rejected,
            notes: data_notes.iter().chain(&fit.notes).map(String::as_str).collect(),
            points: fit.used.len(),
            rows_on_jumps: fit.on_jumps.iter().map(|&at| curve.rows[at]).collect(),
            driven_by: driven_by(fit.led),
            residual_deviation: fit.deviation,
            residual_correlation: fit.correlation,
            noise_before_contact: fit.noise.map(noise),
            aic: fit.aic,
            given: fit.carried.iter().map(GivenRow::of).collect(),
            models: models.iter().map(ModelRow::of).collect(),
        }
    }
}

impl<'f> Parameter<'f> {
    fn of(estimate: &'f Estimate) -> Self {
        let Estimate { path, value, standard_error, low, high, unit } = estimate;
        Self { path, value: *value, standard_error: *standard_error, low: *low, high: *high, unit }
    }
}

/// The file of one fit.
#[derive(Serialize)]
struct File<'f> {
    version: &'static str,
    #[serde(flatten)]
    fit: Summary<'f>,
}

fn ended(text: String) -> String {
    format!("{text}\n")
}

/// One fit as JSON.
///
/// # Errors
/// A number cannot be written as JSON.
pub fn fit_json(fitted: &Fitted) -> Result<String, serde_json::Error> {
    let file = File { version: env!("CARGO_PKG_VERSION"), fit: Summary::of(fitted) };
    serde_json::to_string_pretty(&file).map(ended)
}

/// One fit as JSON, as a member of [`fits_json`].
///
/// # Errors
/// A number cannot be written as JSON.
pub fn fit_member(fitted: &Fitted) -> Result<String, serde_json::Error> {
    serde_json::to_string_pretty(&Summary::of(fitted))
}

/// What `fit` prints with `--json` of fits whose JSON is known: one shape for one and for many.
#[must_use]
pub fn fits_json(members: &[String]) -> String {
    let version = env!("CARGO_PKG_VERSION");
    format!("{{\"version\": \"{version}\", \"fits\": [\n{}\n]}}\n", members.join(",\n"))
}

fn driven_by(led: Drive) -> &'static str {
    match led {
        Drive::Depth => "depth",
        Drive::Force => "force",
        Drive::Speed => "speed",
        Drive::Slide => "slide",
    }
}
