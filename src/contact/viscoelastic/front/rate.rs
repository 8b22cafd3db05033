//! An edge that opens as its rate law has it.

use super::super::attraction::Attraction;
use super::{Front, Instant, Way};
use crate::numerics::{extremum, root};

/// Part of the accuracy that a step may miss: before a collapse what has been missed grows.
const OF_ACCURACY: f64 = 0.25;
/// Part of the error of a step that its roots may be off.
const UNFELT: f64 = 1e-3;
/// Part of the time to a collapse that a step goes.
const SHORT_OF: f64 = 0.5;

/// A step of an edge that opens.
struct OpeningStep {
    /// Where it ends [m].
    to: f64,
    /// Where the edge is on the way [m], at parts of the step.
    between: Vec<(f64, f64)>,
    /// How far the contact radius may be off, as a part of that of the edge from which the motion began.
    error: f64,
}

/// How long the steps of an edge that opens are [s].
struct Pace {
    accuracy: f64,
    /// The shortest and the longest.
    limits: (f64, f64),
    wanted: f64,
    /// The step before, and whether the one after it was too long.
    before: Option<f64>,
    refused: bool,
    /// A time by which a step has found that the edge holds nowhere.
    collapsed: f64,
}

impl Pace {
    fn new(accuracy: f64, limits: (f64, f64)) -> Self {
        Self { accuracy, limits, wanted: limits.1, before: None, refused: false, collapsed: f64::INFINITY }
    }

    /// The next step from the time `now`: not up to a collapse.
    fn next(&self, now: f64) -> f64 {
        self.wanted.min((SHORT_OF * (self.collapsed - now)).max(self.limits.0))
    }

    /// Part of a step of that error which has the one allowed: the error of steps of the third order goes with their cube.
    fn allowed(&self, error: f64) -> f64 {
        0.9 * (self.accuracy / error.max(1e-3 * self.accuracy)).cbrt()
    }

    /// A step that was too long.
    fn refuse(&mut self, step: f64, error: f64) {
        (self.wanted, self.refused) = (step * self.allowed(error).clamp(0.1, 0.8), true);
    }

    /// A step that was made. On the way to a collapse steps get shorter and shorter.
    fn accept(&mut self, step: f64, error: f64) {
        let shrinks = self.before.map_or(1.0, |before| (step / before).min(1.0));
        let most = if self.refused { 1.0 } else { 3.0 };
        let wanted = step * (shrinks * self.allowed(error)).clamp(0.5, most);
        self.wanted = wanted.max(self.limits.0).min(self.limits.1);
        (self.before, self.refused) = (Some(step), false);
        if self.wanted > step {
            self.collapsed = f64::INFINITY;
        }
    }
}

