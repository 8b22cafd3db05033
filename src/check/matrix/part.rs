//! What proves a part of a combination.

use crate::check::attempt::Proof;

/// What proves a part of a combination.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Proved {
    /// It is nothing beside what it goes with.
    Whole,
    /// A case with its name.
    Case(&'static str),
    /// The laws over the matrix, limits and twins among them, with the strength they have.
    Laws(Proof),
}
