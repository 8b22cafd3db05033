//! Laws that hold across the parts of a scene, whatever is combined.
//!
//! # Examples
//! ```
//! use springbed::check::matrix::{Law, Variation, cells};
//!
//! // A ball of rubber pressed and drawn back: cut anywhere, written as a table, with its bodies swapped it is the same.
//! let cells = cells();
//! let cell = cells.iter().find(|cell| cell.names() == ["ball", "viscoelastic", "none", "none", "depth"]).unwrap();
//! let kept = cell.laws(&Variation::default(), 0.4);
//! assert!(kept.len() == 5 && kept.iter().all(|kept| kept.failure.is_none()), "{kept:?}");
//! assert_eq!(kept[0].law, Law::Cut);
//! ```

use super::Cell;
use super::written::{ACCURACY, Variation, Written};
use crate::run::record::{Outcome, Record};
use crate::run::{self, Wanted};

/// A law.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Law {
    /// Straight ways cut in two are the same ways.
    Cut,
    /// The same motion from a table is the same motion.
    Table,
    /// It does not matter which body comes first.
    Swap,
    /// Prony terms without weight leave the elastic contact.
    Elastic,
    /// ∫F dd + ∫F_x du = stored + dissipated, and what is lost is not found again.
    Ledger,
}

/// A law that a scene was held against.
#[derive(Debug, Clone, PartialEq)]
pub struct Kept {
    /// The law.
    pub law: Law,
    /// How it fails, if it does.
    pub failure: Option<String>,
}

/// Relative difference of two ways to the same state that are exact.
const SAME: f64 = 1e-9;
/// Weight of the Prony terms of bodies that are nearly elastic, and what it may change.
const WEIGHT: f64 = 1e-10;

/// Records of an entry where its work is added up, and what the trapezoidal rule may miss of it.
const FINE: u32 = 400;
const TRAPEZOIDS: f64 = 2e-3;

/// What is compared of two runs.
struct Ends {
    record: Record,
    force: f64,
    depth: f64,
    energy: f64,
}

impl Ends {
    fn of(outcome: &Outcome) -> Option<Self> {
        let largest = |of: &dyn Fn(&Record) -> f64| outcome.records.iter().map(|r| of(r).abs()).fold(0.0, f64::max);
        Some(Self {
            record: *outcome.records.last()?,
            force: largest(&|record| record.normal.force),
            depth: largest(&|record| record.normal.indentation.unwrap_or(0.0)),
            energy: largest(&|record| record.normal.stored.elastic)
                + largest(&|record| record.normal.stored.surface)
                + largest(&|record| record.normal.dissipated),
        })
    }

    /// How the end of another way differs beyond `bound`, if it does.
    fn differ(&self, other: &Self, bound: f64) -> Option<String> {
        let (one, two) = (&self.record.normal, &other.record.normal);
        let tangential = |record: &Record| record.tangential.map_or(0.0, |state| state.force);
        let slid = (tangential(&self.record), tangential(&other.record));
        let pairs = [
            ("force", one.force, two.force, self.force),
            ("depth", one.indentation.unwrap_or(0.0), two.indentation.unwrap_or(0.0), self.depth),
            ("stored", one.stored.stored(), two.stored.stored(), self.energy),
            ("dissipated", one.dissipated, two.dissipated, self.energy),
            ("tangential force", slid.0, slid.1, self.force),
        ];
        let off = pairs.iter().find(|(_, one, two, scale)| {
            let off = (one - two).abs();
            off.is_nan() || off > bound * scale.max(f64::MIN_POSITIVE)
        });
        off.map(|(what, one, two, scale)| format!("{what} {one:e}, {two:e}: off by {:e}", (one - two).abs() / scale))
    }
}

/// The outcome of a scene; what is wrong if it has none.
fn outcome(written: &Written) -> Result<Outcome, String> {
    let plan = written.plan().map_err(|errors| errors[0].message.clone())?;
    run::run(&plan, Wanted::NOTHING).map_err(|error| error.to_string())
}

impl Cell {
    /// Whether the scene with other numbers, cut at the part `part` of its ways, keeps the laws that speak of it; of
    /// none where it is refused.
    #[must_use]
    pub fn laws(&self, variation: &Variation, part: f64) -> Vec<Kept> {
        let Some(written) = self.written(variation) else { return Vec::new() };
        if written.plan().is_err() {
            return Vec::new();
        }
        let whole = match outcome(&written) {
            Ok(whole) => whole,
            Err(why) => return vec![Kept { law: Law::Ledger, failure: Some(format!("{why}: {}", written.text())) }],
        };
        let exact = self.bound(&written, &whole);
        let cut = written.cut(part);
        let cut = (cut.history != written.history).then_some((Law::Cut, cut, exact));
        let table = written.in_rows().map(|table| (Law::Table, table, exact));
        let swap = Some((Law::Swap, written.swapped(), exact));
        let same = [cut, table, swap].into_iter().flatten().filter(|(_, other, _)| other.plan().is_ok());
        let mut kept: Vec<Kept> = same
            .map(|(law, other, bound)| {
                let failure = compared(&whole, &other, bound).map(|why| format!("{why}: {}", other.text()));
                Kept { law, failure }
            })
            .collect();
        if written.relaxes() {
            kept.extend(elastic_limit(&written, exact));
        }
        if !written.strikes() {
            let fine = written.finer(FINE);
            let failure = outcome(&fine).map_or_else(Some, |fine| ledger(&fine, exact, self.finds_losses()));
            kept.push(Kept { law: Law::Ledger, failure: failure.map(|why| format!("{why}: {}", fine.text())) });
        }
        kept
    }

