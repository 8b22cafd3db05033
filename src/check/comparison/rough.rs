//! Rough shapes: the bed of a line beside the half-space under the surface itself.

use super::{Candidate, Compared, Contest};
use crate::check::case::Attempt;
use crate::check::row::{Computed, Found, Setting};
use crate::check::study::Method;
use crate::contact::model::{ContactModel, Pull};
use crate::contact::rough::{RoughBed, YieldingRough};
use crate::scene::plan::RoughPlan;
use crate::shape::Boundary;
use crate::shape::rough::RoughLine;
use std::sync::Arc;

/// Springs of the line.
const POINTS: [usize; 5] = [1024, 4096, 16384, 65536, 262_144];
/// Most members of an ensemble that are compared: the half-space takes its time for each.
const MEMBERS: usize = 4;
/// Stiffness is the difference quotient down to this share of the force.
const BELOW: f64 = 0.9;

/// What is compared: the state under a force.
struct Rough {
    plan: RoughPlan,
    /// Normal force [N].
    force: f64,
    /// What happens at the edge of the surface.
    #[cfg_attr(not(feature = "half-space"), expect(dead_code, reason = "only pixels have an edge"))]
    boundary: Boundary,
}

/// The methods under the force [N] of a rough scene.
pub(super) fn contest(plan: RoughPlan, force: f64, boundary: Boundary) -> Contest {
    let rough = Arc::new(Rough { plan, force, boundary });
    let (mut notes, mut methods, mut candidates) = (rough.notes(), Vec::new(), Vec::new());
    let least = 2 * (rough.plan.surface.rings.variances().len() - 1);
    for points in POINTS.into_iter().filter(|&points| points >= least) {
        let name = format!("bed of {points} springs, the finest");
        candidates.insert(0, Candidate { at: methods.len(), name });
        methods.push(rough.method("springs", Setting::springs(points), move |own, seed| own.line(seed, points)));
    }
    let grids = surface::methods(&rough).unwrap_or_else(|note| {
        notes.push(note);
        Vec::new()
    });
    for (name, method) in grids {
        candidates.insert(0, Candidate { at: methods.len(), name });
        methods.push(method);
    }
    if methods.is_empty() {
        notes.push(format!("no bed of at most {} springs carries the shortest wave", POINTS[POINTS.len() - 1]));
    }
    let members = rough.seeds().len();
    Contest { compared: Compared::Rough, methods, exact: None, candidates, pressure: None, members, notes }
}

impl Rough {
    fn notes(&self) -> Vec<String> {
        let mut notes = vec![
            "the state is that of the largest force; indentation counts from first touch".to_owned(),
            "the line of the springs is another random surface of the same spectrum: single surfaces scatter by tens of per cent, and the share of springs in contact is not the contact area".to_owned(),
        ];
        if self.plan.relaxation.is_some() {
            notes.push("bodies that relax are compared by what they give at once, E*(0)".to_owned());
        }
        if self.plan.works.is_some() {
            notes.push("bodies that adhere are compared as if they did not".to_owned());
        }
        if self.plan.surface.seeds.len() > MEMBERS {
            notes.push(format!("means over the first {MEMBERS} of {} seeds", self.plan.surface.seeds.len()));
        }
        notes
    }

    /// The seeds compared.
    fn seeds(&self) -> &[u64] {
        &self.plan.surface.seeds[..self.plan.surface.seeds.len().min(MEMBERS)]
    }

    /// A method that computes every member of the ensemble; what it finds is the mean.
    fn method(
        self: &Arc<Self>,
        name: &'static str,
        setting: Setting,
        member: impl Fn(&Self, u64) -> Attempt<Computed> + Copy + 'static,
    ) -> Method {
        Method::of(name, setting, self, move |rough| {
            let solved: Attempt<Vec<Computed>> = rough.seeds().iter().map(|&seed| member(rough, seed)).collect();
            Ok(mean(&solved?))
        })
    }

