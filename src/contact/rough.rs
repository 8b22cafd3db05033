//! Spring bed of a rough line: independent springs, sorted by height.
//!
//! # Examples
//! ```
//! use springbed::contact::rough::RoughBed;
//!
//! // Three springs of 2 N/m under gaps of 0, 1 and 3 m: at a depth of 2 two of them carry 2·(2 + 1) N.
//! let bed = RoughBed::new(&[1.0, 0.0, 3.0], 2.0)?;
//! let state = bed.at_indentation(2.0);
//! assert_eq!((state.force, state.stiffness), (6.0, 4.0));
//! assert_eq!(bed.at_force(6.0).indentation, 2.0);
//! # Ok::<(), springbed::shape::rough::RoughError>(())
//! ```

use super::adhesion::line::Energy;
use super::error::{ContactError, LineTooShort};
use super::model::{ContactModel, Effort, Event, Glance, Loading, Pull, Straight};
use super::state::Normal;
use super::viscoelastic::Spectrum;
use super::viscoelastic::continuous::in_time;
use super::viscoelastic::layout::Layout;
use super::viscoelastic::lazy::Lazy;
use crate::shape::rough::{RoughError, RoughLine, positive};
use crate::shape::{Profile, Rim};
use std::sync::Arc;

/// What a rough bed is good for, to be shown beside its results.
pub const VALIDITY: &str = "approximate: force and stiffness of a rough line stand for those of the isotropic surface; its contact length does not give the real contact area";

/// Springs under a rough line, sorted by gap, with the bed's force and energy at the touch of each.
///
/// A line of gaps g_j over springs of stiffness k = E*Δx pressed by d carries F = k Σ (d − g_j) over g_j < d
/// (Popov & Heß 2015, ch. 10). Sorted, the springs in contact are the first n, so a state costs one
/// binary search. Sums grow by positive terms only: F(g_{n+1}) = F(g_n) + k n (g_{n+1} − g_n), no cancellation.
/// Approximate for surfaces, see [`VALIDITY`].
#[derive(Debug, Clone, PartialEq)]
pub struct RoughBed {
    stiffness: f64,
    gaps: Vec<f64>,
    forces: Vec<f64>,
    energies: Vec<f64>,
}

/// State of a rough bed at one approach.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BedState {
    /// Approach d [m] in the coordinate of the gaps.
    pub indentation: f64,
    /// Normal force F [N].
    pub force: f64,
    /// Normal stiffness dF/dd [N/m].
    pub stiffness: f64,
    /// Stored energy [J].
    pub energy: f64,
}

impl RoughBed {
    /// A bed of gaps g_j [m] over springs of a stiffness E*Δx [N/m].
    ///
    /// The gaps are rough heights on the one-dimensional profile of a macroscopic shape, or alone for a nominally flat
    /// surface. Indentation is counted in the coordinate of the gaps; first touch is at the least gap.
    ///
    /// # Errors
    /// No gap or one that is not finite; a stiffness that is not positive.
    pub fn new(gaps: &[f64], stiffness: f64) -> Result<Self, RoughError> {
        let stiffness = positive("spring stiffness", stiffness)?;
        if let Some(column) = gaps.iter().position(|g| !g.is_finite()) {
            return Err(RoughError::Height { row: 1, column: column + 1, value: gaps[column] });
        }
        positive("number of springs", number(gaps.len()))?;
        let mut gaps = gaps.to_vec();
        gaps.sort_unstable_by(f64::total_cmp);
        let (forces, energies) = touches(&gaps, stiffness);
        Ok(Self { stiffness, gaps, forces, energies })
    }

    /// The bed of a rough line of a number of points on the one-dimensional profile of a macroscopic shape.
    ///
    /// `base` is g(x) [m] for x ≥ 0 [m], zero for a nominally flat surface; the gaps are g(|x|) + z(x) over springs of stiffness E*Δx.
    /// No spring stands where the base is infinite, beyond the edge of a punch. Indentation counts from the apex of the base on the mean line of the roughness.
    ///
    /// # Errors
    /// Fewer than two points on the shortest wave; a modulus [Pa] that is not positive; a base that is not finite.
    pub fn under(line: &RoughLine, points: usize, modulus: f64, base: impl Fn(f64) -> f64) -> Result<Self, RoughError> {
        let heights = line.heights(points)?;
        let gaps = line.places(points).into_iter().zip(&heights).map(|(x, z)| base(x.abs()) + z);
        let gaps: Vec<_> = gaps.filter(|gap| !gap.is_infinite()).collect();
        Self::new(&gaps, modulus * line.length() / number(points))
    }

