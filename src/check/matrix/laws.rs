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
//! assert!(kept.len() == 7 && kept.iter().all(|kept| kept.failure.is_none()), "{kept:?}");
//! assert_eq!(kept[0].law, Law::Cut);
//! ```

use super::Cell;
use super::balance::{ledger, ledger_of_machine};
use super::ends::{Ends, compared, outcome, outcome_with_instants};
use super::known::{Ball, beyond_estimate};
use super::variation::Variation;
use super::written::{ACCURACY, Written};
use crate::run::record::Outcome;

/// A law.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Law {
    /// Straight ways cut in two are the same ways.
    Cut,
    /// The same motion from a table is the same motion.
    Table,
    /// It does not matter which body comes first.
    Swap,
    /// Units of length, modulus and time do not matter.
    Units,
    /// Prony terms without weight leave the elastic contact.
    Elastic,
    /// A bridge of liquid is the attraction of its work and its stress.
    Bridge,
    /// ∫F dd + ∫F_x du = stored + dissipated, and what is lost is not found again.
    Ledger,
    /// The error is at most what the scene says of it.
    Estimate,
    /// A ball on elastic bodies is that of Hertz, or of Johnson, Kendall & Roberts.
    Closed,
}

impl Law {
    /// All of them.
    pub const ALL: [Self; 9] = [
        Self::Cut,
        Self::Table,
        Self::Swap,
        Self::Units,
        Self::Elastic,
        Self::Bridge,
        Self::Ledger,
        Self::Estimate,
        Self::Closed,
    ];
}

/// A law that a scene was held against.
#[derive(Debug, Clone, PartialEq)]
pub struct Kept {
    /// The law.
    pub law: Law,
    /// How it fails, if it does.
    pub failure: Option<String>,
}

impl Kept {
    /// A law and why it is not kept, with the scene that shows it.
    fn of(law: Law, failure: Option<String>, written: &Written) -> Self {
        Self { law, failure: failure.map(|why| format!("{why}: {}", written.told())) }
    }
}

/// Relative difference of two ways to the same state that are exact.
const SAME: f64 = 1e-9;
/// Weight of the Prony terms of bodies that are nearly elastic, and what it may change.
const WEIGHT: f64 = 1e-10;

/// What physics says no to: a wave that a mass has pressed flat, or a sphere beyond its equator; a liquid drawn out too
/// slowly to part; an edge that a slide peels off.
const REFUSED: [&str; 3] = ["outgrows the profile", "never part", "peels the adhesive contact"];

/// Records of an entry where its work is added up, on a bed and on pixels.
const RECORDS: [u32; 2] = [400, 40];

