//! Equilibrium curves and the branches a quasi-static contact follows on them.
//!
//! # Examples
//! ```
//! use springbed::contact::adhesion::equilibrium::{Branches, Control, Equilibrium};
//! use springbed::contact::adhesion::line::EdgeLine;
//! use springbed::contact::foundation::Foundation;
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! // A ball, R = E* = w = 1, pulled at a prescribed depth: it parts at d = −(3/4)(π²)^{1/3} (JKR).
//! let ground = Foundation::new(Arc::new(Paraboloid { radius: Length::new(1.0)? }), 1.0);
//! let curve = EdgeLine::new(ground, 1.0);
//! let mut branches = Branches::new(&curve, Control::Indentation)?;
//! let (touched, _) = branches.follow(&curve, curve.start(), 1.0)?;
//! let (_, leaps) = branches.follow(&curve, touched, -2.0)?;
//! assert!((leaps[0].at + 0.75 * std::f64::consts::PI.powf(2.0 / 3.0)).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod turning;

use crate::numerics::root;
use turning::{Kind, Turning, TurningPoints};

/// What the machine prescribes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Control {
    /// The indentation depth d.
    Indentation,
    /// The normal force F.
    Force,
}

/// A state on an equilibrium curve. Lengths in metres, force in newtons.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Balance {
    /// Radius a of the contact.
    pub contact_radius: f64,
    /// Radius c ≥ a up to which the bodies attract each other.
    pub reach: f64,
    /// Indentation d.
    pub indentation: f64,
    /// Normal force F.
    pub force: f64,
}

/// Equilibrium states of a contact, as a curve with one growing parameter.
///
/// The parameter s is the radius up to which the bodies act on each other. Off the curve the edge
/// moves: it opens where Q(s) is above the prescribed value Q and closes where it is below
/// (Q = d or F). So a state is stable where Q grows with s, and a contact that has lost its
/// stability runs to the next stable crossing in the direction of the motion.
pub trait Equilibrium {
    /// The prescribed quantity Q(s).
    fn value(&self, control: Control, s: f64) -> f64;

    /// Its derivative dQ/ds.
    fn slope(&self, control: Control, s: f64) -> f64;

    /// The parameter at which Q has the value `target`, where it is known without a search.
    fn known(&self, control: Control, target: f64) -> Option<f64>;

    /// The smallest parameter: where the bodies part or first act on each other.
    fn start(&self) -> f64;

    /// The largest parameter; infinite where the profile goes on for ever.
    fn end(&self) -> f64;

    /// A length typical of the turning points.
    fn scale(&self) -> f64;

    /// Where turning points have to be looked for.
    fn search(&self) -> Search;
}

/// Where an equilibrium curve can turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Search {
    /// Nowhere: Q grows with s.
    Nowhere,
    /// Once: a convex profile with attraction of vanishing range.
    Once,
    /// A few times, over this many decades about the scale: attraction of finite range.
    Decades(f64, f64),
    /// About this parameter at any scale, where the law of the profile changes: a flat or rounded tip.
    About(f64),
    /// Many times, spaced by about this length [m]: a wavy profile.
    Spaced(f64),
}

/// A jump from one stable branch to another, or out of contact (`to` at the start of the curve).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Leap {
    /// The prescribed quantity at the jump.
    pub at: f64,
    /// Parameter before.
    pub from: f64,
    /// Parameter after.
    pub to: f64,
}

/// Why a branch could not be followed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum BranchError {
    /// The contact would grow beyond the end of the profile.
    #[error("the contact would grow beyond the end of the profile at the radius {end:e} m")]
    BeyondEnd {
        /// End of the profile [m].
        end: f64,
    },
    /// The waviness is too fine against the contact to follow each wave.
    #[error(
        "the contact would cover more than {most} waves: no jump could be told from the next; use a longer wavelength or a smaller contact"
    )]
    TooManyWaves {
        /// The most that are followed.
        most: usize,
    },
    /// The equilibrium has no value.
    #[error("the equilibrium of the contact has no value: {0}")]
    Root(#[from] root::RootError),
}

