//! The steady state: one spring swept through the profile tells of all.

use super::cycle;
use super::kernel::Kernel;
use super::sweep::swept;
use super::tally::Tally;
use super::track::{GlidingLine, Track};
use crate::contact::error::{BedError, ContactError};
use crate::contact::viscoelastic::Spectrum;
use crate::contact::viscoelastic::spring::Spring;
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
    form: Form,
    accuracy: f64,
}

/// What glides.
#[derive(Debug, Clone)]
enum Form {
    Round(Arc<dyn Profile>),
    Line(Arc<GlidingLine>),
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
    /// Root mean square slope of what is in contact of a rough line.
    pub rms_slope: Option<f64>,
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
        Self { spectrum, form: Form::Round(profile), accuracy }
    }

    /// A rough line on a bed of the material `spectrum`; depths count from its first touch.
    ///
    /// A line is its own polygon, so that nothing is left to refine.
    #[must_use]
    pub fn line(spectrum: Arc<Spectrum>, line: Arc<GlidingLine>) -> Self {
        Self { spectrum, form: Form::Line(line), accuracy: ROUNDING }
    }

    /// At the speed `speed` > 0 [m/s] and the depth `depth` [m].
    ///
    /// # Errors
    /// The contact outgrows the profile.
    pub fn at_depth(&self, speed: f64, depth: f64) -> Result<SteadyState, ContactError> {
        self.refined(|count, _| self.pass((speed, depth), count, &mut Vec::new()))
    }

    /// At the speed `speed` > 0 [m/s] under the normal force `force` [N].
    ///
    /// # Errors
    /// The contact outgrows the profile.
    pub fn at_force(&self, speed: f64, force: f64) -> Result<SteadyState, ContactError> {
        self.refined(|count, last| {
            let guess = last.map_or_else(|| self.typical_depth(), |state| state.indentation);
            self.balanced(speed, force, (count, guess))
        })
    }

    /// A depth [m] such as the profile has.
    fn typical_depth(&self) -> f64 {
        match &self.form {
            Form::Round(profile) => profile.reduced(profile.scale()),
            Form::Line(line) => 0.1 * line.height(),
        }
    }

    /// What `pass` finds with so many chords that twice as many say the same.
    fn refined(
        &self,
        pass: impl Fn(usize, Option<&SteadyState>) -> Result<SteadyState, ContactError>,
    ) -> Result<SteadyState, ContactError> {
        let mut count = CHORDS.0;
        let mut state = pass(count, None)?;
        if let Form::Line(_) = self.form {
            return Ok(SteadyState { error: LINE, ..state });
        }
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
        let mut loads = Vec::new();
        if force <= 0.0 {
            return self.pass((speed, 0.0), count, &mut loads);
        }
        let overloaded = || ContactError::from(BedError::Overloaded { force });
        // Forces go with a power of the depth: in logarithms the root is that of a line.
        let mut lack = |depth: f64| {
            let state = self.pass((speed, depth.exp()), count, &mut loads);
            let lack = state.map_or(f64::INFINITY, |state| (state.force / force).ln());
            if lack.abs() <= MET { 0.0 } else { lack }
        };
        let (low, high) = bracket(&mut lack, guess.ln()).ok_or_else(overloaded)?;
        let depth = root::brent(lack, low, high).map_err(|_| overloaded())?;
        self.pass((speed, depth.exp()), count, &mut loads)
    }

    /// One spring swept through the line, or through `count` chords on either side of a round profile.
    ///
    /// `loads` are those with which a periodic line has come back before, to begin with.
    fn pass(
        &self,
        (speed, depth): (f64, f64),
        count: usize,
        loads: &mut Vec<f64>,
    ) -> Result<SteadyState, ContactError> {
        if depth <= 0.0 {
            return Ok(apart(speed, depth));
        }
        match &self.form {
            Form::Round(profile) => {
                let outgrown = || BedError::BeyondProfile { indentation: depth };
                let track = Track::of_profile(profile.as_ref(), depth, count).ok_or_else(outgrown)?;
                let state = self.once(&track, speed);
                let place = |time: Option<f64>| time.map(|time| track.front - speed * time);
                let edges = [state.touched, state.released].map(place);
                Ok(of_sums((speed, depth), &state, edges))
            }
            Form::Line(line) => {
                let track = line.track(depth)?;
                let sums = if line.is_periodic() {
                    let lost = || BedError::Unsteady { speed };
                    cycle::steady(&mut Kernel::new(self.spectrum.clone()), &track, (speed, loads)).ok_or_else(lost)?
                } else {
                    self.once(&track, speed)
                };
                let rms_slope = sums.rms_speed().map(|rms| rms / speed);
                Ok(SteadyState { rms_slope, ..of_sums((speed, depth), &sums, [None, None]) })
            }
        }
    }

    /// A spring never touched, swept along a track: its sums, what is left in it at the end among the heat.
    fn once(&self, track: &Track, speed: f64) -> Tally {
        let (mut kernel, mut tally) = (Kernel::new(self.spectrum.clone()), Tally::default());
        let spring = swept(&mut kernel, track, (speed, Spring::untouched(&self.spectrum)), &mut tally);
        let last = track.depths.last().copied().unwrap_or(0.0);
        tally.heat += match &spring {
            Spring::Pressed(loads) => self.spectrum.stored_pressed(last, loads),
            Spring::Free(free) => self.spectrum.stored_free(free),
        };
        tally
    }
}

/// The state that a spring with these sums tells of.
fn of_sums((speed, indentation): (f64, f64), sums: &Tally, edges: [Option<f64>; 2]) -> SteadyState {
    SteadyState {
        speed,
        indentation,
        force: speed * sums.impulse,
        resistance: sums.heat,
        work: sums.work,
        leading_edge: edges[0],
        trailing_edge: edges[1],
        rms_slope: None,
        error: 0.0,
    }
}

/// How closely a force is met, as a part of itself.
const MET: f64 = 1e-13;
/// How closely the steady state of a line is met.
const LINE: f64 = 1e-9;
/// What a few thousand roundings leave of a sum.
const ROUNDING: f64 = 1e-13;

/// By what part of `one` another number is off.
fn off(one: f64, other: f64) -> f64 {
    if one.abs() > 0.0 { ((one - other) / one).abs() } else { other.abs() }
}

/// Bodies that do not touch.
fn apart(speed: f64, indentation: f64) -> SteadyState {
    let (force, resistance, work, error) = (0.0, 0.0, 0.0, 0.0);
    let (leading_edge, trailing_edge, rms_slope) = (None, None, None);
    SteadyState { speed, indentation, force, resistance, work, leading_edge, trailing_edge, rms_slope, error }
}

/// Two arguments around `guess` between which a function becomes positive that grows with a slope of one to two.
fn bracket(mut function: impl FnMut(f64) -> f64, guess: f64) -> Option<(f64, f64)> {
    let first = function(guess);
    let positive = first > 0.0;
    let (mut near, mut step) = (guess, -(1.05 * first).clamp(-LONGEST, LONGEST));
    if step.abs() <= 0.0 {
        return Some((guess, guess));
    }
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

/// Longest first step of a search, in the logarithm of the depth.
const LONGEST: f64 = 3.0;
