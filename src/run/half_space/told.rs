//! Named results of a contact on pixels, and what a user must know of it.

use super::heights::Heights;
use super::series::Series;
use super::state::State;
use super::steady::Glides;
use crate::run::gliding;
use crate::run::named::Named;
use crate::run::record::Record;
use crate::run::results::{of_sliding, pull_off};
use crate::run::rough::of_surface;
use crate::run::unit::Unit;
use crate::run::warnings::dissimilar;
use crate::scene::law::{ElasticAdhesion, PixelFriction};
use crate::scene::plan::HalfSpacePlan;
use crate::scene::surface::Source;
use crate::shape::Boundary;

/// Fewest pixels of a patch that show its area to some ten per cent.
const FEW: f64 = 12.0;
/// Fewest pixels along the ring of an attraction.
const IN_RING: f64 = 2.0;
/// How far what leaks through every second pixel may be from what does through all without a word.
const APART: f64 = 0.3;
/// Fewest rings in the thickness of a layer.
const OF_LAYER: f64 = 2.0;
/// Fewest pixels on the shortest wave of a spectrum that show its summits.
const PER_WAVE: f64 = 4.0;

/// The named results: those of the largest force, and of the end.
pub(super) fn results(plan: &HalfSpacePlan, records: &[Record], series: &Series<'_>, glides: &Glides) -> Vec<Named> {
    let mut results = loads(records);
    results.extend(at_largest(plan, records));
    results.extend(
        series.largest.iter().map(|(_, pressed)| Named::count("contact_pixels", pressed.contact.contact_pixels())),
    );
    if let Some(surface) = plan.surface() {
        let (squares, peak_to_valley) = of_surface(surface);
        results.extend(squares.into_iter().chain(peak_to_valley));
    }
    if let Some(friction) = &plan.friction {
        results.extend(of_sliding(plan, records, matches!(friction, PixelFriction::Gross(_))));
    }
    if matches!(plan.friction, Some(PixelFriction::Coupled { .. })) {
        // What the normal force has done went into the shear too.
    } else if series.pixels().has_past() {
        results.extend(of_past(records, series.least).into_iter().flatten());
        results.extend(known(&[("residual_depth", Unit::METRE, series.pixels().deepest())]));
    } else {
        results.extend(known(&[("work", Unit::JOULE, records.last().map(|last| last.normal.stored.elastic))]));
    }
    results.extend(records.last().iter().flat_map(|last| at_end(last)));
    results.extend(gliding::results(plan.travel.as_ref(), records, &glides.states));
    results.extend(gliding::results_of_rough(plan.travel.as_ref(), &glides.rubbing));
    results
}

/// What is left of the past, and what it has cost; `least` [N] is the least force, between records too.
fn of_past(records: &[Record], least: f64) -> Option<Vec<Named>> {
    let (first, last) = (records.first()?.normal, records.last()?.normal);
    Some(known(&[
        ("pull_off_force", Unit::NEWTON, pull_off(records).map(|held| held.min(least))),
        ("dissipated", Unit::JOULE, Some(last.dissipated)),
        (
            "work",
            Unit::JOULE,
            Some(last.stored.stored() - first.stored.stored() + (last.dissipated - first.dissipated)),
        ),
        ("final_stored_elastic", Unit::JOULE, Some(last.stored.elastic)),
    ]))
}

fn loads(records: &[Record]) -> Vec<Named> {
    let most = |of: fn(&Record) -> Option<f64>| {
        records.iter().filter_map(of).filter(|number| number.is_finite()).reduce(f64::max)
    };
    known(&[
        ("largest_force", Unit::NEWTON, most(|record| Some(record.normal.force))),
        ("largest_indentation", Unit::METRE, most(|record| record.normal.indentation)),
        ("largest_contact_radius", Unit::METRE, most(|record| record.normal.contact_radius)),
        ("largest_stiffness", Unit::NEWTON_PER_METRE, most(|record| Some(record.normal.stiffness))),
        ("largest_stored_elastic", Unit::JOULE, most(|record| Some(record.normal.stored.elastic))),
    ])
}

