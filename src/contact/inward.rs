//! What a half-space leaves out of the force: its surface moves inwards as well, and meets a steeper part of the shape.
//!
//! A point of the surface at r is pressed not under the height f(r) but under f(r + u_r), u_r its radial displacement. To the
//! first order of the slope this changes the force at a given depth by
//!
//! δF/F = κ ∫₀^a f′(r) P(r)/√(a² − r²) dr / (E* ∫₀^a q̂ dx),  P(r) = ∫₀^r p(s) s ds,
//!
//! with the depth d(a) − g(x) = q̂ of the springs, for r u_r = −(1−2ν)(1+ν)P/E of frictionless bodies (Johnson 1985, eq. 3.25)
//! and the force at a given depth is stationary in a. Of a rigid shape on an elastic body κ = (1−2ν)/(1−ν); an incompressible
//! one has none. Hay, Bolshakov & Pharr 1999 have the same for cones.

use crate::material::{Body, Shares};
use crate::shape::Profile;
use std::f64::consts::FRAC_PI_2;

/// Steps of the integrals: 1e-3 of what is asked for.
const STEPS: u32 = 128;

/// δF/F at the contact radius `a` [m] of a round shape on half-spaces without adhesion; `None` of bodies that are none.
///
/// The shape is taken to be that of the stiffer body. Valid to the first order of the slope at the edge.
///
/// Check: a cone of the slope t on a rigid-to-elastic pair of ν = 0 has 0.3141 t, a paraboloid 3a/4πR.
///
/// ```
/// use springbed::contact::inward::left_out;
/// use springbed::material::{Body, Elastic};
/// use springbed::shape::Paraboloid;
///
/// let soft = Body::Elastic(Elastic { young: "1 MPa".parse()?, poisson: "0".parse()?, yield_stress: None });
/// let ball = Paraboloid { radius: "1 m".parse()? };
/// let error = left_out(&(Body::Rigid, soft), &ball, 0.1).unwrap();
/// assert!((error / (0.3 / (4.0 * std::f64::consts::PI)) - 1.0).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn left_out(bodies: &(Body, Body), profile: &dyn Profile, a: f64) -> Option<f64> {
    let inwards = inwards(bodies)?;
    let load = profile.load_integral(a);
    (load > 0.0).then(|| inwards * steeper(profile, a) / load).filter(|error| error.is_finite())
}

/// κ = s(s k − (1 − s) k′) with k = (1−2ν)/(1−ν) and s the part that the softer body takes of the depth, k′ of the stiffer.
fn inwards(bodies: &(Body, Body)) -> Option<f64> {
    let shares = Shares::of(bodies)?;
    let (soft, stiff) = if shares.first_is_softer() { (&bodies.0, &bodies.1) } else { (&bodies.1, &bodies.0) };
    let moves = |body: &Body| body.poisson().map_or(0.0, |nu| (1.0 - 2.0 * nu) / (1.0 - nu));
    let share = shares.of_softer();
    Some(share * (share * moves(soft) - (1.0 - share) * moves(stiff)))
}

/// ∫₀^a f′(r) P̂(r)/√(a² − r²) dr by r = a sin θ, P̂ the load within r over E*.
fn steeper(profile: &dyn Profile, a: f64) -> f64 {
    let step = FRAC_PI_2 / f64::from(STEPS);
    let (mut within, mut sum) = (0.0, 0.0);
    for k in 0..STEPS {
        let (sine, cosine) = ((f64::from(k) + 0.5) * step).sin_cos();
        let r = a * sine;
        let half = 0.5 * step * profile.pressure_integral(r, a) * a * r * cosine;
        sum += step * slope(profile, r) * (within + half);
        within += 2.0 * half;
    }
    sum
}

/// f′ at `r`.
fn slope(profile: &dyn Profile, r: f64) -> f64 {
    const APART: f64 = 1e-4;
    (profile.height(r * (1.0 + APART)) - profile.height(r * (1.0 - APART))) / (2.0 * APART * r)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::quantity::{Length, Positive};
    use crate::material::Elastic;
    use crate::shape::{Cone, Paraboloid};
    use proptest::prelude::*;
    use std::f64::consts::PI;

    /// Catalan's constant.
    const CATALAN: f64 = 0.915_965_594_177_219;

    fn elastic(young: f64, poisson: f64) -> Body {
        let (young, poisson) = (young.to_string() + " Pa", poisson.to_string());
        Body::Elastic(Elastic { young: young.parse().unwrap(), poisson: poisson.parse().unwrap(), yield_stress: None })
    }

    /// The exact factor of a cone, and the fit of Hay, Bolshakov & Pharr 1999 (eq. 15) to the first order of its slope.
    #[test]
    fn a_cone_has_the_factor_of_hay_bolshakov_and_pharr() {
        let (t, nu) = (0.2, 0.3);
        let cone = Cone { slope: Positive::new(t).unwrap() };
        let found = left_out(&(elastic(1e6, nu), Body::Rigid), &cone, 2e-6).unwrap();
        let radial = (1.0 - 2.0 * nu) / (1.0 - nu);
        let exact = radial * t * (CATALAN - 0.5 + PI / 2.0 - 1.0) / PI;
        assert!((found / exact - 1.0).abs() < 1e-3, "{found} {exact}");
        let fitted = 0.25 * radial * t * (0.1548 * 4.0 / PI + 2.0 * 0.8311 * 2.0 / PI);
        assert!((found / fitted - 1.0).abs() < 3e-3, "{found} {fitted}");
    }

    #[test]
    fn incompressible_and_like_bodies_have_none() {
        let ball = Paraboloid { radius: Length::new(1.0).unwrap() };
        let error = |bodies: (Body, Body)| left_out(&bodies, &ball, 0.3).unwrap().abs();
        assert!(error((Body::Rigid, elastic(1.0, 0.5))) < 1e-15);
        assert!(error((elastic(2.0, 0.2), elastic(2.0, 0.2))) < 1e-15);
    }

    proptest! {
        /// Of a ball it is 3κa/4πR, whatever the units.
        #[test]
        fn a_ball_has_three_over_four_pi(radius in -9..3, part in 1..50u32, nu in 0..49u32) {
            let (radius, part, nu) = (10f64.powi(radius), f64::from(part) * 0.01, f64::from(nu) * 0.01);
            let ball = Paraboloid { radius: Length::new(radius).unwrap() };
            let found = left_out(&(Body::Rigid, elastic(1.0, nu)), &ball, part * radius).unwrap();
            let exact = 0.75 / PI * part * (1.0 - 2.0 * nu) / (1.0 - nu);
            prop_assert!((found / exact - 1.0).abs() < 1e-3, "{} {}", found, exact);
        }
    }
}
