//! Gross sliding under laws of soft matter, which act on the pressure p(r).
//!
//! # Examples
//! ```
//! use springbed::contact::loaded::Loaded;
//! use springbed::friction::sliding::{LinearLaw, sliding_force};
//! use springbed::contact::foundation::Foundation;
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! // τ = τ_c + βp over a ball, R = E* = a = 1: F_x = τ_cπa² + βF.
//! let ground = Foundation::new(Arc::new(Paraboloid { radius: Length::new(1.0)? }), 1.0);
//! let law = LinearLaw { strength: 0.01, slope: 0.1 };
//! let force = sliding_force(&Loaded::elastic(ground, 1.0, 0.0), &law);
//! assert!((force - (0.01 * std::f64::consts::PI + 0.1 * 4.0 / 3.0)).abs() < 1e-13);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::peeling::{ShearedAdhesion, TangentialLoad};
use super::strength::{Strength, StrengthCurve};
use super::{Coulomb, CoulombOrowan, Friction, FrictionError};
use crate::contact::error::OutsideTable;
use crate::contact::loaded::Loaded;
use crate::input::quantity::Ratio;
use crate::numerics::quadrature::panel_with_root_ends;
use crate::numerics::root::brent;
use std::f64::consts::{FRAC_PI_2, PI};

/// Samples of the pressure between which it is searched for the corners of a law.
const SAMPLES: u32 = 64;

/// Shear stress of a sliding interface as a function of the local pressure.
pub trait SlidingLaw: Send + Sync {
    /// τ(p) [Pa] at the pressure `p` [Pa], negative in tension. Never negative.
    fn stress(&self, p: f64) -> f64;

    /// Pressures [Pa] at which τ(p) has a corner.
    fn corners(&self) -> Vec<f64>;
}

/// τ = μp where the bodies press each other; tension carries no friction.
impl SlidingLaw for Coulomb {
    fn stress(&self, p: f64) -> f64 {
        self.coefficient.si() * p.max(0.0)
    }

    fn corners(&self) -> Vec<f64> {
        vec![0.0]
    }
}

/// τ = min(μp, τ_max) (Ceglie et al., eq. 6); tension carries no friction.
impl SlidingLaw for CoulombOrowan {
    fn stress(&self, p: f64) -> f64 {
        (self.coefficient.si() * p.max(0.0)).min(self.shear_limit.si())
    }

    fn corners(&self) -> Vec<f64> {
        vec![0.0, self.shear_limit.si() / self.coefficient.si()]
    }
}

/// Shear stress linear in the pressure: τ = τ_c + βp = β(p_ad + p) (Persson et al. 2008, eqs. 3 and 4),
/// and zero where the tension is above the adhesional pressure p_ad = τ_c/β.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearLaw {
    /// Shear stress τ_c at zero pressure [Pa].
    pub strength: f64,
    /// Slope β.
    pub slope: f64,
}

impl SlidingLaw for LinearLaw {
    fn stress(&self, p: f64) -> f64 {
        // β = 0 is the uniform stress τ_c, at any tension.
        if self.slope > 0.0 { (self.strength + self.slope * p).max(0.0) } else { self.strength }
    }

    fn corners(&self) -> Vec<f64> {
        vec![-self.strength / self.slope]
    }
}

impl Friction {
    /// The law of gross sliding at the speed `speed` [m/s]; `curve` is the table of the shear strength,
    /// if the scene names one.
    ///
    /// # Errors
    /// The speed is outside the table.
    pub fn law(&self, speed: f64, curve: Option<&StrengthCurve>) -> Result<Box<dyn SlidingLaw>, OutsideTable> {
        Ok(match self {
            Self::Coulomb(law) => Box::new(law.clone()),
            Self::StaticKinetic(law) => Box::new(Coulomb { coefficient: law.kinetic }),
            Self::RateState(law) => {
                let steady = Ratio::new(law.steady(speed.max(f64::MIN_POSITIVE)));
                let coefficient = steady.unwrap_or(law.coefficient);
                Box::new(Coulomb { coefficient })
            }
            // Where the edge of what stuck has given way nothing is said of friction.
            Self::Stuck => Box::new(LinearLaw { strength: 0.0, slope: 0.0 }),
            Self::CoulombOrowan(law) => Box::new(law.clone()),
            Self::Pressure(law) => {
                let strength = match (&law.shear, curve) {
                    (_, Some(curve)) => curve.at(speed)?,
                    (Strength::Constant(strength), None) => strength.si(),
                    (Strength::Table(_), None) => 0.0,
                };
                Box::new(LinearLaw { strength, slope: law.slope.si() })
            }
        })
    }
}

