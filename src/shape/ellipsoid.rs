//! Ellipsoid with two different principal radii, by its effective radius.

use super::Paraboloid;
use crate::input::quantity::{Length, QuantityError};
use serde::{Deserialize, Serialize};

/// Ellipsoid or crossed cylinders with the principal radii of curvature R₁ and R₂ [m].
///
/// The contact is elliptical; a paraboloid of the effective radius R = √(R₁R₂) approximates its force
/// (Popov, Contact Mechanics and Friction, eq. 5.30): exact at R₁ = R₂, 1 % too small a force at a given
/// indentation for R₁/R₂ = 2 and 10 % for 10; the complete elliptic integrals give the number.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Ellipsoid {
    /// Principal radius of curvature along x.
    pub radius_x: Length,
    /// Principal radius of curvature along y.
    pub radius_y: Length,
}

impl Ellipsoid {
    /// The paraboloid of revolution that stands for the ellipsoid.
    ///
    /// # Errors
    /// √(R₁R₂) is not a positive finite number (radii at the limits of `f64`).
    pub fn effective(&self) -> Result<Paraboloid, QuantityError> {
        Ok(Paraboloid { radius: Length::new(self.effective_radius())? })
    }

    /// R = √(R₁R₂) [m].
    #[must_use]
    pub fn effective_radius(&self) -> f64 {
        self.radius_x.si().sqrt() * self.radius_y.si().sqrt()
    }
}
