//! Steady states of a body that glides over pixels, speed after speed.

use super::heights::Heights;
use super::state::Pressing;
use crate::contact::adhesion::equilibrium::Control;
use crate::contact::gliding::SteadyState;
use crate::halfspace::steady::{SteadyContact, SteadyResponse, Travelled};
use crate::halfspace::{HalfSpaceError, Prescribed, Solution};
use crate::material::Spectrum;
use crate::run::SimulationError;
use crate::run::gliding::{self, ROUGH, Rubbing, beside_theory, held};
use crate::run::record::{ErrorEstimate, Record};
use crate::run::table::{Column, Table};
use crate::run::unit::Unit;
use crate::scene::law::Travel;
use crate::scene::plan::{HalfSpacePlan, PixelledIndenter};
use crate::shape::Boundary;
use ndarray::{Array2, ArrayView2};

/// The steady states, one per speed.
#[derive(Default)]
pub(super) struct Glides {
    pub(super) states: Vec<SteadyState>,
    contacts: Vec<Touching>,
    /// The same with the areas over which their heat is spread.
    pub(super) rubbing: Vec<Rubbing>,
    /// The contact at the last speed.
    pub(super) last: Option<Solution>,
}

/// Where a body that glides touches.
#[derive(Debug, Clone, Copy)]
struct Touching {
    area: f64,
    area_fraction: f64,
    peak_pressure: f64,
}

const COLUMNS: [Column<Touching>; 3] = [
    Column::new("area", Unit::SQUARE_METRE, "contact area A", |contact| Some(contact.area)),
    Column::new("area_fraction", Unit::ONE, "contact area A/A₀", |contact| Some(contact.area_fraction)),
    Column::new("peak_pressure", Unit::PASCAL, "largest pressure", |contact| Some(contact.peak_pressure)),
];

/// How often the way between two speeds is halved to get from one to the other.
const HALVINGS: u32 = 6;
/// By how much slower the body is that is looked at first if the way from rest is too long.
const SLOWER: f64 = 4.0;

/// What the error of a steady state is.
const BASIS: &str = "steady motion: resistance and force against those on every second pixel";

/// A body on the pixels it glides over.
struct Sliding<'s> {
    spectrum: &'s Spectrum,
    heights: &'s Heights,
    boundary: Boundary,
    prescribed: Prescribed,
}

/// A steady state, and the speed [m/s] at which it is one.
struct Steady {
    speed: f64,
    contact: SteadyContact,
}

impl Sliding<'_> {
    /// The steady state at the speed `speed` [m/s], sought from that at another one on, from that on every second pixel, or
    /// from a body at rest; if none leads there, by speeds between.
    fn at(
        &self,
        plan: &HalfSpacePlan,
        (speed, pressing): (f64, &Pressing<'_>),
        (start, coarser, halvings): (Option<&Steady>, Option<&Steady>, u32),
    ) -> Result<Steady, HalfSpaceError> {
        let (pixel, boundary) = (self.heights.pixel, self.boundary);
        let travelled = Travelled { pixel, boundary, speed, ground: plan.ground.clone() };
        let response = SteadyResponse::new(self.spectrum, self.heights.values.dim().into(), &travelled);
        let from = |start: Option<ArrayView2<'_, f64>>| {
            let contact = response.solve(self.heights.values.view(), self.prescribed, start, &pressing.settings)?;
            Ok(Steady { speed, contact })
        };
        let refined = coarser.map(|coarser| self.refined(&coarser.contact.solution.pressure));
        let starts = [start.map(|start| start.contact.solution.pressure.view()), refined.as_ref().map(|p| p.view())];
        for start in starts.into_iter().flatten() {
            match from(Some(start)) {
                Err(HalfSpaceError::NotConverged { .. }) => {}
                found => return found,
            }
        }
        match from(None) {
            Err(HalfSpaceError::NotConverged { .. }) if halvings > 0 => {
                let between = start.map_or(speed / SLOWER, |start| (start.speed * speed).sqrt());
                let there = self.at(plan, (between, pressing), (start, None, halvings - 1))?;
                self.at(plan, (speed, pressing), (Some(&there), None, halvings - 1))
            }
            found => found,
        }
    }

    /// Pressures of every second pixel on all of them.
    fn refined(&self, coarser: &Array2<f64>) -> Array2<f64> {
        let (rows, columns) = coarser.dim();
        let at = |(i, j): (usize, usize)| coarser[[(i / 2).min(rows - 1), (j / 2).min(columns - 1)]];
        Array2::from_shape_fn(self.heights.values.dim(), at)
    }
}

/// The steady states behind the history that has led to `records`; none of a body that does not glide.
///
/// # Errors
/// The contact does not converge, or is full at a depth.
pub(super) fn steady(
    plan: &HalfSpacePlan,
    pressing: &Pressing<'_>,
    records: &[Record],
) -> Result<Glides, SimulationError> {
    let Some(travel) = &plan.travel else { return Ok(Glides::default()) };
    let prescribed = match held(plan, travel, records) {
        (Control::Indentation, depth) => Prescribed::Indentation(pressing.touch + depth),
        (Control::Force, force) => Prescribed::Force(force),
    };
    at_speeds(plan, pressing, (travel, prescribed)).map_err(|error| SimulationError::Refused(error.to_string()))
}

