//! State of a tangential contact.

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
