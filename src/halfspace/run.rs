//! From a problem in the solver's units to its solution, coarse grids first.

use std::cell::OnceCell;
use std::ops::Range;
use std::sync::Arc;

use super::HalfSpaceError;
use super::face::{Budget, Goal, GridContact, GridSolution};
use super::grid::{Grid, Law, Operators, Window, Windows};
use super::kernel::Beneath;
use super::precision::Scratch;
use super::vector::{each, fold, scale, total, update};
use rayon::prelude::*;

/// Relative residual to which a coarser grid is solved before the next finer one starts from it.
const COARSE_TOLERANCE: f64 = 1e-3;

/// Times the part worked on may be widened, or its rounding worked off; the second time is rare.
const MOST_ROUNDS: usize = 50;

/// Pixels kept around the contact known so far.
const MARGIN: usize = 3;

/// A problem in the solver's units.
pub(super) struct Task<'o> {
    pub(super) grid: Grid,
    pub(super) law: Law,
    pub(super) wanted: ScaledLoad,
    pub(super) tolerance: f64,
    pub(super) max_iterations: usize,
    /// Largest pressure.
    pub(super) hardness: f64,
    /// The maps of the whole grid, where they are known already.
    pub(super) whole: Option<&'o Operators>,
    /// What lies beneath, if it is no half-space.
    pub(super) beneath: Option<Beneath<'o>>,
    /// The maps of windows of the finest grid, where they are kept.
    pub(super) windows: Option<&'o Windows>,
}

/// What is prescribed, whatever the grid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum ScaledLoad {
    /// Approach.
    Approach(f64),
    /// Σ of pressure × (pixel side) on a half-space, × 1 on a half-plane.
    Force(f64),
}

/// Where the pressure on the finest grid starts from.
pub(super) enum Origin {
    /// The solution of the next coarser grid.
    Coarser,
    /// No knowledge.
    Nothing,
    /// This pressure.
    Pressure(Vec<f64>),
}

/// Solution in the solver's units.
pub(super) struct ScaledSolution {
    pub(super) pressure: Vec<f64>,
    pub(super) displacement: Vec<f64>,
    pub(super) approach: f64,
    pub(super) residual: f64,
    pub(super) effort: Budget,
}

