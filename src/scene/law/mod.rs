//! The laws of a round contact as decided: who computes it, why, and from what.
//!
//! # Examples
//! ```
//! # #[cfg(feature = "text")] {
//! use springbed::prelude::*;
//! use springbed::scene::law::{ContactLaw, ElasticAdhesion};
//!
//! let text = r#"(shape: Paraboloid(radius: 1), bodies: (Elastic(young: 1, poisson: 0), Rigid), adhesion: Jkr(work: 1),
//!     history: [Press(to: 1, over: 1), Retract(speed: 0.1)])"#;
//! let plan = Notation::Ron.plan(text, &InMemory::default()).map_err(|errors| errors[0].clone())?;
//! let round = plan.round().unwrap();
//! assert_eq!(round.contact, ContactLaw::Direct(ElasticAdhesion::Vanishing { work: 1.0 }));
//! assert!(round.friction.is_none() && round.contact.bodies().adheres());
//! # }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod friction;
mod motion;

pub use crate::friction::contact::Interface;
pub use friction::{FrictionLaw, PixelFriction};
pub use motion::{MachineLaw, WearLaw};

use super::parts::{Component, Solver};
use crate::contact::adhesion::EdgeRule;
use crate::contact::direct::QuasiStatic;
use crate::contact::plastic::YieldingBall;
use crate::contact::viscoelastic::Spectrum;
use crate::contact::viscoelastic::attraction::Attraction;
use crate::material::Relaxation;
use crate::scene::history::Motion;
use std::num::NonZeroUsize;
use std::sync::Arc;

/// Attraction between elastic bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ElasticAdhesion {
    /// None.
    None,
    /// Of vanishing range.
    Vanishing {
        /// Work of adhesion w [J/m²].
        work: f64,
    },
    /// Outside the contact, bending nothing.
    Outside {
        /// Work of adhesion w [J/m²].
        work: f64,
    },
    /// Of finite range.
    Finite {
        /// Work of adhesion w [J/m²].
        work: f64,
        /// Attractive stress σ₀ [Pa].
        stress: f64,
    },
    /// Fading with the gap, on pixels.
    Fading {
        /// Work of adhesion w [J/m²].
        work: f64,
        /// Range ρ [m].
        range: f64,
    },
}

impl ElasticAdhesion {
    /// Work of adhesion [J/m²] of an edge where the attraction has no range, zero without one; `None` for an
    /// attraction across the gap.
    #[must_use]
    pub fn work_at_edge(self) -> Option<f64> {
        match self {
            Self::None => Some(0.0),
            Self::Vanishing { work } => Some(work),
            Self::Outside { .. } | Self::Finite { .. } | Self::Fading { .. } => None,
        }
    }

    /// Work of adhesion [J/m²] of an attraction of vanishing range.
    fn edge_work(self) -> Option<f64> {
        match self {
            Self::None | Self::Outside { .. } | Self::Finite { .. } | Self::Fading { .. } => None,
            Self::Vanishing { work } => Some(work),
        }
    }

    fn pieces(self) -> Vec<Component> {
        match self {
            Self::None => Vec::new(),
            Self::Vanishing { .. } => vec![Component::VanishingRange],
            Self::Outside { .. } => vec![Component::Outside],
            Self::Finite { .. } | Self::Fading { .. } => vec![Component::FiniteRange],
        }
    }
}

/// An adhesive edge that remembers: of viscoelastic bodies, or one that closes with less work than it opens with.
#[derive(Debug, Clone, PartialEq)]
pub struct HeldEdge {
    /// Work of adhesion w [J/m²].
    pub work: f64,
    /// Work of adhesion [J/m²] of a closing edge.
    pub closing: f64,
    /// What holds it.
    pub edge: EdgeRule,
}

impl HeldEdge {
    /// Whether the strength of the edge depends on its speed.
    #[must_use]
    pub fn has_rate(&self) -> bool {
        matches!(self.edge, EdgeRule::Rate(_))
    }

