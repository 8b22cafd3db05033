//! All cases with an exact answer, written once for tests, `verify` and the reports.

mod adhesive;
mod elastic;
mod friction;
#[cfg(feature = "half-space")]
mod half_space;
mod impact;
mod rough;
mod shapes;
mod viscoelastic;

use super::case::{Case, Verdict};
use rayon::prelude::*;

/// Every case.
#[must_use]
pub fn all() -> Vec<Case> {
    #[cfg(feature = "half-space")]
    let half_space = half_space::CASES;
    #[cfg(not(feature = "half-space"))]
    let half_space: &[Case] = &[];
    [
        elastic::CASES,
        shapes::CASES,
        adhesive::CASES,
        viscoelastic::CASES,
        friction::CASES,
        impact::CASES,
        rough::CASES,
        half_space,
    ]
    .concat()
}

/// The cases whose name contains `filter`, in upper or lower case.
#[must_use]
pub fn matching(filter: &str) -> Vec<Case> {
    let filter = filter.to_lowercase();
    all().into_iter().filter(|case| case.name.to_lowercase().contains(&filter)).collect()
}

/// The verdicts on the cases whose name contains `filter`, in their order; run in parallel.
#[must_use]
pub fn verdicts(filter: &str) -> Vec<Verdict> {
    matching(filter).par_iter().map(Case::verdict).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_case_is_within_its_bound() {
        let failed: Vec<Verdict> = verdicts("").into_iter().filter(|verdict| !verdict.passed).collect();
        assert!(failed.is_empty(), "{failed:#?}");
    }

    #[test]
    fn names_are_unique_and_every_case_says_why_and_where_it_is_weak() {
        let cases = all();
        for (at, case) in cases.iter().enumerate() {
            assert!(!case.reason.is_empty() && !case.weak.is_empty(), "{}", case.name);
            assert!(cases[at + 1..].iter().all(|other| other.name != case.name), "{}", case.name);
        }
    }
}
