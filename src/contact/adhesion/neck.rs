//! The neck of an attraction of finite range, at a prescribed depth.
//!
//! # Examples
//! ```
//! use springbed::contact::adhesion::range::RangeDisc;
//! use springbed::contact::foundation::Foundation;
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! let ground = Foundation::new(Arc::new(Paraboloid { radius: Length::new(1.0)? }), 1.0);
//! let disc = RangeDisc::new(ground, 1.0, 2.0)?;
//! // From the state that reaches to 1.5 on to the depth of the one that reaches to 1.6.
//! let (near, there) = (disc.neck_at(1.5).unwrap(), disc.at(1.6));
//! let found = disc.neck_near(near, there.indentation).unwrap();
//! assert!((found.reach - 1.6).abs() < 1e-12);
//! assert!((disc.felt(found).force - there.force).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::equilibrium::{Control, Equilibrium};
use super::range::{RangeDisc, versine};
use std::f64::consts::{FRAC_2_PI, PI};

/// A neck a < x < c, with a = c cos φ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Neck {
    /// c [m].
    pub reach: f64,
    /// φ.
    pub angle: f64,
}

/// A force and its slopes at a prescribed depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Felt {
    /// Force [N].
    pub force: f64,
    /// Slopes in E* [m²], in the work of adhesion [m], in the attractive stress [m²] and in the depth [N/m].
    pub slopes: [f64; 4],
}

/// The most steps of Newton's rule.
const STEPS: usize = 12;
/// Relative step behind which the next is lost in rounding, for each is about the square of the one before it.
const CLOSE: f64 = 1e-10;

/// What the slopes of both conditions are made of, the gap h(c) = w/σ₀ and the depth g(a) − ρc sin φ = d with ρ = 2σ₀/E*:
/// ∂h/∂φ = (2/π)φQ and ∂d/∂φ = −Q, all of them with φ or c kept.
struct Conditions {
    /// h(c) [m].
    gap: f64,
    /// d [m].
    depth: f64,
    /// Q = c(g′ sin φ + ρ cos φ) [m].
    by_angle: f64,
    /// ∂d/∂c = g′ cos φ − ρ sin φ.
    depth_by_reach: f64,
    /// ∂h/∂c + (2/π)φ ∂d/∂c = (2/π)[∫₀^φ g′(c cos ψ) cos ψ dψ − ρ(1 − cos φ)]: the slope of d in c along the equilibrium, by
    /// a factor; above zero where the state is stable.
    growth: f64,
}

impl RangeDisc {
    /// The neck that reaches to `c` [m]; `None` before the bodies touch.
    #[must_use]
    pub fn neck_at(&self, c: f64) -> Option<Neck> {
        (c > self.touch()).then(|| Neck { reach: c, angle: self.neck(c) })
    }

    /// The neck at the indentation `d` [m] by Newton's rule from one near to it; `None` where it is not found so.
    ///
    /// Holds for profiles without a kink.
    #[must_use]
    pub fn neck_near(&self, near: Neck, d: f64) -> Option<Neck> {
        let mut neck = near;
        for _ in 0..STEPS {
            let at = self.conditions(neck);
            let (gap, depth) = (at.gap - self.range(), at.depth - d);
            let reach = -(gap + FRAC_2_PI * neck.angle * depth) / at.growth;
            let angle = (depth + at.depth_by_reach * reach) / at.by_angle;
            neck = Neck { reach: neck.reach + reach, angle: neck.angle + angle };
            let inside = neck.reach > self.touch() && neck.reach <= self.end() && neck.angle > 0.0;
            if !inside || neck.angle > 0.5 * PI {
                return None;
            }
            if reach.abs() <= CLOSE * neck.reach && angle.abs() <= CLOSE * neck.angle {
                return Some(neck);
            }
        }
        None
    }

    fn conditions(&self, neck: Neck) -> Conditions {
        let Neck { reach: c, angle: phi } = neck;
        let ((sine, cosine), ratio) = (phi.sin_cos(), self.ratio());
        let profile = self.ground().profile();
        let slope = profile.reduced_slope(c * cosine);
        let grown = self.over_neck(c, phi, |x, psi| profile.reduced_slope(x) * psi.cos());
        Conditions {
            gap: self.gap(c, phi),
            depth: profile.reduced(c * cosine) - ratio * c * sine,
            by_angle: c * (slope * sine + ratio * cosine),
            depth_by_reach: slope * cosine - ratio * sine,
            growth: FRAC_2_PI * (grown - ratio * versine(phi)),
        }
    }

    /// The force of a neck, and how it changes with the bodies and the depth.
    #[must_use]
    pub fn felt(&self, neck: Neck) -> Felt {
        let Neck { reach: c, angle: phi } = neck;
        let ((sine, cosine), at) = (phi.sin_cos(), self.conditions(neck));
        let (profile, modulus, stress) = (self.ground().profile(), self.ground().modulus(), self.stress());
        let a = c * cosine;
        let (load, slope) = (profile.load_integral(a), profile.reduced_slope(a));
        let pulled = 2.0 * c * c * (sine * cosine + phi);
        let by_reach = 2.0 * modulus * a * slope * cosine - 2.0 * stress * pulled / c;
        let by_angle = -2.0 * modulus * a * slope * c * sine - 4.0 * stress * (c * cosine).powi(2);
        // What the force does if the conditions grow by these: gap less range, and depth less d.
        let follows = |gap: f64, depth: f64| {
            let reach = -(gap + FRAC_2_PI * phi * depth) / at.growth;
            by_reach * reach + by_angle * (depth + at.depth_by_reach * reach) / at.by_angle
        };
        let by_ratio = (FRAC_2_PI * c * (phi * sine - versine(phi)) * self.ratio(), -c * sine * self.ratio());
        Felt {
            force: 2.0 * modulus * load - stress * pulled,
            slopes: [
                2.0 * load + follows(-by_ratio.0 / modulus, -by_ratio.1 / modulus),
                follows(-1.0 / stress, 0.0),
                -pulled + follows((by_ratio.0 + self.range()) / stress, by_ratio.1 / stress),
                follows(0.0, -1.0),
            ],
        }
    }

