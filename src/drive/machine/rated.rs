//! A mass on a contact with friction of rate and state, drawn along the surface by a spring.

use super::drawn::{DrawnMoment, DrawnState, Turnover};
use super::stability::{Carried, threshold};
use super::{DrawnMass, MachineError, Suspension};
use crate::contact::state::Tangential;
use crate::friction::{RateState, SlipRate};
use crate::numerics::stiff::{Stepper, StiffMotion, Whole};

/// Extension of the spring [m], speed of the mass [m/s], load F_x/F, ln(V*θ/D_c).
type Numbers = [f64; 4];
/// The same, with the work of the far end, the energy lost in the damper and that lost to friction [J].
type State = Whole<4, 3>;

/// A mass that a spring draws over a contact with one state: m ẍ + c ẋ + k(x − X) = −F_x, F_x = κ(x − s), and ds/dt = V(F_x, θ).
///
/// The contact gives with the stiffness κ = 2G*a of one that sticks, in series with the spring, and behind that slips as a
/// whole: it has one friction and one state, all of its junctions have slipped alike. Where the state differs from place to
/// place (D_c not large against the displacements in partial slip, F_x/κ times some tenths) this is an approximation; the
/// annulus of partial slip of Cattaneo and Mindlin is left out. A contact whose κ is not above the fall of its friction over
/// the way, F(b − a)/D_c (under the slip law times ln(Vθ/D_c)), lets go by itself, faster than any mass can follow: in truth
/// as a rupture that runs through it. There the motion ends with an error. The contact creeps at any load and never sticks, so that
/// there are no events: the motion is smooth, though stiff, and is followed in extrapolated implicit steps of [`Stepper`],
/// in F_x and ln θ, which are the logarithms of speed and state. The steps know nothing of where the motion is looked at;
/// such a look is a step of its own, beside them.
///
/// A slip is told where the contact has become ten times as fast as the far end, and its end where it is slower again.
/// Check: F_x = μ_ss(V)F in steady sliding; steady sliding is lost at [`threshold`].
#[derive(Debug, Clone)]
pub struct RatedMass {
    motion: Rated,
    stepper: Stepper,
    /// Where the steps are.
    base: Moment,
    /// The end of the next one, if it is known.
    next: Option<Moment>,
    /// What is told of.
    now: Moment,
    steps: usize,
    /// Speed of the far end that slips are held against [m/s].
    gauge: f64,
    slips: bool,
    /// End of the step [s] in which it was fastest, if that has been told.
    told: f64,
}

/// A state, its time [s], and the place of the far end then [m].
#[derive(Debug, Clone, Copy, PartialEq)]
struct Moment {
    time: f64,
    end: f64,
    whole: State,
}

/// The forces.
#[derive(Debug, Clone)]
struct Rated {
    suspension: Suspension,
    law: RateState,
    carried: Carried,
    /// Speed V of the far end [m/s].
    drawn: f64,
}

/// State of a contact with friction of rate and state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RatedState {
    /// State θ [s].
    pub state: f64,
    /// Speed V of slip [m/s].
    pub speed: f64,
}

/// Most steps of a motion.
const MOST_STEPS: usize = 20_000_000;
/// A slip is faster than the far end by this factor.
const FAST: f64 = 10.0;
/// First step, relative to the shortest time in which anything changes.
const FIRST: f64 = 0.05;
/// Longest step, in times that the far end takes over D_c: where steady sliding does not last, a longer one would keep it.
const LONGEST: f64 = 3.0;
/// Longest step of all, in times that the reference speed takes over D_c and in radians of a swing.
const LASTING: f64 = 1e9;
/// How closely the moment of the greatest speed is looked for, as a part of the step: the speed errs by the square of that.
const PEAK: f64 = 1e-5;
/// Least direct effect that errors are held against: below it they would be rounding of the load.
const LEAST: f64 = 1e-4;
/// Most trials for the beginning or the end of a slip, and how close the speed must come to that of a slip.
const MOST_TRIALS: usize = 60;
const CLOSE: f64 = 1e-13;

