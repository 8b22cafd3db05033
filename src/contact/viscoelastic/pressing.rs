//! A prescribed force, followed in straight pieces of the depth.

use super::creep::Creep;
use super::drive::Bed;
use super::memory::BedError;
use crate::numerics::root;

/// A prescribed force that goes linearly with time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ramp {
    /// Force at the beginning [N].
    pub from: f64,
    /// Rate [N/s].
    pub rate: f64,
    /// Error of the force between the ends of the pieces, relative to `scale`.
    pub accuracy: f64,
    /// Force against which errors are measured [N].
    pub scale: f64,
}

impl Ramp {
    /// The force [N] at the time `t` [s].
    #[must_use]
    pub fn force(&self, t: f64) -> f64 {
        self.from + self.rate * t
    }
}

/// A straight piece of the depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// Speed [m/s].
    pub speed: f64,
    /// Time of its end [s].
    pub until: f64,
}

/// A bed under a prescribed force.
///
/// Straight pieces of d(t) that meet the force at their ends; a piece is shortened until the force in
/// its middle is met to the accuracy asked for, so the force actually applied differs from the
/// prescribed one by no more than that at any time. Where the contact has only grown so far, the
/// ends lie on the exact creep curve.
#[derive(Debug, Clone)]
pub struct Pressing {
    ramp: Ramp,
    creep: Option<Creep>,
    end: f64,
    now: f64,
    step: f64,
    parted: bool,
}

/// Shortest piece, relative to the whole.
const SHORTEST: f64 = 1e-18;
/// Least force asked for without adhesion, relative to the scale: the bodies just touch.
const TOUCH: f64 = 1e-9;

impl Pressing {
    /// A ramp that lasts `end` [s].
    #[must_use]
    pub fn new(ramp: Ramp, end: f64) -> Self {
        Self { ramp, creep: None, end, now: 0.0, step: end, parted: false }
    }

    /// The ramp along the exact creep of a contact that has only grown so far.
    #[must_use]
    pub fn along(mut self, creep: Creep) -> Self {
        self.creep = Some(creep);
        self
    }

    /// The exact creep at the time `t` [s] of the ramp, where it is known.
    #[must_use]
    pub fn exact(&self, t: f64) -> Option<Creep> {
        self.creep.as_ref().map(|creep| creep.after(self.ramp.force(t), t))
    }

    /// Time [s] up to which the pieces have been handed out.
    #[must_use]
    pub fn now(&self) -> f64 {
        self.now
    }

    /// The force prescribed at the time `t` [s].
    #[must_use]
    pub fn prescribed(&self, t: f64) -> f64 {
        self.ramp.force(t)
    }

    /// Whether the bodies have parted: no motion meets the force.
    #[must_use]
    pub fn parted(&self) -> bool {
        self.parted
    }

    /// The next piece, to be made by the caller; `None` at the end, and where the bodies part.
    ///
    /// # Errors
    /// The contact would outgrow the profile.
    pub fn next<B: Bed>(&mut self, bed: &mut B) -> Result<Option<Piece>, BedError> {
        while self.now < self.end && !self.parted {
            let last = self.end - self.now <= self.step * (1.0 + 1e-9);
            let until = if last { self.end } else { (self.now + self.step).max(self.now.next_up()) };
            let duration = until - self.now;
            let Some(speed) = self.speed(bed, until)? else {
                self.parted = duration <= 1e-12 * self.end;
                self.step = 0.1 * duration;
                continue;
            };
            let error = self.error(bed, speed, duration)?;
            let shortest = duration <= SHORTEST * self.end || until <= self.now.next_up();
            if error > 1.0 && !shortest && !self.is_first_touch(bed, speed * duration) {
                self.step = duration * (0.8 / error.sqrt()).clamp(1e-3, 0.8);
                continue;
            }
            self.now = until;
            self.step = duration * (0.8 / error.sqrt()).clamp(0.2, 5.0);
            return Ok(Some(Piece { speed, until }));
        }
        Ok(None)
    }

