//! The matrix of all combinations: which shape, bodies, adhesion, friction and drive are computed together, by whom,
//! and why the others are not.
//!
//! # Examples
//! ```
//! use springbed::check::matrix::{Verdict, cells};
//!
//! // A rough line on rubber is computed at a prescribed depth.
//! let rough = cells().into_iter().find(|cell| cell.names() == ["rough line", "viscoelastic", "none", "none", "depth"]);
//! assert!(matches!(rough.unwrap().verdict, Verdict::Computed { solver: "rough viscoelastic bed" }));
//! ```

mod choices;
mod laws;
mod written;

pub use laws::{Kept, Law};
pub use written::Variation;

use crate::run::record::Outcome;
use crate::run::{self, SimulationError, Wanted};
use choices::{ADHESIONS, BODIES, DRIVES, FRICTIONS, SHAPES};
use rayon::prelude::*;
use written::{Written, written};

/// Names of the drives, the columns of the matrix.
#[must_use]
pub fn drives() -> [&'static str; 8] {
    DRIVES.map(|(name, _)| name)
}

/// A combination: the number of its shape, bodies, adhesion, friction and drive.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Cell {
    at: [usize; 5],
    /// What becomes of it.
    pub verdict: Verdict,
}

/// What becomes of a combination.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Verdict {
    /// It is computed.
    Computed {
        /// By whom.
        solver: &'static str,
    },
    /// It is refused.
    Refused {
        /// Why.
        why: String,
    },
}

/// Every combination that can be written, in the order of its parts.
#[must_use]
pub fn cells() -> Vec<Cell> {
    let all: Vec<[usize; 5]> = (0..SHAPES.len())
        .flat_map(|shape| (0..BODIES.len()).map(move |bodies| [shape, bodies]))
        .flat_map(|[shape, bodies]| (0..ADHESIONS.len()).map(move |adhesion| [shape, bodies, adhesion]))
        .flat_map(|[s, b, a]| (0..FRICTIONS.len()).map(move |friction| [s, b, a, friction]))
        .flat_map(|[s, b, a, f]| (0..DRIVES.len()).map(move |drive| [s, b, a, f, drive]))
        .collect();
    all.into_par_iter().filter_map(cell).collect()
}

fn cell(at: [usize; 5]) -> Option<Cell> {
    let verdict = match written(at, &Variation::default())?.plan() {
        Ok(plan) => Verdict::Computed { solver: plan.parts().solver },
        Err(errors) => {
            let why = errors.first().map(|error| reason(&error.message)).unwrap_or_default();
            Verdict::Refused { why }
        }
    };
    Some(Cell { at, verdict })
}

/// A message without its place and its advice.
fn reason(message: &str) -> String {
    let place = message.split_once(": ").filter(|(place, _)| !place.contains(' '));
    let words = place.map_or(message, |(_, words)| words);
    let words = words.split(": expected ").next().unwrap_or(words);
    let words = words.split("; expected ").next().unwrap_or(words);
    // What is said of the place itself needs its name: the friction, an entry of the history.
    let part = place.map_or("", |(place, _)| place.split('[').next().unwrap_or(place));
    if words.starts_with("with ") || words.starts_with("cannot ") {
        format!("{part} {words}")
    } else {
        words.to_owned()
    }
}

impl Cell {
    /// Shape, bodies, adhesion, friction and drive.
    #[must_use]
    pub fn names(&self) -> [&'static str; 5] {
        let [shape, bodies, adhesion, friction, drive] = self.at;
        [
            SHAPES[shape].shape.name,
            BODIES[bodies].name,
            ADHESIONS[adhesion].name,
            FRICTIONS[friction].name,
            DRIVES[drive].0,
        ]
    }

    /// Its scene with other numbers.
    fn written(&self, variation: &Variation) -> Option<Written> {
        written(self.at, variation)
    }

    /// Computes its scene; `None` where it is refused.
    ///
    /// # Errors
    /// It cannot be computed after all.
    pub fn outcome(&self) -> Option<Result<Outcome, SimulationError>> {
        let Ok(plan) = self.written(&Variation::default())?.plan() else { return None };
        Some(run::run(&plan, Wanted::NOTHING))
    }
}

/// The matrix as text: a row for each shape, bodies, adhesion and friction, a column for each drive; a letter stands for
/// the solver, a number for the reason of a refusal.
#[must_use]
pub fn in_words(cells: &[Cell]) -> String {
    let (mut solvers, mut reasons) = (Vec::new(), Vec::new());
    let mut lines = vec![format!("{:<66}{}", "", drives().map(|drive| format!("{drive:<11}")).concat())];
    for row in cells.chunk_by(|one, next| one.at[..4] == next.at[..4]) {
        let of = |drive: usize| row.iter().find(|cell| cell.at[4] == drive);
        let marks = std::array::from_fn::<_, 8, _>(|drive| of(drive).map(|cell| cell.mark(&mut solvers, &mut reasons)));
        let [shape, bodies, adhesion, friction, _] = row[0].names();
        let marks = marks.map(|mark| format!("{:<11}", mark.unwrap_or_else(|| "-".to_owned()))).concat();
        lines.push(format!("{shape:<15}{bodies:<25}{adhesion:<20}{friction:<14}{marks}").trim_end().to_owned());
    }
    let computed = cells.iter().filter(|cell| matches!(cell.verdict, Verdict::Computed { .. })).count();
    lines.push(format!("\n{computed} of {} combinations are computed", cells.len()));
    lines.extend(solvers.iter().enumerate().map(|(k, solver)| format!("{}  {solver}", letter(k))));
    lines.extend(reasons.iter().enumerate().map(|(k, why)| format!("{}  {why}", k + 1)));
    lines.join("\n")
}

/// A, B, C, …
fn letter(k: usize) -> char {
    u8::try_from(k).map_or('?', |k| char::from(b'A'.saturating_add(k)))
}

/// The place of an entry in a list, which gets it if it has not.
fn place<T: PartialEq>(list: &mut Vec<T>, entry: T) -> usize {
    list.iter().position(|known| *known == entry).unwrap_or_else(|| {
        list.push(entry);
        list.len() - 1
    })
}

impl Cell {
    fn mark(&self, solvers: &mut Vec<&'static str>, reasons: &mut Vec<String>) -> String {
        match &self.verdict {
            Verdict::Computed { solver } => letter(place(solvers, *solver)).to_string(),
            Verdict::Refused { why } => (place(reasons, why.clone()) + 1).to_string(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One scene per cell: what the matrix promises runs, its numbers are numbers, and it states an error.
    #[test]
    fn every_cell_that_is_promised_runs() {
        let wrong = |cell: &Cell| {
            let why = match cell.outcome()? {
                Err(error) => error.to_string(),
                Ok(outcome) => {
                    let finite = outcome.records.iter().all(|record| {
                        let normal = &record.normal;
                        let tangential = record.tangential.map_or(0.0, |state| state.force);
                        [normal.force, normal.stored.stored(), normal.dissipated, tangential]
                            .iter()
                            .all(|x| x.is_finite())
                    });
                    if finite && outcome.error_estimate.relative > 0.0 {
                        return None;
                    }
                    format!("{:?}", outcome.error_estimate)
                }
            };
            Some(format!("{:?}: {why}", cell.names()))
        };
        let failed: Vec<String> = cells().par_iter().filter_map(wrong).collect();
        assert!(failed.is_empty(), "{failed:#?}");
    }
}
