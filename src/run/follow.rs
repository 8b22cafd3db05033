//! A history followed stage by stage, record by record.

use super::record::{Field, Record};
use super::stresses::{Carried, SAME};
use super::{SimulationError, Wanted, fields};
use crate::contact::adhesion::equilibrium::Control;
use crate::contact::error::ContactError;
use crate::contact::model::{ContactModel, Effort, Pose};
use crate::contact::state::{Joined, Normal, Tangential};
use crate::drive::course::{Course, Extent, Path};
use crate::drive::{Driver, Loop};
use crate::scene::plan::Shared;
use crate::scene::stage::Stage;

/// A history being followed.
pub(super) struct Run {
    pub(super) contact: Box<dyn ContactModel>,
    driver: Driver,
    control: Control,
    slide: f64,
    time: f64,
    entry: usize,
    pub(super) records: Vec<Record>,
    pub(super) fields: Vec<Field>,
    /// The contact at its largest indentation; `None` until the way back begins.
    deepest: Option<Kept>,
    /// The contact that remembers at its greatest force, if fields are wanted.
    strongest: Option<Kept>,
    /// The force [N], entry and time [s] of the marked state, as long as the force has not fallen since.
    rising: Option<(f64, usize, f64)>,
    /// The contact at its greatest force, if it is to be drawn.
    pressed: Option<Kept>,
    wanted: Wanted,
    jumps: Vec<(Normal, Normal)>,
    pub(super) notes: Vec<String>,
    /// The load of the contact at its greatest force, if it is wanted.
    pub(super) carried: Option<Carried>,
    /// Largest error of the force at the ends of the stages [N].
    pub(super) force_error: f64,
    /// Largest error of the contact radius at the records [m].
    pub(super) radius_error: f64,
    /// Largest state at the ends of the stages.
    pub(super) effort: Effort,
}

/// A contact as it was when something was largest.
struct Kept {
    /// The largest: a depth [m] or a force [N].
    most: f64,
    contact: Box<dyn ContactModel>,
    entry: usize,
    time: f64,
}

/// Follows the history of a scene with a contact that just touches.
///
/// # Errors
/// The contact would leave its profile, or cannot be followed.
pub(super) fn follow(plan: &Shared, contact: Box<dyn ContactModel>, wanted: Wanted) -> Result<Run, SimulationError> {
    let stages = &plan.stages;
    let mut run = Run::new(contact, plan.accuracy(), wanted);
    for (number, stage) in stages.iter().enumerate() {
        run.follow_stage(stage).map_err(|source| SimulationError::Contact { entry: stage.entry, source })?;
        let ends_entry = stages.get(number + 1).is_none_or(|next| next.entry != stage.entry);
        if wanted.fields && ends_entry {
            run.fields.extend(run.field(format!("end of entry {}", stage.entry + 1)));
        }
    }
    run.look_deepest();
    let deepest = run.deepest.take();
    let field = deepest.and_then(|Kept { contact, entry, time, .. }| {
        fields::field(contact.as_ref(), format!("largest depth (entry {})", entry + 1), time)
    });
    fields::with_deepest(&mut run.fields, field);
    Ok(run)
}

impl Run {
    /// Depth [m] at which a retraction from where it is would part the bodies, where that depends on the present alone.
    pub(super) fn parts_at(&self) -> Option<f64> {
        self.contact.last_depth()?.ok()
    }

    /// What the last stage has prescribed: a depth or a force.
    pub(super) fn control(&self) -> Control {
        self.control
    }

    /// Tangential displacement at the end [m].
    pub(super) fn slide(&self) -> f64 {
        self.slide
    }

    /// What leads the contact, as the history leaves it.
    pub(super) fn driver(&self) -> &Driver {
        &self.driver
    }

    fn new(contact: Box<dyn ContactModel>, accuracy: f64, wanted: Wanted) -> Self {
        let mut run = Self {
            driver: Driver::new(contact.as_ref(), accuracy),
            contact,
            control: Control::Indentation,
            slide: 0.0,
            time: 0.0,
            entry: 0,
            records: Vec::new(),
            fields: Vec::new(),
            deepest: None,
            strongest: None,
            rising: None,
            pressed: None,
            wanted,
            jumps: Vec::new(),
            notes: Vec::new(),
            carried: None,
            force_error: 0.0,
            radius_error: 0.0,
            effort: Effort::default(),
        };
        run.record();
        run
    }

