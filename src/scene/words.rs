//! Plans in words.

use super::law::{ElasticAdhesion, FrictionLaw, PixelFriction, WearLaw};
use super::parts::{Component, Parts, Solver};
use super::plan::{HalfSpacePlan, ImpactPlan, PadPlan, Plan, PlanePlan, RoughImpactPlan, RoughPlan, RoundPlan};
use super::tractive::TractiveRolling;
use crate::contact::direct::QuasiStatic;
use crate::contact::pad::{Element, Pad};
use crate::contact::plane::PlaneContact;
use crate::friction::TangentialMemory;
use crate::shape::Boundary;

impl Plan {
    /// The plan in words.
    #[must_use]
    pub fn parts(&self) -> Parts {
        match self {
            Self::Round(plan) => plan.parts(),
            Self::Impact(plan) => plan.parts(),
            Self::Plane(plan) => plan.parts(),
            Self::Rough(plan) => plan.parts(),
            Self::RoughImpact(plan) => plan.parts(),
            Self::Pad(plan) => plan.parts(),
            Self::HalfSpace(plan) => plan.parts(),
        }
    }
}

impl RoundPlan {
    /// The plan in words; springs and bytes of a contact that relaxes are known from its run.
    #[must_use]
    pub fn parts(&self) -> Parts {
        let mut used = self.contact.pieces();
        used.extend(self.friction.iter().map(FrictionLaw::piece));
        used.extend(self.travel.iter().map(|_| Component::Gliding));
        used.extend(self.rolling.iter().map(|_| Component::Rolling));
        used.extend(self.wear.map(|_| Component::Wear));
        used.extend(self.machine.as_ref().map(|_| Component::Machine));
        used.extend(self.spring.map(|_| Component::LedBySpring));
        let mut solver = self.solver();
        solver.reason.extend(self.rolling.as_ref().map(TractiveRolling::in_words));
        solver.reason.extend(self.wear.map(WearLaw::in_words));
        solver.reason.extend(self.spring.map(|_| "; it is led by the far end of a spring, d + F/k, between the limits of a prescribed depth and a prescribed force"));
        solver.reason.extend(self.machine.as_ref().map(|machine| machine.in_words(self.friction.as_ref())));
        let tangential = self.friction.as_ref().map_or(0, FrictionLaw::bytes);
        Parts {
            springs: self.contact.springs(),
            state_bytes: self.contact.bytes() + tangential,
            ..Parts::round(solver, &used)
        }
    }
}

impl RoundPlan {
    /// Who leads the contact through its history, and who finds its steady motion.
    fn solver(&self) -> Solver {
        let solver = self.contact.solver(self.friction.as_ref());
        match &self.travel {
            None => solver,
            Some(_) => Solver { reason: format!("{}; {STEADY}", solver.reason), ..solver },
        }
    }
}

/// How a steady motion along the surface is found.
const STEADY: &str = "in the steady motion along the surface all springs of the bed go through the same one after the other: one, swept through the profile, tells of all";

impl ImpactPlan {
    /// The plan in words; bytes are known from the run.
    #[must_use]
    pub fn parts(&self) -> Parts {
        let (mut solver, mut used) = (self.law.solver(), self.law.bodies().pieces());
        let mut state_bytes = size_of::<QuasiStatic>();
        if self.ball.is_some() && self.law.bodies().relaxation().is_some() {
            used.push(Component::ViscoelasticFriction);
            solver.reason.push_str("; along the surface a Coulomb bed of relaxing springs is dragged through that motion in steps, which with the springs are doubled until the rebound settles; it does not act back on the normal motion");
        } else if self.ball.is_some() {
            used.push(Component::TurningPoints);
            solver.reason.push_str("; along the surface the Coulomb bed is driven by its memory of turning points, which does not act back on the normal motion");
            state_bytes += size_of::<TangentialMemory>() + 8 * TangentialMemory::BYTES_PER_TURN;
        }
        Parts { state_bytes, ..Parts::round(solver, &used) }
    }
}

