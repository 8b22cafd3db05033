//! Tangential loops, stick and slip, shear stress, fretting, sliding friction against load.

use super::curve::{axis_of, marked, of_records, panel, time_axis};
use super::fields::{across, largest, shown};
use crate::app::figure::{Axis, Guide, Hue, Line, Mark, Marks, Panel, Points, Series};
use crate::contact::state::Tangential;
use crate::friction::sliding::SlidingPoint;
use crate::run::curves::sliding::{self, SlideDirection};
use crate::run::record::{
    AREA_RATIO, CONTACT_RADIUS, Field, FieldRow, Outcome, Record, SLIDE, STICK_RADIUS, TANGENTIAL_FORCE, TIME,
};
use crate::scene::Plot;
use crate::scene::law::FrictionLaw;
use crate::scene::plan::Plan;

/// What suits a scene with friction that asks for nothing.
pub fn suiting(law: &FrictionLaw, outcome: &Outcome) -> Vec<Plot> {
    match law {
        FrictionLaw::Memory { .. } | FrictionLaw::Springs { .. } | FrictionLaw::Viscoelastic { .. } => {
            let fretting = outcome.table("fretting").map(|_| Plot::Fretting);
            [Plot::Friction, Plot::Stick, Plot::Shear].into_iter().chain(fretting).collect()
        }
        // Only a machine has it, which has figures of its own.
        FrictionLaw::RateState(_) => Vec::new(),
        FrictionLaw::Stuck { .. } | FrictionLaw::Peeling { .. } => {
            vec![Plot::Friction, Plot::Area, Plot::Radius, Plot::Pressure]
        }
        FrictionLaw::Sliding(_) => vec![Plot::Friction, Plot::Coefficient, Plot::Shear],
    }
}

/// Tangential force against displacement, forwards and backwards.
pub fn loops(plan: &Plan, records: &[Record]) -> Panel {
    let states: Vec<Tangential> = records.iter().filter_map(|record| record.tangential).collect();
    let panel = sliding::ways(&states).into_iter().map(|(way, states)| {
        let label = match way {
            SlideDirection::Forward => "forward",
            SlideDirection::Backward => "backward",
        };
        Series::new(label, states.iter().map(|state| (state.slide, state.force))).arrow()
    });
    let panel = panel.fold(Panel::new(axis_of(&SLIDE), axis_of(&TANGENTIAL_FORCE)), Panel::with);
    let Some(limit) = sliding::limit(plan, records) else { return panel };
    panel.guide(Guide::horizontal(limit, "μF")).guide(Guide::horizontal(-limit, "−μF"))
}

/// Radius of the contact and of its sticking part over time from the first slide on; between them is
/// the slip annulus.
pub fn stick(plan: &Plan, records: &[Record]) -> Panel {
    let width = if plan.scene.shape.is_plane() { "half width" } else { "radius" };
    let of = |column| of_records(from_first_slide(records), &TIME, column);
    Panel::new(time_axis(records), Axis::linear(width, "m").from(0.0))
        .with(Series::new("contact a", of(&CONTACT_RADIUS)))
        .with(Series::new("stick c", of(&STICK_RADIUS)))
}

/// The records from the last one before the first slide on.
pub fn from_first_slide(records: &[Record]) -> &[Record] {
    let slides = |record: &Record| record.tangential.is_some_and(|state| state.slide.abs() > 0.0);
    &records[records.iter().position(slides).map_or(0, |first| first.saturating_sub(1))..]
}

