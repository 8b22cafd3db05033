//! What a scene answers to the drive of a measured curve.

use super::adhesive::{Branch, Followed, Jump};
use super::attracted::Attracted;
use super::curve::Curve;
use super::free::Free;
use super::led;
use super::ranged::Ranged;
use super::remembering::{Remembering, goes_in_once};
use super::slopes::Slopes;
use crate::contact::adhesion::dmt::DmtBall;
use crate::contact::adhesion::line::EdgeLine;
use crate::contact::adhesion::range::RangeDisc;
use crate::contact::adhesion::{Adhesion, Range};
use crate::contact::creep::Creep;
use crate::contact::foundation::Foundation;
use crate::input::table::Tables;
use crate::material::{Joined, Relaxation, Spectrum, Times, joined};
use crate::scene::Scene;
use crate::scene::fit::Drive;
use crate::scene::law::{ContactLaw, ElasticAdhesion};
use crate::scene::plan::{Plan, RoundPlan};
use crate::text::place::{Places, Value};
use std::sync::{Arc, Mutex, PoisonError};

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
    pub led: Drive,
    /// What was decided last.
    pub last: &'m Last,
}

/// The scene that was decided last, with its values: first touch is no part of it.
#[derive(Default)]
pub struct Last(Mutex<Option<(Vec<f64>, Arc<Decided>)>>);

/// A scene that is decided for a curve.
pub struct Decided {
    plan: Plan,
    /// E*(t) of bodies that relax, over the times of the curve.
    relaxation: Option<Arc<Relaxation>>,
}

/// What a model answers.
#[derive(Debug, Clone, Default)]
pub struct Answer {
    /// One per point: force [N], or depth [m] under a force.
    pub response: Vec<f64>,
    /// Its slopes, where they come with it.
    slopes: Option<Slopes>,
    /// Where it jumps on the way.
    pub jumps: Vec<Jump>,
}

impl Answer {
    /// A response of which no more is known.
    fn plain(response: Vec<f64>) -> Self {
        Self { response, ..Self::default() }
    }

    fn by_run((response, jumps): (Vec<f64>, Vec<Jump>)) -> Self {
        Self { jumps, ..Self::plain(response) }
    }

    fn followed(followed: Followed) -> Self {
        Self { response: followed.forces, slopes: Some(followed.slopes), jumps: followed.jumps }
    }
}

/// Who computes a curve.
enum Way<'w> {
    /// The force follows from the depth.
    Elastic(Foundation),
    /// It follows from the depth and from whether the bodies hold each other.
    Adhesive(Branch),
    /// It is Hertz's less an attraction, from the depth at which the bodies touch.
    Outside(Attracted),
    /// The same of bodies that attract each other over a range.
    Ranged(Ranged),
    /// It remembers a depth that has risen and fallen, at these times.
    Remembering(Remembering<'w>, &'w [f64]),
    /// A whole run.
    Run,
}

impl Way<'_> {
    /// The numbers of the bodies from which the force follows under a given shape; `None` of a run.
    fn numbers(&self) -> Option<Vec<f64>> {
        match self {
            Self::Elastic(ground) => Some(vec![ground.modulus()]),
            Self::Adhesive(branch) => Some(branch.numbers()),
            Self::Outside(contact) => Some(contact.numbers()),
            Self::Ranged(contact) => Some(contact.numbers()),
            Self::Remembering(body, _) => Some(body.numbers()),
            Self::Run => None,
        }
    }

    /// The same of the bodies and the adhesion of another scene.
    fn numbers_of(&self, scene: &Scene, joined: Joined) -> Option<Vec<f64>> {
        let adhesion = scene.adhesion.as_ref().map(Adhesion::traits);
        let modulus = joined.pair.normal;
        match (self, adhesion.map(|traits| (traits.work, traits.range))) {
            (Self::Elastic(_), None) => Some(vec![modulus]),
            (Self::Adhesive(_), Some((work, Range::Vanishing(_)))) => Some(vec![modulus, work]),
            (Self::Outside(_), Some((work, Range::Outside))) => Some(vec![modulus, work]),
            (Self::Ranged(_), Some((work, Range::Finite(stress)))) => Some(vec![modulus, work, stress]),
            (Self::Remembering(body, _), None) => {
                let relaxation = Arc::new(joined.relaxation?);
                Some(Remembering { relaxation, ..*body }.numbers())
            }
            (
                Self::Elastic(_)
                | Self::Adhesive(_)
                | Self::Outside(_)
                | Self::Ranged(_)
                | Self::Remembering(..)
                | Self::Run,
                _,
            ) => None,
        }
    }
}

/// Slopes of an answer in the numbers of its bodies, and where they were taken.
pub struct Sloped {
    /// The slopes.
    pub slopes: Slopes,
    numbers: Vec<f64>,
    scene: Arc<Decided>,
}

