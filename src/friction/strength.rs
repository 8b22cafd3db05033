//! Shear strength of a sliding interface: a number, or a table over the sliding speed.
//!
//! # Examples
//! ```
//! use springbed::friction::StrengthCurve;
//! use springbed::input::table::InMemory;
//!
//! let speeds: (&str, &[f64]) = ("speed_m_per_s", &[1e-6, 1e-4]);
//! let tables = InMemory::default().with("gel.csv", &[speeds, ("shear_pa", &[1e5, 2e5])]);
//! let curve = StrengthCurve::read("gel.csv".as_ref(), &tables)?;
//! assert_eq!(curve.at(1e-4)?, 2e5);
//! assert!(curve.at(1.0).unwrap_err().to_string().contains("outside the table"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::contact::error::OutsideTable;
use crate::input::quantity::{Speed, Stress};
use crate::input::table::{TableError, Tables};
use serde::{Deserialize, Deserializer, Serialize, de};
use std::fmt;
use std::path::{Path, PathBuf};

/// Shear strength τ_c as a scene gives it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Strength {
    /// The same at all speeds [Pa].
    Constant(Stress),
    /// A table with the columns `speed_m_per_s,shear_pa`, next to the scene.
    Table(PathBuf),
}

struct StrengthVisitor;

impl de::Visitor<'_> for StrengthVisitor {
    type Value = Strength;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a pressure (a number in Pa or text with a unit such as \"10 kPa\") or the path of a table such as \"shear.csv\" with columns speed_m_per_s,shear_pa")
    }

    fn visit_f64<E: de::Error>(self, value: f64) -> Result<Strength, E> {
        Stress::new(value).map(Strength::Constant).map_err(E::custom)
    }

    #[expect(clippy::cast_precision_loss, reason = "a whole number above 2^53 in a scene is a rounded number anyway")]
    fn visit_i64<E: de::Error>(self, value: i64) -> Result<Strength, E> {
        self.visit_f64(value as f64)
    }

    #[expect(clippy::cast_precision_loss, reason = "a whole number above 2^53 in a scene is a rounded number anyway")]
    fn visit_u64<E: de::Error>(self, value: u64) -> Result<Strength, E> {
        self.visit_f64(value as f64)
    }

    fn visit_str<E: de::Error>(self, text: &str) -> Result<Strength, E> {
        if Path::new(text).extension().is_some_and(|extension| extension.eq_ignore_ascii_case("csv")) {
            return Ok(Strength::Table(text.into()));
        }
        text.parse().map(Strength::Constant).map_err(E::custom)
    }
}

impl<'de> Deserialize<'de> for Strength {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(StrengthVisitor)
    }
}

/// Shear strength over the sliding speed, linear in the logarithm of the speed between the rows.
///
/// Check: 1 kPa at 1 µm/s and 3 kPa at 100 µm/s give 2 kPa at 10 µm/s.
#[derive(Debug, Clone, PartialEq)]
pub struct StrengthCurve {
    /// Speeds [m/s], rising.
    speeds: Vec<f64>,
    /// Strengths [Pa].
    strengths: Vec<f64>,
}

const COLUMNS: [&str; 2] = ["speed_m_per_s", "shear_pa"];

impl StrengthCurve {
    /// The curve in the table at `path`, with the columns `speed_m_per_s` and `shear_pa`.
    ///
    /// # Errors
    /// The table cannot be read, has no rows, or holds speeds that do not rise or a strength that
    /// makes no sense.
    pub fn read(path: &Path, tables: &dyn Tables) -> Result<Self, TableError> {
        let columns = tables.columns(path, &COLUMNS)?;
        let [speeds, strengths] = <[Vec<f64>; 2]>::try_from(columns.values)
            .map_err(|_| TableError::whole(path, "expected the columns speed_m_per_s,shear_pa"))?;
        if speeds.is_empty() {
            return Err(TableError::whole(path, "has no rows: expected at least one speed with its shear strength"));
        }
        for ((&speed, &strength), &row) in speeds.iter().zip(&strengths).zip(&columns.rows) {
            Speed::new(speed).map_err(|error| TableError::at(path, row, format!("speed_m_per_s: {error}")))?;
            Stress::new(strength).map_err(|error| TableError::at(path, row, format!("shear_pa: {error}")))?;
        }
        if let Some(at) = speeds.windows(2).position(|pair| pair[1] <= pair[0]) {
            let message =
                format!("speed_m_per_s goes from {} to {}: expected rising speeds", speeds[at], speeds[at + 1]);
            return Err(TableError::at(path, columns.rows[at + 1], message));
        }
        Ok(Self { speeds, strengths })
    }

