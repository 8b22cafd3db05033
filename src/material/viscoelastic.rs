//! Bodies that relax: as a scene writes them, and their E*(t) against a rigid one.

use super::Relaxation;
use super::alone::Known;
use super::power_law::{PowerLaw, Times};
use super::shift::{Shift, ShiftError};
use crate::input::problem::Problem;
use crate::input::quantity::{Duration, Poisson, Stress, Temperature, Viscosity};
use crate::input::table::{TableError, Tables};
use serde::{Deserialize, Deserializer, Serialize, de};
use std::fmt;
use std::path::{Path, PathBuf};

/// Isotropic, linearly viscoelastic material with a constant Poisson's ratio.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Viscoelastic {
    /// Poisson's ratio ν, constant in time.
    pub poisson: Poisson,
    /// Relaxation in shear; with a shift that at its reference temperature.
    pub shear: Shear,
    /// Temperature T [K], with a shift.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub temperature: Option<Temperature>,
    /// How the temperature shifts the times.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shift: Option<Shift>,
}

/// Relaxation function in shear, G(t) = G∞ + Σ Gᵢ e^(−t/τᵢ) + G₀(t/t₀)^(−β), and a parallel dashpot η.
///
/// A scene writes it `(equilibrium: …, terms: […], viscosity: …)`, or `PowerLaw(modulus: …, exponent: …, time: …)` with the
/// others beside it if there are any.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Shear {
    /// Equilibrium modulus G∞ [Pa]; zero for a liquid.
    pub equilibrium: Stress,
    /// Terms Gᵢ, τᵢ of the Prony series.
    pub terms: Terms,
    /// Viscosity η [Pa s] of a parallel dashpot (Kelvin–Voigt).
    pub viscosity: Viscosity,
    /// Power law G₀, β, t₀.
    pub power_law: Option<PowerLaw>,
}

/// The terms of a Prony series: a list, or a table with columns `time_s,modulus_pa`.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Terms {
    /// Terms in the scene.
    List(Vec<Term>),
    /// Terms in a file next to the scene.
    Table(PathBuf),
}

impl Default for Terms {
    fn default() -> Self {
        Self::List(Vec::new())
    }
}

/// One Maxwell element: modulus Gᵢ [Pa] and relaxation time τᵢ [s].
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Term {
    /// Modulus Gᵢ [Pa].
    pub modulus: Stress,
    /// Relaxation time τᵢ [s].
    pub time: Duration,
}

struct TermsVisitor;

impl<'de> de::Visitor<'de> for TermsVisitor {
    type Value = Terms;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a list of terms [(modulus: \"1 MPa\", time: \"1 s\"), …] or the path of a table with columns time_s,modulus_pa")
    }

    fn visit_str<E: de::Error>(self, path: &str) -> Result<Terms, E> {
        Ok(Terms::Table(path.into()))
    }

    fn visit_seq<A: de::SeqAccess<'de>>(self, mut seq: A) -> Result<Terms, A::Error> {
        let mut terms = Vec::new();
        while let Some(term) = seq.next_element()? {
            terms.push(term);
        }
        Ok(Terms::List(terms))
    }
}

impl<'de> Deserialize<'de> for Terms {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(TermsVisitor)
    }
}

impl Viscoelastic {
    /// E*(t) = 2G(t)/(1−ν) against a rigid body (Popov & Heß 2015, eq. 7.9), terms in the order given; a power law, which
    /// stands for nothing without `times`, as its series between them.
    ///
    /// # Errors
    /// The table of terms cannot be read or holds a term that makes no sense.
    pub fn relaxation(&self, tables: &dyn Tables, times: Option<Times>) -> Result<Relaxation, TableError> {
        let scale = 2.0 / (1.0 - self.poisson.si());
        let terms = match &self.shear.terms {
            Terms::List(terms) => terms.iter().map(|term| (term.modulus.si(), term.time.si())).collect(),
            Terms::Table(path) => terms_of_table(path, tables)?,
        };
        let shift = self.shift.as_ref().zip(self.temperature);
        let shifted = shift.and_then(|(shift, temperature)| shift.factor(temperature.si(), tables).ok()).unwrap_or(1.0);
        let series = self.shear.power_law.zip(times).map(|(law, times)| law.series(times.at_reference(shifted)));
        let (beyond, series) = series.map_or((0.0, Vec::new()), |series| (series.equilibrium, series.terms));
        Ok(Relaxation {
            equilibrium: scale * (self.shear.equilibrium.si() + beyond),
            terms: terms.into_iter().chain(series).map(|(modulus, time)| (scale * modulus, shifted * time)).collect(),
            viscosity: shifted * (scale * self.shear.viscosity.si()),
        })
    }
}

fn terms_of_table(path: &Path, tables: &dyn Tables) -> Result<Vec<(f64, f64)>, TableError> {
    let columns = tables.columns(path, &["time_s", "modulus_pa"])?;
    let [times, moduli] = &columns.values[..] else {
        return Err(TableError::whole(path, "expected the columns time_s,modulus_pa"));
    };
    if times.is_empty() {
        return Err(TableError::whole(path, "has no rows: expected at least one term of the Prony series"));
    }
    for ((&time, &modulus), &row) in times.iter().zip(moduli).zip(&columns.rows) {
        Duration::new(time).map_err(|error| TableError::at(path, row, format!("time_s: {error}")))?;
        Stress::new(modulus).map_err(|error| TableError::at(path, row, format!("modulus_pa: {error}")))?;
    }
    Ok(moduli.iter().copied().zip(times.iter().copied()).collect())
}

/// E*(t) against a rigid body, above zero at once, or with a dashpot alone.
pub(super) fn instantly_stiff(body: &Viscoelastic, path: &str, known: Known<'_>) -> Result<Relaxation, Problem> {
    if let Some(problem) = badly_shifted(body, path, known.tables) {
        return Err(problem);
    }
    let relaxation = body
        .relaxation(known.tables, known.times)
        .map_err(|error| Problem::new(format!("{path}.shear.terms"), error.to_string()))?;
    if relaxation.instantaneous() > 0.0 || relaxation.viscosity > 0.0 || body.shear.power_law.is_some() {
        return Ok(relaxation);
    }
    let message = "has no modulus above zero: expected an equilibrium modulus, at least one term or a viscosity";
    Err(Problem::new(format!("{path}.shear"), message))
}

/// A temperature without a shift, a shift without a temperature, or one where the law has no value.
fn badly_shifted(body: &Viscoelastic, path: &str, tables: &dyn Tables) -> Option<Problem> {
    match (body.temperature, &body.shift) {
        (None, None) => None,
        (Some(_), None) => Some(Problem::new(
            format!("{path}.temperature"),
            "without a shift it changes nothing: expected shift: Wlf(c1: …, c2: …, reference: …) beside it, or no temperature",
        )),
        (None, Some(_)) => Some(Problem::new(
            format!("{path}.shift"),
            "lacks the temperature to which it shifts: expected temperature: \"20 degC\" or the like, or no shift",
        )),
        (Some(temperature), Some(shift)) => {
            let place = |error: &ShiftError| match error {
                ShiftError::Cold { .. } | ShiftError::Outside { .. } => "temperature",
                ShiftError::Table(_) => "shift",
            };
            let error = shift.factor(temperature.si(), tables).err()?;
            Some(Problem::new(format!("{path}.{}", place(&error)), error.to_string()))
        }
    }
}
