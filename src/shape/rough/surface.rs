//! Random rough surfaces.

use super::{
    Random, Rings, RoughError, RoughnessSpectrum,
    fourier::{Transform, transposed},
};
use crate::numerics::complex::Complex;
use ndarray::Array2;
use rayon::prelude::*;
use std::f64::consts::TAU;

/// A periodic random surface of a spectrum: heights [m] on a grid of `points` × `points` over a square of side `length` [m].
///
/// h(x, y) = Σ B cos(q·x + φ) over half of the wavevectors q = 2π(m, n)/length inside the cut-offs, φ random in [0, 2π).
/// The waves of a ring share its variance in proportion to C(|q|) ([`Rings`]), so the rms height is that of the
/// spectrum for every seed, and [`RoughLine`](super::RoughLine) of the same rings is the equivalent line. The phase of a
/// wave depends on the seed and on (m, n) only: a finer grid or cut-off keeps the long waves. The
/// same seed gives the same bytes on every machine and with any number of threads.
///
/// # Errors
/// Waves longer than the side or shorter than two steps.
///
/// ```
/// use springbed::shape::rough::{RoughnessSpectrum, rough_surface};
/// let spectrum = RoughnessSpectrum::table(&[(6.4, 1e-12), (64.0, 1e-15)])?;
/// let heights = rough_surface(&spectrum, 1.0, 32, 7)?;
/// let variance = heights.iter().map(|h| h * h).sum::<f64>() / 1024.0;
/// assert!((variance.sqrt() / spectrum.rms_height() - 1.0).abs() < 1e-12);
/// # Ok::<(), springbed::shape::rough::RoughError>(())
/// ```
pub fn rough_surface(
    spectrum: &RoughnessSpectrum,
    length: f64,
    points: usize,
    seed: u64,
) -> Result<Array2<f64>, RoughError> {
    let rings = Rings::of(spectrum, length, points)?;
    let waves = Amplitudes::new(spectrum, &rings);
    let transform = Transform::new(points);
    let mut columns = vec![Complex::default(); points * points];
    columns.par_chunks_mut(points).enumerate().for_each(|(m, line)| waves.fill(line, m, seed, &transform));
    let mut rows = transposed(&columns, points);
    transform.run_lines(&mut rows);
    let heights = Array2::from_shape_fn((points, points), |(i, j)| rows[i * points + j].re);
    Ok(heights)
}

/// Amplitudes of the waves of a surface: a factor per ring times √C(|q|).
struct Amplitudes<'a> {
    spectrum: &'a RoughnessSpectrum,
    width: f64,
    cut_offs: (f64, f64),
    /// 2V_k / Σ C over the half of ring k.
    factors: Vec<f64>,
}

impl<'a> Amplitudes<'a> {
    fn new(spectrum: &'a RoughnessSpectrum, rings: &Rings) -> Self {
        let factors = vec![0.0; rings.variances().len()];
        let mut waves = Self { spectrum, width: TAU / rings.length(), cut_offs: spectrum.cut_offs(), factors };
        let last = waves.factors.len() - 1;
        let mut sums = waves.factors.clone();
        for m in 0..=last {
            for n in waves.partners(m) {
                if let Some((ring, density)) = waves.of(m, n) {
                    sums[ring] += density;
                }
            }
        }
        let factor = |(v, sum): (&f64, &f64)| if *sum > 0.0 { 2.0 * v / sum } else { 0.0 };
        waves.factors = rings.variances().iter().zip(&sums).map(factor).collect();
        waves
    }

    /// Second indices of the half plane m > 0, or m = 0 and n > 0.
    fn partners(&self, m: usize) -> impl Iterator<Item = isize> + use<> {
        let last = isize::try_from(self.factors.len() - 1).unwrap_or(isize::MAX);
        (if m == 0 { 1 } else { -last })..=last
    }

