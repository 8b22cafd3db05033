//! A scene run from its first touch to the end of its history.

mod conditioning;
mod contact;
mod error;
mod fields;
mod fretting;
mod relaxing;
mod plane;
pub mod record;
mod results;
mod rough;
mod shear;
mod strike;

pub use contact::{ContactError, Direct, Drive, Event, Loop, Moment, NormalContact, Springs};
pub use plane::PlaneError;
pub use rough::LineTooShort;
pub use shear::{TangentialContact, sheared};

use crate::contact::adhesion::Adhesion;
use crate::contact::adhesion::equilibrium::Control;
use crate::contact::adhesion::line::EdgeLine;
use crate::contact::adhesion::range::RangeDisc;
use crate::contact::direct::{Attraction, QuasiStatic};
use crate::contact::springs::SpringBed;
use crate::contact::state::Normal;
use crate::run::record::{Field, Outcome, Record};
use crate::scene::plan;
use crate::scene::setup::Setup;
use crate::scene::stage::{Path, Stage, stages};
use shear::Step;
use std::num::NonZeroUsize;

/// Why a scene could not be run to its end.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SimulationError {
    /// The contact cannot follow what an entry prescribes.
    #[error("history[{entry}]: {source}")]
    Contact {
        /// Number of the entry.
        entry: usize,
        /// Why.
        source: ContactError,
    },
    /// The scene holds a part that cannot be computed.
    #[error("{0}")]
    Refused(String),
}

/// What is wanted beside records and results; what is not asked for is not computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Wanted {
    /// Pressure and surface profiles.
    pub fields: bool,
    /// Stresses below the surface.
    pub stresses: bool,
    /// Where in the contact friction takes its energy.
    pub fretting: bool,
}

impl Wanted {
    /// Records and results only.
    pub const NOTHING: Self = Self { fields: false, stresses: false, fretting: false };
}

/// The contact of a run: what presses, and what rubs if the scene has friction.
struct Contact<'p> {
    normal: Box<dyn NormalContact + 'p>,
    tangential: Option<Box<dyn TangentialContact + 'p>>,
}

/// Runs a scene.
///
/// The order: the plan picks a solver; the history becomes stages; each stage is followed record by
/// record, jumps between records included; then the named results are read off the records.
///
/// # Errors
/// The contact would leave its profile, or cannot be followed.
pub fn run(setup: &Setup, wanted: Wanted) -> Result<Outcome, SimulationError> {
    run_watched(setup, wanted, &|_| ())
}

/// Runs a scene; `done` is told the share of the work that is behind, from any thread, where it is long.
///
/// # Errors
/// As for [`run`].
pub fn run_watched(setup: &Setup, wanted: Wanted, done: &(dyn Fn(f64) + Sync)) -> Result<Outcome, SimulationError> {
    if let Some(surface) = &setup.surface {
        return rough::run(setup, surface, done);
    }
    if let Some(outcome) = plane::run(setup, wanted) {
        return outcome;
    }
    if let Some(impact) = strike::of(setup) {
        return strike::run(setup, impact, wanted);
    }
    let mut plan = plan::of(setup);
    let mut run = follow(setup, contact(setup, wanted)?, wanted)?;
    let mut error_estimate = error::estimate(setup, &run.records);
    if setup.relaxation.is_some() {
        let own = run.tangential.as_ref().map_or((0, 0), |tangential| (tangential.bytes(), tangential.springs()));
        (plan.state_bytes, plan.springs) = (run.bytes + own.0, run.contact.springs() + own.1);
        error_estimate = error::with_friction(setup, relaxing::error_estimate(setup, &run));
    }
    let stresses = if wanted.stresses { run.stresses(setup) } else { Vec::new() };
    let path = run.tangential.as_ref().map_or(&[][..], |tangential| tangential.path());
    let fretting = fretting::map(setup, path);
    let mut results = results::named(setup, &run.records, &run.fields);
    results.extend(relaxing::results(setup, &run));
    run.notes.extend(relaxing::remark(&run));
    Ok(Outcome {
        records: std::mem::take(&mut run.records),
        fields: std::mem::take(&mut run.fields),
        stresses,
        fretting,
        results,
        error_estimate,
        warnings: std::mem::take(&mut run.notes),
        plan,
        ensemble: None,
        impacts: None,
    })
}

