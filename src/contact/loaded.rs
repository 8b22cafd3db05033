//! A loaded contact as a value: pressure, surface and stresses from the present line load q(x).
//!
//! # Examples
//! ```
//! use springbed::contact::loaded::Loaded;
//! use springbed::contact::foundation::Foundation;
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! // Hertz, R = E* = a = 1: p₀ = 2E*a/πR, F = 4E*a³/3R, and the surface at the edge has sunk by half of d.
//! let ground = Foundation::new(Arc::new(Paraboloid { radius: Length::new(1.0)? }), 1.0);
//! let loaded = Loaded::elastic(ground, 1.0, 0.0);
//! assert!((loaded.pressure(0.0) - std::f64::consts::FRAC_2_PI).abs() < 1e-15);
//! assert!((loaded.force() - 4.0 / 3.0).abs() < 1e-14 && (loaded.surface(1.0) - 0.5).abs() < 1e-14);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::adhesion::equilibrium::Balance;
use super::adhesion::range::{RangeDisc, attraction};
use super::foundation::Foundation;
use crate::numerics::panelled::PanelledCurve;
use crate::shape::Profile;
use std::sync::Arc;

/// Where the line load comes from.
#[derive(Debug, Clone)]
pub(super) enum Bed {
    /// Elastic springs: q = E*(g(a) − g(x)) + q(a), and the attraction of finite range, if there is one.
    Elastic(Foundation, Option<(RangeDisc, Balance)>),
    /// Springs that remember: their loads q [N/m] and displacements [m].
    Remembered(PanelledCurve<'static>, PanelledCurve<'static>),
}

/// A contact under the line load q(x) [N/m] of its springs, as it is at one instant.
///
/// Owned, and independent of how the load came about: pressure, stress intensity and the stresses below
/// the surface are those of q alone (Popov & Heß 2015, eqs. 3.37 and 3.40).
#[derive(Debug, Clone)]
pub struct Loaded {
    pub(super) bed: Bed,
    pub(super) profile: Arc<dyn Profile>,
    pub(super) contact_radius: f64,
    pub(super) edge_load: f64,
    indentation: f64,
}

impl Loaded {
    /// An elastic contact of the radius `contact_radius` a [m] whose edge carries `edge_load` q(a) [N/m]: positive
    /// at a wall, negative with adhesion.
    #[must_use]
    pub fn elastic(ground: Foundation, contact_radius: f64, edge_load: f64) -> Self {
        let indentation = ground.profile().reduced(contact_radius) + edge_load / ground.modulus();
        let profile = ground.shared_profile();
        Self { bed: Bed::Elastic(ground, None), profile, contact_radius, edge_load, indentation }
    }

    /// The same at the indentation `indentation` [m], where that is known to more digits.
    #[must_use]
    pub fn at_depth(self, indentation: f64) -> Self {
        Self { indentation, ..self }
    }

    /// A contact held by an attraction of finite range in the state `balance`.
    #[must_use]
    pub fn attracted(disc: RangeDisc, balance: Balance) -> Self {
        let ground = disc.ground().clone();
        let profile = ground.shared_profile();
        let (contact_radius, indentation) = (balance.contact_radius, balance.indentation);
        Self { bed: Bed::Elastic(ground, Some((disc, balance))), profile, contact_radius, edge_load: 0.0, indentation }
    }

    /// A contact at the indentation `indentation` [m] whose springs carry `load` q(x) [N/m], the last end of its
    /// panels being the contact radius, and are displaced by `displacement` [m], those let go included.
    #[must_use]
    pub fn remembered(
        profile: Arc<dyn Profile>,
        indentation: f64,
        load: PanelledCurve<'static>,
        displacement: PanelledCurve<'static>,
    ) -> Self {
        let contact_radius = load.ends().last().copied().unwrap_or(0.0);
        let edge_load = load.at(contact_radius);
        // Without adhesion the last spring ends unloaded, to the rounding of the others.
        let rounding = 1e-12 * load.at(0.0).abs();
        let edge_load = if edge_load.abs() <= rounding { 0.0 } else { edge_load };
        Self { bed: Bed::Remembered(load, displacement), profile, contact_radius, edge_load, indentation }
    }

    /// Contact radius a [m].
    #[must_use]
    pub fn contact_radius(&self) -> f64 {
        self.contact_radius
    }

    /// Radius [m] up to which the bodies act on each other.
    #[must_use]
    pub fn reach(&self) -> f64 {
        match &self.bed {
            Bed::Elastic(_, Some((_, balance))) => balance.reach,
            Bed::Elastic(_, None) | Bed::Remembered(..) => self.contact_radius,
        }
    }

    /// Load q(a) of the edge [N/m]; zero where the edge is not singular.
    #[must_use]
    pub fn edge_load(&self) -> f64 {
        self.edge_load
    }

    /// Indentation d [m].
    #[must_use]
    pub fn indentation(&self) -> f64 {
        self.indentation
    }

    /// Place [m] in the bed beyond which no spring is displaced: the edge, or where springs let go still recover.
    #[must_use]
    pub fn displaced_to(&self) -> f64 {
        match &self.bed {
            Bed::Elastic(..) => self.contact_radius,
            Bed::Remembered(_, displacement) => {
                displacement.ends().last().copied().unwrap_or(0.0).max(self.contact_radius)
            }
        }
    }

