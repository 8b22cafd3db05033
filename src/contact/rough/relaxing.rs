//! A rough line on bodies that relax.
//!
//! # Examples
//! ```
//! use springbed::contact::model::{ContactModel, Straight};
//! use springbed::contact::rough::RelaxingRough;
//! use springbed::material::{Relaxation, Spectrum};
//! use springbed::shape::rough::{Rings, RoughLine, RoughnessSpectrum};
//! use std::sync::Arc;
//!
//! // Held for long, only the equilibrium modulus carries: F = E∞L(d − mean gap) at full contact.
//! let spectrum = RoughnessSpectrum::table(&[(6.4, 1e-12), (64.0, 1e-15)])?;
//! let line = RoughLine::new(&Rings::of(&spectrum, 1.0, 1000)?, 7);
//! let rubber = Relaxation { equilibrium: 1.0, terms: vec![(9.0, 0.1)], viscosity: 0.0 };
//! let mut contact = RelaxingRough::new(&line, 1000, Arc::new(Spectrum::new(&rubber)), None)?;
//! contact.follow(&Straight::between(0.0, 1.0, 1.0))?;
//! let before = contact.state().force;
//! contact.follow(&Straight::between(1.0, 1.0, 10.0))?;
//! assert!(contact.state().force < 0.6 * before && (contact.state().force - 1.0).abs() < 1e-3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::bed::{RoughBed, number};
use super::ends::LineEnds;
use crate::contact::adhesion::line::Energy;
use crate::contact::error::ContactError;
use crate::contact::model::{ContactModel, Effort, Event, Glance, Loading, Straight};
use crate::contact::state::Normal;
use crate::contact::viscoelastic::Spectrum;
use crate::contact::viscoelastic::continuous::in_time;
use crate::contact::viscoelastic::layout::Layout;
use crate::contact::viscoelastic::lazy::Lazy;
use crate::shape::Profile;
use crate::shape::rough::{RoughError, RoughLine};
use std::sync::Arc;

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
        let (ends, width) = (LineEnds::of(line, points, base, bed.first_touch())?, line.length() / number(points));
        Ok(Self { bed: Lazy::new(spectrum, Layout::sorted(bed.heights(), width)), width, ends })
    }

    /// Where its springs stand, sorted by the depths at which they are touched.
    #[must_use]
    pub fn layout(&self) -> &Layout {
        self.bed.layout()
    }

    /// What its springs are made of.
    #[must_use]
    pub fn shared_spectrum(&self) -> Arc<Spectrum> {
        self.bed.shared_spectrum()
    }

    /// Depth [m] that a mass of the kinetic energy `energy` [J] and the speed `speed` [m/s] does not pass on the way in
    /// if nothing relaxes: the lesser of those at which the springs at E(0) alone, or the dashpots alone, take it.
    ///
    /// # Errors
    /// As of [`RoughBed::new`].
    pub fn stopped_at(&self, energy: f64, speed: f64) -> Result<f64, RoughError> {
        let (spectrum, springs) = (self.bed.spectrum(), RoughBed::new(&self.layout().height, self.width)?);
        let elastic = springs.at_energy(energy / spectrum.instantaneous()).indentation;
        Ok(springs.at_force(energy / (spectrum.viscosity() * speed)).indentation.min(elastic))
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
        Some(self.shared_spectrum())
    }

    fn effort(&self) -> Effort {
        self.bed.effort()
    }

    fn leave(&mut self) -> Option<f64> {
        self.bed.leave();
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::rough::RoughContact;
    use crate::shape::rough::{Rings, RoughnessSpectrum};

    fn line() -> RoughLine {
        let spectrum = RoughnessSpectrum::table(&[(6.4, 1e-12), (64.0, 1e-15)]).unwrap();
        RoughLine::new(&Rings::of(&spectrum, 1.0, 1000).unwrap(), 7)
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
        let largest = elastic.bed().heights()[600];
        let full = elastic.bed().full_contact().0;
        let largest_energy = elastic.bed().at_indentation(full).energy;
        for part in [0.3, 1.0, 0.7, 0.1, 0.0, 0.5] {
            let piece = Straight::between(relaxing.bed.indentation(), part * largest, 1.0);
            relaxing.follow(&piece).unwrap();
            elastic.follow(&piece).unwrap();
            let (one, two) = (relaxing.state(), elastic.state());
            assert!((one.force - two.force).abs() <= 1e-12 * elastic.bed().full_contact().1, "{part}");
            assert!((one.stored.elastic - two.stored.elastic).abs() <= 1e-12 * largest_energy);
            assert!(one.dissipated.abs() <= 1e-12 * largest_energy);
        }
    }
}
