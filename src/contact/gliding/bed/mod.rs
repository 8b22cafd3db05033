//! A bed of springs under a profile that is pressed and glides: how a contact at rest comes into motion.

use super::Gliding;
use super::kernel::Kernel;
use super::tally::Tally;
use crate::contact::adhesion::line::Energy;
use crate::contact::error::{BedError, ContactError};
use crate::contact::model::{ContactModel, Effort, Event, Glance, Loading, Pull, Straight};
use crate::contact::state::Normal;
use crate::contact::viscoelastic::Spectrum;
use crate::contact::viscoelastic::continuous::in_time;
use crate::contact::viscoelastic::spring::{Free, Motion, Spring};
use crate::shape::Profile;
use std::collections::VecDeque;
use std::ops::Range;
use std::sync::Arc;

/// Springs at (j + ½)h under the polygon of a profile with corners at kh.
///
/// Every spring is followed by itself and exactly in time, so that the history of a contact, where it has been and
/// what it has left behind, is known. Second order in the width h. A prescribed force is followed in straight pieces of the
/// depth, in whose middle the force is right to the accuracy.
#[derive(Debug, Clone)]
pub struct GlidingBed {
    kernel: Kernel,
    profile: Arc<dyn Profile>,
    width: f64,
    accuracy: f64,
    /// Heights [m] of the polygon at kh, k = 0, 1, …
    heights: Vec<f64>,
    /// The springs that have ever been within reach, in order.
    springs: VecDeque<Touched>,
    /// Number j of the first of them.
    first: i64,
    now: Pose,
    /// How the contact moved last.
    moved: Moved,
    work: f64,
    /// Step [s] by which a prescribed force was followed last.
    step: f64,
}

/// A spring with the time [s] up to which it is known.
#[derive(Debug, Clone)]
struct Touched {
    spring: Spring,
    known: f64,
}

/// Where the body is.
#[derive(Debug, Clone, Copy, Default)]
struct Pose {
    time: f64,
    depth: f64,
    place: f64,
}

/// Speeds [m/s] down and along.
#[derive(Debug, Clone, Copy, Default)]
struct Moved {
    down: f64,
    along: f64,
}

/// A stretch of the motion in which every spring stays below one chord.
#[derive(Debug, Clone, Copy)]
struct Stretch {
    /// Number of the spring right of the chord that begins at the middle of the body.
    cell: i64,
    /// Part of the chord at which every spring is, at the beginning and the end.
    parts: [f64; 2],
    depths: [f64; 2],
    duration: f64,
}

impl Stretch {
    /// The chord under which spring `j` is, by the number of its lower corner.
    fn chord(&self, j: i64) -> i64 {
        j - self.cell - 1
    }
}

/// Where on the way from `begin` to `end`, in widths, all springs pass from one chord to the next; and its end.
fn joints(begin: f64, end: f64) -> impl Iterator<Item = f64> {
    let (low, high) = (begin.min(end).floor() + 1.0, begin.max(end).ceil());
    let count = number((high - low).max(0.0));
    let joint = move |k: usize| if end > begin { low + k as f64 } else { high - 1.0 - k as f64 };
    (0..count).map(joint).chain([end])
}

/// Most halvings of a step under a prescribed force.
const HALVINGS: u32 = 40;
/// Corners beyond the contact that are looked at too.
const MARGIN: usize = 2;

impl GlidingBed {
    /// A bed never touched, with springs of the width `width` [m], to the relative accuracy `accuracy`.
    #[must_use]
    pub fn new(spectrum: Arc<Spectrum>, profile: Arc<dyn Profile>, (width, accuracy): (f64, f64)) -> Self {
        Self {
            kernel: Kernel::new(spectrum),
            heights: vec![profile.reduced(0.0)],
            profile,
            width,
            accuracy,
            springs: VecDeque::new(),
            first: 0,
            now: Pose::default(),
            moved: Moved::default(),
            work: 0.0,
            step: f64::INFINITY,
        }
    }

