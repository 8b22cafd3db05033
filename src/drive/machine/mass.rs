//! A mass on an elastic contact, along the normal.

use super::{Held, MachineError, MovedMass, Suspension};
use crate::contact::error::ContactError;
use crate::contact::model::{ContactModel, Straight};
use crate::numerics::extrapolation::{Motion, Stepper};

/// Where the mass is.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct MassState {
    /// Time since the beginning [s].
    pub time: f64,
    /// Depth d [m], below zero in flight.
    pub depth: f64,
    /// Speed ḋ [m/s], towards the ground.
    pub speed: f64,
    /// Energy lost in the damper so far, ∫cḋ²dt [J].
    pub damped: f64,
}

/// What happens to the mass.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Happening {
    /// It touches the ground.
    Touches,
    /// It leaves it.
    Parts,
    /// Its speed passes zero.
    Turns,
}

/// What happens, and the state then.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MassMoment {
    /// What.
    pub what: Happening,
    /// Where and when.
    pub state: MassState,
}

/// A mass on a contact whose force follows from the present depth alone, as that of elastic bodies without adhesion does.
///
/// m d̈ = W − k(d − D) − cḋ − F(d), in extrapolated steps (see [`extrapolation`](crate::numerics::extrapolation)); where
/// the bodies touch and part and where the mass turns a step ends, to rounding. In flight under gravity the motion is one step.
/// Check: a ball with R = E* = m = v = 1, no weight, leaves after 2.943275 (15/16)^{2/5}.
pub struct Mass<'c> {
    forces: Forces<'c>,
    state: MassState,
    touching: bool,
    stepper: Stepper,
    /// First step of the last contact [s].
    first: f64,
    turns: usize,
}

/// The forces on a mass, as a motion of depth, speed and loss.
struct Forces<'c> {
    contact: &'c mut dyn ContactModel,
    suspension: Suspension,
    held: Held,
    touching: bool,
    failed: Option<ContactError>,
}

/// Relative error of a step.
const TOLERANCE: f64 = 1e-13;
/// Rounding of a force, relative to the push and the force of the contact that balance in it.
const ROUNDING: f64 = 4.0 * f64::EPSILON;
/// Most turns of a mass.
pub const MOST_TURNS: usize = 200_000;
/// Fd of mv² at which a mass that has touched counts as slowed down: of a ball it has gone two to four fifths of its way to where
/// it turns; and the least of the way of the longest step at which that is looked for.
const SLOWED: f64 = 0.125;
const SHORTEST: f64 = f64::EPSILON;
/// Growth of the first step of a contact over that of the one before.
const BOLDER: f64 = 4.0;

impl Forces<'_> {
    /// The force [N] of the contact.
    fn contact(&mut self, depth: f64) -> f64 {
        if !self.touching {
            return 0.0;
        }
        match self.contact.look(&Straight::between(depth, depth, 0.0)) {
            Ok(seen) => seen.force,
            Err(error) => {
                self.failed = Some(error);
                f64::NAN
            }
        }
    }
}

impl Motion<3> for Forces<'_> {
    fn rate(&mut self, _: f64, &[depth, speed, _]: &[f64; 3]) -> [f64; 3] {
        let Suspension { mass, damping, .. } = self.suspension;
        let drag = damping * speed;
        let force = self.suspension.push(self.held, depth) - drag - self.contact(depth);
        [speed, force / mass, drag * speed]
    }

    fn rounding(&self) -> [f64; 3] {
        [0.0, ROUNDING * self.held.push.abs() / self.suspension.mass, 0.0]
    }
}

impl<'c> Mass<'c> {
    /// A mass on `contact`, let go at the depth [m] and speed [m/s] of `start`.
    pub fn new(
        contact: &'c mut dyn ContactModel,
        suspension: Suspension,
        held: Held,
        (depth, speed): (f64, f64),
    ) -> Self {
        let touching = depth > 0.0;
        let forces = Forces { contact, suspension, held, touching, failed: None };
        let state = MassState { depth, speed, ..MassState::default() };
        let mut stepper = Stepper::new(TOLERANCE);
        if touching {
            let stiffness = suspension.stiffness + forces.contact.state().stiffness;
            stepper.restart((suspension.mass / stiffness).sqrt());
        }
        Self { forces, state, touching, stepper, first: f64::INFINITY, turns: 0 }
    }

    /// On to the time `until` [s]; what happens on the way.
    ///
    /// # Errors
    /// The contact cannot follow, or the motion is too fast.
    pub fn advance(&mut self, until: f64) -> Result<Vec<MassMoment>, MachineError> {
        let mut moments = Vec::new();
        while self.state.time < until {
            moments.extend(self.step(until)?);
        }
        Ok(moments)
    }

    /// Time since the beginning of a step, and the state, at which the number `at` of the state is zero.
    fn land(
        &mut self,
        (from, to, step): (&[f64; 3], &[f64; 3], f64),
        at: usize,
    ) -> Result<Option<(f64, [f64; 3])>, MachineError> {
        let landed = self.stepper.landing(&mut self.forces, (from, to), (step, at, 0.0));
        landed.map(Some).ok_or_else(|| self.failure())
    }

    /// A step \[s\] over which a mass that has touched is slowed down, of at most `longest` \[s\]: what lies far beyond where it
    /// turns may be dear to know, and a step too long would look there.
    fn slowed(&mut self, longest: f64) -> f64 {
        let (speed, way) = (self.state.speed, self.state.speed * longest);
        let energy = self.forces.suspension.mass * speed * speed;
        let mut depth = SHORTEST * way;
        while depth < way && self.forces.contact(depth) * depth < SLOWED * energy {
            depth *= 2.0;
        }
        if depth < way { depth / speed } else { longest }
    }

