//! A rough line on bodies that bear no more than their hardness.
//!
//! # Examples
//! ```
//! use springbed::contact::model::{ContactModel, Straight};
//! use springbed::contact::rough::YieldingRough;
//! use std::f64::consts::PI;
//!
//! // A flat of 2 m under springs of 3 N/m bears H = 0.1 Pa on the patch of half its length: πHl².
//! let mut flat = YieldingRough::of_gaps(&[0.0; 8], 0.25, (12.0, 0.1))?;
//! flat.follow(&Straight::between(0.0, 10.0, 1.0))?;
//! assert!((flat.state().force / (0.1 * PI) - 1.0).abs() < 1e-12);
//! // Let go, it parts where the dents end.
//! flat.follow(&Straight::between(10.0, 9.9, 1.0))?;
//! assert_eq!(flat.state().force, 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::bed::{BedState, RoughBed, number};
use super::dents::{Deepest, Line};
use super::ends::LineEnds;
use crate::contact::adhesion::line::Energy;
use crate::contact::error::ContactError;
use crate::contact::model::{ContactModel, Effort, Event, Glance, Loading, Pull, Straight};
use crate::contact::state::Normal;
use crate::shape::Profile;
use crate::shape::rough::{RoughError, RoughLine, positive};
use std::sync::Arc;

/// A rough line on bodies whose pressure is capped by the hardness H; indentation counts from first touch.
///
/// Where the pressure on a round patch of radius l is H all over, its bed carries q(x) = 2∫ₓˡ H r dr/√(r² − x²) = 2H√(l² − x²)
/// and πHl² altogether. A spring in a patch of the half length l, x from its middle, carries no more than that: what is pressed
/// deeper stays as a dent. A cap grows with its patch and does not fall; so all dents are those of the largest depth, and below
/// it the bed is one of elastic springs. A smooth ball of radius R tends to dF/dd = πHR, Thornton's (1997) slope. Approximate
/// as rough beds are, see [`VALIDITY`](super::VALIDITY), and so is the cap: neighbours that yield do not pile up.
#[derive(Debug, Clone)]
pub struct YieldingRough {
    line: Arc<Line>,
    deepest: Deepest,
    /// Springs over their dents, where the bodies have come back from the largest depth.
    let_go: Option<Arc<RoughBed>>,
    /// Indentation in the coordinate of the gaps [m].
    indentation: f64,
    ends: Option<LineEnds>,
}

impl YieldingRough {
    /// A line of `points` springs on the profile `base`, none under a nominally flat surface, over a half-space of the
    /// modulus E* and the hardness H [Pa], just touching.
    ///
    /// # Errors
    /// As of [`RoughBed::under`], or no springs.
    pub fn new(
        line: &RoughLine,
        points: usize,
        bodies: (f64, f64),
        base: Option<&dyn Profile>,
    ) -> Result<Self, RoughError> {
        let gaps = RoughBed::gaps_under(line, points, |x| base.map_or(0.0, |base| base.reduced(x)))?;
        let mut contact = Self::of_gaps(&gaps, line.length() / number(points), bodies)?;
        contact.ends = Some(LineEnds::of(line, points, base, contact.first_touch())?);
        Ok(contact)
    }

    /// Springs Δx = `width` [m] apart under the gaps along a line [m], infinite where none stands, over a half-space of the
    /// modulus E* and the hardness H [Pa], just touching.
    ///
    /// # Errors
    /// No gap; a gap that is none; a width, modulus or hardness that is not positive.
    pub fn of_gaps(gaps: &[f64], width: f64, (modulus, hardness): (f64, f64)) -> Result<Self, RoughError> {
        let borne = positive("hardness", hardness)? * width / positive("modulus", modulus)?;
        let line = Line::new(gaps, modulus * positive("spring width", width)?, borne)?;
        let deepest = Deepest::new(&line);
        Ok(Self { indentation: deepest.depth, line: Arc::new(line), deepest, let_go: None, ends: None })
    }

    fn first_touch(&self) -> f64 {
        self.line.gaps[0]
    }

    /// Depth from first touch that takes the energy `energy` [J] if nothing yields [m].
    ///
    /// # Errors
    /// There are no springs.
    pub fn stopped_at(&self, energy: f64) -> Result<f64, RoughError> {
        let elastic = RoughBed::new(&self.line.gaps, self.line.stiffness)?;
        Ok(elastic.at_energy(energy).indentation - self.first_touch())
    }