/// The least force of a record through whose gap no way leads.
fn sealing_force(records: &[Record]) -> Option<f64> {
    let sealed = records.iter().filter(|record| record.pixels.is_some_and(|pixels| pixels.leak == Some(0.0)));
    sealed.map(|record| record.normal.force).reduce(f64::min)
}

/// The contact under the largest force, or of the largest area under an attraction.
fn at_largest(plan: &HalfSpacePlan, records: &[Record]) -> Vec<Named> {
    let attracts = plan.attraction != ElasticAdhesion::None;
    let size = |record: &Record| match record.pixels {
        Some(pixels) if attracts => pixels.area,
        Some(_) | None => record.normal.force,
    };
    let most = records.iter().max_by(|one, other| size(one).total_cmp(&size(other)));
    let Some(contact) = most.and_then(|record| record.pixels) else { return Vec::new() };
    let rough = plan.surface().is_some();
    let mut results = known(&[
        ("leak_conductance", Unit::CUBIC_METRE_PER_PASCAL_SECOND, contact.leak),
        ("sealing_force", Unit::NEWTON, sealing_force(records)),
        ("peak_pressure", Unit::PASCAL, Some(contact.peak_pressure)),
        ("area", Unit::SQUARE_METRE, Some(contact.area)),
        ("area_fraction", Unit::ONE, Some(contact.area_fraction).filter(|_| rough)),
        ("mean_gap", Unit::METRE, contact.mean_gap),
    ]);
    results.push(Named::count("contact_patches", contact.patches));
    if rough {
        results.push(Named::answer("contact_percolates", contact.percolates));
        results.push(Named::answer("gap_percolates", contact.gap_percolates));
    }
    results
}

fn at_end(last: &Record) -> Vec<Named> {
    known(&[
        ("final_time", Unit::SECOND, Some(last.time)),
        ("final_indentation", Unit::METRE, last.normal.indentation),
        ("final_force", Unit::NEWTON, Some(last.normal.force)),
    ])
}

