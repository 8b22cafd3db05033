//! One solved state of a contact on pixels.

use super::heights::Heights;
use super::pressed::Pressed;
use super::settings;
use crate::contact::state::{Normal, Tangential};
use crate::halfspace::{
    Boundary, HalfSpaceError, Prescribed, PressedMap, Settings, Solution, Start, SurfaceResponse, bytes_needed, leak,
    pieces, solve_on,
};
use crate::run::record::PixelContact;
use crate::scene::plan::HalfSpacePlan;
use crate::scene::solver::{Heading, Leak};
use crate::shape::Shape;
use ndarray::{Array2, ArrayView2, Zip, s};
use std::f64::consts::PI;

/// What a state is told of, beside what is prescribed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct State {
    pub(super) normal: Normal,
    pub(super) pixels: PixelContact,
    /// Largest distance of a pixel in contact from the tip along x and y [m].
    pub(super) extent: [f64; 2],
    /// Whether a pixel at the border is in contact.
    pub(super) meets_border: bool,
    /// Number of pixels in contact, and whether that is all of them.
    pub(super) count: usize,
    pub(super) full: bool,
    /// Whether nothing presses and nothing pulls.
    pub(super) parted: bool,
    /// How far what leaks through every second pixel is from what does through all, of the larger.
    pub(super) leak_apart: f64,
    /// What holds it back along the surface, if there is friction.
    pub(super) tangential: Option<Tangential>,
}

/// A surface to be pressed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pressing<'h> {
    pub(super) heights: &'h Heights,
    /// Height of first touch [m].
    pub(super) touch: f64,
    /// E* [Pa].
    pub(super) modulus: f64,
    /// G* \[Pa\] along x, of the contact as far as it is drawn out.
    pub(super) tangential: f64,
    pub(super) boundary: Boundary,
    pub(super) settings: Settings,
    /// What pressures do to the surface.
    pub(super) response: &'h SurfaceResponse,
}

/// What pressures do to the pixels of `heights` in a plan, if they fit into memory.
pub(super) fn response(plan: &HalfSpacePlan, heights: &Heights) -> Result<SurfaceResponse, HalfSpaceError> {
    let (rows, columns) = heights.values.dim();
    let (needed, limit) = (bytes_needed([rows, columns], plan.boundary), settings(plan).memory_limit);
    if needed > limit {
        return Err(HalfSpaceError::Memory { rows, columns, needed, limit });
    }
    Ok(SurfaceResponse::over(plan.ground.clone(), [rows, columns], heights.pixel, plan.boundary))
}

impl<'h> Pressing<'h> {
    /// The heights of a plan, pressed on their `response`.
    pub(super) fn of(plan: &HalfSpacePlan, heights: &'h Heights, response: &'h SurfaceResponse) -> Self {
        Self {
            heights,
            touch: heights.touch_of(&plan.indenter),
            modulus: plan.pair.normal,
            tangential: plan.pair.tangential,
            boundary: plan.boundary,
            settings: settings(plan),
            response,
        }
    }

    /// The state under a force [N] or at an approach [m].
    pub(super) fn solve(&self, control: Prescribed, start: Start<'_>) -> Result<Solution, HalfSpaceError> {
        self.pressed(&self.heights.values, control, start)
    }

    pub(super) fn pressed(
        &self,
        heights: &Array2<f64>,
        control: Prescribed,
        start: Start<'_>,
    ) -> Result<Solution, HalfSpaceError> {
        let Self { modulus, boundary, settings, .. } = *self;
        let map = PressedMap { heights: heights.view(), pixel: self.heights.pixel, modulus, boundary, control };
        solve_on(self.response, &map, start, &settings)
    }

    /// dF/dd [N/m] of a contact that keeps its place, as it does to the first order: the force of a flat punch of its
    /// outline. Infinite in full contact of what repeats, unless a layer ends on a rigid body. The pressures under the punch
    /// start from `last`, those of the last one, and become it.
    pub(super) fn stiffness(&self, solution: &Solution, last: &mut Option<Array2<f64>>) -> Result<f64, HalfSpaceError> {
        let count = solution.contact_pixels();
        if count == 0 {
            return Ok(0.0);
        }
        if count == solution.pressure.len() && self.boundary == Boundary::Periodic {
            let [x, y] = self.heights.sides();
            return Ok(x * y * self.modulus / self.response.compression());
        }
        let punch = solution.pressure.mapv(|pressure| if pressure > 0.0 { 0.0 } else { f64::INFINITY });
        let depth = (self.heights.pixel[0] * self.heights.pixel[1]).sqrt();
        let start = last.as_ref().map_or(Start::Coarser, |last| Start::Pressure(last.view()));
        let punched = self.pressed(&punch, Prescribed::Indentation(depth), start)?;
        let stiffness = punched.force() / depth;
        *last = Some(punched.pressure);
        Ok(stiffness)
    }

    /// Gap [m] between the surfaces.
    pub(super) fn gap(&self, solution: &Solution) -> Array2<f64> {
        let mut gap = solution.displacement.clone();
        Zip::from(&mut gap).and(&self.heights.values).and(&solution.pressure).for_each(|gap, height, pressure| {
            *gap = if *pressure > 0.0 { 0.0 } else { (*gap + (height - solution.indentation)).max(0.0) };
        });
        gap
    }