impl Front<'_> {
    /// The way of an edge that opens by the rate law, until it stands still: radii and times.
    ///
    /// Extrapolated implicit steps, as short as their error asks for, but no shorter than tells when an edge that holds nowhere
    /// any more has collapsed.
    pub(super) fn path(&self) -> Vec<(f64, f64)> {
        let duration = self.motion.duration;
        let accuracy = OF_ACCURACY * self.attraction.map_or(0.0, Attraction::accuracy);
        let shortest = self.instantly * duration;
        let longest = duration * self.attraction.map_or(1.0, Attraction::longest);
        let mut pace = Pace::new(accuracy, (shortest, longest));
        let (mut now, mut a, mut stride) = (0.0, self.edge, 0.0);
        let mut path = vec![(a, 0.0)];
        while now < duration && a > 0.0 && !(self.fails)() {
            let step = pace.next(now);
            let until = if duration - now <= 1.01 * step { duration } else { now + step };
            let may_be_shorter = until - now > 2.0 * shortest;
            let whole = self.opened(a, now, until, stride);
            // An edge that holds nowhere by then has collapsed on the way: when is known as well as it has been left behind.
            let left = self.profile.contact_radius(a) / self.profile.contact_radius(self.edge);
            if whole <= 0.0 && left > accuracy && may_be_shorter {
                pace.collapsed = until;
                continue;
            }
            let made = self.extrapolated(a, (now, until), (whole, accuracy));
            let error = made.as_ref().map_or(left, |made| made.error);
            stride = a - whole;
            if error > accuracy && may_be_shorter {
                pace.refuse(until - now, error);
                continue;
            }
            let next = made.as_ref().map_or(0.0, |made| made.to);
            if next >= a {
                break;
            }
            for (part, at) in made.iter().flat_map(|made| made.between.iter().copied()) {
                if next < at && path.last().is_some_and(|&(last, _)| at < last) {
                    path.push((at, now + part * (until - now)));
                }
            }
            path.push((next, until));
            pace.accept(until - now, error);
            (now, a) = (until, next);
        }
        path
    }

    /// A step from the edge `a` that ends at `whole` [m] when made at once: made in two and, where that changes more than it
    /// may, in three parts as well, and extrapolated; `None` where it holds nowhere at its end.
    ///
    /// The error is what the second order changes, or the third, or what the place in the middle is off the cubic through the
    /// others.
    fn extrapolated(&self, a: f64, (now, until): (f64, f64), (whole, allowed): (f64, f64)) -> Option<OpeningStep> {
        let times = |count: u32| (0..=count).map(move |k| now + f64::from(k) / f64::from(count) * (until - now));
        let made_in = |count: u32| {
            let ends: Vec<f64> = times(count).take(count as usize).chain([until]).collect();
            let (mut at, mut stride) = (a, (a - whole) / f64::from(count));
            ends.windows(2)
                .map(|time| {
                    let next = self.opened(at, time[0], time[1], stride);
                    (at, stride) = (next, at - next);
                    next
                })
                .collect::<Vec<f64>>()
        };
        let radius = |place: f64| self.profile.contact_radius(place.max(0.0));
        let apart = |one: f64, two: f64| (radius(one) - radius(two)).abs() / radius(self.edge);
        let halves = made_in(2);
        // On the way implicit steps err by what they do at the end, as far as they have come.
        let (second, off) = (2.0 * halves[1] - whole, 2.0 * (halves[1] - whole));
        let middle = halves[0] + off / 4.0;
        let error = apart(halves[1], whole);
        if second > 0.0 && error <= allowed {
            return Some(OpeningStep { to: second, between: vec![(0.5, middle)], error });
        }
        let thirds = made_in(3);
        let better = 3.0 * thirds[2] - 2.0 * halves[1];
        let to = better + 0.5 * (better - second);
        if thirds[2] <= 0.0 || to <= 0.0 {
            return None;
        }
        let (early, late) = (thirds[0] + off / 9.0, thirds[1] + 2.0 * off / 9.0);
        let cubic = (9.0 * (early + late) - a - to) / 16.0;
        let between = vec![(1.0 / 3.0, early), (0.5, middle), (2.0 / 3.0, late)];
        Some(OpeningStep { to, between, error: apart(to, better).max(apart(middle, cubic)) })
    }

    /// Part of a radius that an extrapolated step does not feel.
    fn exact_enough(&self) -> f64 {
        UNFELT * self.attraction.map_or(0.0, Attraction::accuracy)
    }

    /// The largest radius not above `a` that holds at the time `until` (implicit in the speed of the edge); it is
    /// looked for about a `stride` [m] away first.
    fn opened(&self, a: f64, now: f64, until: f64, stride: f64) -> f64 {
        let at = Instant::at(self.spectrum, until);
        let margin = |x: f64| {
            let candidate = self.candidate(Way::Opening, x);
            let way = self.profile.contact_radius(a) - self.profile.contact_radius(x);
            let slope = self.profile.contact_area_slope(x);
            let strength = self.attraction.map_or(0.0, |law| law.strength(slope, way / (until - now)));
            strength - candidate.limit - candidate.urge_then(self.spectrum, &at)
        };
        let near = a - 1.5 * stride;
        if stride > 0.0 && near > 0.0 {
            let ends = [(near, margin(near)), (a, margin(a))];
            if ends[1].1 < 0.0 && ends[0].1 >= 0.0 {
                return root::brent_from(margin, ends, self.exact_enough()).unwrap_or(near);
            }
        }
        if a > 0.0 { last_hold(&margin, a, 1.5 * stride, self.exact_enough()).unwrap_or(0.0) } else { 0.0 }
    }
}

/// First step inwards of the search for an edge that holds, and the longest, relative to where it begins.
const FIRST_REACH: f64 = 1e-5;
const LONGEST_REACH: f64 = 1.0 / 64.0;

/// The largest place not above `from` at which the margin of an edge is not negative; `None` if there is none.
///
/// A place is a radius, or the time at which the spring there was touched.
fn last_hold(margin: &dyn Fn(f64) -> f64, from: f64, reach: f64, exact: f64) -> Option<f64> {
    let here = margin(from);
    if here >= 0.0 {
        return Some(from);
    }
    let (mut outer, mut beyond, mut reach) = (from, here, reach.clamp(FIRST_REACH * from, LONGEST_REACH * from));
    let (mut best, mut around) = (here, (from, from));
    while outer > 0.0 {
        let inner = (outer - reach).max(0.0);
        let found = margin(inner);
        if found >= 0.0 && inner > 0.0 {
            return Some(root::brent_from(margin, [(inner, found), (outer, beyond)], exact).unwrap_or(inner));
        }
        if found > best {
            (best, around) = (found, (inner, outer));
        }
        (outer, beyond, reach) = (inner, found, (1.5 * reach).min(LONGEST_REACH * from));
    }
    // Just before the edge gives way, the stretch that holds is narrower than any step.
    let low = around.0 - (around.1 - around.0).max(FIRST_REACH * from);
    let holds = extremum::reaches_zero(margin, low, around.1)?;
    let ends = [holds, around.1].map(|x| (x, margin(x)));
    Some(root::brent_from(margin, ends, exact).unwrap_or(holds))
}
