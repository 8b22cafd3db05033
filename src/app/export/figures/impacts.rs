//! Figures of impacts.

use super::against_time;
use crate::app::figure::{Axis, Guide, Line, Marks, Panel, Series};
use crate::run::record::{ImpactRow, Impacts, Incidence, Record};

/// Depth, force and contact radius over time.
pub fn over_time(records: &[Record]) -> Vec<Panel> {
    vec![
        against_time(records, ("indentation d", "m"), |record| record.normal.indentation),
        against_time(records, ("force F", "N"), |record| Some(record.normal.force)),
        against_time(records, ("contact radius a", "m"), |record| record.normal.contact_radius),
    ]
}

/// Restitution against speed; impacts after which the bodies stay together are marked on the axis.
pub fn restitution(impacts: &Impacts) -> Panel {
    let mut rows: Vec<&ImpactRow> = impacts.rows.iter().collect();
    rows.sort_by(|x, y| x.speed.total_cmp(&y.speed));
    let free: Vec<(f64, f64)> =
        rows.iter().filter(|row| !row.rebound.sticks()).map(|row| (row.speed, row.rebound.restitution)).collect();
    let stuck: Vec<(f64, f64)> = rows.iter().filter(|row| row.rebound.sticks()).map(|row| (row.speed, 0.0)).collect();
    let mut panel = Panel::new(Axis::log("speed v", "m/s"), Axis::linear("restitution e", "1").from(0.0).to(1.0));
    let few = free.len() <= MARKED;
    let names = if stuck.is_empty() { ("", "") } else { ("comes free", "stays") };
    if !free.is_empty() {
        let series = Series::new(names.0, free);
        panel = panel.with(if few { series.marks(Marks::Numbered) } else { series });
    }
    if stuck.is_empty() {
        panel
    } else {
        panel.with(Series::new(names.1, stuck).line(Line::Absent).marks(Marks::Numbered))
    }
}

/// Most points of a curve that are marked one by one.
const MARKED: usize = 40;

/// Local angles of incidence and rebound, and the rebound over the angle of the path.
///
/// ψ = (G*/μE*) w/v with w the speed of the contact point along the surface and v the normal speed
/// before the impact (Maw, Barber & Fawcett 1976); `angle` is the scene's own [rad].
pub fn incidence(angle: f64, impacts: &Impacts) -> Vec<Panel> {
    if impacts.incidence.is_empty() {
        return Vec::new();
    }
    let own = impacts.rows.iter().find_map(|row| row.oblique.as_ref());
    let local = |one: &Incidence| one.rebound.psi;
    let degrees = |one: &Incidence| (one.angle.to_degrees(), one.rebound.angle.to_degrees());
    let curve = |of: &dyn Fn(&Incidence) -> (f64, f64)| impacts.incidence.iter().map(of).collect::<Vec<_>>();
    // Beyond gross slip all along the curve is a straight line: only its beginning is shown.
    let shown: Vec<(f64, f64)> = curve(&local).into_iter().filter(|point| point.0.abs() <= LARGEST_LOCAL).collect();
    let mut first = Panel::new(Axis::linear("local incidence ψ₁", "1"), Axis::linear("local rebound ψ₂", "1"))
        .with(Series::new("", shown))
        .guide(Guide::horizontal(0.0, ""));
    let mut second = Panel::new(Axis::linear("angle of incidence", "°"), Axis::linear("angle of rebound", "°"))
        .with(Series::new("", curve(&degrees)));
    if let Some(own) = own {
        first = first.with(Series::new("this scene", vec![own.psi]).line(Line::Absent).marks(Marks::Numbered));
        second = second.with(
            Series::new("this scene", vec![(angle.to_degrees(), own.angle.to_degrees())])
                .line(Line::Absent)
                .marks(Marks::Numbered),
        );
    }
    vec![first, second]
}

/// Largest local angle of incidence shown.
const LARGEST_LOCAL: f64 = 10.0;
