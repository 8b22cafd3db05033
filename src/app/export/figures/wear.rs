//! Worn profiles in time, their pressures, and what has been worn off.

use super::curve::{against_time, axis, short};
use crate::app::figure::{Panel, Series};
use crate::run::record::{Outcome, WEAR_DEPTH, WORN_VOLUME};
use crate::run::table::Table;

/// Most profiles in a panel.
const MOST: usize = 6;
/// Radii shown, in radii of the largest contact.
const OUT: f64 = 1.25;

/// Profiles and pressures over the radius, worn volume and depth over time.
pub fn panels(outcome: &Outcome) -> Vec<Panel> {
    let of_table = |table: &Table| ["height", "pressure"].into_iter().filter_map(|of| over_radius(table, of)).collect();
    let profiles: Vec<Panel> = outcome.table("profiles").map(of_table).unwrap_or_default();
    let over_time = [WORN_VOLUME, WEAR_DEPTH].map(|column| against_time(&outcome.records, &column));
    profiles.into_iter().chain(over_time).collect()
}

/// A column of the profiles over the radius, a curve for each profile.
fn over_radius(table: &Table, quantity: &str) -> Option<Panel> {
    let (radius, column) = (table.column("radius")?, table.column(quantity)?);
    let [radii, paths, pressures] = ["radius", "path", "pressure"].map(|name| table.column(name));
    let (radii, paths, pressures) = (radii?.numbers(), paths?.numbers(), pressures?.numbers());
    let pressed = radii.iter().zip(pressures).filter(|(_, p)| p.is_some_and(|p| p > 0.0));
    let end = OUT * pressed.filter_map(|(r, _)| *r).fold(0.0, f64::max);
    let mut blocks: Vec<(f64, Vec<(f64, f64)>)> = Vec::new();
    for ((path, r), value) in paths.iter().zip(radii).zip(column.numbers()) {
        let (Some(path), Some(r), Some(value)) = (*path, *r, *value) else { continue };
        if blocks.last().is_none_or(|block| block.0 < path) {
            blocks.push((path, Vec::new()));
        }
        if let Some((_, points)) = blocks.last_mut().filter(|_| r <= end) {
            points.push((r, value));
        }
    }
    let skipped = blocks.len().saturating_sub(MOST - 1);
    let shown = blocks.into_iter().enumerate().filter(|(at, _)| *at == 0 || *at >= skipped).map(|(_, block)| block);
    let series = shown.map(|(path, points)| {
        let label = if path > 0.0 { format!("after {}", short(path, "m")) } else { "unworn".to_owned() };
        Series::new(label, points)
    });
    Some(series.fold(Panel::new(axis(radius).from(0.0), axis(column).from(0.0)), Panel::with))
}