    /// Depth from first touch at which the dents part [m].
    #[must_use]
    pub fn residual_depth(&self) -> f64 {
        self.deepest.dented().into_iter().fold(f64::INFINITY, f64::min) - self.first_touch()
    }

    /// Moves to a depth in the coordinate of the gaps.
    fn go(&mut self, indentation: f64) {
        if indentation < self.deepest.depth {
            self.let_go();
        } else {
            self.deepest.go(&self.line, indentation);
            self.let_go = None;
        }
        self.indentation = indentation;
    }

    /// The springs over their dents.
    fn let_go(&mut self) -> Option<&RoughBed> {
        if self.let_go.is_none() {
            self.let_go = RoughBed::new(&self.deepest.dented(), self.line.stiffness).ok().map(Arc::new);
        }
        self.let_go.as_deref()
    }

    /// The springs as they are, their energy what they store.
    fn springs(&self) -> BedState {
        match &self.let_go {
            Some(bed) => bed.at_indentation(self.indentation),
            None => self.deepest.state(&self.line),
        }
    }

    fn hold(&self) -> Result<(), ContactError> {
        let depth = self.indentation - self.first_touch();
        self.ends.map_or(Ok(()), |ends| ends.hold(depth))
    }
}

impl ContactModel for YieldingRough {
    fn follow(&mut self, piece: &Straight) -> Result<Vec<Event>, ContactError> {
        self.go(self.first_touch() + piece.to);
        self.hold().map(|()| Vec::new())
    }

    fn look(&mut self, piece: &Straight) -> Result<Glance, ContactError> {
        let mut ahead = self.clone();
        ahead.go(self.first_touch() + piece.to);
        Ok(Glance { force: ahead.springs().force, contact_radius: 0.0 })
    }

    fn state(&self) -> Normal {
        let springs = self.springs();
        Normal {
            indentation: Some(self.indentation - self.first_touch()),
            force: springs.force,
            contact_radius: None,
            stiffness: springs.stiffness,
            stored: Energy { elastic: springs.energy, surface: 0.0 },
            dissipated: self.line.stiffness * self.deepest.yielded(),
        }
    }

    fn joined(&self) -> bool {
        self.springs().force > 0.0
    }

    fn loading(&self) -> Option<Box<dyn Loading + '_>> {
        None
    }

    fn copy(&self) -> Box<dyn ContactModel> {
        Box::new(self.clone())
    }

    fn effort(&self) -> Effort {
        let springs = self.line.gaps.len();
        Effort { springs, bytes: BYTES * springs, ..Effort::default() }
    }

    fn press(&mut self, pull: &Pull) -> Option<Result<Vec<Event>, ContactError>> {
        let depth = if pull.force < self.deepest.state(&self.line).force {
            self.let_go()?.at_force(pull.force).indentation.min(self.deepest.depth)
        } else {
            match self.deepest.carried(&self.line, pull.force) {
                Ok(depth) => depth,
                Err(overloaded) => return Some(Err(overloaded)),
            }
        };
        self.go(depth);
        Some(self.hold().map(|()| Vec::new()))
    }

    fn last_depth(&self) -> Option<Result<f64, ContactError>> {
        Some(Ok(self.residual_depth()))
    }
}

/// Bytes of a spring: foot, cap, patch and its length; gap, place and rank; foot, force and energy as it is let go.
const BYTES: usize = 80;

#[cfg(test)]
mod tests {
    use super::super::dents::LAG;
    use super::*;
    use crate::contact::rough::RoughContact;
    use crate::shape::rough::{Rings, RoughnessSpectrum};
    use proptest::prelude::*;
    use std::f64::consts::PI;

    const BODIES: (f64, f64) = (3.0, 0.02);
    const WIDTH: f64 = 1e-3;

    fn depth(contact: &YieldingRough) -> f64 {
        contact.state().indentation.unwrap()
    }

    fn pressed(contact: &YieldingRough, to: f64) -> YieldingRough {
        let mut contact = contact.clone();
        contact.follow(&Straight::between(depth(&contact), to, 1.0)).unwrap();
        contact
    }

