//! Coulomb friction of viscoelastic bodies in a run: a bed beside the normal contact.

use super::{Step, TangentialContact};
use crate::contact::adhesion::equilibrium::Control;
use crate::contact::viscoelastic::Spectrum;
use crate::friction::state::Tangential;
use crate::friction::{FrictionError, Grip, RelaxingBed};
use crate::material::Relaxation;
use crate::run::contact::{ContactError, NormalContact};
use crate::scene::plan::RoundPlan;
use crate::scene::stage::Path;
use crate::shape::Rim;
use std::num::NonZeroUsize;
use std::sync::Arc;

/// A bed of viscoelastic springs with friction, driven along the depth of the normal contact.
///
/// Exact in time for depth and slide that are straight between records, which is all a scene may ask
/// of it. What springs lose by slip is not told apart from what they lose by relaxing, so that no
/// energy is given.
#[derive(Debug)]
pub struct Relaxing {
    bed: RelaxingBed,
    /// Shortest time in which nothing relaxes [s], for a jump of the depth.
    instant: f64,
    tangential_modulus: f64,
    width: f64,
    slide: f64,
}

impl Relaxing {
    /// A bed just wide enough for the history of the scene, never touched.
    ///
    /// # Errors
    /// The profile ends before the bed.
    #[expect(clippy::cast_precision_loss, reason = "no bed has 2^53 springs")]
    pub fn new(
        plan: &RoundPlan,
        relaxation: &Relaxation,
        grip: Grip,
        springs: NonZeroUsize,
    ) -> Result<Self, FrictionError> {
        let spectrum = Arc::new(Spectrum::new(relaxation));
        let (instant, radius) = (spectrum.instant(), reach(plan));
        let bed = RelaxingBed::new(plan.profile.as_ref(), spectrum, grip, springs, radius)?;
        let width = radius / springs.get() as f64;
        Ok(Self { bed, instant, tangential_modulus: grip.tangential_modulus, width, slide: 0.0 })
    }
}

/// Radius [m] at the largest depth of the history: no spring further out is ever touched.
fn reach(plan: &RoundPlan) -> f64 {
    let depth = |path: Path| if let Path::To(to) = path { to } else { 0.0 };
    let by_depth = |control: Option<Control>| control == Some(Control::Indentation);
    let ramps = plan.stages.iter().filter(|stage| by_depth(stage.control));
    let deepest = ramps.map(|stage| depth(stage.normal)).fold(0.0, f64::max);
    let profile = plan.profile.as_ref();
    let edge = if deepest > 0.0 { profile.edge(deepest) } else { None };
    match profile.rim() {
        Rim::Wall(end) => edge.map_or(end, |edge| edge.min(end)),
        Rim::None | Rim::End(_) => edge.unwrap_or_else(|| profile.scale()),
    }
}

impl TangentialContact for Relaxing {
    fn advance(&mut self, step: &Step<'_>) -> Result<Option<Tangential>, ContactError> {
        let depth = step.contact.state().indentation.unwrap_or(0.0);
        let (down, way) = (depth - self.bed.depth(), step.slide.1 - self.slide);
        self.slide = step.slide.1;
        let over = if step.over > 0.0 { step.over } else { self.instant };
        if step.over > 0.0 || down.abs() > 0.0 || way.abs() > 0.0 {
            self.bed.advance((down / over, way / over), over);
        }
        Ok(None)
    }

    #[expect(clippy::cast_precision_loss, reason = "no bed has 2^53 springs")]
    fn state(&self) -> Tangential {
        let stick_radius = self.bed.held().1 as f64 * self.width;
        Tangential {
            slide: self.slide,
            force: self.bed.forces().1,
            stick_radius,
            stiffness: 2.0 * self.tangential_modulus * stick_radius,
            stored: None,
            dissipated: None,
            area_ratio: None,
        }
    }

    fn bytes(&self) -> usize {
        self.bed.bytes()
    }

    fn springs(&self) -> usize {
        self.bed.springs()
    }

    fn stress(&self, _contact: &dyn NormalContact, radii: &[f64]) -> Vec<Option<f64>> {
        vec![None; radii.len()]
    }
}
