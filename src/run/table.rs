//! Columns, and tables filled with them.
//!
//! ```
//! use springbed::run::table::{Column, Table};
//! use springbed::run::unit::Unit;
//!
//! struct Ball {
//!     radius: f64,
//!     load: Option<f64>,
//! }
//!
//! let columns = [
//!     Column::new("radius", Unit::METRE, "radius R", |ball: &Ball| Some(ball.radius)),
//!     Column::new("force", Unit::NEWTON, "force F", |ball: &Ball| ball.load),
//! ];
//! let balls = [Ball { radius: 0.01, load: Some(2.0) }, Ball { radius: 0.02, load: None }];
//! let table = Table::new("balls").with(&columns, balls.iter());
//! let force = table.column("force").unwrap();
//! assert_eq!((force.name().as_str(), force.numbers()), ("force_n", &[Some(2.0), None][..]));
//! ```

use super::named::Named;
use super::unit::Unit;

/// A column of numbers: what it is called, its unit, and where in a row of type `R` it comes from.
#[derive(Debug, Clone, Copy)]
pub struct Column<R> {
    /// What it holds; in a file its name is this and the ending of the unit, such as `force_n`.
    pub quantity: &'static str,
    /// SI unit.
    pub unit: Unit,
    /// Words and symbol on the axis of a figure, such as `force F`.
    pub label: &'static str,
    /// The number of a row, if the row has it.
    pub of: fn(&R) -> Option<f64>,
}

impl<R> Column<R> {
    /// A column of the quantity `quantity`, with the words `label` on an axis.
    pub const fn new(quantity: &'static str, unit: Unit, label: &'static str, of: fn(&R) -> Option<f64>) -> Self {
        Self { quantity, unit, label, of }
    }

    /// The number of one row as a named result, if the row has it.
    pub fn named(&self, row: &R) -> Option<Named> {
        (self.of)(row).filter(|number| number.is_finite()).map(|number| Named::number(self.quantity, self.unit, number))
    }
}

/// Rows under named columns.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// What it is about, in one word, such as `pressure`; its file is named after it.
    pub name: &'static str,
    /// All of the same length.
    pub columns: Vec<Filled>,
}

/// A column with its cells.
#[derive(Debug, Clone, PartialEq)]
pub struct Filled {
    /// What it holds.
    pub quantity: String,
    /// SI unit.
    pub unit: Unit,
    /// Words and symbol on the axis of a figure.
    pub label: &'static str,
    /// One per row.
    pub cells: Content,
}

/// The cells of a column.
#[derive(Debug, Clone, PartialEq)]
pub enum Content {
    /// Finite numbers; `None` where there is none.
    Numbers(Vec<Option<f64>>),
    /// Words.
    Words(Vec<String>),
}

impl Table {
    /// A table without columns.
    #[must_use]
    pub const fn new(name: &'static str) -> Self {
        Self { name, columns: Vec::new() }
    }

    /// The table with columns filled from rows.
    #[must_use]
    pub fn with<'r, R: 'r>(self, columns: &[Column<R>], rows: impl Iterator<Item = &'r R> + Clone) -> Self {
        self.with_each("", columns, rows)
    }

    /// The same with `before` in front of the names of the columns.
    #[must_use]
    pub fn with_each<'r, R: 'r>(
        mut self,
        before: &str,
        columns: &[Column<R>],
        rows: impl Iterator<Item = &'r R> + Clone,
    ) -> Self {
        let filled = |column: &Column<R>| Filled {
            quantity: format!("{before}{}", column.quantity),
            unit: column.unit,
            label: column.label,
            cells: Content::Numbers(
                rows.clone().map(|row| (column.of)(row).filter(|number| number.is_finite())).collect(),
            ),
        };
        self.columns.extend(columns.iter().map(filled));
        self
    }

    /// The table with a column of words.
    #[must_use]
    pub fn with_words(mut self, quantity: &str, words: Vec<String>) -> Self {
        let (quantity, unit, label) = (quantity.to_owned(), Unit::ONE, "");
        self.columns.push(Filled { quantity, unit, label, cells: Content::Words(words) });
        self
    }

    /// Number of rows.
    #[must_use]
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |column| match &column.cells {
            Content::Numbers(numbers) => numbers.len(),
            Content::Words(words) => words.len(),
        })
    }

    /// The column of a quantity.
    #[must_use]
    pub fn column(&self, quantity: &str) -> Option<&Filled> {
        self.columns.iter().find(|column| column.quantity == quantity)
    }
}

impl Filled {
    /// Name in files, such as `force_n`.
    #[must_use]
    pub fn name(&self) -> String {
        format!("{}{}", self.quantity, self.unit.ending)
    }

    /// The numbers, row by row; none of a column of words.
    #[must_use]
    pub fn numbers(&self) -> &[Option<f64>] {
        match &self.cells {
            Content::Numbers(numbers) => numbers,
            Content::Words(_) => &[],
        }
    }
}
