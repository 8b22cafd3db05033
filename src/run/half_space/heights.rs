//! Shapes as heights on pixels.

use crate::scene::plan::{HalfSpacePlan, PixelledIndenter};
use crate::scene::surface::{Source, Surface};
use crate::shape::rough::{HeightMap, RoughError, RoughnessSpectrum, rough_surface};
use crate::shape::{Boundary, Profile};
use ndarray::{Array2, s};

/// Heights on pixels, away from the half-space; +∞ where there is no material.
#[derive(Debug, Clone, PartialEq)]
pub struct Heights {
    /// Heights [m], rows along y and columns along x.
    pub values: Array2<f64>,
    /// Width and height of a pixel [m].
    pub pixel: [f64; 2],
}

impl Heights {
    /// Root mean square slope |∇h| of the pixels under pressure, by differences over two pixels; one-sided at a border.
    #[must_use]
    pub fn rms_slope_where(&self, pressure: &Array2<f64>) -> Option<f64> {
        let (rows, columns) = self.values.dim();
        let slope = |(one, other): ((usize, usize), (usize, usize)), pixel: f64| {
            let apart = (other.0 - one.0 + other.1 - one.1) as f64 * pixel;
            if apart > 0.0 { (self.values[other] - self.values[one]) / apart } else { 0.0 }
        };
        let square = |(row, column): (usize, usize)| {
            let (left, right) = ((row, column.saturating_sub(1)), (row, (column + 1).min(columns - 1)));
            let (below, above) = ((row.saturating_sub(1), column), ((row + 1).min(rows - 1), column));
            slope((left, right), self.pixel[0]).powi(2) + slope((below, above), self.pixel[1]).powi(2)
        };
        let touching = pressure.indexed_iter().filter(|(_, p)| **p > 0.0).map(|(at, _)| square(at));
        let (count, sum) =
            touching.filter(|square| square.is_finite()).fold((0u32, 0.0), |(n, sum), s| (n + 1, sum + s));
        (count > 0).then(|| (sum / f64::from(count)).sqrt())
    }

    /// A shape whose tip stands on the node in the middle; `height` [m] over x and y [m].
    pub fn about_tip([rows, columns]: [usize; 2], pixel: [f64; 2], height: impl Fn(f64, f64) -> f64) -> Self {
        let place = |index: usize, count: usize, pixel: f64| (index as f64 - (count / 2) as f64) * pixel;
        let at = |(row, column): (usize, usize)| height(place(column, columns, pixel[0]), place(row, rows, pixel[1]));
        Self { values: Array2::from_shape_fn((rows, columns), at), pixel }
    }

    /// A random surface on `grid` × `grid` pixels of its length, on the profile `base` if not on a flat.
    ///
    /// # Errors
    /// The grid does not carry the shortest wave.
    pub fn of_spectrum(
        spectrum: &RoughnessSpectrum,
        base: Option<&dyn Profile>,
        (length, grid): (f64, usize),
        seed: u64,
    ) -> Result<Self, RoughError> {
        let mut values = rough_surface(spectrum, length, grid, seed)?;
        let pixel = length / grid as f64;
        let place = |index: usize| (index as f64 + 0.5) * pixel - 0.5 * length;
        if let Some(base) = base {
            for ((row, column), height) in values.indexed_iter_mut() {
                *height += material(base, place(row).hypot(place(column)));
            }
        }
        Ok(Self { values, pixel: [pixel; 2] })
    }

    /// Every `stride`-th height of a map; its peaks reach towards the other body.
    pub fn of_map(map: &HeightMap, stride: usize) -> Self {
        let every = map.heights().slice(s![..;stride, ..;stride]);
        let pixel = [map.pixel().0 * stride as f64, map.pixel().1 * stride as f64];
        Self { values: every.mapv(|height| -height), pixel }
    }

    /// Every second height of every second row.
    pub fn thinned(&self) -> Self {
        let values = self.values.slice(s![..;2, ..;2]).to_owned();
        Self { values, pixel: self.pixel.map(|side| 2.0 * side) }
    }

