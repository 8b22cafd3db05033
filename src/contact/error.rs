//! Why a contact cannot follow what is prescribed.
//!
//! # Examples
//! ```
//! use springbed::contact::error::{ContactError, FrictionError};
//!
//! let why = ContactError::from(FrictionError::Parted { force: -1.0 });
//! assert_eq!(why.to_string(), "the bodies part under the normal force -1e0 N");
//! ```

use super::adhesion::equilibrium::BranchError;
use crate::numerics::root::RootError;

/// Why a contact cannot follow what is prescribed.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum ContactError {
    /// No equilibrium of the elastic contact.
    #[error(transparent)]
    Branch(#[from] BranchError),
    /// The viscoelastic bed ends.
    #[error(transparent)]
    Bed(#[from] BedError),
    /// The plane contact cannot follow.
    #[error(transparent)]
    Plane(#[from] PlaneError),
    /// The contact grows out of a rough line.
    #[error(transparent)]
    Line(#[from] LineTooShort),
    /// A jump of the depth against a dashpot.
    #[error(
        "a jump to the depth {to:e} m would need an infinite force, for the viscosity lets nothing give at once: expected time_s of the first row above zero, or no viscosity"
    )]
    Jump {
        /// Depth after the jump [m].
        to: f64,
    },
    /// No state of the tangential contact.
    #[error(transparent)]
    Friction(#[from] FrictionError),
}

/// Why a bed could not follow.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum BedError {
    /// The contact would become larger than the profile.
    #[error("the contact outgrows the profile at the indentation {indentation:e} m")]
    BeyondProfile {
        /// Indentation [m].
        indentation: f64,
    },
    /// The contact is wider than layers are known.
    #[error(
        "the contact radius of {radius:e} m is beyond {known:e} m, up to which such layers are computed (64 thicknesses of the topmost one; a million under a Paraboloid on a rigid base, not with a Poisson's ratio between some 0.45 and 0.5): expected a smaller load, or Winkler(modulus: …, thickness: …) for so thin a layer"
    )]
    Wide {
        /// Contact radius [m].
        radius: f64,
        /// Radius up to which the layers are known [m].
        known: f64,
    },
    /// The steady state of a line that glides is not found.
    #[error("the steady state of the line at the speed {speed:e} m/s is not found: expected another speed")]
    Unsteady {
        /// Speed [m/s].
        speed: f64,
    },
    /// A liquid flows faster than its edge is pulled.
    #[error(
        "drawn out at {speed:e} m/s the bodies never part: a liquid flows, and at this speed pulls its edge less than holds it: expected a faster speed, or an equilibrium modulus above zero"
    )]
    NeverParts {
        /// Speed [m/s].
        speed: f64,
    },
    /// Wear beyond what numbers hold.
    #[error(
        "wear at this rate cannot be followed, for its numbers are too large: expected a smaller coefficient or a shorter way"
    )]
    Endless,
    /// All of a line yields under less than a force.
    #[error(
        "{force:.4e} N are more than the {most:.4e} N that the hardness bears on all of the line: expected less force, or a larger hardness"
    )]
    Yields {
        /// Normal force [N].
        force: f64,
        /// Largest force [N].
        most: f64,
    },
    /// The contact would become larger than the profile under a force.
    #[error("the contact outgrows the profile under the force {force:e} N")]
    Overloaded {
        /// Normal force [N].
        force: f64,
    },
}

/// Why a plane contact cannot follow.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum PlaneError {
    /// The wave is flat.
    #[error(
        "an indentation of {indentation:e} m is beyond full contact at {full:e} m, where it no longer decides the force: expected Press(to: …)"
    )]
    FullContact {
        /// Indentation asked for [m].
        indentation: f64,
        /// Indentation of full contact [m].
        full: f64,
    },
    /// The contact is wider than the datum.
    #[error("the half width {half_width:e} m of the contact reaches the datum: expected a `datum` well above it")]
    Datum {
        /// Half width [m].
        half_width: f64,
    },
    /// A wavy parabola is followed by its force.
    #[error("the depth of a wavy parabola is known from its force only: expected Press(to: …) or HoldForce(…)")]
    ByForce,
    /// The waves cannot be resolved.
    #[error(transparent)]
    Waves(#[from] ConnectivityError),
}

/// Why no contact was found.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum ConnectivityError {
    /// The deviation is too rough for the Chebyshev series.
    #[error(
        "slope of the roughness is not resolved by {terms} Chebyshev terms over the contact of half width {half_width:e} m: it has kinks or too short waves"
    )]
    NotResolved {
        /// Terms tried.
        terms: usize,
        /// Half width of the contact [m].
        half_width: f64,
    },
    /// No half width carries the load.
    #[error("no balanced contact in one piece carries this load")]
    NoContact,
    /// No centre balances the contact.
    #[error("no centre balances the contact: {0}")]
    NoCentre(#[from] RootError),
}

/// The contact grows out of the line.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error(
    "at an indentation of {indentation:e} m the contact reaches the ends of the rough line: expected a `length` well above {length:e} m"
)]
pub struct LineTooShort {
    /// Indentation [m].
    pub indentation: f64,
    /// Length of the line [m].
    pub length: f64,
}

/// Why a tangential state does not exist.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum FrictionError {
    /// The indentation asks for a contact beyond the end of the profile.
    #[error("the profile ends before the indentation {depth:e} m is reached")]
    BeyondProfile {
        /// Indentation [m].
        depth: f64,
    },
    /// A bed asks for springs beyond the end of the profile.
    #[error("the profile ends before the radius {radius:e} m of the bed")]
    BeyondRadius {
        /// Radius [m].
        radius: f64,
    },
    /// No slide carries the tangential force asked for.
    #[error("a tangential force of {force:e} N is not below the limit of {limit:e} N: the contact slips as a whole")]
    GrossSlip {
        /// Tangential force asked for [N].
        force: f64,
        /// μF [N].
        limit: f64,
    },
    /// The profile ends before the normal force is reached.
    #[error("the profile ends before the normal force {force:e} N is reached")]
    ForceBeyondProfile {
        /// Normal force [N].
        force: f64,
    },
    /// An adhesive contact parts under the normal force alone.
    #[error("the bodies part under the normal force {force:e} N")]
    Parted {
        /// Normal force [N].
        force: f64,
    },
    /// A ball does not move towards the surface.
    #[error("the normal speed before the impact is {speed:e} m/s: it must be above zero")]
    NoApproach {
        /// Normal speed [m/s].
        speed: f64,
    },
    /// A sliding speed outside the table of shear strength.
    #[error(transparent)]
    OutsideTable(#[from] OutsideTable),
    /// The tangential load has peeled an adhesive contact that nothing presses.
    #[error("at the indentation {depth:e} m the tangential load peels the adhesive contact: the bodies part")]
    PeeledAt {
        /// Indentation [m].
        depth: f64,
    },
    /// The tangential load has peeled the adhesive contact.
    #[error("under the normal force {force:e} N the tangential load peels the adhesive contact")]
    Peeled {
        /// Normal force [N].
        force: f64,
    },
}

/// A speed that a table of shear strength does not hold.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error(
    "slides at {speed:e} m/s, outside the table of shear strength: expected a speed from {least:e} to {most:e} m/s"
)]
pub struct OutsideTable {
    /// Speed asked for [m/s].
    pub speed: f64,
    /// Least speed of the table [m/s].
    pub least: f64,
    /// Greatest speed of the table [m/s].
    pub most: f64,
}
