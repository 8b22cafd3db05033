//! Coulomb friction of viscoelastic bodies: a bed exact in time.
//!
//! Tangential springs have the spectrum of the normal ones times G*/E*. With v the tangential
//! displacement divided by m = μE*/G*, the condition |q_x| ≤ μq says that the two springs of
//! displacement n − v and n + v, n the normal displacement, are never in tension. The bed therefore
//! is two unilateral contacts: a spring sticks while both are pressed at the speeds ḋ ∓ u̇, and slips
//! forwards or backwards while one of them is free and creeps without load. The loads have never
//! been negative, so the facts of [`spring`](crate::contact::viscoelastic::spring) hold for both: at
//! constant speeds the load of a pressed one passes zero at most once, and a free one creeps ever more
//! slowly, so that slip begins at most once between two changes of speed and ends only at one.
//!
//! # Examples
//! ```
//! use springbed::friction::{Grip, ViscoelasticBed};
//! use springbed::input::quantity::Length;
//! use springbed::shape::Paraboloid;
//! use springbed::material::{Relaxation, Spectrum};
//! use std::sync::Arc;
//!
//! // Gross sliding follows the normal force as it relaxes: F_x = μF(t).
//! let rubber = Spectrum::new(&Relaxation { equilibrium: 0.2, terms: vec![(0.8, 0.3)], viscosity: 0.0 });
//! let ball = Paraboloid { radius: Length::new(1.0)? };
//! let grip = Grip { normal_modulus: 1.0, tangential_modulus: 1.0, coefficient: 0.3 };
//! let mut bed = ViscoelasticBed::new(&ball, Arc::new(rubber), grip, 60.try_into()?, 1.2)?;
//! bed.advance((1.0, 0.0), 0.8);
//! bed.advance((0.0, 2.0), 1.0);
//! let (normal, tangential) = bed.forces();
//! assert!((tangential / (0.3 * normal) - 1.0).abs() < 1e-14);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod spring;
mod step;

use super::FrictionError;
use super::turning::Grip;
use crate::contact::viscoelastic::layout::Layout;
use crate::contact::viscoelastic::spring::{Free, Spring};
use crate::contact::viscoelastic::{Motion, Spectrum};
use crate::shape::Profile;
use spring::{Rubbed, SlipState, SpringGrip, is_stuck};
use std::num::NonZeroUsize;
use std::sync::Arc;
use step::BedStep;

/// A bed of viscoelastic springs with Coulomb friction, exact for motions of constant speeds.
///
/// There is no error of the time step: every instant at which a spring is touched, begins to slip or
/// is released is a root. What remains is the sum over the springs. Valid for a constant Poisson's
/// ratio (G*/E* constant in time) and elastic similarity. The work done at the bed is the sum of the energy stored,
/// of the heat of relaxation and of that of friction, μ∫q|slip|, which is told apart.
/// Check: without terms it is [`CoulombBed`](super::bed::CoulombBed).
#[derive(Debug, Clone)]
pub struct ViscoelasticBed {
    spectrum: Arc<Spectrum>,
    layout: Layout,
    /// μ and m; moduli enter only by their ratio.
    coefficient: f64,
    reach: f64,
    depth: f64,
    speeds: (f64, f64),
    springs: Vec<(Spring, SpringGrip)>,
    /// Energy lost to friction so far [J].
    dissipated: f64,
    /// Work ∫F_x du_x done along the surface so far [J].
    work: f64,
}

impl ViscoelasticBed {
    /// A bed of `springs` springs between the axis and the distance `radius` [m], never touched.
    ///
    /// The moduli of `grip` count by their ratio only.
    ///
    /// # Errors
    /// The profile ends before `radius`.
    pub fn new(
        profile: &dyn Profile,
        spectrum: Arc<Spectrum>,
        grip: Grip,
        springs: NonZeroUsize,
        radius: f64,
    ) -> Result<Self, FrictionError> {
        let layout = Layout::uniform(profile, radius, springs.get());
        if layout.height.iter().any(|height| height.is_nan()) {
            return Err(FrictionError::BeyondRadius { radius });
        }
        Ok(Self::on(layout, spectrum, grip))
    }

