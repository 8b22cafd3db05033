//! A rough line on elastic bodies that adhere, patch by patch.
//!
//! The springs that hold form patches of neighbours. The end of a patch of half length l holds up to the elongation
//! Δl = √(2πlw/E*) (Heß's rule; Popov & Heß 2015, ch. 10, for each piece of the contact), and the spring beside it is
//! drawn in at the same one. That is the energy E*Δx Σ ½(g − d)² − w Σ πl² of springs and patches: a spring closes or
//! opens where that costs nothing. So patches meet and become one, and a spring inside of one opens where its own
//! energy pays for the surface that two patches have less than one. The finer the springs the less it can: what is
//! closed then opens from its ends only, as a crack does. Without work nothing is pulled, as on the elastic bed.
//!
//! A spring that closes never makes another open, nor the other way round: what holds at a depth does not depend on the
//! order in which the springs went, nor on the steps.
//!
//! # Examples
//! ```
//! use springbed::contact::model::{ContactModel, Straight};
//! use springbed::contact::rough::{AdhesiveRough, EdgeWorks};
//!
//! // A flat of a hundred springs, E* = 1, L = 1: off at F = −E*LΔl, Δl = √(2πlw/E*), l half its length (Kendall).
//! let mut flat = AdhesiveRough::of_gaps(&[0.0; 100], 0.01, 0.01, EdgeWorks { opening: 1e-4, closing: 1e-4 })?;
//! flat.follow(&Straight::between(0.0, 0.1, 1.0))?;
//! let jumps = flat.follow(&Straight::between(0.1, -1.0, 1.0))?;
//! let pull = -(std::f64::consts::PI * 1e-4).sqrt();
//! assert!((jumps[0].before.force / pull - 1.0).abs() < 0.003 && !flat.joined());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::bed::{RoughBed, number};
use super::ends::within;
use super::ground::{EdgeWorks, Ground, Turn, more};
use super::patches::Patches;
use super::told::Told;
use crate::contact::adhesion::line::Energy;
use crate::contact::error::{ContactError, LineTooShort};
use crate::contact::model::{ContactModel, Effort, Event, Glance, Loading, Pull, Straight};
use crate::contact::state::Normal;
use crate::shape::Profile;
use crate::shape::rough::{RoughError, RoughLine, positive};
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::sync::Arc;

/// A sum whose rounding does not grow with the number of its terms (Neumaier).
#[derive(Debug, Clone, Copy, Default)]
struct Sum {
    high: f64,
    low: f64,
}

impl Sum {
    fn add(&mut self, term: f64) {
        let sum = self.high + term;
        let (large, small) = if self.high.abs() >= term.abs() { (self.high, term) } else { (term, self.high) };
        self.low += (large - sum) + small;
        self.high = sum;
    }

    fn value(&self) -> f64 {
        self.high + self.low
    }
}

/// Number of the springs that hold, and the sums of their gaps [m] and of the squares of these.
#[derive(Debug, Clone, Copy, Default)]
struct Held {
    springs: usize,
    gaps: Sum,
    squares: Sum,
}

/// Where the motion goes.
#[derive(Debug, Clone, Copy)]
enum Goal {
    Depth(f64),
    Force(f64),
}

/// The turns ahead on the way the contact goes.
#[derive(Debug, Clone)]
enum Ahead {
    /// Closings beside patches, and how many springs in the order of their gaps have closed.
    Down(BinaryHeap<Reverse<Turn>>, usize),
    /// The first opening of every patch.
    Up(BinaryHeap<Turn>),
    Unknown,
}

/// A rough line pressed on elastic bodies that adhere; indentation counts from first touch.
#[derive(Debug, Clone)]
pub struct AdhesiveRough {
    ground: Arc<Ground>,
    patches: Patches,
    held: Held,
    ahead: Ahead,
    /// Indentation from first touch [m]; minus infinity after a pull has parted the bodies.
    depth: f64,
    /// Energy of the closed surface [J].
    surface: f64,
    dissipated: f64,
}

