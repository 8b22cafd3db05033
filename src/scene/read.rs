//! The tables of a scene, read.

use super::Scene;
use super::mended::{Look, Mended};
use super::surface::{self, Surface};
use super::times;
use crate::friction::{Friction, Strength, StrengthCurve};
use crate::ground::{self, Ground, Grounded};
use crate::input::problem::Problem;
use crate::input::table::Tables;
use crate::material::{self, Joined, Relaxation, Times};
use crate::scene::history::{Entry, MotionTable};
use crate::shape::{Family, Lying, MapSource, Pad, PlacedTip, PlaneWavy, Profile, RoughShape, Shape, Tip};
use std::sync::Arc;

/// The parts of a scene with their tables read; a part is missing where it cannot be read, or had to be mended.
#[derive(Debug)]
pub(super) struct Read {
    pub(super) joined: Option<Joined>,
    pub(super) relaxation: Option<Arc<Relaxation>>,
    pub(super) geometry: Option<Geometry>,
    /// What lies under the bodies, if they are not alike at all depths.
    pub(super) ground: Option<Arc<dyn Ground>>,
    pub(super) strength: Option<Arc<StrengthCurve>>,
    /// The times of the history.
    pub(super) times: Option<Times>,
    /// One per history entry: the table it names.
    pub(super) motions: Vec<Option<MotionTable>>,
}

impl Read {
    /// Reads what is not `mended`.
    pub(super) fn of(scene: &Scene, tables: &dyn Tables, mended: &Mended, problems: &mut Vec<Problem>) -> Self {
        let mut read = Reading { tables, mended, problems };
        let motions: Vec<_> = scene.history.iter().enumerate().map(|numbered| read.motion(numbered)).collect();
        let times = times::of(scene, &motions);
        let joined = read.part("bodies", |tables| material::joined(&scene.bodies, tables, times)).flatten();
        let ground = joined.as_ref().and_then(|joined| ground::of(&joined.under));
        let geometry = read.part("shape", |tables| Geometry::of(scene, tables));
        Self {
            relaxation: joined.as_ref().and_then(|joined| joined.relaxation.clone()).map(Arc::new),
            joined,
            geometry,
            ground,
            strength: read.part("friction", |tables| strength(scene.friction.as_ref(), tables)).flatten(),
            times,
            motions,
        }
    }

    /// What is pressed by the solver of a scene: pixels have the ground under them, springs are of the shape on it.
    pub(super) fn geometry_for(&self, scene: &Scene) -> Option<Geometry> {
        let geometry = self.geometry.clone()?;
        Some(if scene.solver.is_some() { geometry } else { geometry.on(self.ground.clone()) })
    }
}

/// What parts are read with, and what was wrong with them.
struct Reading<'r> {
    tables: &'r dyn Tables,
    mended: &'r Mended,
    problems: &'r mut Vec<Problem>,
}

impl Reading<'_> {
    /// The part at `path`, if it can be read and nothing in it is mended.
    fn part<T>(&mut self, path: &str, read: impl FnOnce(&dyn Tables) -> Result<T, Vec<Problem>>) -> Option<T> {
        if !self.mended.knows(path, Look::Whole) {
            return None;
        }
        read(self.tables).map_err(|found| self.problems.extend(found)).ok()
    }

    /// The table that a history entry names.
    fn motion(&mut self, (number, entry): (usize, &Entry)) -> Option<MotionTable> {
        let (path, control) = entry.table()?;
        let place = format!("history[{number}]");
        let problem = |what: String| vec![Problem::new(&place, what)];
        self.part(&place, |tables| {
            MotionTable::read((path, control), tables).map_err(|error| problem(error.to_string()))
        })
    }
}

/// What is pressed, ready for evaluation.
#[derive(Debug, Clone)]
pub(super) enum Geometry {
    Round(Arc<dyn Profile>),
    /// Roughness, on a smooth profile if not on a flat.
    Rough(Arc<Surface>, Option<Arc<dyn Profile>>),
    Wavy(PlaneWavy),
    /// Several tips side by side.
    Tips(Arc<[PlacedTip]>),
    /// Springs or summits of scattered heights.
    Pad(Pad),
}