/// Friction force F_x = 2π∫₀^a τ(p(r)) r dr [N] of a loaded contact in gross sliding.
///
/// With r = a sin θ both the root at the edge of a smooth contact and the inverse root at a wall or
/// an adhesive edge become smooth; panels end where the law or the profile has a corner.
/// Under `Coulomb` without adhesion it is μF, under `Pressure` τ_cπa² + βF as long as no tension
/// exceeds p_ad.
#[must_use]
pub fn sliding_force(loaded: &Loaded, law: &dyn SlidingLaw) -> f64 {
    over_angles(loaded, law, &|radius| loaded.profile().ring(radius))
}

/// Tangential displacement u = (2/G*) ∫₀^a τ(p(r)) dr [m] at which a contact slips everywhere; below it the middle sticks.
///
/// The tangential springs of a contact in gross sliding carry q_x(x) = 2∫ₓ^a τ r dr/√(r²−x²), most on the axis, which
/// slips last (Popov & Heß 2015, ch. 5). Of a second slide the other way it is twice as much. `modulus` is G* [Pa].
/// Check: Coulomb friction has μdE*/G* whatever the shape, a uniform stress 2τa/G*.
#[must_use]
pub fn full_slip_displacement(loaded: &Loaded, law: &dyn SlidingLaw, modulus: f64) -> f64 {
    over_angles(loaded, law, &|radius| loaded.profile().under_middle(radius)) / modulus
}

/// Radius, or half width, [m] of a loaded contact.
fn radius(loaded: &Loaded) -> f64 {
    loaded.profile().contact_radius(loaded.contact_radius())
}

/// ∫ τ(p(r)) weight(r) dr over the radius r = a sin θ, the cosine of which takes an inverse root away.
fn over_angles(loaded: &Loaded, law: &dyn SlidingLaw, weight: &dyn Fn(f64) -> f64) -> f64 {
    let (place, a, profile) = (loaded.contact_radius(), radius(loaded), loaded.profile());
    let mut ends: Vec<f64> = law.corners().into_iter().flat_map(|p| crossings(loaded, p)).collect();
    let inside = profile.breaks(place).into_iter().filter(|&x| x < place);
    ends.extend(inside.map(|x| (profile.contact_radius(x) / a).asin()));
    ends.push(FRAC_PI_2);
    ends.sort_by(f64::total_cmp);
    let mut from = 0.0;
    let mut sum = 0.0;
    for to in ends {
        let at = |theta: f64| law.stress(pressure(loaded, theta)) * weight(a * theta.sin()) * a * theta.cos();
        sum += panel_with_root_ends(|past, left| at(if past < left { from + past } else { to - left }), to - from);
        from = to;
    }
    sum
}

/// Pressure [Pa] at r = a sin θ, where the root at the edge of a round contact is a cos θ to all digits.
fn pressure(loaded: &Loaded, theta: f64) -> f64 {
    let (a, edge) = (radius(loaded), loaded.edge_load());
    let place = loaded.profile().place(a * theta.sin());
    if loaded.profile().is_plane() {
        return loaded.pressure(place);
    }
    let regular = loaded.regular_pressure(place);
    if edge.abs() > 0.0 { regular + edge / (PI * (a * theta.cos())) } else { regular }
}