impl Task<'_> {
    pub(super) fn run(&self, origin: Origin) -> Result<ScaledSolution, HalfSpaceError> {
        let mut scratch = Scratch::default();
        let start = match origin {
            Origin::Pressure(pressure) => pressure,
            Origin::Nothing => self.blank(&self.grid),
            Origin::Coarser => self.coarser_start(&self.grid, &mut scratch),
        };
        self.finish(start, &mut scratch)
    }

    fn goal(&self, grid: &Grid) -> Goal {
        match (self.wanted, self.law) {
            (ScaledLoad::Approach(approach), _) => Goal::Approach(approach),
            (ScaledLoad::Force(force), Law::FreePlane(_) | Law::PeriodicPlane) => Goal::Sum(force),
            (ScaledLoad::Force(force), _) => Goal::Sum(force / grid.unit()),
        }
    }

    /// Hardness in the pressures of a grid, which are measured in the side of its pixels.
    fn hardness_on(&self, grid: &Grid) -> f64 {
        self.hardness * grid.unit() / self.grid.unit()
    }

    /// Nothing for a prescribed approach, a uniform pressure for a prescribed force.
    fn blank(&self, grid: &Grid) -> Vec<f64> {
        let value = match self.goal(grid) {
            Goal::Approach(_) => 0.0,
            Goal::Sum(sum) => sum / each(&grid.heights).filter(|height| height.is_finite()).count().max(1) as f64,
        };
        each(&grid.heights).map(|height| if height.is_finite() { value } else { 0.0 }).collect()
    }

    /// Pressure of the next coarser grid, itself started likewise; nothing if there is none.
    fn coarser_start(&self, grid: &Grid, scratch: &mut Scratch) -> Vec<f64> {
        let Some(coarse) = grid.coarser(self.law) else {
            return self.blank(grid);
        };
        let mut pressure = self.coarser_start(&coarse, scratch);
        let mut effort = Budget { iterations: 0, products: 0, limit: self.max_iterations };
        if let Some(window) = self.window(&coarse, &pressure) {
            let operators = Operators::new(&coarse, window.size, self.law, self.beneath);
            let (goal, hardness) = (self.goal(&coarse), self.hardness_on(&coarse));
            let part = WindowedGrid { operators: &operators, grid: &coarse, window, goal, hardness };
            part.solve(&mut pressure, COARSE_TOLERANCE.max(self.tolerance), &mut effort, scratch);
        }
        grid.refine(&pressure, &coarse, self.law)
    }

    /// Part of the grid where contact can be expected.
    fn window(&self, grid: &Grid, pressure: &[f64]) -> Option<Window> {
        if self.law.is_periodic() {
            return Some(grid.whole());
        }
        grid.window(MARGIN, |index| pressure[index] > 0.0).or_else(|| match self.wanted {
            ScaledLoad::Approach(approach) => grid.window(0, |index| grid.heights[index] < approach),
            ScaledLoad::Force(_) => Some(grid.whole()),
        })
    }

    /// Solves the finest grid until the whole of it, not only the part worked on, obeys the tolerance.
    fn finish(&self, mut pressure: Vec<f64>, scratch: &mut Scratch) -> Result<ScaledSolution, HalfSpaceError> {
        let grid = &self.grid;
        let mut effort = Budget { iterations: 0, products: 0, limit: self.max_iterations };
        let mut rounds = 0;
        let mut part = self.part(self.window(grid, &pressure).unwrap_or(grid.whole()));
        let made = OnceCell::new();
        let whole = || {
            self.whole.unwrap_or_else(|| made.get_or_init(|| Operators::new(grid, grid.size, self.law, self.beneath)))
        };
        loop {
            let (window, maps) = &part;
            let operators = match maps {
                Some(maps) => maps,
                None => whole(),
            };
            let (goal, hardness) = (self.goal(grid), self.hardness_on(grid));
            let outcome = WindowedGrid { operators, grid, window: *window, goal, hardness }.solve(
                &mut pressure,
                self.tolerance,
                &mut effort,
                scratch,
            );
            let whole = whole();
            let mut displacement = vec![0.0; pressure.len()];
            whole.influence.apply(&pressure, &mut displacement, scratch);
            effort.products += 1;
            let residual = self.residual(&pressure, &displacement, outcome.approach, whole.compliance);
            if residual <= self.tolerance {
                return Ok(ScaledSolution { pressure, displacement, approach: outcome.approach, residual, effort });
            }
            rounds += 1;
            if effort.iterations >= effort.limit || rounds >= MOST_ROUNDS {
                return Err(HalfSpaceError::NotConverged {
                    iterations: effort.iterations,
                    residual,
                    tolerance: self.tolerance,
                });
            }
            let overlap =
                |index: usize| pressure[index] > 0.0 || displacement[index] + grid.heights[index] < outcome.approach;
            let wider = if self.law.is_periodic() { None } else { grid.window(MARGIN, overlap) };
            if let Some(wider) = wider.filter(|wider| wider != window) {
                part = self.part(wider);
            }
        }
    }

    /// The part of the finest grid to be worked on, and its maps; none of the whole, whose own are kept.
    fn part(&self, window: Window) -> (Window, Option<Arc<Operators>>) {
        let window = self.grid.stepped(window);
        let made = |size| match self.windows {
            Some(windows) => windows.of(size),
            None => Arc::new(Operators::new(&self.grid, size, self.law, self.beneath)),
        };
        (window, (window != self.grid.whole()).then(|| made(window.size)))
    }

    /// Largest gap in contact or overlap out of it, relative to the largest displacement in contact.
    fn residual(&self, pressure: &[f64], displacement: &[f64], approach: f64, compliance: f64) -> f64 {
        if !approach.is_finite() {
            return f64::INFINITY;
        }
        let hardness = self.hardness_on(&self.grid);
        let piece = |range: Range<usize>| {
            let (mut misfit, mut scale) = (0.0_f64, f64::MIN_POSITIVE);
            let displaced = pressure[range.clone()].iter().zip(&displacement[range.clone()]);
            for ((&p, &u), &height) in displaced.zip(&self.grid.heights[range]) {
                let gap = u + height - approach;
                if !(p.is_finite() && u.is_finite()) {
                    misfit = f64::INFINITY;
                } else if p > 0.0 {
                    misfit = misfit.max(if p < hardness { gap.abs() } else { gap.max(0.0) });
                    scale = scale.max(u.abs()).max(compliance * p);
                } else {
                    misfit = misfit.max(-gap);
                }
            }
            (misfit, scale)
        };
        let larger = |one: (f64, f64), other: (f64, f64)| (one.0.max(other.0), one.1.max(other.1));
        let (misfit, scale) = fold(pressure.len(), piece, (0.0, f64::MIN_POSITIVE), larger);
        misfit / scale
    }
}

/// The part of a grid that is worked on.
struct WindowedGrid<'a> {
    operators: &'a Operators,
    grid: &'a Grid,
    window: Window,
    goal: Goal,
    hardness: f64,
}

impl WindowedGrid<'_> {
    /// Pressure where there is material, scaled to the force; a uniform one if that leaves nothing of it.
    fn start(&self, pressure: Vec<f64>, heights: &[f64]) -> Vec<f64> {
        let material = |p: f64, height: f64| if height.is_finite() { p } else { 0.0 };
        let mut part = pressure;
        update(&mut part, heights, |p, height| *p = material(*p, height));
        if let Goal::Sum(wanted) = self.goal {
            if total(&part) <= 0.0 {
                update(&mut part, heights, |p, height| *p = material(1.0, height));
            }
            let factor = wanted / total(&part);
            scale(&mut part, factor);
        }
        part
    }

    fn solve(
        &self,
        pressure: &mut Vec<f64>,
        tolerance: f64,
        effort: &mut Budget,
        scratch: &mut Scratch,
    ) -> GridSolution {
        let heights = self.grid.cut(&self.grid.heights, self.window);
        let mut part = self.start(self.grid.cut(pressure, self.window).into_owned(), &heights);
        let contact =
            GridContact { operators: self.operators, heights: &heights, goal: self.goal, hardness: self.hardness };
        let outcome = contact.solve(&mut part, tolerance, effort, scratch);
        update(&mut part, &heights, |p, _| *p = p.max(0.0));
        self.grid.paste(part, self.window, pressure);
        outcome
    }
}
