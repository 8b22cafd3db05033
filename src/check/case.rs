//! A case: what is computed, what is right, how far apart they may be and why.
//!
//! # Examples
//! ```
//! use springbed::check::case::{Proof, worst};
//!
//! // The largest relative difference of pairs (computed, right).
//! assert!((worst(&[(1.0, 1.0), (2.2, 2.0)]) - 0.1).abs() < 1e-15);
//! assert_eq!(Proof::Rounding.word(), "rounding");
//! ```

pub use super::attempt::{Attempt, Pairs, Proof, worst};
use super::extreme::Extreme;
use super::row::Row;
use super::stated::Stated;
use super::study::{Study, Thoroughness};

/// What a case asks.
#[derive(Debug, Clone, Copy)]
pub enum Question {
    /// Numbers of one computation beside the right ones.
    Numbers(fn() -> Attempt<Pairs>),
    /// Whether the error a scene states bounds its true one, at several accuracies.
    Stated(Stated),
    /// The largest error over a range of values.
    Over(Extreme),
}

/// A case with its exact answer.
#[derive(Debug, Clone, Copy)]
pub struct Case {
    /// Name: part of physics, then what is compared, such as `hertz/steel ball`.
    pub name: &'static str,
    /// Strength of the proof.
    pub proof: Proof,
    /// Largest relative error allowed.
    pub bound: f64,
    /// Why this bound.
    pub because: &'static str,
    /// Where the case is weak, in one line.
    pub weak: &'static str,
    /// What is computed.
    pub question: Question,
    /// The ways to compute it that are measured against each other, if any.
    pub ways: Option<fn(Thoroughness) -> Attempt<Study>>,
}

impl Case {
    /// A case still without its question.
    pub(super) const fn new(name: &'static str, proof: Proof, bound: f64, because: &'static str) -> Self {
        let question = Question::Numbers(|| Err("the case asks nothing".into()));
        Self { name, proof, bound, because, weak: "", question, ways: None }
    }

    pub(super) const fn weak(self, weak: &'static str) -> Self {
        Self { weak, ..self }
    }

    pub(super) const fn by(self, numbers: fn() -> Attempt<Pairs>) -> Self {
        Self { question: Question::Numbers(numbers), ..self }
    }

    pub(super) const fn asks(self, question: Question) -> Self {
        Self { question, ..self }
    }

    pub(super) const fn ways(self, ways: fn(Thoroughness) -> Attempt<Study>) -> Self {
        Self { ways: Some(ways), ..self }
    }

    /// Runs the case; what cannot be computed says why.
    #[must_use]
    pub fn verdict(&self) -> Row {
        let row = match &self.question {
            Question::Numbers(numbers) => Row::of(numbers().map(|pairs| worst(&pairs))),
            Question::Stated(stated) => stated.verdict(),
            Question::Over(extreme) => Row::over(*extreme),
        };
        Row { case: self.name, proof: Some(self.proof), bound: Some(self.bound), ..row }
    }
}
