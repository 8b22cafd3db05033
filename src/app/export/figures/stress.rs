//! Stresses below the surface: the map of von Mises, the maps of single stresses, and the axis.

use super::curve::short;
use crate::app::figure::{Axis, Colours, Contours, Hue, Line, Mark, Marks, Panel, Series};
use crate::run::record::Outcome;
use crate::run::table::{Filled, Table};

/// Part of the points of the map that a colour is given to where the stress has no bound.
const SHOWN: f64 = 0.985;

/// The map of the stress of von Mises over place and depth in radii of the contact, and the stresses on the axis.
pub fn panels(outcome: &Outcome) -> Vec<Panel> {
    let Some(table) = outcome.table("stress") else { return Vec::new() };
    let radius = outcome.number("stress_contact_radius_m").filter(|&a| a > 0.0);
    let axis = on_axis(table, outcome.number("von_mises_largest_pa").is_some());
    radius.and_then(|a| map(table, a, outcome)).into_iter().chain(axis).collect()
}

/// Stresses of a map over those of a place, below which one is rounding.
const ROUNDING: f64 = 1e-9;

/// Maps of the single stresses, tension positive; in the plane of the sliding, of a contact that slides.
pub fn fields(outcome: &Outcome) -> Vec<Panel> {
    let Some(table) = outcome.table("stress") else { return Vec::new() };
    let Some(radius) = outcome.number("stress_contact_radius_m").filter(|&a| a > 0.0) else { return Vec::new() };
    let bounded = outcome.number("von_mises_largest_pa").is_some();
    let names = ["sigma_zz", "sigma_rr", "sigma_xx", "sigma_tt", "sigma_yy", "tau_rz", "tau_xz"];
    let stresses = names.into_iter().filter_map(|name| table.column(name));
    let mut panels: Vec<Panel> = stresses.filter_map(|stress| field(table, stress, (radius, bounded))).collect();
    let unbounded =
        (!bounded).then_some("The stress has no bound under a sharp edge or tip: colours are cut off there.");
    let notes = std::iter::once("Thick lines: zero. Tension is positive.").chain(unbounded).map(str::to_owned);
    if let Some(first) = panels.first_mut() {
        first.notes.extend(notes);
    }
    panels
}

/// The map of one stress, in colours about zero.
fn field(table: &Table, stress: &Filled, (a, bounded): (f64, bool)) -> Option<Panel> {
    let (place, depth, _) = columns(table)?;
    let (x, y) = (distinct(place, a), distinct(depth, a));
    let values = continued(stress.numbers(), x.len());
    let bar = Axis::linear(stress.label, "Pa");
    let bar = if bounded { bar } else { bar.from(common(&values, 1.0 - SHOWN)?).to(common(&values, SHOWN)?) };
    let across = if place.quantity == "place" { "place x/a along the sliding" } else { "radius r/a" };
    let axes = [between(Axis::linear(across, "1"), &x), between(Axis::linear("depth z/a", "1"), &y).falling()];
    let [across, down] = axes;
    let panel = Panel::new(across, down).titled(format!("{}, a = {}", stress.label, short(a, "m")));
    Some(panel.over(Contours { x, y, values, axis: bar, colours: Colours::AboutZero }))
}

/// The values of a map row by row from the surface down: one without bound at the surface is drawn as the one below it, and
/// what is rounding as zero.
fn continued(values: &[Option<f64>], columns: usize) -> Vec<Option<f64>> {
    let largest = values.iter().flatten().fold(0.0, |most: f64, value| most.max(value.abs()));
    let below = |k: usize| values.get(k).copied().flatten().or(values.get(k + columns).copied().flatten());
    let rounded = |value: f64| if value.abs() <= ROUNDING * largest { 0.0 } else { value };
    (0..values.len()).map(|k| below(k).map(rounded)).collect()
}

/// The places, the depths and the stresses of the table.
fn columns(table: &Table) -> Option<(&Filled, &Filled, &[Filled])> {
    match &table.columns[..] {
        [place, depth, stresses @ ..] => Some((place, depth, stresses)),
        _ => None,
    }
}

