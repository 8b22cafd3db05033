//! Which adhesion goes with which bodies.

use super::{Adhesion, Edge, Jkr, Maugis};
use crate::input::problem::Problem;
use crate::material::Relaxation;
use crate::shape::{Profile, Rim, Shape};

impl Adhesion {
    /// The name a scene gives it.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Jkr(_) => "Jkr",
            Self::Maugis(_) => "Maugis",
        }
    }

    /// The rule by which the edge of a viscoelastic contact holds, in words.
    #[must_use]
    pub fn edge_in_words(&self) -> Option<String> {
        let Self::Jkr(jkr) = self else { return None };
        let held = match jkr.edge.as_ref()? {
            Edge::Relaxed => "E_c = E*(∞), w_eff = w: the process zone is long against the relaxation".to_owned(),
            Edge::Instantaneous => "E_c = E*(0), w_eff = w: the process zone has no length".to_owned(),
            Edge::Rate(rate) => format!(
                "E_c = E*(∞), w_eff = w [1 + (v/v₀)ⁿ] with v₀ = {:e} m/s, n = {} (Gent & Schultz): a fast edge holds stronger",
                rate.speed.si(),
                rate.exponent.si()
            ),
        };
        Some(format!(
            "an opening edge holds while q(a)² < 2πa E_c w_eff, with {held}; a closing edge attaches where the bodies touch; the work of separation counts as dissipated"
        ))
    }

    /// What is wrong with the adhesion of bodies that relax so, or do not relax.
    #[must_use]
    pub fn problems(&self, relaxation: Option<&Relaxation>) -> Vec<Problem> {
        let found = match (self, relaxation) {
            (Self::Jkr(jkr), None) => jkr.of_elastic_bodies(),
            (Self::Jkr(jkr), Some(relaxation)) => jkr.of_relaxing_bodies(relaxation),
            (Self::Maugis(maugis), None) => maugis.of_elastic_bodies(),
            (Self::Maugis(_), Some(_)) => Some(Problem::new(
                "adhesion",
                "Maugis with a Viscoelastic body cannot be computed: expected Jkr(work: …, edge: …)",
            )),
        };
        found.into_iter().collect()
    }

    /// What is wrong with the adhesion on a shape, whose profile is given.
    #[must_use]
    pub fn problem_on(&self, shape: &Shape, profile: &dyn Profile) -> Option<Problem> {
        let Self::Maugis(_) = self else { return None };
        let why = if let Rim::Wall(_) = profile.rim() {
            "the side of the punch leaves the attraction no gap of growing width"
        } else if profile.feature().is_some() {
            "the slope of this profile rises and falls, so it could be attracted in several rings"
        } else {
            return None;
        };
        let name = shape.name();
        Some(Problem::new("adhesion", format!("Maugis on a {name} cannot be computed: {why}; expected Jkr(work: …)")))
    }
}

impl Jkr {
    fn of_elastic_bodies(&self) -> Option<Problem> {
        self.edge.as_ref().map(|_| {
            Problem::new("adhesion.edge", "an edge is a matter of Viscoelastic bodies, and there is none: leave it out")
        })
    }

    fn of_relaxing_bodies(&self, relaxation: &Relaxation) -> Option<Problem> {
        match self.edge {
            None => Some(Problem::new(
                "adhesion",
                "Jkr with a Viscoelastic body lacks what holds its edge: expected edge: Relaxed, Instantaneous or Rate(speed: …, exponent: …)",
            )),
            Some(Edge::Relaxed | Edge::Rate(_)) if relaxation.equilibrium <= 0.0 => Some(Problem::new(
                "adhesion.edge",
                "an edge held by the relaxed modulus, which is zero here, holds nothing: expected edge: Instantaneous, or an equilibrium modulus above zero",
            )),
            Some(Edge::Instantaneous) if relaxation.viscosity > 0.0 => Some(Problem::new(
                "adhesion.edge",
                "Instantaneous with a viscosity has no finite instantaneous modulus: expected edge: Relaxed or Rate(…)",
            )),
            Some(_) => None,
        }
    }
}

impl Maugis {
    fn of_elastic_bodies(&self) -> Option<Problem> {
        (self.work.si() <= 0.0).then(|| {
            Problem::new(
                "adhesion.work",
                "a work of zero gives the attraction no range: expected one above zero, or no adhesion",
            )
        })
    }
}
