//! Stresses on the axis below a loaded contact; those of any place are told by a [`StressField`].
//!
//! # Examples
//! ```
//! use springbed::contact::loaded::Loaded;
//! use springbed::contact::foundation::Foundation;
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! // Hertz with ν = 0.3: the largest shear stress, 0.310 p₀, lies 0.481 a below the surface (Johnson 1985).
//! let ground = Foundation::new(Arc::new(Paraboloid { radius: Length::new(1.0)? }), 1.0);
//! let loaded = Loaded::elastic(ground, 1.0, 0.0);
//! let hardest = loaded.hardest(0.3).unwrap();
//! assert!((hardest.depth - 0.481).abs() < 1e-3);
//! assert!((hardest.shear.abs() / loaded.pressure(0.0) - 0.310).abs() < 1e-3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::loaded::Loaded;
use super::punch::Stresses;
use super::subsurface::StressField;
use crate::numerics::extremum;

/// Stresses on the axis below the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StressRow {
    /// Depth z below the surface [m].
    pub depth: f64,
    /// Axial stress σ_zz [Pa], tension positive.
    pub axial: f64,
    /// Radial stress σ_xx [Pa], tension positive.
    pub radial: f64,
    /// Largest shear stress |σ_zz − σ_xx|/2 [Pa].
    pub shear: f64,
}

/// Depths at which the hardest place is looked for.
const LOOKS: usize = 96;

impl Loaded {
    /// Stresses on the axis at the depth `z` > 0 [m] in a body of Poisson's ratio `poisson`.
    #[must_use]
    pub fn on_axis(&self, z: f64, poisson: f64) -> StressRow {
        self.field(poisson).on_axis(z)
    }

    /// Stresses at `count` depths down to three contact radii, denser near the surface.
    #[must_use]
    pub fn down_the_axis(&self, count: usize, poisson: f64) -> Vec<StressRow> {
        self.field(poisson).down_the_axis(count)
    }

    /// Where on the axis the stress of von Mises |σ_zz − σ_xx| is largest: there a ball yields first. What lies off the
    /// axis is [`StressField::hardest`].
    ///
    /// Check: Hertz at ν = 0.3 has its largest shear 0.3100205020 p₀ at z = 0.480864 a, so it yields at
    /// p₀ = 1.6127965630 Y.
    #[must_use]
    pub fn hardest(&self, poisson: f64) -> Option<StressRow> {
        let field = self.field(poisson);
        let rows = field.down_the_axis(LOOKS);
        let at = (0..rows.len()).max_by(|&i, &j| rows[i].shear.total_cmp(&rows[j].shear))?;
        let depth = |k: usize| rows.get(k).map_or(rows[at].depth, |row| row.depth);
        let (low, high) = (depth(at.wrapping_sub(1)), depth(at + 1));
        let peak = extremum::greatest(|z| field.on_axis(z).shear, low, high);
        Some(field.on_axis(peak.place)).filter(|row| row.shear >= rows[at].shear).or(Some(rows[at]))
    }
}

impl StressField {
    /// Stresses on the axis at the depth `z` > 0 [m].
    #[must_use]
    pub fn on_axis(&self, z: f64) -> StressRow {
        let Stresses { axial, radial, .. } = self.at(0.0, z);
        StressRow { depth: z, axial, radial, shear: 0.5 * (axial - radial).abs() }
    }