impl AdhesiveRough {
    /// A line of `points` springs on the profile `base`, none under a nominally flat surface, over a half-space of the
    /// modulus E* [Pa], just touching.
    ///
    /// # Errors
    /// As of [`RoughBed::under`].
    pub fn new(
        line: &RoughLine,
        points: usize,
        modulus: f64,
        base: Option<&dyn Profile>,
        works: EdgeWorks,
    ) -> Result<Self, RoughError> {
        let gaps = RoughBed::gaps_under(line, points, |x| base.map_or(0.0, |base| base.reduced(x)))?;
        let width = line.length() / number(points);
        let mut contact = Self::of_gaps(&gaps, width, positive("modulus", modulus)? * width, works)?;
        if let (Some(base), Some(ground)) = (base, Arc::get_mut(&mut contact.ground)) {
            ground.within = within(base, line, points);
        }
        Ok(contact)
    }

    /// Springs of a width Δx [m] and a stiffness E*Δx [N/m] under gaps [m] along a line.
    ///
    /// # Errors
    /// No gap that is finite, one that is NaN; a width or a stiffness that is not positive.
    pub fn of_gaps(gaps: &[f64], width: f64, stiffness: f64, works: EdgeWorks) -> Result<Self, RoughError> {
        let ground = Ground::new(gaps, width, stiffness, works)?;
        Ok(Self {
            patches: Patches::new(ground.gaps.len()),
            ground: Arc::new(ground),
            held: Held::default(),
            ahead: Ahead::Unknown,
            depth: 0.0,
            surface: 0.0,
            dissipated: 0.0,
        })
    }

    /// Number of patches.
    #[must_use]
    pub fn patches(&self) -> usize {
        self.patches.all().count()
    }

    /// Depth [m] at which the next spring closes on the way down; infinite where all hold.
    #[must_use]
    pub fn closes_next(&mut self) -> f64 {
        self.next_closing().map_or(f64::INFINITY, |turn| turn.depth.max(self.depth))
    }

    /// Depth [m] at which the next spring opens on the way up; minus infinite where none holds.
    #[must_use]
    pub fn opens_next(&mut self) -> f64 {
        self.next_opening().map_or(f64::NEG_INFINITY, |turn| turn.depth.min(self.depth))
    }

    /// Moves on to where the next springs close, and lets them.
    ///
    /// # Errors
    /// The contact would reach the ends of the line.
    pub fn let_close(&mut self) -> Result<(), ContactError> {
        let depth = self.closes_next();
        if depth.is_finite() {
            self.go_down(Goal::Depth(depth))?;
        }
        Ok(())
    }

    /// Moves back to where the next spring opens, and lets it.
    pub fn let_open(&mut self) {
        if let Some(turn) = self.next_opening() {
            self.depth = turn.depth.min(self.depth);
            self.open(turn);
        }
    }

    /// F = E*Δx Σ (d − g) over the springs that hold [N].
    fn force(&self) -> f64 {
        if self.held.springs == 0 {
            return 0.0;
        }
        self.ground.stiffness * (number(self.held.springs) * self.depth - self.held.gaps.value())
    }

    /// ½E*Δx Σ (d − g)² [J].
    fn elastic(&self) -> f64 {
        if self.held.springs == 0 {
            return 0.0;
        }
        let (springs, gaps) = (number(self.held.springs), self.held.gaps.value());
        let mean = gaps / springs;
        let scatter = (self.held.squares.value() - gaps * mean).max(0.0);
        0.5 * self.ground.stiffness * (springs * (self.depth - mean).powi(2) + scatter)
    }

    /// Energy [J] of a spring that is stretched from its gap to the depth.
    fn strain_energy(&self, spring: usize) -> f64 {
        let stretch = self.ground.gaps[spring] - self.depth;
        0.5 * self.ground.stiffness * stretch * stretch
    }

    /// Lets a spring close.
    fn close(&mut self, spring: usize) -> Result<(), ContactError> {
        if !self.ground.within.contains(&spring) {
            return Err(LineTooShort { indentation: self.depth, length: self.ground.length }.into());
        }
        let given = self.ground.closing * more(self.patches.beside(spring));
        let ends = self.patches.close(spring);
        let gap = self.ground.gaps[spring];
        self.held.springs += 1;
        self.held.gaps.add(gap);
        self.held.squares.add(gap * gap);
        self.surface -= given;
        self.dissipated += given - self.strain_energy(spring);
        self.see_closings(ends);
        Ok(())
    }

