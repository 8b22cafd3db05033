//! A mass on a contact of any kind, step by step.

use super::{ImpactState, Projectile, Rebound};
use crate::contact::error::ContactError;
use crate::contact::model::{ContactModel, Straight};
use crate::drive::force::{ahead, depth_of, is_damped};
use crate::numerics::extremum::{self, Peak, top_through};
use std::f64::consts::PI;

/// A mass that drives any contact in straight pieces of its depth.
///
/// In a step of the duration h the depth goes straight, with the mean w of the speeds at both ends:
/// m(v₁ − v₀) = −∫F dt, the impulse of the contact along the piece by Simpson's rule. m(v₁² − v₀²)/2 = −w∫F dt is
/// then its work: kinetic energy, stored energy and heat add up to the error of that rule however long the
/// steps. Of second order in h. The energy of an elastic impact and the collocation of a viscoelastic one are the
/// better answers where they exist; this one is theirs to be held against, and serves any contact they do not know.
///
/// A body that takes the speed long before it gives way (a dashpot, or an edge that creeps on) leaves a mass that moves
/// far more slowly than it struck: it is followed in steps of its own pace.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SteppedMass {
    /// The mass and its speed.
    pub impact: Projectile,
    /// Time of the impact on the stiffest bodies [s], or about as long.
    pub time: f64,
    /// Steps in that time.
    pub steps: f64,
}

/// Steps after which a mass that does not come back counts as stuck.
const MOST_STEPS: usize = 200_000;
/// First step, relative to the longest: the force rises from zero like a root.
const FIRST: f64 = 1e-6;
/// Change of the mean speed, relative to the speed of the impact, after which the next is of no account: each is (ωh)²/4
/// of the one before.
const SETTLED: f64 = 1e-9;
/// (ωh)²/4 of a step, or as much of what damps it, in which a mass no longer swings: the speed at its end, which would lie
/// now on one side of the motion and now on the other, and further off from step to step, is that of the means.
const STIFF: f64 = 4.0;
/// How often the last step of a mass that sticks is cut: its speed goes to zero all but linearly.
const MOST_CUTS: usize = 6;
/// Looks at the pull in a step in which it may turn, each a quarter as far from its end as the last and, before the middle,
/// each four times as far from its beginning: a pull turns just after a step begins, or just before the bodies part.
const FIRST_LOOKS: i32 = 4;
const LAST_LOOKS: i32 = 12;
/// Part of a step by which the turn of the parabola through three forces may miss that of the pull.
const MISSED: f64 = 0.25;
/// Growth of the steps at first, relative to the time that has passed.
const GROWTH: f64 = 0.1;
/// A mass that moves by so much more slowly than it struck is slow: its steps grow with its pace.
const SLOW: f64 = 4.0;
/// Part of the greatest depth that does not count: a mass with less to go has come to rest.
const REST: f64 = 1e-9;

/// The mean speeds [m/s] of two steps, each at its middle [s], led on to the time `time` [s].
pub fn led_on([one, other]: [(f64, f64); 2], time: f64) -> f64 {
    other.1 + (other.1 - one.1) / (other.0 - one.0) * (time - other.0)
}

/// Force [N] of a contact as it moves on at the speed `speed` [m/s] for a while of the order `duration` [s]: a dashpot takes
/// on at once that of the mass, where the piece behind it had the mean of a step.
///
/// # Errors
/// The contact cannot be looked at.
pub fn force_at(contact: &mut dyn ContactModel, speed: f64, duration: f64) -> Result<f64, ContactError> {
    if !is_damped(contact) {
        return Ok(contact.state().force);
    }
    Ok(contact.look(&ahead(contact, speed, f64::EPSILON * duration))?.force)
}

/// Is told of the states at the ends of the steps.
pub type Watcher<'w> = dyn FnMut(ImpactState, &dyn ContactModel) + 'w;

