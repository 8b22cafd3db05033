//! Impacts in straight steps of the depth, halved until they agree.

use crate::contact::error::ContactError;
use crate::contact::model::{ContactModel, Straight};
use crate::contact::state::Normal;
use crate::drive::impact::{ImpactState, Projectile, Rebound, SteppedMass, force_at, led_on};

/// Steps in the time of an impact on the stiffest bodies: those of the first run, the most of a run, and the most where
/// the scene asks for an accuracy.
const STEPS: f64 = 25.0;
const MOST: f64 = 200.0;
const MOST_ASKED: f64 = 800.0;
/// Time of an elastic impact in depths over speeds.
pub(super) const ELASTIC: f64 = 2.94;

/// What is struck, and by what.
pub(super) struct Struck<'c> {
    /// The contact, which just touches.
    pub(super) contact: &'c dyn ContactModel,
    pub(super) impact: Projectile,
    /// Time of the impact on the stiffest bodies, without adhesion [s].
    pub(super) time: f64,
}

/// One run, with the states at the ends of its steps.
pub(super) struct Steps {
    pub(super) rebound: Rebound,
    pub(super) states: Vec<ImpactState>,
    /// The contact as the mass turns, or where it comes to rest before, and when [s].
    pub(super) deepest: Option<(f64, Box<dyn ContactModel>)>,
    pub(super) bytes: usize,
}

impl Struck<'_> {
    /// Runs with half as long steps until their limits agree to the accuracy `aim`, or, unless the scene has `asked` for
    /// it, to what fewer steps give: the error states how far they do. What comes of it is the limit.
    ///
    /// # Errors
    /// The contact cannot follow.
    pub(super) fn settled(&self, aim: f64, asked: bool) -> Result<Steps, ContactError> {
        let most = if asked { MOST_ASKED } else { MOST };
        let mut steps = 2.0 * STEPS;
        let mut coarse = self.run(STEPS)?;
        let mut limit: Option<Rebound> = None;
        loop {
            let fine = self.run(steps)?;
            let now = fine.rebound.extrapolated(&coarse.rebound);
            let error = limit.map_or(f64::INFINITY, |limit| now.difference(&limit)).max(f64::EPSILON);
            if error <= aim || steps >= most {
                return Ok(Steps { rebound: Rebound { error, ..now }, ..fine });
            }
            (coarse, limit, steps) = (fine, Some(now), 2.0 * steps);
        }
    }

    fn run(&self, steps: f64) -> Result<Steps, ContactError> {
        let mut contact = self.contact.copy();
        let (mut states, mut deepest) =
            (vec![ImpactState { speed: self.impact.speed, ..ImpactState::default() }], None);
        let mut watcher = |state: ImpactState, contact: &dyn ContactModel| {
            states.push(state);
            if state.speed <= 0.0 && deepest.is_none() {
                deepest = Some((state.time, contact.copy()));
            }
        };
        let mass = SteppedMass { impact: self.impact, time: self.time, steps };
        let rebound = mass.watched(contact.as_mut(), &mut watcher)?;
        // A mass that creeps in until it rests turns nowhere.
        let deepest = deepest.or_else(|| Some((states.last()?.time, contact.copy())));
        Ok(Steps { rebound, states, deepest, bytes: contact.effort().bytes })
    }

    /// States at `count` + 1 equal times of a run, which is followed once more, and just after the bodies have parted.
    ///
    /// # Errors
    /// The contact cannot follow.
    pub(super) fn again(&self, run: &Steps, count: usize) -> Result<Vec<(f64, Normal)>, ContactError> {
        let mut contact = self.contact.copy();
        let held = run.states.len() - usize::from(!run.rebound.sticks());
        let end = run.states[held - 1].time;
        let time = |k: usize| if k < count { end * k as f64 / count as f64 } else { end };
        let mut moments = vec![(0.0, contact.state())];
        let means: Vec<(f64, f64)> = run.states[..held].windows(2).map(mean).collect();
        for (step, pair) in run.states[..held].windows(2).enumerate() {
            let mut from = pair[0];
            while moments.len() <= count && time(moments.len()) <= pair[1].time {
                let now = between(pair, time(moments.len()));
                contact.follow(&straight(&from, &now))?;
                let speed = speed_at(&means, step, now.time, pair[1].speed);
                let force = force_at(contact.as_mut(), speed, pair[1].time - pair[0].time)?;
                moments.push((now.time, Normal { force, ..contact.state() }));
                from = now;
            }
            if from.time < pair[1].time {
                contact.follow(&straight(&from, &pair[1]))?;
            }
        }
        for pair in run.states[held - 1..].windows(2) {
            contact.follow(&straight(&pair[0], &pair[1]))?;
            if contact.joined() {
                contact.leave();
            }
            moments.push((pair[1].time, Normal { indentation: Some(pair[1].depth), ..contact.state() }));
        }
        Ok(moments)
    }
}

/// Where the mass is at the time `time` [s] between the ends of a step.
fn between(step: &[ImpactState], time: f64) -> ImpactState {
    let part = (time - step[0].time) / (step[1].time - step[0].time);
    let depth = if part < 1.0 { step[0].depth + part * (step[1].depth - step[0].depth) } else { step[1].depth };
    ImpactState { time, depth, ..step[1] }
}

/// The middle [s] and the mean speed [m/s] of a step.
fn mean(step: &[ImpactState]) -> (f64, f64) {
    let (from, to) = (&step[0], &step[1]);
    (0.5 * (from.time + to.time), (to.depth - from.depth) / (to.time - from.time))
}

