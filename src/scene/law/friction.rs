//! The laws of friction as decided.

use crate::contact::state::Tangential;
use crate::drive::machine::RatedMass;
use crate::friction::contact::Interface;
use crate::friction::peeling::ShearedAdhesion;
use crate::friction::{CoulombBed, RateState, TangentialMemory};
use crate::material::Relaxation;
use crate::scene::parts::Component;
use std::num::NonZeroUsize;
use std::sync::Arc;

/// Friction on the pixels of a half-space.
#[derive(Debug, Clone, PartialEq)]
pub enum PixelFriction {
    /// Stick and slip under Coulomb's law, by the memory of turning points.
    Partial {
        /// Coefficient of friction μ.
        coefficient: f64,
    },
    /// Stick and slip under Coulomb's law on every pixel, together with its pressures.
    Coupled {
        /// Coefficient of friction μ.
        coefficient: f64,
    },
    /// Gross sliding under a law that acts on the pressure.
    Gross(Interface),
}

/// Who computes the tangential contact.
#[derive(Debug, Clone, PartialEq)]
pub enum FrictionLaw {
    /// Coulomb friction by the memory of turning points.
    Memory {
        /// Coefficient of friction μ.
        coefficient: f64,
    },
    /// Coulomb friction by springs.
    Springs {
        /// Coefficient of friction μ.
        coefficient: f64,
        /// Number of springs.
        count: NonZeroUsize,
    },
    /// Coulomb friction of viscoelastic bodies, by springs.
    Viscoelastic {
        /// Coefficient of friction μ.
        coefficient: f64,
        /// Number of springs.
        count: NonZeroUsize,
        /// E*(t).
        relaxation: Arc<Relaxation>,
    },
    /// Friction of rate and state of the contact as a whole, in a machine.
    RateState(RateState),
    /// Gross sliding under a law that acts on the pressure.
    Sliding(Interface),
    /// An adhesive contact that sticks until its edge gives way.
    Stuck {
        /// Work of adhesion w [J/m²].
        work: f64,
    },
    /// Sliding of an adhesive contact.
    Peeling {
        /// What slides on what.
        interface: Interface,
        /// Work of adhesion w [J/m²].
        work: f64,
    },
}

impl FrictionLaw {
    pub(in crate::scene) fn piece(&self) -> Component {
        match self {
            Self::Memory { .. } => Component::TurningPoints,
            Self::Springs { .. } => Component::FrictionSprings,
            Self::Viscoelastic { .. } => Component::ViscoelasticFriction,
            Self::RateState(_) => Component::RateState,
            Self::Sliding(_) => Component::Sliding,
            Self::Stuck { .. } | Self::Peeling { .. } => Component::Peeling,
        }
    }

    /// Bytes of state, as far as they are known before the run.
    pub(in crate::scene) fn bytes(&self) -> usize {
        match self {
            // With as many turning points as fit into the first growths of the list.
            Self::Memory { .. } => size_of::<TangentialMemory>() + 8 * TangentialMemory::BYTES_PER_TURN,
            // Depth and slip in the bed; place, depth, slip, loss and way in the map.
            Self::Springs { count, .. } => size_of::<CoulombBed>() + (16 + 40) * count.get(),
            // Known from the run.
            Self::Viscoelastic { .. } => 0,
            Self::RateState(_) => size_of::<RatedMass>(),
            Self::Sliding(_) => size_of::<Tangential>(),
            Self::Stuck { .. } | Self::Peeling { .. } => size_of::<ShearedAdhesion>() + size_of::<Tangential>(),
        }
    }

    /// Coefficient of Coulomb friction.
    #[must_use]
    pub fn coulomb(&self) -> Option<f64> {
        match self {
            Self::Memory { coefficient }
            | Self::Springs { coefficient, .. }
            | Self::Viscoelastic { coefficient, .. } => Some(*coefficient),
            Self::RateState(_) | Self::Sliding(_) | Self::Stuck { .. } | Self::Peeling { .. } => None,
        }
    }

    /// Rate and state of the contact, if they matter.
    #[must_use]
    pub fn rate_state(&self) -> Option<&RateState> {
        match self {
            Self::RateState(law) => Some(law),
            Self::Memory { .. }
            | Self::Springs { .. }
            | Self::Viscoelastic { .. }
            | Self::Sliding(_)
            | Self::Stuck { .. }
            | Self::Peeling { .. } => None,
        }
    }

    /// What slides as a whole.
    #[must_use]
    pub fn interface(&self) -> Option<&Interface> {
        match self {
            Self::Memory { .. }
            | Self::Springs { .. }
            | Self::Viscoelastic { .. }
            | Self::RateState(_)
            | Self::Stuck { .. } => None,
            Self::Sliding(interface) | Self::Peeling { interface, .. } => Some(interface),
        }
    }
}
