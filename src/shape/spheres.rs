//! Two spheres against each other, by their effective radius.

use super::Paraboloid;
use crate::input::quantity::{Displacement, Length};
use serde::{Deserialize, Serialize};

/// Two spheres of the radii R₁ and R₂ [m], one of which may be hollow (a cup, of negative radius).
///
/// Their gap is that of a paraboloid of the effective radius R with 1/R = 1/R₁ + 1/R₂ on a flat (Hertz 1882; Popov,
/// Contact Mechanics and Friction, eq. 5.25), while a is small against both radii. Valid for any pair of bodies.
/// Check: a ball of 10 mm in a cup of −20 mm is one of 20 mm on a flat.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Spheres {
    /// Radius of the first sphere.
    pub radius_1: Displacement,
    /// Radius of the second sphere.
    pub radius_2: Displacement,
}

impl Spheres {
    /// The paraboloid on a flat that stands for both; `None` where the surfaces do not part from each other.
    #[must_use]
    pub fn effective(&self) -> Option<Paraboloid> {
        Length::new(self.effective_radius()).ok().map(|radius| Paraboloid { radius })
    }

    /// R = R₁R₂/(R₁ + R₂) [m], below zero or not finite where the surfaces do not part from each other.
    #[must_use]
    pub fn effective_radius(&self) -> f64 {
        let (one, other) = (self.radius_1.si(), self.radius_2.si());
        // The larger one divides, so that nothing overflows: R = R₂/(1 + R₂/R₁).
        let (small, large) = if one.abs() < other.abs() { (one, other) } else { (other, one) };
        small / (1.0 + small / large)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn effective(one: f64, other: f64) -> Option<f64> {
        let radius = |radius| Displacement::new(radius).unwrap();
        let spheres = Spheres { radius_1: radius(one), radius_2: radius(other) };
        spheres.effective().map(|paraboloid| paraboloid.radius.si())
    }

    #[test]
    fn curvatures_add() {
        assert_eq!(effective(1.0, 1.0), Some(0.5));
        assert_eq!(effective(10.0, -20.0), Some(20.0));
        assert_eq!(effective(-20.0, 10.0), Some(20.0));
        assert_eq!(effective(1e-300, 1e300), Some(1e-300));
        assert_eq!(effective(1e308, 1e308), Some(0.5e308));
    }

    #[test]
    fn surfaces_that_do_not_part_have_no_radius() {
        for (one, other) in [(1.0, -1.0), (1.0, -0.5), (-1.0, -2.0), (0.0, 1.0), (0.0, 0.0)] {
            assert_eq!(effective(one, other), None, "{one} {other}");
        }
    }
}