impl Cell {
    /// The scene with other numbers as text, if there is one.
    #[must_use]
    pub fn text(&self, variation: &Variation) -> Option<String> {
        self.written(variation).map(|written| written.told())
    }

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
            Err(why) if REFUSED.iter().any(|refused| why.contains(refused)) => return Vec::new(),
            Err(why) => return vec![Kept::of(Law::Ledger, Some(why), &written)],
        };
        let exact = self.bound(&written, &whole);
        let mut kept = same_ways(&whole, &written, (part, &|outcome| self.bound(&written, outcome)));
        kept.extend(self.other_units(&whole, variation, exact));
        if written.relaxes() {
            kept.extend(elastic_limit(&written, exact));
        }
        kept.extend(self.balanced(&whole, &written, exact));
        kept.push(Kept::of(Law::Estimate, beyond_estimate(&written, &whole), &written));
        kept.extend(self.ball(variation).map(|ball| Kept::of(Law::Closed, ball.missed(&whole), &written)));
        kept
    }

    /// The same in the units of the matrix.
    fn other_units(&self, whole: &Outcome, variation: &Variation, exact: f64) -> Option<Kept> {
        let (written, plain) = (self.written(variation)?, self.written(&variation.in_plain_units())?);
        if written.falls() {
            return None;
        }
        let units = &variation.units;
        let one = Ends::of(whole)?.over(units.of(written.force), units.of("m"));
        let failure = match outcome(&plain) {
            Ok(plain) => Ends::of(&plain)?.differ(&one, exact),
            Err(why) => Some(why),
        };
        Some(Kept::of(Law::Units, failure, &written))
    }

    /// The ledger of a scene that keeps one.
    fn balanced(&self, whole: &Outcome, written: &Written, exact: f64) -> Option<Kept> {
        if written.strikes() || written.moves_along() || written.wears() {
            return None;
        }
        if whole.records.iter().any(|record| record.machine.is_some()) {
            return Some(Kept::of(Law::Ledger, ledger_of_machine(whole, exact.max(ACCURACY)), written));
        }
        let fine = written.clone().finer(RECORDS[usize::from(written.is_on_pixels())]);
        let failure = outcome_with_instants(&fine).map_or_else(Some, |fine| ledger(&fine, exact, self.finds_losses()));
        Some(Kept::of(Law::Ledger, failure, &fine))
    }

    /// The ball of Hertz, or of Johnson, Kendall & Roberts, if it is one at rest.
    pub(super) fn ball(&self, variation: &Variation) -> Option<Ball> {
        let [shape, bodies, adhesion, friction, drive] = self.names();
        let work = match adhesion {
            "none" => 0.0,
            "JKR" => 0.02 * variation.work * variation.units.of("J/m2"),
            _ => return None,
        };
        let rests = !["impact", "oblique", "glide", "roll", "traction", "ring", "fall"].contains(&drive);
        let modulus = match bodies {
            "elastic" => 2e6 / 0.75,
            "both elastic" => 1e6 / 0.75,
            _ => return None,
        };
        let units = &variation.units;
        let ball = Ball { radius: 5e-3 * units.of("m"), modulus: modulus * units.of("Pa"), work };
        (shape == "ball" && friction == "none" && rests).then_some(ball)
    }

    /// Whether an edge may find again what was lost. A spring that leaves it at the load q = −√(2πaE∞w) moves by −q/E∞
    /// alone, and its dashpots slip as far under the load S of its elements: where these still pull, S < 0, they give
    /// back Sq/E∞ per length. The work of adhesion is w whatever S is, and a spring that was stretched faster than it
    /// relaxes has taken less.
    fn finds_losses(&self) -> bool {
        let [_, bodies, adhesion, ..] = self.names();
        bodies.contains("viscoelastic") && ["JKR", "JKR, rate", "JKR, closing"].contains(&adhesion)
    }

    /// How far two ways to the same state may end apart: rounding, and where a motion or an edge is followed to an
    /// accuracy only, that. What a method misses of its shape it misses on both ways.
    fn bound(&self, written: &Written, whole: &Outcome) -> f64 {
        let estimate = whole.error_estimate.relative;
        let followed = match self.names()[0] {
            // An edge that opens at a rate is followed as well as is told, on any shape.
            "rough line" | "ellipsoid" if written.relaxes() && self.names()[2] != "JKR, rate" => estimate.min(ACCURACY),
            // An edge between two works is followed in steps.
            "ellipsoid" if self.names()[2] == "JKR, closing" => estimate.min(ACCURACY),
            "rough line" | "ellipsoid" if !written.relaxes() => 0.0,
            // What the steps leave is another matter on other steps.
            _ if written.is_on_pixels() => {
                estimate.min(whole.number("error_of_steps").map_or(ACCURACY, |steps| steps.max(ACCURACY)))
            }
            _ => estimate,
        };
        SAME + 4.0 * followed
    }
}

/// Cut at a part of its ways, as a table, with its bodies swapped, with another name for its attraction: it may end as
/// far apart as either is `known`.
fn same_ways(whole: &Outcome, written: &Written, (part, known): (f64, &dyn Fn(&Outcome) -> f64)) -> Vec<Kept> {
    // A pad is led from where its highest part just touches, pixels that attract each other from where they have come together.
    let [begin, pull] = whole
        .records
        .first()
        .map_or([0.0; 2], |record| [record.normal.indentation.unwrap_or(0.0), record.normal.force]);
    let cut = written.cut(part, [begin, pull]);
    let cut = (cut.history != written.history).then_some((Law::Cut, cut));
    let table = written.in_rows(begin).map(|table| (Law::Table, table));
    let bridge = written.as_maugis().map(|bridge| (Law::Bridge, bridge));
    let ways = [cut, table, Some((Law::Swap, written.swapped())), bridge].into_iter().flatten();
    ways.filter(|(_, other)| other.plan().is_ok())
        .map(|(law, other)| Kept::of(law, compared(whole, &other, known), &other))
        .collect()
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
    Some(Kept::of(Law::Elastic, failure, &relaxing))
}
