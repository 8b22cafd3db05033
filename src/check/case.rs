//! A case: what is computed, what is right, how far apart they may be and why.

use super::extreme::Extreme;

use super::row::Row;
use super::stated::Stated;
use super::study::{Effort, Study};

/// What an attempt gives, or why it gives nothing.
pub type Attempt<T> = Result<T, Box<dyn std::error::Error + Send + Sync>>;

/// Pairs (computed, right).
pub type Pairs = Vec<(f64, f64)>;

/// Strength of a proof.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Proof {
    /// An identity or a limit, true to rounding.
    Rounding,
    /// A proved constant.
    Bound,
    /// A rate of convergence.
    Order,
    /// Another code, another method or a finer grid.
    Other,
    /// A number of this program from before: detects change only.
    Own,
}

impl Proof {
    /// The word printed in tables.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Rounding => "rounding",
            Self::Bound => "bound",
            Self::Order => "order",
            Self::Other => "other method",
            Self::Own => "self",
        }
    }
}

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
    pub ways: Option<fn(Effort) -> Attempt<Study>>,
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

    pub(super) const fn ways(self, ways: fn(Effort) -> Attempt<Study>) -> Self {
        Self { ways: Some(ways), ..self }
    }

    /// Runs the case; what cannot be computed says why.
    #[must_use]
    pub fn verdict(&self) -> Row {
        let row = match &self.question {
            Question::Numbers(numbers) => Row::of(numbers().map(|pairs| worst(&pairs))),
            Question::Stated(stated) => stated.verdict(),
            Question::Over(extreme) => extreme.verdict(),
        };
        Row { case: self.name, proof: Some(self.proof), bound: Some(self.bound), ..row }
    }
}

/// Largest relative difference of pairs (computed, right); absolute where the right value is zero. NaN if one is.
#[must_use]
pub fn worst(pairs: &[(f64, f64)]) -> f64 {
    let difference = |&(value, right): &(f64, f64)| {
        let scale = if right.abs() > 0.0 { right.abs() } else { 1.0 };
        (value - right).abs() / scale
    };
    pairs.iter().map(difference).fold(0.0, |most, next| if next > most || next.is_nan() { next } else { most })
}