/// The contact of a scene, bodies just touching.
fn contact(setup: &Setup, wanted: Wanted) -> Result<Contact<'_>, SimulationError> {
    if let Some(relaxation) = &setup.relaxation {
        let tangential = shear::of(setup, None, None)?;
        return Ok(Contact { normal: relaxing::contact(setup, relaxation), tangential });
    }
    let direct = direct(setup)?;
    let Some(springs) = setup.scene.springs else {
        let path = (wanted.fretting && fretting::is_fretting(setup)).then(Vec::new);
        return Ok(Contact { normal: Box::new(direct), tangential: shear::of(setup, None, path)? });
    };
    let (bed, reach) = springs_under(setup, springs, direct)?;
    let tangential = shear::of(setup, Some((springs, reach)), None)?;
    Ok(Contact { normal: Box::new(bed), tangential })
}

/// The direct path of a scene, bodies just touching.
///
/// # Errors
/// The attraction has no contact.
pub fn direct(setup: &Setup) -> Result<Direct<'_>, SimulationError> {
    let modulus = setup.pair.normal;
    let profile = setup.profile.as_ref();
    let attraction = match &setup.scene.adhesion {
        None => Attraction::Line(EdgeLine::new(profile, modulus, 0.0)),
        Some(Adhesion::Jkr(jkr)) => Attraction::Line(EdgeLine::new(profile, modulus, jkr.work.si())),
        Some(Adhesion::Maugis(maugis)) => {
            let disc = RangeDisc::new(profile, modulus, maugis.work.si(), maugis.stress.si());
            Attraction::Range(disc.map_err(|error| SimulationError::Refused(error.to_string()))?)
        }
    };
    let mut contact = QuasiStatic::new(profile, modulus, attraction);
    if let Attraction::Range(_) = attraction {
        // The bodies have come from far away: at d = 0 they attract each other already.
        contact.indent(0.0).map_err(|source| SimulationError::Contact { entry: 0, source: source.into() })?;
    }
    Ok(Direct::new(contact, modulus))
}

/// A bed of `springs` springs that is just wide enough for the history, as the direct path finds it,
/// and its half width [m].
fn springs_under(setup: &Setup, springs: NonZeroUsize, direct: Direct<'_>) -> Result<(Springs, f64), SimulationError> {
    let work = match &setup.scene.adhesion {
        Some(Adhesion::Jkr(jkr)) => jkr.work.si(),
        Some(Adhesion::Maugis(_)) => {
            return Err(SimulationError::Refused("springs: a bed of springs cannot carry Maugis adhesion".to_owned()));
        }
        None => 0.0,
    };
    let run = follow(setup, Contact { normal: Box::new(direct), tangential: None }, Wanted::NOTHING)?;
    let largest = run.records.iter().filter_map(|record| record.normal.contact_radius).fold(0.0, f64::max);
    let reach = SpringBed::reach_for(setup.profile.as_ref(), largest);
    let bed = SpringBed::new(setup.profile.as_ref(), (springs.get(), reach), setup.pair.normal, work);
    Ok((Springs::new(bed, setup.pair.normal), reach))
}

/// Where a step leads: the prescribed quantity, the tangential displacement [m], and the time as the
/// beginning of the stage and what has passed since [s].
#[derive(Debug, Clone, Copy)]
struct Aim {
    prescribed: f64,
    slide: f64,
    since: (f64, f64),
}

impl Aim {
    fn time(&self) -> f64 {
        self.since.0 + self.since.1
    }
}

