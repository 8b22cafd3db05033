//! The history, gone through on fewer pixels first: how many steps it takes, and what pixels cost.

use super::series::{Depth, Series};
use super::settings;
use super::state::{Pressing, response};
use crate::contact::adhesion::equilibrium::Control;
use crate::contact::state::Normal;
use crate::run::SimulationError;
use crate::run::record::{ErrorEstimate, Record};
use crate::scene::law::{ElasticAdhesion, PixelFriction};
use crate::scene::plan::HalfSpacePlan;

/// Error of the time steps, relative, that is aimed at where less is asked for: pixels have more.
const OF_TIME: f64 = 1e-4;
/// The same of steps in which pressures and shear are found together, which are of the first order only.
const OF_SLIP: f64 = 2e-3;
/// What twice the pixel makes of the error of an attraction without a range of its own, √2 − 1 more, its inverse: it is given
/// one of three pixels, and what that is off by is inverse to Tabor's parameter, which grows as the stress does, with the
/// root of the inverse of the pixel.
const OF_RANGE: f64 = 1.0 + std::f64::consts::SQRT_2;
/// Pixels that tell in how many steps a contact is to be followed.
const FEW: f64 = 16.0;
/// Part of what steps twice as long left open that is taken to be left.
const KEPT: f64 = 0.5;
/// Most doublings of the steps between two records.
const DOUBLINGS: u32 = 5;

/// A history on every second pixel.
pub(super) struct Rehearsed {
    records: Result<Vec<Record>, SimulationError>,
    /// Steps from record to record.
    pub(super) steps: u32,
    /// Error that they leave, relative, of bodies that remember and of pressures and shear that are found together.
    of_time: Option<f64>,
}

impl Rehearsed {
    /// That of bodies which remember, or of pressures and shear together, with twice as many steps again and again, until
    /// force and depth no longer change.
    pub(super) fn of(plan: &HalfSpacePlan, pressing: &Pressing<'_>) -> Self {
        let thinned = pressing.heights.thinned();
        let response = match response(plan, &thinned) {
            Ok(response) => response,
            Err(error) => {
                return Self { records: Err(SimulationError::Refused(error.to_string())), steps: 1, of_time: None };
            }
        };
        let half = Pressing { heights: &thinned, response: &response, ..*pressing };
        let followed =
            |pressing: Pressing<'_>, steps: u32| Series::new(plan, pressing, Depth::Outline, steps).follow(&|_| ());
        let begun = |pressing: Pressing<'_>| Self { records: followed(pressing, 1), steps: 1, of_time: None };
        let first = begun(half);
        let aimed = if let Some(PixelFriction::Coupled { .. }) = plan.friction {
            OF_SLIP
        } else if plan.relaxation.is_some() {
            OF_TIME
        } else {
            return first;
        };
        let aimed = plan.accuracy().max(aimed);
        let rehearsed = first.refined(aimed, |steps| followed(half, steps));
        if rehearsed.presses_more_than(FEW, thinned.values.len()) {
            return rehearsed;
        }
        // What so few pixels do in time says nothing of as many again.
        let Self { steps, of_time, .. } = begun(*pressing).refined(aimed, |steps| followed(*pressing, steps));
        Self {
            steps: steps.max(rehearsed.steps),
            of_time: rehearsed.of_time.into_iter().chain(of_time).reduce(f64::max),
            ..rehearsed
        }
    }

    /// Whether more than so many pixels of all carry a load in one of the records.
    fn presses_more_than(&self, few: f64, all: usize) -> bool {
        let carry = |record: &Record| record.pixels.map_or(0.0, |contact| contact.area_fraction * all as f64);
        self.records.iter().flatten().any(|record| carry(record) > few)
    }

    /// Edges go from pixel to pixel, so that steps are of the first order: half of one changes what is left. Where no pixel
    /// is met within a step any more it has no error, and of twice as many pixels, which the next are, it has.
    fn refined(mut self, aimed: f64, follow: impl Fn(u32) -> Result<Vec<Record>, SimulationError>) -> Self {
        let mut before = 0.0;
        for doubling in 1..=DOUBLINGS {
            let (Ok(coarse), Ok(finer)) = (&self.records, follow(1 << doubling)) else { break };
            let apart = apart(coarse, &finer).max(energy_apart(coarse, &finer));
            let of_time = apart.max(KEPT * before);
            before = apart;
            if of_time + apart <= aimed {
                self.of_time = Some(of_time + apart);
                break;
            }
            self = Self { records: Ok(finer), steps: 1 << doubling, of_time: Some(of_time) };
            if of_time <= aimed {
                break;
            }
        }
        self
    }

    /// Error that the steps of the time leave, relative.
    pub(super) fn of_time(&self) -> Option<f64> {
        self.of_time
    }