/// The largest relative change of a number of the bodies over a step by which slopes are taken.
const SMALL: f64 = 1e-3;
/// Part of the shortest step down to which a power law is kept to.
const WITHIN: f64 = 0.1;

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
        let decided = self.decided(values)?;
        let plan = &decided.plan;
        let run = || led::answered(plan, (self.curve, self.tables), (self.led, contact)).map(Answer::by_run);
        if self.led == Drive::Force {
            return match self.creeping(&decided) {
                Some((creep, time)) => self.crept(creep, time).map(|mut depths| {
                    // A power law is infinitely stiff at once, its series is not.
                    depths.iter_mut().take(usize::from(plan.times().is_some())).for_each(|depth| *depth = 0.0);
                    Answer::plain(depths)
                }),
                None => run(),
            };
        }
        match self.way(&decided, contact) {
            Way::Elastic(ground) => self.pressed(&ground, contact),
            Way::Adhesive(branch) => Ok(Answer::followed(branch.followed(self.curve.driven(Drive::Depth), contact)?)),
            Way::Outside(bodies) => Ok(Answer::followed(bodies.followed(self.curve.driven(Drive::Depth), contact))),
            Way::Ranged(bodies) => Ok(Answer::followed(bodies.followed(self.curve.driven(Drive::Depth), contact)?)),
            Way::Remembering(body, time) => {
                Ok(Answer::plain(body.followed(time, self.curve.driven(Drive::Depth), contact)?))
            }
            Way::Run => run(),
        }
    }

    /// The scene at the free values `values`, decided.
    fn decided(&self, values: &[f64]) -> Result<Arc<Decided>, String> {
        if let Some((known, decided)) = self.last.0.lock().unwrap_or_else(PoisonError::into_inner).as_ref()
            && known == values
        {
            return Ok(decided.clone());
        }
        let decided = Arc::new(self.decide(values)?);
        *self.last.0.lock().unwrap_or_else(PoisonError::into_inner) = Some((values.to_vec(), decided.clone()));
        Ok(decided)
    }

    fn decide(&self, values: &[f64]) -> Result<Decided, String> {
        let plan = self.scene(values)?.resolve(self.tables).map_err(|problems| led::told(&problems))?;
        let relaxation = self.relaxation(&plan);
        Ok(Decided { plan, relaxation })
    }

    /// Slopes of the answer at the values `values` in the numbers of its bodies, and those numbers, where no run is needed.
    ///
    /// # Errors
    /// The scene cannot be computed.
    pub fn slopes(&self, (values, contact): (&[f64], f64), answer: &Answer) -> Result<Option<Sloped>, String> {
        let decided = self.decided(values)?;
        let slopes = match (&answer.slopes, self.led) {
            (_, Drive::Force | Drive::Speed | Drive::Slide) => None,
            (Some(slopes), Drive::Depth) => Some(slopes.clone()),
            (None, Drive::Depth) => match self.way(&decided, contact) {
                Way::Remembering(body, time) => Some(body.slopes(time, self.curve.driven(Drive::Depth), contact)?),
                Way::Elastic(_) | Way::Adhesive(_) | Way::Outside(_) | Way::Ranged(_) | Way::Run => None,
            },
        };
        let numbers = self.way(&decided, contact).numbers();
        Ok(slopes.zip(numbers).map(|(slopes, numbers)| Sloped { slopes, numbers, scene: decided }))
    }

    /// By how much the numbers change from those of `base` to other values; `None` where more than numbers changes.
    pub fn changes(&self, base: &Sloped, values: &[f64], contact: f64) -> Option<Vec<f64>> {
        let (scene, plan) = (self.scene(values).ok()?, &base.scene.plan);
        if scene.shape != plan.scene.shape {
            return None;
        }
        let joined = joined(&scene.bodies, self.tables, self.times(plan)).ok()??;
        if plan.under() != Some(&joined.under) {
            return None;
        }
        let numbers = self.way(&base.scene, contact).numbers_of(&scene, joined)?;
        let changes = numbers.iter().zip(&base.numbers).map(|(there, here)| there - here);
        // A series of other terms is no change of its numbers.
        let small = |(change, here): (f64, &f64)| change.abs() <= SMALL * here.abs();
        let alike = numbers.len() == base.numbers.len() && changes.clone().zip(&base.numbers).all(small);
        alike.then(|| changes.collect())
    }

    /// The answer of an elastic ground.
    fn pressed(&self, ground: &Foundation, contact: f64) -> Result<Answer, String> {
        let states = self.curve.driven(Drive::Depth).iter().map(|d| elastic(ground, d - contact));
        let (response, touch): (Vec<f64>, Vec<f64>) = states.collect::<Result<Vec<_>, _>>()?.into_iter().unzip();
        let by_modulus = response.iter().map(|force| force / ground.modulus()).collect();
        let slopes = Slopes { numbers: vec![by_modulus], touch };
        Ok(Answer { response, slopes: Some(slopes), jumps: Vec::new() })
    }

    /// Whether an answer takes no run.
    #[must_use]
    pub fn is_cheap(&self) -> bool {
        let values: Vec<f64> = self.free.iter().map(|free| free.start.clamp(free.low, free.high)).collect();
        self.decided(&values).is_ok_and(|decided| match self.led {
            Drive::Depth => !matches!(self.way(&decided, f64::NEG_INFINITY), Way::Run),
            Drive::Force => self.creeping(&decided).is_some(),
            Drive::Speed | Drive::Slide => false,
        })
    }

    /// A contact that grows under a force that never falls, and the times, if it is one.
    fn creeping(&self, decided: &Decided) -> Option<(Creep, &[f64])> {
        let plan = &decided.plan;
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
        let force = self.curve.driven(Drive::Force);
        let grows = force.first().is_some_and(|first| *first >= 0.0) && force.windows(2).all(|pair| pair[1] >= pair[0]);
        let time = self.curve.time.as_deref().filter(|_| grows)?;
        let relaxation = decided.relaxation.as_ref().unwrap_or(relaxation);
        Some((Creep::new(Arc::new(Spectrum::new(relaxation)), round.profile.clone()), time))
    }

    /// E*(t) of bodies that relax by a power law, over the times of the curve; `None` of others.
    fn relaxation(&self, plan: &Plan) -> Option<Arc<Relaxation>> {
        let times = self.times(plan)?;
        let joined = joined(&plan.scene.bodies, self.tables, Some(times)).ok()??;
        joined.relaxation.map(Arc::new)
    }

    /// The times between which a power law of the bodies is kept to; `None` of others.
    fn times(&self, plan: &Plan) -> Option<Times> {
        plan.times()?;
        let time = self.curve.time.as_deref()?;
        let step = time.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::MAX, f64::min);
        let longest = time.last()? - time.first()?;
        Some(Times { shortest: WITHIN * step, longest, accuracy: plan.accuracy() })
    }

    /// Depths [m] of a contact that creeps; the first force is there at once.
    fn crept(&self, mut creep: Creep, time: &[f64]) -> Result<Vec<f64>, String> {
        let mut before = time.first().copied().unwrap_or(0.0);
        let mut depth = |(&force, &t): (&f64, &f64)| {
            creep = creep.after(force, t - before);
            before = t;
            creep.indentation().ok_or_else(|| format!("under {force:e} N the contact outgrows its profile"))
        };
        self.curve.driven(Drive::Force).iter().zip(time).map(&mut depth).collect()
    }

    /// Who computes a plan under the drive.
    fn way<'w>(&'w self, decided: &'w Decided, contact: f64) -> Way<'w> {
        let by_depth = self.led == Drive::Depth;
        let simple = |round: &&RoundPlan| by_depth && round.friction.is_none() && !round.profile.is_plane();
        let Some(round) = decided.plan.round().filter(simple) else {
            return Way::Run;
        };
        match &round.contact {
            ContactLaw::Direct(ElasticAdhesion::None) => Way::Elastic(round.ground()),
            ContactLaw::Direct(ElasticAdhesion::Vanishing { work }) => {
                Branch::of(EdgeLine::new(round.ground(), *work)).map_or(Way::Run, Way::Adhesive)
            }
            ContactLaw::Continuous { relaxation, edge: None } => {
                let relaxation = decided.relaxation.as_ref().unwrap_or(relaxation).clone();
                let once = goes_in_once(self.curve.driven(Drive::Depth), contact);
                let time = self.curve.time.as_deref().filter(|_| once && relaxation.viscosity <= 0.0);
                let flat = round.profile.flat_radius() > 0.0;
                let body = Remembering { profile: round.profile.as_ref(), relaxation };
                time.filter(|_| !flat).map_or(Way::Run, |time| Way::Remembering(body, time))
            }
            ContactLaw::Direct(ElasticAdhesion::Outside { work }) => {
                Way::Outside(Attracted(DmtBall::new(round.ground(), *work)))
            }
            ContactLaw::Direct(ElasticAdhesion::Finite { work, stress }) => {
                let disc = RangeDisc::new(round.ground(), *work, *stress).ok();
                disc.and_then(Ranged::of).map_or(Way::Run, Way::Ranged)
            }
            ContactLaw::Direct(ElasticAdhesion::Fading { .. })
            | ContactLaw::Plastic(_)
            | ContactLaw::Gliding { .. }
            | ContactLaw::Springs { .. }
            | ContactLaw::Continuous { .. }
            | ContactLaw::ViscoelasticSprings { .. } => Way::Run,
        }
    }
}

/// Force [N] and its slope in first touch, −dF/dd = −2E*a [N/m], at the depth `d` [m].
fn elastic(ground: &Foundation, d: f64) -> Result<(f64, f64), String> {
    if d <= 0.0 {
        return Ok((0.0, 0.0));
    }
    let a = ground.profile().edge(d).ok_or_else(|| format!("the depth {d:e} m is beyond the end of the profile"))?;
    Ok((ground.force(a, d - ground.depth(a)), -ground.stiffness(a)))
}
