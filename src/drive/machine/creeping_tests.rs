//! A mass that falls on a body so damped that it does not come up again, and creeps.

use super::*;
use crate::contact::viscoelastic::continuous::ContinuousContact;
use crate::contact::viscoelastic::memory::Memory;
use crate::input::quantity::Length;
use crate::material::{Relaxation, Spectrum};
use crate::shape::Paraboloid;
use std::sync::Arc;

const PUSH: f64 = 1e-2;
const ACCURACY: f64 = 1e-5;

/// A ball, R = m = 1, that falls with the push [`PUSH`] from the height `height` on a Kelvin–Voigt body, E* = 1 and the retardation time `tau`.
fn fallen<R>((tau, height): (f64, f64), tell: impl FnOnce(SteppedMachine<'_>) -> R) -> R {
    let body = Arc::new(Spectrum::new(&Relaxation { equilibrium: 1.0, terms: Vec::new(), viscosity: tau }));
    let ball = Arc::new(Paraboloid { radius: Length::new(1.0).unwrap() });
    let mut contact = ContinuousContact::new(Memory::new(body, ball));
    let suspension = Suspension { mass: 1.0, stiffness: 0.0, damping: 0.0 };
    let held = Held { depth: 0.0, push: PUSH };
    // Where the impulse of the dashpot, ∫2aτ dd, has taken the speed: (4/3)τd^{3/2} = v.
    let speed = (2.0 * PUSH * height).sqrt();
    let stop = (0.75 * speed / tau).powf(2.0 / 3.0) / speed;
    tell(SteppedMachine::new(&mut contact, suspension, held, (-height, stop / 25.0)))
}

/// Once it creeps, what the weight presses on is a contact that grows, u + τu′ = F/K with u = d^{3/2} and K = 4/3, and what the
/// body gives back of a heavier blow one that shrinks, d + τd′ = (F/K)^{2/3}. To the
/// accuracy asked for; what is left out of its inertia as it begins to is little, and told.
#[test]
fn an_overdamped_ball_creeps_to_hertz() {
    for (tau, height) in [(1e3, 0.5), (1e3, 5e4), (1e6, 0.5)] {
        let (off, left_out) = fallen((tau, height), |mass| {
            let mut mass = mass.until_it_creeps(ACCURACY, 20.0 * tau);
            while mass.creeping().is_none() {
                mass.step(10.0 * tau).unwrap();
            }
            let from = mass.state();
            let rest = (0.75 * PUSH).powf(2.0 / 3.0);
            let mut off = 0.0f64;
            for k in 1..=4 {
                let until = from.time + tau * f64::from(k);
                while mass.state().time < until {
                    assert_eq!(mass.step(until).unwrap(), None);
                }
                let power = if from.depth < rest { 1.5 } else { 1.0 };
                let (end, before) = (rest.powf(power), from.depth.powf(power));
                let exact = (end + (before - end) * f64::from(-k).exp()).powf(power.recip());
                off = off.max((mass.state().depth - exact).abs() / from.depth.max(rest));
            }
            (off, mass.creeping().unwrap().inertia)
        });
        assert!(left_out <= 1e-3 && off < ACCURACY, "{tau:e} {height:e}: {off:e} {left_out:e}");
    }
}

/// Where the body damps so little that inertia counts for a while yet, the depth is that of the mass whose inertia is never left
/// out, to what is told of it.
#[test]
fn no_more_inertia_is_left_out_than_told() {
    let (tau, height) = (30.0, 0.5);
    let until = 3.0 * tau;
    let depth = |mass: &mut SteppedMachine<'_>| {
        while mass.state().time < until {
            mass.step(until).unwrap();
        }
        mass.state().depth
    };
    let whole = fallen((tau, height), |mut mass| depth(&mut mass));
    let (left, told) = fallen((tau, height), |mass| {
        let mut mass = mass.until_it_creeps(ACCURACY, until);
        (depth(&mut mass), mass.creeping().unwrap().inertia)
    });
    assert!((left / whole - 1.0).abs() < told + ACCURACY, "{left:e} {whole:e} {told:e}");
}
