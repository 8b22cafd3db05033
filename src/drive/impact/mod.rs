//! Impact of a mass on an elastic, adhesive or viscoelastic half-space.
//!
//! The mass is free, m d̈ = −F, and the contact follows it without inertia of its own. Of elastic
//! bodies energy alone gives the motion, jump by jump ([`Passage`]); a viscoelastic body remembers,
//! and its bed is driven step by step ([`StruckHalfSpace`]). Any other contact is driven in straight pieces ([`SteppedMass`]).

mod driven;
mod passage;
mod stepped;

pub use driven::{Flight, StruckHalfSpace};
pub use passage::Passage;
pub use stepped::SteppedMass;

use crate::contact::adhesion::equilibrium::BranchError;
use crate::contact::adhesion::line::Energy;
use crate::contact::error::BedError;

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

    /// Largest difference of restitution, and relative ones of contact time, depth and force.
    fn difference(&self, other: &Self) -> f64 {
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
#[derive(Debug, Clone, Copy, PartialEq)]
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
    /// The motion takes more steps than there are.
    #[error("the impact comes to no end: the shortest and the longest time of the bed are too far apart for its steps")]
    NoEnd,
}