    /// Least gap [m], the indentation of first touch.
    #[must_use]
    pub fn first_touch(&self) -> f64 {
        self.gaps[0]
    }

    /// Heights of the springs above the first one touched [m], ascending.
    #[must_use]
    pub fn heights(&self) -> Vec<f64> {
        self.gaps.iter().map(|gap| gap - self.gaps[0]).collect()
    }

    /// Number of springs.
    #[must_use]
    pub fn springs(&self) -> usize {
        self.gaps.len()
    }

    /// Indentation [m] and force [N] at which every spring is in contact.
    #[must_use]
    pub fn full_contact(&self) -> (f64, f64) {
        let last = self.gaps.len() - 1;
        (self.gaps[last], self.forces[last])
    }

    /// The state at an indentation d [m]; zero force where nothing touches.
    #[must_use]
    pub fn at_indentation(&self, indentation: f64) -> BedState {
        self.state(self.gaps.partition_point(|&g| g < indentation), indentation)
    }

    /// The state at a force F [N]; at F ≤ 0 the bed is at first touch.
    #[must_use]
    pub fn at_force(&self, force: f64) -> BedState {
        let touched = self.forces.partition_point(|&f| f < force).max(1);
        let (gap, carried) = (self.gaps[touched - 1], self.forces[touched - 1]);
        self.state(touched, gap + (force - carried).max(0.0) / (self.stiffness * number(touched)))
    }

    /// State with the first `touched` springs in contact.
    fn state(&self, touched: usize, indentation: f64) -> BedState {
        let Some(last) = touched.checked_sub(1) else {
            return BedState { indentation, force: 0.0, stiffness: 0.0, energy: 0.0 };
        };
        let stiffness = self.stiffness * number(touched);
        let beyond = indentation - self.gaps[last];
        let force = self.forces[last] + stiffness * beyond;
        let energy = self.energies[last] + 0.5 * (self.forces[last] + force) * beyond;
        BedState { indentation, force, stiffness, energy }
    }
}

/// Force and energy of the bed when spring n is just touched, for every n.
fn touches(gaps: &[f64], stiffness: f64) -> (Vec<f64>, Vec<f64>) {
    let (mut forces, mut energies) = (vec![0.0; gaps.len()], vec![0.0; gaps.len()]);
    for n in 1..gaps.len() {
        let rise = gaps[n] - gaps[n - 1];
        forces[n] = forces[n - 1] + stiffness * number(n) * rise;
        energies[n] = energies[n - 1] + 0.5 * (forces[n - 1] + forces[n]) * rise;
    }
    (forces, energies)
}

#[expect(clippy::cast_precision_loss, reason = "springs are far fewer than 2^53")]
fn number(n: usize) -> f64 {
    n as f64
}

/// Part of the line at either end that a contact on a curved shape must not reach.
const MARGIN: f64 = 1.0 / 16.0;

/// How deep a line can be pressed before a contact on a curved shape reaches its ends.
#[derive(Debug, Clone, Copy)]
struct LineEnds {
    /// Indentation from first touch at which they are reached [m]; infinite over a flat.
    depth: f64,
    /// Length of the line [m].
    length: f64,
}

impl LineEnds {
    fn of(line: &RoughLine, points: usize, base: Option<&dyn Profile>, first_touch: f64) -> Result<Self, RoughError> {
        Ok(Self { depth: least_gap_at_ends(base, line, points)? - first_touch, length: line.length() })
    }

    fn hold(&self, depth: f64) -> Result<(), ContactError> {
        if depth > self.depth {
            return Err(LineTooShort { indentation: depth, length: self.length }.into());
        }
        Ok(())
    }
}

/// A rough line pressed on its bed; indentation counts from first touch.
#[derive(Debug, Clone)]
pub struct RoughContact {
    bed: Arc<RoughBed>,
    state: BedState,
    /// Indentation from first touch [m].
    depth: f64,
    ends: LineEnds,
}

