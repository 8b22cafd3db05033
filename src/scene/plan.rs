//! Which parts a scene needs, decided once.

use crate::contact::adhesion::Adhesion;
use crate::contact::direct::QuasiStatic;
use crate::contact::plane::PlaneContact;
use crate::friction::peeling::ShearedAdhesion;
use crate::friction::state::Tangential;
use crate::friction::{CoulombBed, Friction, TangentialMemory};
use crate::scene::history::Entry;
use crate::scene::setup::Setup;
use crate::scene::stage::Stage;
use crate::scene::surface::Surface;
use crate::shape::Shape;
use serde::Serialize;

/// What a scene needs and what it leaves out.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Plan {
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

/// The plan of a scene.
#[must_use]
pub fn of(setup: &Setup) -> Plan {
    let scene = &setup.scene;
    let (mut used, mut left_out) = (vec!["one-dimensional profile g(x)"], Vec::new());
    let mut part = |name, wanted: bool| if wanted { used.push(name) } else { left_out.push(name) };
    part("adhesion of vanishing range (JKR)", matches!(scene.adhesion, Some(Adhesion::Jkr(_))));
    part("adhesion of finite range (Maugis–Dugdale)", matches!(scene.adhesion, Some(Adhesion::Maugis(_))));
    part("Prony elements", setup.relaxation.is_some());
    let asked = scene.springs.map(std::num::NonZeroUsize::get);
    let springs = setup.relaxation.as_ref().map_or(asked, |_| relaxing_springs(setup));
    let rubbing = Rubbing::of(setup);
    for kind in Rubbing::ALL {
        part(kind.name(), rubbing == Some(kind));
    }
    part("springs", springs.is_some());
    let springs = springs.unwrap_or(0);
    let (solver, reason) =
        if matches!(scene.history[..], [Entry::Impact(_)]) { of_impact(setup) } else { of_history(setup) };
    let tangential = rubbing.map_or(0, |kind| kind.bytes(springs));
    let state_bytes = size_of::<QuasiStatic>() + 16 * springs + tangential;
    Plan { solver, reason, used, left_out, springs, state_bytes }
}

/// How an impact is followed, and why so.
fn of_impact(setup: &Setup) -> (&'static str, String) {
    let (solver, how) = match setup.relaxation {
        None => (
            "energy of the direct path",
            "elastic bodies give back what they take, so that the speed follows from the energy at each depth, jumps of an adhesive contact included; the time is an integral over the depth, no step is taken",
        ),
        Some(_) => (
            "driven continuous bed",
            "the bodies remember: m d̈ = −F in steps of high order; the contact grows once and shrinks once, its force follows from the memory integrals of the motion; no spring is allocated",
        ),
    };
    let oblique = setup.scene.history.iter().any(|entry| matches!(entry, Entry::Impact(impact) if impact.is_oblique()));
    let slip = "; along the surface the Coulomb bed is driven by its memory of turning points, which does not act back on the normal motion";
    let sticks = match &setup.scene.adhesion {
        Some(Adhesion::Jkr(jkr)) if jkr.edge.is_some() => {
            "; a closing edge attaches at geometric touch, an opening one holds by the law of the scene"
        }
        _ => "",
    };
    (solver, format!("{how}{sticks}{}", if oblique { slip } else { "" }))
}

fn of_history(setup: &Setup) -> (&'static str, String) {
    match (setup.scene.springs, &setup.relaxation) {
        (None, None) => ("direct", "the state depends on the present depth or force alone: the edge is a root of the equilibrium on g(x) and the force an integral up to it; no spring is allocated".to_owned()),
        (None, Some(_)) if setup.scene.friction.is_some() => ("continuous bed", "the bodies remember: strips of springs with a common past for the normal contact, and beside it a bed of springs for the tangential one; exact in time".to_owned()),
        (None, Some(_)) if relaxing_springs(setup).is_some() => ("viscoelastic springs", "a prescribed force or an oscillation takes hundreds of straight pieces of the depth: springs as fine as the accuracy asks for; exact in time, work is done only for springs touched or released".to_owned()),
        (None, Some(_)) => ("continuous bed", "the bodies remember: strips of springs with a common past, exact in time for a depth that goes in straight pieces; no spring is allocated".to_owned()),
        (Some(count), None) => ("springs", format!("`springs: {count}` asks for the classical bed")),
        (Some(count), Some(_)) => ("viscoelastic springs", format!("`springs: {count}` asks for the classical bed; exact in time, work is done only for springs touched or released")),
    }
}

/// The tangential parts a scene can need; it needs at most one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Rubbing {
    Memory,
    Springs,
    Relaxing,
    Sliding,
    Peeling,
}