    /// Least and greatest speed [m/s].
    #[must_use]
    pub fn range(&self) -> (f64, f64) {
        (self.speeds[0], self.speeds[self.speeds.len() - 1])
    }

    /// Shear strength [Pa] at the sliding speed `speed` [m/s].
    ///
    /// # Errors
    /// The speed is outside the table. An end of the table holds to rounding: a speed is a way over a time.
    pub fn at(&self, speed: f64) -> Result<f64, OutsideTable> {
        let (least, most) = self.range();
        let slack = 1.0 + 8.0 * f64::EPSILON;
        if !(speed * slack >= least && speed <= most * slack) {
            return Err(OutsideTable { speed, least, most });
        }
        let upper = self.speeds.partition_point(|&row| row < speed).min(self.speeds.len() - 1);
        let lower = upper.saturating_sub(1);
        let width = (self.speeds[upper] / self.speeds[lower]).ln();
        let part = if width > 0.0 { ((speed / self.speeds[lower]).ln() / width).clamp(0.0, 1.0) } else { 1.0 };
        Ok(self.strengths[lower] + part * (self.strengths[upper] - self.strengths[lower]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::table::InMemory;

    fn read(speeds: &[f64], strengths: &[f64]) -> Result<StrengthCurve, String> {
        let tables = InMemory::default().with("s.csv", &[("speed_m_per_s", speeds), ("shear_pa", strengths)]);
        StrengthCurve::read(Path::new("s.csv"), &tables).map_err(|error| error.to_string())
    }

    #[test]
    fn between_rows_the_strength_is_linear_in_the_decades() {
        let curve = read(&[1e-6, 1e-4, 1e-3], &[1e3, 3e3, 2e3]).unwrap();
        for (speed, right) in [(1e-6, 1e3), (1e-5, 2e3), (1e-4, 3e3), (1e-3, 2e3)] {
            assert!((curve.at(speed).unwrap() / right - 1.0).abs() < 1e-14, "{speed:e}");
        }
        assert!(curve.at(1e-6 * (1.0 - 1e-16)).is_ok());
    }

    #[test]
    fn outside_the_table_the_range_is_named() {
        let curve = read(&[1e-6, 1e-4], &[1e3, 3e3]).unwrap();
        let said = curve.at(1e-2).unwrap_err().to_string();
        assert!(said.contains("1e-2 m/s") && said.contains("from 1e-6 to 1e-4 m/s"), "{said}");
        assert!(curve.at(1e-7).is_err() && curve.at(0.0).is_err() && curve.at(f64::NAN).is_err());
    }

    #[test]
    fn a_wrong_table_is_refused_with_its_row() {
        assert!(read(&[], &[]).unwrap_err().contains("has no rows"));
        assert_eq!(
            read(&[1e-6, 1e-6], &[1.0, 2.0]).unwrap_err(),
            "s.csv, row 3: speed_m_per_s goes from 0.000001 to 0.000001: expected rising speeds"
        );
        assert!(read(&[0.0, 1.0], &[1.0, 2.0]).unwrap_err().contains("row 2: speed_m_per_s"));
        assert!(read(&[1.0], &[-1.0]).unwrap_err().contains("row 2: shear_pa"));
    }
}
