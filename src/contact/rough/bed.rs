//! Spring bed of a rough line: independent springs, sorted by height.
//!
//! # Examples
//! ```
//! use springbed::contact::rough::RoughBed;
//!
//! // At full contact every spring carries: 2 N/m on the last of gaps 0, 1 and 3 m.
//! let bed = RoughBed::new(&[1.0, 0.0, 3.0], 2.0)?;
//! assert_eq!(bed.full_contact(), (3.0, 10.0));
//! # Ok::<(), springbed::shape::rough::RoughError>(())
//! ```

use crate::shape::rough::{RoughError, RoughLine, positive};

/// Springs under a rough line, sorted by gap, with the bed's force and energy at the touch of each.
///
/// A line of gaps g_j over springs of stiffness k = E*Δx pressed by d carries F = k Σ (d − g_j) over g_j < d
/// (Popov & Heß 2015, ch. 10). Sorted, the springs in contact are the first n, so a state costs one
/// binary search. Sums grow by positive terms only: F(g_{n+1}) = F(g_n) + k n (g_{n+1} − g_n), no cancellation.
/// Approximate for surfaces, see [`VALIDITY`](super::VALIDITY).
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
        let gaps: Vec<_> = Self::gaps_under(line, points, base)?.into_iter().filter(|gap| !gap.is_infinite()).collect();
        Self::new(&gaps, modulus * line.length() / number(points))
    }

    /// The gaps g(|x|) + z(x) [m] along a line, infinite beyond the edge of a punch.
    ///
    /// # Errors
    /// Fewer than two points on the shortest wave.
    pub(super) fn gaps_under(
        line: &RoughLine,
        points: usize,
        base: impl Fn(f64) -> f64,
    ) -> Result<Vec<f64>, RoughError> {
        let places = line.places(points);
        Ok(places.into_iter().zip(line.heights(points)?).map(|(x, z)| base(x.abs()) + z).collect())
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

    /// The state that has taken the energy U [J] since first touch; at U ≤ 0 the bed is at first touch.
    #[must_use]
    pub fn at_energy(&self, energy: f64) -> BedState {
        let touched = self.energies.partition_point(|&u| u < energy).max(1);
        let (gap, carried, taken) = (self.gaps[touched - 1], self.forces[touched - 1], self.energies[touched - 1]);
        // U = U₀ + F₀x + ½Kx², free of cancellation.
        let (rest, stiffness) = ((energy - taken).max(0.0), self.stiffness * number(touched));
        let fast = carried + (carried * carried + 2.0 * stiffness * rest).sqrt();
        self.state(touched, if fast > 0.0 { gap + 2.0 * rest / fast } else { gap })
    }

    /// The states in which the springs are just touched, one by one; their stiffness is that with the spring.
    pub fn touches(&self) -> impl DoubleEndedIterator<Item = BedState> + ExactSizeIterator {
        let ends = self.gaps.iter().zip(&self.forces).zip(&self.energies).enumerate();
        ends.map(|(before, ((&indentation, &force), &energy))| BedState {
            indentation,
            force,
            stiffness: self.stiffness * number(before + 1),
            energy,
        })
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

/// A number of springs as a number.
#[expect(clippy::cast_precision_loss, reason = "springs are far fewer than 2^53")]
pub(super) fn number(n: usize) -> f64 {
    n as f64
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

        /// The depth that takes an energy is found again, at the touch of a spring too.
        #[test]
        fn an_energy_is_found_again(gaps in gaps(), f in 1i32..600) {
            let bed = RoughBed::new(&gaps, 1e3).unwrap();
            let energy = 1e-14 * 10f64.powf(0.02 * f64::from(f));
            let state = bed.at_energy(energy);
            prop_assert!((state.energy / energy - 1.0).abs() < 1e-13);
            for touch in bed.touches() {
                let found = bed.at_energy(touch.energy);
                prop_assert!((found.indentation - touch.indentation).abs() <= 1e-14 * touch.indentation);
                prop_assert!((found.energy - touch.energy).abs() <= 1e-14 * touch.energy);
            }
        }
    }
}
