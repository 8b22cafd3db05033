//! Contact and attraction find each other, on the part of the pixels where either acts.

use super::attraction::Attraction;
use super::lone::LoneSprings;
use super::mixed::Mixed;
use super::pressed::area;
use crate::halfspace::{
    Boundary, HalfSpaceError, Prescribed, PressedMap, Settings, Solution, Start, SurfaceResponse, bytes_needed,
    solve_on,
};
use ndarray::{Array2, ArrayView2, Zip, s};
use std::ops::Range;

/// Rounds in which gap and attraction may find each other.
const ROUNDS: usize = 2000;
/// Residual to which a contact is solved that an attraction changes again, whatever accuracy is asked for: less would be
/// worked off in the next round, and more keeps gap and attraction from finding each other.
const LOOSE: f64 = 1e-7;
/// The same while they are far from each other, as part of what the last round has changed, and at most.
const OF_CHANGE: f64 = 1e-3;
const LOOSEST: f64 = 1e-4;
/// The same of rounds that have gone on for long: of a range that is short beside the displacements what is left over changes
/// the attraction.
const TIGHT: f64 = 1e-10;
/// Part of the range of an attraction to which what touches does so in the end: a gap left over is energy that is not there.
const TOUCHING: f64 = 1e-4;
/// Change of the attraction, as part of what it pulls most with, at which they have: of pixels that are wide beside the ring
/// in which it acts that may be a small part of its stress.
const SETTLED: f64 = 1e-5;
/// Pixels kept around those that press or pull.
const MARGIN: usize = 4;
/// Sides of a part are so many pixels, or twice as many …: its maps are known as long as it grows by less.
const STEP: usize = 8;

/// A surface that is pressed and pulled.
pub(super) struct Rounds<'r> {
    pub(super) attraction: Attraction,
    /// Pixels that neighbours do nothing to.
    pub(super) lone: Option<LoneSprings>,
    /// What pressures do to its pixels.
    pub(super) response: &'r SurfaceResponse,
    /// Its heights without either, with what is prescribed of both together.
    pub(super) map: PressedMap<'r>,
    pub(super) settings: Settings,
}

/// What presses, and what pulls \[Pa\].
pub(super) struct Settled {
    pub(super) contact: Solution,
    pub(super) pull: Array2<f64>,
}

/// A part of the pixels: rows and columns.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Part([Range<usize>; 2]);

/// What rounds on a part have come to.
enum Reached {
    /// Gap and attraction have found each other there.
    Settled(Settled),
    /// What pulls has come to the rim.
    Outgrown(Settled),
    /// The force pulls more than the bodies do.
    TornOff,
}

impl Part {
    /// All of so many rows and columns.
    fn whole((rows, columns): (usize, usize)) -> Self {
        Self([0..rows, 0..columns])
    }

    fn size(&self) -> [usize; 2] {
        self.0.each_ref().map(ExactSizeIterator::len)
    }

    fn contains(&self, (row, column): (usize, usize)) -> bool {
        self.0[0].contains(&row) && self.0[1].contains(&column)
    }

    /// The values on the part.
    fn of<'a>(&self, whole: &'a ArrayView2<'_, f64>) -> ArrayView2<'a, f64> {
        let [rows, columns] = self.0.clone();
        whole.slice(s![rows, columns])
    }

    /// The values of the part among zeros.
    fn pasted(&self, values: &Array2<f64>, whole: (usize, usize)) -> Array2<f64> {
        let [rows, columns] = self.0.clone();
        let mut all = Array2::zeros(whole);
        all.slice_mut(s![rows, columns]).assign(values);
        all
    }

    /// Whether what pulls on the part has come to its rim within so many rows and columns.
    fn is_outgrown(&self, pull: &Array2<f64>, (rows, columns): (usize, usize)) -> bool {
        let [above, left] = self.0.each_ref().map(|range| range.start > 0);
        let (below, right) = (self.0[0].end < rows, self.0[1].end < columns);
        let pulls = |line: ArrayView2<'_, f64>| line.iter().any(|&pull| pull > 0.0);
        above && pulls(pull.slice(s![..1, ..]))
            || below && pulls(pull.slice(s![-1.., ..]))
            || left && pulls(pull.slice(s![.., ..1]))
            || right && pulls(pull.slice(s![.., -1..]))
    }
}

