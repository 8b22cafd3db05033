//! Contacts for a program of one's own: owned, cloned at will, sent between threads.
//!
//! ```
//! use springbed::prelude::*;
//!
//! // A cone of the slope 0.2 on a body of E* = 1 GPa, pressed to 1 µm: F = 2E*d²/(π tan θ).
//! let mut tip = Contact::cone(0.2)?.elastic(1e9)?;
//! tip.advance(1e-6, 0.0)?;
//! assert!((tip.force() / (2e9 * 1e-12 / (0.2 * std::f64::consts::PI)) - 1.0).abs() < 1e-14);
//! // Bad numbers are errors.
//! assert!(Contact::sphere(-1.0).is_err() && tip.advance(f64::NAN, 0.0).is_err());
//! # Ok::<(), LibraryError>(())
//! ```

use crate::contact::adhesion::equilibrium::BranchError;
use crate::contact::adhesion::line::EdgeLine;
use crate::contact::adhesion::range::RangeDisc;
use crate::contact::direct::{ElasticAttraction, Jump, QuasiStatic};
use crate::contact::error::BedError;
use crate::contact::foundation::Foundation;
use crate::contact::loaded::Loaded;
use crate::contact::viscoelastic::Spectrum;
use crate::contact::viscoelastic::memory::Memory;
use crate::friction::{FrictionError, Grip, Pose, TangentialMemory};
use crate::input::quantity::{
    Amplitude, Displacement, Duration, Force, Length, Modulus, Positive, QuantityError, Ratio, Stress, Viscosity,
    WorkOfAdhesion,
};
use crate::material::Relaxation;
use crate::numerics::root::RootError;
use crate::shape::{Cone, Paraboloid, Profile, Rim, Sphere};
use std::sync::Arc;

