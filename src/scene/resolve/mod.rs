//! From a scene as written to the decision who computes it.

mod contact;
mod tangential;

use contact::{elastic, hardness, held_edge, lasting, pinned, resting, unrelaxed, works, yielding};
use tangential::{interface, left, tangential, travel};

use super::law::{ContactLaw, ImpactLaw, MachineLaw, PixelFriction, WearLaw};
use super::mended::Mended;
use super::pixelled::PixelledIndenter;
use super::plan::{
    HalfSpacePlan, ImpactPlan, PadPlan, Plan, PlanePlan, RoughImpactPlan, RoughPlan, RoundPlan, SceneSettings, Shared,
};
use super::read::{Geometry, Read};
use super::rules::{self, Draft, Parts, Written};
use super::solver::{HalfSpace, SolverChoice, Tractions};
use super::surface::Surface;
use super::tractive::TractiveRolling;
use super::{Scene, limits, pixelled, reach};
use crate::contact::pad::{Bed, Element, Spring, Summit};
use crate::drive::machine::Machine;
use crate::friction::oblique::{Ball, SOLID};
use crate::friction::{Friction, Slip};
use crate::input::problem::Problem;
use crate::input::table::Tables;
use crate::material::Under;
use crate::scene::history::{EntryTraits, Impact, space};
use crate::shape::{Pad, Profile, Shape};
use crate::wear::Wear;
use std::num::NonZeroUsize;
use std::sync::Arc;

/// Records per entry of a contact on pixels unless the scene says otherwise: each is solved by itself.
const RECORDS_ON_PIXELS: usize = 20;

impl Scene {
    /// The scene with its tables read and decided, or everything that is wrong with it.
    ///
    /// # Errors
    /// Parts that do not fit together, tables that cannot be read: all problems at once, in no
    /// particular order.
    pub fn resolve(self, tables: &dyn Tables) -> Result<Plan, Vec<Problem>> {
        let mut problems = Vec::new();
        let read = Read::of(&self, tables, &Mended::default(), &mut problems);
        decided(self, Arc::new(read), problems)
    }

    /// What is wrong with a scene beside what was `mended`: the problems that it has whatever should stand there.
    ///
    /// ```
    /// # #[cfg(feature = "text")] {
    /// use springbed::prelude::*;
    /// use springbed::scene::{Scene, mended::Mended};
    ///
    /// let text = "(shape: Cone(slope: 0.1), bodies: (Rigid, Rigid), history: [Slide(to: 1, over: 1)])";
    /// let scene = Scene::from_ron(text)?;
    /// let problems = |mended| scene.problems_beside(&mended, &InMemory::default());
    /// assert_eq!(problems(Mended::default()).len(), 2);
    /// // Whatever the second body should be, the slide lacks a friction.
    /// let problems = problems(Mended::at(["bodies.1"]));
    /// assert!(problems.len() == 1 && problems[0].path == "history[0]");
    /// # }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn problems_beside(&self, mended: &Mended, tables: &dyn Tables) -> Vec<Problem> {
        let mut problems = Vec::new();
        let read = Read::of(self, tables, mended, &mut problems);
        problems.extend(misfits(&read, Written { scene: self, entries: &entries(self, &read), mended }));
        problems
    }
}

impl Plan {
    /// The same scene with other settings.
    ///
    /// # Errors
    /// The parts do not fit together under them.
    pub fn with(&self, settings: SceneSettings) -> Result<Self, Vec<Problem>> {
        let SceneSettings { accuracy, springs, steps, solver } = settings;
        // Figures of one solver are not those of another: then it draws what suits it.
        let plots = self.scene.plots.clone().filter(|_| solver == self.scene.solver);
        let scene = Scene { accuracy, springs, steps, solver, plots, ..self.scene.clone() };
        decided(scene, self.read.clone(), Vec::new())
    }
}

/// The decision, if nothing is wrong with the parts of the scene by themselves or held against each other.
fn decided(scene: Scene, read: Arc<Read>, mut problems: Vec<Problem>) -> Result<Plan, Vec<Problem>> {
    let entries = entries(&scene, &read);
    problems.extend(misfits(&read, Written { scene: &scene, entries: &entries, mended: &Mended::default() }));
    let impact = entries.iter().find_map(|entry| entry.impact.cloned());
    let stages = entries.into_iter().flat_map(|entry| entry.stages).collect();
    match (&read.joined, read.geometry_for(&scene)) {
        (Some(joined), Some(geometry)) if problems.is_empty() => {
            let pair = if scene.shape.is_plane() { joined.pair.long_across() } else { joined.pair };
            let shared = Shared { pair, scene, stages, read: read.clone() };
            kind(shared, &geometry, impact).ok_or_else(|| vec![rules::tips_without_pixels()])
        }
        (Some(_) | None, Some(_) | None) => Err(problems),
    }
}

