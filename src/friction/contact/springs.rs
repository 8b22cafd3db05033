//! Coulomb friction by the plain bed of springs.

use super::{Step, Sudden, TangentialContact};
use crate::contact::model::{Effort, Pose};
use crate::contact::state::Tangential;
use crate::friction::{CoulombBed, FrettingMap, FrictionError, Grip};
use crate::shape::Profile;
use std::num::NonZeroUsize;

/// The bed of Coulomb springs with the energy each of them loses: the twin of the memory.
#[derive(Debug, Clone)]
pub struct CoulombSprings {
    bed: CoulombBed,
    map: FrettingMap,
    grip: Grip,
    width: f64,
    accuracy: f64,
    at: Pose,
    force: f64,
}

impl CoulombSprings {
    /// A bed of `springs` springs out to `radius` [m], bodies just touching; curved steps are followed to 1e-6.
    ///
    /// # Errors
    /// The profile ends before `radius`.
    pub fn new(profile: &dyn Profile, grip: Grip, springs: NonZeroUsize, radius: f64) -> Result<Self, FrictionError> {
        Ok(Self::of(CoulombBed::new(profile, grip, springs, radius)?, grip, radius / springs.get() as f64))
    }

    /// The springs of a rough line of the width Δx [m] each, sorted by the depths [m] at which they are touched;
    /// bodies just touching.
    #[must_use]
    pub fn sorted(depths: Vec<f64>, grip: Grip, width: f64) -> Self {
        Self::of(CoulombBed::of_depths(depths.into(), grip, 0.5 * width), grip, 0.5 * width)
    }

    fn of(bed: CoulombBed, grip: Grip, width: f64) -> Self {
        let springs = bed.depths().iter().enumerate().map(|(k, &depth)| ((k as f64 + 0.5) * width, depth));
        let map = FrettingMap::of_depths(grip, springs);
        Self { bed, map, grip, width, accuracy: 1e-6, at: Pose::default(), force: 0.0 }
    }

    /// The same with curved steps followed to `accuracy`.
    #[must_use]
    pub fn accurate_to(self, accuracy: f64) -> Self {
        Self { accuracy, ..self }
    }

    /// Number of springs in contact inside the first one that slips.
    fn stuck(&self) -> usize {
        let reach = self.grip.reach();
        let limits = self.bed.depths().iter().map(|depth| reach * (self.at.indentation - depth));
        let limits: Vec<f64> = limits.take_while(|limit| *limit > 0.0).collect();
        // A spring at its limit has been put there, to rounding of the slide.
        let slips = |(v, limit): (f64, &f64)| v.abs() >= (1.0 - 1e-9) * limit;
        let first = self.bed.displacements().into_iter().zip(&limits).position(slips);
        first.unwrap_or(limits.len())
    }
}

impl TangentialContact for CoulombSprings {
    fn follow(&mut self, step: &Step<'_>) -> Result<Vec<Sudden>, FrictionError> {
        let path = step.positions(self.at, self.accuracy);
        for &to in &path {
            self.map.advance(to);
        }
        self.force = self.bed.advance(&path).last().copied().unwrap_or(self.force);
        self.at = path.last().copied().unwrap_or(self.at);
        Ok(Vec::new())
    }

    fn state(&self) -> Tangential {
        let stick_radius = self.stuck() as f64 * self.width;
        let squares: f64 = self.bed.displacements().iter().map(|v| v * v).sum();
        Tangential {
            slide: self.at.slide,
            force: self.force,
            stick_radius,
            stiffness: 2.0 * self.grip.tangential_modulus * stick_radius,
            stored: Some(self.grip.tangential_modulus * self.width * squares),
            dissipated: Some(self.width * self.map.energy().iter().sum::<f64>()),
            area_ratio: None,
        }
    }

    fn copy(&self) -> Box<dyn TangentialContact> {
        Box::new(self.clone())
    }

    fn effort(&self) -> Effort {
        Effort { springs: self.bed.depths().len(), ..Effort::default() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::model::{ContactModel, Straight};
    use crate::contact::rough::RoughContact;
    use crate::friction::contact::FrictionalContact;
    use crate::shape::rough::{Rings, RoughLine, RoughnessSpectrum};

    /// A rough line that has only been pressed and then slid: F_x = μ[F(d) − F(d − u_x/m)], m = μE*/G* (Ciavarella,
    /// Jäger), as on any bed. Bound: rounding of a thousand springs.
    #[test]
    fn the_first_slide_on_a_rough_line() {
        let spectrum = RoughnessSpectrum::table(&[(6.4, 1e-12), (64.0, 1e-15)]).unwrap();
        let line = RoughLine::new(&Rings::of(&spectrum, 1.0, 1000).unwrap(), 7);
        let elastic = RoughContact::new(&line, 1000, 2.5, None).unwrap();
        let bed = elastic.bed().clone();
        let depth = bed.heights()[700];
        let grip = Grip { normal_modulus: 2.5, tangential_modulus: 2.0, coefficient: 0.3 };
        let springs = CoulombSprings::sorted(bed.heights(), grip, 1e-3);
        let mut contact = FrictionalContact::new(Box::new(elastic), Box::new(springs));
        contact.follow(&Straight::between(0.0, depth, 1.0)).unwrap();
        let force = |d: f64| bed.at_indentation(bed.first_touch() + d).force;
        for k in 1..=10 {
            let part = 0.1 * f64::from(k);
            let slide = part * depth * grip.reach();
            contact.follow(&Straight { slide, ..Straight::between(depth, depth, 1.0) }).unwrap();
            let right = 0.3 * (force(depth) - force(depth * (1.0 - part)));
            assert!((contact.tangential().unwrap().force - right).abs() <= 1e-12 * force(depth), "{k}");
        }
    }
}
