//! Figures of bodies that roll with traction.

use super::curve::{axis, points};
use crate::app::figure::{Axis, Guide, Line, Marks, Panel, Series};
use crate::run::record::Outcome;
use crate::run::table::{Filled, Table};
use crate::scene::Plot;

/// What suits a body that rolls with traction.
pub fn suiting(outcome: &Outcome) -> Vec<Plot> {
    if outcome.table("tractions").is_some() { vec![Plot::Traction] } else { vec![Plot::Force] }
}

/// Traction over creepage, and what the contact carries at one of the points.
pub fn traction(outcome: &Outcome) -> Vec<Panel> {
    let curve = outcome.table("tractions").and_then(|table| over_creepage(table, outcome));
    let contact = outcome.table("rolling").map(across).unwrap_or_default();
    curve.into_iter().chain(contact).collect()
}

/// Most points of a curve that are marked one by one.
const MARKED: usize = 40;

fn over_creepage(table: &Table, outcome: &Outcome) -> Option<Panel> {
    let (creepage, force) = (table.column("creepage")?, table.column("tangential_force")?);
    if table.rows() < 2 {
        return None;
    }
    let exact = table.column("kalker_tangential_force");
    let own = if exact.is_some() { "bed" } else { "Carter" };
    let series = Series::new(own, points(creepage, force));
    let series = if table.rows() <= MARKED { series.marks(Marks::Numbered) } else { series };
    let panel = Panel::new(axis(creepage), axis(force)).with(series);
    let panel = match exact {
        Some(exact) => panel.with(Series::new("cube with Kalker's C₁₁", points(creepage, exact)).line(Line::Dashed)),
        None => panel,
    };
    Some(match outcome.number("largest_traction_n") {
        Some(limit) => panel.guide(Guide::horizontal(limit, "μP")),
        None => panel,
    })
}

/// Most creepages of which the contact is drawn.
const DRAWN: usize = 4;

/// Rows of a table of one creepage each, some of all.
fn blocks(creepage: &Filled) -> Vec<(f64, std::ops::Range<usize>)> {
    let numbers = creepage.numbers();
    let mut blocks: Vec<(f64, std::ops::Range<usize>)> = Vec::new();
    for (row, number) in numbers.iter().enumerate() {
        let number = number.unwrap_or(0.0);
        match blocks.last_mut().filter(|block| block.0.to_bits() == number.to_bits()) {
            Some(block) => block.1.end = row + 1,
            None => blocks.push((number, row..row + 1)),
        }
    }
    let every = blocks.len().div_ceil(DRAWN).max(1);
    let last = blocks.len();
    blocks
        .into_iter()
        .enumerate()
        .filter(|(at, _)| (last - 1 - at).is_multiple_of(every))
        .map(|(_, block)| block)
        .collect()
}

fn across(table: &Table) -> Vec<Panel> {
    let Some((creepage, place)) = table.column("creepage").zip(table.column("place")) else { return Vec::new() };
    let blocks = blocks(creepage);
    let of = |y: &Filled, rows: &std::ops::Range<usize>| {
        points(place, y).into_iter().skip(rows.start).take(rows.len()).collect::<Vec<_>>()
    };
    let drawn = |loads: (&str, &str), words: &'static str, normal: &'static str| {
        let (normal_load, tangential) = (table.column(loads.0)?, table.column(loads.1)?);
        let last = &blocks.last()?.1;
        let panel = Panel::new(axis(place), Axis::linear(words, tangential.unit.symbol));
        let panel = blocks.iter().fold(panel, |panel, (creepage, rows)| {
            panel.with(Series::new(format!("ξ = {creepage:.2e}"), of(tangential, rows)))
        });
        Some(panel.with(Series::new(normal, of(normal_load, last)).line(Line::Dashed)))
    };
    let loads = drawn(("pressure", "shear_stress"), "stress", "pressure p")
        .or_else(|| drawn(("line_load", "tangential_line_load"), "line load", "normal"));
    let heat = table.column("heat_flux").map(|heat| {
        let panel = Panel::new(axis(place), axis(heat).from(0.0));
        blocks.iter().fold(panel, |panel, (creepage, rows)| {
            panel.with(Series::new(format!("ξ = {creepage:.2e}"), of(heat, rows)))
        })
    });
    loads.into_iter().chain(heat).collect()
}
