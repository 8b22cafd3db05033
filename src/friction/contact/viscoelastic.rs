//! Coulomb friction of viscoelastic bodies: a bed beside the normal contact.

use super::{Step, Sudden, TangentialContact};
use crate::contact::model::{Effort, TangentialBed};
use crate::contact::state::Tangential;
use crate::friction::{FrictionError, ViscoelasticBed};

/// A bed of viscoelastic springs with friction, driven along the depth of the normal contact.
///
/// Exact in time for depth and slide that are straight in each step. What springs lose by slip is told apart from what
/// they lose by relaxing.
#[derive(Debug, Clone)]
pub struct ViscoelasticFriction {
    bed: ViscoelasticBed,
    tangential_modulus: f64,
    slide: f64,
}

impl ViscoelasticFriction {
    /// The bed `bed`, never touched, of bodies with the instantaneous tangential modulus `tangential_modulus` G* [Pa].
    #[must_use]
    pub fn new(bed: ViscoelasticBed, tangential_modulus: f64) -> Self {
        Self { bed, tangential_modulus, slide: 0.0 }
    }

    fn present(&self) -> Tangential {
        let stick_radius = self.bed.stick_radius();
        Tangential {
            slide: self.slide,
            force: self.bed.forces().1,
            stick_radius,
            stiffness: 2.0 * self.tangential_modulus * stick_radius,
            stored: Some(self.bed.stored()),
            dissipated: Some(self.bed.dissipated()),
            area_ratio: None,
        }
    }
}

impl TangentialBed for ViscoelasticFriction {
    fn go(&mut self, speeds: (f64, f64), duration: f64) -> f64 {
        self.slide += speeds.1 * duration;
        self.bed.advance(speeds, duration)
    }

    fn look(&self, speeds: (f64, f64), duration: f64) -> (f64, bool) {
        self.bed.look(speeds, duration)
    }

    fn state(&self) -> Tangential {
        self.present()
    }

    fn relaxed(&self) -> f64 {
        self.bed.relaxed()
    }

    fn gives_at(&self) -> f64 {
        self.bed.gives_at()
    }

    fn give_way(&mut self, part: f64) {
        self.bed.give_way(part);
    }

    fn copy(&self) -> Box<dyn TangentialBed> {
        Box::new(self.clone())
    }
}

impl TangentialContact for ViscoelasticFriction {
    fn follow(&mut self, step: &Step<'_>) -> Result<Vec<Sudden>, FrictionError> {
        let depth = step.prescribed[1];
        let (down, way) = (depth - self.bed.depth(), step.slide[1] - self.slide);
        self.slide = step.slide[1];
        let over = if step.over > 0.0 { step.over } else { self.bed.instant() };
        // An instant at the speed at which the contact is just led has no way that numbers could tell, but dashpots feel it.
        let is_instant = step.over > 0.0 && over <= self.bed.instant() && way.abs() <= 0.0;
        let speeds = if is_instant { (step.sinking, step.speed) } else { (down / over, way / over) };
        if step.over > 0.0 || down.abs() > 0.0 || way.abs() > 0.0 {
            self.bed.advance(speeds, over);
        }
        Ok(Vec::new())
    }

    fn state(&self) -> Tangential {
        self.present()
    }

    fn relaxed(&self) -> f64 {
        self.bed.relaxed()
    }

    fn copy(&self) -> Box<dyn TangentialContact> {
        Box::new(self.clone())
    }

    fn bed(&self) -> Option<Box<dyn TangentialBed>> {
        Some(Box::new(self.clone()))
    }