    /// The largest energy \[J\] of its records.
    pub(super) fn energy(&self) -> f64 {
        self.records.as_deref().map_or(0.0, energy)
    }

    /// The error of the records on all of the pixels, which `series` has led to.
    pub(super) fn estimate(&self, plan: &HalfSpacePlan, records: &[Record], series: &Series<'_>) -> ErrorEstimate {
        let (rows, columns) = series.size();
        match &self.records {
            Ok(coarse) => self.beside(plan, (coarse, records), series),
            Err(error) => ErrorEstimate {
                relative: 1.0,
                basis: format!("not known: on every second of {columns} × {rows} pixels there is no answer ({error})"),
            },
        }
    }

    fn beside(
        &self,
        plan: &HalfSpacePlan,
        (coarse, records): (&[Record], &[Record]),
        series: &Series<'_>,
    ) -> ErrorEstimate {
        let ((rows, columns), tolerance) = (series.size(), settings(plan).tolerance);
        if series.largest.is_none() {
            return ErrorEstimate { relative: tolerance, basis: "the bodies never press on each other".to_owned() };
        }
        let of_pixels = apart(coarse, records);
        let (parts, ranged) = match plan.attraction {
            ElasticAdhesion::Vanishing { .. } => {
                (OF_RANGE, format!(", {OF_RANGE:.1} times that for the range of three pixels"))
            }
            ElasticAdhesion::None
            | ElasticAdhesion::Outside { .. }
            | ElasticAdhesion::Finite { .. }
            | ElasticAdhesion::Fading { .. } => (1.0, String::new()),
        };
        let of_time = self.of_time.unwrap_or(0.0);
        let in_words = self.of_time.map_or_else(String::new, |of| format!("; the steps leave {of:.0e}"));
        // What shear has cost is not known as well as what it carries.
        let loss = apart_in(|record| record.tangential?.dissipated, coarse, records);
        let rubbed = if loss > 0.0 { format!(", what friction has taken {loss:.1e}") } else { String::new() };
        // Without a past, and under friction, radii follow from pressures or areas known better than from pixel to pixel.
        let has_past = series.pixels().has_past();
        let is_known = !has_past || (plan.friction.is_some() && plan.ground.is_none());
        let radii = records.iter().filter_map(|record| record.normal.contact_radius);
        let mut of_edge = of_edge(radii, series.pixel(), is_known);
        let mut edge = String::new();
        if of_edge > 0.0 {
            edge = format!("; an edge lies within half a pixel, {of_edge:.1e} of the largest radius");
        }
        if series.pixels().attraction().is_some() {
            // What pulls holds an edge from pixel to pixel, further off the larger they are, beside how it is counted.
            let held = apart_in(|record| record.normal.contact_radius, coarse, records);
            edge = format!("{edge}, and {held:.1e} from where it is held on every second");
            of_edge += held;
        }
        let (of_area, touching) = match area_apart((coarse, records), series).filter(|_| !has_past) {
            Some((area, peak)) => (
                area,
                format!("; under the largest load peak pressure {peak:.1e}, area {area:.1e} with what its edges add"),
            ),
            None => (0.0, String::new()),
        };
        // Pixels that neighbours do nothing to are held or let go whole, and two counts of few of them may agree by chance.
        let of_held = if series.pixels().knows_losses() { counted(series).unwrap_or(0.0) } else { 0.0 };
        if of_held > 0.0 {
            edge = format!("{edge}; what is held is counted in pixels, {of_held:.1e} of its area");
        }
        let (of_touch, first) = touch_apart(plan, records, series);
        let basis = format!(
            "the whole history again on every second of {columns} × {rows} pixels: force or indentation {of_pixels:.1e} of the largest apart{ranged}{rubbed}{in_words}{first}{touching}{edge}; residual of the solver {tolerance:.0e}"
        );
        let relative = (parts * of_pixels + of_time + of_touch).max(of_edge).max(of_area).max(of_held).max(tolerance);
        ErrorEstimate { relative, basis }
    }
}

/// What it is worth that the highest peak of a rough surface may lie between its pixels, and the same in words: depths are told
/// from first touch, with which bodies that attract each other begin. A force that leads finds the same contact.
fn touch_apart(plan: &HalfSpacePlan, records: &[Record], series: &Series<'_>) -> (f64, String) {
    let below = series.below_touch();
    if plan.surface().is_none() || below <= 0.0 {
        return (0.0, String::new());
    }
    let largest = |of: fn(&Record) -> f64| records.iter().map(of).filter(|of| of.is_finite()).fold(0.0, f64::max);
    let of_whole = |of: f64, whole: f64| if whole > 0.0 { of / whole } else { 0.0 };
    let told = "; between its pixels the surface may touch earlier, ";
    let attracts = series.pixels().attraction().is_some();
    let is_forced = plan.stages.iter().filter_map(|stage| stage.control).all(|control| control == Control::Force);
    if is_forced && !attracts {
        let depth = of_whole(below, largest(|record| record.normal.indentation.map_or(0.0, f64::abs)));
        return (0.0, format!("{told}which adds {depth:.1e} of the largest to the depths alone"));
    }
    // Under a given force a stiffness moves no force, however large it is: in full contact of what repeats it has no end.
    let by_force = |entry| plan.stages.iter().any(|it| it.entry == entry && it.control == Some(Control::Force));
    let begins = usize::from(attracts);
    let by_depth =
        records[..begins.min(records.len())].iter().chain(records.iter().filter(|record| !by_force(record.entry)));
    let stiffness = by_depth.map(|record| record.normal.stiffness).filter(|of| of.is_finite()).fold(0.0, f64::max);
    let force = of_whole(below * stiffness, largest(|record| record.normal.force.abs()));
    (force, format!("{told}{force:.1e} of the largest force"))
}

