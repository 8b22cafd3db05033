//! All cases with an exact answer, written once for tests, `verify` and the reports.
//!
//! # Examples
//! ```
//! use springbed::check::cases;
//!
//! let all = cases::all();
//! assert!(all.len() > 50 && cases::matching("impact/").len() >= 8);
//! assert!(all.iter().all(|case| !case.because.is_empty()));
//! ```

mod adhesive;
mod bed;
mod elastic;
pub(super) mod estimates;
pub(super) mod extremes;
mod friction;
mod gliding;
#[cfg(feature = "half-space")]
mod half_space;
#[cfg(feature = "half-space")]
mod half_space_past;
#[cfg(feature = "half-space")]
mod half_space_sliding;
mod impact;
mod ground;
mod lying;
mod machine;
mod pad;
mod plastic;
mod power_law;
mod rolling;
mod rough;
mod shapes;
mod stress;
mod viscoelastic;
mod viscous;
mod wear;

use super::case::{Attempt, Case};
use super::study::{Study, Thoroughness};

/// The usual way, shown beside the extremes and held to nothing.
pub const USUAL: Case = extremes::EXPLICIT_EULER;

/// Every case.
#[must_use]
pub fn all() -> Vec<Case> {
    #[cfg(feature = "half-space")]
    let half_space = [half_space::CASES, half_space_sliding::CASES, half_space_past::CASES].concat();
    #[cfg(not(feature = "half-space"))]
    let half_space: Vec<Case> = Vec::new();
    let held = [
        elastic::CASES,
        bed::CASES,
        shapes::CASES,
        lying::CASES,
        ground::CASES,
        stress::CASES,
        adhesive::CASES,
        pad::CASES,
        viscoelastic::CASES,
        viscous::CASES,
        power_law::CASES,
        friction::CASES,
        wear::CASES,
        impact::CASES,
        plastic::CASES,
        gliding::CASES,
        rolling::CASES,
        machine::CASES,
        rough::CASES,
        &half_space,
        estimates::CASES,
    ];
    [held.concat(), extremes::all()].concat()
}

/// The cases whose name contains `filter`, in upper or lower case.
#[must_use]
pub fn matching(filter: &str) -> Vec<Case> {
    let filter = filter.to_lowercase();
    all().into_iter().filter(|case| case.name.to_lowercase().contains(&filter)).collect()
}

/// The cases that can be computed in several ways, with the ways.
///
/// # Errors
/// A way cannot be set up.
pub fn studies(effort: Thoroughness) -> Attempt<Vec<Study>> {
    all().iter().filter_map(|case| case.ways).map(|ways| ways(effort)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::row::Row;
    use rayon::prelude::*;

    #[test]
    fn every_case_is_within_its_bound() {
        let failed: Vec<Row> = all().par_iter().map(Case::verdict).filter(|row| !row.passed()).collect();
        assert!(failed.is_empty(), "{failed:#?}");
    }

    #[test]
    fn names_are_unique_and_every_case_says_why_and_where_it_is_weak() {
        let cases = all();
        for (at, case) in cases.iter().enumerate() {
            assert!(!case.because.is_empty() && !case.weak.is_empty(), "{}", case.name);
            assert!(cases[at + 1..].iter().all(|other| other.name != case.name), "{}", case.name);
        }
    }
}
