//! The figures a scene asks for, or those that suit it.

mod between;
mod branches;
mod comparison;
mod fields;
mod friction;
mod impacts;
mod rough;
mod shape;

use crate::app::figure::{Axis, Figure, Guide, Hue, Line, Panel, Series};
use crate::run::record::{Outcome, Record};
use crate::scene::Plot;
use crate::scene::history::Entry;
use crate::scene::setup::Setup;
use crate::shape::Rim;
pub use comparison::comparison_figure;

use branches::{Branch, branches, jumps};

/// The figure of a scene: one panel per plot wanted.
#[must_use]
pub fn figures(setup: &Setup, outcome: &Outcome) -> Figure {
    let wanted = setup.scene.plots.clone().unwrap_or_else(|| suiting(setup, outcome));
    let panels = wanted.iter().flat_map(|plot| panels(*plot, setup, outcome)).chain(oblique(setup, outcome));
    panels.fold(Figure::new(setup.scene.title.clone()), Figure::with)
}

/// What suits a scene that asks for nothing.
fn suiting(setup: &Setup, outcome: &Outcome) -> Vec<Plot> {
    if setup.surface.is_some() {
        return rough::SUITING.to_vec();
    }
    if setup.scene.shape.is_plane() {
        return vec![Plot::Force, Plot::Radius, Plot::Pressure];
    }
    if let Some(impacts) = &outcome.impacts {
        let oblique = !impacts.incidence.is_empty();
        return match impacts.rows.len() {
            1 if oblique => vec![Plot::Force],
            1 => vec![Plot::Force, Plot::Pressure],
            _ => vec![Plot::Restitution],
        };
    }
    if outcome.records.iter().any(|record| record.tangential.is_some()) {
        return friction::suiting(setup, outcome);
    }
    let mut plots = vec![Plot::Force, Plot::Radius];
    if !outcome.fields.is_empty() {
        plots.push(Plot::Pressure);
    }
    if setup.scene.friction.is_none() && !matches!(setup.profile.rim(), Rim::Wall(_)) {
        plots.push(Plot::Shape);
    }
    plots
}

fn panels(plot: Plot, setup: &Setup, outcome: &Outcome) -> Vec<Panel> {
    if let Some(surface) = &setup.surface {
        return rough::panels(plot, (setup, surface), outcome);
    }
    let records = &outcome.records;
    match plot {
        Plot::Force if outcome.impacts.is_some() => {
            let loop_of = against_depth((setup, records), Axis::linear("force F", "N"), |record| record.normal.force);
            impacts::over_time(records).into_iter().chain([loop_of]).collect()
        }
        Plot::Force => force(setup, records),
        Plot::Radius => {
            let name = if setup.scene.shape.is_plane() { "half width a" } else { "contact radius a" };
            let axis = Axis::linear(name, "m").from(0.0);
            let by_depth =
                against_depth((setup, records), axis, |record| record.normal.contact_radius.unwrap_or(f64::NAN));
            let over_time = || against_time(records, (name, "m"), |record| record.normal.contact_radius);
            std::iter::once(by_depth).chain(setup.relaxation.as_ref().map(|_| over_time())).collect()
        }
        Plot::Pressure => vec![fields::pressure(setup, outcome)],
        Plot::Stress => vec![fields::stress(outcome)],
        Plot::Energy => vec![energy(records)],
        Plot::Shape => vec![shape::profile(setup, outcome)],
        Plot::Friction => vec![friction::loops(setup, records)],
        Plot::Stick => vec![friction::stick(records)],
        Plot::Shear => friction::stress(setup, outcome).into_iter().collect(),
        Plot::Fretting => friction::fretting(outcome).into_iter().collect(),
        Plot::Coefficient => friction::coefficient(setup, outcome).into_iter().collect(),
        Plot::Area => friction::area(setup, outcome).into_iter().collect(),
        Plot::Moduli => setup.relaxation.as_ref().map(shape::moduli).into_iter().collect(),
        Plot::Restitution => outcome.impacts.iter().map(impacts::restitution).collect(),
    }
}

/// The angles of every oblique impact.
fn oblique(setup: &Setup, outcome: &Outcome) -> Vec<Panel> {
    let angle = setup.scene.history.iter().find_map(|entry| match entry {
        Entry::Impact(impact) => Some(impact.incidence()),
        _ => None,
    });
    outcome.impacts.iter().flat_map(|found| impacts::incidence(angle.unwrap_or(0.0), found)).collect()
}