impl RoughContact {
    /// A line of `points` springs on the profile `base`, none under a nominally flat surface, over a half-space of the
    /// modulus E* [Pa], just touching.
    ///
    /// # Errors
    /// As of [`RoughBed::under`].
    pub fn new(line: &RoughLine, points: usize, modulus: f64, base: Option<&dyn Profile>) -> Result<Self, RoughError> {
        let bed = RoughBed::under(line, points, modulus, |x| base.map_or(0.0, |base| base.reduced(x)))?;
        let state = bed.at_indentation(bed.first_touch());
        let ends = LineEnds::of(line, points, base, bed.first_touch())?;
        Ok(Self { bed: Arc::new(bed), state, depth: 0.0, ends })
    }

    /// The springs.
    #[must_use]
    pub fn bed(&self) -> &RoughBed {
        &self.bed
    }
}

/// A rough line pressed on a bed that relaxes; indentation counts from first touch.
///
/// Springs do not see each other, and what one has been through depends on its height only: sorted, they are a bed like
/// that of a round body, and a record costs the springs touched or released before it.
#[derive(Debug, Clone)]
pub struct RelaxingRough {
    bed: Lazy,
    width: f64,
    ends: LineEnds,
}

impl RelaxingRough {
    /// A line of `points` springs on the profile `base`, none under a nominally flat surface, over a half-space that
    /// relaxes, just touching.
    ///
    /// # Errors
    /// As of [`RoughBed::under`].
    pub fn new(
        line: &RoughLine,
        points: usize,
        spectrum: Arc<Spectrum>,
        base: Option<&dyn Profile>,
    ) -> Result<Self, RoughError> {
        let bed = RoughBed::under(line, points, 1.0, |x| base.map_or(0.0, |base| base.reduced(x)))?;
        let (ends, width) = (LineEnds::of(line, points, base, bed.first_touch())?, bed.stiffness);
        Ok(Self { bed: Lazy::new(spectrum, Layout::sorted(bed.heights(), width)), width, ends })
    }
}

impl ContactModel for RelaxingRough {
    fn follow(&mut self, piece: &Straight) -> Result<Vec<Event>, ContactError> {
        if let Some(piece) = in_time(self.bed.spectrum(), self.bed.indentation(), piece)? {
            self.bed.follow_line(&piece);
        }
        self.ends.hold(self.bed.indentation())?;
        Ok(Vec::new())
    }

    fn look(&mut self, piece: &Straight) -> Result<Glance, ContactError> {
        let see = |bed: &Lazy| Glance { force: bed.force(), contact_radius: bed.radius() };
        match in_time(self.bed.spectrum(), self.bed.indentation(), piece)? {
            Some(piece) => Ok(self.bed.tried(piece.speed, piece.duration, see)),
            None => Ok(see(&self.bed)),
        }
    }

    fn state(&self) -> Normal {
        let ledger = self.bed.ledger();
        Normal {
            indentation: Some(self.bed.indentation()),
            force: self.bed.force(),
            contact_radius: None,
            stiffness: self.bed.spectrum().instantaneous() * self.width * number(self.bed.pressed()),
            stored: Energy { elastic: ledger.stored, surface: 0.0 },
            dissipated: ledger.dissipated,
        }
    }

    fn joined(&self) -> bool {
        self.bed.pressed() > 0
    }

    fn loading(&self) -> Option<Box<dyn Loading + '_>> {
        None
    }

    fn copy(&self) -> Box<dyn ContactModel> {
        Box::new(self.clone())
    }

    fn memory(&self) -> Option<Arc<Spectrum>> {
        Some(self.bed.shared_spectrum())
    }

    fn effort(&self) -> Effort {
        self.bed.effort()
    }

    fn leave(&mut self) {
        self.bed.leave();
    }
}

/// Least gap near the ends of the line; infinite over a flat, whose edge the contact may reach.
fn least_gap_at_ends(base: Option<&dyn Profile>, line: &RoughLine, points: usize) -> Result<f64, RoughError> {
    let Some(profile) = base else { return Ok(f64::INFINITY) };
    let half = 0.5 * line.length();
    if matches!(profile.rim(), Rim::Wall(end) if end <= half) {
        return Ok(f64::INFINITY);
    }
    let places = line.places(points);
    let near = places.iter().zip(line.heights(points)?).filter(|(x, _)| x.abs() > (1.0 - MARGIN) * half);
    Ok(near.map(|(x, z)| profile.reduced(x.abs()) + z).fold(f64::INFINITY, f64::min))
}

