//! Heights with noise, made such that the contact stays in one piece.
//!
//! The contact under f(r) is a full circle at every depth if g′(x) = ∫₀^{π/2} (r f′)′ dθ at r = x sin θ is nowhere negative
//! (Popov & Heß 2015, eq. 3.2 under the integral): if r f′ = df/d ln r rises. The slopes of the secants over ln r,
//! weighted by their lengths, are replaced by the nearest ones that rise and are not below zero.

use crate::numerics::isotonic::isotonic;
use crate::shape::Moved;

/// The heights at rising radii whose slope over ln r rises, with the mean of the measured ones, and how far they were moved.
/// Of heights that do already nothing changes but rounding.
pub(super) fn smoothed(radii: &[f64], heights: &[f64]) -> (Vec<f64>, Moved) {
    let lengths: Vec<f64> = radii.windows(2).skip(1).map(|pair| (pair[1] / pair[0]).ln()).collect();
    let rises = heights.windows(2).map(|pair| pair[1] - pair[0]);
    let slopes: Vec<f64> = rises.skip(1).zip(&lengths).map(|(rise, length)| rise / length).collect();
    let rising = isotonic(&slopes, &lengths);
    // Over the first radius, of endless length, r f′ rises from zero to the first slope.
    let most = rising.first().copied().unwrap_or(0.0).max(0.0);
    let first = (heights[1] - heights[0]).clamp(0.0, most);
    let mut found = vec![0.0, first];
    for (slope, length) in rising.iter().zip(&lengths) {
        found.push(found[found.len() - 1] + slope.max(0.0) * length);
    }
    let count = heights.len() as f64;
    let mean = heights.iter().zip(&found).map(|(height, found)| height - found).sum::<f64>() / count;
    found.iter_mut().for_each(|height| *height += mean);
    let off = heights.iter().zip(&found).map(|(height, found)| (height - found).abs());
    let (largest, squares) = off.fold((0.0f64, 0.0), |(largest, sum), off| (largest.max(off), sum + off * off));
    (found, Moved { largest, rms: (squares / count).sqrt() })
}
