//! The values a number of a scene is to take, one after another: `v`, `[a,b,c]`, `LO..HI:N` or `LO..HI:Nlog`.
//!
//! # Examples
//! ```
//! use springbed::input::values::{Spacing, Values};
//!
//! let Values::Range(range) = "1kPa..1MPa:50log".parse()? else { panic!() };
//! assert_eq!((range.from.as_str(), range.to.as_str(), range.count, range.spacing), ("1kPa", "1MPa", 50, Spacing::Log));
//! // Four numbers of equal ratio; the ends are exact.
//! let log: Values = "1..1000:4log".parse()?;
//! let Values::Range(range) = log else { panic!() };
//! assert_eq!(range.between(1.0, 1000.0)?, [1.0, 10.0, 100.0, 1000.0]);
//! assert_eq!("[1 um, 2 um]".parse(), Ok(Values::List(vec!["1 um".to_owned(), "2 um".to_owned()])));
//! assert!("1..2".parse::<Values>().unwrap_err().to_string().contains("LO..HI:N"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use serde::{Deserialize, Serialize};
use std::fmt;
use std::str::FromStr;

/// Most values of one range.
const MOST: usize = 10_000_000;

/// Values as a person writes them; each is a number in SI units or text with its unit, to be read where it stands.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, Serialize)]
#[serde(try_from = "String", into = "String")]
pub enum Values {
    /// These.
    List(Vec<String>),
    /// Those between two ends.
    Range(Range),
}

/// Values from one end to the other, both of them included.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Range {
    /// The first.
    pub from: String,
    /// The last.
    pub to: String,
    /// How many, at least 2.
    pub count: usize,
    /// What is equal between them.
    pub spacing: Spacing,
}

/// What is equal between the values of a range.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spacing {
    /// Differences.
    Linear,
    /// Ratios.
    Log,
}

/// Why values were refused; the text says what they were and what would be right.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct ValuesError(String);

impl Range {
    /// The values between the ends `from` and `to`: from + (to − from)·i/(N−1), or from·(to/from)^(i/(N−1)).
    ///
    /// # Errors
    /// Equal ratios between ends of which one is zero or that differ in sign.
    pub fn between(&self, from: f64, to: f64) -> Result<Vec<f64>, ValuesError> {
        if self.spacing == Spacing::Log && from * to <= 0.0 {
            return Err(ValuesError(format!(
                "{self} goes from {from:?} to {to:?}: expected ends above zero for `log`"
            )));
        }
        #[expect(clippy::cast_precision_loss, reason = "counts are small")]
        let part = |i: usize| i as f64 / (self.count - 1) as f64;
        let between = |i| match self.spacing {
            Spacing::Linear => from + (to - from) * part(i),
            Spacing::Log => from * 10f64.powf((to / from).log10() * part(i)),
        };
        let last = self.count - 1;
        Ok((0..self.count)
            .map(|i| {
                if i == 0 {
                    from
                } else if i == last {
                    to
                } else {
                    between(i)
                }
            })
            .collect())
    }
}

impl FromStr for Values {
    type Err = ValuesError;

    fn from_str(text: &str) -> Result<Self, ValuesError> {
        let text = text.trim();
        if let Some(inner) = text.strip_prefix('[') {
            let inner = inner.strip_suffix(']');
            let inner = inner.ok_or_else(|| ValuesError(format!("{text} has no closing bracket: expected [a,b,c]")))?;
            return listed(inner, text);
        }
        match text.split_once("..").filter(|(from, _)| !from.is_empty() && !text.starts_with(['"', '{'])) {
            Some((from, rest)) => Ok(Self::Range(range(from, rest, text)?)),
            None => listed(text, text),
        }
    }
}

fn listed(inner: &str, text: &str) -> Result<Values, ValuesError> {
    let all: Vec<String> = elements(inner).into_iter().map(|element| element.trim().to_owned()).collect();
    if all.iter().any(String::is_empty) {
        let right = "expected `v`, `[a,b,c]`, `LO..HI:N` or `LO..HI:Nlog`";
        return Err(ValuesError(format!("\"{text}\" lacks a value: {right}")));
    }
    Ok(Values::List(all))
}

/// What stands between the commas that are in no bracket and no text.
fn elements(text: &str) -> Vec<&str> {
    let (mut depth, mut quoted) = (0_usize, false);
    text.split(|c| {
        match c {
            '"' => quoted = !quoted,
            '[' | '{' | '(' if !quoted => depth += 1,
            ']' | '}' | ')' if !quoted => depth = depth.saturating_sub(1),
            _ => {}
        }
        c == ',' && depth == 0 && !quoted
    })
    .collect()
}

