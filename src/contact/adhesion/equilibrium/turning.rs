//! Where an equilibrium curve turns: the ends of its stable branches, found as far out as a contact has come.

use super::{BranchError, Control, Equilibrium, Search};
use crate::numerics::{extremum, root};

/// Whether a turning point is the lower or the upper end of a stable branch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Minimum,
    Maximum,
}

/// A point where dQ/ds changes its sign.
#[derive(Debug, Clone, Copy)]
pub(super) struct Turning {
    pub(super) s: f64,
    pub(super) value: f64,
    pub(super) kind: Kind,
}

/// Points at which the slope is looked at per wave.
const POINTS_PER_WAVE: f64 = 24.0;

/// The most waves that are followed.
const MOST_WAVES: usize = 200_000;

/// Points per decade in the search over decades.
const POINTS_PER_DECADE: f64 = 24.0;

/// Where a function that has the same sign at both ends comes nearest to zero between them, if it may change its sign
/// there: a parabola through both ends and the middle tells whether to look.
fn nearest_to_zero((low, a): (f64, f64), f: impl Fn(f64) -> f64, (high, c): (f64, f64)) -> Option<f64> {
    let middle = 0.5 * (low + high);
    let b = f(middle);
    if (b > 0.0) != (a > 0.0) {
        return Some(middle);
    }
    let (bend, tilt) = (a - 2.0 * b + c, 0.5 * (a - c));
    let towards = if a > 0.0 { bend > 0.0 } else { bend < 0.0 };
    // Beyond an end, in halves of the way, it belongs to the neighbours; a pair at their border to both.
    if !towards || tilt.abs() > BORDER * bend.abs() {
        return None;
    }
    let nearest = b - 0.5 * tilt * tilt / bend;
    let away = (nearest > 0.0) == (a > 0.0) && nearest.abs() > BLUR * bend.abs();
    (!away).then(|| extremum::greatest(|s| if a > 0.0 { -f(s) } else { f(s) }, low, high).place)
}

/// Halves of the way from the middle up to which the nearest place by a parabola may be inside.
const BORDER: f64 = 1.25;

/// Part of its bend by which a parabola over a step of a search may be wrong.
const BLUR: f64 = 0.25;

/// The turning points of a curve under one kind of control, ascending; wavy curves are searched further as the contact grows.
#[derive(Debug, Clone)]
pub(super) struct TurningPoints {
    control: Control,
    points: Vec<Turning>,
    scanned: f64,
}

impl TurningPoints {
    /// Those of `curve`.
    ///
    /// # Errors
    /// The equilibrium has no value somewhere.
    pub(super) fn of(curve: &impl Equilibrium, control: Control) -> Result<Self, BranchError> {
        let mut own = Self { control, points: Vec::new(), scanned: f64::INFINITY };
        own.mark_start(curve);
        match curve.search() {
            Search::Nowhere => {}
            Search::Once => own.find_single(curve, curve.end())?,
            Search::Decades(below, above) => own.find_in_decades(curve, (below, above))?,
            Search::About(kink) => own.find_about(curve, kink)?,
            Search::Spaced(length) => {
                let first = length / POINTS_PER_WAVE;
                own.scanned = first.min(curve.end());
                if curve.slope(control, first) > 0.0 {
                    own.find_single(curve, first)?;
                }
            }
        }
        Ok(own)
    }

    pub(super) fn first(&self) -> Option<Turning> {
        self.points.first().copied()
    }

    pub(super) fn last(&self) -> Option<Turning> {
        self.points.last().copied()
    }

    /// The parameter up to which a wavy curve is searched; infinite of all others.
    pub(super) fn scanned(&self) -> f64 {
        self.scanned
    }

    pub(super) fn next_maximum(&self, s: f64) -> Option<Turning> {
        let from = self.points.partition_point(|turning| turning.s <= s);
        self.points[from..].iter().find(|turning| turning.kind == Kind::Maximum).copied()
    }

    pub(super) fn next_minimum(&self, s: f64) -> Option<Turning> {
        let from = self.points.partition_point(|turning| turning.s <= s);
        self.points[from..].iter().find(|turning| turning.kind == Kind::Minimum).copied()
    }

    /// Parameters strictly between `low` and `high` at which Q turns, ascending.
    ///
    /// # Errors
    /// A wavy contact covers too many waves.
    pub(super) fn between(&mut self, curve: &impl Equilibrium, low: f64, high: f64) -> Result<Vec<f64>, BranchError> {
        self.scan_to(curve, high)?;
        let inside = |turning: &&Turning| turning.s > low && turning.s < high && turning.s > curve.start();
        Ok(self.points.iter().filter(inside).map(|turning| turning.s).collect())
    }

    /// The minimum at or below `s`.
    pub(super) fn minimum_below(&self, s: f64) -> Option<Turning> {
        let to = self.points.partition_point(|turning| turning.s <= s);
        self.points[..to].iter().rev().find(|turning| turning.kind == Kind::Minimum).copied()
    }

    pub(super) fn maximum_below(&self, s: f64) -> Option<Turning> {
        let to = self.points.partition_point(|turning| turning.s < s);
        self.points[..to].iter().rev().find(|turning| turning.kind == Kind::Maximum).copied()
    }

    fn mark_start(&mut self, curve: &impl Equilibrium) {
        let s = curve.start();
        let kind = if curve.search() == Search::Nowhere { Kind::Minimum } else { Kind::Maximum };
        self.points.push(Turning { s, value: curve.value(self.control, s), kind });
    }

    fn push(&mut self, curve: &impl Equilibrium, s: f64, kind: Kind) {
        self.points.push(Turning { s, value: curve.value(self.control, s), kind });
    }

