//! Isotropic power spectra of rough surfaces.

use super::RoughError;
use std::f64::consts::TAU;

/// An isotropic power spectrum C(q) [m⁴] that is a power law between its knots and zero outside.
///
/// Convention of Persson: ⟨h²⟩ = 2π ∫ C(q) q dq, with q the wavevector [rad/m] and h the height about the mean plane
/// (Persson et al. 2008, figure 1). The one-dimensional equivalent is C₁D(q) = π q C(q) [m³] with
/// ⟨z²⟩ = 2 ∫ C₁D dq (Popov & Heß 2015, ch. 10).
#[derive(Debug, Clone, PartialEq)]
pub struct RoughnessSpectrum {
    pieces: Vec<PowerLaw>,
}

/// C(q) = density (q/from)^exponent for q in [from, to].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PowerLaw {
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) density: f64,
    pub(super) exponent: f64,
}

impl PowerLaw {
    fn at(&self, q: f64) -> f64 {
        self.density * (q / self.from).powf(self.exponent)
    }

    /// ∫ qⁿ C dq over the part of the piece inside `[low, high]`.
    fn integral(&self, power: i32, (low, high): (f64, f64)) -> f64 {
        let (low, high) = (low.max(self.from), high.min(self.to));
        if low >= high {
            return 0.0;
        }
        let scale = self.density * self.from.powi(power + 1);
        scale * power_integral(self.exponent + f64::from(power), low / self.from, high / low)
    }
}

/// ∫ xˢ dx from a to a·ratio = aˢ⁺¹ L (e^{(s+1)L} − 1)/((s+1)L), L = ln ratio; smooth through s = −1.
fn power_integral(s: f64, a: f64, ratio: f64) -> f64 {
    let octaves = ratio.ln();
    a.powf(s + 1.0) * octaves * relative_growth((s + 1.0) * octaves)
}

/// (eʸ − 1)/y, 1 at y = 0.
fn relative_growth(y: f64) -> f64 {
    if y.abs() < f64::MIN_POSITIVE { 1.0 } else { y.exp_m1() / y }
}

impl RoughnessSpectrum {
    pub(super) fn from_pieces(pieces: Vec<PowerLaw>) -> Self {
        Self { pieces }
    }

    /// A tabulated spectrum: wavevectors [rad/m], increasing, and densities C [m⁴], power laws between the rows.
    ///
    /// # Errors
    /// Fewer than two rows; a row that is not positive and finite, or does not increase.
    pub fn table(rows: &[(f64, f64)]) -> Result<Self, RoughError> {
        if rows.len() < 2 {
            return Err(RoughError::SpectrumRows(rows.len()));
        }
        for (index, row) in rows.iter().enumerate() {
            check_row(index, *row, index.checked_sub(1).map(|before| rows[before].0))?;
        }
        let pieces = rows.windows(2).map(|pair| {
            let ((from, density), (to, next)) = (pair[0], pair[1]);
            PowerLaw { from, to, density, exponent: (next / density).ln() / (to / from).ln() }
        });
        Ok(Self { pieces: pieces.collect() })
    }

    /// C(q) [m⁴] at a wavevector [rad/m]; zero outside the cut-offs.
    #[must_use]
    pub fn density(&self, q: f64) -> f64 {
        self.pieces.iter().find(|p| q >= p.from && q <= p.to).map_or(0.0, |p| p.at(q))
    }

    /// Least and greatest wavevector [rad/m] with roughness.
    #[must_use]
    pub fn cut_offs(&self) -> (f64, f64) {
        (self.pieces.first().map_or(0.0, |p| p.from), self.pieces.last().map_or(0.0, |p| p.to))
    }

    /// Mean square of the n-th derivative in the sense 2π ∫ qⁿ⁺ⁿ⁺¹ C dq = 2 ∫ q²ⁿ C₁D dq over wavevectors in `band`.
    ///
    /// n = 0: height variance [m²]; 1: mean square slope; 2: mean square of ∇²h [1/m²].
    #[must_use]
    pub fn mean_square(&self, derivative: u8, band: (f64, f64)) -> f64 {
        let power = 2 * i32::from(derivative) + 1;
        self.pieces.iter().map(|p| p.integral(power, band)).sum::<f64>() * TAU
    }

