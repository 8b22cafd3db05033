//! How two bodies share the displacement of a contact.

use super::Body;
use super::alone::in_series;

/// The parts of the displacement of a contact that its two bodies take, which sum up to one.
///
/// Both bear the same pressure, so that each surface gives by its own compliance: u₁ : u₂ = 1/E*₁ : 1/E*₂ with
/// E*ᵢ = Eᵢ/(1 − νᵢ²) (Johnson 1985, eq. 4.6 and before it). Of bodies that relax the ratio is one for all times only if the other one is rigid or relaxes alike.
///
/// ```
/// use springbed::material::{Body, Elastic, Shares};
///
/// let elastic = |young: &str| Body::Elastic(Elastic { young: young.parse().unwrap(), poisson: "0.3".parse().unwrap(), yield_stress: None });
/// let shares = Shares::of(&(elastic("210 GPa"), elastic("70 GPa"))).unwrap();
/// assert!((shares.one - 0.25).abs() < 1e-15 && (shares.two - 0.75).abs() < 1e-15);
/// assert_eq!(Shares::of(&(Body::Rigid, elastic("1 Pa"))).unwrap().two, 1.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shares {
    /// Part of the first body.
    pub one: f64,
    /// Part of the second body.
    pub two: f64,
}

impl Shares {
    /// The parts of two bodies; `None` of two rigid ones, and where the parts depend on time or place: of a body that relaxes
    /// against another one, of layers, of a graded body, and of one that yields.
    #[must_use]
    pub fn of(bodies: &(Body, Body)) -> Option<Self> {
        let ((one, two), _) = match (&bodies.0, &bodies.1) {
            (Body::Rigid, Body::Elastic(_) | Body::Viscoelastic(_)) => in_series(f64::INFINITY, 1.0),
            (Body::Elastic(_) | Body::Viscoelastic(_), Body::Rigid) => in_series(1.0, f64::INFINITY),
            (Body::Elastic(one), Body::Elastic(two)) => in_series(one.plane_modulus(), two.plane_modulus()),
            (Body::Viscoelastic(one), Body::Viscoelastic(two)) if one == two => in_series(1.0, 1.0),
            (
                Body::Rigid
                | Body::Elastic(_)
                | Body::Viscoelastic(_)
                | Body::Layered(_)
                | Body::Winkler(_)
                | Body::Graded(_)
                | Body::Plastic(_),
                Body::Rigid
                | Body::Elastic(_)
                | Body::Viscoelastic(_)
                | Body::Layered(_)
                | Body::Winkler(_)
                | Body::Graded(_)
                | Body::Plastic(_),
            ) => return None,
        };
        Some(Self { one, two })
    }

    /// The part of the softer body, the second of two that are alike.
    #[must_use]
    pub fn of_softer(self) -> f64 {
        self.one.max(self.two)
    }

    /// Whether the first body is the softer one.
    #[must_use]
    pub fn first_is_softer(self) -> bool {
        self.one > self.two
    }
}
