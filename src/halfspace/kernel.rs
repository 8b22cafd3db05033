//! Surface displacement of one uniformly loaded pixel, in units of the pixel.

use crate::ground::Ground;
use std::f64::consts::{FRAC_1_PI, FRAC_2_PI};

/// Influence of a unit pressure on the pixel at the origin; lengths in pixels' mean size,
/// displacement in (pressure × mean pixel size / E*).
#[derive(Debug, Clone, Copy)]
pub(super) enum Influence<'g> {
    /// Half-space under a uniformly loaded rectangle of these sides (product 1).
    Rectangle(Rectangle),
    /// The same, over a ground that is not alike at all depths.
    Over(Rectangle, Beneath<'g>),
    /// What was computed before, on a window at least as large.
    Kept(&'g KernelTable),
    /// Half-plane under a uniformly loaded strip of width 1, displacement zero at this distance.
    Strip {
        /// Distance of the datum from the load, in strips.
        datum: f64,
    },
}

/// Influences of a pixel on a quarter of a window, row after row.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct KernelTable {
    pub(super) stride: usize,
    pub(super) values: Vec<f64>,
}

/// A ground that is not alike at all depths, and a length of the solver in metres.
#[derive(Debug, Clone, Copy)]
pub(super) struct Beneath<'g> {
    pub(super) ground: &'g dyn Ground,
    pub(super) unit: f64,
}

impl Beneath<'_> {
    /// The same where lengths are measured in `units` of the present one.
    pub(super) fn in_units(self, units: f64) -> Self {
        Self { unit: units * self.unit, ..self }
    }

    /// What a wave gives, in lengths of the solver; zero for an endless one under which everything sinks without an end.
    pub(super) fn wave(self, q: f64) -> f64 {
        let given = self.ground.wave(q / self.unit) / self.unit;
        if given.is_finite() { given } else { 0.0 }
    }
}

impl Influence<'_> {
    /// Displacement at the centre of the pixel `row`, `column` steps away.
    pub(super) fn at(&self, row: usize, column: usize) -> f64 {
        match self {
            Self::Rectangle(rectangle) => rectangle.at(row, column),
            Self::Over(rectangle, Beneath { ground, unit }) => {
                let sides = [unit * rectangle.width, unit * rectangle.height];
                let away = [column as f64 * sides[0], row as f64 * sides[1]];
                ground.under_rectangle(away, sides, unit * rectangle.at(row, column)) / unit
            }
            Self::Kept(KernelTable { stride, values }) => values[row * stride + column],
            Self::Strip { datum } => FRAC_2_PI * (datum.ln() - mean_log(column)),
        }
    }
}

/// Uniformly loaded rectangle on a half-space (Love 1929; Johnson, Contact Mechanics, eq. 3.25).
///
/// Closer than `FAR` sides the closed form with its logarithms of ratios taken as `ln(1 + …)`;
/// further away the multipole series of ∫∫ dA/r, whose next term is below rounding there.
/// The closed form alone would lose digits in proportion to the distance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rectangle {
    width: f64,
    height: f64,
    far: f64,
    second: [f64; 2],
    fourth: [f64; 3],
    sixth: [f64; 4],
}

/// Distance in sides beyond which the series to sixth order is exact to rounding:
/// the eighth-order term is at most 1/(2304 · 32⁸) of the whole.
const FAR: f64 = 32.0;

impl Rectangle {
    /// Rectangle with the aspect ratio of a pixel of these sides.
    pub(super) fn new(pixel_width: f64, pixel_height: f64) -> Self {
        let width = (pixel_width / pixel_height).sqrt();
        let height = width.recip();
        let (a, b) = (width * width / 4.0, height * height / 4.0);
        let (m20, m02) = (a / 3.0, b / 3.0);
        let (m40, m22, m04) = (a * a / 5.0, a * b / 9.0, b * b / 5.0);
        let (m60, m42, m24, m06) = (a * a * a / 7.0, a * a * b / 15.0, a * b * b / 15.0, b * b * b / 7.0);
        let (s4, s6) = (m40 + 2.0 * m22 + m04, m60 + 3.0 * m42 + 3.0 * m24 + m06);
        let (x4, y4) = (m40 + m22, m22 + m04);
        let (x6, y6) = (m60 + 2.0 * m42 + m24, m42 + 2.0 * m24 + m06);
        let (xx6, xy6, yy6) = (m60 + m42, m42 + m24, m24 + m06);
        Self {
            width,
            height,
            far: FAR * width.max(height),
            second: [1.5 * m02 - 0.5 * (m20 + m02), 1.5 * (m20 - m02)],
            fourth: quartic([m40, m22, m04], [x4, y4], s4),
            sixth: sextic([m60, m42, m24, m06], [xx6, xy6, yy6], [x6, y6, s6]),
        }
    }

