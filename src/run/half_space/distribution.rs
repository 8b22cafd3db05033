//! How often a pressure and a gap occur.

use super::pressed::Pressed;
use crate::run::table::{Column, Table};
use crate::run::unit::Unit;

/// Classes of the pressure and of the gap.
const CLASSES: usize = 48;
/// States shown.
const SHOWN: usize = 5;

/// Shares of the nominal area by pressure and by gap, under one force.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Distribution {
    force: f64,
    rows: Vec<Class>,
}

/// One class of both.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Class {
    force: f64,
    pressure: f64,
    of_pressure: f64,
    gap: f64,
    of_gap: f64,
}

const COLUMNS: [Column<Class>; 5] = [
    Column::new("force", Unit::NEWTON, "force F", |class| Some(class.force)),
    Column::new("pressure", Unit::PASCAL, "pressure p", |class| Some(class.pressure)),
    Column::new("pressure_density", Unit::PER_PASCAL, "density of the pressure", |class| Some(class.of_pressure)),
    Column::new("gap", Unit::METRE, "gap g", |class| Some(class.gap)),
    Column::new("gap_density", Unit::PER_METRE, "density of the gap", |class| Some(class.of_gap)),
];

impl Distribution {
    /// Of the pixels in contact the pressure, of the others the gap; both densities together have the integral one,
    /// but for pixels without material.
    pub(super) fn of(pressed: &Pressed, force: f64) -> Self {
        let (gap, pushes, pressure) = (&pressed.gap, &pressed.contact.pressure, pressed.pressure());
        let touching = pressure.iter().zip(pushes).filter(|(_, pushes)| **pushes > 0.0).map(|(pressure, _)| *pressure);
        let apart = gap.iter().zip(pushes).filter(|(gap, pushes)| **pushes <= 0.0 && gap.is_finite()).map(|(g, _)| *g);
        let pixels = gap.len();
        let (pressures, gaps) = (classes(touching, pixels), classes(apart, pixels));
        let class = |((pressure, of_pressure), (gap, of_gap))| Class { force, pressure, of_pressure, gap, of_gap };
        Self { force, rows: pressures.into_iter().zip(gaps).map(class).collect() }
    }
}

/// Middles and densities of equal classes from zero, or the least value below it, to the largest, of `pixels` in all.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the classes")]
fn classes(values: impl Iterator<Item = f64> + Clone, pixels: usize) -> Vec<(f64, f64)> {
    let largest = values.clone().fold(0.0, f64::max);
    let least = values.clone().fold(0.0, f64::min);
    let width = if largest > least { (largest - least) / CLASSES as f64 } else { 1.0 };
    let mut counts = [0usize; CLASSES];
    values.for_each(|value| counts[(((value - least) / width) as usize).min(CLASSES - 1)] += 1);
    let share = |count: usize| count as f64 / (pixels as f64 * width);
    counts.iter().enumerate().map(|(k, &count)| (least + (k as f64 + 0.5) * width, share(count))).collect()
}

/// Distributions under the largest force and about halves of it, the least first.
pub(super) fn table(distributions: &[Distribution]) -> Option<Table> {
    let largest = distributions.iter().map(|one| one.force).reduce(f64::max).filter(|&force| force > 0.0)?;
    let mut chosen: Vec<&Distribution> = Vec::new();
    for halvings in 0..SHOWN {
        let wanted = largest * 0.5_f64.powi(i32::try_from(halvings).unwrap_or(0));
        let far = |one: &&Distribution| (one.force / wanted).ln().abs();
        let nearest = distributions.iter().min_by(|one, other| far(one).total_cmp(&far(other)));
        chosen.extend(nearest.filter(|one| far(one) < 0.35 && chosen.iter().all(|known| known.force > one.force)));
    }
    chosen.reverse();
    let rows: Vec<Class> = chosen.iter().flat_map(|one| one.rows.iter().copied()).collect();
    Some(Table::new("distribution").with(&COLUMNS, rows.iter()))
}
