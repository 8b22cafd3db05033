//! Attraction outside the contact that bends nothing (Derjaguin, Muller & Toporov), under a paraboloid.
//!
//! # Examples
//! ```
//! use springbed::contact::adhesion::dmt::DmtBall;
//! use springbed::contact::foundation::Foundation;
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use std::f64::consts::PI;
//! use std::sync::Arc;
//!
//! // R = E* = w = 1: Hertz's 4/3 at d = 1 less 2π.
//! let ground = Foundation::new(Arc::new(Paraboloid { radius: Length::new(1.0)? }), 1.0);
//! let ball = DmtBall::new(ground, 1.0);
//! assert!((ball.at(1.0).force - (4.0 / 3.0 - 2.0 * PI)).abs() < 1e-14);
//! assert!((ball.radius_under(4.0 / 3.0 - 2.0 * PI) - 1.0).abs() < 1e-14);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::equilibrium::{Balance, Control, Equilibrium, Search};
use super::line::{EdgeLine, Energy};
use super::sprung::Sprung;
use crate::contact::foundation::Foundation;
use crate::numerics::root;
use std::f64::consts::PI;

/// Contact of a paraboloid that is pressed by its own attraction beside the load.
///
/// Outside the contact the bodies attract each other by 2πwR, whatever the depth, and are not bent by it: F = (4/3)E*√R d^{3/2}
/// − 2πwR for d ≥ 0. At d = 0 they part, or join, at F = −2πwR; the force follows from the depth alone, so that nothing
/// is lost under a prescribed depth. Symbols: d indentation [m], R radius of curvature [m], w work of adhesion [J/m²], E*
/// effective modulus [Pa]. Source: Derjaguin, Muller & Toporov 1975; Maugis 1992, eq. 17. Valid where the range of the
/// attraction is long against what it would bend (Tabor parameter below 0.1) and short against the radius; the range
/// itself is left out, so that bodies with a gap do not feel each other. Check: R = E* = w = 1 has a = (3π/2)^{1/3} at F = 0.
#[derive(Debug, Clone)]
pub struct DmtBall {
    plain: EdgeLine,
    work: f64,
}

impl DmtBall {
    /// A paraboloid on `ground`, a half-space, with the work of adhesion w [J/m²].
    #[must_use]
    pub fn new(ground: Foundation, work: f64) -> Self {
        Self { plain: EdgeLine::new(ground, 0.0), work }
    }

    /// What the indenter is pressed into.
    #[must_use]
    pub fn ground(&self) -> &Foundation {
        self.plain.ground()
    }

    /// Work of adhesion w [J/m²].
    #[must_use]
    pub fn work(&self) -> f64 {
        self.work
    }

    /// 2πwR [N].
    #[must_use]
    pub fn attraction(&self) -> f64 {
        2.0 * PI * self.work * self.ground().profile().scale()
    }

    /// The state at the contact radius `a` [m].
    #[must_use]
    pub fn at(&self, a: f64) -> Balance {
        let hertz = self.plain.at(a);
        Balance { force: hertz.force - self.attraction(), ..hertz }
    }

    /// Contact radius [m] at the indentation `d` ≥ 0 [m].
    #[must_use]
    pub fn radius_at(&self, d: f64) -> f64 {
        self.ground().profile().edge(d).unwrap_or(0.0)
    }

    /// Contact radius [m] under the force `force` ≥ −2πwR [N]: a³ = 3R(F + 2πwR)/(4E*).
    #[must_use]
    pub fn radius_under(&self, force: f64) -> f64 {
        let (pressed, ground) = ((force + self.attraction()).max(0.0), self.ground());
        // Root by root, so that nothing overflows.
        (0.75 * pressed).cbrt() * ground.profile().scale().cbrt() / ground.modulus().cbrt()
    }

    /// The state that bodies, `joined` or not, come to at the indentation [m] or under the force [N] `to`; `None` where
    /// they are apart. On a spring of the compliance `compliance` [m/N] the indentation is that of its far end, d + F/k.
    #[must_use]
    pub fn brought(&self, joined: bool, (control, to): (Control, f64), compliance: f64) -> Option<Balance> {
        // Bodies apart are brought together by what presses them.
        let least = match control {
            Control::Indentation if joined => -compliance * self.attraction(),
            Control::Force if joined => -self.attraction(),
            Control::Indentation | Control::Force => 0.0,
        };
        (to >= least).then(|| match control {
            Control::Indentation if compliance > 0.0 => self.at(self.radius_behind(to, compliance)),
            Control::Indentation => Balance { indentation: to, ..self.at(self.radius_at(to)) },
            Control::Force => Balance { force: to, ..self.at(self.radius_under(to)) },
        })
    }

    /// Contact radius [m] with the far end of a spring of the compliance `compliance` [m/N] at `to` [m].
    fn radius_behind(&self, to: f64, compliance: f64) -> f64 {
        let sprung = Sprung { curve: self, compliance };
        let residual = |a: f64| sprung.value(Control::Indentation, a) - to;
        // Where the spring alone, or the contact alone, would give way by all of it.
        let all = (to + compliance * self.attraction()).max(0.0);
        let high = self.radius_at(all).min(self.radius_under(to / compliance));
        root::within(residual, 0.0, high)
    }

