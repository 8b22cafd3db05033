//! The ball that yields as a contact that is driven.

use super::{Dent, YieldingBall};
use crate::contact::adhesion::line::Energy;
use crate::contact::error::ContactError;
use crate::contact::model::{ContactModel, Event, Glance, Loading, Pull, Straight};
use crate::contact::state::Normal;

/// A ball that yields, led through any history of depth and force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlasticContact {
    ball: YieldingBall,
    depth: f64,
    deepest: f64,
}

impl PlasticContact {
    /// Bodies that just touch.
    #[must_use]
    pub fn new(ball: YieldingBall) -> Self {
        Self { ball, depth: 0.0, deepest: 0.0 }
    }

    /// What it is when let go.
    fn dent(&self) -> Dent {
        self.ball.let_go(self.deepest)
    }

    /// Depth [m] at which the bodies touch: that of the dent.
    #[must_use]
    pub fn residual(&self) -> f64 {
        self.dent().residual
    }

    /// Moves to the depth `depth` [m].
    pub fn go_to(&mut self, depth: f64) {
        self.depth = depth;
        self.deepest = self.deepest.max(depth);
    }

    /// Whether it yields as it goes on.
    fn yields(&self) -> bool {
        self.depth >= self.deepest && self.depth > self.ball.yield_depth()
    }
}

impl ContactModel for PlasticContact {
    fn follow(&mut self, piece: &Straight) -> Result<Vec<Event>, ContactError> {
        self.go_to(piece.to);
        Ok(Vec::new())
    }

    fn look(&mut self, piece: &Straight) -> Result<Glance, ContactError> {
        let mut probe = *self;
        probe.go_to(piece.to);
        let dent = probe.dent();
        Ok(Glance { force: dent.force(probe.depth), contact_radius: dent.contact_radius(probe.depth) })
    }

    fn state(&self) -> Normal {
        let dent = self.dent();
        let contact_radius = dent.contact_radius(self.depth);
        let elastic = 2.0 * self.ball.modulus * contact_radius;
        Normal {
            indentation: Some(self.depth),
            force: dent.force(self.depth),
            contact_radius: Some(contact_radius),
            stiffness: if self.yields() { self.ball.plastic_stiffness() } else { elastic },
            stored: Energy { elastic: dent.stored(self.depth), surface: 0.0 },
            dissipated: self.ball.heat(self.deepest),
        }
    }

    fn joined(&self) -> bool {
        self.depth > self.residual()
    }

    fn loading(&self) -> Option<Box<dyn Loading + '_>> {
        self.joined().then(|| Box::new(PlasticLoading { contact: *self }) as Box<dyn Loading>)
    }

    fn copy(&self) -> Box<dyn ContactModel> {
        Box::new(*self)
    }

    fn press(&mut self, pull: &Pull) -> Option<Result<Vec<Event>, ContactError>> {
        let dent = self.dent();
        let again = pull.force <= dent.force(self.deepest);
        self.go_to(if again { dent.depth(pull.force) } else { self.ball.depth(pull.force) });
        Some(Ok(Vec::new()))
    }

    fn last_depth(&self) -> Option<Result<f64, ContactError>> {
        Some(Ok(self.residual()))
    }
}

/// The pressure of a ball that yields.
struct PlasticLoading {
    contact: PlasticContact,
}

impl Loading for PlasticLoading {
    fn contact_radius(&self) -> f64 {
        self.contact.dent().contact_radius(self.contact.depth)
    }

    /// While it yields Hertz's pressure over the undeformed ball, cut off at p_y; let go, Hertz's over the dent.
    fn pressure(&self, r: f64) -> Option<f64> {
        let (ball, a) = (self.contact.ball, self.contact_radius());
        Some(if self.contact.yields() {
            ball.elastic().pressure(r, a).min(ball.limit)
        } else {
            self.contact.dent().pressure(r, a)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::quadrature;
    use std::f64::consts::TAU;

    const BALL: YieldingBall = YieldingBall { radius: 1.0, modulus: 1.0, limit: 0.01 };

    fn pressed(depth: f64) -> PlasticContact {
        let mut contact = PlasticContact::new(BALL);
        contact.follow(&Straight::between(0.0, depth, 1.0)).unwrap();
        contact
    }

    /// The pressure carries the force while it yields and when it is let go.
    #[test]
    fn the_pressure_carries_the_force() {
        let deepest = 7.0 * BALL.yield_depth();
        for depth in [0.6 * BALL.yield_depth(), deepest, 6.5 * BALL.yield_depth()] {
            let mut contact = pressed(depth.max(deepest * f64::from(u8::from(depth > 2.0 * BALL.yield_depth()))));
            contact.follow(&Straight::between(deepest, depth, 1.0)).unwrap();
            let loading = contact.loading().unwrap();
            let a = loading.contact_radius();
            // The pressure has a corner where it is cut off, a² − r² = a_y².
            let corner = (a * a - BALL.yield_depth()).max(0.0).sqrt();
            let ring = |r: f64| TAU * r * loading.pressure(r).unwrap();
            let inner = quadrature::panel(ring, 0.0, corner);
            let outer = quadrature::panel_with_root_ends(|rest, _| ring(corner + rest), a - corner);
            assert!(((inner + outer) / contact.state().force - 1.0).abs() < 1e-10, "{depth}");
        }
    }

    /// Let go and pressed again it comes to the same point, and no energy is lost on the way.
    #[test]
    fn pressed_again_it_is_where_it_was() {
        let deepest = 20.0 * BALL.yield_depth();
        let mut contact = pressed(deepest);
        let there = contact.state();
        // F = 29.5 F_y over √20 times the radius of first yield.
        let residual = (20.0 - 29.5 / 20f64.sqrt()) * BALL.yield_depth();
        contact.follow(&Straight::between(deepest, 0.0, 1.0)).unwrap();
        assert!(
            contact.state().force <= 0.0 && !contact.joined() && (contact.residual() / residual - 1.0).abs() < 1e-12
        );
        contact.follow(&Straight::between(0.0, deepest, 1.0)).unwrap();
        assert_eq!(contact.state(), there);
        let force = 1.3 * there.force;
        contact.press(&Pull { force, slide: 0.0, sliding_speed: 0.0, duration: 1.0 }).unwrap().unwrap();
        assert!((contact.state().force / force - 1.0).abs() < 1e-13);
        assert!((contact.state().indentation.unwrap() / pressed(BALL.depth(force)).depth - 1.0).abs() < 1e-13);
    }
}
