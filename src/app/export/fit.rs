//! Fits as lines and tables.

use super::fit_json::{ModelRow, Parameter};
use super::fitted::{Fitted, Tried};
use super::summary::with_prefix;
use super::tables::{cell, text};
use crate::fit::{Estimate, Map};
use crate::scene::fit::Drive;
use std::fmt::Write as _;

/// The points of a curve with what the fit says of them, one row per row of the data.
///
/// # Errors
/// The text cannot be put together.
pub fn fit_points(fitted: &Fitted) -> Result<String, csv::Error> {
    let Fitted { curve, fit, .. } = fitted;
    let names = match fit.led {
        Drive::Depth => ["row", "indentation_m", "force_n", "model_force_n", "residual_n", "counts"],
        Drive::Force => ["row", "force_n", "indentation_m", "model_indentation_m", "residual_m", "counts"],
        Drive::Speed => ["row", "speed_m_per_s", "restitution", "model_restitution", "residual", "counts"],
        Drive::Slide => ["row", "slide_m", "tangential_force_n", "model_tangential_force_n", "residual_n", "counts"],
    };
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(names)?;
    let (drive, response) = (curve.driven(fit.led), curve.answered(fit.led));
    for at in 0..curve.len() {
        let numbers = [drive[at], response[at], fit.model[at], response[at] - fit.model[at]];
        let cells = numbers.into_iter().map(|number| cell(Some(number)));
        let counts = fit.used.binary_search(&at).is_ok();
        let counts = if counts { "1" } else { "0" };
        writer.write_record([curve.rows[at].to_string()].into_iter().chain(cells).chain([counts.to_owned()]))?;
    }
    text(writer)
}

/// What the table of several fits has of one data file.
#[derive(Debug, Clone)]
pub struct FitsRow {
    file: String,
    parameters: Vec<Estimate>,
    chi2: Option<f64>,
    /// Whether the data speak against the scene.
    rejected: Option<bool>,
    /// Number of points that counted.
    points: Option<usize>,
    notes: String,
}

impl FitsRow {
    /// Of a curve with its fit.
    #[must_use]
    pub fn of(Fitted { file, fit, data_notes, .. }: &Fitted) -> Self {
        let notes: Vec<&str> = data_notes.iter().chain(&fit.notes).map(String::as_str).collect();
        Self {
            file: file.clone(),
            parameters: fit.parameters.clone(),
            chi2: fit.chi2,
            rejected: Some(fit.rejected),
            points: Some(fit.used.len()),
            notes: notes.join("; "),
        }
    }

    /// Of a file that has no fit, and why.
    #[must_use]
    pub fn without_fit(file: String, why: &str) -> Self {
        let notes = format!("not fitted: {why}");
        Self { file, parameters: Vec::new(), chi2: None, rejected: None, points: None, notes }
    }

    fn cells(&self, paths: &[&str]) -> Vec<String> {
        let numbers = paths.iter().flat_map(|path| {
            let one = self.parameters.iter().find(|estimate| estimate.path == *path);
            let of = |of: fn(&Estimate) -> Option<f64>| cell(one.and_then(of));
            [of(|one| Some(one.value)), of(|one| one.standard_error), of(|one| one.low), of(|one| one.high)]
        });
        let rejected = self.rejected.map(|rejected| rejected.to_string()).unwrap_or_default();
        let points = self.points.map(|points| points.to_string()).unwrap_or_default();
        let tail = [cell(self.chi2), rejected, points, self.notes.clone()];
        [self.file.clone()].into_iter().chain(numbers).chain(tail).collect()
    }
}

