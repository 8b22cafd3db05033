//! What the indenter is pressed into.

use crate::shape::Profile;
use std::sync::Arc;

/// An elastic half-space under an indenter: springs of the stiffness 2E* dx under the profile g(x).
///
/// E* effective modulus [Pa] (Popov & Heß 2015, eq. 3.1). Cheap to clone, owned and free of lifetimes.
#[derive(Debug, Clone)]
pub struct HalfSpace {
    profile: Arc<dyn Profile>,
    modulus: f64,
}

impl HalfSpace {
    /// A half-space of the effective modulus `modulus` E* [Pa] under `profile`.
    #[must_use]
    pub fn new(profile: Arc<dyn Profile>, modulus: f64) -> Self {
        Self { profile, modulus }
    }

    /// Profile of the indenter.
    #[must_use]
    pub fn profile(&self) -> &dyn Profile {
        self.profile.as_ref()
    }

    /// Effective modulus E* [Pa].
    #[must_use]
    pub fn modulus(&self) -> f64 {
        self.modulus
    }
}