impl Geometry {
    fn of(scene: &Scene, tables: &dyn Tables) -> Result<Self, Vec<Problem>> {
        let shape = &scene.shape;
        let rough = |surface, base| Self::Rough(Arc::new(surface), base);
        Ok(match shape.family() {
            Family::Round => Self::Round(
                if let Shape::PlaneWave(wave) = shape
                    && !is_of_the_present(scene)
                {
                    Arc::new(Lying::from(wave).kept_open())
                } else {
                    profile(shape, tables)?
                },
            ),
            Family::Line(line) => rough(surface::of_line(line, tables)?, base(line, tables)?),
            Family::Map(MapSource::Plain(path, pixel)) => rough(surface::of_map(path, pixel, tables)?, None),
            Family::Map(MapSource::Treated(of)) => rough(surface::of_topography(of, tables)?, None),
            Family::Wavy(wavy) => Self::Wavy(wavy.clone()),
            Family::Tips(tips) => Self::Tips(placed(tips, tables)?),
            Family::Pad(pad) => Self::Pad(*pad),
        })
    }

    /// The same on a ground that is not alike at all depths: of a round shape another profile.
    fn on(self, ground: Option<Arc<dyn Ground>>) -> Self {
        match (self, ground) {
            (Self::Round(profile), Some(ground)) if !profile.is_plane() => {
                Self::Round(Arc::new(Grounded::new(profile, ground)))
            }
            (geometry, _) => geometry,
        }
    }

    /// The smooth profile over a radius.
    pub(super) fn profile(&self) -> Option<&dyn Profile> {
        match self {
            Self::Round(profile) => Some(profile.as_ref()),
            Self::Rough(_, base) => base.as_deref(),
            Self::Wavy(_) | Self::Tips(_) | Self::Pad(_) => None,
        }
    }
}

/// Whether the state of a contact follows from its present depth or force, which a wave needs that may lie flat.
fn is_of_the_present(scene: &Scene) -> bool {
    let slides = |entry: &Entry| matches!(entry, Entry::Slide(_) | Entry::Shake(_)) || entry.table().is_some();
    let rubs = scene.friction.is_some() && scene.history.iter().any(slides);
    let pinned = scene.adhesion.as_ref().is_some_and(|adhesion| adhesion.traits().closing.is_some());
    !scene.relaxes() && !pinned && !rubs && scene.springs.is_none()
}

fn profile(shape: &Shape, tables: &dyn Tables) -> Result<Arc<dyn Profile>, Vec<Problem>> {
    shape.profile(tables).map_err(|error| vec![Problem::new("shape", error.to_string())])
}

/// Tips with their tables read.
fn placed(tips: &[Tip], tables: &dyn Tables) -> Result<Arc<[PlacedTip]>, Vec<Problem>> {
    if tips.is_empty() {
        return Err(vec![Problem::new(
            "shape",
            "has no tip: expected at least one, (shape: Sphere(radius: …), x: …, y: …)",
        )]);
    }
    let problem = |at: usize, what: String| vec![Problem::new(format!("shape[{at}].shape"), what)];
    let placed = tips.iter().enumerate().map(|(at, tip)| tip.placed(tables).map_err(|what| problem(at, what)));
    placed.collect()
}

/// The smooth shape under a rough line.
fn base(line: &RoughShape, tables: &dyn Tables) -> Result<Option<Arc<dyn Profile>>, Vec<Problem>> {
    line.base.as_deref().map(|base| profile(base, tables)).transpose()
}

/// The table of the shear strength, if the friction names one.
fn strength(friction: Option<&Friction>, tables: &dyn Tables) -> Result<Option<Arc<StrengthCurve>>, Vec<Problem>> {
    let Some(Friction::Pressure(law)) = friction else { return Ok(None) };
    let Strength::Table(path) = &law.shear else { return Ok(None) };
    let curve = StrengthCurve::read(path, tables);
    curve.map(Arc::new).map(Some).map_err(|error| vec![Problem::new("friction.shear", error.to_string())])
}
