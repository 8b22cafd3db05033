//! Stresses on the axis below the surface.
//!
//! A profile is a superposition of flat punches of radius x, each with the load 2x(−q′) dx, and one
//! of radius a with the load 2aq(a) for a singular edge.

use crate::contact::foundation::HalfSpace;
use crate::numerics::quadrature;
use std::f64::consts::{FRAC_1_PI, PI};

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

/// Load of a contact: E* [Pa], Poisson's ratio, contact radius a [m] and q(a) at the edge [N/m].
#[derive(Debug, Clone)]
pub struct Loading {
    /// What the indenter is pressed into.
    pub ground: HalfSpace,
    /// Poisson's ratio ν of the body looked into.
    pub poisson: f64,
    /// Contact radius a [m].
    pub contact_radius: f64,
    /// Load q(a) of the edge [N/m].
    pub edge_load: f64,
}

impl Loading {
    /// Stresses on the axis at the depth `z` > 0 [m].
    ///
    /// Of a flat punch of radius x and load P: σ_zz = −(P/2π)(x²+3z²)/(x²+z²)² and
    /// σ_xx = −(1+ν)P/(2π(x²+z²)) − σ_zz/2, from Boussinesq's solution (Johnson 1985, §3.4).
    /// Check: Hertz gives σ_zz = −p₀/(1+z²/a²) (Popov, Contact Mechanics and Friction, eq. 5.47).
    #[must_use]
    pub fn on_axis(&self, z: f64) -> StressRow {
        let a = self.contact_radius;
        let edge = FRAC_1_PI * a * self.edge_load;
        let weight = |x: f64| FRAC_1_PI * self.ground.modulus() * x * self.ground.profile().reduced_slope(x);
        let mut breaks = self.ground.profile().breaks(a);
        // Panels that grow with the distance from the poles at x = ±iz.
        breaks.extend((-2..10).map(|k| 4f64.powi(k) * z));
        breaks.sort_by(f64::total_cmp);
        let axial_kernel = |x: f64| (x * x + 3.0 * z * z) / (x * x + z * z).powi(2);
        let radial_kernel = |x: f64| 1.0 / (x * x + z * z);
        let sum = |kernel: &dyn Fn(f64) -> f64| {
            quadrature::panels(|x| weight(x) * kernel(x), (0.0, a), &breaks) + edge * kernel(a)
        };
        let axial = -sum(&axial_kernel);
        let radial = -(1.0 + self.poisson) * sum(&radial_kernel) - 0.5 * axial;
        StressRow { depth: z, axial, radial, shear: 0.5 * (axial - radial).abs() }
    }

    /// Stresses at `count` depths down to three contact radii, denser near the surface.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "a profile has far fewer than 2^53 points")]
    pub fn profile_down(&self, count: usize) -> Vec<StressRow> {
        let depth = |k: usize| 3.0 * self.contact_radius * ((k as f64 + 1.0) / count as f64).powi(2);
        (0..count).map(|k| self.on_axis(depth(k))).collect()
    }

    /// Mean load over the contact, F/(πa²) [Pa].
    #[must_use]
    pub fn mean_pressure(&self) -> f64 {
        let a = self.contact_radius;
        2.0 * (self.ground.modulus() * self.ground.profile().load_integral(a) + a * self.edge_load) / (PI * a * a)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::quantity::Length;
    use crate::shape::Paraboloid;
    use std::sync::Arc;

    #[test]
    fn hertz_on_the_axis() {
        let ball = Paraboloid { radius: Length::new(1.0).unwrap() };
        let a = 0.1;
        let load =
            Loading { ground: HalfSpace::new(Arc::new(ball), 1.0), poisson: 0.33, contact_radius: a, edge_load: 0.0 };
        let peak = 2.0 * a * FRAC_1_PI;
        for part in [0.01, 0.1, 0.49, 1.0, 3.0, 30.0] {
            let z = part * a;
            let row = load.on_axis(z);
            let axial = -peak / (1.0 + part * part);
            let radial = -peak * (1.33 * (1.0 - part * (1.0 / part).atan()) - 0.5 / (1.0 + part * part));
            assert!((row.axial / axial - 1.0).abs() < 1e-13, "{part}: {}", row.axial / axial - 1.0);
            assert!((row.radial - radial).abs() < 1e-13 * peak, "{part}");
        }
        let shear = |part: f64| load.on_axis(part * a).shear;
        assert!(shear(0.49) > shear(0.46) && shear(0.49) > shear(0.52));
    }
}