impl Rubbing {
    const ALL: [Self; 5] = [Self::Memory, Self::Springs, Self::Relaxing, Self::Sliding, Self::Peeling];

    fn of(setup: &Setup) -> Option<Self> {
        let scene = &setup.scene;
        Some(match (scene.friction.as_ref()?, &scene.adhesion, scene.springs) {
            (Friction::Coulomb(_), ..) if setup.relaxation.is_some() => Self::Relaxing,
            (Friction::Coulomb(_), _, None) => Self::Memory,
            (Friction::Coulomb(_), _, Some(_)) => Self::Springs,
            (_, Some(_), _) => Self::Peeling,
            (_, None, _) => Self::Sliding,
        })
    }

    fn name(self) -> &'static str {
        match self {
            Self::Memory => "stick and slip by turning points",
            Self::Springs => "stick and slip by springs",
            Self::Relaxing => "stick and slip by relaxing springs",
            Self::Sliding => "gross sliding on the pressure",
            Self::Peeling => "peeling under shear",
        }
    }

    fn bytes(self, springs: usize) -> usize {
        match self {
            // With as many turning points as fit into the first growths of the list.
            Self::Memory => size_of::<TangentialMemory>() + 8 * TangentialMemory::BYTES_PER_TURN,
            // Depth and slip in the bed; place, depth, slip, loss and way in the map.
            Self::Springs => size_of::<CoulombBed>() + (16 + 40) * springs,
            // Known from the run.
            Self::Relaxing => 0,
            Self::Sliding => size_of::<Tangential>(),
            Self::Peeling => size_of::<ShearedAdhesion>() + size_of::<Tangential>(),
        }
    }
}

/// Springs are equally wide up to this part of the largest contact, and in geometric progression beyond.
pub const GRADE: f64 = 1.0 / 32.0;

/// The number of springs of a viscoelastic scene, asked for or needed by the accuracy; `None` where the
/// continuous bed does without: with adhesion, and for a depth in few straight pieces.
///
/// −1/4 ≤ error·(a/Δx)² ≤ 1/8 and Δx/a = arsinh(1/[`GRADE`])/N: N for half the accuracy.
#[must_use]
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped before")]
pub fn relaxing_springs(setup: &Setup) -> Option<usize> {
    if setup.scene.adhesion.is_some() {
        return None;
    }
    let needed = GRADE.recip().asinh() / (2.0 * setup.accuracy()).sqrt();
    let needed = is_curved(setup).then(|| needed.ceil().clamp(256.0, 262_144.0) as usize);
    setup.scene.springs.map(std::num::NonZeroUsize::get).or(needed)
}

/// Whether the depth of a history is a curve in time: under a prescribed force, and in an oscillation.
#[must_use]
pub fn is_curved(setup: &Setup) -> bool {
    setup.stages.iter().any(Stage::is_curved)
}

/// The plan of a scene with a rough shape.
#[must_use]
pub fn of_rough(setup: &Setup, surface: &Surface) -> Plan {
    let members = surface.seeds.len();
    let mut used = vec!["equivalent rough line", "springs sorted by height"];
    let mut left_out = vec!["real contact area"];
    let mut part = |name, wanted: bool| if wanted { used.push(name) } else { left_out.push(name) };
    part("one-dimensional profile g(x)", setup.profile.flat_radius() <= 0.0);
    part("ensemble", members > 1);
    Plan {
        solver: "rough bed",
        reason: format!(
            "approximate: a line with the spectrum of the surface stands for it, {} springs that touch one by one",
            surface.points
        ),
        used,
        left_out,
        springs: surface.points,
        // Gaps, forces and energies of the members that run at a time are no more than those of all.
        state_bytes: 24 * surface.points,
    }
}

/// The plan of a scene with a plane shape.
#[must_use]
pub fn of_plane(setup: &Setup) -> Plan {
    let (mut used, mut left_out) = (vec!["half-plane"], vec!["one-dimensional profile g(x)", "springs"]);
    let mut part = |name, wanted: bool| if wanted { used.push(name) } else { left_out.push(name) };
    part("gross sliding", setup.scene.friction.is_some());
    let (solver, reason) = match setup.scene.shape {
        Shape::PlaneWave(_) => ("Westergaard", "one period of a wave on the half-plane has a closed form"),
        _ => (
            "Chebyshev series",
            "a contact in one piece on the half-plane: pressure and ends from the series of the slope",
        ),
    };
    Plan { solver, reason: reason.to_owned(), used, left_out, springs: 0, state_bytes: size_of::<PlaneContact>() }
}