    /// The attraction at the edge of bodies with this spectrum.
    #[must_use]
    pub fn attraction(&self, spectrum: &Spectrum) -> Attraction {
        let attraction = match &self.edge {
            EdgeRule::Relaxed => Attraction::relaxed(self.work, spectrum),
            EdgeRule::Instantaneous => Attraction::instantaneous(self.work, spectrum),
            EdgeRule::Rate(rate) => Attraction::with_rate(self.work, spectrum, (rate.speed.si(), rate.exponent.si())),
        };
        attraction.closing(self.closing)
    }
}

/// Steady motion along the surface, behind what the history has done.
#[derive(Debug, Clone, PartialEq)]
pub struct Travel {
    /// Number of the history entry.
    pub entry: usize,
    /// Speeds [m/s].
    pub speeds: Vec<f64>,
    /// Whether the body glides or rolls.
    pub motion: Motion,
    /// E*(t); without terms of elastic bodies.
    pub relaxation: Arc<Relaxation>,
    /// Whether the motion is asked for as it is in the end, or also how it comes to that.
    pub start: Start,
}

/// How a steady motion begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Start {
    /// The history leads there.
    Followed,
    /// It is not asked for.
    LeftOut,
}

/// Springs are equally wide up to this part of the largest contact, and in geometric progression beyond.
pub const GRADE: f64 = 1.0 / 32.0;

/// Where a number of springs comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SpringCount {
    /// The scene asks for it.
    Asked(NonZeroUsize),
    /// The accuracy needs it.
    Needed(usize),
}

impl SpringCount {
    /// −1/4 ≤ error·(a/Δx)² ≤ 1/8 and Δx/a = arsinh(1/[`GRADE`])/N: N for half the accuracy.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped before")]
    pub(in crate::scene) fn of_accuracy(accuracy: f64) -> Self {
        let needed = GRADE.recip().asinh() / (2.0 * accuracy).sqrt();
        Self::Needed(needed.ceil().clamp(256.0, 262_144.0) as usize)
    }

    /// The number.
    #[must_use]
    pub fn get(self) -> usize {
        match self {
            Self::Asked(count) => count.get(),
            Self::Needed(count) => count,
        }
    }
}

/// The bodies of a contact and what holds them together, whoever computes it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Bodies<'l> {
    /// Elastic bodies.
    Elastic(ElasticAdhesion),
    /// Bodies with E*(t), and their adhesive edge if they have one.
    Viscoelastic(&'l Arc<Relaxation>, Option<&'l HeldEdge>),
    /// Bodies that yield.
    Plastic(&'l YieldingBall),
}

impl<'l> Bodies<'l> {
    /// E*(t) of bodies that relax.
    #[must_use]
    pub fn relaxation(self) -> Option<&'l Arc<Relaxation>> {
        match self {
            Self::Elastic(_) | Self::Plastic(_) => None,
            Self::Viscoelastic(relaxation, _) => Some(relaxation),
        }
    }

    /// Work of adhesion [J/m²] of an attraction of vanishing range.
    #[must_use]
    pub fn edge_work(self) -> Option<f64> {
        match self {
            Self::Elastic(adhesion) => adhesion.edge_work(),
            Self::Viscoelastic(_, edge) => edge.map(|edge| edge.work),
            Self::Plastic(_) => None,
        }
    }

    /// What holds the edge of bodies that relax.
    #[must_use]
    pub fn held_edge(self) -> Option<&'l HeldEdge> {
        match self {
            Self::Elastic(_) | Self::Plastic(_) => None,
            Self::Viscoelastic(_, edge) => edge,
        }
    }

    /// Whether they adhere.
    #[must_use]
    pub fn adheres(self) -> bool {
        match self {
            Self::Elastic(adhesion) => adhesion != ElasticAdhesion::None,
            Self::Viscoelastic(_, edge) => edge.is_some(),
            Self::Plastic(_) => false,
        }
    }

    /// The ball and its limit, if they yield.
    #[must_use]
    pub fn yielding(self) -> Option<&'l YieldingBall> {
        match self {
            Self::Elastic(_) | Self::Viscoelastic(..) => None,
            Self::Plastic(ball) => Some(ball),
        }
    }

    /// What they use.
    pub(in crate::scene) fn pieces(self) -> Vec<Component> {
        match self {
            Self::Elastic(adhesion) => adhesion.pieces(),
            Self::Viscoelastic(_, edge) => {
                edge.map(|_| Component::VanishingRange).into_iter().chain([Component::Prony]).collect()
            }
            Self::Plastic(_) => Vec::new(),
        }
    }
}