/// Most of Newton's steps to a root nearby, and the part of the parameter below which one is followed by less than rounding
/// where what is left of Q is a small part of it too: beside the rim of a flat the slope is infinite, and any step short.
const STEPS_NEARBY: usize = 8;
const MET: f64 = 1e-10;
const LEFT: f64 = 1e-7;

/// The stable branches of an equilibrium curve under one kind of control.
#[derive(Debug, Clone)]
pub struct Branches {
    control: Control,
    turning: TurningPoints,
}

impl Branches {
    /// The branches of `curve`; wavy curves are searched further as the contact grows.
    ///
    /// # Errors
    /// The equilibrium has no value somewhere.
    pub fn new(curve: &impl Equilibrium, control: Control) -> Result<Self, BranchError> {
        Ok(Self { control, turning: TurningPoints::of(curve, control)? })
    }

    /// Follows the stable branch from `s` while the prescribed quantity goes to `target`.
    ///
    /// Returns the parameter at the end and the jumps on the way, in order. Beyond a wall the
    /// parameter stays at the end of the curve.
    ///
    /// # Errors
    /// The contact would leave the profile, or cover too many waves.
    pub fn follow(&mut self, curve: &impl Equilibrium, s: f64, target: f64) -> Result<(f64, Vec<Leap>), BranchError> {
        let mut leaps = Vec::new();
        // Another control may have led here, past waves this one has not seen.
        self.turning.scan_to(curve, s)?;
        let upwards = s <= curve.start() || curve.value(self.control, s) <= target;
        let end =
            if upwards { self.climb(curve, s, target, &mut leaps)? } else { self.sink(curve, s, target, &mut leaps)? };
        Ok((end, leaps))
    }

    /// The ends of the stable branch at `s`: the parameter and the prescribed quantity at its minimum and at its maximum;
    /// `None` where it has none.
    #[must_use]
    pub fn ends(&self, s: f64) -> [Option<(f64, f64)>; 2] {
        [self.turning.minimum_below(s), self.turning.next_maximum(s)]
            .map(|turning| turning.map(|turning| (turning.s, turning.value)))
    }

    /// Parameters strictly between `low` and `high` at which Q turns, ascending.
    ///
    /// # Errors
    /// A wavy contact covers too many waves.
    pub fn turns_between(&mut self, curve: &impl Equilibrium, low: f64, high: f64) -> Result<Vec<f64>, BranchError> {
        self.turning.between(curve, low, high)
    }

    fn climb(
        &mut self,
        curve: &impl Equilibrium,
        s: f64,
        target: f64,
        leaps: &mut Vec<Leap>,
    ) -> Result<f64, BranchError> {
        let mut at = s;
        if at <= curve.start() {
            if target < curve.value(self.control, curve.start()) {
                return Ok(curve.start());
            }
            if let Some(first) = self.turning.first().filter(|first| first.kind == Kind::Maximum) {
                let to = self.landing_above(curve, first)?;
                leaps.push(Leap { at: first.value, from: first.s, to });
                at = to;
            }
        }
        self.turning.scan_until(curve, target)?;
        while let Some(top) = self.turning.next_maximum(at) {
            if top.value >= target {
                return self.root_between(curve, (at, top.s), target);
            }
            let to = self.landing_above(curve, top)?;
            leaps.push(Leap { at: top.value, from: top.s, to });
            at = to;
        }
        self.root_above(curve, at, target)
    }

    fn sink(&self, curve: &impl Equilibrium, s: f64, target: f64, leaps: &mut Vec<Leap>) -> Result<f64, BranchError> {
        let mut at = s;
        loop {
            let Some(bottom) = self.turning.minimum_below(at) else { return Ok(curve.start()) };
            if bottom.value <= target {
                let nearby = self.nearby(curve, at, target);
                return nearby.map_or_else(|| self.root_between(curve, (bottom.s, at), target), Ok);
            }
            if bottom.s <= curve.start() {
                return Ok(curve.start());
            }
            let to = self.landing_below(curve, bottom)?;
            leaps.push(Leap { at: bottom.value, from: bottom.s, to });
            at = to;
            if at <= curve.start() {
                return Ok(at);
            }
        }
    }

