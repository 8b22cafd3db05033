//! From a scene as written to the decision who computes it.

use super::law::{ContactLaw, ElasticAdhesion, FrictionLaw, HeldEdge, ImpactLaw, Interface, SpringCount};
use super::plan::{CappedCoulomb, ImpactPlan, Plan, PlanePlan, RoughPlan, RoundPlan, SceneSettings, Section, Shared};
use super::rules::Draft;
use super::surface::{self, Surface};
use super::{Scene, limits, reach};
use crate::contact::adhesion::{Adhesion, Range};
use crate::friction::oblique::{Ball, SOLID};
use crate::friction::{Friction, Slip, Strength, StrengthCurve};
use crate::input::problem::Problem;
use crate::input::table::Tables;
use crate::material::{self, Joined, Relaxation};
use crate::scene::history::{Entry, EntryTraits, Impact, Motion};
use crate::shape::{Family, PlaneWave, PlaneWavy, Profile, RoughShape, Shape};
use std::num::NonZeroUsize;
use std::sync::Arc;

/// Springs of the friction of viscoelastic bodies unless the scene says otherwise.
const FRICTION_SPRINGS: NonZeroUsize = NonZeroUsize::MIN.saturating_add(999);

/// The parts of a scene with their tables read; a part is missing where it cannot be read.
#[derive(Debug)]
pub(super) struct Read {
    joined: Option<Joined>,
    relaxation: Option<Arc<Relaxation>>,
    geometry: Option<Geometry>,
    strength: Option<Arc<StrengthCurve>>,
    /// One per history entry: the table it names.
    motions: Vec<Option<Motion>>,
}

impl Scene {
    /// The scene with its tables read and decided, or everything that is wrong with it.
    ///
    /// # Errors
    /// Parts that do not fit together, tables that cannot be read: all problems at once, in no
    /// particular order.
    pub fn resolve(self, tables: &dyn Tables) -> Result<Plan, Vec<Problem>> {
        let mut problems = Vec::new();
        let read = Read::of(&self, tables, &mut problems);
        decided(self, Arc::new(read), problems)
    }
}

impl Plan {
    /// The same scene with other settings.
    ///
    /// # Errors
    /// The parts do not fit together under them.
    pub fn with(&self, settings: SceneSettings) -> Result<Self, Vec<Problem>> {
        let SceneSettings { accuracy, springs, steps } = settings;
        let scene = Scene { accuracy, springs, steps, ..self.scene.clone() };
        decided(scene, self.read.clone(), Vec::new())
    }
}

impl Read {
    fn of(scene: &Scene, tables: &dyn Tables, problems: &mut Vec<Problem>) -> Self {
        let joined = material::joined(&scene.bodies, tables).map_err(|found| problems.extend(found)).ok().flatten();
        Self {
            relaxation: joined.as_ref().and_then(|joined| joined.relaxation.clone()).map(Arc::new),
            joined,
            geometry: Geometry::of(&scene.shape, tables).map_err(|found| problems.extend(found)).ok(),
            strength: strength(scene.friction.as_ref(), tables).map_err(|found| problems.push(found)).ok().flatten(),
            motions: motions(&scene.history, tables, problems),
        }
    }
}

/// What is pressed, ready for evaluation.
#[derive(Debug)]
enum Geometry {
    Round(Arc<dyn Profile>),
    /// Roughness, on a smooth profile if not on a flat.
    Rough(Arc<Surface>, Option<Arc<dyn Profile>>),
    Wave(PlaneWave),
    Wavy(PlaneWavy),
}

impl Geometry {
    fn of(shape: &Shape, tables: &dyn Tables) -> Result<Self, Vec<Problem>> {
        let rough = |surface, base| Self::Rough(Arc::new(surface), base);
        Ok(match shape.family() {
            Family::Round => Self::Round(profile(shape, tables)?),
            Family::Line(line) => rough(surface::of_line(line, tables)?, base(line, tables)?),
            Family::Map(path, pixel) => rough(surface::of_map(path, pixel, tables)?, None),
            Family::Wave(wave) => Self::Wave(wave.clone()),
            Family::Wavy(wavy) => Self::Wavy(wavy.clone()),
        })
    }

    /// The smooth profile over a radius.
    fn profile(&self) -> Option<&dyn Profile> {
        match self {
            Self::Round(profile) => Some(profile.as_ref()),
            Self::Rough(_, base) => base.as_deref(),
            Self::Wave(_) | Self::Wavy(_) => None,
        }
    }
}

