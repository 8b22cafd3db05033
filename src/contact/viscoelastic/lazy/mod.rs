//! The bed that does work only where something happens.
//!
//! All pressed springs share u̇ = ḋ. With Hᵢ(t) the memory integral of ḋ, a spring with the element
//! loads sᵢ(t_c) at some time t_c has sᵢ(t) = Hᵢ(t) + e^(−(t−t_c)/τᵢ)[sᵢ(t_c) − Hᵢ(t_c)] as long as it is
//! pressed, and zₘ(t) = e^(−(t−t_c)/λₘ) zₘ(t_c) as long as it is free. The sums over the contact obey
//! the same scalar equations, so a motion costs O(terms) plus the springs touched or released in it,
//! however many springs there are.
//!
//! # Examples
//! ```
//! use springbed::contact::viscoelastic::{Spectrum, layout::Layout, lazy::Lazy};
//! use springbed::input::quantity::Length;
//! use springbed::material::Relaxation;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! // Pressed at once and held for 20 relaxation times: what is left is Hertz' force with E∞.
//! let ball = Paraboloid { radius: Length::new(1.0)? };
//! let relaxation = Relaxation { equilibrium: 1.0, terms: vec![(9.0, 1.0)], viscosity: 0.0 };
//! let mut bed = Lazy::new(Arc::new(Spectrum::new(&relaxation)), Layout::uniform(&ball, 0.2, 1000));
//! bed.advance(1e7, 1e-9);
//! assert!((bed.force() / (4e-2 / 3.0) - 1.0).abs() < 1e-4);
//! bed.advance(0.0, 20.0);
//! assert!((bed.force() / (4e-3 / 3.0) - 1.0).abs() < 1e-4);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod edge;
mod glance;
mod mark;
mod release;
mod touch;

use mark::{Mark, Undo};

use super::Spectrum;
use super::alike::Alike;
use super::layout::Layout;
use super::ledger::Ledger;
use super::spring::{Free, Motion, Piece, Spring};
use super::totals::{Numbers, Totals};
use crate::contact::model::{Effort, Straight};
use crate::shape::Profile;
use std::ops::Range;
use std::sync::Arc;

/// Bed whose cost per motion does not grow with the number of springs.
#[derive(Debug, Clone)]
pub struct Lazy {
    spectrum: Arc<Spectrum>,
    layout: Layout,
    prefix: Prefix,
    /// Spring by spring: sᵢ(t_c) − Hᵢ(t_c) while pressed, zₘ(t_c) while free.
    constants: Vec<f64>,
    /// Displacement that stays, of free springs.
    rest: Vec<f64>,
    /// t_c.
    since: Vec<Instant>,
    now: Now,
    journal: Option<Vec<Undo>>,
    marked: Option<Mark>,
}

/// All that changes in every motion: O(terms) numbers.
#[derive(Debug, Clone)]
struct Now {
    memory: Vec<f64>,
    totals: Totals,
    pressed: usize,
    touched: usize,
    refreshed: usize,
    instant: Instant,
    depth: f64,
    speed: f64,
    /// ∫ F dt of the last motion [N s].
    impulse: f64,
    work: f64,
}

/// A time as the sum of two numbers: short steps late in a long history are not lost.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
struct Instant {
    whole: f64,
    part: f64,
}

impl Instant {
    fn after(self, duration: f64) -> Self {
        let added = self.part + duration;
        let whole = self.whole + added;
        Self { whole, part: added - (whole - self.whole) }
    }

    fn since(self, earlier: Self) -> f64 {
        (self.whole - earlier.whole) + (self.part - earlier.part)
    }
}

/// Sums of weight, weight·height and weight·height² over the first springs.
#[derive(Debug, Clone)]
struct Prefix(Vec<[f64; 3]>);

impl Prefix {
    fn new(layout: &Layout) -> Self {
        let mut sum = [0.0; 3];
        let next = |(w, c): (&f64, &f64)| {
            sum = [sum[0] + w, sum[1] + w * c, sum[2] + w * c * c];
            sum
        };
        Self(std::iter::once([0.0; 3]).chain(layout.weight.iter().zip(&layout.height).map(next)).collect())
    }
}

/// A spring touched or released in a motion.
#[derive(Debug)]
struct Event {
    spring: usize,
    before: Spring,
    after: Spring,
    /// ∫ q dt [N s/m].
    impulse: f64,
}

