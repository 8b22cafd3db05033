//! What a solved contact tells: pressure, displacement, force, area, radius.

use ndarray::Array2;

use super::input::Raw;
use super::vector::on_pixels;
use super::{Boundary, PressedMap};

/// Solution of a half-space contact.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    /// Pressure on each pixel \[Pa\], never negative.
    pub pressure: Array2<f64>,
    /// Displacement of each pixel into the half-space \[m\].
    pub displacement: Array2<f64>,
    /// Approach d of the height map's zero level and the undeformed surface \[m\].
    pub indentation: f64,
    /// Relative residual, computed from the pressure returned.
    pub residual: f64,
    /// Conjugate gradient iterations on the finest grid.
    pub iterations: usize,
    /// Products with the influence matrix on the finest grid.
    pub products: usize,
    /// Upper bound of the bytes used.
    pub bytes: u64,
    /// Pixel width and height \[m\].
    pub pixel: [f64; 2],
    /// Edge of the map.
    pub boundary: Boundary,
}

/// (π − 1 + ln 2)/24: share of a boundary pixel that counting gives too much, averaged over edges
/// of all directions (Yastrebov, Anciaux & Molinari 2017, eq. 8).
const EDGE_SHARE: f64 = (std::f64::consts::PI - 1.0 + std::f64::consts::LN_2) / 24.0;

impl Solution {
    pub(super) fn new(problem: &PressedMap<'_>, raw: Raw) -> Self {
        let pixels = problem.heights.dim();
        Self {
            pressure: on_pixels(raw.pressure, pixels),
            displacement: on_pixels(raw.displacement, pixels),
            indentation: raw.approach,
            residual: raw.residual,
            iterations: raw.iterations,
            products: raw.products,
            bytes: raw.bytes,
            pixel: problem.pixel,
            boundary: problem.boundary,
        }
    }

    /// Normal force F = Σ p ΔxΔy \[N\].
    pub fn force(&self) -> f64 {
        self.pressure.sum() * self.pixel_area()
    }

    /// Largest pressure \[Pa\].
    pub fn peak_pressure(&self) -> f64 {
        self.pressure.iter().copied().fold(0.0, f64::max)
    }

    /// Force over contact area \[Pa\]; zero without contact.
    pub fn mean_pressure(&self) -> f64 {
        let area = self.contact_area();
        if area > 0.0 { self.force() / area } else { 0.0 }
    }

    /// Number of pixels under pressure.
    pub fn contact_pixels(&self) -> usize {
        self.pressure.iter().filter(|&&p| p > 0.0).count()
    }

    /// Area of the pixels under pressure \[m²\]; first order in the pixel size.
    pub fn contact_area(&self) -> f64 {
        self.contact_pixels() as f64 * self.pixel_area()
    }

    /// Contact area over the area of the map.
    pub fn area_fraction(&self) -> f64 {
        self.contact_pixels() as f64 / self.pressure.len() as f64
    }

    /// Contact area less what counting whole pixels adds along its edge \[m²\]:
    /// A − (π − 1 + ln 2)/24 · S √(ΔxΔy) with S the length of the edge along the pixels' sides
    /// (Yastrebov, Anciaux & Molinari 2017); meant for contacts of many pixels with edges in all directions.
    pub fn corrected_area(&self) -> f64 {
        self.contact_area() - EDGE_SHARE * self.edge_length() * self.pixel_area().sqrt()
    }

    /// Radius of the circle of the contact's area, √(A/π) \[m\].
    pub fn contact_radius(&self) -> f64 {
        (self.contact_area() / std::f64::consts::PI).sqrt()
    }

    /// Semi-axes of a Hertzian contact with this pressure's second moments, larger first \[m\]:
    /// ⟨x²⟩ = a²/5 under p ∝ √(1 − x²/a² − y²/b²). Second order in the pixel size, for one contact away from the
    /// edges of the map; one a single pixel wide has the moment of that pixel.
    pub fn hertzian_semi_axes(&self) -> [f64; 2] {
        let [xx, xy, yy] = self.second_moments();
        let [xx, yy] = [(xx, self.pixel[0]), (yy, self.pixel[1])]
            .map(|(moment, side)| if moment > 0.0 || self.contact_pixels() == 0 { moment } else { side * side / 12.0 });
        let (mean, spread) = (0.5 * (xx + yy), (0.5 * (xx - yy)).hypot(xy));
        [(5.0 * (mean + spread)).sqrt(), (5.0 * (mean - spread).max(0.0)).sqrt()]
    }

    fn pixel_area(&self) -> f64 {
        self.pixel[0] * self.pixel[1]
    }

    /// Length of the sides between a pixel in contact and one out of it.
    fn edge_length(&self) -> f64 {
        let (rows, columns) = self.pressure.dim();
        let contact = |row: usize, column: usize| self.pressure[[row, column]] > 0.0;
        let next = |index: usize, count: usize| match self.boundary {
            Boundary::Periodic => Some((index + 1) % count),
            Boundary::Free => Some(index + 1).filter(|&next| next < count),
        };
        let mut sides = [0usize; 2];
        for ((row, column), pressure) in self.pressure.indexed_iter() {
            let own = *pressure > 0.0;
            sides[1] += usize::from(next(column, columns).is_some_and(|column| contact(row, column) != own));
            sides[0] += usize::from(next(row, rows).is_some_and(|row| contact(row, column) != own));
        }
        sides[0] as f64 * self.pixel[0] + sides[1] as f64 * self.pixel[1]
    }

    /// Second moments of the pressure about its centre, over the force.
    fn second_moments(&self) -> [f64; 3] {
        let place = |(row, column): (usize, usize)| [column as f64 * self.pixel[0], row as f64 * self.pixel[1]];
        let total = self.pressure.sum();
        if total <= 0.0 {
            return [0.0; 3];
        }
        let mean =
            |axis: usize| self.pressure.indexed_iter().map(|(index, p)| p * place(index)[axis]).sum::<f64>() / total;
        let (centre_x, centre_y) = (mean(0), mean(1));
        let mut sums = [0.0; 3];
        for (index, p) in self.pressure.indexed_iter() {
            let [x, y] = place(index);
            let (x, y) = (x - centre_x, y - centre_y);
            sums[0] += p * x * x;
            sums[1] += p * x * y;
            sums[2] += p * y * y;
        }
        sums.map(|sum| sum / total)
    }
}
