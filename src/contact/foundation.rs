//! What an indenter is pressed into: a bed of independent springs.
//!
//! Springs of the stiffness 2E* dx under the profile g(x): a contact of the radius a carries
//! F = 2E* ∫₀^a (d − g(x)) dx and stores U = E* ∫₀^a (d − g(x))² dx (Popov & Heß 2015, eq. 3.1). A body that is layered
//! or graded is the same bed under a profile of its own, see [`ground`](crate::ground).
//!
//! ```
//! # use springbed::contact::foundation::Foundation;
//! # use springbed::{input::quantity::Length, shape::Paraboloid};
//! # use std::sync::Arc;
//! // A lens of R = 1 m on a half-space of E* = 3 Pa, pressed to a = 0.1 m: d = a²/R and F = 4E*a³/3R.
//! let lens = Paraboloid { radius: Length::new(1.0)? };
//! let ground = Foundation::new(Arc::new(lens), 3.0);
//! assert!((ground.depth(0.1) - 0.01).abs() < 1e-17);
//! assert!((ground.force(0.1, 0.0) - 0.004).abs() < 1e-17);
//! # Ok::<(), springbed::input::quantity::QuantityError>(())
//! ```

use crate::shape::Profile;
use std::sync::Arc;

/// Elastic springs under an indenter, 2E* dx each. Radii and depths in metres.
#[derive(Debug, Clone)]
pub struct Foundation {
    profile: Arc<dyn Profile>,
    modulus: f64,
}

impl Foundation {
    /// Springs of the effective modulus `modulus` E* [Pa] under `profile`; of layers E* is that of the topmost one.
    #[must_use]
    pub fn new(profile: Arc<dyn Profile>, modulus: f64) -> Self {
        Self { profile, modulus }
    }

    /// Profile of the indenter: where it ends, where its law changes, f(r).
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

    /// g(a) [m], the indentation at which the contact without adhesion has the radius a.
    #[must_use]
    pub fn depth(&self, a: f64) -> f64 {
        self.profile.reduced(a)
    }

    /// g′(a) [1].
    #[must_use]
    pub fn depth_slope(&self, a: f64) -> f64 {
        self.profile.reduced_slope(a)
    }

    /// Normal force [N] of a contact of radius `a` whose edge is pressed by `edge` = d − g(a): 2E*(N + a·edge), with
    /// N(a) = ∫₀^a (g(a) − g(x)) dx.
    #[must_use]
    pub fn force(&self, a: f64, edge: f64) -> f64 {
        2.0 * self.modulus * (self.profile.load_integral(a) + a * edge)
    }

    /// d − g(a) [m] of a contact of radius `a` that carries the normal force `force` [N].
    #[must_use]
    pub fn edge_under(&self, a: f64, force: f64) -> f64 {
        (0.5 * force / self.modulus - self.profile.load_integral(a)) / a
    }

    /// Elastic energy [J] of a contact of radius `a` whose edge is pressed by `edge`: E*(M + 2 edge N + a edge²), with
    /// M(a) = ∫₀^a (g(a) − g(x))² dx.
    #[must_use]
    pub fn energy(&self, a: f64, edge: f64) -> f64 {
        let (n, m) = (self.profile.load_integral(a), self.profile.energy_integral(a));
        self.modulus * (m + 2.0 * edge * n + a * edge * edge)
    }

    /// 2E*a [N/m], dF/dd at constant contact radius.
    #[must_use]
    pub fn stiffness(&self, a: f64) -> f64 {
        2.0 * self.modulus * a
    }

    /// Δl(a) = √(A′w/E*) [m], at which an edge with the work of adhesion `work` w [J/m²] parts: an edge pulled by
    /// Δl releases E*Δl²/A′ of energy per area, A′ = 2πa under a round contact.
    #[must_use]
    pub fn elongation(&self, a: f64, work: f64) -> f64 {
        if work > 0.0 { (self.profile.contact_area_slope(a) * (work / self.modulus)).sqrt() } else { 0.0 }
    }

    /// d ln Δl/d ln a [1].
    #[must_use]
    pub fn elongation_growth(&self, a: f64) -> f64 {
        0.5 * self.profile.contact_area_bend(a)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::adhesion::equilibrium::{Control, Equilibrium};
    use crate::contact::adhesion::line::EdgeLine;
    use crate::ground::{Grounded, Layers, PowerLaw};
    use crate::input::quantity::{GradingExponent, Length, Modulus, Poisson};
    use crate::material::{Graded, Joint, Sheet, Stack};
    use crate::shape::Paraboloid;

    /// Depth and force of an adhesive edge at a = h, w = 1e-3, g = x²/10, E* = 1: numbers given to 11 digits.
    #[test]
    fn an_adhesive_edge_on_layers() {
        let sheet = |shear: f64, poisson: f64| Sheet { shear, poisson, thickness: 1.0, joint: Joint::Bonded };
        let gel = Stack { sheets: vec![sheet(1.0, 0.5)], base: None };
        let film = Stack { sheets: vec![sheet(1.0, 0.3)], base: Some(sheet(0.1, 0.3)) };
        for (stack, depth, force) in
            [(gel, 0.027_347_159_332, -0.018_884_392_816), (film, -0.018_667_611_853, -0.024_729_449_527)]
        {
            let ball = Arc::new(Paraboloid { radius: Length::new(10.0).unwrap() });
            let bed = Grounded::new(ball, Arc::new(Layers::new(vec![(1.0, stack)])));
            let place = bed.place(1.0);
            let ground = Foundation::new(Arc::new(bed), 1.0);
            let edge = -ground.elongation(place, 1e-3);
            assert!(
                (ground.depth(place) + edge - depth).abs() < 1e-11 && (ground.force(place, edge) - force).abs() < 1e-11
            );
        }
    }

    /// The slopes of the equilibrium and the energy balance of the edge, by central differences.
    #[test]
    fn slopes_and_energies_agree() {
        let body = Graded {
            young: Modulus::new(1.0).unwrap(),
            depth: Length::new(1.0).unwrap(),
            exponent: GradingExponent::new(0.4).unwrap(),
            poisson: Poisson::new(0.3).unwrap(),
        };
        let ball = Arc::new(Paraboloid { radius: Length::new(1.0).unwrap() });
        let graded = Grounded::new(ball.clone(), Arc::new(PowerLaw::from(&body)));
        for profile in [ball as Arc<dyn Profile>, Arc::new(graded)] {
            let (ground, h) = (Foundation::new(profile, 1.0), 1e-5);
            let line = EdgeLine::new(ground.clone(), 0.3);
            for a in [0.1, 0.7, 3.0] {
                let about = |f: &dyn Fn(f64) -> f64| (f(a * (1.0 + h)) - f(a * (1.0 - h))) / (2.0 * h * a);
                for control in [Control::Indentation, Control::Force] {
                    let slope = about(&|x| line.value(control, x));
                    assert!((slope / line.slope(control, a) - 1.0).abs() < 1e-7, "{a} {slope}");
                }
                let state = line.at(a);
                let released = about(&|x| line.energy(x, state.indentation).elastic);
                let area = about(&|x| ground.profile().contact_area(x));
                // At the same depth the bodies give wdA.
                assert!((released / (area * 0.3) - 1.0).abs() < 1e-6, "{a} {released}");
                let work = about(&|x| ground.energy(x, 0.0)) / ground.depth_slope(a);
                assert!((work / ground.force(a, 0.0) - 1.0).abs() < 1e-7, "{a} {work}");
            }
        }
    }
}
