//! Contacts that remember: a viscoelastic bed followed through a history.
//!
//! A stage is a sequence of straight pieces of the depth, chosen before a record is looked at: one
//! for a ramp or a hold, chords of the sine for an oscillation, pieces found by an error estimate for
//! a prescribed force. A record is a look at the bed from the beginning of its piece and changes
//! nothing, so no answer depends on how many there are.

mod bed;
mod chords;
mod cycle;
mod instants;

use super::contact::{ContactError, Drive, Event, Loop, Moment, NormalContact};
use super::follow::Run;
use crate::contact::adhesion::equilibrium::Control;
use crate::contact::adhesion::line::Energy;
use crate::contact::state::Normal;
use crate::contact::viscoelastic::Spectrum;
use crate::contact::viscoelastic::creep::Creep;
use crate::contact::viscoelastic::drive::{Springs, State};
use crate::contact::viscoelastic::layout::Layout;
use crate::contact::viscoelastic::memory::{BedError, Memory};
use crate::contact::viscoelastic::opening::Attraction;
use crate::contact::viscoelastic::pressing::{Pressing, Ramp};
use crate::material::Relaxation;
use crate::run::named::Named;
use crate::run::unit::Unit;
use crate::scene::law::{GRADE, HeldEdge};
use crate::scene::plan::RoundPlan;
use crate::scene::stage::{Extent, Path};
use crate::shape::Profile;
use bed::ReadBed;
use chords::Chords;
use cycle::Cycle;
use instants::{Instant, Straight, instants, looks};
use std::collections::VecDeque;
use std::f64::consts::TAU;
use std::sync::Arc;

/// A viscoelastic contact on its way through a stage.
#[derive(Debug, Clone)]
pub struct Relaxing<B> {
    /// At the beginning of the present piece.
    bed: B,
    /// At the last record, if that was inside the piece.
    seen: Option<B>,
    piece: Option<Piece>,
    course: Course,
    profile: Arc<dyn Profile>,
    /// Exact creep, as long as the contact has only grown under a prescribed force.
    creep: Option<Creep>,
    /// Time of the last record since the beginning of the stage [s].
    until: f64,
    /// Largest force so far [N], against which errors are measured.
    largest: f64,
    accuracy: f64,
    /// Largest depth so far [m].
    deepest: f64,
    parted: bool,
    /// Speed of the present piece, either way [m/s].
    speed: f64,
    /// Force in the middle of the last chord.
    middle: Option<f64>,
    /// The last cycle of the last oscillation.
    cycle: Cycle,
}

/// The rest of a stage.
#[derive(Debug, Clone)]
enum Course {
    /// At constant speed to this depth [m] until this time [s].
    Straight(f64, f64, Extent),
    /// Chords of a sine.
    Chords(Chords),
    /// Under a prescribed force.
    Force(Pressing),
    /// Nothing is left.
    Done,
}

/// A straight piece of the depth within a stage.
#[derive(Debug, Clone)]
struct Piece {
    /// Depth at its end [m].
    to: f64,
    /// Times of its beginning and end since the beginning of the stage [s].
    time: (f64, f64),
    instants: VecDeque<Instant>,
}

impl<B: ReadBed> Relaxing<B> {
    /// A contact on the bed `bed`, never touched; `creep` if it follows the exact creep.
    fn new(bed: B, (profile, creep): (Arc<dyn Profile>, Option<Creep>), accuracy: f64) -> Self {
        Self {
            bed,
            profile,
            seen: None,
            piece: None,
            course: Course::Done,
            creep,
            until: 0.0,
            largest: 0.0,
            accuracy,
            deepest: 0.0,
            parted: false,
            speed: 0.0,
            middle: None,
            cycle: Cycle::default(),
        }
    }

    fn seen(&self) -> &B {
        self.seen.as_ref().unwrap_or(&self.bed)
    }

