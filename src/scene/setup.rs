//! A scene made ready: what the simulation works with.

use crate::contact::foundation::HalfSpace;
use crate::friction::{Friction, Strength, StrengthCurve};
use crate::input::problem::Problem;
use crate::input::quantity::Length;
use crate::input::table::Tables;
use crate::material::{self, Joined, Pair, Relaxation};
use crate::scene::history::{Entry, Motion};
use crate::scene::rules::Draft;
use crate::scene::stage::Stage;
use crate::scene::surface::{self, Surface};
use crate::scene::{Scene, limits, reach};
use crate::shape::{Family, FlatPunch, Profile};
use std::num::NonZeroUsize;
use std::sync::Arc;

/// A scene whose parts fit together, with its tables read and its effective moduli known.
///
/// Made only by [`Scene::resolve`], so whoever has one need not ask again.
#[derive(Debug, Clone)]
pub struct Setup {
    /// The scene as written.
    pub scene: Scene,
    /// Profile of the indenter.
    pub profile: Arc<dyn Profile>,
    /// Roughness on the profile, if the shape has one.
    pub surface: Option<Surface>,
    /// Effective moduli; instantaneous ones of a viscoelastic pair.
    pub pair: Pair,
    /// E*(t) if one of the bodies is viscoelastic.
    pub relaxation: Option<Relaxation>,
    /// Shear strength over the sliding speed, if the friction names a table.
    pub strength: Option<StrengthCurve>,
    /// The stages of the history.
    pub stages: Vec<Stage>,
}

impl Setup {
    /// Relative error to aim at: the scene's, or 1e-6.
    #[must_use]
    pub fn accuracy(&self) -> f64 {
        self.scene.accuracy.map_or(1e-6, |accuracy| accuracy.si())
    }

    /// What the indenter is pressed into; instantaneous where it relaxes.
    #[must_use]
    pub fn ground(&self) -> HalfSpace {
        HalfSpace::new(self.profile.clone(), self.pair.normal)
    }
}

impl Scene {
    /// The scene with its tables read, or everything that is wrong with it.
    ///
    /// # Errors
    /// Parts that do not fit together, tables that cannot be read: all problems at once, in no
    /// particular order.
    pub fn resolve(self, tables: &dyn Tables) -> Result<Setup, Vec<Problem>> {
        let mut problems = Vec::new();
        let motions = motions(&self.history, tables, &mut problems);
        let steps = self.steps.map(NonZeroUsize::get);
        let numbered = self.history.iter().zip(&motions).enumerate();
        let entries: Vec<_> =
            numbered.map(|(number, (entry, motion))| entry.traits(number, motion.as_ref(), steps)).collect();
        let joined = material::joined(&self.bodies, tables).map_err(|found| problems.extend(found)).ok().flatten();
        let surface = surface::of(&self.shape, tables).map_err(|found| problems.extend(found)).ok();
        let profile = self.profile(surface.as_ref().and_then(Option::as_ref), tables);
        let profile = profile.map_err(|found| problems.extend(found)).ok();
        let strength = strength(self.friction.as_ref(), tables, &mut problems);
        problems.extend(limits::problems(&self, &entries));
        let draft = Draft {
            scene: &self,
            bounds: profile.as_deref().map_or_else(Vec::new, |profile| reach::bounds(profile, self.adhesion.is_some())),
            profile: profile.as_deref(),
            bodies: joined.as_ref(),
            strength: strength.as_ref(),
            entries,
        };
        problems.extend(draft.problems());
        let stages = draft.entries.into_iter().flat_map(|entry| entry.stages).collect();
        match (joined, profile, surface) {
            (Some(Joined { pair, relaxation }), Some(profile), Some(surface)) if problems.is_empty() => {
                Ok(Setup { scene: self, profile, surface, pair, relaxation, strength, stages })
            }
            _ => Err(problems),
        }
    }

    /// The smooth profile: that of the shape, or a flat as wide as a height map.
    fn profile(&self, surface: Option<&Surface>, tables: &dyn Tables) -> Result<Arc<dyn Profile>, Option<Problem>> {
        let problem = |what: String| Some(Problem::new("shape", what));
        let flat = |side: Length| {
            FlatPunch::of_width(side)
                .map(|punch| Arc::new(punch) as Arc<dyn Profile>)
                .map_err(|error| problem(error.to_string()))
        };
        match self.shape.family() {
            Family::Round | Family::Line(_) => self.shape.profile(tables).map_err(|error| problem(error.to_string())),
            Family::Wave(wave) => flat(wave.wavelength),
            Family::Wavy(wavy) => Ok(Arc::new(crate::shape::Paraboloid { radius: wavy.radius })),
            // A map that cannot be read has been refused already.
            Family::Map(..) => {
                let side = surface.ok_or(None)?.length();
                flat(Length::new(side).map_err(|error| problem(error.to_string()))?)
            }
        }
    }
}

/// The table of the shear strength, if the friction names one.
fn strength(friction: Option<&Friction>, tables: &dyn Tables, problems: &mut Vec<Problem>) -> Option<StrengthCurve> {
    let Some(Friction::Pressure(law)) = friction else { return None };
    let Strength::Table(path) = &law.shear else { return None };
    let curve = StrengthCurve::read(path, tables);
    curve.map_err(|error| problems.push(Problem::new("friction.shear", error.to_string()))).ok()
}

fn motions(history: &[Entry], tables: &dyn Tables, problems: &mut Vec<Problem>) -> Vec<Option<Motion>> {
    let mut read = |(index, entry): (usize, &Entry)| {
        let Entry::Table(path) = entry else { return None };
        let motion = Motion::read(path, tables);
        motion.map_err(|error| problems.push(Problem::new(format!("history[{index}]"), error.to_string()))).ok()
    };
    history.iter().enumerate().map(&mut read).collect()
}
