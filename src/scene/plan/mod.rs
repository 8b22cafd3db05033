//! A scene decided: who computes it, and from what.
//!
//! # Examples
//! ```
//! # #[cfg(feature = "text")] {
//! use springbed::prelude::*;
//! use springbed::scene::plan::{Plan, SceneSettings};
//!
//! let text = r#"(shape: Paraboloid(radius: 1), bodies: (Elastic(young: 1, poisson: 0), Rigid),
//!     history: [Indent(to: 1, over: 1)])"#;
//! let plan = Notation::Ron.plan(text, &InMemory::default()).map_err(|errors| errors[0].clone())?;
//! assert!(matches!(plan, Plan::Round(_)) && plan.pair.normal == 1.0);
//! // The same scene on a bed of a hundred springs.
//! let springs = std::num::NonZeroUsize::new(100);
//! let bed = plan.with(SceneSettings { springs, ..plan.settings() }).map_err(|problems| problems[0].clone())?;
//! assert_eq!(bed.parts().springs, 100);
//! # }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod answers;

use super::law::{ContactLaw, ElasticAdhesion, FrictionLaw, ImpactLaw, MachineLaw, PixelFriction, Travel, WearLaw};
pub use super::pixelled::PixelledIndenter;
use super::read::Read;
use super::surface::Surface;
use super::tractive::TractiveRolling;
use crate::contact::foundation::Foundation;
use crate::contact::pad::Bed;
use crate::contact::rough::EdgeWorks;
use crate::friction::Grip;
use crate::friction::oblique::Ball;
use crate::ground::Ground;
use crate::input::quantity::Accuracy;
use crate::material::{Pair, Relaxation, Times, Under};
use crate::scene::Scene;
use crate::scene::history::Impact;
use crate::scene::solver::{Leak, SolverChoice};
use crate::scene::stage::{Path, Stage};
use crate::shape::{Boundary, Pad, PlaneWavy, Profile};
use std::num::NonZeroUsize;
use std::ops::Deref;
use std::sync::Arc;

/// A scene whose parts fit together, with its tables read, and the decision who computes it.
///
/// Made only by [`Scene::resolve`], so whoever has one need not ask again.
#[derive(Debug, Clone)]
pub enum Plan {
    /// A round contact led through a history.
    Round(RoundPlan),
    /// The impact of a round body.
    Impact(ImpactPlan),
    /// A contact long across its section.
    Plane(PlanePlan),
    /// A rough contact led through a history.
    Rough(RoughPlan),
    /// The impact of a rough body.
    RoughImpact(RoughImpactPlan),
    /// A pad of scattered heights, led through a history.
    Pad(PadPlan),
    /// A contact on the pixels of a half-space, led through a history.
    HalfSpace(HalfSpacePlan),
}

/// What all plans have.
#[derive(Debug, Clone)]
pub struct Shared {
    /// The scene as written.
    pub scene: Scene,
    /// Effective moduli; instantaneous ones of a viscoelastic pair.
    pub pair: Pair,
    /// The stages of the history.
    pub stages: Vec<Stage>,
    pub(super) read: Arc<Read>,
}

impl Shared {
    /// Relative error to aim at: the scene's, or 1e-6.
    #[must_use]
    pub fn accuracy(&self) -> f64 {
        self.scene.accuracy.map_or(1e-6, |accuracy| accuracy.si())
    }

    /// The times between which a power law of the bodies is kept to, if there is one.
    #[must_use]
    pub fn times(&self) -> Option<Times> {
        let (one, two) = &self.scene.bodies;
        one.power_law().or(two.power_law()).and(self.read.times)
    }

    /// Whether nothing but the moduli of the bodies counts: they are alike at all depths.
    #[must_use]
    pub fn fills_half_spaces(&self) -> bool {
        self.read.ground.is_none()
    }

    /// What lies under the surfaces, if the bodies are joined.
    #[must_use]
    pub fn under(&self) -> Option<&Under> {
        self.read.joined.as_ref().map(|joined| &joined.under)
    }

