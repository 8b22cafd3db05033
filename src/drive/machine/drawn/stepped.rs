//! A mass on a contact whose springs remember, drawn along the surface in straight steps.

use super::{DrawnMoment, DrawnState, Turnover};
use crate::contact::model::TangentialBed;
use crate::contact::state::Tangential;
use crate::drive::machine::{DrawnMass, MachineError, Suspension};

/// A mass that a spring draws over springs of friction that relax: m ẍ + c ẋ + k(x − X) = −F_x.
///
/// In a step of the duration h the mass goes straight, with the mean w of its speeds at both ends, and so does the normal
/// motion: 2m(w − v)/h + cw + k(w − V)h/2 + ∫F_x dt/h = k(X − x), with ∫F_x dt = W_x/w from the work that the springs, exact
/// in time, take along the way. Times w it is the balance of energies, to rounding however long the steps; of second order
/// in h, and stable at any. Steps are chosen by the change of the acceleration, and end where the last spring slips
/// and where a mass that slides comes to rest. Between the two the friction is the part `left` = μ_k/μ_s of what it was.
/// Check: springs that do not relax are [`Drawn`](super::Drawn) to the order of the springs.
pub struct SteppedDrawn {
    bed: Box<dyn TangentialBed>,
    suspension: Suspension,
    left: f64,
    /// Error of a step, relative to the way at which the contact slides.
    tolerance: f64,
    /// Speed V of the far end [m/s], and that of the depth [m/s].
    drawn: f64,
    led: f64,
    state: DrawnState,
    /// The direction 1 or −1 in which all slides.
    slides: Option<f64>,
    /// Duration of the next step [s].
    next: f64,
    /// The last step, where the motion has been smooth since.
    last: Option<Last>,
    /// Stiffness of the contact at the last change [N/m].
    stiffness: f64,
    steps: usize,
}

/// A step that has been taken.
#[derive(Clone, Copy)]
struct Last {
    /// Acceleration in it [m/s²], and how fast that changes [m/s³].
    pace: f64,
    turn: f64,
    /// Duration [s].
    step: f64,
}

/// A step that has been tried.
#[derive(Clone, Copy)]
struct Tried {
    /// Mean speed [m/s].
    mean: f64,
    /// Whether a spring sticks at its end.
    sticks: bool,
}

/// First step after a change, in radians of the mass on its contact.
const FIRST: f64 = 1e-3;
/// Change of the mean speed, relative to the speeds in a step, after which the next is of no account: a tenth of it at most,
/// for so well the stiffness is known.
const SETTLED: f64 = 1e-8;
/// A way that does not count, relative to that at which the contact slides, in which what has settled has a share.
const ROUNDING: f64 = 1e-7;
/// Most corrections of a mean speed, halvings of a step that ends a stick, corrections of one that ends there or where a slide does.
const MOST: usize = 40;
const HALVINGS: usize = 40;
const CORRECTIONS: usize = 4;
/// Most and least growth of a step, and how far below the error allowed the next one aims.
const GROWTH: (f64, f64) = (0.2, 2.0);
const SAFETY: f64 = 0.9;
/// Most steps.
const MOST_STEPS: usize = 500_000;

impl SteppedDrawn {
    /// A mass at rest on a contact with the springs `bed`, its spring in balance with them; `left` is μ_k/μ_s. Steps have
    /// the error `tolerance` in ways at which the contact slides.
    #[must_use]
    pub fn new(bed: Box<dyn TangentialBed>, suspension: Suspension, left: f64, tolerance: f64) -> Self {
        let Tangential { force, slide, .. } = bed.state();
        let state = DrawnState { extension: force / suspension.stiffness, slide, ..DrawnState::default() };
        let mut mass = Self {
            bed,
            suspension,
            left,
            tolerance,
            drawn: 0.0,
            led: 0.0,
            state,
            slides: None,
            next: 0.0,
            last: None,
            stiffness: 0.0,
            steps: 0,
        };
        mass.begin_anew();
        mass
    }

    /// The next step is short, and the acceleration of the last one tells nothing of it.
    fn begin_anew(&mut self) {
        self.stiffness = self.bed.state().stiffness;
        self.next = FIRST * (self.suspension.mass / (self.suspension.stiffness + self.stiffness)).sqrt();
        self.last = None;
    }

    /// The mean speed with which a step of the duration `step` [s] is in balance.
    fn tried(&self, step: f64) -> Result<Tried, MachineError> {
        let Suspension { mass, stiffness, damping } = self.suspension;
        let DrawnState { speed, extension, time, .. } = self.state;
        let stiff = 2.0 * mass / step + damping + 0.5 * stiffness * step;
        // Ways of rounding do not count.
        let rounding = ROUNDING * self.bed.gives_at() / step;
        let scale = speed.abs() + step * stiffness * extension.abs() / mass + self.drawn.abs() + rounding;
        let ahead = |last: Last| last.pace + 0.5 * last.turn * (step + last.step);
        let mut mean = speed + 0.5 * self.last.map_or(0.0, ahead) * step;
        let mut slope = stiff + 0.5 * self.stiffness * step;
        let mut before: Option<(f64, f64)> = None;
        for _ in 0..MOST {
            // The work of a bed that does not move tells no force.
            let way = if mean.abs() > 0.0 { mean } else { f64::EPSILON * scale };
            let (work, sticks) = self.bed.look((self.led, way), step);
            let force = work / (way * step);
            let driven = stiffness * (extension + 0.5 * self.drawn * step) + 2.0 * mass * speed / step;
            let miss = stiff * mean + force - driven;
            if let Some((at, was)) = before {
                let seen = (miss - was) / (mean - at);
                slope = if seen >= stiff { seen } else { slope };
            }
            before = Some((mean, miss));
            let change = miss / slope;
            mean -= change;
            if change.abs() <= SETTLED * scale {
                return Ok(Tried { mean, sticks });
            }
        }
        Err(MachineError::Stalled { time })
    }

