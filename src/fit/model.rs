//! What a scene answers to the drive of a measured curve.

use super::adhesive::{Branch, Followed, Jump};
use super::curve::Curve;
use super::free::Free;
use super::remembering::{Remembering, goes_in_once};
use crate::contact::adhesion::equilibrium::Control;
use crate::contact::adhesion::line::EdgeLine;
use crate::contact::creep::Creep;
use crate::contact::foundation::Foundation;
use crate::input::table::{Columns, RawMap, TableError, Tables};
use crate::material::{Relaxation, Spectrum, Times, Under, joined};
use crate::run::record::Record;
use crate::run::{Wanted, run};
use crate::scene::Scene;
use crate::scene::history::Entry;
use crate::scene::law::{ContactLaw, ElasticAdhesion};
use crate::scene::plan::{Plan, RoundPlan};
use crate::text::place::{Places, Value};
use ndarray::Array2;
use std::path::Path;
use std::sync::Arc;

/// A scene under the drive of a curve.
#[derive(Clone, Copy)]
pub struct Model<'m> {
    /// The scene.
    pub places: &'m Places,
    /// What may change of it.
    pub free: &'m [Free],
    /// The tables it names.
    pub tables: &'m dyn Tables,
    /// The curve.
    pub curve: &'m Curve,
    /// What drives it.
    pub control: Control,
}

/// What a model answers.
#[derive(Debug, Clone, Default)]
pub struct Answer {
    /// One per point: force [N], or depth [m] under a force.
    pub response: Vec<f64>,
    /// Its slope in the drive, where it is known.
    pub slope: Option<Vec<f64>>,
    /// Where it jumps on the way.
    pub jumps: Vec<Jump>,
    /// The decision, where the state follows from the depth.
    plan: Option<Plan>,
}

impl Answer {
    /// A response of which no more is known.
    fn plain(response: Vec<f64>) -> Self {
        Self { response, ..Self::default() }
    }
}

/// Who computes a curve.
enum Way<'w> {
    /// The force follows from the depth.
    Elastic(Foundation),
    /// It follows from the depth and from whether the bodies hold each other.
    Adhesive(Branch),
    /// It remembers a depth that has risen and fallen, at these times.
    Remembering(Remembering<'w>, &'w [f64]),
    /// A whole run.
    Run,
}

/// Part of the shortest step down to which a power law is kept to.
const WITHIN: f64 = 0.1;
/// Part of the first interval in which the first row is reached.
const SOON: f64 = 1e-9;
/// Name of the table that drives.
const DRIVE: &str = "measured drive";

