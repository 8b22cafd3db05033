//! Springs of a line that give way at their caps, at the largest depth there has been.
//!
//! # Examples
//! ```
//! use springbed::contact::model::{ContactModel, Straight};
//! use springbed::contact::rough::YieldingRough;
//! use std::f64::consts::PI;
//!
//! // A spring alone is a patch of its own width, and bears πH(Δx/2)²; what is pressed deeper stays as a dent.
//! let mut one = YieldingRough::of_gaps(&[0.0], 2.0, (1.0, 0.5))?;
//! one.follow(&Straight::between(0.0, 3.0, 1.0))?;
//! assert!((one.state().force / (0.5 * PI) - 1.0).abs() < 1e-12);
//! assert!((one.residual_depth() / (3.0 - 0.25 * PI) - 1.0).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::bed::{BedState, number};
use super::patches::Patches;
use crate::contact::error::{BedError, ContactError};
use crate::shape::rough::{RoughError, positive};

/// The springs before they yield.
#[derive(Debug)]
pub(super) struct Line {
    /// Gaps, ascending [m].
    pub(super) gaps: Vec<f64>,
    /// The place along the line of each, and the other way round.
    places: Vec<usize>,
    ranks: Vec<usize>,
    /// Stiffness of a spring [N/m].
    pub(super) stiffness: f64,
    /// H Δx/E* [m]: four πths of the overlap that a spring alone bears.
    borne: f64,
}

/// The springs at the largest depth, those touched first coming first.
#[derive(Debug, Clone)]
pub(super) struct Deepest {
    /// The depth in the coordinate of the gaps [m].
    pub(super) depth: f64,
    /// Number of springs touched.
    touched: usize,
    /// Gaps with the dents below them, as they were when the cap was last raised [m].
    feet: Vec<f64>,
    /// Largest overlaps [m].
    caps: Vec<f64>,
    /// Σ overlap d(dent) up to when caps were raised [m²].
    yielded: f64,
    pub(super) patches: Patches,
    /// Lengths of patches, in springs, for which their caps are, at either end.
    capped: Vec<usize>,
}

impl Line {
    pub(super) fn new(gaps: &[f64], stiffness: f64, borne: f64) -> Result<Self, RoughError> {
        if let Some(column) = gaps.iter().position(|gap| gap.is_nan() || *gap == f64::NEG_INFINITY) {
            return Err(RoughError::Height { row: 1, column: column + 1, value: gaps[column] });
        }
        let mut places: Vec<usize> = (0..gaps.len()).filter(|&place| gaps[place].is_finite()).collect();
        places.sort_by(|&one, &other| gaps[one].total_cmp(&gaps[other]));
        positive("number of springs", number(places.len()))?;
        let mut ranks = vec![usize::MAX; gaps.len()];
        places.iter().enumerate().for_each(|(rank, &place)| ranks[place] = rank);
        Ok(Self { gaps: places.iter().map(|&place| gaps[place]).collect(), places, ranks, stiffness, borne })
    }
}

impl Deepest {
    /// Just touching.
    pub(super) fn new(line: &Line) -> Self {
        let mut touching = Self {
            depth: line.gaps[0],
            touched: 0,
            feet: line.gaps.clone(),
            caps: vec![0.0; line.gaps.len()],
            yielded: 0.0,
            patches: Patches::new(line.ranks.len()),
            capped: vec![0; line.ranks.len()],
        };
        touching.go(line, line.gaps[0]);
        touching
    }

    /// Goes on to a larger depth, from touch to touch.
    pub(super) fn go(&mut self, line: &Line, depth: f64) {
        while let Some(&gap) = line.gaps.get(self.touched).filter(|gap| **gap <= depth) {
            self.depth = gap;
            self.touch(line, line.places[self.touched]);
            self.touched += 1;
        }
        self.depth = depth;
    }

    /// Lets the spring at a place touch. The caps of its patch are raised; of a long one that only grows, not at every spring.
    fn touch(&mut self, line: &Line, place: usize) {
        let (before, behind) = self.patches.beside(place);
        let (first, last) = self.patches.close(place);
        let count = last - first + 1;
        let known = match (before, behind) {
            (_, 0) if before > 0 => self.capped[place - 1],
            (0, _) if behind > 0 => self.capped[place + 1],
            _ => 0,
        };
        let lags = number(count - known) < LAG * number(known);
        if lags {
            let edge = segments(count).nth(1).unwrap_or(0.0);
            self.raise(line.ranks[place], line.borne * edge);
        } else {
            let mut before = 0.0;
            for (spring, behind) in segments(count).skip(1).enumerate() {
                let cap = line.borne * (behind - before);
                before = behind;
                self.raise(line.ranks[first + spring], cap);
                self.raise(line.ranks[last - spring], cap);
            }
        }
        let known = if lags { known } else { count };
        (self.capped[first], self.capped[last]) = (known, known);
    }

