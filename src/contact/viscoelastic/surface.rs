//! Pressure and surface of the beds, from the loads and displacements of their springs.

use super::memory::Memory;
use super::pressure;
use super::spring::Spring;
use super::strip::Strip;
use crate::numerics::quadrature;
use std::f64::consts::{FRAC_2_PI, FRAC_PI_2};

/// u_z(r) = (2/π) ∫₀^r u(x) dx/√(r²−x²) [m] (Popov & Heß 2015, eq. 3.40).
///
/// The transform knows no time: springs let go and still creeping back count with what is left of
/// their displacement. x = r sin θ takes the root away. `ends` are the borders of panels on which u
/// is smooth; beyond the last of them u = 0.
pub fn surface(displacement: &impl Fn(f64) -> f64, ends: &[f64], r: f64) -> f64 {
    let Some(&last) = ends.last() else { return 0.0 };
    let angle = |x: f64| if x < r { (x / r).asin() } else { FRAC_PI_2 };
    let breaks: Vec<f64> = ends.iter().map(|&x| angle(x)).collect();
    FRAC_2_PI * quadrature::panels(|theta| displacement(r * theta.sin()), (0.0, angle(last)), &breaks)
}

/// Panels finer than this part of the contact are put together: a contact of thousands of strips has
/// loads with thousands of kinks too faint to see.
const FINEST: f64 = 1.0 / 512.0;

/// Borders at least [`FINEST`] of the last one apart, the last one always among them.
fn thinned(ends: Vec<f64>) -> Vec<f64> {
    let Some(&last) = ends.last() else { return ends };
    let mut kept: Vec<f64> = Vec::new();
    for x in ends {
        if kept.last().is_none_or(|&before| x - before >= FINEST * last) {
            kept.push(x);
        }
    }
    kept.pop();
    kept.push(last);
    kept
}

impl Memory {
    fn ends(&self, strips: &[Strip]) -> Vec<f64> {
        let ends: Vec<f64> = strips.iter().flat_map(|strip| strip.panel_ends(&self.ground)).collect();
        if strips.len() > 8 { thinned(ends) } else { ends }
    }

    /// Panels of the springs in contact, and of all that have been touched.
    pub(super) fn borders(&self) -> (Vec<f64>, Vec<f64>) {
        (self.ends(&self.strips[..self.pressed]), self.ends(&self.strips))
    }

    /// Pressure p(r) [Pa] at the radius `r` ≥ 0 [m]; zero outside the contact.
    #[must_use]
    pub fn pressure(&self, r: f64) -> f64 {
        pressure::inverse(&|x| self.line_load(x), &self.ends(&self.strips[..self.pressed]), r)
    }

    /// Displacement u_z(r) [m] of the surface into the body: d − f(r) in the contact.
    #[must_use]
    pub fn surface(&self, r: f64) -> f64 {
        let profile = &self.ground.profile;
        if r <= self.radius() {
            return self.indentation() - profile.height(r);
        }
        let displacement = |x: f64| match self.spring(x) {
            Spring::Pressed(_) => self.indentation() - profile.reduced(x),
            Spring::Free(free) => self.ground.spectrum.recovered(&free, 0.0),
        };
        surface(&displacement, &self.ends(&self.strips), r)
    }
}
