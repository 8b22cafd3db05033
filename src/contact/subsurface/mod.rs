//! The stresses below a loaded contact, made ready for many points.
//!
//! A contact is a sum of flat punches of radius x, each with the load 2x(−q′) dx, and one of radius a with the load
//! 2aq(a) for a singular edge (Popov & Heß 2015, ch. 3). −q′ is brought into polynomials once; at a point the pieces
//! far from it are sums over few nodes, those near it are integrated in t, x = r + z sinh t, in which the poles of a
//! punch at x = ±r ± iz stand a distance π/2 away at any depth.
//!
//! # Examples
//! ```
//! use springbed::contact::foundation::Foundation;
//! use springbed::contact::loaded::Loaded;
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! // Hertz, R = E* = a = 1, ν = 0.3: σ_zz = −p₀/(1+z²/a²) on the axis.
//! let ground = Foundation::new(Arc::new(Paraboloid { radius: Length::new(1.0)? }), 1.0);
//! let loaded = Loaded::elastic(ground, 1.0, 0.0);
//! let field = loaded.field(0.3);
//! assert!((field.at(0.0, 1.0).axial / (-0.5 * loaded.pressure(0.0)) - 1.0).abs() < 1e-13);
//! // It yields first on the axis, at 0.48 a, where the stress of von Mises is 0.62 p₀.
//! let hardest = field.hardest().unwrap();
//! assert!(hardest.radius < 1e-6 && (hardest.depth - 0.480864).abs() < 1e-5);
//! assert!((hardest.von_mises / loaded.pressure(0.0) - 0.620041004).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod hardest;
mod piece;
mod yielding;
#[cfg(test)]
mod tests;

pub use hardest::Place;
pub use yielding::FirstYield;

use super::adhesion::equilibrium::Balance;
use super::adhesion::range::RangeDisc;
use super::foundation::Foundation;
use super::loaded::{Bed, Loaded};
use super::punch::{Point, Stresses};
use crate::numerics::chebyshev::{self, Chebyshev};
use crate::numerics::quadrature;
use piece::Piece;

/// Error of the loads of the pieces, as a part of the largest load.
const FINE: f64 = 1e-14;
/// More pieces than a smooth bed asks for: one of many kinks is followed no finer.
const MOST_PIECES: usize = 384;
/// Depth, in radii of the contact, that stands for the surface itself: the stresses there differ by this part.
const SURFACE: f64 = 1e-9;

/// The stresses below a contact at one instant.
#[derive(Debug, Clone)]
pub struct StressField {
    /// Length [m] in which the field is kept: how far the bodies act on each other.
    scale: f64,
    poisson: f64,
    /// Shear traction over pressure, where the contact slides as a whole.
    drag: f64,
    pieces: Vec<Piece>,
    /// Radius of the contact in the scale, and the load q(a) of its edge over the scale [Pa].
    edge: (f64, f64),
    ring: Option<(RangeDisc, Balance)>,
    bounded: bool,
}

impl Loaded {
    /// The stresses below the surface of a body of Poisson's ratio `poisson`.
    #[must_use]
    pub fn field(&self, poisson: f64) -> StressField {
        let scale = self.reach();
        let a = self.contact_radius / scale;
        let (pieces, ring) = match &self.bed {
            Bed::Elastic(ground, ring) => (self.elastic_pieces(ground), ring.clone()),
            Bed::Remembered(load, _) => {
                let ends = self.ends(load.ends().to_vec());
                let line = |x: f64| load.at(scale * x) / scale;
                let loads = chebyshev::pieces(line, &ends, FINE * line(0.0).abs(), MOST_PIECES);
                let weight = |load: &Chebyshev| Piece::new(load.slope().scaled(-1.0), 0.0);
                (loads.iter().map(weight).collect(), None)
            }
        };
        StressField {
            scale,
            poisson,
            drag: 0.0,
            pieces,
            edge: (a, self.edge_load / scale),
            ring,
            bounded: self.is_bounded(),
        }
    }

    /// The pieces of E*g′: over x up to a kink of the profile at b, beyond it, where g goes with the root of x − b, over
    /// s = √(x² − b²), in which it is smooth.
    fn elastic_pieces(&self, ground: &Foundation) -> Vec<Piece> {
        let (a, scale, modulus) = (self.contact_radius, self.reach(), ground.modulus());
        let fine = FINE * modulus * self.profile.reduced(a).abs() / scale;
        let weight = |x: f64| modulus * self.profile.reduced_slope(scale * x);
        let along = |ends: &[f64]| chebyshev::pieces(weight, ends, fine, MOST_PIECES);
        let Some(kink) = self.profile.kink().filter(|&kink| kink > 0.0 && kink < a) else {
            let pieces = along(&self.ends(self.profile.breaks(a)));
            return pieces.into_iter().map(|weight| Piece::new(weight, 0.0)).collect();
        };
        let inner = if self.profile.flat_radius() < kink { along(&[0.0, kink / scale]) } else { Vec::new() };
        let load = |s: f64| modulus * self.profile.reduced(kink.hypot(scale * s)) / scale;
        let last = ((a - kink) * (a + kink)).sqrt() / scale;
        let outer = chebyshev::pieces(load, &[0.0, last], fine, MOST_PIECES);
        let inner = inner.into_iter().map(|weight| Piece::new(weight, 0.0));
        inner.chain(outer.iter().map(|load| Piece::new(load.slope(), kink / scale))).collect()
    }