    /// Whether something lost may be found again: a spring that leaves an edge held by the relaxed modulus faster than
    /// it relaxes has taken less than the work of adhesion.
    fn finds_losses(&self) -> bool {
        let [_, bodies, adhesion, ..] = self.names();
        bodies.contains("viscoelastic") && ["JKR", "JKR, rate", "JKR, closing"].contains(&adhesion)
    }

    /// How far two ways to the same state may end apart: rounding, and where a motion or an edge is followed to an
    /// accuracy only, that. What a method misses of its shape it misses on both ways.
    fn bound(&self, written: &Written, whole: &Outcome) -> f64 {
        let estimate = whole.error_estimate.relative;
        let followed = match self.names()[0] {
            "rough line" | "ellipsoid" if written.relaxes() => estimate.min(ACCURACY),
            "rough line" | "ellipsoid" => 0.0,
            _ => estimate,
        };
        SAME + 4.0 * followed
    }
}

fn compared(whole: &Outcome, other: &Written, bound: f64) -> Option<String> {
    let other = match outcome(other) {
        Ok(other) => other,
        Err(why) => return Some(why),
    };
    Ends::of(whole)?.differ(&Ends::of(&other)?, bound)
}

/// Against the elastic scene, where it can be computed.
fn elastic_limit(written: &Written, exact: f64) -> Option<Kept> {
    let [relaxing, elastic] = written.nearly_elastic(WEIGHT);
    elastic.plan().ok()?;
    relaxing.plan().ok()?;
    let failure = match (outcome(&relaxing), outcome(&elastic)) {
        (Ok(one), Ok(two)) => {
            let (one, two) = (Ends::of(&one)?, Ends::of(&two)?);
            two.differ(&one, exact + 1e3 * WEIGHT)
        }
        (Err(why), _) | (_, Err(why)) => Some(why),
    };
    Some(Kept { law: Law::Elastic, failure: failure.map(|why| format!("{why}: {}", relaxing.text())) })
}

/// Work by the trapezoidal rule between records, against what is stored and lost; nothing lost is found again unless the
/// contact `finds` it.
fn ledger(whole: &Outcome, exact: f64, finds: bool) -> Option<String> {
    let energy = Ends::of(whole)?.energy;
    let lost = |record: &Record| record.normal.dissipated;
    let back = whole.records.windows(2).map(|pair| lost(&pair[0]) - lost(&pair[1])).fold(0.0, f64::max);
    if !finds && back > exact * energy {
        return Some(format!("dissipation falls by {:e} of the energies", back / energy));
    }
    let (first, last) = (whole.records.first()?, whole.records.last()?);
    let work: f64 = whole.records.windows(2).map(|pair| work(&pair[0], &pair[1])).sum();
    let off = (work - accounted(last) + accounted(first)).abs();
    let bound = TRAPEZOIDS + exact;
    (off > bound * energy).then(|| format!("the ledger is open by {:e} of the energies", off / energy))
}

/// What has been stored and lost [J].
fn accounted(record: &Record) -> f64 {
    let rubbed = record.tangential.map_or(0.0, |state| state.stored.unwrap_or(0.0) + state.dissipated.unwrap_or(0.0));
    record.normal.stored.stored() + record.normal.dissipated + rubbed
}

/// Work between two records [J].
fn work(one: &Record, two: &Record) -> f64 {
    let slide = |record: &Record| record.tangential.map_or((0.0, 0.0), |state| (state.slide, state.force));
    let ((from, resisted), (to, resists)) = (slide(one), slide(two));
    let rubbed = 0.5 * (resisted + resists) * (to - from);
    let (Some(from), Some(to)) = (one.normal.indentation, two.normal.indentation) else { return rubbed };
    0.5 * (one.normal.force + two.normal.force) * (to - from) + rubbed
}

#[cfg(test)]
mod tests {
    use super::super::{Verdict, cells};
    use super::*;
    use rayon::prelude::*;

    /// Every seventeenth combination that is computed, each with numbers of its own.
    #[test]
    fn the_laws_hold_across_the_matrix() {
        let computed: Vec<Cell> =
            cells().into_iter().filter(|cell| matches!(cell.verdict, Verdict::Computed { .. })).collect();
        let broken = |(number, cell): (usize, &Cell)| {
            let (variation, part) = Variation::numbered(number as u64);
            let kept = cell.laws(&variation, part);
            let failed = kept.into_iter().filter(|kept| kept.failure.is_some());
            failed.map(|kept| (number, cell.names(), kept)).collect::<Vec<_>>()
        };
        let every: Vec<_> = computed.iter().enumerate().step_by(17).collect();
        let broken: Vec<_> = every.into_par_iter().flat_map_iter(broken).collect();
        assert!(broken.is_empty(), "{broken:#?}");
    }
}