    /// Moduli and friction of a contact with the coefficient `coefficient` μ.
    #[must_use]
    pub fn grip(&self, coefficient: f64) -> Grip {
        Grip { normal_modulus: self.pair.normal, tangential_modulus: self.pair.tangential, coefficient }
    }

    /// Whether depth or slide is a curve in time: under a prescribed force, and in a wave.
    #[must_use]
    pub fn is_curved(&self) -> bool {
        self.stages.iter().any(Stage::is_curved)
    }

    /// How often a depth that is prescribed in straight pieces turns back.
    #[must_use]
    pub fn turns(&self) -> usize {
        let depths = self.stages.iter().filter_map(|stage| match stage.normal {
            Path::To(depth) => Some(depth),
            Path::Stay | Path::Steady { .. } | Path::Wave(_) | Path::UntilParted { .. } => None,
        });
        let (mut before, mut way, mut turns) = (0.0, 0.0, 0);
        for depth in depths {
            let step: f64 = depth - before;
            turns += usize::from(step * way < 0.0);
            (before, way) = (depth, if step.abs() > 0.0 { step.signum() } else { way });
        }
        turns
    }
}

/// A round contact led through a history.
#[derive(Debug, Clone)]
pub struct RoundPlan {
    /// What all plans have.
    pub shared: Shared,
    /// Profile of the indenter.
    pub profile: Arc<dyn Profile>,
    /// Who computes the normal contact.
    pub contact: ContactLaw,
    /// Who computes the tangential contact, if there is friction.
    pub friction: Option<FrictionLaw>,
    /// The steady motion along the surface at the end, if there is one.
    pub travel: Option<Travel>,
    /// The steady rolling with traction at the end, if there is one.
    pub rolling: Option<TractiveRolling>,
    /// How the indenter wears, if it does.
    pub wear: Option<WearLaw>,
    /// The machine of which the contact is a part, if there is one.
    pub machine: Option<MachineLaw>,
    /// Stiffness [N/m] of the spring by whose far end the contact is led, if there is one.
    pub spring: Option<f64>,
}

/// The impact of a round body.
#[derive(Debug, Clone)]
pub struct ImpactPlan {
    /// What all plans have.
    pub shared: Shared,
    /// Profile of the indenter.
    pub profile: Arc<dyn Profile>,
    /// The impact.
    pub impact: Impact,
    /// Who computes it.
    pub law: ImpactLaw,
    /// The ball of an oblique impact.
    pub ball: Option<Ball>,
}

/// A contact long across its section.
#[derive(Debug, Clone)]
pub struct PlanePlan {
    /// What all plans have.
    pub shared: Shared,
    /// The section.
    pub section: PlaneWavy,
}

/// A rough contact.
#[derive(Debug, Clone)]
pub struct RoughPlan {
    /// What all plans have.
    pub shared: Shared,
    /// The roughness.
    pub surface: Arc<Surface>,
    /// The smooth profile under it; `None` for a nominally flat surface.
    pub base: Option<Arc<dyn Profile>>,
    /// E*(t) of bodies that relax.
    pub relaxation: Option<Arc<Relaxation>>,
    /// What an edge of its patches takes and gives, if the bodies adhere.
    pub works: Option<EdgeWorks>,
    /// Hardness [Pa], if the bodies yield.
    pub hardness: Option<f64>,
    /// Coefficient μ of Coulomb friction.
    pub coefficient: Option<f64>,
    /// The steady motion along the surface at the end, if there is one.
    pub travel: Option<Travel>,
}

/// The impact of a rough body.
#[derive(Debug, Clone)]
pub struct RoughImpactPlan {
    /// What is struck.
    pub rough: RoughPlan,
    /// The impact.
    pub impact: Impact,
}

/// A pad of scattered heights.
#[derive(Debug, Clone)]
pub struct PadPlan {
    /// What all plans have.
    pub shared: Shared,
    /// The pad.
    pub pad: Pad,
    /// Its springs or summits.
    pub bed: Bed,
}