/// A history being followed.
struct Run<'p> {
    contact: Box<dyn NormalContact + 'p>,
    tangential: Option<Box<dyn TangentialContact + 'p>>,
    control: Control,
    slide: f64,
    /// Sliding speed of the present stage [m/s].
    speed: f64,
    time: f64,
    entry: usize,
    records: Vec<Record>,
    fields: Vec<Field>,
    /// The largest indentation [m] and the field there; `None` until the way back begins.
    deepest: Option<(f64, Field)>,
    wanted: Wanted,
    notes: Vec<String>,
    loaded: Option<Normal>,
    /// Largest error of the force at the ends of the stages [N].
    force_error: f64,
    /// Largest state [bytes].
    bytes: usize,
}

fn follow<'p>(setup: &Setup, contact: Contact<'p>, wanted: Wanted) -> Result<Run<'p>, SimulationError> {
    let stages = stages(setup.entries(), setup.scene.steps.map(NonZeroUsize::get));
    let mut run = Run {
        contact: contact.normal,
        tangential: contact.tangential,
        control: Control::Indentation,
        slide: 0.0,
        speed: 0.0,
        time: 0.0,
        entry: 0,
        records: Vec::new(),
        fields: Vec::new(),
        deepest: None,
        wanted,
        notes: Vec::new(),
        loaded: None,
        force_error: 0.0,
        bytes: 0,
    };
    run.push(run.contact.state(), 0.0);
    for (number, stage) in stages.iter().enumerate() {
        run.follow_stage(stage).map_err(|source| SimulationError::Contact { entry: stage.entry, source })?;
        let ends_entry = stages.get(number + 1).is_none_or(|next| next.entry != stage.entry);
        if wanted.fields && ends_entry {
            run.fields.extend(run.field(format!("end of entry {}", stage.entry + 1)));
        }
    }
    run.look_deepest();
    fields::with_deepest(&mut run.fields, run.deepest.take().map(|(_, field)| field));
    Ok(run)
}

