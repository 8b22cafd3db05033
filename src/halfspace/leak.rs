//! How much of a thin fluid a gap lets through: Reynolds' equation on its map.

use super::{Boundary, HalfSpaceError};
use ndarray::{Array2, ArrayView2};

/// Error of the conductance at which the pressure of the fluid is known well enough.
const TOLERANCE: f64 = 1e-10;
/// Iterations that are not worth to be checked.
const CHECKED: usize = 16;
/// Part of what an incomplete factor leaves out that it takes from its diagonal (Gustafsson 1978).
const RELAXED: f64 = 0.97;

/// Viscosity times the flow through a gap per difference of the pressure \[m³\], from the left border to the right one.
///
/// Reynolds' equation ∇·(g³∇p) = 0 of a viscous fluid between walls that are nearly parallel (Reynolds 1886), p given on
/// both borders; across, nothing flows out, or the gap repeats. Between neighbouring pixels the conductances of their
/// halves are in series, so that a gap that varies along the flow or across it alone is exact to its sum over pixels:
/// w g³/(12l) of plates of the width w and the length l. Otherwise first order in the pixel where the gap ends and second
/// order elsewhere, from below and above alike. Zero of a gap through which no way leads; `None` where it is endless.
///
/// ```
/// use ndarray::Array2;
/// use springbed::halfspace::{Boundary, leak};
///
/// // Plates of 1 mm × 2 mm that are 3 µm apart, from left to right.
/// let gap = Array2::from_elem((20, 10), 3e-6);
/// let through = leak(gap.view(), [1e-4; 2], Boundary::Free)?.unwrap();
/// assert!((through / (2.0 * 3e-6f64.powi(3) / 12.0) - 1.0).abs() < 1e-12);
/// # Ok::<(), springbed::halfspace::HalfSpaceError>(())
/// ```
///
/// # Errors
/// The iteration does not converge.
pub fn leak(gap: ArrayView2<'_, f64>, pixel: [f64; 2], boundary: Boundary) -> Result<Option<f64>, HalfSpaceError> {
    let widest = gap.iter().copied().fold(0.0, f64::max);
    if !widest.is_finite() {
        return Ok(None);
    }
    let Some(network) = Network::of(gap, pixel, boundary) else { return Ok(Some(0.0)) };
    Ok(Some(widest.powi(3) / 12.0 * network.conductance()?))
}

/// Pixels through which a way leads, and the conductances between them, of the widest gap over 12 times the viscosity.
struct Network {
    columns: usize,
    /// From each pixel to the next one along the row; none from the last of a row.
    right: Vec<f64>,
    /// From each pixel to that of the next row; of the last row to the first one, where it repeats.
    down: Vec<f64>,
    /// From the first and from the last pixel of each row to their borders.
    inlet: Vec<f64>,
    outlet: Vec<f64>,
    /// Sum of all conductances of a pixel; zero where nothing flows.
    total: Vec<f64>,
}