/// The side from `first` to `last` of `count` pixels with its margin, in whole steps, where there are as many.
fn widened([first, last]: [usize; 2], count: usize) -> Range<usize> {
    let (start, end) = (first.saturating_sub(MARGIN), (last + 1 + MARGIN).min(count));
    let side = (end - start).next_multiple_of(STEP).min(count);
    let start = start.saturating_sub((side - (end - start)) / 2).min(count - side);
    start..start + side
}

impl Rounds<'_> {
    /// Rounds until neither contact nor attraction changes the other, from the pressures `last` and the attraction `pull`;
    /// `None` where the force pulls more than the bodies do. The displacement is what both make.
    ///
    /// A stronger attraction narrows every gap, but far away where the surface repeats, and a narrower gap is attracted no
    /// less: from an attraction that is too weak the rounds go up to the weakest equilibrium above it, from one too strong
    /// down to the strongest below. So a contact that approaches snaps in where its own branch ends, and one that is
    /// withdrawn snaps off where its does. Rounds that are guessed ahead ([`Mixed`]) may do so a little before, where next to
    /// nothing is left of the branch.
    pub(super) fn settled(
        &self,
        last: Option<&Array2<f64>>,
        pull: Array2<f64>,
    ) -> Result<Option<Settled>, HalfSpaceError> {
        let (mut last, mut pull, mut left) = (last.cloned(), pull, ROUNDS);
        let acts = |at| pull[at] > 0.0 || last.as_ref().is_some_and(|pressure| pressure[at] > 0.0);
        let mut part = self.around(acts);
        loop {
            let (found, is_settled) = match self.on(&part, (last.as_ref(), &pull), &mut left)? {
                Reached::Settled(found) => (found, true),
                Reached::Outgrown(found) => (found, false),
                Reached::TornOff => return Ok(None),
            };
            if is_settled && part == Part::whole(self.map.heights.dim()) {
                return Ok(Some(found));
            }
            let found = self.everywhere(&part, found);
            let near = |at| self.gap(&found.contact, at) < self.attraction.reach();
            if is_settled && found.pull.indexed_iter().all(|(at, _)| part.contains(at) || !near(at)) {
                return Ok(Some(found));
            }
            part = self.around(|at| found.pull[at] > 0.0 || found.contact.pressure[at] > 0.0 || near(at));
            (last, pull) = (Some(found.contact.pressure), found.pull);
        }
    }

    /// The part around the pixels chosen; all of them where none is, or where everything repeats.
    fn around(&self, chosen: impl Fn((usize, usize)) -> bool) -> Part {
        let dim = self.map.heights.dim();
        let mut ends: Option<[[usize; 2]; 2]> = None;
        if self.map.boundary == Boundary::Free {
            for (row, column) in self.map.heights.indexed_iter().map(|(at, _)| at).filter(|&at| chosen(at)) {
                let [rows, columns] = ends.unwrap_or([[row; 2], [column; 2]]);
                ends = Some([[rows[0].min(row), rows[1].max(row)], [columns[0].min(column), columns[1].max(column)]]);
            }
        }
        ends.map_or_else(|| Part::whole(dim), |[rows, columns]| Part([widened(rows, dim.0), widened(columns, dim.1)]))
    }

    /// Rounds on a part, beyond which nothing acts.
    fn on(
        &self,
        part: &Part,
        (last, pull): (Option<&Array2<f64>>, &Array2<f64>),
        left: &mut usize,
    ) -> Result<Reached, HalfSpaceError> {
        let Self { attraction, lone, map, .. } = self;
        let own = (part.size() != <[usize; 2]>::from(map.heights.dim())).then(|| self.response.part(part.size()));
        let response = own.as_ref().unwrap_or(self.response);
        let heights = part.of(&map.heights);
        let mut last = last.map(|last| part.of(&last.view()).to_owned());
        let mut pull = part.of(&pull.view()).to_owned();
        let mut mixed = Mixed::default();
        let (mut change, mut finest) = (f64::INFINITY, f64::INFINITY);
        while *left > 0 {
            *left -= 1;
            let tolerance = residual_after(change, *left).min(finest);
            let settings = Settings { tolerance, ..self.settings };
            let Some(control) = self.control(&pull) else {
                // A guess may pull less than what holds the bodies.
                let Some(safe) = mixed.back() else { return Ok(Reached::TornOff) };
                pull = safe;
                continue;
            };
            let pulled = -response.displacement(pull.view(), map.modulus);
            let lifted = &heights + &pulled;
            let start = last.as_ref().map_or(Start::Coarser, |last| Start::Pressure(last.view()));
            let mut contact =
                solve_on(response, &PressedMap { heights: lifted.view(), control, ..*map }, start, &settings)?;
            let mut gap = lifted;
            Zip::from(&mut gap).and(&contact.displacement).and(&contact.pressure).for_each(|gap, moved, &pressure| {
                *gap = if pressure > 0.0 { 0.0 } else { (moved + (*gap - contact.indentation)).max(0.0) };
            });
            let touches = (TOUCHING * attraction.range() / largest(&contact.displacement)).max(TIGHT);
            contact.displacement += &pulled;
            let after = match lone {
                Some(lone) => Zip::from(&heights)
                    .and(&pull)
                    .map_collect(|height, &pull| lone.pull(height - contact.indentation, pull)),
                None => attraction.pull(&gap, map.boundary),
            };
            change = most_apart(&pull, &after) / largest(&pull).max(largest(&after)).max(f64::MIN_POSITIVE);
            if change <= SETTLED {
                if contact.residual <= touches {
                    return Ok(Reached::Settled(Settled { contact, pull }));
                }
                (finest, last) = (touches, Some(contact.pressure));
                continue;
            }
            pull = mixed.next(&pull, after, change, attraction.stress);
            if part.is_outgrown(&pull, map.heights.dim()) {
                return Ok(Reached::Outgrown(Settled { contact, pull }));
            }
            last = Some(contact.pressure);
        }
        Err(HalfSpaceError::NotConverged { iterations: ROUNDS, residual: change, tolerance: SETTLED })
    }

    /// What a part has come to, on all pixels.
    fn everywhere(&self, part: &Part, found: Settled) -> Settled {
        let dim = self.map.heights.dim();
        let pressure = part.pasted(&found.contact.pressure, dim);
        let pull = part.pasted(&found.pull, dim);
        let displacement = self.response.displacement((&pressure - &pull).view(), self.map.modulus);
        let bytes = bytes_needed(dim.into(), self.map.boundary);
        Settled { contact: Solution { pressure, displacement, bytes, ..found.contact }, pull }
    }

    /// How far the surfaces are apart \[m\] at a pixel.
    fn gap(&self, contact: &Solution, at: (usize, usize)) -> f64 {
        contact.displacement[at] + (self.map.heights[at] - contact.indentation)
    }

    /// What is prescribed of the pressures that push.
    fn control(&self, pull: &Array2<f64>) -> Option<Prescribed> {
        let pulls = pull.sum() * area(self.map.pixel);
        match self.map.control {
            Prescribed::Force(force) if force + pulls < 0.0 => None,
            Prescribed::Force(force) => Some(Prescribed::Force(force + pulls)),
            depth @ Prescribed::Indentation(_) => Some(depth),
        }
    }
}

