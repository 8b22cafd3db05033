//! What is done to measured heights before they are pressed: points that stick out are taken away, missing ones filled,
//! a tilt taken off.

use ndarray::Array2;

/// Half the side of the square of neighbours a point is held against.
const NEAR: usize = 2;
/// Standard deviations of a normal distribution in its median absolute deviation.
const DEVIATIONS: f64 = 1.482_602_218_505_602;
/// Part of the range of heights by which a filled point may still change.
const SETTLED: f64 = 1e-12;
/// Sweeps before a fill is taken as it is.
const SWEEPS: usize = 20_000;

/// Takes away (as NaN) the heights that are further than `limit` standard deviations from the median of the 5 × 5 points
/// about them; how many those are.
///
/// The standard deviation is that of all such distances, 1.4826 times their median (Hampel's identifier), so that the
/// outliers do not hide each other. A rough surface has distances of many sizes: below a limit of about 5 true summits
/// go with the outliers.
pub fn without_outliers(heights: &mut Array2<f64>, limit: f64) -> usize {
    let distances = distances(heights);
    let mut known: Vec<f64> = distances.iter().copied().filter(|distance| distance.is_finite()).map(f64::abs).collect();
    let deviation = DEVIATIONS * median(&mut known).unwrap_or(0.0);
    let mut taken = 0;
    for (height, distance) in heights.iter_mut().zip(&distances) {
        if distance.abs() > limit * deviation {
            (*height, taken) = (f64::NAN, taken + 1);
        }
    }
    taken
}

/// Distance of each height from the median of its neighbourhood.
fn distances(heights: &Array2<f64>) -> Array2<f64> {
    let (rows, columns) = heights.dim();
    let range = |at: usize, count: usize| at.saturating_sub(NEAR)..(at + NEAR + 1).min(count);
    let mut near = Vec::with_capacity((2 * NEAR + 1).pow(2));
    Array2::from_shape_fn((rows, columns), |(row, column)| {
        near.clear();
        for beside in range(row, rows) {
            near.extend(
                range(column, columns).map(|other| heights[[beside, other]]).filter(|height| height.is_finite()),
            );
        }
        heights[[row, column]] - median(&mut near).unwrap_or(f64::NAN)
    })
}

/// The median; the values are put in another order.
fn median(values: &mut [f64]) -> Option<f64> {
    let middle = values.len() / 2;
    (!values.is_empty()).then(|| *values.select_nth_unstable_by(middle, f64::total_cmp).1)
}

/// Puts heights in the place of missing ones (NaN) as a membrane held at the others does: each is the mean of its
/// neighbours. How many those are; `None` if all are missing.
pub fn filled(heights: &mut Array2<f64>) -> Option<usize> {
    let known: Vec<f64> = heights.iter().copied().filter(|height| height.is_finite()).collect();
    let mean = known.iter().sum::<f64>() / known.len() as f64;
    let low = known.iter().copied().reduce(f64::min)?;
    let range = known.iter().copied().fold(low, f64::max) - low;
    let missing: Vec<(usize, usize)> =
        heights.indexed_iter().filter(|(_, height)| !height.is_finite()).map(|(place, _)| place).collect();
    missing.iter().for_each(|&place| heights[place] = mean);
    for _ in 0..SWEEPS {
        let mut change = 0.0_f64;
        for &place in &missing {
            let stretched = relaxed(heights, place);
            change = change.max((stretched - heights[place]).abs());
            heights[place] = stretched;
        }
        if change <= SETTLED * range {
            break;
        }
    }
    Some(missing.len())
}

/// Over-relaxation, which takes a membrane over many points to rest sooner than its mean alone.
const OVER: f64 = 1.7;

fn relaxed(heights: &Array2<f64>, (row, column): (usize, usize)) -> f64 {
    let (rows, columns) = heights.dim();
    let beside = [
        (row.checked_sub(1), Some(column)),
        (Some(row + 1).filter(|&row| row < rows), Some(column)),
        (Some(row), column.checked_sub(1)),
        (Some(row), Some(column + 1).filter(|&column| column < columns)),
    ];
    let (mut sum, mut count) = (0.0, 0.0);
    for place in beside.into_iter().filter_map(|(row, column)| row.zip(column)) {
        sum += heights[place];
        count += 1.0;
    }
    let here = heights[[row, column]];
    if count > 0.0 { here + OVER * (sum / count - here) } else { here }
}

