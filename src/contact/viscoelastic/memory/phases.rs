//! The phases of a motion, one after the other: what the edge does, and what becomes of the springs it passes.

use super::Memory;
use crate::contact::error::BedError;
use crate::contact::viscoelastic::alike::Alike;
use crate::contact::viscoelastic::front::{EdgePhase, Front, SightedSpring, Way, instants};
use crate::contact::viscoelastic::panel::{Grain, Lived, Panel, panels};
use crate::contact::viscoelastic::spring::{Motion, Piece, Spring};
use crate::numerics::monotone::{FEWEST, Interpolant};
use crate::shape::Rim;

/// What polynomials may miss of the springs where nothing else errs, relative to their loads.
const SMOOTH: f64 = 1e-14;

/// Part of a motion below which an edge that moves gets nowhere: then there may be rounding alone, and the longer it
/// stands still the sooner there is more.
const PROGRESS: f64 = 1e-4;

/// Part of a motion to which it is told when an edge that obeys a rate law collapses; of the accuracy, where a look asks only
/// whether it does.
const INSTANTLY: f64 = 1e-12;
const SOON: f64 = 1e-2;

/// Phases that get nowhere before the edge stands still for a while.
const MOST_STALLS: u32 = 256;

/// Panels beside the edge whose corners are kept.
const BEHIND: usize = 3;

/// What is left of a motion on the way through it.
pub(super) struct Walk {
    pub rest: Motion,
    /// How long all of it lasts [s].
    whole: f64,
    /// Phases that got nowhere.
    stalls: u32,
    /// The shortest time the edge may stand still [s]: below it there is only rounding.
    shortest: f64,
    /// The same now: longer each time that nothing has happened.
    least: f64,
    /// When the last spring of a contact that nothing holds has left [s], if that was in the last phase.
    pub ended: Option<f64>,
}

impl Walk {
    pub fn new(motion: Motion) -> Self {
        let shortest = 1e-15 * motion.duration;
        Self { rest: motion, whole: motion.duration, stalls: 0, shortest, least: shortest, ended: None }
    }
}

/// What happens first in a motion.
struct PhaseStep {
    duration: f64,
    change: Option<Change>,
    /// When the last spring leaves [s], if nothing holds the bodies.
    ended: Option<f64>,
}

/// Springs between two radii [m] that join or leave, as they are afterwards, and the work [J] done on them meanwhile.
struct Change {
    inner: f64,
    outer: f64,
    panels: Vec<Panel>,
    work: f64,
}

/// An edge that moves inwards along a path of falling radii [m] and times [s].
struct Opening {
    /// Time left [s] over the radius.
    left: Option<Interpolant>,
    path: [(f64, f64); 2],
}

impl Opening {
    fn new(path: &[(f64, f64)]) -> Self {
        let ends = [path.first(), path.last()].map(|end| end.copied().unwrap_or((0.0, 0.0)));
        let rising = || path.iter().rev();
        let of_three = || {
            Interpolant::new(rising().map(|knot| knot.0).collect(), rising().map(|knot| ends[1].1 - knot.1).collect())
        };
        Self { left: (path.len() >= FEWEST).then(of_three), path: ends }
    }

    /// When it is at the radius `x` [s].
    fn instant(&self, x: f64) -> f64 {
        let [(far, early), (near, late)] = self.path;
        let x = x.clamp(near, far);
        match &self.left {
            Some(left) => (late - left.height(x)).clamp(early, late),
            None if far > near => early + (far - x) / (far - near) * (late - early),
            None => late,
        }
    }
}

impl Memory {
    /// The first phase of what is left of a motion.
    pub(super) fn phase(&mut self, walk: &mut Walk) -> Result<(), BedError> {
        let motion = walk.rest;
        let step = if walk.stalls < MOST_STALLS {
            self.next(&motion, walk.least)?
        } else {
            walk.stalls -= 1;
            PhaseStep { duration: walk.least.min(motion.duration), change: None, ended: None }
        };
        if step.change.is_none() {
            walk.least *= 4.0;
        } else if step.duration > PROGRESS * walk.whole {
            (walk.least, walk.stalls) = (walk.shortest, 0);
        } else {
            walk.stalls += 1;
        }
        walk.ended = step.ended.map(|time| walk.whole - motion.duration + time);
        self.take(&motion.lasting(step.duration), step.change);
        self.depth = motion.depth(step.duration);
        walk.rest = motion.after(step.duration);
        Ok(())
    }