    /// Leads the contact through a stage: the drive moves it from record to record and says what happens on the way.
    fn follow_stage(&mut self, stage: &Stage) -> Result<(), ContactError> {
        self.entry = stage.entry;
        self.control = stage.control.unwrap_or(self.control);
        let start = self.time;
        let Some(course) = self.course(stage)? else {
            self.record();
            return Ok(());
        };
        self.driver.begin(self.contact.as_mut(), course, self.slide)?;
        for part in stage.parts() {
            self.advance(&course, part, start)?;
        }
        self.slide = course.tangential.at(self.slide, 1.0, course.over);
        self.observe();
        // By rounding they may have parted already.
        if let Path::UntilParted { speed } = stage.normal
            && self.contact.joined()
        {
            let held = self.driver.state(self.contact.as_ref());
            let parted = self.driver.part(self.contact.as_mut(), speed)?;
            self.jumps.push((held, parted));
            self.push(parted, self.contact.tangential(), self.time);
        }
        Ok(())
    }

    /// What is prescribed in a stage; a retraction becomes a ramp to the depth where the bodies part.
    fn course(&mut self, stage: &Stage) -> Result<Option<Course>, ContactError> {
        let (mut normal, mut over) = (stage.normal, stage.over);
        if let Path::UntilParted { speed } = stage.normal {
            if !self.contact.joined() {
                let entry = stage.entry;
                self.notes
                    .push(format!("history[{entry}]: the bodies have parted already; there is nothing to retract"));
                return Ok(None);
            }
            let to = self.driver.last_depth(self.contact.as_mut(), speed)?;
            let from = self.contact.position().unwrap_or(0.0);
            (normal, over) = (Path::To(to), (from - to).abs() / speed);
        }
        if self.leads_nowhere(stage) {
            return Ok(None);
        }
        Ok(Some(Course { control: self.control, normal, tangential: stage.tangential, over, extent: stage.extent }))
    }

    /// Whether a row of a table stands where the bodies are, without time between: it is no motion, and bodies that
    /// only touch stay free of each other.
    fn leads_nowhere(&self, stage: &Stage) -> bool {
        let there = |path: Path, now: f64| match path {
            Path::To(to) => (to - now).abs() <= 0.0,
            Path::Stay => true,
            Path::Wave(_) | Path::Steady { .. } | Path::UntilParted { .. } => false,
        };
        let depth = self.contact.position();
        let stays = depth.is_some_and(|depth| there(stage.normal, depth)) && there(stage.tangential, self.slide);
        self.control == Control::Indentation && stage.over <= 0.0 && stage.extent == Extent::Row && stays
    }

    /// To the part `part` of a stage that began at the time `start` [s], with what happens on the way.
    fn advance(&mut self, course: &Course, part: f64, start: f64) -> Result<(), ContactError> {
        let was_joined = self.contact.joined();
        if self.goes_back(course, part) {
            self.look_deepest();
        }
        let time = start + part * course.over;
        let mut parted = time;
        for event in self.driver.advance(self.contact.as_mut(), part)? {
            self.jumps.push((event.before, event.after));
            if self.wanted.instants {
                self.push(event.before, event.tangential, start + event.time);
                self.push(event.after, event.tangential, start + event.time);
            }
            parted = start + event.time;
        }
        if was_joined
            && !self.contact.joined()
            && self.control == Control::Force
            && self.driver.prescribed_at(part) < 0.0
        {
            self.notes.push(format!(
                "history[{}]: the prescribed force passes pull-off at t = {parted:e} s: the bodies part and stay apart",
                self.entry,
            ));
        }
        self.time = time;
        self.record();
        Ok(())
    }

    /// Whether what is prescribed falls on the way to the part `part` of the stage.
    fn goes_back(&self, course: &Course, part: f64) -> bool {
        let present = self.driver.state(self.contact.as_ref());
        let now = match course.control {
            Control::Indentation => self.contact.position().unwrap_or(0.0),
            Control::Force => present.force,
        };
        self.driver.prescribed_at(part) < now
    }

    /// Notes the error and the size of the contact at the end of a stage.
    fn observe(&mut self) {
        let effort = self.contact.effort();
        self.force_error = self.force_error.max(effort.force_error.unwrap_or(0.0));
        self.effort.bytes = self.effort.bytes.max(effort.bytes);
        self.effort.springs = effort.springs;
    }

    /// The present state as a record.
    fn record(&mut self) {
        let state = self.driver.state(self.contact.as_ref());
        let tangential = self.contact.tangential();
        self.push(state, tangential, self.time);
        let doubt = self.contact.effort().radius_error.unwrap_or(0.0);
        let missed = self.driver.missed(self.contact.as_ref()) * state.contact_radius.unwrap_or(0.0);
        self.radius_error = self.radius_error.max(doubt).max(missed);
        if self.wanted.fields && self.contact.memory().is_some() {
            self.look_at_force(state.force);
        }
        self.look_strongest(&state);
        if self.wanted.stresses && self.carried.as_ref().is_none_or(|carried| carried.is_below(&state, tangential)) {
            let loaded = self.contact.loading().and_then(|loading| loading.loaded());
            let carried = loaded.map(|loaded| Carried::new(loaded, &state, tangential));
            self.carried = carried.or(self.carried.take());
        }
    }