    /// 0, the places `breaks` [m] inside the contact and its radius, in the scale of the field; few enough to be pieces.
    fn ends(&self, breaks: Vec<f64>) -> Vec<f64> {
        let (a, scale) = (self.contact_radius, self.reach());
        let inside: Vec<f64> = breaks.into_iter().filter(|&x| x > 0.0 && x < a).collect();
        let step = inside.len().div_ceil(MOST_PIECES / 2).max(1);
        let inside = inside.into_iter().step_by(step).map(|x| x / scale);
        std::iter::once(0.0).chain(inside).chain([a / scale]).collect()
    }

    /// Whether the elastic stress is finite everywhere: neither the edge nor an apex or kink of the profile is sharp.
    #[must_use]
    pub fn is_bounded(&self) -> bool {
        let kink = self.profile.kink().filter(|&kink| kink > 0.0 && kink < self.contact_radius);
        let finite = |r: f64| self.pressure(r).is_finite();
        self.edge_load.abs() <= 0.0 && finite(0.0) && kink.is_none_or(finite)
    }
}

impl StressField {
    /// The same contact sliding as a whole along x, with a shear traction `drag` times the pressure dragged along with the
    /// indenter: positive while that moves towards +x.
    #[must_use]
    pub fn dragged(self, drag: f64) -> Self {
        Self { drag, ..self }
    }

    /// Whether the contact slides, so that the field is told over the place x in the plane y = 0.
    #[must_use]
    pub fn slides(&self) -> bool {
        self.drag.abs() > 0.0
    }

    /// How far the bodies act on each other [m].
    #[must_use]
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// Stresses [Pa] at the distance `r` from the axis and the depth `z` [m], tension positive.
    ///
    /// Of a contact that slides they are σ_xx, σ_yy, σ_zz and τ_xz at the place x = `r` of either sign in the plane
    /// y = 0 through the axis along the sliding. z = 0 is the limit from below; NaN where it is singular.
    ///
    /// Check: Hertz gives σ_zz = −p₀/(1+z²/a²) on the axis (Popov, Contact Mechanics and Friction, eq. 5.47).
    #[must_use]
    pub fn at(&self, r: f64, z: f64) -> Stresses {
        let depth = (z / self.scale).max(SURFACE);
        let point = Point { radius: r.abs() / self.scale, depth, poisson: self.poisson };
        let pressed = self.sum(&point, &|b| point.under_punch(b));
        if !self.slides() {
            return pressed;
        }
        let dragged = self.drag * self.sum(&point, &|b| point.under_dragged_punch(b));
        let side = if r < 0.0 { -1.0 } else { 1.0 };
        Stresses {
            radial: pressed.radial + side * dragged.radial,
            hoop: pressed.hoop + side * dragged.hoop,
            axial: pressed.axial + side * dragged.axial,
            shear: side * pressed.shear + dragged.shear,
        }
    }

    /// All punches of the contact at a point.
    fn sum(&self, point: &Point, punch: &impl Fn(f64) -> Stresses) -> Stresses {
        let pieces = self.pieces.iter().map(|piece| piece.stresses(point, punch));
        let regular = pieces.fold(Stresses::default(), |sum, piece| sum + piece);
        let (a, load) = self.edge;
        let edge = if a > 0.0 && load.abs() > 0.0 { load * punch(a) } else { Stresses::default() };
        regular + edge + self.drawn(point, punch)
    }

    /// The punches of an attraction of finite range: −q′ = −2σ₀x/√(c²−x²) on a < x < c; t = √(c²−x²).
    fn drawn(&self, point: &Point, punch: &impl Fn(f64) -> Stresses) -> Stresses {
        let Some((disc, balance)) = &self.ring else { return Stresses::default() };
        let c = balance.reach / self.scale;
        let inner = |x: f64| ((c - x) * (c + x)).sqrt();
        let mut breaks: Vec<f64> = about(point).into_iter().filter(|&x| x > self.edge.0 && x < c).map(inner).collect();
        breaks.reverse();
        let ends = std::iter::once(0.0).chain(breaks).chain([inner(self.edge.0)]);
        let ends: Vec<f64> = ends.collect();
        let mut sum = Stresses::default();
        for pair in ends.windows(2) {
            let (middle, half) = (0.5 * (pair[0] + pair[1]), 0.5 * (pair[1] - pair[0]));
            for &(node, weight) in quadrature::nodes() {
                sum = sum + (half * weight) * punch(inner(middle + half * node));
            }
        }
        (-2.0 * disc.stress()) * sum
    }
}

/// Borders of panels that grow with the distance from the poles at x = ±r ± iz, ascending.
fn about(point: &Point) -> Vec<f64> {
    let steps = (-2..24).map(|k| 4f64.powi(k) * point.depth).filter(|&step| step < 2.0);
    let mut places: Vec<f64> = steps.flat_map(|step| [point.radius - step, point.radius + step]).collect();
    places.push(point.radius);
    places.sort_by(f64::total_cmp);
    places
}
