//! A plan in words: who computes the scene, why, and from which parts.

use super::law::Solver;
use super::plan::{ImpactPlan, Plan, PlanePlan, RoughPlan, RoundPlan};
use crate::contact::direct::QuasiStatic;
use crate::contact::plane::PlaneContact;
use crate::friction::TangentialMemory;
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
pub(super) enum Piece {
    Profile,
    VanishingRange,
    FiniteRange,
    Prony,
    TurningPoints,
    FrictionSprings,
    ViscoelasticFriction,
    Sliding,
    Peeling,
    Springs,
}

impl Piece {
    const ALL: [Self; 10] = [
        Self::Profile,
        Self::VanishingRange,
        Self::FiniteRange,
        Self::Prony,
        Self::TurningPoints,
        Self::FrictionSprings,
        Self::ViscoelasticFriction,
        Self::Sliding,
        Self::Peeling,
        Self::Springs,
    ];

    fn name(self) -> &'static str {
        match self {
            Self::Profile => "one-dimensional profile g(x)",
            Self::VanishingRange => "adhesion of vanishing range (JKR)",
            Self::FiniteRange => "adhesion of finite range (Maugis–Dugdale)",
            Self::Prony => "Prony elements",
            Self::TurningPoints => "stick and slip by turning points",
            Self::FrictionSprings => "stick and slip by springs",
            Self::ViscoelasticFriction => "stick and slip by relaxing springs",
            Self::Sliding => "gross sliding on the pressure",
            Self::Peeling => "peeling under shear",
            Self::Springs => "springs",
        }
    }
}

impl Parts {
    fn new(solver: Solver, used: Vec<&'static str>, left_out: Vec<&'static str>) -> Self {
        Self { solver: solver.name, reason: solver.reason, used, left_out, springs: 0, state_bytes: 0 }
    }

    /// Those of a round contact.
    fn round(solver: Solver, used: &[Piece]) -> Self {
        let (used, left_out): (Vec<Piece>, Vec<Piece>) =
            Piece::ALL.into_iter().partition(|piece| *piece == Piece::Profile || used.contains(piece));
        let names = |pieces: Vec<Piece>| pieces.into_iter().map(Piece::name).collect();
        Self::new(solver, names(used), names(left_out))
    }
}

impl Plan {
    /// The plan in words.
    #[must_use]
    pub fn parts(&self) -> Parts {
        match self {
            Self::Round(plan) => plan.parts(),
            Self::Impact(plan) => plan.parts(),
            Self::Plane(plan) => plan.parts(),
            Self::Rough(plan) => plan.parts(),
        }
    }
}

impl RoundPlan {
    /// The plan in words; springs and bytes of a contact that relaxes are known from its run.
    #[must_use]
    pub fn parts(&self) -> Parts {
        let mut used = self.contact.pieces();
        used.extend(self.friction.iter().map(super::law::FrictionLaw::piece));
        let tangential = self.friction.as_ref().map_or(0, super::law::FrictionLaw::bytes);
        Parts {
            springs: self.contact.springs(),
            state_bytes: self.contact.bytes() + tangential,
            ..Parts::round(self.contact.solver(self.friction.as_ref()), &used)
        }
    }
}

impl ImpactPlan {
    /// The plan in words; bytes are known from the run.
    #[must_use]
    pub fn parts(&self) -> Parts {
        let (mut solver, mut used) = (self.law.solver(), self.law.pieces());
        let mut state_bytes = size_of::<QuasiStatic>();
        if self.ball.is_some() {
            used.push(Piece::TurningPoints);
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
        let (mut used, mut left_out) = (vec!["half-plane"], vec!["one-dimensional profile g(x)", "springs"]);
        (if self.section.slides() { &mut used } else { &mut left_out }).push("gross sliding");
        Parts { state_bytes: size_of::<PlaneContact>(), ..Parts::new(self.section.solver(), used, left_out) }
    }
}

impl RoughPlan {
    /// The plan in words.
    #[must_use]
    pub fn parts(&self) -> Parts {
        let springs = self.surface.points;
        let solver = Solver::new(
            "rough bed",
            format!(
                "approximate: a line with the spectrum of the surface stands for it, {springs} springs that touch one by one"
            ),
        );
        let (mut used, mut left_out) =
            (vec!["equivalent rough line", "springs sorted by height"], vec!["real contact area"]);
        (if self.base.is_some() { &mut used } else { &mut left_out }).push(Piece::Profile.name());
        (if self.surface.seeds.len() > 1 { &mut used } else { &mut left_out }).push("ensemble");
        // Gaps, forces and energies of the members that run at a time are no more than those of all.
        Parts { springs, state_bytes: 24 * springs, ..Parts::new(solver, used, left_out) }
    }
}