/// The mass on its way.
struct MovingMass<'c> {
    contact: &'c mut dyn ContactModel,
    impact: Projectile,
    /// 1/ω \[s\] of a mass that swings as it struck.
    struck: f64,
    speed: f64,
    time: f64,
    /// Time and force at the ends of the last two steps.
    before: [Peak; 2],
    /// Middle and mean speed of the last three.
    means: [(f64, f64); 3],
    /// Half the force [N] more per speed and mass, as in the last step [1/s].
    resistance: f64,
    /// Forces [N] at the beginning, in the middle and at the end of the piece looked at last.
    forces: [f64; 3],
    /// Whether it no longer swings: then its inertia is next to nothing, and a step longer than that could tell.
    creeps: bool,
    /// Whether it has turned once.
    turned: bool,
    most: Rebound,
}

impl SteppedMass {
    /// What comes of the impact on a contact that just touches.
    ///
    /// # Errors
    /// The contact cannot follow.
    pub fn rebound(&self, contact: &mut dyn ContactModel) -> Result<Rebound, ContactError> {
        self.watched(contact, &mut |_, _| ())
    }

    /// The same, with the states at the ends of all steps.
    ///
    /// A mass that turns a second time has stuck: it has less energy than it had at the first turn.
    ///
    /// # Errors
    /// As of [`rebound`](Self::rebound).
    pub fn watched(&self, contact: &mut dyn ContactModel, watcher: &mut Watcher<'_>) -> Result<Rebound, ContactError> {
        let most = Rebound { lost: self.impact.energy(), ..Rebound::default() };
        let (impact, speed) = (self.impact, self.impact.speed);
        let (before, means) = ([Peak { place: 0.0, value: 0.0 }; 2], [(0.0, speed); 3]);
        // The period of a mass that swings goes by in π of its paces.
        let (struck, longest) = (self.time / PI, self.time / self.steps);
        let mut way = MovingMass {
            contact,
            impact,
            struck,
            speed,
            time: 0.0,
            before,
            means,
            resistance: 0.0,
            forces: [0.0; 3],
            creeps: false,
            turned: false,
            most,
        };
        let mut step = FIRST * longest;
        for _ in 0..MOST_STEPS {
            if way.step(step, watcher)? || way.rests() || (way.turned && way.speed >= 0.0) {
                break;
            }
            way.turned |= way.speed < 0.0;
            let slower = (way.pace() / (SLOW * struck)).max(1.0);
            step = (longest * slower).min(GROWTH * way.time + FIRST * longest);
        }
        Ok(way.most)
    }
}

