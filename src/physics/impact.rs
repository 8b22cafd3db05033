//! Impact of a mass on an elastic, adhesive or viscoelastic half-space.
//!
//! Without dissipation in the contact the motion follows from energy alone; with it, the bed is
//! driven by m d̈ = −F.

mod driven;

pub use driven::Driven;

use super::quadrature;
use super::root;
use super::shape::Profile;

/// A mass that meets the half-space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Impact {
    /// Mass m [kg].
    pub mass: f64,
    /// Speed v at first touch [m/s].
    pub speed: f64,
}

/// What comes of an impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rebound {
    /// Contact time [s]; `None` if the bodies stay together.
    pub contact_time: Option<f64>,
    /// Greatest depth [m].
    pub greatest_depth: f64,
    /// Greatest force [N].
    pub greatest_force: f64,
    /// Restitution coefficient e = rebound speed/v, zero if the bodies stay together.
    pub restitution: f64,
    /// Kinetic energy lost for good [J].
    pub lost: f64,
}

impl Rebound {
    /// Whether the bodies stay together.
    #[must_use]
    pub fn sticks(&self) -> bool {
        self.contact_time.is_none()
    }
}

/// Why an impact could not be followed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum ImpactError {
    /// The kinetic energy carries the contact beyond the end of its profile.
    #[error("the impact drives the contact beyond the profile: {energy:e} J of kinetic energy")]
    BeyondProfile {
        /// Kinetic energy [J].
        energy: f64,
    },
}

/// A contact that gives back the work done on it, from the depth at which it forms to the depth at
/// which it parts.
pub trait Conservative {
    /// Force [N] at the depth `d` [m]; `None` beyond the profile.
    fn force(&self, d: f64) -> Option<f64>;

    /// Work [J] from the depth zero, where the contact forms, to `d` [m].
    fn work(&self, d: f64) -> Option<f64>;

    /// Depth at which the contact parts on the way back [m]: zero without adhesion, negative with it.
    fn parting(&self) -> f64;

    /// A depth [m] typical of the contact, from which searches start.
    fn scale(&self) -> f64;
}

/// Elastic contact without adhesion: F = 2E*N(a), W = E* ∫₀^a (d − g)² dx.
#[derive(Debug)]
pub struct Elastic<'p> {
    /// Profile of the indenter.
    pub profile: &'p dyn Profile,
    /// E* [Pa].
    pub modulus: f64,
}

impl Conservative for Elastic<'_> {
    fn force(&self, d: f64) -> Option<f64> {
        let a = self.profile.edge(d)?;
        let over = d - self.profile.reduced(a);
        Some(2.0 * self.modulus * (self.profile.load_integral(a) + a * over))
    }

    fn work(&self, d: f64) -> Option<f64> {
        let a = self.profile.edge(d)?;
        let over = d - self.profile.reduced(a);
        let squares = self.profile.energy_integral(a) + over * (2.0 * self.profile.load_integral(a) + over * a);
        Some(self.modulus * squares)
    }

    fn parting(&self) -> f64 {
        0.0
    }

    fn scale(&self) -> f64 {
        self.profile.reduced(self.profile.scale())
    }
}

/// Impact on a contact without dissipation but for the jump into contact and the one out of it.
///
/// The speed is v as the contact forms at d = 0, and again as d comes back to zero; the work from
/// there to the parting, W, is lost: e = √(1 − (v_s/v)²) with the sticking speed v_s = √(2W/m).
/// Contact time ∫ dd/√(v² − 2W(d)/m). Check: Hertz, 2.943275184324705 x₀/v with the greatest depth
/// x₀ = (15mv²/(16E*√R))^{2/5} (Johnson 1985, eq. 11.23).
///
/// # Errors
/// The kinetic energy carries the contact beyond the profile.
pub fn conservative(impact: &Impact, contact: &impl Conservative) -> Result<Rebound, ImpactError> {
    let energy = 0.5 * impact.mass * impact.speed * impact.speed;
    let deepest = turning_point(contact, energy).ok_or(ImpactError::BeyondProfile { energy })?;
    let parting = contact.parting();
    let detaching = if parting < 0.0 { contact.work(parting).unwrap_or(0.0) } else { 0.0 };
    let left = energy - detaching;
    let contact_time = (left > 0.0).then(|| {
        let inwards = duration_inwards(impact, contact, deepest);
        let speed = |d: f64| (2.0 * (energy - contact.work(d).unwrap_or(0.0)) / impact.mass).sqrt();
        2.0 * inwards + quadrature::panel_with_root_ends(|_, above| speed(-above).recip(), -parting)
    });
    Ok(Rebound {
        contact_time,
        greatest_depth: deepest,
        greatest_force: contact.force(deepest).unwrap_or(0.0),
        restitution: (left / energy).max(0.0).sqrt(),
        lost: if left > 0.0 { detaching } else { energy },
    })
}

/// Depth at which the kinetic energy is used up.
fn turning_point(contact: &impl Conservative, energy: f64) -> Option<f64> {
    let residual = |d: f64| contact.work(d).map_or(f64::MAX, |work| work - energy);
    let mut high = contact.scale();
    while residual(high) < 0.0 {
        high *= 2.0;
    }
    let mut low = high;
    while residual(low) > 0.0 && low > 1e-300 {
        (low, high) = (0.5 * low, low);
    }
    let deepest = root::brent(residual, low, high).ok()?;
    contact.work(deepest).map(|_| deepest)
}