    /// A bed of the springs of `layout`, such as those of a rough line sorted by height, never touched.
    ///
    /// The moduli of `grip` count by their ratio only.
    #[must_use]
    pub fn on(layout: Layout, spectrum: Arc<Spectrum>, grip: Grip) -> Self {
        let rest = Free { rest: 0.0, modes: vec![0.0; spectrum.modes().len()] };
        let springs = vec![(Spring::untouched(&spectrum), SpringGrip::Free(rest)); layout.len()];
        let (coefficient, reach) = (grip.coefficient, grip.reach());
        Self {
            spectrum,
            layout,
            coefficient,
            reach,
            depth: 0.0,
            speeds: (0.0, 0.0),
            springs,
            dissipated: 0.0,
            work: 0.0,
        }
    }

    /// Moves at the normal speed `speed` and the tangential speed `slide` [m/s] for `duration` [s]; the work ∫F_x du_x it
    /// takes on the way [J].
    pub fn advance(&mut self, (speed, slide): (f64, f64), duration: f64) -> f64 {
        let step = BedStep::new(&self.spectrum, (speed, self.scaled(slide)), duration);
        let mut all = Rubbed::default();
        for (j, spring) in self.springs.iter_mut().enumerate() {
            let (place, weight) = (self.depth - self.layout.height[j], self.layout.weight[j]);
            let rubbed = match step.sticking(place, spring) {
                Some(rubbed) => {
                    step.carry(spring);
                    rubbed
                }
                None => step.follow(place, spring),
            };
            all.lost += weight * rubbed.lost;
            all.work += weight * rubbed.work;
        }
        self.dissipated += self.coefficient * self.reach * all.lost;
        let work = self.coefficient * self.reach * all.work;
        self.work += work;
        self.depth = Motion { start: self.depth, speed, duration }.end();
        self.speeds = (speed, step.slide);
        work
    }

    /// The work [J] that [`advance`](Self::advance) would take, and whether a spring would stick at its end; the bed stays
    /// as it is.
    #[must_use]
    pub fn look(&self, (speed, slide): (f64, f64), duration: f64) -> (f64, bool) {
        let step = BedStep::new(&self.spectrum, (speed, self.scaled(slide)), duration);
        let (mut work, mut sticks) = (0.0, false);
        for (j, spring) in self.springs.iter().enumerate() {
            let (place, weight) = (self.depth - self.layout.height[j], self.layout.weight[j]);
            if let Some(rubbed) = step.sticking(place, spring) {
                work += weight * rubbed.work;
                sticks = true;
                continue;
            }
            if let Some(slipping) = step.slipping(place, spring) {
                work += weight * slipping;
                continue;
            }
            let mut spring = spring.clone();
            work += weight * step.follow(place, &mut spring).work;
            sticks = sticks || is_stuck(&spring).unwrap_or(false);
        }
        (self.coefficient * self.reach * work, sticks)
    }

    /// A displacement or speed along the surface, divided by m.
    fn scaled(&self, slide: f64) -> f64 {
        if self.reach > 0.0 { slide / self.reach } else { 0.0 }
    }

    /// From now on the coefficient of friction is the part `part` of what it was. What springs carry above it they let
    /// go at once, and what that frees is lost to friction.
    pub fn give_way(&mut self, part: f64) {
        let before = self.stored();
        (self.coefficient, self.reach) = (part * self.coefficient, part * self.reach);
        let spectrum = self.spectrum.as_ref();
        for ((normal, own), height) in self.springs.iter_mut().zip(&self.layout.height) {
            own.divide(part);
            let (Spring::Pressed(loads), SpringGrip::Held { displacement, loads: along, slip }) = (&*normal, own)
            else {
                continue;
            };
            if part >= 1.0 {
                *slip = SlipState::No;
                continue;
            }
            let at_rest = |u: f64, loads: &[f64]| spectrum.equilibrium() * u + loads.iter().sum::<f64>();
            let carried = at_rest(*displacement, along);
            let (above, side) = (carried.abs() - at_rest(self.depth - height, loads), carried.signum());
            if above <= 0.0 {
                continue;
            }
            // It gives at once, all elements with it, unless a dashpot holds it.
            let back = if spectrum.viscosity() > 0.0 { 0.0 } else { side * above / spectrum.instantaneous() };
            *displacement -= back;
            for (own, term) in along.iter_mut().zip(spectrum.terms()) {
                *own -= term.modulus * back;
            }
            *slip = SlipState::Towards(side);
        }
        self.speeds.1 /= part;
        self.dissipated += before - self.stored();
    }

