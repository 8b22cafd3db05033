//! The edge of the contact on its way through a motion.
//!
//! Springs do not see each other: each joins or leaves when its own limit is reached, at an instant that is the root
//! of one function of time. The edge moves on as long as these instants follow each other; where the next spring's
//! lies in the past the edge jumps, and where the next spring never reaches its limit the edge stands still.

use super::Spectrum;
use super::attraction::Attraction;
use super::spring::{Motion, Spring};
use crate::numerics::{extremum, root};
use crate::shape::Profile;

/// What the edge does next.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum EdgePhase {
    /// It stands still for a time [s].
    Still(f64),
    /// It moves to a radius [m] in a time [s], each spring at the instant of its own limit.
    Moves {
        /// Where it comes to [m].
        to: f64,
        /// How long it takes [s].
        duration: f64,
    },
    /// It moves as the rate law has it: radii [m], falling, and the times [s] at which it is there.
    Creeps(Vec<(f64, f64)>),
    /// It is somewhere else at once [m].
    Jumps(f64),
}

/// Whether springs join or leave.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Way {
    /// They join: the edge moves outwards.
    Closing,
    /// They leave: the edge moves inwards.
    Opening,
}

/// A spring as it is when the motion begins.
pub(super) struct SightedSpring {
    pub spring: Spring,
    /// Height g(x) of the indenter above it [m].
    pub height: f64,
    /// How far its load [N/m] or, if it is free, its displacement [m] may be off.
    pub doubt: f64,
}

/// A spring that may join or leave, as it is when the motion begins.
struct EdgeSpring {
    spring: Spring,
    doubt: f64,
    /// The motion as it sees it.
    seen: Motion,
    /// The lengths [m] of which its displacement is the difference.
    lengths: f64,
    /// Line load [N/m] it withstands, or the distance [m] over which it is drawn.
    limit: f64,
}

/// A bed at the beginning of a motion.
pub(super) struct Front<'b> {
    pub spectrum: &'b Spectrum,
    pub attraction: Option<&'b Attraction>,
    /// The spring at the distance x from the axis, at the edge the one that may go that way.
    pub see: &'b dyn Fn(Way, f64) -> SightedSpring,
    /// The shape of the indenter.
    pub profile: &'b dyn Profile,
    /// Contact radius [m].
    pub edge: f64,
    /// Largest radius there may be [m].
    pub limit: f64,
    /// Radii [m] at which springs of one past end, in ascending order.
    pub borders: &'b [f64],
    /// A radius [m] typical of the indenter.
    pub scale: f64,
    /// Length [m] over which it may rise and fall.
    pub feature: f64,
    /// What is left of the motion.
    pub motion: Motion,
    /// The shortest time the edge stands still [s].
    pub least: f64,
    /// Times between which nothing changes much.
    pub instants: Vec<Instant>,
}

/// A time of a motion, and what the terms of the spectrum have lost until then: the same of all springs.
pub(super) struct Instant {
    /// Time since the beginning of the motion [s].
    time: f64,
    decays: Vec<(f64, f64)>,
}

/// First step of the search for the edge, and the longest, relative to where it is.
const FIRST_STEP: f64 = 1e-5;
const LONGEST_STEP: f64 = 1.0 / 24.0;
/// The longest step inwards under an attraction, relative to the distance from the axis.
const LONGEST_INWARDS: f64 = 0.25;
/// Part of a step at whose end it is seen whether the edge has turned there.
const NEAR_THE_END: f64 = 1.0 / 64.0;
/// Part of a radius that does not count: nearer to the edge no spring is looked at.
const BESIDE: f64 = 8.0 * f64::EPSILON;
/// Rounding of a limit, relative to what it is made of.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// Times between which no spring's load changes much: halved from the end of a motion to well below the shortest
/// time in which a spring changes by itself.
pub(super) fn instants(spectrum: &Spectrum, duration: f64) -> Vec<Instant> {
    let shortest = spectrum.modes().first().map_or(f64::INFINITY, |mode| mode.time).min(spectrum.shortest_time());
    let least = (0.125 * shortest).clamp(1e-18 * duration, 0.25 * duration);
    let mut times = vec![duration, 0.75 * duration];
    while times.last().is_some_and(|&t| t > least) {
        let half = 0.5 * times[times.len() - 2];
        times.push(half);
        times.push(0.75 * half);
    }
    times.pop();
    times.push(0.0);
    times.reverse();
    times.into_iter().map(|time| Instant { time, decays: spectrum.decays(time).collect() }).collect()
}