    /// Lets a spring open.
    fn open(&mut self, Turn { spring, ends, .. }: Turn) {
        let taken = self.ground.closing * more((spring - ends.0, ends.1 - spring));
        let left = self.patches.open(spring, ends);
        let gap = self.ground.gaps[spring];
        self.held.springs -= 1;
        self.held.gaps.add(-gap);
        self.held.squares.add(-gap * gap);
        self.surface += taken;
        self.dissipated += self.strain_energy(spring) - taken;
        if self.held.springs == 0 {
            (self.held, self.surface) = (Held::default(), 0.0);
        }
        left.into_iter().flatten().for_each(|ends| self.see_opening(ends));
    }

    /// Notes when the springs beside a patch close.
    fn see_closings(&mut self, (first, last): (usize, usize)) {
        let Ahead::Down(turns, _) = &mut self.ahead else { return };
        let behind = (last + 1 < self.ground.gaps.len()).then_some(last + 1);
        for spring in [first.checked_sub(1), behind].into_iter().flatten() {
            let depth = self.ground.closes_at(spring, self.patches.beside(spring));
            if depth.is_finite() {
                turns.push(Reverse(Turn { depth, spring, ends: (spring, spring) }));
            }
        }
    }

    /// Notes when the first spring of a patch opens.
    fn see_opening(&mut self, ends: (usize, usize)) {
        if let Ahead::Up(turns) = &mut self.ahead {
            turns.push(self.ground.first_to_open(ends));
        }
    }

    /// The spring that closes next on the way down, and when.
    fn next_closing(&mut self) -> Option<Turn> {
        if !matches!(self.ahead, Ahead::Down(..)) {
            self.ahead = Ahead::Down(BinaryHeap::new(), 0);
            let patches: Vec<_> = self.patches.all().collect();
            patches.into_iter().for_each(|patch| self.see_closings(patch));
        }
        let Ahead::Down(turns, touched) = &mut self.ahead else { return None };
        let Ground { order, .. } = self.ground.as_ref();
        while order.get(*touched).is_some_and(|&spring| self.patches.holds(spring)) {
            *touched += 1;
        }
        while turns.peek().is_some_and(|Reverse(turn)| self.patches.holds(turn.spring)) {
            turns.pop();
        }
        let alone = order.get(*touched).map(|&spring| Turn {
            depth: self.ground.closes_at(spring, self.patches.beside(spring)),
            spring,
            ends: (spring, spring),
        });
        let beside = turns.peek().map(|Reverse(turn)| *turn);
        alone.into_iter().chain(beside).min()
    }

    /// The spring that opens next on the way up, and when.
    fn next_opening(&mut self) -> Option<Turn> {
        if !matches!(self.ahead, Ahead::Up(_)) {
            self.ahead = Ahead::Up(BinaryHeap::new());
            let patches: Vec<_> = self.patches.all().collect();
            patches.into_iter().for_each(|patch| self.see_opening(patch));
        }
        let Ahead::Up(turns) = &mut self.ahead else { return None };
        while turns.peek().is_some_and(|turn| !self.patches.are_ends(turn.ends)) {
            turns.pop();
        }
        turns.peek().copied()
    }

    /// Depth [m] of the goal while nothing closes or opens; `free` where nothing holds.
    fn depth_of(&self, goal: Goal, free: f64) -> f64 {
        match goal {
            Goal::Depth(depth) => depth,
            Goal::Force(_) if self.held.springs == 0 => free,
            Goal::Force(force) => (force / self.ground.stiffness + self.held.gaps.value()) / number(self.held.springs),
        }
    }

    /// Moves to a depth [m] where nothing closes or opens on the way; what a given force does beyond what the springs
    /// take is lost. `level` is the greatest or least force so far [N].
    fn move_to(&mut self, depth: f64, goal: Goal, level: &mut f64) {
        if let Goal::Force(_) = goal
            && self.held.springs > 0
        {
            let (force, stiffness) = (self.force(), self.ground.stiffness * number(self.held.springs));
            let (way, free) = (depth - self.depth, (*level - force) / stiffness);
            // Until the springs carry the force again, ½k(2·free − way)·way.
            let way = if free.abs() < way.abs() { free } else { way };
            self.dissipated += stiffness * (free - 0.5 * way) * way;
            if free.abs() < (depth - self.depth).abs() {
                *level = force + stiffness * (depth - self.depth);
            }
        }
        self.depth = depth;
    }

