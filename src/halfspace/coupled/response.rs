//! The surfaces of elastic bodies under pressures and shear, each of which moves them along and across.

use super::kernel::Sheared;
use crate::halfspace::kernel::Rectangle;
use crate::halfspace::spectrum::{Parity, spectrum_of_quarter};
use crate::halfspace::transform::{Lines, Size, good_length};
use crate::halfspace::vector::lengthen;
use crate::material::Pair;
use crate::shape::Boundary;
use ndarray::{Array2, ArrayView2};
use rayon::prelude::*;
use rustfft::num_complex::Complex;
use std::f64::consts::TAU;
use std::fmt::{self, Debug, Formatter};

/// What pressures p and shear stresses q do to the surfaces of a pair of elastic half-spaces:
///
/// > u_z = (G₀ p + β (Gₗₓ q_x + Gₗᵧ q_y))/E*, u_x = (G₀ q_x + n (Gₓₓ q_x + Gₓᵧ q_y) − β Gₗₓ p)/E*, n = 2 (E*/G* − 1),
///
/// with the influences 1/(πr), x²/(πr³), xy/(πr³), x/(πr²) and y/(πr²) of a point (Johnson 1985, eq. 3.22 and 3.75; β of
/// eq. 5.3) over uniformly loaded pixels (free), or 2/k, 2k_y²/k³, −2k_xk_y/k³, −2ik_x/k² and −2ik_y/k² on every wave
/// (periodic, the mean displacement zero). u is that of the surface below against the one above, z into it; p presses the
/// lower body, q pulls it along; β is the pair's, its first body being the lower one.
///
/// # Examples
/// ```
/// use ndarray::Array2;
/// use springbed::halfspace::{Boundary, CoupledResponse};
/// use springbed::material::Pair;
///
/// // Where pressures p cos(kx) press, the surface is drawn in: u_x = −2β/(kE*) p sin(kx).
/// let (pair, k) = (Pair { normal: 2.0, tangential: 1.5, coupling: 0.25 }, std::f64::consts::TAU);
/// let response = CoupledResponse::new([8, 64], [1.0 / 64.0; 2], Boundary::Periodic, pair);
/// let pressure = Array2::from_shape_fn((8, 64), |(_, j)| (k * j as f64 / 64.0).cos());
/// let [along, _] = response.drawn(pressure.view());
/// assert!((along[[3, 16]] + 2.0 * 0.25 / (k * 2.0)).abs() < 1e-15);
/// ```
pub struct CoupledResponse {
    lines: Lines,
    waves: Vec<Wave>,
    period: Size,
    size: Size,
    pixels: ([f64; 2], Boundary),
    pair: Pair,
    compliance: f64,
}

/// What a wave is multiplied by, without its factors of i, in metres per pascal.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Wave {
    along: [f64; 2],
    across: f64,
    lifted: [f64; 2],
}

/// Influences on a wave, or on pixels of area 1, of a half-space with E* = 1.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Influences {
    /// 1/(πr).
    direct: f64,
    /// x²/(πr³).
    along: f64,
    /// xy/(πr³).
    across: f64,
    /// (x, y)/(πr²).
    lifted: [f64; 2],
}

/// Amplitudes of a wave.
type Amplitude = Complex<f64>;

/// A field along the surface: its parts along x and y.
pub(super) type Along = [Vec<f64>; 2];

/// Space for transforms.
#[derive(Debug, Default)]
pub(super) struct Work {
    rows: [Vec<Amplitude>; 2],
    columns: Vec<Amplitude>,
}

impl Debug for CoupledResponse {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self { size, pixels, pair, .. } = self;
        f.debug_struct("CoupledResponse")
            .field("size", size)
            .field("pixels", pixels)
            .field("pair", pair)
            .finish_non_exhaustive()
    }
}