    fn happen(&mut self, ((after, to), what): ((f64, [f64; 3]), Happening)) -> Result<MassMoment, MachineError> {
        let time = self.state.time + after;
        self.state = MassState { time, depth: to[0], speed: to[1], damped: to[2] };
        match what {
            Happening::Turns => {
                self.state.speed = 0.0;
                self.turns += 1;
            }
            Happening::Touches => {
                (self.state.depth, self.touching) = (0.0, true);
                self.stepper.restart(BOLDER * self.first);
                self.first = f64::INFINITY;
            }
            Happening::Parts => {
                (self.state.depth, self.touching) = (0.0, false);
                self.stepper.restart(f64::INFINITY);
            }
        }
        if self.turns > MOST_TURNS {
            return Err(MachineError::TooManyTurns { most: MOST_TURNS, time });
        }
        Ok(MassMoment { what, state: self.state })
    }

    fn failure(&self) -> MachineError {
        let stalled = MachineError::Stalled { time: self.state.time };
        self.forces.failed.map_or(stalled, MachineError::Contact)
    }
}

impl MovedMass for Mass<'_> {
    fn state(&self) -> MassState {
        self.state
    }

    fn contact(&mut self) -> Result<&dyn ContactModel, ContactError> {
        let depth = self.forces.contact.state().indentation.unwrap_or(0.0);
        self.forces.contact.follow(&Straight::between(depth, self.state.depth, 0.0))?;
        Ok(&*self.forces.contact)
    }

    fn step(&mut self, until: f64) -> Result<Option<MassMoment>, MachineError> {
        let MassState { time, depth, speed, damped } = self.state;
        self.forces.touching = self.touching;
        let (from, longest) = ([depth, speed, damped], until - time);
        if self.touching && self.stepper.next().is_infinite() && speed > 0.0 {
            let step = self.slowed(longest);
            self.stepper.restart(step);
        }
        let stepped = self.stepper.step(&mut self.forces, &from, longest);
        let (step, to) = stepped.ok_or_else(|| self.failure())?;
        if self.first.is_infinite() && self.touching {
            self.first = step;
        }
        let side = if self.touching { -1.0 } else { 1.0 };
        let leaves = |depth: f64| side * depth > 0.0;
        let (ends, turns) = (leaves(to[0]), speed * to[1] < 0.0);
        let turn = if turns { self.land((&from, &to, step), 1)? } else { None };
        // A mass may leave only to turn, and be back at the end of the step.
        let edge = match turn {
            Some((after, there)) if leaves(there[0]) => self.land((&from, &there, after), 0)?,
            Some(_) | None if ends => self.land((&from, &to, step), 0)?,
            Some(_) | None => None,
        };
        let first = match (edge, turn) {
            (Some(edge), Some(turn)) if turn.0 < edge.0 => (turn, Happening::Turns),
            (Some(edge), _) => (edge, if self.touching { Happening::Parts } else { Happening::Touches }),
            (None, Some(turn)) => (turn, Happening::Turns),
            (None, None) => {
                let end = if step < longest { time + step } else { until };
                self.state = MassState { time: end, depth: to[0], speed: to[1], damped: to[2] };
                return Ok(None);
            }
        };
        self.happen(first).map(Some)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::adhesion::line::EdgeLine;
    use crate::contact::direct::QuasiStatic;
    use crate::contact::foundation::Foundation;
    use crate::drive::impact::{Passage, Projectile};
    use crate::input::quantity::Length;
    use crate::shape::Paraboloid;
    use std::sync::Arc;

    const ALONE: Suspension = Suspension { mass: 1.0, stiffness: 0.0, damping: 0.0 };

    fn ball() -> QuasiStatic {
        let ground = Foundation::new(Arc::new(Paraboloid { radius: Length::new(1.0).unwrap() }), 1.0);
        QuasiStatic::new(EdgeLine::new(ground, 0.0))
    }

    /// Without weight a ball that comes in leaves as the energy of the direct path says, with its speed turned round.
    #[test]
    fn without_weight_it_is_the_impact() {
        let exact = Passage::new(&ball(), Projectile { mass: 1.0, speed: 0.01 }, 1e-12).unwrap().rebound();
        let mut contact = ball();
        let mut mass = Mass::new(&mut contact, ALONE, Held { depth: 0.0, push: 0.0 }, (-0.01, 0.01));
        let moments = mass.advance(2.0 + exact.contact_time.unwrap()).unwrap();
        assert_eq!(
            moments.iter().map(|moment| moment.what).collect::<Vec<_>>(),
            [Happening::Touches, Happening::Turns, Happening::Parts]
        );
        let contact_time = moments[2].state.time - moments[0].state.time;
        assert!((contact_time / exact.contact_time.unwrap() - 1.0).abs() < 1e-11, "{contact_time:e} {exact:?}");
        assert!((moments[1].state.depth / exact.greatest_depth - 1.0).abs() < 1e-11);
        assert!((moments[2].state.speed + 0.01).abs() < 1e-13, "{:?}", moments[2]);
    }

    /// A mass at rest stays there.
    #[test]
    fn what_balances_stays() {
        let mut contact = ball();
        contact.follow(&Straight::between(0.0, 0.3, 1.0)).unwrap();
        let held = Held { depth: 0.3, push: contact.state().force };
        let mut mass = Mass::new(&mut contact, Suspension { stiffness: 2.0, ..ALONE }, held, (0.3, 0.0));
        mass.advance(1e3).unwrap();
        assert!((mass.state().depth - 0.3).abs() < 1e-12 && mass.state().speed.abs() < 1e-12, "{:?}", mass.state());
    }
}
