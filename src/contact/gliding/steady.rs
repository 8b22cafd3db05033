//! The steady state: one spring swept through the profile tells of all.

use super::kernel::Kernel;
use super::tally::Tally;
use super::track::Track;
use crate::contact::error::{BedError, ContactError};
use crate::contact::viscoelastic::Spectrum;
use crate::contact::viscoelastic::spring::{Motion, Spring};
use crate::numerics::root;
use crate::shape::Profile;
use std::sync::Arc;

/// A body in steady motion over a bed that remembers.
///
/// Exact in time for the polygon that stands for the profile; its chords are halved until force and resistance
/// change by no more than the accuracy, which is then a bound of what is left: the chords are of second order.
#[derive(Debug, Clone)]
pub struct SteadyGlide {
    spectrum: Arc<Spectrum>,
    profile: Arc<dyn Profile>,
    accuracy: f64,
}

/// A contact in steady motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SteadyState {
    /// Speed v [m/s].
    pub speed: f64,
    /// Indentation d [m].
    pub indentation: f64,
    /// Normal force F = ∫ f dξ [N].
    pub force: f64,
    /// Resistance F_x = ∫ f g′ dξ [N], from the heat: a sum of positive terms.
    pub resistance: f64,
    /// The same from the work ∫ f u̇ dt done on the springs [N], which is less exact where little is lost.
    pub work: f64,
    /// Where the contact begins, from the middle of the body in the direction of its motion [m].
    pub leading_edge: Option<f64>,
    /// Where it ends [m]; behind the middle it is negative.
    pub trailing_edge: Option<f64>,
    /// By how much force and resistance may be off, as parts of themselves.
    pub error: f64,
}

impl SteadyState {
    /// Resistance over normal force; `None` where the bodies do not touch.
    #[must_use]
    pub fn coefficient(&self) -> Option<f64> {
        (self.force > 0.0).then(|| self.resistance / self.force)
    }
}

/// Fewest chords on either side, and most.
const CHORDS: (usize, usize) = (128, 1 << 19);

impl SteadyGlide {
    /// A round body of the profile `profile` on a bed of the material `spectrum`, to the relative accuracy `accuracy`.
    #[must_use]
    pub fn round(spectrum: Arc<Spectrum>, profile: Arc<dyn Profile>, accuracy: f64) -> Self {
        Self { spectrum, profile, accuracy }
    }

    /// At the speed `speed` > 0 [m/s] and the depth `depth` [m].
    ///
    /// # Errors
    /// The contact outgrows the profile.
    pub fn at_depth(&self, speed: f64, depth: f64) -> Result<SteadyState, ContactError> {
        self.refined(|count, _| self.pass(speed, depth, count))
    }

    /// At the speed `speed` > 0 [m/s] under the normal force `force` [N].
    ///
    /// # Errors
    /// The contact outgrows the profile.
    pub fn at_force(&self, speed: f64, force: f64) -> Result<SteadyState, ContactError> {
        self.refined(|count, last| {
            let guess = last.map_or_else(|| self.profile.reduced(self.profile.scale()), |state| state.indentation);
            self.balanced(speed, force, (count, guess))
        })
    }

    /// What `pass` finds with so many chords that twice as many say the same.
    fn refined(
        &self,
        pass: impl Fn(usize, Option<&SteadyState>) -> Result<SteadyState, ContactError>,
    ) -> Result<SteadyState, ContactError> {
        let mut count = CHORDS.0;
        let mut state = pass(count, None)?;
        loop {
            count *= 2;
            let next = pass(count, Some(&state))?;
            let error = off(next.force, state.force)
                .max(off(next.resistance, state.resistance))
                .max(off(next.indentation, state.indentation));
            state = SteadyState { error: error.max(ROUNDING), ..next };
            if error <= self.accuracy || count >= CHORDS.1 {
                return Ok(state);
            }
        }
    }

    /// The depth under which the bed carries `force` [N], found from a guess [m].
    fn balanced(&self, speed: f64, force: f64, (count, guess): (usize, f64)) -> Result<SteadyState, ContactError> {
        if force <= 0.0 {
            return self.pass(speed, 0.0, count);
        }
        let overloaded = || ContactError::from(BedError::Overloaded { force });
        // Forces go with a power of the depth: in logarithms the root is that of a line.
        let lack = |depth: f64| {
            self.pass(speed, depth.exp(), count).map_or(f64::INFINITY, |state| (state.force / force).ln())
        };
        let (low, high) = bracket(lack, guess.ln()).ok_or_else(overloaded)?;
        let depth = root::brent(lack, low, high).map_err(|_| overloaded())?;
        self.pass(speed, depth.exp(), count)
    }

    /// One spring swept through `count` chords on either side.
    fn pass(&self, speed: f64, depth: f64, count: usize) -> Result<SteadyState, ContactError> {
        if depth <= 0.0 {
            return Ok(apart(speed, depth));
        }
        let outgrown = || BedError::BeyondProfile { indentation: depth };
        let track = Track::of_profile(self.profile.as_ref(), depth, count).ok_or_else(outgrown)?;
        let (tally, left) = swept(&mut Kernel::new(self.spectrum.clone()), &track, speed);
        let place = |time: Option<f64>| time.map(|time| track.front - speed * time);
        Ok(SteadyState {
            speed,
            indentation: depth,
            force: speed * tally.impulse,
            resistance: tally.heat + left,
            work: tally.work,
            leading_edge: place(tally.touched),
            trailing_edge: place(tally.released),
            error: 0.0,
        })
    }
}

/// What a few thousand roundings leave of a sum.
const ROUNDING: f64 = 1e-13;

/// By what part of `one` another number is off.
fn off(one: f64, other: f64) -> f64 {
    if one.abs() > 0.0 { ((one - other) / one).abs() } else { other.abs() }
}

/// Bodies that do not touch.
fn apart(speed: f64, indentation: f64) -> SteadyState {
    let (force, resistance, work, error) = (0.0, 0.0, 0.0, 0.0);
    SteadyState { speed, indentation, force, resistance, work, leading_edge: None, trailing_edge: None, error }
}

/// Two arguments around `guess` between which a growing function becomes positive.
fn bracket(function: impl Fn(f64) -> f64, guess: f64) -> Option<(f64, f64)> {
    let positive = function(guess) > 0.0;
    let (mut near, mut step) = (guess, if positive { -1.0 } else { 1.0 } * 1e-3);
    for _ in 0..60 {
        let far = near + step;
        if !far.is_finite() {
            return None;
        }
        if (function(far) > 0.0) != positive {
            return Some(if positive { (far, near) } else { (near, far) });
        }
        (near, step) = (far, 2.0 * step);
    }
    None
}

/// A spring never touched, swept along a track: its sums, and the energy [J/m] that is left in it at the end, of which
/// all will be heat.
fn swept(kernel: &mut Kernel, track: &Track, speed: f64) -> (Tally, f64) {
    let (mut spring, mut tally) = (Spring::untouched(kernel.spectrum()), Tally::default());
    for (step, depths) in track.steps.iter().zip(track.depths.windows(2)) {
        let duration = step / speed;
        kernel.prepare(duration);
        let motion = Motion { start: depths[0], speed: (depths[1] - depths[0]) / duration, duration };
        kernel.step(&mut spring, &motion, &mut tally);
    }
    let last = track.depths.last().copied().unwrap_or(0.0);
    let left = match &spring {
        Spring::Pressed(loads) => kernel.spectrum().stored_pressed(last, loads),
        Spring::Free(free) => kernel.spectrum().stored_free(free),
    };
    (tally, left)
}
