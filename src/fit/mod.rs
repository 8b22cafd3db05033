//! Parameters of a scene from measured curves, and how sure they are.
//!
//! The scene is led through the drive of the data, as [`run`](crate::run::run) would lead it, and what it answers is
//! held against what was measured. Free parameters count on their natural scale (the logarithm of what is positive);
//! first touch and a baseline are found beside them. Intervals hold with 95 %, for noise whose neighbours may be
//! alike; where the sum of squares is no parabola they are read off its profile.
//!
//! # Examples
//! ```
//! use springbed::fit::{Curve, Options, Question};
//! use springbed::prelude::*;
//! use springbed::scene::Scene;
//!
//! // F = (4/3)E*√R d^{3/2} with E* = 4/3 kPa and R = 1 mm, touched at 2 µm of the drive.
//! let depth: Vec<f64> = (0..200).map(|k| f64::from(k) * 1e-7).collect();
//! let force = depth.iter().map(|d| 4.0 / 3.0 * 4e3 / 3.0 * (1e-3 * (d - 2e-6f64).max(0.0).powi(3)).sqrt()).collect();
//! let curve = Curve::of_depths(depth, force);
//! let scene = Scene::from_ron(r#"(shape: Paraboloid(radius: "1 mm"), bodies: (Elastic(young: "5 kPa", poisson: 0.5), Rigid),
//!     history: [Indent(to: "10 um", over: 1)])"#)?;
//! let question = Question::new(&scene, &["bodies.0.young=100 Pa..1 MPa"], Options::default())?;
//! let fit = question.fit(&curve, &InMemory::default())?;
//! assert!((fit.parameters[0].value / 1e3 - 1.0).abs() < 1e-6);
//! assert!((fit.parameter("contact_point").unwrap().value / 2e-6 - 1.0).abs() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod adhesive;
mod answer;
mod attracted;
mod candidates;
mod compare;
mod curve;
mod drive;
mod fading;
mod few;
mod frame;
mod free;
mod given;
mod interval;
mod jumps;
mod led;
mod map;
mod master;
mod model;
mod noise;
mod notes;
pub mod prony;
mod ranged;
mod remembering;
mod slopes;
mod solve;
mod start;
mod straight;
mod sure;
mod unsure;
mod verdict;
mod widened;

pub use answer::{Estimate, Fit};
pub use candidates::Candidate;
pub use compare::{Standing, compared};
pub use curve::{Curve, Readings};
pub use few::Terms;
pub use free::Free;
pub use given::{Carried, Doubt, Given, percent};
pub use map::Map;
pub use master::{Master, Sweeps};
pub use verdict::Noise;

use crate::input::problem::Problem;
use crate::input::table::Tables;
use crate::scene::Scene;
use crate::scene::fit::{Baseline, Drive, FirstTouch, Loss, Way};
use crate::text::place::{Places, Value};
use frame::Frame;
use interval::huber;
use model::{Last, Model};
use noise::Moments;
use solve::{Found, Task};
use straight::Bent;

/// Why there is no fit.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FitError {
    /// A free parameter is not right.
    #[error("{0}")]
    Free(String),
    /// There is no such place in the scene.
    #[error(transparent)]
    Place(#[from] Problem),
    /// The data cannot be fitted.
    #[error("{0}")]
    Data(String),
    /// The scene cannot be computed.
    #[error("{0}")]
    Scene(String),
}

/// What a fit takes for granted and what it looks for beside the parameters of the scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// Line under the response.
    pub baseline: Baseline,
    /// Where first touch is; under a force it is the baseline of the depth.
    pub contact: FirstTouch,
    /// What drives; that of the first entry of the history if `None`.
    pub drive: Option<Drive>,
    /// The ways that count.
    pub way: Way,
    /// Least and largest drive that counts [m or N].
    pub range: (f64, f64),
    /// How points far off count.
    pub loss: Loss,
    /// Stiffness of the cantilever [N/m], where its virtual deflection is the baseline.
    pub spring: Option<f64>,
}

impl Default for Options {
    fn default() -> Self {
        let range = (f64::NEG_INFINITY, f64::INFINITY);
        Self {
            baseline: Baseline::default(),
            contact: FirstTouch::default(),
            drive: None,
            way: Way::default(),
            range,
            loss: Loss::default(),
            spring: None,
        }
    }
}

