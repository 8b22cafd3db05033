//! Records of many random surfaces: their mean and scatter.

use super::named::Named;
use super::record::Record;
use super::table::{Column, Table};
use super::unit::Unit;
use crate::contact::adhesion::line::Energy;
use crate::contact::state::{Gliding, Normal, Tangential};
use crate::shape::rough::Scatter;

/// Mean and scatter over many random surfaces.
#[derive(Debug, Clone, PartialEq)]
pub struct Ensemble {
    /// Number of members.
    members: usize,
    /// One row per record.
    rows: Vec<Scattered>,
}

/// One record of an [`Ensemble`].
#[derive(Debug, Clone, Copy, PartialEq)]
struct Scattered {
    /// Mean time [s].
    time: f64,
    /// Indentation d [m].
    indentation: Scatter,
    /// Normal force F [N].
    force: Scatter,
    /// Stiffness dF/dd [N/m].
    stiffness: Scatter,
}

const TIME: Column<Scattered> = Column::new("time", Unit::SECOND, "time t", |row| Some(row.time));

/// Columns of a quantity in a unit.
const fn scatter(unit: Unit) -> [Column<Scatter>; 4] {
    [
        Column::new("mean", unit, "mean", |scatter| Some(scatter.mean)),
        Column::new("deviation", unit, "standard deviation", |scatter| Some(scatter.deviation)),
        Column::new("least", unit, "least", |scatter| Some(scatter.range.0)),
        Column::new("greatest", unit, "greatest", |scatter| Some(scatter.range.1)),
    ]
}

impl Ensemble {
    /// Mean and scatter of every record over the members; `None` for a member alone.
    #[must_use]
    pub fn of(members: &[Vec<Record>]) -> Option<Self> {
        let row = |k: usize| {
            Some(Scattered {
                time: over(members, k, |record| record.time)?.mean,
                indentation: over(members, k, |record| record.normal.indentation.unwrap_or(0.0))?,
                force: over(members, k, |record| record.normal.force)?,
                stiffness: over(members, k, |record| record.normal.stiffness)?,
            })
        };
        (members.len() > 1)
            .then(|| Self { members: members.len(), rows: (0..shortest(members)).filter_map(row).collect() })
    }

    /// Largest standard deviation of the depth, the force or the stiffness, each as a part of its largest mean.
    #[must_use]
    pub fn relative_deviation(&self) -> f64 {
        let of = |of: fn(&Scattered) -> Scatter| {
            let scatters = self.rows.iter().map(of);
            let (mean, deviation) = scatters.fold((0.0, 0.0), |most: (f64, f64), scatter| {
                (most.0.max(scatter.mean.abs()), most.1.max(scatter.deviation))
            });
            if mean > 0.0 { deviation / mean } else { 0.0 }
        };
        of(|row| row.indentation).max(of(|row| row.force)).max(of(|row| row.stiffness))
    }

    /// Mean and scatter, one row per record.
    #[must_use]
    pub fn table(&self) -> Table {
        let rows = self.rows.iter();
        Table::new("ensemble")
            .with(&[TIME], rows.clone())
            .with_each("indentation_", &scatter(Unit::METRE), rows.clone().map(|row| &row.indentation))
            .with_each("force_", &scatter(Unit::NEWTON), rows.clone().map(|row| &row.force))
            .with_each("stiffness_", &scatter(Unit::NEWTON_PER_METRE), rows.map(|row| &row.stiffness))
    }

    /// Number of members, and the largest deviation between them.
    #[must_use]
    pub fn results(&self) -> Vec<Named> {
        let largest = |of: fn(&Scattered) -> Scatter| self.rows.iter().map(|row| of(row).deviation).fold(0.0, f64::max);
        vec![
            Named::count("members", self.members),
            Named::number("largest_force_deviation", Unit::NEWTON, largest(|row| row.force)),
            Named::number("largest_indentation_deviation", Unit::METRE, largest(|row| row.indentation)),
            Named::number("largest_stiffness_deviation", Unit::NEWTON_PER_METRE, largest(|row| row.stiffness)),
        ]
    }
}

/// The mean of the members, record by record.
#[must_use]
pub fn mean(members: &[Vec<Record>]) -> Vec<Record> {
    let record = |(k, record): (usize, &Record)| {
        let mean = |of: fn(&Record) -> f64| over(members, k, of).map(|scatter| scatter.mean);
        let indentation = mean(|record| record.normal.indentation.unwrap_or(0.0))?;
        let normal = Normal {
            indentation: record.normal.indentation.map(|_| indentation),
            force: mean(|record| record.normal.force)?,
            stiffness: mean(|record| record.normal.stiffness)?,
            stored: Energy {
                elastic: mean(|record| record.normal.stored.elastic)?,
                surface: mean(|record| record.normal.stored.surface)?,
            },
            dissipated: mean(|record| record.normal.dissipated)?,
            ..record.normal
        };
        let rubbed = |of: fn(&Tangential) -> f64| over(members, k, |record| record.tangential.as_ref().map_or(0.0, of));
        let tangential = record.tangential.map(|state| {
            Some(Tangential {
                force: rubbed(|state| state.force)?.mean,
                stick_radius: rubbed(|state| state.stick_radius)?.mean,
                stiffness: rubbed(|state| state.stiffness)?.mean,
                stored: state.stored.and(Some(rubbed(|state| state.stored.unwrap_or(0.0))?.mean)),
                dissipated: state.dissipated.and(Some(rubbed(|state| state.dissipated.unwrap_or(0.0))?.mean)),
                ..state
            })
        });
        let resistance = |record: &Record| record.gliding.map_or(0.0, |state| state.resistance);
        let gliding = record.gliding.and_then(|state| Some(Gliding { resistance: mean(resistance)?, ..state }));
        Some(Record { time: mean(|record| record.time)?, normal, tangential: tangential.flatten(), gliding, ..*record })
    };
    let first = members.first().map_or(&[][..], |first| &first[..shortest(members)]);
    first.iter().enumerate().filter_map(record).collect()
}

/// Mean and scatter of the k-th record.
fn over(members: &[Vec<Record>], k: usize, of: impl Fn(&Record) -> f64) -> Option<Scatter> {
    Scatter::of(&members.iter().filter_map(|records| records.get(k).map(&of)).collect::<Vec<_>>())
}

/// Records all members have.
fn shortest(members: &[Vec<Record>]) -> usize {
    members.iter().map(Vec::len).min().unwrap_or(0)
}