/// Who computes the normal contact.
#[derive(Debug, Clone, PartialEq)]
pub enum ContactLaw {
    /// The direct path of elastic bodies.
    Direct(ElasticAdhesion),
    /// The classical bed of elastic springs.
    Springs {
        /// Number of springs.
        count: NonZeroUsize,
        /// Work of adhesion w [J/m²] at the edge, if the bodies adhere.
        work: Option<f64>,
    },
    /// The continuous bed of viscoelastic bodies.
    Continuous {
        /// E*(t).
        relaxation: Arc<Relaxation>,
        /// Adhesive edge.
        edge: Option<HeldEdge>,
    },
    /// The bed of viscoelastic springs.
    ViscoelasticSprings {
        /// E*(t).
        relaxation: Arc<Relaxation>,
        /// Number of springs.
        count: SpringCount,
    },
    /// The bed of springs under a body that glides or rolls.
    Gliding {
        /// E*(t); without terms of elastic bodies.
        relaxation: Arc<Relaxation>,
    },
    /// The closed form of a ball that yields.
    Plastic(YieldingBall),
}

impl ContactLaw {
    /// The solver; `friction` acts beside it.
    #[must_use]
    pub fn solver(&self, friction: Option<&FrictionLaw>) -> Solver {
        match self {
            Self::Plastic(_) => Solver::new("yielding ball", "the body yields: Hertz's contact, then a force that grows in a straight line, and Hertz's again over the dent it leaves (Thornton 1997), all in closed form; no spring is allocated"),
            Self::Gliding { .. } => Solver::new("gliding bed", "the body moves along, and every place of the bed has a past of its own: springs under the polygon of the profile, each touched and let go by itself; exact in time, second order in the width of a spring"),
            Self::Direct(_) => Solver::new("direct", "the state depends on the present depth or force alone: the edge is a root of the equilibrium on g(x) and the force an integral up to it; no spring is allocated"),
            Self::Springs { count, .. } => Solver::new("springs", format!("`springs: {count}` asks for the classical bed")),
            Self::Continuous { .. } => Solver::new("continuous bed", match friction {
                Some(_) => "the bodies remember: strips of springs with a common past for the normal contact, and beside it a bed of springs for the tangential one; exact in time",
                None => "the bodies remember: strips of springs with a common past, exact in time for a depth that goes in straight pieces; no spring is allocated",
            }),
            Self::ViscoelasticSprings { count, .. } => Solver::new("viscoelastic springs", match count {
                SpringCount::Asked(count) => format!("`springs: {count}` asks for the classical bed; exact in time, work is done only for springs touched or released"),
                SpringCount::Needed(_) => "a prescribed force, an oscillation or a depth that turns back hundreds of times takes hundreds of straight pieces of the depth: springs as fine as the accuracy asks for; exact in time, work is done only for springs touched or released".to_owned(),
            }),
        }
    }

    /// Number of springs.
    #[must_use]
    pub fn springs(&self) -> usize {
        match self {
            // Of a body that moves along they are known from the run.
            Self::Direct(_) | Self::Continuous { .. } | Self::Gliding { .. } | Self::Plastic(_) => 0,
            Self::Springs { count, .. } => count.get(),
            Self::ViscoelasticSprings { count, .. } => count.get(),
        }
    }

    /// Bytes of state, as far as they are known before the run.
    pub(in crate::scene) fn bytes(&self) -> usize {
        size_of::<QuasiStatic>() + 16 * self.springs()
    }