/// Takes off the plane z = a + bx + cy of least squares through the heights that are there.
pub fn levelled(heights: &mut Array2<f64>) {
    let (rows, columns) = heights.dim();
    let centred = |(row, column): (usize, usize)| {
        [1.0, column as f64 - 0.5 * (columns - 1) as f64, row as f64 - 0.5 * (rows - 1) as f64]
    };
    let (mut normal, mut right) = ([[0.0; 3]; 3], [0.0; 3]);
    for (place, &height) in heights.indexed_iter().filter(|(_, height)| height.is_finite()) {
        let terms = centred(place);
        for (row, &one) in terms.iter().enumerate() {
            right[row] += one * height;
            terms.iter().zip(&mut normal[row]).for_each(|(other, sum)| *sum += one * other);
        }
    }
    let plane = solved(normal, right);
    for (place, height) in heights.indexed_iter_mut() {
        *height -= centred(place).iter().zip(&plane).map(|(term, factor)| term * factor).sum::<f64>();
    }
}

/// The solution of three equations, positive (semi)definite; a term nothing tells of is zero.
fn solved(mut matrix: [[f64; 3]; 3], mut right: [f64; 3]) -> [f64; 3] {
    for k in 0..3 {
        let pivot = matrix[k][k];
        if pivot <= 1e-12 * matrix[0][0].max(f64::MIN_POSITIVE) {
            continue;
        }
        for row in (0..3).filter(|&row| row != k) {
            let factor = matrix[row][k] / pivot;
            let line = matrix[k];
            line.iter().zip(&mut matrix[row]).for_each(|(one, other)| *other -= factor * one);
            right[row] -= factor * right[k];
        }
    }
    let part = |k: usize| {
        if matrix[k][k] > 1e-12 * matrix[0][0].max(f64::MIN_POSITIVE) { right[k] / matrix[k][k] } else { 0.0 }
    };
    [part(0), part(1), part(2)]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plane() -> Array2<f64> {
        Array2::from_shape_fn((12, 17), |(i, j)| 3.0 + 0.25 * i as f64 - 0.5 * j as f64)
    }

    #[test]
    fn a_plane_is_taken_off_whatever_is_missing() {
        let mut heights = plane();
        heights[[3, 4]] = f64::NAN;
        heights[[0, 0]] = f64::NAN;
        levelled(&mut heights);
        assert!(heights.iter().filter(|height| height.is_finite()).all(|height| height.abs() < 1e-12));
        assert_eq!(heights.iter().filter(|height| height.is_nan()).count(), 2);
        // A row alone has no slope across.
        let mut row = Array2::from_shape_fn((1, 5), |(_, j)| j as f64);
        levelled(&mut row);
        assert!(row.iter().all(|height| height.abs() < 1e-12));
    }

    /// A membrane over a hole in a plane is the plane.
    #[test]
    fn a_hole_in_a_plane_is_filled_with_it() {
        let mut heights = plane();
        for (row, column) in [(5, 5), (5, 6), (6, 5), (6, 6), (7, 6), (1, 15)] {
            heights[[row, column]] = f64::NAN;
        }
        assert_eq!(filled(&mut heights), Some(6));
        assert!(heights.iter().zip(&plane()).all(|(found, right)| (found - right).abs() < 1e-9));
        assert_eq!(filled(&mut Array2::from_elem((4, 4), f64::NAN)), None);
        assert_eq!(filled(&mut plane()), Some(0));
    }

    #[test]
    fn spikes_go_and_waves_stay() {
        let mut heights = Array2::from_shape_fn((30, 30), |(i, j)| (0.4 * i as f64).sin() + (0.3 * j as f64).cos());
        let whole = heights.clone();
        assert_eq!(without_outliers(&mut heights, 20.0), 0);
        heights[[10, 20]] = 40.0;
        heights[[11, 20]] = -30.0;
        assert_eq!(without_outliers(&mut heights, 20.0), 2);
        assert!(heights[[10, 20]].is_nan() && heights[[11, 20]].is_nan());
        filled(&mut heights);
        assert!((heights[[10, 20]] - whole[[10, 20]]).abs() < 0.1);
    }
}
