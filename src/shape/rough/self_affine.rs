//! Self-affine roughness between two cut-offs.

use super::{RoughError, RoughnessSpectrum, spectrum::PowerLaw};
use crate::input::quantity::{Hurst, Length, Positive};
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// Self-affine roughness: C = C₀ for wavelengths from `long` to `roll_off`, C = C₀ (q/q_r)^{−2(1+H)} from there to `short`.
///
/// q = 2π/wavelength, q_r that of the roll-off, H the Hurst exponent (fractal dimension 3 − H). Without a
/// roll-off the power law begins at `long`. How rough it is follows from the rms height or from the plateau C₀.
/// Valid for isotropic surfaces with random phases.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SelfAffine {
    /// Hurst exponent H, above 0 and at most 1; 0.8 is common.
    pub hurst: Hurst,
    /// Root mean square height [m] of the whole spectrum; this or `amplitude`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rms: Option<Length>,
    /// Plateau C₀ [m⁴]; this or `rms`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub amplitude: Option<Positive>,
    /// Longest wavelength [m].
    pub long: Length,
    /// Wavelength [m] at which the plateau ends; `long` if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub roll_off: Option<Length>,
    /// Shortest wavelength [m].
    pub short: Length,
}

impl SelfAffine {
    /// The spectrum of these parameters.
    ///
    /// # Errors
    /// Cut-offs out of order; both or neither of `rms` and `amplitude`.
    pub fn spectrum(&self) -> Result<RoughnessSpectrum, RoughError> {
        let (long, short) = (self.long.si(), self.short.si());
        let roll_off = self.roll_off.map_or(long, Length::si);
        let cut_off = |name, length| CutOff { name, length };
        ordered(&cut_off("long", long), "at least", &cut_off("roll_off", roll_off))?;
        let end = cut_off(if self.roll_off.is_some() { "roll_off" } else { "long" }, roll_off);
        ordered(&end, "above", &cut_off("short", short))?;
        let shape = unit_plateau(self.hurst.si(), (TAU / long, TAU / roll_off, TAU / short));
        match (self.rms, self.amplitude) {
            (Some(rms), None) => Ok(shape.scaled((rms.si() / shape.rms_height()).powi(2))),
            (None, Some(amplitude)) => Ok(shape.scaled(amplitude.si())),
            (Some(_), Some(_)) => Err(RoughError::RmsOrAmplitude("both")),
            (None, None) => Err(RoughError::RmsOrAmplitude("neither")),
        }
    }
}

/// A wavelength [m] of the spectrum under its name in a scene.
struct CutOff {
    name: &'static str,
    length: f64,
}

fn ordered(larger: &CutOff, relation: &'static str, smaller: &CutOff) -> Result<(), RoughError> {
    if larger.length > smaller.length || (relation == "at least" && larger.length >= smaller.length) {
        return Ok(());
    }
    Err(RoughError::CutOffs {
        larger: larger.name,
        larger_value: larger.length,
        relation,
        smaller: smaller.name,
        smaller_value: smaller.length,
    })
}