impl Rated {
    fn slip(&self, [_, _, load, log]: &Numbers) -> SlipRate {
        self.law.slip(*load, *log)
    }

    /// d ln|V|/dt [1/s] of the contact.
    fn quickens(&self, state: &Numbers) -> f64 {
        let (rate, slip) = (self.rate(state).0, self.slip(state));
        rate[2] * slip.by_load / slip.speed - self.law.evolution.si() / self.law.direct.si() * rate[3]
    }

    /// Longest step [s].
    fn longest(&self) -> f64 {
        let Suspension { mass, stiffness, .. } = self.suspension;
        let distance = self.law.distance.si();
        let lasting = LASTING * (distance / self.law.speed.si() + (mass / stiffness).sqrt());
        let speed = self.drawn.abs();
        if speed <= 0.0 || threshold(&self.law, speed, (&self.suspension, self.carried)).is_steady(stiffness) {
            return lasting;
        }
        lasting.min(LONGEST * distance / speed)
    }

    /// First step [s] from a state.
    fn first(&self, state: &Numbers) -> f64 {
        let (rate, whole) = (self.rate(state).0, self.whole(&state.map(f64::abs)).0);
        let times = rate.iter().zip(whole).filter(|(rate, _)| rate.abs() > 0.0).map(|(rate, whole)| whole / rate.abs());
        FIRST * times.fold(self.law.distance.si() / self.law.speed.si().max(self.drawn.abs()), f64::min)
    }
}

impl StiffMotion<4, 3> for Rated {
    fn rate(&self, state: &Numbers) -> (Numbers, [f64; 3]) {
        let Suspension { mass, stiffness, damping } = self.suspension;
        let (&[extension, speed, load, log], slip) = (state, self.slip(state));
        let (pull, drag, friction) = (stiffness * extension, damping * speed, self.carried.force * load);
        let rates = [
            self.drawn - speed,
            (pull - drag - friction) / mass,
            (speed - slip.speed) / self.carried.force * self.carried.stiffness,
            self.law.evolves(&slip, log),
        ];
        (rates, [pull * self.drawn, drag * speed, friction * slip.speed])
    }

    fn slopes(&self, state: &Numbers) -> [Numbers; 4] {
        let Suspension { mass, stiffness, damping } = self.suspension;
        let (&[_, _, _, log], slip) = (state, self.slip(state));
        let give = self.carried.stiffness / self.carried.force;
        let by_log = -slip.speed * (self.law.evolution.si() / self.law.direct.si());
        let [by_load, of_itself] = self.law.evolution_slopes(&slip, log);
        [
            [0.0, -1.0, 0.0, 0.0],
            [stiffness / mass, -damping / mass, -self.carried.force / mass, 0.0],
            [0.0, give, -give * slip.by_load, -give * by_log],
            [0.0, 0.0, by_load, of_itself],
        ]
    }

    /// What changes the speed of slip by a factor of e, by force, and as the speed of a swing; energies of the contact.
    fn whole(&self, [_, speed, ..]: &Numbers) -> (Numbers, [f64; 3]) {
        let Suspension { mass, stiffness, .. } = self.suspension;
        let (a, force) = (self.law.direct.si().max(LEAST), self.carried.force);
        let whole = stiffness + self.carried.stiffness;
        let energy = force * (force / whole);
        ([a * force / stiffness, a * force / (mass * whole).sqrt() + speed, a, 1.0], [energy; 3])
    }
}

impl RatedMass {
    /// A mass at rest on a contact under `carried` that has not slipped since it was made, the time `age` [s] ago; each step errs
    /// by `tolerance` of what changes the speed of slip by a factor of e.
    #[must_use]
    pub fn new(suspension: Suspension, law: &RateState, (carried, age, tolerance): (Carried, f64, f64)) -> Self {
        let log = law.log_state(law.rested(age));
        Self::from_state(Rated { suspension, law: law.clone(), carried, drawn: 0.0 }, [0.0, 0.0, 0.0, log], tolerance)
    }