impl Model<'_> {
    /// The scene with the free values `values` [SI units].
    ///
    /// # Errors
    /// A value is out of its range.
    pub fn scene(&self, values: &[f64]) -> Result<Scene, String> {
        let set = self.free.iter().zip(values).map(|(free, &value)| (free.path.as_str(), Value::from(value)));
        self.places.with(&set.collect::<Vec<_>>()).map_err(|problem| problem.to_string())
    }

    /// The answer with the free values `values` [SI units] and first touch at `contact` of the drive.
    ///
    /// # Errors
    /// The scene cannot be computed.
    pub fn answer(&self, values: &[f64], contact: f64) -> Result<Answer, String> {
        let scene = self.scene(values)?;
        let plan = scene.resolve(self.tables).map_err(|problems| told(&problems))?;
        if self.control == Control::Force {
            return match self.creeping(&plan) {
                Some((creep, time)) => self.crept(creep, time).map(|mut depths| {
                    // A power law is infinitely stiff at once, its series is not.
                    depths.iter_mut().take(usize::from(plan.times().is_some())).for_each(|depth| *depth = 0.0);
                    Answer::plain(depths)
                }),
                None => self.by_run(plan.scene.clone(), contact),
            };
        }
        match self.way(&plan, contact) {
            Way::Elastic(ground) => {
                let states = self.curve.depth.iter().map(|d| elastic(&ground, d - contact));
                let (response, slope) = states.collect::<Result<Vec<_>, _>>()?.into_iter().unzip();
                Ok(Answer { response, slope: Some(slope), plan: Some(plan), jumps: Vec::new() })
            }
            Way::Adhesive(branch) => {
                let Followed { forces, slopes, jumps } = branch.followed(&self.curve.depth, contact)?;
                Ok(Answer { response: forces, slope: Some(slopes), plan: None, jumps })
            }
            Way::Remembering(body, time) => Ok(Answer::plain(body.followed(time, &self.curve.depth, contact)?)),
            Way::Run => self.by_run(plan.scene.clone(), contact),
        }
    }

    /// Whether an answer takes no run.
    #[must_use]
    pub fn is_cheap(&self) -> bool {
        let values: Vec<f64> = self.free.iter().map(|free| free.start.clamp(free.low, free.high)).collect();
        let plan = self.scene(&values).ok().and_then(|scene| scene.resolve(self.tables).ok());
        let cheap = |plan: &Plan| match self.control {
            Control::Indentation => !matches!(self.way(plan, f64::NEG_INFINITY), Way::Run),
            Control::Force => self.creeping(plan).is_some(),
        };
        plan.as_ref().is_some_and(cheap)
    }

    /// A contact that grows under a force that never falls, and the times, if it is one.
    fn creeping(&self, plan: &Plan) -> Option<(Creep, &[f64])> {
        let round = plan.round().filter(|round| round.friction.is_none() && !round.profile.is_plane())?;
        let relaxation = match &round.contact {
            ContactLaw::Continuous { relaxation, edge: None } => relaxation,
            ContactLaw::ViscoelasticSprings { relaxation, .. } if plan.scene.springs.is_none() => relaxation,
            ContactLaw::Continuous { edge: Some(_), .. }
            | ContactLaw::ViscoelasticSprings { .. }
            | ContactLaw::Gliding { .. }
            | ContactLaw::Direct(_)
            | ContactLaw::Plastic(_)
            | ContactLaw::Springs { .. } => return None,
        };
        let force = &self.curve.force;
        let grows = force.first().is_some_and(|first| *first >= 0.0) && force.windows(2).all(|pair| pair[1] >= pair[0]);
        let time = self.curve.time.as_deref().filter(|_| grows)?;
        let relaxation = self.relaxation(plan).unwrap_or_else(|| relaxation.clone());
        Some((Creep::new(Arc::new(Spectrum::new(&relaxation)), round.profile.clone()), time))
    }

    /// E*(t) of bodies that relax by a power law, over the times of the curve; `None` of others.
    fn relaxation(&self, plan: &Plan) -> Option<Arc<Relaxation>> {
        plan.times()?;
        let time = self.curve.time.as_deref()?;
        let step = time.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::MAX, f64::min);
        let longest = time.last()? - time.first()?;
        let times = Times { shortest: WITHIN * step, longest, accuracy: plan.accuracy() };
        let joined = joined(&plan.scene.bodies, self.tables, Some(times)).ok()??;
        joined.relaxation.map(Arc::new)
    }

    /// Depths [m] of a contact that creeps; the first force is there at once.
    fn crept(&self, mut creep: Creep, time: &[f64]) -> Result<Vec<f64>, String> {
        let mut before = time.first().copied().unwrap_or(0.0);
        let mut depth = |(&force, &t): (&f64, &f64)| {
            creep = creep.after(force, t - before);
            before = t;
            creep.indentation().ok_or_else(|| format!("under {force:e} N the contact outgrows its profile"))
        };
        self.curve.force.iter().zip(time).map(&mut depth).collect()
    }

    /// Who computes a plan under the drive.
    fn way<'w>(&'w self, plan: &'w Plan, contact: f64) -> Way<'w> {
        let simple = |round: &&RoundPlan| round.friction.is_none() && !round.profile.is_plane();
        let Some(round) = plan.round().filter(simple) else {
            return Way::Run;
        };
        match &round.contact {
            ContactLaw::Direct(ElasticAdhesion::None) => Way::Elastic(round.ground()),
            ContactLaw::Direct(ElasticAdhesion::Vanishing { work }) => {
                Branch::of(EdgeLine::new(round.ground(), *work)).map_or(Way::Run, Way::Adhesive)
            }
            ContactLaw::Continuous { relaxation, edge: None } => {
                let relaxation = self.relaxation(plan).unwrap_or_else(|| relaxation.clone());
                let once = goes_in_once(&self.curve.depth, contact);
                let time = self.curve.time.as_deref().filter(|_| once && relaxation.viscosity <= 0.0);
                let flat = round.profile.flat_radius() > 0.0;
                let body = Remembering { profile: round.profile.as_ref(), relaxation };
                time.filter(|_| !flat).map_or(Way::Run, |time| Way::Remembering(body, time))
            }
            ContactLaw::Direct(ElasticAdhesion::Finite { .. })
            | ContactLaw::Plastic(_)
            | ContactLaw::Gliding { .. }
            | ContactLaw::Springs { .. }
            | ContactLaw::Continuous { .. }
            | ContactLaw::ViscoelasticSprings { .. } => Way::Run,
        }
    }

    /// The response with other values, if it is `base` times a factor: that of another modulus alone.
    pub(super) fn scaled(&self, base: &Answer, values: &[f64]) -> Option<Vec<f64>> {
        let plan = base.plan.as_ref().filter(|plan| self.fills_half_spaces(&plan.scene))?;
        let scene = self.scene(values).ok().filter(|scene| scene.shape == plan.scene.shape)?;
        let factor = scene.resolve(self.tables).ok()?.pair.normal / plan.pair.normal;
        Some(base.response.iter().map(|force| factor * force).collect())
    }

    /// Whether nothing but the moduli of the bodies counts.
    fn fills_half_spaces(&self, scene: &Scene) -> bool {
        let joined = joined(&scene.bodies, self.tables, None).ok().flatten();
        joined.is_some_and(|joined| matches!(joined.under, Under::HalfSpaces))
    }

    /// A run led through the curve, from its first row on.
    fn by_run(&self, mut scene: Scene, contact: f64) -> Result<Answer, String> {
        let drive = Drive::of(self, contact, scene.relaxes())?;
        scene.history = vec![Entry::Table(DRIVE.into())];
        let plan = scene.resolve(&drive).map_err(|problems| told(&problems))?;
        let outcome = run(&plan, Wanted { instants: false, ..Wanted::NOTHING }).map_err(|error| error.to_string())?;
        let records = &outcome.records;
        // One record per row, and one before the first of them.
        let before = records.len().checked_sub(self.curve.len()).ok_or("the run left out a row")?;
        let answered = records[before..].iter().map(|record| match self.control {
            Control::Indentation => Ok(record.normal.force),
            Control::Force => record.normal.indentation.ok_or_else(parted),
        });
        let response = answered.collect::<Result<Vec<f64>, String>>()?;
        let jumps = if plan.adheres() { jumps(&records[before..], &response) } else { Vec::new() };
        Ok(Answer { jumps, ..Answer::plain(response) })
    }
}

