//! Numbers and answers that have a name.
//!
//! ```
//! use springbed::run::named::Named;
//! use springbed::run::unit::Unit;
//!
//! let force = Named::number("largest_force", Unit::NEWTON, 30.8);
//! assert_eq!(force.name(), "largest_force_n");
//! assert!(force.is_called("largest_force_n") && !force.is_called("largest_force"));
//! ```

use super::unit::Unit;
use serde::Serialize;
use std::fmt;

/// A named result of a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Named {
    /// What it is; in a file its name is this and the ending of the unit, such as `largest_force_n`.
    pub quantity: &'static str,
    /// SI unit.
    pub unit: Unit,
    /// What it comes to.
    pub finding: Finding,
}

/// What a named result comes to.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Finding {
    /// A number in the SI unit of the result.
    Number(f64),
    /// A yes or no.
    Answer(bool),
    /// A count.
    Count(usize),
}

impl fmt::Display for Finding {
    /// The number to rounding, `yes` or `no`, the count.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => write!(f, "{number:?}"),
            Self::Answer(yes) => f.write_str(if *yes { "yes" } else { "no" }),
            Self::Count(count) => write!(f, "{count}"),
        }
    }
}

impl Named {
    /// A number in a unit.
    #[must_use]
    pub const fn number(quantity: &'static str, unit: Unit, number: f64) -> Self {
        Self { quantity, unit, finding: Finding::Number(number) }
    }

    /// A yes or no.
    #[must_use]
    pub const fn answer(quantity: &'static str, yes: bool) -> Self {
        Self { quantity, unit: Unit::ONE, finding: Finding::Answer(yes) }
    }

    /// A count.
    #[must_use]
    pub const fn count(quantity: &'static str, count: usize) -> Self {
        Self { quantity, unit: Unit::ONE, finding: Finding::Count(count) }
    }

    /// Multiplies the number of the quantity `quantity` by `factor`; all else stays.
    pub fn scale(&mut self, quantity: &str, factor: f64) {
        if let Finding::Number(number) = &mut self.finding
            && self.quantity == quantity
        {
            *number *= factor;
        }
    }

    /// Name in files, such as `largest_force_n`.
    #[must_use]
    pub fn name(&self) -> String {
        format!("{}{}", self.quantity, self.unit.ending)
    }

    /// Whether it has this name.
    #[must_use]
    pub fn is_called(&self, name: &str) -> bool {
        name.strip_prefix(self.quantity) == Some(self.unit.ending)
    }
}