/// How far area and peak pressure of the record of the largest force are apart, as parts of the finer ones.
///
/// Areas are of first order at best and scatter: their error is what counting whole pixels adds along the edges, although
/// that is taken off, or the difference if that is more.
fn area_apart((coarse, records): (&[Record], &[Record]), series: &Series<'_>) -> Option<(f64, f64)> {
    let edges = counted(series)?;
    let both =
        shared(coarse, records).filter_map(|(one, other)| Some((other.normal.force, one.pixels?, other.pixels?)));
    let (_, coarse, fine) = both.max_by(|one, other| one.0.total_cmp(&other.0))?;
    Some((part(fine.area, coarse.area).max(edges), part(fine.peak_pressure, coarse.peak_pressure)))
}

/// How far two numbers are apart, of the first.
fn part(of: f64, other: f64) -> f64 {
    if of > 0.0 { (other / of - 1.0).abs() } else { 1.0 }
}

/// Part of the largest contact that counting whole pixels adds along its edges.
fn counted(series: &Series<'_>) -> Option<f64> {
    let contact = &series.largest.as_ref()?.1.contact;
    Some(part(contact.contact_area(), contact.corrected_area()))
}

/// Half a pixel, of the largest of the radii of contact \[m\]: what is known of an edge that is found by counting pixels.
/// Where it follows from pressures or areas it is known better, but of a contact no wider than two pixels.
fn of_edge(radii: impl Iterator<Item = f64>, pixel: [f64; 2], known: bool) -> f64 {
    let side = pixel[0].max(pixel[1]);
    let (mut least, mut largest) = (f64::INFINITY, 0.0_f64);
    for radius in radii.filter(|&radius| radius > 0.0) {
        (least, largest) = (least.min(radius), largest.max(radius));
    }
    let is_counted = !known || least < side;
    if largest > 0.0 && is_counted { 0.5 * side / largest } else { 0.0 }
}

/// How far two histories are apart at the times that both have, in forces and in indentation, of the largest of each.
fn apart(one: &[Record], other: &[Record]) -> f64 {
    let of = |value| apart_in(value, one, other);
    let normal = of(|record| Some(record.normal.force)).max(of(|record| record.normal.indentation));
    normal.max(of(Record::tangential_force))
}

/// How far they are apart in what they have lost, of the largest energy of both.
fn energy_apart(one: &[Record], other: &[Record]) -> f64 {
    let (lost, largest) = (|record: &Record| record.normal.dissipated, energy(one).max(energy(other)));
    let apart = shared(one, other).map(|(one, other)| (lost(one) - lost(other)).abs()).fold(0.0, f64::max);
    if largest > 0.0 { apart / largest } else { 0.0 }
}

/// The largest energy \[J\] of records.
fn energy(records: &[Record]) -> f64 {
    let of = |normal: &Normal| normal.stored.stored().abs().max(normal.dissipated);
    records.iter().map(|record| of(&record.normal)).fold(0.0, f64::max)
}

/// The same in one quantity.
fn apart_in(value: fn(&Record) -> Option<f64>, one: &[Record], other: &[Record]) -> f64 {
    let (mut apart, mut largest) = (0.0_f64, 0.0_f64);
    for (one, other) in shared(one, other) {
        if let (Some(one), Some(other)) = (value(one), value(other)) {
            apart = apart.max((one - other).abs());
            largest = largest.max(one.abs()).max(other.abs());
        }
    }
    if largest > 0.0 { apart / largest } else { 0.0 }
}

/// Records of the same instants.
fn shared<'r>(one: &'r [Record], other: &'r [Record]) -> impl Iterator<Item = (&'r Record, &'r Record)> {
    let mut rest = other.iter().peekable();
    one.iter().filter_map(move |record| {
        while rest.next_if(|next| (next.entry, next.time) < (record.entry, record.time)).is_some() {}
        rest.next_if(|next| (next.entry, next.time) == (record.entry, record.time)).map(|other| (record, other))
    })
}
