//! A ball that yields: pressed, let go and pressed again, in closed form.
//!
//! The contact is Hertz's until the pressure in its middle reaches p_y; from then on that is the greatest pressure there
//! can be, and the force grows in a straight line. Let go, it is Hertz's again, of the flatter surfaces that the yielding
//! has left (Thornton 1997).
//!
//! # Examples
//! ```
//! use springbed::contact::plastic::YieldingBall;
//!
//! // R = E* = 1, p_y = 0.01: it yields at F_y = π³R²p_y³/6E*² and d_y = π²Rp_y²/4E*².
//! let ball = YieldingBall { radius: 1.0, modulus: 1.0, limit: 0.01 };
//! assert!((ball.yield_depth() / 2.4674011002723e-4 - 1.0).abs() < 1e-12);
//! // Ten times as deep the force has grown in a straight line, and let go, a dent is left.
//! let deepest = 10.0 * ball.yield_depth();
//! let dent = ball.let_go(deepest);
//! assert!((ball.force(deepest) / ball.force(ball.yield_depth()) - 14.5).abs() < 1e-12);
//! assert!(dent.residual > 0.5 * deepest && (dent.force(deepest) / ball.force(deepest) - 1.0).abs() < 1e-12);
//! ```

mod contact;

pub use contact::PlasticContact;

use std::f64::consts::{FRAC_PI_2, PI};

pub use crate::material::YIELD_PRESSURE;

/// A ball on a flat, one of which yields.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct YieldingBall {
    /// Radius R [m].
    pub radius: f64,
    /// Effective modulus E* [Pa].
    pub modulus: f64,
    /// Greatest pressure p_y [Pa], [`YIELD_PRESSURE`] times the yield stress.
    pub limit: f64,
}

impl YieldingBall {
    /// Depth d_y = π²Rp_y²/4E*² [m] at which it yields first.
    #[must_use]
    pub fn yield_depth(&self) -> f64 {
        self.radius * (FRAC_PI_2 * self.limit / self.modulus).powi(2)
    }

    /// Force F_y = π³R²p_y³/6E*² [N] at which it yields first.
    #[must_use]
    pub fn yield_force(&self) -> f64 {
        2.0 / 3.0 * PI * self.radius * self.yield_depth() * self.limit
    }

    /// Speed v_y = √(2W/m) [m/s] at which a ball of the mass `mass` [kg] yields first, W = (2/5)F_yd_y.
    ///
    /// v_y = (π/2E*)²√(8πR³/15m) p_y^{5/2}.
    #[must_use]
    pub fn yield_speed(&self, mass: f64) -> f64 {
        (2.0 * self.yield_work() / mass).sqrt()
    }

    /// Work of first yield [J].
    #[must_use]
    pub fn yield_work(&self) -> f64 {
        0.4 * self.yield_force() * self.yield_depth()
    }

    /// Slope πp_yR [N/m] of the force once it yields.
    #[must_use]
    pub fn plastic_stiffness(&self) -> f64 {
        PI * self.limit * self.radius
    }

    /// Force [N] at the depth `depth` d [m], never pressed as deep before: Hertz, then F_y + πp_yR(d − d_y).
    #[must_use]
    pub fn force(&self, depth: f64) -> f64 {
        match depth - self.yield_depth() {
            beyond if beyond > 0.0 => self.yield_force() + self.plastic_stiffness() * beyond,
            _ => self.elastic().force(depth),
        }
    }

    /// The depth [m] at which a force `force` ≥ 0 [N] is first carried.
    #[must_use]
    pub fn depth(&self, force: f64) -> f64 {
        match force - self.yield_force() {
            beyond if beyond > 0.0 => self.yield_depth() + beyond / self.plastic_stiffness(),
            _ => self.elastic().depth(force),
        }
    }

    /// Work [J] done on the way to the depth `depth` [m], never pressed as deep before.
    #[must_use]
    pub fn work(&self, depth: f64) -> f64 {
        match depth - self.yield_depth() {
            beyond if beyond > 0.0 => {
                self.yield_work() + beyond * (self.yield_force() + 0.5 * self.plastic_stiffness() * beyond)
            }
            _ => self.elastic().stored(depth),
        }
    }

    /// The ball before it yields.
    fn elastic(&self) -> Dent {
        Dent { modulus: self.modulus, radius: self.radius, residual: 0.0 }
    }

    /// What a ball that was pressed to the depth `deepest` [m] is when it is let go and pressed again.
    ///
    /// Hertz's contact of the radius R_p = (4E*/3F_e)[(2F_e + F_y)/2πp_y]^{3/2}, which carries the same force F_e over the
    /// same contact radius √(Rd) (Thornton 1997).
    #[must_use]
    pub fn let_go(&self, deepest: f64) -> Dent {
        if deepest <= self.yield_depth() {
            return self.elastic();
        }
        let (force, square) = (self.force(deepest), self.radius * deepest);
        let radius = 4.0 * self.modulus * square * square.sqrt() / (3.0 * force);
        Dent { modulus: self.modulus, radius, residual: deepest - square / radius }
    }

