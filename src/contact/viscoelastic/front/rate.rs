//! An edge that opens as its rate law has it.

use super::super::attraction::Attraction;
use super::{Front, Way};
use crate::numerics::{extremum, root};

impl Front<'_> {
    /// The way of an edge that opens by the rate law, until it stands still: radii and times.
    ///
    /// Implicit steps, halves and whole extrapolated, as short as the difference of their contact radii asks for, but no shorter
    /// than tells when an edge that holds nowhere any more has collapsed.
    pub(super) fn path(&self) -> Vec<(f64, f64)> {
        let duration = self.motion.duration;
        let (shortest, accuracy) = (self.instantly * duration, self.attraction.map_or(0.0, Attraction::accuracy));
        let longest = duration * self.attraction.map_or(1.0, Attraction::longest);
        let (mut now, mut a, mut step, mut stride) = (0.0, self.edge, longest, 0.0);
        let mut path = vec![(a, 0.0)];
        while now < duration && a > 0.0 && !(self.fails)() {
            let until = if duration - now <= 1.01 * step { duration } else { now + step };
            let half = 0.5 * (now + until);
            let radius = |place: f64| self.profile.contact_radius(place);
            let may_be_shorter = until - now > shortest;
            let shorter = |error: f64| (until - now) * (0.9 * (accuracy / error).sqrt()).clamp(0.1, 0.5);
            let whole = self.opened(a, now, until, stride);
            // An edge that holds nowhere by then has collapsed on the way: when is known as well as it has been left behind.
            let left = radius(a) / radius(self.edge);
            if whole <= 0.0 && left > accuracy && may_be_shorter {
                step = shorter(left);
                continue;
            }
            let middle = self.opened(a, now, half, 0.5 * (a - whole));
            let halves = self.opened(middle, half, until, a - middle);
            stride = a - whole;
            let error = if halves > 0.0 { (radius(whole) - radius(halves)).abs() / radius(self.edge) } else { left };
            if error > accuracy && may_be_shorter {
                step = shorter(error);
                continue;
            }
            let next = if halves > 0.0 { (2.0 * halves - whole).clamp(0.0, middle) } else { 0.0 };
            if next >= a {
                break;
            }
            if middle < a && next < middle {
                path.push((middle, half));
            }
            path.push((next, until));
            step = (until - now) * (0.9 * (accuracy / error.max(1e-3 * accuracy)).sqrt()).clamp(0.5, 2.0);
            step = step.min(longest);
            (now, a) = (until, next);
        }
        path
    }

    /// The largest radius not above `a` that holds at the time `until` (implicit in the speed of the edge); it is
    /// looked for about a `stride` [m] away first.
    fn opened(&self, a: f64, now: f64, until: f64, stride: f64) -> f64 {
        let margin = |x: f64| {
            let candidate = self.candidate(Way::Opening, x);
            let way = self.profile.contact_radius(a) - self.profile.contact_radius(x);
            let slope = self.profile.contact_area_slope(x);
            let strength = self.attraction.map_or(0.0, |law| law.strength(slope, way / (until - now)));
            strength - candidate.limit - candidate.urge(self.spectrum, until)
        };
        let near = a - 1.5 * stride;
        if stride > 0.0 && near > 0.0 && margin(a) < 0.0 && margin(near) >= 0.0 {
            return root::within(|x| -margin(x), near, a);
        }
        if a > 0.0 { last_hold(&margin, a).unwrap_or(0.0) } else { 0.0 }
    }
}

/// First step inwards of the search for an edge that holds, and the longest, relative to where it begins.
const FIRST_REACH: f64 = 1e-5;
const LONGEST_REACH: f64 = 1.0 / 64.0;

/// The largest place not above `from` at which the margin of an edge is not negative; `None` if there is none.
///
/// A place is a radius, or the time at which the spring there was touched.
fn last_hold(margin: &dyn Fn(f64) -> f64, from: f64) -> Option<f64> {
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