    /// State of the bed, with depth and force exact where the creep is.
    fn exact_state(&self) -> State {
        let state = self.seen().state();
        let Course::Force(pressing) = &self.course else { return self.within_reach(state) };
        let Some(indentation) = pressing.exact(self.until).and_then(|creep| creep.indentation()) else {
            return self.within_reach(state);
        };
        let contact_radius = self.profile.edge(indentation).filter(|_| indentation > 0.0).unwrap_or(0.0);
        let stiffness = 2.0 * self.bed.spectrum().instantaneous() * contact_radius;
        State { indentation, force: pressing.prescribed(self.until), contact_radius, stiffness, ..state }
    }

    /// The state of a contact that ends where g is the largest depth so far at the farthest, and ends there
    /// if it is as deep as that.
    fn within_reach(&self, state: State) -> State {
        let Some(reach) = self.profile.edge(self.deepest.max(state.indentation)) else { return state };
        let grows = state.indentation >= self.deepest;
        if state.contact_radius <= 0.0 || (!grows && state.contact_radius <= reach) {
            return state;
        }
        State { contact_radius: reach, stiffness: 2.0 * self.bed.spectrum().instantaneous() * reach, ..state }
    }

    /// A jump of the depth, so fast that nothing relaxes.
    fn jump(&mut self, to: f64) -> Result<(), ContactError> {
        if (to - self.bed.state().indentation).abs() <= 0.0 {
            return Ok(());
        }
        if self.bed.spectrum().viscosity() > 0.0 {
            return Err(ContactError::Jump { to });
        }
        let instant = self.bed.spectrum().instant();
        Ok(self.bed.reach(to, instant)?)
    }

    fn begin_force(&mut self, from: f64, path: Path, over: f64) -> Result<(), ContactError> {
        let to = if let Path::To(to) = path { to } else { from };
        self.creep = self.creep.take().filter(|creep| to >= creep.force());
        self.largest = self.largest.max(from.abs()).max(to.abs());
        let mut duration = over;
        if over <= 0.0 {
            duration = self.bed.spectrum().instant();
        }
        let ramp = Ramp { from, rate: (to - from) / duration, accuracy: self.accuracy, scale: self.largest };
        let mut pressing = Pressing::new(ramp, duration);
        if let Some(creep) = self.creep.take() {
            self.creep = Some(creep.after(to, over));
            pressing = pressing.along(creep);
        }
        self.course = Course::Force(pressing);
        if over <= 0.0 {
            while let Some(piece) = self.next_piece()? {
                self.finish(&piece)?;
            }
            self.course = Course::Done;
        }
        Ok(())
    }

    /// The bodies part under a pull, and the indenter is taken away.
    fn let_go(&mut self) -> Option<Event> {
        let Course::Force(pressing) = &self.course else { return None };
        let (time, before) = (pressing.now(), self.normal(&self.bed.state()));
        self.bed.leave();
        (self.parted, self.seen) = (true, None);
        Some(Event { at: Moment::Time(time), before, after: self.normal(&self.bed.state()) })
    }

    /// The next piece of the stage, with what happens on it.
    fn next_piece(&mut self) -> Result<Option<Piece>, ContactError> {
        let since = self.piece.as_ref().map_or(0.0, |piece| piece.time.1);
        let depth = self.bed.state().indentation;
        let (to, end, extent) = match &mut self.course {
            Course::Done => return Ok(None),
            &mut Course::Straight(to, end, extent) => {
                self.course = Course::Done;
                (to, end, Some(extent))
            }
            Course::Chords(chords) => match chords.next() {
                Some((to, end)) => (to, end, Some(Extent::Row)),
                None => return Ok(None),
            },
            Course::Force(pressing) => match pressing.next(&mut self.bed)? {
                Some(piece) => (depth + piece.speed * (piece.until - since), piece.until, None),
                None => return Ok(None),
            },
        };
        let straight = Straight { speed: (to - depth) / (end - since), duration: end - since };
        self.speed = straight.speed.abs();
        let instants = extent.map_or_else(|| Ok(Vec::new()), |extent| self.instants(&straight, extent))?;
        Ok(Some(Piece { to, time: (since, end), instants: instants.into() }))
    }