    /// A mass that slides steadily with the far end at the speed `speed` [m/s], above zero, but for the state of the contact, the
    /// logarithm of which is larger by `disturbed`.
    #[must_use]
    pub fn sliding(
        suspension: Suspension,
        law: &RateState,
        (carried, tolerance): (Carried, f64),
        (speed, disturbed): (f64, f64),
    ) -> Self {
        let load = law.steady(speed);
        let pull = load * carried.force + suspension.damping * speed;
        let log = disturbed - (speed / law.speed.si()).ln();
        let state = [pull / suspension.stiffness, speed, load, log];
        let mut mass = Self::from_state(Rated { suspension, law: law.clone(), carried, drawn: 0.0 }, state, tolerance);
        mass.draw(speed);
        mass
    }

    fn from_state(motion: Rated, state: Numbers, tolerance: f64) -> Self {
        let whole = Whole { state, sums: [0.0; 3] };
        let base =
            Moment { time: 0.0, end: state[0] + motion.carried.force / motion.carried.stiffness * state[2], whole };
        let stepper = Stepper::new(tolerance, motion.first(&state));
        Self {
            motion,
            stepper,
            base,
            next: None,
            now: base,
            steps: 0,
            gauge: 0.0,
            slips: false,
            told: f64::NEG_INFINITY,
        }
    }

    /// State of the contact.
    #[must_use]
    pub fn rated(&self) -> RatedState {
        let state = &self.now.whole.state;
        RatedState { state: self.motion.law.state(state[3]), speed: self.motion.slip(state).speed }
    }

    /// Number of steps so far.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.steps
    }

    /// `step` [s] on from `from`.
    fn moved(&self, from: &Moment, (step, whole): (f64, State)) -> Moment {
        Moment { time: from.time + step, end: from.end + self.motion.drawn * step, whole }
    }

    /// Why there is no step: the only speed that grows within no time is that of a contact which lets go by itself.
    fn ruptures(&self, time: f64) -> MachineError {
        let Carried { force, stiffness } = self.motion.carried;
        let fall = self.motion.law.evolution.si() - self.motion.law.direct.si();
        MachineError::Ruptures { time, stiffness, fall: force * fall / self.motion.law.distance.si() }
    }

    /// The end of the next step.
    fn ahead(&mut self) -> Result<Moment, MachineError> {
        if let Some(next) = self.next {
            return Ok(next);
        }
        self.steps += 1;
        if self.steps > MOST_STEPS {
            return Err(MachineError::TooManySteps { most: MOST_STEPS, time: self.base.time });
        }
        let stepped = self.stepper.step(&self.motion, &self.base.whole, self.motion.longest());
        let next = self.moved(&self.base, stepped.ok_or(self.ruptures(self.base.time))?);
        self.next = Some(next);
        Ok(next)
    }

    /// The motion `after` [s] behind the beginning of the present step, and inside it.
    fn within(&self, after: f64) -> Result<Moment, MachineError> {
        let (mut stepper, mut at, mut gone) = (self.stepper, self.base, 0.0);
        stepper.restart(after);
        while gone < after {
            let stepped = stepper.step(&self.motion, &at.whole, after - gone);
            let (step, whole) = stepped.ok_or(self.ruptures(at.time))?;
            gone = if step < after - gone { gone + step } else { after };
            at = self.moved(&self.base, (gone, whole));
        }
        Ok(at)
    }

    /// ln(|V|/V₀) of the contact, V₀ the speed that begins or ends a slip.
    fn above(&self, state: &Numbers) -> f64 {
        let least = if self.slips { self.gauge } else { FAST * self.gauge };
        self.motion.slip(state).log - (least / self.motion.law.speed.si()).ln()
    }

    /// Whether a slip begins or ends in the present step.
    fn turns_over(&self, next: &Moment) -> bool {
        self.gauge > 0.0 && (self.above(&next.whole.state) > 0.0) != self.slips
    }

    /// When in the present step of the length `span` a slip begins or ends: by Newton's method, guarded by halving.
    fn turnover(&self, span: f64) -> Result<Moment, MachineError> {
        let (mut low, mut high) = (0.0, span);
        let mut after = 0.5 * span;
        let mut at = self.base;
        for _ in 0..MOST_TRIALS {
            at = self.within(after)?;
            let (state, above) = (&at.whole.state, self.above(&at.whole.state));
            if (above > 0.0) == self.slips {
                low = after
            } else {
                high = after
            }
            let slope = self.motion.quickens(state);
            if above.abs() <= CLOSE || high - low <= 4.0 * f64::EPSILON * span {
                break;
            }
            let newton = after - above / slope;
            after = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        }
        Ok(at)
    }
}

