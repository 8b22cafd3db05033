//! A contact that wears while it slides or is shaken.

mod look;

use super::bed::{Load, Pressed, WornBed};
use super::rings::Start;
use super::slips::Slips;
use crate::contact::error::{BedError, ContactError};
use crate::numerics::stabilized::{Flow, Moment, between, longest};
use crate::shape::Profile;
use std::sync::Arc;

/// How the bodies rub.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Motion {
    /// One way, as a whole; the path is the way slid [m].
    Slide,
    /// To and fro; the path is the number of cycles.
    Shake {
        /// Amplitude [m].
        amplitude: f64,
        /// m = μE*/G*: a spring slips after m times its compression.
        reach: f64,
    },
}

/// What has been worn off so far.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Worn {
    /// Volume [m³].
    pub volume: f64,
    /// Largest depth [m].
    pub depth: f64,
}

/// A ring of the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ring {
    /// Radius in its middle [m].
    pub radius: f64,
    /// Height f [m] of the worn profile.
    pub height: f64,
    /// Mean worn depth [m].
    pub worn: f64,
    /// Mean pressure [Pa].
    pub pressure: f64,
}

/// Numbers of a state before the worn depths: ∫∫ p ds dA (worn volume per k_w), work of the pressure on what is worn
/// off, work of friction per μ.
const TOTALS: usize = 3;
/// Most by which a step grows after another, and shrinks after it was too long.
const GROWTH: f64 = 5.0;
const SHRINKING: f64 = 0.1;
/// Most steps tried one after the other; each that is too long is a tenth as long the next time.
const MOST_TRIES: usize = 400;
/// Part of the error allowed that a rest followed in one straight line may have.
const STRAIGHT: f64 = 1e-3;

/// A contact that wears.
///
/// A stretch of rubbing is followed in steps of its own, whatever records are asked for: between their ends the state is
/// a cubic, of which worn volume and ∫F ds are the same linear function.
#[derive(Debug, Clone)]
pub struct Wearing {
    bed: WornBed,
    slips: Slips,
    coefficient: f64,
    tolerance: f64,
    /// Totals and worn depths.
    state: Vec<f64>,
    load: Load,
    pressed: Pressed,
    stretch: Option<Stretch>,
    steps: usize,
}

/// A stretch of rubbing, followed up to the end of a step.
#[derive(Debug, Clone)]
struct Stretch {
    motion: Motion,
    /// Length of its path.
    span: f64,
    /// Path at the beginning of the last step, and its length.
    from: f64,
    step: f64,
    start: Moment,
    end: Moment,
    /// Length to try next, and the largest rate of decay.
    next: f64,
    rate: f64,
    /// The bed at its end, from whose depth the next one is looked for: looks in between change nothing.
    pressed: Pressed,
}

/// The rates of the totals and of the worn depths.
struct Rates<'w> {
    bed: &'w WornBed,
    slips: &'w Slips,
    coefficient: f64,
    motion: Motion,
    load: Load,
    pressed: Pressed,
    /// Slips of the cells and of the rings per path.
    of_cells: Vec<f64>,
    of_rings: Vec<f64>,
    forces: Vec<f64>,
}

impl Rates<'_> {
    /// The slips of cells and rings as the bed is pressed now.
    fn slip(&mut self) {
        let count = self.bed.rings.len();
        self.of_cells.clear();
        self.of_rings.resize(count, 0.0);
        match self.motion {
            Motion::Slide => {
                self.of_cells.resize(count, 1.0);
                self.of_rings.fill(1.0);
            }
            Motion::Shake { amplitude, reach } => {
                // Twice as far and back as the spring goes beyond its limit on each side.
                let below = |g: &f64| (self.pressed.depth - g).max(0.0);
                self.of_cells
                    .extend(self.pressed.reduced.iter().map(|g| 4.0 * (amplitude - reach * below(g)).max(0.0)));
                self.slips.of(&self.of_cells, &mut self.of_rings);
            }
        }
    }
}

impl Flow for Rates<'_> {
    fn rate(&mut self, state: &[f64], rate: &mut [f64]) {
        let rings = &self.bed.rings;
        self.bed.press(&state[TOTALS..], self.load, &mut self.pressed);
        self.forces.resize(rings.len(), 0.0);
        rings.forces(&self.pressed.loads, &mut self.forces);
        self.slip();
        rate.fill(0.0);
        let (totals, depths) = rate.split_at_mut(TOTALS);
        for (j, depth) in depths.iter_mut().enumerate() {
            let rubbed = self.forces[j] * self.of_rings[j];
            *depth = self.coefficient * rubbed / rings.areas()[j];
            totals[0] += rubbed;
            totals[1] += self.forces[j] * *depth;
        }
        let lost = |(i, q): (usize, &f64)| 2.0 * rings.width(i) * q * self.of_cells[i];
        totals[2] = self.pressed.loads.iter().enumerate().map(lost).sum();
    }
}