fn known(found: &[(&'static str, Unit, Option<f64>)]) -> Vec<Named> {
    let named = |&(quantity, unit, number): &(_, _, Option<f64>)| Some(Named::number(quantity, unit, number?));
    found.iter().filter_map(named).collect()
}

/// What leaves the meaning of the answer.
pub(super) fn warnings(
    plan: &HalfSpacePlan,
    heights: &Heights,
    (series, glides): (&Series<'_>, &Glides),
) -> Vec<String> {
    let states = || series.states.iter();
    let most = states().max_by(|one, other| one.normal.force.total_cmp(&other.normal.force));
    let found = [
        full(states()),
        narrow(plan, states(), glides),
        border(plan),
        most.and_then(|most| coarse(plan, heights, most)),
        ring(plan, heights, series),
        necks(states()),
        torn(series),
        slipped(plan),
    ];
    found.into_iter().flatten().collect()
}

/// Under more than this force nothing is left to close.
fn full<'s>(states: impl Iterator<Item = &'s State>) -> Option<String> {
    let forces = states.filter(|state| state.full).map(|state| state.normal.force);
    let least = forces.reduce(f64::min)?;
    Some(format!(
        "full contact is reached under {least:.4e} N or less: the whole area touches, no gap is left, and a greater force only adds to the mean pressure"
    ))
}

/// A tip whose contact meets the border of its window.
fn narrow<'s>(plan: &HalfSpacePlan, mut states: impl Iterator<Item = &'s State>, glides: &Glides) -> Option<String> {
    let meets = states.any(|state| state.meets_border && state.count > 0) || glides.meets_border();
    let meets = plan.surface().is_none() && meets;
    let what = match plan.boundary {
        Boundary::Free => "beyond it the shape is cut off and presses with an edge it does not have",
        Boundary::Periodic => "it runs into that of the neighbouring tip",
    };
    meets.then(|| format!("the contact meets the border of the window: {what}; expected a larger solver.window"))
}

/// A surface that is cut out of a larger one.
fn border(plan: &HalfSpacePlan) -> Option<String> {
    let rough = plan.surface()?;
    let (Boundary::Free, None, Source::Map(_)) = (plan.boundary, plan.profile(), &rough.source) else { return None };
    Some("the map ends at its border, where its pressures rise as at the edge of a punch; boundary: Periodic lets it go on instead, with a step where its opposite sides do not meet".to_owned())
}

/// Stick and slip of bodies whose shear presses.
fn slipped(plan: &HalfSpacePlan) -> Option<String> {
    matches!(plan.friction, Some(PixelFriction::Partial { .. })).then(|| dissimilar(plan)).flatten()
}

/// A force beyond what the attraction bears.
fn torn(series: &Series<'_>) -> Option<String> {
    let attracts = series.pixels().attraction().is_some();
    let torn = attracts && series.states.iter().any(|state| state.parted && state.normal.indentation.is_none());
    torn.then(|| {
        "the prescribed force passes pull-off: the bodies part, and stay apart while they are pulled".to_owned()
    })
}

/// An attraction that ends within few pixels: between two of them it holds an edge that nothing else would.
fn ring(plan: &HalfSpacePlan, heights: &Heights, series: &Series<'_>) -> Option<String> {
    let modulus = plan.relaxation.as_ref().map_or(plan.pair.normal, |relaxation| relaxation.equilibrium);
    let side = heights.pixel[0].max(heights.pixel[1]);
    let ring = series.pixels().attraction()?.ring(modulus) / side;
    let layer = match plan.ground.as_ref().map(|ground| ground.scale()) {
        Some(None) => return None,
        Some(Some(thickness)) => thickness / side,
        None => f64::INFINITY,
    };
    if let (ElasticAdhesion::Vanishing { .. }, true) = (plan.attraction, layer < OF_LAYER * ring) {
        return Some(format!(
            "the ring outside the contact in which the attraction acts is {ring:.1} pixels long, and the thinnest top layer {layer:.1} thick: its edge feels what lies beneath, expected a finer solver.grid"
        ));
    }
    (ring < IN_RING).then(|| {
        format!(
            "the ring outside the contact in which the attraction acts is {ring:.1} pixels long: the edge is held from pixel to pixel and forces are too large, expected {IN_RING} and more (a finer solver.grid, or less stress)"
        )
    })
}

/// A gap whose necks are few pixels wide.
fn necks<'s>(states: impl Iterator<Item = &'s State>) -> Option<String> {
    let worst = states
        .filter(|state| state.leak_apart > APART)
        .min_by(|one, other| one.normal.force.total_cmp(&other.normal.force))?;
    Some(format!(
        "from {:.4e} N on the necks of the gap are few pixels wide: on every second pixel {:.0} % less or more leaks, and where nothing leaks through pixels something may; expected a finer solver.grid",
        worst.normal.force,
        100.0 * worst.leak_apart
    ))
}

/// Patches, or waves, of few pixels.
fn coarse(plan: &HalfSpacePlan, heights: &Heights, most: &State) -> Option<String> {
    if most.count == 0 {
        return None;
    }
    let each = most.count as f64 / most.pixels.patches.max(1) as f64;
    if each < FEW {
        return Some(format!(
            "a patch of contact has {each:.1} pixels on average: its area and peak pressure are not resolved, expected a finer solver.grid"
        ));
    }
    let Source::Spectrum(spectrum) = &plan.surface()?.source else { return None };
    let waves = std::f64::consts::TAU / spectrum.cut_offs().1 / heights.pixel[0];
    (waves < PER_WAVE * (1.0 - 1e-9)).then(|| {
        format!("the shortest wave has {waves:.1} pixels: summits are blunted, expected four and more (solver.grid)")
    })
}