impl PlanePlan {
    /// The plan in words.
    #[must_use]
    pub fn parts(&self) -> Parts {
        let solver = Solver::new(
            "Chebyshev series",
            "a contact in one piece on the half-plane: pressure and ends from the series of the slope",
        );
        let left_out = vec!["one-dimensional profile g(x)", "springs", "gross sliding"];
        Parts { state_bytes: size_of::<PlaneContact>(), ..Parts::new(solver, vec!["half-plane"], left_out) }
    }
}

impl PadPlan {
    /// The plan in words.
    #[must_use]
    pub fn parts(&self) -> Parts {
        let (what, reason) = match self.bed.element {
            Element::Spring(_) => (
                "springs",
                "springs that stand for themselves join and let go one by one: sums over normal heights in closed form",
            ),
            Element::Summit(_) => (
                "summits",
                "summits that stand for themselves join and let go one by one: sums over normal heights by their radii",
            ),
        };
        let left_out = vec!["one-dimensional profile g(x)", "what neighbours feel of each other", "gross sliding"];
        let solver = Solver::new("pad", reason);
        Parts {
            state_bytes: size_of::<Pad>(),
            ..Parts::new(solver, vec![what, "edge between what is joined and what is not"], left_out)
        }
    }
}

impl RoughPlan {
    /// The plan in words.
    #[must_use]
    pub fn parts(&self) -> Parts {
        let springs = self.surface.points;
        let name = match (&self.relaxation, self.works, self.hardness) {
            (Some(_), _, _) => "rough viscoelastic bed",
            (None, Some(_), _) => "rough adhesive bed",
            (None, None, Some(_)) => "rough yielding bed",
            (None, None, None) => "rough bed",
        };
        let (name, past, order) = if self.moves_along() {
            ("gliding bed of a rough line", ", each with a past of its own, exact in time", "springs in their places")
        } else {
            (name, "", "springs sorted by height")
        };
        let solver = Solver::new(
            name,
            format!(
                "approximate: a line with the spectrum of the surface stands for it, {springs} springs that touch one by one{past}"
            ),
        );
        let (mut used, mut left_out) = (vec!["equivalent rough line", order], vec!["real contact area"]);
        (if self.base.is_some() { &mut used } else { &mut left_out }).push(Component::Profile.name());
        for (part, there) in [
            ("relaxation", self.relaxation.is_some()),
            ("adhesive patches", self.works.is_some()),
            ("hardness", self.hardness.is_some()),
            ("Coulomb springs", self.coefficient.is_some()),
            (Component::Gliding.name(), self.travel.is_some()),
        ] {
            (if there { &mut used } else { &mut left_out }).push(part);
        }
        (if self.surface.seeds.len() > 1 { &mut used } else { &mut left_out }).push("ensemble");
        // Gaps, forces and energies of the members that run at a time are no more than those of all.
        Parts { springs, state_bytes: 24 * springs, ..Parts::new(solver, used, left_out) }
    }
}

impl HalfSpacePlan {
    /// The plan in words.
    #[must_use]
    pub fn parts(&self) -> Parts {
        let [rows, columns] = self.size;
        let (boundary, because) = match (self.boundary, self.surface().is_some()) {
            (Boundary::Periodic, _) => ("periodic", "it repeats"),
            (Boundary::Free, true) => ("free", "beyond its border nothing presses"),
            (Boundary::Free, false) => ("free", "the shape stands alone"),
        };
        let window = match self.window {
            Some(side) => format!("a window of {side:e} m"),
            None if self.surface().is_some() => "the whole surface".to_owned(),
            None => "a window three times as wide as the largest contact".to_owned(),
        };
        let solver = Solver::new(
            "half-space",
            format!(
                "`solver: HalfSpace` asks for it: pressure on {columns} × {rows} pixels over {window}, {boundary} ({because}), by conjugate gradients with transforms{}{}{}",
                self.ground_in_words(),
                self.bodies_in_words(),
                self.friction_in_words()
            ) + self.travel_in_words(),
        );
        let (mut used, mut left_out) = (vec!["pixels of a half-space"], vec!["springs"]);
        (if self.ground.is_some() { &mut used } else { &mut left_out }).push("layers");
        (if self.relaxation.is_some() { &mut used } else { &mut left_out }).push("relaxation");
        (if self.travel.is_some() { &mut used } else { &mut left_out }).push(Component::Gliding.name());
        let pulls = self.attraction != ElasticAdhesion::None;
        (if pulls { &mut used } else { &mut left_out }).push("attraction across the gap");
        (if self.hardness.is_some() { &mut used } else { &mut left_out }).push("hardness");
        (if self.friction.is_some() { &mut used } else { &mut left_out }).push("friction");
        (if self.profile().is_some() { &mut used } else { &mut left_out }).push("smooth shape");
        (if self.surface().is_some() { &mut used } else { &mut left_out }).push("rough surface");
        Parts { state_bytes: self.bytes(), ..Parts::new(solver, used, left_out) }
    }