    fn under(contact: &YieldingRough, force: f64) -> Result<YieldingRough, ContactError> {
        let mut contact = contact.clone();
        let pull = Pull { force, slide: 0.0, sliding_speed: 0.0, duration: 1.0 };
        contact.press(&pull).unwrap().map(|_| contact)
    }

    fn gaps() -> impl Strategy<Value = Vec<f64>> {
        proptest::collection::vec((0i32..400).prop_map(|k| 1e-6 * f64::from(k)), 1..50)
    }

    fn depths() -> impl Strategy<Value = Vec<f64>> {
        proptest::collection::vec((0i32..800).prop_map(|k| 1e-6 * f64::from(k)), 1..8)
    }

    fn close(one: f64, other: f64, scale: f64) -> bool {
        (one - other).abs() <= 1e-11 * scale
    }

    /// ∫q over a ball: elastic springs E*(d − x²/R) where they are below 2H√(a² − x²), a² = Rd, and that elsewhere.
    #[test]
    fn a_smooth_ball_yields_from_its_middle() {
        let (modulus, hardness, radius) = (1.0, 0.05, 1.0);
        let count = 20_001;
        let width = 0.6 / f64::from(count);
        let place = |k: i32| width * (f64::from(k) - 0.5 * f64::from(count - 1));
        let gaps: Vec<f64> = (0..count).map(|k| place(k).powi(2) / radius).collect();
        let contact = YieldingRough::of_gaps(&gaps, width, (modulus, hardness)).unwrap();
        for depth in [5e-3, 0.02, 0.06] {
            let (a, b) = (f64::sqrt(radius * depth), 2.0 * hardness * radius / modulus);
            let inner = (a * a - b * b).max(0.0).sqrt();
            let capped = 2.0 * hardness * (inner * (a * a - inner * inner).sqrt() + a * a * (inner / a).asin());
            let elastic = |x: f64| 2.0 * modulus / radius * (a * a * x - x.powi(3) / 3.0);
            let force = capped + elastic(a) - elastic(inner);
            let found = pressed(&contact, depth).state();
            // Springs at the edge count in whole ones, a part Δx/a of the last of them, and caps are behind by LAG at most.
            assert!((found.force / force - 1.0).abs() < 2.0 * width / a + LAG, "{depth} {} {force}", found.force);
        }
        let slope = (pressed(&contact, 0.08).state().force - pressed(&contact, 0.06).state().force) / 0.02;
        assert!((slope / (PI * hardness * radius) - 1.0).abs() < 0.05, "Thornton: {slope}");
    }

    /// Springs of any height, of the width two: all patches of the line are full of pressure H where it is deep enough.
    #[test]
    fn a_flat_bears_its_hardness_on_all_of_it() {
        let contact = YieldingRough::of_gaps(&[0.0, 2.0, 1.0, 0.5], 2.0, (1.0, 1e-3)).unwrap();
        let full = pressed(&contact, 10.0).state();
        assert!((full.force / (1e-3 * PI * 16.0) - 1.0).abs() < 1e-12 && full.stiffness == 0.0);
        assert!(under(&contact, 1.01 * full.force).unwrap_err().to_string().contains("that the hardness bears"));
    }

    #[test]
    fn impossible_lines_are_refused() {
        assert!(YieldingRough::of_gaps(&[], 1.0, BODIES).is_err());
        assert!(YieldingRough::of_gaps(&[f64::INFINITY], 1.0, BODIES).is_err());
        assert!(YieldingRough::of_gaps(&[f64::NAN], 1.0, BODIES).is_err());
        assert!(YieldingRough::of_gaps(&[0.0], 1.0, (1.0, 0.0)).unwrap_err().to_string().contains("hardness"));
    }