    fn instants(&mut self, straight: &Straight, extent: Extent) -> Result<Vec<Instant>, BedError> {
        if straight.duration <= 0.0 {
            return Ok(Vec::new());
        }
        let times = match extent {
            Extent::Row => [0.5, 1.0].map(|part| part * straight.duration).to_vec(),
            Extent::Entry => looks(straight.duration, 1e20 * self.bed.spectrum().instant()),
        };
        let mut found = instants(&mut self.bed, straight, &times)?;
        if let Course::Chords(chords) = self.course {
            self.cycle.watch(&mut self.bed, &chords, straight)?;
            // The force of a path with corners turns at the corners more often than between them.
            let state = self.bed.state();
            let middle = self.bed.force_after(straight.speed, times[0])?;
            let before = self.middle.replace(middle);
            if before.is_some_and(|before| (state.force - before) * (state.force - middle) > 0.0) {
                found.insert(0, Instant { time: 0.0, before: state, after: state });
            }
        }
        Ok(found)
    }

    /// Takes the bed to the end of a piece.
    fn finish(&mut self, piece: &Piece) -> Result<(), ContactError> {
        self.seen = None;
        self.deepest = self.deepest.max(piece.to);
        Ok(self.bed.reach(piece.to, piece.time.1 - piece.time.0)?)
    }

    fn normal(&self, state: &State) -> Normal {
        Normal {
            indentation: (!self.parted).then_some(state.indentation),
            force: state.force,
            contact_radius: Some(state.contact_radius),
            stiffness: state.stiffness,
            stored: Energy { elastic: state.ledger.stored, surface: 0.0 },
            dissipated: state.ledger.dissipated,
        }
    }

    /// The instants of the present piece up to the time `until` of the stage.
    fn passed(&mut self, until: f64, events: &mut Vec<Event>) {
        let Some(piece) = &mut self.piece else { return };
        let mut taken = Vec::new();
        while let Some(instant) = piece.instants.pop_front() {
            if piece.time.0 + instant.time > until {
                piece.instants.push_front(instant);
                break;
            }
            taken.push((piece.time.0 + instant.time, instant));
        }
        events.extend(taken.into_iter().map(|(time, instant)| Event {
            at: Moment::Time(time),
            before: self.normal(&instant.before),
            after: self.normal(&instant.after),
        }));
    }
}