fn profile(shape: &Shape, tables: &dyn Tables) -> Result<Arc<dyn Profile>, Vec<Problem>> {
    shape.profile(tables).map_err(|error| vec![Problem::new("shape", error.to_string())])
}

/// The smooth shape under a rough line.
fn base(line: &RoughShape, tables: &dyn Tables) -> Result<Option<Arc<dyn Profile>>, Vec<Problem>> {
    line.base.as_deref().map(|base| profile(base, tables)).transpose()
}

/// The table of the shear strength, if the friction names one.
fn strength(friction: Option<&Friction>, tables: &dyn Tables) -> Result<Option<Arc<StrengthCurve>>, Problem> {
    let Some(Friction::Pressure(law)) = friction else { return Ok(None) };
    let Strength::Table(path) = &law.shear else { return Ok(None) };
    let curve = StrengthCurve::read(path, tables);
    curve.map(Arc::new).map(Some).map_err(|error| Problem::new("friction.shear", error.to_string()))
}

fn motions(history: &[Entry], tables: &dyn Tables, problems: &mut Vec<Problem>) -> Vec<Option<Motion>> {
    let mut read = |(index, entry): (usize, &Entry)| {
        let Entry::Table(path) = entry else { return None };
        let motion = Motion::read(path, tables);
        motion.map_err(|error| problems.push(Problem::new(format!("history[{index}]"), error.to_string()))).ok()
    };
    history.iter().enumerate().map(&mut read).collect()
}

/// The decision, if nothing is wrong with the parts of the scene by themselves or held against each other.
fn decided(scene: Scene, read: Arc<Read>, mut problems: Vec<Problem>) -> Result<Plan, Vec<Problem>> {
    let entries = entries(&scene, &read);
    problems.extend(limits::problems(&scene, &entries));
    let profile = read.geometry.as_ref().and_then(Geometry::profile);
    let adheres = scene.adhesion.is_some();
    let draft = Draft {
        scene: &scene,
        entries,
        profile,
        bounds: profile.map_or_else(Vec::new, |profile| reach::bounds(profile, adheres)),
        bodies: read.joined.as_ref(),
        strength: read.strength.as_deref(),
    };
    problems.extend(draft.problems());
    let impact = draft.entries.iter().find_map(|entry| entry.impact.cloned());
    let stages = draft.entries.into_iter().flat_map(|entry| entry.stages).collect();
    match (&read.joined, &read.geometry) {
        (Some(joined), Some(geometry)) if problems.is_empty() => {
            let shared = Shared { pair: joined.pair, scene, stages, read: read.clone() };
            Ok(kind(shared, geometry, impact))
        }
        _ => Err(problems),
    }
}

fn entries<'s>(scene: &'s Scene, read: &'s Read) -> Vec<EntryTraits<'s>> {
    let steps = scene.steps.map(NonZeroUsize::get);
    let numbered = scene.history.iter().zip(&read.motions).enumerate();
    numbered.map(|(number, (entry, motion))| entry.traits(number, motion.as_ref(), steps)).collect()
}

/// The kind of plan: every kind of scene and every law is named here once.
fn kind(shared: Shared, geometry: &Geometry, impact: Option<Impact>) -> Plan {
    match (geometry, impact) {
        (Geometry::Round(profile), Some(impact)) => Plan::Impact(struck(shared, profile.clone(), impact)),
        (Geometry::Round(profile), None) => Plan::Round(round(shared, profile.clone())),
        (Geometry::Rough(surface, base), _) => {
            Plan::Rough(RoughPlan { surface: surface.clone(), base: base.clone(), shared })
        }
        (Geometry::Wave(wave), _) => {
            let section = Section::Wave { wave: wave.clone(), sliding: sliding(shared.scene.friction.as_ref()) };
            Plan::Plane(PlanePlan { section, shared })
        }
        (Geometry::Wavy(wavy), _) => Plan::Plane(PlanePlan { section: Section::Wavy(wavy.clone()), shared }),
    }
}

