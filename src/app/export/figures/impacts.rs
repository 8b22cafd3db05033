//! Figures of impacts.

use super::curve::{against_time, axis, log, marked, points};
use crate::app::figure::{Axis, Guide, Marks, Panel, Series};
use crate::run::record::{INDENTATION, Record};
use crate::run::table::{Column, Table};

/// Depth, `force` and `radius` over time.
pub fn over_time(records: &[Record], [force, radius]: [&Column<Record>; 2]) -> Vec<Panel> {
    [&INDENTATION, force, radius].into_iter().map(|column| against_time(records, column)).collect()
}

/// Restitution against speed; impacts after which the bodies stay together, on all surfaces of an ensemble, are marked on
/// the axis.
pub fn restitution(impacts: &Table) -> Option<Panel> {
    let (speed, restitution) = (impacts.column("speed")?, impacts.column("restitution")?);
    let mut panel = Panel::new(log(axis(speed)), axis(restitution).from(0.0).to(1.0));
    let sticks = impacts.column("sticks")?.numbers();
    let mut rows: Vec<_> =
        points(speed, restitution).into_iter().zip(sticks).filter_map(|(point, sticks)| point.zip(*sticks)).collect();
    rows.sort_by(|(one, _), (other, _)| one.0.total_cmp(&other.0));
    let (stuck, free): (Vec<_>, Vec<_>) = rows.into_iter().partition(|(_, sticks)| *sticks >= 1.0);
    let names = if stuck.is_empty() { ("", "") } else { ("comes free", "stays") };
    if !free.is_empty() {
        let series = Series::new(names.0, free.iter().map(|(point, _)| *point));
        panel = panel.with(if free.len() <= MARKED { series.marks(Marks::Numbered) } else { series });
    }
    if stuck.is_empty() {
        return Some(panel);
    }
    let stuck = stuck.iter().map(|(point, _)| (point.0, 0.0));
    Some(panel.with(marked(names.1, stuck, Marks::Numbered)))
}

/// Most points of a curve that are marked one by one.
const MARKED: usize = 40;

/// Local angles of incidence and rebound, and the rebound over the angle of the path.
///
/// ψ = (G*/μE*) w/v with w the speed of the contact point along the surface and v the normal speed
/// before the impact (Maw, Barber & Fawcett 1976); `angle` is the scene's own [rad].
pub fn incidence(angle: f64, incidence: &Table, impacts: &Table) -> Option<Vec<Panel>> {
    let (before, after) = (incidence.column("local_incidence")?, incidence.column("local_rebound")?);
    let mut local = points(before, after);
    // Beyond gross slip all along the curve is a straight line: only its beginning is shown.
    local.retain(|point| point.is_some_and(|(incidence, _)| incidence.abs() <= LARGEST_LOCAL));
    let local = Panel::new(axis(before), axis(after)).with(Series::new("", local)).guide(Guide::horizontal(0.0, ""));
    let (path, rebound) = (incidence.column("angle")?, incidence.column("rebound_angle")?);
    let degrees = |point: (f64, f64)| (point.0.to_degrees(), point.1.to_degrees());
    let angles = points(path, rebound).into_iter().map(|point| point.map(degrees));
    let angles =
        Panel::new(Axis::linear(path.label, "°"), Axis::linear(rebound.label, "°")).with(Series::new("", angles));
    let own = |quantity| impacts.column(quantity)?.numbers().iter().flatten().next().copied();
    let (Some(psi), Some(back)) = (own("local_incidence").zip(own("local_rebound")), own("rebound_angle")) else {
        return Some(vec![local, angles]);
    };
    let here = |point| marked("this scene", vec![point], Marks::Numbered);
    Some(vec![local.with(here(psi)), angles.with(here(degrees((angle, back))))])
}

/// Largest local angle of incidence shown.
const LARGEST_LOCAL: f64 = 10.0;