    fn at(&self, row: usize, column: usize) -> f64 {
        self.at_place(row as f64, column as f64)
    }

    /// The same at a place that need not be the centre of a pixel, both at least zero.
    pub(super) fn at_place(&self, row: f64, column: f64) -> f64 {
        let (x, y) = (column * self.width, row * self.height);
        let square = x * x + y * y;
        if square > self.far * self.far {
            FRAC_1_PI * self.series(x * x / square, square)
        } else {
            FRAC_1_PI * self.closed(x, y)
        }
    }

    /// Slope along a row of that, per pixel, both at least zero.
    pub(super) fn slope_at_place(&self, row: f64, column: f64) -> f64 {
        let (x, y) = (column * self.width, row * self.height);
        let (lower, upper) = (y - 0.5 * self.height, y + 0.5 * self.height);
        let [left, right] = [x - 0.5 * self.width, x + 0.5 * self.width];
        FRAC_1_PI * self.width * (log_ratio(lower, upper, right) - log_ratio(lower, upper, left))
    }

    /// ∫∫ dA/r by multipoles; `c` = cos² of the direction, `square` = r².
    fn series(&self, c: f64, square: f64) -> f64 {
        let inverse = square.recip();
        let second = self.second[0] + c * self.second[1];
        let fourth = horner(&self.fourth, c);
        let sixth = horner(&self.sixth, c);
        inverse.sqrt() * (1.0 + inverse * (second + inverse * (fourth + inverse * sixth)))
    }

    /// ∫∫ dA/r in closed form, centre of the rectangle at distance (x, y) ≥ 0.
    fn closed(&self, x: f64, y: f64) -> f64 {
        let (left, right) = (x - 0.5 * self.width, x + 0.5 * self.width);
        let (lower, upper) = (y - 0.5 * self.height, y + 0.5 * self.height);
        right * log_ratio(lower, upper, right) - left * log_ratio(lower, upper, left)
            + upper * log_ratio(left, right, upper)
            - lower * log_ratio(left, right, lower)
    }
}

/// asinh(to/|across|) − asinh(from/|across|) without cancellation, to > |from|.
fn log_ratio(from: f64, to: f64, across: f64) -> f64 {
    if from < 0.0 {
        return (to / across.abs()).asinh() - (from / across.abs()).asinh();
    }
    let (near, far) = (from.hypot(across), to.hypot(across));
    ((to - from) * (1.0 + (to + from) / (near + far)) / (from + near)).ln_1p()
}

/// Mean of |s|⁴P₄ over the rectangle as a polynomial in c = cos²: moments of s, of s² and of 1 in t = s·r̂.
fn quartic(t4: [f64; 3], t2: [f64; 2], t0: f64) -> [f64; 3] {
    let [m40, m22, m04] = t4;
    let fourth = [m04, 6.0 * m22 - 2.0 * m04, m40 - 6.0 * m22 + m04];
    let second = [t2[1], t2[0] - t2[1]];
    [
        (35.0 * fourth[0] - 30.0 * second[0] + 3.0 * t0) / 8.0,
        (35.0 * fourth[1] - 30.0 * second[1]) / 8.0,
        35.0 * fourth[2] / 8.0,
    ]
}