fn map(table: &Table, a: f64, outcome: &Outcome) -> Option<Panel> {
    let (place, depth, _) = columns(table)?;
    let values = table.column("von_mises")?.numbers().to_vec();
    let (x, y) = (distinct(place, a), distinct(depth, a));
    let slides = place.quantity == "place";
    let across = if slides { "place x/a along the sliding" } else { "radius r/a" };
    let hardest = Hardest::of(outcome, a);
    let bar = Axis::linear("von Mises stress", "Pa").from(0.0);
    let bar = if hardest.is_some() { bar } else { bar.to(common(&values, SHOWN)?) };
    let panel =
        Panel::new(between(Axis::linear(across, "1"), &x), between(Axis::linear("depth z/a", "1"), &y).falling());
    let contours = Contours { x, y, values, axis: bar, colours: Colours::Rising };
    let panel = panel.titled(format!("a = {}", short(a, "m"))).over(contours);
    Some(match hardest {
        Some(hardest) => panel.with(hardest.mark()),
        None => panel.note("The stress has no bound under a sharp edge or tip: the darkest colour is cut off there."),
    })
}

/// Where the stress is greatest, in radii of the contact, and what it is.
struct Hardest {
    place: (f64, f64),
    von_mises: f64,
}

impl Hardest {
    fn of(outcome: &Outcome, a: f64) -> Option<Self> {
        let at = |name: &str| Some(outcome.number(name)? / a);
        let place = (at("von_mises_largest_radius_m")?, at("von_mises_largest_depth_m")?);
        Some(Self { place, von_mises: outcome.number("von_mises_largest_pa")? })
    }

    fn mark(&self) -> Series {
        let label = format!("hardest: {} at z = {:.2} a", short(self.von_mises, "Pa"), self.place.1);
        let dot = Series::new(label, [self.place]).line(Line::Absent).colour(Hue::Vermillion);
        dot.marks(Marks::As(Mark::Diamond))
    }
}

/// The stresses on the axis over the depth; those at the surface only where they are bounded.
fn on_axis(table: &Table, bounded: bool) -> Option<Panel> {
    let (place, depth, stresses) = columns(table)?;
    let on_axis = |k: &usize| {
        let [place, depth] = [place, depth].map(|column| column.numbers().get(*k).copied().flatten());
        place.is_some_and(|place| place.abs() <= 0.0) && (bounded || depth.is_some_and(|depth| depth > 0.0))
    };
    let rows: Vec<usize> = (0..table.rows()).filter(on_axis).collect();
    let number = |column: &Filled, k: usize| column.numbers().get(k).copied().flatten();
    let curve = |stress: &Filled| {
        let points = rows.iter().map(|&k| number(depth, k).zip(number(stress, k)));
        Series::new(stress.label, points.collect::<Vec<_>>())
    };
    let panel = Panel::new(Axis::linear("depth z on the axis", "m").from(0.0), Axis::linear("stress", "Pa"));
    let told = |stress: &&Filled| stress.quantity.starts_with("sigma") || stress.quantity == "von_mises";
    // On the axis both stresses along the surface are one.
    let same = |stress: &&Filled| !matches!(stress.quantity.as_str(), "sigma_tt" | "sigma_yy");
    Some(stresses.iter().filter(told).filter(same).map(curve).fold(panel, Panel::with))
}

/// The different numbers of a column in ascending order, in radii of the contact.
fn distinct(column: &Filled, a: f64) -> Vec<f64> {
    let mut numbers: Vec<f64> = column.numbers().iter().flatten().copied().collect();
    numbers.sort_by(f64::total_cmp);
    numbers.dedup();
    numbers.into_iter().map(|number| number / a).collect()
}

/// An axis over ascending places and nothing beyond.
fn between(axis: Axis, places: &[f64]) -> Axis {
    Axis { limits: (places.first().copied(), places.last().copied()), ..axis }
}

/// The value below which the part `part` of the map lies.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a part of a count")]
fn common(values: &[Option<f64>], part: f64) -> Option<f64> {
    let mut values: Vec<f64> = values.iter().flatten().copied().collect();
    values.sort_by(f64::total_cmp);
    values.get((part * values.len() as f64) as usize).copied()
}
