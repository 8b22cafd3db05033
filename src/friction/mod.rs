//! Tangential contact: stick, slip, dissipation, adhesion under shear, sliding, oblique impact.
//!
//! # Examples
//! ```
//! use springbed::friction::{Grip, Pose, TangentialMemory};
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use std::sync::Arc;
//!
//! // R = E* = G* = d = 1, μ = 0.3, slid by 0.225: sticks inside a/2, F_x = (1 − (c/a)³)μF (Cattaneo & Mindlin).
//! let ball = Paraboloid { radius: Length::new(1.0)? };
//! let grip = Grip { normal_modulus: 1.0, tangential_modulus: 1.0, coefficient: 0.3 };
//! let mut contact = TangentialMemory::new(Arc::new(ball), grip);
//! contact.advance(Pose { indentation: 1.0, slide: 0.0 })?;
//! contact.advance(Pose { indentation: 1.0, slide: 0.225 })?;
//! let state = contact.state();
//! assert!((state.stick_radius - 0.5).abs() < 1e-14 && (state.tangential_force - 0.4 * 0.875).abs() < 1e-14);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod bed;
pub mod contact;
mod driven;
pub mod fretting;
pub mod peeling;
pub mod viscoelastic;
pub mod sliding;
pub mod rate_state;
pub mod rolling;
pub mod oblique;
pub mod load;
mod slipped;
pub mod strength;
pub mod turning;

pub use crate::contact::error::FrictionError;
pub use bed::CoulombBed;
pub use driven::chords;
pub use fretting::{FrettingMap, WearMap};
pub use rate_state::{RateState, SlipRate, StateLaw};
pub use strength::{Strength, StrengthCurve};
pub use turning::{Branch, Corner, Grip, Pose, PowerBranch, TangentialMemory, TangentialState};
pub use viscoelastic::ViscoelasticBed;

use crate::input::quantity::{Modulus, Ratio};
use serde::{Deserialize, Serialize};

/// Law of friction.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
pub enum Friction {
    /// Slip where the tangential load of a spring reaches μ times its normal load.
    Coulomb(Coulomb),
    /// Coulomb's law with a coefficient that falls as the contact begins to slide as a whole.
    StaticKinetic(StaticKinetic),
    /// Friction that depends on the rate of slip and on a state of the contact (Dieterich 1979; Ruina 1983).
    RateState(RateState),
    /// The contact sticks everywhere until its adhesive edge gives way (Savkoor & Briggs 1977).
    Stuck,
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
            Self::StaticKinetic(_) => "StaticKinetic",
            Self::RateState(_) => "RateState",
            Self::Stuck => "Stuck",
            Self::CoulombOrowan(_) => "CoulombOrowan",
            Self::Pressure(_) => "Pressure",
        }
    }

    /// How a contact slips under it.
    #[must_use]
    pub fn slip(&self) -> Slip {
        match self {
            Self::Coulomb(law) => Slip::Local(law.coefficient.si()),
            Self::StaticKinetic(law) => Slip::Local(law.r#static.si()),
            Self::RateState(law) => Slip::Local(law.coefficient.si()),
            Self::Stuck => Slip::Nowhere,
            Self::CoulombOrowan(_) | Self::Pressure(_) => Slip::Gross,
        }
    }
}

/// How a contact slips.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Slip {
    /// Spring by spring, from the edge inwards, with the coefficient μ.
    Local(f64),
    /// Everywhere at once.
    Gross,
    /// Nowhere.
    Nowhere,
}

/// Coulomb friction.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Coulomb {
    /// Coefficient of friction μ.
    pub coefficient: Ratio,
}

/// Coulomb friction of a contact that is held by more than it is slowed down.
///
/// Springs slip one by one at μ_s times their load. Once all slip, the contact slides as a whole and each of them
/// carries μ_k times its load, until the mass comes to rest and the contact sticks again.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct StaticKinetic {
    /// Coefficient of static friction μ_s.
    pub r#static: Ratio,
    /// Coefficient of kinetic friction μ_k, at most μ_s.
    pub kinetic: Ratio,
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
