//! The scene: what is pressed on what, and how.

pub mod history;
pub mod plan;
pub mod reach;
pub mod setup;
pub mod stage;
pub mod surface;

use crate::contact::adhesion::Adhesion;
use crate::friction::Friction;
use crate::input::problem::Problem;
use crate::input::quantity::Accuracy;
use crate::material::Body;
use crate::scene::history::Entry;
use crate::shape::Shape;
use serde::{Deserialize, Serialize};
use std::num::NonZeroUsize;

/// A contact to be computed, as written in a scene file.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    /// Title, for figures and summaries.
    #[serde(default)]
    pub title: String,
    /// Shape of the indenter.
    pub shape: Shape,
    /// The two bodies.
    pub bodies: (Body, Body),
    /// Adhesion, if any.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub adhesion: Option<Adhesion>,
    /// Friction, if any.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub friction: Option<Friction>,
    /// What is done, in order.
    pub history: Vec<Entry>,
    /// Relative error to aim at, 1e-6 if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub accuracy: Option<Accuracy>,
    /// Number of springs, to study the classical bed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub springs: Option<NonZeroUsize>,
    /// Records per history entry.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub steps: Option<NonZeroUsize>,
    /// Figures wanted; what suits the scene if absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub plots: Option<Vec<Plot>>,
}

/// A figure one can ask for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize)]
pub enum Plot {
    /// Force against indentation, and against time where time matters.
    Force,
    /// Contact radius.
    Radius,
    /// Pressure profile.
    Pressure,
    /// Stress below the surface, on the axis.
    Stress,
    /// Stored and dissipated energy.
    Energy,
    /// Shape f(r) with its one-dimensional equivalent g(x).
    Shape,
    /// Relaxation modulus and storage and loss moduli.
    Moduli,
    /// Tangential force against tangential displacement.
    Friction,
    /// Radius of the contact and of its sticking part.
    Stick,
    /// Shear stress over the radius.
    Shear,
    /// Energy lost to friction over the radius, of a contact that is shaken.
    Fretting,
    /// Coefficient of sliding friction against the load, without adhesion.
    Coefficient,
    /// Area of a sheared adhesive contact against the sliding speed.
    Area,
    /// Restitution against speed.
    Restitution,
}

/// Most springs: their state alone has a gigabyte.
const MOST_SPRINGS: usize = 1 << 26;

impl Scene {
    /// What is wrong with the figures and the springs asked for.
    #[must_use]
    pub fn problems(&self) -> Vec<Problem> {
        let wanted = self.plots.iter().flatten().enumerate();
        let plots = wanted.filter_map(|(index, &plot)| {
            self.lacks(plot)
                .map(|what| Problem::new(format!("plots[{index}]"), format!("{plot:?} cannot be drawn: {what}")))
        });
        plots.chain(self.wrong_springs()).collect()
    }

    /// What the scene lacks for a figure.
    fn lacks(&self, plot: Plot) -> Option<&'static str> {
        let relaxes = |body: &Body| matches!(body, Body::Viscoelastic(_));
        let impact =
            self.history.iter().find_map(|entry| if let Entry::Impact(impact) = entry { Some(impact) } else { None });
        match plot {
            Plot::Radius | Plot::Pressure | Plot::Stress if self.shape.is_rough() => {
                Some("a rough bed does not know its contact area: expected Force, Energy or Shape")
            }
            Plot::Moduli if !(relaxes(&self.bodies.0) || relaxes(&self.bodies.1)) => {
                Some("expected a Viscoelastic body")
            }
            Plot::Friction | Plot::Stick | Plot::Shear if self.friction.is_none() => Some("expected a friction"),
            Plot::Fretting if !matches!(self.friction, Some(Friction::Coulomb(_))) => {
                Some("expected Coulomb friction and Shake or a Table with slide_m")
            }
            Plot::Coefficient if self.adhesion.is_some() || !self.slides_as_a_whole() => {
                Some("expected CoulombOrowan or Pressure friction, and no adhesion")
            }
            Plot::Area if self.adhesion.is_none() || !self.slides_as_a_whole() => {
                Some("expected Jkr adhesion and Pressure friction")
            }
            Plot::Restitution if impact.is_none_or(|impact| impact.speed.len() < 2) => {
                Some("expected an Impact with a list of at least two speeds")
            }
            _ => None,
        }
    }

    /// Whether the friction is one of gross sliding.
    fn slides_as_a_whole(&self) -> bool {
        matches!(self.friction, Some(Friction::CoulombOrowan(_) | Friction::Pressure(_)))
    }

    fn wrong_springs(&self) -> Option<Problem> {
        let springs = self.springs?.get();
        let what = if springs > MOST_SPRINGS {
            format!("{springs} do not fit into memory: expected at most {MOST_SPRINGS}")
        } else if matches!(self.adhesion, Some(Adhesion::Maugis(_))) {
            "with Maugis adhesion cannot be computed: expected Jkr(…), or no springs".to_owned()
        } else if matches!(&self.adhesion, Some(Adhesion::Jkr(jkr)) if jkr.edge.is_some()) {
            "with an adhesive Viscoelastic body cannot be computed: expected no springs, for the continuous bed holds the edge"
                .to_owned()
        } else if self.adhesion.is_some() && self.friction.is_some() {
            "with Jkr adhesion under shear cannot be computed: expected no springs, no adhesion or no friction"
                .to_owned()
        } else {
            return None;
        };
        Some(Problem::new("springs", what))
    }
}