/// Force against indentation, and against time where the bodies remember.
fn force(setup: &Setup, records: &[Record]) -> Vec<Panel> {
    let plane = setup.scene.shape.is_plane();
    let axis = if plane { Axis::linear("force per length F", "N/m") } else { Axis::linear("force F", "N") };
    let mut panels = vec![against_depth((setup, records), axis, |record| record.normal.force)];
    if setup.relaxation.is_some() {
        panels.push(against_time(records, ("force F", "N"), |record| Some(record.normal.force)));
        panels.push(against_time(records, ("indentation d", "m"), |record| record.normal.indentation));
        panels.extend(last_loop(setup, records));
    }
    panels
}

/// Force against indentation in the last oscillation alone, where nothing else hides it.
fn last_loop(setup: &Setup, records: &[Record]) -> Option<Panel> {
    let entry = setup.scene.history.iter().rposition(|entry| matches!(entry, Entry::Oscillate(_)))?;
    let inside = records.iter().filter(|record| record.entry == entry);
    let points = inside.map(|record| (record.normal.indentation.unwrap_or(f64::NAN), record.normal.force)).collect();
    let panel = Panel::new(Axis::linear("indentation d", "m"), Axis::linear("force F", "N"));
    Some(panel.titled("oscillation").with(Series::new("", points).arrow()))
}

/// A quantity against the indentation, approaches first: a label has the same look in all panels.
fn against_depth((setup, records): (&Setup, &[Record]), axis: Axis, of: impl Fn(&Record) -> f64 + Copy) -> Panel {
    let panel = Panel::new(Axis::linear("indentation d", "m"), axis);
    let point = |record: &Record| (record.normal.indentation.unwrap_or(f64::NAN), of(record));
    let mut found = branches(records);
    found.sort_by_key(|branch| branch.label);
    let drawn = |branch: &Branch<'_>| {
        let (colour, line) = look(branch.label);
        let points = between::filled(setup, branch.records).iter().map(point).collect();
        Series::new(branch.label, points).colour(colour).line(line).arrow()
    };
    let panel = found.iter().map(drawn).fold(panel, Panel::with);
    jumps(records)
        .fold(panel, |panel, (before, after)| panel.guide(Guide::Jump { from: point(before), to: point(after) }))
}

/// Colour and line of a branch.
fn look(label: &str) -> (Hue, Line) {
    if label == branches::APPROACH { (Hue::Blue, Line::Solid) } else { (Hue::Orange, Line::Dashed) }
}

fn against_time(records: &[Record], (name, unit): (&str, &str), of: impl Fn(&Record) -> Option<f64>) -> Panel {
    let points = records.iter().map(|record| (record.time, of(record).unwrap_or(f64::NAN))).collect();
    Panel::new(time_axis(records), Axis::linear(name, unit)).with(Series::new("", points))
}

/// Decades of time from which on a history is drawn over the logarithm of time.
const MANY_DECADES: f64 = 3.0;

/// Time, in decades if half of the records lie before a thousandth of the whole.
fn time_axis(records: &[Record]) -> Axis {
    let last = records.last().map_or(0.0, |record| record.time);
    let middle = records.get(records.len() / 2).map_or(last, |record| record.time);
    let many = middle > 0.0 && last > middle * 10f64.powf(MANY_DECADES);
    if many { Axis::log("time t", "s") } else { Axis::linear("time t", "s") }
}

fn energy(records: &[Record]) -> Panel {
    let of = |value: fn(&Record) -> f64| records.iter().map(|record| (record.time, value(record))).collect::<Vec<_>>();
    let mut panel = Panel::new(Axis::linear("time t", "s"), Axis::linear("energy", "J"))
        .with(Series::new("elastic", of(|record| record.normal.stored.elastic)));
    if records.iter().any(|record| record.normal.stored.surface.abs() > 0.0) {
        panel = panel.with(Series::new("surface", of(|record| record.normal.stored.surface)));
    }
    let lost = |record: &Record| {
        record.normal.dissipated + record.tangential.and_then(|state| state.dissipated).unwrap_or(0.0)
    };
    panel.with(Series::new("dissipated", records.iter().map(|record| (record.time, lost(record))).collect()))
}
