//! The matrix as text.

use super::{Cell, Verdict, drives};
use crate::check::attempt::Proof;
use rayon::prelude::*;

/// Strengths of proof, from the strongest on.
const STRENGTHS: [Proof; 5] = [Proof::Rounding, Proof::Bound, Proof::Order, Proof::Other, Proof::Own];

/// The matrix as text: a row for each shape, bodies, adhesion and friction, a column for each drive. What is computed has a
/// letter for the solver and one for the strength of the proof, such as `Ar`; a number stands for the reason of a refusal.
/// Rows of the same shape and bodies in which nothing is computed stand in one line, with all their reasons.
#[must_use]
pub fn in_words(cells: &[Cell]) -> String {
    with_errors(cells, &vec![String::new(); cells.len()])
}

/// The same with the decade of the error that the scene of each combination reaches, such as `Ar-15`. Every scene is
/// computed, most of them twice.
#[must_use]
pub fn measured(cells: &[Cell]) -> String {
    with_errors(cells, &cells.par_iter().map(decade).collect::<Vec<String>>())
}

fn with_errors(cells: &[Cell], errors: &[String]) -> String {
    let (mut solvers, mut reasons) = (Vec::new(), Vec::new());
    let told: Vec<(&Cell, &str)> = cells.iter().zip(errors.iter().map(String::as_str)).collect();
    let mut lines = vec![format!("{:<69}{}", "", drives().map(|drive| format!("{drive:<11}")).concat())];
    let rows: Vec<&[(&Cell, &str)]> = told.chunk_by(|(one, _), (next, _)| one.at[..4] == next.at[..4]).collect();
    for alike in rows.chunk_by(|one, next| {
        let together = one[0].0.at[..2] == next[0].0.at[..2];
        together && one.iter().chain(next.iter()).all(|(cell, _)| cell.is_refused())
    }) {
        lines.push(match alike {
            [row] => line(row, &mut solvers, &mut reasons),
            rows => refused(rows, &mut reasons),
        });
    }
    let computed = cells.iter().filter(|cell| !cell.is_refused()).count();
    lines.push(format!("\n{computed} of {} combinations are computed", cells.len()));
    lines.extend(STRENGTHS.iter().map(|proof| format!("{}  {}", initial(*proof), proof.word())));
    lines.extend(solvers.iter().enumerate().map(|(k, solver)| format!("{}  {solver}", letter(k))));
    lines.extend(reasons.iter().enumerate().map(|(k, why)| format!("{}  {why}", k + 1)));
    lines.join("\n")
}

/// What stands for a strength of proof.
fn initial(proof: Proof) -> &'static str {
    match proof {
        Proof::Rounding => "r",
        Proof::Bound => "b",
        Proof::Order => "o",
        Proof::Other => "m",
        Proof::Own => "s",
    }
}

/// The decade of the error that the scene of a combination reaches.
#[expect(clippy::cast_possible_truncation, reason = "the exponents of floats")]
fn decade(cell: &Cell) -> String {
    match cell.reached() {
        None => String::new(),
        Some(Err(_)) => "?".to_owned(),
        Some(Ok(reached)) => format!("{}", reached.error.max(1e-16).log10().floor() as i32),
    }
}

/// A row with a mark for each drive.
fn line(row: &[(&Cell, &str)], solvers: &mut Vec<&'static str>, reasons: &mut Vec<String>) -> String {
    let [shape, bodies, adhesion, friction, _] = row[0].0.names();
    let mut mark = |drive: usize| {
        let found = row.iter().find(|(cell, _)| cell.at[4] == drive);
        found.map_or_else(|| "-".to_owned(), |(cell, error)| cell.mark(error, solvers, reasons))
    };
    let marks: String = (0..drives().len()).map(|drive| format!("{:<11}", mark(drive))).collect();
    format!("{shape:<21}{bodies:<25}{adhesion:<20}{friction:<17}{marks}").trim_end().to_owned()
}

/// Rows in which nothing is computed, from the first to the last, with the numbers of their reasons.
fn refused(rows: &[&[(&Cell, &str)]], reasons: &mut Vec<String>) -> String {
    let [shape, bodies, adhesion, friction, _] = rows[0][0].0.names();
    let [_, _, to_adhesion, to_friction, _] = rows[rows.len() - 1][0].0.names();
    let mut numbers: Vec<usize> = Vec::new();
    for (cell, _) in rows.iter().flat_map(|row| row.iter()) {
        if let Verdict::Refused { why } = &cell.verdict {
            let number = place(reasons, why.clone()) + 1;
            place(&mut numbers, number);
        }
    }
    numbers.sort_unstable();
    let numbers: Vec<String> = numbers.iter().map(usize::to_string).collect();
    let numbers = numbers.join(" ");
    format!("{shape:<21}{bodies:<25}refused from {adhesion}/{friction} to {to_adhesion}/{to_friction}: {numbers}")
}

/// A, B, C, …, a, b, c, …
fn letter(k: usize) -> char {
    let letters = ('A'..='Z').chain('a'..='z');
    letters.into_iter().nth(k).unwrap_or('?')
}

/// The place of an entry in a list, which gets it if it has not.
fn place<T: PartialEq>(list: &mut Vec<T>, entry: T) -> usize {
    list.iter().position(|known| *known == entry).unwrap_or_else(|| {
        list.push(entry);
        list.len() - 1
    })
}

impl Cell {
    fn is_refused(&self) -> bool {
        matches!(self.verdict, Verdict::Refused { .. })
    }

    fn mark(&self, error: &str, solvers: &mut Vec<&'static str>, reasons: &mut Vec<String>) -> String {
        match &self.verdict {
            Verdict::Computed { solver } => {
                format!("{}{}{error}", letter(place(solvers, *solver)), initial(self.proof()))
            }
            Verdict::Refused { why } => (place(reasons, why.clone()) + 1).to_string(),
        }
    }
}
