//! A bed of springs under a profile that is pressed and glides: how a contact at rest comes into motion.

mod contact;
mod outline;
mod pull;
mod rough;
mod seen;
mod window;

use super::kernel::Kernel;
use super::tally::Tally;
use super::track::GlidingLine;
use crate::contact::error::ContactError;
use crate::contact::viscoelastic::Spectrum;
use crate::contact::viscoelastic::spring::{Free, Motion, Spring};
use crate::shape::Profile;
use outline::Outline;
use std::collections::VecDeque;
use std::ops::Range;
use std::sync::Arc;
use window::Window;

/// Springs at (j + ½)h under the polygon of a round profile with corners at kh, or at jh under a rough line, whose points are
/// the corners; where the line comes again and again so do they.
///
/// Every spring is followed by itself and exactly in time, so that the history of a contact, where it has been and
/// what it has left behind, is known. Second order in the width h. A prescribed force is followed in straight pieces of the
/// depth, in whose middle the force is right to the accuracy.
#[derive(Debug, Clone)]
pub struct GlidingBed {
    kernel: Kernel,
    outline: Outline,
    width: f64,
    accuracy: f64,
    /// The springs that have ever been within reach, in order.
    springs: VecDeque<Touched>,
    /// Number j of the first of them.
    first: i64,
    now: Pose,
    /// How the contact moved last.
    moved: Moved,
    work: f64,
    /// What has resisted a rough line on the last width of its way.
    window: Window,
    /// Step [s] by which a prescribed force was followed last.
    pub(super) step: f64,
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

/// Corners beyond the contact that are looked at too.
const MARGIN: usize = 2;

impl GlidingBed {
    /// A bed never touched, with springs of the width `width` [m], to the relative accuracy `accuracy`.
    #[must_use]
    pub fn new(spectrum: Arc<Spectrum>, profile: Arc<dyn Profile>, (width, accuracy): (f64, f64)) -> Self {
        Self::under(Outline::round(profile), spectrum, (width, accuracy))
    }

    /// A bed never touched under a rough line, with a spring under each of its points, to the relative accuracy
    /// `accuracy`, with which a prescribed force is followed; depths count from the first touch.
    #[must_use]
    pub fn line(spectrum: Arc<Spectrum>, line: Arc<GlidingLine>, accuracy: f64) -> Self {
        let width = line.step();
        Self::under(Outline::Line(line), spectrum, (width, accuracy))
    }

    fn under(outline: Outline, spectrum: Arc<Spectrum>, (width, accuracy): (f64, f64)) -> Self {
        Self {
            kernel: Kernel::new(spectrum),
            outline,
            width,
            accuracy,
            springs: VecDeque::new(),
            first: 0,
            now: Pose::default(),
            moved: Moved::default(),
            work: 0.0,
            window: Window::default(),
            step: f64::INFINITY,
        }
    }

    fn spectrum(&self) -> &Spectrum {
        self.kernel.spectrum()
    }

    /// A place [m] in widths, such that the spring j is below the chord j − ⌊…⌋ − 1.
    fn cells(&self, place: f64) -> f64 {
        place / self.width - self.outline.offset()
    }

    /// Where the spring `j` is kept.
    fn index(&self, j: i64) -> Option<usize> {
        match self.outline.ring() {
            Some(ring) => usize::try_from(j.rem_euclid(signed(ring))).ok(),
            None => usize::try_from(j - self.first).ok(),
        }
    }

    /// Takes up the springs of a range that have not been within reach before.
    fn take_up(&mut self, range: &Range<i64>) {
        let fresh = || Touched { spring: Spring::untouched(self.kernel.spectrum()), known: self.now.time };
        if let Some(ring) = self.outline.ring() {
            return self.springs.resize_with(ring, fresh);
        }
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
        let (begin, end) = (self.cells(from.place), self.cells(place));
        let (mut at, mut behind) = (begin, 0.0);
        for next in joints(begin, end) {
            let last = next.total_cmp(&end).is_eq();
            let part = if last { 1.0 } else { (next - begin) / (end - begin) };
            let to = Pose {
                time: from.time + part * duration,
                depth: if last { depth } else { from.depth + part * (depth - from.depth) },
                place: if last { place } else { (next + self.outline.offset()) * self.width },
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
        let chords = self.outline.reach(stretch.depths[0].max(stretch.depths[1]), self.width)?;
        let range = stretch.cell + 1 + chords.start..stretch.cell + 1 + chords.end;
        self.take_up(&range);
        self.kernel.prepare(stretch.duration);
        let (mut tally, mut along) = (Tally::default(), 0.0);
        for j in range {
            let chord = stretch.chord(j);
            let (low, high) = (self.outline.height(chord), self.outline.height(chord + 1));
            let depths = [0, 1].map(|end| stretch.depths[end] - (low + stretch.parts[end] * (high - low)));
            let speed = (depths[1] - depths[0]) / stretch.duration;
            let motion = Motion { start: depths[0], speed, duration: stretch.duration };
            let Some(place) = self.index(j).and_then(|at| self.springs.get_mut(at)) else { continue };
            place.catch_up(self.kernel.spectrum(), self.now.time);
            let before = tally.impulse;
            self.kernel.step(&mut place.spring, &motion, &mut tally);
            along += (high - low) * (tally.impulse - before);
            place.known = self.now.time + stretch.duration;
        }
        self.work += self.width * tally.work;
        if let Outline::Line(_) = self.outline {
            self.window.note(stretch.parts, (stretch.duration, along));
        }
        Ok(())
    }
}

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
