//! One spring or summit of a pad: what it carries at a depth, and how far it holds.

use crate::contact::adhesion::line::Energy;
use std::f64::consts::PI;

/// What touches one by one on a pad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Element {
    /// Springs.
    Spring(Spring),
    /// Balls.
    Summit(Summit),
}

/// A spring that is joined to what it touches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spring {
    /// Stiffness k [N/m].
    pub stiffness: f64,
    /// Energy [J] of adhesion, w times the area it stands for.
    pub work: f64,
    /// The same that it gains as it joins.
    pub closing: f64,
}

/// A ball on an elastic half-space, by Johnson, Kendall & Roberts.
///
/// u = a²/R − √(2πaw/E*), f = 4E*a³/3R − √(8πE*wa³), and without adhesion Hertz; E*, R, w as there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Summit {
    /// Radius R [m].
    pub radius: f64,
    /// Effective modulus E* [Pa].
    pub modulus: f64,
    /// Work of adhesion w [J/m²].
    pub work: f64,
}

/// Stretches [m] of a spring or summit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hold {
    /// Distance at which it joins.
    pub joins: f64,
    /// Stretch at which it lets go.
    pub leaves: f64,
}

/// What an element carries.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Carried {
    /// Force [N], a pull negative.
    pub force: f64,
    /// Stored energy [J].
    pub stored: Energy,
}

impl Element {
    /// How far it holds.
    #[must_use]
    pub fn hold(&self) -> Hold {
        match self {
            // ½ks² is the energy of adhesion.
            Self::Spring(spring) => Hold {
                joins: (2.0 * spring.closing / spring.stiffness).sqrt(),
                leaves: (2.0 * spring.work / spring.stiffness).sqrt(),
            },
            Self::Summit(summit) => Hold { joins: 0.0, leaves: -summit.depth(summit.least_radius()) },
        }
    }

    /// What it carries while it is joined, pressed in by `depth` [m]; a stretch is negative.
    #[must_use]
    pub fn carried(&self, depth: f64) -> Carried {
        match self {
            Self::Spring(spring) => Carried {
                force: spring.stiffness * depth,
                stored: Energy { elastic: 0.5 * spring.stiffness * depth * depth, surface: -spring.work },
            },
            Self::Summit(summit) => summit.carried(summit.contact_radius(depth)),
        }
    }
}

impl Summit {
    /// Least contact radius [m] in equilibrium under a prescribed depth, (πwR²/8E*)^{1/3}.
    #[must_use]
    pub fn least_radius(&self) -> f64 {
        (PI * self.work * self.radius.powi(2) / (8.0 * self.modulus)).cbrt()
    }

    /// √(2πaw/E*) [m], by which the edge is stretched.
    fn stretch(&self, a: f64) -> f64 {
        (2.0 * PI * a * self.work / self.modulus).sqrt()
    }

    /// Depth u [m] at the contact radius `a` [m].
    #[must_use]
    pub fn depth(&self, a: f64) -> f64 {
        a * a / self.radius - self.stretch(a)
    }

    /// du/da.
    #[must_use]
    pub fn depth_growth(&self, a: f64) -> f64 {
        let edge = if self.work > 0.0 { 0.5 * self.stretch(a) / a } else { 0.0 };
        2.0 * a / self.radius - edge
    }

    /// df/da [N/m] = 4E*a²/R − √(18πE*wa).
    #[must_use]
    pub fn force_growth(&self, a: f64) -> f64 {
        4.0 * self.modulus * a * a / self.radius - (18.0 * PI * self.modulus * self.work * a).sqrt()
    }

    /// Contact radius [m] of the stable equilibrium at the depth `u` [m].
    ///
    /// The depth is a convex function of the radius: Newton's method from above falls to it without a turn.
    #[must_use]
    pub fn contact_radius(&self, u: f64) -> f64 {
        let (least, touch) = (self.least_radius(), 4f64.cbrt().powi(2) * self.least_radius());
        let mut a = (self.radius * u.max(0.0)).sqrt() + touch;
        if self.work <= 0.0 {
            return a;
        }
        for _ in 0..60 {
            let next = (a - (self.depth(a) - u) / self.depth_growth(a)).max(least);
            if next >= a {
                break;
            }
            a = next;
        }
        a
    }

    /// What it carries at the contact radius `a` [m]: U = E*∫₀^a (u − x²/R)² dx − πwa².
    #[must_use]
    pub fn carried(&self, a: f64) -> Carried {
        let (e, r) = (self.modulus, self.radius);
        let (u, square) = (self.depth(a), a * a);
        let elastic = e * a * (u * u - 2.0 * u * square / (3.0 * r) + square * square / (5.0 * r * r));
        let force = 4.0 * e * a * square / (3.0 * r) - (8.0 * PI * e * self.work * a * square).sqrt();
        Carried { force, stored: Energy { elastic, surface: -PI * self.work * square } }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// JKR, R = E* = w = 1: 25-digit numbers at the turning point, at first touch and without load.
    #[test]
    fn a_summit_is_an_adhesive_ball() {
        let summit = Summit { radius: 1.0, modulus: 1.0, work: 1.0 };
        assert!((summit.least_radius() - 0.732_295_943_780_762).abs() < 1e-15);
        let element = Element::Summit(summit);
        assert!((element.hold().leaves - 1.608_772_047_833_27).abs() < 1e-14);
        assert!((element.carried(-1.608_772_047_833_27).force + 5.0 / 6.0 * PI).abs() < 1e-6);
        assert!((element.carried(0.0).force + 4.0 / 3.0 * PI).abs() < 1e-14);
        assert!((summit.contact_radius(0.0) - 1.845_270_148_644_028).abs() < 1e-14);
        assert!((summit.contact_radius(1.948_888_544_860_377) - 2.417_987_931_024_707).abs() < 1e-14);
        // The work to part it from first touch.
        let lost = element.carried(-element.hold().leaves).stored.stored() - element.carried(0.0).stored.stored();
        assert!((lost - 7.092_196).abs() < 1e-6, "{lost}");
    }
}
