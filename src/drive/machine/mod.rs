//! A contact in a machine: a mass, a spring and a damper on a contact that has a stiffness, a memory and a friction.
//!
//! Along the normal m d̈ + c ḋ + k(d − D) = W − F(d): a mass that swings about a preload, or falls and bounces. Along the
//! surface m ẍ + c ẋ + k(x − X) = −F_x: the far end X of the spring is drawn on, and the mass creeps, sticks and slips. The
//! contact acts back with its own stiffness; it has no mass of its own (all of it moves far below the speed of sound).
//!
//! # Examples
//! ```
//! use springbed::contact::adhesion::line::EdgeLine;
//! use springbed::contact::direct::QuasiStatic;
//! use springbed::contact::foundation::Foundation;
//! use springbed::contact::model::{ContactModel, Straight};
//! use springbed::drive::machine::{Held, Mass, MovedMass, Suspension};
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! // R = E* = m = 1, pressed to d = 1 and let go 1e-5 beside it: ω² = 2E*a/m = 2.
//! let ground = Foundation::new(Arc::new(Paraboloid { radius: Length::new(1.0)? }), 1.0);
//! let mut contact = QuasiStatic::new(EdgeLine::new(ground, 0.0));
//! contact.follow(&Straight::between(0.0, 1.0, 1.0))?;
//! let held = Held { depth: 1.0, push: contact.state().force };
//! let suspension = Suspension { mass: 1.0, stiffness: 0.0, damping: 0.0 };
//! let mut mass = Mass::new(&mut contact, suspension, held, (1.0 + 1e-5, 0.0));
//! let turns = mass.advance(3.0)?;
//! let half = std::f64::consts::PI / 2f64.sqrt();
//! assert!((turns[0].state.time / half - 1.0).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod drawn;
mod mass;
mod rated;
mod sliding;
mod stability;
mod stepped;

pub use drawn::{Drawn, DrawnMoment, DrawnState, SteppedDrawn, Turnover};
pub use mass::{Happening, Mass, MassMoment, MassState};
pub use rated::{RatedMass, RatedState};
pub use stability::{Carried, Threshold, threshold};
pub use stepped::{Creeping, SteppedMachine};

use crate::contact::error::ContactError;
use crate::contact::model::ContactModel;
use crate::contact::state::Tangential;
use crate::input::quantity::{self, Damping, Stiffness};
use serde::{Deserialize, Serialize};

/// Gravity of Earth [m/s²] (CGPM 1901).
pub const GRAVITY: f64 = 9.806_65;

/// The machine of a scene.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Machine {
    /// Mass m [kg]; none of a spring that leads the contact slowly.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mass: Option<quantity::Mass>,
    /// Stiffness k of the spring that holds or draws it [N/m]; none if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stiffness: Option<Stiffness>,
    /// Damping c between the mass and what stands still [N s/m]; none if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub damping: Option<Damping>,
}

impl Machine {
    /// Its mass, spring and damper in SI units; `None` without a mass.
    #[must_use]
    pub fn suspension(&self) -> Option<Suspension> {
        let (mass, stiffness) = (self.mass?.si(), self.stiffness());
        Some(Suspension { mass, stiffness, damping: self.damping.map_or(0.0, Damping::si) })
    }

    /// Stiffness k of its spring [N/m], zero without one.
    #[must_use]
    pub fn stiffness(&self) -> f64 {
        self.stiffness.map_or(0.0, Stiffness::si)
    }
}

/// A mass with its spring and damper.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Suspension {
    /// Mass m [kg], above zero.
    pub mass: f64,
    /// Stiffness k [N/m].
    pub stiffness: f64,
    /// Damping c [N s/m].
    pub damping: f64,
}

/// A mass that moves along the normal, step by step.
pub trait MovedMass {
    /// Where it is.
    fn state(&self) -> MassState;

    /// The contact where the mass is.
    ///
    /// # Errors
    /// The contact cannot follow.
    fn contact(&mut self) -> Result<&dyn ContactModel, ContactError>;

    /// Time [s] from which on it only creeps, if that is told.
    fn creeps_since(&self) -> Option<f64> {
        None
    }