/// Residual to which a contact is solved after a round that has changed the attraction by `change`, with `left` rounds to go.
fn residual_after(change: f64, left: usize) -> f64 {
    match change {
        _ if 4 * left <= 3 * ROUNDS => TIGHT,
        change if change.is_finite() => (OF_CHANGE * change).clamp(LOOSE, LOOSEST),
        _ => LOOSE,
    }
}

fn largest(values: &Array2<f64>) -> f64 {
    values.fold(0.0, |largest, &value| f64::max(largest, value))
}

fn most_apart(one: &Array2<f64>, other: &Array2<f64>) -> f64 {
    Zip::from(one).and(other).fold(0.0, |most: f64, one, other| most.max((one - other).abs()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::law::ElasticAdhesion;
    use proptest::prelude::*;

    const SIDE: usize = 40;

    /// Two balls of the radius 1 on pixels of the side 0.01, the second higher up by `higher`.
    fn two_balls([row, column]: [i32; 2], higher: f64) -> Array2<f64> {
        let ball = |(i, j): (usize, usize), [row, column]: [i32; 2]| {
            let far = |at: usize, middle: i32| 0.01 * (at as f64 - f64::from(middle));
            0.5 * (far(i, row).powi(2) + far(j, column).powi(2))
        };
        Array2::from_shape_fn((SIDE, SIDE), |at| ball(at, [10, 11]).min(higher + ball(at, [row, column])))
    }

    proptest! {
        #![proptest_config(crate::laws::cases(12))]

        /// What a part comes to is at rest on all pixels, wherever a second ball comes within the range: rounds on all of
        /// them that begin there end there, where they change less than a hundred-thousandth of the stress. From the same
        /// beginning they may come to the next equilibrium, for rounds that are guessed ahead may pass the weakest.
        #[test]
        fn a_part_is_enough(
            (row, column) in (14i32..38, 14i32..38),
            higher in 0i32..20,
            depths in prop::collection::vec(-10i32..40, 1..4),
        ) {
            let heights = two_balls([row, column], 1e-4 * f64::from(higher));
            let response = SurfaceResponse::new([SIDE; 2], [0.01; 2], Boundary::Free);
            let law = ElasticAdhesion::Finite { work: 2e-5, stress: 0.04 };
            let attraction = Attraction::of(law, 0.01, 1.0).unwrap();
            let rounds = |depth: i32| Rounds {
                attraction,
                lone: None,
                response: &response,
                map: PressedMap {
                    heights: heights.view(),
                    pixel: [0.01; 2],
                    modulus: 1.0,
                    boundary: Boundary::Free,
                    control: Prescribed::Indentation(5e-5 * f64::from(depth)),
                },
                settings: Settings::default(),
            };
            let (mut last, mut pull) = (None, Array2::zeros((SIDE, SIDE)));
            for depth in depths {
                let rounds = rounds(depth);
                let Ok(Some(part)) = rounds.settled(last.as_ref(), pull) else {
                    return Err(TestCaseError::fail("not settled"));
                };
                let start = (Some(&part.contact.pressure), &part.pull);
                let Ok(Reached::Settled(whole)) = rounds.on(&Part::whole((SIDE, SIDE)), start, &mut { ROUNDS }) else {
                    return Err(TestCaseError::fail("not settled on all pixels"));
                };
                let force = |settled: &Settled| settled.contact.force() - 1e-4 * settled.pull.sum();
                let largest = 1e-4 * whole.pull.sum() + whole.contact.force();
                let (one, other) = (force(&whole), force(&part));
                prop_assert!((one - other).abs() <= 1e-3 * largest, "{one} {other} of {largest}");
                (last, pull) = (Some(part.contact.pressure), part.pull);
            }
        }
    }

    /// Beside a range that is short beside the depth nothing is left of a gap where bodies touch.
    #[test]
    fn what_touches_leaves_no_gap() {
        let heights = two_balls([20, 20], 0.0);
        let response = SurfaceResponse::new([SIDE; 2], [0.01; 2], Boundary::Free);
        let law = ElasticAdhesion::Fading { work: 1e-10, range: 1e-8 };
        let attraction = Attraction::of(law, 0.01, 1.0).unwrap();
        let (pixel, boundary, control) = ([0.01; 2], Boundary::Free, Prescribed::Indentation(2e-3));
        let map = PressedMap { heights: heights.view(), pixel, modulus: 1.0, boundary, control };
        let rounds = Rounds { attraction, lone: None, response: &response, map, settings: Settings::default() };
        let found = rounds.settled(None, Array2::zeros((SIDE, SIDE))).unwrap().unwrap();
        let touching = found.contact.pressure.indexed_iter().filter(|(_, pressure)| **pressure > 0.0);
        let gaps: Vec<f64> = touching.map(|(at, _)| rounds.gap(&found.contact, at).abs()).collect();
        let largest = gaps.iter().copied().fold(0.0, f64::max);
        assert!(gaps.len() > 20 && largest <= 2.0 * TOUCHING * attraction.range(), "{} {largest:e}", gaps.len());
    }

    /// Bodies drawn apart hold nothing, not even what a round may be off by.
    #[test]
    fn nothing_is_left_out_of_reach() {
        let heights = two_balls([20, 20], 0.0);
        let response = SurfaceResponse::new([SIDE; 2], [0.01; 2], Boundary::Free);
        let attraction = Attraction::of(ElasticAdhesion::Finite { work: 2e-5, stress: 0.04 }, 0.01, 1.0).unwrap();
        let (pixel, boundary, control) = ([0.01; 2], Boundary::Free, Prescribed::Indentation(-1e-2));
        let map = PressedMap { heights: heights.view(), pixel, modulus: 1.0, boundary, control };
        let rounds = Rounds { attraction, lone: None, response: &response, map, settings: Settings::default() };
        let little = Array2::from_elem((SIDE, SIDE), 1e-6 * attraction.stress);
        let found = rounds.settled(None, little).unwrap().unwrap();
        assert!(found.pull.iter().all(|&pull| pull <= 0.0) && found.contact.contact_pixels() == 0);
    }

    /// Parts keep their margin and are no larger than what there is.
    #[test]
    fn a_part_has_a_margin() {
        for (ends, range) in [([12, 20], 5..29), ([0, 3], 0..8), ([36, 39], 32..40), ([1, 38], 0..40)] {
            assert_eq!(widened(ends, SIDE), range, "{ends:?}");
        }
    }
}