    /// Energy of a state: of Hertz's contact, and −2πwRd of the attraction.
    #[must_use]
    pub fn energy(&self, state: &Balance) -> Energy {
        let elastic = self.plain.energy(state.contact_radius, state.indentation).elastic;
        Energy { elastic, surface: -self.attraction() * state.indentation }
    }
}

impl Equilibrium for DmtBall {
    fn value(&self, control: Control, a: f64) -> f64 {
        match control {
            Control::Indentation => self.plain.value(control, a),
            Control::Force => self.plain.value(control, a) - self.attraction(),
        }
    }

    fn slope(&self, control: Control, a: f64) -> f64 {
        self.plain.slope(control, a)
    }

    fn known(&self, control: Control, target: f64) -> Option<f64> {
        match control {
            Control::Indentation => self.plain.known(control, target),
            Control::Force => None,
        }
    }

    fn start(&self) -> f64 {
        0.0
    }

    fn end(&self) -> f64 {
        self.plain.end()
    }

    fn scale(&self) -> f64 {
        self.plain.scale()
    }

    fn search(&self) -> Search {
        Search::Nowhere
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::direct::QuasiStatic;
    use crate::input::quantity::Length;
    use crate::shape::Paraboloid;
    use proptest::prelude::*;
    use std::sync::Arc;

    fn ground(radius: f64, modulus: f64) -> Foundation {
        Foundation::new(Arc::new(Paraboloid { radius: Length::new(radius).unwrap() }), modulus)
    }

    fn ball(radius: f64, modulus: f64, work: f64) -> QuasiStatic {
        QuasiStatic::new(DmtBall::new(ground(radius, modulus), work))
    }

    #[test]
    fn bodies_at_no_depth_hold_each_other_and_part_beyond() {
        let mut contact = ball(2.0, 3.0, 0.5);
        assert!(contact.indent(-1.0).unwrap().is_empty());
        let joins = contact.indent(0.0).unwrap();
        assert!(contact.present().joined && joins.len() == 1);
        assert!((contact.present().balance.force + 2.0 * PI).abs() < 1e-15);
        let parts = contact.indent(-1e-300).unwrap();
        assert!(!contact.present().joined && (parts[0].before.force + 2.0 * PI).abs() < 1e-15);
        // Nothing is lost, however often.
        assert!(contact.dissipated().abs() <= 0.0);
    }

    /// Under a force the bodies snap in at F = 0 and part at −2πwR; all that is lost is lost as they snap in.
    #[test]
    fn under_a_force_the_fall_into_contact_is_lost() {
        let mut contact = ball(1.0, 1.0, 1.0);
        assert!(contact.press(-1.0).unwrap().is_empty() && !contact.present().joined);
        contact.press(0.0).unwrap();
        let d = contact.present().balance.indentation;
        // Hertz's 2πR w = (4/3) d^{3/2}: ∫ of the force back to d = 0 is 2πd(1 − 2/5).
        assert!((contact.dissipated() - 1.2 * PI * d).abs() < 1e-13 * d);
        contact.press(-2.0 * PI).unwrap();
        assert!(contact.present().joined);
        contact.press(-2.0 * PI * (1.0 + 1e-15)).unwrap();
        assert!(!contact.present().joined);
        assert!((contact.dissipated() - 1.2 * PI * d).abs() < 1e-13 * d);
    }

    proptest! {
        /// Depth and force are two ways to the same state; dU = F dd; without work it is Hertz's contact.
        #[test]
        fn the_force_is_the_slope_of_the_energy(k in prop::array::uniform4(-300i32..300)) {
            let [radius, modulus, work, depth] = k.map(|k| (0.02 * f64::from(k)).exp());
            let mut contact = ball(radius, modulus, work);
            contact.indent(depth).unwrap();
            let there = contact.present().balance;
            let energy = |d: f64| { let mut at = contact.clone(); at.indent(d).unwrap(); at.energy().stored() };
            let h = 1e-4 * depth;
            let slope = (energy(depth + h) - energy(depth - h)) / (2.0 * h);
            let scale = there.force.abs() + 2.0 * PI * work * radius;
            // h² times the third derivative, at most 1e-8 of the force, and rounding over h.
            prop_assert!((slope - there.force).abs() < 3e-9 * scale, "{slope:e} {:e}", there.force);
            let mut pressed = ball(radius, modulus, work);
            pressed.press(there.force.max(0.0)).unwrap();
            pressed.press(there.force).unwrap();
            let rounding = 1e-14 * scale / (there.force + 2.0 * PI * work * radius);
            prop_assert!((pressed.present().balance.indentation / depth - 1.0).abs() < rounding.max(1e-14));
            let (mut none, mut hertz) = (ball(radius, modulus, 0.0), QuasiStatic::new(EdgeLine::new(ground(radius, modulus), 0.0)));
            none.indent(depth).unwrap();
            hertz.indent(depth).unwrap();
            prop_assert!((none.present().balance.force / hertz.present().balance.force - 1.0).abs() < 1e-14);
        }
    }
}
