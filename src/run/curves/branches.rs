//! Records told apart by direction: approach and retraction, with the jumps between them.
//!
//! # Examples
//! ```
//! # #[cfg(feature = "text")] {
//! use springbed::prelude::*;
//! use springbed::run::curves::branches::{Direction, branches};
//!
//! let text = r#"(shape: Paraboloid(radius: 1), bodies: (Elastic(young: 1, poisson: 0), Rigid), adhesion: Jkr(work: 1),
//!     history: [Press(to: 1, over: 1), Retract(speed: 0.1)])"#;
//! let plan = Notation::Ron.plan(text, &InMemory::default()).map_err(|errors| errors[0].clone())?;
//! let outcome = run(&plan, Wanted::NOTHING)?;
//! assert_eq!(branches(&outcome.records).last().unwrap().direction, Direction::Retraction);
//! # }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use crate::run::record::Record;

/// How the indentation moves along a branch.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Direction {
    /// It grows.
    Approach,
    /// It falls.
    Retraction,
}

/// A run of records that move in one direction without a jump.
#[derive(Debug, Clone, Copy)]
pub struct Branch<'r> {
    /// How the indentation moves.
    pub direction: Direction,
    /// The records.
    pub records: &'r [Record],
}

/// Splits records where the direction of the indentation changes and where the contact jumps.
#[must_use]
pub fn branches(records: &[Record]) -> Vec<Branch<'_>> {
    let mut found = Vec::new();
    let mut start = 0;
    for end in 1..=records.len() {
        if end == records.len() || is_jump(&records[end - 1], &records[end]) || turns(&records[start..=end]) {
            found.extend(branch(&records[start..end]));
            // A turning point belongs to both branches, the two sides of a jump to one each.
            start = if end < records.len() && is_jump(&records[end - 1], &records[end]) { end } else { end - 1 };
        }
    }
    found
}

/// The records on both sides of each jump.
pub fn jumps(records: &[Record]) -> impl Iterator<Item = (&Record, &Record)> {
    records.windows(2).map(|pair| (&pair[0], &pair[1])).filter(|pair| is_jump(pair.0, pair.1))
}

fn branch(records: &[Record]) -> Option<Branch<'_>> {
    let (first, last) = (depth(records.first()?)?, depth(records.last()?)?);
    let direction = if last > first { Direction::Approach } else { Direction::Retraction };
    ((last - first).abs() > 0.0).then_some(Branch { direction, records })
}

fn depth(record: &Record) -> Option<f64> {
    record.normal.indentation
}

/// Two states at one time.
fn is_jump(before: &Record, after: &Record) -> bool {
    (after.time - before.time).abs() <= 0.0 && before.normal != after.normal
}

/// Whether the last of these records moves against the others.
fn turns(records: &[Record]) -> bool {
    let [first, .., before, last] = records else { return false };
    let (Some(first), Some(before), Some(last)) = (depth(first), depth(before), depth(last)) else { return true };
    (before - first) * (last - before) < 0.0
}
