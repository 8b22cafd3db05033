//! An opening edge followed through a motion.

use super::attraction::{Attraction, Tear};
use super::spring::Motion;
use crate::numerics::{extremum, root};

/// How the edge opens in a motion.
#[derive(Debug, Clone)]
pub(super) struct Opening {
    /// Radius at the end [m].
    pub left: f64,
    /// Times [s] and radii [m].
    path: Vec<(f64, f64)>,
}

impl Opening {
    pub(super) fn tear(&self, height: impl Fn(f64) -> f64) -> Tear {
        Tear(self.path.iter().map(|&(t, a)| (height(a), t)).collect())
    }

    /// When the bodies part [s].
    pub(super) fn parting(&self) -> Option<f64> {
        self.path.iter().find(|&&(_, a)| a <= 0.0).map(|&(t, _)| t)
    }
}

/// Relative change of the radius beyond which a step is halved, and the step that is not.
const LEAP: f64 = 0.02;

/// An edge that may open: the line load of a spring if nothing lets it go, and what it withstands.
pub(super) struct Edge<'b> {
    /// Line load [N/m] at the end of a motion of the spring at the distance x from the axis.
    pub load: &'b dyn Fn(f64, &Motion) -> f64,
    /// What holds it.
    pub attraction: &'b Attraction,
    /// The motion in which it may open.
    pub motion: Motion,
}

impl Edge<'_> {
    /// Follows the edge from `reached` inwards.
    ///
    /// Steps are halved until the radius changes by little; what changes at once in a step of no
    /// duration is a jump.
    pub(super) fn open_from(&self, reached: f64) -> Opening {
        let (duration, longest) = (self.motion.duration, self.motion.duration / self.attraction.steps);
        let mut path = vec![(0.0, reached)];
        let (mut now, mut a, mut step) = (0.0, reached, longest);
        while now < duration && a > 0.0 {
            let until = if duration - now <= step * (1.0 + 1e-9) { duration } else { now + step };
            let next = self.advanced(a, now, until);
            let bit = 4.0 * f64::EPSILON * duration;
            if a - next > LEAP * a && until - now > bit {
                step = 0.5 * (until - now);
                continue;
            }
            if next < a {
                path.push((now, a));
                path.push((until, next));
            }
            (now, a) = (until, next);
            step = (1.5 * step).max(bit).min(longest);
        }
        Opening { left: a, path }
    }

    /// The edge after one step; with a rate law, two half steps and one whole one extrapolated.
    fn advanced(&self, a: f64, now: f64, until: f64) -> f64 {
        let whole = self.stepped(a, now, until);
        if self.attraction.rate.is_none() || whole >= a || whole <= 0.0 {
            return whole;
        }
        let half = 0.5 * (now + until);
        let halves = self.stepped(self.stepped(a, now, half), half, until);
        if halves > 0.0 { (2.0 * halves - whole).clamp(0.0, a) } else { 0.0 }
    }

    /// The largest radius not above `a` that holds at the time `until` (implicit in the speed of the edge).
    fn stepped(&self, a: f64, now: f64, until: f64) -> f64 {
        let seen = Motion { duration: until, ..self.motion };
        let strength = |x: f64| self.attraction.strength(x, (a - x) / (until - now));
        last_hold(&|x| (self.load)(x, &seen) + strength(x), a).unwrap_or(0.0)
    }
}

/// First step inwards of the search for an edge that holds, and the longest, relative to where it begins.
const FIRST_REACH: f64 = 1e-5;
const LONGEST_REACH: f64 = 1.0 / 64.0;

/// The largest place not above `from` at which the margin of an edge is not negative; `None` if there is none.
///
/// A place is a radius, or the time at which the spring there was touched.
pub(crate) fn last_hold(margin: &dyn Fn(f64) -> f64, from: f64) -> Option<f64> {
    let here = margin(from);
    if here >= 0.0 {
        return Some(from);
    }
    let (mut outer, mut reach) = (from, FIRST_REACH * from);
    let (mut best, mut around) = (here, (from, from));
    while outer > 0.0 {
        let inner = (outer - reach).max(0.0);
        let found = margin(inner);
        if found >= 0.0 && inner > 0.0 {
            return Some(root::brent(margin, inner, outer).unwrap_or(inner));
        }
        if found > best {
            (best, around) = (found, (inner, outer));
        }
        (outer, reach) = (inner, (1.5 * reach).min(LONGEST_REACH * from));
    }
    // Just before the edge gives way, the stretch that holds is narrower than any step.
    let low = around.0 - (around.1 - around.0).max(FIRST_REACH * from);
    let holds = extremum::reaches_zero(margin, low, around.1)?;
    Some(root::brent(margin, holds, around.1).unwrap_or(holds))
}
