//! What of a surface lies within a range: the gap is a plane over each triangle between the middles of pixels.
//!
//! Four pixels that meet are cut into triangles both ways, each with half of the weight. So the energy −∫ σ₀ max(0, δ − g) dA
//! of a stress that ends at the gap δ is a function of the gaps on the pixels, and what pulls each of them is its slope:
//! where nothing jumps the work done is the energy gained, to rounding, however coarse the pixels are.

use crate::halfspace::Boundary;
use ndarray::Array2;

/// Four pixels that meet, row by row, each as its place in the order of all, and the part of a pixel between their middles.
struct Cell {
    corners: [usize; 4],
    area: f64,
}

/// The triangles of a cell cut both ways.
const TRIANGLES: [[usize; 3]; 4] = [[0, 1, 3], [0, 2, 3], [0, 1, 2], [3, 1, 2]];

/// How much of each pixel is within the range `range` \[m\] of the other surface, `gap` \[m\] away.
pub(super) fn shares(gap: &Array2<f64>, range: f64, boundary: Boundary) -> Array2<f64> {
    let near = nearness(gap, range);
    let mut shares = vec![0.0; near.len()];
    for cell in cells(gap.dim(), boundary) {
        let Some(inside) = of_cell(cell.corners.map(|at| near[at])) else { continue };
        for (corner, share) in cell.corners.into_iter().zip(inside.shares) {
            shares[corner] += cell.area * share;
        }
    }
    // There are as many shares as gaps, the only thing it can object to.
    Array2::from_shape_vec(gap.dim(), shares).unwrap_or_else(|_| Array2::zeros(gap.dim()))
}

/// Σ ∫ max(0, δ − g) dA over the pixels \[m, times the area of a pixel\] within the range δ = `range` \[m\].
pub(super) fn depth(gap: &Array2<f64>, range: f64, boundary: Boundary) -> f64 {
    let near = nearness(gap, range);
    let of = |cell: Cell| of_cell(cell.corners.map(|at| near[at])).map_or(0.0, |inside| cell.area * inside.depth);
    cells(gap.dim(), boundary).map(of).sum()
}

/// How far each pixel is within the range \[m\], row after row.
fn nearness(gap: &Array2<f64>, range: f64) -> Vec<f64> {
    gap.iter().map(|gap| range - gap).collect()
}

/// All cells; at a border that does not repeat the surface goes on level for half a pixel.
fn cells((rows, columns): (usize, usize), boundary: Boundary) -> impl Iterator<Item = Cell> {
    let pairs = move |count: usize| {
        let last = match boundary {
            Boundary::Periodic => count - 1,
            Boundary::Free => count,
        };
        (0..=last).map(move |k| match boundary {
            Boundary::Periodic => ([k, (k + 1) % count], 1.0),
            Boundary::Free => ([k.saturating_sub(1), k.min(count - 1)], if k == 0 || k == count { 0.5 } else { 1.0 }),
        })
    };
    pairs(rows).flat_map(move |(ends, high)| {
        let [above, below] = ends.map(|row| row * columns);
        pairs(columns).map(move |([left, right], wide)| Cell {
            corners: [above + left, above + right, below + left, below + right],
            area: high * wide,
        })
    })
}

/// What lies within the range, of an area of one: the part that belongs to each corner, and ∫ max(0, δ − g) dA.
#[derive(Clone, Copy)]
struct Inside<const CORNERS: usize> {
    shares: [f64; CORNERS],
    depth: f64,
}

/// A cell whose corners are `near` \[m\] within the range, unless nothing of it is.
#[inline]
fn of_cell(near: [f64; 4]) -> Option<Inside<4>> {
    if near.iter().all(|&near| near <= 0.0) {
        return None;
    }
    if near.iter().all(|&near| near >= 0.0) {
        return Some(Inside { shares: [0.25; 4], depth: 0.25 * near.iter().sum::<f64>() });
    }
    Some(of_cut_cell(near))
}

/// A cell through which the range ends.
fn of_cut_cell(near: [f64; 4]) -> Inside<4> {
    let mut inside = Inside { shares: [0.0; 4], depth: 0.0 };
    for corners in TRIANGLES {
        let part = of_triangle(corners.map(|corner| near[corner]));
        inside.depth += 0.25 * part.depth;
        corners.into_iter().zip(part.shares).for_each(|(corner, share)| inside.shares[corner] += 0.25 * share);
    }
    inside
}