/// Where adhesive bodies have snapped together or parted since the record before.
fn jumps(records: &[Record], response: &[f64]) -> Vec<Jump> {
    let joined = |record: &Record| record.normal.contact_radius.is_some_and(|radius| radius > 0.0);
    let before = std::iter::once(false).chain(records.iter().map(joined));
    let rows = before.zip(records.iter().map(joined)).enumerate();
    // Before the first row nothing has touched.
    let height = |row: usize| (response[row] - row.checked_sub(1).map_or(0.0, |before| response[before])).abs();
    let jump = |(row, _)| Jump { row, height: height(row), at: None };
    rows.filter(|(_, (before, here))| before != here).map(jump).collect()
}

fn parted() -> String {
    "the force parts the bodies: expected drive: Depth for a curve on which they pull at each other".to_owned()
}

fn told(problems: &[crate::input::problem::Problem]) -> String {
    problems.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
}

/// Force [N] and its slope dF/dd = 2E*a [N/m] at the depth `d` [m].
fn elastic(ground: &Foundation, d: f64) -> Result<(f64, f64), String> {
    if d <= 0.0 {
        return Ok((0.0, 0.0));
    }
    let a = ground.profile().edge(d).ok_or_else(|| format!("the depth {d:e} m is beyond the end of the profile"))?;
    Ok((ground.force(a, d - ground.depth(a)), ground.stiffness(a)))
}

/// The curve as a table that drives a scene, beside the tables of the scene itself.
struct Drive<'d> {
    tables: &'d dyn Tables,
    name: &'static str,
    time: Vec<f64>,
    values: Vec<f64>,
    rows: &'d [usize],
}

impl<'d> Drive<'d> {
    fn of(model: &Model<'d>, contact: f64, relaxes: bool) -> Result<Self, String> {
        let Model { curve, control, .. } = *model;
        let time = match &curve.time {
            // What stands in the first row is reached in no time worth it, and not at once: creep needs a way.
            Some(time) => {
                let early = SOON * time.get(1).map_or(1.0, |next| next - time[0]);
                time.iter().map(|t| t - time[0] + early).collect()
            }
            None if relaxes => return Err("bodies that relax need the times: expected a column of them".to_owned()),
            // The order alone matters.
            None => (0..curve.len()).map(|row| row as f64).collect(),
        };
        let values = curve.driven(control).iter().map(|value| value - contact).collect();
        let name = if control == Control::Force { "force_n" } else { "indentation_m" };
        Ok(Self { tables: model.tables, name, time, values, rows: &curve.rows })
    }
}

impl Tables for Drive<'_> {
    fn names(&self, path: &Path) -> Result<Vec<String>, TableError> {
        if path == Path::new(DRIVE) {
            return Ok(vec!["time_s".to_owned(), self.name.to_owned()]);
        }
        self.tables.names(path)
    }

    fn columns(&self, path: &Path, names: &[&str]) -> Result<Columns, TableError> {
        if path == Path::new(DRIVE) {
            let of = |name: &&str| if *name == "time_s" { self.time.clone() } else { self.values.clone() };
            return Ok(Columns { values: names.iter().map(of).collect(), rows: self.rows.to_vec() });
        }
        self.tables.columns(path, names)
    }

    fn heights(&self, path: &Path) -> Result<Array2<f64>, TableError> {
        self.tables.heights(path)
    }

    fn topography(&self, path: &Path) -> Result<RawMap, TableError> {
        self.tables.topography(path)
    }
}