/// A scene with what is free in it.
#[derive(Debug, Clone)]
pub struct Question {
    places: Places,
    free: Vec<Free>,
    given: Vec<Given>,
    /// Numbers of the parameters of which a map is wanted.
    map: Option<[usize; 2]>,
    options: Options,
    led: Drive,
    /// Relative error of what the scene answers.
    floor: f64,
}

/// Points more than parameters that a fit needs.
const SPARE: usize = 3;
/// The most points a start is searched from with, where an answer is cheap.
const FEW: usize = 200;
/// The most points a start is looked for with.
const FEWEST: usize = 60;
/// Rounds in which weights or the correlation of the noise are found.
const ROUNDS: usize = 3;
/// Times of the sum of squares, not made white, beyond which an answer to white noise has left the data.
const LEAVES: f64 = 4.0;
/// Correlation up to which white noise sees what there is.
const LIKE: f64 = 0.5;
/// Relative error of what is answered in closed form or by sums of it.
const SHARP: f64 = 1e-9;
/// Relative change of parameters or sum of squares at which a search ends.
const TOLERANCE: f64 = 1e-12;

impl Question {
    /// A scene and its free parameters, each `PATH=LO..HI` or `PATH`.
    ///
    /// # Errors
    /// There is no such parameter, or its range is not right.
    pub fn new(scene: &Scene, free: &[impl AsRef<str>], options: Options) -> Result<Self, FitError> {
        let places = Places::of(scene)?;
        let free: Vec<Free> = free.iter().map(|text| Free::read(&places, text.as_ref())).collect::<Result<_, _>>()?;
        if free.is_empty() {
            return Err(FitError::Free("nothing is free: expected a PATH such as bodies.0.young=1 kPa..1 MPa".into()));
        }
        for (at, one) in free.iter().enumerate() {
            if free[..at].iter().any(|other| other.path == one.path) {
                return Err(FitError::Free(format!("{} is free twice: expected it once", one.path)));
            }
        }
        let led = led::led_by(scene, options.drive)?;
        let options = Options { baseline: led::baseline(options.baseline, led)?, ..options };
        straight::checked(&options, led)?;
        let steps = led == Drive::Force || led != Drive::Depth && scene.relaxes();
        let floor = if steps { scene.accuracy.map_or(1e-6, |accuracy| accuracy.si()) } else { SHARP };
        Ok(Self { places, free, given: Vec::new(), map: None, options, led, floor })
    }

    /// The same question where some numbers of the scene, each `PATH=SPREAD`, are known with a standard error only.
    ///
    /// # Errors
    /// There is no such number, its standard error is none, or it is free.
    pub fn given(self, given: &[impl AsRef<str>]) -> Result<Self, FitError> {
        let given: Vec<Given> =
            given.iter().map(|text| Given::read(&self.places, text.as_ref())).collect::<Result<_, _>>()?;
        match given.iter().find(|given| self.free.iter().any(|free| free.path == given.path)) {
            Some(both) => Err(FitError::Free(format!("{} is both free and given: expected one of them", both.path))),
            None => Ok(Self { given, ..self }),
        }
    }

    /// The same question with a map of the confidence over two parameters, `PATH,PATH`.
    ///
    /// # Errors
    /// They are not two that are free.
    pub fn map(self, pair: &str) -> Result<Self, FitError> {
        Ok(Self { map: Some(self.pair(pair)?), ..self })
    }

    /// Whether first touch is free.
    fn touches(&self) -> bool {
        self.options.contact == FirstTouch::Free && self.led == Drive::Depth
    }

    /// What drives.
    #[must_use]
    pub fn led(&self) -> Drive {
        self.led
    }

    /// What is free.
    #[must_use]
    pub fn free(&self) -> &[Free] {
        &self.free
    }

    /// The scene at the free values `values` [SI units].
    ///
    /// # Errors
    /// A value is out of its range.
    pub fn scene(&self, values: &[f64]) -> Result<Scene, FitError> {
        let set = self.free.iter().zip(values).map(|(free, &value)| (free.path.as_str(), Value::from(value)));
        Ok(self.places.with(&set.collect::<Vec<_>>())?)
    }