    /// Takes a step that has been tried; one that `ends` does so at that time [s] to the last digit.
    fn take(&mut self, mean: f64, step: f64, ends: Option<f64>) {
        let Suspension { stiffness, damping, .. } = self.suspension;
        let DrawnState { time, slide, speed, extension, work, damped } = self.state;
        let drawn_out = (self.drawn - mean) * step;
        self.state = DrawnState {
            time: ends.unwrap_or(time + step),
            slide: slide + mean * step,
            speed: 2.0 * mean - speed,
            extension: extension + drawn_out,
            work: work + stiffness * (extension + 0.5 * drawn_out) * self.drawn * step,
            damped: damped + damping * mean * mean * step,
        };
        let pace = 2.0 * (mean - speed) / step;
        let turn = self.last.map_or(0.0, |last| (pace - last.pace) / (0.5 * (step + last.step)));
        self.last = Some(Last { pace, turn, step });
        self.bed.go((self.led, mean), step);
    }

    /// How much longer the next step may be than one of the duration `step` [s] at the mean speed `mean` [m/s].
    fn growth(&self, mean: f64, step: f64) -> f64 {
        let Some(last) = self.last else { return GROWTH.1 };
        let turned = (2.0 * (mean - self.state.speed) / step - last.pace) / (0.5 * (step + last.step));
        let error = step.powi(3) * turned.abs() / 12.0;
        let growth = SAFETY * (self.tolerance * self.bed.gives_at() / error).cbrt();
        growth.clamp(GROWTH.0, GROWTH.1)
    }

    /// The contact begins to slide as a whole somewhere in a step.
    fn slip(&mut self, step: f64, mut mean: f64) -> Result<DrawnMoment, MachineError> {
        let mut ends = step;
        for _ in 0..CORRECTIONS {
            let (mut low, mut high) = (0.0, step);
            for _ in 0..HALVINGS {
                let middle = 0.5 * (low + high);
                let (_, sticks) = self.bed.look((self.led, mean), middle);
                *(if sticks { &mut low } else { &mut high }) = middle;
            }
            ends = high;
            mean = self.tried(ends)?.mean;
        }
        self.take(mean, ends, None);
        let force = self.bed.state().force;
        self.slides = Some(if force < 0.0 { -1.0 } else { 1.0 });
        if self.left < 1.0 {
            self.bed.give_way(self.left);
        }
        self.begin_anew();
        Ok(DrawnMoment { what: Turnover::Slips, state: self.state, force })
    }

    /// A mass that slides comes to rest somewhere in a step.
    fn stick(&mut self, step: f64, mut mean: f64) -> Result<DrawnMoment, MachineError> {
        let from = self.state.speed;
        let mut time = step;
        for _ in 0..CORRECTIONS {
            time *= 0.5 * from / (from - mean);
            mean = self.tried(time)?.mean;
        }
        self.take(mean, time, None);
        self.state.speed = 0.0;
        let force = self.bed.state().force;
        self.slides = None;
        if self.left < 1.0 {
            self.bed.give_way(self.left.recip());
        }
        self.begin_anew();
        Ok(DrawnMoment { what: Turnover::Sticks, state: self.state, force })
    }
}

impl DrawnMass for SteppedDrawn {
    fn draw(&mut self, speed: f64) {
        self.drawn = speed;
        self.begin_anew();
    }

    fn lead(&mut self, speed: f64) {
        self.led = speed;
    }

    fn step(&mut self, until: f64) -> Result<Option<DrawnMoment>, MachineError> {
        while self.state.time < until {
            self.steps += 1;
            if self.steps > MOST_STEPS {
                return Err(MachineError::TooManySteps { most: MOST_STEPS, time: self.state.time });
            }
            let left = until - self.state.time;
            let (step, ends) = if self.next < left { (self.next, None) } else { (left, Some(until)) };
            let Tried { mean, sticks } = self.tried(step)?;
            let growth = self.growth(mean, step);
            if growth < SAFETY {
                self.next = growth * step;
                continue;
            }
            let to = 2.0 * mean - self.state.speed;
            match self.slides {
                Some(ahead) if ahead * to <= 0.0 && ahead * self.state.speed > 0.0 => {
                    return self.stick(step, mean).map(Some);
                }
                None if !sticks => return self.slip(step, mean).map(Some),
                Some(_) | None => {}
            }
            self.take(mean, step, ends);
            self.next = if ends.is_some() { self.next.max(growth * step) } else { growth * step };
        }
        Ok(None)
    }

    fn state(&self) -> DrawnState {
        self.state
    }

    fn suspension(&self) -> Suspension {
        self.suspension
    }

    fn tangential(&self) -> Tangential {
        let state = self.bed.state();
        let (stick_radius, stiffness) =
            if self.slides.is_some() { (0.0, 0.0) } else { (state.stick_radius, state.stiffness) };
        Tangential { slide: self.state.slide, stick_radius, stiffness, ..state }
    }

    fn relaxed(&self) -> f64 {
        self.bed.relaxed()
    }
}
