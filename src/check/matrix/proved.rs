//! How strong the proof of a combination is, and how far its own scene is off.
//!
//! # Examples
//! ```
//! use springbed::check::case::Proof;
//! use springbed::check::matrix::{Against, cells};
//!
//! // A ball under JKR's adhesion: by a case to rounding, and its own scene beside the closed form.
//! let cells = cells();
//! let cell = cells.iter().find(|cell| cell.names() == ["ball", "elastic", "JKR", "none", "depth"]).unwrap();
//! assert_eq!((cell.proof(), cell.cases()), (Proof::Rounding, vec!["hertz/steel ball", "jkr/radius under load"]));
//! let reached = cell.reached().unwrap()?;
//! assert!(reached.against == Against::ClosedForm && reached.error < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error + Send + Sync>>(())
//! ```

use super::Cell;
use super::choices::{ADHESIONS, BODIES, ByKind, DRIVES, FRICTIONS, SHAPES};
use super::ends::outcome;
use super::known::beside_finer;
use super::part::Proved;
use super::variation::Variation;
use crate::check::attempt::{Attempt, Proof};
use crate::check::cases;
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// What the scene of a combination is held against.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Against {
    /// A closed form.
    ClosedForm,
    /// The same scene with a thousandth of its error.
    Finer,
    /// Nothing but what it says of itself.
    Itself,
}

impl Against {
    /// In words.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::ClosedForm => "closed form",
            Self::Finer => "the scene at 1e-6",
            Self::Itself => "its own estimate",
        }
    }
}

/// How far the scene of a combination is off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reached {
    /// Relative error.
    pub error: f64,
    /// What it is held against.
    pub against: Against,
}

/// Strengths of the cases by their names.
static STRENGTHS: LazyLock<BTreeMap<&'static str, Proof>> =
    LazyLock::new(|| cases::all().iter().map(|case| (case.name, case.proof)).collect());

impl Cell {
    fn proved(&self) -> [Proved; 5] {
        let [shape, bodies, adhesion, friction, drive] = self.at;
        let (shape, bodies) = (&SHAPES[shape], &BODIES[bodies]);
        let of = |parts: &ByKind| parts[shape.kind as usize];
        let adhesion = &ADHESIONS[adhesion];
        let adhesion = if bodies.relaxes { adhesion.relaxing } else { adhesion.elastic };
        [
            shape.proved,
            of(&bodies.proved),
            adhesion.map_or(Proved::Whole, |(_, proved)| of(&proved)),
            of(&FRICTIONS[friction].proved),
            of(&DRIVES[drive].2),
        ]
    }

    /// The cases that prove its parts.
    #[must_use]
    pub fn cases(&self) -> Vec<&'static str> {
        let case = |proved: Proved| if let Proved::Case(name) = proved { Some(name) } else { None };
        self.proved().into_iter().filter_map(case).collect()
    }

    /// Strength of its proof: that of the part which is proved least.
    #[must_use]
    pub fn proof(&self) -> Proof {
        let strength = |proved: Proved| match proved {
            Proved::Whole => Proof::Rounding,
            Proved::Case(name) => STRENGTHS.get(name).copied().unwrap_or(Proof::Own),
            Proved::Laws(proof) => proof,
        };
        self.proved().into_iter().map(strength).max().unwrap_or(Proof::Own)
    }

    /// How far its own scene is off; `None` where it is refused.
    ///
    /// On pixels a finer grid costs too much, and the estimate stands for it. Where the closed form, or the finer scene,
    /// differs by less than the rounding that the scene states, that is what is reached.
    ///
    /// # Errors
    /// It cannot be computed after all.
    pub fn reached(&self) -> Option<Attempt<Reached>> {
        let variation = Variation::default();
        let written = self.written(&variation)?;
        written.plan().ok()?;
        let whole = match outcome(&written) {
            Ok(whole) => whole,
            Err(why) => return Some(Err(why.into())),
        };
        if let Some(ball) = self.ball(&variation) {
            return Some(Ok(Reached { error: ball.off(&whole), against: Against::ClosedForm }));
        }
        let own = Reached { error: whole.error_estimate.relative, against: Against::Itself };
        if written.is_on_pixels() {
            return Some(Ok(own));
        }
        Some(beside_finer(&written, &whole).map_err(Into::into).map(|off| match off {
            Some(error) if error > 0.0 => Reached { error, against: Against::Finer },
            _ => own,
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::matrix::{Verdict, cells};

    #[test]
    fn what_proves_a_part_is_a_case() {
        for cell in cells().iter().filter(|cell| matches!(cell.verdict, Verdict::Computed { .. })) {
            for case in cell.cases() {
                assert!(STRENGTHS.contains_key(case), "{case} of {:?}", cell.names());
            }
            assert!(cell.proof() < Proof::Own, "{:?}", cell.names());
        }
    }
}