    /// Raises the cap of a spring, whose dent is the deeper the less it was.
    fn raise(&mut self, spring: usize, cap: f64) {
        let dent = self.dent(spring);
        self.yielded += self.caps[spring] * dent;
        self.feet[spring] += dent;
        self.caps[spring] = self.caps[spring].max(cap);
    }

    /// By how much a spring has been dented since its cap was raised [m].
    fn dent(&self, spring: usize) -> f64 {
        (self.depth - self.feet[spring] - self.caps[spring]).max(0.0)
    }

    /// Gaps with the dents below them [m].
    pub(super) fn dented(&self) -> Vec<f64> {
        let dent = |spring: usize| if spring < self.touched { self.dent(spring) } else { 0.0 };
        self.feet.iter().enumerate().map(|(spring, foot)| foot + dent(spring)).collect()
    }

    /// Σ overlap d(dent) [m²].
    pub(super) fn yielded(&self) -> f64 {
        self.yielded + (0..self.touched).map(|spring| self.caps[spring] * self.dent(spring)).sum::<f64>()
    }

    /// The larger depth that carries a force [N]: the last touch before it is found by ever longer, then ever shorter steps.
    pub(super) fn carried(&self, line: &Line, force: f64) -> Result<f64, ContactError> {
        let (mut here, mut stride, mut grows) = (self.clone(), 1, true);
        while stride > 0 {
            let next = line.gaps.get(here.touched + stride - 1);
            let ahead = next.map(|&gap| {
                let mut ahead = here.clone();
                ahead.go(line, gap);
                ahead
            });
            match ahead.filter(|ahead| ahead.state(line).force < force) {
                Some(ahead) => here = ahead,
                None => grows = false,
            }
            stride = if grows { 2 * stride } else { stride / 2 };
        }
        here.carried_by_those(line, force)
    }

    /// The depth at which the springs touched carry a force [N] if no other one is touched: as the depth grows they give way
    /// one by one.
    fn carried_by_those(&self, line: &Line, force: f64) -> Result<f64, ContactError> {
        let mut rooms: Vec<f64> = self.touching().map(|(overlap, cap)| (cap - overlap).max(0.0)).collect();
        rooms.sort_unstable_by(f64::total_cmp);
        let borne: f64 = self.touching().map(|(overlap, _)| overlap).sum();
        let needed = force / line.stiffness;
        let (mut missing, mut way) = ((needed - borne).max(0.0), 0.0);
        for (given_way, &room) in rooms.iter().enumerate() {
            let rising = number(rooms.len() - given_way);
            if rising * (room - way) >= missing {
                return Ok(self.depth + way + missing / rising);
            }
            missing -= rising * (room - way);
            way = room;
        }
        if missing <= ROUNDINGS * number(rooms.len()) * f64::EPSILON * needed {
            return Ok(self.depth + way);
        }
        Err(BedError::Yields { force, most: line.stiffness * self.caps.iter().sum::<f64>() }.into())
    }

    /// Overlaps and largest overlaps of the springs touched [m].
    fn touching(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        self.feet.iter().zip(&self.caps).take(self.touched).map(|(foot, &cap)| ((self.depth - foot).min(cap), cap))
    }

    pub(super) fn state(&self, line: &Line) -> BedState {
        let (mut sum, mut squares, mut rising) = (0.0, 0.0, 0);
        let rounding = ROUNDINGS * f64::EPSILON * self.depth.abs();
        for (overlap, cap) in self.touching() {
            sum += overlap;
            squares += overlap * overlap;
            rising += usize::from(overlap > 0.0 && overlap < cap - rounding);
        }
        BedState {
            indentation: self.depth,
            force: line.stiffness * sum,
            stiffness: line.stiffness * number(rising),
            energy: 0.5 * line.stiffness * squares,
        }
    }
}

/// Roundings of the depth, or of a force, within which a spring bears all it can.
const ROUNDINGS: f64 = 4.0;

/// Part by which a patch may have grown since its caps were raised: they are too low by no more, and one spring costs the same
/// however long the line is. Shorter patches than 1/LAG springs are never behind.
pub(super) const LAG: f64 = 1.0 / 1024.0;

/// The parts up to each border between springs, from the end of a patch to its middle, of ∫ 2√(l² − x²) dx over the `count`
/// springs of l = count/2, in their widths: l²(θ − sin θ cos θ) with sin²(θ/2) = y/2l.
fn segments(count: usize) -> impl Iterator<Item = f64> {
    let diameter = number(count);
    (0..=count.div_ceil(2)).map(move |border| {
        let part = (number(border) / diameter).min(1.0);
        0.5 * diameter * diameter * (part.sqrt().asin() - (part * (1.0 - part)).sqrt() * (1.0 - 2.0 * part))
    })
}