impl MovingMass<'_> {
    /// Whether the mass stands still: at its pace it will not get anywhere any more.
    fn rests(&self) -> bool {
        let pace = self.pace();
        (self.speed.abs() + self.slowing().0.abs() * pace) * pace < REST * self.most.greatest_depth
    }

    /// Time [s] in which the motion changes: 1/ω of a mass that swings as it struck, 1/ω = `struck`, at any moment of
    /// the swing, T of one whose speed goes as exp(−t/T).
    fn pace(&self) -> f64 {
        let (rate, change) = self.slowing();
        let pace = self.speed.hypot(self.struck * rate) / rate.hypot(self.struck * change);
        if pace.is_finite() { pace } else { self.struck }
    }

    /// A speed [m/s] of the order of what counts: that of the impact, and less of a mass that creeps.
    fn fast(&self) -> f64 {
        let creeping = self.most.greatest_depth / self.pace();
        if creeping > 0.0 { creeping.min(self.impact.speed) } else { self.impact.speed }
    }

    /// How fast the speed changes [m/s²], and that [m/s³]: of the mean speeds, for those at the ends of long steps behind a
    /// dashpot lie now on one side of the motion and now on the other.
    fn slowing(&self) -> (f64, f64) {
        let slope = |one: (f64, f64), two: (f64, f64)| (0.5 * (one.0 + two.0), (two.1 - one.1) / (two.0 - one.0));
        let [first, second, third] = self.means;
        let (early, late) = (slope(first, second), slope(second, third));
        (late.1, slope(early, late).1)
    }

    /// One step; whether the bodies have parted in it.
    fn step(&mut self, duration: f64, watcher: &mut Watcher<'_>) -> Result<bool, ContactError> {
        let (from, fast) = (depth_of(self.contact), self.speed);
        let (mean, duration) = self.until_it_sticks(duration)?;
        let parted = mean < 0.0 && !self.joined_after(mean, duration)?;
        // The pull at the moment of parting belongs to the impulse, the nothing after it does not.
        let (held, duration) = if parted { self.parting(mean, duration)? } else { (duration, duration) };
        let pull = self.strongest_pull(mean, held, parted)?;
        self.means = [self.means[1], self.means[2], (self.time + 0.5 * held, mean)];
        self.creeps = !parted && self.resistance * duration > STIFF;
        self.speed = if parted {
            self.speed - self.impulse(mean, held)? / self.impact.mass
        } else if self.creeps {
            self.speed_by_means(self.time + held)
        } else {
            // With the mean of the speeds at both ends the impulse is 2m(v₀ − w), which it need not be asked for again.
            2.0 * mean - self.speed
        };
        if let Some((time, speed)) = pull {
            self.contact.follow(&ahead(self.contact, mean, time))?;
            watcher(self.state(self.time + time, speed)?, self.contact);
        }
        self.contact.follow(&ahead(self.contact, mean, held - pull.map_or(0.0, |(time, _)| time)))?;
        let at_end = self.state(self.time + held, self.speed)?;
        watcher(at_end, self.contact);
        if parted {
            self.contact.follow(&ahead(self.contact, mean, duration - held))?;
            let depth = depth_of(self.contact);
            // An edge that obeys a rate may hold a little longer on a way cut in two: it has had its time.
            if self.contact.joined() {
                self.contact.leave();
            }
            watcher(ImpactState { depth, ..self.state(self.time + duration, self.speed)? }, self.contact);
        }
        self.time += duration;
        let force = self.greatest_force(at_end.force);
        let most = &mut self.most;
        // Where the speed passes zero, it has gone linearly.
        let top = if fast > 0.0 && self.speed < 0.0 { fast / (fast - self.speed) * 0.5 * fast * duration } else { 0.0 };
        most.greatest_depth = most.greatest_depth.max(depth_of(self.contact)).max(from + top);
        most.greatest_force = most.greatest_force.max(force);
        if parted {
            most.restitution = -self.speed / self.impact.speed;
            most.lost = self.impact.energy() - 0.5 * self.impact.mass * self.speed * self.speed;
            most.contact_time = Some(self.time);
        }
        Ok(parted)
    }

    /// Mean speed [m/s] and duration [s] of a step of the duration `duration` [s] at most, cut where a mass that has turned
    /// turns again.
    fn until_it_sticks(&mut self, duration: f64) -> Result<(f64, f64), ContactError> {
        let (mut mean, mut held) = (self.mean_speed(duration)?, duration);
        if !self.turned || mean <= 0.5 * self.speed {
            return Ok((mean, held));
        }
        for _ in 0..MOST_CUTS {
            let end = 2.0 * mean - self.speed;
            if end.abs() <= SETTLED * self.impact.speed {
                break;
            }
            held = (held * self.speed / (self.speed - end)).min(duration);
            mean = self.mean_speed(held)?;
            // In a shorter step it does not turn: behind a dashpot the speed at its beginning was not that of the motion.
            if mean <= self.speed {
                return Ok((mean, held));
            }
        }
        Ok((mean.max(0.5 * self.speed), held))
    }

    /// Speed [m/s] at the time `time` [s], to which the mean speeds of the last two steps are led on: behind a dashpot those at
    /// the ends of long steps lie now on one side of the motion and now on the other.
    fn speed_by_means(&self, time: f64) -> f64 {
        let [_, early, late] = self.means;
        let led = led_on([early, late], time);
        if led.is_finite() { led } else { self.speed }
    }

    /// The state at the time `time` [s], at which the mass has the speed `speed` [m/s].
    fn state(&mut self, time: f64, speed: f64) -> Result<ImpactState, ContactError> {
        let state = self.contact.state();
        // What a dashpot makes of a speed that is a little off is more than there is.
        let force = if self.creeps {
            -self.impact.mass * self.slowing().0
        } else {
            let led = self.speed_by_means(time);
            force_at(self.contact, led, time)?
        };
        Ok(ImpactState {
            time,
            depth: depth_of(self.contact),
            speed,
            force,
            radius: state.contact_radius.unwrap_or(0.0),
            stored: state.stored,
            dissipated: state.dissipated,
        })
    }

    /// `force` [N], that at the end of a step, or that of the parabola through it and those before, where that has its top
    /// between them.
    fn greatest_force(&mut self, force: f64) -> f64 {
        let now = Peak { place: self.time, value: force };
        let [first, second] = self.before;
        self.before = [second, now];
        top_through([first, second, now]).map_or(force, |top| top.value)
    }

    /// ∫F dt [N s] over a piece at the speed `mean` [m/s].
    fn impulse(&mut self, mean: f64, duration: f64) -> Result<f64, ContactError> {
        // A dashpot takes the new speed on at once: the beginning is just after it.
        let mut force = |part: f64| self.force_after(mean, part * duration);
        let forces = [force(f64::EPSILON)?, force(0.5)?, force(1.0)?];
        self.forces = forces;
        Ok(duration / 6.0 * (forces[0] + 4.0 * forces[1] + forces[2]))
    }

    /// Force [N] after a piece at the speed `mean` [m/s].
    fn force_after(&mut self, mean: f64, duration: f64) -> Result<f64, ContactError> {
        let piece: Straight = ahead(self.contact, mean, duration);
        Ok(self.contact.look(&piece)?.force)
    }

    /// The time [s] in a piece outwards at which the pull is greatest, and the speed [m/s] there, unless that is at one of its
    /// ends; `parts` if the bodies part at its end, just before which it may be.
    fn strongest_pull(&mut self, mean: f64, duration: f64, parts: bool) -> Result<Option<(f64, f64)>, ContactError> {
        let [first, middle, last] = self.forces;
        // The parabola through them turns in the step, or near it.
        let (bend, turn) = (first - 2.0 * middle + last, 0.25 * (3.0 * first - 4.0 * middle + last));
        let may_turn = turn > -MISSED * bend && turn < (1.0 + MISSED) * bend;
        if mean >= 0.0 || !(parts || may_turn && middle.min(first).min(last) < 0.0) {
            return Ok(None);
        }
        let early = (1..=FIRST_LOOKS).rev().map(|k| 0.25f64.powi(k));
        let late = (1..=LAST_LOOKS).map(|k| 1.0 - 0.25f64.powi(k));
        let looks = [0.0].into_iter().chain(early).chain([0.5]).chain(late).chain([1.0]);
        let times: Vec<f64> = looks.map(|part| part * duration).collect();
        let pull = |time: f64| Ok::<_, ContactError>(-self.force_after(mean, time.max(f64::EPSILON * duration))?);
        let Some(Peak { place: time, .. }) = extremum::turn(pull, &times)?.filter(|peak| peak.value > 0.0) else {
            return Ok(None);
        };
        Ok(Some((time, self.speed - self.impulse(mean, time)? / self.impact.mass)))
    }

    fn joined_after(&mut self, mean: f64, duration: f64) -> Result<bool, ContactError> {
        let piece = ahead(self.contact, mean, duration);
        Ok(self.contact.look(&piece)?.contact_radius > 0.0)
    }

    /// w = v₀ − ½∫F dt/m with the impulse along w itself, from the last speeds and the last resistance on.
    fn mean_speed(&mut self, duration: f64) -> Result<f64, ContactError> {
        let mass = self.impact.mass;
        let (late, last_mean) = self.means[2];
        let guess = last_mean + self.slowing().0 * (self.time + 0.5 * duration - late);
        let mut mean = if guess.is_finite() { guess } else { self.speed };
        let mut slope = -1.0 - self.resistance * duration;
        let mut last: Option<(f64, f64)> = None;
        let least = SETTLED * self.fast();
        for _ in 0..20 {
            let miss = self.speed - 0.5 * self.impulse(mean, duration)? / mass - mean;
            let seen = last.map_or(slope, |(w, m)| (miss - m) / (mean - w));
            slope = if seen.is_finite() && seen < -0.5 { seen } else { -1.0 };
            last = Some((mean, miss));
            let better = mean - miss / slope;
            let settled = (better - mean).abs() <= least;
            mean = better;
            if settled {
                break;
            }
        }
        self.resistance = (-1.0 - slope) / duration;
        Ok(mean)
    }

    /// The last time in the step at which the bodies hold, and the first at which they have parted.
    fn parting(&mut self, mean: f64, duration: f64) -> Result<(f64, f64), ContactError> {
        let (mut low, mut high) = (0.0, duration);
        for _ in 0..48 {
            let middle = 0.5 * (low + high);
            *(if self.joined_after(mean, middle)? { &mut low } else { &mut high }) = middle;
        }
        Ok((low, high))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::adhesion::line::EdgeLine;
    use crate::contact::direct::QuasiStatic;
    use crate::contact::foundation::Foundation;
    use crate::contact::viscoelastic::Spectrum;
    use crate::contact::viscoelastic::attraction::Attraction;
    use crate::contact::viscoelastic::continuous::ContinuousContact;
    use crate::contact::viscoelastic::memory::Memory;
    use crate::drive::impact::Passage;
    use crate::input::quantity::Length;
    use crate::material::Relaxation;
    use crate::shape::Paraboloid;
    use std::sync::Arc;

    /// A ball, R = 1, on a bed with an adhesive edge: what comes of it in `steps` steps, and how far kinetic, stored and
    /// lost energy together go astray, as a part of the first.
    fn held(terms: &[(f64, f64)], work: f64, impact: Projectile, steps: f64) -> (Rebound, f64) {
        let relaxation = Relaxation { equilibrium: 1.0, terms: terms.to_vec(), viscosity: 0.0 };
        let spectrum = Arc::new(Spectrum::new(&relaxation));
        let attraction = Attraction::relaxed(work, &spectrum).to_accuracy(1e-6);
        let ball = Arc::new(Paraboloid { radius: Length::new(1.0).unwrap() });
        let mut contact = ContinuousContact::new(Memory::new(spectrum, ball).with(attraction));
        let mut astray: f64 = 0.0;
        let mut watcher = |state: ImpactState, _: &dyn ContactModel| {
            let kinetic = 0.5 * impact.mass * state.speed * state.speed;
            let all = kinetic + state.stored.stored() + state.dissipated;
            astray = astray.max((all / impact.energy() - 1.0).abs());
        };
        let mass = SteppedMass { impact, time: 3.0, steps };
        (mass.watched(&mut contact, &mut watcher).unwrap(), astray)
    }

    /// A bed whose edge could remember but whose bodies do not: the energy of the direct path, jump in and pull-off. The
    /// ledger is open by what Simpson's rule misses where the edge jumps.
    #[test]
    fn an_edge_without_memory_is_the_elastic_impact() {
        let impact = Projectile { mass: 1.0, speed: 3.0 };
        let ground = Foundation::new(Arc::new(Paraboloid { radius: Length::new(1.0).unwrap() }), 1.0);
        let exact = Passage::new(&QuasiStatic::new(EdgeLine::new(ground, 0.3)), impact, 1e-9).unwrap().rebound();
        let ((coarse, _), (fine, astray)) = (held(&[], 0.3, impact, 100.0), held(&[], 0.3, impact, 200.0));
        let off = fine.extrapolated(&coarse).difference(&exact);
        assert!(off < 1e-5 && fine.difference(&exact) < 2e-4 && astray < 5e-5, "{off:e} {astray:e} {fine:?} {exact:?}");
        let slow = Projectile { mass: 1.0, speed: 0.3 };
        assert!(held(&[], 0.3, slow, 100.0).0.sticks());
    }

    /// A mass that sticks is followed to where it turns the second time, as by the energy of the direct path.
    #[test]
    fn a_mass_that_sticks_ends_where_it_turns() {
        let ground = Foundation::new(Arc::new(Paraboloid { radius: Length::new(1.0).unwrap() }), 1.0);
        let mut contact = QuasiStatic::new(EdgeLine::new(ground, 0.3));
        let impact = Projectile { mass: 1.0, speed: 0.3 };
        let exact = Passage::new(&contact, impact, 1e-9).unwrap().moments(4).last().map(|moment| moment.depth).unwrap();
        let mut last = ImpactState::default();
        let mass = SteppedMass { impact, time: 3.0, steps: 300.0 };
        let seen = mass.watched(&mut contact, &mut |state, _| last = state).unwrap();
        let off = last.depth / exact - 1.0;
        assert!(seen.sticks() && last.speed.abs() < 1e-6 && off.abs() < 1e-4, "{off:e} {last:?}");
    }

    /// An edge that obeys a rate: the last state is one of bodies apart.
    #[test]
    fn bodies_that_part_are_apart() {
        let relaxation = Relaxation { equilibrium: 1.0, terms: vec![(1.0, 0.5), (0.5, 5.0)], viscosity: 0.0 };
        let spectrum = Arc::new(Spectrum::new(&relaxation));
        let ball = Arc::new(Paraboloid { radius: Length::new(1.0).unwrap() });
        for rate in [0.03, 0.3, 3.0] {
            let attraction = Attraction::with_rate(0.01, &spectrum, (rate, 0.5)).to_accuracy(1e-3);
            let mut contact = ContinuousContact::new(Memory::new(spectrum.clone(), ball.clone()).with(attraction));
            let mut last = ImpactState::default();
            let mass = SteppedMass { impact: Projectile { mass: 1.0, speed: 3.0 }, time: 3.0, steps: 100.0 };
            let seen = mass.watched(&mut contact, &mut |state, _| last = state).unwrap();
            assert!(!seen.sticks() && last.force.abs() <= 0.0 && last.radius <= 0.0, "{rate}: {last:?}");
            assert!(last.depth.abs() < seen.greatest_depth, "{last:?}");
        }
    }

    /// A body so tough that it stops the mass at once, and that its adhesion then draws into it for as long as it takes:
    /// until it carries nothing, at the depth of JKR, F = 0, in steps by the hundred.
    #[test]
    fn a_mass_that_hardly_gets_in_sinks_at_its_own_pace() {
        let ball = Arc::new(Paraboloid { radius: Length::new(1.0).unwrap() });
        let sunk = |relaxation: &Relaxation, work: f64, (impact, time): (Projectile, f64)| {
            let radius = (0.75 * (8.0 * PI * work).sqrt()).powf(2.0 / 3.0);
            let depth = radius * radius - (2.0 * PI * radius * work).sqrt();
            let spectrum = Arc::new(Spectrum::new(relaxation));
            let attraction = Attraction::relaxed(work, &spectrum).to_accuracy(1e-6);
            let mut contact = ContinuousContact::new(Memory::new(spectrum, ball.clone()).with(attraction));
            let mut states = Vec::new();
            let mass = SteppedMass { impact, time, steps: 50.0 };
            let seen = mass.watched(&mut contact, &mut |state, _| states.push(state)).unwrap();
            let (off, steps) = (seen.greatest_depth / depth - 1.0, states.len());
            assert!(seen.sticks() && off.abs() < 1e-3 && steps < 3000, "{relaxation:?}: {off:e} in {steps}");
            states
        };
        for viscosity in [1e2, 1e4, 1e8] {
            let relaxation = Relaxation { equilibrium: 1.0, terms: vec![], viscosity };
            sunk(&relaxation, 0.3, (Projectile { mass: 1.0, speed: 3.0 }, 3.0 / viscosity));
        }
        // It creeps by 10⁻¹² of the speed at which it struck.
        let terms = vec![(10.0, 0.1), (10.0, 3e2), (10.0, 1e3)];
        let relaxation = Relaxation { equilibrium: 1.0, terms, viscosity: 3e2 };
        let states = sunk(&relaxation, 3e-7, (Projectile { mass: 3e-7, speed: 9.0 }, 1e-7));
        // What is left to slow it down is nothing beside the attraction.
        let late = states.iter().filter(|state| state.time > 1.0).map(|state| state.force.abs());
        let most = late.fold(0.0, f64::max);
        assert!(most > 0.0 && most < 1e-7 * 3e-7, "{most:e}");
    }

    /// Bodies with a dashpot: the largest force is of second order in the steps too, within 1/n² of them; with the speed of
    /// the last step for that of the mass it were of first.
    #[test]
    fn forces_on_a_dashpot_converge_as_the_motion_does() {
        let relaxation = Relaxation { equilibrium: 1.0, terms: vec![], viscosity: 3.0 };
        let spectrum = Arc::new(Spectrum::new(&relaxation));
        let ball = Arc::new(Paraboloid { radius: Length::new(1.0).unwrap() });
        let impact = Projectile { mass: 1.0, speed: 3.0 };
        let largest = |steps: f64| {
            let attraction = Attraction::relaxed(0.01, &spectrum).to_accuracy(1e-6);
            let mut contact = ContinuousContact::new(Memory::new(spectrum.clone(), ball.clone()).with(attraction));
            SteppedMass { impact, time: 1.0, steps }.rebound(&mut contact).unwrap().greatest_force
        };
        let fine = largest(400.0);
        for steps in [50.0, 100.0, 200.0] {
            let off = (largest(steps) / fine - 1.0).abs();
            assert!(off * steps * steps < 1.0, "{steps}: {off:e}");
        }
    }

    /// Bodies that relax: no energy is lost from sight.
    #[test]
    fn the_energy_of_an_adhesive_impact_adds_up() {
        let impact = Projectile { mass: 1.0, speed: 3.0 };
        let terms = [(1.0, 0.5), (0.5, 5.0)];
        let ((coarse, open), (fine, less)) = (held(&terms, 0.3, impact, 100.0), held(&terms, 0.3, impact, 200.0));
        assert!(open < 5e-4 && less < 0.5 * open, "{open:e} {less:e}");
        assert!(coarse.difference(&fine) < 2e-3 && fine.lost > 0.0, "{coarse:?} {fine:?}");
    }

    /// An elastic ball, with and without adhesion, against the energy of the direct path. Of second order: a
    /// fourth of the error in half the steps.
    #[test]
    fn elastic_impacts_converge_to_those_of_energy() {
        let ball = Arc::new(Paraboloid { radius: Length::new(1.0).unwrap() });
        let impact = Projectile { mass: 1.0, speed: 3.0 };
        for work in [0.0, 0.3] {
            let contact = QuasiStatic::new(EdgeLine::new(Foundation::new(ball.clone(), 1.0), work));
            let exact = Passage::new(&contact, impact, 1e-9).unwrap().rebound();
            let off = |steps: f64| {
                let mut contact = contact.clone();
                let seen = SteppedMass { impact, time: 3.0, steps }.rebound(&mut contact).unwrap();
                let time = seen.contact_time.unwrap() / exact.contact_time.unwrap() - 1.0;
                (seen.restitution - exact.restitution).abs().max(time.abs())
            };
            let (coarse, fine) = (off(150.0), off(300.0));
            assert!(coarse < 1e-3 && fine < 0.5 * coarse, "{work}: {coarse:e} {fine:e}");
        }
    }
}
