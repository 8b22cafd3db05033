//! Tangential contact: stick, slip, dissipation, adhesion under shear, sliding, oblique impact.

pub mod bed;
mod driven;
pub mod fretting;
pub mod peeling;
pub mod relaxing;
pub mod sliding;
pub mod oblique;
mod load;
mod slipped;
pub mod strength;
pub mod state;
pub mod turning;

pub use bed::CoulombBed;
pub use driven::chords;
pub use fretting::{FrettingMap, WearMap};
pub use relaxing::RelaxingBed;
pub use strength::{Strength, StrengthCurve};
pub use turning::{Grip, Pose, TangentialMemory, TangentialState};

use crate::input::quantity::{Modulus, Ratio};
use serde::{Deserialize, Serialize};

/// Law of friction.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
pub enum Friction {
    /// Slip where the tangential load of a spring reaches μ times its normal load.
    Coulomb(Coulomb),
    /// τ = min(μp, τ_max) in gross sliding (Ceglie et al., eq. 6).
    CoulombOrowan(CoulombOrowan),
    /// τ = τ_c + βp in gross sliding (Persson et al. 2008, eq. 3).
    Pressure(PressureLaw),
}

impl Friction {
    /// The name a scene gives it.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Coulomb(_) => "Coulomb",
            Self::CoulombOrowan(_) => "CoulombOrowan",
            Self::Pressure(_) => "Pressure",
        }
    }

    /// How a contact slips under it.
    #[must_use]
    pub fn slip(&self) -> Slip<'_> {
        match self {
            Self::Coulomb(law) => Slip::Local(law),
            Self::CoulombOrowan(_) | Self::Pressure(_) => Slip::Gross,
        }
    }
}

/// How a contact slips.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Slip<'f> {
    /// Spring by spring, from the edge inwards.
    Local(&'f Coulomb),
    /// Everywhere at once.
    Gross,
}

/// Coulomb friction.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Coulomb {
    /// Coefficient of friction μ.
    pub coefficient: Ratio,
}

/// Coulomb friction with a cap on the shear stress.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct CoulombOrowan {
    /// Coefficient of friction μ.
    pub coefficient: Ratio,
    /// Largest shear stress τ_max [Pa].
    pub shear_limit: Modulus,
}

/// Shear stress that grows linearly with the pressure.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct PressureLaw {
    /// Shear stress τ_c at zero pressure [Pa], or its table over the sliding speed.
    pub shear: Strength,
    /// Slope β.
    pub slope: Ratio,
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
    OutsideTable(#[from] strength::OutsideTable),
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
