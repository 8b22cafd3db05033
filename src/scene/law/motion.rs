//! What a machine and wear do to a contact, as decided.

use super::friction::FrictionLaw;
use crate::drive::machine::Suspension;
use crate::scene::history::{MachineEntry, MachineMotion};

/// The machine of a contact, and what it does behind the rest of the history.
#[derive(Debug, Clone, PartialEq)]
pub struct MachineLaw {
    /// Mass, spring and damper.
    pub suspension: Suspension,
    /// What is left of the friction of a contact that is about to slide once it slides as a whole, μ_k/μ_s.
    pub left: f64,
    /// Its motions, in order.
    pub motions: Vec<MachineEntry>,
}

impl MachineLaw {
    /// What it adds to the reason for a solver.
    pub(in crate::scene) fn in_words(&self, friction: Option<&FrictionLaw>) -> &'static str {
        if self.is_along() && friction.and_then(FrictionLaw::rate_state).is_some() {
            "; the mass of the machine is led by its spring and a contact that gives with the stiffness 2G*a and slips as a whole, with one state: extrapolated implicit steps in the logarithms of speed and state, without events"
        } else if self.is_along() && matches!(friction, Some(FrictionLaw::Viscoelastic { .. })) {
            "; the mass of the machine is led by its spring and springs of friction exact in time, under the depth or the force that the history has left: straight steps in balance of energies, which end where a slip begins or ends"
        } else if self.is_along() {
            "; the mass of the machine is led by its spring and the memory of friction: extrapolated steps while the contact sticks, in closed form while it slides as a whole, each end of a slip to rounding"
        } else {
            "; the mass of the machine swings on the contact in extrapolated steps, which end where it touches, parts or turns"
        }
    }

    /// Whether its mass falls.
    #[must_use]
    pub fn falls(&self) -> bool {
        self.motions.iter().any(|motion| matches!(motion.motion, MachineMotion::Fall { .. }))
    }

    /// Whether it moves the mass along the surface.
    #[must_use]
    pub fn is_along(&self) -> bool {
        self.motions.iter().any(|motion| motion.motion.is_along())
    }
}

/// How the indenter wears.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WearLaw {
    /// Volume worn per path and normal force, k_w [m²/N].
    pub coefficient: f64,
    /// Cells per contact radius.
    pub cells: usize,
}

impl WearLaw {
    /// Cells of the width h err by (h/a)² times 0.1 or less, but for the edge.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped before")]
    pub(in crate::scene) fn new(coefficient: f64, accuracy: f64) -> Self {
        Self { coefficient, cells: (0.1 / accuracy.sqrt()).ceil().clamp(24.0, 256.0) as usize }
    }

    /// What it adds to the reason for a solver.
    pub(in crate::scene) fn in_words(self) -> String {
        format!(
            "; from the first slide on the profile wears: {} cells per contact radius and as many rings of the surface, joined by one matrix, in stable explicit steps chosen by their error, each of which costs the square of the cells",
            self.cells
        )
    }
}
