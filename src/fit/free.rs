//! What a fit may change, and on which scale.

use super::FitError;
use crate::input::problem::Problem;
use crate::text::place::{Places, Value};

/// A free parameter of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Free {
    /// Its place in the scene, such as `bodies.0.young`.
    pub path: String,
    /// Value of the scene [SI unit].
    pub start: f64,
    /// Least value [SI unit].
    pub low: f64,
    /// Largest value [SI unit].
    pub high: f64,
    /// SI unit; empty for a pure number.
    pub unit: &'static str,
}

/// Part of the present value down to which, and times of it up to which, one without a range may go.
const WIDE: f64 = 1e6;

impl Free {
    /// The parameter that `text`, `PATH=LO..HI` or `PATH`, names in a scene; the ends may have units.
    ///
    /// # Errors
    /// There is no number at the path, an end is none that it can have, or the range is empty.
    pub fn read(places: &Places, text: &str) -> Result<Self, FitError> {
        let (path, range) = text.split_once('=').map_or((text, None), |(path, range)| (path, Some(range)));
        let path = path.trim();
        let start = number(places, path)?;
        let (low, high) = match range {
            None if start > 0.0 => (start / WIDE, start * WIDE),
            None => return Err(FitError::Free(format!("{path} is {start:?}: expected a range, {path}=LO..HI"))),
            Some(range) => {
                let wrong = || FitError::Free(format!("\"{text}\" has no range: expected {path}=LO..HI"));
                let (low, high) = range.split_once("..").ok_or_else(wrong)?;
                (end(places, path, low)?, end(places, path, high)?)
            }
        };
        if low >= high {
            let what = format!("the range of {path} goes from {low:?} to {high:?}: expected the smaller end first");
            return Err(FitError::Free(what));
        }
        Ok(Self { path: path.to_owned(), start, low, high, unit: places.unit(path).unwrap_or_default() })
    }

    /// Whether it counts in ratios.
    #[must_use]
    pub fn is_ratio(&self) -> bool {
        self.low > 0.0
    }

    /// Whether all forces grow in its ratio if all parameters of its kind do.
    #[must_use]
    pub fn scales_force(&self) -> bool {
        self.is_ratio() && ["Pa", "J/m^2", "N", "Pa s"].contains(&self.unit)
    }

    /// The value on its natural scale: the logarithm of one that is positive.
    #[must_use]
    pub fn natural(&self, value: f64) -> f64 {
        if self.is_ratio() { value.ln() } else { value }
    }

    /// The value [SI unit] of one on the natural scale.
    #[must_use]
    pub fn value(&self, natural: f64) -> f64 {
        if self.is_ratio() { natural.exp() } else { natural }
    }

    /// Both ends on the natural scale.
    #[must_use]
    pub fn ends(&self) -> (f64, f64) {
        (self.natural(self.low), self.natural(self.high))
    }

    /// The value `part` of the way from the low end to the high one.
    #[must_use]
    pub fn between(&self, part: f64) -> f64 {
        let (low, high) = self.ends();
        self.value(low + part * (high - low)).clamp(self.low, self.high)
    }
}

/// The number [SI unit] that `text` stands for at a place.
pub(super) fn end(places: &Places, path: &str, text: &str) -> Result<f64, FitError> {
    number(&Places::of(&places.with(&[(path, given(text))])?)?, path)
}

/// The number at a place, or what is there instead.
pub(super) fn number(places: &Places, path: &str) -> Result<f64, FitError> {
    places.number(path).ok_or_else(|| {
        let wrong = places.with(&[(path, Value::from(1.0))]).err();
        wrong.unwrap_or_else(|| Problem::new(path, "holds no number: expected the place of one")).into()
    })
}

/// A value as it is written: a number in SI units, or text with its unit.
fn given(text: &str) -> Value {
    text.trim().parse::<f64>().map_or_else(|_| Value::from(text.trim()), Value::from)
}
