//! Relaxation spectra as lines, tables and JSON.

use super::summary::with_prefix;
use super::tables::{cell, text};
use crate::fit::Master;
use crate::fit::prony::{Moduli, Spectrum};
use serde::Serialize;
use std::fmt::Write as _;

#[derive(Serialize)]
struct Summary<'s> {
    version: &'static str,
    data: &'s str,
    equilibrium_pa: f64,
    terms: Vec<Term>,
    relative_deviation: f64,
    smoothing: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    master: Option<Shifted>,
}

/// The shifts of a master curve.
#[derive(Serialize)]
struct Shifted {
    reference_k: f64,
    wlf_c1: Option<f64>,
    wlf_c2_k: Option<f64>,
    shifts: Vec<Shift>,
}

#[derive(Serialize)]
struct Shift {
    temperature_k: f64,
    log10_shift: f64,
    standard_error: f64,
    vertical_shift: f64,
}

impl Shifted {
    fn of(master: &Master) -> Self {
        let shift = |((&(temperature_k, log10_shift), &standard_error), &vertical_shift)| Shift {
            temperature_k,
            log10_shift,
            standard_error,
            vertical_shift,
        };
        Self {
            reference_k: master.reference,
            wlf_c1: master.wlf.map(|law| law.0),
            wlf_c2_k: master.wlf.map(|law| law.1),
            shifts: master.shifts.iter().zip(&master.errors).zip(&master.vertical).map(shift).collect(),
        }
    }
}

#[derive(Serialize)]
struct Term {
    modulus: f64,
    time: f64,
}

/// A spectrum as JSON; `file` is the name of the data.
///
/// # Errors
/// A number cannot be written as JSON.
pub fn spectrum_json(file: &str, spectrum: &Spectrum, master: Option<&Master>) -> Result<String, serde_json::Error> {
    let terms = spectrum.terms.iter().map(|&(modulus, time)| Term { modulus, time }).collect();
    let summary = Summary {
        version: env!("CARGO_PKG_VERSION"),
        data: file,
        equilibrium_pa: spectrum.equilibrium,
        terms,
        relative_deviation: spectrum.deviation,
        smoothing: spectrum.smoothing,
        master: master.map(Shifted::of),
    };
    serde_json::to_string_pretty(&summary).map(|text| format!("{text}\n"))
}

/// Measured moduli and those of the spectrum.
///
/// # Errors
/// The text cannot be put together.
pub fn spectrum_points(moduli: &Moduli, spectrum: &Spectrum) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(["frequency_hz", "storage_pa", "loss_pa", "model_storage_pa", "model_loss_pa"])?;
    for ((&frequency, &storage), &loss) in moduli.frequency.iter().zip(&moduli.storage).zip(&moduli.loss) {
        let model = spectrum.at(frequency);
        writer.write_record([frequency, storage, loss, model.0, model.1].map(|number| cell(Some(number))))?;
    }
    text(writer)
}

/// A spectrum as lines, with the piece of a scene that says it.
#[must_use]
pub fn spectrum_text(file: &str, spectrum: &Spectrum, master: Option<&Master>) -> String {
    let mut lines = format!("{file}\n  equilibrium  {}\n", with_prefix(spectrum.equilibrium, "Pa"));
    for &(modulus, time) in &spectrum.terms {
        let _ = writeln!(lines, "  {:>12} with {}", with_prefix(modulus, "Pa"), with_prefix(time, "s"));
    }
    let _ = writeln!(lines, "  relative residual {:.2e}", spectrum.deviation);
    let term = |&(modulus, time): &(f64, f64)| format!("(modulus: {modulus:.5e}, time: {time:.5e})");
    let terms: Vec<String> = spectrum.terms.iter().map(term).collect();
    let _ = writeln!(lines, "shear: (equilibrium: {:.5e}, terms: [{}])", spectrum.equilibrium, terms.join(", "));
    if let Some(master) = master {
        for (&(temperature, log), error) in master.shifts.iter().zip(&master.errors) {
            let law = master.law(temperature).map_or_else(String::new, |law| format!("  ({law:.3} by the law)"));
            let _ = writeln!(lines, "  at {temperature:.2} K: log a_T {log:.3} ± {error:.3}{law}");
        }
        let _ = match master.wlf {
            Some((c1, c2)) => {
                writeln!(lines, "shift: Wlf(c1: {c1:.4}, c2: \"{c2:.3} K\", reference: \"{:.2} K\")", master.reference)
            }
            None => writeln!(lines, "  the shifts follow no law of Williams, Landel & Ferry"),
        };
    }
    lines
}

/// The shifts of a master curve, one row per temperature.
///
/// # Errors
/// The text cannot be put together.
pub fn shifts_table(master: &Master) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(["temperature_k", "log10_shift", "standard_error", "vertical_shift", "wlf_log10_shift"])?;
    for ((&(temperature, log), &error), &vertical) in master.shifts.iter().zip(&master.errors).zip(&master.vertical) {
        writer.write_record([
            cell(Some(temperature)),
            cell(Some(log)),
            cell(Some(error)),
            cell(Some(vertical)),
            cell(master.law(temperature)),
        ])?;
    }
    text(writer)
}