    /// The same before the bodies touch, d = f(c) − (2/π)ρc − w/σ₀ and F = −πσ₀c².
    #[must_use]
    pub fn felt_before_touch(&self, c: f64) -> Felt {
        let (modulus, stress, drawn) = (self.ground().modulus(), self.stress(), FRAC_2_PI * self.ratio() * c);
        let rate = -2.0 * PI * stress * c / self.slope(Control::Indentation, c);
        Felt {
            force: -PI * stress * c * c,
            slopes: [
                -rate * drawn / modulus,
                rate / stress,
                -PI * c * c + rate * (drawn - self.range()) / stress,
                rate,
            ],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::foundation::Foundation;
    use crate::input::quantity::Length;
    use crate::shape::{Paraboloid, Sphere};
    use std::sync::Arc;

    fn disc((modulus, work, stress): (f64, f64, f64)) -> RangeDisc {
        let ground = Foundation::new(Arc::new(Paraboloid { radius: Length::new(1.0).unwrap() }), modulus);
        RangeDisc::new(ground, work, stress).unwrap()
    }

    /// Of both sides of first touch and of ranges from long to short: against central differences at one depth, whose
    /// truncation is h²/6 of third slopes and whose rounding is 1e-15 over h.
    #[test]
    fn slopes_are_those_of_differences() {
        let h = 1e-5;
        for stress in [0.3, 2.0, 20.0] {
            let here = (1.0, 1.0, stress);
            let now = disc(here);
            for neck in [1.2, 1.6, 3.0].map(|times| now.neck_at(times * now.touch()).unwrap()) {
                let d = now.value(Control::Indentation, neck.reach);
                let at = |(modulus, work, stress), d| {
                    let disc = disc((modulus, work, stress));
                    disc.felt(disc.neck_near(neck, d).unwrap()).force
                };
                let moved = |k: usize, by: f64| match k {
                    0 => at((1.0 + by, 1.0, stress), d),
                    1 => at((1.0, 1.0 + by, stress), d),
                    2 => at((1.0, 1.0, stress + by), d),
                    _ => at(here, d + by),
                };
                let felt = now.felt(neck);
                assert!((felt.force - now.value(Control::Force, neck.reach)).abs() < 1e-12 * felt.force.abs().max(1.0));
                for (k, slope) in felt.slopes.into_iter().enumerate() {
                    let by = (moved(k, h) - moved(k, -h)) / (2.0 * h);
                    assert!((slope - by).abs() < 1e-7 * (1.0 + by.abs()), "{stress} {k} {neck:?}: {slope} {by}");
                }
            }
        }
    }

    /// c of d = c²/2R − (2/π)ρc − w/σ₀ on the rising branch, in closed form.
    #[test]
    fn slopes_before_touch() {
        let (h, d) = (1e-5, -3.3);
        let reach = |(modulus, work, stress): (f64, f64, f64), d: f64| {
            let ratio = FRAC_2_PI * 2.0 * stress / modulus;
            ratio + (ratio * ratio + 2.0 * (d + work / stress)).sqrt()
        };
        let force = |of: (f64, f64, f64), d: f64| -PI * of.2 * reach(of, d).powi(2);
        let here = (1.0, 1.0, 0.3);
        let felt = disc(here).felt_before_touch(reach(here, d));
        let moved = |k: usize, by: f64| match k {
            0 => force((1.0 + by, 1.0, 0.3), d),
            1 => force((1.0, 1.0 + by, 0.3), d),
            2 => force((1.0, 1.0, 0.3 + by), d),
            _ => force(here, d + by),
        };
        assert!((felt.force - force(here, d)).abs() < 1e-13);
        for (k, slope) in felt.slopes.into_iter().enumerate() {
            let by = (moved(k, h) - moved(k, -h)) / (2.0 * h);
            assert!((slope - by).abs() < 1e-6 * (1.0 + by.abs()), "{k}: {slope} {by}");
        }
    }

    #[test]
    fn a_ball_is_followed_as_its_equilibrium() {
        let ground = Foundation::new(Arc::new(Sphere { radius: Length::new(1.0).unwrap() }), 100.0);
        let disc = RangeDisc::new(ground, 1.0, 20.0).unwrap();
        let mut neck = disc.neck_at(1.5 * disc.touch()).unwrap();
        for k in 0..20 {
            let c = disc.touch() * (1.5 + 0.02 * f64::from(k));
            neck = disc.neck_near(neck, disc.value(Control::Indentation, c)).unwrap();
            assert!((neck.reach / c - 1.0).abs() < 1e-11, "{c}: {neck:?}");
        }
    }
}