/// A contact on the pixels of a half-space.
#[derive(Debug, Clone)]
pub struct HalfSpacePlan {
    /// What all plans have.
    pub shared: Shared,
    /// What is pressed.
    pub indenter: PixelledIndenter,
    /// What happens at the edge of the window.
    pub boundary: Boundary,
    /// Rows and columns of pixels.
    pub size: [usize; 2],
    /// Side of the window [m]; that of the surface, or found from the contact, if absent.
    pub window: Option<f64>,
    /// What lies under them; absent for half-spaces that are alike at all depths.
    pub ground: Option<Arc<dyn Ground>>,
    /// E*(t) of bodies that relax.
    pub relaxation: Option<Arc<Relaxation>>,
    /// The fluid that the gap lets through.
    pub leak: Option<Leak>,
    /// What pulls across the gap.
    pub attraction: ElasticAdhesion,
    /// Largest pressure [Pa] of a body that yields.
    pub hardness: Option<f64>,
    /// What holds it back along the surface, if there is friction.
    pub friction: Option<PixelFriction>,
    /// The steady motion along the surface at the end, if there is one.
    pub travel: Option<Travel>,
}

impl HalfSpacePlan {
    /// The same on another number of pixels along x.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "of the order of the grid")]
    pub fn on(&self, grid: usize) -> Self {
        let [rows, columns] = self.size.map(|side| side as f64);
        let size = [((grid as f64 * rows / columns).round() as usize).max(1), grid];
        Self { size, ..self.clone() }
    }

    /// The smooth profile, if there is one.
    #[must_use]
    pub fn profile(&self) -> Option<&dyn Profile> {
        self.indenter.profile()
    }

    /// The roughness, if there is one.
    #[must_use]
    pub fn surface(&self) -> Option<&Surface> {
        self.indenter.surface()
    }
}

impl Shared {
    /// Whether the history leads the body along the surface of a bed that remembers.
    #[must_use]
    pub fn moves_along(&self) -> bool {
        self.stages.iter().any(|stage| matches!(stage.tangential, Path::Steady { .. }))
    }
}

impl RoughPlan {
    /// One-dimensional profile [m] under the roughness at `x` [m].
    #[must_use]
    pub fn reduced(&self, x: f64) -> f64 {
        self.base.as_ref().map_or(0.0, |base| base.reduced(x))
    }
}

impl RoundPlan {
    /// What the indenter is pressed into; instantaneous where it relaxes.
    #[must_use]
    pub fn ground(&self) -> Foundation {
        Foundation::new(self.profile.clone(), self.pair.normal)
    }
}

impl ImpactPlan {
    /// What the indenter is pressed into; instantaneous where it relaxes.
    #[must_use]
    pub fn ground(&self) -> Foundation {
        Foundation::new(self.profile.clone(), self.pair.normal)
    }
}

/// What can be changed of a scene without reading its tables again.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SceneSettings {
    /// Relative error to aim at.
    pub accuracy: Option<Accuracy>,
    /// Number of springs.
    pub springs: Option<NonZeroUsize>,
    /// Records per history entry.
    pub steps: Option<NonZeroUsize>,
    /// Another solver than the one that suits.
    pub solver: Option<SolverChoice>,
}

impl Deref for Plan {
    type Target = Shared;

    fn deref(&self) -> &Shared {
        match self {
            Self::Round(plan) => &plan.shared,
            Self::Impact(plan) => &plan.shared,
            Self::Plane(plan) => &plan.shared,
            Self::Rough(plan) => &plan.shared,
            Self::RoughImpact(plan) => &plan.rough.shared,
            Self::Pad(plan) => &plan.shared,
            Self::HalfSpace(plan) => &plan.shared,
        }
    }
}

macro_rules! shares {
    ($($plan:ty),*) => {$(
        impl Deref for $plan {
            type Target = Shared;

            fn deref(&self) -> &Shared {
                &self.shared
            }
        }
    )*};
}

shares!(RoundPlan, ImpactPlan, PlanePlan, RoughPlan, PadPlan, HalfSpacePlan);

impl Deref for RoughImpactPlan {
    type Target = Shared;

    fn deref(&self) -> &Shared {
        &self.rough.shared
    }
}
