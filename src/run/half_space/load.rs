//! The normal load on pixels as a function of the depth, solved where friction asks for it.

use super::pressed::Pressed;
use super::state::{Pressing, State, of_disc};
use crate::friction::load::{Carried, LinearProduct, NormalLoad, Slice, SpringDepth};
use crate::halfspace::{HalfSpaceError, Prescribed, Solution, Start};
use crate::shape::{Boundary, Shape};
use ndarray::Array2;
use std::cell::RefCell;
use std::collections::HashMap;

/// Below this part of its depth a slice is told by the stiffness at both ends: what its pixels join in steps is then less
/// than what two solutions miss each.
const NARROW: f64 = 1e-5;

/// What is known of a depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Known {
    /// What it carries.
    carried: Carried,
    /// Area of contact \[m²\].
    pub(super) area: f64,
    /// Radius of a contact that is one disc \[m\].
    pub(super) radius: Option<f64>,
}

/// Force, stiffness and energy of elastic bodies at the depths at which they have been solved.
///
/// The stiffness of pixels that touch is the derivative of their force, and that of their energy: the moments between two
/// depths are those of a measure, whatever the pixels.
#[derive(Debug)]
pub(super) struct PixelLoad<'p> {
    pressing: Pressing<'p>,
    /// The tip whose pressures are Hertz'.
    tip: Option<&'p Shape>,
    known: RefCell<HashMap<u64, Known>>,
    last: RefCell<Option<Array2<f64>>>,
    /// Pressures under the last flat punch of a contact's outline.
    punch: RefCell<Option<Array2<f64>>>,
    refused: RefCell<Option<HalfSpaceError>>,
}

impl<'p> PixelLoad<'p> {
    pub(super) fn new(pressing: Pressing<'p>, tip: Option<&'p Shape>) -> Self {
        let (known, last, punch) = (RefCell::default(), RefCell::default(), RefCell::default());
        Self { pressing, tip, known, last, punch, refused: RefCell::default() }
    }

    /// Takes over a state that has been solved already.
    pub(super) fn learn(&self, state: &State) {
        let Some(depth) = state.normal.indentation.filter(|&depth| depth > 0.0) else { return };
        let known = self.of(state, state.normal.contact_radius);
        self.known.borrow_mut().insert(depth.to_bits(), known);
    }

    /// What is known of the place of a spring, which has been asked for before.
    pub(super) fn at(&self, place: SpringDepth) -> Known {
        let known = self.known.borrow().get(&place.depth().to_bits()).copied();
        known.unwrap_or(Known { carried: Carried::default(), area: 0.0, radius: self.tip.map(|_| 0.0) })
    }

    /// Why a depth could not be solved, if one could not.
    pub(super) fn refusal(&self) -> Option<HalfSpaceError> {
        self.refused.borrow_mut().take()
    }

    /// Number of pixels.
    pub(super) fn pixels(&self) -> usize {
        self.pressing.heights.values.len()
    }

    /// Depth \[m\] under a force \[N\].
    pub(super) fn depth(&self, force: f64) -> Result<f64, HalfSpaceError> {
        let last = self.last.borrow();
        let start = last.as_ref().map_or(Start::Coarser, |last| Start::Pressure(last.view()));
        Ok(self.pressing.solve(Prescribed::Force(force), start)?.indentation - self.pressing.touch)
    }

    fn of(&self, state: &State, radius: Option<f64>) -> Known {
        let modulus = self.pressing.modulus;
        let carried = Carried {
            radius: 0.5 * state.normal.stiffness / modulus,
            load: 0.5 * state.normal.force / modulus,
            energy: state.normal.stored.elastic / modulus,
        };
        Known { carried, area: state.pixels.area, radius }
    }

    /// The contact at a depth \[m\] above zero.
    pub(super) fn solution(&self, depth: f64) -> Result<Solution, HalfSpaceError> {
        let mut last = self.last.borrow_mut();
        let start = last.as_ref().map_or(Start::Coarser, |last| Start::Pressure(last.view()));
        let solution = self.pressing.solve(Prescribed::Indentation(self.pressing.touch + depth), start)?;
        *last = Some(solution.pressure.clone());
        Ok(solution)
    }

    fn solved(&self, depth: f64) -> Result<Known, HalfSpaceError> {
        let solution = self.solution(depth)?;
        let stiffness = self.pressing.stiffness(&solution, &mut self.punch.borrow_mut())?;
        let gap = self.pressing.gap(&solution);
        let pressed = Pressed::elastic(solution, gap);
        let state = self.pressing.told(&pressed, stiffness);
        let radius = self.tip.and_then(|tip| of_disc(Some(tip), &pressed.contact, &state.pixels));
        Ok(self.of(&state, radius))
    }

    fn carried(&self, place: SpringDepth) -> Carried {
        self.at(place).carried
    }
}

/// Whether a state is one in which nothing slips before all does: the full contact of what repeats has no stiffness.
pub(super) fn is_rigid(state: &State, pressing: &Pressing<'_>) -> bool {
    state.full && pressing.boundary == Boundary::Periodic
}

impl NormalLoad for PixelLoad<'_> {
    fn place(&self, reference: f64, below: f64) -> Option<SpringDepth> {
        let depth = reference - below;
        if depth <= 0.0 {
            return Some(SpringDepth::new((reference, below), 0.0));
        }
        let known = self.known.borrow().get(&depth.to_bits()).copied();
        let known = match known.map_or_else(|| self.solved(depth), Ok) {
            Ok(known) => known,
            Err(error) => {
                self.refused.borrow_mut().get_or_insert(error);
                return None;
            }
        };
        self.known.borrow_mut().insert(depth.to_bits(), known);
        Some(SpringDepth::new((reference, below), known.carried.radius))
    }

    fn increment(&self, (lower, upper): Slice) -> f64 {
        let (below, above) = (self.carried(lower), self.carried(upper));
        let rise = lower.rise(upper);
        if rise < NARROW * upper.depth() { rise * 0.5 * (below.radius + above.radius) } else { above.load - below.load }
    }

    fn integral(&self, (lower, upper): Slice, product: LinearProduct) -> f64 {
        let (below, above) = (self.carried(lower), self.carried(upper));
        let rise = lower.rise(upper);
        if rise < NARROW * upper.depth() {
            product.over(above.radius - below.radius)
        } else {
            Carried::integral(&below, &above, rise, product)
        }
    }
}
