//! What is wrong with a scene, and where in it.
//!
//! # Examples
//! ```
//! use springbed::input::problem::Problem;
//!
//! let problem = Problem::new("history[1].to", "expected a depth above zero");
//! assert_eq!(problem.to_string(), "history[1].to: expected a depth above zero");
//! ```

use std::fmt;

/// A part of a scene that cannot be computed, found after every single value was read and checked.
///
/// All problems of a scene are collected, so that a person mends them in one go.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Problem {
    /// Place in the scene: names of fields and numbers of list entries, such as `history[3].to` or
    /// `bodies.0.young`; `history[0]` is the first entry.
    pub path: String,
    /// What it is and what would be right.
    pub message: String,
}

impl Problem {
    /// A problem at a place in the scene.
    pub fn new(path: impl Into<String>, message: impl Into<String>) -> Self {
        Self { path: path.into(), message: message.into() }
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.path, self.message)
    }
}

impl std::error::Error for Problem {}
