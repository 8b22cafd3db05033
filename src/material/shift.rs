//! How a temperature shifts the times of a material.
//!
//! # Examples
//! ```
//! use springbed::input::table::InMemory;
//! use springbed::material::Shift;
//!
//! // Measured shifts, log₁₀ a_T, straight between the temperatures.
//! let tables = InMemory::default().with("s.csv", &[("temperature_k", &[293.15, 313.15]), ("log10_shift", &[0.0, -2.0])]);
//! let shift = Shift::Table("s.csv".into());
//! assert!((shift.factor(303.15, &tables)? / 0.1 - 1.0).abs() < 1e-12);
//! assert!(shift.factor(353.15, &tables).is_err());
//! # Ok::<(), springbed::material::ShiftError>(())
//! ```

use crate::input::quantity::{Positive, Temperature, TemperatureDifference};
use crate::input::table::{TableError, Tables};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// How a temperature shifts all times of a material alike, each τᵢ to a_T τᵢ and η to a_T η.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
pub enum Shift {
    /// Williams, Landel & Ferry.
    Wlf(Wlf),
    /// Measured shifts of a master curve: a table with the columns `temperature_k` or `temperature_degc`, rising, and
    /// `log10_shift` or `shift`, log₁₀ a_T or a_T, against the temperature at which the times are given. Between its rows
    /// log₁₀ a_T is straight over the temperature; beyond them nothing is known.
    Table(PathBuf),
}

/// The shift of Williams, Landel & Ferry, log₁₀ a_T = −C₁(T − T_r)/(C₂ + T − T_r).
///
/// For amorphous polymers from their glass transition T_g to some 100 K above it (J. Am. Chem. Soc. 77, 3701, 1955, eq. 20;
/// of many C₁ = 17.44, C₂ = 51.6 K for T_r = T_g); the moduli are taken as those at T_r.
/// Check: these constants give a_T = 10^(−17.44·50/101.6) = 2.6·10⁻⁹ at 50 K above T_g.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Wlf {
    /// C₁.
    pub c1: Positive,
    /// C₂ [K].
    pub c2: TemperatureDifference,
    /// T_r [K], at which the times are given.
    pub reference: Temperature,
}

/// Why there is no shift at a temperature.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ShiftError {
    /// Where the law has no value.
    #[error(
        "{temperature:?} K is too near to {lowest:?} K or below it, where the times of Wlf become infinite: expected a higher one"
    )]
    Cold {
        /// Temperature [K].
        temperature: f64,
        /// T_r − C₂ [K].
        lowest: f64,
    },
    /// Outside the table.
    #[error(
        "{temperature:?} K is outside the table of the shifts, which goes from {from:?} to {to:?} K: expected a temperature within"
    )]
    Outside {
        /// Temperature [K].
        temperature: f64,
        /// First temperature [K].
        from: f64,
        /// Last temperature [K].
        to: f64,
    },
    /// The table.
    #[error(transparent)]
    Table(#[from] TableError),
}

/// 0 °C [K].
const ICE: f64 = 273.15;

impl Shift {
    /// a_T at the temperature `temperature` [K].
    ///
    /// # Errors
    /// The law has no value there; the table does not reach there, or cannot be read.
    pub fn factor(&self, temperature: f64, tables: &dyn Tables) -> Result<f64, ShiftError> {
        match self {
            Self::Wlf(law) => law.factor(temperature),
            Self::Table(path) => measured(path, tables)?.factor(temperature),
        }
    }
}

impl Wlf {
    fn factor(&self, temperature: f64) -> Result<f64, ShiftError> {
        let (reference, c2) = (self.reference.si(), self.c2.si());
        let above = temperature - reference;
        let factor = 10f64.powf(-self.c1.si() * above / (c2 + above));
        let known = c2 + above > 0.0 && factor > 0.0 && factor.is_finite();
        if known { Ok(factor) } else { Err(ShiftError::Cold { temperature, lowest: reference - c2 }) }
    }
}

/// Temperatures [K], rising, and log₁₀ a_T.
struct Measured {
    temperatures: Vec<f64>,
    shifts: Vec<f64>,
}

impl Measured {
    /// Straight between the rows; a row itself to rounding of the temperature.
    fn factor(&self, temperature: f64) -> Result<f64, ShiftError> {
        let (all, last) = (&self.temperatures, self.temperatures.len() - 1);
        let near = |one: f64| (temperature - one).abs() <= 4.0 * f64::EPSILON * one;
        if (temperature < all[0] && !near(all[0])) || (temperature > all[last] && !near(all[last])) {
            return Err(ShiftError::Outside { temperature, from: all[0], to: all[last] });
        }
        let after = all.partition_point(|one| *one < temperature).clamp(1, last.max(1)).min(last);
        let before = after.saturating_sub(1);
        let width = all[after] - all[before];
        let part = if width > 0.0 { ((temperature - all[before]) / width).clamp(0.0, 1.0) } else { 0.0 };
        Ok(10f64.powf(self.shifts[before] + part * (self.shifts[after] - self.shifts[before])))
    }
}

