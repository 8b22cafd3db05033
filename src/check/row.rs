//! One row of any report: a case by one method at one fineness.
//!
//! # Examples
//! ```
//! use springbed::check::row::{Row, Setting};
//!
//! // An error within its bound, and one that is not there.
//! let row = Row { setting: Setting::springs(100), bound: Some(1e-3), ..Row::of(Ok(1e-4)) };
//! assert!(row.passed());
//! assert!(!Row { bound: Some(1e-3), ..Row::of(Err("no contact".into())) }.passed());
//! ```

use super::attempt::{Attempt, Proof};
use super::clock::Times;
use super::extreme::{Extreme, Tally};
use serde::Serialize;

/// How fine a method works.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Setting {
    /// Number of springs of half the bed.
    pub springs: Option<usize>,
    /// Pixels along the side of the grid, or strips of a half-plane.
    pub grid: Option<usize>,
    /// Steps in time.
    pub steps: Option<usize>,
    /// Relative error asked for.
    pub accuracy: Option<f64>,
    /// What is counted in a run, such as `records`, and how many of them.
    pub counted: Option<(&'static str, usize)>,
}

impl Setting {
    /// Nothing to choose.
    pub const FREE: Self = Self { springs: None, grid: None, steps: None, accuracy: None, counted: None };

    /// A number of springs.
    #[must_use]
    pub const fn springs(count: usize) -> Self {
        Self { springs: Some(count), ..Self::FREE }
    }

    /// Pixels along a side.
    #[must_use]
    pub const fn grid(side: usize) -> Self {
        Self { grid: Some(side), ..Self::FREE }
    }

    /// A number of steps.
    #[must_use]
    pub const fn steps(count: usize) -> Self {
        Self { steps: Some(count), ..Self::FREE }
    }
}

/// The state a method has found. A value that does not exist is `None`.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Found {
    /// Indentation [m].
    pub indentation_m: Option<f64>,
    /// Normal force [N].
    pub force_n: Option<f64>,
    /// Contact radius [m]; of a contact that is not a circle, of the circle of the same area; not of rough shapes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub contact_radius_m: Option<f64>,
    /// Largest pressure [Pa]; not where it is singular.
    pub peak_pressure_pa: Option<f64>,
    /// Stiffness [N/m], of rough shapes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stiffness_n_per_m: Option<f64>,
    /// Real over nominal contact area, of the half-space under rough shapes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub area_fraction: Option<f64>,
}

/// What a method gives.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Computed {
    /// The numbers compared, such as the forces of a loop.
    pub values: Vec<f64>,
    /// The state, where there is one.
    pub found: Found,
    /// Bytes of state.
    pub bytes: usize,
    /// Iterations, of a method that iterates.
    pub iterations: Option<usize>,
}

/// Relative errors, value/right − 1, of what is known on both sides.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Errors {
    /// Of the indentation.
    pub indentation: Option<f64>,
    /// Of the normal force.
    pub force: Option<f64>,
    /// Of the contact radius.
    pub radius: Option<f64>,
    /// Of the largest pressure.
    pub pressure: Option<f64>,
    /// Of the stiffness.
    pub stiffness: Option<f64>,
}

impl Errors {
    /// The errors of a state against the right one.
    #[must_use]
    pub fn of(found: &Found, right: &Found) -> Self {
        let error =
            |of: fn(&Found) -> Option<f64>| Some(of(found)? / of(right)? - 1.0).filter(|error| error.is_finite());
        Self {
            indentation: error(|state| state.indentation_m),
            force: error(|state| state.force_n),
            radius: error(|state| state.contact_radius_m),
            pressure: error(|state| state.peak_pressure_pa),
            stiffness: error(|state| state.stiffness_n_per_m),
        }
    }
}

/// A case by one method at one fineness.
#[derive(Debug, Clone, Default)]
pub struct Row {
    /// Name of the case.
    pub case: &'static str,
    /// The method.
    pub method: &'static str,
    /// How fine it works.
    pub setting: Setting,
    /// Strength of the proof, of a case that is held to a bound.
    pub proof: Option<Proof>,
    /// Largest error allowed, if it is held to one.
    pub bound: Option<f64>,
    /// Largest error found.
    pub error: Option<f64>,
    /// Errors by quantity.
    pub errors: Errors,
    /// What the method has found.
    pub solved: Computed,
    /// Run times.
    pub times: Option<Times>,
    /// What the time is compared with, and the time over the time of that.
    pub beside: Option<(&'static str, f64)>,
    /// The range of values tried, if it is one.
    pub over: Option<Extreme>,
    /// Computations tried, of a range of values.
    pub tried: usize,
    /// Computations in which a law was broken.
    pub broken: usize,
    /// Why there is no answer.
    pub why: Option<String>,
}

impl Row {
    /// The row of an error, or of the reason why there is none.
    #[must_use]
    pub fn of(error: Attempt<f64>) -> Self {
        match error {
            Ok(error) => Self { error: Some(error), ..Self::default() },
            Err(why) => Self { why: Some(why.to_string()), ..Self::default() },
        }
    }

    /// The largest error over a range of values; to have tried nothing is no answer.
    #[must_use]
    pub fn over(extreme: Extreme) -> Self {
        let row = match (extreme.tried)() {
            Ok(Tally { tried: 0, .. }) => Self::of(Err("nothing was tried".into())),
            Ok(tally) => Self { tried: tally.tried, broken: tally.broken, ..Self::of(Ok(tally.worst)) },
            Err(why) => Self::of(Err(why)),
        };
        Self { over: Some(extreme), ..row }
    }

    /// Whether there is an answer, within its bound and with no law broken.
    #[must_use]
    pub fn passed(&self) -> bool {
        // Written so that a NaN fails.
        let within = self.error.zip(self.bound).is_some_and(|(error, bound)| error <= bound);
        within && self.broken == 0 && self.why.is_none()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_an_answer_within_its_bound_and_laws_passes() {
        let row = |error| Row { bound: Some(0.1), ..Row::of(error) };
        assert!(row(Ok(0.1)).passed());
        assert!(!row(Ok(0.2)).passed() && !row(Ok(f64::NAN)).passed() && !row(Err("no contact".into())).passed());
        assert!(!Row { broken: 1, ..row(Ok(0.0)) }.passed() && !Row::of(Ok(0.0)).passed());
        assert_eq!(row(Err("no contact".into())).why.unwrap(), "no contact");
    }
}