    /// First stable state above a maximum at the same prescribed value.
    fn landing_above(&mut self, curve: &impl Equilibrium, top: Turning) -> Result<f64, BranchError> {
        self.turning.scan_until(curve, top.value)?;
        let mut from = self.turning.next_minimum(top.s).map_or(top.s, |bottom| bottom.s);
        while let Some(next) = self.turning.next_maximum(from) {
            if next.value > top.value {
                return self.root_between(curve, (from, next.s), top.value);
            }
            from = self.turning.next_minimum(next.s).map_or(next.s, |bottom| bottom.s);
        }
        self.root_above(curve, from, top.value)
    }

    /// First stable state below a minimum at the same prescribed value; the start if there is none.
    fn landing_below(&self, curve: &impl Equilibrium, bottom: Turning) -> Result<f64, BranchError> {
        let mut below = bottom.s;
        while let Some(top) = self.turning.maximum_below(below) {
            let Some(low) = self.turning.minimum_below(top.s) else { break };
            if low.value < bottom.value {
                return self.root_between(curve, (low.s, top.s), bottom.value);
            }
            below = low.s;
        }
        Ok(curve.start())
    }

    fn root_between(&self, curve: &impl Equilibrium, (low, high): (f64, f64), target: f64) -> Result<f64, BranchError> {
        let residual = |s: f64| curve.value(self.control, s) - target;
        match root::brent(residual, low, high) {
            Err(root::RootError::NoSignChange { .. }) => {
                // The target is a turning value to rounding: the nearer end is the answer.
                Ok(if residual(low).abs() <= residual(high).abs() { low } else { high })
            }
            found => Ok(found?),
        }
    }

    /// The root on the last, rising branch above `s`; the end of the curve if the wall is reached.
    ///
    /// What has been searched is known to rise from its last turning point on; beyond it a step could
    /// pass over the waves to come.
    fn root_above(&self, curve: &impl Equilibrium, s: f64, target: f64) -> Result<f64, BranchError> {
        if let Some(known) = curve.known(self.control, target) {
            return Ok(known);
        }
        if let Some(found) = self.nearby(curve, s, target) {
            return Ok(found);
        }
        let (end, searched) = (curve.end(), self.turning.scanned());
        let residual = |s: f64| curve.value(self.control, s) - target;
        let from = self.turning.last().map_or(s, |turning| turning.s.max(s));
        if searched.is_finite() && residual(searched) > 0.0 {
            return self.root_between(curve, (from, searched), target);
        }
        let first = if s > curve.start() { s * (1.0 + 1.0 / 64.0) } else { curve.start() + curve.scale() };
        match self.bracket_above(residual, (s, first), end) {
            Some(bracket) => self.root_between(curve, bracket, target),
            None => Ok(end),
        }
    }

    /// The root near `s` on a branch that rises without an end, by Newton's steps; `None` where they leave it or do not end.
    fn nearby(&self, curve: &impl Equilibrium, s: f64, target: f64) -> Option<f64> {
        let low = self.turning.last().map_or(curve.start(), |turning| turning.s);
        if !matches!(curve.search(), Search::Nowhere | Search::Once) || s <= low {
            return None;
        }
        let mut at = s;
        for _ in 0..STEPS_NEARBY {
            let value = curve.value(self.control, at);
            let left = value - target;
            let step = left / curve.slope(self.control, at);
            let next = at - step;
            if !(next > low && next < curve.end()) {
                return None;
            }
            if step.abs() <= MET * at && left.abs() <= LEFT * (value.abs() + target.abs()) {
                return Some(next);
            }
            at = next;
        }
        None
    }

    fn bracket_above(
        &self,
        mut residual: impl FnMut(f64) -> f64,
        (low, high): (f64, f64),
        end: f64,
    ) -> Option<(f64, f64)> {
        let (mut low, mut high) = (low, high.min(end));
        let mut growth = (high / low).clamp(1.0 + 1.0 / 64.0, 2.0);
        while residual(high) < 0.0 {
            if high >= end || high >= 0.25 * f64::MAX {
                return None;
            }
            growth = (growth * growth).min(4.0);
            (low, high) = (high, (high * growth).min(end));
        }
        Some((low, high))
    }
}