/// The table at `path`.
fn measured(path: &Path, tables: &dyn Tables) -> Result<Measured, TableError> {
    let names = tables.names(path)?;
    let either =
        |one: &'static str, other: &'static str| if names.iter().any(|name| name == one) { one } else { other };
    let wanted = [either("temperature_degc", "temperature_k"), either("shift", "log10_shift")];
    let columns = tables.columns(path, &wanted)?;
    let [temperatures, shifts] = <[Vec<f64>; 2]>::try_from(columns.values)
        .map_err(|_| TableError::whole(path, "expected the columns temperature_k,log10_shift"))?;
    if temperatures.is_empty() {
        return Err(TableError::whole(path, "has no rows: expected at least one temperature with its shift"));
    }
    let zero = if wanted[0] == "temperature_k" { 0.0 } else { ICE };
    let temperatures: Vec<f64> = temperatures.into_iter().map(|of| of + zero).collect();
    if let Some(at) = temperatures.windows(2).position(|pair| pair[1] <= pair[0]) {
        let message = format!("{} does not rise: expected rising temperatures", wanted[0]);
        return Err(TableError::at(path, columns.rows[at + 1], message));
    }
    let logarithm = |(shift, row): (f64, usize)| match wanted[1] {
        "shift" if shift > 0.0 => Ok(shift.log10()),
        "shift" => Err(TableError::at(path, row, format!("shift: {shift:?} is no factor: expected one above zero"))),
        _ => Ok(shift),
    };
    let shifts = shifts.into_iter().zip(columns.rows).map(logarithm).collect::<Result<_, _>>()?;
    Ok(Measured { temperatures, shifts })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::table::InMemory;

    fn at(names: [&str; 2], columns: [&[f64]; 2], temperature: f64) -> Result<f64, String> {
        let tables = InMemory::default().with("s.csv", &[(names[0], columns[0]), (names[1], columns[1])]);
        Shift::Table("s.csv".into()).factor(temperature, &tables).map_err(|error| error.to_string())
    }

    /// Rows of the law of Williams, Landel & Ferry give its factors back, in kelvins and degrees, as logarithm and as factor.
    #[test]
    fn rows_of_a_law_are_the_law() {
        let reference = |of: f64| Temperature::new(of).unwrap();
        let law = Wlf {
            c1: Positive::new(8.86).unwrap(),
            c2: TemperatureDifference::new(101.6).unwrap(),
            reference: reference(293.15),
        };
        let celsius: Vec<f64> = (0..9).map(|k| 10.0 * f64::from(k)).collect();
        let kelvin: Vec<f64> = celsius.iter().map(|of| of + ICE).collect();
        let factors: Vec<f64> = kelvin.iter().map(|&of| law.factor(of).unwrap()).collect();
        let logarithms: Vec<f64> = factors.iter().map(|of| of.log10()).collect();
        for (of, right) in kelvin.iter().zip(&factors) {
            let found = [
                at(["temperature_k", "log10_shift"], [&kelvin, &logarithms], *of).unwrap(),
                at(["temperature_degc", "shift"], [&celsius, &factors], *of).unwrap(),
            ];
            assert!(found.iter().all(|found| (found / right - 1.0).abs() < 1e-12), "{of}: {found:?} {right}");
        }
        assert!(
            (at(["temperature_k", "log10_shift"], [&[300.0], &[0.5]], 300.0).unwrap() / 10f64.sqrt() - 1.0).abs()
                < 1e-14
        );
    }

    #[test]
    fn a_wrong_table_is_refused_with_its_row() {
        let names = ["temperature_k", "shift"];
        assert!(at(names, [&[], &[]], 300.0).unwrap_err().contains("has no rows"));
        assert!(
            at(names, [&[300.0, 290.0], &[1.0, 2.0]], 300.0)
                .unwrap_err()
                .contains("row 3: temperature_k does not rise")
        );
        assert!(
            at(names, [&[290.0, 300.0], &[1.0, 0.0]], 295.0).unwrap_err().contains("row 3: shift: 0.0 is no factor")
        );
        let said = at(names, [&[290.0, 300.0], &[1.0, 2.0]], 301.0).unwrap_err();
        assert!(said.contains("from 290.0 to 300.0 K"), "{said}");
    }
}
