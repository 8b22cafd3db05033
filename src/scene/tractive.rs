//! Steady rolling with traction, as a scene asks for it.
//!
//! # Examples
//! ```
//! use springbed::input::quantity::Length;
//! use springbed::scene::tractive::RollingBody;
//! use springbed::shape::{Paraboloid, Shape};
//!
//! let ball = Shape::Paraboloid(Paraboloid { radius: Length::new(0.5)? });
//! assert_eq!(RollingBody::of(&ball), Some(RollingBody::Ball { radius: 0.5 }));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::Scene;
use crate::friction::rolling::{CreepLaw, RollingContact, RollingPlace, ball, carter};
use crate::friction::{Friction, Grip};
use crate::material::Pair;
use crate::scene::history::Glide;
use crate::shape::Shape;

/// Steady rolling with traction behind what the history has done.
#[derive(Debug, Clone, PartialEq)]
pub struct TractiveRolling {
    /// Number of the history entry.
    pub entry: usize,
    /// Speed of rolling v [m/s].
    pub speed: f64,
    /// What rolls.
    pub body: RollingBody,
    /// Moduli and coefficient of friction.
    pub grip: Grip,
    /// What is prescribed.
    pub asked: Prescribed,
}

/// A body that rolls with traction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RollingBody {
    /// A cylinder, as Carter has it.
    Cylinder {
        /// Radius R [m].
        radius: f64,
    },
    /// A ball, on its bed.
    Ball {
        /// Radius of curvature R [m] of both bodies together.
        radius: f64,
    },
}

/// What is prescribed of a body that rolls.
#[derive(Debug, Clone, PartialEq)]
pub enum Prescribed {
    /// Creepages ξ.
    Creepages(Vec<f64>),
    /// Tangential forces T [N].
    Tractions(Vec<f64>),
}

impl RollingBody {
    /// The body of a shape, if it is one that is known to roll with traction.
    #[must_use]
    pub fn of(shape: &Shape) -> Option<Self> {
        match shape {
            Shape::Cylinder(cylinder) => Some(Self::Cylinder { radius: cylinder.radius.si() }),
            Shape::Paraboloid(ball) => Some(Self::Ball { radius: ball.radius.si() }),
            Shape::Spheres(balls) => Some(Self::Ball { radius: balls.effective_radius() }),
            Shape::Sphere(_)
            | Shape::Cone(_)
            | Shape::Power(_)
            | Shape::FlatPunch(_)
            | Shape::TruncatedCone(_)
            | Shape::TruncatedParaboloid(_)
            | Shape::RoundedCone(_)
            | Shape::RoundedPunch(_)
            | Shape::WavyParaboloid(_)
            | Shape::Ellipsoid(_)
            | Shape::Table(_)
            | Shape::SmoothTable(_)
            | Shape::RoughLine(_)
            | Shape::HeightMap(..)
            | Shape::Topography(_)
            | Shape::Tips(_)
            | Shape::PlaneWave(_)
            | Shape::PlaneWavy(_)
            | Shape::Pad(_) => None,
        }
    }

    /// Radius of curvature R [m].
    #[must_use]
    pub fn radius(self) -> f64 {
        match self {
            Self::Cylinder { radius } | Self::Ball { radius } => radius,
        }
    }

    /// The traction curve.
    #[must_use]
    pub fn law(self, contact: &RollingContact) -> CreepLaw {
        match self {
            Self::Cylinder { .. } => carter::law(contact),
            Self::Ball { .. } => ball::law(contact),
        }
    }

    /// What the places of the contact carry at a creepage, rolling at a speed [m/s].
    #[must_use]
    pub fn profile(self, contact: &RollingContact, creepage: f64, speed: f64) -> Vec<RollingPlace> {
        match self {
            Self::Cylinder { .. } => carter::profile(contact, creepage, speed),
            Self::Ball { .. } => ball::profile(contact, creepage, speed),
        }
    }
}

impl TractiveRolling {
    /// That of a scene with the effective moduli `pair`, if it asks for it.
    pub(super) fn of(scene: &Scene, pair: &Pair) -> Option<Self> {
        let entries = scene.history.iter().enumerate();
        let mut rolls = entries.filter_map(|(entry, of)| Some((entry, of.traits(entry, None, None).traction()?.0)));
        let (entry, glide) = rolls.next()?;
        let (Some(Friction::Coulomb(law)), Some(body)) = (&scene.friction, RollingBody::of(&scene.shape)) else {
            return None;
        };
        let (normal_modulus, tangential_modulus) = (pair.normal, pair.tangential);
        let grip = Grip { normal_modulus, tangential_modulus, coefficient: law.coefficient.si() };
        Some(Self { entry, speed: glide.speed.first()?.si(), body, grip, asked: Prescribed::of(glide)? })
    }

    /// What it adds to the reason for a solver.
    pub(super) fn in_words(&self) -> &'static str {
        match self.body {
            RollingBody::Cylinder { .. } => "; it rolls steadily with traction by Carter's closed form",
            RollingBody::Ball { .. } => {
                "; it rolls steadily with traction on one line of springs along its way, in closed form, which is too compliant: beside it Kalker's creep coefficient"
            }
        }
    }
}

impl Prescribed {
    fn of(glide: &Glide) -> Option<Self> {
        match (&glide.creepage, &glide.traction) {
            (Some(creepages), _) => Some(Self::Creepages(creepages.iter().map(|creepage| creepage.si()).collect())),
            (None, Some(tractions)) => Some(Self::Tractions(tractions.iter().map(|traction| traction.si()).collect())),
            (None, None) => None,
        }
    }
}