/// What is beyond the limits of a scene, and what does not fit together.
fn misfits(read: &Read, written: Written<'_>) -> Vec<Problem> {
    let geometry = read.geometry_for(written.scene);
    let parts = Parts {
        profile: geometry.as_ref().and_then(Geometry::profile),
        bodies: read.joined.as_ref(),
        strength: read.strength.as_deref(),
    };
    let draft = Draft::new(written, parts, reach::bounds);
    let mut problems = limits::problems(&draft);
    problems.extend(rules::problems(&draft));
    problems
}

fn entries<'s>(scene: &'s Scene, read: &'s Read) -> Vec<EntryTraits<'s>> {
    let steps = scene.steps.map(NonZeroUsize::get).or(scene.solver.map(|_| RECORDS_ON_PIXELS));
    let numbered = scene.history.iter().zip(&read.motions).enumerate();
    let mut entries: Vec<EntryTraits<'_>> =
        numbered.map(|(number, (entry, motion))| entry.traits(number, motion.as_ref(), steps)).collect();
    space(scene, &mut entries);
    entries
}

/// The kind of plan: every kind of scene and every law is named here once.
fn kind(shared: Shared, geometry: &Geometry, impact: Option<Impact>) -> Option<Plan> {
    if let Some(SolverChoice::HalfSpace(asked)) = shared.scene.solver
        && let Some(indenter) = PixelledIndenter::of(&shared.scene.shape, geometry)
    {
        return Some(Plan::HalfSpace(on_pixels(shared, indenter, asked)));
    }
    Some(match (geometry, impact) {
        (Geometry::Round(profile), Some(impact)) => Plan::Impact(impact_plan(shared, profile.clone(), impact)),
        (Geometry::Round(profile), None) => Plan::Round(round(shared, profile.clone())),
        (Geometry::Rough(surface, base), None) => {
            let coefficient = match &shared.scene.friction {
                Some(Friction::Coulomb(law)) => Some(law.coefficient.si()),
                Some(
                    Friction::StaticKinetic(_)
                    | Friction::RateState(_)
                    | Friction::Stuck
                    | Friction::CoulombOrowan(_)
                    | Friction::Pressure(_),
                )
                | None => None,
            };
            Plan::Rough(RoughPlan { coefficient, ..rough(shared, (surface, base.as_ref())) })
        }
        // On a mass that comes straight in friction does not act.
        (Geometry::Rough(surface, base), Some(impact)) => {
            Plan::RoughImpact(RoughImpactPlan { rough: rough(shared, (surface, base.as_ref())), impact })
        }
        (Geometry::Wavy(section), _) => Plan::Plane(PlanePlan { section: section.clone(), shared }),
        (Geometry::Pad(of), _) => Plan::Pad(pad(shared, *of)?),
        (Geometry::Tips(_), _) => return None,
    })
}

/// A pad: its springs stand for the area of a sheet, or its summits are balls.
fn pad(shared: Shared, pad: Pad) -> Option<PadPlan> {
    let works = shared.scene.adhesion.as_ref().map(works);
    let (work, closing) = works.map_or((0.0, 0.0), |works| (works.opening, works.closing));
    let (number, element) = match (&pad.summits, &shared.read.joined.as_ref()?.under) {
        (Some(summits), _) => {
            let (radius, modulus) = (summits.radius.si(), shared.pair.normal);
            (summits.number.si(), Element::Summit(Summit { radius, modulus, work }))
        }
        (None, Under::Springs(thickness)) => {
            let area = pad.area();
            let stiffness = shared.pair.normal * area / thickness;
            (1.0, Element::Spring(Spring { stiffness, work: work * area, closing: closing * area }))
        }
        (None, Under::HalfSpaces | Under::Layers(_) | Under::Graded(_)) => return None,
    };
    Some(PadPlan { bed: Bed { number, deviation: pad.deviation.si(), element }, pad, shared })
}

