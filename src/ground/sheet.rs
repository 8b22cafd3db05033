//! A thin sheet of springs on a rigid base.

use super::Ground;
use crate::shape::Profile;
use std::f64::consts::{FRAC_1_PI, FRAC_PI_2, PI};

/// Winkler's foundation: p = Mu/h. k = πa²M/h, d_e = f(a): with M for E* the places are s = πa²/2h.
///
/// It is the limit of a compressible layer bonded to a rigid base under a contact much wider than its thickness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Springs {
    /// Thickness h [m].
    pub thickness: f64,
}

impl Ground for Springs {
    fn scale(&self) -> Option<f64> {
        None
    }

    fn end(&self, _profile: &dyn Profile, _asked: f64) -> f64 {
        f64::INFINITY
    }

    fn measure(&self, a: f64) -> f64 {
        FRAC_PI_2 * a * (a / self.thickness)
    }

    fn radius(&self, s: f64) -> f64 {
        (s / FRAC_PI_2).sqrt() * self.thickness.sqrt()
    }

    fn density(&self, a: f64) -> f64 {
        PI * a / self.thickness
    }

    fn per_density(&self, _a: f64) -> f64 {
        self.thickness * FRAC_1_PI
    }

    fn growth(&self, _a: f64) -> f64 {
        2.0
    }

    fn density_growth(&self, _a: f64) -> f64 {
        1.0
    }

    fn depth_share(&self, profile: &dyn Profile, a: f64) -> f64 {
        profile.height(a) / profile.reduced(a)
    }

    fn edge_pressure(&self, _root: f64, _a: f64) -> f64 {
        self.thickness.recip()
    }

    fn pressure(&self, springs: &dyn Fn(f64) -> f64, _ends: &[f64], r: f64) -> f64 {
        springs(r) / self.thickness
    }

    /// A spring that is let go rests where it has got to.
    fn surface(&self, springs: &dyn Fn(f64) -> f64, ends: &[f64], r: f64) -> f64 {
        if ends.last().is_some_and(|&last| r <= last) { springs(r) } else { 0.0 }
    }

    fn wave(&self, _k: f64) -> f64 {
        self.thickness
    }

    fn alone(&self) -> Option<f64> {
        Some(self.thickness)
    }

    /// Springs that are not loaded stay.
    fn under_rectangle(&self, away: [f64; 2], sides: [f64; 2], _endless: f64) -> f64 {
        let loaded = away.iter().zip(sides).all(|(away, side)| 2.0 * away.abs() <= side);
        if loaded { self.thickness } else { 0.0 }
    }
}