/// The angles θ at which the pressure passes `level` [Pa].
fn crossings(loaded: &Loaded, level: f64) -> Vec<f64> {
    if !level.is_finite() {
        return Vec::new();
    }
    // Times cos θ it is finite at the edge too.
    let excess = |theta: f64| {
        let p = pressure(loaded, theta);
        if p.is_finite() { (p - level) * theta.cos() } else { p }
    };
    let waves = |length: f64| (radius(loaded) / length).clamp(1.0, 64.0).ceil();
    let samples = f64::from(SAMPLES) * loaded.profile().feature().map_or(1.0, waves);
    let mut angles: Vec<f64> = Vec::new();
    let (mut k, mut low) = (0.0, 1e-9);
    while k < samples {
        k += 1.0;
        let high = k / samples * FRAC_PI_2;
        if excess(low) * excess(high) < 0.0 {
            angles.extend(brent(excess, low, high).ok());
        }
        low = high;
    }
    angles
}

/// Friction at one load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlidingPoint {
    /// Normal force F [N].
    pub force: f64,
    /// Contact radius a [m].
    pub contact_radius: f64,
    /// Friction force F_x [N].
    pub friction_force: f64,
    /// F_x/F, the coefficient of friction one would measure.
    pub coefficient: f64,
    /// d ln F_x/d ln F: one where Amontons' law holds, 2/3 where F_x follows the area of a paraboloid.
    pub exponent: f64,
}

/// Friction force against load, without (`work` = 0) or with adhesion (JKR; shear does not peel).
///
/// # Errors
/// A load at which the bodies part or at which the profile ends.
pub fn friction_curve(
    contact: &ShearedAdhesion,
    law: &dyn SlidingLaw,
    loads: &[f64],
) -> Result<Vec<SlidingPoint>, FrictionError> {
    let pressed = |force: f64| -> Result<Loaded, FrictionError> {
        let ground = contact.line.ground().clone();
        if contact.line.work() > 0.0 {
            let state = contact.under(force, TangentialLoad::Force(0.0))?;
            let edge_load = ground.modulus() * (state.indentation - ground.profile().reduced(state.contact_radius));
            return Ok(Loaded::elastic(ground, state.contact_radius, edge_load));
        }
        let contact_radius = contact.plain_radius(force)?;
        Ok(Loaded::elastic(ground, contact_radius, 0.0))
    };
    let point = |&force: &f64| {
        let middle = pressed(force)?;
        let friction = sliding_force(&middle, law);
        // Central difference over ±0.1 %: 1e-7 of the curvature against 1e-12 of rounding.
        let step = 1e-3;
        let sides = [1.0 + step, 1.0 - step].map(|part| pressed(part * force).map(|state| sliding_force(&state, law)));
        let [above, below] = sides;
        Ok(SlidingPoint {
            force,
            contact_radius: middle.contact_radius(),
            friction_force: friction,
            coefficient: friction / force,
            exponent: (above? / below?).ln() / ((1.0 + step) / (1.0 - step)).ln(),
        })
    };
    loads.iter().map(point).collect()
}

/// The loads [N] between which Amontons' law holds: the longest run of points whose exponent is
/// within `tolerance` of one. `None` if there is no such point.
#[must_use]
pub fn amontons_range(points: &[SlidingPoint], tolerance: f64) -> Option<(f64, f64)> {
    points
        .chunk_by(|a, b| holds(a, tolerance) == holds(b, tolerance))
        .filter(|run| run.first().is_some_and(|point| holds(point, tolerance)))
        .max_by_key(|run| run.len())
        .and_then(|run| Some((run.first()?.force, run.last()?.force)))
}

