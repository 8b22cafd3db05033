//! What an attempt gives, how far it is off, and how strong the proof is.

/// What an attempt gives, or why it gives nothing.
pub type Attempt<T> = Result<T, Box<dyn std::error::Error + Send + Sync>>;

/// Pairs (computed, right).
pub type Pairs = Vec<(f64, f64)>;

/// Strength of a proof, the strongest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, serde::Serialize)]
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

/// Largest relative difference of pairs (computed, right); absolute where the right value is zero. NaN if one is.
#[must_use]
pub fn worst(pairs: &[(f64, f64)]) -> f64 {
    let difference = |&(value, right): &(f64, f64)| {
        let scale = if right.abs() > 0.0 { right.abs() } else { 1.0 };
        (value - right).abs() / scale
    };
    pairs.iter().map(difference).fold(0.0, |most, next| if next > most || next.is_nan() { next } else { most })
}
