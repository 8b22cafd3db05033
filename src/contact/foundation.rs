//! What an indenter is pressed into: a bed of independent springs.
//!
//! Frictionless normal contact on any half-space whose stiffness depends on the depth below its surface
//! alone, homogeneous, layered or graded, is a bed of independent springs: of the stiffness k′(x) dx
//! under the profile d_e(x). k(a) is the stiffness [N/m] of a flat punch of radius a, d_e(a) the
//! indentation [m] at which the contact without adhesion has the radius a, so that
//! F = ∫₀^a k′(x)(d − d_e(x)) dx and U = ½∫₀^a k′(x)(d − d_e(x))² dx. In the measure s(x) = k(x)/2E* [m]
//! it is the bed of the homogeneous half-space under the profile d_e(x(s)).
//!
//! ```
//! # use springbed::contact::foundation::{Foundation, HalfSpace};
//! # use springbed::{input::quantity::Length, shape::Paraboloid};
//! # use std::sync::Arc;
//! // A lens of R = 1 m on a half-space of E* = 3 Pa, pressed to a = 0.1 m: d = a²/R and F = 4E*a³/3R.
//! let lens = Paraboloid { radius: Length::new(1.0)? };
//! let ground = HalfSpace::new(Arc::new(lens), 3.0);
//! assert!((ground.depth(0.1) - 0.01).abs() < 1e-17);
//! assert!((ground.force(0.1, 0.0) - 0.004).abs() < 1e-17);
//! # Ok::<(), springbed::input::quantity::QuantityError>(())
//! ```

use crate::numerics::{quadrature, root};
use crate::shape::Profile;
use std::fmt::Debug;
use std::sync::Arc;

/// A half-space under an indenter, as the springs of its bed. Radii and depths in metres.
pub trait Foundation: Debug + Clone + Send + Sync + 'static {
    /// Profile of the indenter: where it ends, where its law changes, f(r).
    fn profile(&self) -> &dyn Profile;

    /// Effective modulus E* [Pa] that goes with the measure; of layers that of the topmost one.
    fn modulus(&self) -> f64;

    /// s(a) = k(a)/2E* [m]; grows with a from 0.
    fn measure(&self, a: f64) -> f64;

    /// s′(a) [1]. Where it is zero at the apex, [`elongation`](Self::elongation) needs its limit there.
    fn density(&self, a: f64) -> f64;

    /// d ln s′/d ln a [1]; n of a power-law graded body.
    fn density_growth(&self, a: f64) -> f64;

    /// d_e(a) [m].
    fn depth(&self, a: f64) -> f64;

    /// d_e′(a) [1].
    fn depth_slope(&self, a: f64) -> f64;

    /// A length [m] typical of the contact, from which searches start.
    fn scale(&self) -> f64 {
        self.profile().scale()
    }

    /// The shortest length [m] over which d_e′ may rise and fall again, see [`Profile::feature`].
    fn feature(&self) -> Option<f64> {
        self.profile().feature()
    }

    /// A radius [m] about which d_e′ may rise and fall over any scale, see [`Profile::kink`].
    fn kink(&self) -> Option<f64> {
        self.profile().kink()
    }

    /// The radius a [m] at which s(a) = `measure` [m].
    fn radius(&self, measure: f64) -> f64 {
        let residual = |a: f64| self.measure(a) - measure;
        let bracket = root::bracket_upwards(residual, 0.0, self.scale(), f64::MAX);
        bracket.map_or(f64::INFINITY, |(low, high)| root::within(residual, low, high))
    }

    /// N(a) = ∫₀^a (d_e(a) − d_e(x)) ds [m²].
    fn load_integral(&self, a: f64) -> f64 {
        let rise = |x: f64| self.measure(x) * self.depth_slope(x);
        quadrature::panels(rise, (0.0, a), &self.profile().breaks(a))
    }

    /// M(a) = ∫₀^a (d_e(a) − d_e(x))² ds [m³].
    fn energy_integral(&self, a: f64) -> f64 {
        let rise = |x: f64| 2.0 * self.depth_slope(x) * self.load_integral(x);
        quadrature::panels(rise, (0.0, a), &self.profile().breaks(a))
    }

    /// Normal force [N] of a contact of radius `a` whose edge is pressed by `edge` = d − d_e(a):
    /// 2E*(N + s·edge).
    fn force(&self, a: f64, edge: f64) -> f64 {
        2.0 * self.modulus() * (self.load_integral(a) + self.measure(a) * edge)
    }

    /// d − d_e(a) [m] of a contact of radius `a` that carries the normal force `force` [N].
    fn edge_under(&self, a: f64, force: f64) -> f64 {
        (0.5 * force / self.modulus() - self.load_integral(a)) / self.measure(a)
    }

    /// Elastic energy [J] of a contact of radius `a` whose edge is pressed by `edge`:
    /// E*(M + 2 edge N + s edge²).
    fn energy(&self, a: f64, edge: f64) -> f64 {
        let (n, m) = (self.load_integral(a), self.energy_integral(a));
        self.modulus() * (m + 2.0 * edge * n + self.measure(a) * edge * edge)
    }

    /// k(a) = 2E*s(a) [N/m], dF/dd at constant contact radius.
    fn stiffness(&self, a: f64) -> f64 {
        2.0 * self.modulus() * self.measure(a)
    }

    /// Δl(a) = √(2A′w/k′(a)) [m], at which an edge with the work of adhesion `work` w [J/m²] parts: an edge pulled by
    /// Δl releases k′Δl²/2A′ of energy per area, A′ = 2πa under a round contact.
    fn elongation(&self, a: f64, work: f64) -> f64 {
        (self.profile().contact_area_slope(a) * (work / self.modulus()) / self.density(a)).sqrt()
    }

    /// d ln Δl/d ln a [1].
    fn elongation_growth(&self, a: f64) -> f64 {
        0.5 * (self.profile().contact_area_bend(a) - self.density_growth(a))
    }

    /// d ln k/d ln a [1].
    fn stiffness_growth(&self, a: f64) -> f64 {
        a * self.density(a) / self.measure(a)
    }
}

