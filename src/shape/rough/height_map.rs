//! Roughness of a measured or generated height map.

use super::{
    Rings, RoughError,
    error::positive,
    fourier::{Transform, transposed},
};
use crate::numerics::complex::Complex;
use ndarray::Array2;
use std::f64::consts::TAU;

/// Heights [m] on a rectangular grid.
#[derive(Debug, Clone, PartialEq)]
pub struct HeightMap {
    heights: Array2<f64>,
    /// Step between columns and between rows [m].
    pixel: (f64, f64),
}

/// What lies beyond the border of a map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Border {
    /// The map repeats: generated surfaces. The spectrum is exact.
    Periodic,
    /// Unknown, as in a measurement: the mean plane is taken off and the edges are tapered (Hann window of mean square 1),
    /// which blurs the spectrum over two rings and leaves waves of the size of the map uncertain.
    #[default]
    Cut,
}

/// Roughness parameters of a map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Roughness {
    /// Root mean square height [m] about the mean (periodic) or the mean plane (cut).
    pub rms_height: f64,
    /// Root mean square of |∇h|, from the spectrum: [2π∫q³C dq]^½.
    pub rms_slope: f64,
    /// Root mean square of the mean curvature ∇²h/2 [1/m], from the spectrum: ½[2π∫q⁵C dq]^½.
    pub rms_curvature: f64,
    /// Highest minus lowest point [m]; `None` of a spectrum.
    pub peak_to_valley: Option<f64>,
}

impl HeightMap {
    /// A map of heights [m], rows along y and columns along x, with the steps (Δx, Δy) [m].
    ///
    /// # Errors
    /// Fewer than 4 rows or columns; a height that is not finite (its row and column); steps that are not positive.
    pub fn new(heights: Array2<f64>, pixel: (f64, f64)) -> Result<Self, RoughError> {
        let (rows, columns) = heights.dim();
        if rows < 4 || columns < 4 {
            return Err(RoughError::TooSmall { rows, columns });
        }
        positive("pixel along x", pixel.0)?;
        positive("pixel along y", pixel.1)?;
        match heights.indexed_iter().find(|(_, h)| !h.is_finite()) {
            Some(((i, j), &value)) => Err(RoughError::Height { row: i + 1, column: j + 1, value }),
            None => Ok(Self { heights, pixel }),
        }
    }

    /// The heights [m].
    #[must_use]
    pub fn heights(&self) -> &Array2<f64> {
        &self.heights
    }

    /// Steps (Δx, Δy) [m].
    #[must_use]
    pub fn pixel(&self) -> (f64, f64) {
        self.pixel
    }

    /// Sides (L_x, L_y) [m]: number of points times step.
    #[must_use]
    pub fn sides(&self) -> (f64, f64) {
        let (rows, columns) = self.heights.dim();
        (number(columns) * self.pixel.0, number(rows) * self.pixel.1)
    }

    /// Roughness parameters, to be printed beside a result.
    #[must_use]
    pub fn roughness(&self, border: Border) -> Roughness {
        let level = self.levelled(border);
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        level.iter().for_each(|h| (low, high) = (low.min(*h), high.max(*h)));
        let variance = level.iter().map(|h| h * h).sum::<f64>() / number(level.len());
        let (mut slope, mut laplacian) = (0.0, 0.0);
        for (q, v) in self.waves(level, border) {
            slope += q * q * v;
            laplacian += q * q * q * q * v;
        }
        Roughness {
            rms_height: variance.sqrt(),
            rms_slope: slope.sqrt(),
            rms_curvature: 0.5 * laplacian.sqrt(),
            peak_to_valley: Some(high - low),
        }
    }

