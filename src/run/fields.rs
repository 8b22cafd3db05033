//! Fields over the radius.

use super::table::{Column, Table};
use super::unit::Unit;
use crate::contact::model::{ContactModel, Loading};
use crate::contact::state::Tangential;
use crate::run::record::{Field, FieldRow, Record};
use std::f64::consts::FRAC_PI_2;

/// Radii inside the contact, denser towards the edge.
const INSIDE: usize = 160;
/// Radii outside, out to three times the reach of the contact.
const OUTSIDE: usize = 64;

/// Pressure, shear stress and surface of a contact; `None` where the bodies are apart.
#[must_use]
pub fn field(contact: &dyn ContactModel, label: String, time: f64) -> Option<Field> {
    Some(of(contact.loading()?.as_ref(), contact.tangential(), (label, time)))
}

/// The same of a load.
pub fn of(loading: &dyn Loading, tangential: Option<Tangential>, (label, time): (String, f64)) -> Field {
    let a = loading.contact_radius();
    let mut radii = radii(a, loading.reach());
    radii.extend(about_stick(tangential.map(|state| state.stick_radius), a));
    radii.sort_by(f64::total_cmp);
    let row = |(&radius, shear): (&f64, Option<f64>)| {
        let (pressure, displacement) = (loading.pressure(radius), loading.surface(radius));
        FieldRow { radius, pressure, displacement, shear }
    };
    let rows: Vec<FieldRow> = radii.iter().zip(loading.shear(&radii)).map(row).collect();
    let carried = rows.iter().filter(|row| row.radius < a).filter_map(|row| Some((row.radius, row.pressure?)));
    let peak = loading.peak_among(&carried.collect::<Vec<_>>());
    Field { label, time, contact_radius: a, stress_intensity: loading.stress_intensity(), peak, rows }
}

/// Radii on both sides of the border of stick, where the shear stress has a corner.
fn about_stick(stick_radius: Option<f64>, a: f64) -> Vec<f64> {
    let border = stick_radius.filter(|&c| c > 0.0 && c < a);
    let beside = |c: f64| [-2e-2, -8e-3, -2e-3, -2e-4, 2e-4].map(|part| (1.0 + part) * c);
    border.map_or_else(Vec::new, |c| beside(c).into_iter().filter(|&r| r < a).collect())
}

/// Adds the field at the largest depth to those at the ends of the entries; where it is one of them, its
/// label says so.
pub fn with_deepest(fields: &mut Vec<Field>, deepest: Option<Field>) {
    let Some(deepest) = deepest else { return };
    let same = |field: &&mut Field| (field.time - deepest.time).abs() <= 0.0 && field.rows == deepest.rows;
    if let Some(end) = fields.iter_mut().find(same) {
        end.label.push_str(" (largest depth)");
        return;
    }
    let place = fields.iter().position(|field| field.time > deepest.time).unwrap_or(fields.len());
    fields.insert(place, deepest);
}

#[expect(clippy::cast_precision_loss, reason = "few radii")]
fn radii(a: f64, reach: f64) -> Vec<f64> {
    let inside = (0..=INSIDE).map(|k| a * (FRAC_PI_2 * k as f64 / INSIDE as f64).sin());
    let ring = (1..=INSIDE / 4).map(|k| a + (reach - a) * k as f64 / (INSIDE / 4) as f64);
    let outside = (1..=OUTSIDE).map(|k| reach * (1.0 + 2.0 * (k as f64 / OUTSIDE as f64).powi(2)));
    let mut all: Vec<f64> = inside.filter(|_| a > 0.0).collect();
    if reach > a {
        all.extend(ring);
    }
    all.extend(outside);
    all
}

/// A row of the table of pressures.
const COLUMNS: [Column<(f64, FieldRow)>; 4] = [
    Column::new("time", Unit::SECOND, "time t", |(time, _)| Some(*time)),
    Column::new("radius", Unit::METRE, "radius r", |(_, row)| Some(row.radius)),
    Column::new("pressure", Unit::PASCAL, "pressure p", |(_, row)| row.pressure),
    Column::new("surface_displacement", Unit::METRE, "surface displacement u", |(_, row)| row.displacement),
];
const SHEAR: Column<(f64, FieldRow)> = Column::new("shear", Unit::PASCAL, "shear stress τ", |(_, row)| row.shear);

/// Pressure and surface over the radius, one block of rows per field, named in the first column; with the
/// shear stress if the scene has friction.
#[must_use]
pub fn pressure_table(fields: &[Field], records: &[Record]) -> Option<Table> {
    let sheared = records.iter().any(|record| record.tangential.is_some());
    let rows: Vec<(f64, FieldRow)> =
        fields.iter().flat_map(|field| field.rows.iter().map(|row| (field.time, *row))).collect();
    let labels = fields.iter().flat_map(|field| field.rows.iter().map(|_| field.label.clone())).collect();
    let table = Table::new("pressure").with_words("profile", labels).with(&COLUMNS, rows.iter());
    let table = if sheared { table.with(&[SHEAR], rows.iter()) } else { table };
    (!fields.is_empty()).then_some(table)
}