    /// The lowest height [m], that of first touch.
    pub fn touch(&self) -> f64 {
        self.values.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// How much lower [m] the surface may be between its lowest pixels and those beside them than on any: the vertices of
    /// the paraboloids through nine, twice, for of a wave that four pixels carry these see six tenths.
    pub(super) fn below_touch(&self, boundary: Boundary) -> f64 {
        let (rows, columns) = self.values.dim();
        let lowest = self.touch();
        let at = |row: usize, column: usize| self.values[[row % rows, column % columns]];
        let below = |(row, column): (usize, usize), height: f64| {
            let around = |down: usize, right: usize| at(row + rows - 1 + down, column + columns - 1 + right) - height;
            let inside = row > 0 && row + 1 < rows && column > 0 && column + 1 < columns;
            let beside = [around(0, 1), around(1, 0), around(1, 2), around(2, 1)];
            let askew = [around(0, 0), around(0, 2), around(2, 0), around(2, 2)];
            let is_lowest = beside.iter().chain(&askew).all(|&other| other >= 0.0);
            if (boundary == Boundary::Free && !inside) || !is_lowest {
                return 0.0;
            }
            let [above, left, right, under] = beside;
            let mixed = 0.25 * (askew[0] - askew[1] - askew[2] + askew[3]);
            vertex([0.5 * (right - left), 0.5 * (under - above)], [left + right, above + under, mixed])
        };
        let reached = self.values.indexed_iter().map(|(at, &height)| 2.0 * below(at, height) - (height - lowest));
        reached.fold(0.0, f64::max)
    }

    /// The same, or the apex [m] of a tip that stands between the nodes.
    pub(super) fn touch_of(&self, indenter: &PixelledIndenter) -> f64 {
        match indenter {
            PixelledIndenter::Tips(tips) => tips.iter().map(|tip| tip.height).fold(self.touch(), f64::min),
            PixelledIndenter::Smooth(_) | PixelledIndenter::Ellipsoid(..) | PixelledIndenter::Rough(..) => self.touch(),
        }
    }

    /// Sides of the window along x and y [m].
    pub fn sides(&self) -> [f64; 2] {
        let (rows, columns) = self.values.dim();
        [columns as f64 * self.pixel[0], rows as f64 * self.pixel[1]]
    }
}

/// How deep the vertex of a paraboloid lies beneath the place at which it has the slopes `along` x and y and the second
/// derivatives `bent` along x, y and both; 0 where it has none.
fn vertex(along: [f64; 2], bent: [f64; 3]) -> f64 {
    let ([x, y], [xx, yy, xy]) = (along, bent);
    let whole = xx * yy - xy * xy;
    if whole > 0.0 && whole.is_finite() { 0.5 * (x * x * yy - 2.0 * x * y * xy + y * y * xx) / whole } else { 0.0 }
}

/// Height of a smooth shape [m] at the radius `r` [m]; +∞ where it has no material.
pub fn material(profile: &dyn Profile, r: f64) -> f64 {
    if r > profile.rim().radius() { f64::INFINITY } else { profile.height(r) }
}

/// Height [m] of an ellipsoid with the radii of curvature `radii` along x and y [m].
pub fn ellipsoid(radii: [f64; 2]) -> impl Fn(f64, f64) -> f64 {
    move |x, y| 0.5 * (x * x / radii[0] + y * y / radii[1])
}

/// A tip on pixels that fill a window of the sides `window` along x and y [m].
pub(super) fn of_tip(indenter: &PixelledIndenter, size: [usize; 2], window: [f64; 2]) -> Option<Heights> {
    let pixel = [window[0] / size[1] as f64, window[1] / size[0] as f64];
    Some(match indenter {
        PixelledIndenter::Smooth(profile) => {
            Heights::about_tip(size, pixel, |x, y| material(profile.as_ref(), x.hypot(y)))
        }
        PixelledIndenter::Ellipsoid(radii, _) => Heights::about_tip(size, pixel, ellipsoid(*radii)),
        PixelledIndenter::Tips(tips) => {
            let lowest = |x, y| tips.iter().map(|tip| tip.height_at(x, y)).fold(f64::INFINITY, f64::min);
            Heights::about_tip(size, pixel, lowest)
        }
        PixelledIndenter::Rough(..) => return None,
    })
}

/// The surface of a plan; `None` of a tip.
///
/// # Errors
/// The grid does not carry the shortest wave.
pub(super) fn of_surface(plan: &HalfSpacePlan) -> Result<Option<Heights>, RoughError> {
    let PixelledIndenter::Rough(surface, base) = &plan.indenter else { return Ok(None) };
    let Surface { source, seeds, .. } = surface.as_ref();
    let heights = match source {
        Source::Spectrum(spectrum) => {
            let seed = seeds.first().copied().unwrap_or(1);
            Heights::of_spectrum(spectrum, base.as_deref(), (surface.length(), plan.size[1]), seed)?
        }
        Source::Map(map) => resampled(&cut(map, plan.window), plan.size, plan.boundary),
    };
    Ok(Some(heights))
}

/// The middle of a map, at most `window` [m] wide and high.
fn cut(map: &HeightMap, window: Option<f64>) -> Heights {
    let whole = Heights::of_map(map, 1);
    let Some(window) = window else { return whole };
    let (rows, columns) = whole.values.dim();
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "positive, and no more than a side")]
    let range = |count: usize, pixel: f64| {
        let kept = ((window / pixel).round() as usize).clamp(1, count);
        ((count - kept) / 2, (count - kept) / 2 + kept)
    };
    let ((top, bottom), (left, right)) = (range(rows, whole.pixel[1]), range(columns, whole.pixel[0]));
    Heights { values: whole.values.slice(s![top..bottom, left..right]).to_owned(), pixel: whole.pixel }
}

