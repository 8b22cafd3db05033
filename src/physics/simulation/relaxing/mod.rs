//! Contacts that remember: a viscoelastic bed followed through a history.
//!
//! A stage is a sequence of straight pieces of the depth, chosen before a record is looked at: one
//! for a ramp or a hold, chords of the sine for an oscillation, pieces found by an error estimate for
//! a prescribed force. A record is a look at the bed from the beginning of its piece and changes
//! nothing, so no answer depends on how many there are.

mod bed;
mod chords;
mod instants;

use super::Run;
use super::contact::{ContactError, Drive, Event, Moment, NormalContact};
use crate::physics::adhesion::equilibrium::Control;
use crate::physics::adhesion::line::Energy;
use crate::physics::adhesion::{Adhesion, Edge};
use crate::physics::history::{Driven, Entry, Motion};
use crate::physics::material::Relaxation;
use crate::physics::record::{ErrorEstimate, Normal};
use crate::physics::setup::Setup;
use crate::physics::shape::Profile;
use crate::physics::stage::{Extent, Path, stages};
use crate::physics::viscoelastic::Spectrum;
use crate::physics::viscoelastic::creep::Creep;
use crate::physics::viscoelastic::drive::{Springs, State};
use crate::physics::viscoelastic::layout::Layout;
use crate::physics::viscoelastic::memory::{BedError, Memory};
use crate::physics::viscoelastic::opening::Attraction;
use crate::physics::viscoelastic::pressing::{Pressing, Ramp};
use bed::ReadBed;
use chords::Chords;
use instants::{Instant, Straight, instants, looks};
use std::collections::VecDeque;
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
    parted: bool,
    /// Force in the middle of the last chord, and the instant between the last two.
    middle: Option<f64>,
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
            parted: false,
            middle: None,
        }
    }

    fn seen(&self) -> &B {
        self.seen.as_ref().unwrap_or(&self.bed)
    }

    /// State of the bed, with depth and force exact where the creep is.
    fn exact_state(&self) -> State {
        let state = self.seen().state();
        let Course::Force(pressing) = &self.course else { return state };
        let Some(indentation) = pressing.exact(self.until).and_then(|creep| creep.indentation()) else { return state };
        let contact_radius = self.profile.edge(indentation).filter(|_| indentation > 0.0).unwrap_or(0.0);
        let stiffness = 2.0 * self.bed.spectrum().instantaneous() * contact_radius;
        State { indentation, force: pressing.prescribed(self.until), contact_radius, stiffness, ..state }
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
        let instants = extent.map_or_else(|| Ok(Vec::new()), |extent| self.instants(&straight, extent))?;
        Ok(Some(Piece { to, time: (since, end), instants: instants.into() }))
    }

    fn instants(&mut self, straight: &Straight, extent: Extent) -> Result<Vec<Instant>, BedError> {
        if straight.duration <= 0.0 {
            return Ok(Vec::new());
        }
        let times = match extent {
            Extent::Row => vec![0.5 * straight.duration, straight.duration],
            Extent::Entry => looks(straight.duration, 1e20 * self.bed.spectrum().instant()),
        };
        let mut found = instants(&mut self.bed, straight, &times)?;
        if let Course::Chords(_) = self.course {
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
        self.largest = self.largest.max(self.seen().state().force.abs());
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
        let instant = self.bed.spectrum().instant();
        self.bed.reach(depth - 1e-9 * depth.abs(), instant)?;
        let after = Normal { indentation: before.indentation, ..self.state() };
        Ok(vec![Event { at: Moment::Time(self.until), before, after }])
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

    fn snapshot(&self) -> Box<dyn NormalContact + '_> {
        Box::new(self.clone())
    }
}

/// The contact of a scene with a viscoelastic body, bodies just touching.
///
/// A depth in few straight pieces is followed by the continuous bed. An oscillation and a prescribed
/// force need hundreds of pieces, each of which would leave a strip behind: there a bed of springs
/// does it, as fine as the accuracy asks for.
pub fn contact(setup: &Setup, relaxation: &Relaxation) -> Box<dyn NormalContact> {
    let (spectrum, profile) = (Arc::new(Spectrum::new(relaxation)), setup.profile.clone());
    let accuracy = setup.accuracy();
    let attraction = attraction(setup, &spectrum);
    let creep = attraction.is_none().then(|| Creep::new(spectrum.clone(), profile.clone()));
    match springs_wanted(setup).filter(|_| attraction.is_none()) {
        Some(count) => {
            let reach = reach(setup, &spectrum);
            let layout = Layout::graded(profile.as_ref(), (GRADE * reach, reach), count);
            Box::new(Relaxing::new(Springs::new(spectrum, profile.clone(), layout), (profile, creep), accuracy))
        }
        None => {
            let bed = Memory::new(spectrum, profile.clone());
            let bed = attraction.into_iter().fold(bed, Memory::with);
            Box::new(Relaxing::new(bed, (profile, creep), accuracy))
        }
    }
}