    /// Nearer, springs closing on the way.
    fn go_down(&mut self, goal: Goal) -> Result<Told, ContactError> {
        let (mut told, mut level) = (Told::default(), self.force());
        loop {
            let until = self.depth_of(goal, f64::INFINITY).max(self.depth);
            let Some(turn) = self.next_closing().filter(|turn| turn.depth <= until) else {
                told.rest(|| self.state());
                self.move_to(until, goal, &mut level);
                return Ok(told);
            };
            if turn.depth > self.depth {
                told.rest(|| self.state());
                self.move_to(turn.depth, goal, &mut level);
            }
            told.change(|| self.state());
            self.close(turn.spring)?;
        }
    }

    /// Further away, springs opening on the way.
    fn go_up(&mut self, goal: Goal) -> Told {
        let (mut told, mut level) = (Told::default(), self.force());
        loop {
            let until = self.depth_of(goal, f64::NEG_INFINITY).min(self.depth);
            let Some(turn) = self.next_opening().filter(|turn| turn.depth > until) else {
                told.rest(|| self.state());
                self.move_to(until, goal, &mut level);
                return told;
            };
            if turn.depth < self.depth {
                told.rest(|| self.state());
                self.move_to(turn.depth, goal, &mut level);
            }
            told.change(|| self.state());
            self.open(turn);
        }
    }
}

impl ContactModel for AdhesiveRough {
    fn follow(&mut self, piece: &Straight) -> Result<Vec<Event>, ContactError> {
        let (goal, from) = (Goal::Depth(piece.to), self.force());
        let told = if piece.to < self.depth { self.go_up(goal) } else { self.go_down(goal)? };
        Ok(told.by_depth(from.min(self.force())))
    }

    fn look(&mut self, piece: &Straight) -> Result<Glance, ContactError> {
        let mut probe = self.clone();
        probe.follow(piece)?;
        Ok(Glance { force: probe.force(), contact_radius: 0.0 })
    }

    fn state(&self) -> Normal {
        Normal {
            indentation: self.depth.is_finite().then_some(self.depth),
            force: self.force(),
            contact_radius: None,
            stiffness: self.ground.stiffness * number(self.held.springs),
            stored: Energy { elastic: self.elastic(), surface: self.surface },
            dissipated: self.dissipated,
        }
    }

    fn joined(&self) -> bool {
        self.held.springs > 0
    }

