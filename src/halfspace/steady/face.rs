//! Pressure under a body that slides: minimal residuals on the present contact, which is then corrected pixel by pixel.
//!
//! What slides answers to itself before and behind differently, so that there is no energy whose least the contact would
//! be, and no conjugate directions. On the contact as it is now the gap is closed by the directions that leave the least
//! of it ([`Subspace`]); then pixels that pull leave it and pixels that overlap join it, all at once (Hintermüller, Ito &
//! Kunisch 2002) as long as ever fewer are wrong.

use super::subspace::Subspace;
use crate::halfspace::precision::Scratch;
use crate::halfspace::transform::Multiplier;
use crate::halfspace::vector::{fold, sum, total, update};
use crate::halfspace::{HalfSpaceError, Settings};
use rayon::prelude::*;
use realfft::num_complex::Complex;

/// Directions of one cycle on a contact.
pub(super) const DIRECTIONS: usize = 40;
/// Cycles on one contact before it is corrected in any case.
const CYCLES: usize = 5;
/// Part of the misfit of a contact that its own gap may be before the contact is corrected.
const SETTLED: f64 = 0.1;
/// Corrections of all pixels at once that need not lead to fewer wrong ones than ever before.
const CHANCES: usize = 10;

/// What is prescribed, in the solver's units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Load {
    /// The approach.
    Approach(f64),
    /// The sum of the pressures.
    Sum(f64),
}

/// A body that slides, in the solver's units.
pub(super) struct SlidingContact<'a> {
    /// Pressure → displacement.
    pub(super) influence: &'a Multiplier<Complex<f64>>,
    /// Roughly displacement → pressure.
    pub(super) stiffness: &'a Multiplier<Complex<f64>>,
    /// Pixels along the motion.
    pub(super) columns: usize,
    /// Heights of the body, +∞ where it has no material.
    pub(super) heights: &'a [f64],
    pub(super) load: Load,
    /// Displacement of a pixel under unit pressure on itself.
    pub(super) compliance: f64,
}

/// What was found, in the solver's units.
pub(super) struct Found {
    pub(super) pressure: Vec<f64>,
    pub(super) displacement: Vec<f64>,
    pub(super) approach: f64,
    pub(super) residual: f64,
    pub(super) iterations: usize,
    pub(super) products: usize,
}

/// Where the search is.
struct Search {
    pressure: Vec<f64>,
    displacement: Vec<f64>,
    contact: Vec<bool>,
    scratch: Scratch,
    corrections: usize,
    pivots: Pivots,
    iterations: usize,
    products: usize,
}

/// How far a pressure is from a solution, relative to the largest displacement.
struct Misfit {
    approach: f64,
    /// Largest gap in contact, or overlap out of it.
    gap: f64,
    overlap: f64,
    scale: f64,
}

