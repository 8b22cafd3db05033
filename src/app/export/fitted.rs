//! A curve with its fit, and the models that were tried on it.

use crate::fit::{Curve, Fit, Standing};
use crate::scene::Scene;

/// A curve with its fit.
#[derive(Debug, Clone)]
pub struct Fitted {
    /// The data file.
    pub file: String,
    /// The scene at the values found.
    pub scene: Scene,
    /// The data.
    pub curve: Curve,
    /// The fit.
    pub fit: Fit,
    /// What was taken for granted of the data.
    pub data_notes: Vec<String>,
    /// All models that were tried, where there were several.
    pub models: Vec<Tried>,
}

/// A model that was tried on a curve.
#[derive(Debug, Clone)]
pub struct Tried {
    /// Its name.
    pub name: String,
    /// Where it stands among the others; `None` where it has no answer.
    pub standing: Option<Standing>,
    /// Its answer, or why it has none.
    pub answer: Result<Answered, String>,
}

/// The answer of a model.
#[derive(Debug, Clone)]
pub struct Answered {
    /// The fit.
    pub fit: Fit,
    /// The scene at the values found.
    pub scene: Scene,
    /// Tabor's parameter, under an attraction of vanishing range.
    pub tabor: Option<f64>,
}

impl Tried {
    /// Why there is no answer, if there is none.
    #[must_use]
    pub fn why_not(self) -> Option<String> {
        let error = self.answer.err()?;
        Some(if self.name.is_empty() { error } else { format!("{}: {error}", self.name) })
    }
}
