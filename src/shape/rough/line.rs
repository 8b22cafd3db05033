//! The one-dimensional equivalent of a rough surface.

use super::{Random, Rings, RoughError, fourier::Transform};
use crate::numerics::complex::Complex;
use std::f64::consts::TAU;

/// A periodic rough line z(x) = Σ_k B_k cos(q_k x + φ_k), q_k = 2πk/length, B_k = √(2V_k), φ_k random in [0, 2π).
///
/// V_k is the variance of ring k ([`Rings`]), so ⟨z²⟩ = Σ B_k²/2 = 2 ∫ C₁D dq exactly, for every seed. One phase is drawn
/// per wave from the longest down: a finer cut-off with the same seed keeps the long waves. The same seed gives the
/// same bytes on every machine. With random phases heights are Gaussian only in the sense of many waves.
#[derive(Debug, Clone, PartialEq)]
pub struct RoughLine {
    length: f64,
    /// Amplitude [m] and phase [rad] of wave k at index k.
    waves: Vec<(f64, f64)>,
}

impl RoughLine {
    /// The line of a seed with the roughness of `rings`.
    #[must_use]
    pub fn new(rings: &Rings, seed: u64) -> Self {
        let mut random = Random::seeded(seed);
        let mut wave = |(k, v): (usize, &f64)| if k == 0 { (0.0, 0.0) } else { ((2.0 * v).sqrt(), random.phase()) };
        Self { length: rings.length(), waves: rings.variances().iter().enumerate().map(&mut wave).collect() }
    }

    /// Length [m] of one period.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Places x_j = (j + ½)Δx − length/2 [m], Δx = length/points, of the heights and slopes.
    #[must_use]
    pub fn places(&self, points: usize) -> Vec<f64> {
        let step = self.length / number(points);
        (0..points).map(|j| (number(j) + 0.5 - 0.5 * number(points)) * step).collect()
    }

    /// Heights z(x_j) [m] at a number of evenly spaced points.
    ///
    /// # Errors
    /// Fewer than two points on the shortest wave.
    pub fn heights(&self, points: usize) -> Result<Vec<f64>, RoughError> {
        self.sampled(points, |_, amplitude, phase| Complex::polar(amplitude, phase))
    }

    /// Slopes z′(x_j) at a number of evenly spaced points.
    ///
    /// # Errors
    /// Fewer than two points on the shortest wave.
    pub fn slopes(&self, points: usize) -> Result<Vec<f64>, RoughError> {
        let i = Complex { re: 0.0, im: 1.0 };
        let slope = |k, amplitude, phase| Complex::polar(TAU * number(k) / self.length * amplitude, phase) * i;
        self.sampled(points, slope)
    }

    /// Height [m] at any place [m], by the sum itself.
    #[must_use]
    pub fn height_at(&self, x: f64) -> f64 {
        let origin = 0.5 * self.length;
        let angle = |k: usize| TAU * number(k) * (x + origin) / self.length;
        self.waves.iter().enumerate().map(|(k, (b, phase))| b * libm::cos(angle(k) + phase)).sum()
    }

    /// Real part of the sum of waves with complex amplitudes at the half-step places.
    fn sampled(&self, points: usize, wave: impl Fn(usize, f64, f64) -> Complex) -> Result<Vec<f64>, RoughError> {
        let last = self.waves.len().saturating_sub(1);
        if 2 * last.max(1) > points {
            let short = self.length / number(last.max(1));
            let step = self.length / number(points);
            return Err(RoughError::TooFine { short, step, length: self.length, points, needed: 2 * last.max(1) });
        }
        let mut data = vec![Complex::default(); points];
        for (k, &(amplitude, phase)) in self.waves.iter().enumerate() {
            let half_step = 0.5 * TAU * number(k) / number(points);
            data[k] = wave(k, amplitude, phase) * Complex::polar(1.0, half_step);
        }
        Transform::new(points).run(&mut data);
        Ok(data.into_iter().map(|z| z.re).collect())
    }
}

#[expect(clippy::cast_precision_loss, reason = "points are far fewer than 2^53")]
fn number(n: usize) -> f64 {
    n as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::rough::RoughnessSpectrum;
    use proptest::prelude::*;

    fn rings(hurst: f64, points: usize) -> Rings {
        let short: f64 = 2.0 / number(points - 1);
        let rows = [(TAU, 1.0), (TAU / short, short.powf(2.0 * (1.0 + hurst)))];
        Rings::of(&RoughnessSpectrum::table(&rows).unwrap(), 1.0, points).unwrap()
    }

    fn mean_square(values: &[f64]) -> f64 {
        values.iter().map(|z| z * z).sum::<f64>() / number(values.len())
    }

    proptest! {
        /// Height, slope and every ring come back from the samples to rounding (the sum is orthogonal on the grid):
        /// the generated line satisfies ⟨z²⟩ = Σ B²/2 = 2 ∫ C₁D dq for any seed, length of the grid and H.
        #[test]
        fn roughness_is_recovered(h in 1i32..=100, points in 16usize..300, seed in 0u64..1000) {
            let rings = rings(0.01 * f64::from(h), points);
            let line = RoughLine::new(&rings, seed);
            let heights = line.heights(points).unwrap();
            prop_assert!((mean_square(&heights) / rings.mean_square(0) - 1.0).abs() < 1e-12);
            let slopes = line.slopes(points).unwrap();
            prop_assert!((mean_square(&slopes) / rings.mean_square(1) - 1.0).abs() < 1e-11);
            let mut spectrum: Vec<_> = heights.iter().map(|z| Complex::from(*z)).collect();
            Transform::new(points).run(&mut spectrum);
            for (k, v) in rings.variances().iter().enumerate().skip(1) {
                let found = 2.0 * spectrum[k].square() / number(points).powi(2);
                prop_assert!((found - v).abs() < 1e-13 * (rings.mean_square(0) * v).sqrt() + 1e-12 * v);
            }
        }

        /// Samples of any grid lie on the same line.
        #[test]
        fn finer_grids_sample_the_same_line(points in 16usize..200, more in 0usize..200, at in 0usize..16) {
            let line = RoughLine::new(&rings(0.7, points), 5);
            let heights = line.heights(points + more).unwrap();
            let there = line.height_at(line.places(points + more)[at]);
            prop_assert!((heights[at] - there).abs() < 1e-12 * line.waves[1].0);
        }
    }

    #[test]
    fn a_finer_cut_off_keeps_the_long_waves() {
        let (coarse, fine) = (RoughLine::new(&rings(0.8, 64), 3), RoughLine::new(&rings(0.8, 128), 3));
        for k in 1..20 {
            assert!((coarse.waves[k].1 - fine.waves[k].1).abs() <= 0.0);
        }
    }

    #[test]
    fn too_few_points_are_refused() {
        let line = RoughLine::new(&rings(0.8, 65), 1);
        assert!(line.heights(63).unwrap_err().to_string().contains("use at least 64 points"));
        assert!(line.heights(64).is_ok());
    }

    /// The same bytes on every machine: a digest of the bits, found once, of 100 points (Bluestein) and 128 (radix 2).
    #[test]
    fn a_seed_is_the_same_bytes_everywhere() {
        let digest = |points: usize| {
            let heights = RoughLine::new(&rings(0.8, 64), 42).heights(points).unwrap();
            heights.iter().fold(0u64, |d, z| d.rotate_left(7) ^ z.to_bits())
        };
        assert_eq!(format!("{:x} {:x}", digest(100), digest(128)), "f3fecd77ce9dfa2f 293dd904eb9200b7");
    }
}
