//! Which friction goes with which adhesion and which bodies.

use super::{Friction, PressureLaw};
use crate::contact::adhesion::Adhesion;
use crate::input::problem::Problem;
use crate::material::Relaxation;

impl Friction {
    /// What is wrong with this friction between bodies that adhere and relax so.
    #[must_use]
    pub fn problems(&self, adhesion: Option<&Adhesion>, relaxation: Option<&Relaxation>) -> Vec<Problem> {
        let adhering = adhesion.and_then(|adhesion| self.adhering(adhesion));
        let relaxing = relaxation.and_then(|_| self.relaxing());
        adhering.into_iter().chain(relaxing).collect()
    }

    fn adhering(&self, adhesion: &Adhesion) -> Option<Problem> {
        let message = match (adhesion, self) {
            (Adhesion::Jkr(_), Self::Pressure(law)) => return law.uniform(),
            (Adhesion::Jkr(_), Self::Coulomb(_)) => {
                "Coulomb with Jkr adhesion cannot be computed, for the springs of an adhesive edge are pulled and have no limit μq: expected Pressure(shear: …, slope: 0), or no adhesion"
            }
            (Adhesion::Jkr(_), Self::CoulombOrowan(_)) => {
                "CoulombOrowan with Jkr adhesion cannot be computed, for how a stress that is not uniform peels an edge has no closed answer: expected Pressure(shear: …, slope: 0), or no adhesion"
            }
            (Adhesion::Maugis(_), _) => {
                return Some(Problem::new(
                    "friction",
                    format!(
                        "{} with Maugis adhesion cannot be computed: expected Jkr(…) with Pressure(shear: …, slope: 0), or no adhesion",
                        self.name()
                    ),
                ));
            }
        };
        Some(Problem::new("friction", message))
    }

    fn relaxing(&self) -> Option<Problem> {
        if let Self::Coulomb(_) = self {
            return None;
        }
        let message = format!(
            "{} with a Viscoelastic body cannot be computed: expected Coulomb(coefficient: …), Elastic or Rigid bodies, or no friction",
            self.name()
        );
        Some(Problem::new("friction", message))
    }
}

impl PressureLaw {
    /// A sheared adhesive contact is known under uniform stress.
    fn uniform(&self) -> Option<Problem> {
        (self.slope.si() > 0.0).then(|| {
            Problem::new(
                "friction.slope",
                format!(
                    "Pressure with a slope of {} and Jkr adhesion cannot be computed, for peeling is known under a uniform stress only: expected slope: 0",
                    self.slope.si()
                ),
            )
        })
    }
}