/// Why a contact cannot be made or moved.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum LibraryError {
    /// A number out of the range that makes sense for it.
    #[error(transparent)]
    Quantity(#[from] QuantityError),
    /// Parts that cannot be computed together.
    #[error("{one} with {other} cannot be computed{because}")]
    Pair {
        /// First part.
        one: &'static str,
        /// Second part.
        other: &'static str,
        /// Why, and what would be right.
        because: &'static str,
    },
    /// No equilibrium of the elastic contact.
    #[error(transparent)]
    Branch(#[from] BranchError),
    /// An attraction of finite range that finds no touch.
    #[error(transparent)]
    Range(#[from] RootError),
    /// The viscoelastic contact outgrows its profile.
    #[error(transparent)]
    Bed(#[from] BedError),
    /// No state of the tangential contact.
    #[error(transparent)]
    Friction(#[from] FrictionError),
}

/// A shape that is not pressed into anything yet.
#[derive(Debug, Clone)]
pub struct Indenter {
    profile: Arc<dyn Profile>,
}

impl Indenter {
    /// On elastic bodies of the effective modulus `modulus` E* [Pa], 1/E* = (1−ν₁²)/E₁ + (1−ν₂²)/E₂.
    ///
    /// # Errors
    /// The modulus is not above zero.
    pub fn elastic(self, modulus: f64) -> Result<Contact, LibraryError> {
        let ground = Foundation::new(self.profile, Modulus::new(modulus)?.si());
        Ok(Contact::from(Material::Elastic(QuasiStatic::new(EdgeLine::new(ground, 0.0)))))
    }

    /// On viscoelastic bodies of the effective modulus E*(t).
    ///
    /// # Errors
    /// A modulus below zero, a time not above zero, or nothing that carries a load.
    pub fn viscoelastic(self, relaxation: &Relaxation) -> Result<Contact, LibraryError> {
        Stress::new(relaxation.equilibrium)?;
        Viscosity::new(relaxation.viscosity)?;
        for &(modulus, time) in &relaxation.terms {
            Modulus::new(modulus)?;
            Duration::new(time)?;
        }
        if relaxation.terms.is_empty() && relaxation.viscosity <= 0.0 {
            Modulus::new(relaxation.equilibrium)?;
        }
        let bed = Memory::new(Arc::new(Spectrum::new(relaxation)), self.profile);
        Ok(Contact::from(Material::Viscoelastic(bed)))
    }
}

/// What follows the depth.
#[derive(Debug, Clone)]
enum Material {
    Elastic(QuasiStatic),
    Viscoelastic(Memory),
}

/// A contact that is driven by depth or force.
///
/// Made from a shape, a material and what else acts, each checked as it is given:
/// `Contact::sphere(r)?.elastic(e)?.jkr(w)?`. A contact that is only touched carries nothing.
#[derive(Debug, Clone)]
pub struct Contact {
    material: Material,
    friction: Option<TangentialMemory>,
}

impl From<Material> for Contact {
    fn from(material: Material) -> Self {
        Self { material, friction: None }
    }
}

impl Contact {
    /// A sphere of the radius `radius` R [m].
    ///
    /// # Errors
    /// The radius is not above zero.
    pub fn sphere(radius: f64) -> Result<Indenter, LibraryError> {
        Ok(Self::of(Arc::new(Sphere { radius: Length::new(radius)? })))
    }

    /// A paraboloid of the radius of curvature `radius` R [m], f = r²/2R.
    ///
    /// # Errors
    /// The radius is not above zero.
    pub fn paraboloid(radius: f64) -> Result<Indenter, LibraryError> {
        Ok(Self::of(Arc::new(Paraboloid { radius: Length::new(radius)? })))
    }

    /// A cone, f = r·`slope`.
    ///
    /// # Errors
    /// The slope is not above zero.
    pub fn cone(slope: f64) -> Result<Indenter, LibraryError> {
        Ok(Self::of(Arc::new(Cone { slope: Positive::new(slope)? })))
    }

    /// Any profile, one of [`shape`](crate::shape) or of one's own.
    #[must_use]
    pub fn of(profile: Arc<dyn Profile>) -> Indenter {
        Indenter { profile }
    }

    /// The same bodies, untouched, with an attraction of vanishing range and the work of adhesion `work` [J/m²]
    /// (Johnson, Kendall & Roberts).
    ///
    /// # Errors
    /// The work is below zero; the bodies are viscoelastic or rub.
    pub fn jkr(self, work: f64) -> Result<Self, LibraryError> {
        let work = WorkOfAdhesion::new(work)?.si();
        let ground = self.ground_for("adhesion")?;
        Ok(Self::from(Material::Elastic(QuasiStatic::new(EdgeLine::new(ground, work)))))
    }

    /// The same bodies, untouched at d = 0, with the work of adhesion `work` w [J/m²] and the attractive stress
    /// `stress` σ₀ [Pa] up to the gap w/σ₀ (Maugis).
    ///
    /// # Errors
    /// Work or stress is not above zero; the bodies are viscoelastic or rub; the shape has a wall or waves.
    pub fn maugis(self, work: f64, stress: f64) -> Result<Self, LibraryError> {
        // As a plain number a work is held above zero.
        let (work, stress) = (Positive::new(work)?.si(), Modulus::new(stress)?.si());
        let ground = self.ground_for("adhesion")?;
        if matches!(ground.profile().rim(), Rim::Wall(_)) || ground.profile().feature().is_some() {
            let because = ": the gap must grow all the way; expected jkr(work)";
            return Err(LibraryError::Pair { one: "an attraction of finite range", other: "a wall or waves", because });
        }
        let mut contact = QuasiStatic::new(RangeDisc::new(ground, work, stress)?);
        contact.indent(0.0)?;
        Ok(Self::from(Material::Elastic(contact.without_losses())))
    }

    /// The same bodies, untouched, with Coulomb friction `coefficient` μ and the tangential modulus
    /// `tangential_modulus` G* [Pa], 1/G* = (2−ν₁)/4G₁ + (2−ν₂)/4G₂.
    ///
    /// # Errors
    /// The modulus is not above zero or μ below it; the bodies are viscoelastic or attract each other.
    pub fn coulomb(self, tangential_modulus: f64, coefficient: f64) -> Result<Self, LibraryError> {
        let tangential_modulus = Modulus::new(tangential_modulus)?.si();
        let coefficient = Ratio::new(coefficient)?.si();
        if self.is_adhesive() {
            let because = ": expected one of them";
            return Err(LibraryError::Pair { one: "Coulomb friction", other: "adhesion", because });
        }
        let ground = self.ground_for("Coulomb friction")?;
        let grip = Grip { normal_modulus: ground.modulus(), tangential_modulus, coefficient };
        let friction = Some(TangentialMemory::new(ground.shared_profile(), grip));
        Ok(Self { material: Material::Elastic(QuasiStatic::new(EdgeLine::new(ground, 0.0))), friction })
    }

    fn is_adhesive(&self) -> bool {
        match &self.material {
            Material::Elastic(contact) => match contact.attraction() {
                ElasticAttraction::Line(line) => line.work() > 0.0,
                ElasticAttraction::Outside(_) | ElasticAttraction::Range(_) => true,
            },
            Material::Viscoelastic(_) => false,
        }
    }

    /// The half-space of elastic bodies that do not rub.
    fn ground_for(&self, part: &'static str) -> Result<Foundation, LibraryError> {
        let refused = |other, because| Err(LibraryError::Pair { one: part, other, because });
        match &self.material {
            Material::Viscoelastic(_) => refused("viscoelastic bodies", " here: run a scene"),
            Material::Elastic(_) if self.friction.is_some() => refused("Coulomb friction", ": expected one of them"),
            Material::Elastic(contact) => Ok(contact.ground().clone()),
        }
    }

    /// Moves at once on a straight line to the indentation `depth` [m] and the tangential displacement `slide` [m];
    /// the jumps of the edge on the way, in order.
    ///
    /// # Errors
    /// No finite numbers; the contact would leave its profile; a dashpot would need an infinite force.
    pub fn advance(&mut self, depth: f64, slide: f64) -> Result<Vec<Jump>, LibraryError> {
        self.advance_over(depth, slide, 0.0)
    }

    /// The same in the time `seconds` [s], which only viscoelastic bodies feel.
    ///
    /// # Errors
    /// As [`advance`](Self::advance); the time is below zero.
    pub fn advance_over(&mut self, depth: f64, slide: f64, seconds: f64) -> Result<Vec<Jump>, LibraryError> {
        let (indentation, slide) = (Displacement::new(depth)?.si(), Displacement::new(slide)?.si());
        // As a plain number a time may be zero.
        let seconds = Ratio::new(seconds)?.si();
        if let Some(friction) = &mut self.friction {
            friction.advance(Pose { indentation, slide })?;
        }
        match &mut self.material {
            Material::Elastic(contact) => Ok(contact.indent(indentation)?),
            Material::Viscoelastic(bed) => {
                let spectrum = bed.spectrum();
                if seconds <= 0.0 && spectrum.viscosity() > 0.0 {
                    let because = ": nothing gives at once; expected advance_over(depth, slide, seconds)";
                    return Err(LibraryError::Pair { one: "a jump of the depth", other: "a viscosity", because });
                }
                bed.reach(indentation, seconds.max(spectrum.instant()))?;
                Ok(Vec::new())
            }
        }
    }

    /// Moves at once to the normal force `force` [N], nothing sliding; the jumps of the edge on the way, in order.
    ///
    /// # Errors
    /// No finite number; no state carries the force; the bodies are viscoelastic.
    pub fn press(&mut self, force: f64) -> Result<Vec<Jump>, LibraryError> {
        let force = Force::new(force)?.si();
        let Material::Elastic(contact) = &mut self.material else {
            let because = " here: run a scene with Press, or advance_over a depth";
            return Err(LibraryError::Pair { one: "a prescribed force", other: "viscoelastic bodies", because });
        };
        let jumps = contact.press(force)?;
        if let Some(friction) = &mut self.friction {
            let present = contact.present();
            let indentation = if present.joined { present.balance.indentation } else { 0.0 };
            friction.advance(Pose { indentation, slide: friction.position().slide })?;
        }
        Ok(jumps)
    }

    /// Whether the bodies touch or attract each other.
    #[must_use]
    pub fn is_joined(&self) -> bool {
        match &self.material {
            Material::Elastic(contact) => contact.present().joined,
            Material::Viscoelastic(bed) => bed.radius() > 0.0,
        }
    }

    /// Indentation [m]; `None` where a pull has parted the bodies.
    #[must_use]
    pub fn indentation(&self) -> Option<f64> {
        match &self.material {
            Material::Elastic(contact) => Some(contact.present().balance.indentation).filter(|d| !d.is_nan()),
            Material::Viscoelastic(bed) => Some(bed.indentation()),
        }
    }

    /// Normal force [N].
    #[must_use]
    pub fn force(&self) -> f64 {
        match &self.material {
            Material::Elastic(contact) => contact.present().balance.force,
            Material::Viscoelastic(bed) => bed.force(),
        }
    }

    /// Tangential force [N]; zero without friction.
    #[must_use]
    pub fn tangential_force(&self) -> f64 {
        self.friction.as_ref().map_or(0.0, |friction| friction.state().tangential_force)
    }

    /// Contact radius [m].
    #[must_use]
    pub fn contact_radius(&self) -> f64 {
        match &self.material {
            Material::Elastic(contact) => contact.present().balance.contact_radius,
            Material::Viscoelastic(bed) => bed.radius(),
        }
    }

    /// Radius of stick [m]: of the whole contact without friction.
    #[must_use]
    pub fn stick_radius(&self) -> f64 {
        self.friction.as_ref().map_or_else(|| self.contact_radius(), |friction| friction.state().stick_radius)
    }

    /// Stiffness dF/dd [N/m] at constant contact radius, against a sudden step of the depth.
    #[must_use]
    pub fn stiffness(&self) -> f64 {
        match &self.material {
            Material::Elastic(contact) => contact.stiffness(),
            Material::Viscoelastic(bed) => bed.stiffness(),
        }
    }

    /// The contact as it is now, under its load: fields over the radius and below the surface.
    #[must_use]
    pub fn loaded(&self) -> Loaded {
        match &self.material {
            Material::Elastic(contact) => contact.loaded(),
            Material::Viscoelastic(bed) => bed.loaded(),
        }
    }

    /// Pressure [Pa] at the radius `r` [m]; infinite at an edge that carries a load and under a point.
    ///
    /// # Errors
    /// The radius is below zero or no number.
    pub fn pressure(&self, r: f64) -> Result<f64, LibraryError> {
        Ok(self.loaded().pressure(Amplitude::new(r)?.si()))
    }

    /// Stored energy [J]: elastic, of the surfaces, and of the tangential deformation.
    #[must_use]
    pub fn stored(&self) -> f64 {
        let tangential = self.friction.as_ref().map_or(0.0, TangentialMemory::stored);
        tangential
            + match &self.material {
                Material::Elastic(contact) => contact.energy().stored(),
                Material::Viscoelastic(bed) => bed.ledger().stored,
            }
    }

    /// Energy lost so far [J], in jumps, by friction or in the material.
    #[must_use]
    pub fn dissipated(&self) -> f64 {
        let rubbed = self.friction.as_ref().map_or(0.0, |friction| friction.state().dissipated);
        rubbed
            + match &self.material {
                Material::Elastic(contact) => contact.dissipated(),
                Material::Viscoelastic(bed) => bed.ledger().dissipated,
            }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn held<T: Clone + Send + Sync + 'static>() {}

    #[test]
    fn a_host_language_can_hold_it() {
        held::<Contact>();
        held::<Indenter>();
        held::<Loaded>();
    }

    #[test]
    fn what_makes_no_contact_is_refused_in_words() {
        let ball = || Contact::paraboloid(1.0).unwrap();
        let relaxation =
            |equilibrium, terms: &[(f64, f64)]| Relaxation { equilibrium, terms: terms.to_vec(), viscosity: 0.0 };
        for bad in [
            Contact::sphere(f64::NAN).and_then(|shape| shape.elastic(1.0)),
            Contact::cone(0.0).and_then(|shape| shape.elastic(1.0)),
            ball().elastic(f64::INFINITY),
            ball().elastic(1.0).and_then(|contact| contact.jkr(-1.0)),
            ball().elastic(1.0).and_then(|contact| contact.maugis(1.0, 0.0)),
            ball().elastic(1.0).and_then(|contact| contact.jkr(1.0)?.coulomb(1.0, 0.3)),
            ball().elastic(1.0).and_then(|contact| contact.coulomb(1.0, 0.3)?.jkr(1.0)),
            ball().viscoelastic(&relaxation(0.0, &[])),
            ball().viscoelastic(&relaxation(1.0, &[(1.0, -1.0)])),
            ball().viscoelastic(&relaxation(1.0, &[])).and_then(|contact| contact.jkr(1.0)),
        ] {
            assert!(!bad.unwrap_err().to_string().is_empty());
        }
        let mut contact = Contact::sphere(1.0).unwrap().elastic(1.0).unwrap();
        assert!(contact.advance(f64::NAN, 0.0).is_err() && contact.press(f64::INFINITY).is_err());
        assert!(contact.advance_over(0.1, 0.0, -1.0).is_err());
        assert!(!contact.is_joined());
    }

    /// A pull parts bodies without adhesion; friction forgets with them.
    #[test]
    fn parted_bodies_carry_nothing() {
        let mut contact = Contact::paraboloid(1.0).unwrap().elastic(1.0).unwrap().coulomb(1.0, 0.3).unwrap();
        contact.press(4.0 / 3.0).unwrap();
        contact.advance(1.0, 0.2).unwrap();
        assert!(contact.tangential_force() > 0.3 && contact.stick_radius() < 1.0);
        contact.press(-1.0).unwrap();
        assert!(contact.force() == 0.0 && contact.tangential_force() == 0.0 && contact.indentation().is_none());
        assert!(contact.dissipated() > 0.0);
    }
}