    fn spectrum(&self) -> &Spectrum {
        self.kernel.spectrum()
    }

    /// Height [m] of the polygon at the corner k.
    fn height(&self, corner: i64) -> f64 {
        usize::try_from(corner.unsigned_abs()).ok().and_then(|k| self.heights.get(k)).copied().unwrap_or(f64::INFINITY)
    }

    /// Corners up to which a contact of the depth `depth` [m] reaches.
    fn reach(&mut self, depth: f64) -> Result<usize, ContactError> {
        let outgrown = || ContactError::from(BedError::BeyondProfile { indentation: depth });
        let known = self.heights.partition_point(|height| *height < depth);
        if known + MARGIN < self.heights.len() || depth <= 0.0 && self.heights.len() > MARGIN {
            return Ok(known + MARGIN);
        }
        let end = self.profile.rim().radius();
        let edge = self.profile.edge(depth.max(0.0)).ok_or_else(outgrown)?;
        if edge >= end {
            return Err(outgrown());
        }
        let corners = number((edge / self.width).ceil()) + 2 * MARGIN + 1;
        let height = |k: usize| {
            let x = k as f64 * self.width;
            // Beyond its end the profile goes on straight, where nothing meets it.
            let inside = x.min(end);
            self.profile.reduced(inside) + (x - inside) * self.profile.reduced_slope(inside)
        };
        let more: Vec<f64> = (self.heights.len()..=corners).map(height).collect();
        self.heights.extend(more);
        Ok(self.heights.partition_point(|height| *height < depth) + MARGIN)
    }

    /// Takes up the springs of a range that have not been within reach before.
    fn take_up(&mut self, range: &Range<i64>) {
        let fresh = || Touched { spring: Spring::untouched(self.kernel.spectrum()), known: self.now.time };
        if self.springs.is_empty() {
            self.first = range.start;
        }
        while self.first > range.start {
            let spring = fresh();
            self.springs.push_front(spring);
            self.first -= 1;
        }
        while self.end() < range.end {
            let spring = fresh();
            self.springs.push_back(spring);
        }
    }

    fn end(&self) -> i64 {
        self.first + signed(self.springs.len())
    }

    /// Moves to a depth [m] and on to a place [m] in `duration` [s].
    fn advance(&mut self, depth: f64, place: f64, duration: f64) -> Result<(), ContactError> {
        let from = self.now;
        self.moved = Moved { down: (depth - from.depth) / duration, along: (place - from.place) / duration };
        let cells = |place: f64| place / self.width - 0.5;
        let (begin, end) = (cells(from.place), cells(place));
        let (mut at, mut behind) = (begin, 0.0);
        for next in joints(begin, end) {
            let last = next.total_cmp(&end).is_eq();
            let part = if last { 1.0 } else { (next - begin) / (end - begin) };
            let to = Pose {
                time: from.time + part * duration,
                depth: if last { depth } else { from.depth + part * (depth - from.depth) },
                place: if last { place } else { (next + 0.5) * self.width },
            };
            let cell = (0.5 * (at + next)).floor();
            let stretch = Stretch {
                cell: integer(cell),
                parts: [at, next].map(|cells| 1.0 - (cells - cell)),
                depths: [self.now.depth, to.depth],
                duration: (part - behind) * duration,
            };
            self.pass(&stretch)?;
            (self.now, at, behind) = (to, next, part);
        }
        Ok(())
    }

