//! Why a plane contact cannot follow.

use super::ConnectivityError;

/// Why a plane contact cannot follow.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum PlaneError {
    /// The wave is flat.
    #[error(
        "an indentation of {indentation:e} m is beyond full contact at {full:e} m, where it no longer decides the force: expected Press(to: …)"
    )]
    FullContact {
        /// Indentation asked for [m].
        indentation: f64,
        /// Indentation of full contact [m].
        full: f64,
    },
    /// The contact is wider than the datum.
    #[error("the half width {half_width:e} m of the contact reaches the datum: expected a `datum` well above it")]
    Datum {
        /// Half width [m].
        half_width: f64,
    },
    /// A wavy parabola is followed by its force.
    #[error("the depth of a wavy parabola is known from its force only: expected Press(to: …) or HoldForce(…)")]
    ByForce,
    /// The waves cannot be resolved.
    #[error(transparent)]
    Waves(#[from] ConnectivityError),
}