impl EdgeSpring {
    /// How far beyond its limit the spring is after the time `t`: positive once it has joined or left.
    fn urge(&self, spectrum: &Spectrum, t: f64) -> f64 {
        match &self.spring {
            Spring::Pressed(s) => -spectrum.load_after(self.seen.start, s, self.seen.speed, t) - self.limit,
            Spring::Free(free) => self.seen.depth(t) - spectrum.recovered(free, t) + self.limit,
        }
    }

    /// The same at an instant whose decays are known.
    fn urge_then(&self, spectrum: &Spectrum, at: &Instant) -> f64 {
        match &self.spring {
            Spring::Pressed(s) => {
                let decays = at.decays.iter().copied();
                -spectrum.load_faded((self.seen.start, s, self.seen.speed), at.time, decays) - self.limit
            }
            Spring::Free(_) => self.urge(spectrum, at.time),
        }
    }

    /// How fast it grows at an instant whose decays are known.
    fn rate_then(&self, spectrum: &Spectrum, at: &Instant) -> f64 {
        match &self.spring {
            Spring::Pressed(s) => -spectrum.rate_faded((s, self.seen.speed), at.decays.iter().copied()),
            Spring::Free(_) => self.urge_rate(spectrum, at.time),
        }
    }

    /// How fast that grows.
    fn urge_rate(&self, spectrum: &Spectrum, t: f64) -> f64 {
        match &self.spring {
            Spring::Pressed(s) => -spectrum.load_rate(s, self.seen.speed, t),
            Spring::Free(free) => self.seen.speed - spectrum.recovery_speed(free, t),
        }
    }

    /// What rounding leaves of it, and the doubt about the spring.
    fn rounding(&self, spectrum: &Spectrum) -> f64 {
        self.own_rounding(spectrum) + self.doubt
    }

    /// What rounding leaves of it, the spring taken as it is told.
    fn own_rounding(&self, spectrum: &Spectrum) -> f64 {
        let parts = match &self.spring {
            Spring::Pressed(s) => {
                let steady = spectrum.equilibrium() * self.lengths + (spectrum.viscosity() * self.seen.speed).abs();
                steady + s.iter().map(|s| s.abs()).sum::<f64>()
            }
            Spring::Free(free) => self.lengths + free.rest.abs() + free.modes.iter().map(|z| z.abs()).sum::<f64>(),
        };
        ROUNDING * (parts + self.limit)
    }
}

