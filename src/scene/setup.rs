//! A scene made ready: what the simulation works with.

use crate::contact::adhesion::Adhesion;
use crate::contact::foundation::HalfSpace;
use crate::contact::viscoelastic::Spectrum;
use crate::friction::{Friction, Strength, StrengthCurve};
use crate::input::problem::Problem;
use crate::input::quantity::Length;
use crate::input::table::Tables;
use crate::material::{self, Body, Elastic, Pair, Relaxation};
use crate::scene::Scene;
use crate::scene::history::impacts::{self, Parts};
use crate::scene::history::rules::{self, Allowed};
use crate::scene::history::{Entry, Motion};
use crate::scene::reach::{self, Bound};
use crate::scene::surface::{self, Surface};
use crate::shape::{FlatPunch, Profile, Shape};
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
    /// One per history entry: the table it names, `None` for an entry without.
    pub motions: Vec<Option<Motion>>,
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

    /// The entries of the history in order, each with the motion of its table if it names one.
    pub fn entries(&self) -> impl Iterator<Item = (&Entry, Option<&Motion>)> {
        self.scene.history.iter().zip(self.motions.iter().map(Option::as_ref))
    }
}

impl Scene {
    /// The scene with its tables read, or everything that is wrong with it.
    ///
    /// # Errors
    /// Parts that do not fit together, tables that cannot be read: all problems at once, in no
    /// particular order.
    pub fn resolve(self, tables: &dyn Tables) -> Result<Setup, Vec<Problem>> {
        let mut problems = self.problems();
        let motions = motions(&self.history, tables, &mut problems);
        let pair = material::pair(&self.bodies, tables).map_err(|found| problems.extend(found)).ok();
        let pair = pair.map(|pair| beside_elastic(&self.bodies, pair));
        problems.extend(self.rubbing_in_series());
        let surface = surface::of(&self, tables).map_err(|found| problems.extend(found)).ok();
        let profile = self.profile(surface.as_ref().and_then(Option::as_ref), tables);
        let profile = profile.map_err(|found| problems.extend(found)).ok();
        let strength = strength(self.friction.as_ref(), tables, &mut problems);
        problems.extend(strength.iter().flat_map(|curve| rules::sliding_speeds(&self.history, curve)));
        problems.extend(rules::problems(&self.history, &motions, self.allowed()));
        let adhesion = self.adhesion.as_ref().zip(profile.as_deref());
        problems.extend(adhesion.and_then(|(adhesion, profile)| adhesion.problem_on(&self.shape, profile)));
        if let Some((_, relaxation)) = &pair {
            problems.extend(impacts::problems(&self.history, self.parts(relaxation.is_some())));
        }
        if let Some((pair, relaxation)) = &pair {
            problems.extend(self.adhesion.iter().flat_map(|adhesion| adhesion.problems(relaxation.as_ref())));
            let (adhesion, relaxed) = (self.adhesion.as_ref(), relaxation.as_ref());
            problems.extend(self.rubbing().iter().flat_map(|friction| friction.problems(adhesion, relaxed)));
            if let Some(profile) = &profile {
                let direct = (self.adhesion.is_none() && relaxation.is_none()).then_some(pair.normal);
                let bounds = self.bounds(profile.as_ref());
                problems.extend(reach::problems(&bounds, direct, (&self.history, &motions)));
            }
        }
        match (pair, profile, surface) {
            (Some((pair, relaxation)), Some(profile), Some(surface)) if problems.is_empty() => {
                Ok(Setup { scene: self, profile, surface, pair, relaxation, strength, motions })
            }
            _ => Err(problems),
        }
    }

    /// Friction needs one ratio of tangential and normal stiffness at all times.
    fn rubbing_in_series(&self) -> Option<Problem> {
        self.friction.as_ref().zip(partner(&self.bodies)).map(|_| {
            Problem::new(
                "friction",
                "with a Viscoelastic body against an Elastic body cannot be computed, for the pair is not elastically similar at all times: expected Rigid beside Viscoelastic, or no friction",
            )
        })
    }

