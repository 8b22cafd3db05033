//! What lies under the contact: layers, a thin sheet of springs, a body whose stiffness grows with the depth.
//!
//! Frictionless normal contact on a half-space whose stiffness depends on the depth below its surface alone is a bed
//! of independent springs of the stiffness k′(x)dx under the profile
//! d_e(x). k(a) is the stiffness of a flat punch of the radius a, and k′ = 2E*q₁(a)², q₁(x) being E* times less than
//! the line load under a punch that sinks by one. At the places s = k/2E* it is the bed of the homogeneous half-space
//! under the profile d_e(a(s)), a [`Grounded`] one: whatever a bed does in time, under adhesion, in an impact, it does
//! over layers.
//!
//! # Examples
//! ```
//! use springbed::ground::{Ground, Grounded, Layers};
//! use springbed::input::quantity::Length;
//! use springbed::material::{Joint, Sheet, Stack};
//! use springbed::shape::{Paraboloid, Profile};
//! use std::sync::Arc;
//!
//! // An incompressible layer of the thickness 1 bonded to a rigid base, E* = 1: a punch as wide as the layer is thick is
//! // 3.6 times as stiff as on a half-space, and a ball of R = 10 in a contact of that radius carries 0.188.
//! let sheet = Sheet { shear: 1.0, poisson: 0.5, thickness: 1.0, joint: Joint::Bonded };
//! let layer = Arc::new(Layers::new(vec![(1.0, Stack { sheets: vec![sheet], base: None })]));
//! assert!((2.0 * layer.measure(1.0) / 7.2374716979 - 1.0).abs() < 1e-10);
//! let bed = Grounded::new(Arc::new(Paraboloid { radius: Length::new(10.0)? }), layer);
//! let place = bed.place(1.0);
//! assert!((bed.reduced(place) / 0.055941548556 - 1.0).abs() < 1e-10);
//! assert!((2.0 * bed.load_integral(place) / 0.18806668992 - 1.0).abs() < 1e-10);
//! # Ok::<(), springbed::input::quantity::QuantityError>(())
//! ```

mod grounded;
mod kernel;
mod layers;
mod line_load;
mod octave;
mod power;
mod punch;
mod punches;
mod sheet;
mod transfer;
mod wide;
#[cfg(test)]
mod tests;

pub use grounded::Grounded;
pub use layers::Layers;
pub use power::PowerLaw;
pub use sheet::Springs;

use crate::material::Under;
use crate::shape::Profile;
use std::fmt::Debug;
use std::sync::Arc;

/// A half-space in which the stiffness depends on the depth, as springs. Radii and places in metres.
///
/// Displacements of springs, `springs`, are over the radius; `ends` are borders of panels on which they are smooth,
/// ascending, and beyond the last one they are zero.
pub trait Ground: Debug + Send + Sync {
    /// The length [m] over which it changes, if it has one.
    fn scale(&self) -> Option<f64>;

    /// Radius [m] of the widest contact that is known under `profile`, looked for no further than `asked` [m].
    fn end(&self, profile: &dyn Profile, asked: f64) -> f64;

    /// Radius [m] of the widest contact whose pressure and surface are known.
    fn fields_end(&self) -> f64 {
        f64::INFINITY
    }

    /// Relative error of depth and stiffness that come of tables; zero of closed forms.
    fn table_error(&self) -> f64 {
        0.0
    }

    /// s(a) = k(a)/2E* [m]; grows with a from 0.
    fn measure(&self, a: f64) -> f64;

    /// The radius a [m] at which s(a) = `s` [m].
    fn radius(&self, s: f64) -> f64;

    /// s′(a) [1].
    fn density(&self, a: f64) -> f64;

    /// a/s′(a) [m], which has a limit at the axis.
    fn per_density(&self, a: f64) -> f64 {
        a / self.density(a)
    }

    /// d ln s/d ln a [1].
    fn growth(&self, a: f64) -> f64;

    /// d ln s′/d ln a [1].
    fn density_growth(&self, a: f64) -> f64;

    /// d_e(a)/g(a) [1] under a profile whose g(a) is above zero.
    fn depth_share(&self, profile: &dyn Profile, a: f64) -> f64;

    /// Pressure per E* [1/m] at the radius r < `a` under a flat punch of the radius `a` that sinks by one; `root` is
    /// √(a²−r²) [m].
    fn edge_pressure(&self, root: f64, a: f64) -> f64;

    /// Pressure per E* [1] at the radius `r` over springs displaced by `springs` [m].
    fn pressure(&self, springs: &dyn Fn(f64) -> f64, ends: &[f64], r: f64) -> f64;

    /// Displacement [m] of the surface at the radius `r` over springs displaced by `springs` [m].
    fn surface(&self, springs: &dyn Fn(f64) -> f64, ends: &[f64], r: f64) -> f64;

    /// E* times what the surface gives per pressure cos kx [m], 2/k on a homogeneous half-space; `k` [1/m] from 0 on, a
    /// uniform pressure, under which it may be infinite.
    fn wave(&self, k: f64) -> f64;

    /// E* times what a place gives per pressure on it [m], where its neighbours do nothing to it.
    fn alone(&self) -> Option<f64> {
        None
    }

    /// E* times what the surface gives per pressure [m] at `away` [m] along x and y from the middle of a loaded rectangle
    /// of the `sides` [m], on which a homogeneous half-space would give `endless` [m].
    fn under_rectangle(&self, away: [f64; 2], sides: [f64; 2], endless: f64) -> f64;
}

/// The ground that lies under two bodies; `None` for two half-spaces, which need none.
#[must_use]
pub fn of(under: &Under) -> Option<Arc<dyn Ground>> {
    match under {
        Under::HalfSpaces => None,
        Under::Layers(parts) => Some(Arc::new(Layers::new(parts.clone()))),
        Under::Springs(thickness) => Some(Arc::new(Springs { thickness: *thickness })),
        Under::Graded(graded) => Some(Arc::new(PowerLaw::from(graded))),
    }
}
