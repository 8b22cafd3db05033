//! How far a contact is drawn out along one direction, as shear feels it.

use super::Boundary;
use super::precision::Scratch;
use super::transform::{Multiplier, Size, good_length};
use ndarray::ArrayView2;
use std::f64::consts::TAU;

/// The mean of cos²φ over the waves of pressures, φ between a wave and the x axis: ½ where no direction is preferred, more
/// where the contact is longer across x than along it. `None` without pressures.
///
/// A wave of shear stress along x displaces along x by q̂(1 − ν cos²φ)/(G|k|), one of pressure across by p̂(1 − ν)/(G|k|)
/// (Johnson 1985, from Cerruti's and Boussinesq's solutions). Stresses in the ratio of the pressures do, weighted by
/// themselves, ∬|p̂|²(1 − ν cos²φ)/|k| over ∬|p̂|²(1 − ν)/|k|: with ⟨cos²φ⟩ = ½ that is the ratio E*/G* of
/// [`Pair`](crate::material::Pair); of an ellipse, exactly that of Mindlin's compliances along its axes (1949).
///
/// On a free boundary the waves are those of a window twice as wide, each weighted by the mean over those nearest to it.
///
/// # Examples
/// ```
/// use ndarray::Array2;
/// use springbed::halfspace::{Boundary, lengthwise};
///
/// // A strip across x is all along x for the waves, one along x not at all.
/// let strip = Array2::from_shape_fn((16, 16), |(_, column)| if column < 5 { 1.0 } else { 0.0 });
/// assert_eq!(lengthwise(strip.view(), [1.0; 2], Boundary::Periodic), Some(1.0));
/// assert_eq!(lengthwise(strip.t(), [1.0; 2], Boundary::Periodic), Some(0.0));
/// ```
#[must_use]
pub fn lengthwise(pressure: ArrayView2<'_, f64>, pixel: [f64; 2], boundary: Boundary) -> Option<f64> {
    let (rows, columns) = pressure.dim();
    let size = Size { rows, columns };
    let period = match boundary {
        Boundary::Free => Size { rows: good_length(2 * rows), columns: good_length(2 * columns) },
        Boundary::Periodic => size,
    };
    let cell = [TAU / (period.columns as f64 * pixel[0]), TAU / (period.rows as f64 * pixel[1])];
    let pressures: Vec<f64> = pressure.iter().copied().collect();
    let weighed = |along: bool| {
        let mut symbol = Vec::with_capacity((period.columns / 2 + 1) * (period.rows / 2 + 1));
        for column in 0..=period.columns / 2 {
            for row in 0..=period.rows / 2 {
                let wave = [column as f64 * cell[0], row as f64 * cell[1]];
                symbol.push(match boundary {
                    Boundary::Free => of_cell(wave, cell, along),
                    Boundary::Periodic if row + column == 0 => 0.0,
                    Boundary::Periodic => of_wave(wave, along),
                });
            }
        }
        let mut weighed = vec![0.0; pressures.len()];
        Multiplier::new(size, period, symbol).apply(&pressures, &mut weighed, &mut Scratch::default());
        pressures.iter().zip(&weighed).map(|(one, other)| one * other).sum::<f64>()
    };
    let all = weighed(false);
    (all > 0.0).then(|| weighed(true) / all)
}

/// 1/|k|, or cos²φ/|k|, of a wave.
fn of_wave([x, y]: [f64; 2], along: bool) -> f64 {
    let wave = x.hypot(y);
    if along { (x / wave).powi(2) / wave } else { wave.recip() }
}

/// Their means over the waves about one, from ∬dk/|k| = x arsinh y/x + y arsinh x/y up to the wave (x, y), of which the second
/// term is that of cos²φ.
fn of_cell([x, y]: [f64; 2], cell: [f64; 2], along: bool) -> f64 {
    let term = |one: f64, other: f64| if one.abs() > 0.0 { one * (other / one.abs()).asinh() } else { 0.0 };
    let up_to = |x: f64, y: f64| if along { term(y, x) } else { term(x, y) + term(y, x) };
    let [(left, right), (low, high)] =
        [(x, cell[0]), (y, cell[1])].map(|(middle, side)| (middle - 0.5 * side, middle + 0.5 * side));
    let integral = (up_to(right, high) - up_to(left, high)) - (up_to(right, low) - up_to(left, low));
    integral / (cell[0] * cell[1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::quadrature::node_and_weight;
    use ndarray::Array2;

    /// Of an ellipse with the semi-axes a along x and b the waves at the angle φ weigh 1/√(a²cos²φ + b²sin²φ).
    fn of_ellipse(a: f64, b: f64) -> f64 {
        let mean = |of: &dyn Fn(f64) -> f64| -> f64 {
            let angle = |k| {
                let (node, weight) = node_and_weight(60, k);
                (0.25 * std::f64::consts::PI * (1.0 + node), weight)
            };
            (0..60).map(angle).map(|(phi, weight)| weight * of(phi) / (a * phi.cos()).hypot(b * phi.sin())).sum()
        };
        mean(&|phi| phi.cos().powi(2)) / mean(&|_| 1.0)
    }

    #[test]
    fn an_ellipse_weighs_its_waves_by_its_axes() {
        for (a, b, pixel) in [(20.0, 20.0, [1.0; 2]), (30.0, 10.0, [1.0; 2]), (75.0, 30.0, [2.5, 1.0])] {
            let place = |k: usize, side: f64| (k as f64 - 47.5) * side;
            let pressure = Array2::from_shape_fn((96, 96), |(i, j)| {
                (1.0 - (place(j, pixel[0]) / a).powi(2) - (place(i, pixel[1]) / b).powi(2)).max(0.0).sqrt()
            });
            let found = lengthwise(pressure.view(), pixel, Boundary::Free).unwrap_or(0.0);
            // An edge that lies between pixels makes half an axis of ten of them longer or shorter by a thousandth.
            assert!((found - of_ellipse(a, b)).abs() < 2e-3, "{a} {b}: {found} {}", of_ellipse(a, b));
            let turned = lengthwise(pressure.t(), [pixel[1], pixel[0]], Boundary::Free).unwrap_or(0.0);
            assert!((found + turned - 1.0).abs() < 1e-12);
        }
        let nothing = Array2::zeros((8, 8));
        assert!(lengthwise(nothing.view(), [1.0; 2], Boundary::Free).is_none());
    }
}
