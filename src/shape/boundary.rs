//! What happens at the edge of a map of heights.

use serde::{Deserialize, Serialize};

/// What happens at the edge of a map of heights that is pressed on a half-space.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
pub enum Boundary {
    /// The half-space goes on, load-free; displacement is zero far away.
    Free,
    /// Everything repeats; the mean displacement is zero, so approach counts from the mean surface.
    Periodic,
}
