//! Where in the contact friction takes its energy.

use super::table::{Column, Table};
use super::unit::Unit;
use crate::friction::{Pose, WearMap};
use crate::scene::law::FrictionLaw;
use crate::scene::plan::RoundPlan;
use crate::scene::stage::{Extent, Path, Stage};
use std::f64::consts::FRAC_PI_2;

/// Positions of the map, denser towards the edge.
const POSITIONS: usize = 192;

/// Whether the scene is one of fretting: Coulomb friction, and a tangential motion to and fro.
#[must_use]
pub fn is_fretting(plan: &RoundPlan) -> bool {
    let to_and_fro = |stage: &Stage| match stage.tangential {
        Path::Stay | Path::Steady { .. } | Path::UntilParted { .. } => false,
        Path::To(_) => stage.extent == Extent::Row,
        Path::Wave(_) => true,
    };
    !plan.profile.is_plane() && coefficient(plan).is_some() && plan.stages.iter().any(to_and_fro)
}

fn coefficient(plan: &RoundPlan) -> Option<f64> {
    plan.friction.as_ref().and_then(FrictionLaw::coulomb)
}

/// Energy lost to friction at one position, gathered over the whole history.
struct Lost {
    /// Distance from the axis [m]: of a spring x, and of the surface r.
    position: f64,
    /// Energy per length over x lost by the springs of both halves of the bed [J/m].
    per_length: f64,
    /// Energy per area lost at the surface [J/m²]; wear is proportional to it.
    per_area: f64,
}

const COLUMNS: [Column<Lost>; 3] = [
    Column::new("radius", Unit::METRE, "radius r", |lost| Some(lost.position)),
    Column::new("energy", Unit::JOULE_PER_SQUARE_METRE, "energy lost per area", |lost| Some(lost.per_area)),
    Column::new("spring_energy", Unit::JOULE_PER_METRE, "energy lost per length", |lost| Some(lost.per_length)),
];

/// The fretting map of a path of straight steps: energy lost to friction over the distance from the axis.
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "few positions")]
pub fn map(plan: &RoundPlan, path: &[Pose]) -> Option<Table> {
    let coefficient = coefficient(plan).filter(|_| !path.is_empty())?;
    let profile = plan.profile.as_ref();
    let deepest = path.iter().map(|at| at.indentation).fold(0.0, f64::max);
    let a = profile.edge(deepest).filter(|&a| a > 0.0)?;
    let at = |k: usize| a * (FRAC_PI_2 * k as f64 / POSITIONS as f64).sin();
    let positions: Vec<f64> = (0..=POSITIONS).map(at).collect();
    let mut map = WearMap::new(plan.profile.clone(), plan.grip(coefficient), &positions);
    for &to in path {
        map.advance(to);
    }
    let springs = map.springs().energy();
    let rows = positions.iter().zip(springs).zip(map.energy());
    let lost = |((&position, per_length), &per_area)| Lost { position, per_length, per_area };
    Some(Table::new("fretting").with(&COLUMNS, rows.map(lost).collect::<Vec<_>>().iter()))
}