    fn loading(&self) -> Option<Box<dyn Loading + '_>> {
        None
    }

    fn copy(&self) -> Box<dyn ContactModel> {
        Box::new(self.clone())
    }

    fn effort(&self) -> Effort {
        let springs = self.ground.gaps.len();
        Effort { springs, bytes: springs * 3 * size_of::<f64>(), force_error: None, radius_error: None }
    }

    fn press(&mut self, pull: &Pull) -> Option<Result<Vec<Event>, ContactError>> {
        if !self.joined() && pull.force < 0.0 {
            return Some(Ok(Vec::new()));
        }
        let goal = Goal::Force(pull.force);
        let told = if pull.force < self.force() { Ok(self.go_up(goal)) } else { self.go_down(goal) };
        Some(told.map(Told::by_force))
    }

    fn last_depth(&self) -> Option<Result<f64, ContactError>> {
        let mut probe = self.clone();
        let parted = probe.go_up(Goal::Depth(-f64::MAX)).parted;
        Some(Ok(parted.and_then(|jump| jump.before.indentation).unwrap_or(self.depth)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::adhesion::line::EdgeLine;
    use crate::contact::direct::QuasiStatic;
    use crate::contact::foundation::Foundation;
    use crate::contact::rough::RoughContact;
    use crate::input::quantity::Length;
    use crate::shape::Paraboloid;
    use crate::shape::rough::{Rings, RoughnessSpectrum};
    use proptest::prelude::*;
    use std::f64::consts::PI;

    fn both(work: f64) -> EdgeWorks {
        EdgeWorks { opening: work, closing: work }
    }

    fn to(contact: &mut AdhesiveRough, depth: f64) -> Vec<Event> {
        let piece = Straight::between(contact.depth, depth, 1.0);
        contact.follow(&piece).unwrap()
    }

    /// A line by brute force: every spring is asked at every turn, and every sum is taken anew.
    struct Asked {
        gaps: Vec<f64>,
        held: Vec<bool>,
        stiffness: f64,
        alone: EdgeWorks,
        depth: f64,
        work: f64,
    }

    impl Asked {
        fn beside(&self, spring: usize) -> (usize, usize) {
            let (before, behind) = (&self.held[..spring], &self.held[spring + 1..]);
            (before.iter().rev().take_while(|held| **held).count(), behind.iter().take_while(|held| **held).count())
        }

        fn force(&self) -> f64 {
            let springs = self.gaps.iter().zip(&self.held).filter(|(_, held)| **held);
            self.stiffness * springs.map(|(gap, _)| self.depth - gap).sum::<f64>()
        }

        fn elastic(&self) -> f64 {
            let springs = self.gaps.iter().zip(&self.held).filter(|(_, held)| **held);
            0.5 * self.stiffness * springs.map(|(gap, _)| (self.depth - gap).powi(2)).sum::<f64>()
        }

        fn surface(&self) -> f64 {
            let patches = self.held.split(|held| !held).map(|patch| number(patch.len()).powi(2));
            -self.alone.closing * patches.sum::<f64>()
        }

        fn reach(&self, alone: f64, (before, behind): (usize, usize)) -> f64 {
            let square = |springs: usize| number(springs * springs);
            (2.0 * alone * (square(before + behind + 1) - square(before) - square(behind)) / self.stiffness).sqrt()
        }

        fn turn(&self, down: bool) -> Option<(f64, usize)> {
            let springs = (0..self.gaps.len()).filter(|&spring| self.held[spring] != down);
            let alone = if down { self.alone.closing } else { self.alone.opening };
            let turns = springs.map(|spring| (self.gaps[spring] - self.reach(alone, self.beside(spring)), spring));
            let order = |a: &(f64, usize), b: &(f64, usize)| a.0.total_cmp(&b.0);
            if down { turns.min_by(order) } else { turns.max_by(order) }
        }

        fn shift(&mut self, to: f64) {
            let (from, force) = (self.depth, self.force());
            self.depth = to;
            self.work += 0.5 * (force + self.force()) * (to - from);
        }

        fn go(&mut self, to: f64) {
            let down = to >= self.depth;
            while let Some((at, spring)) = self.turn(down).filter(|(at, _)| if down { *at <= to } else { *at > to }) {
                let at = if down { at.max(self.depth) } else { at.min(self.depth) };
                self.shift(at);
                self.held[spring] = down;
            }
            self.shift(to);
        }
    }

    fn depths() -> impl Strategy<Value = Vec<f64>> {
        proptest::collection::vec((-400i32..600).prop_map(|k| 0.01 * f64::from(k)), 1..8)
    }

    fn lines() -> impl Strategy<Value = Vec<f64>> {
        proptest::collection::vec((0i32..400).prop_map(|k| 0.01 * f64::from(k)), 1..40)
    }

    /// Parts of 1: the work of closing of that of opening, which is up to 10 times what holds a spring by the scatter
    /// of the gaps.
    fn works() -> impl Strategy<Value = EdgeWorks> {
        (0i32..100, 0i32..=20).prop_map(|(work, part)| {
            let opening = 0.01 * f64::from(work) * f64::from(work);
            EdgeWorks { opening, closing: opening * 0.05 * f64::from(part) }
        })
    }

    proptest! {
        /// Force, energies and losses of any motion, against brute force; rounding of some hundred terms of the size
        /// of the largest force and energy. And nothing lost is found again.
        #[test]
        fn any_motion_is_that_of_the_springs_asked_one_by_one(gaps in lines(), works in works(), depths in depths()) {
            let mut contact = AdhesiveRough::of_gaps(&gaps, 1.0, 2.5, works).unwrap();
            let least = gaps.iter().copied().fold(f64::INFINITY, f64::min);
            let mut asked = Asked {
                gaps: gaps.iter().map(|gap| gap - least).collect(),
                held: vec![false; gaps.len()],
                stiffness: 2.5,
                alone: EdgeWorks { opening: works.opening * 0.25 * PI, closing: works.closing * 0.25 * PI },
                depth: 0.0,
                work: 0.0,
            };
            let (force, energy) = (2.5 * 40.0 * 8.0, 2.5 * 40.0 * 64.0 + PI * works.opening * 1600.0);
            let mut lost = 0.0;
            for depth in depths {
                to(&mut contact, depth);
                asked.go(depth);
                let state = contact.state();
                prop_assert!((state.force - asked.force()).abs() <= 1e-13 * force);
                prop_assert!((state.stored.elastic - asked.elastic()).abs() <= 1e-12 * energy);
                prop_assert!((state.stored.surface - asked.surface()).abs() <= 1e-12 * energy);
                let dissipated = asked.work - asked.elastic() - asked.surface();
                prop_assert!((state.dissipated - dissipated).abs() <= 1e-12 * energy, "{state:?} {dissipated}");
                prop_assert!(state.dissipated >= lost - 1e-14 * energy);
                lost = state.dissipated;
            }
        }

        /// A motion cut into pieces is the same motion; so is one under a force that leads to the same depths.
        #[test]
        fn cutting_a_motion_changes_nothing(gaps in lines(), works in works(), depths in depths(), cuts in 1usize..7) {
            let mut whole = AdhesiveRough::of_gaps(&gaps, 1.0, 2.5, works).unwrap();
            let mut cut = whole.clone();
            for depth in depths {
                let from = cut.depth;
                to(&mut whole, depth);
                for piece in 1..=cuts {
                    to(&mut cut, if piece == cuts { depth } else { from + (depth - from) * number(piece) / number(cuts) });
                }
                prop_assert_eq!(&whole.patches, &cut.patches);
                prop_assert!((whole.force() - cut.force()).abs() <= 0.0);
            }
        }

        /// Under a given force the springs carry it, or the bodies have parted under a pull; nothing is gained:
        /// ∫F dd = stored + lost, with F the load where it rises or falls, and the level of the load while it waits.
        #[test]
        fn a_given_force_is_carried_or_parts_the_bodies(gaps in lines(), works in works(), forces in depths()) {
            let mut contact = AdhesiveRough::of_gaps(&gaps, 1.0, 2.5, works).unwrap();
            let mut lost = 0.0;
            for force in forces {
                let force = 20.0 * force;
                let pull = Pull { force, slide: 0.0, sliding_speed: 0.0, duration: 1.0 };
                contact.press(&pull).unwrap().unwrap();
                let state = contact.state();
                if contact.joined() {
                    prop_assert!((state.force - force).abs() <= 1e-12 * 2.5 * 40.0 * 80.0);
                } else {
                    prop_assert!(force <= 0.0 && state.force == 0.0);
                }
                prop_assert!(state.dissipated >= lost - 1e-12 * 2.5 * 40.0 * 80.0 * 80.0, "{} {lost}", state.dissipated);
                lost = state.dissipated;
            }
        }
    }

    fn smooth(rms: f64) -> RoughLine {
        let spectrum = RoughnessSpectrum::table(&[(6.4, rms * rms), (64.0, 1e-3 * rms * rms)]).unwrap();
        RoughLine::new(&Rings::of(&spectrum, 1.0, 400).unwrap(), 7)
    }

    /// Without work it is the elastic bed, up and down.
    #[test]
    fn without_work_it_is_the_elastic_bed() {
        let line = smooth(1e-6);
        let mut adhesive = AdhesiveRough::new(&line, 1000, 2.5, None, both(0.0)).unwrap();
        let mut elastic = RoughContact::new(&line, 1000, 2.5, None).unwrap();
        let heights = elastic.bed().heights();
        let full = elastic.bed().at_indentation(elastic.bed().full_contact().0);
        for part in [0.3, 1.0, 0.7, 0.1, 0.0, 0.5, 1.2] {
            let depth = part * heights[600];
            to(&mut adhesive, depth);
            elastic.follow(&Straight::between(0.0, depth, 1.0)).unwrap();
            let (one, other) = (adhesive.state(), elastic.state());
            assert!((one.force - other.force).abs() <= 1e-12 * full.force, "{part}");
            assert!((one.stored.elastic - other.stored.elastic).abs() <= 1e-12 * full.energy, "{part}");
            assert!(one.dissipated.abs() <= 1e-12 * full.energy, "{part}");
        }
    }

    /// Roughness that vanishes leaves the ball of Johnson, Kendall & Roberts: pull-off, force on the way in and out
    /// and losses, first order in the width of a spring.
    #[test]
    fn vanishing_roughness_is_the_adhesive_ball() {
        let (radius, work) = (2.0, 1e-4);
        let ball = Paraboloid { radius: Length::new(radius).unwrap() };
        let off = |points: usize| {
            let ground = Foundation::new(Arc::new(ball.clone()), 1.0);
            let mut exact = QuasiStatic::new(EdgeLine::new(ground, work));
            let mut line = AdhesiveRough::new(&smooth(1e-30), points, 1.0, Some(&ball), both(work)).unwrap();
            let pull = 1.5 * PI * work * radius;
            let mut worst: f64 = 0.0;
            for depth in [2e-3, 1e-3, 1.5e-2, 2e-3, -1e-3, -2e-3] {
                let jumps = to(&mut line, depth);
                exact.indent(depth).unwrap();
                let force = exact.present().balance.force;
                worst = worst.max((line.force() - force).abs() / pull);
                if depth < -1.5e-3 {
                    let least = jumps.iter().map(|jump| jump.before.force).fold(0.0, f64::min);
                    worst = worst.max((least / pull + 1.0).abs());
                }
                worst = worst.max((line.dissipated - exact.dissipated()).abs() / (pull * 1e-2));
            }
            worst
        };
        let (coarse, fine) = (off(2000), off(16000));
        assert!(coarse < 0.06 && fine < 0.01 && fine < 0.25 * coarse, "{coarse} {fine}");
    }

    /// A flat parts at Kendall's force, by depth and by force.
    #[test]
    fn a_flat_parts_at_kendalls_force() {
        let (springs, work) = (4000, 1e-3);
        let width = 1.0 / number(springs);
        let kendall = -(PI * work).sqrt();
        let mut flat = AdhesiveRough::of_gaps(&vec![0.0; springs], width, width, both(work)).unwrap();
        to(&mut flat, 1e-3);
        let mut pulled = flat.clone();
        let jumps = to(&mut flat, -1.0);
        assert!((jumps[0].before.force / kendall - 1.0).abs() < 2e-4, "{jumps:?}");
        let pull = |force: f64| Pull { force, slide: 0.0, sliding_speed: 0.0, duration: 1.0 };
        assert!(pulled.press(&pull(0.999 * kendall)).unwrap().unwrap().is_empty() && pulled.joined());
        let jumps = pulled.press(&pull(1.001 * kendall)).unwrap().unwrap();
        assert!((jumps[0].before.force / kendall - 1.0).abs() < 2e-4);
        assert_eq!(pulled.state().indentation, None);
        pulled.press(&pull(0.0)).unwrap().unwrap();
        assert!(pulled.joined());
    }

    /// On a rough line patches join on the way in that do not part where they joined: the way out lies below, something
    /// is lost, and the last patch goes at less than the pull of the flat.
    #[test]
    fn a_rough_line_has_a_hysteresis() {
        let works = both(1e-5);
        let mut line = AdhesiveRough::new(&smooth(3e-3), 4000, 1.0, None, works).unwrap();
        let mut again = line.clone();
        let middle = line.ground.gaps[line.ground.order[2000]];
        to(&mut line, middle);
        to(&mut line, 0.5 * middle);
        to(&mut again, 0.5 * middle);
        assert!(line.force() < again.force() - 0.01 * again.force().abs(), "{} {}", line.force(), again.force());
        assert!(line.dissipated > again.dissipated && line.held.springs > again.held.springs);
        let last = ContactModel::last_depth(&line).unwrap().unwrap();
        let jumps = to(&mut line, last.next_down());
        assert!(!line.joined());
        let least = jumps.iter().map(|jump| jump.before.force).fold(0.0, f64::min);
        assert!(least < 0.0 && least > -(PI * works.opening).sqrt(), "{least}");
    }
}
