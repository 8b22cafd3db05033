//! The surfaces of both bodies under the greatest force.

use super::fields;
use super::follow::Run;
use super::table::{Column, Table};
use super::unit::Unit;
use crate::material::Shares;
use crate::run::record::FieldRow;
use crate::scene::plan::RoundPlan;

/// Heights over the plane that the surface of the lower body was.
struct Row {
    time: f64,
    radius: f64,
    /// Of the indenter as it was, f(r) − d [m]; none beyond its end.
    shape: Option<f64>,
    /// Of the surface of the upper body.
    upper: Option<f64>,
    /// Of the surface of the lower body.
    lower: Option<f64>,
}

const COLUMNS: [Column<Row>; 5] = [
    Column::new("time", Unit::SECOND, "time t", |row| Some(row.time)),
    Column::new("radius", Unit::METRE, "radius r", |row| Some(row.radius)),
    Column::new("shape", Unit::METRE, "shape f(r) − d", |row| row.shape),
    Column::new("upper", Unit::METRE, "upper surface", |row| row.upper),
    Column::new("lower", Unit::METRE, "lower surface", |row| row.lower),
];

/// Surfaces of both bodies over the radius at the greatest force.
///
/// The stiffer body is drawn above with the shape, the softer one below as a half-space that was plane: for the contact it does not
/// matter which of them has it. Of the displacement u_z(r) the bodies take their [`Shares`]: the lower surface lies at
/// −s u_z, the upper one at f(r) − d + (1 − s) u_z; in the contact u_z = d − f(r), and they meet.
pub(super) fn table(plan: &RoundPlan, run: &Run) -> Option<Table> {
    let (contact, time) = run.at_greatest_force().filter(|_| run.wanted().surface)?;
    let softer = Shares::of(&plan.scene.bodies)?.of_softer();
    let loading = contact.loading()?;
    let depth = contact.sheared().indentation?;
    let (profile, rim) = (&plan.profile, plan.profile.rim().radius());
    let row = |&FieldRow { radius, displacement, .. }: &FieldRow| {
        let shape = (radius <= rim).then(|| profile.height(radius) - depth);
        let upper = shape.zip(displacement).map(|(shape, u)| shape + (1.0 - softer) * u);
        Row { time, radius, shape, upper, lower: displacement.map(|u| -softer * u) }
    };
    let field = fields::of(loading.as_ref(), None, (String::new(), time));
    let rows: Vec<Row> = field.rows.iter().map(row).collect();
    Some(Table::new("surface").with(&COLUMNS, rows.iter()))
}
