//! The ways a pad can go from where it is, and the force on them.

use super::bed::{Bed, REACH};
use super::element::Hold;
use crate::numerics::root;

/// The forces on the ways from a state: with the edge held, and beyond with the edge led along.
#[derive(Debug, Clone, Copy)]
pub(super) struct Path {
    bed: Bed,
    hold: Hold,
    /// The edge [m] where it begins.
    edge: f64,
}

/// Deviations beyond which no number of double precision tells the density from zero.
const FAR: f64 = 37.0;
/// Part of a deviation by which the last element is within reach.
const WITHIN: f64 = 1e-9;

impl Bed {
    /// The greatest pull [N] against which the pad holds, all of it joined before: the least force on the way out.
    ///
    /// Of springs F = Nkσφ(t)[1 + (t − λ)λ] where Φ(t) = λφ(t), λ the stretch at break over σ.
    #[must_use]
    pub fn greatest_pull(&self) -> f64 {
        let hold = self.hold();
        let path = Path::new(*self, hold.leaves + FAR * self.deviation);
        path.least_below(path.edge - hold.joins).map_or(0.0, |depth| path.force(depth))
    }
}

impl Path {
    /// The ways from where the edge is at `edge` [m].
    pub(super) fn new(bed: Bed, edge: f64) -> Self {
        Self { bed, hold: bed.hold(), edge }
    }

    /// The force [N] once the depth `d` [m] is reached without a turn.
    pub(super) fn force(&self, d: f64) -> f64 {
        self.bed.sums(d, self.edge.clamp(d + self.hold.joins, d + self.hold.leaves)).force
    }

    /// dF/dd [N/m] there: N∫f′φ, and where elements join or leave at the stretch s besides N f(−s)φ(e).
    pub(super) fn slope(&self, d: f64) -> f64 {
        let Hold { joins, leaves } = self.hold;
        if d + leaves < self.edge {
            self.bed.slope(d + leaves, leaves)
        } else if d + joins > self.edge {
            self.bed.slope(d + joins, joins)
        } else {
            self.bed.sums(d, self.edge).stiffness
        }
    }

    /// The depth [m] at which no element is left.
    pub(super) fn end(&self) -> f64 {
        -REACH * self.bed.deviation - self.hold.leaves
    }

    /// The depth [m] at which elements begin to join.
    pub(super) fn joining(&self) -> f64 {
        self.edge - self.hold.joins
    }

    /// A width [m] that tells a depth from another.
    pub(super) fn width(&self) -> f64 {
        4.0 * WITHIN * self.bed.deviation
    }

    /// The depth [m] below `depth` [m] where the force is least; `None` where it grows on the way out, or never pulls.
    pub(super) fn least_below(&self, depth: f64) -> Option<f64> {
        let last = self.end() + WITHIN * self.bed.deviation;
        // Where elements are about to leave, what counts is how the force goes once they do.
        let below = depth - self.width();
        let turns = self.hold.leaves > 0.0 && below > last && self.slope(below) > 0.0 && self.slope(last) < 0.0;
        turns.then(|| root::within(|d| self.slope(d), last, below))
    }

    /// Whether on the way out from the depth `depth` [m] the pull is less at once: it has been at its greatest.
    pub(super) fn gives_way(&self, depth: f64) -> bool {
        self.hold.leaves > 0.0 && self.slope(depth - self.width()) <= 0.0
    }

    /// The depth [m] from which on the force grows on the way in, between these depths: `low` if it grows at once.
    pub(super) fn grows_from(&self, low: f64, high: f64) -> f64 {
        if self.slope(low) >= 0.0 { low } else { root::within(|d| self.slope(d), low, high) }
    }

    /// The depth [m] from which on the force grows as elements join.
    pub(super) fn joined_from(&self) -> f64 {
        let begins = self.joining() + WITHIN * self.bed.deviation;
        let ends = begins.max(0.0) + FAR * self.bed.deviation;
        self.grows_from(begins, ends)
    }

    /// The depth [m] under the force `force` [N], above the depth `low` [m] from which on the force grows.
    pub(super) fn above(&self, low: f64, force: f64) -> f64 {
        let lacks = |way: f64| self.force(low + way) - force;
        let step = self.bed.deviation + self.hold.leaves;
        let bracket = root::bracket_upwards(lacks, 0.0, step, f64::MAX.sqrt());
        bracket.map_or(low, |(from, to)| low + root::within(lacks, from, to))
    }

    /// The same between two depths [m].
    pub(super) fn between(&self, (low, high): (f64, f64), force: f64) -> f64 {
        root::within(|d| self.force(d) - force, low, high)
    }
}