impl Network {
    fn of(gap: ArrayView2<'_, f64>, [width, height]: [f64; 2], boundary: Boundary) -> Option<Self> {
        let (rows, columns) = gap.dim();
        let widest = gap.iter().copied().fold(0.0, f64::max);
        let open = passed(&gap.mapv(|gap| gap > 0.0), boundary)?;
        let cube = |row: usize, column: usize| {
            if open[[row, column]] { (gap[[row, column]] / widest).powi(3) } else { 0.0 }
        };
        let series = |one: f64, other: f64| if one * other > 0.0 { 2.0 / (one.recip() + other.recip()) } else { 0.0 };
        let (along, across) = (height / width, width / height);
        let places = || (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column)));
        let right = places().map(|(row, column)| {
            let next = if column + 1 < columns { cube(row, column + 1) } else { 0.0 };
            along * series(cube(row, column), next)
        });
        let around = boundary == Boundary::Periodic && rows > 1;
        let down = places().map(|(row, column)| match row + 1 == rows {
            true if around => across * series(cube(row, column), cube(0, column)),
            true => 0.0,
            false => across * series(cube(row, column), cube(row + 1, column)),
        });
        let border = |column: usize| (0..rows).map(|row| along * 2.0 * cube(row, column)).collect();
        let mut network = Self {
            columns,
            right: right.collect(),
            down: down.collect(),
            inlet: border(0),
            outlet: border(columns - 1),
            total: Vec::new(),
        };
        network.total = network.totals();
        Some(network)
    }

    fn totals(&self) -> Vec<f64> {
        let (columns, pixels) = (self.columns, self.right.len());
        let of = |at: usize| self.left(at) + self.right[at] + self.down[self.above(at)] + self.down[at];
        let mut totals: Vec<f64> = (0..pixels).map(of).collect();
        for (row, (inlet, outlet)) in self.inlet.iter().zip(&self.outlet).enumerate() {
            totals[row * columns] += inlet;
            totals[(row + 1) * columns - 1] += outlet;
        }
        totals
    }

    /// Conductance to the pixel before.
    fn left(&self, at: usize) -> f64 {
        at.checked_sub(1).map_or(0.0, |before| self.right[before])
    }

    /// The pixel of the row before; of the first row that of the last.
    fn above(&self, at: usize) -> usize {
        if at >= self.columns { at - self.columns } else { at + self.right.len() - self.columns }
    }

    /// The pixel of the next row; of the last row that of the first.
    fn below(&self, at: usize) -> usize {
        let next = at + self.columns;
        if next < self.right.len() { next } else { next - self.right.len() }
    }

    /// What flows out of each pixel under the pressures `p` of the fluid, the border on the left held at `left`.
    fn outflow(&self, p: &[f64], left: f64, out: &mut [f64]) {
        for at in 0..p.len() {
            if self.total[at] <= 0.0 {
                continue;
            }
            let before = if at > 0 { self.right[at - 1] * p[at - 1] } else { 0.0 };
            let after = if at + 1 < p.len() { self.right[at] * p[at + 1] } else { 0.0 };
            let (above, below) = (self.above(at), self.below(at));
            out[at] = self.total[at] * p[at] - before - after - self.down[above] * p[above] - self.down[at] * p[below];
        }
        for (out, inlet) in out.iter_mut().step_by(self.columns).zip(&self.inlet) {
            *out -= inlet * left;
        }
    }

    /// Flow under a pressure of one: the power Σ T(Δp)², whose error is of second order in that of the pressures.
    fn power(&self, p: &[f64]) -> f64 {
        let inside = (0..p.len()).map(|at| {
            let next = if at + 1 < p.len() { p[at + 1] } else { 0.0 };
            self.right[at] * (p[at] - next).powi(2) + self.down[at] * (p[at] - p[self.below(at)]).powi(2)
        });
        let border = |t: &f64, off: f64| t * off * off;
        let inlet: f64 = self.inlet.iter().zip(self.first(p)).map(|(t, p)| border(t, 1.0 - p)).sum();
        let outlet: f64 = self.outlet.iter().zip(self.last(p)).map(|(t, &p)| border(t, p)).sum();
        inlet + inside.sum::<f64>() + outlet
    }

    /// The pressures at the border where the fluid comes in.
    fn first<'p>(&self, p: &'p [f64]) -> impl Iterator<Item = &'p f64> {
        p.iter().step_by(self.columns)
    }

    /// The pressures at the border where it goes out.
    fn last<'p>(&self, p: &'p [f64]) -> impl Iterator<Item = &'p f64> {
        p.iter().skip(self.columns - 1).step_by(self.columns)
    }

    /// What flows in minus what flows out, of their sum.
    fn imbalance(&self, p: &[f64]) -> f64 {
        let enters: f64 = self.inlet.iter().zip(self.first(p)).map(|(t, p)| t * (1.0 - p)).sum();
        let leaves: f64 = self.outlet.iter().zip(self.last(p)).map(|(t, p)| t * p).sum();
        (enters - leaves).abs() / (enters.abs() + leaves.abs()).max(f64::MIN_POSITIVE)
    }

    /// Conjugate gradients with an incomplete factor, from pressures that fall straight.
    fn conductance(&self) -> Result<f64, HalfSpaceError> {
        let (columns, pixels) = (self.columns, self.right.len());
        let straight = |at: usize| {
            let passed = (at % columns) as f64 + 0.5;
            if self.total[at] > 0.0 { 1.0 - passed / columns as f64 } else { 0.0 }
        };
        let mut p: Vec<f64> = (0..pixels).map(straight).collect();
        let mut residual = vec![0.0; pixels];
        self.outflow(&p, 1.0, &mut residual);
        residual.iter_mut().for_each(|value| *value = -*value);
        let factor = self.factor();
        let (mut direction, mut image, mut scaled) = (vec![0.0; pixels], vec![0.0; pixels], vec![0.0; pixels]);
        let (mut last, mut known) = (0.0, self.power(&p));
        let most = 200 + 20 * (columns + pixels / columns);
        for iteration in 1..=most {
            self.precondition(&factor, &residual, &mut scaled);
            let slope = dot(&residual, &scaled);
            // What the error may still change of the power is its own energy, about the slope.
            if slope <= f64::EPSILON * TOLERANCE * known {
                return Ok(self.power(&p));
            }
            let memory = if last > 0.0 { slope / last } else { 0.0 };
            last = slope;
            direction.iter_mut().zip(&scaled).for_each(|(direction, value)| *direction = value + memory * *direction);
            self.outflow(&direction, 0.0, &mut image);
            let length = slope / dot(&direction, &image);
            p.iter_mut().zip(&direction).for_each(|(p, direction)| *p += length * direction);
            residual.iter_mut().zip(&image).for_each(|(residual, image)| *residual -= length * image);
            if iteration % CHECKED == 0 {
                let power = self.power(&p);
                if (power / known - 1.0).abs() <= TOLERANCE && self.imbalance(&p) <= TOLERANCE.sqrt() {
                    return Ok(power);
                }
                known = power;
            }
        }
        Err(HalfSpaceError::NotConverged { iterations: most, residual: self.imbalance(&p), tolerance: TOLERANCE })
    }

    /// Reciprocal diagonal of an incomplete factor; what goes round from the last row to the first is in the diagonal
    /// alone.
    fn factor(&self) -> Vec<f64> {
        let columns = self.columns;
        let mut inverse = vec![0.0; self.total.len()];
        for at in 0..inverse.len() {
            if self.total[at] <= 0.0 {
                continue;
            }
            let (left, above) = (self.left(at), at.checked_sub(columns).map_or(0.0, |above| self.down[above]));
            let taken = |from: usize, by: f64, other: f64| by * (by + RELAXED * other) * inverse[from];
            let of_left = if left > 0.0 { taken(at - 1, left, self.down[at - 1]) } else { 0.0 };
            let of_above = if above > 0.0 { taken(at - columns, above, self.right[at - columns]) } else { 0.0 };
            let rest = self.total[at] - of_left - of_above;
            inverse[at] = if rest > 0.0 { rest } else { self.total[at] }.recip();
        }
        inverse
    }

    /// Solves the incomplete factors: down the pixels, and up again.
    fn precondition(&self, inverse: &[f64], residual: &[f64], out: &mut [f64]) {
        let (columns, pixels) = (self.columns, residual.len());
        for at in 0..pixels {
            if inverse[at] > 0.0 {
                let left = if at > 0 { self.right[at - 1] * out[at - 1] } else { 0.0 };
                let above = if at >= columns { self.down[at - columns] * out[at - columns] } else { 0.0 };
                out[at] = inverse[at] * (residual[at] + left + above);
            }
        }
        for at in (0..pixels).rev() {
            if inverse[at] > 0.0 {
                let right = if at + 1 < pixels { self.right[at] * out[at + 1] } else { 0.0 };
                let below = if at + columns < pixels { self.down[at] * out[at + columns] } else { 0.0 };
                out[at] += inverse[at] * (right + below);
            }
        }
    }
}

