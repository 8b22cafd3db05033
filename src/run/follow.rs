//! A history followed stage by stage, record by record.

use super::contact::{ContactError, Drive, Moment, NormalContact};
use super::record::{Field, Record};
use super::shear::{Step, TangentialContact};
use super::table::Table;
use super::{Contact, SimulationError, Wanted, fields};
use crate::contact::adhesion::equilibrium::Control;
use crate::contact::state::Normal;
use crate::scene::plan::RoundPlan;
use crate::scene::stage::{Path, Stage};

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
pub(super) struct Run<'p> {
    pub(super) contact: Box<dyn NormalContact + 'p>,
    pub(super) tangential: Option<Box<dyn TangentialContact + 'p>>,
    pub(super) control: Control,
    pub(super) slide: f64,
    /// Sliding speed of the present stage [m/s].
    pub(super) speed: f64,
    pub(super) time: f64,
    pub(super) entry: usize,
    pub(super) records: Vec<Record>,
    pub(super) fields: Vec<Field>,
    /// The largest indentation [m] and the field there; `None` until the way back begins.
    pub(super) deepest: Option<(f64, Field)>,
    pub(super) wanted: Wanted,
    pub(super) notes: Vec<String>,
    pub(super) loaded: Option<Normal>,
    /// Largest error of the force at the ends of the stages [N].
    pub(super) force_error: f64,
    /// Largest state [bytes].
    pub(super) bytes: usize,
}

pub(super) fn follow<'p>(stages: &[Stage], contact: Contact<'p>, wanted: Wanted) -> Result<Run<'p>, SimulationError> {
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

    pub(super) fn stresses(&self, plan: &RoundPlan) -> Option<Table> {
        fields::stresses(plan, &plan.ground(), &self.loaded?)
    }
}
