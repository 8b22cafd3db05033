//! The history of bodies with a past, gone through on fewer pixels first: how many steps it takes, and what pixels cost.

use super::error::of_edge;
use super::heights::Heights;
use super::series::{Depth, Series};
use super::state::{Pressing, response};
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

/// What twice as many steps are worth.
struct Order {
    /// Error that is aimed at where less is asked for.
    aimed: f64,
    /// Part of what two histories are apart by which the finer one is wrong, its inverse: 2ⁿ − 1 of the order n.
    parts: f64,
}

impl Rehearsed {
    /// Of bodies with a past, or friction; that of bodies which remember, or of pressures and shear together, with twice as many
    /// steps again and again, until force and depth no longer change.
    pub(super) fn of(plan: &HalfSpacePlan, pressing: &Pressing<'_>) -> Option<Self> {
        let thinned = pressing.heights.thinned();
        let response = response(plan, &thinned).ok()?;
        let pressing = Pressing { heights: &thinned, response: &response, ..*pressing };
        let follow = |steps: u32| {
            let mut series = Series::new(plan, pressing, Depth::Outline, steps);
            series.has_past().then(|| series.follow(&|_| ()))
        };
        let first = Self { records: follow(1)?, steps: 1, of_time: None };
        let order = if let Some(PixelFriction::Coupled { .. }) = plan.friction {
            Order { aimed: OF_SLIP, parts: 1.0 }
        } else if plan.relaxation.is_some() {
            Order { aimed: OF_TIME, parts: 3.0 }
        } else {
            return Some(first);
        };
        Some(first.refined(plan.accuracy().max(order.aimed), order, follow))
    }

    fn refined(
        mut self,
        aimed: f64,
        order: Order,
        follow: impl Fn(u32) -> Option<Result<Vec<Record>, SimulationError>>,
    ) -> Self {
        for doubling in 1..=DOUBLINGS {
            let (Ok(coarse), Some(Ok(finer))) = (&self.records, follow(1 << doubling)) else { break };
            let apart = apart(coarse, &finer);
            let of_time = apart / order.parts;
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

    /// The largest energy \[J\] of its records.
    pub(super) fn energy(&self) -> f64 {
        let of = |normal: &Normal| normal.stored.stored().abs().max(normal.dissipated);
        self.records.iter().flatten().map(|record| of(&record.normal)).fold(0.0, f64::max)
    }

    /// The error of the records on all of the pixels.
    pub(super) fn estimate(&self, plan: &HalfSpacePlan, records: &[Record], heights: &Heights) -> ErrorEstimate {
        let (rows, columns) = heights.values.dim();
        // The radius under Hertz' pressures is not counted in pixels.
        let hertzian = plan.friction.is_some() && plan.ground.is_none();
        match &self.records {
            Ok(coarse) => {
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
                let radii = records.iter().filter_map(|record| record.normal.contact_radius);
                let of_edge = of_edge(radii, heights.pixel, hertzian);
                let edge = if of_edge > 0.0 {
                    format!("; the edge lies within half a pixel, {of_edge:.1e} of the radius")
                } else {
                    String::new()
                };
                let basis = format!(
                    "the whole history again on every second of {columns} × {rows} pixels: force or indentation {of_pixels:.1e} of the largest apart{ranged}{rubbed}{in_words}{edge}"
                );
                ErrorEstimate { relative: (parts * of_pixels + of_time).max(of_edge), basis }
            }
            Err(error) => ErrorEstimate {
                relative: 1.0,
                basis: format!("not known: on every second of {columns} × {rows} pixels there is no answer ({error})"),
            },
        }
    }
}

/// How far two histories are apart at the times that both have, in forces and in indentation, of the largest of each.
fn apart(one: &[Record], other: &[Record]) -> f64 {
    let of = |value| apart_in(value, one, other);
    let normal = of(|record| Some(record.normal.force)).max(of(|record| record.normal.indentation));
    normal.max(of(Record::tangential_force))
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