    /// Line load q(x) [N/m] of the springs at the place `x` [m], compression positive; at the edge that of the last spring
    /// that is held, and zero beyond.
    ///
    /// An attraction of finite range, which acts beyond the edge, is not told.
    #[must_use]
    pub fn line_load(&self, x: f64) -> f64 {
        match &self.bed {
            _ if x > self.contact_radius || self.contact_radius <= 0.0 => 0.0,
            Bed::Elastic(ground, _) => {
                ground.modulus() * (self.profile.reduced(self.contact_radius) - self.profile.reduced(x))
                    + self.edge_load
            }
            Bed::Remembered(..) if x >= self.contact_radius => self.edge_load,
            Bed::Remembered(load, _) => load.at(x),
        }
    }

    /// Displacement [m] of the springs at the place `x` [m] into the body: d − g(x) in the contact, and beyond it what those
    /// let go have not yet recovered.
    #[must_use]
    pub fn displacement(&self, x: f64) -> f64 {
        match &self.bed {
            _ if x <= self.contact_radius && self.contact_radius > 0.0 => self.indentation - self.profile.reduced(x),
            Bed::Elastic(..) => 0.0,
            Bed::Remembered(_, displacement) if x <= self.displaced_to() => displacement.at(x),
            Bed::Remembered(..) => 0.0,
        }
    }

    /// Profile of the indenter.
    #[must_use]
    pub fn profile(&self) -> &dyn Profile {
        self.profile.as_ref()
    }

    /// Normal force F = 2∫₀^a q dx over the contact [N].
    #[must_use]
    pub fn force(&self) -> f64 {
        let a = self.contact_radius;
        match &self.bed {
            Bed::Elastic(ground, None) => 2.0 * (ground.modulus() * self.profile.load_integral(a) + a * self.edge_load),
            Bed::Elastic(_, Some((_, balance))) => balance.force,
            Bed::Remembered(load, _) => 2.0 * load.integral(),
        }
    }

    /// Mean pressure F/A [Pa], A = πa².
    #[must_use]
    pub fn mean_pressure(&self) -> f64 {
        self.force() / self.profile.contact_area(self.contact_radius)
    }

    /// Stress intensity K_I = −q(a)√(2/A′) = −q(a)/√(πa) [Pa √m] of the edge; zero without adhesion and for attraction of
    /// finite range, negative under the sharp edge of a punch.
    #[must_use]
    pub fn stress_intensity(&self) -> f64 {
        let a = self.contact_radius;
        if a <= 0.0 || self.edge_load.abs() <= 0.0 {
            0.0
        } else {
            -self.edge_load * (2.0 / self.profile.contact_area_slope(a)).sqrt()
        }
    }

    /// Pressure p(r) [Pa] at the radius `r` [m], compression positive, zero beyond the reach of the bodies.
    ///
    /// p(r) = (1/π)∫_r^a (−q′) dx/√(x²−r²) + q(a)/(π√(a²−r²)) (Popov & Heß 2015, eq. 3.37);
    /// infinite at r = a if the edge carries a load, and at the apex of a cone.
    #[must_use]
    pub fn pressure(&self, r: f64) -> f64 {
        let a = self.contact_radius;
        if r > a || a <= 0.0 {
            return self.drawn(r);
        }
        if let Bed::Remembered(load, _) = &self.bed {
            if r >= a && self.edge_load.abs() > 0.0 {
                return self.edge_load * f64::INFINITY;
            }
            return self.profile.pressure_of(load, r);
        }
        let edge = self.edge_load;
        let singular = if edge.abs() > 0.0 { edge * self.profile.edge_pressure(r, a) } else { 0.0 };
        self.regular_pressure(r) + singular + self.drawn(r)
    }

    /// The same without what the load of the edge and an attraction of finite range add.
    #[must_use]
    pub fn regular_pressure(&self, r: f64) -> f64 {
        match &self.bed {
            Bed::Elastic(ground, _) => ground.modulus() * self.profile.pressure_integral(r, self.contact_radius),
            Bed::Remembered(load, _) => self.profile.pressure_of(&load.less(self.edge_load), r),
        }
    }

    /// Pressure of the attraction of finite range.
    fn drawn(&self, r: f64) -> f64 {
        match &self.bed {
            Bed::Elastic(_, Some((disc, balance))) => attraction(disc.stress(), balance, r),
            Bed::Elastic(_, None) | Bed::Remembered(..) => 0.0,
        }
    }

    /// Displacement u_z(r) [m] of the surface into the body, relative to the undeformed plane: d − f(r) in the
    /// contact and (2/π)∫₀^r u dx/√(r²−x²) outside, u the displacement of the springs.
    #[must_use]
    pub fn surface(&self, r: f64) -> f64 {
        let a = self.contact_radius;
        if r <= a && a > 0.0 {
            return self.indentation - self.profile.height(r);
        }
        let (ground, ring) = match &self.bed {
            Bed::Elastic(ground, ring) => (ground, ring),
            Bed::Remembered(_, displacement) => {
                return self.profile.surface_of(displacement, r);
            }
        };
        let drawn = ring.as_ref().map_or(0.0, |(disc, balance)| disc.pulled_up(balance, r));
        let edge = match ring {
            None => self.edge_load / ground.modulus(),
            Some(_) => self.indentation - self.profile.reduced(a),
        };
        let edge = edge * self.profile.edge_surface(r, a);
        if a > 0.0 { self.profile.displacement_integral(r, a) + edge + drawn } else { drawn }
    }
}