impl Wearing {
    /// An unworn `profile` on a half-space of the modulus `modulus` E* [Pa], wearing by `coefficient` k_w [m²/N].
    #[must_use]
    pub fn new(profile: Arc<dyn Profile>, modulus: f64, coefficient: f64, start: Start) -> Self {
        let bed = WornBed::new(profile, modulus, start);
        let state = vec![0.0; TOTALS + bed.rings.len()];
        Self {
            bed,
            slips: Slips::default(),
            coefficient,
            tolerance: 0.5 / (start.cells as f64).powi(2),
            state,
            load: Load::Indentation(0.0),
            pressed: Pressed::default(),
            stretch: None,
            steps: 0,
        }
    }

    /// Presses the bodies together; nothing rubs.
    ///
    /// # Errors
    /// The contact outgrows the profile.
    pub fn press(&mut self, load: Load) -> Result<(), ContactError> {
        (self.load, self.stretch) = (load, None);
        self.settle();
        while self.bed.is_too_narrow(&self.pressed) {
            self.widen()?;
            self.settle();
        }
        Ok(())
    }

    fn settle(&mut self) {
        self.bed.press(&self.state[TOTALS..], self.load, &mut self.pressed);
    }

    fn widen(&mut self) -> Result<(), ContactError> {
        let before = self.bed.rings.len();
        self.bed.widen();
        self.state.resize(TOTALS + self.bed.rings.len(), 0.0);
        let stuck = self.bed.rings.len() == before;
        let indentation = self.pressed.depth;
        if stuck { Err(BedError::BeyondProfile { indentation }.into()) } else { Ok(()) }
    }

    /// Begins to rub over the path `span` under a load.
    ///
    /// # Errors
    /// As for [`press`](Self::press).
    pub fn begin(&mut self, motion: Motion, load: Load, span: f64) -> Result<(), ContactError> {
        self.press(load)?;
        self.begin_stretch(motion, span);
        Ok(())
    }

    fn begin_stretch(&mut self, motion: Motion, span: f64) {
        if let Motion::Shake { .. } = motion {
            self.slips.fill(&self.bed.rings);
        }
        let mut rates = self.rates(motion, self.pressed.depth);
        let start = Moment::new(&mut rates, self.state.clone());
        let rate = rates.coefficient * rates.bed.stiffness(&rates.of_rings);
        let pressed = rates.pressed;
        let next = if rate > 0.0 { (0.1 / rate).min(span) } else { span };
        self.stretch =
            Some(Stretch { motion, span, from: 0.0, step: 0.0, end: start.clone(), start, next, rate, pressed });
    }