fn dot(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(one, other)| one * other).sum()
}

/// The open pixels through which a way leads from the first column to the last; `None` if there is no way.
fn passed(open: &Array2<bool>, boundary: Boundary) -> Option<Array2<bool>> {
    let last = open.ncols().checked_sub(1)?;
    let (from_left, from_right) = (reached(open, 0, boundary), reached(open, last, boundary));
    let both = Array2::from_shape_fn(open.dim(), |at| from_left[at] && from_right[at]);
    both.iter().any(|&both| both).then_some(both)
}

/// The open pixels that a way leads to from a column.
fn reached(open: &Array2<bool>, column: usize, boundary: Boundary) -> Array2<bool> {
    let (rows, columns) = open.dim();
    let mut seen = Array2::from_elem(open.dim(), false);
    let mut stack: Vec<[usize; 2]> = (0..rows).map(|row| [row, column]).filter(|&at| open[at]).collect();
    stack.iter().for_each(|&at| seen[at] = true);
    while let Some([row, column]) = stack.pop() {
        let around = boundary == Boundary::Periodic;
        let above = row.checked_sub(1).or(around.then_some(rows - 1)).map(|row| [row, column]);
        let below = if row + 1 < rows { Some(row + 1) } else { around.then_some(0) }.map(|row| [row, column]);
        let left = column.checked_sub(1).map(|column| [row, column]);
        let right = (column + 1 < columns).then_some([row, column + 1]);
        for next in [above, below, left, right].into_iter().flatten() {
            if open[next] && !seen[next] {
                seen[next] = true;
                stack.push(next);
            }
        }
    }
    seen
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    fn through(gap: &Array2<f64>, pixel: [f64; 2], boundary: Boundary) -> f64 {
        leak(gap.view(), pixel, boundary).unwrap().unwrap()
    }

    /// Grooves along the flow are in parallel, ridges across it in series: on pixels the sums that the integrals are,
    /// (1 + 3a²/2) and ((1 − a²)^{5/2}/(1 + a²/2)) of the gap's cube, for waves are exact.
    #[test]
    fn grooves_and_ridges() {
        let (n, a) = (64, 0.6_f64);
        let wave = |k: usize| 1.0 + a * (TAU * (k as f64 + 0.5) / n as f64).cos();
        let along = Array2::from_shape_fn((n, 40), |(row, _)| wave(row));
        let across = Array2::from_shape_fn((40, n), |(_, column)| wave(column));
        for boundary in [Boundary::Free, Boundary::Periodic] {
            let plates = |rows: usize, columns: usize| rows as f64 / columns as f64 * 2.0 / 12.0;
            let parallel = through(&along, [1.0, 2.0], boundary) / plates(n, 40);
            assert!((parallel / (1.0 + 1.5 * a * a) - 1.0).abs() < 1e-9, "{parallel}");
            let series = through(&across, [1.0, 2.0], boundary) / plates(40, n);
            let right = (1.0 - a * a).powf(2.5) / (1.0 + 0.5 * a * a);
            assert!((series / right - 1.0).abs() < 1e-9, "{series} {right}");
        }
    }

    /// Of a gap whose cube is k or 1/k in the squares of a chequered board the conductance is one, whatever k is (Keller
    /// 1964), between lines through the middles of squares as on the whole of it; at the corners pressures are steep.
    #[test]
    fn a_chequered_gap() {
        let board = |n: usize, ratio: f64| {
            Array2::from_shape_fn((2 * n, 2 * n), |(row, column)| {
                (if (row / n + (column + n / 2) / n).is_multiple_of(2) { ratio } else { ratio.recip() }).cbrt()
            })
        };
        let missing = |n: usize| 1.0 - 12.0 * through(&board(n, 2.0), [1.0; 2], Boundary::Periodic);
        let [coarse, middle, fine] = [missing(8), missing(16), missing(32)];
        // Each halving of the pixel takes more than half, and what is left in the end (Aitken) is nothing.
        let (first, second) = (coarse - middle, middle - fine);
        let limit = fine - second * second / (first - second);
        assert!(fine > 0.0 && middle < 0.5 * coarse && fine < 0.5 * middle, "{coarse} {middle} {fine}");
        assert!(limit.abs() < 1e-3, "{limit}");
    }

    /// A wall, and a slit of one pixel in it, which alone resists.
    #[test]
    fn a_closed_gap_lets_nothing_through() {
        let mut gap = Array2::from_elem((9, 12), 1e-6);
        gap.column_mut(5).fill(0.0);
        assert_eq!(leak(gap.view(), [1.0; 2], Boundary::Free), Ok(Some(0.0)));
        gap[[4, 5]] = 1e-9;
        let narrow = through(&gap, [1.0; 2], Boundary::Free);
        let slit = 1e-27 / 12.0;
        assert!(narrow > 0.9 * slit && narrow < slit * 1.0001, "{narrow:e} {slit:e}");
        gap[[0, 0]] = f64::INFINITY;
        assert_eq!(leak(gap.view(), [1.0; 2], Boundary::Free), Ok(None));
    }

    /// Nothing in a scale changes but the scale, over thirty decades, and islands of contact lie in the way.
    #[test]
    fn scales_and_islands() {
        let gap = Array2::from_shape_fn((48, 48), |(row, column)| {
            let (x, y) = (column as f64 - 23.5, row as f64 - 23.5);
            (x.hypot(y) - 12.0).max(0.0) * (1.0 + 0.9 * (0.7 * x).sin() * (0.4 * y).cos())
        });
        let one = through(&gap, [1.0; 2], Boundary::Periodic);
        let tiny = through(&gap.mapv(|gap| 1e-30 * gap), [1e-9; 2], Boundary::Periodic) * 1e90;
        assert!(one > 0.0 && (tiny / one - 1.0).abs() < 1e-9, "{one} {tiny}");
        // A narrower gap lets less through (Rayleigh).
        let mut narrowed = gap.clone();
        narrowed[[5, 20]] *= 0.5;
        let less = through(&narrowed, [1.0; 2], Boundary::Periodic);
        assert!(less < one, "{less} {one}");
    }
}