impl CoupledResponse {
    /// Of `[rows, columns]` pixels of the width and height `pixel` \[m\].
    #[must_use]
    pub fn new([rows, columns]: [usize; 2], pixel: [f64; 2], boundary: Boundary, pair: Pair) -> Self {
        let size = Size { rows, columns };
        let unit = pixel[0].sqrt() * pixel[1].sqrt();
        let period = match boundary {
            Boundary::Periodic => size,
            Boundary::Free => Size { rows: 2 * good_length(rows), columns: 2 * good_length(columns) },
        };
        let sides = pixel.map(|side| side / unit);
        let influences = match boundary {
            Boundary::Periodic => repeated(size, sides),
            Boundary::Free => alone(period, sides),
        };
        let beside = 2.0 * (pair.normal / pair.tangential - 1.0);
        let own = Rectangle::new(sides[0], sides[1]).at_place(0.0, 0.0) + beside * Sheared::at([0.0; 2], sides).along;
        let scale = unit / pair.normal;
        let share = scale / period.pixels() as f64;
        let waves = influences.into_par_iter().map(|influences| influences.of((pair, beside), share)).collect();
        let (lines, pixels) = (Lines::new(size, period), (pixel, boundary));
        Self { lines, waves, period, size, pixels, pair, compliance: scale * own }
    }

    /// The moduli.
    #[must_use]
    pub fn pair(&self) -> Pair {
        self.pair
    }

    /// Width and height \[m\] of a pixel, and what is beyond the border.
    pub(super) fn pixels(&self) -> ([f64; 2], Boundary) {
        self.pixels
    }

    /// Rows and columns.
    pub(super) fn size(&self) -> [usize; 2] {
        [self.size.rows, self.size.columns]
    }

    /// What a pixel under its own unit shear is moved by \[m/Pa\].
    pub(super) fn compliance(&self) -> f64 {
        self.compliance
    }

    /// Displacement \[m\] along x and y under the pressure \[Pa\].
    #[must_use]
    pub fn drawn(&self, pressure: ArrayView2<'_, f64>) -> [Array2<f64>; 2] {
        let given: Vec<f64> = pressure.iter().copied().collect();
        self.by_pressure(&given, &mut Work::default()).map(|part| self.on_pixels(&part))
    }