/// A triangle; where there is no material at a corner, it is as far as the farthest other, and has no share.
fn of_triangle(near: [f64; 3]) -> Inside<3> {
    let least = near.iter().copied().filter(|near| near.is_finite()).fold(f64::INFINITY, f64::min);
    if least.is_infinite() {
        return Inside { shares: [0.0; 3], depth: 0.0 };
    }
    let Inside { mut shares, depth } = of_plane(near.map(|near| if near.is_finite() { near } else { least }));
    let whole: f64 = shares.iter().sum();
    shares.iter_mut().zip(near).filter(|(_, near)| !near.is_finite()).for_each(|(share, _)| *share = 0.0);
    let kept = if whole > 0.0 { shares.iter().sum::<f64>() / whole } else { 0.0 };
    Inside { shares, depth: kept * depth }
}

/// A triangle over which the gap is a plane.
fn of_plane(near: [f64; 3]) -> Inside<3> {
    let is_inside = near.map(|near| near > 0.0);
    let mean = near.iter().sum::<f64>() / 3.0;
    let alone = |alone: bool| is_inside.iter().position(|&inside| inside == alone).unwrap_or(0);
    match is_inside.iter().filter(|&&inside| inside).count() {
        0 => Inside { shares: [0.0; 3], depth: 0.0 },
        1 => of_corner(near, alone(true)),
        2 => {
            let outside = of_corner(near, alone(false));
            Inside { shares: outside.shares.map(|share| 1.0 / 3.0 - share), depth: mean - outside.depth }
        }
        _ => Inside { shares: [1.0 / 3.0; 3], depth: mean },
    }
}

/// The part of a triangle on the side of one corner, and ∫ (δ − g) dA over it.
fn of_corner(near: [f64; 3], corner: usize) -> Inside<3> {
    let [next, last] = [(corner + 1) % 3, (corner + 2) % 3];
    // How far along both edges the range ends.
    let along = |other: usize| near[corner] / (near[corner] - near[other]);
    let (one, two) = (along(next), along(last));
    let part = one * two / 3.0;
    let mut shares = [0.0; 3];
    (shares[corner], shares[next], shares[last]) = (part * (3.0 - one - two), part * one, part * two);
    Inside { shares, depth: part * near[corner] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn boundary() -> impl Strategy<Value = Boundary> {
        prop_oneof![Just(Boundary::Periodic), Just(Boundary::Free)]
    }

    proptest! {
        #![proptest_config(crate::laws::cases(128))]

        /// What pulls a pixel is the slope of the energy, closed in by differences of the convex energy on both sides.
        #[test]
        fn shares_are_slopes_of_the_depth(
            gaps in prop::collection::vec(0i32..40, 30),
            (range, step) in (1i32..40, 1i32..100),
            boundary in boundary(),
        ) {
            let gap = Array2::from_shape_vec((5, 6), gaps.iter().map(|&gap| f64::from(gap)).collect()).unwrap();
            let (range, step) = (f64::from(range), 1e-4 * f64::from(step));
            let shares = shares(&gap, range, boundary);
            for at in [[0, 0], [0, 3], [2, 5], [3, 2], [4, 5]] {
                let moved = |by: f64| {
                    let mut gap = gap.clone();
                    gap[at] += by;
                    depth(&gap, range, boundary)
                };
                let [before, here, after] = [-step, 0.0, step].map(moved);
                let bound = 1e-10 / step;
                prop_assert!((here - after) / step <= shares[at] + bound && shares[at] <= (before - here) / step + bound);
            }
        }

        /// Of a level gap, all of each pixel is within the range, or nothing; of a plane, the part that is.
        #[test]
        fn a_plane_is_cut_where_the_range_ends(rise in 1i32..20, range in 0i32..200, boundary in boundary()) {
            let (rise, range) = (0.1 * f64::from(rise), 0.1 * f64::from(range));
            let level = shares(&Array2::from_elem((4, 5), range), range * (1.0 + 1e-9) + 1e-9, boundary);
            prop_assert!(level.iter().all(|share| (share - 1.0).abs() < 1e-15));
            let plane = Array2::from_shape_fn((7, 8), |(_, column)| rise * column as f64);
            let sum: f64 = shares(&plane, range, Boundary::Free).sum();
            // From half a pixel before the first middle to where it ends, level for half a pixel at both borders.
            let exact = 7.0 * if range > 7.0 * rise { 8.0 } else if range > 0.0 { range / rise + 0.5 } else { 0.0 };
            prop_assert!((sum - exact).abs() < 1e-9, "{sum} {exact}");
        }
    }

    /// Beside a hole a pixel within the range is all within it.
    #[test]
    fn holes_take_nothing_from_their_neighbours() {
        let mut gap = Array2::zeros((4, 4));
        gap[[1, 2]] = f64::INFINITY;
        for boundary in [Boundary::Free, Boundary::Periodic] {
            let shares = shares(&gap, 1.0, boundary);
            assert!(shares.indexed_iter().all(|(at, share)| (share - f64::from(at != (1, 2))).abs() < 1e-15));
            assert!((depth(&gap, 1.0, boundary) - 15.0).abs() < 1e-14);
        }
    }
}