/// A homogeneous elastic half-space: springs of the stiffness 2E* dx under the profile g(x), s(x) = x.
///
/// E* effective modulus [Pa] (Popov & Heß 2015, eq. 3.1).
#[derive(Debug, Clone)]
pub struct HalfSpace {
    profile: Arc<dyn Profile>,
    modulus: f64,
}

impl HalfSpace {
    /// A half-space of the effective modulus `modulus` E* [Pa] under `profile`.
    #[must_use]
    pub fn new(profile: Arc<dyn Profile>, modulus: f64) -> Self {
        Self { profile, modulus }
    }

    /// Profile of the indenter.
    #[must_use]
    pub fn profile(&self) -> &dyn Profile {
        self.profile.as_ref()
    }

    /// The profile, to be held on its own.
    #[must_use]
    pub fn shared_profile(&self) -> Arc<dyn Profile> {
        self.profile.clone()
    }

    /// Effective modulus E* [Pa].
    #[must_use]
    pub fn modulus(&self) -> f64 {
        self.modulus
    }
}

impl Foundation for HalfSpace {
    fn profile(&self) -> &dyn Profile {
        self.profile.as_ref()
    }

    fn modulus(&self) -> f64 {
        self.modulus
    }

    fn measure(&self, a: f64) -> f64 {
        a
    }

    fn density(&self, _a: f64) -> f64 {
        1.0
    }

    fn density_growth(&self, _a: f64) -> f64 {
        0.0
    }

    fn depth(&self, a: f64) -> f64 {
        self.profile.reduced(a)
    }

    fn depth_slope(&self, a: f64) -> f64 {
        self.profile.reduced_slope(a)
    }

    fn radius(&self, measure: f64) -> f64 {
        measure
    }

    fn load_integral(&self, a: f64) -> f64 {
        self.profile.load_integral(a)
    }

    fn energy_integral(&self, a: f64) -> f64 {
        self.profile.energy_integral(a)
    }