    fn line(&self, seed: u64, points: usize) -> Attempt<Computed> {
        let line = RoughLine::new(&self.plan.surface.rings, seed);
        let modulus = self.plan.pair.normal;
        if let Some(hardness) = self.plan.hardness {
            let base = self.plan.base.as_deref();
            return self.yielded(YieldingRough::new(&line, points, (modulus, hardness), base)?);
        }
        let bed = RoughBed::under(&line, points, modulus, |x| self.plan.reduced(x))?;
        let depth = |force: f64| bed.at_force(force).indentation;
        let found = self.found([depth(BELOW * self.force), depth(self.force)], bed.first_touch());
        Ok(Computed { found, bytes: 24 * points, ..Computed::default() })
    }

    fn yielded(&self, mut line: YieldingRough) -> Attempt<Computed> {
        let mut depth = |force: f64| -> Attempt<f64> {
            line.press(&Pull { force, slide: 0.0, sliding_speed: 0.0, duration: 1.0 }).transpose()?;
            Ok(line.state().indentation.unwrap_or(0.0))
        };
        let found = self.found([depth(BELOW * self.force)?, depth(self.force)?], 0.0);
        Ok(Computed { found, bytes: line.effort().bytes, ..Computed::default() })
    }

    /// The state from the indentations at nine tenths of the force and at the force.
    fn found(&self, [below, here]: [f64; 2], touch: f64) -> Found {
        Found {
            indentation_m: Some(here - touch),
            force_n: Some(self.force),
            stiffness_n_per_m: Some((1.0 - BELOW) * self.force / (here - below)),
            ..Found::default()
        }
    }
}

/// The mean of the members, and the most that one of them takes.
fn mean(members: &[Computed]) -> Computed {
    let mean = |of: fn(&Found) -> Option<f64>| {
        let values: Option<Vec<f64>> = members.iter().map(|member| of(&member.found)).collect();
        values.map(|values| values.iter().sum::<f64>() / values.len() as f64)
    };
    let found = Found {
        indentation_m: mean(|found| found.indentation_m),
        force_n: mean(|found| found.force_n),
        contact_radius_m: None,
        peak_pressure_pa: mean(|found| found.peak_pressure_pa),
        stiffness_n_per_m: mean(|found| found.stiffness_n_per_m),
        area_fraction: mean(|found| found.area_fraction),
    };
    let bytes = members.iter().map(|member| member.bytes).max().unwrap_or(0);
    let iterations = members.iter().filter_map(|member| member.iterations).max();
    Computed { found, bytes, iterations, ..Computed::default() }
}

/// No half-space.
#[cfg(not(feature = "half-space"))]
mod surface {
    pub(super) fn methods(_: &std::sync::Arc<super::Rough>) -> Result<Vec<(String, super::Method)>, String> {
        super::super::WITHOUT.map_or(Ok(Vec::new()), |note| Err(note.to_owned()))
    }
}

/// The rough surface itself on the full half-space.
#[cfg(feature = "half-space")]
mod surface {
    use super::super::GRIDS;
    use super::{Arc, Attempt, BELOW, Boundary, Computed, Found, Method, Rough, Setting};
    use crate::halfspace::{
        HalfSpaceError, Prescribed, PressedMap, Settings, Start, SurfaceResponse, bytes_needed, solve_on,
    };
    use crate::run::half_space::Heights;
    use crate::scene::surface::Source;

    /// Relative residual: far below the scatter of surfaces.
    const TOLERANCE: f64 = 1e-6;
    /// Most pixels of all members on one grid, unless a coarser one would not carry the roughness.
    const MOST_PIXELS: usize = 1 << 20;
    /// The same of bodies that yield, whose depth is searched for.
    const MOST_YIELDING: usize = 1 << 16;
    /// Coarsest map made from a larger one.
    const COARSEST: usize = 24;

    /// The half-space on all grids, and what it is called where it is right.
    pub(super) fn methods(rough: &Arc<Rough>) -> Result<Vec<(String, Method)>, String> {
        let method = |grid| rough.method("half-space", Setting::grid(grid), move |own, seed| pressed(own, grid, seed));
        let named = |grid| (format!("half-space on {grid}² pixels, the finest grid"), method(grid));
        Ok(grids(rough)?.into_iter().map(named).collect())
    }