    /// The parameters at which the scene is nearest to `curve`; `tables` has what the scene names.
    ///
    /// # Errors
    /// There are too few points, or the scene cannot be computed anywhere in the ranges.
    pub fn fit(&self, curve: &Curve, tables: &dyn Tables) -> Result<Fit, FitError> {
        self.fit_in_doubt((curve, &[]), tables)
    }

    /// The same for a curve that depends on numbers of the instrument known only roughly.
    ///
    /// # Errors
    /// As of [`fit`](Self::fit).
    pub fn fit_in_doubt(&self, (curve, doubts): (&Curve, &[Doubt]), tables: &dyn Tables) -> Result<Fit, FitError> {
        curve.checked(self.led).map_err(FitError::Data)?;
        match self.options.spring.filter(|_| self.led == Drive::Depth) {
            Some(spring) => self.on_cantilever((curve, doubts), tables, spring),
            None => Ok(self.fit_along((curve, doubts), tables, None)?.0),
        }
    }

    /// The same on a cantilever whose state is known so far, and then with the slopes of the response in first touch.
    fn fit_along(
        &self,
        (curve, doubts): (&Curve, &[Doubt]),
        tables: &dyn Tables,
        bent: Option<&Bent>,
    ) -> Result<(Fit, Vec<f64>), FitError> {
        let touch_is_free = self.touches();
        let used = self.used(curve);
        let needed = self.free.len() + 3 + SPARE;
        if used.len() < needed {
            let what = format!("{} points count: expected at least {needed}", used.len());
            return Err(FitError::Data(what));
        }
        let last = Last::default();
        let model = Model { places: &self.places, free: &self.free, tables, curve, led: self.led, last: &last };
        let frame = Frame::new(curve.driven(self.led), used, self.options.baseline);
        let frame = match bent {
            Some(bent) if self.options.baseline == Baseline::Virtual => {
                frame.along(&bent.column).weighing(&bent.weights)
            }
            Some(bent) => frame.weighing(&bent.weights),
            None => frame,
        };
        // Slopes by differences: half of the digits of what the scene is computed to.
        let step = if self.floor <= SHARP || model.is_cheap() { 1e-7 } else { self.floor.sqrt() };
        let task = Task { model, frame: &frame, touch: touch_is_free, step, kept: [None; 2], scaling: None };
        let (found, scaling) = self.nearest(task)?;
        let task = Task { scaling, ..task };
        let (frame, found) = jumps::left_out(&task, found, TOLERANCE).map_err(FitError::Scene)?;
        let (frame, found) = self.weighed(Task { frame: &frame, ..task }, found)?;
        let weighed = Task { frame: &frame, ..task };
        let carried = self.carried(&weighed, &found, doubts).map_err(FitError::Scene)?;
        let touch = bent.map(|_| weighed.slope_of_touch(&found.place, &found.answer));
        let touch = touch.transpose().map_err(FitError::Scene)?.unwrap_or_default();
        let mut fit = answer::told(self, weighed, found)?.widened(&self.free, carried);
        fit.on_jumps = task.frame.used.iter().copied().filter(|at| fit.used.binary_search(at).is_err()).collect();
        fit.notes.extend(jumps::told(curve, &fit.on_jumps));
        Ok((fit, touch))
    }

    /// The points that count.
    fn used(&self, curve: &Curve) -> Vec<usize> {
        let drive = curve.driven(self.led);
        let turn = (0..drive.len()).max_by(|&a, &b| drive[a].total_cmp(&drive[b])).unwrap_or(0);
        let way = |at: &usize| match self.options.way {
            Way::Both => true,
            Way::In => *at <= turn,
            Way::Out => *at >= turn,
        };
        let (low, high) = self.options.range;
        (0..drive.len()).filter(way).filter(|&at| (low..=high).contains(&drive[at])).collect()
    }