    /// The single minimum below `limit`, bracketed in factors of four about the scale.
    fn find_single(&mut self, curve: &impl Equilibrium, limit: f64) -> Result<(), BranchError> {
        let slope = |s: f64| curve.slope(self.control, s);
        let mut high = curve.scale().min(limit);
        while slope(high) < 0.0 {
            if high >= limit || high > 1e300 {
                self.push(curve, high, Kind::Minimum);
                return Ok(());
            }
            high = (4.0 * high).min(limit);
        }
        let mut low = 0.25 * high;
        while slope(low) > 0.0 && low > 1e-300 {
            (low, high) = (0.25 * low, low);
        }
        let s = root::brent(slope, low, high)?;
        self.push(curve, s, Kind::Minimum);
        Ok(())
    }

    /// Turning points below a kink, at it and closely above it, and the last one far above.
    ///
    /// The edge of a flat holds the contact over a range of Q in a sliver as thin as 1e-13 of it.
    fn find_about(&mut self, curve: &impl Equilibrium, kink: f64) -> Result<(), BranchError> {
        let mut at = kink * (1.0 - f64::EPSILON);
        if curve.slope(self.control, at) > 0.0 {
            self.find_single(curve, at)?;
        }
        let closing_in = (0..=14).rev().map(|k| kink * (1.0 + 8f64.powi(-k)));
        let beyond = std::iter::successors(Some(2.0 * kink), |s| Some(1.1 * s));
        for next in closing_in.chain(beyond) {
            // Beyond a few times the kink Q grows for good once it grows.
            if at > 8.0 * kink && curve.slope(self.control, at) > 0.0 || at > 1e300 {
                return Ok(());
            }
            if next > at {
                self.find_between(curve, (at, next))?;
                at = next;
            }
        }
        Ok(())
    }

    fn find_in_decades(&mut self, curve: &impl Equilibrium, (below, above): (f64, f64)) -> Result<(), BranchError> {
        let mut s = curve.scale() * 10f64.powf(-below);
        let top = (curve.scale() * 10f64.powf(above)).min(curve.end());
        let factor = 10f64.powf(1.0 / POINTS_PER_DECADE);
        self.points.clear();
        let kind = if curve.slope(self.control, s) < 0.0 { Kind::Maximum } else { Kind::Minimum };
        self.push(curve, curve.start(), kind);
        while s < top {
            let next = (s * factor).min(top);
            self.find_between(curve, (s, next))?;
            s = next;
        }
        self.close_at_wall(curve, top);
        Ok(())
    }

    /// At a wall the prescribed quantity can grow at once, so a falling end is a minimum.
    fn close_at_wall(&mut self, curve: &impl Equilibrium, top: f64) {
        if top >= curve.end() && curve.slope(self.control, top) < 0.0 {
            self.push(curve, top, Kind::Minimum);
        }
    }

    /// Searches a wavy curve until it has risen above `target` for good.
    pub(super) fn scan_until(&mut self, curve: &impl Equilibrium, target: f64) -> Result<(), BranchError> {
        self.scan_while(curve, |own| own.scanned < curve.end() && !own.has_passed(curve, target))
    }

    /// Searches a wavy curve out to the parameter `s`.
    pub(super) fn scan_to(&mut self, curve: &impl Equilibrium, s: f64) -> Result<(), BranchError> {
        self.scan_while(curve, |own| own.scanned < s.min(curve.end()))
    }

    fn scan_while(&mut self, curve: &impl Equilibrium, open: impl Fn(&Self) -> bool) -> Result<(), BranchError> {
        let Search::Spaced(length) = curve.search() else { return Ok(()) };
        while open(self) {
            self.scan_step(curve, length)?;
        }
        Ok(())
    }

    fn scan_step(&mut self, curve: &impl Equilibrium, length: f64) -> Result<(), BranchError> {
        let next = (self.scanned + length / POINTS_PER_WAVE).min(curve.end());
        if next / length > MOST_WAVES as f64 {
            return Err(BranchError::TooManyWaves { most: MOST_WAVES });
        }
        self.find_between(curve, (self.scanned, next))?;
        self.scanned = next;
        if next >= curve.end() {
            self.close_at_wall(curve, next);
        }
        Ok(())
    }

    fn has_passed(&self, curve: &impl Equilibrium, target: f64) -> bool {
        curve.value(self.control, self.scanned) > target
            && self.points.last().is_none_or(|turning| turning.kind == Kind::Minimum)
    }

    /// Turning points between two neighbouring points of a search, a close pair included.
    fn find_between(&mut self, curve: &impl Equilibrium, (low, high): (f64, f64)) -> Result<(), BranchError> {
        let slope = |s: f64| curve.slope(self.control, s);
        let (at_low, at_high) = (slope(low), slope(high));
        if (at_low > 0.0) != (at_high > 0.0) {
            let s = root::brent(slope, low, high)?;
            let kind = if at_high > 0.0 { Kind::Minimum } else { Kind::Maximum };
            self.push(curve, s, kind);
            return Ok(());
        }
        let Some(between) = nearest_to_zero((low, at_low), slope, (high, at_high)) else { return Ok(()) };
        if (slope(between) > 0.0) != (at_low > 0.0) {
            let pair = [root::brent(slope, low, between)?, root::brent(slope, between, high)?];
            let kinds = if at_low > 0.0 { [Kind::Maximum, Kind::Minimum] } else { [Kind::Minimum, Kind::Maximum] };
            for (s, kind) in pair.into_iter().zip(kinds) {
                self.push(curve, s, kind);
            }
        }
        Ok(())
    }
}
