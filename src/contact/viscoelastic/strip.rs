//! A stretch of the continuous bed whose springs share their past.
//!
//! The springs of a strip were touched in the same motions of the indenter and let go in the same
//! ones, each at an instant of its own. So one short list of motions gives the state of every spring
//! of the strip in closed form, and a sum over them is an integral of a smooth function.

use super::attraction::{Attraction, Tear};
use super::ledger::impulse;
use super::spring::{Free, Motion, Piece, Spring};
use super::totals::Totals;
use super::{Element, Spectrum};
use crate::numerics::exponential::decay;
use crate::numerics::quadrature;
use crate::shape::Profile;
use std::sync::Arc;

/// The past of a spring: the last motion that touched it or let it go, and what has been since.
#[derive(Debug, Clone)]
pub(super) struct Past {
    /// Up to the beginning of that motion; `None` for springs it was the first to touch.
    pub before: Option<Arc<Past>>,
    /// That motion.
    pub motion: Motion,
    /// Whether it left the springs pressed.
    pub pressed: bool,
    /// When it tore the springs off, if they held on to the indenter.
    pub torn: Option<Arc<Tear>>,
    /// Time since its end [s].
    pub age: f64,
    /// Element loads [N/m] from the motion since its end, alike for all springs pressed.
    memory: Vec<f64>,
    /// What is left since then of the element loads, or of the modes of free springs.
    kept: Vec<f64>,
}

/// Springs between two distances from the axis.
#[derive(Debug, Clone)]
pub(super) struct Strip {
    pub inner: f64,
    pub outer: f64,
    pub past: Past,
    /// Sums over the strip, of both halves of the bed; `None` until somebody needs them.
    pub totals: Option<Totals>,
}

/// How much of a motion is followed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Detail {
    /// Only what the force needs.
    Force,
    /// Energies too.
    Energy,
}

/// What a strip is made of: the springs and the shape above them.
#[derive(Debug, Clone)]
pub(super) struct Ground {
    pub spectrum: Arc<Spectrum>,
    pub profile: Arc<dyn Profile>,
    pub attraction: Option<Attraction>,
}

impl Past {
    /// Past of springs that `motion` has just touched or let go.
    pub(super) fn new(spectrum: &Spectrum, before: Option<Arc<Self>>, motion: Motion, pressed: bool) -> Self {
        let states = if pressed { spectrum.terms().len() } else { spectrum.modes().len() };
        Self { before, motion, pressed, torn: None, age: 0.0, memory: vec![0.0; states], kept: vec![1.0; states] }
    }

    /// The spring under the height `c` of the indenter, now.
    pub(super) fn spring(&self, ground: &Ground, c: f64) -> Spring {
        if self.before.is_none() && self.pressed {
            return Spring::Pressed(self.first_loads(&ground.spectrum, c));
        }
        self.lived(ground, c, &mut |_| {})
    }

    /// Element loads of a spring touched for the first time in the last motion.
    fn first_loads(&self, spectrum: &Spectrum, c: f64) -> Vec<f64> {
        let speed = self.motion.speed;
        // Clamped at both ends: a rounding beyond the border is many times the shortest relaxation time.
        let pressed = (self.motion.duration - ((c - self.motion.start) / speed).max(0.0)).max(0.0);
        let loaded = |term: &Element| term.modulus * speed * term.time * decay(pressed / term.time).1;
        let since = self.kept.iter().zip(&self.memory);
        spectrum.terms().iter().zip(since).map(|(term, (kept, m))| loaded(term) * kept + m).collect()
    }