    /// What happens first in a motion.
    fn next(&self, motion: &Motion, least: f64) -> Result<PhaseStep, BedError> {
        let see = |way: Way, x: f64| self.seen(way, x);
        let fails = || self.fails();
        let borders = self.borders();
        let front = self.front(motion, least, &borders, (&see, &fails));
        let (phase, way) = front.phase();
        let mut ended = None;
        let (duration, change) = match phase {
            EdgePhase::Still(duration) => (duration, None),
            EdgePhase::Moves { to, duration, passed } => {
                let at = |x: f64| front.instant(way, x, (duration, &passed));
                ended = front.is_spent(way, duration).then(|| at(0.0));
                let to = if ended.is_some() { 0.0 } else { to };
                if way == Way::Closing && to >= front.limit && matches!(self.profile.rim(), Rim::End(_)) {
                    return Err(BedError::BeyondProfile { indentation: motion.depth(duration) });
                }
                (duration, Some(self.change(way, to, &motion.lasting(duration), &at)))
            }
            EdgePhase::Creeps(path) => {
                let &(to, duration) = path.last().unwrap_or(&(front.edge, 0.0));
                let way_in = Opening::new(&path);
                (duration, Some(self.change(way, to, &motion.lasting(duration), &|x| way_in.instant(x))))
            }
            EdgePhase::Jumps(to) => (0.0, Some(self.change(way, to, &motion.lasting(0.0), &|_| 0.0))),
        };
        Ok(PhaseStep { duration, change, ended })
    }

    /// Radii [m] at which springs of one past end.
    fn borders(&self) -> Vec<f64> {
        let ends = |k: usize| self.panels.get(k + 1).is_none_or(|next| !self.panels[k].goes_on_in(next));
        (0..self.panels.len()).filter(|&k| ends(k)).map(|k| self.panels[k].outer).collect()
    }

