//! What a fit is asked for, and its answer for a file or a curve.
//!
//! # Examples
//! ```
//! use springbed::app::fitting::Fitting;
//! use springbed::fit::Curve;
//! use springbed::prelude::*;
//! use springbed::scene::{Scene, fit::Measured};
//!
//! // F = (4/3)E*√R d^{3/2} with E* = 4/3 kPa and R = 1 mm.
//! let depth: Vec<f64> = (0..50).map(|k| f64::from(k) * 1e-7).collect();
//! let force = depth.iter().map(|d| 4.0 / 3.0 * 4e3 / 3.0 * (1e-3 * d.powi(3)).sqrt()).collect();
//! let curve = Curve::of_depths(depth, force);
//! let scene = Scene::from_ron(r#"(shape: Paraboloid(radius: "1 mm"), bodies: (Elastic(young: "5 kPa", poisson: 0.5), Rigid),
//!     history: [Indent(to: "10 um", over: 1)])"#)?;
//! let measured = Measured { free: vec!["bodies.0.young=100 Pa..1 MPa".to_owned()], ..Measured::default() };
//! let fitted = Fitting::new(&measured, &scene, "".as_ref())?.of_curve("a curve", curve, &InMemory::default())?;
//! assert!((fitted.fit.parameters[0].value / 1e3 - 1.0).abs() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use super::data_file::{Data, Wanted};
use super::export::{Answered, Fitted, Tried};
use super::fault::Fault;
use super::scene_file::SceneFile;
use crate::fit::{Candidate, Curve, Doubt, Fit, FitError, Given, Options, Question, Readings, compared, percent};
use crate::input::quantity::{Displacement, Force, Speed, SpringStiffness};
use crate::input::table::Tables;
use crate::run::tabor_parameter;
use crate::scene::Scene;
use crate::scene::fit::{Drive, Measured};
use std::path::Path;

/// Questions to curves, one for each model, and the columns in which their files have it.
#[derive(Debug, Clone)]
pub struct Fitting {
    models: Vec<(String, Question)>,
    wanted: Wanted,
    /// The stiffness of the cantilever, where it is known with a standard error only.
    spring: Option<Given>,
}

/// How the cantilever is called among what is given.
const SPRING: &str = "spring";

impl Fitting {
    /// What `measured` asks of a scene; the files of models are looked for in `folder`.
    ///
    /// # Errors
    /// Columns, a model, a free or a given parameter or a range are not right.
    pub fn new(measured: &Measured, scene: &Scene, folder: &Path) -> Result<Self, String> {
        let stiffness = measured.spring.map(SpringStiffness::si);
        let wanted = Wanted::read(&measured.columns, stiffness).map_err(|what| format!("columns: {what}"))?;
        let (of_spring, given): (Vec<&String>, Vec<&String>) =
            measured.given.iter().partition(|text| text.split('=').next().is_some_and(|path| path.trim() == SPRING));
        let spring = of_spring.first().map(|text| spring(text, stiffness)).transpose()?;
        let plain = Candidate {
            name: String::new(),
            scene: scene.clone(),
            free: measured.free.clone(),
            given: given.into_iter().cloned().collect(),
        };
        let candidates = match &measured.models[..] {
            [] => vec![plain],
            names => names.iter().map(|name| candidate(name, &plain, folder)).collect::<Result<_, _>>()?,
        };
        let asked = |one: Candidate| Ok((one.name.clone(), question(measured, &one)?));
        let models = candidates.into_iter().map(asked).collect::<Result<Vec<(String, Question)>, String>>()?;
        let led = models.first().map_or(Drive::Depth, |(_, question)| question.led());
        Ok(Self { models, wanted: wanted.led_by(led), spring })
    }

    /// A curve of two columns in SI units, depth and force, speed and restitution, or slide and tangential force, whichever
    /// the scene is led by, and the times if they were measured.
    #[must_use]
    pub fn curve(&self, columns: [Vec<f64>; 2], time: Option<Vec<f64>>) -> Curve {
        let rows = (0..columns[0].len()).collect();
        Curve { readings: Readings::of(self.wanted.led.unwrap_or(Drive::Depth), columns), time, rows }
    }

    /// The answer for the file at `path`; `tables` are those of the scene.
    ///
    /// # Errors
    /// The file cannot be read, has no such curve, or the curve cannot be fitted.
    pub fn of_file(&self, path: &Path, tables: &dyn Tables) -> Result<Fitted, String> {
        let said = |fault: Fault| format!("{}: {}", fault.file.display(), fault.message);
        let data = Data::load(path, &self.wanted).map_err(said)?;
        let curve = data.curve().map_err(said)?;
        let doubt = |given: &Given| {
            let with = |sign: f64| data.curve_of(Some(given.value + sign * given.spread)).map_err(said);
            Ok::<_, String>(Doubt { given: given.clone(), curves: [with(-1.0)?, with(1.0)?] })
        };
        let doubts: Vec<Doubt> = self.spring.iter().map(doubt).collect::<Result<_, _>>()?;
        let fitted = self.best((&path.display().to_string(), curve), &doubts, tables)?;
        Ok(Fitted { data_notes: data.notes, ..fitted })
    }

    /// The answer for a curve that is called `name`; `tables` are those of the scene.
    ///
    /// # Errors
    /// The curve cannot be fitted.
    pub fn of_curve(&self, name: &str, curve: Curve, tables: &dyn Tables) -> Result<Fitted, String> {
        if let Some(given) = &self.spring {
            return Err(format!("given: {} is of data with a deflection: expected a file of such", given.path));
        }
        self.best((name, curve), &[], tables)
    }

