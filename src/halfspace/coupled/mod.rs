//! Normal and tangential contact together: shear under Coulomb's law on every pixel, which presses where it lifts, and
//! pressures that draw the surface along where the bodies are not elastically similar.
//!
//! A step to the next depth or force and slide is implicit: sought are pressures and shear at its end with
//!
//! > g ≥ 0, p ≥ 0, p·g = 0, |q| ≤ μp, slip against q where |q| = μp, none where |q| < μp,
//!
//! the slip being what the surface has gone against the slider since the last state (Kalker 1990, § 4.1). Contact and shear are
//! found in turns, each under the other, until neither changes (Panagiotopoulos 1975). Each step is an inequality of its own, so
//! that a history is right to the first order of its steps; one in which every ratio stays as it is, such as pressing a ball, has
//! its steps' error in the pixels that they join.

mod kernel;
mod response;
mod stuck;
#[cfg(test)]
mod tests;

pub use response::CoupledResponse;

use super::{Boundary, HalfSpaceError, Prescribed, PressedMap, Settings, Solution, Start, SurfaceResponse, solve_on};
use crate::material::Pair;
use ndarray::{Array2, ArrayView2};
use response::{Along, Work};
use stuck::{Found, Stuck, both};

/// Rounds in which contact and shear may find each other.
const ROUNDS: usize = 100;
/// Tolerance of the first round, and part of what a round has changed to which the next is found.
const COARSE: f64 = 1e-3;
const CLOSER: f64 = 0.03;
/// Least slip that counts, as part of the largest displacement.
const LEAST: f64 = 1e-3;
/// How far from its bound a shear is that sticks.
const HELD: f64 = 1e-6;

/// A height map that rubs on an elastic half-space, and what its history has left there.
#[derive(Debug)]
pub struct RubbingMap<'h> {
    heights: ArrayView2<'h, f64>,
    response: CoupledResponse,
    pressed: SurfaceResponse,
    coefficient: f64,
    settings: Settings,
    pressure: Option<Array2<f64>>,
    /// Largest shear stress \[Pa\].
    bounds: Vec<f64>,
    shear: Along,
    /// Displacement along the surface \[m\].
    along: Along,
    slide: [f64; 2],
    dissipated: f64,
    work: Work,
}

/// A state of a map that rubs.
#[derive(Debug, Clone)]
pub struct RubbedState {
    /// Pressures, and the displacement into the surface under them and the shear.
    pub contact: Solution,
    /// Shear stress \[Pa\] on the surface below, along x and y.
    pub shear: [Array2<f64>; 2],
    /// Pixels that stick.
    pub stuck: Array2<bool>,
    /// Elastic energy \[J\] of the shear, ½ ∫ q·u dA.
    pub stored: f64,
    /// Work of friction so far \[J\].
    pub dissipated: f64,
    /// Stiffness \[N/m\] along x of the pixels that stick, whose pressures do not change.
    pub stiffness: f64,
}

impl RubbedState {
    /// Force \[N\] along x and y that the slider drags the surface with.
    #[must_use]
    pub fn force(&self) -> [f64; 2] {
        let [width, height] = self.contact.pixel;
        [0, 1].map(|axis| width * height * self.shear[axis].sum())
    }
}

impl<'h> RubbingMap<'h> {
    /// Heights of the rigid map \[m\] over pixels of the width and height `pixel` \[m\], apart; the coefficient of friction μ may be
    /// infinite: nothing slips.
    #[must_use]
    pub fn new(
        heights: ArrayView2<'h, f64>,
        (pixel, boundary): ([f64; 2], Boundary),
        (pair, coefficient): (Pair, f64),
        settings: Settings,
    ) -> Self {
        let size: [usize; 2] = heights.dim().into();
        let nothing = || [vec![0.0; heights.len()], vec![0.0; heights.len()]];
        Self {
            heights,
            response: CoupledResponse::new(size, pixel, boundary, pair),
            pressed: SurfaceResponse::new(size, pixel, boundary),
            coefficient,
            settings,
            pressure: None,
            bounds: vec![0.0; heights.len()],
            shear: nothing(),
            along: nothing(),
            slide: [0.0; 2],
            dissipated: 0.0,
            work: Work::default(),
        }
    }

    /// Leads the map to a depth or force, slid by `slide` \[m\] along x and y from where it was at first.
    ///
    /// # Errors
    /// As [`solve`](super::solve), and contact and shear that do not find each other.
    pub fn advance(&mut self, control: Prescribed, slide: [f64; 2]) -> Result<RubbedState, HalfSpaceError> {
        let mut shear = self.shear.clone();
        let mut lift = self.response.lift_of(&shear, &mut self.work);
        let asked = self.settings.tolerance;
        // Neither is found more closely than the other yet allows.
        let mut settings = Settings { tolerance: asked.max(COARSE), ..self.settings };
        for _ in 0..ROUNDS {
            let mut contact = self.press(control, &lift, &settings)?;
            let pressure: Vec<f64> = contact.pressure.iter().copied().collect();
            let bounds: Vec<f64> = pressure.iter().map(|&pressure| self.bound(pressure)).collect();
            let drawn = self.response.by_pressure(&pressure, &mut self.work);
            let found = self.rub((&drawn, &bounds), (&shear, slide), &contact, &settings)?;
            let next = self.response.lift_of(&found.shear, &mut self.work);
            let change = lift.iter().zip(&next).fold(0.0, |most: f64, (one, other)| most.max((one - other).abs()));
            let scale = contact.displacement.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
            self.pressure = Some(contact.pressure.clone());
            shear.clone_from(&found.shear);
            if change <= asked * scale && settings.tolerance <= asked {
                contact.displacement += &self.response.on_pixels(&lift);
                return self.taken(contact, (found, bounds), slide);
            }
            lift = next;
            let changed = if scale > 0.0 { change / scale } else { 0.0 };
            settings.tolerance = (CLOSER * changed).clamp(asked, settings.tolerance);
        }
        Err(HalfSpaceError::NotConverged { iterations: ROUNDS, residual: f64::NAN, tolerance: asked })
    }

