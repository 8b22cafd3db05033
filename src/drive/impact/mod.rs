//! Impact of a mass on an elastic, adhesive or viscoelastic half-space.
//!
//! The mass is free, m d̈ = −F, and the contact follows it without inertia of its own. Of elastic
//! bodies energy alone gives the motion, jump by jump ([`Passage`]), on a rough line from spring to spring ([`SpringPassage`]); a
//! viscoelastic body remembers, and its bed is driven step by step ([`StruckHalfSpace`]). Any other contact is driven in
//! straight pieces ([`SteppedMass`]).
//!
//! # Examples
//! ```
//! use springbed::contact::adhesion::line::EdgeLine;
//! use springbed::contact::direct::QuasiStatic;
//! use springbed::drive::impact::{Passage, Projectile, SteppedMass};
//! use springbed::contact::foundation::Foundation;
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! // R = E* = m = v = 1: contact time 2.943275 (15/16)^{2/5} by energy, and in steps on any contact.
//! let ground = Foundation::new(Arc::new(Paraboloid { radius: Length::new(1.0)? }), 1.0);
//! let mut contact = QuasiStatic::new(EdgeLine::new(ground, 0.0));
//! let impact = Projectile { mass: 1.0, speed: 1.0 };
//! let exact = Passage::new(&contact, impact, 1e-9)?.rebound().contact_time.unwrap();
//! assert!((exact / (2.943_275_184_324_705 * 0.9375f64.powf(0.4)) - 1.0).abs() < 1e-9);
//! let stepped = SteppedMass { impact, time: 3.0, steps: 60.0 }.rebound(&mut contact)?.contact_time.unwrap();
//! assert!((stepped / exact - 1.0).abs() < 1e-3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod driven;
mod passage;
mod plastic;
mod springs;
mod stepped;

pub use driven::{Flight, StruckHalfSpace};
pub use passage::Passage;
pub use plastic::PlasticPassage;
pub use springs::SpringPassage;
pub use stepped::{SteppedMass, Watcher, force_at, led_on};

use crate::contact::adhesion::equilibrium::BranchError;
use crate::contact::adhesion::line::Energy;
use crate::contact::error::{BedError, ContactError};

/// A mass that meets the half-space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Projectile {
    /// Mass m [kg].
    pub mass: f64,
    /// Speed v [m/s] as the bodies first act on each other.
    pub speed: f64,
}

impl Projectile {
    /// Kinetic energy ½mv² [J].
    #[must_use]
    pub fn energy(&self) -> f64 {
        0.5 * self.mass * self.speed * self.speed
    }
}

/// What comes of an impact.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Rebound {
    /// Contact time [s]; `None` if the bodies stay together.
    pub contact_time: Option<f64>,
    /// Greatest depth [m].
    pub greatest_depth: f64,
    /// Greatest force [N].
    pub greatest_force: f64,
    /// Restitution coefficient e = rebound speed/v, zero if the bodies stay together.
    pub restitution: f64,
    /// Kinetic energy not given back [J]: turned into heat, or kept by bodies that stay together or by a surface
    /// that still creeps back.
    pub lost: f64,
    /// Estimate of the relative error of what stands above.
    pub error: f64,
}

impl Rebound {
    /// Whether the bodies stay together.
    #[must_use]
    pub fn sticks(&self) -> bool {
        self.contact_time.is_none()
    }

    /// What runs with twice as long steps, `coarse`, and with these lead to as the steps get short, of an error of second
    /// order.
    #[must_use]
    pub fn extrapolated(&self, coarse: &Self) -> Self {
        let limit = |fine: f64, coarse: f64| fine + (fine - coarse) / 3.0;
        let contact_time = self.contact_time.zip(coarse.contact_time).map(|(fine, coarse)| limit(fine, coarse));
        Self {
            contact_time: contact_time.or(self.contact_time),
            greatest_depth: limit(self.greatest_depth, coarse.greatest_depth),
            greatest_force: limit(self.greatest_force, coarse.greatest_force),
            restitution: limit(self.restitution, coarse.restitution).max(0.0),
            lost: limit(self.lost, coarse.lost),
            error: self.error,
        }
    }

    /// Largest difference of restitution, and relative ones of contact time, depth and force.
    #[must_use]
    pub fn difference(&self, other: &Self) -> f64 {
        let relative = |x: f64, y: f64| (x - y).abs() / x.abs().max(y.abs()).max(f64::MIN_POSITIVE);
        let times = self.contact_time.zip(other.contact_time).map_or(0.0, |(x, y)| relative(x, y));
        (self.restitution - other.restitution)
            .abs()
            .max(times)
            .max(relative(self.greatest_depth, other.greatest_depth))
            .max(relative(self.greatest_force, other.greatest_force))
    }
}

/// State of an impact at one time.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ImpactState {
    /// Time since the bodies first act on each other [s].
    pub time: f64,
    /// Depth [m].
    pub depth: f64,
    /// Speed towards the half-space [m/s].
    pub speed: f64,
    /// Force [N].
    pub force: f64,
    /// Contact radius [m].
    pub radius: f64,
    /// Stored energy [J].
    pub stored: Energy,
    /// Energy turned into heat so far [J].
    pub dissipated: f64,
}

/// Why an impact could not be followed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum ImpactError {
    /// The kinetic energy carries the contact beyond the end of its profile.
    #[error("the impact drives the contact beyond the profile: {energy:e} J of kinetic energy are left at its end")]
    BeyondProfile {
        /// Kinetic energy [J].
        energy: f64,
    },
    /// The contact has no equilibrium on the way.
    #[error(transparent)]
    Branch(#[from] BranchError),
    /// The viscoelastic bed ends.
    #[error(transparent)]
    Bed(#[from] BedError),
    /// The contact cannot follow.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// The motion takes more steps than there are.
    #[error("the impact comes to no end: the shortest and the longest time of the bed are too far apart for its steps")]
    NoEnd,
}