    fn stiffness_growth(&self, _a: f64) -> f64 {
        1.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::adhesion::equilibrium::{Control, Equilibrium};
    use crate::contact::adhesion::line::EdgeLine;
    use crate::contact::direct::QuasiStatic;
    use crate::contact::springs::SpringBed;
    use crate::input::quantity::Length;
    use crate::shape::Paraboloid;
    use std::f64::consts::PI;

    /// E ∝ zⁿ under a paraboloid of R = 1: s′ = xⁿ and d_e = x²/(1+n) (Heß 2016), the rest from the defaults.
    #[derive(Debug, Clone)]
    struct Graded {
        profile: Arc<dyn Profile>,
        exponent: f64,
    }

    impl Foundation for Graded {
        fn profile(&self) -> &dyn Profile {
            self.profile.as_ref()
        }
        fn modulus(&self) -> f64 {
            1.0
        }
        fn measure(&self, a: f64) -> f64 {
            a.powf(1.0 + self.exponent) / (1.0 + self.exponent)
        }
        fn density(&self, a: f64) -> f64 {
            a.powf(self.exponent)
        }
        fn density_growth(&self, _a: f64) -> f64 {
            self.exponent
        }
        fn elongation(&self, a: f64, work: f64) -> f64 {
            (2.0 * PI * work * a.powf(1.0 - self.exponent)).sqrt()
        }
        fn depth(&self, a: f64) -> f64 {
            self.profile.reduced(a) / (1.0 + self.exponent)
        }
        fn depth_slope(&self, a: f64) -> f64 {
            self.profile.reduced_slope(a) / (1.0 + self.exponent)
        }
    }

    fn graded(exponent: f64) -> Graded {
        Graded { profile: Arc::new(Paraboloid { radius: Length::new(1.0).unwrap() }), exponent }
    }

    /// A ball on a graded half-space parts at F = −(3+n)πwR/2 (Heß 2016), n = 0 being JKR.
    #[test]
    fn a_ball_parts_from_graded_ground() {
        for exponent in [0.0, 0.25, 0.5, 0.9] {
            let pull_off = -0.5 * (3.0 + exponent) * PI;
            let mut contact = QuasiStatic::new(EdgeLine::new(graded(exponent), 1.0));
            contact.press(0.0).unwrap();
            let parted = contact.press(-9.0).unwrap()[0].before;
            // The default integrals meet xᵐ with a broken m: 32 nodes leave 32^(−2m−2), m ≥ 2.
            assert!((parted.force / pull_off - 1.0).abs() < 1e-9, "{exponent}: {}", parted.force);
            let mut bed = SpringBed::new(graded(exponent), 4000, 4.0, 1.0);
            bed.press(0.0);
            // Counted springs miss half a cell at the edge, hΔl of F.
            assert!(bed.press(0.995 * pull_off) && !bed.press(1.005 * pull_off), "{exponent}");
        }
    }

    /// The slopes of the equilibrium and the energy balance of the edge, by central differences.
    #[test]
    fn the_defaults_agree_with_each_other() {
        let (ground, h) = (graded(0.4), 1e-5);
        let line = EdgeLine::new(ground.clone(), 0.3);
        for a in [0.1, 0.7, 3.0] {
            assert!((ground.radius(ground.measure(a)) / a - 1.0).abs() < 1e-13);
            let about = |f: &dyn Fn(f64) -> f64| (f(a * (1.0 + h)) - f(a * (1.0 - h))) / (2.0 * h * a);
            for control in [Control::Indentation, Control::Force] {
                let slope = about(&|x| line.value(control, x));
                assert!((slope / line.slope(control, a) - 1.0).abs() < 1e-7, "{a} {slope}");
            }
            let state = line.at(a);
            let released = about(&|x| line.energy(x, state.indentation).elastic);
            // At the same depth the bodies give wdA.
            assert!((released / (2.0 * PI * a * 0.3) - 1.0).abs() < 1e-6, "{a} {released}");
            let work = about(&|x| ground.energy(x, 0.0)) / ground.depth_slope(a);
            assert!((work / ground.force(a, 0.0) - 1.0).abs() < 1e-7, "{a} {work}");
        }
    }
}