/// Shear stress over the radius at the ends of the last entries, with the limit the pressure sets.
pub fn stress(plan: &Plan, outcome: &Outcome) -> Option<Panel> {
    let rubs = |field: &&&Field| field.rows.iter().any(|row| row.shear.is_some_and(|tau| tau.abs() > 0.0));
    let all = shown(&outcome.fields);
    let fields: Vec<&Field> = all.iter().filter(rubs).copied().collect();
    let fields = &fields[fields.len().saturating_sub(3)..];
    let panel = Panel::new(across(plan), Axis::linear("shear stress τ", "Pa"));
    let curve = |field: &Field, reach: f64, of: &dyn Fn(&FieldRow) -> Option<f64>| -> Points {
        let inside = field.rows.iter().filter(|row| row.radius <= reach * field.contact_radius);
        inside.map(|row| Some((row.radius, of(row)?))).collect()
    };
    let series = fields.iter().map(|field| Series::new(field.label.clone(), curve(field, 1.2, &|row| row.shear)));
    let panel = series.fold(panel, Panel::with);
    let field = largest(fields)?;
    let coefficient = plan.round().and_then(|round| round.friction.as_ref()?.coulomb());
    let Some(coefficient) = coefficient else { return Some(panel) };
    let largest = field.rows.iter().filter_map(|row| row.shear).max_by(|x, y| x.abs().total_cmp(&y.abs()))?;
    let coefficient = coefficient * largest.signum();
    let limit = curve(field, 1.0, &|row| Some(coefficient * row.pressure?));
    Some(panel.with(Series::new("limit μp", limit).line(Line::Dotted).colour(Hue::Black)))
}

/// Energy lost at the surface over the radius.
pub fn fretting(outcome: &Outcome) -> Option<Panel> {
    let table = outcome.table("fretting")?;
    let mut panel = panel(table.column("radius")?, table.column("energy")?);
    (panel.x, panel.y) = (panel.x.from(0.0), panel.y.from(0.0));
    Some(panel.note("Wear by Archard's law is proportional to it."))
}

/// Coefficient of friction over the load, and where Amontons' law holds.
pub fn coefficient(plan: &Plan, records: &[Record]) -> Panel {
    let slid = records.iter().filter_map(sliding::slid);
    let panel = Panel::new(Axis::log("normal force F", "N"), Axis::log("friction coefficient Fₓ/F", "1"));
    let slid = marked("this scene", slid, Marks::As(Mark::Disc));
    match sliding::coefficient(plan, records) {
        Ok(curve) => {
            let law = Series::new("law", curve.iter().map(|point| (point.force, point.coefficient)));
            amontons(panel.with(law).with(slid), &curve)
        }
        Err(why) => panel.with(slid).note(format!("The law is not drawn: {why}.")),
    }
}

fn amontons(panel: Panel, curve: &[SlidingPoint]) -> Panel {
    let Some((from, to)) = sliding::amontons(curve) else {
        return panel.note("Amontons' law holds nowhere here: d ln Fₓ/d ln F differs from 1 by more than 1 %.");
    };
    let from = from.map(|low| Guide::vertical(low, "Amontons' law from here"));
    let to = to.map(|high| Guide::vertical(high, "Amontons' law up to here"));
    let panel = from.into_iter().chain(to).fold(panel, Panel::guide);
    panel.note("Amontons' law counts as holding while d ln Fₓ/d ln F is within 1 % of 1.")
}

/// A/A_JKR of a sheared adhesive contact: over the sliding speed if there are several, or theory knows what they do, else
/// over the displacement.
pub fn area(plan: &Plan, outcome: &Outcome) -> Option<Panel> {
    let hertz = outcome.number("hertz_area_ratio")?;
    let (points, force) = sliding::area(plan, &outcome.records)?;
    let ratio = Axis::linear("area of contact over area at rest A/A₀", "1").from((hertz - 0.02).max(0.0)).to(1.02);
    let over = |axis: Axis| {
        let panel = Panel::new(axis, ratio.clone());
        panel.guide(Guide::horizontal(1.0, "JKR")).guide(Guide::horizontal(hertz, "Hertz"))
    };
    let theory = sliding::area_in_theory(plan, force);
    let same = points.windows(2).all(|pair| (pair[0].0 - pair[1].0).abs() <= 0.0);
    if same && theory.as_ref().is_ok_and(Vec::is_empty) {
        let ratios = of_records(&outcome.records, &SLIDE, &AREA_RATIO);
        return Some(over(axis_of(&SLIDE)).with(Series::new("", ratios)));
    }
    let panel = over(Axis::log("sliding speed v", "m/s"));
    let panel = match theory {
        Ok(line) if line.is_empty() => panel,
        Ok(line) => panel.with(Series::new("Savkoor & Briggs", line)),
        Err(why) => panel.note(format!("Savkoor & Briggs are not drawn: {why}.")),
    };
    Some(panel.with(marked("this scene", points, Marks::As(Mark::Disc))))
}