impl<B: ReadBed + 'static> NormalContact for Relaxing<B> {
    fn begin(&mut self, drive: &Drive) -> Result<(), ContactError> {
        let force = self.exact_state().force;
        self.largest = self.largest.max(force.abs());
        (self.piece, self.until, self.middle) = (None, 0.0, None);
        if drive.control == Control::Force {
            self.begin_force(force, drive.path, drive.over)?;
        } else {
            self.creep = None;
            self.parted = false;
            let depth = self.bed.state().indentation;
            self.course = match drive.path {
                Path::Wave { amplitude, frequency } => {
                    Course::Chords(Chords::new(depth, (amplitude, frequency), drive.over, self.accuracy))
                }
                Path::To(to) if drive.over <= 0.0 => {
                    self.jump(to)?;
                    Course::Done
                }
                Path::To(to) => Course::Straight(to, drive.over, drive.extent),
                Path::Stay | Path::UntilParted { .. } => Course::Straight(depth, drive.over, drive.extent),
            };
        }
        self.piece = self.next_piece()?;
        Ok(())
    }

    fn advance(&mut self, _control: Control, _to: f64, until: f64) -> Result<Vec<Event>, ContactError> {
        let mut events = Vec::new();
        while let Some(end) = self.piece.as_ref().map(|piece| piece.time.1) {
            self.passed(until, &mut events);
            if until < end {
                break;
            }
            if let Some(piece) = self.piece.clone() {
                self.finish(&piece)?;
            }
            self.piece = self.next_piece()?;
        }
        if let Some(piece) = &self.piece {
            let mut seen = self.bed.clone();
            let speed = (piece.to - seen.state().indentation) / (piece.time.1 - piece.time.0);
            seen.advance(speed, until - piece.time.0)?;
            self.seen = Some(seen);
        }
        self.until = until;
        if let Course::Force(pressing) = &self.course
            && pressing.parted()
            && !self.parted
        {
            events.extend(self.let_go());
        }
        Ok(events)
    }

    fn state(&self) -> Normal {
        self.normal(&self.exact_state())
    }

    fn last_depth(&self, speed: f64) -> Result<f64, ContactError> {
        let start = self.bed.state().indentation;
        let mut bed = self.bed.clone();
        let mut high = start.abs().max(1e-300) / speed;
        while bed.glance(-speed, high)?.1 > 0.0 {
            high *= 2.0;
        }
        let mut low = 0.0;
        while low < 0.5 * (low + high) && 0.5 * (low + high) < high {
            let middle = 0.5 * (low + high);
            *(if bed.glance(-speed, middle)?.1 > 0.0 { &mut low } else { &mut high }) = middle;
        }
        Ok(start - speed * low)
    }

    fn part(&mut self) -> Result<Vec<Event>, ContactError> {
        let (before, depth) = (self.state(), self.bed.state().indentation);
        // On at the same speed for as short a time as it takes.
        let mut duration = f64::EPSILON * self.until;
        while self.bed.glance(-self.speed, duration)?.1 > 0.0 && duration < self.until {
            duration *= 2.0;
        }
        self.bed.advance(-self.speed, duration)?;
        self.bed.reach(depth, f64::MIN_POSITIVE.max(duration * f64::EPSILON))?;
        Ok(vec![Event { at: Moment::Time(self.until), before, after: self.state() }])
    }

    fn pressure(&self, r: f64) -> Option<f64> {
        Some(self.seen().pressure(r)).filter(|pressure| pressure.is_finite())
    }

    fn surface(&self, r: f64) -> Option<f64> {
        Some(self.seen().surface(r)).filter(|displacement| displacement.is_finite())
    }

    fn stress_intensity(&self) -> Option<f64> {
        None
    }

    fn joined(&self) -> bool {
        self.seen().state().contact_radius > 0.0
    }

    fn reach(&self) -> f64 {
        self.seen().state().contact_radius
    }

    fn force_error(&self) -> Option<f64> {
        self.seen().force_error()
    }

    fn bytes(&self) -> usize {
        self.seen().bytes()
    }

    fn springs(&self) -> usize {
        self.seen().springs()
    }

    fn last_loop(&self) -> Option<Loop> {
        self.cycle.moduli()
    }

    fn snapshot(&self) -> Box<dyn NormalContact + '_> {
        Box::new(self.clone())
    }
}

/// The continuous bed of a scene, bodies just touching: for a depth in few straight pieces.
pub fn continuous(plan: &RoundPlan, relaxation: &Relaxation, edge: Option<&HeldEdge>) -> Box<dyn NormalContact> {
    let spectrum = Arc::new(Spectrum::new(relaxation));
    let attraction = edge.map(|edge| edge.attraction(&spectrum));
    let creep = attraction.is_none().then(|| Creep::new(spectrum.clone(), plan.profile.clone()));
    Box::new(Relaxing::new(memory(plan, spectrum, attraction), (plan.profile.clone(), creep), plan.accuracy()))
}

