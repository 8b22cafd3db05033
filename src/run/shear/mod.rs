//! The tangential part of a run: what slides, sticks and rubs while the normal contact moves.

mod peeling;
mod relaxing;
mod sliding;
mod springs;
mod sticking;

pub use peeling::sheared;

use super::SimulationError;
use super::contact::{ContactError, NormalContact};
use crate::contact::adhesion::equilibrium::Control;
use crate::contact::state::Normal;
use crate::friction::sliding::Pressed;
use crate::friction::state::Tangential;
use crate::friction::{Coulomb, Friction, Grip, Pose, chords};
use crate::run::record::ErrorEstimate;
use crate::scene::setup::Setup;
use crate::scene::stage::{Path, Stage};
use peeling::Peeling;
use sliding::{Interface, Sliding};
use std::num::NonZeroUsize;

/// A step of the history, seen after the normal contact has taken it.
pub struct Step<'c> {
    /// The normal contact at the end of the step.
    pub contact: &'c dyn NormalContact,
    /// What is prescribed.
    pub control: Control,
    /// Its values at the beginning and the end; between them it is linear in time.
    pub prescribed: (f64, f64),
    /// Tangential displacements at the beginning and the end [m], linear in time too.
    pub slide: (f64, f64),
    /// Sliding speed [m/s].
    pub speed: f64,
    /// Duration [s].
    pub over: f64,
}

/// A tangential contact on top of a normal one.
pub trait TangentialContact {
    /// Follows a step; returns the state at its beginning if that has changed suddenly.
    ///
    /// # Errors
    /// There is no state of the contact at its end.
    fn advance(&mut self, step: &Step<'_>) -> Result<Option<Tangential>, ContactError>;

    /// Told before the normal contact moves.
    fn let_go(&mut self) {}

    /// Present state.
    fn state(&self) -> Tangential;

    /// Shear stress τ [Pa] at the radii `radii` [m]; `None` where it is singular or not known.
    fn stress(&self, contact: &dyn NormalContact, radii: &[f64]) -> Vec<Option<f64>>;

    /// The state of the normal contact under shear, from the one without.
    fn normal(&self, normal: Normal) -> Normal {
        normal
    }

    /// The normal contact under shear, where that changes its pressure.
    fn pressed(&self) -> Option<Pressed> {
        None
    }

    /// Bytes of state, where the plan cannot know them.
    fn bytes(&self) -> usize {
        0
    }

    /// Number of springs of its own.
    fn springs(&self) -> usize {
        0
    }

    /// The straight steps taken so far, if they were kept.
    fn path(&self) -> &[Pose] {
        &[]
    }
}

/// The tangential part a scene needs; `None` without friction.
///
/// `springs` is the number of springs and the half width [m] of the bed, if the scene asks for one;
/// `kept` has room for the path, if it is wanted.
///
/// # Errors
/// The bed of springs is wider than the profile.
pub fn of<'p>(
    setup: &'p Setup,
    springs: Option<(NonZeroUsize, f64)>,
    kept: Option<Vec<Pose>>,
) -> Result<Option<Box<dyn TangentialContact + 'p>>, SimulationError> {
    let law = match (&setup.scene.friction, sheared(setup)) {
        (None, _) => return Ok(None),
        (Some(Friction::Coulomb(law)), _) => law,
        (Some(friction), Some(contact)) => return Ok(Some(Box::new(Peeling::new(contact, setup, friction)))),
        (Some(friction), None) => return Ok(Some(Box::new(Sliding::new(Interface::new(setup, friction))))),
    };
    let grip = grip(setup, law);
    if let Some(relaxation) = &setup.relaxation {
        let bed = relaxing::Relaxing::new(setup, relaxation, grip);
        return Ok(Some(Box::new(bed.map_err(|source| SimulationError::Refused(source.to_string()))?)));
    }
    let accuracy = accuracy(setup);
    Ok(Some(match springs {
        None => Box::new(sticking::Sticking::new((setup.profile.clone(), grip), accuracy, kept)),
        Some(size) => {
            let bed = springs::Springs::new((setup.profile.as_ref(), grip), size, accuracy);
            Box::new(bed.map_err(|source| SimulationError::Refused(source.to_string()))?)
        }
    }))
}

/// How closely a curved path is followed, as a part of the depth.
fn accuracy(setup: &Setup) -> f64 {
    setup.accuracy().clamp(1e-12, 1e-2)
}

/// The error of the tangential contact, where it is not rounding.
#[must_use]
pub fn error_estimate(setup: &Setup) -> Option<ErrorEstimate> {
    let Some(Friction::Coulomb(_)) = &setup.scene.friction else { return None };
    let bed = setup.relaxation.as_ref().map(|_| relaxing::springs(setup)).or(setup.scene.springs);
    if let Some(springs) = bed {
        return Some(ErrorEstimate {
            relative: 17.0 / 16.0 / springs.get() as f64,
            basis: format!("bed of {springs} springs: the tangential force within half a cell of its variation"),
        });
    }
    let curved = |stage: &Stage| stage.control == Some(Control::Force) && stage.tangential != Path::Stay;
    setup.stages.iter().any(curved).then(|| ErrorEstimate {
        relative: accuracy(setup),
        basis: "memory of friction: the depth under a force is a curve, followed by chords to this part".to_owned(),
    })
}

/// Moduli and friction of a scene.
#[must_use]
pub fn grip(setup: &Setup, law: &Coulomb) -> Grip {
    Grip {
        normal_modulus: setup.pair.normal,
        tangential_modulus: setup.pair.tangential,
        coefficient: law.coefficient.si(),
    }
}

impl Step<'_> {
    /// The step as straight ones that start from `from`.
    ///
    /// Under a prescribed depth there is one. Under a prescribed force the depth is a curve in time:
    /// it is replaced by chords within `accuracy` of it, for the memory of friction holds how slide
    /// and depth grew together. A body that comes back under a force first touches where it is.
    fn positions(&self, from: Pose, accuracy: f64) -> Vec<Pose> {
        let end = self.contact.state().indentation.unwrap_or(0.0);
        if self.control == Control::Indentation {
            return vec![Pose { indentation: end, slide: self.slide.1 }];
        }
        let from = Pose { indentation: from.indentation.max(0.0), ..from };
        let depth = |t: f64| match t {
            t if t <= 0.0 => from.indentation,
            t if t >= 1.0 => end,
            t => self.depth(t).unwrap_or(f64::NAN),
        };
        std::iter::once(from).chain(chords(&depth, (self.slide.0, self.slide.1), accuracy)).collect()
    }

    /// Depth [m] at the fraction `t` of a step under a prescribed force. Without adhesion it depends
    /// on the present force alone.
    fn depth(&self, t: f64) -> Option<f64> {
        let mut probe = self.contact.snapshot();
        let force = self.prescribed.0 + t * (self.prescribed.1 - self.prescribed.0);
        probe.advance(Control::Force, force, 0.0).ok()?;
        probe.state().indentation
    }
}