    fn effort(&self) -> Effort {
        Effort { bytes: self.bed.bytes(), springs: self.bed.springs(), force_error: None, radius_error: None }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::model::{ContactModel, Pose, Straight};
    use crate::contact::rough::{RelaxingRough, RoughContact};
    use crate::friction::contact::{CoulombSprings, FrictionalContact};
    use crate::friction::{Grip, TangentialMemory};
    use crate::input::quantity::Length;
    use crate::material::{Relaxation, Spectrum};
    use crate::shape::Paraboloid;
    use crate::shape::rough::{Rings, RoughLine, RoughnessSpectrum};
    use std::sync::Arc;

    const GRIP: Grip = Grip { normal_modulus: 2.5, tangential_modulus: 2.0, coefficient: 0.3 };

    fn line(height: f64) -> RoughLine {
        let spectrum = RoughnessSpectrum::table(&[(6.4, height * height), (64.0, 1e-3 * height * height)]).unwrap();
        RoughLine::new(&Rings::of(&spectrum, 1.0, 1000).unwrap(), 7)
    }

    /// The line on bodies that relax, with friction.
    fn rubbing(line: &RoughLine, terms: &[(f64, f64)], base: Option<&Paraboloid>) -> FrictionalContact {
        damped(line, (terms, 0.0), base)
    }

    /// The same with a dashpot.
    fn damped(
        line: &RoughLine,
        (terms, viscosity): (&[(f64, f64)], f64),
        base: Option<&Paraboloid>,
    ) -> FrictionalContact {
        let relaxation = Relaxation { equilibrium: 2.5, terms: terms.to_vec(), viscosity };
        let spectrum = Arc::new(Spectrum::new(&relaxation));
        let base = base.map(|base| base as &dyn crate::shape::Profile);
        let normal = RelaxingRough::new(line, 1000, spectrum.clone(), base).unwrap();
        let bed = ViscoelasticBed::on(normal.layout().clone(), spectrum, GRIP);
        FrictionalContact::new(Box::new(normal), Box::new(ViscoelasticFriction::new(bed, GRIP.tangential_modulus)))
    }

    fn go(contact: &mut FrictionalContact, from: Pose, to: Pose, over: f64) {
        let piece = Straight { slide: to.slide, ..Straight::between(from.indentation, to.indentation, over) };
        contact.follow(&piece).unwrap();
        contact.settle().unwrap();
    }

    /// Poses in depths of the line.
    fn poses(depth: f64) -> Vec<Pose> {
        let pose = |(down, along): &(f64, f64)| Pose { indentation: down * depth, slide: along * depth };
        [(1.0, 0.0), (1.0, 0.2), (1.4, 0.3), (0.9, 0.1), (0.9, -0.4), (1.2, -0.3), (0.2, 0.0), (1.0, 0.1)]
            .iter()
            .map(pose)
            .collect()
    }

    /// Springs that do not relax are those of the elastic bed, through stick, slip and touch anew. Bound: rounding of a
    /// thousand springs, of the largest force.
    #[test]
    fn without_terms_a_rough_line_rubs_as_an_elastic_one() {
        let line = line(1e-6);
        let elastic = RoughContact::new(&line, 1000, 2.5, None).unwrap();
        let depth = elastic.bed().heights()[700];
        let most = elastic.bed().at_indentation(elastic.bed().first_touch() + 1.4 * depth).force;
        let springs = CoulombSprings::sorted(elastic.bed().heights(), GRIP, 1e-3);
        let mut two = FrictionalContact::new(Box::new(elastic), Box::new(springs));
        let (mut one, mut from) = (rubbing(&line, &[], None), Pose::default());
        for to in poses(depth) {
            go(&mut one, from, to, 1.0);
            go(&mut two, from, to, 1.0);
            let (seen, right) = (one.tangential().unwrap(), two.tangential().unwrap());
            assert!((seen.force - right.force).abs() <= 1e-12 * most, "{to:?}: {} {}", seen.force, right.force);
            let lost = seen.dissipated.unwrap() - right.dissipated.unwrap();
            assert!(lost.abs() <= 1e-12 * most * depth, "{to:?}: {lost:e}");
            from = to;
        }
    }

    /// Gross sliding carries μF while F relaxes, to rounding; once it has relaxed friction takes μF over the way of the
    /// indenter, for no spring creeps any more, to e^(−20) of what is left of the slowest term.
    #[test]
    fn gross_sliding_on_rough_rubber_follows_the_normal_force() {
        let line = line(1e-6);
        let depth = RoughContact::new(&line, 1000, 1.0, None).unwrap().bed().heights()[700];
        let mut contact = rubbing(&line, &[(3.0, 0.4), (2.0, 5.0)], None);
        let mut at = Pose { indentation: depth, slide: 0.0 };
        go(&mut contact, Pose::default(), at, 0.1);
        for k in 1..=40 {
            let to = Pose { slide: 0.1 * depth * f64::from(k), ..at };
            go(&mut contact, at, to, 0.02);
            at = to;
            let (force, friction) = (contact.state().force, contact.tangential().unwrap().force);
            assert!(k < 20 || (friction / (0.3 * force) - 1.0).abs() < 1e-12, "{k}");
        }
        let lost = |contact: &FrictionalContact| contact.tangential().unwrap().dissipated.unwrap();
        let last = Pose { slide: 5.0 * depth, ..at };
        go(&mut contact, at, last, 100.0);
        let (before, to) = (lost(&contact), Pose { slide: 6.0 * depth, ..at });
        go(&mut contact, last, to, 0.1);
        let (taken, right) = (lost(&contact) - before, 0.3 * contact.state().force * depth);
        assert!((taken / right - 1.0).abs() < 1e-7, "{taken:e} {right:e}");
    }

    /// An instant in which a damped contact is looked at at its speed is no stop: the dashpots along the surface go on.
    #[test]
    fn an_instant_goes_on_along_the_surface() {
        let line = line(1e-6);
        let depth = RoughContact::new(&line, 1000, 1.0, None).unwrap().bed().heights()[700];
        let mut contact = damped(&line, (&[(3.0, 0.4)], 0.2), None);
        let at = Pose { indentation: depth, slide: 0.0 };
        go(&mut contact, Pose::default(), at, 1.0);
        let (slide, sliding_speed, down) = (0.1 * depth, 0.1 * depth, 1.1 * depth);
        let led = Straight { slide, sliding_speed, ..Straight::between(depth, down, 1.0) };
        contact.follow(&led).unwrap();
        contact.settle().unwrap();
        let before = contact.tangential().unwrap().force;
        let instant = contact.memory().unwrap().instant();
        let to = down + led.speed * instant;
        contact.follow(&Straight { to, duration: instant, ..led }).unwrap();
        contact.settle().unwrap();
        let after = contact.tangential().unwrap();
        assert!(before > 0.0 && (after.force / before - 1.0).abs() < 1e-6, "{before:e} {after:?}");
        assert!((after.slide / slide - 1.0).abs() < 1e-6);
    }

    /// Pieces cut in three are the same pieces.
    #[test]
    fn cuts_do_not_matter_on_rough_rubber() {
        let line = line(1e-6);
        let depth = RoughContact::new(&line, 1000, 1.0, None).unwrap().bed().heights()[700];
        let terms = [(3.0, 0.4), (2.0, 5.0)];
        let (mut whole, mut cut) = (rubbing(&line, &terms, None), rubbing(&line, &terms, None));
        let mut from = Pose::default();
        let mut most: f64 = 0.0;
        for to in poses(depth) {
            go(&mut whole, from, to, 1.0);
            let mut behind = from;
            for (part, over) in [(0.3, 0.3), (0.55, 0.25), (1.0, 0.45)] {
                let between = |from: f64, to: f64| if part < 1.0 { from + part * (to - from) } else { to };
                let there = Pose {
                    indentation: between(from.indentation, to.indentation),
                    slide: between(from.slide, to.slide),
                };
                go(&mut cut, behind, there, over);
                behind = there;
            }
            let (one, two) = (whole.tangential().unwrap(), cut.tangential().unwrap());
            most = most.max(whole.state().force);
            assert!((one.force - two.force).abs() <= 1e-10 * most, "{to:?}: {} {}", one.force, two.force);
            let lost = one.dissipated.unwrap() - two.dissipated.unwrap();
            assert!(lost.abs() <= 1e-10 * most * depth, "{to:?}: {lost:e}");
            from = to;
        }
    }

    /// Roughness that vanishes on a ball that does not relax is Cattaneo's and Mindlin's contact, to the order of the
    /// springs, (a/Δx)⁻¹ = 1e-2 of what slips last.
    #[test]
    fn vanishing_roughness_is_the_rubbing_ball() {
        let ball = Paraboloid { radius: Length::new(1.0).unwrap() };
        let mut contact = rubbing(&line(1e-15), &[], Some(&ball));
        let mut memory = TangentialMemory::new(Arc::new(ball.clone()), GRIP);
        let mut from = Pose::default();
        for (down, along) in [(0.01, 0.0), (0.01, 1e-3), (0.01, -1e-3), (0.012, 5e-4)] {
            let to = Pose { indentation: down, slide: along };
            go(&mut contact, from, to, 1.0);
            memory.advance(to).unwrap();
            let (seen, right) = (contact.tangential().unwrap().force, memory.state().tangential_force);
            assert!((seen - right).abs() < 1e-2 * 0.3 * contact.state().force, "{to:?}: {seen} {right}");
            from = to;
        }
    }
}