/// A map on another number of pixels over the same window, linear between its own.
fn resampled(map: &Heights, [rows, columns]: [usize; 2], boundary: Boundary) -> Heights {
    let (own_rows, own_columns) = map.values.dim();
    if (rows, columns) == (own_rows, own_columns) {
        return map.clone();
    }
    let across: Vec<Between> = (0..columns).map(|k| Between::of(k, columns, own_columns, boundary)).collect();
    let down: Vec<Between> = (0..rows).map(|k| Between::of(k, rows, own_rows, boundary)).collect();
    let values = Array2::from_shape_fn((rows, columns), |(row, column)| {
        let along = |of: usize| {
            across[column].mean(map.values[[of, across[column].low]], map.values[[of, across[column].high]])
        };
        down[row].mean(along(down[row].low), along(down[row].high))
    });
    let sides = map.sides();
    Heights { values, pixel: [sides[0] / columns as f64, sides[1] / rows as f64] }
}

/// A place between two pixels.
struct Between {
    low: usize,
    high: usize,
    share: f64,
}

impl Between {
    /// Middle of the pixel `index` of `count` among `own` pixels on the same side.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the pixels")]
    fn of(index: usize, count: usize, own: usize, boundary: Boundary) -> Self {
        let place = (index as f64 + 0.5) * own as f64 / count as f64 - 0.5;
        let (low, share) = (place.floor(), place - place.floor());
        let last = own - 1;
        match boundary {
            Boundary::Free if place <= 0.0 => Self { low: 0, high: 0, share: 0.0 },
            Boundary::Free => Self { low: (low as usize).min(last), high: (low as usize + 1).min(last), share },
            Boundary::Periodic if low < 0.0 => Self { low: last, high: 0, share },
            Boundary::Periodic => Self { low: low as usize % own, high: (low as usize + 1) % own, share },
        }
    }

    fn mean(&self, low: f64, high: f64) -> f64 {
        if self.share > 0.0 { low + self.share * (high - low) } else { low }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_map_keeps_a_plane_where_it_ends_and_a_wave_where_it_repeats() {
        let plane =
            Heights { values: Array2::from_shape_fn((6, 8), |(i, j)| i as f64 + 0.5 * j as f64), pixel: [1.0, 2.0] };
        let finer = resampled(&plane, [12, 24], Boundary::Free);
        assert!(finer.sides().iter().zip(plane.sides()).all(|(one, other)| (one - other).abs() < 1e-12));
        for ((row, column), value) in
            finer.values.indexed_iter().filter(|((i, j), _)| (1..11).contains(i) && (1..22).contains(j))
        {
            let (y, x) = ((row as f64 + 0.5) / 2.0 - 0.5, (column as f64 + 0.5) / 3.0 - 0.5);
            assert!((value - y - 0.5 * x).abs() < 1e-14);
        }
        let wave =
            Heights { values: Array2::from_shape_fn((4, 4), |(_, j)| [0.0, 1.0, 0.0, -1.0][j]), pixel: [1.0; 2] };
        let twice = resampled(&wave, [4, 8], Boundary::Periodic);
        assert_eq!(twice.values.row(0).to_vec(), [-0.25, 0.25, 0.75, 0.75, 0.25, -0.25, -0.75, -0.75]);
    }

    #[test]
    fn a_tip_stands_on_a_node_and_every_second_pixel_keeps_it() {
        let heights = Heights::about_tip([8, 16], [1.0, 2.0], ellipsoid([1.0, 1.0]));
        assert_eq!((heights.touch(), heights.values[[4, 8]], heights.values[[4, 9]]), (0.0, 0.0, 0.5));
        let thinned = heights.thinned();
        assert_eq!((thinned.touch(), thinned.values.dim(), thinned.sides()), (0.0, (4, 8), heights.sides()));
    }

    /// A paraboloid that stands askew between pixels is lower there by what its vertex is; on a pixel by nothing.
    #[test]
    fn a_peak_between_pixels_is_found() {
        let bowl = |x0: f64, y0: f64| {
            Heights::about_tip([9, 8], [1.0; 2], |x, y| {
                let (x, y) = (x - x0, y - y0);
                x * x + 2.0 * y * y + 1.5 * x * y
            })
        };
        let between = bowl(0.4, -0.3);
        assert!((between.below_touch(Boundary::Free) - 2.0 * between.touch()).abs() < 1e-12);
        assert!(bowl(0.0, 1.0).below_touch(Boundary::Free) < 1e-14);
        // Across the border of what repeats: −cos(x − π/4), of which eight pixels carry a wave, is lowest there by 1 − cos(π/8).
        let wave = Array2::from_shape_fn((3, 8), |(_, j)| -(std::f64::consts::FRAC_PI_4 * (j as f64 + 0.5)).cos());
        let wave = Heights { values: wave + &ndarray::arr2(&[[1.0], [0.0], [1.0]]), pixel: [1.0; 2] };
        let below = wave.below_touch(Boundary::Periodic);
        let exact = 1.0 - (0.125 * std::f64::consts::PI).cos();
        assert!(below > exact && below < 2.0 * exact, "{below} {exact}");
        let holed = Heights { values: Array2::from_elem((4, 4), f64::INFINITY), pixel: [1.0; 2] };
        assert!(holed.below_touch(Boundary::Periodic) <= 0.0);
    }
}