    #[expect(clippy::cast_precision_loss, reason = "a profile has far fewer than 2^53 points")]
    fn down_the_axis(&self, count: usize) -> Vec<StressRow> {
        let depth = |k: usize| 3.0 * self.scale() * ((k as f64 + 1.0) / count as f64).powi(2);
        (0..count).map(|k| self.on_axis(depth(k))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::foundation::Foundation;
    use crate::input::quantity::Length;
    use crate::numerics::panelled::PanelledCurve;
    use crate::shape::{Paraboloid, Profile};
    use std::f64::consts::FRAC_1_PI;
    use std::sync::Arc;

    fn ball() -> Arc<dyn Profile> {
        Arc::new(Paraboloid { radius: Length::new(1.0).unwrap() })
    }

    /// A ball of R = 1 with E* = 1: p₀ = 2a/π.
    fn hertz(a: f64) -> Loaded {
        Loaded::elastic(Foundation::new(ball(), 1.0), a, 0.0)
    }

    /// The same contact, of which the loads alone are known.
    fn remembered(a: f64) -> Loaded {
        let load = PanelledCurve::new(move |x| (a - x) * (a + x), vec![a]);
        Loaded::remembered(ball(), a * a, load.clone(), load)
    }

    #[test]
    fn hertz_on_the_axis() {
        let a = 0.1;
        let peak = 2.0 * a * FRAC_1_PI;
        for part in [0.01, 0.1, 0.49, 1.0, 3.0, 30.0] {
            let axial = -peak / (1.0 + part * part);
            let radial = -peak * (1.33 * (1.0 - part * (1.0f64 / part).atan()) - 0.5 / (1.0 + part * part));
            for load in [hertz(a), remembered(a)] {
                let row = load.on_axis(part * a, 0.33);
                assert!((row.axial / axial - 1.0).abs() < 1e-13, "{part}: {}", row.axial / axial - 1.0);
                assert!((row.radial - radial).abs() < 1e-13 * peak, "{part}");
            }
        }
    }

    /// Hertz at ν = 0.3 in p₀ and a, by Boussinesq's point loads and quadrature.
    #[test]
    fn hertz_off_the_axis() {
        let a = 0.7;
        let peak = 2.0 * a * FRAC_1_PI;
        for (r, z, exact) in [
            (0.5, 0.5, [-0.162_947_161_611, -0.142_309_653_636, -0.650_850_826_035, -0.153_645_038_156]),
            (1.0, 0.2, [-0.188_203_749_364, -0.138_080_182_064, -0.191_552_679_283, -0.173_352_792_240]),
            (2.0, 1.0, [-0.053_464_272_216, -0.008_222_032_631, -0.025_647_239_127, -0.041_498_104_625]),
        ] {
            for load in [hertz(a), remembered(a)] {
                let found = load.field(0.3).at(r * a, z * a);
                for (found, exact) in [found.radial, found.hoop, found.axial, found.shear].into_iter().zip(exact) {
                    assert!((found / peak - exact).abs() < 2e-12, "{r} {z}: {} {exact}", found / peak);
                }
            }
        }
    }

    /// Near the surface σ_zz is the pressure.
    #[test]
    fn the_surface_carries_the_pressure() {
        for load in [hertz(0.7), remembered(0.7), Loaded::elastic(Foundation::new(ball(), 1.0), 0.7, -0.1)] {
            for r in [0.0, 0.2, 0.5, 0.9] {
                let axial = load.field(0.3).at(r, 1e-7).axial;
                let pressure = load.pressure(r);
                // σ_zz leaves the pressure with z² (with z outside of an edge).
                assert!((axial + pressure).abs() < 1e-6, "{r}: {axial} {pressure}");
            }
        }
    }

    #[test]
    fn hertz_yields_first_below_the_surface() {
        for (poisson, ratio) in [(0.3, 1.612_796_563_0), (0.5, 1.877_239_337_1), (0.25, 1.554_347_432_4)] {
            for load in [hertz(0.1), remembered(0.1)] {
                let row = load.hardest(poisson).unwrap();
                assert!((load.pressure(0.0) / (2.0 * row.shear) - ratio).abs() < 2e-10, "{poisson}");
            }
        }
        let row = hertz(0.1).hardest(0.3).unwrap();
        // The place of a maximum is known to the root of its rounding.
        assert!((row.depth / 0.1 - 0.480_864).abs() < 1e-6, "{}", row.depth);
    }
}