    /// Displacement [m] at which the contact slides as a whole, of springs that do not relax.
    #[must_use]
    pub fn gives_at(&self) -> f64 {
        self.reach * self.depth.max(0.0)
    }

    /// Number of springs.
    #[must_use]
    pub fn springs(&self) -> usize {
        self.springs.len()
    }

    /// Bytes of the springs: each with its place, and the loads of its elements twice.
    #[must_use]
    pub fn bytes(&self) -> usize {
        let elements = 2 * self.spectrum.terms().len() * size_of::<f64>();
        self.springs.len() * (size_of::<(Spring, SpringGrip)>() + 2 * size_of::<f64>() + elements)
    }

    /// Shortest time [s], in which nothing relaxes: the duration of a jump.
    #[must_use]
    pub fn instant(&self) -> f64 {
        self.spectrum.instant()
    }

    /// Radius up to which the springs stick [m].
    #[must_use]
    pub fn stick_radius(&self) -> f64 {
        self.held().1 as f64 * self.layout.weight.first().map_or(0.0, |weight| 0.5 * weight)
    }

    /// Present depth [m].
    #[must_use]
    pub fn depth(&self) -> f64 {
        self.depth
    }

    /// Energy lost to friction so far [J].
    #[must_use]
    pub fn dissipated(&self) -> f64 {
        self.dissipated
    }

    /// Energy stored in tangential deformation [J], ½G∞v² + Σ fᵢ²/2Gᵢ of each spring, those left and still creeping
    /// included.
    #[must_use]
    pub fn stored(&self) -> f64 {
        let springs = self.springs.iter().zip(&self.layout.weight);
        let sum: f64 = springs.map(|((_, own), weight)| weight * own.stored(&self.spectrum)).sum();
        self.coefficient * self.reach * sum
    }

    /// Energy lost so far [J] by the tangential springs as they relax: what of the work along the surface is neither
    /// stored nor lost to friction.
    #[must_use]
    pub fn relaxed(&self) -> f64 {
        self.work - self.stored() - self.dissipated
    }

    /// Normal and tangential force [N].
    #[must_use]
    pub fn forces(&self) -> (f64, f64) {
        let loads = (0..self.springs.len()).map(|j| (self.layout.weight[j], self.line_loads(j)));
        let sum = loads.fold((0.0, 0.0), |sum, (weight, load)| (sum.0 + weight * load.0, sum.1 + weight * load.1));
        (sum.0, self.coefficient * sum.1)
    }

    /// Line loads q and q_x/μ [N/m] of the spring `j`; zero where it is free.
    fn line_loads(&self, j: usize) -> (f64, f64) {
        let (Spring::Pressed(loads), SpringGrip::Held { displacement, loads: own, slip }) = &self.springs[j] else {
            return (0.0, 0.0);
        };
        let normal = self.spectrum.load(self.depth - self.layout.height[j], loads, self.speeds.0);
        match slip {
            SlipState::Towards(side) => (normal, side * normal),
            SlipState::No => (normal, self.spectrum.load(*displacement, own, self.speeds.1)),
        }
    }

    /// Number of springs under the indenter, and how many of them stick.
    #[must_use]
    pub fn held(&self) -> (usize, usize) {
        let held = self.springs.iter().filter_map(is_stuck);
        held.fold((0, 0), |(pressed, stuck), one| (pressed + 1, stuck + usize::from(one)))
    }
}

