//! Worn profiles and their pressures at chosen times.

use crate::run::table::{Column, Table};
use crate::run::unit::Unit;
use crate::wear::Ring;

/// Parts of a single way of rubbing at which profiles are kept.
pub(super) const PARTS: [f64; 5] = [0.01, 0.03, 0.1, 0.3, 1.0];

/// A worn profile at a time.
pub(super) struct Kept {
    pub time: f64,
    /// Way slid so far, to and fro [m].
    pub path: f64,
    pub rings: Vec<Ring>,
}

/// A row of the table.
#[derive(Clone, Copy)]
struct Row {
    time: f64,
    path: f64,
    ring: Ring,
}

const COLUMNS: [Column<Row>; 6] = [
    Column::new("time", Unit::SECOND, "time t", |row| Some(row.time)),
    Column::new("path", Unit::METRE, "way slid s", |row| Some(row.path)),
    Column::new("radius", Unit::METRE, "radius r", |row| Some(row.ring.radius)),
    Column::new("height", Unit::METRE, "height f", |row| Some(row.ring.height)),
    Column::new("worn_depth", Unit::METRE, "worn depth", |row| Some(row.ring.worn)),
    Column::new("pressure", Unit::PASCAL, "pressure p", |row| Some(row.ring.pressure)),
];

/// The profiles, one block of rows after the other, all over the rings of the last.
pub(super) fn table(mut kept: Vec<Kept>) -> Table {
    let all: Vec<Ring> = kept.last().map_or_else(Vec::new, |last| last.rings.clone());
    for profile in &mut kept {
        let further = all.iter().skip(profile.rings.len());
        let further = further.map(|ring| Ring { height: ring.height - ring.worn, worn: 0.0, pressure: 0.0, ..*ring });
        profile.rings.extend(further);
    }
    let row = |profile: &Kept, ring: &Ring| Row { time: profile.time, path: profile.path, ring: *ring };
    let rows: Vec<Row> = kept.iter().flat_map(|profile| profile.rings.iter().map(|ring| row(profile, ring))).collect();
    Table::new("profiles").with(&COLUMNS, rows.iter())
}
