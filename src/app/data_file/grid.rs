//! The table of numbers in a text, wherever it stands.

use csv::ReaderBuilder;

/// A table of numbers with the lines above it.
#[derive(Debug, Clone)]
pub struct Grid {
    /// Cells of the lines above the table that have as many of them, the nearest last.
    pub heads: Vec<Vec<String>>,
    /// Number of columns.
    pub width: usize,
    lines: Vec<(usize, Vec<String>)>,
    decimal: char,
}

/// Numbers in a row from which on a line belongs to the table.
const NARROWEST: usize = 2;
/// Lines looked at to find out what separates columns.
const LOOKED_AT: usize = 400;

/// What separates columns, and the sign of decimals.
#[derive(Debug, Clone, Copy)]
struct Style {
    separator: Separator,
    decimal: char,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Separator {
    Byte(u8),
    Blanks,
}

/// Tabs and semicolons first: commas and blanks are also found inside cells.
const STYLES: [Style; 7] = [
    Style { separator: Separator::Byte(b'\t'), decimal: '.' },
    Style { separator: Separator::Byte(b'\t'), decimal: ',' },
    Style { separator: Separator::Byte(b';'), decimal: '.' },
    Style { separator: Separator::Byte(b';'), decimal: ',' },
    Style { separator: Separator::Byte(b','), decimal: '.' },
    Style { separator: Separator::Blanks, decimal: '.' },
    Style { separator: Separator::Blanks, decimal: ',' },
];

impl Grid {
    /// The table in `text`.
    ///
    /// # Errors
    /// There is none, or a line in it has too few or too many cells.
    pub fn of(text: &str) -> Result<Self, String> {
        let lines: Vec<(usize, &str)> = text
            .lines()
            .enumerate()
            .filter(|(_, line)| !line.trim().is_empty())
            .map(|(at, line)| (at + 1, line))
            .collect();
        let end = lines.len();
        let tail = &lines[end.saturating_sub(LOOKED_AT)..];
        let fits = |style: &Style| tail.iter().filter(|(_, line)| is_row(&style.cells(line), style.decimal)).count();
        // Of equal ones the first.
        let style = STYLES.iter().rev().max_by_key(|style| fits(style)).filter(|style| fits(style) > 0);
        let style = style.ok_or("there is no table of numbers in it: expected rows of at least two numbers")?;
        let first = lines.iter().position(|(_, line)| is_row(&style.cells(line), style.decimal)).unwrap_or(end);
        let width = style.cells(lines[first].1).len();
        let cells = |line: &&(usize, &str)| style.cells(line.1);
        let heads = lines[..first].iter().rev().map(|line| cells(&line)).take_while(|cells| cells.len() == width);
        let mut heads: Vec<Vec<String>> = heads.collect();
        heads.reverse();
        let commented = |line: &&(usize, &str)| !line.1.trim_start().starts_with('#');
        let rows = lines[first..].iter().filter(commented);
        Ok(Self { heads, width, lines: rows.map(|line| (line.0, cells(&line))).collect(), decimal: style.decimal })
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.lines.len()
    }

    /// Row of the file in which a line stands.
    pub fn row(&self, line: usize) -> usize {
        self.lines[line].0
    }

    /// The finite number in a cell.
    ///
    /// # Errors
    /// There is none; what is there, and what would be right.
    pub fn number(&self, line: usize, column: usize) -> Result<f64, String> {
        let Some(cell) = self.lines[line].1.get(column) else {
            let count = self.lines[line].1.len();
            return Err(format!("the row has {count} cells: expected {}", self.width));
        };
        match number(cell, self.decimal) {
            Some(value) if value.is_finite() => Ok(value),
            Some(_) => Err(format!("\"{cell}\" is not finite: expected a number")),
            None if cell.is_empty() => Err("the cell is empty: expected a number".to_owned()),
            None => {
                let cell: String = cell.chars().take(40).collect();
                Err(format!("\"{cell}\" is not a number: expected one such as 1{}5e-6", self.decimal))
            }
        }
    }
}

impl Style {
    fn cells(self, line: &str) -> Vec<String> {
        match self.separator {
            Separator::Blanks => line.split_whitespace().map(str::to_owned).collect(),
            // To build a reader costs fifty times what a line without quotes does.
            Separator::Byte(separator) if !line.contains('"') => {
                line.split(char::from(separator)).map(|cell| cell.trim().to_owned()).collect()
            }
            Separator::Byte(separator) => {
                let mut reader =
                    ReaderBuilder::new().delimiter(separator).has_headers(false).from_reader(line.as_bytes());
                let record = reader.records().next().and_then(Result::ok);
                record.map_or_else(Vec::new, |record| record.iter().map(|cell| cell.trim().to_owned()).collect())
            }
        }
    }
}

/// Whether a line belongs to the table: numbers, and cells without one between them.
fn is_row(cells: &[String], decimal: char) -> bool {
    let numbers = cells.iter().filter(|cell| number(cell, decimal).is_some_and(f64::is_finite)).count();
    numbers >= NARROWEST && cells.iter().all(|cell| cell.is_empty() || number(cell, decimal).is_some())
}

/// The number in a cell, NaN and infinity among them.
fn number(cell: &str, decimal: char) -> Option<f64> {
    if decimal == '.' {
        return cell.parse().ok();
    }
    if cell.contains('.') { None } else { cell.replace(decimal, ".").parse().ok() }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A cell in quotes is the same cell, and may hold what separates others.
    #[test]
    fn quotes_change_no_cell() {
        for style in STYLES.iter().filter(|style| style.separator != Separator::Blanks) {
            let Separator::Byte(separator) = style.separator else { continue };
            let joined = |cells: &[&str]| cells.join(&char::from(separator).to_string());
            let plain = style.cells(&joined(&["1", " 2e-3 ", "", "z [nm]"]));
            assert_eq!(plain, style.cells(&joined(&["\"1\"", " 2e-3 ", "", "\"z [nm]\""])));
            assert_eq!(plain, ["1", "2e-3", "", "z [nm]"]);
            let one = format!("\"a{}b\"", char::from(separator));
            assert_eq!(style.cells(&one).len(), 1);
        }
    }
}