/// Springs are equally wide up to this part of the largest contact, and in geometric progression beyond.
const GRADE: f64 = 1.0 / 32.0;

/// The number of springs a scene asks for, or that its accuracy needs.
pub fn springs_wanted(setup: &Setup) -> Option<usize> {
    let curved = |(entry, motion): (&Entry, Option<&Motion>)| match entry {
        Entry::Press(_) | Entry::HoldForce(_) | Entry::Oscillate(_) => true,
        _ => motion.is_some_and(|motion| matches!(motion.control, Driven::Force(_))),
    };
    if let Some(count) = setup.scene.springs {
        return Some(count.get());
    }
    setup.entries().any(curved).then(|| count_for(setup.accuracy()))
}

/// −1/4 ≤ error·(a/Δx)² ≤ 1/8, and Δx/a = arsinh(1/GRADE)/N in a graded bed: N for half the accuracy.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped before")]
fn count_for(accuracy: f64) -> usize {
    (GRADE.recip().asinh() / (2.0 * accuracy).sqrt()).ceil().clamp(256.0, 262_144.0) as usize
}

/// A radius [m] the contact of a scene does not outgrow: of its largest depth, or of the creep under its
/// largest force over all its time.
fn reach(setup: &Setup, spectrum: &Arc<Spectrum>) -> f64 {
    let (mut depth, mut force, mut time) = (0f64, 0f64, 0.0);
    let mut before = 0.0;
    for stage in stages(setup.entries(), Some(1)) {
        time += stage.over;
        match (stage.control, stage.normal) {
            (Some(Control::Force), Path::To(to)) => force = force.max(to),
            (Some(Control::Indentation), Path::To(to)) => (before, depth) = (to, depth.max(to)),
            (_, Path::Wave { amplitude, .. }) => depth = depth.max(before.max(depth) + amplitude),
            _ => {}
        }
    }
    let creep = Creep::new(spectrum.clone(), setup.profile.clone()).after(force, 0.0).after(force, time);
    let deepest = depth.max(creep.indentation().unwrap_or(0.0));
    setup.profile.edge(deepest).filter(|&reach| reach > 0.0).unwrap_or_else(|| setup.profile.scale())
}

/// What holds the edge.
fn attraction(setup: &Setup, spectrum: &Spectrum) -> Option<Attraction> {
    let Some(Adhesion::Jkr(jkr)) = &setup.scene.adhesion else { return None };
    let work = jkr.work.si();
    Some(match jkr.edge.as_ref()? {
        Edge::Relaxed => Attraction::relaxed(work, spectrum),
        Edge::Instantaneous => Attraction::instantaneous(work, spectrum),
        Edge::Rate(rate) => Attraction::with_rate(work, spectrum, (rate.speed.si(), rate.exponent.si())),
    })
}

/// The error of a run: of the sums of the bed, of its springs, of the pieces under a prescribed force.
pub fn error_estimate(setup: &Setup, run: &Run<'_>) -> ErrorEstimate {
    let largest = run.records.iter().map(|record| record.normal.force.abs()).fold(f64::MIN_POSITIVE, f64::max);
    let bed = run.force_error / largest;
    let Some(count) = springs_wanted(setup).filter(|_| setup.scene.adhesion.is_none()) else {
        let basis = "continuous bed, exact in time: every sum made anew with panels of half the width";
        return ErrorEstimate { relative: bed.max(1e-13), basis: basis.to_owned() };
    };
    let width = GRADE.recip().asinh() / count as f64;
    let basis = format!(
        "bed of {count} springs: second order in the spring width, constant 1/4, and straight pieces of the depth within {:.0e}",
        setup.accuracy()
    );
    ErrorEstimate { relative: 0.25 * width * width + felt(setup, run) * setup.accuracy(), basis }
}

/// What the largest force feels of a depth off by a part of itself, 2E(0)a·d/F, where the depth is followed in
/// chords; one where the force itself is met.
fn felt(setup: &Setup, run: &Run<'_>) -> f64 {
    let chords = setup.scene.history.iter().any(|entry| matches!(entry, Entry::Oscillate(_)));
    let normal = run.records.iter().map(|record| &record.normal).max_by(|a, b| a.force.total_cmp(&b.force));
    let part = normal.and_then(|normal| Some(normal.stiffness * normal.indentation? / normal.force));
    part.filter(|part| chords && part.is_finite()).unwrap_or(1.0).max(1.0)
}