impl SlidingContact<'_> {
    /// The pressure from `pressure` on.
    pub(super) fn solve(&self, pressure: Vec<f64>, settings: &Settings) -> Result<Found, HalfSpaceError> {
        let mut search = self.begin(pressure);
        loop {
            let before = self.misfit(&search);
            let target = settings.tolerance.max(SETTLED * before.overlap.max(SETTLED * before.gap) / before.scale);
            self.settle(&mut search, [settings.tolerance, target]);
            let changed = self.correct(&mut search);
            let misfit = self.misfit(&search);
            let residual = misfit.gap.max(misfit.overlap) / misfit.scale;
            if residual <= settings.tolerance && !changed {
                return Ok(Found {
                    approach: misfit.approach,
                    residual,
                    iterations: search.iterations,
                    products: search.products,
                    pressure: search.pressure,
                    displacement: search.displacement,
                });
            }
            if search.iterations + search.corrections >= settings.max_iterations || !residual.is_finite() {
                return Err(HalfSpaceError::NotConverged {
                    iterations: search.iterations,
                    residual,
                    tolerance: settings.tolerance,
                });
            }
        }
    }

    fn begin(&self, mut pressure: Vec<f64>) -> Search {
        update(&mut pressure, self.heights, |p, height| *p = if height.is_finite() { p.max(0.0) } else { 0.0 });
        if pressure.iter().all(|&p| p <= 0.0) {
            update(&mut pressure, self.heights, |p, height| *p = f64::from(u8::from(height.is_finite())));
            if let Load::Approach(_) = self.load {
                pressure.fill(0.0);
            }
        }
        let contact = match self.load {
            Load::Approach(approach) => {
                pressure.iter().zip(self.heights).map(|(&p, &height)| p > 0.0 || height < approach).collect()
            }
            Load::Sum(_) => pressure.iter().map(|&p| p > 0.0).collect(),
        };
        let displacement = vec![0.0; pressure.len()];
        let mut search = Search {
            pressure,
            displacement,
            contact,
            scratch: Scratch::default(),
            corrections: 0,
            pivots: Pivots { fewest: usize::MAX, chances: 0 },
            iterations: 0,
            products: 0,
        };
        self.refresh(&mut search);
        search
    }

    /// The displacement under the pressure, which carries the whole load.
    fn refresh(&self, search: &mut Search) {
        if let Load::Sum(wanted) = self.load {
            let factor = wanted / total(&search.pressure);
            search.pressure.par_iter_mut().for_each(|p| *p *= factor);
        }
        self.influence.apply(&search.pressure, &mut search.displacement, &mut search.scratch);
        search.products += 1;
    }

    /// The approach: that prescribed, or the mean over the contact.
    fn approach(&self, search: &Search) -> f64 {
        match self.load {
            Load::Approach(approach) => approach,
            Load::Sum(_) => self.mean(search, |index| search.displacement[index] + self.heights[index]),
        }
    }

    /// Mean over the contact.
    fn mean(&self, search: &Search, of: impl Fn(usize) -> f64 + Sync) -> f64 {
        let count = search.contact.iter().filter(|&&contact| contact).count().max(1);
        let part = |range: std::ops::Range<usize>| range.filter(|&index| search.contact[index]).map(&of).sum();
        sum(self.heights.len(), part) / count as f64
    }

    fn misfit(&self, search: &Search) -> Misfit {
        let approach = self.approach(search);
        let piece = |range: std::ops::Range<usize>| {
            let mut worst = [0.0f64, 0.0, f64::MIN_POSITIVE];
            for index in range {
                let (p, u) = (search.pressure[index], search.displacement[index]);
                let gap = u + self.heights[index] - approach;
                if search.contact[index] {
                    worst[0] = worst[0].max(gap.abs());
                    worst[2] = worst[2].max(u.abs()).max(self.compliance * p);
                } else {
                    worst[1] = worst[1].max(-gap);
                }
            }
            worst
        };
        let join = |one: [f64; 3], two: [f64; 3]| std::array::from_fn(|k| one[k].max(two[k]));
        let [gap, overlap, scale] = fold(self.heights.len(), piece, [0.0; 3], join);
        Misfit { approach, gap, overlap, scale }
    }

    /// Closes the gap of the present contact, down to a part `target` of the largest displacement; some of it in any case,
    /// unless it is closed to the tolerance.
    fn settle(&self, search: &mut Search, [tolerance, target]: [f64; 2]) {
        for cycle in 0..CYCLES {
            let misfit = self.misfit(search);
            let allowed = if cycle == 0 { tolerance } else { target };
            if misfit.gap <= allowed * misfit.scale {
                return;
            }
            let residual = self.open(search, misfit.approach);
            if !self.descend(search, residual, target * misfit.scale) {
                return;
            }
        }
    }

    /// Leaves of a residual what directions of one cycle cannot close, or what is allowed; whether there were any.
    fn descend(&self, search: &mut Search, residual: Vec<f64>, allowed: f64) -> bool {
        let Some(mut subspace) = Subspace::around(self.on_contact(search, residual)) else { return false };
        for _ in 0..DIRECTIONS {
            let mut effect = vec![0.0; self.heights.len()];
            let pressure = self.pressed(search, subspace.next());
            self.influence.apply(&pressure, &mut effect, &mut search.scratch);
            self.restrict(search, &mut effect);
            search.products += 1;
            search.iterations += 1;
            if !subspace.take(self.on_contact(search, effect)) || subspace.rest() <= allowed {
                break;
            }
        }
        let more = self.pressed(search, &subspace.best());
        update(&mut search.pressure, &more, |p, more| *p += more);
        self.influence.apply(&search.pressure, &mut search.displacement, &mut search.scratch);
        search.products += 1;
        true
    }

    /// Values on the contact alone, one after the other.
    fn on_contact(&self, search: &Search, values: Vec<f64>) -> Vec<f64> {
        values.into_iter().zip(&search.contact).filter_map(|(value, &contact)| contact.then_some(value)).collect()
    }

    /// Roughly the pressure on the contact of a displacement there.
    fn pressed(&self, search: &mut Search, displacement: &[f64]) -> Vec<f64> {
        let mut given = displacement.iter();
        let spread: Vec<f64> = search
            .contact
            .iter()
            .map(|&contact| if contact { given.next().copied().unwrap_or_default() } else { 0.0 })
            .collect();
        let mut pressure = vec![0.0; spread.len()];
        self.stiffness.apply(&spread, &mut pressure, &mut search.scratch);
        self.restrict(search, &mut pressure);
        pressure
    }

    /// What the displacement lacks on the contact.
    fn open(&self, search: &Search, approach: f64) -> Vec<f64> {
        let lacks = |index: usize| approach - search.displacement[index] - self.heights[index];
        let on_contact = |index: usize| if search.contact[index] { lacks(index) } else { 0.0 };
        (0..self.heights.len()).into_par_iter().map(on_contact).collect()
    }

    /// Zero out of contact; under a prescribed sum zero in the mean, too.
    fn restrict(&self, search: &Search, values: &mut [f64]) {
        let mean = match self.load {
            Load::Approach(_) => 0.0,
            Load::Sum(_) => self.mean(search, |index| values[index]),
        };
        let within = |(value, &contact): (&mut f64, &bool)| *value = if contact { *value - mean } else { 0.0 };
        values.par_iter_mut().zip(&search.contact).for_each(within);
    }

    /// Lets go of what pulls and joins what overlaps; whether the contact has changed.
    fn correct(&self, search: &mut Search) -> bool {
        let Misfit { approach, scale, .. } = self.misfit(search);
        let least = f64::EPSILON * scale;
        let is_wrong = |index: usize| match search.contact[index] {
            true => search.pressure[index] < 0.0,
            false => search.displacement[index] + self.heights[index] - approach < -least,
        };
        let wrong: Vec<usize> = (0..self.heights.len()).into_par_iter().filter(|&index| is_wrong(index)).collect();
        search.corrections += 1;
        let chosen = search.pivots.chosen(&wrong, self.columns);
        for index in chosen {
            search.contact[index] = !search.contact[index];
            if !search.contact[index] {
                search.pressure[index] = 0.0;
            }
        }
        if !wrong.is_empty() {
            self.refresh(search);
        }
        !wrong.is_empty()
    }
}

/// Which of the pixels that are wrong change sides.
///
/// All at once as long as there are fewer of them after a few corrections than ever before; else those of the foremost
/// line alone, since what lies behind is late of what lies before it (Júdice & Pires 1994, Comput. Oper. Res. 21, 587).
struct Pivots {
    fewest: usize,
    chances: usize,
}

impl Pivots {
    fn chosen(&mut self, wrong: &[usize], columns: usize) -> Vec<usize> {
        if wrong.len() < self.fewest {
            (self.fewest, self.chances) = (wrong.len(), CHANCES);
            return wrong.to_vec();
        }
        if self.chances > 0 {
            self.chances -= 1;
            return wrong.to_vec();
        }
        let column = |index: &usize| index % columns;
        let foremost = wrong.iter().map(column).max();
        wrong.iter().copied().filter(|index| Some(column(index)) == foremost).collect()
    }
}