/// The spectrum with C₀ = 1 and wavevectors of the long cut-off, the roll-off and the short cut-off.
fn unit_plateau(hurst: f64, (longest, roll, shortest): (f64, f64, f64)) -> RoughnessSpectrum {
    let law = PowerLaw { from: roll, to: shortest, density: 1.0, exponent: -2.0 * (1.0 + hurst) };
    let plateau = PowerLaw { from: longest, to: roll, density: 1.0, exponent: 0.0 };
    RoughnessSpectrum::from_pieces(if longest < roll { vec![plateau, law] } else { vec![law] })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn surface(hurst: f64, long: f64, roll_off: f64, short: f64) -> SelfAffine {
        SelfAffine {
            hurst: Hurst::new(hurst).unwrap(),
            rms: Some(Length::new(1e-6).unwrap()),
            amplitude: None,
            long: Length::new(long).unwrap(),
            roll_off: Some(Length::new(roll_off).unwrap()),
            short: Length::new(short).unwrap(),
        }
    }

    #[test]
    fn cut_offs_out_of_order_are_named() {
        let text = |s: SelfAffine| s.spectrum().unwrap_err().to_string();
        assert!(text(surface(0.8, 1e-6, 1e-3, 1e-8)).contains("long = 1e-6 m must be at least roll_off = 0.001 m"));
        assert!(text(surface(0.8, 1e-3, 1e-6, 1e-6)).contains("roll_off = 1e-6 m must be above short = 1e-6 m"));
        let no_roll = SelfAffine { roll_off: None, ..surface(0.8, 1e-6, 1.0, 1e-3) };
        assert!(text(no_roll).contains("long = 1e-6 m must be above short = 0.001 m"));
        assert!(text(SelfAffine { rms: None, ..surface(0.8, 1e-3, 1e-4, 1e-6) }).contains("neither"));
    }

    /// Textbook closed forms away from the singular exponents: with x = q_r/q_L and y = q_s/q_r,
    /// ⟨h²⟩/(2πC₀q_r²) = (1 − x⁻²)/2 + (1 − y^{−2H})/(2H), slope: (1 − x⁻⁴)/4 + (y^{2−2H} − 1)/(2−2H),
    /// curvature: (1 − x⁻⁶)/6 + (y^{4−2H} − 1)/(4−2H); at H = 1 the slope term is ln y.
    #[test]
    fn moments_are_the_closed_forms_also_at_hurst_one_and_one_half() {
        let (x, y) = (8.0, 500.0);
        for hurst in [0.2, 0.5, 0.8, 1.0] {
            let s = SelfAffine {
                rms: None,
                amplitude: Some(Positive::new(3e-24).unwrap()),
                ..surface(hurst, TAU * x, TAU, TAU / y)
            };
            let s = s.spectrum().unwrap();
            let grown = |e: f64| if e == 0.0 { f64::ln(y) } else { (y.powf(e) - 1.0) / e };
            let expected = [
                (1.0 - x.powi(-2)) / 2.0 + grown(-2.0 * hurst),
                (1.0 - x.powi(-4)) / 4.0 + grown(2.0 - 2.0 * hurst),
                (1.0 - x.powi(-6)) / 6.0 + grown(4.0 - 2.0 * hurst),
            ];
            for (n, e) in (0..3).zip(expected) {
                let moment = s.mean_square(n, s.cut_offs()) / (TAU * 3e-24);
                assert!((moment / e - 1.0).abs() < 1e-13, "H = {hurst}, n = {n}: {moment} {e}");
            }
        }
    }

    proptest! {
        /// The rms height asked for is the rms height had, at any scale from 1e-12 m to 1e4 m.
        #[test]
        fn rms_height_is_what_was_asked(h in 1i32..=100, decade in -12i32..4, roll in 0i32..20, range in 1i32..60) {
            let long = 10f64.powi(decade);
            let roll_off = long * 10f64.powf(-0.1 * f64::from(roll));
            let s = surface(0.01 * f64::from(h), long, roll_off, roll_off * 10f64.powf(-0.1 * f64::from(range)));
            let rms = s.spectrum().unwrap().rms_height();
            prop_assert!((rms / 1e-6 - 1.0).abs() < 1e-14);
        }

        /// Moments are continuous in H across 1, where the exponent of the slope integral passes −1.
        #[test]
        fn the_slope_is_smooth_through_hurst_one(k in 1i32..12) {
            let slope = |hurst| surface(hurst, 1e-3, 1e-4, 1e-7).spectrum().unwrap().rms_slope();
            let small = 10f64.powi(-k);
            // d ln(slope)/dH is about ln(q_s/q_r) = 6.9 at most.
            prop_assert!((slope(1.0 - small) / slope(1.0) - 1.0).abs() < (7.0 * small).exp_m1() + 1e-14);
        }
    }
}