fn on_pixels(shared: Shared, indenter: PixelledIndenter, asked: HalfSpace) -> HalfSpacePlan {
    let window = asked.window.map(|window| window.si());
    let boundary = asked.boundary.unwrap_or_else(|| pixelled::suiting(&indenter));
    let size = pixelled::size(&indenter, asked.grid, window);
    let (relaxation, attraction) = (shared.read.relaxation.clone(), elastic(shared.scene.adhesion.as_ref()));
    let hardness = hardness(&shared);
    let ground = shared.read.ground.clone();
    let travel = travel(&shared);
    let friction = shared.scene.friction.as_ref().map(|friction| match friction.slip() {
        Slip::Local(coefficient) if asked.tractions == Some(Tractions::Coupled) => {
            PixelFriction::Coupled { coefficient }
        }
        Slip::Local(coefficient) => PixelFriction::Partial { coefficient },
        // What sticks everywhere is refused on pixels.
        Slip::Gross | Slip::Nowhere => PixelFriction::Gross(interface(&shared, friction)),
    });
    HalfSpacePlan {
        travel,
        friction,
        shared,
        indenter,
        boundary,
        size,
        window,
        ground,
        leak: asked.leak,
        relaxation,
        attraction,
        hardness,
    }
}

fn round(shared: Shared, profile: Arc<dyn Profile>) -> RoundPlan {
    let scene = &shared.scene;
    let rolling = TractiveRolling::of(scene, &shared.pair);
    // What rolls steadily has one state, and no way that a tangential contact would follow.
    let friction = scene.friction.as_ref().filter(|_| rolling.is_none());
    let friction = friction.map(|friction| tangential(&shared, friction));
    let travel = travel(&shared).filter(|_| rolling.is_none());
    let contact =
        if shared.moves_along() { ContactLaw::Gliding { relaxation: lasting(&shared) } } else { resting(&shared) };
    let wear = scene.wear.as_ref().map(|Wear::Archard(law)| WearLaw::new(law.coefficient.si(), shared.accuracy()));
    let machine = machine(&shared);
    let spring = scene.machine.as_ref().filter(|machine| machine.mass.is_none()).map(Machine::stiffness);
    RoundPlan { profile, contact, friction, travel, rolling, wear, machine, spring, shared }
}

/// The machine and its motions.
fn machine(shared: &Shared) -> Option<MachineLaw> {
    let scene = &shared.scene;
    let suspension = scene.machine.as_ref()?.suspension()?;
    let steps = scene.steps.map(NonZeroUsize::get);
    let entries = scene.history.iter().enumerate();
    let motions = entries.filter_map(|(number, entry)| entry.traits(number, None, steps).machine).collect();
    Some(MachineLaw { suspension, left: left(scene.friction.as_ref()), motions })
}

/// A rough contact without friction.
fn rough(shared: Shared, (surface, base): (&Arc<Surface>, Option<&Arc<dyn Profile>>)) -> RoughPlan {
    RoughPlan {
        surface: surface.clone(),
        base: base.cloned(),
        relaxation: shared.read.relaxation.clone(),
        works: shared.scene.adhesion.as_ref().map(works),
        hardness: hardness(&shared),
        coefficient: None,
        travel: travel(&shared),
        shared,
    }
}

fn impact_plan(shared: Shared, profile: Arc<dyn Profile>, impact: Impact) -> ImpactPlan {
    let adhesion = shared.scene.adhesion.as_ref();
    let relaxation = shared.read.relaxation.clone();
    let law = match (relaxation, held_edge(adhesion), pinned(adhesion)) {
        (None, _, None) => match yielding(&shared) {
            Some(ball) => ImpactLaw::Plastic(ball),
            None => ImpactLaw::Elastic(elastic(adhesion)),
        },
        (None, _, Some(edge)) => ImpactLaw::Held { relaxation: Arc::new(unrelaxed(&shared)), edge },
        (Some(relaxation), None, _) => ImpactLaw::Viscoelastic { relaxation },
        (Some(relaxation), Some(edge), _) => ImpactLaw::Held { relaxation, edge },
    };
    ImpactPlan { profile, law, ball: ball(&shared, &impact), impact, shared }
}

/// The ball of an oblique impact.
fn ball(shared: &Shared, impact: &Impact) -> Option<Ball> {
    let (Shape::Paraboloid(shape), Slip::Local(coefficient)) =
        (&shared.scene.shape, shared.scene.friction.as_ref()?.slip())
    else {
        return None;
    };
    let grip = shared.grip(coefficient);
    let ball = Ball { grip, radius: shape.radius.si(), mass: impact.mass.si(), gyration: SOLID };
    impact.is_oblique().then_some(ball)
}