    fn rates(&self, motion: Motion, depth: f64) -> Rates<'_> {
        Rates {
            bed: &self.bed,
            slips: &self.slips,
            coefficient: self.coefficient,
            motion,
            load: self.load,
            pressed: Pressed { depth, ..Pressed::default() },
            of_cells: Vec::new(),
            of_rings: Vec::new(),
            forces: Vec::new(),
        }
    }

    /// Rubs on up to the path `path` since the beginning.
    ///
    /// # Errors
    /// The contact outgrows the profile.
    pub fn advance(&mut self, path: f64) -> Result<(), ContactError> {
        while let Some(stretch) = self.stretch.take() {
            if path <= stretch.from + stretch.step {
                let part = if stretch.step > 0.0 { (path - stretch.from) / stretch.step } else { 1.0 };
                self.state = between(&stretch.start, &stretch.end, stretch.step, part);
                self.pressed.depth = stretch.pressed.depth;
                self.stretch = Some(stretch);
                break;
            }
            self.stretch = Some(self.step(stretch)?);
        }
        self.settle();
        Ok(())
    }

    /// One step on, as long as the error allows; on more cells where the contact outgrows them.
    fn step(&mut self, stretch: Stretch) -> Result<Stretch, ContactError> {
        let (from, mut begin) = (stretch.from + stretch.step, stretch);
        let left = begin.span - from;
        if self.goes_straight(&begin, left) {
            return Ok(begin.straight(left));
        }
        for _ in 0..MOST_TRIES {
            let step = begin.next.min(longest(begin.rate)).min(left);
            let mut rates = self.rates(begin.motion, begin.pressed.depth);
            let ahead = begin.end.ahead(&mut rates, step, begin.rate);
            if rates.bed.is_too_narrow(&rates.pressed) {
                self.pressed.depth = rates.pressed.depth;
                begin = self.on_more_cells(begin)?;
                continue;
            }
            let error = self.relative(&ahead.error, &ahead.end.state, &rates.pressed) / self.tolerance;
            let factor = 0.8 * error.powf(-1.0 / 3.0);
            begin.next = step * if factor.is_nan() { SHRINKING } else { factor.clamp(SHRINKING, GROWTH) };
            if error <= 1.0 {
                if let Motion::Shake { .. } = begin.motion {
                    begin.rate = rates.coefficient * rates.bed.stiffness(&rates.of_rings);
                }
                // The last step ends where the stretch does.
                let from = if step >= left { begin.span - step } else { from };
                let pressed = rates.pressed;
                self.steps += 1;
                return Ok(Stretch { from, step, start: begin.end, end: ahead.end, pressed, ..begin });
            }
        }
        Err(BedError::Endless.into())
    }

    /// The stretch at the end of its last step, on more cells.
    fn on_more_cells(&mut self, stretch: Stretch) -> Result<Stretch, ContactError> {
        let motion = stretch.motion;
        self.state.clone_from(&stretch.end.state);
        self.widen()?;
        self.slips.fill(&self.bed.rings);
        let mut rates = self.rates(motion, stretch.pressed.depth);
        let end = Moment::new(&mut rates, self.state.clone());
        let rate = rates.coefficient * rates.bed.stiffness(&rates.of_rings);
        let pressed = rates.pressed;
        Ok(Stretch { end, rate, pressed, ..stretch })
    }

    /// Whether the rates stay as they are over the path `left`, as far as it matters: where next to nothing is worn any
    /// more, and under a punch whose pressure no longer changes.
    ///
    /// Its forms decay at k_wE*/2b or faster, so that they lose no more than |ṗ|/λ² of depth.
    fn goes_straight(&self, stretch: &Stretch, left: f64) -> bool {
        let enough = STRAIGHT * self.tolerance * self.yardstick(&stretch.end.state, &stretch.pressed);
        let pace = largest(&stretch.end.rate[TOTALS..]);
        let full = self.bed.rings.ended() && self.bed.rings.outer() <= self.bed.contact_radius(&stretch.pressed);
        let slowest = 0.5 * self.coefficient * self.bed.modulus() / self.bed.rings.outer();
        let drift = |(one, other): (&f64, &f64)| (one - other).abs();
        let drift = stretch.start.rate.iter().zip(&stretch.end.rate).skip(TOTALS).map(drift).fold(0.0, f64::max);
        let settled = full && stretch.motion == Motion::Slide && drift <= stretch.step * slowest * slowest * enough;
        stretch.step > 0.0 && (pace * left <= enough || settled)
    }

    /// What errors of the worn depths are held against [m]: the largest of them, or the largest compression of a spring
    /// where that is less, for the pressures follow from it however much is worn off.
    fn yardstick(&self, state: &[f64], pressed: &Pressed) -> f64 {
        let compression = largest(&pressed.loads) / self.bed.modulus();
        largest(&state[TOTALS..]).min(compression)
    }

    /// The error of the worn depths against their yardstick.
    fn relative(&self, error: &[f64], state: &[f64], pressed: &Pressed) -> f64 {
        let error = largest(&error[TOTALS..]);
        if error > 0.0 || error.is_nan() { error / self.yardstick(state, pressed) } else { 0.0 }
    }
}

impl Stretch {
    /// The rest of the path `left` as one step at the present rates.
    fn straight(self, left: f64) -> Self {
        let state = self.end.state.iter().zip(&self.end.rate).map(|(y, f)| y + left * f).collect();
        let end = Moment { state, rate: self.end.rate.clone() };
        Self { from: self.span - left, step: left, start: self.end, end, ..self }
    }
}

/// The largest of numbers, whatever their sign; not a number if one of them is not.
fn largest(numbers: &[f64]) -> f64 {
    let larger = |most: f64, number: &f64| if most.is_nan() || number.abs() <= most { most } else { number.abs() };
    numbers.iter().fold(0.0, larger)
}