    /// The spring now, its last motion watched.
    pub(super) fn lived(&self, ground: &Ground, c: f64, watch: &mut impl FnMut(&Piece<'_>)) -> Spring {
        let spectrum = &ground.spectrum;
        let before = self.before.as_ref().map_or_else(|| Spring::untouched(spectrum), |past| past.spring(ground, c));
        let seen = Motion { start: self.motion.start - c, ..self.motion };
        let after = match (&self.torn, &ground.attraction) {
            (Some(tear), _) => torn(spectrum, before, (&seen, tear.time(c)), watch),
            (None, Some(_)) => before.hold(spectrum, &seen, watch),
            (None, None) => before.follow(spectrum, &seen, watch),
        };
        let mut spring = self.settled(spectrum, after, seen.end());
        match &mut spring {
            Spring::Pressed(loads) => {
                let since = self.kept.iter().zip(&self.memory);
                loads.iter_mut().zip(since).for_each(|(s, (kept, m))| *s = *s * kept + m);
            }
            Spring::Free(free) => free.modes.iter_mut().zip(&self.kept).for_each(|(z, kept)| *z *= kept),
        }
        spring
    }

    /// At the border of a strip a spring may come out on the wrong side by a rounding: both sides are
    /// the same state there.
    fn settled(&self, spectrum: &Spectrum, spring: Spring, u: f64) -> Spring {
        match spring {
            Spring::Free(free) if self.pressed => {
                let mut s = vec![0.0; spectrum.terms().len()];
                spectrum.loads_of_free(&free, &mut s);
                Spring::Pressed(s)
            }
            Spring::Pressed(s) if !self.pressed => {
                let mut free = Free::default();
                spectrum.let_go((u, &s), 0.0, &mut free);
                Spring::Free(free)
            }
            spring => spring,
        }
    }

    /// A motion in which nothing happens to the springs.
    pub(super) fn pass(&mut self, spectrum: &Spectrum, motion: &Motion) {
        self.age += motion.duration;
        if self.pressed {
            spectrum.press(&mut self.memory, motion.speed, motion.duration);
            self.kept = spectrum.terms().iter().map(|term| decay(self.age / term.time).0).collect();
        } else {
            self.kept = spectrum.modes().iter().map(|mode| decay(self.age / mode.time).0).collect();
        }
    }

    /// The longest of the motions that touched these springs or let them go [s].
    fn longest(&self) -> f64 {
        let before = self.before.as_ref().map_or(0.0, |past| past.longest());
        before.max(self.motion.duration)
    }
}

/// A spring torn off at the time `at` of a motion, and free from then on.
fn torn(
    spectrum: &Spectrum,
    spring: Spring,
    (motion, at): (&Motion, f64),
    watch: &mut impl FnMut(&Piece<'_>),
) -> Spring {
    let held = spring.hold(spectrum, &Motion { duration: at, ..*motion }, watch);
    let Spring::Pressed(s) = held else { return held.hold(spectrum, &motion.after(at), watch) };
    let mut free = Free::default();
    let u = motion.depth(at);
    let load = if spectrum.viscosity() > 0.0 { 0.0 } else { spectrum.load(u, &s, motion.speed) };
    spectrum.let_go((u, &s), load, &mut free);
    watch(&Piece::Free { free: &free, duration: motion.duration - at });
    spectrum.recover(&mut free, motion.duration - at);
    Spring::Free(free)
}

impl Strip {
    /// A strip without its sums.
    pub(super) fn new((inner, outer): (f64, f64), past: Past) -> Self {
        Self { inner, outer, past, totals: None }
    }

    /// Makes the sums if there are none.
    pub(super) fn fill(&mut self, ground: &Ground, detail: Detail) {
        if self.totals.is_some() || (detail == Detail::Force && !self.past.pressed) {
            return;
        }
        let mut totals = Totals::new(&ground.spectrum);
        self.visit(ground, |c, w| totals.add(&self.past.spring(ground, c), w));
        self.totals = Some(totals);
    }

    /// Makes the sums, and gives the work of the last motion [J].
    pub(super) fn settle(&mut self, ground: &Ground) -> f64 {
        let mut totals = Totals::new(&ground.spectrum);
        let mut work = 0.0;
        self.visit(ground, |c, w| {
            let mut impulse = 0.0;
            let spring = self.past.lived(ground, c, &mut |piece| impulse += ground.spectrum.impulse(piece));
            totals.add(&spring, w);
            work += w * self.past.motion.speed * impulse;
        });
        self.totals = Some(totals);
        work
    }

    /// A motion in which nothing happens to the strip; the work of its Maxwell elements [J].
    pub(super) fn pass(&mut self, spectrum: &Spectrum, motion: &Motion) -> f64 {
        let held = if self.past.pressed { self.weight() } else { 0.0 };
        let mut work = 0.0;
        if let Some(totals) = &mut self.totals {
            for (term, s) in spectrum.terms().iter().zip(&totals.loads) {
                work += motion.speed * impulse(term, *s, motion.speed * held, motion.duration);
            }
            totals.evolve(spectrum, (held, motion.speed), motion.duration);
        }
        self.past.pass(spectrum, motion);
        work
    }

    /// ∫ Σ sᵢ 2 dx [N].
    pub(super) fn load(&self) -> f64 {
        self.totals.iter().flat_map(|totals| &totals.loads).sum()
    }

    /// Energy in the Maxwell elements, or in the free springs [J].
    pub(super) fn stored(&self, spectrum: &Spectrum) -> f64 {
        self.totals.as_ref().map_or(0.0, |totals| totals.stored(spectrum))
    }

    /// Weight ∫ 2 dx of the strip [m].
    fn weight(&self) -> f64 {
        2.0 * (self.outer - self.inner)
    }

    /// The height g(x) and the weight 2 dx at the nodes of a quadrature that resolves the strip.
    ///
    /// Towards the border touched or let go last the loads change over the shortest relaxation time:
    /// panels shrink towards it sixteenfold until they are shorter than that, or than anything that
    /// counts. The other border is alike if the springs had a life before.
    pub(super) fn visit(&self, ground: &Ground, mut at: impl FnMut(f64, f64)) {
        for pair in self.panel_ends(ground).windows(2) {
            let half = 0.5 * (pair[1] - pair[0]);
            for &(node, w) in quadrature::nodes() {
                at(ground.profile.reduced(pair[0] + half * (1.0 + node)), 2.0 * half * w);
            }
        }
    }

    /// ∫ Σ sᵢ 2 dx [N] anew, with panels of half the width: what the sums should be.
    pub(super) fn checked_load(&self, ground: &Ground) -> f64 {
        let load = |x: f64| match self.past.spring(ground, ground.profile.reduced(x)) {
            Spring::Pressed(s) => 2.0 * s.iter().sum::<f64>(),
            Spring::Free(_) => 0.0,
        };
        let halves = |pair: &[f64]| {
            let middle = 0.5 * (pair[0] + pair[1]);
            quadrature::panel(load, pair[0], middle) + quadrature::panel(load, middle, pair[1])
        };
        self.panel_ends(ground).windows(2).map(halves).sum()
    }

    /// Ends of the panels, from the inner border to the outer one.
    pub(super) fn panel_ends(&self, ground: &Ground) -> Vec<f64> {
        let fine = graded(self.past.longest() / ground.fastest());
        let levels = if self.past.before.is_some() { (fine.max(4), fine.max(4)) } else { (1, fine) };
        let mut breaks = vec![self.inner];
        breaks.extend(ground.profile.breaks(self.outer).into_iter().filter(|&x| x > self.inner && x < self.outer));
        breaks.push(self.outer);
        let mut ends: Vec<f64> = breaks.windows(2).flat_map(|pair| panels((pair[0], pair[1]), levels)).collect();
        ends.push(self.outer);
        ends
    }

    /// Line load [N/m] at the distance `x` from the axis, the indenter at the depth `d` and the speed `v`.
    pub(super) fn line_load(&self, ground: &Ground, x: f64, (d, v): (f64, f64)) -> f64 {
        let c = ground.profile.reduced(x);
        match self.past.spring(ground, c) {
            Spring::Pressed(s) => ground.spectrum.load(d - c, &s, v),
            Spring::Free(_) => 0.0,
        }
    }
}

impl Ground {
    /// Shortest time in which a spring changes by itself [s].
    fn fastest(&self) -> f64 {
        let mode = self.spectrum.modes().first().map_or(f64::INFINITY, |mode| mode.time);
        self.spectrum.shortest_time().min(mode)
    }
}

/// How many sixteenths bring a length down by `ratio`; twelve reach below rounding.
#[expect(clippy::cast_possible_truncation, reason = "between 1 and 12 by the clamp")]
fn graded(ratio: f64) -> i32 {
    (ratio.log2() / 4.0).ceil().clamp(1.0, 12.0) as i32
}

/// Lower ends of panels of an interval that shrink towards both ends, so many times at each, with
/// the middle in four.
fn panels((low, high): (f64, f64), (inner, outer): (i32, i32)) -> Vec<f64> {
    let half = 0.5 * (high - low);
    let rising = (1..=inner).rev().map(|k| low + half * 16f64.powi(-k));
    let middle = [0.5, 1.0, 1.5].map(|part| low + part * half);
    let falling = (1..=outer).map(|k| high - half * 16f64.powi(-k));
    std::iter::once(low).chain(rising).chain(middle).chain(falling).collect()
}