    fn bound(&self, pressure: f64) -> f64 {
        if pressure > 0.0 { self.coefficient * pressure } else { 0.0 }
    }

    /// The contact over a surface that shear has lifted.
    fn press(&self, control: Prescribed, lift: &[f64], settings: &Settings) -> Result<Solution, HalfSpaceError> {
        let heights = &self.heights + &self.response.on_pixels(lift);
        let (pixel, boundary) = self.response.pixels();
        let modulus = self.response.pair().normal;
        let map = PressedMap { heights: heights.view(), pixel, modulus, boundary, control };
        let start = self.pressure.as_ref().map_or(Start::Coarser, |pressure| Start::Pressure(pressure.view()));
        solve_on(&self.pressed, &map, start, settings)
    }

    /// The shear on pressures that draw the surface along.
    fn rub(
        &mut self,
        (drawn, bounds): (&Along, &[f64]),
        (start, slide): (&Along, [f64; 2]),
        contact: &Solution,
        settings: &Settings,
    ) -> Result<Found, HalfSpaceError> {
        let mut free = drawn.clone();
        for (axis, free) in free.iter_mut().enumerate() {
            let slid = slide[axis] - self.slide[axis];
            free.iter_mut().zip(&self.along[axis]).for_each(|(free, before)| *free -= before + slid);
        }
        let pixels = bounds.iter().enumerate().filter(|(_, bound)| **bound > 0.0);
        let most = pixels.fold(0.0, |most: f64, (index, _)| most.max(free[0][index].hypot(free[1][index])));
        let deepest = contact.displacement.iter().copied().fold(0.0, f64::max);
        let tolerance = settings.tolerance * most.max(LEAST * deepest);
        let most = settings.max_iterations;
        let stuck = Stuck { response: &self.response, bounds, free: &free, tolerance, most };
        stuck.solve(start, &mut self.work)
    }

    /// The state, which is the past of the next.
    fn taken(
        &mut self,
        contact: Solution,
        (found, bounds): (Found, Vec<f64>),
        slide: [f64; 2],
    ) -> Result<RubbedState, HalfSpaceError> {
        let Found { shear, slip, residual } = found;
        let area = contact.pixel[0] * contact.pixel[1];
        self.dissipated -= area * both(&shear, &slip);
        for (axis, along) in self.along.iter_mut().enumerate() {
            let slid = slide[axis] - self.slide[axis];
            along.iter_mut().zip(&slip[axis]).for_each(|(along, slip)| *along += slip + slid);
        }
        let sticks = |index: usize| {
            let [slip, shear] = [&slip, &shear].map(|field| field[0][index].hypot(field[1][index]));
            bounds[index] > 0.0 && shear < bounds[index] * (1.0 - HELD) && slip <= 2.0 * residual
        };
        let held: Vec<bool> = (0..bounds.len()).map(sticks).collect();
        let stiffness = area * self.stiffness(&held)?;
        let (rows, columns) = contact.pressure.dim();
        let stuck = Array2::from_shape_fn((rows, columns), |(row, column)| held[row * columns + column]);
        (self.shear, self.bounds, self.slide) = (shear, bounds, slide);
        Ok(RubbedState {
            contact,
            shear: [0, 1].map(|axis| self.response.on_pixels(&self.shear[axis])),
            stuck,
            stored: 0.5 * area * both(&self.shear, &self.along),
            dissipated: self.dissipated,
            stiffness,
        })
    }

    /// Σ of the shear stress along x \[Pa/m\] that moves the pixels held by one metre.
    fn stiffness(&mut self, held: &[bool]) -> Result<f64, HalfSpaceError> {
        let count = held.iter().filter(|held| **held).count();
        if count == 0 {
            return Ok(0.0);
        }
        let bounds: Vec<f64> = held.iter().map(|&held| if held { f64::INFINITY } else { 0.0 }).collect();
        let nothing = vec![0.0; held.len()];
        let free = [vec![-1.0; held.len()], nothing.clone()];
        let (tolerance, most) = (self.settings.tolerance.max(1e-8), self.settings.max_iterations);
        let stuck = Stuck { response: &self.response, bounds: &bounds, free: &free, tolerance, most };
        let found = stuck.solve(&[nothing.clone(), nothing], &mut self.work)?;
        Ok(found.shear[0].iter().sum())
    }
}
