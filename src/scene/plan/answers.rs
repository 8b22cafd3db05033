//! What a plan answers whatever its kind.

use super::super::Scene;
use super::super::law::{Bodies, ElasticAdhesion, HeldEdge, Travel};
use super::super::surface::Surface;
use super::{ImpactPlan, Plan, RoughImpactPlan, RoughPlan, RoundPlan, SceneSettings};
use crate::contact::foundation::Foundation;
use crate::material::Relaxation;
use crate::shape::Profile;
use std::sync::Arc;

impl Plan {
    /// The settings of the scene.
    #[must_use]
    pub fn settings(&self) -> SceneSettings {
        let Scene { accuracy, springs, steps, solver, .. } = self.scene;
        SceneSettings { accuracy, springs, steps, solver }
    }

    /// What a round scene says, led through a history or in an impact; `None` of a scene that is not round.
    fn of_round<'p, T>(
        &'p self,
        history: impl FnOnce(&'p RoundPlan) -> Option<T>,
        impact: impl FnOnce(&'p ImpactPlan) -> Option<T>,
    ) -> Option<T> {
        match self {
            Self::Round(plan) => history(plan),
            Self::Impact(plan) => impact(plan),
            Self::Plane(_) | Self::Rough(_) | Self::RoughImpact(_) | Self::Pad(_) | Self::HalfSpace(_) => None,
        }
    }

    /// The plan of a round contact that is led through a history, if it is one.
    #[must_use]
    pub fn round(&self) -> Option<&RoundPlan> {
        self.of_round(Some, |_| None)
    }

    /// The plan of a rough contact, led through a history or in an impact, if it is one.
    #[must_use]
    pub fn rough(&self) -> Option<&RoughPlan> {
        match self {
            Self::Rough(plan) => Some(plan),
            Self::RoughImpact(plan) => Some(&plan.rough),
            Self::Round(_) | Self::Impact(_) | Self::Plane(_) | Self::Pad(_) | Self::HalfSpace(_) => None,
        }
    }

    /// What the indenter is pressed into, if it is round.
    #[must_use]
    pub fn ground(&self) -> Option<Foundation> {
        self.of_round(|plan| Some(plan.ground()), |plan| Some(plan.ground()))
    }

    /// The bodies of a round contact and what holds them together.
    #[must_use]
    pub fn bodies(&self) -> Option<Bodies<'_>> {
        self.of_round(|plan| Some(plan.contact.bodies()), |plan| Some(plan.law.bodies()))
    }

    /// The steady motion along the surface at the end, if there is one.
    #[must_use]
    pub fn travel(&self) -> Option<&Travel> {
        match self {
            Self::Round(plan) => plan.travel.as_ref(),
            Self::Rough(plan) => plan.travel.as_ref(),
            Self::HalfSpace(plan) => plan.travel.as_ref(),
            Self::Impact(_) | Self::Plane(_) | Self::RoughImpact(_) | Self::Pad(_) => None,
        }
    }

    /// E*(t) of bodies that relax.
    #[must_use]
    pub fn relaxation(&self) -> Option<&Relaxation> {
        match self.rough() {
            Some(rough) => rough.relaxation.as_deref(),
            None => self.bodies()?.relaxation().map(Arc::as_ref),
        }
    }

    /// Work of adhesion [J/m²] of an attraction of vanishing range.
    #[must_use]
    pub fn edge_work(&self) -> Option<f64> {
        self.bodies()?.edge_work()
    }

    /// Whether the bodies adhere.
    #[must_use]
    pub fn adheres(&self) -> bool {
        match self {
            Self::Rough(rough) | Self::RoughImpact(RoughImpactPlan { rough, .. }) => rough.works.is_some(),
            Self::Pad(plan) => plan.bed.hold().leaves > 0.0,
            Self::Round(_) | Self::Impact(_) | Self::Plane(_) | Self::HalfSpace(_) => {
                self.bodies().is_some_and(Bodies::adheres)
            }
        }
    }

    /// What holds the edge of bodies that relax.
    #[must_use]
    pub fn held_edge(&self) -> Option<&HeldEdge> {
        self.bodies()?.held_edge()
    }

    /// The attraction of elastic bodies on the direct path; `None` where another solver is at work.
    #[must_use]
    pub fn direct(&self) -> Option<ElasticAdhesion> {
        self.of_round(|plan| plan.contact.direct(), |plan| plan.law.direct())
    }

    /// Whether friction acts in a round contact.
    #[must_use]
    pub fn has_friction(&self) -> bool {
        let acts = self
            .of_round(|plan| Some(plan.friction.is_some() || plan.rolling.is_some()), |plan| Some(plan.ball.is_some()));
        acts == Some(true)
    }

    /// The smooth profile, if there is one over a radius.
    #[must_use]
    pub fn profile(&self) -> Option<&dyn Profile> {
        match self {
            Self::Round(plan) => Some(plan.profile.as_ref()),
            Self::Impact(plan) => Some(plan.profile.as_ref()),
            Self::Plane(_) | Self::Pad(_) => None,
            Self::Rough(plan) => plan.base.as_deref(),
            Self::RoughImpact(plan) => plan.rough.base.as_deref(),
            Self::HalfSpace(plan) => plan.profile(),
        }
    }

    /// The roughness, if there is one.
    #[must_use]
    pub fn surface(&self) -> Option<&Surface> {
        match self {
            Self::HalfSpace(plan) => plan.surface(),
            Self::Round(_)
            | Self::Impact(_)
            | Self::Plane(_)
            | Self::Rough(_)
            | Self::RoughImpact(_)
            | Self::Pad(_) => Some(&self.rough()?.surface),
        }
    }
}