    /// Displacement \[m\] along x and y under the shear stress \[Pa\] along x and y.
    #[must_use]
    pub fn sheared(&self, shear: [ArrayView2<'_, f64>; 2]) -> [Array2<f64>; 2] {
        let given = shear.map(|part| part.iter().copied().collect());
        self.by_shear(&given, &mut Work::default()).map(|part| self.on_pixels(&part))
    }

    /// Displacement \[m\] into the surface under the shear stress \[Pa\] along x and y.
    #[must_use]
    pub fn lifted(&self, shear: [ArrayView2<'_, f64>; 2]) -> Array2<f64> {
        let given = shear.map(|part| part.iter().copied().collect());
        self.on_pixels(&self.lift_of(&given, &mut Work::default()))
    }

    pub(super) fn on_pixels(&self, values: &[f64]) -> Array2<f64> {
        let columns = self.size.columns;
        Array2::from_shape_fn(self.size(), |(row, column)| values[row * columns + column])
    }

    pub(super) fn by_pressure(&self, pressure: &[f64], work: &mut Work) -> Along {
        let nothing = vec![0.0; pressure.len()];
        self.product([pressure, &nothing], (2, work), |wave, sign, [p, _]| {
            [turned(-p * wave.lifted[0]), turned(-p * sign * wave.lifted[1])]
        })
    }

    pub(super) fn by_shear(&self, [x, y]: &Along, work: &mut Work) -> Along {
        self.product([x, y], (2, work), |wave, sign, [x, y]| {
            let across = -sign * wave.across;
            [x * wave.along[0] + y * across, y * wave.along[1] + x * across]
        })
    }

    pub(super) fn lift_of(&self, [x, y]: &Along, work: &mut Work) -> Vec<f64> {
        let [lifted, _] = self.product([x, y], (1, work), |wave, sign, [x, y]| {
            [turned(x * wave.lifted[0] + y * sign * wave.lifted[1]), Amplitude::default()]
        });
        lifted
    }

    /// The first `kept` of two combinations of two fields, wave by wave; the sign is that of waves which run backward along
    /// the columns.
    fn product(
        &self,
        given: [&[f64]; 2],
        (kept, work): (usize, &mut Work),
        combined: impl Fn(&Wave, f64, [Amplitude; 2]) -> [Amplitude; 2] + Sync,
    ) -> Along {
        let needed = self.size.spectrum(self.period);
        for (spectrum, given) in work.rows.iter_mut().zip(given) {
            lengthen(spectrum, needed);
            self.lines.transform_rows(given, spectrum);
        }
        lengthen(&mut work.columns, 2 * needed);
        let (rows, quarter) = (self.period.rows, self.period.rows / 2 + 1);
        let [first, second] = &work.rows;
        self.lines.across([first, second], (&mut work.columns, kept), |column, lines| {
            let waves = &self.waves[column * quarter..(column + 1) * quarter];
            let [x, y] = lines;
            for (row, (x, y)) in x.iter_mut().zip(y).enumerate() {
                let (wave, sign) = if row < quarter { (&waves[row], 1.0) } else { (&waves[rows - row], -1.0) };
                [*x, *y] = combined(wave, sign, [*x, *y]);
            }
        });
        let mut found: Along = std::array::from_fn(|part| vec![0.0; if part < kept { given[0].len() } else { 0 }]);
        for (part, found) in found.iter_mut().enumerate().take(kept) {
            self.lines.restore_rows(&work.columns, (part, kept), found);
        }
        found
    }
}

impl Influences {
    /// What a pair makes of it, `beside` being n, times `scale`.
    fn of(self, (pair, beside): (Pair, f64), scale: f64) -> Wave {
        let Self { direct, along, across, lifted } = self;
        Wave {
            along: [direct + beside * along, direct + beside * (direct - along)].map(|part| scale * part),
            across: scale * beside * across,
            lifted: lifted.map(|part| scale * pair.coupling * part),
        }
    }
}

/// i times an amplitude.
fn turned(amplitude: Amplitude) -> Amplitude {
    Amplitude::new(-amplitude.im, amplitude.re)
}

/// Influences on a quarter of the waves of what repeats, column first; the shortest wave has no odd part.
fn repeated(size: Size, sides: [f64; 2]) -> Vec<Influences> {
    let step = [TAU / (sides[0] * size.columns as f64), TAU / (sides[1] * size.rows as f64)];
    let odd = |index: usize, count: usize| if 2 * index == count { 0.0 } else { 1.0 };
    let of = |column: usize, row: usize| {
        let [x, y] = [column as f64 * step[0], row as f64 * step[1]];
        let k = x.hypot(y);
        if k <= 0.0 {
            return Influences { direct: 0.0, along: 0.0, across: 0.0, lifted: [0.0; 2] };
        }
        let [odd_x, odd_y] = [odd(column, size.columns), odd(row, size.rows)];
        let (x, y) = (x / k, y / k);
        Influences {
            direct: 2.0 / k,
            along: 2.0 * y * y / k,
            across: odd_x * odd_y * 2.0 * x * y / k,
            lifted: [-2.0 * odd_x * x / k, -2.0 * odd_y * y / k],
        }
    };
    let rows = size.rows / 2 + 1;
    (0..(size.columns / 2 + 1) * rows).into_par_iter().map(|index| of(index / rows, index % rows)).collect()
}

/// Influences on a quarter of the waves of a padded period, column first.
fn alone(period: Size, sides: [f64; 2]) -> Vec<Influences> {
    let half = period.columns / 2 + 1;
    let places = (period.rows / 2 + 1) * half;
    let at = |index: usize| [(index % half) as f64 * sides[0], (index / half) as f64 * sides[1]];
    let sheared: Vec<Sheared> = (0..places).into_par_iter().map(|index| Sheared::at(at(index), sides)).collect();
    let pixel = Rectangle::new(sides[0], sides[1]);
    let pressed = |index: usize| pixel.at_place((index / half) as f64, (index % half) as f64);
    let (even, odd) = (Parity::Even, Parity::Odd);
    let spectrum = |of: &(dyn Fn(usize) -> f64 + Sync), parity: [Parity; 2]| {
        spectrum_of_quarter((0..places).into_par_iter().map(of).collect(), period, parity)
    };
    let direct = spectrum(&pressed, [even, even]);
    let along = spectrum(&|index| sheared[index].along, [even, even]);
    let across = spectrum(&|index| sheared[index].across, [odd, odd]);
    let x = spectrum(&|index| sheared[index].lifted[0], [even, odd]);
    let y = spectrum(&|index| sheared[index].lifted[1], [odd, even]);
    let of = |index: usize| Influences {
        direct: direct[index],
        along: along[index],
        across: across[index],
        lifted: [x[index], y[index]],
    };
    (0..direct.len()).map(of).collect()
}
