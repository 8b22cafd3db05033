//! A case: what is computed, what is right, how far apart they may be and why.

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
    pub reason: &'static str,
    /// Where the case is weak, in one line.
    pub weak: &'static str,
    /// Computes the largest relative error; NaN if the computation fails.
    pub error: fn() -> f64,
}

/// What a case gave.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Verdict {
    /// Name of the case.
    pub name: &'static str,
    /// Strength of the proof.
    pub proof: Proof,
    /// Largest relative error found.
    pub error: f64,
    /// Largest relative error allowed.
    pub bound: f64,
    /// Whether the error is within the bound.
    pub passed: bool,
}

impl Case {
    /// Runs the case.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        let error = (self.error)();
        // Written so that a NaN fails.
        let passed = error <= self.bound;
        Verdict { name: self.name, proof: self.proof, error, bound: self.bound, passed }
    }
}

/// Largest relative difference of pairs (computed, right); absolute where the right value is zero.
#[must_use]
pub fn worst(pairs: &[(f64, f64)]) -> f64 {
    let difference = |&(value, right): &(f64, f64)| {
        let scale = if right.abs() > 0.0 { right.abs() } else { 1.0 };
        (value - right).abs() / scale
    };
    pairs.iter().map(difference).fold(0.0, |most, next| if next > most || next.is_nan() { next } else { most })
}