    /// The model the data are for, all of them beside it where there are several.
    fn best(&self, (name, curve): (&str, Curve), doubts: &[Doubt], tables: &dyn Tables) -> Result<Fitted, String> {
        let one = |(model, question): &(String, Question)| {
            let fit = question.fit_in_doubt((&curve, doubts), tables).map_err(|error| error.to_string());
            let answer = fit.and_then(|fit| {
                let scene = question.scene(&fit.values).map_err(|error| error.to_string())?;
                let tabor = scene.clone().resolve(tables).ok().and_then(|plan| tabor_parameter(&plan));
                Ok(Answered { fit, scene, tabor })
            });
            Tried { name: model.clone(), standing: None, answer }
        };
        let mut tried: Vec<Tried> = self.models.iter().map(one).collect();
        let fits: Vec<&Fit> = tried.iter().filter_map(|one| one.answer.as_ref().ok()).map(|one| &one.fit).collect();
        let standings = compared(&curve, &fits);
        let good = tried.iter_mut().filter(|one| one.answer.is_ok());
        good.zip(standings).for_each(|(one, standing)| one.standing = Some(standing));
        let ranked = tried.iter().filter_map(|one| Some((one.standing?.beyond_best, one.answer.as_ref().ok()?)));
        let Some((_, Answered { fit, scene, .. })) = ranked.min_by(|a, b| a.0.total_cmp(&b.0)) else {
            return Err(tried.into_iter().filter_map(Tried::why_not).collect::<Vec<_>>().join("; "));
        };
        let (fit, scene) = (fit.clone(), scene.clone());
        let models = if tried.len() > 1 { tried } else { Vec::new() };
        Ok(Fitted { file: name.to_owned(), scene, curve, fit, data_notes: Vec::new(), models })
    }
}

/// The question `measured` asks of a model.
fn question(measured: &Measured, model: &Candidate) -> Result<Question, String> {
    let Measured { baseline, contact, drive, way, loss, .. } = *measured;
    let spring = measured.spring.map(SpringStiffness::si);
    let mut options = Options { baseline, contact, drive, way, loss, spring, ..Options::default() };
    let told =
        |error: FitError| if model.name.is_empty() { error.to_string() } else { format!("{}: {error}", model.name) };
    let asked = |options| Question::new(&model.scene, &model.free, options).map_err(told);
    if !measured.range.is_empty() {
        let led = asked(options)?.led();
        options.range = range(&measured.range, led).map_err(|what| format!("range: {what}"))?;
    }
    let asked = asked(options)?.given(&model.given).map_err(told)?;
    // A model that has not both of them has no map.
    let mapped = |pair: &str| asked.clone().map(pair).map_err(told);
    match &measured.map[..] {
        "" => Ok(asked),
        pair if measured.models.is_empty() => mapped(pair),
        pair => Ok(mapped(pair).unwrap_or(asked)),
    }
}

/// The model a name or a scene file in `folder` stands for.
fn candidate(name: &str, plain: &Candidate, folder: &Path) -> Result<Candidate, String> {
    if let Some(varied) = plain.varied(name) {
        return varied.map_err(|error| error.to_string());
    }
    let path = folder.join(name);
    if !path.extension().is_some_and(|ending| ["ron", "json"].iter().any(|known| ending.eq_ignore_ascii_case(known))) {
        let advice = crate::text::advice(name, &Candidate::names());
        return Err(format!("there is no model `{name}`: {advice}; or a scene file"));
    }
    let told = |faults: Vec<Fault>| {
        let told = faults.iter().map(|fault| format!("{}: {}", fault.file.display(), fault.message));
        told.collect::<Vec<_>>().join("; ")
    };
    let file = SceneFile::load(&path).map_err(told)?;
    let (name, scene) = (file.stem(), file.plan.scene.clone());
    let asked = scene.fit.clone().unwrap_or_default();
    let or = |own: Vec<String>, common: &Vec<String>| if own.is_empty() { common.clone() } else { own };
    Ok(Candidate { name, free: or(asked.free, &plain.free), given: or(asked.given, &plain.given), scene })
}

/// The cantilever with its standard error, `spring=10 %` or `spring=0.002 N/m`.
fn spring(text: &str, stiffness: Option<f64>) -> Result<Given, String> {
    let value = stiffness.ok_or_else(|| {
        format!("given: \"{text}\" is of a cantilever that is not there: expected --spring \"0.05 N/m\" too")
    })?;
    let spread = text.split_once('=').map_or("", |(_, spread)| spread);
    let spread = match percent(spread) {
        Some(part) => part * value,
        None => {
            let read = spread.trim().parse::<SpringStiffness>();
            read.map_err(|error| format!("given: {SPRING}: {error}"))?.si()
        }
    };
    let given = Given { path: SPRING.to_owned(), value, spread, unit: "N/m" };
    given.checked(text).map_err(|error| format!("given: {error}"))
}

fn range(text: &str, led: Drive) -> Result<(f64, f64), String> {
    let (low, high) = text.split_once("..").ok_or_else(|| format!("\"{text}\" is no range: expected LO..HI"))?;
    let end = |text: &str, open: f64| match led {
        _ if text.trim().is_empty() => Ok(open),
        Drive::Depth | Drive::Slide => text.parse().map(Displacement::si).map_err(|error| error.to_string()),
        Drive::Speed => text.parse().map(Speed::si).map_err(|error| error.to_string()),
        Drive::Force => text.parse().map(Force::si).map_err(|error| error.to_string()),
    };
    let (low, high) = (end(low, f64::NEG_INFINITY)?, end(high, f64::INFINITY)?);
    if low < high { Ok((low, high)) } else { Err(format!("\"{text}\" is empty: expected the smaller end first")) }
}
