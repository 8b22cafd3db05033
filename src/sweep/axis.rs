//! A place of a scene and the values it takes.

use crate::input::problem::Problem;
use crate::input::values::{Range, Values};
use crate::text::place::{Places, Value};
use serde::{Deserialize, Serialize};

/// A place of a scene and the values it takes, one after another.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
pub struct Axis {
    /// Path of the place, such as `bodies.0.young`.
    pub path: String,
    /// SI unit of the numbers, empty of pure ones; `None` where there are words.
    pub unit: Option<String>,
    /// Numbers in SI units, or words; at least one.
    pub values: Vec<Value>,
}

impl Axis {
    /// The values at `path` of the scene `places`, read as the scene would read them.
    ///
    /// # Errors
    /// The path leads nowhere, a value cannot stand there, a range is not one of numbers.
    pub fn new(places: &Places, path: &str, values: &Values) -> Result<Self, Problem> {
        let values = match values {
            Values::List(all) => {
                all.iter().map(|given| read(places, path, of_words(given))).collect::<Result<_, _>>()?
            }
            Values::Range(range) => between(places, path, range)?,
        };
        Self::of_values(places, path, values)
    }

    /// The values at `path`, each as a scene in JSON has it.
    ///
    /// # Errors
    /// The path leads nowhere, a value cannot stand there, or there is none.
    pub fn given(places: &Places, path: &str, values: Vec<Value>) -> Result<Self, Problem> {
        let values = values.into_iter().map(|value| read(places, path, value)).collect::<Result<_, _>>()?;
        Self::of_values(places, path, values)
    }

    fn of_values(places: &Places, path: &str, values: Vec<Value>) -> Result<Self, Problem> {
        let first = values.first().ok_or_else(|| Problem::new(path, "has no values: expected at least one"))?;
        let set = Places::of(&places.with(&[(path, first.clone())])?)?;
        Ok(Self { path: path.to_owned(), unit: set.unit(path).map(str::to_owned), values })
    }

    /// The number of a value, if it is one.
    #[must_use]
    pub fn number(&self, pick: usize) -> Option<f64> {
        self.values.get(pick)?.as_f64()
    }
}

/// A number, `true`, a whole value in JSON, or else a word or text with a unit.
fn of_words(given: &str) -> Value {
    given.parse().unwrap_or_else(|_| Value::from(given))
}

/// A value as the scene reads it: a quantity in SI units.
fn read(places: &Places, path: &str, value: Value) -> Result<Value, Problem> {
    let set = Places::of(&places.with(&[(path, value.clone())])?)?;
    Ok(match (set.value(path), set.number(path)) {
        (Some(Value::Array(_)), Some(number)) => Value::from(number),
        (Some(read), _) => read.clone(),
        // A quantity that may be given in another way than it is kept.
        (None, _) => value,
    })
}

/// The values of a range; where the scene takes whole numbers the nearest ones, each once.
fn between(places: &Places, path: &str, range: &Range) -> Result<Vec<Value>, Problem> {
    let end = |given: &str| read(places, path, of_words(given));
    let (from, to) = (end(&range.from)?, end(&range.to)?);
    let (Some(first), Some(last)) = (from.as_f64(), to.as_f64()) else {
        return Err(Problem::new(path, format!("a range needs numbers, found {from} and {to}: expected [a,b,c]")));
    };
    let numbers = range.between(first, last).map_err(|error| Problem::new(path, error.to_string()))?;
    if !(from.is_u64() && to.is_u64()) {
        return Ok(numbers.into_iter().map(Value::from).collect());
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between two whole numbers")]
    let mut whole: Vec<u64> = numbers.into_iter().map(|number| number.round() as u64).collect();
    whole.dedup();
    Ok(whole.into_iter().map(Value::from).collect())
}
