//! Which parts a scene needs, decided once.

use super::adhesion::Adhesion;
use super::quasistatic::QuasiStatic;
use super::record::Plan;
use super::setup::Setup;

/// The plan of a scene.
#[must_use]
pub fn of(setup: &Setup) -> Plan {
    let scene = &setup.scene;
    let (mut used, mut left_out) = (vec!["one-dimensional profile g(x)"], Vec::new());
    let mut part = |name, wanted: bool| if wanted { used.push(name) } else { left_out.push(name) };
    part("adhesion of vanishing range (JKR)", matches!(scene.adhesion, Some(Adhesion::Jkr(_))));
    part("adhesion of finite range (Maugis–Dugdale)", matches!(scene.adhesion, Some(Adhesion::Maugis(_))));
    part("Prony elements", setup.relaxation.is_some());
    part("friction", scene.friction.is_some());
    part("springs", scene.springs.is_some());
    let springs = scene.springs.map_or(0, std::num::NonZeroUsize::get);
    let (solver, reason) = match scene.springs {
        None => ("direct", "the state depends on the present depth or force alone: the edge is a root of the equilibrium on g(x) and the force an integral up to it; no spring is allocated".to_owned()),
        Some(count) => ("springs", format!("`springs: {count}` asks for the classical bed")),
    };
    Plan { solver, reason, used, left_out, springs, state_bytes: size_of::<QuasiStatic<'_>>() + 16 * springs }
}