impl RatedMass {
    /// Whether the contact slips fastest inside the present step, and that has not been told.
    fn peaks(&self, next: &Moment) -> bool {
        let [before, behind] = [&self.base, next].map(|at| self.motion.quickens(&at.whole.state));
        self.slips && self.told < next.time && before > 0.0 && behind < 0.0
    }

    /// When in the present step of the length `span` it does: by halves, for near its peak a speed hardly changes.
    fn peak(&self, span: f64) -> Result<Moment, MachineError> {
        let (mut low, mut high) = (0.0, span);
        let mut at = self.base;
        while high - low > PEAK * span {
            let after = 0.5 * (low + high);
            at = self.within(after)?;
            if self.motion.quickens(&at.whole.state) > 0.0 { low = after } else { high = after }
        }
        Ok(at)
    }

    /// What is told of the moment, which is the present one from now on.
    fn tell(&mut self, what: Turnover, moment: Moment) -> DrawnMoment {
        self.now = moment;
        DrawnMoment { what, state: self.state(), force: self.tangential().force }
    }
}

impl DrawnMass for RatedMass {
    fn draw(&mut self, speed: f64) {
        if (speed - self.motion.drawn).abs() <= 0.0 {
            return;
        }
        (self.base, self.next, self.motion.drawn) = (self.now, None, speed);
        if speed.abs() > 0.0 {
            self.gauge = speed.abs();
        }
        self.stepper.restart(self.motion.first(&self.base.whole.state));
    }

    fn step(&mut self, until: f64) -> Result<Option<DrawnMoment>, MachineError> {
        loop {
            let next = self.ahead()?;
            if self.peaks(&next) {
                let moment = self.peak(next.time - self.base.time)?;
                if moment.time <= until {
                    self.told = next.time;
                    return Ok(Some(self.tell(Turnover::Fastest, moment)));
                }
            }
            if self.turns_over(&next) {
                let moment = self.turnover(next.time - self.base.time)?;
                if moment.time <= until {
                    self.slips = !self.slips;
                    // The step goes on from there: it is cut where the motion says, not where it is looked at.
                    (self.base, self.next) = (moment, None);
                    let what = if self.slips { Turnover::Slips } else { Turnover::Sticks };
                    return Ok(Some(self.tell(what, moment)));
                }
            }
            if next.time > until {
                self.now = self.within(until - self.base.time)?;
                self.now.time = until;
                return Ok(None);
            }
            (self.base, self.next, self.now) = (next, None, next);
        }
    }

    fn state(&self) -> DrawnState {
        let Moment { time, end, whole: Whole { state: [extension, speed, ..], sums: [work, damped, _] } } = self.now;
        DrawnState { time, slide: end - extension, speed, extension, work, damped }
    }

    fn suspension(&self) -> Suspension {
        self.motion.suspension
    }

    fn tangential(&self) -> Tangential {
        let Carried { force, stiffness } = self.motion.carried;
        let pulled = force * self.now.whole.state[2];
        Tangential {
            slide: self.state().slide,
            force: pulled,
            stick_radius: 0.0,
            stiffness,
            stored: Some(0.5 * pulled * (pulled / stiffness)),
            dissipated: Some(self.now.whole.sums[2]),
            area_ratio: None,
        }
    }

    fn rated(&self) -> Option<RatedState> {
        Some(Self::rated(self))
    }
}
