//! Fits as lines, tables and JSON.

use super::summary::with_prefix;
use super::tables::{cell, text};
use crate::contact::adhesion::equilibrium::Control;
use crate::fit::{Curve, Estimate, Fit, Free, Noise};
use crate::scene::Scene;
use serde::Serialize;
use std::fmt::Write as _;

/// A curve with its fit.
#[derive(Debug, Clone)]
pub struct Fitted {
    /// The data file.
    pub file: String,
    /// The scene at the values found.
    pub scene: Scene,
    /// The data.
    pub curve: Curve,
    /// The fit.
    pub fit: Fit,
    /// What was taken for granted of the data.
    pub data_notes: Vec<String>,
}

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
}

#[derive(Serialize)]
struct Described<'f> {
    title: &'f str,
    resolved: &'f Scene,
}

#[derive(Serialize)]
struct Parameter<'f> {
    path: &'f str,
    value: f64,
    standard_error: Option<f64>,
    low: Option<f64>,
    high: Option<f64>,
    unit: &'f str,
}

#[derive(Serialize)]
struct NoiseRow {
    deviation: f64,
    correlation: f64,
    points: usize,
}

impl<'f> Summary<'f> {
    fn of(fitted: &'f Fitted) -> Self {
        let Fitted { file, scene, fit, data_notes, curve } = fitted;
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
            driven_by: if fit.control == Control::Force { "force" } else { "depth" },
            residual_deviation: fit.deviation,
            residual_correlation: fit.correlation,
            noise_before_contact: fit.noise.map(noise),
            aic: fit.aic,
        }
    }
}

impl<'f> Parameter<'f> {
    fn of(estimate: &'f Estimate) -> Self {
        let Estimate { path, value, standard_error, low, high, unit } = estimate;
        Self { path, value: *value, standard_error: *standard_error, low: *low, high: *high, unit }
    }
}

/// What `fit` prints with `--json`, and what a file of one fit holds.
#[derive(Serialize)]
struct Printed<'f> {
    version: &'static str,
    fits: Vec<Summary<'f>>,
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

/// Fits as JSON, one shape for one and for many.
///
/// # Errors
/// A number cannot be written as JSON.
pub fn fits_json(fits: &[&Fitted]) -> Result<String, serde_json::Error> {
    let fits = fits.iter().map(|fit| Summary::of(fit)).collect();
    serde_json::to_string_pretty(&Printed { version: env!("CARGO_PKG_VERSION"), fits }).map(ended)
}

/// The points of a curve with what the fit says of them, one row per row of the data.
///
/// # Errors
/// The text cannot be put together.
pub fn fit_points(fitted: &Fitted) -> Result<String, csv::Error> {
    let Fitted { curve, fit, .. } = fitted;
    let names = match fit.control {
        Control::Indentation => ["row", "indentation_m", "force_n", "model_force_n", "residual_n", "counts"],
        Control::Force => ["row", "force_n", "indentation_m", "model_indentation_m", "residual_m", "counts"],
    };
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(names)?;
    let (drive, response) = (curve.driven(fit.control), curve.answered(fit.control));
    for at in 0..curve.len() {
        let numbers = [drive[at], response[at], fit.model[at], response[at] - fit.model[at]];
        let cells = numbers.into_iter().map(|number| cell(Some(number)));
        let counts = fit.used.binary_search(&at).is_ok();
        let counts = if counts { "1" } else { "0" };
        writer.write_record([curve.rows[at].to_string()].into_iter().chain(cells).chain([counts.to_owned()]))?;
    }
    text(writer)
}

/// Fits as a table, one row per data file.
///
/// # Errors
/// The text cannot be put together.
pub fn fits_table(free: &[Free], rows: &[(String, Result<&Fitted, &str>)]) -> Result<String, csv::Error> {
    let mut paths: Vec<&str> = free.iter().map(|free| free.path.as_str()).collect();
    let found = rows.iter().find_map(|(_, fit)| fit.ok());
    paths.extend(
        found.iter().flat_map(|fitted| fitted.fit.parameters[free.len()..].iter()).map(|one| one.path.as_str()),
    );
    let mut writer = csv::Writer::from_writer(Vec::new());
    let four = |path: &&str| [path.to_string(), format!("{path}.error"), format!("{path}.low"), format!("{path}.high")];
    let heads = paths.iter().flat_map(four);
    let tail = ["chi2", "rejected", "points", "notes"].map(str::to_owned);
    writer.write_record(["file".to_owned()].into_iter().chain(heads).chain(tail))?;
    for (file, fit) in rows {
        let numbers = paths.iter().flat_map(|path| {
            let one = fit.ok().and_then(|fitted| fitted.fit.parameter(path));
            let of = |of: fn(&Estimate) -> Option<f64>| cell(one.and_then(of));
            [of(|one| Some(one.value)), of(|one| one.standard_error), of(|one| one.low), of(|one| one.high)]
        });
        let tail = match fit {
            Ok(Fitted { fit, data_notes, .. }) => {
                let notes: Vec<&str> = data_notes.iter().chain(&fit.notes).map(String::as_str).collect();
                [cell(fit.chi2), fit.rejected.to_string(), fit.used.len().to_string(), notes.join("; ")]
            }
            Err(error) => [String::new(), String::new(), String::new(), format!("not fitted: {error}")],
        };
        writer.write_record([file.clone()].into_iter().chain(numbers).chain(tail))?;
    }
    text(writer)
}

/// A fit as lines.
#[must_use]
pub fn fit_text(fitted: &Fitted) -> String {
    let Fitted { file, fit, .. } = fitted;
    let rows: Vec<[String; 4]> = fit.parameters.iter().map(row).collect();
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let (name, value, error) = (width(0), width(1), width(2));
    let mut lines = format!("{file}\n");
    for [path, number, spread, interval] in &rows {
        let _ = writeln!(lines, "  {path:name$}  {number:>value$}  {spread:<error$}  {interval}");
    }
    let unit = if fit.control == Control::Force { "m" } else { "N" };
    let _ = write!(lines, "  {} points, what is left {}", fit.used.len(), with_prefix(fit.deviation, unit));
    if fit.correlation.abs() > 0.0 {
        let _ = write!(lines, ", correlation of neighbours {:.3}", fit.correlation);
    }
    if let Some(chi2) = fit.chi2 {
        let verdict =
            if fit.rejected { "the data speak against the scene" } else { "as the noise before contact has it" };
        let _ = write!(lines, "; chi² per degree of freedom {chi2:.3}: {verdict}");
    }
    lines.push('\n');
    lines
}

/// Path, value, error and interval of a parameter.
fn row(one: &Estimate) -> [String; 4] {
    let shown = |value: f64| match one.unit {
        "" => format!("{value:.6}"),
        unit => with_prefix(value, unit),
    };
    let error = one.standard_error.map_or_else(|| "± ?".to_owned(), |error| format!("± {}", shown(error)));
    let interval = match (one.low, one.high) {
        (None, None) => "no interval".to_owned(),
        (low, high) => {
            let end = |end: Option<f64>| end.map_or_else(|| "no end".to_owned(), shown);
            format!("95 %: {} … {}", end(low), end(high))
        }
    };
    [one.path.clone(), shown(one.value), error, interval]
}
