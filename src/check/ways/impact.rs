//! A Hertz impact: contact time.

use super::script::verlet_contact_time;
use crate::check::case::Attempt;
use crate::check::contacts::{paraboloid, plain};
use crate::check::row::{Computed, Setting};
use crate::check::study::{Method, Study, Thoroughness};
use crate::drive::impact::{Passage, Projectile, SteppedMass, StruckHalfSpace};
use crate::material::{Relaxation, Spectrum};
use std::hint::black_box;
use std::sync::Arc;

/// Mass and speed one; R = E* = 1.
const IMPACT: Projectile = Projectile { mass: 1.0, speed: 1.0 };

/// Contact time of a ball, 2.943275184324705 x₀/v.
pub fn hertz(effort: Thoroughness) -> Attempt<Study> {
    let depth = (15.0f64 / 16.0).powf(0.4);
    let mut methods = vec![Method::new("energy integral", Setting::FREE, || {
        let ball = paraboloid(1.0)?;
        Ok(move || solved(Passage::new(&plain(ball.clone(), 1.0), IMPACT, 1e-6)?.rebound().contact_time, 0))
    })];
    let finest = if effort == Thoroughness::Brief { 4 } else { 6 };
    for k in 0..finest {
        methods.push(driven(10f64.powi(-2 * k - 1))?);
    }
    methods.extend(effort.decades(1, 4).map(move |steps| stepped(steps, depth)));
    methods.extend(effort.decades(1, 6).map(move |steps| verlet(steps, depth)));
    Ok(Study {
        case: "impact",
        about: "a ball that hits an elastic half-space: contact time".to_owned(),
        quantity: "contact time",
        reference: "2.943275184324705 x₀/v (Johnson 1985, eq. 11.23)".to_owned(),
        exact: Computed { values: vec![2.943_275_184_324_705 * depth], ..Computed::default() },
        methods,
    })
}

fn solved(contact_time: Option<f64>, bytes: usize) -> Attempt<Computed> {
    Ok(Computed { values: vec![contact_time.ok_or("the bodies do not part")?], bytes, ..Computed::default() })
}

/// The bed driven by the mass, aiming at `accuracy`; its steps are those it took.
fn driven(accuracy: f64) -> Attempt<Method> {
    let model = || -> Attempt<StruckHalfSpace> {
        let elastic = Relaxation { equilibrium: 1.0, terms: Vec::new(), viscosity: 0.0 };
        let (spectrum, profile) = (Arc::new(Spectrum::new(&elastic)), paraboloid(1.0)?);
        Ok(StruckHalfSpace { spectrum, profile })
    };
    let steps = model()?.flight(&IMPACT, accuracy)?.steps();
    Ok(Method::new("bed driven by the mass", Setting::steps(steps), move || {
        let model = model()?;
        Ok(move || {
            let flight = model.flight(&IMPACT, accuracy)?;
            solved(flight.rebound().contact_time, flight.bytes())
        })
    }))
}

/// Contact time in greatest depths over the speed, about.
const CONTACT: f64 = 2.943;

/// The drive of any contact by a mass, here of the direct path, `steps` per contact.
#[expect(clippy::cast_precision_loss, reason = "steps are far below 2^53")]
fn stepped(steps: usize, depth: f64) -> Method {
    let mass = SteppedMass { impact: IMPACT, time: CONTACT * depth, steps: steps as f64 };
    Method::new("mass in steps on any contact", Setting::steps(steps), move || {
        let ball = paraboloid(1.0)?;
        Ok(move || solved(black_box(mass).rebound(&mut plain(ball.clone(), 1.0))?.contact_time, size_of_val(&mass)))
    })
}

/// The way of particle codes, `steps` per contact.
#[expect(clippy::cast_precision_loss, reason = "steps are far below 2^53")]
fn verlet(steps: usize, depth: f64) -> Method {
    let step = CONTACT * depth / steps as f64;
    Method::new("velocity Verlet on Hertz's law", Setting::steps(steps), move || {
        Ok(move || {
            let time = verlet_contact_time(4.0 / 3.0, IMPACT.mass, IMPACT.speed, black_box(step));
            solved(Some(time), 3 * size_of::<f64>())
        })
    })
}