    /// One step towards the time `until` [s]; what happens at its end, before which nothing does.
    ///
    /// # Errors
    /// The contact cannot follow, or the motion is too fast.
    fn step(&mut self, until: f64) -> Result<Option<MassMoment>, MachineError>;
}

/// A mass that a spring draws along the surface, step by step.
pub trait DrawnMass: Send {
    /// Draws on at the speed `speed` [m/s] from now on.
    fn draw(&mut self, speed: f64);

    /// From now on the depth of the contact changes at the speed `speed` [m/s].
    fn lead(&mut self, _speed: f64) {}

    /// On to the time `until` [s], or to the next change between stick and slip, which is told.
    ///
    /// # Errors
    /// The contact cannot follow, or the motion is too fast.
    fn step(&mut self, until: f64) -> Result<Option<DrawnMoment>, MachineError>;

    /// Where it is.
    fn state(&self) -> DrawnState;

    /// Its mass, spring and damper.
    fn suspension(&self) -> Suspension;

    /// State of the contact.
    fn tangential(&self) -> Tangential;

    /// Rate and state of the contact, if its friction has them.
    fn rated(&self) -> Option<RatedState> {
        None
    }

    /// Force of the spring [N].
    fn pull(&self) -> f64 {
        self.suspension().stiffness * self.state().extension
    }

    /// Energy [J] that the springs of friction have lost so far as they relax.
    fn relaxed(&self) -> f64 {
        0.0
    }

    /// Energy [J] of swings that were left out although they had not died down.
    fn left_out(&self) -> f64 {
        0.0
    }
}

/// How the far end of a normal spring is held.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Held {
    /// Depth [m] at which the mass is pushed by `push`.
    pub depth: f64,
    /// Force [N] of spring and weight on the mass at that depth, towards the ground.
    pub push: f64,
}

impl Suspension {
    /// Force [N] of spring and weight on the mass at the depth `depth` [m].
    #[must_use]
    pub fn push(&self, held: Held, depth: f64) -> f64 {
        held.push - self.stiffness * (depth - held.depth)
    }

    /// Kinetic energy [J] at the speed `speed` [m/s].
    #[must_use]
    pub fn kinetic(&self, speed: f64) -> f64 {
        0.5 * self.mass * speed * speed
    }
}

/// Why a machine could not be followed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum MachineError {
    /// The contact cannot follow.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// No step is short enough.
    #[error(
        "at {time:e} s of the entry the motion has no step short enough: its forces are beyond what can be computed with"
    )]
    Stalled {
        /// Time since the beginning of the entry [s].
        time: f64,
    },
    /// The contact lets go by itself.
    #[error(
        "at {time:e} s of the entry the contact lets go by itself, however its mass is held: its stiffness of {stiffness:.3e} N/m is no match for a friction that falls by (b - a)F/D_c = {fall:.3e} N/m, and under the slip law for some times that. In truth a rupture would run through it, where one state says nothing: expected a smaller force, a larger contact, a longer distance or a smaller evolution"
    )]
    Ruptures {
        /// Time since the beginning of the entry [s].
        time: f64,
        /// Stiffness of the contact along the surface [N/m].
        stiffness: f64,
        /// Fall of the friction over the way [N/m].
        fall: f64,
    },
    /// The mass moves too fast for the duration.
    #[error(
        "the motion takes more than {most} steps: at {time:e} s of the entry it is not at its end; expected a shorter `over`, or a damping in which the swings of the mass on the contact die down"
    )]
    TooManySteps {
        /// Most steps that are taken.
        most: usize,
        /// Time since the beginning of the entry [s].
        time: f64,
    },
    /// The mass turns too often for the duration.
    #[error(
        "the mass turns more than {most} times: at {time:e} s of the entry it is not at its end; expected a shorter `over`, a softer spring or a larger mass"
    )]
    TooManyTurns {
        /// Most turns that are followed.
        most: usize,
        /// Time since the beginning of the entry [s].
        time: f64,
    },
}

#[cfg(test)]
mod creeping_tests;
#[cfg(test)]
mod rated_tests;
#[cfg(test)]
mod relaxing_tests;
#[cfg(test)]
mod tests;