    /// What lies under the pixels, in words.
    fn ground_in_words(&self) -> &'static str {
        if self.ground.is_some() { " over the transfer function of what lies beneath" } else { "" }
    }

    /// What holds it back along the surface, in words.
    fn friction_in_words(&self) -> &'static str {
        match &self.friction {
            None => ", without friction",
            Some(PixelFriction::Partial { .. }) => {
                "; stick and slip by the memory of turning points, each of which is a shallower contact that is taken off: what shear does across its own direction, and to the pressures, is left out"
            }
            Some(PixelFriction::Coupled { .. }) => {
                "; stick and slip together with the pressures, in implicit steps from record to record: more records follow a curved way better"
            }
            Some(PixelFriction::Gross(_)) => "; in gross sliding the law acts on the pressure of each pixel",
        }
    }

    /// How a body that glides is computed, in words.
    fn travel_in_words(&self) -> &'static str {
        if self.travel.is_some() {
            "; in the steady motion each wave answers by the complex modulus at the frequency with which it is passed, by minimal residuals on the contact"
        } else {
            ""
        }
    }

    /// What the bodies are, in words.
    fn bodies_in_words(&self) -> &'static str {
        let pulls = self.attraction != ElasticAdhesion::None;
        match (self.relaxation.is_some(), pulls) {
            (false, false) if self.hardness.is_some() => {
                "; elastic up to the hardness, under which each pixel is dented for good"
            }
            (false, false) => "; elastic",
            (false, true) => {
                "; elastic, with an attraction across the gap, contact and attraction in turns until they agree"
            }
            (true, false) => {
                "; each pixel remembers by Maxwell elements that are exact in time, steps halved until they agree"
            }
            (true, true) => {
                "; each pixel remembers by Maxwell elements that are exact in time, with a constant attraction across the gap up to its range"
            }
        }
    }

    /// Bytes of the largest solution.
    #[cfg(feature = "half-space")]
    fn bytes(&self) -> usize {
        usize::try_from(crate::halfspace::bytes_needed(self.size, self.boundary)).unwrap_or(usize::MAX)
    }

    /// Without the solver nothing is computed.
    #[cfg(not(feature = "half-space"))]
    fn bytes(&self) -> usize {
        0
    }
}

impl RoughImpactPlan {
    /// The plan in words.
    #[must_use]
    pub fn parts(&self) -> Parts {
        let parts = self.rough.parts();
        let (solver, driven) = match (&self.rough.relaxation, self.rough.works, self.rough.hardness) {
            (Some(_), _, _) => (
                "mass on the rough viscoelastic bed",
                "the springs remember: m d̈ = −F in straight steps of the depth, halved until they agree",
            ),
            (None, None, Some(_)) => (
                "mass on the rough yielding bed",
                "the springs give way: m d̈ = −F in straight steps of the depth, halved until they agree",
            ),
            (None, Some(_), _) => (
                "harmonic motions on the rough adhesive bed",
                "between two springs that close or open the mass swings freely: speeds from the energy, times in closed form, no step is taken",
            ),
            (None, None, None) => (
                "harmonic motions on the rough bed",
                "between the touch of two springs the mass swings freely: speeds from the energy, times in closed form, no step is taken",
            ),
        };
        Parts { solver, reason: format!("{}; {driven}", parts.reason), ..parts }
    }
}