    fn push(&mut self, normal: Normal, tangential: Option<Tangential>, time: f64) {
        // What happened on the way there happened in another state.
        let present = |_: &Joined| self.contact.state().force.total_cmp(&normal.force).is_eq();
        let (gliding, joined) = (self.contact.gliding(), self.contact.pieces().filter(present));
        let (entry, worn, pixels, machine) = (self.entry, None, None, None);
        let record = Record { entry, time, normal, tangential, gliding, worn, pixels, joined, machine, spring: None };
        if self.records.last() != Some(&record) {
            self.records.push(record);
        }
        self.time = time;
    }

    fn field(&self, label: String) -> Option<Field> {
        fields::field(self.contact.as_ref(), label, self.time)
    }

    fn kept(&self, most: f64) -> Kept {
        Kept { most, contact: self.contact.copy(), entry: self.entry, time: self.time }
    }

    /// Keeps the present state to be drawn if it is joined and none before carried as much, to rounding: a force that is
    /// held is drawn as it is when it is reached.
    fn look_strongest(&mut self, state: &Normal) {
        let exceeds = |kept: &Kept| state.force > kept.most + SAME * kept.most.abs();
        let drawn = self.wanted.bed || self.wanted.surface;
        if drawn && self.contact.joined() && self.pressed.as_ref().is_none_or(exceeds) {
            self.pressed = Some(self.kept(state.force));
        }
    }

    /// The contact at its greatest force and the time [s] of that, if it was to be drawn.
    pub(super) fn at_greatest_force(&self) -> Option<(&dyn ContactModel, f64)> {
        self.pressed.as_ref().map(|kept| (kept.contact.as_ref(), kept.time))
    }

    /// What is wanted beside records.
    pub(super) fn wanted(&self) -> Wanted {
        self.wanted
    }

    /// The present time [s].
    pub(super) fn time(&self) -> f64 {
        self.time
    }

    /// Keeps the state at the greatest force: a contact that can is marked as long as the force rises, and copied as it
    /// was when it falls.
    fn look_at_force(&mut self, force: f64) {
        let most = self.rising.map(|(most, ..)| most).or(self.strongest.as_ref().map(|kept| kept.most));
        if most.is_some_and(|most| force < most) {
            self.strongest = self.marked().or(self.strongest.take());
            self.rising = None;
            self.contact.unmark();
        } else if self.contact.mark() {
            self.rising = Some((force, self.entry, self.time));
        } else {
            self.strongest = Some(self.kept(force));
        }
    }

    /// The contact at its mark, if that is where the force was greatest.
    fn marked(&self) -> Option<Kept> {
        let (most, entry, time) = self.rising?;
        Some(Kept { most, contact: self.contact.at_mark()?, entry, time })
    }

    /// Keeps the present state if none before was as deep.
    fn look_deepest(&mut self) {
        let present = self.driver.state(self.contact.as_ref());
        let Some(depth) = present.indentation.filter(|_| self.wanted.fields && self.contact.joined()) else { return };
        if self.deepest.as_ref().is_none_or(|deepest| depth > deepest.most) {
            self.deepest = Some(self.kept(depth));
        }
    }

    /// Largest pressure [Pa] of a contact that remembers at its greatest force; `None` where a field shows it or where it is
    /// singular. Bodies that relax have lost it by the end of the entry.
    pub(super) fn peak_at_greatest_force(&self) -> Option<f64> {
        let marked = self.marked();
        let kept = marked.as_ref().or(self.strongest.as_ref())?;
        let shown = self.fields.iter().any(|field| (field.time - kept.time).abs() <= 0.0);
        if shown { None } else { kept.contact.loading()?.peak() }
    }

    /// The sudden changes on the way, the states before and after, whether they are among the records or not.
    pub(super) fn jumps(&self) -> &[(Normal, Normal)] {
        &self.jumps
    }

    /// The straight steps the tangential contact has taken, if they were kept.
    pub(super) fn path(&self) -> &[Pose] {
        self.contact.path()
    }

    /// What is controlled at its end, and the tangential displacement [m] there.
    pub(super) fn ends_with(&self) -> (Control, f64) {
        (self.control, self.slide)
    }

    /// What the last loop of an oscillation says of the material.
    pub(super) fn last_loop(&self) -> Option<Loop> {
        self.driver.last_loop()
    }
}