impl ContactModel for RoughContact {
    fn follow(&mut self, piece: &Straight) -> Result<Vec<Event>, ContactError> {
        (self.state, self.depth) = (self.bed.at_indentation(self.bed.first_touch() + piece.to), piece.to);
        self.ends.hold(self.depth).map(|()| Vec::new())
    }

    fn look(&mut self, piece: &Straight) -> Result<Glance, ContactError> {
        let state = self.bed.at_indentation(self.bed.first_touch() + piece.to);
        Ok(Glance { force: state.force, contact_radius: 0.0 })
    }

    fn state(&self) -> Normal {
        Normal {
            indentation: Some(self.depth),
            force: self.state.force,
            contact_radius: None,
            stiffness: self.state.stiffness,
            stored: Energy { elastic: self.state.energy, surface: 0.0 },
            dissipated: 0.0,
        }
    }

    fn joined(&self) -> bool {
        self.state.force > 0.0
    }

    fn loading(&self) -> Option<Box<dyn Loading + '_>> {
        None
    }

    fn copy(&self) -> Box<dyn ContactModel> {
        Box::new(self.clone())
    }

    fn effort(&self) -> Effort {
        Effort { springs: self.bed.springs(), ..Effort::default() }
    }

    fn press(&mut self, pull: &Pull) -> Option<Result<Vec<Event>, ContactError>> {
        self.state = self.bed.at_force(pull.force);
        self.depth = self.state.indentation - self.bed.first_touch();
        Some(self.ends.hold(self.depth).map(|()| Vec::new()))
    }

    fn last_depth(&self) -> Option<Result<f64, ContactError>> {
        Some(Ok(0.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn gaps() -> impl Strategy<Value = Vec<f64>> {
        proptest::collection::vec((0i32..1000).prop_map(|k| 1e-9 * f64::from(k)), 1..60)
    }

    #[test]
    fn nothing_touches_below_the_least_gap() {
        let bed = RoughBed::new(&[2.0, 1.0, 3.0], 10.0).unwrap();
        assert_eq!(bed.at_indentation(0.5), BedState { indentation: 0.5, force: 0.0, stiffness: 0.0, energy: 0.0 });
        assert_eq!(bed.at_force(0.0), BedState { indentation: 1.0, force: 0.0, stiffness: 10.0, energy: 0.0 });
        // d = 4: springs carry 10 (3 + 2 + 1) = 60 N and 5 (9 + 4 + 1) = 70 J.
        assert_eq!(bed.at_indentation(4.0), BedState { indentation: 4.0, force: 60.0, stiffness: 30.0, energy: 70.0 });
        assert_eq!(bed.full_contact(), (3.0, 30.0));
    }

    #[test]
    fn impossible_beds_are_refused() {
        assert!(RoughBed::new(&[], 1.0).is_err());
        assert!(RoughBed::new(&[0.0, f64::NAN], 1.0).unwrap_err().to_string().contains("column 2 is NaN"));
        assert!(RoughBed::new(&[0.0], 0.0).unwrap_err().to_string().contains("spring stiffness = 0.0"));
    }

    /// Roughness that vanishes leaves the bed of the ball: Hertz to the order of the springs, (a/Δx)⁻² ≈ 1e-4.
    #[test]
    fn vanishing_roughness_is_the_smooth_ball() {
        let spectrum = crate::shape::rough::RoughnessSpectrum::table(&[(6.4, 1e-30), (64.0, 1e-33)]).unwrap();
        let line = RoughLine::new(&crate::shape::rough::Rings::of(&spectrum, 1.0, 1000).unwrap(), 1);
        let bed = RoughBed::under(&line, 1000, 1e6, |x| x * x).unwrap();
        let force = 4.0 / 3.0 * 1e6 * 0.01f64.powf(1.5);
        assert!((bed.at_indentation(0.01).force / force - 1.0).abs() < 2e-4);
        assert!((bed.at_force(force).indentation / 0.01 - 1.0).abs() < 2e-4);
    }

    fn line() -> RoughLine {
        let spectrum = crate::shape::rough::RoughnessSpectrum::table(&[(6.4, 1e-12), (64.0, 1e-15)]).unwrap();
        RoughLine::new(&crate::shape::rough::Rings::of(&spectrum, 1.0, 1000).unwrap(), 7)
    }

    /// Pressed at constant speed v every spring has been pressed since its touch:
    /// F = Δx v Σⱼ [E∞ sⱼ + Σᵢ Eᵢτᵢ (1 − e^(−sⱼ/τᵢ))], sⱼ its time. Bound: rounding of a thousand positive terms.
    #[test]
    fn a_ramp_on_a_rough_line_is_the_sum_over_its_springs() {
        let terms = vec![(3.0, 0.2), (0.5, 7.0)];
        let relaxation = crate::material::Relaxation { equilibrium: 0.4, terms: terms.clone(), viscosity: 0.0 };
        let mut contact = RelaxingRough::new(&line(), 1000, Arc::new(Spectrum::new(&relaxation)), None).unwrap();
        let heights = contact.bed.layout().height.clone();
        let (speed, steps) = (0.02 * heights[999], 40);
        for k in 1..=steps {
            let (from, to) = (f64::from(k - 1), f64::from(k));
            contact.follow(&Straight::between(speed * from, speed * to, 1.0)).unwrap();
            let pressed = heights.iter().map(|height| to - height / speed).filter(|since| *since > 0.0);
            let spring = |since: f64| {
                let elements = terms.iter().map(|(e, tau)| -e * tau * (-since / tau).exp_m1());
                speed * (0.4 * since + elements.sum::<f64>())
            };
            let force = contact.width * pressed.map(spring).sum::<f64>();
            assert!((contact.state().force / force - 1.0).abs() < 1e-12, "{to}");
        }
        let state = contact.state();
        assert!(state.dissipated > 0.0 && state.contact_radius.is_none());
    }

    /// A body that remembers nothing is the elastic bed, up and down.
    #[test]
    fn without_memory_it_is_the_elastic_bed() {
        let spectrum = Arc::new(Spectrum::elastic(2.5));
        let mut relaxing = RelaxingRough::new(&line(), 1000, spectrum, None).unwrap();
        let mut elastic = RoughContact::new(&line(), 1000, 2.5, None).unwrap();
        let largest = elastic.bed.heights()[600];
        for part in [0.3, 1.0, 0.7, 0.1, 0.0, 0.5] {
            let piece = Straight::between(relaxing.bed.indentation(), part * largest, 1.0);
            relaxing.follow(&piece).unwrap();
            elastic.follow(&piece).unwrap();
            let (one, two) = (relaxing.state(), elastic.state());
            assert!((one.force - two.force).abs() <= 1e-12 * elastic.bed.full_contact().1, "{part}");
            assert!((one.stored.elastic - two.stored.elastic).abs() <= 1e-12 * elastic.bed.energies[999]);
            assert!(one.dissipated.abs() <= 1e-12 * elastic.bed.energies[999]);
        }
    }

    proptest! {
        /// Against the sum over springs; rounding of n positive terms.
        #[test]
        fn force_stiffness_and_energy_are_the_sums(gaps in gaps(), d in -10i32..2000) {
            let (d, k) = (1e-9 * f64::from(d), 3e4);
            let state = RoughBed::new(&gaps, k).unwrap().at_indentation(d);
            let pressed = || gaps.iter().map(|g| d - g).filter(|u| *u > 0.0);
            let (force, energy) = (k * pressed().sum::<f64>(), 0.5 * k * pressed().map(|u| u * u).sum::<f64>());
            prop_assert!((state.force - force).abs() <= 1e-13 * force);
            prop_assert!((state.energy - energy).abs() <= 1e-13 * energy);
            prop_assert!((state.stiffness - k * number(pressed().count())).abs() <= 0.0);
        }

        /// Force control is the inverse of indentation control.
        #[test]
        fn a_force_is_found_again(gaps in gaps(), f in 1i32..600) {
            let bed = RoughBed::new(&gaps, 1e3).unwrap();
            let force = 1e-7 * 10f64.powf(0.02 * f64::from(f));
            let state = bed.at_force(force);
            prop_assert!((state.force / force - 1.0).abs() < 1e-12);
            prop_assert!((bed.at_indentation(state.indentation).force / force - 1.0).abs() < 1e-9);
        }
    }
}