/// ∫ dd/√(v² − 2W/m) from zero to the greatest depth x₀, with d = x₀(1 − u²).
///
/// The energy left near the turning point is the integral of the force from there, free of
/// cancellation.
fn duration_inwards(impact: &Impact, contact: &impl Conservative, deepest: f64) -> f64 {
    let force = |d: f64| contact.force(d).unwrap_or(0.0);
    let at = |u: f64| {
        let d = deepest * (1.0 - u) * (1.0 + u);
        let left = quadrature::panel_with_root_ends(|above, _| force(d + above), deepest * u * u);
        2.0 * deepest * u / (2.0 * left / impact.mass).sqrt()
    };
    quadrature::panels(at, (0.0, 0.5), &[]) + 0.5 * quadrature::panel_with_root_ends(|_, y| at(1.0 - 0.5 * y), 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::quantity::Length;
    use crate::physics::shape::Paraboloid;
    use proptest::prelude::*;
    use std::f64::consts::TAU;

    /// A line of force, F = k(d − d₀): half a period of an oscillator.
    struct Linear {
        stiffness: f64,
        parting: f64,
    }

    impl Conservative for Linear {
        fn force(&self, d: f64) -> Option<f64> {
            Some(self.stiffness * d)
        }

        fn work(&self, d: f64) -> Option<f64> {
            Some(0.5 * self.stiffness * d * d)
        }

        fn parting(&self) -> f64 {
            self.parting
        }

        fn scale(&self) -> f64 {
            1.0
        }
    }

    proptest! {
        /// Hertz over 20 decades; bound: rounding of roots and quadrature.
        #[test]
        fn hertz(m in -100i32..100, v in -50i32..50) {
            let power = |k: i32| 10f64.powf(0.1 * f64::from(k));
            let profile = Paraboloid { radius: Length::new(0.3).unwrap() };
            let impact = Impact { mass: power(m), speed: power(v) };
            let seen = conservative(&impact, &Elastic { profile: &profile, modulus: 7.0 }).unwrap();
            let depth = (15.0 * impact.mass * impact.speed.powi(2) / (16.0 * 7.0 * 0.3f64.sqrt())).powf(0.4);
            prop_assert!((seen.greatest_depth / depth - 1.0).abs() < 1e-13);
            let time = seen.contact_time.unwrap() * impact.speed / depth;
            prop_assert!((time - 2.943_275_184_324_705).abs() < 1e-10, "{time}");
            prop_assert!((seen.restitution - 1.0).abs() < 1e-15);
        }
    }

    /// Half a period within, a twelfth beyond: speed 2 and parting at half the amplitude.
    #[test]
    fn oscillator_that_parts_late() {
        let contact = Linear { stiffness: 1.0, parting: -1.0 };
        let seen = conservative(&Impact { mass: 1.0, speed: 2.0 }, &contact).unwrap();
        assert!((seen.restitution - 0.75f64.sqrt()).abs() < 1e-15);
        assert!((seen.contact_time.unwrap() - 7.0 / 6.0 * std::f64::consts::PI).abs() < 1e-13);
        assert!(conservative(&Impact { mass: 1.0, speed: 0.99 }, &contact).unwrap().sticks());
    }

    /// JKR paraboloid, R = E* = w = 1, on its stable branch: a is the larger root of d = a² − √(2πa).
    struct Jkr;

    impl Jkr {
        fn radius(d: f64) -> f64 {
            root::brent(|a| a * a - (TAU * a).sqrt() - d, 0.732_295_943_780_762, 1e3).unwrap()
        }

        fn energy(d: f64) -> f64 {
            let a = Self::radius(d);
            a * d * d - 2.0 / 3.0 * d * a.powi(3) + 0.2 * a.powi(5) - 0.5 * TAU * a * a
        }
    }

    impl Conservative for Jkr {
        fn force(&self, d: f64) -> Option<f64> {
            let a = Self::radius(d);
            Some(2.0 * (a * d - a.powi(3) / 3.0))
        }

        fn work(&self, d: f64) -> Option<f64> {
            Some(Self::energy(d) - Self::energy(0.0))
        }

        fn parting(&self) -> f64 {
            // Just before the turning point, where the branch still has two sides.
            -1.608_772_047
        }

        fn scale(&self) -> f64 {
            1.0
        }
    }

    /// Work to detach from d = 0: 7.092196; e = √(1 − (v_s/v)²), v_s² = 2W/m.
    #[test]
    fn adhesive_ball() {
        let sticking = (2.0 * 7.092_196f64 / 3.0).sqrt();
        for ratio in [1.01, 1.5, 4.0] {
            let seen = conservative(&Impact { mass: 3.0, speed: ratio * sticking }, &Jkr).unwrap();
            let exact = (1.0 - 1.0 / (ratio * ratio)).sqrt();
            // Six digits of W: 1e-7·(v_s/v)²/e².
            assert!((seen.restitution / exact - 1.0).abs() < 1e-5, "{}", seen.restitution);
        }
        assert!(conservative(&Impact { mass: 3.0, speed: 0.99 * sticking }, &Jkr).unwrap().sticks());
    }
}
