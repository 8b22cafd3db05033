//! Where in the contact friction takes its energy.

use super::shear;
use crate::friction::{Friction, Pose, WearMap};
use crate::run::record::FrettingRow;
use crate::scene::setup::Setup;
use crate::scene::stage::{Extent, Path, Stage};
use std::f64::consts::FRAC_PI_2;

/// Positions of the map, denser towards the edge.
const POSITIONS: usize = 192;

/// Whether the scene is one of fretting: Coulomb friction, and a tangential motion to and fro.
#[must_use]
pub fn is_fretting(setup: &Setup) -> bool {
    let to_and_fro = |stage: &Stage| match stage.tangential {
        Path::Stay | Path::UntilParted { .. } => false,
        Path::To(_) => stage.extent == Extent::Row,
        Path::Wave { .. } => true,
    };
    matches!(setup.scene.friction, Some(Friction::Coulomb(_))) && setup.stages.iter().any(to_and_fro)
}

/// The fretting map of a path of straight steps.
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "few positions")]
pub fn map(setup: &Setup, path: &[Pose]) -> Vec<FrettingRow> {
    let Some(Friction::Coulomb(law)) = setup.scene.friction.as_ref().filter(|_| !path.is_empty()) else {
        return Vec::new();
    };
    let profile = setup.profile.as_ref();
    let deepest = path.iter().map(|at| at.indentation).fold(0.0, f64::max);
    let Some(a) = profile.edge(deepest).filter(|&a| a > 0.0) else { return Vec::new() };
    let at = |k: usize| a * (FRAC_PI_2 * k as f64 / POSITIONS as f64).sin();
    let positions: Vec<f64> = (0..=POSITIONS).map(at).collect();
    let mut map = WearMap::new(setup.profile.clone(), shear::grip(setup, law), &positions);
    for &to in path {
        map.advance(to);
    }
    let springs = map.springs().energy();
    let rows = positions.iter().zip(springs).zip(map.energy());
    rows.map(|((&position, per_length), &per_area)| FrettingRow { position, per_length, per_area }).collect()
}