    /// The friction, unless the history is an impact, which has its own rules.
    fn rubbing(&self) -> Option<&Friction> {
        self.friction.as_ref().filter(|_| !self.history.iter().any(|entry| matches!(entry, Entry::Impact(_))))
    }

    /// The smooth profile: that of the shape, or a flat as wide as a height map.
    fn profile(&self, surface: Option<&Surface>, tables: &dyn Tables) -> Result<Arc<dyn Profile>, Option<Problem>> {
        let problem = |what: String| Some(Problem::new("shape", what));
        let Shape::HeightMap(..) = &self.shape else {
            return self.shape.profile(tables).map_err(|error| problem(error.to_string()));
        };
        // A map that cannot be read has been refused already.
        let side = surface.ok_or(None)?.length();
        let punch = Length::new(side).and_then(FlatPunch::of_width);
        punch.map(|punch| Arc::new(punch) as Arc<dyn Profile>).map_err(|error| problem(error.to_string()))
    }

    fn parts(&self, relaxes: bool) -> Parts<'_> {
        Parts { shape: &self.shape, adhesion: self.adhesion.as_ref(), relaxes, springs: self.springs.is_some() }
    }

    fn relaxes(&self) -> bool {
        let relaxes = |body: &Body| matches!(body, Body::Viscoelastic(_));
        relaxes(&self.bodies.0) || relaxes(&self.bodies.1)
    }

    fn allowed(&self) -> Allowed {
        Allowed {
            friction: self.friction.as_ref().map(Friction::name),
            relaxing: self.relaxes().then_some("Viscoelastic"),
            adhesion: self.adhesion.as_ref().map(Adhesion::name),
            steps: self.steps.map(NonZeroUsize::get),
        }
    }

    /// How deep the profile can be pressed. With adhesion the contact is held together.
    fn bounds(&self, profile: &dyn Profile) -> Vec<Bound> {
        let second = if self.adhesion.is_none() { reach::second_contact(profile) } else { None };
        second.into_iter().chain(reach::end(profile)).collect()
    }
}

/// The table of the shear strength, if the friction names one.
fn strength(friction: Option<&Friction>, tables: &dyn Tables, problems: &mut Vec<Problem>) -> Option<StrengthCurve> {
    let Some(Friction::Pressure(law)) = friction else { return None };
    let Strength::Table(path) = &law.shear else { return None };
    let curve = StrengthCurve::read(path, tables);
    curve.map_err(|error| problems.push(Problem::new("friction.shear", error.to_string()))).ok()
}

/// The elastic partner of a viscoelastic body.
fn partner(bodies: &(Body, Body)) -> Option<&Elastic> {
    match bodies {
        (Body::Viscoelastic(_), Body::Elastic(partner)) | (Body::Elastic(partner), Body::Viscoelastic(_)) => {
            Some(partner)
        }
        _ => None,
    }
}

/// A viscoelastic and an elastic body: two compliances in series, again a Prony series.
///
/// Each half-space is pressed in by its own 1/E*ᵢ(p) times the same pressure, whatever its ν: the sum is
/// exact for constant ν, in the normal direction and without friction.
fn beside_elastic(bodies: &(Body, Body), (pair, alone): (Pair, Option<Relaxation>)) -> (Pair, Option<Relaxation>) {
    let (Some(partner), Some(relaxation)) = (partner(bodies), &alone) else { return (pair, alone) };
    let both = Spectrum::new(relaxation).in_series_with(partner.plane_modulus()).relaxation_function();
    (Pair { normal: both.instantaneous(), ..pair }, Some(both))
}

fn motions(history: &[Entry], tables: &dyn Tables, problems: &mut Vec<Problem>) -> Vec<Option<Motion>> {
    let mut read = |(index, entry): (usize, &Entry)| {
        let Entry::Table(path) = entry else { return None };
        let motion = Motion::read(path, tables);
        motion.map_err(|error| problems.push(Problem::new(format!("history[{index}]"), error.to_string()))).ok()
    };
    history.iter().enumerate().map(&mut read).collect()
}