    /// Ring and density C of a wave, if it lies inside the cut-offs.
    #[expect(clippy::cast_precision_loss, reason = "indices of waves are far below 2^53")]
    fn of(&self, m: usize, n: isize) -> Option<(usize, f64)> {
        let order = (m as f64).hypot(n as f64);
        let q = order * self.width;
        let (least, greatest) = self.cut_offs;
        if q < least * (1.0 - SLACK) || q > greatest * (1.0 + SLACK) {
            return None;
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "below the number of rings")]
        let ring = (order.round() as usize).clamp(self.first_ring(), self.factors.len() - 1);
        Some((ring, self.spectrum.density(q.clamp(least, greatest))))
    }

    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the first ring is small")]
    fn first_ring(&self) -> usize {
        (self.cut_offs.0 / self.width - SLACK).floor() as usize + 1
    }

    /// Fills and transforms the waves of first index m along their second index.
    fn fill(&self, line: &mut [Complex], m: usize, seed: u64, transform: &Transform) {
        if m >= self.factors.len() {
            return;
        }
        for n in self.partners(m) {
            let Some((ring, density)) = self.of(m, n) else { continue };
            let amplitude = (self.factors[ring] * density).sqrt();
            line[n.rem_euclid(line.len().cast_signed()).cast_unsigned()] =
                Complex::polar(amplitude, wave_phase(seed, m, n));
        }
        transform.run(line);
    }
}

/// Wavelengths that equal a limit but for rounding count as equal.
const SLACK: f64 = 1e-9;

/// Phase of one wave of one seed.
fn wave_phase(seed: u64, m: usize, n: isize) -> f64 {
    let place = ((m as u64) << 32).wrapping_add_signed(n as i64);
    Random::seeded(Random::seeded(seed).bits() ^ place).phase()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::rough::{Border, HeightMap};
    use proptest::prelude::*;

    fn spectrum(hurst: f64, short: f64) -> RoughnessSpectrum {
        RoughnessSpectrum::table(&[(TAU, 1.0), (TAU / short, short.powf(2.0 * (1.0 + hurst)))]).unwrap()
    }

    #[test]
    fn any_number_of_threads_gives_the_same_bits() {
        let with = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| rough_surface(&spectrum(0.8, 0.05), 1.0, 64, 9).unwrap())
        };
        assert_eq!(with(1), with(3));
    }

    /// A surface on twice the points is the same surface: every second point agrees to rounding.
    #[test]
    fn a_finer_grid_samples_the_same_surface() {
        let s = spectrum(0.6, 0.1);
        let (coarse, fine) = (rough_surface(&s, 1.0, 40, 4).unwrap(), rough_surface(&s, 1.0, 80, 4).unwrap());
        let scale = s.rms_height();
        for ((i, j), h) in coarse.indexed_iter() {
            assert!((h - fine[(2 * i, 2 * j)]).abs() < 1e-12 * scale);
        }
    }

    proptest! {
        #![proptest_config(crate::laws::cases(32))]
        /// The height map made from a spectrum has the rings of the spectrum, ring by ring.
        #[test]
        fn the_spectrum_is_recovered(h in 10i32..=100, points in 8usize..50, seed in 0u64..100) {
            let s = spectrum(0.01 * f64::from(h), 2.1 / f64::from(u32::try_from(points).unwrap()));
            let rings = Rings::of(&s, 1.0, points).unwrap();
            let heights = rough_surface(&s, 1.0, points, seed).unwrap();
            let map = HeightMap::new(heights, (1.0 / points as f64, 1.0 / points as f64)).unwrap();
            let found = map.rings(Border::Periodic);
            let total = rings.mean_square(0);
            prop_assert!((found.mean_square(0) / total - 1.0).abs() < 1e-12);
            let last = rings.variances().len() - 1;
            for (k, v) in rings.variances().iter().enumerate().take(last) {
                prop_assert!((found.variances()[k] - v).abs() <= 1e-12 * (total * v).sqrt(), "{k}");
            }
            // The last ring reaches out to the cut-off, half a ring further at most.
            let rest: f64 = found.variances()[last..].iter().sum();
            prop_assert!((rest - rings.variances()[last]).abs() < 1e-12 * total.sqrt() * rings.variances()[last].sqrt());
        }
    }
}
