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

mod balance;
mod choices;
mod ends;
mod known;
mod laws;
mod led;
mod part;
mod proved;
mod table;
mod variation;
mod written;

pub use laws::{Kept, Law};
pub use proved::{Against, Reached};
pub use table::{in_words, measured};
pub use variation::{Turn, Units, Variation};

use crate::run::record::Outcome;
use crate::run::{self, SimulationError, Wanted};
use choices::{ADHESIONS, BODIES, DRIVES, FRICTIONS, SHAPES};
use rayon::prelude::*;
use written::{Written, written};

/// Names of the drives, the columns of the matrix.
#[must_use]
pub fn drives() -> [&'static str; DRIVES.len()] {
    DRIVES.map(|(name, ..)| name)
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
    // What is said of the place itself needs its name: the friction, a machine, an entry of the history.
    let part = place.map_or("", |(place, _)| place.split('[').next().unwrap_or(place));
    if ["with ", "cannot ", "on "].iter().any(|start| words.starts_with(start)) {
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
        [SHAPES[shape].name, BODIES[bodies].name, ADHESIONS[adhesion].name, FRICTIONS[friction].name, DRIVES[drive].0]
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

#[cfg(test)]
mod tests;
