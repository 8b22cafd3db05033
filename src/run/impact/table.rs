//! Impacts one by one, as tables.

use crate::drive::impact;
use crate::friction::oblique::BallRebound;
use crate::run::table::{Column, Content, Filled, Table};
use crate::run::unit::Unit;
use crate::shape::rough::Scatter;

/// One impact of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct ImpactRow {
    /// Speed before [m/s], along the path.
    pub speed: f64,
    /// What comes of the normal motion.
    pub rebound: impact::Rebound,
    /// Largest pressure [Pa], if there is a finite one.
    pub peak_pressure: Option<f64>,
    /// What comes of the tangential motion, if it is oblique.
    pub oblique: Option<BallRebound>,
}

impl ImpactRow {
    /// Speed of the centre after the impact [m/s]; zero if the bodies stay together.
    #[must_use]
    pub fn rebound_speed(&self) -> f64 {
        match &self.oblique {
            None => self.rebound.restitution * self.speed,
            Some(oblique) => oblique.flight.normal_speed.hypot(oblique.flight.tangential_speed),
        }
    }
}

/// An oblique impact at one angle of incidence.
#[derive(Debug, Clone, PartialEq)]
pub struct Incidence {
    /// Angle of incidence from the normal [rad].
    pub angle: f64,
    /// What comes of it.
    pub rebound: BallRebound,
}

const SPEED: Column<ImpactRow> = Column::new("speed", Unit::METRE_PER_SECOND, "speed v", |row| Some(row.speed));
pub const RESTITUTION: Column<ImpactRow> =
    Column::new("restitution", Unit::ONE, "restitution e", |row| Some(row.rebound.restitution));
pub const REBOUND_SPEED: Column<ImpactRow> =
    Column::new("rebound_speed", Unit::METRE_PER_SECOND, "speed of rebound", |row| Some(row.rebound_speed()));
pub const CONTACT_TIME: Column<ImpactRow> =
    Column::new("contact_time", Unit::SECOND, "contact time", |row| row.rebound.contact_time);
pub const GREATEST_DEPTH: Column<ImpactRow> =
    Column::new("greatest_depth", Unit::METRE, "greatest depth", |row| Some(row.rebound.greatest_depth));
pub const LARGEST_FORCE: Column<ImpactRow> =
    Column::new("largest_force", Unit::NEWTON, "largest force", |row| Some(row.rebound.greatest_force));
const PEAK_PRESSURE: Column<ImpactRow> =
    Column::new("peak_pressure", Unit::PASCAL, "largest pressure", |row| row.peak_pressure);
const STICKS: Column<ImpactRow> =
    Column::new("sticks", Unit::ONE, "stays", |row| Some(f64::from(u8::from(row.rebound.sticks()))));
pub const LOSS: Column<ImpactRow> = Column::new("lost", Unit::JOULE, "energy lost", |row| Some(row.rebound.lost));

const COLUMNS: [Column<ImpactRow>; 9] =
    [SPEED, RESTITUTION, REBOUND_SPEED, CONTACT_TIME, GREATEST_DEPTH, LARGEST_FORCE, PEAK_PRESSURE, STICKS, LOSS];

/// What scatters over random surfaces.
const SCATTERED: [Column<ImpactRow>; 6] =
    [RESTITUTION, REBOUND_SPEED, CONTACT_TIME, GREATEST_DEPTH, LARGEST_FORCE, LOSS];

const ANGLE: Column<Incidence> =
    Column::new("angle", Unit::RADIAN, "angle of incidence", |incidence| Some(incidence.angle));

/// How an oblique impact ends.
pub const AFTER: [Column<BallRebound>; 6] = [
    Column::new("rebound_angle", Unit::RADIAN, "angle of rebound", |rebound| Some(rebound.angle)),
    Column::new("rebound_spin", Unit::RADIAN_PER_SECOND, "spin", |rebound| Some(rebound.flight.spin)),
    Column::new("tangential_restitution", Unit::ONE, "tangential restitution", |rebound| {
        rebound.tangential_restitution
    }),
    Column::new("impulse_ratio", Unit::ONE, "ratio of impulses", |rebound| Some(rebound.impulse_ratio)),
    Column::new("local_incidence", Unit::ONE, "local incidence ψ₁", |rebound| Some(rebound.psi.0)),
    Column::new("local_rebound", Unit::ONE, "local rebound ψ₂", |rebound| Some(rebound.psi.1)),
];

/// What an oblique impact loses.
pub const LOST: Column<BallRebound> =
    Column::new("friction_dissipated", Unit::JOULE, "energy lost to friction", |rebound| Some(rebound.dissipated));

/// Impacts, one row each; with what comes of the tangential motion if they are oblique.
#[must_use]
pub fn impacts(rows: &[ImpactRow]) -> Table {
    let table = Table::new("impacts").with(&COLUMNS, rows.iter());
    let oblique = rows.iter().filter_map(|row| row.oblique.as_ref());
    if oblique.clone().next().is_some() { table.with(&AFTER, oblique.clone()).with(&[LOST], oblique) } else { table }
}

/// Impacts on random surfaces, of each one row per speed: their means, and the standard deviations of more than one. The
/// contact time is that of the surfaces from which the mass comes free, `sticks` the share of those from which it does
/// not.
#[must_use]
pub fn scattered(surfaces: &[Vec<ImpactRow>]) -> Table {
    let rows = 0..surfaces.iter().map(Vec::len).min().unwrap_or(0);
    let filled = |column: &Column<ImpactRow>, what: &str, number: fn(Scatter) -> f64| Filled {
        quantity: format!("{}{what}", column.quantity),
        unit: column.unit,
        label: column.label,
        cells: Content::Numbers(rows.clone().map(|k| over(surfaces, k, column).map(number)).collect()),
    };
    let known = COLUMNS.iter().filter(|column| column.quantity != PEAK_PRESSURE.quantity);
    let means = known.map(|column| filled(column, "", |scatter| scatter.mean));
    let many = SCATTERED.iter().filter(|_| surfaces.len() > 1);
    let deviations = many.map(|column| filled(column, "_deviation", |scatter| scatter.deviation));
    Table { columns: means.chain(deviations).collect(), ..Table::new("impacts") }
}

/// Mean and scatter of a column over random surfaces, at one speed.
#[must_use]
pub fn over(surfaces: &[Vec<ImpactRow>], speed: usize, column: &Column<ImpactRow>) -> Option<Scatter> {
    let rows = surfaces.iter().filter_map(|rows| rows.get(speed));
    Scatter::of(&rows.filter_map(column.of).collect::<Vec<f64>>())
}

/// The impact of the scene at other angles of incidence, one row each; `None` if it has none.
#[must_use]
pub fn incidence(rows: &[Incidence]) -> Option<Table> {
    let rebounds = rows.iter().map(|row| &row.rebound);
    let table = Table::new("incidence").with(&[ANGLE], rows.iter());
    (!rows.is_empty()).then(|| table.with(&AFTER, rebounds.clone()).with(&[LOST], rebounds))
}