    /// Root mean square height [m] of the surface, and of its equivalent line.
    #[must_use]
    pub fn rms_height(&self) -> f64 {
        self.mean_square(0, self.cut_offs()).sqrt()
    }

    /// Root mean square of |∇h| on the surface, and of z′ on its equivalent line.
    #[must_use]
    pub fn rms_slope(&self) -> f64 {
        self.mean_square(1, self.cut_offs()).sqrt()
    }

    /// Root mean square of the mean curvature ∇²h/2 [1/m] of the surface (half of that of z″ on the line).
    #[must_use]
    pub fn rms_curvature(&self) -> f64 {
        0.5 * self.mean_square(2, self.cut_offs()).sqrt()
    }

    /// The spectrum with every density multiplied by a positive factor.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        let scale = |p: &PowerLaw| PowerLaw { density: p.density * factor, ..*p };
        Self { pieces: self.pieces.iter().map(scale).collect() }
    }
}

fn check_row(index: usize, (q, density): (f64, f64), before: Option<f64>) -> Result<(), RoughError> {
    let fault = |fault| Err(RoughError::SpectrumRow { row: index + 1, fault });
    if !(q.is_finite() && q > 0.0) {
        return fault(format!("wavevector {q:?} rad/m: expected a finite number above zero"));
    }
    if !(density.is_finite() && density > 0.0) {
        return fault(format!("density {density:?} m^4: expected a finite number above zero"));
    }
    match before {
        Some(before) if q <= before => fault(format!("wavevector {q:?} rad/m does not increase from {before:?} rad/m")),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_bad_table_names_its_row() {
        let text = |rows: &[(f64, f64)]| RoughnessSpectrum::table(rows).unwrap_err().to_string();
        assert!(text(&[(1.0, 1.0)]).contains("at least two rows"));
        assert!(text(&[(1.0, 1.0), (1.0, 2.0)]).contains("row 2: wavevector 1.0 rad/m does not increase"));
        assert!(text(&[(1.0, 0.0), (2.0, 2.0)]).contains("row 1: density 0.0"));
        assert!(text(&[(1.0, 1.0), (2.0, f64::NAN)]).contains("row 2: density NaN"));
        assert!(text(&[(-1.0, 1.0), (2.0, 2.0)]).contains("row 1: wavevector -1.0"));
    }

    /// C = q⁻² between 1 and 2: 2π ∫ q⁻¹ dq = 2π ln 2, 2π ∫ q dq = 3π, 2π ∫ q³ dq = 7.5π.
    #[test]
    fn an_integrable_table_gives_its_integrals() {
        let s = RoughnessSpectrum::table(&[(1.0, 1.0), (2.0, 0.25)]).unwrap();
        assert!((s.rms_height().powi(2) / (TAU * 2f64.ln()) - 1.0).abs() < 4.0 * f64::EPSILON);
        assert!((s.rms_slope().powi(2) / (1.5 * TAU) - 1.0).abs() < 4.0 * f64::EPSILON);
        assert!((4.0 * s.rms_curvature().powi(2) / (3.75 * TAU) - 1.0).abs() < 4.0 * f64::EPSILON);
    }

    proptest! {
        /// A band cut anywhere is the sum of its parts, and the line carries what the surface carries.
        #[test]
        fn bands_add_up(h in 1i32..=100, cut in 1i32..99, wave in -40i32..80) {
            let q = 10f64.powf(0.1 * f64::from(wave));
            let exponent = -2.0 * (1.0 + 0.01 * f64::from(h));
            let s = RoughnessSpectrum::table(&[(q, 1.0), (2.0 * q, 1.0), (200.0 * q, 100f64.powf(exponent))]).unwrap();
            let middle = q * 200f64.powf(0.01 * f64::from(cut));
            for n in 0..3 {
                let whole = s.mean_square(n, (q, 200.0 * q));
                let parts = s.mean_square(n, (q, middle)) + s.mean_square(n, (middle, 200.0 * q));
                prop_assert!((parts / whole - 1.0).abs() < 1e-14, "{}", parts / whole - 1.0);
            }
        }
    }
}