#[cfg(test)]
mod tests {
    use super::super::{CoulombBed, FrettingMap, Pose};
    use super::*;
    use crate::input::quantity::Length;
    use crate::material::Relaxation;
    use crate::shape::Paraboloid;
    use proptest::prelude::*;

    const GRIP: Grip = Grip { normal_modulus: 1.0, tangential_modulus: 0.8, coefficient: 0.4 };

    fn spectrum(equilibrium: f64, terms: &[(f64, f64)], viscosity: f64) -> Arc<Spectrum> {
        Arc::new(Spectrum::new(&Relaxation { equilibrium, terms: terms.to_vec(), viscosity }))
    }

    fn bed(spectrum: &Arc<Spectrum>, grip: Grip) -> ViscoelasticBed {
        let shape = Paraboloid { radius: Length::new(1.0).unwrap() };
        ViscoelasticBed::new(&shape, Arc::clone(spectrum), grip, 60.try_into().unwrap(), 1.2).unwrap()
    }

    /// Speeds (normal, tangential) from integers, in motions of 0.1 s to 1 s.
    fn motions() -> impl Strategy<Value = Vec<(i32, i32, i32)>> {
        prop::collection::vec((-10i32..14, -10i32..10, 1i32..11), 1..14)
    }

    fn speeds((speed, slide, time): (i32, i32, i32)) -> ((f64, f64), f64) {
        ((0.1 * f64::from(speed), 0.15 * f64::from(slide)), 0.1 * f64::from(time))
    }

    proptest! {
        #![proptest_config(crate::laws::cases(64))]

        /// Without terms it is the elastic bed, spring by spring.
        #[test]
        fn without_terms_it_is_the_elastic_bed(history in motions()) {
            let shape = Paraboloid { radius: Length::new(1.0).unwrap() };
            let mut relaxing = bed(&spectrum(1.0, &[], 0.0), GRIP);
            let mut elastic = CoulombBed::new(&shape, GRIP, 60.try_into().unwrap(), 1.2).unwrap();
            let mut map = FrettingMap::new(&shape, GRIP, &relaxing.layout.place);
            let mut to = Pose::default();
            for motion in history {
                let ((speed, slide), time) = speeds(motion);
                relaxing.advance((speed, slide), time);
                // The same products as in the bed, so that both are touched at the same instants.
                to = Pose { indentation: to.indentation + speed * time, slide: to.slide + slide * time };
                let force = elastic.advance(&[to])[0];
                map.advance(to);
                let per_length = map.energy().into_iter().zip(&relaxing.layout.weight);
                let right: f64 = per_length.map(|(energy, weight)| 0.5 * weight * energy).sum();
                let lost = relaxing.dissipated();
                prop_assert!((lost - right).abs() < 1e-13, "{lost} {right}");
                prop_assert!((relaxing.forces().1 - force).abs() < 1e-13, "{} {force}", relaxing.forces().1);
            }
        }

        /// No error of the step: motions cut in three give the same; friction never passes μF.
        #[test]
        fn steps_do_not_matter(history in motions(), which in 0usize..4) {
            let kinds = [
                spectrum(0.2, &[(0.8, 0.3)], 0.0),
                spectrum(0.0, &[(0.5, 0.05), (0.5, 2.0)], 0.0),
                spectrum(0.1, &[(1.0, 0.01), (0.5, 0.4), (0.3, 30.0)], 0.0),
                spectrum(0.5, &[(0.5, 0.3)], 0.05),
            ];
            let (mut whole, mut cut) = (bed(&kinds[which], GRIP), bed(&kinds[which], GRIP));
            let (mut before, mut heat) = (0.0, 0.0);
            for motion in history {
                let (pair, time) = speeds(motion);
                whole.advance(pair, time);
                for part in [0.2, 0.5, 0.3] {
                    cut.advance(pair, part * time);
                }
                let ((normal, force), (_, other)) = (whole.forces(), cut.forces());
                prop_assert!((force - other).abs() < 1e-11, "{force} {other}");
                let (lost, other) = (whole.dissipated(), cut.dissipated());
                prop_assert!((lost - other).abs() < 1e-11 && lost > before - 1e-14, "{before} {lost} {other}");
                before = lost;
                prop_assert!((whole.stored() - cut.stored()).abs() < 1e-11 && whole.stored() >= 0.0);
                prop_assert!((whole.relaxed() - cut.relaxed()).abs() < 1e-11, "{} {}", whole.relaxed(), cut.relaxed());
                prop_assert!(whole.relaxed() > heat - 1e-13, "{heat} {}", whole.relaxed());
                heat = whole.relaxed();
                prop_assert!(force.abs() <= GRIP.coefficient * normal * (1.0 + 1e-12) + 1e-14);
            }
        }
    }