fn round(shared: Shared, profile: Arc<dyn Profile>) -> RoundPlan {
    let scene = &shared.scene;
    let adhesion = scene.adhesion.as_ref();
    let contact = match (shared.read.relaxation.clone(), scene.springs) {
        (None, None) => ContactLaw::Direct(elastic(adhesion)),
        (None, Some(count)) => ContactLaw::Springs { count, work: adhesion.map(|adhesion| adhesion.traits().work) },
        (Some(relaxation), asked) => viscoelastic(&shared, relaxation, asked),
    };
    let friction = scene.friction.as_ref().map(|friction| tangential(&shared, friction));
    RoundPlan { profile, contact, friction, shared }
}

fn elastic(adhesion: Option<&Adhesion>) -> ElasticAdhesion {
    match adhesion {
        None => ElasticAdhesion::None,
        Some(Adhesion::Jkr(jkr)) => ElasticAdhesion::Vanishing { work: jkr.work.si() },
        Some(Adhesion::Maugis(maugis)) => {
            ElasticAdhesion::Finite { work: maugis.work.si(), stress: maugis.stress.si() }
        }
    }
}

/// The continuous bed, unless springs are asked for or the depth goes in very many pieces without adhesion.
fn viscoelastic(shared: &Shared, relaxation: Arc<Relaxation>, asked: Option<NonZeroUsize>) -> ContactLaw {
    let edge = held_edge(shared.scene.adhesion.as_ref());
    let needed = (edge.is_none() && shared.is_curved()).then(|| SpringCount::of_accuracy(shared.accuracy()));
    match asked.map(SpringCount::Asked).or(needed) {
        Some(count) => ContactLaw::ViscoelasticSprings { relaxation, count },
        None => ContactLaw::Continuous { relaxation, edge },
    }
}

fn held_edge(adhesion: Option<&Adhesion>) -> Option<HeldEdge> {
    let adhesion = adhesion?.traits();
    match adhesion.range {
        Range::Vanishing(edge) => edge.map(|edge| HeldEdge { work: adhesion.work, edge: edge.clone() }),
        Range::Finite => None,
    }
}

fn tangential(shared: &Shared, friction: &Friction) -> FrictionLaw {
    let springs = shared.scene.springs;
    let coefficient = match friction.slip() {
        Slip::Local(law) => law.coefficient.si(),
        Slip::Gross => return gross(shared, friction),
    };
    match (shared.read.relaxation.clone(), springs) {
        (None, None) => FrictionLaw::Memory { coefficient },
        (None, Some(count)) => FrictionLaw::Springs { coefficient, count },
        (Some(relaxation), asked) => {
            FrictionLaw::Viscoelastic { coefficient, count: asked.unwrap_or(FRICTION_SPRINGS), relaxation }
        }
    }
}

fn gross(shared: &Shared, friction: &Friction) -> FrictionLaw {
    let interface = Interface { friction: friction.clone(), strength: shared.read.strength.clone() };
    match &shared.scene.adhesion {
        None => FrictionLaw::Sliding(interface),
        Some(adhesion) => FrictionLaw::Peeling { interface, work: adhesion.traits().work },
    }
}

fn sliding(friction: Option<&Friction>) -> Option<CappedCoulomb> {
    match friction? {
        Friction::Coulomb(law) => Some(CappedCoulomb { coefficient: law.coefficient.si(), cap: f64::MAX }),
        Friction::CoulombOrowan(law) => {
            Some(CappedCoulomb { coefficient: law.coefficient.si(), cap: law.shear_limit.si() })
        }
        Friction::Pressure(_) => None,
    }
}

fn struck(shared: Shared, profile: Arc<dyn Profile>, impact: Impact) -> ImpactPlan {
    let adhesion = shared.scene.adhesion.as_ref();
    let law = match shared.read.relaxation.clone() {
        None => ImpactLaw::Elastic(elastic(adhesion)),
        Some(relaxation) => ImpactLaw::Viscoelastic { relaxation, edge: held_edge(adhesion) },
    };
    ImpactPlan { profile, law, ball: ball(&shared, &impact), impact, shared }
}

/// The ball of an oblique impact.
fn ball(shared: &Shared, impact: &Impact) -> Option<Ball> {
    let (Shape::Paraboloid(shape), Slip::Local(law)) = (&shared.scene.shape, shared.scene.friction.as_ref()?.slip())
    else {
        return None;
    };
    let grip = shared.grip(law.coefficient.si());
    let ball = Ball { grip, radius: shape.radius.si(), mass: impact.mass.si(), gyration: SOLID };
    impact.is_oblique().then_some(ball)
}
