//! How much of a thin fluid a gap lets through: Reynolds' equation on its map.

mod multigrid;

use super::{Boundary, HalfSpaceError};
use multigrid::{Link, Multigrid, Network, dot};
use ndarray::{Array2, ArrayView2};

/// Error of the conductance at which the pressures are known well enough.
const TOLERANCE: f64 = 1e-10;
/// Part of the widest gap below which nothing flows that could be told.
const CLOSED: f64 = 1e-100;
/// Steps after which they will not come to be known.
const MOST: usize = 400;

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
    let Some(gap) = Gap::of(gap, pixel, boundary) else { return Ok(Some(0.0)) };
    Ok(Some(widest.powi(3) / 12.0 * gap.balanced()?.conductance))
}

/// What pressures in balance come to.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Balanced {
    /// Flow under a pressure of one.
    conductance: f64,
    /// Steps of conjugate gradients to them.
    steps: usize,
}

/// Pixels through which a way leads, with the conductances between them, of the widest gap over 12 times the viscosity.
struct Gap {
    multigrid: Multigrid,
    /// Node and conductance of the pixels at the border where the fluid comes in, and of those where it goes out.
    inlet: Vec<(usize, f64)>,
    outlet: Vec<(usize, f64)>,
    /// How far along the gap each node lies, of its length.
    passed: Vec<f64>,
}

impl Gap {
    fn of(gap: ArrayView2<'_, f64>, [width, height]: [f64; 2], boundary: Boundary) -> Option<Self> {
        let (rows, columns) = gap.dim();
        let widest = gap.iter().copied().fold(0.0, f64::max);
        let open = passed(&gap.mapv(|gap| gap > CLOSED * widest), boundary)?;
        let mut nodes = 0..;
        let node = open.mapv(|open| if open { nodes.next() } else { None });
        let cube = |at: [usize; 2]| (gap[at] / widest).powi(3);
        let (along, across) = (height / width, width / height);
        let link = |one: [usize; 2], other: [usize; 2], shape: f64| {
            let ends = [node[one]?, node[other]?];
            let conductance = shape * 2.0 / (cube(one).recip() + cube(other).recip());
            (conductance > 0.0).then_some(Link { ends, conductance })
        };
        let around = boundary == Boundary::Periodic && rows > 1;
        let places = || (0..rows).flat_map(|row| (0..columns).map(move |column| [row, column]));
        let right = places().filter(|at| at[1] + 1 < columns);
        let right = right.filter_map(|[row, column]| link([row, column], [row, column + 1], along));
        let below = places().filter(|at| at[0] + 1 < rows || around);
        let below = below.filter_map(|[row, column]| link([row, column], [(row + 1) % rows, column], across));
        let links: Vec<Link> = right.chain(below).collect();
        let border = |column: usize| {
            let at = (0..rows).map(move |row| [row, column]);
            at.filter_map(|at| Some((node[at]?, along * 2.0 * cube(at)))).collect::<Vec<_>>()
        };
        let (inlet, outlet) = (border(0), border(columns - 1));
        let passed: Vec<f64> = places()
            .filter(|&at| node[at].is_some())
            .map(|[_, column]| (column as f64 + 0.5) / columns as f64)
            .collect();
        let mut off = vec![0.0; passed.len()];
        inlet.iter().chain(&outlet).for_each(|&(node, conductance)| off[node] += conductance);
        Some(Self { multigrid: Multigrid::new(Network::new(off, &links)), inlet, outlet, passed })
    }

    /// Flow under a pressure of one: the power Σ T(Δp)², whose error is of second order in that of the pressures.
    fn power(&self, p: &[f64]) -> f64 {
        let inlet: f64 = self.inlet.iter().map(|&(node, t)| t * (1.0 - p[node]).powi(2)).sum();
        let outlet: f64 = self.outlet.iter().map(|&(node, t)| t * p[node].powi(2)).sum();
        inlet + self.multigrid.network().power(p) + outlet
    }

    /// Conjugate gradients from pressures that fall straight.
    fn balanced(&self) -> Result<Balanced, HalfSpaceError> {
        let network = self.multigrid.network();
        let mut p: Vec<f64> = self.passed.iter().map(|passed| 1.0 - passed).collect();
        let mut image = vec![0.0; p.len()];
        network.outflow(&p, &mut image);
        let mut residual: Vec<f64> = image.iter().map(|image| -image).collect();
        self.inlet.iter().for_each(|&(node, conductance)| residual[node] += conductance);
        let (mut direction, mut before, mut last) = (vec![0.0; p.len()], residual.clone(), 0.0);
        let mut off = 0.0;
        for steps in 0..MOST {
            let scaled = self.multigrid.precondition(&residual);
            // The power is too large by the energy of what the pressures are off, which is about the slope.
            let (slope, power) = (dot(&residual, &scaled), self.power(&p));
            off = slope / power;
            if slope <= TOLERANCE * power {
                return Ok(Balanced { conductance: power, steps });
            }
            // The preconditioner is not the same in each step (Polak and Ribière).
            let memory = if last > 0.0 { (slope - dot(&before, &scaled)) / last } else { 0.0 };
            last = slope;
            direction.iter_mut().zip(&scaled).for_each(|(direction, value)| *direction = value + memory * *direction);
            network.outflow(&direction, &mut image);
            let length = dot(&direction, &residual) / dot(&direction, &image);
            p.iter_mut().zip(&direction).for_each(|(p, direction)| *p += length * direction);
            before.copy_from_slice(&residual);
            residual.iter_mut().zip(&image).for_each(|(residual, image)| *residual -= length * image);
        }
        Err(HalfSpaceError::NotConverged { iterations: MOST, residual: off, tolerance: TOLERANCE })
    }
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
    use proptest::strategy::{Strategy, ValueTree};
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

    /// A rough gap far from its threshold and near it, where necks let ten decades less through than its caves: the steps
    /// to the pressures hardly grow with the pixels.
    #[test]
    fn steps_do_not_grow() {
        let mut runner = proptest::test_runner::TestRunner::deterministic();
        let mut random = || f64::from((-100..100_i32).new_tree(&mut runner).unwrap().current());
        let waves: Vec<[f64; 3]> = (0..300).map(|_| [random() % 16.0, random() % 16.0, random()]).collect();
        let height = |x: f64, y: f64| -> f64 {
            let of = |[k, l, phase]: &[f64; 3]| (TAU * (k * x + l * y) + phase).cos() / (1.0 + k.hypot(*l)).powf(1.8);
            waves.iter().map(of).sum()
        };
        for pixels in [64, 128, 256] {
            let at = |pixel: usize| (pixel as f64 + 0.5) / pixels as f64;
            let heights = Array2::from_shape_fn((pixels, pixels), |(row, column)| height(at(column), at(row)));
            let above = |level: f64| {
                let gap = heights.mapv(|height| (height - level).max(0.0));
                Gap::of(gap.view(), [1.0; 2], Boundary::Periodic)
            };
            let rms = heights.std(0.0);
            let (mut open, mut sealed) = (-3.0 * rms, 3.0 * rms);
            while sealed - open > 1e-3 * rms {
                let level = 0.5 * (open + sealed);
                *(if above(level).is_some() { &mut open } else { &mut sealed }) = level;
            }
            for level in [open - rms, open] {
                let Balanced { conductance, steps } = above(level).unwrap().balanced().unwrap();
                assert!(conductance > 0.0 && steps <= 32, "{pixels} {level} {conductance:e} {steps}");
            }
        }
    }
}