    fn front<'b>(
        &'b self,
        motion: &Motion,
        least: f64,
        borders: &'b [f64],
        (see, fails): (&'b dyn Fn(Way, f64) -> SightedSpring, &'b dyn Fn() -> bool),
    ) -> Front<'b> {
        Front {
            spectrum: &self.spectrum,
            attraction: self.attraction.as_ref(),
            profile: self.profile.as_ref(),
            see,
            fails,
            edge: self.radius(),
            limit: match self.profile.rim() {
                Rim::None => f64::MAX,
                Rim::Wall(end) | Rim::End(end) => end,
            },
            borders,
            scale: self.profile.scale(),
            feature: self.profile.feature().unwrap_or(f64::INFINITY),
            motion: *motion,
            least: least.min(motion.duration),
            instantly: self.instantly(),
            instants: instants(&self.spectrum, motion.duration),
        }
    }

    /// Part of a motion to which it is told when an edge that obeys a rate law collapses.
    fn instantly(&self) -> f64 {
        let of_look = self.attraction.as_ref().filter(|_| !self.counts).map(|attraction| SOON * attraction.accuracy());
        of_look.map_or(INSTANTLY, |part| part.max(INSTANTLY))
    }

    /// The springs between the edge and the radius `to` at the end of a motion in which they join or leave, each at
    /// its `instant`.
    fn change(&self, way: Way, to: f64, motion: &Motion, instant: &dyn Fn(f64) -> f64) -> Change {
        let edge = self.radius();
        let (inner, outer) = (edge.min(to), edge.max(to));
        let lived = |x: f64| self.lived(way, x, motion, instant(x));
        let Some(sight) = self.sight.as_ref().filter(|_| way == Way::Opening) else {
            return self.changed(way, (inner, outer), motion, &lived);
        };
        // Of springs let go a look asks for those beside the edge at most.
        let told = (inner + sight.beside_edge * outer).min(outer);
        let mut change = if told > inner {
            self.changed(way, (inner, told), motion, &lived)
        } else {
            Change { inner, outer, panels: Vec::new(), work: 0.0 }
        };
        if told < outer {
            change.panels.push(Panel::unknown(&self.spectrum, told, outer));
        }
        Change { outer, ..change }
    }

    /// Lets all springs go at once, where they are: no work is done.
    pub(super) fn let_go(&mut self) {
        if self.held == 0 {
            return;
        }
        let motion = Motion { start: self.depth, speed: 0.0, duration: 0.0 };
        let freed = |x: f64| Lived { spring: self.freed(x), impulse: 0.0 };
        let change = self.changed(Way::Opening, (0.0, self.radius()), &motion, &freed);
        self.take(&motion, Some(change));
    }

    /// The spring held at `x` let go at once: it gives by q/E(0), its elements with it, and behind a dashpot not at all.
    fn freed(&self, x: f64) -> Spring {
        let (spectrum, u) = (&self.spectrum, self.depth - self.profile.reduced(x));
        let Spring::Pressed(mut s) = self.spring_on(Way::Opening, x) else { return Spring::untouched(spectrum) };
        let back = spectrum.load(u, &s, 0.0) * spectrum.glass_compliance();
        s.iter_mut().zip(spectrum.terms()).for_each(|(s, term)| *s -= term.modulus * back);
        Spring::Free(spectrum.let_go(u - back, &s))
    }

    /// The springs between two radii, as `lived` tells them after a motion in which they join or leave.
    fn changed(&self, way: Way, (inner, outer): (f64, f64), motion: &Motion, lived: &dyn Fn(f64) -> Lived) -> Change {
        let own = self.panels.iter().map(|panel| panel.outer).chain(self.profile.breaks(outer));
        let mut borders: Vec<f64> = own.filter(|&x| inner < x && x < outer).chain([inner, outer]).collect();
        borders.sort_by(f64::total_cmp);
        borders.dedup();
        let lengths = motion.start.abs().max(motion.end().abs()) + self.profile.reduced(outer);
        let (scale, most) = match way {
            Way::Closing => (self.spectrum.equilibrium() * lengths, self.spectrum.instantaneous() * lengths),
            Way::Opening => (lengths, lengths),
        };
        // Beside the work so far a piece of no length or speed has none.
        let impulse = if motion.speed.abs() > 0.0 { (self.work / motion.speed).abs() } else { f64::MAX };
        let grain = Grain { scale, impulse, tolerance: self.tolerance(), floor: 2.0 * f64::EPSILON * most };
        let (mut panels, work) = panels(&self.spectrum, &borders, motion.speed, grain, lived);
        for panel in &mut panels {
            panel.past = self.pasts + borders.partition_point(|&border| border <= panel.inner) as u64;
        }
        Change { inner, outer, panels, work }
    }

    /// What the polynomials of the panels may miss: no more than the way of an edge that obeys a rate law.
    fn tolerance(&self) -> f64 {
        let followed = self.attraction.as_ref().filter(|attraction| attraction.has_rate());
        followed.map_or(SMOOTH, |attraction| SMOOTH.max(0.1 * attraction.accuracy()))
    }

    /// The spring at `x` after a motion in which it joins or leaves at the time `at`.
    fn lived(&self, way: Way, x: f64, motion: &Motion, at: f64) -> Lived {
        let (spectrum, height) = (&self.spectrum, self.profile.reduced(x));
        let seen = Motion { start: motion.start - height, ..*motion };
        let (u, rest) = (seen.depth(at), motion.duration - at);
        let mut impulse = 0.0;
        let mut pressed = |u: f64, s: &mut [f64], duration: f64| {
            if self.counts {
                impulse = spectrum.impulse(&Piece::Pressed { u, s, speed: seen.speed, duration });
            }
            spectrum.press(s, seen.speed, duration);
        };
        let spring = match (way, self.spring_on(way, x)) {
            (Way::Closing, Spring::Free(mut free)) => {
                spectrum.recover(&mut free, at);
                let mut s = vec![0.0; spectrum.terms().len()];
                spectrum.loads_of_free(&free, &mut s);
                if let Some(attraction) = &self.attraction {
                    attraction.moved(spectrum, (spectrum.recovered(&free, 0.0), u), &mut s);
                }
                pressed(u, &mut s, rest);
                Spring::Pressed(s)
            }
            (Way::Opening, Spring::Pressed(mut s)) => {
                pressed(seen.start, &mut s, at);
                let mut free = match &self.attraction {
                    Some(attraction) => {
                        let load = spectrum.load(u, &s, seen.speed);
                        attraction.let_go(spectrum, u, (load, self.profile.contact_area_slope(x)), &mut s)
                    }
                    None => spectrum.let_go(u, &s),
                };
                spectrum.recover(&mut free, rest);
                Spring::Free(free)
            }
            (_, spring) => spring,
        };
        Lived { spring, impulse }
    }

    /// A motion, with what happens to the springs at the edge.
    fn take(&mut self, motion: &Motion, change: Option<Change>) {
        let edge = self.radius();
        let change = change.unwrap_or(Change { inner: edge, outer: edge, panels: Vec::new(), work: 0.0 });
        self.work += change.work + self.steady_work(motion, change.inner);
        let first = self.cut_out(change.inner, change.outer);
        let alike = Alike::new(&self.spectrum, motion.speed, motion.duration);
        for panel in &mut self.panels {
            if self.counts {
                self.work += panel.work(&alike);
            }
            panel.pass(&alike);
        }
        self.pasts = change.panels.iter().map(|panel| panel.past).fold(self.pasts, u64::max);
        let count = change.panels.len();
        self.panels.splice(first..first, change.panels);
        // What a look makes is soon gone.
        if self.counts {
            self.merge(first, first + count);
        }
        self.held = self.panels.iter().take_while(|panel| panel.held).count();
        if self.counts && self.corner > 0.0 {
            self.round_corners(count);
        }
    }

    /// Makes one panel of two whose corner is less than it is known, behind an edge that has made so many panels. Springs at the
    /// edge, which has stopped where they are at their limits, keep theirs.
    fn round_corners(&mut self, made: usize) {
        let behind = self.held.saturating_sub(BEHIND);
        for k in (behind.saturating_sub(made).max(1)..=behind).rev() {
            self.held -= usize::from(self.join(k, self.corner));
        }
        let beyond = self.held + BEHIND;
        for k in (beyond..=(beyond + made).min(self.panels.len())).rev() {
            self.join(k, self.corner);
        }
    }

    /// Makes one panel of the one with that number and the one before where that loses no more than the `tolerance`; whether
    /// it has.
    fn join(&mut self, k: usize, tolerance: f64) -> bool {
        let (Some(one), Some(two)) = (k.checked_sub(1).and_then(|k| self.panels.get(k)), self.panels.get(k)) else {
            return false;
        };
        let joined = one.joined_with(two, &self.spectrum, tolerance);
        let is_joined = joined.is_some();
        if let Some(joined) = joined {
            self.panels.splice(k - 1..=k, [joined]);
        }
        is_joined
    }

    /// Makes one panel of two where that loses nothing, at the borders from `first` to `last`.
    fn merge(&mut self, first: usize, last: usize) {
        for k in (first.max(1)..=last).rev() {
            self.join(k, self.tolerance());
        }
    }

    /// Takes a stretch out of the panels, whose springs are about to change; where it was.
    fn cut_out(&mut self, inner: f64, outer: f64) -> usize {
        let first = self.panels.partition_point(|panel| panel.outer <= inner);
        let last = self.panels.partition_point(|panel| panel.inner < outer).max(first);
        let (spectrum, within) = (&self.spectrum, &self.panels[first..last]);
        let below = within.first().filter(|panel| panel.inner < inner);
        let below = below.map(|panel| panel.part(spectrum, panel.inner, inner));
        let beyond = within.last().filter(|panel| panel.outer > outer);
        let beyond = beyond.map(|panel| panel.part(spectrum, outer, panel.outer));
        let place = first + usize::from(below.is_some());
        self.panels.splice(first..last, below.into_iter().chain(beyond));
        place
    }
}
