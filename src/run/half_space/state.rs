//! One solved state of a contact on pixels.

use super::heights::Heights;
use crate::contact::adhesion::line::Energy;
use crate::contact::state::Normal;
use crate::halfspace::{Boundary, HalfSpaceError, Prescribed, PressedMap, Settings, Solution, Start, pieces, solve};
use crate::run::record::PixelContact;
use crate::shape::Shape;
use ndarray::{Array2, Zip};
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
}

/// A surface to be pressed.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pressing<'h> {
    pub(super) heights: &'h Heights,
    /// Height of first touch [m].
    pub(super) touch: f64,
    /// E* [Pa].
    pub(super) modulus: f64,
    pub(super) boundary: Boundary,
    pub(super) settings: Settings,
}

impl Pressing<'_> {
    /// The state under a force [N] or at an approach [m].
    pub(super) fn solve(&self, control: Prescribed, start: Start<'_>) -> Result<Solution, HalfSpaceError> {
        self.pressed(&self.heights.values, control, start)
    }

    fn pressed(
        &self,
        heights: &Array2<f64>,
        control: Prescribed,
        start: Start<'_>,
    ) -> Result<Solution, HalfSpaceError> {
        let Self { modulus, boundary, settings, .. } = *self;
        let map = PressedMap { heights: heights.view(), pixel: self.heights.pixel, modulus, boundary, control };
        solve(&map, start, &settings)
    }

    /// dF/dd [N/m] of a contact that keeps its place, as it does to the first order: the force of a flat punch of its
    /// outline. Infinite in full contact of what repeats.
    pub(super) fn stiffness(&self, solution: &Solution) -> Result<f64, HalfSpaceError> {
        let count = solution.contact_pixels();
        if count == 0 {
            return Ok(0.0);
        }
        if count == solution.pressure.len() && self.boundary == Boundary::Periodic {
            return Ok(f64::INFINITY);
        }
        let punch = solution.pressure.mapv(|pressure| if pressure > 0.0 { 0.0 } else { f64::INFINITY });
        let depth = (self.heights.pixel[0] * self.heights.pixel[1]).sqrt();
        Ok(self.pressed(&punch, Prescribed::Indentation(depth), Start::Coarser)?.force() / depth)
    }

    /// Gap [m] between the surfaces.
    pub(super) fn gap(&self, solution: &Solution) -> Array2<f64> {
        let mut gap = solution.displacement.clone();
        Zip::from(&mut gap).and(&self.heights.values).and(&solution.pressure).for_each(|gap, height, pressure| {
            *gap = if *pressure > 0.0 { 0.0 } else { (*gap + (height - solution.indentation)).max(0.0) };
        });
        gap
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
        }
    }

    /// What a solution tells; `stiffness` [N/m] is known already.
    pub(super) fn told(&self, solution: &Solution, stiffness: f64) -> State {
        let contact = solution.pressure.mapv(|pressure| pressure > 0.0);
        let (patches, gap) =
            (pieces(&contact, self.boundary), pieces(&contact.mapv(|touches| !touches), self.boundary));
        let count = solution.contact_pixels();
        let full = count == contact.len();
        let sides = self.heights.sides();
        let area = if full { sides[0] * sides[1] } else { solution.corrected_area().max(0.0) };
        let mean_gap = self.gap(solution).mean().filter(|gap| gap.is_finite());
        let pixel_area = self.heights.pixel[0] * self.heights.pixel[1];
        let elastic = 0.5 * pixel_area * (&solution.pressure * &solution.displacement).sum();
        State {
            normal: Normal {
                indentation: Some(solution.indentation - self.touch),
                force: solution.force(),
                contact_radius: None,
                stiffness,
                stored: Energy { elastic, surface: 0.0 },
                dissipated: 0.0,
            },
            pixels: PixelContact {
                area,
                area_fraction: area / (sides[0] * sides[1]),
                mean_gap,
                peak_pressure: solution.peak_pressure(),
                patches: patches.count,
                percolates: patches.percolates,
                gap_percolates: gap.percolates,
            },
            extent: self.extent(&contact),
            meets_border: meets_border(&contact),
            count,
            full,
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
    match shape {
        Shape::Paraboloid(_) | Shape::Ellipsoid(_) => {
            let [a, b] = solution.hertzian_semi_axes();
            (a * b).sqrt()
        }
        Shape::FlatPunch(_) => solution.contact_radius(),
        _ => (solution.corrected_area().max(0.0) / PI).sqrt(),
    }
}

/// The same, where the contact is one disc about the tip.
pub(super) fn of_disc(shape: &Shape, solution: &Solution, pixels: &PixelContact) -> Option<f64> {
    let (rows, columns) = solution.pressure.dim();
    let disc = pixels.patches == 1 && solution.pressure[[rows / 2, columns / 2]] > 0.0;
    disc.then(|| radius_of(shape, solution))
}