    /// The nearest of the places found from several starts with a few points, searched for with all of them, and the
    /// parameter that stands for a ratio of all forces.
    fn nearest(&self, task: Task<'_>) -> Result<(Found, Option<usize>), FitError> {
        let cheap = task.model.is_cheap();
        let thinned = |most: usize| {
            let few = task.model.curve.thinned(&task.frame.used, self.led, most);
            let frame = Frame::new(few.driven(self.led), (0..few.len()).collect(), self.options.baseline);
            (few, frame, Last::default())
        };
        let (few, frame, last) = thinned(FEWEST);
        let sketch = Task { model: Model { curve: &few, last: &last, ..task.model }, frame: &frame, ..task };
        let scaling = start::scaling(&sketch);
        let starts = start::starts(&Task { scaling, ..sketch });
        let (few, frame, last) = thinned(if cheap { FEW } else { FEWEST });
        let rough = Task { model: Model { curve: &few, last: &last, ..task.model }, frame: &frame, scaling, ..task };
        let task = Task { scaling, ..task };
        let found = starts.into_iter().filter_map(|place| rough.solved(&place, 1e-6).ok());
        let place = found.min_by(|a, b| a.squares.total_cmp(&b.squares)).map(|found| found.place);
        let place = place.ok_or_else(|| FitError::Scene(self.why_not(&task)))?;
        Ok((task.solved(&place, TOLERANCE).map_err(FitError::Scene)?, scaling))
    }

    /// What is wrong with the scene at its own values.
    fn why_not(&self, task: &Task<'_>) -> String {
        let values = self.free.iter().map(|free| free.start.clamp(free.low, free.high)).collect();
        let drive = task.model.curve.driven(self.led);
        let contact = if task.touch { drive.iter().copied().fold(f64::MAX, f64::min) } else { 0.0 };
        let error = task.answer(&solve::Place { values, contact }).err();
        error.unwrap_or_else(|| "the scene cannot be computed anywhere in the ranges".to_owned())
    }

    /// The frame of the noise the residuals show, and the answer in it.
    fn weighed(&self, task: Task<'_>, mut found: Found) -> Result<(Frame, Found), FitError> {
        let mut frame = task.frame.clone();
        if self.options.loss == Loss::Robust {
            for _ in 0..ROUNDS {
                let rest = task.rest(&found.answer);
                frame = task.frame.with(huber(task.frame, &rest, &frame.baseline(&rest)), 0.0);
                found = Task { frame: &frame, ..task }.solved(&found.place, TOLERANCE).map_err(FitError::Scene)?;
            }
        }
        // Impacts are shots, each by itself: their noise is white.
        let rounds = if self.led == Drive::Speed { 0 } else { ROUNDS };
        for _ in 0..rounds {
            let columns = answer::columns(&Task { frame: &frame, ..task }, &found).map_err(FitError::Scene)?;
            let rho = Moments::of(&frame, &columns, &task.rest(&found.answer)).most_likely().correlation;
            if (rho - frame.correlation).abs() <= 1e-3 * (1.0 - rho.abs()) || self.is_exact(&task, &found) {
                break;
            }
            (frame, found) = self.whitened((&task, &frame), &found, rho)?;
        }
        Ok((frame, found))
    }

    /// The frame of noise of the correlation `rho`, and the answer in it; of a lesser one where that answer would leave
    /// the data: what a wrong model leaves looks like noise of a correlation next to one, which is blind to all but steps
    /// from row to row.
    fn whitened(
        &self,
        (task, frame): (&Task<'_>, &Frame),
        found: &Found,
        rho: f64,
    ) -> Result<(Frame, Found), FitError> {
        let plain = frame.with(frame.weights.clone(), 0.0);
        let left = |found: &Found| {
            plain.reduced(&Task { frame: &plain, ..*task }.rest(&found.answer)).iter().map(|x| x * x).sum::<f64>()
        };
        let most = LEAVES * left(found);
        let mut rho = rho;
        loop {
            let next = frame.with(frame.weights.clone(), rho);
            let there = Task { frame: &next, ..*task }.solved(&found.place, TOLERANCE).map_err(FitError::Scene)?;
            if rho <= LIKE || left(&there) <= most {
                return Ok((next, there));
            }
            rho = (1.0 - 4.0 * (1.0 - rho)).max(0.0);
        }
    }

    /// Whether no more is left than what the scene is computed to.
    fn is_exact(&self, task: &Task<'_>, found: &Found) -> bool {
        let largest = found.answer.response.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
        let rest = task.rest(&found.answer);
        let rest = interval::without(task.frame, &rest, &task.frame.baseline(&rest));
        rest.iter().all(|x| x.abs() <= self.floor * largest)
    }
}