    /// Gross sliding: F_x = μF(t) while F relaxes.
    #[test]
    fn gross_sliding_follows_the_normal_force() {
        let mut bed = bed(&spectrum(0.2, &[(0.8, 0.3)], 0.0), GRIP);
        bed.advance((1.0, 0.0), 0.8);
        bed.advance((0.0, 2.0), 1.0);
        for _ in 0..20 {
            bed.advance((0.0, 2.0), 0.05);
            let (normal, force) = bed.forces();
            assert!((force / (GRIP.coefficient * normal) - 1.0).abs() < 1e-14);
            assert_eq!(bed.held().1, 0);
        }
    }

    /// The work along the surface is ∫F_x du_x, by the trapezoidal rule to second order of a step, and what is not
    /// stored or rubbed away has relaxed: all of it when the springs have come to rest.
    #[test]
    fn the_work_is_that_of_the_force() {
        let rubber = spectrum(0.2, &[(0.8, 0.3)], 0.01);
        let mut bed = bed(&rubber, GRIP);
        let (mut work, mut last, steps) = (0.0, 0.0, 2000);
        for (pair, time) in [((1.0, 0.1), 0.8), ((0.0, 0.7), 0.5), ((-0.5, -0.9), 0.6), ((0.3, 0.2), 1.0)] {
            bed.advance(pair, 1e-12);
            last = bed.forces().1;
            for _ in 0..steps {
                bed.advance(pair, time / f64::from(steps));
                let now = bed.forces().1;
                work += 0.5 * (last + now) * pair.1 * time / f64::from(steps);
                last = now;
            }
        }
        assert!(last.abs() > 0.0 && (bed.work / work - 1.0).abs() < 1e-5, "{} {work}", bed.work);
        // Apart for long: nothing is stored, and all has become heat.
        bed.advance((-1.0, 0.0), 10.0);
        bed.advance((0.0, 0.0), 100.0);
        assert!(bed.stored() < 1e-12 && (bed.relaxed() + bed.dissipated() - bed.work).abs() < 1e-12);
        assert!(bed.relaxed() > 0.1 * bed.dissipated());
    }

    /// μ → ∞: every spring sticks, and a slide at constant speed after touch gives
    /// F_x = 2a(G*/E*) ∫E*(t) dt u̇ over the springs in contact.
    #[test]
    fn without_slip_it_is_the_relaxation_of_the_punch() {
        let grip = Grip { coefficient: 1e9, ..GRIP };
        let mut bed = bed(&spectrum(0.2, &[(0.8, 0.3)], 0.0), grip);
        bed.advance((1.0, 0.0), 0.8);
        bed.advance((0.0, 0.01), 0.7);
        let (held, stuck) = bed.held();
        assert_eq!(held, stuck);
        let relaxed = 0.2 * 0.7 + 0.8 * 0.3 * (1.0 - (-0.7f64 / 0.3).exp());
        #[expect(clippy::cast_precision_loss, reason = "60 springs")]
        let width = 2.0 * held as f64 * 0.02;
        assert!((bed.forces().1 / (0.8 * width * 0.01 * relaxed) - 1.0).abs() < 1e-12);
    }
}
