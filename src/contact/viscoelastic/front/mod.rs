//! The edge of the contact on its way through a motion.
//!
//! Springs do not see each other: each joins or leaves when its own limit is reached, at an instant that is the root
//! of one function of time. The edge moves on as long as these instants follow each other; where the next spring's
//! lies in the past the edge jumps, and where the next spring never reaches its limit the edge stands still.

mod rate;
mod search;
mod spring;

use spring::EdgeSpring;
pub(super) use spring::{Instant, instants};

use super::Spectrum;
use super::attraction::Attraction;
use super::spring::{Motion, Spring};
use crate::numerics::root;
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
        /// Radii [m] on the way, and when it is there [s].
        passed: Vec<(f64, f64)>,
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

/// A bed at the beginning of a motion.
pub(super) struct Front<'b> {
    pub spectrum: &'b Spectrum,
    pub attraction: Option<&'b Attraction>,
    /// The spring at the distance x from the axis, at the edge the one that may go that way.
    pub see: &'b dyn Fn(Way, f64) -> SightedSpring,
    /// Whether it has been asked for springs that are not known: then what comes out is of no use.
    pub fails: &'b dyn Fn() -> bool,
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
    /// Part of the motion to which it is told when an edge that obeys a rate law collapses.
    pub instantly: f64,
    /// Times between which nothing changes much.
    pub instants: Vec<Instant>,
}

/// Part of a step at whose end it is seen whether the edge has turned there.
const NEAR_THE_END: f64 = 1.0 / 64.0;
/// Part of what rounding may be that hides a gap.
const HIDDEN: f64 = 0.5;
/// Parts of the rounding of a limit by which a spring is surely beyond it.
const BEYOND: f64 = 4.0;
/// Part of a radius that does not count: nearer to the edge no spring is looked at.
const BESIDE: f64 = 8.0 * f64::EPSILON;

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

    /// When the spring at `x`, of those that move, joins or leaves [s]; at the end `last` at the latest, and on a way that has
    /// `passed` its neighbours after the one and before the other.
    pub(super) fn instant(&self, way: Way, x: f64, (last, passed): (f64, &[(f64, f64)])) -> f64 {
        let candidate = self.candidate(way, x);
        let next = passed.partition_point(|&(place, _)| if way == Way::Closing { place < x } else { place > x });
        let between = next.checked_sub(1).and_then(|before| Some((passed[before].1, passed.get(next)?.1)));
        let urge = |t: f64| candidate.urge(self.spectrum, t);
        let within = between.filter(|&(early, late)| early < late && urge(early) < 0.0 && urge(late) >= 0.0);
        let first = || self.first(&candidate).unwrap_or(last);
        within.map_or_else(first, |(early, late)| root::within(urge, early, late)).min(last)
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
        let rate = next.urge_rate(self.spectrum, 0.0);
        // What falls again may be what the polynomials miss of the spring: only one that is beyond its limit goes.
        if urge > rounding && (rate >= 0.0 || urge > BEYOND * rounding) {
            return true;
        }
        // An edge that waited would be past a limit that is reached within the shortest wait.
        if urge + rate.max(0.0) * self.least < -rounding {
            return false;
        }
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
        let first = self.first_step();
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
            // A surface that comes up to where nothing touches yet never quite does: it touches once rounding hides the gap.
            let comes_up = way == Way::Closing && self.edge <= 0.0 && self.attraction.is_some();
            let at = at.or_else(|| self.crossing(&next, -HIDDEN * next.rounding(self.spectrum)).filter(|_| comes_up));
            wait = at.map_or(wait, |at| wait.min(at));
        }
        wait
    }

    /// How an edge that wants to move does.
    fn moves(&self, way: Way) -> EdgePhase {
        let mut on_the_way = vec![(self.edge, 0.0)];
        let mut phase = self.goes(way, &mut on_the_way);
        if let EdgePhase::Moves { to, duration, passed } = &mut phase {
            on_the_way.retain(|&(_, at)| at < *duration);
            on_the_way.push((*to, *duration));
            *passed = on_the_way;
        }
        phase
    }

    fn goes(&self, way: Way, passed: &mut Vec<(f64, f64)>) -> EdgePhase {
        let from = self.beside(way);
        if way == Way::Opening && self.attraction.is_some_and(Attraction::has_rate) {
            return EdgePhase::Creeps(self.path());
        }
        if self.is_beyond(way, from) {
            return EdgePhase::Jumps(self.landing(way, from));
        }
        let mut step = self.first_step();
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
                    Some(to) => EdgePhase::Moves { to, duration: now, passed: Vec::new() },
                    None => self.folds(way, before, next),
                };
            }
            passed.push((next, at));
            (before, x, now) = (x, next, at);
            step = self.longer(way, step, x);
        }
        EdgePhase::Moves { to: x, duration: now, passed: Vec::new() }
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
        candidate.urge(self.spectrum, 0.0) > BEYOND * candidate.rounding(self.spectrum)
    }
}
