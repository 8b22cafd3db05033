//! What is wrong with a file, shown as `file:line:column: message` with the line itself below.
//!
//! # Examples
//! ```
//! use springbed::app::fault::Fault;
//!
//! let fault = Fault::whole("tip.csv".as_ref(), "has no rows");
//! assert!(fault.position.is_none() && fault.message == "has no rows");
//! ```

use crate::text::{Position, TextError};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// Longest piece of a line that is shown.
const WIDTH: usize = 100;

/// One thing that is wrong with a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// The file.
    pub file: PathBuf,
    /// Where in it; `None` if the file as a whole is meant.
    pub position: Option<Position>,
    /// What it was, and what would be right.
    pub message: String,
    /// The line of the file at which the position points.
    pub line: Option<String>,
}

impl Fault {
    /// A fault of the file as a whole.
    pub fn whole(file: &Path, message: impl Into<String>) -> Self {
        Self { file: file.to_owned(), position: None, message: message.into(), line: None }
    }

    /// A fault of the text of the file.
    #[must_use]
    pub fn at(file: &Path, error: TextError) -> Self {
        let TextError { position, message, line } = error;
        Self { file: file.to_owned(), position: Some(position), message, line: Some(line) }
    }

    /// `file:line:column: message`, then the line and a caret under the column.
    #[must_use]
    pub fn rendered(&self, paint: Paint) -> String {
        let mut out = String::new();
        let mut place = self.file.display().to_string();
        if let Some(Position { line, column }) = self.position {
            let _ = write!(place, ":{line}:{column}");
        }
        let _ = write!(out, "{}: {}", paint.bold(&place), self.message);
        if let (Some(position), Some(line)) = (self.position, &self.line) {
            let number = position.line.to_string();
            let (piece, before) = window(line, position.column);
            let _ = write!(out, "\n {number} | {piece}");
            let _ = write!(out, "\n {:1$} | {2:3$}{4}", "", number.len(), "", before, paint.red("^"));
        }
        out
    }
}

/// The piece of a long line around a column, tabs as blanks, dots where it was cut, and the characters before the column.
fn window(line: &str, column: usize) -> (String, usize) {
    let count = line.chars().count();
    let first = column.saturating_sub(WIDTH / 2).min(count.saturating_sub(WIDTH));
    let shown = |(k, c): (usize, char)| match c {
        _ if k == 0 && first > 0 || k + 1 == WIDTH && first + WIDTH < count => '…',
        c if c.is_control() => ' ',
        c => c,
    };
    (line.chars().skip(first).take(WIDTH).enumerate().map(shown).collect(), column - 1 - first)
}

/// Whether messages are coloured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Paint {
    /// With escape sequences of a terminal.
    Coloured,
    /// Plain text.
    Plain,
}

impl Paint {
    fn wrapped(self, code: &str, text: &str) -> String {
        match self {
            Self::Coloured => format!("\x1b[{code}m{text}\x1b[0m"),
            Self::Plain => text.to_owned(),
        }
    }

    /// Bold text.
    #[must_use]
    pub fn bold(self, text: &str) -> String {
        self.wrapped("1", text)
    }

    /// Bold red text.
    #[must_use]
    pub fn red(self, text: &str) -> String {
        self.wrapped("1;31", text)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_caret_stands_under_the_column() {
        let text = "(\n  µ: 10 mm,\n)";
        let fault = Fault::at(Path::new("a.ron"), TextError::at(text, text.find("mm").unwrap(), "wrong"));
        assert_eq!(fault.rendered(Paint::Plain), "a.ron:2:9: wrong\n 2 |   µ: 10 mm,\n   |         ^");
        assert!(fault.rendered(Paint::Coloured).starts_with("\x1b[1ma.ron:2:9\x1b[0m: wrong"));
    }

    #[test]
    fn a_long_line_is_cut_around_the_column() {
        for at in [0, 60, 99, 5000, 9900, 10_000] {
            let text = format!("{}x{}", "-".repeat(at), "y".repeat(10_000 - at));
            let shown = Fault::at(Path::new("a.ron"), TextError::at(&text, at, "wrong")).rendered(Paint::Plain);
            let lines: Vec<&str> = shown.lines().collect();
            let place = |line: &str, sign| line.chars().position(|c| c == sign);
            assert_eq!(place(lines[1], 'x'), place(lines[2], '^'));
            assert!(lines[1].chars().count() < 120);
            // What stands beside the fault is seen, on both of its sides.
            assert!(at > 9950 || lines[2].chars().count() + 40 < lines[1].chars().count(), "{at}");
        }
    }

    #[test]
    fn a_fault_of_the_whole_file_has_no_line() {
        assert_eq!(Fault::whole(Path::new("a.ron"), "is a directory").rendered(Paint::Plain), "a.ron: is a directory");
    }
}