    /// Takes every spring within reach through a stretch.
    fn pass(&mut self, stretch: &Stretch) -> Result<(), ContactError> {
        if stretch.duration <= 0.0 {
            return Ok(());
        }
        let reach = signed(self.reach(stretch.depths[0].max(stretch.depths[1]))?);
        let range = stretch.cell + 1 - reach..stretch.cell + 1 + reach;
        self.take_up(&range);
        self.kernel.prepare(stretch.duration);
        let mut tally = Tally::default();
        for j in range {
            let chord = stretch.chord(j);
            let (low, high) = (self.height(chord), self.height(chord + 1));
            let depths = [0, 1].map(|end| stretch.depths[end] - (low + stretch.parts[end] * (high - low)));
            let speed = (depths[1] - depths[0]) / stretch.duration;
            let motion = Motion { start: depths[0], speed, duration: stretch.duration };
            let Some(place) = usize::try_from(j - self.first).ok().and_then(|at| self.springs.get_mut(at)) else { continue };
            place.catch_up(self.kernel.spectrum(), self.now.time);
            self.kernel.step(&mut place.spring, &motion, &mut tally);
            place.known = self.now.time + stretch.duration;
        }
        self.work += self.width * tally.work;
        Ok(())
    }

    /// The springs that are pressed: their distance from the middle of the body [m], displacement [m] and load [N/m].
    fn pressed(&self) -> impl DoubleEndedIterator<Item = (i64, f64, f64)> + '_ {
        let cells = self.now.place / self.width - 0.5;
        // Of a spring below a corner the chord it came from.
        let cell = if self.moved.along > 0.0 { cells.ceil() - 1.0 } else { cells.floor() };
        let (part, cell) = (1.0 - (cells - cell), integer(cell));
        let load = move |(at, touched): (usize, &Touched)| {
            let Spring::Pressed(loads) = &touched.spring else { return None };
            let j = self.first + signed(at);
            let (low, high) = (self.height(j - cell - 1), self.height(j - cell));
            let speed = self.moved.down + self.moved.along * (high - low) / self.width;
            let displacement = self.now.depth - (low + part * (high - low));
            Some((j, displacement, self.spectrum().load(displacement, loads, speed)))
        };
        self.springs.iter().enumerate().filter_map(load)
    }

    /// Distance [m] of the spring `j` from the middle of the body.
    fn distance(&self, j: i64) -> f64 {
        (j as f64 + 0.5) * self.width - self.now.place
    }

    /// Normal force F and resistance F_x [N].
    fn forces(&self) -> (f64, f64) {
        let modulus = self.spectrum().equilibrium();
        let mut sums = (0.0, 0.0);
        for (j, displacement, load) in self.pressed() {
            let at = self.distance(j);
            let slope = if at.abs() > 0.0 { self.profile.reduced_slope(at.abs()).copysign(at) } else { 0.0 };
            sums.0 += load;
            sums.1 += (load - modulus * displacement) * slope;
        }
        (self.width * sums.0, self.width * sums.1 + 0.5 * modulus * self.rise())
    }

    /// 2∫ u g′ dξ over the contact: u² at its rear less that at its front [m²].
    fn rise(&self) -> f64 {
        let Some((front, rear)) = self.edges() else { return 0.0 };
        let displacement = |at: f64| (self.now.depth - self.profile.reduced(at.abs())).max(0.0);
        (displacement(rear) - displacement(front)) * (displacement(rear) + displacement(front))
    }

    /// Where the contact ends on the side of larger and of smaller places [m]: on ground never touched where the profile
    /// meets it, else between two springs where the load goes to zero.
    fn edges(&self) -> Option<(f64, f64)> {
        let mut all = self.pressed().map(|(j, _, load)| (j, load));
        let front = (all.next_back()?, all.next_back());
        let mut all = self.pressed().map(|(j, _, load)| (j, load));
        let rear = (all.next()?, all.next());
        Some((self.edge(front, 1), self.edge(rear, -1)))
    }

    fn edge(&self, (last, before): ((i64, f64), Option<(i64, f64)>), side: i64) -> f64 {
        let outside = usize::try_from(last.0 + side - self.first).ok().and_then(|at| self.springs.get(at));
        if outside.is_none_or(|touched| touched.spring.is_untouched())
            && let Some(edge) = self.profile.edge(self.now.depth)
        {
            return edge * side as f64;
        }
        let part = before.map_or(0.5, |before| (last.1 / (before.1 - last.1)).clamp(0.0, 1.0));
        let part = if part.is_finite() { part } else { 0.5 };
        self.distance(last.0) + side as f64 * part * self.width
    }

    /// Energy [J] in all springs.
    fn stored(&self) -> f64 {
        let pressed = self.pressed().map(|(j, displacement, _)| {
            let touched = usize::try_from(j - self.first).ok().and_then(|at| self.springs.get(at));
            match touched.map(|touched| &touched.spring) {
                Some(Spring::Pressed(loads)) => self.spectrum().stored_pressed(displacement, loads),
                Some(Spring::Free(_)) | None => 0.0,
            }
        });
        let free = self.springs.iter().map(|touched| touched.stored_free(self.spectrum(), self.now.time));
        self.width * (pressed.sum::<f64>() + free.sum::<f64>())
    }

    /// The part of the bed that the body can meet within `duration` [s]: cheap to take and to throw away.
    fn scout(&self, along: f64, duration: f64) -> Self {
        let cells = |place: f64| integer(place / self.width);
        let (one, other) = (cells(self.now.place), cells(self.now.place + along * duration));
        let reach = signed(self.heights.len());
        let from = (one.min(other) - reach).max(self.first);
        let to = (one.max(other) + reach).min(self.end());
        let at = |j: i64| usize::try_from(j - self.first).unwrap_or(0).min(self.springs.len());
        Self {
            springs: self.springs.range(at(from)..at(to).max(at(from))).cloned().collect(),
            first: from,
            kernel: self.kernel.clone(),
            profile: self.profile.clone(),
            heights: self.heights.clone(),
            ..*self
        }
    }

    /// The force at the end of a piece, which is not taken.
    fn force_after(&self, down: f64, along: f64, duration: f64) -> Result<f64, ContactError> {
        let mut scout = self.scout(along, duration);
        scout.advance(self.now.depth + down * duration, self.now.place + along * duration, duration)?;
        Ok(scout.forces().0)
    }

    /// Speed down [m/s] that brings the force to `force` [N] after `duration` [s].
    fn speed_to(&self, force: f64, along: f64, duration: f64) -> Result<f64, ContactError> {
        let scale = force.abs().max(self.forces().0);
        let lack = |down: f64| Ok::<f64, ContactError>(self.force_after(down, along, duration)? - force);
        let mut one = (self.moved.down, lack(self.moved.down)?);
        let stiffness = self.stiffness().max(self.stiffness_of_touch());
        let mut two = (one.0 - one.1 / (stiffness * duration), f64::NAN);
        two.1 = lack(two.0)?;
        let within = ROUNDING * scale;
        for _ in 0..60 {
            if two.1.abs() <= within || one.1.total_cmp(&two.1).is_eq() {
                break;
            }
            let next = two.0 - two.1 * (two.0 - one.0) / (two.1 - one.1);
            // Bodies apart carry nothing, however far: half the way back from there.
            let next = if two.1 <= -force && force > 0.0 { 0.5 * (one.0 + two.0) } else { next };
            (one, two) = (two, (next, lack(next)?));
        }
        Ok(two.0)
    }

    /// Stiffness dF/dd [N/m] at once.
    fn stiffness(&self) -> f64 {
        self.spectrum().instantaneous() * self.width * self.pressed().count() as f64
    }

    /// Stiffness [N/m] of the first few springs, from which a contact begins.
    fn stiffness_of_touch(&self) -> f64 {
        2.0 * self.spectrum().instantaneous() * self.width
    }

    /// Follows a prescribed force: in the middle of every straight piece of the depth it is right to the accuracy.
    fn pull(&mut self, pull: &Pull) -> Result<(), ContactError> {
        let duration = if pull.duration > 0.0 { pull.duration } else { self.spectrum().instant() };
        let (from, along) = (self.forces().0, (pull.slide - self.now.place) / duration);
        let at = |time: f64| from + (pull.force - from) * (time / duration);
        let (mut time, tolerance) = (0.0, self.accuracy * from.max(pull.force));
        while time < duration {
            let mut step = self.step.min(duration - time);
            let mut halvings = 0;
            let down = loop {
                let down = self.speed_to(at(time + step), along, step)?;
                let middle = self.force_after(down, along, 0.5 * step)? - at(time + 0.5 * step);
                if middle.abs() <= tolerance || halvings >= HALVINGS {
                    if 8.0 * middle.abs() < tolerance {
                        self.step = 2.0 * step;
                    }
                    break down;
                }
                (step, halvings) = (0.5 * step, halvings + 1);
                self.step = step;
            };
            let last = time + step >= duration;
            let place = if last { pull.slide } else { self.now.place + along * step };
            self.advance(self.now.depth + down * step, place, step)?;
            time = if last { duration } else { time + step };
        }
        Ok(())
    }
}