/// The bed of `count` springs of a scene, bodies just touching: for an oscillation and a prescribed force, which
/// need hundreds of straight pieces, each of which would leave a strip behind in the continuous bed.
pub fn springs(plan: &RoundPlan, relaxation: &Relaxation, count: usize) -> Box<dyn NormalContact> {
    let (spectrum, profile) = (Arc::new(Spectrum::new(relaxation)), plan.profile.clone());
    let creep = Creep::new(spectrum.clone(), profile.clone());
    let reach = reach(plan, &spectrum);
    let layout = Layout::graded(profile.as_ref(), (GRADE * reach, reach), count);
    let bed = Springs::new(spectrum, profile.clone(), layout);
    Box::new(Relaxing::new(bed, (profile, Some(creep)), plan.accuracy()))
}

/// The contact of an adhesive scene with the edge followed in half the steps.
pub fn refined(plan: &RoundPlan, relaxation: &Relaxation, edge: &HeldEdge) -> Box<dyn NormalContact> {
    let spectrum = Arc::new(Spectrum::new(relaxation));
    let attraction = edge.attraction(&spectrum).refined();
    Box::new(Relaxing::new(memory(plan, spectrum, Some(attraction)), (plan.profile.clone(), None), plan.accuracy()))
}

fn memory(plan: &RoundPlan, spectrum: Arc<Spectrum>, attraction: Option<Attraction>) -> Memory {
    attraction.into_iter().fold(Memory::new(spectrum, plan.profile.clone()), Memory::with)
}

/// A radius [m] the contact of a scene does not outgrow: of its largest depth, or of the creep under its
/// largest force over all its time.
fn reach(plan: &RoundPlan, spectrum: &Arc<Spectrum>) -> f64 {
    let (mut depth, mut force, mut time) = (0f64, 0f64, 0.0);
    let mut before = 0.0;
    for stage in &plan.stages {
        time += stage.over;
        match (stage.control, stage.normal) {
            (Some(Control::Force), Path::To(to)) => force = force.max(to),
            (Some(Control::Indentation), Path::To(to)) => (before, depth) = (to, depth.max(to)),
            (_, Path::Wave { amplitude, .. }) => depth = depth.max(before.max(depth) + amplitude),
            _ => {}
        }
    }
    let creep = Creep::new(spectrum.clone(), plan.profile.clone()).after(force, 0.0).after(force, time);
    let deepest = depth.max(creep.indentation().unwrap_or(0.0));
    plan.profile.edge(deepest).filter(|&reach| reach > 0.0).unwrap_or_else(|| plan.profile.scale())
}

/// Named results of a viscoelastic contact alone: the moduli of the last loop, and what is expected of
/// the same contact if its edge stood still.
pub fn results(plan: &RoundPlan, run: &Run<'_>) -> Vec<Named> {
    let (Some(found), Some(relaxation)) = (run.contact.last_loop(), plan.contact.relaxation()) else {
        return Vec::new();
    };
    let (spectrum, omega) = (Spectrum::new(relaxation), TAU * found.frequency);
    let expected = (spectrum.storage(omega), spectrum.loss(omega));
    let all = [
        ("storage_modulus", Unit::PASCAL, found.storage),
        ("loss_modulus", Unit::PASCAL, found.loss),
        ("loss_tangent", Unit::ONE, found.loss / found.storage),
        ("expected_storage_modulus", Unit::PASCAL, expected.0),
        ("expected_loss_modulus", Unit::PASCAL, expected.1),
        ("expected_loss_tangent", Unit::ONE, expected.1 / expected.0),
    ];
    all.into_iter().map(|(quantity, unit, value)| Named::number(quantity, unit, value)).collect()
}

/// What a user must know of the comparison of a loop with the moduli.
pub fn remark(run: &Run<'_>) -> Option<String> {
    let found = run.contact.last_loop()?;
    Some(format!(
        "storage and loss are those of the effective modulus E* from the first harmonics of the last cycle at its mean contact radius; they are compared with E*′(ω) and E*″(ω), which a contact has whose edge stands still: the edge of this one moves by {:.2} % of the radius",
        100.0 * found.swing
    ))
}