    /// Isotropic spectrum: the variance of each ring of wavevectors, all directions together.
    ///
    /// The ring width is 2π/√(L_xL_y), so that [`RoughLine::new`](super::RoughLine::new) of these rings is the equivalent line of a
    /// surface of the same nominal area. Wavevectors run into the corners of the grid's square, up to √2 times its Nyquist
    /// wavevector; the line needs twice as many points as there are rings. An anisotropic surface is averaged over directions.
    #[must_use]
    pub fn rings(&self, border: Border) -> Rings {
        let (x, y) = self.sides();
        let length = (x * y).sqrt();
        let mut variances = vec![0.0];
        for (q, v) in self.waves(self.levelled(border), border) {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "below the number of points")]
            let ring = ((q * length / TAU).round() as usize).max(1);
            if ring >= variances.len() {
                variances.resize(ring + 1, 0.0);
            }
            variances[ring] += v;
        }
        Rings::measured(length, variances)
    }

    /// Heights about the mean, or about the mean plane.
    fn levelled(&self, border: Border) -> Array2<f64> {
        let (rows, columns) = self.heights.dim();
        let n = number(self.heights.len());
        let mean = self.heights.sum() / n;
        let centred = |k: usize, of: usize| number(k) - 0.5 * number(of - 1);
        let (mut across, mut along) = (0.0, 0.0);
        if border == Border::Cut {
            for ((i, j), h) in self.heights.indexed_iter() {
                across += centred(j, columns) * (h - mean);
                along += centred(i, rows) * (h - mean);
            }
            // Σ centred² over k of n points = n (n² − 1)/12.
            let spread = |of: usize| n * (number(of) * number(of) - 1.0) / 12.0;
            (across, along) = (across / spread(columns), along / spread(rows));
        }
        let plane = |i, j| mean + across * centred(j, columns) + along * centred(i, rows);
        Array2::from_shape_fn((rows, columns), |(i, j)| self.heights[(i, j)] - plane(i, j))
    }

    /// (|q|, variance) of every wave of the grid but the mean.
    fn waves(&self, level: Array2<f64>, border: Border) -> Vec<(f64, f64)> {
        let (rows, columns) = level.dim();
        let taper = |k: usize, of: usize| match border {
            Border::Periodic => 1.0,
            // Mean square of (1 − cos)·√(2/3) over a period is 1.
            Border::Cut => (2.0f64 / 3.0).sqrt() * (1.0 - libm::cos(TAU * (number(k) + 0.5) / number(of))),
        };
        let (across, along) = (Transform::new(columns), Transform::new(rows));
        let mut data: Vec<_> =
            level.indexed_iter().map(|((i, j), h)| Complex::from(h * taper(i, rows) * taper(j, columns))).collect();
        across.run_lines(&mut data);
        let mut data = transposed(&data, columns);
        along.run_lines(&mut data);
        let (x, y) = self.sides();
        let wave = |k: usize, of: usize, side: f64| TAU * number(k.min(of - k)) / side;
        let scale = number(rows * columns).powi(2);
        let measured = data.iter().enumerate().skip(1).map(|(at, z)| {
            let q = wave(at / rows, columns, x).hypot(wave(at % rows, rows, y));
            (q, z.square() / scale)
        });
        measured.collect()
    }
}

#[expect(clippy::cast_precision_loss, reason = "points are far fewer than 2^53")]
fn number(n: usize) -> f64 {
    n as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::rough::RoughLine;
    use ndarray::array;

    fn wave(rows: usize, columns: usize, tilt: f64) -> HeightMap {
        let h = |(i, j): (usize, usize)| {
            1e-6 * (TAU * (3.0 * number(j) / number(columns) + 4.0 * number(i) / number(rows))).cos() + tilt * number(j)
        };
        HeightMap::new(Array2::from_shape_fn((rows, columns), h), (1e-6, 1e-6)).unwrap()
    }

    /// One wave of amplitude A and wavevector (3, 4)·2π/L: |q| = 5·2π/L, rms A/√2, slope q A/√2, curvature q²A/(2√2).
    #[test]
    fn one_wave_is_one_ring() {
        for n in [20, 27, 32] {
            let map = wave(n, n, 0.0);
            let (r, q) = (map.roughness(Border::Periodic), TAU * 5.0 / (1e-6 * number(n)));
            let rms = 1e-6 / 2f64.sqrt();
            assert!((r.rms_height / rms - 1.0).abs() < 1e-13);
            assert!((r.rms_slope / (q * rms) - 1.0).abs() < 1e-12);
            assert!((r.rms_curvature / (0.5 * q * q * rms) - 1.0).abs() < 1e-11);
            let rings = map.rings(Border::Periodic);
            assert!((rings.variances()[5] / (rms * rms) - 1.0).abs() < 1e-12);
            assert!((rings.rms_slope() / r.rms_slope - 1.0).abs() < 1e-12);
            let line = RoughLine::new(&rings, 1).heights(4 * n).unwrap();
            let line_rms = (line.iter().map(|z| z * z).sum::<f64>() / number(4 * n)).sqrt();
            assert!((line_rms / rms - 1.0).abs() < 1e-12);
        }
    }

    /// A tilted measurement: the tilt is taken off, and rms height and slope of the wave stay within the taper's blur of 5 %.
    #[test]
    fn a_cut_map_loses_its_tilt() {
        let map = wave(60, 60, 1e-5);
        let (r, q) = (map.roughness(Border::Cut), TAU * 5.0 / 60e-6);
        let rms = 1e-6 / 2f64.sqrt();
        assert!((r.rms_height / rms - 1.0).abs() < 0.05, "{r:?}");
        assert!((r.rms_slope / (q * rms) - 1.0).abs() < 0.05, "{r:?}");
        assert!((map.rings(Border::Cut).rms_height() / rms - 1.0).abs() < 0.05);
    }

    #[test]
    fn a_rectangle_keeps_its_variance() {
        let map = wave(16, 48, 0.0);
        assert!((map.rings(Border::Periodic).rms_height() / (1e-6 / 2f64.sqrt()) - 1.0).abs() < 1e-13);
        assert!((map.rings(Border::Periodic).length() / (1e-6 * (16.0f64 * 48.0).sqrt()) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn bad_maps_are_refused_with_their_place() {
        let text = |h: Array2<f64>| HeightMap::new(h, (1.0, 1.0)).unwrap_err().to_string();
        assert!(text(array![[0.0, 1.0]]).contains("found 1 × 2"));
        let mut map = Array2::zeros((5, 6));
        map[(3, 1)] = f64::NAN;
        assert!(text(map).contains("row 4, column 2 is NaN"));
        assert!(HeightMap::new(Array2::zeros((4, 4)), (1.0, -1.0)).unwrap_err().to_string().contains("pixel along y"));
    }
}