/// By how much a force may be missed at the end of a piece, as a part of itself.
const ROUNDING: f64 = 1e-12;

impl Touched {
    /// Recovers up to the time `now` [s].
    fn catch_up(&mut self, spectrum: &Spectrum, now: f64) {
        if let Spring::Free(free) = &mut self.spring
            && self.known < now
        {
            spectrum.recover(free, now - self.known);
        }
        self.known = now;
    }

    /// Energy [J/m] of a free spring at the time `now` [s].
    fn stored_free(&self, spectrum: &Spectrum, now: f64) -> f64 {
        let Spring::Free(free) = &self.spring else { return 0.0 };
        let mut free: Free = free.clone();
        spectrum.recover(&mut free, (now - self.known).max(0.0));
        spectrum.stored_free(&free)
    }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "counts of springs, far below 2^53")]
fn number(count: f64) -> usize {
    count as usize
}

#[expect(clippy::cast_possible_truncation, reason = "numbers of springs, far below 2^53")]
fn integer(cell: f64) -> i64 {
    cell as i64
}

#[expect(clippy::cast_possible_wrap, reason = "counts of springs, far below 2^63")]
fn signed(count: usize) -> i64 {
    count as i64
}

impl ContactModel for GlidingBed {
    fn follow(&mut self, piece: &Straight) -> Result<Vec<Event>, ContactError> {
        if let Some(piece) = in_time(self.spectrum(), self.now.depth, piece)? {
            self.advance(piece.to, piece.slide, piece.duration)?;
        }
        Ok(Vec::new())
    }