    /// Hard bodies are elastic ones, to rounding.
    #[test]
    fn hard_bodies_do_not_yield() {
        let spectrum = RoughnessSpectrum::table(&[(6.4, 1e-12), (64.0, 1e-15)]).unwrap();
        let line = RoughLine::new(&Rings::of(&spectrum, 1.0, 1000).unwrap(), 7);
        let mut elastic = RoughContact::new(&line, 1000, 2.5, None).unwrap();
        let mut hard = YieldingRough::new(&line, 1000, (2.5, 1e9), None).unwrap();
        for to in [1e-6, 3e-6, 2e-6, 5e-6, 1e-5] {
            let piece = Straight::between(0.0, to, 1.0);
            elastic.follow(&piece).unwrap();
            hard.follow(&piece).unwrap();
            let (one, other) = (elastic.state(), hard.state());
            assert!(close(one.force, other.force, one.force) && close(one.stiffness, other.stiffness, 2.5));
            assert!(close(one.stored.elastic, other.stored.elastic, one.stored.elastic) && other.dissipated == 0.0);
        }
    }

    proptest! {
        /// Cut anywhere, turned anywhere, mirrored: the state is that of the largest depth and the present one.
        #[test]
        fn only_the_largest_depth_is_remembered(gaps in gaps(), depths in depths(), cut in 0i32..100) {
            let start = YieldingRough::of_gaps(&gaps, WIDTH, BODIES).unwrap();
            let mirrored: Vec<f64> = gaps.iter().rev().copied().collect();
            let other_way = YieldingRough::of_gaps(&mirrored, WIDTH, BODIES).unwrap();
            let (mut one, mut most) = (start.clone(), 0.0f64);
            for to in depths {
                let from = depth(&one);
                one = pressed(&pressed(&one, from + 0.01 * f64::from(cut) * (to - from)), to);
                most = most.max(to);
                for twin in [&start, &other_way] {
                    let twin = pressed(&pressed(twin, most), to);
                    let (one, twin) = (one.state(), twin.state());
                    prop_assert!(close(one.force, twin.force, BODIES.0 * WIDTH * most * gaps.len() as f64));
                    prop_assert!(close(one.dissipated, twin.dissipated, BODIES.0 * WIDTH * most * most * gaps.len() as f64));
                }
            }
        }

        /// A force is found again, on the way in as on the way out.
        #[test]
        fn a_force_is_found_again(gaps in gaps(), depths in depths()) {
            let start = YieldingRough::of_gaps(&gaps, WIDTH, BODIES).unwrap();
            let mut one = start;
            for to in depths {
                let there = pressed(&one, to);
                let force = there.state().force;
                let found = under(&one, force).unwrap();
                prop_assert!(close(found.state().force, force, BODIES.0 * WIDTH * to * gaps.len() as f64), "{force:e} {:e}", found.state().force);
                one = there;
            }
        }

        /// ∫F dd = stored + dissipated, the trapezoidal rule being right to the square of its step where springs are touched
        /// and give way; the dissipation never falls, nor the force on the way in; no patch bears more than its hardness.
        #[test]
        fn the_ledger_closes(gaps in gaps(), most in 1i32..800) {
            let start = YieldingRough::of_gaps(&gaps, WIDTH, BODIES).unwrap();
            let (most, steps) = (1e-6 * f64::from(most), 4000);
            let (mut one, mut work) = (start, 0.0);
            let stiffness = BODIES.0 * WIDTH * gaps.len() as f64;
            let step = most / f64::from(steps);
            for k in (1..=steps).chain((0..steps).rev()) {
                let before = one.state();
                one = pressed(&one, step * f64::from(k));
                let after = one.state();
                work += 0.5 * (before.force + after.force) * (depth(&one) - before.indentation.unwrap());
                // Rounding of the sum over the springs, and of the depths in which their dents are measured.
                let rounding = f64::EPSILON * (gaps.len() as f64 * before.dissipated + stiffness * most * most);
                prop_assert!(after.dissipated >= before.dissipated - rounding, "{:e}", before.dissipated - after.dissipated);
                prop_assert!(depth(&one) < before.indentation.unwrap() || after.force >= before.force * (1.0 - 1e-12));
                let areas: f64 = one.deepest.patches.all().map(|(a, b)| 0.25 * (WIDTH * number(b - a + 1)).powi(2)).sum();
                prop_assert!(after.force <= PI * BODIES.1 * areas * (1.0 + 1e-12));
            }
            let off = work - one.state().stored.elastic - one.state().dissipated;
            // Each of the springs turns the slope at most twice a touch, and the way out once.
            prop_assert!(off.abs() <= stiffness * step * step * gaps.len() as f64 + 1e-12 * stiffness * most * most, "{off:e}");
        }
    }
}