/// Mean of |s|⁶P₆ over the rectangle as a polynomial in c = cos².
fn sextic(t6: [f64; 4], t4: [f64; 3], t2: [f64; 3]) -> [f64; 4] {
    let [m60, m42, m24, m06] = t6;
    let sixth = [m06, 15.0 * m24 - 3.0 * m06, 15.0 * m42 - 30.0 * m24 + 3.0 * m06, m60 - 15.0 * m42 + 15.0 * m24 - m06];
    let [xx, xy, yy] = t4;
    let fourth = [yy, 6.0 * xy - 2.0 * yy, xx - 6.0 * xy + yy];
    let [x, y, whole] = t2;
    [
        (231.0 * sixth[0] - 315.0 * fourth[0] + 105.0 * y - 5.0 * whole) / 16.0,
        (231.0 * sixth[1] - 315.0 * fourth[1] + 105.0 * (x - y)) / 16.0,
        (231.0 * sixth[2] - 315.0 * fourth[2]) / 16.0,
        231.0 * sixth[3] / 16.0,
    ]
}

fn horner(coefficients: &[f64], c: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * c + coefficient)
}

/// Mean of ln|s| over the unit strip whose centre is `steps` away.
fn mean_log(steps: usize) -> f64 {
    if steps == 0 {
        return -1.0 - std::f64::consts::LN_2;
    }
    let s = steps as f64;
    let z = 0.25 / (s * s);
    0.5 * (s * s).ln() + 0.5 * (-z).ln_1p() + arctanh_excess(z)
}

/// artanh(√z)/√z − 1 for 0 < z ≤ ¼ without cancellation.
fn arctanh_excess(z: f64) -> f64 {
    if z < 1e-3 {
        return z * (1.0 / 3.0 + z * (0.2 + z * (1.0 / 7.0 + z * (1.0 / 9.0 + z / 11.0))));
    }
    z.sqrt().atanh() / z.sqrt() - 1.0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Centre of a uniformly loaded square of side 1: u = (4/π) ln(1 + √2) p/E* (Johnson, Contact Mechanics, 3.25).
    #[test]
    fn square_under_itself() {
        let exact = 4.0 / std::f64::consts::PI * (1.0 + 2.0_f64.sqrt()).ln();
        assert!((Rectangle::new(3.0, 3.0).at(0, 0) / exact - 1.0).abs() < 1e-15);
    }

    /// A rectangle of 3×3 pixels is the sum of its pixels, near and far, on both sides of the change of formula.
    /// The large one has pixels three times as big: K(3Δ) = 3 K(Δ) at a distance of as many large pixels.
    /// Rounding: the sum of nine, each to a few units of the last place times the cancellation of at most 32.
    #[test]
    fn pixels_add_up_to_a_larger_one() {
        for (width, height) in [(1.0, 1.0), (2.0, 1.0), (1.0, 5.0)] {
            let pixel = Rectangle::new(width, height);
            for (row, column) in
                [(1_usize, 0_usize), (0, 1), (2, 3), (10, 0), (0, 11), (11, 2), (25, 20), (33, 0), (150, 90), (4000, 1)]
            {
                let small: f64 = (0..9_usize)
                    .map(|k| pixel.at((3 * row + k / 3).abs_diff(1), (3 * column + k % 3).abs_diff(1)))
                    .sum();
                let large = 3.0 * pixel.at(row, column);
                assert!(
                    (small / large - 1.0).abs() < 1e-13,
                    "{width}×{height}, {row} {column}: {}",
                    small / large - 1.0
                );
            }
        }
    }

    /// Far away a pixel is a point force: π r K → 1, the next term being at most (a² + b²)/8r² of it.
    #[test]
    fn far_away_it_is_a_point() {
        let pixel = Rectangle::new(1.0, 1.0);
        for distance in [1_000, 1_000_000, 1_000_000_000_usize] {
            let product = std::f64::consts::PI * distance as f64 * pixel.at(0, distance);
            assert!((product - 1.0).abs() < 1.0 / (8.0 * (distance as f64).powi(2)) + 4e-16);
        }
    }

    /// Strips add up too: 3 strips of width 1 are one of width 3, whose datum is a third as many widths away.
    #[test]
    fn strips_add_up_to_a_wider_one() {
        let (narrow, wide) = (Influence::Strip { datum: 3e5 }, Influence::Strip { datum: 1e5 });
        for column in [0_usize, 1, 2, 7, 9, 100, 20_000] {
            let small: f64 = (0..3_usize).map(|k| narrow.at(0, (3 * column + k).abs_diff(1))).sum();
            assert!((small / (3.0 * wide.at(0, column)) - 1.0).abs() < 1e-14, "{column}");
        }
    }
}