    /// The attraction of elastic bodies on the direct path.
    pub(in crate::scene) fn direct(&self) -> Option<ElasticAdhesion> {
        match self {
            Self::Direct(adhesion) => Some(*adhesion),
            Self::Springs { .. }
            | Self::Continuous { .. }
            | Self::ViscoelasticSprings { .. }
            | Self::Gliding { .. }
            | Self::Plastic(_) => None,
        }
    }

    /// The bodies and what holds them together.
    #[must_use]
    pub fn bodies(&self) -> Bodies<'_> {
        match self {
            Self::Direct(adhesion) => Bodies::Elastic(*adhesion),
            Self::Springs { work: Some(work), .. } => Bodies::Elastic(ElasticAdhesion::Vanishing { work: *work }),
            Self::Springs { work: None, .. } => Bodies::Elastic(ElasticAdhesion::None),
            Self::Continuous { relaxation, edge } => Bodies::Viscoelastic(relaxation, edge.as_ref()),
            Self::ViscoelasticSprings { relaxation, .. } | Self::Gliding { relaxation } => {
                Bodies::Viscoelastic(relaxation, None)
            }
            Self::Plastic(ball) => Bodies::Plastic(ball),
        }
    }

    /// What it uses.
    pub(in crate::scene) fn pieces(&self) -> Vec<Component> {
        let springs = (self.springs() > 0).then_some(Component::Springs);
        self.bodies().pieces().into_iter().chain(springs).collect()
    }
}

/// Who computes an impact.
#[derive(Debug, Clone, PartialEq)]
pub enum ImpactLaw {
    /// Elastic bodies: the energy of the direct path.
    Elastic(ElasticAdhesion),
    /// Viscoelastic bodies: the continuous bed is driven.
    Viscoelastic {
        /// E*(t).
        relaxation: Arc<Relaxation>,
    },
    /// Bodies whose adhesive edge depends on what has been: the mass drives the continuous bed in steps.
    Held {
        /// E*(t); without terms of elastic bodies.
        relaxation: Arc<Relaxation>,
        /// Adhesive edge.
        edge: HeldEdge,
    },
    /// Bodies that yield: the closed form of a ball.
    Plastic(YieldingBall),
}

impl ImpactLaw {
    /// The solver.
    #[must_use]
    pub fn solver(&self) -> Solver {
        match self {
            Self::Elastic(_) => Solver::new(
                "energy of the direct path",
                "elastic bodies give back what they take, so that the speed follows from the energy at each depth, jumps of an adhesive contact included; the time is an integral over the depth, no step is taken",
            ),
            Self::Viscoelastic { .. } => Solver::new(
                "driven continuous bed",
                "the bodies remember: m d̈ = −F in steps of high order; the contact grows once and shrinks once, its force follows from the memory integrals of the motion; no spring is allocated",
            ),
            Self::Held { .. } => Solver::new(
                "mass on the continuous bed",
                "the edge remembers: m d̈ = −F in straight steps of the depth, halved until they agree; the contact is that of a prescribed depth",
            ),
            Self::Plastic(_) => Solver::new(
                "energy of the yielding ball",
                "the body yields: the work of the way in gives the greatest depth, what the dent gives back the speed of rebound; times in closed form too, no step is taken",
            ),
        }
    }

    /// The attraction of elastic bodies on the direct path.
    pub(in crate::scene) fn direct(&self) -> Option<ElasticAdhesion> {
        match self {
            Self::Elastic(adhesion) => Some(*adhesion),
            Self::Viscoelastic { .. } | Self::Held { .. } | Self::Plastic(_) => None,
        }
    }

    /// The bodies and what holds them together.
    #[must_use]
    pub fn bodies(&self) -> Bodies<'_> {
        match self {
            Self::Elastic(adhesion) => Bodies::Elastic(*adhesion),
            Self::Viscoelastic { relaxation } => Bodies::Viscoelastic(relaxation, None),
            Self::Held { relaxation, edge } => Bodies::Viscoelastic(relaxation, Some(edge)),
            Self::Plastic(ball) => Bodies::Plastic(ball),
        }
    }
}