    fn look(&mut self, piece: &Straight) -> Result<Glance, ContactError> {
        let mut ahead = self.clone();
        ahead.follow(piece)?;
        let state = ahead.state();
        Ok(Glance { force: state.force, contact_radius: state.contact_radius.unwrap_or(0.0) })
    }

    fn state(&self) -> Normal {
        let stored = self.stored();
        Normal {
            indentation: Some(self.now.depth),
            force: self.forces().0,
            contact_radius: Some(self.edges().map_or(0.0, |(front, rear)| 0.5 * (front - rear))),
            stiffness: self.stiffness(),
            stored: Energy { elastic: stored, surface: 0.0 },
            dissipated: self.work - stored,
        }
    }

    fn joined(&self) -> bool {
        self.pressed().next().is_some()
    }

    fn loading(&self) -> Option<Box<dyn Loading + '_>> {
        None
    }

    fn copy(&self) -> Box<dyn ContactModel> {
        Box::new(self.clone())
    }

    fn gliding(&self) -> Option<Gliding> {
        let (_, resistance) = self.forces();
        let edges = self.edges();
        Some(Gliding {
            slide: self.now.place,
            resistance,
            leading_edge: edges.map(|(front, _)| front),
            trailing_edge: edges.map(|(_, rear)| rear),
        })
    }

    fn press(&mut self, pull: &Pull) -> Option<Result<Vec<Event>, ContactError>> {
        Some(self.pull(pull).map(|()| Vec::new()))
    }

    fn effort(&self) -> Effort {
        let numbers = self.spectrum().terms().len().max(self.spectrum().modes().len()) + 8;
        Effort { springs: self.springs.len(), bytes: self.springs.len() * numbers * size_of::<f64>(), force_error: None }
    }
}