impl Front<'_> {
    /// What the edge does first in the motion, and which way.
    ///
    /// Where rounding hides whether an edge at its limit moves, it waits for a little more.
    pub(super) fn phase(&self) -> (EdgePhase, Way) {
        for way in [Way::Opening, Way::Closing] {
            if self.wants(way) {
                let phase = self.moves(way);
                if self.gets_on(&phase) {
                    return (phase, way);
                }
            }
        }
        (EdgePhase::Still(self.patience().max(self.least)), Way::Opening)
    }

    /// Whether at the time `t` even the spring at the axis, of a contact that nothing holds, carries no more than
    /// rounding: then it has ended.
    pub(super) fn is_spent(&self, way: Way, t: f64) -> bool {
        let pulls = self.attraction.is_some_and(|attraction| attraction.work() > 0.0);
        way == Way::Opening && !pulls && {
            let axis = self.candidate(way, 0.0);
            axis.urge(self.spectrum, t) >= -axis.own_rounding(self.spectrum)
        }
    }

    /// Whether a phase leads anywhere.
    fn gets_on(&self, phase: &EdgePhase) -> bool {
        let away = |x: f64| (x - self.edge).abs() > 2.0 * BESIDE * self.edge;
        match phase {
            EdgePhase::Still(duration) => *duration > 0.0,
            EdgePhase::Moves { to, .. } | EdgePhase::Jumps(to) => away(*to),
            EdgePhase::Creeps(path) => path.last().is_some_and(|&(to, _)| away(to)),
        }
    }

    /// When the spring at `x`, of those that move, joins or leaves [s]; at the end `last` at the latest.
    pub(super) fn instant(&self, way: Way, x: f64, last: f64) -> f64 {
        self.first(&self.candidate(way, x)).unwrap_or(last).min(last)
    }

    fn candidate(&self, way: Way, x: f64) -> EdgeSpring {
        let SightedSpring { spring, height, doubt } = (self.see)(way, x);
        let seen = Motion { start: self.motion.start - height, ..self.motion };
        let slope = || self.profile.contact_area_slope(x);
        let limit = self.attraction.map_or(0.0, |attraction| match spring {
            Spring::Pressed(_) => attraction.strength(slope(), 0.0),
            Spring::Free(_) => attraction.reach(slope()),
        });
        // A profile steeper than a square feels the rounding of its place more than that of its height.
        let felt = height.max(0.5 * x * self.profile.reduced_slope(x));
        EdgeSpring { spring, doubt, seen, lengths: self.motion.start.abs() + felt, limit }
    }

    /// A place just beyond the edge, on the side of the springs that would move: what is nearer does not count.
    fn beside(&self, way: Way) -> f64 {
        match way {
            Way::Opening => self.edge * (1.0 - BESIDE),
            Way::Closing => self.edge * (1.0 + BESIDE),
        }
    }

    /// Whether the edge moves that way as the motion begins.
    fn wants(&self, way: Way) -> bool {
        let there = match way {
            Way::Opening => self.edge > 0.0,
            Way::Closing => self.edge < self.limit,
        };
        if !there {
            return false;
        }
        let next = self.candidate(way, self.beside(way));
        let (urge, rounding) = (next.urge(self.spectrum, 0.0), next.rounding(self.spectrum));
        if urge.abs() > rounding {
            return urge > 0.0;
        }
        let rate = next.urge_rate(self.spectrum, 0.0);
        // At a limit only just reached: whether it is passed is seen a little later.
        self.draws_at_touch(way, rate)
            || rate > 0.0 && next.urge_then(self.spectrum, &self.instants[1]) > -rounding
            || next.urge_then(self.spectrum, &self.instants[1]) > rounding
    }

    /// Whether bodies that just touch, and do not move apart, are drawn together: the springs beside the first one are
    /// within reach. Of a lying body those next to it carry and reach nothing that a number can hold.
    fn draws_at_touch(&self, way: Way, rate: f64) -> bool {
        if way != Way::Closing || self.edge > 0.0 || rate < 0.0 {
            return false;
        }
        let first = FIRST_STEP * self.start_length();
        let places = std::iter::successors(Some(first), |x| Some(2.0 * x)).take_while(|&x| x <= self.scale);
        let urges = places.map(|x| {
            let candidate = self.candidate(way, x);
            (candidate.urge(self.spectrum, 0.0), 4.0 * candidate.rounding(self.spectrum))
        });
        let mut told = urges.filter(|(urge, rounding)| urge.abs() > *rounding);
        told.next().is_some_and(|(urge, _)| urge > 0.0)
    }

    /// How long the edge stands still [s].
    fn patience(&self) -> f64 {
        let mut wait = self.motion.duration;
        let ways = [(Way::Opening, self.edge > 0.0), (Way::Closing, self.edge < self.limit)];
        for (way, _) in ways.into_iter().filter(|(_, there)| *there) {
            let next = self.candidate(way, self.beside(way));
            let now = next.urge(self.spectrum, 0.0).max(0.0);
            let passes = |rounding: f64| self.crossing(&next, now + rounding + f64::MIN_POSITIVE);
            // A doubt fades with the loads it is about: where it hides the limit, there is more to see later.
            let at = passes(next.rounding(self.spectrum)).or_else(|| passes(next.own_rounding(self.spectrum)));
            wait = at.map_or(wait, |at| wait.min(at));
        }
        wait
    }

    /// The first time at which a spring is beyond its limit [s].
    fn first(&self, candidate: &EdgeSpring) -> Option<f64> {
        if candidate.urge(self.spectrum, 0.0) >= 0.0 {
            return Some(0.0);
        }
        self.crossing(candidate, 0.0)
    }

    /// The first time at which the urge of a spring rises through `level` [s].
    fn crossing(&self, candidate: &EdgeSpring, level: f64) -> Option<f64> {
        let urge = |t: f64| candidate.urge(self.spectrum, t) - level;
        let rate = |t: f64| candidate.urge_rate(self.spectrum, t);
        let (mut before, mut rising) = (0.0, rate(0.0) > 0.0);
        for at in &self.instants[1..] {
            let t = at.time;
            if candidate.urge_then(self.spectrum, at) - level >= 0.0 {
                return Some(root::within(urge, before, t));
            }
            let rises = candidate.rate_then(self.spectrum, at) > 0.0;
            if rising && !rises {
                // A top between the two: the limit may be reached there and only there.
                let top = root::brent(rate, before, t).unwrap_or(t);
                if urge(top) >= 0.0 {
                    return Some(root::within(urge, before, top));
                }
            }
            (before, rising) = (t, rises);
        }
        None
    }

    /// The greatest urge of a spring, and when [s].
    fn top(&self, candidate: &EdgeSpring) -> extremum::Peak {
        let urge = |t: f64| candidate.urge(self.spectrum, t);
        let rate = |t: f64| candidate.urge_rate(self.spectrum, t);
        let at = |t: f64| extremum::Peak { place: t, value: urge(t) };
        let (mut best, mut before) = (at(0.0), (0.0, rate(0.0)));
        for instant in &self.instants[1..] {
            let t = instant.time;
            let now = (t, candidate.rate_then(self.spectrum, instant));
            if before.1 > 0.0 && now.1 <= 0.0 {
                best = best.max(at(root::brent(rate, before.0, t).unwrap_or(t)));
            }
            best = best.max(extremum::Peak { place: t, value: candidate.urge_then(self.spectrum, instant) });
            before = now;
        }
        best
    }

    /// The next place of a search that way, `step` further [m]; `None` where there is none.
    ///
    /// Springs of another past have other limits at once: a search stops on both sides of each border.
    fn further(&self, way: Way, x: f64, step: f64) -> Option<f64> {
        let (there, to) = match way {
            Way::Opening => (x > 0.0, (x - step).max(0.0)),
            Way::Closing => (x < self.limit, (x + step).min(self.limit)),
        };
        let ahead = |&border: &f64| match way {
            Way::Opening => border < x && to < border * (1.0 + BESIDE),
            Way::Closing => border > x && to > border * (1.0 - BESIDE),
        };
        // The nearest that way, or none.
        let nearest = match way {
            Way::Opening => self.borders.partition_point(|&border| border < x).checked_sub(1),
            Way::Closing => Some(self.borders.partition_point(|&border| border <= x)),
        };
        let next = nearest.and_then(|k| self.borders.get(k).copied()).filter(ahead);
        let stop = |border: f64| {
            let (near, far) = match way {
                Way::Opening => (border * (1.0 + BESIDE), border * (1.0 - BESIDE)),
                Way::Closing => (border * (1.0 - BESIDE), border * (1.0 + BESIDE)),
            };
            // Where two borders lie side by side, a place may be beside both: it is the one ahead that counts.
            if is_beside(x, border) { far } else { near }
        };
        there.then(|| next.map_or(to, stop))
    }

    /// The border beside which `x` is, if it is beside one.
    fn border_at(&self, x: f64) -> Option<f64> {
        let first = self.borders.partition_point(|&border| border < x && !is_beside(x, border));
        self.borders.get(first).copied().filter(|&border| is_beside(x, border))
    }

    /// Steps of a search: from fine to coarse, and fine again beyond a border; inwards under an attraction too, for the
    /// radius at which a contact collapses may be a small part of the one it had.
    fn longer(&self, way: Way, step: f64, x: f64) -> f64 {
        let first = FIRST_STEP * self.start_length();
        if self.border_at(x).is_some() {
            return first;
        }
        let longest = if self.edge > 0.0 { LONGEST_STEP * self.edge.max(x) } else { 0.5 * x };
        let inwards =
            if way == Way::Opening && self.attraction.is_some() { LONGEST_INWARDS * x } else { f64::INFINITY };
        (1.7 * step).min(longest.min(inwards).max(first)).min(0.25 * self.feature)
    }

    /// A length [m] with which a search from the axis begins.
    fn start_length(&self) -> f64 {
        if self.edge > 0.0 { self.edge } else { 1e-3 * self.scale }
    }

    /// How an edge that wants to move does.
    fn moves(&self, way: Way) -> EdgePhase {
        let from = self.beside(way);
        if way == Way::Opening && self.attraction.is_some_and(Attraction::has_rate) {
            return EdgePhase::Creeps(self.path());
        }
        if self.is_beyond(way, from) {
            return EdgePhase::Jumps(self.landing(way, from));
        }
        let mut step = FIRST_STEP * self.start_length();
        let (mut x, mut before, mut now) = (from, from, 0.0);
        while let Some(next) = self.further(way, x, step) {
            let Some(at) = self.first(&self.candidate(way, next)) else { return self.ends(way, x, next) };
            if now <= 0.0 && self.is_beyond(way, next) {
                return EdgePhase::Jumps(self.landing(way, next));
            }
            if at >= now && self.has_turned(way, (x, next), at) {
                return self.folds(way, x, next);
            }
            if at < now {
                return match self.border_at(x) {
                    Some(to) => EdgePhase::Moves { to, duration: now },
                    None => self.folds(way, before, next),
                };
            }
            (before, x, now) = (x, next, at);
            step = self.longer(way, step, x);
        }
        EdgePhase::Moves { to: x, duration: now }
    }

    /// Whether the edge gets ahead of itself on a step that ends beside a border with the instant `at`: beyond it
    /// springs have another past, which would hide it.
    fn has_turned(&self, way: Way, (x, next): (f64, f64), at: f64) -> bool {
        let earlier = || self.first(&self.candidate(way, next + NEAR_THE_END * (x - next)));
        self.border_at(x).is_none() && self.border_at(next).is_some() && earlier().is_some_and(|earlier| earlier > at)
    }

    /// Whether the spring at `x` is beyond its limit as the motion begins, by more than rounding.
    fn is_beyond(&self, way: Way, x: f64) -> bool {
        let candidate = self.candidate(way, x);
        candidate.urge(self.spectrum, 0.0) > 4.0 * candidate.rounding(self.spectrum)
    }

    /// Where an edge that jumps comes to rest, from `x` on.
    fn landing(&self, way: Way, mut x: f64) -> f64 {
        let urge = |x: f64| self.candidate(way, x).urge(self.spectrum, 0.0);
        let mut step = FIRST_STEP * self.start_length();
        while let Some(next) = self.further(way, x, step) {
            if urge(next) <= 0.0 {
                return root::brent(urge, x.min(next), x.max(next)).unwrap_or(next);
            }
            x = next;
            step = self.longer(way, step, x);
        }
        x
    }

    /// The edge comes to an end between two places: the first has its instant, the other has not.
    fn ends(&self, way: Way, inside: f64, outside: f64) -> EdgePhase {
        let top = |x: f64| self.top(&self.candidate(way, x));
        let missing = |x: f64| -top(x).value;
        let to = match root::brent(missing, inside.min(outside), inside.max(outside)) {
            Ok(to) if missing(inside) < 0.0 => to,
            _ => inside,
        };
        EdgePhase::Moves { to, duration: top(to).place }
    }

    /// The edge gets ahead of itself between two places: it moves to where the instants are latest, or to the first
    /// spring between that has none.
    fn folds(&self, way: Way, before: f64, next: f64) -> EdgePhase {
        let at = |x: f64| self.first(&self.candidate(way, x)).unwrap_or(self.motion.duration);
        let latest = extremum::greatest(at, before.min(next), before.max(next));
        if self.first(&self.candidate(way, latest.place)).is_none() {
            return self.ends(way, before, latest.place);
        }
        EdgePhase::Moves { to: latest.place, duration: latest.value }
    }

    /// The way of an edge that opens by the rate law, until it stands still: radii and times.
    ///
    /// Implicit steps, halves and whole extrapolated, as short as the difference of their contact radii asks for.
    fn path(&self) -> Vec<(f64, f64)> {
        let duration = self.motion.duration;
        let (shortest, accuracy) = (1e-12 * duration, self.attraction.map_or(0.0, Attraction::accuracy));
        let longest = duration * self.attraction.map_or(1.0, Attraction::longest);
        let (mut now, mut a, mut step, mut stride) = (0.0, self.edge, longest, 0.0);
        let mut path = vec![(a, 0.0)];
        while now < duration && a > 0.0 {
            let until = if duration - now <= 1.01 * step { duration } else { now + step };
            let half = 0.5 * (now + until);
            let whole = self.opened(a, now, until, stride);
            let middle = self.opened(a, now, half, 0.5 * (a - whole));
            let halves = self.opened(middle, half, until, a - middle);
            stride = a - whole;
            let radius = |place: f64| self.profile.contact_radius(place);
            // An edge that holds nowhere by then has collapsed on the way: when is known as well as it has been left behind.
            let apart = if halves > 0.0 { (radius(whole) - radius(halves)).abs() } else { radius(a) };
            let error = apart / radius(self.edge);
            if error > accuracy && until - now > shortest {
                step = (until - now) * (0.9 * (accuracy / error).sqrt()).clamp(0.1, 0.5);
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

/// Whether a place is beside a border.
fn is_beside(x: f64, border: f64) -> bool {
    (x - border).abs() <= 1.5 * BESIDE * border
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

#[cfg(test)]
mod tests {
    use super::super::laws::unit_ball;
    use super::*;
    use crate::material::Relaxation;

    /// Borders within the rounding of each other, three of them beside the edge itself: a search gets past them all, each
    /// place of it beyond the last one.
    #[test]
    fn a_search_gets_past_borders_side_by_side() {
        let spectrum = Spectrum::new(&Relaxation { equilibrium: 1.0, terms: vec![(1.0, 1.0)], viscosity: 0.0 });
        let see = |_: Way, _: f64| SightedSpring { spring: Spring::untouched(&spectrum), height: 0.0, doubt: 0.0 };
        let profile = unit_ball();
        for ulps in 0..40 {
            let apart = 1.0 + f64::EPSILON * f64::from(ulps);
            let borders = [0.5 / apart, 0.5, 0.5 * apart, 1.0, apart, apart * apart];
            let front = Front {
                spectrum: &spectrum,
                attraction: None,
                see: &see,
                profile: &profile,
                edge: 0.5,
                limit: 2.0,
                borders: &borders,
                scale: 1.0,
                feature: f64::INFINITY,
                motion: Motion { start: 0.0, speed: 1.0, duration: 1.0 },
                least: 0.0,
                instants: instants(&spectrum, 1.0),
            };
            for (way, sign, mut x) in [(Way::Closing, 1.0, 0.4), (Way::Opening, -1.0, 1.1)] {
                let mut places = 0;
                while let Some(next) = front.further(way, x, 0.05) {
                    assert!(sign * (next - x) > 0.0 && places < 60, "{ulps} {way:?}: {x:e} {next:e}");
                    (x, places) = (next, places + 1);
                }
            }
        }
    }
}
