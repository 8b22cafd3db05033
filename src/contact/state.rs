//! State of a normal contact.

use super::adhesion::line::Energy;

/// State of the normal contact. A value that does not exist is `None`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Normal {
    /// Indentation d [m]; `None` after the bodies have parted under a prescribed force.
    pub indentation: Option<f64>,
    /// Normal force F [N], compression positive.
    pub force: f64,
    /// Contact radius a [m]; `None` for a rough bed, which does not know its contact area.
    pub contact_radius: Option<f64>,
    /// Contact stiffness dF/dd, 2E*a of a round contact [N/m].
    pub stiffness: f64,
    /// Stored energy [J] by part.
    pub stored: Energy,
    /// Energy lost so far in the normal motion [J].
    pub dissipated: f64,
}
