//! A plan in words: who computes the scene, why, and from which parts.
//!
//! # Examples
//! ```
//! # #[cfg(feature = "text")] {
//! use springbed::prelude::*;
//!
//! let text = r#"(shape: Paraboloid(radius: 1), bodies: (Elastic(young: 1, poisson: 0), Rigid),
//!     history: [Indent(to: 1, over: 1)])"#;
//! let plan = Notation::Ron.plan(text, &InMemory::default()).map_err(|errors| errors[0].clone())?;
//! // An elastic ball is computed without a single spring, and without adhesion or friction.
//! let parts = plan.parts();
//! assert_eq!(parts.springs, 0);
//! assert!(parts.left_out.contains(&"adhesion of vanishing range (JKR)"));
//! # }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use serde::Serialize;

/// What a scene needs and what it leaves out.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Parts {
    /// The solver.
    pub solver: &'static str,
    /// Why this one.
    pub reason: String,
    /// Parts used.
    pub used: Vec<&'static str>,
    /// Parts left out.
    pub left_out: Vec<&'static str>,
    /// Number of springs allocated.
    pub springs: usize,
    /// Bytes of state.
    pub state_bytes: usize,
}

/// A part of the computation of a round contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Component {
    Profile,
    VanishingRange,
    Outside,
    FiniteRange,
    Prony,
    TurningPoints,
    FrictionSprings,
    ViscoelasticFriction,
    RateState,
    Sliding,
    Peeling,
    Wear,
    Springs,
    Gliding,
    Rolling,
    Machine,
    LedBySpring,
}

impl Component {
    const ALL: [Self; 17] = [
        Self::Profile,
        Self::VanishingRange,
        Self::Outside,
        Self::FiniteRange,
        Self::Prony,
        Self::TurningPoints,
        Self::FrictionSprings,
        Self::ViscoelasticFriction,
        Self::RateState,
        Self::Sliding,
        Self::Peeling,
        Self::Wear,
        Self::Springs,
        Self::Gliding,
        Self::Rolling,
        Self::Machine,
        Self::LedBySpring,
    ];

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Profile => "one-dimensional profile g(x)",
            Self::VanishingRange => "adhesion of vanishing range (JKR)",
            Self::Outside => "attraction outside the contact (DMT)",
            Self::FiniteRange => "adhesion of finite range (Maugis–Dugdale)",
            Self::Prony => "Prony elements",
            Self::TurningPoints => "stick and slip by turning points",
            Self::FrictionSprings => "stick and slip by springs",
            Self::ViscoelasticFriction => "stick and slip by relaxing springs",
            Self::RateState => "friction of rate and state",
            Self::Sliding => "gross sliding on the pressure",
            Self::Peeling => "peeling under shear",
            Self::Wear => "wear of the profile (Archard)",
            Self::Springs => "springs",
            Self::Gliding => "springs under a body that moves along",
            Self::Rolling => "rolling with traction",
            Self::Machine => "mass of a machine",
            Self::LedBySpring => "spring of a machine in series",
        }
    }
}

impl Parts {
    pub(super) fn new(solver: Solver, used: Vec<&'static str>, left_out: Vec<&'static str>) -> Self {
        Self { solver: solver.name, reason: solver.reason, used, left_out, springs: 0, state_bytes: 0 }
    }

    /// Those of a round contact.
    pub(super) fn round(solver: Solver, used: &[Component]) -> Self {
        let (used, left_out): (Vec<Component>, Vec<Component>) =
            Component::ALL.into_iter().partition(|piece| *piece == Component::Profile || used.contains(piece));
        let names = |pieces: Vec<Component>| pieces.into_iter().map(Component::name).collect();
        Self::new(solver, names(used), names(left_out))
    }
}

/// A solver in words.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Solver {
    /// Its name.
    pub name: &'static str,
    /// Why it was taken.
    pub reason: String,
}

impl Solver {
    /// A solver that is always taken for the same reason.
    #[must_use]
    pub fn new(name: &'static str, reason: impl Into<String>) -> Self {
        Self { name, reason: reason.into() }
    }
}