impl Lazy {
    /// A bed never touched.
    #[must_use]
    pub fn new(spectrum: Arc<Spectrum>, layout: Layout) -> Self {
        let count = layout.len();
        let now = Now {
            memory: vec![0.0; spectrum.terms().len()],
            totals: Totals::new(&spectrum),
            pressed: 0,
            touched: 0,
            refreshed: 0,
            instant: Instant::default(),
            depth: 0.0,
            speed: 0.0,
            impulse: 0.0,
            work: 0.0,
        };
        let rows = spectrum.terms().len().max(spectrum.modes().len());
        Self {
            prefix: Prefix::new(&layout),
            constants: vec![0.0; rows * count],
            rest: vec![0.0; count],
            since: vec![Instant::default(); count],
            journal: None,
            marked: None,
            spectrum,
            layout,
            now,
        }
    }

    /// Adds springs never touched until the bed reaches `radius` [m].
    pub fn extend(&mut self, profile: &dyn Profile, radius: f64) {
        let rows = self.row(0).len();
        self.layout.extend(profile, radius);
        let count = self.layout.len();
        self.constants.resize(rows * count, 0.0);
        self.rest.resize(count, 0.0);
        self.since.resize(count, Instant::default());
        self.prefix = Prefix::new(&self.layout);
    }

    /// Where the springs stand.
    #[must_use]
    pub fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Moves at constant `speed` [m/s] for `duration` [s].
    pub fn advance(&mut self, speed: f64, duration: f64) {
        let motion = Motion { start: self.now.depth, speed, duration };
        let pressed = self.now.pressed;
        let touched = self.touched_again(&motion);
        let first = self.touched_first(touched.len(), &motion);
        let held = !first.is_empty() || touched.iter().any(|event| matches!(event.after, Spring::Pressed(_)));
        let inwards = (0..if held { 0 } else { pressed }).rev();
        let mut near = 0.0;
        let released: Vec<Event> = inwards.map_while(|j| self.released_in(j, &motion, &mut near)).collect();
        for event in &released {
            self.now.pressed = event.spring;
            self.now.totals.add(&event.before, -self.layout.weight[event.spring]);
        }
        self.evolve(&motion);
        touched.into_iter().chain(released).for_each(|event| self.replace(event, duration));
        for j in first {
            let touch = self.touch_first(j, &motion);
            self.keep(&touch);
        }
        self.now.work += speed * self.now.impulse;
        self.refresh();
    }

    /// Moves to the depth `to` [m] in `duration` [s], and lands on it to the last bit.
    pub fn reach(&mut self, to: f64, duration: f64) {
        self.advance((to - self.now.depth) / duration, duration);
        self.now.depth = to;
    }

    /// Moves along a straight piece, and lands on its end to the last bit.
    pub fn follow_line(&mut self, line: &Straight) {
        self.advance(line.speed, line.duration);
        self.now.depth = line.to;
    }

    /// Takes the indenter far away at once.
    pub fn leave(&mut self) {
        let away = self.now.depth.min(0.0) - 1.0;
        self.reach(away, self.spectrum.instant());
    }

    /// Springs and bytes.
    #[must_use]
    pub fn effort(&self) -> Effort {
        Effort { springs: self.layout.len(), bytes: self.bytes(), force_error: None, radius_error: None }
    }

    /// The springs' material.
    #[must_use]
    pub fn spectrum(&self) -> &Spectrum {
        &self.spectrum
    }

    /// The same, to be held.
    #[must_use]
    pub fn shared_spectrum(&self) -> Arc<Spectrum> {
        self.spectrum.clone()
    }

    /// Number of springs touched so far.
    #[must_use]
    pub fn touched(&self) -> usize {
        self.now.touched
    }

    fn event(&self, spring: usize, before: Spring, seen: &Motion) -> Event {
        let mut impulse = 0.0;
        let watch = &mut |piece: &Piece<'_>| impulse += self.spectrum.impulse(piece);
        let after = before.clone().follow(&self.spectrum, seen, watch);
        Event { spring, before, after, impulse }
    }

    /// The motion as the spring `j` sees it.
    fn seen(&self, j: usize, motion: &Motion) -> Motion {
        Motion { start: motion.start - self.layout.height[j], ..*motion }
    }

    fn row(&self, j: usize) -> Range<usize> {
        let rows = self.constants.len() / self.layout.len().max(1);
        j * rows..(j + 1) * rows
    }

    /// The spring `j` now.
    fn spring(&self, j: usize) -> Spring {
        if self.is_pressed(j) { Spring::Pressed(self.loads(j).collect()) } else { Spring::Free(self.free(j)) }
    }

    fn is_pressed(&self, j: usize) -> bool {
        j < self.now.pressed
    }