fn holds(point: &SlidingPoint, tolerance: f64) -> bool {
    (point.exponent - 1.0).abs() <= tolerance
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::adhesion::line::EdgeLine;
    use crate::contact::foundation::Foundation;
    use crate::input::quantity::{Length, Modulus, Positive, Ratio};
    use crate::shape::{Cone, Paraboloid, Profile};
    use std::sync::Arc;

    fn orowan(coefficient: f64, limit: f64) -> CoulombOrowan {
        CoulombOrowan { coefficient: Ratio::new(coefficient).unwrap(), shear_limit: Modulus::new(limit).unwrap() }
    }

    fn lens() -> Paraboloid {
        Paraboloid { radius: Length::new(1.0).unwrap() }
    }

    fn ground() -> Foundation {
        Foundation::new(Arc::new(lens()), 1.0)
    }

    /// Linear laws: μF and τ_cπa² + βF for any profile, the logarithm of the cone included.
    #[test]
    fn linear_laws_need_no_pressure() {
        let cone = Cone { slope: Positive::new(0.3).unwrap() };
        let (lens, a) = (lens(), 0.7);
        let law = LinearLaw { strength: 0.2, slope: 0.1 };
        let coulomb = Coulomb { coefficient: Ratio::new(0.4).unwrap() };
        for (profile, bound) in [(Arc::new(lens) as Arc<dyn Profile>, 1e-13), (Arc::new(cone), 1e-9)] {
            let force = 2.0 * profile.load_integral(a);
            let pressed = Loaded::elastic(Foundation::new(profile, 1.0), a, 0.0);
            assert!((sliding_force(&pressed, &coulomb) / (0.4 * force) - 1.0).abs() < bound);
            let exact = 0.2 * PI * a * a + 0.1 * force;
            assert!((sliding_force(&pressed, &law) / exact - 1.0).abs() < bound);
        }
    }

    /// A wall: the singular pressure of a flat punch and of JKR is integrated, not clipped by chance.
    #[test]
    fn an_edge_load_is_integrated() {
        let (lens, a) = (lens(), 0.7);
        let pressed = Loaded::elastic(ground(), a, 0.5);
        let force = 2.0 * (lens.load_integral(a) + 0.5 * a);
        let coulomb = Coulomb { coefficient: Ratio::new(0.4).unwrap() };
        assert!((sliding_force(&pressed, &coulomb) / (0.4 * force) - 1.0).abs() < 1e-13);
        // Uniform stress whatever the tension.
        let uniform = LinearLaw { strength: 0.2, slope: 0.0 };
        let adhesive = Loaded::elastic(ground(), a, -0.5);
        assert!((sliding_force(&adhesive, &uniform) / (0.2 * PI * a * a) - 1.0).abs() < 1e-13);
        // Capped, it is less than the cap times the area and less than μ times the pressing part.
        let capped = sliding_force(&adhesive, &orowan(0.4, 0.2));
        assert!(capped > 0.0 && capped < 0.2 * PI * a * a);
    }

    /// The tensile rim of JKR carries no Coulomb friction: p = (2/π)[√(1−r²) − e/√(1−r²)] with
    /// a = E* = R = 1 and q(a) = −2e is positive inside s = √(1−r²) > √e, and gives 4μ(1/3 − e + (2/3)e^{3/2}).
    #[test]
    fn tension_carries_no_friction() {
        let e: f64 = 0.2;
        let pressed = Loaded::elastic(ground(), 1.0, -2.0 * e);
        let coulomb = Coulomb { coefficient: Ratio::new(1.0).unwrap() };
        let exact = 4.0 * (1.0 / 3.0 - e + 2.0 / 3.0 * e.powf(1.5));
        assert!((sliding_force(&pressed, &coulomb) / exact - 1.0).abs() < 1e-13);
    }

    #[test]
    fn amontons_holds_at_low_load_under_a_cap() {
        let contact = ShearedAdhesion { line: EdgeLine::new(ground(), 0.0), ratio: 1.0 };
        let loads: Vec<f64> = (-60..40).map(|k| 10f64.powf(0.1 * f64::from(k))).collect();
        let law = orowan(0.5, 0.05);
        let points = friction_curve(&contact, &law, &loads).unwrap();
        let (low, high) = amontons_range(&points, 1e-6).unwrap();
        let limit = PI.powi(3) * 0.1f64.powi(3) / 6.0;
        assert!(low < 1.1e-6 && high < limit && high > limit / 1.3, "{high} {limit}");
        // Far above it the force follows the area, F^{2/3}.
        assert!((points.last().unwrap().exponent - 2.0 / 3.0).abs() < 1e-3);
    }
}