    /// Pixels on the sides of the grids that carry the roughness; what is too large is told.
    ///
    /// Of a height map, every pixel, every second, every fourth.
    fn grids(rough: &Rough) -> Result<Vec<usize>, String> {
        if let Source::Map(map) = &rough.plan.surface.source {
            let (rows, columns) = map.heights().dim();
            refused([rows, columns])?;
            let side = rows.min(columns);
            let carries = |stride: &usize| *stride == 1 || side / stride >= COARSEST;
            return Ok([4, 2, 1].into_iter().filter(carries).map(|stride| rows.div_ceil(stride)).collect());
        }
        let least = 2 * (rough.plan.surface.rings.variances().len() - 1);
        refused([least, least])?;
        let fine: Vec<usize> = GRIDS.into_iter().filter(|&grid| grid >= least.max(GRIDS[1])).collect();
        let largest = GRIDS[GRIDS.len() - 1];
        let Some(&first) = fine.first() else {
            return Err(format!(
                "half-space: the shortest wave needs {least}² pixels ({:.1e} bytes); not tried above {largest}²",
                bytes_needed([least; 2], Boundary::Free) as f64
            ));
        };
        let most = if rough.plan.hardness.is_some() { MOST_YIELDING } else { MOST_PIXELS };
        let affordable = |grid: usize| grid * grid * rough.seeds().len() <= most;
        Ok(fine.into_iter().filter(|&grid| grid == first || affordable(grid)).collect())
    }

    /// A grid that does not fit into the memory allowed.
    fn refused(size: [usize; 2]) -> Result<(), String> {
        let (needed, limit) = (bytes_needed(size, Boundary::Free), Settings::default().memory_limit);
        let [rows, columns] = size;
        let refusal = HalfSpaceError::Memory { rows, columns, needed, limit };
        if needed > limit { Err(format!("half-space: {refusal}")) } else { Ok(()) }
    }

    fn pressed(rough: &Rough, grid: usize, seed: u64) -> Attempt<Computed> {
        let Heights { values: heights, pixel } = &heights(rough, grid, seed)?;
        let (touch, pixel) = (heights.iter().copied().fold(f64::INFINITY, f64::min), *pixel);
        let settings = Settings { tolerance: TOLERANCE, ..Settings::default() };
        let response = SurfaceResponse::over(None, heights.dim().into(), pixel, rough.boundary)
            .yielding_under(rough.plan.hardness.unwrap_or(f64::INFINITY));
        let at = |force: f64, start: Start<'_>| {
            let (modulus, control) = (rough.plan.pair.normal, Prescribed::Force(force));
            let problem = PressedMap { heights: heights.view(), pixel, modulus, boundary: rough.boundary, control };
            solve_on(&response, &problem, start, &settings)
        };
        let here = at(rough.force, Start::Coarser)?;
        let below = at(BELOW * rough.force, Start::Pressure(here.pressure.view()))?;
        let found = Found {
            peak_pressure_pa: Some(here.peak_pressure()),
            area_fraction: Some(here.area_fraction()),
            ..rough.found([below.indentation, here.indentation], touch)
        };
        let (bytes, iterations) = (usize::try_from(here.bytes)?, Some(here.iterations));
        Ok(Computed { found, bytes, iterations, ..Computed::default() })
    }

    /// Heights of the indenter, away from the half-space.
    fn heights(rough: &Rough, grid: usize, seed: u64) -> Attempt<Heights> {
        Ok(match &rough.plan.surface.source {
            Source::Spectrum(spectrum) => {
                let base = rough.plan.base.as_deref();
                Heights::of_spectrum(spectrum, base, (rough.plan.surface.length(), grid), seed)?
            }
            Source::Map(map) => Heights::of_map(map, map.heights().nrows().div_ceil(grid)),
        })
    }
}
