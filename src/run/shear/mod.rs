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
use crate::friction::{FrictionError, Pose, chords};
use crate::run::record::ErrorEstimate;
use crate::scene::law::FrictionLaw;
use crate::scene::plan::RoundPlan;
use crate::scene::stage::{Path, Stage};
use peeling::Peeling;
use sliding::Sliding;

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

/// The tangential part a scene needs.
///
/// `bed_radius` is the half width [m] of the bed of springs under the normal contact, if it has one;
/// `kept` has room for the path, if it is wanted.
///
/// # Errors
/// The bed of springs is wider than the profile.
pub fn of<'p>(
    plan: &RoundPlan,
    law: &'p FrictionLaw,
    bed_radius: f64,
    kept: Option<Vec<Pose>>,
) -> Result<Box<dyn TangentialContact + 'p>, SimulationError> {
    let refused = |source: FrictionError| SimulationError::Refused(source.to_string());
    Ok(match law {
        FrictionLaw::Memory { coefficient } => {
            Box::new(sticking::Sticking::new((plan.profile.clone(), plan.grip(*coefficient)), accuracy(plan), kept))
        }
        FrictionLaw::Springs { coefficient, count } => {
            let on = (plan.profile.as_ref(), plan.grip(*coefficient));
            Box::new(springs::Springs::new(on, (*count, bed_radius), accuracy(plan)).map_err(refused)?)
        }
        FrictionLaw::Viscoelastic { coefficient, count, relaxation } => {
            let bed = relaxing::Relaxing::new(plan, relaxation, plan.grip(*coefficient), *count);
            Box::new(bed.map_err(refused)?)
        }
        FrictionLaw::Sliding(interface) => Box::new(Sliding::new(plan.ground(), interface)),
        FrictionLaw::Peeling { interface, work } => Box::new(Peeling::new(peeling::contact(plan, *work), interface)),
    })
}

/// How closely a curved path is followed, as a part of the depth.
fn accuracy(plan: &RoundPlan) -> f64 {
    plan.accuracy().clamp(1e-12, 1e-2)
}

/// The error of the tangential contact, where it is not rounding.
#[must_use]
pub fn error_estimate(plan: &RoundPlan, law: &FrictionLaw) -> Option<ErrorEstimate> {
    match law {
        FrictionLaw::Springs { count, .. } | FrictionLaw::Viscoelastic { count, .. } => Some(ErrorEstimate {
            relative: 17.0 / 16.0 / count.get() as f64,
            basis: format!("bed of {count} springs: the tangential force within half a cell of its variation"),
        }),
        FrictionLaw::Memory { .. } => {
            let curved = |stage: &Stage| stage.control == Some(Control::Force) && stage.tangential != Path::Stay;
            plan.stages.iter().any(curved).then(|| ErrorEstimate {
                relative: accuracy(plan),
                basis: "memory of friction: the depth under a force is a curve, followed by chords to this part"
                    .to_owned(),
            })
        }
        FrictionLaw::Sliding(_) | FrictionLaw::Peeling { .. } => None,
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