impl Run<'_> {
    fn follow_stage(&mut self, stage: &Stage) -> Result<(), ContactError> {
        self.entry = stage.entry;
        self.control = stage.control.unwrap_or(self.control);
        let (from, slide, start) = (self.prescribed(), self.slide, self.time);
        let (normal, over) = self.resolved(stage)?;
        self.speed = if let Path::To(to) = stage.tangential { (to - slide).abs() / over } else { 0.0 };
        self.contact.begin(&Drive { control: self.control, path: normal, over, extent: stage.extent })?;
        for part in stage.parts() {
            let aim = Aim {
                prescribed: normal.at(from, (part, over)),
                slide: stage.tangential.at(slide, (part, over)),
                since: (start, part * over),
            };
            self.advance(aim)?;
        }
        self.observe();
        if let Path::UntilParted { .. } = stage.normal {
            self.part()?;
        }
        Ok(())
    }

    /// The path and duration of a stage; a retraction becomes a ramp to the depth where the bodies part.
    fn resolved(&mut self, stage: &Stage) -> Result<(Path, f64), ContactError> {
        let Path::UntilParted { speed } = stage.normal else { return Ok((stage.normal, stage.over)) };
        if !self.contact.joined() {
            self.notes
                .push(format!("history[{}]: the bodies have parted already; there is nothing to retract", stage.entry));
            return Ok((Path::Stay, 0.0));
        }
        let to = self.contact.last_depth(speed)?;
        Ok((Path::To(to), (self.prescribed() - to).abs() / speed))
    }

    /// Present value of what is prescribed; a body that has come free starts again from first touch.
    fn prescribed(&self) -> f64 {
        let state = self.contact.state();
        match self.control {
            Control::Indentation => state.indentation.unwrap_or(0.0),
            Control::Force => state.force,
        }
    }

    /// Moves on straight lines to `to`.
    ///
    /// The order: the normal contact goes first, for nothing it does depends on friction (the bodies are
    /// taken as elastically similar); its jumps are recorded; the tangential contact follows along
    /// the depths the normal one has gone through; the record of both is last.
    fn advance(&mut self, to: Aim) -> Result<(), ContactError> {
        let (from, since) = (self.prescribed(), self.time);
        let (value, over) = (to.prescribed, to.time() - since);
        let was_joined = self.contact.joined();
        if value < from {
            self.look_deepest();
        }
        if (value - from).abs() > 0.0 {
            self.tangential.iter_mut().for_each(|tangential| tangential.let_go());
        }
        for event in self.contact.advance(self.control, value, to.since.1)? {
            let at = match event.at {
                Moment::Time(elapsed) => to.since.0 + elapsed,
                Moment::Value(passed) if (value - from).abs() > 0.0 => {
                    since + ((passed - from) / (value - from)).clamp(0.0, 1.0) * over
                }
                Moment::Value(_) => since,
            };
            self.push(event.before, at);
            self.push(event.after, at);
        }
        if was_joined && !self.contact.joined() && self.control == Control::Force && value < 0.0 {
            self.notes.push(format!(
                "history[{}]: the prescribed force passes pull-off at t = {:e} s: the bodies part and stay apart",
                self.entry,
                to.time()
            ));
        }
        self.shear(from, to, over)?;
        self.push(self.contact.state(), to.time());
        Ok(())
    }

    /// The tangential part of a step; where it begins suddenly, that is a record too.
    fn shear(&mut self, from: f64, to: Aim, over: f64) -> Result<(), ContactError> {
        let slide = (std::mem::replace(&mut self.slide, to.slide), to.slide);
        let Some(tangential) = &mut self.tangential else { return Ok(()) };
        let prescribed = (from, to.prescribed);
        let step =
            Step { contact: self.contact.as_ref(), control: self.control, prescribed, slide, speed: self.speed, over };
        let Some(onset) = tangential.advance(&step)? else { return Ok(()) };
        let normal = tangential.normal(self.contact.state());
        self.records.push(Record { entry: self.entry, time: self.time, normal, tangential: Some(onset) });
        Ok(())
    }

    /// The instant in which a retracted contact parts: a hair below the last stable depth.
    fn part(&mut self) -> Result<(), ContactError> {
        for event in self.contact.part()? {
            self.push(event.after, self.time);
        }
        Ok(())
    }

    /// Notes the error and the size of the contact at the end of a stage.
    fn observe(&mut self) {
        let error = self.contact.force_error().unwrap_or(0.0);
        self.force_error = self.force_error.max(error);
        self.bytes = self.bytes.max(self.contact.bytes());
    }

    fn push(&mut self, normal: Normal, time: f64) {
        let tangential = self.tangential.as_ref().map(|tangential| tangential.state());
        let normal = self.tangential.as_ref().map_or(normal, |tangential| tangential.normal(normal));
        let record = Record { entry: self.entry, time, normal, tangential };
        if self.records.last() != Some(&record) {
            self.records.push(record);
        }
        self.time = time;
        if self.loaded.is_none_or(|most| normal.force > most.force) {
            self.loaded = Some(normal);
        }
    }

    fn field(&self, label: String) -> Option<Field> {
        fields::field((self.contact.as_ref(), self.tangential.as_deref()), label, self.time)
    }

    /// Keeps the field of the present state if no state before was as deep.
    fn look_deepest(&mut self) {
        let Some(depth) = self.contact.state().indentation.filter(|_| self.wanted.fields) else { return };
        if self.deepest.as_ref().is_none_or(|(most, _)| depth > *most) {
            let field = self.field(format!("largest depth (entry {})", self.entry + 1));
            self.deepest = field.map(|field| (depth, field)).or(self.deepest.take());
        }
    }

    fn stresses(&self, setup: &Setup) -> Vec<crate::contact::stress::StressRow> {
        self.loaded.map_or_else(Vec::new, |normal| fields::stresses(setup, &normal))
    }
}