/// Speed [m/s] at the time `time` [s] of the step `step`, by its mean speed and that of the nearer of its neighbours; that at
/// its end, `last`, where a step takes no time.
fn speed_at(means: &[(f64, f64)], step: usize, time: f64, last: f64) -> f64 {
    let here = means[step];
    let before = step.checked_sub(1).and_then(|other| means.get(other));
    let after = means.get(step + 1);
    let other = if time < here.0 { before.or(after) } else { after.or(before) };
    let led = other.map_or(here.1, |&other| led_on([other, here], time));
    if led.is_finite() { led } else { last }
}

fn straight(from: &ImpactState, to: &ImpactState) -> Straight {
    Straight::between(from.depth, to.depth, to.time - from.time)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::rough::{RelaxingRough, RoughContact};
    use crate::drive::impact::SpringPassage;
    use crate::material::{Relaxation, Spectrum};
    use crate::shape::rough::{Rings, RoughLine, RoughnessSpectrum};
    use std::sync::Arc;

    /// A motion slowed down evenly has the speed of its means all the way, whatever the steps; a step that takes no time, and
    /// one led on beside it alone, has that at its end.
    #[test]
    fn the_speed_is_led_on_from_the_means() {
        let path = |time: f64| 3.0 * time - time * time;
        let means = |times: &[f64]| -> Vec<(f64, f64)> {
            let mean =
                |pair: &[f64]| (0.5 * (pair[0] + pair[1]), (path(pair[1]) - path(pair[0])) / (pair[1] - pair[0]));
            times.windows(2).map(mean).collect()
        };
        let times = [0.0, 0.1, 0.15, 0.5, 0.9];
        let slowed = means(&times);
        for (step, pair) in times.windows(2).enumerate() {
            for time in [pair[0], 0.7 * pair[0] + 0.3 * pair[1], pair[1]] {
                let speed = speed_at(&slowed, step, time, f64::NAN);
                assert!((speed - (3.0 - 2.0 * time)).abs() < 1e-13, "{step} {time}: {speed}");
            }
        }
        let stopped = means(&[0.0, 0.1, 0.1]);
        assert!([0, 1].iter().all(|&step| (speed_at(&stopped, step, 0.1, 2.8) - 2.8).abs() <= 0.0));
        assert!((speed_at(&means(&[0.0, 0.1]), 0, 0.02, 2.8) - 2.9).abs() < 1e-14);
    }

    const IMPACT: Projectile = Projectile { mass: 1.0, speed: 3e-3 };

    fn line() -> RoughLine {
        let spectrum = RoughnessSpectrum::table(&[(6.4, 1e-6), (64.0, 1e-9)]).unwrap();
        RoughLine::new(&Rings::of(&spectrum, 1.0, 1000).unwrap(), 7)
    }

    fn rubber(weight: f64) -> RelaxingRough {
        let terms = vec![(2.0 * weight, 1.0), (weight, 10.0)];
        let relaxation = Relaxation { equilibrium: 3.0, terms, viscosity: 0.0 };
        RelaxingRough::new(&line(), 1000, Arc::new(Spectrum::new(&relaxation)), None).unwrap()
    }

    fn struck(contact: &RelaxingRough) -> Struck<'_> {
        let time = ELASTIC * contact.stopped_at(IMPACT.energy(), IMPACT.speed).unwrap() / IMPACT.speed;
        Struck { contact, impact: IMPACT, time }
    }

    /// Prony terms without weight leave the exact impact of the elastic springs, to the error that is stated.
    #[test]
    fn on_springs_that_hardly_relax_it_is_the_elastic_impact() {
        let contact = rubber(1e-12);
        let run = struck(&contact).settled(1e-6, true).unwrap();
        let elastic = RoughContact::new(&line(), 1000, 3.0, None).unwrap();
        let exact = SpringPassage::elastic(elastic.bed(), IMPACT).rebound();
        let off = run.rebound.difference(&exact);
        assert!(
            run.rebound.error < 1e-5 && off < 4.0 * run.rebound.error + 1e-9,
            "{off:e} {:?} {exact:?}",
            run.rebound
        );
    }

    /// Rubber keeps some of the energy; kinetic energy, stored energy and heat are that of the beginning at every step,
    /// to the error of Simpson's rule where springs are touched.
    #[test]
    fn the_energy_of_an_impact_on_rough_rubber_adds_up() {
        let contact = rubber(1.0);
        let struck = struck(&contact);
        let run = struck.settled(1e-5, true).unwrap();
        assert!(run.rebound.restitution < 0.95 && run.rebound.restitution > 0.2, "{:?}", run.rebound);
        let astray = run.states.iter().map(|state| {
            let kinetic = 0.5 * IMPACT.mass * state.speed * state.speed;
            ((kinetic + state.stored.stored() + state.dissipated) / IMPACT.energy() - 1.0).abs()
        });
        let astray = astray.fold(0.0, f64::max);
        assert!(astray < 1e-5, "{astray:e}");
        // The way gone once more, cut at other times, ends as it did.
        let moments = struck.again(&run, 37).unwrap();
        let (last, held) = (run.states[run.states.len() - 1], run.states[run.states.len() - 2]);
        assert_eq!(moments.len(), 39);
        let ((_, before), (_, apart)) = (moments[37], moments[38]);
        let near = |one: f64, two: f64| (one - two).abs() < 1e-9 * IMPACT.energy();
        assert!(near(before.stored.stored(), held.stored.stored()) && near(before.dissipated, held.dissipated));
        assert!(near(apart.dissipated, last.dissipated) && apart.force.abs() <= 0.0, "{apart:?} {last:?}");
    }
}
