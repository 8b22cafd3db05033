//! Pressure over the radius and stress under the axis.

use crate::app::figure::{Axis, Panel, Series};
use crate::physics::record::{Field, FieldRow, Outcome};
use crate::physics::setup::Setup;

/// Pressure profiles, at most four: the largest contact and the last ones.
pub fn pressure(setup: &Setup, outcome: &Outcome) -> Panel {
    let shown = shown(&outcome.fields);
    let mean = shown.iter().map(|field| mean_pressure(field)).fold(0.0, f64::max);
    let singular = shown.iter().any(|field| field.stress_intensity.is_some());
    // A singular edge or apex would leave no room for the rest of the curve.
    let least = shown.iter().flat_map(|field| &field.rows).filter_map(|row| row.pressure).fold(0.0, f64::min);
    let most = shown.iter().flat_map(|field| &field.rows).filter_map(|row| row.pressure).fold(0.0, f64::max);
    let mut axis = Axis::linear("pressure p", "Pa");
    if singular || most > 4.0 * mean {
        axis = axis.from(least.max(-3.0 * mean.abs())).to(most.min(4.0 * mean.abs()));
    }
    let panel = Panel::new(Axis::linear("radius r", "m").from(0.0), axis);
    let panel = shown.iter().fold(panel, |panel, field| panel.with(curve(field)));
    if singular && setup.scene.adhesion.is_some() {
        return panel.note("The edge is singular: p → −∞ as r → a; the curve is cut off there.");
    }
    if singular { panel.note("The edge is singular: p → ∞ as r → a; the curve is cut off there.") } else { panel }
}

fn shown(fields: &[Field]) -> Vec<&Field> {
    let largest = fields.iter().max_by(|x, y| x.contact_radius.total_cmp(&y.contact_radius));
    let mut shown: Vec<&Field> = largest.into_iter().collect();
    for field in fields.iter().rev() {
        let same = shown.iter().any(|other| (other.contact_radius - field.contact_radius).abs() <= 0.0);
        if shown.len() < 4 && !same {
            shown.push(field);
        }
    }
    shown
}

fn mean_pressure(field: &Field) -> f64 {
    let inside = field.rows.iter().filter(|row| row.radius < field.contact_radius);
    let pressures: Vec<f64> = inside.filter_map(|row| row.pressure).map(f64::abs).collect();
    pressures.iter().sum::<f64>() / (pressures.len().max(1) as f64)
}

fn curve(field: &Field) -> Series {
    let point = |row: &FieldRow| (row.radius, row.pressure.unwrap_or(f64::NAN));
    let until =
        |row: &&FieldRow| row.radius <= 1.5 * field.contact_radius || row.pressure.is_some_and(|p| p.abs() > 0.0);
    Series::new(field.label.clone(), field.rows.iter().filter(until).map(point).collect())
}

/// Stresses on the axis at the largest force.
pub fn stress(outcome: &Outcome) -> Panel {
    let of = |value: fn(&crate::physics::record::StressRow) -> f64| {
        outcome.stresses.iter().map(|row| (row.depth, value(row))).collect::<Vec<_>>()
    };
    Panel::new(Axis::linear("depth z on the axis", "m").from(0.0), Axis::linear("stress", "Pa"))
        .with(Series::new("axial σ_zz", of(|row| row.axial)))
        .with(Series::new("radial σ_xx", of(|row| row.radial)))
        .with(Series::new("largest shear", of(|row| row.shear)))
}