    /// Energy [J] turned into heat by the first way to the depth `deepest` [m].
    #[must_use]
    pub fn heat(&self, deepest: f64) -> f64 {
        (self.work(deepest) - self.let_go(deepest).stored(deepest)).max(0.0)
    }
}

/// Hertz's contact over the dent that yielding has left.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dent {
    modulus: f64,
    /// Effective radius R_p [m] of the surfaces that it has flattened.
    pub radius: f64,
    /// Depth [m] of the dent, at which the bodies part.
    pub residual: f64,
}

impl Dent {
    /// Contact radius √(R_p(d − d_r)) [m] at the depth `depth` d [m].
    #[must_use]
    pub fn contact_radius(&self, depth: f64) -> f64 {
        (self.radius * (depth - self.residual).max(0.0)).sqrt()
    }

    /// Force (4/3)E*√R_p(d − d_r)^{3/2} [N] at the depth `depth` d [m].
    #[must_use]
    pub fn force(&self, depth: f64) -> f64 {
        4.0 / 3.0 * self.modulus * self.contact_radius(depth) * (depth - self.residual).max(0.0)
    }

    /// Depth [m] at which it carries the force `force` ≥ 0 [N].
    #[must_use]
    pub fn depth(&self, force: f64) -> f64 {
        let third = (0.75 * force.max(0.0) / self.modulus).cbrt();
        self.residual + third * (third / self.radius.cbrt())
    }

    /// Stored energy (2/5)F(d − d_r) [J] at the depth `depth` d [m].
    #[must_use]
    pub fn stored(&self, depth: f64) -> f64 {
        0.4 * self.force(depth) * (depth - self.residual).max(0.0)
    }

    /// Pressure [Pa] at the distance `r` from the axis over the contact radius `a` [m].
    fn pressure(&self, r: f64, a: f64) -> f64 {
        if r >= a { 0.0 } else { 2.0 * self.modulus / (PI * self.radius) * ((a - r) * (a + r)).sqrt() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::quadrature;
    use proptest::prelude::*;

    /// Any ball, and how deep it is pressed over its depth of first yield.
    fn balls() -> impl Strategy<Value = (YieldingBall, f64)> {
        (-60i32..20, 60i32..120, -50i32..0, 0i32..40).prop_map(|(radius, modulus, limit, depth)| {
            let modulus = 10f64.powf(0.1 * f64::from(modulus));
            let limit = modulus * 10f64.powf(-1.0 + 0.1 * f64::from(limit));
            let ball = YieldingBall { radius: 10f64.powf(0.1 * f64::from(radius)), modulus, limit };
            (ball, 10f64.powf(0.1 * f64::from(depth)))
        })
    }

    proptest! {
        /// Work is the integral of the force, and what is not given back is heat; the dent carries the same force over the
        /// same contact, the pressure of first yield is p_y.
        #[test]
        fn the_ledger_closes((ball, parts) in balls()) {
            let (first, deepest) = (ball.yield_depth(), parts * ball.yield_depth());
            let ways = quadrature::panel_with_root_ends(|depth, _| ball.force(depth), first)
                + quadrature::panel(|depth| ball.force(depth), first, deepest);
            prop_assert!((ways / ball.work(deepest) - 1.0).abs() < 1e-12);
            let dent = ball.let_go(deepest);
            let back = quadrature::panel_with_root_ends(|rise, _| dent.force(dent.residual + rise), deepest - dent.residual);
            prop_assert!((ways - back - ball.heat(deepest)).abs() < 1e-11 * ways);
            prop_assert!((dent.force(deepest) / ball.force(deepest) - 1.0).abs() < 1e-12);
            prop_assert!((dent.contact_radius(deepest) / (ball.radius * deepest).sqrt() - 1.0).abs() < 1e-12);
            let peak = ball.elastic().pressure(0.0, (ball.radius * first).sqrt());
            prop_assert!((peak / ball.limit - 1.0).abs() < 1e-13);
            prop_assert!((ball.depth(ball.force(deepest)) / deepest - 1.0).abs() < 1e-13);
            // As Thornton writes the radius.
            let (force, least) = (ball.force(deepest), ball.yield_force());
            let radius = 4.0 * ball.modulus / (3.0 * force) * ((2.0 * force + least) / (2.0 * PI * ball.limit)).powf(1.5);
            prop_assert!((dent.radius / radius - 1.0).abs() < 1e-12);
        }
    }

    /// A limit never reached is Hertz.
    #[test]
    fn without_yield_it_is_hertz() {
        let ball = YieldingBall { radius: 2.0, modulus: 3.0, limit: 1e3 };
        assert!((ball.force(0.1) - 4.0 * 2f64.sqrt() * 0.1f64.powf(1.5)).abs() < 1e-15 && ball.heat(0.1) <= 0.0);
        assert!(ball.let_go(0.1).residual <= 0.0);
    }
}