fn at_speeds(
    plan: &HalfSpacePlan,
    pressing: &Pressing<'_>,
    (travel, prescribed): (&Travel, Prescribed),
) -> Result<Glides, HalfSpaceError> {
    let (spectrum, thinned) = (Spectrum::new(&travel.relaxation), pressing.heights.thinned());
    let on = |heights| Sliding { spectrum: &spectrum, heights, boundary: plan.boundary, prescribed };
    let (fine, coarse) = (on(pressing.heights), on(&thinned));
    let (mut glides, mut last, mut coarser) = (Glides::default(), None, None);
    for &speed in &travel.speeds {
        let rough = coarse.at(plan, (speed, pressing), (coarser.as_ref(), None, HALVINGS))?;
        let found = fine.at(plan, (speed, pressing), (last.as_ref(), Some(&rough), HALVINGS))?;
        let error = apart(&found.contact, &rough.contact);
        glides.states.push(state(plan, pressing, &found.contact, (speed, error)));
        glides.contacts.push(touching(&found.contact.solution));
        glides.rubbing.extend(rubbing(plan, pressing.heights, &glides));
        (last, coarser) = (Some(found), Some(rough));
    }
    glides.last = last.map(|steady| steady.contact.solution);
    Ok(glides)
}

/// How far force and resistance are apart on two grids, as parts of the finer one's.
fn apart(fine: &SteadyContact, coarse: &SteadyContact) -> f64 {
    let part = |of: f64, other: f64| if of.abs() > 0.0 { (other / of - 1.0).abs() } else { other.abs() };
    part(fine.solution.force(), coarse.solution.force()).max(part(fine.resistance, coarse.resistance))
}

fn state(
    plan: &HalfSpacePlan,
    pressing: &Pressing<'_>,
    SteadyContact { solution, resistance }: &SteadyContact,
    (speed, error): (f64, f64),
) -> SteadyState {
    let edges = match &plan.indenter {
        PixelledIndenter::Smooth(_) | PixelledIndenter::Ellipsoid(..) => edges(solution),
        PixelledIndenter::Tips(_) | PixelledIndenter::Rough(..) => None,
    };
    SteadyState {
        speed,
        indentation: solution.indentation - pressing.touch,
        force: solution.force(),
        resistance: *resistance,
        work: *resistance,
        leading_edge: edges.map(|[_, leading]| leading),
        trailing_edge: edges.map(|[trailing, _]| trailing),
        rms_slope: pressing.heights.rms_slope_where(&solution.pressure),
        error,
    }
}

/// Where the contact of a tip ends and begins along the motion [m].
fn edges(solution: &Solution) -> Option<[f64; 2]> {
    let (_, columns) = solution.pressure.dim();
    let touches = |column: &usize| solution.pressure.column(*column).iter().any(|&p| p > 0.0);
    let (first, last) = ((0..columns).find(touches)?, (0..columns).rev().find(touches)?);
    let at = |border: f64| (border - 0.5 - (columns / 2) as f64) * solution.pixel[0];
    Some([at(first as f64), at(last as f64 + 1.0)])
}

fn touching(solution: &Solution) -> Touching {
    let [width, height] = solution.pixel;
    let area = solution.corrected_area();
    let whole = width * height * solution.pressure.len() as f64;
    Touching { area, area_fraction: area / whole, peak_pressure: solution.peak_pressure() }
}

/// The last steady state, with the nominal area of a rough surface or else that of its contact.
fn rubbing(plan: &HalfSpacePlan, heights: &Heights, glides: &Glides) -> Option<Rubbing> {
    let flat = plan.surface().is_some() && plan.profile().is_none();
    let nominal = heights.pixel[0] * heights.pixel[1] * heights.values.len() as f64;
    let area = if flat { nominal } else { glides.contacts.last()?.area };
    Some((*glides.states.last()?, area))
}

impl Glides {
    /// One row per speed; of a flat rough surface with Persson's theory beside it.
    pub(super) fn table(&self, plan: &HalfSpacePlan) -> Option<Table> {
        let table = gliding::table(&self.states)?.with(&COLUMNS, self.contacts.iter());
        let table = table.with(&ROUGH, self.rubbing.iter());
        let (Some(surface), None, Some(travel)) = (plan.surface(), plan.profile(), &plan.travel) else {
            return Some(table);
        };
        Some(beside_theory(table, (surface, travel), &self.states))
    }

    /// The estimate, unless a steady state is known less well.
    pub(super) fn at_least(&self, estimate: ErrorEstimate) -> ErrorEstimate {
        gliding::at_least(estimate, &self.states, BASIS)
    }

    /// Whether a contact meets the border of a window beyond which its body goes on.
    pub(super) fn meets_border(&self) -> bool {
        self.last.as_ref().is_some_and(|last| {
            let (rows, columns) = last.pressure.dim();
            last.pressure.indexed_iter().any(|((row, column), &p)| {
                p > 0.0 && (row == 0 || column == 0 || row + 1 == rows || column + 1 == columns)
            })
        })
    }
}
