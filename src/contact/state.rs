//! States of a contact.
//!
//! # Examples
//! ```
//! use springbed::contact::adhesion::line::Energy;
//! use springbed::contact::state::Normal;
//!
//! // What does not exist is absent, not zero: parted bodies have no indentation.
//! let stored = Energy { elastic: 3.0, surface: -1.0 };
//! let parted = Normal { stored, ..Normal::default() };
//! assert!(parted.indentation.is_none() && parted.stored.stored() == 2.0);
//! ```

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

impl Normal {
    /// Energy stored and lost [J].
    #[must_use]
    pub fn accounted(&self) -> f64 {
        self.stored.stored() + self.dissipated
    }

    /// The forces [N] that hold each other in balance in an adhesive contact: the force itself, or where that is small
    /// √(2U k), with U the elastic energy, but no more than that of the surface, for what is left of an earlier contact
    /// around this one holds nothing. Zero where nothing attracts.
    #[must_use]
    pub fn in_balance(&self) -> f64 {
        if self.stored.surface >= 0.0 {
            return 0.0;
        }
        let energy = self.stored.elastic.min(-self.stored.surface).max(0.0);
        self.force.abs().max((2.0 * energy * self.stiffness).sqrt())
    }
}

/// State of the tangential contact at one time.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Tangential {
    /// Tangential displacement of the indenter [m].
    pub slide: f64,
    /// Tangential force [N].
    pub force: f64,
    /// Radius of the sticking part of the contact [m].
    pub stick_radius: f64,
    /// Tangential stiffness dF_x/du_x [N/m] while the slide goes on.
    pub stiffness: f64,
    /// Elastic energy of the tangential deformation [J], if it is known.
    pub stored: Option<f64>,
    /// Energy lost to friction so far [J], if it is told apart from other losses.
    pub dissipated: Option<f64>,
    /// Area of a sheared adhesive contact over its area without shear, A/A_JKR.
    pub area_ratio: Option<f64>,
}

/// What of a pad of many springs or summits is joined.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Joined {
    /// Share of them.
    pub share: f64,
    /// Area of contact [m²] of summits.
    pub area: Option<f64>,
}

/// Where a gliding contact is, and what holds it back.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gliding {
    /// Way it has glided [m].
    pub slide: f64,
    /// Force against the motion F_x [N].
    pub resistance: f64,
    /// Where the contact begins, from the middle of the body in the direction of its motion [m].
    pub leading_edge: Option<f64>,
    /// Where it ends [m]; behind the middle it is negative.
    pub trailing_edge: Option<f64>,
}