    /// Element loads sᵢ [N/m] of the pressed spring `j`.
    fn loads(&self, j: usize) -> impl Iterator<Item = f64> + '_ {
        let (age, constants) = (self.now.instant.since(self.since[j]), &self.constants[self.row(j)]);
        let elements = self.spectrum.terms().iter().zip(constants).zip(&self.now.memory);
        elements.map(move |((term, c), h)| h + (-age / term.time).exp() * c)
    }

    /// The free spring `j`.
    fn free(&self, j: usize) -> Free {
        let (age, constants) = (self.now.instant.since(self.since[j]), &self.constants[self.row(j)]);
        let modes = self.spectrum.modes().iter().zip(constants);
        Free { rest: self.rest[j], modes: modes.map(|(mode, z)| z * (-age / mode.time).exp()).collect() }
    }

    /// Memory and sums over a motion of the springs that stay pressed or free.
    fn evolve(&mut self, motion: &Motion) {
        let Self { spectrum, now, prefix, .. } = self;
        let [weight, first, _] = prefix.0[now.pressed];
        let alike = Alike::new(spectrum, motion.speed, motion.duration);
        let sum = alike.impulse(&now.totals.loads, weight);
        alike.press(&mut now.memory);
        let mean = weight * (motion.start + 0.5 * motion.speed * motion.duration) - first;
        let steady = spectrum.equilibrium() * mean + spectrum.viscosity() * motion.speed * weight;
        now.impulse = sum + motion.duration * steady;
        now.totals.evolve(&alike, weight);
        now.instant = now.instant.after(motion.duration);
        (now.depth, now.speed) = (motion.end(), motion.speed);
    }

    /// Puts a spring into its state at the end of the motion, its work into the ledger.
    fn replace(&mut self, event: Event, duration: f64) {
        let (j, weight) = (event.spring, self.layout.weight[event.spring]);
        if let Spring::Free(mut free) = event.before {
            self.spectrum.recover(&mut free, duration);
            self.now.totals.add(&Spring::Free(free), -weight);
        }
        self.now.impulse += weight * event.impulse;
        self.now.totals.add(&event.after, weight);
        self.store(j, event.after);
    }

    fn store(&mut self, j: usize, spring: Spring) {
        self.note(j);
        let row = self.row(j);
        self.since[j] = self.now.instant;
        self.now.touched = self.now.touched.max(j + 1);
        match spring {
            Spring::Pressed(loads) => {
                self.now.pressed = self.now.pressed.max(j + 1);
                let kept = loads.iter().zip(&self.now.memory).map(|(s, h)| s - h);
                self.constants[row].iter_mut().zip(kept).for_each(|(c, value)| *c = value);
            }
            Spring::Free(free) => {
                self.rest[j] = free.rest;
                self.constants[row].iter_mut().zip(free.modes).for_each(|(c, value)| *c = value);
            }
        }
    }

    /// Normal force F = Σ 2Δx q [N].
    #[must_use]
    pub fn force(&self) -> f64 {
        let [weight, first, _] = self.prefix.0[self.now.pressed];
        let steady = self.spectrum.equilibrium() * (self.now.depth * weight - first);
        steady + self.now.totals.loads.iter().sum::<f64>() + self.spectrum.viscosity() * self.now.speed * weight
    }

    /// Line load of the spring `j` [N/m].
    #[must_use]
    pub fn line_load(&self, j: usize) -> f64 {
        if !self.is_pressed(j) {
            return 0.0;
        }
        let loads: Numbers = self.loads(j).collect();
        self.spectrum.load(self.displacement(j), &loads, self.now.speed)
    }

    /// Displacement u [m] of the spring `j`.
    #[must_use]
    pub fn displacement(&self, j: usize) -> f64 {
        if self.is_pressed(j) {
            self.now.depth - self.layout.height[j]
        } else {
            self.spectrum.recovered(&self.free(j), 0.0)
        }
    }

    /// Contact radius [m], between two springs.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.edge().place
    }

    /// Number of springs pressed.
    #[must_use]
    pub fn pressed(&self) -> usize {
        self.now.pressed
    }

    /// Indentation [m].
    #[must_use]
    pub fn indentation(&self) -> f64 {
        self.now.depth
    }

    /// Work done so far, energy in the springs, and their difference, the heat [J].
    #[must_use]
    pub fn ledger(&self) -> Ledger {
        let [weight, first, second] = self.prefix.0[self.now.pressed];
        let depth = self.now.depth;
        let squares = depth * (depth * weight - 2.0 * first) + second;
        let stored = 0.5 * self.spectrum.equilibrium() * squares + self.now.totals.stored(&self.spectrum);
        Ledger { stored, dissipated: self.now.work - stored, work: self.now.work }
    }

    /// ∫ F dt [N s] over the last motion.
    #[must_use]
    pub fn impulse(&self) -> f64 {
        self.now.impulse
    }

    /// Bytes of state.
    #[must_use]
    pub fn bytes(&self) -> usize {
        size_of::<f64>() * (self.constants.len() + 9 * self.layout.len())
    }
}
