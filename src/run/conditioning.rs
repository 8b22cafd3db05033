//! How far rounding moves an edge: near a turning point the radius is known to few digits.

use crate::contact::adhesion::equilibrium::{Control, Equilibrium};
use crate::contact::adhesion::line::EdgeLine;
use crate::contact::adhesion::sprung::Sprung;
use crate::run::record::Record;
use crate::scene::plan::RoundPlan;

/// Error of a radius at a turning point: the root of the rounding.
const TURNING: f64 = 1e-7;

/// Largest relative error of a radius under the work of adhesion `work` [J/m²] from the rounding of what is
/// prescribed, Q = d or F: δa = 4ε·(terms of Q)/(dQ/da), at most that of a turning point.
///
/// The states just before a jump are roots of the slope itself, and not moved by it.
#[must_use]
pub fn moved_edge(plan: &RoundPlan, work: f64, records: &[Record]) -> f64 {
    let line = EdgeLine::new(plan.ground(), work);
    let line = Sprung { curve: &line, compliance: plan.spring.map_or(0.0, f64::recip) };
    let first = |entry: usize| plan.stages.partition_point(|stage| stage.entry < entry);
    let control = |entry: usize| plan.stages.get(first(entry))?.control;
    let largest = records.iter().filter_map(|record| record.normal.contact_radius).fold(0.0, f64::max);
    let largest = plan.profile.place(largest);
    let jumps = |at: usize| records.get(at + 1).is_some_and(|next| (next.time - records[at].time).abs() <= 0.0);
    let states = records.iter().enumerate().filter(|(at, _)| !jumps(*at)).map(|(_, record)| record);
    let error = |record: &Record| {
        let control = control(record.entry)?;
        let place = plan.profile.place(record.normal.contact_radius?);
        Some((moved(&line, control, place, plan.pair.normal)? / largest).min(TURNING))
    };
    states.filter_map(error).fold(0.0, f64::max)
}

/// How far rounding moves an edge at the radius `a` [m].
fn moved(line: &Sprung<'_, EdgeLine>, control: Control, a: f64, modulus: f64) -> Option<f64> {
    if a <= 0.0 || a >= line.end() {
        return None;
    }
    let (stretched, pulled) = (line.curve.elongation(a), 2.0 * modulus * a * line.curve.elongation(a));
    let elongation = match control {
        Control::Indentation => stretched + line.compliance * pulled,
        Control::Force => pulled,
    };
    let terms = line.value(control, a).abs() + 2.0 * elongation;
    Some(4.0 * f64::EPSILON * terms / line.slope(control, a).abs()).filter(|moved| !moved.is_nan())
}