    /// Error of the force in the middle of a piece over the error allowed.
    ///
    /// Beside the exact creep it is that of the depth, F being about d^{3/2}: there the bed need not be asked.
    fn error<B: Bed>(&self, bed: &mut B, speed: f64, duration: f64) -> Result<f64, BedError> {
        let (half, scale) = (0.5 * duration, self.ramp.scale.max(f64::MIN_POSITIVE));
        let middle = self.now + half;
        let off = match self.exact(middle).and_then(|creep| creep.indentation()) {
            Some(depth) if depth > 0.0 => {
                let chord = bed.state().indentation + speed * half;
                1.5 * self.target(middle) * (1.0 - chord / depth)
            }
            _ => bed.force_after(speed, half)? - self.target(middle),
        };
        Ok(off.abs() / (self.ramp.accuracy * scale))
    }

    /// A first piece this short leaves no trace in what follows.
    fn is_first_touch<B: Bed>(&self, bed: &B, rise: f64) -> bool {
        let full = self.exact(self.end).and_then(|creep| creep.indentation());
        bed.state().contact_radius <= 0.0 && full.is_some_and(|full| rise <= self.ramp.accuracy * full)
    }

    /// The force to be met at the time `t` [s].
    fn target(&self, t: f64) -> f64 {
        let force = self.ramp.force(t);
        if force.abs() < TOUCH * self.ramp.scale { TOUCH * self.ramp.scale } else { force }
    }

    /// The speed that leads to the force at the time `until`; `None` if none does.
    fn speed<B: Bed>(&self, bed: &mut B, until: f64) -> Result<Option<f64>, BedError> {
        let duration = until - self.now;
        match self.exact(until) {
            Some(creep) => {
                let depth = creep.indentation().ok_or(BedError::BeyondProfile { indentation: f64::INFINITY })?;
                Ok(Some((depth - bed.state().indentation) / duration))
            }
            None => speed_to(bed, self.target(until), duration),
        }
    }
}

/// The speed at which a motion of the given duration ends with the force `force` [N]; `None` if the
/// bodies part before.
///
/// # Errors
/// The contact would outgrow the profile.
pub fn speed_to<B: Bed>(bed: &mut B, force: f64, duration: f64) -> Result<Option<f64>, BedError> {
    let state = bed.state();
    let mut failed = None;
    // Force beyond the prescribed one, and whether the bodies still touch.
    let mut look = |speed: f64| match bed.glance(speed, duration) {
        Ok((found, radius)) => (found - force, radius > 0.0),
        Err(error) => {
            failed = Some(error);
            (f64::MAX, true)
        }
    };
    // A guess from the stiffness, widened until it brackets the root: the force grows with the speed.
    let still = look(0.0).0;
    let stiffness = state.stiffness.max(1e-9 * force.abs() / state.indentation.abs().max(1e-30));
    let near = still.abs() / stiffness / duration;
    let mut width = near.max(1e-12 * state.indentation.abs() / duration).max(1e-300).copysign(-still);
    let mut inner = 0.0;
    loop {
        let (residual, joined) = look(width);
        if residual > 0.0 && !joined && still > 0.0 {
            // Parted: the pull must be found before, if anywhere.
            match last_pull(&mut look, inner, width) {
                Some(pull) => width = pull,
                None => return Ok(None),
            }
            break;
        }
        if (residual > 0.0) != (still > 0.0) || width.abs() >= 1e290 {
            break;
        }
        inner = width;
        width *= 2.0;
    }
    let speed = root::brent(|speed| look(speed).0, inner.min(width), inner.max(width)).unwrap_or(width);
    match failed.filter(|_| speed.abs() <= 0.0) {
        Some(error) => Err(error),
        None => Ok(Some(speed)),
    }
}

/// A speed between one that keeps the bodies together and one that parts them at which the pull is
/// stronger than prescribed.
fn last_pull(look: &mut impl FnMut(f64) -> (f64, bool), mut held: f64, mut parted: f64) -> Option<f64> {
    for _ in 0..50 {
        let middle = 0.5 * (held + parted);
        match look(middle) {
            (residual, true) if residual <= 0.0 => return Some(middle),
            (_, true) => held = middle,
            (_, false) => parted = middle,
        }
    }
    None
}