    /// What a gap [m] lets through of a fluid [m³/(Pa s)], and through every second pixel of it; `None` where it is endless.
    pub(super) fn leaks(&self, gap: &Array2<f64>, fluid: Leak) -> Result<Option<[f64; 2]>, HalfSpaceError> {
        let through = |gap: ArrayView2<'_, f64>, [width, height]: [f64; 2]| match fluid.along {
            Heading::X => leak(gap, [width, height], self.boundary),
            Heading::Y => leak(gap.t(), [height, width], self.boundary),
        };
        let pixel = self.heights.pixel;
        let fine = through(gap.view(), pixel)?;
        let coarse = through(gap.slice(s![..;2, ..;2]), pixel.map(|side| 2.0 * side))?;
        Ok(fine.zip(coarse).map(|(fine, coarse)| [fine, coarse].map(|through| through / fluid.viscosity.si())))
    }

    /// The gap [m] of bodies that do not press on each other, at the depth `depth` ≤ 0 [m].
    pub(super) fn open(&self, depth: f64) -> Array2<f64> {
        self.heights.values.mapv(|height| (height - self.touch - depth).max(0.0))
    }

    /// Bodies at the depth `depth` ≤ 0 [m].
    pub(super) fn apart(&self, depth: f64) -> State {
        let mean = self.heights.values.iter().map(|height| height - self.touch).sum::<f64>()
            / self.heights.values.len() as f64;
        State {
            normal: Normal { indentation: Some(depth), ..Normal::default() },
            pixels: PixelContact { mean_gap: Some(mean - depth).filter(|gap| gap.is_finite()), ..PixelContact::APART },
            extent: [0.0; 2],
            meets_border: false,
            count: 0,
            full: false,
            parted: true,
            leak_apart: 0.0,
            tangential: None,
        }
    }

    /// Elastic energy [J] of pressures and the displacements under them.
    pub(super) fn elastic(&self, pressure: &Array2<f64>, displacement: &Array2<f64>) -> f64 {
        0.5 * self.heights.pixel[0] * self.heights.pixel[1] * (pressure * displacement).sum()
    }

    /// What a solution tells; `stiffness` [N/m] is known already.
    pub(super) fn told(&self, pressed: &Pressed, stiffness: f64) -> State {
        let solution = &pressed.contact;
        let contact = solution.pressure.mapv(|pressure| pressure > 0.0);
        let count = solution.contact_pixels();
        let held = match &pressed.pull {
            Some(pull) => pull.mapv(|pull| pull > pressed.faint),
            None => contact.clone(),
        };
        State {
            normal: Normal {
                indentation: Some(solution.indentation - self.touch),
                force: pressed.force(),
                contact_radius: None,
                stiffness,
                stored: pressed.stored,
                dissipated: pressed.dissipated,
            },
            pixels: self.touching(pressed, &contact),
            extent: self.extent(&held),
            meets_border: meets_border(&held),
            count,
            full: count == contact.len(),
            parted: pressed.parted(),
            leak_apart: 0.0,
            tangential: None,
        }
    }

    /// Area, gap and pieces of the pixels that touch.
    fn touching(&self, pressed: &Pressed, contact: &Array2<bool>) -> PixelContact {
        let (patches, gap) = (pieces(contact, self.boundary), pieces(&contact.mapv(|touches| !touches), self.boundary));
        let sides = self.heights.sides();
        let whole = sides[0] * sides[1];
        let full = contact.iter().all(|touches| *touches);
        let area = if full { whole } else { pressed.contact.corrected_area().max(0.0) };
        PixelContact {
            area,
            area_fraction: area / whole,
            mean_gap: pressed.gap.mean().filter(|gap| gap.is_finite()),
            peak_pressure: pressed.peak_pressure(),
            patches: patches.count,
            percolates: patches.percolates,
            gap_percolates: gap.percolates,
            leak: None,
        }
    }

    fn extent(&self, contact: &Array2<bool>) -> [f64; 2] {
        let (rows, columns) = contact.dim();
        let far = |index: usize, count: usize, pixel: f64| (index as f64 - (count / 2) as f64).abs() * pixel;
        let touching = contact.indexed_iter().filter(|(_, touches)| **touches);
        touching.fold([0.0; 2], |[x, y]: [f64; 2], ((row, column), _)| {
            [x.max(far(column, columns, self.heights.pixel[0])), y.max(far(row, rows, self.heights.pixel[1]))]
        })
    }
}

fn meets_border(contact: &Array2<bool>) -> bool {
    let (rows, columns) = contact.dim();
    let outer = |(row, column): (usize, usize)| row == 0 || column == 0 || row + 1 == rows || column + 1 == columns;
    contact.indexed_iter().any(|(place, touches)| *touches && outer(place))
}

/// Radius [m] of a contact about the tip of a smooth shape: of Hertzian pressures from their second moments, else from
/// the area.
pub fn radius_of(shape: &Shape, solution: &Solution) -> f64 {
    if let Shape::Paraboloid(_) | Shape::Ellipsoid(_) = shape {
        let [a, b] = solution.hertzian_semi_axes();
        (a * b).sqrt()
    } else if let Shape::FlatPunch(_) = shape {
        solution.contact_radius()
    } else {
        radius_of_area(solution)
    }
}

fn radius_of_area(solution: &Solution) -> f64 {
    (solution.corrected_area().max(0.0) / PI).sqrt()
}

/// The same, where the contact is one disc about the tip; that of its area, if the pressures are not those of `shape`.
pub(super) fn of_disc(shape: Option<&Shape>, solution: &Solution, pixels: &PixelContact) -> Option<f64> {
    let (rows, columns) = solution.pressure.dim();
    let disc = pixels.patches == 1 && solution.pressure[[rows / 2, columns / 2]] > 0.0;
    disc.then(|| shape.map_or_else(|| radius_of_area(solution), |shape| radius_of(shape, solution)))
}