fn range(from: &str, rest: &str, text: &str) -> Result<Range, ValuesError> {
    let fault = |what: &str| ValuesError(format!("\"{text}\" {what}: expected LO..HI:N or LO..HI:Nlog"));
    let (to, count) = rest.rsplit_once(':').ok_or_else(|| fault("does not say how many values"))?;
    let (count, spacing) = match count.trim().strip_suffix("log") {
        Some(count) => (count, Spacing::Log),
        None => (count.trim(), Spacing::Linear),
    };
    let count: usize = count.trim().parse().map_err(|_| fault(&format!("has no count in `{count}`")))?;
    if !(2..=MOST).contains(&count) {
        return Err(fault(&format!("has {count} values where 2 to {MOST} are meant")));
    }
    let (from, to) = (from.trim().to_owned(), to.trim().to_owned());
    if from.is_empty() || to.is_empty() { Err(fault("lacks an end")) } else { Ok(Range { from, to, count, spacing }) }
}

impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let log = if self.spacing == Spacing::Log { "log" } else { "" };
        write!(f, "{}..{}:{}{log}", self.from, self.to, self.count)
    }
}

impl fmt::Display for Values {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::List(all) => write!(f, "[{}]", all.join(",")),
            Self::Range(range) => range.fmt(f),
        }
    }
}

impl TryFrom<String> for Values {
    type Error = ValuesError;

    fn try_from(text: String) -> Result<Self, ValuesError> {
        text.parse()
    }
}

impl From<Values> for String {
    fn from(values: Values) -> Self {
        values.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn list(text: &str) -> Vec<String> {
        match text.parse() {
            Ok(Values::List(all)) => all,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn a_list_is_split_at_its_own_commas_only() {
        assert_eq!(list("5 mm"), ["5 mm"]);
        assert_eq!(list(" [1, [2,3] ,\"a,b\"] "), ["1", "[2,3]", "\"a,b\""]);
        assert_eq!(list("../tip.csv"), ["../tip.csv"]);
        assert_eq!(list("[{\"Cone\": {\"slope\": 1, \"x\": 2}}, 3]").len(), 2);
    }

    #[test]
    fn what_is_wrong_is_told_with_what_would_be_right() {
        let wrong = |text: &str| text.parse::<Values>().unwrap_err().to_string();
        assert_eq!(wrong("1..2"), "\"1..2\" does not say how many values: expected LO..HI:N or LO..HI:Nlog");
        assert!(wrong("1..2:many").contains("has no count in `many`"));
        assert!(wrong("1..2:1").contains("has 1 values where 2 to"));
        assert!(wrong("1..:3log").contains("lacks an end"));
        assert!(wrong("[1,,2]").contains("lacks a value"));
        assert!(wrong("[1,2").contains("no closing bracket"));
        assert!(wrong("").contains("lacks a value"));
        let Ok(Values::Range(range)) = "0..1:3log".parse() else { panic!() };
        assert!(range.between(0.0, 1.0).unwrap_err().to_string().contains("ends above zero"));
    }

    proptest! {
        /// Ends to the bit, the rest in order, equal steps or ratios to rounding.
        #[test]
        fn a_range_keeps_its_ends_and_its_order(lo in 1_u32..1_000_000, up in 1_u32..1_000_000, count in 2_usize..40) {
            let (lo, hi) = (f64::from(lo) * 1e-9, f64::from(lo) * 1e-9 + f64::from(up));
            for (ending, ratio) in [("", false), ("log", true)] {
                let Ok(Values::Range(range)) = format!("{lo}..{hi}:{count}{ending}").parse() else { panic!() };
                let all = range.between(lo, hi).unwrap();
                prop_assert!(all.len() == count && all[0].to_bits() == lo.to_bits());
                prop_assert!(all[count - 1].to_bits() == hi.to_bits());
                prop_assert!(all.windows(2).all(|pair| pair[0] < pair[1]));
                let step = |pair: &[f64]| if ratio { pair[1] / pair[0] } else { pair[1] - pair[0] };
                let first = step(&all[..2]);
                // A difference of neighbours carries the rounding of the larger end.
                let slack = if ratio { 1e-12 * first } else { 8.0 * f64::EPSILON * hi };
                prop_assert!(all.windows(2).all(|pair| (step(pair) - first).abs() <= slack));
            }
        }

        /// As written again it is read as the same.
        #[test]
        fn what_is_written_is_read_again(text in "[0-9a-zA-Z\\[\\]\",.:{} ]{0,20}") {
            if let Ok(values) = text.parse::<Values>() {
                prop_assert_eq!(values.to_string().parse::<Values>().unwrap(), values);
            }
        }
    }
}