/// Fits as a table, one row per data file.
///
/// # Errors
/// The text cannot be put together.
pub fn fits_table(rows: &[FitsRow]) -> Result<String, csv::Error> {
    let mut paths: Vec<&str> = Vec::new();
    for one in rows.iter().flat_map(|row| &row.parameters) {
        if !paths.contains(&one.path.as_str()) {
            paths.push(&one.path);
        }
    }
    let mut writer = csv::Writer::from_writer(Vec::new());
    let four = |path: &&str| [path.to_string(), format!("{path}.error"), format!("{path}.low"), format!("{path}.high")];
    let heads = paths.iter().flat_map(four);
    let tail = ["chi2", "rejected", "points", "notes"].map(str::to_owned);
    writer.write_record(["file".to_owned()].into_iter().chain(heads).chain(tail))?;
    for row in rows {
        writer.write_record(row.cells(&paths))?;
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
    let left = match fit.led {
        Drive::Depth | Drive::Slide => with_prefix(fit.deviation, "N"),
        Drive::Force => with_prefix(fit.deviation, "m"),
        Drive::Speed => format!("{:.3e}", fit.deviation),
    };
    let _ = write!(lines, "  {} points, what is left {left}", fit.used.len());
    if fit.correlation.abs() > 0.0 {
        let _ = write!(lines, ", correlation of neighbours {:.3}", fit.correlation);
    }
    if let Some(chi2) = fit.chi2 {
        let verdict =
            if fit.rejected { "the data speak against the scene" } else { "as the noise before contact has it" };
        let _ = write!(lines, "; chi² per degree of freedom {chi2:.3}: {verdict}");
    }
    lines.push('\n');
    lines.push_str(&models_text(&fitted.models));
    lines
}

/// The models that were compared, the best first.
fn models_text(models: &[Tried]) -> String {
    let mut ranked: Vec<&Tried> = models.iter().collect();
    let beyond = |one: &Tried| one.standing.map_or(f64::INFINITY, |standing| standing.beyond_best);
    ranked.sort_by(|a, b| beyond(a).total_cmp(&beyond(b)));
    let width = models.iter().map(|one| one.name.chars().count()).max().unwrap_or(0);
    let mut lines = String::new();
    for Tried { name, standing, answer } in ranked {
        let told = match (standing, answer) {
            (Some(standing), Ok(answered)) => {
                let mut told = format!("ΔBIC {:.1}, weight {:.3}", standing.beyond_best, standing.weight);
                let tabor = answered.tabor.map(|tabor| format!(", Tabor parameter {tabor:.3}"));
                told.push_str(&tabor.unwrap_or_default());
                told.push_str(if answered.fit.rejected { "; the data speak against it" } else { "" });
                told
            }
            (_, Err(why)) => format!("not fitted: {why}"),
            (None, Ok(_)) => "not compared".to_owned(),
        };
        let _ = writeln!(lines, "  model {name:width$}  {told}");
    }
    lines
}

/// The models that were compared on a curve, one row per parameter of each.
///
/// # Errors
/// The text cannot be put together.
pub fn models_table(fitted: &Fitted) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(MODEL_COLUMNS)?;
    for model in &fitted.models {
        let row = ModelRow::of(model);
        let head = [cell(row.bic_beyond_best), cell(row.weight), cell(row.chi2), cell(row.tabor_parameter)];
        let rejected = row.rejected.map_or_else(String::new, |rejected| rejected.to_string());
        let line = |parameter: Option<&Parameter<'_>>| {
            let of = |of: fn(&Parameter<'_>) -> Option<f64>| cell(parameter.and_then(of));
            let numbers =
                [of(|one| Some(one.value)), of(|one| one.standard_error), of(|one| one.low), of(|one| one.high)];
            let path = parameter.map_or(String::new(), |one| one.path.to_owned());
            let unit = parameter.map_or(String::new(), |one| one.unit.to_owned());
            let names = [row.model.to_owned()].into_iter().chain(head.clone()).chain([rejected.clone(), path]);
            names.chain(numbers).chain([unit, row.notes.join("; ")]).collect::<Vec<String>>()
        };
        if row.parameters.is_empty() {
            writer.write_record(line(None))?;
        }
        for parameter in &row.parameters {
            writer.write_record(line(Some(parameter)))?;
        }
    }
    text(writer)
}

const MODEL_COLUMNS: [&str; 13] = [
    "model",
    "bic_beyond_best",
    "weight",
    "chi2",
    "tabor_parameter",
    "rejected",
    "path",
    "value",
    "standard_error",
    "low",
    "high",
    "unit",
    "notes",
];

/// The confidence over two parameters, one row per pair of values.
///
/// # Errors
/// The text cannot be put together.
pub fn map_table(map: &Map) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record([&map.paths[0], &map.paths[1], "chi2_rise", "confidence"])?;
    let pairs = map.x.iter().flat_map(|&x| map.y.iter().map(move |&y| (x, y)));
    for ((x, y), &rise) in pairs.zip(&map.rise) {
        let confidence = rise.map(|rise| map.confidence(rise));
        writer.write_record([cell(Some(x)), cell(Some(y)), cell(rise), cell(confidence)])?;
    }
    text(writer)
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
