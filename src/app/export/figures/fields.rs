//! Pressure over the radius.

use super::curve::short;
use crate::app::figure::{Axis, Guide, Panel, Series};
use crate::run::record::{Field, FieldRow, Outcome};
use crate::scene::plan::Plan;

/// The radius or, in a plane contact, the place.
pub(super) fn across(plan: &Plan) -> Axis {
    Axis::linear(if plan.scene.shape.is_plane() { "place x" } else { "radius r" }, "m").from(0.0)
}

/// Pressure profiles over the radius or, in a plane contact, the place; at most four: the largest contact and the last ones.
pub fn pressure(plan: &Plan, outcome: &Outcome) -> Panel {
    let shown = shown(&outcome.fields);
    let pressures = Pressures::of(&shown);
    let panel = Panel::new(across(plan), pressures.axis());
    let panel = shown.iter().fold(panel, |panel, field| panel.with(curve(field)));
    let edge = largest(&shown).map(|field| field.contact_radius).filter(|&a| a > 0.0);
    let panel = edge.into_iter().fold(panel, |panel, a| panel.guide(Guide::vertical(a, "a")));
    let across = if plan.scene.shape.is_plane() { 'x' } else { 'r' };
    pressures.notes(across).into_iter().fold(panel, Panel::note)
}

/// What the pressures shown reach, and where they have no bound.
struct Pressures {
    least: f64,
    most: f64,
    mean: f64,
    /// Some edge pulls without bound.
    pulls: bool,
    /// Some edge presses without bound.
    presses: bool,
    /// The pressure at the axis has no bound.
    pointed: bool,
}

impl Pressures {
    fn of(shown: &[&Field]) -> Self {
        let edge = |sign: f64| shown.iter().any(|field| field.stress_intensity.is_some_and(|k| k * sign > 0.0));
        let pressures = || shown.iter().flat_map(|field| &field.rows).filter_map(|row| row.pressure);
        Self {
            least: pressures().fold(0.0, f64::min),
            most: pressures().fold(0.0, f64::max),
            mean: shown.iter().map(|field| mean_pressure(field)).fold(0.0, f64::max),
            pulls: edge(1.0),
            presses: edge(-1.0),
            pointed: shown.iter().any(|field| {
                field.rows.first().is_some_and(|row| row.pressure.is_none() && row.radius < field.contact_radius)
            }),
        }
    }

    /// An axis on which a pressure without bound leaves room for the rest of the curve.
    fn axis(&self) -> Axis {
        let mut axis = Axis::linear("pressure p", "Pa");
        if self.presses || self.pointed {
            axis = axis.to(self.most.min(4.0 * self.mean));
        } else if self.pulls && self.most > 0.0 {
            axis = axis.to(1.08 * self.most);
        }
        let depth = if self.most > 0.0 && !self.presses { self.most } else { 3.0 * self.mean };
        if self.pulls { axis.from(self.least.max(-depth)) } else { axis }
    }

    fn notes(&self, across: char) -> Vec<String> {
        let edge = match (self.pulls, self.presses) {
            (true, true) => Some("±∞"),
            (true, false) => Some("−∞"),
            (false, true) => Some("∞"),
            (false, false) => None,
        };
        let edge = edge.map(|bound| {
            format!("The edge is singular: p → {bound} as {across} → a; what goes beyond is cut off there.")
        });
        let tip = "The tip is a point: p → ∞ as r → 0; the curve is cut off there.".to_owned();
        edge.into_iter().chain(self.pointed.then_some(tip)).collect()
    }
}

/// At most four, in the order of time: the largest contact and the last ones.
pub fn shown(fields: &[Field]) -> Vec<&Field> {
    let all: Vec<&Field> = fields.iter().collect();
    let mut shown: Vec<&Field> = largest(&all).into_iter().collect();
    for field in fields.iter().rev() {
        let same = shown.iter().any(|other| (other.contact_radius - field.contact_radius).abs() <= 0.0);
        if shown.len() < 4 && !same {
            shown.push(field);
        }
    }
    shown.sort_by(|one, other| one.time.total_cmp(&other.time));
    shown
}

/// The field of the largest contact.
pub fn largest<'f>(fields: &[&'f Field]) -> Option<&'f Field> {
    fields.iter().copied().max_by(|x, y| x.contact_radius.total_cmp(&y.contact_radius))
}

fn mean_pressure(field: &Field) -> f64 {
    let inside = field.rows.iter().filter(|row| row.radius < field.contact_radius);
    let pressures: Vec<f64> = inside.filter_map(|row| row.pressure).map(f64::abs).collect();
    pressures.iter().sum::<f64>() / (pressures.len().max(1) as f64)
}

fn curve(field: &Field) -> Series {
    let point = |row: &FieldRow| row.pressure.map(|pressure| (row.radius, pressure));
    let acts = |row: &&FieldRow| row.pressure.is_some_and(|p| p.abs() > 0.0);
    let reach = field.rows.iter().filter(acts).map(|row| row.radius).fold(field.contact_radius, f64::max);
    let rows = field.rows.iter().filter(|row| row.radius <= 1.4 * reach);
    let label = format!("{}, a = {}", field.label, short(field.contact_radius, "m"));
    Series::new(label, rows.map(point))
}
