//! What pulls at pixels whose neighbours do nothing to them, as those of a sheet of springs: each joins and leaves by itself.

use super::attraction::Attraction;
use ndarray::{Array2, Zip};

/// Most steps of Newton's method, which come to the root of what fades from one side.
const STEPS: usize = 100;

/// Springs without neighbours under an attraction.
///
/// A spring whose surface is x apart while nothing moves it rests where k(x − g) is what pulls at it across the gap g. Where
/// the attraction falls faster than the spring grows stiff there are two such gaps, and it stays on its branch as far as
/// that goes: it is drawn in, and lets go, at once. What a jump loses is known exactly, and with it the ledger.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct LoneSprings {
    attraction: Attraction,
    /// k \[Pa/m\].
    stiffness: f64,
    /// Distances x \[m\] within which every spring is drawn in, and within which one stays that is.
    joins: f64,
    leaves: f64,
}

impl LoneSprings {
    pub(super) fn new(attraction: Attraction, stiffness: f64) -> Self {
        let stretched = attraction.stress / stiffness;
        let [joins, leaves] = match attraction.fading() {
            None => [attraction.range(), attraction.range() + stretched],
            // x = g + (σ₀/k) e^(−g/ρ) is least at g = ρ ln(σ₀/kρ).
            Some(range) if stretched > range => [range * (1.0 + (stretched / range).ln()), stretched],
            Some(_) => [stretched; 2],
        };
        Self { attraction, stiffness, joins, leaves }
    }

    /// What pulls \[Pa\] at the distance `free` \[m\], where `pull` did.
    pub(super) fn pull(&self, free: f64, pull: f64) -> f64 {
        let is_near = free < self.joins || self.is_near(pull) && free < self.leaves;
        if is_near { self.attraction.stress } else { self.attraction.at(self.far(free)) }
    }

    /// Whether a spring is drawn in at which `pull` \[Pa\] pulls.
    fn is_near(&self, pull: f64) -> bool {
        pull >= self.attraction.stress
    }

    /// Gap \[m\] of a spring at the distance `free` \[m\] that is not drawn in.
    ///
    /// x = g + (σ₀/k) e^(−g/ρ) is convex in g: from g = x the steps come down to the wider of its roots.
    fn far(&self, free: f64) -> f64 {
        let (Some(range), true) = (self.attraction.fading(), free < self.leaves + self.attraction.reach()) else {
            return free;
        };
        // No spring that is not drawn in is nearer than where x is least.
        let (mut gap, nearest) = (free, self.joins - range);
        for _ in 0..STEPS {
            let drawn = self.attraction.at(gap) / self.stiffness;
            let next = gap - (gap + drawn - free) / (1.0 - drawn / range).max(f64::EPSILON);
            if next >= gap || next.is_nan() {
                break;
            }
            gap = next.max(nearest).max(0.0);
        }
        gap
    }

    /// Energy \[J/m²\] of a spring at the distance `free` \[m\] across the gap `gap` \[m\].
    fn energy(&self, free: f64, gap: f64) -> f64 {
        0.5 * self.stiffness * (free - gap) * (free - gap) + self.attraction.energy_at(gap)
    }

    /// Energy \[J/m²\] by which one that is drawn in at the distance `free` \[m\] is below one that is not.
    fn below(&self, free: f64) -> f64 {
        let stretched = self.attraction.stress / self.stiffness;
        let near = if self.attraction.fading().is_some() { 0.0 } else { (free - stretched).max(0.0) };
        self.energy(free, self.far(free)) - self.energy(free, near)
    }

    /// Energy \[J/m²\] that springs lose in jumps, where what pulls goes from `before` to `after`.
    pub(super) fn lost(&self, before: &Array2<f64>, after: &Array2<f64>) -> f64 {
        if self.joins >= self.leaves {
            return 0.0;
        }
        let [joined, left] = [self.below(self.joins), -self.below(self.leaves)].map(|lost| lost.max(0.0));
        Zip::from(before).and(after).fold(0.0, |sum, &before, &after| {
            match (self.is_near(before), self.is_near(after)) {
                (false, true) => sum + joined,
                (true, false) => sum + left,
                (true, true) | (false, false) => sum,
            }
        })
    }

    /// Energy of the attraction \[J per m² of a pixel\], zero far apart.
    pub(super) fn surface(&self, gap: &Array2<f64>) -> f64 {
        gap.fold(0.0, |sum, &gap| sum + self.attraction.energy_at(gap))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::law::ElasticAdhesion;
    use proptest::prelude::*;

    /// Springs of the stiffness 1 under an attraction of the work 1.
    fn springs(law: i32, stress: i32) -> LoneSprings {
        let stress = 1.05_f64.powi(stress);
        let law = match law {
            0 => ElasticAdhesion::Finite { work: 1.0, stress },
            _ => ElasticAdhesion::Fading { work: 1.0, range: 1.0 / stress },
        };
        LoneSprings::new(Attraction::of(law, 1.0, 1.0).unwrap(), 1.0)
    }

    /// Force on a spring and its energy.
    fn state(springs: &LoneSprings, free: f64, pull: f64) -> (f64, f64) {
        let stretched = pull.min(free);
        (stretched, springs.energy(free, free - stretched))
    }

    proptest! {
        #![proptest_config(crate::laws::cases(64))]

        /// Drawn to and fro, what is done on a spring is stored or lost in its jumps, and it rests wherever it is.
        #[test]
        fn work_is_stored_or_lost(law in 0i32..2, stress in -60i32..60, ways in prop::collection::vec(1i32..100, 2..6)) {
            let springs = springs(law, stress);
            let far = springs.leaves + springs.attraction.reach();
            let place = |way: i32| 1e-2 * f64::from(way) * 1.5 * springs.leaves;
            let (mut free, mut pull) = (far, 0.0);
            let (_, begun) = state(&springs, free, pull);
            let (mut work, mut lost) = (0.0, 0.0);
            let steps = 4000;
            for end in ways.iter().map(|&way| place(way)) {
                let from = free;
                for step in 1..=steps {
                    let next = from + (end - from) * f64::from(step) / f64::from(steps);
                    let after = springs.pull(next, pull);
                    let [one, two] = [(free, pull), (next, after)].map(|(free, pull)| state(&springs, free, pull).0);
                    work += 0.5 * (one + two) * (next - free);
                    lost += springs.lost(&Array2::from_elem((1, 1), pull), &Array2::from_elem((1, 1), after));
                    (free, pull) = (next, after);
                    let gap = free - state(&springs, free, pull).0;
                    prop_assert!(gap <= 0.0 || (springs.attraction.at(gap) - pull).abs() <= 1e-6 * springs.attraction.stress);
                }
                let (_, stored) = state(&springs, free, pull);
                // A jump lies somewhere in its step.
                let open = 2.0 * f64::from(steps).recip() * far * springs.attraction.stress * ways.len() as f64;
                prop_assert!((begun + work - stored - lost).abs() <= open, "{work} {stored} {lost} {open}");
            }
        }
    }

    /// A spring that is as stiff as what fades is steep has one place everywhere.
    #[test]
    fn what_fades_slowly_loses_nothing() {
        let springs = springs(1, -1);
        assert!(springs.joins >= springs.leaves);
        let gap = springs.far(1.001 * springs.leaves);
        assert!((0.0..0.1).contains(&gap), "{gap}");
    }
}
