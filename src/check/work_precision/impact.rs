//! A Hertz impact: contact time.

use super::{Answer, Effort, Method, Setting, Study};
use crate::check::usual;
use crate::contact::adhesion::line::EdgeLine;
use crate::contact::direct::QuasiStatic;
use crate::contact::foundation::HalfSpace;
use crate::contact::viscoelastic::Spectrum;
use crate::drive::impact::{Passage, Projectile, StruckHalfSpace};
use crate::input::quantity::Length;
use crate::material::Relaxation;
use crate::shape::Paraboloid;
use std::sync::Arc;

/// Mass and speed one; R = E* = 1.
const IMPACT: Projectile = Projectile { mass: 1.0, speed: 1.0 };

/// Contact time of a ball, 2.943275184324705 x₀/v.
pub(super) fn hertz(effort: Effort) -> Option<Study> {
    let depth = (15.0f64 / 16.0).powf(0.4);
    let mut methods = vec![Method::new("energy integral", Setting::FREE, || {
        let ball = ball()?;
        Some(move || {
            let contact = QuasiStatic::new(EdgeLine::new(HalfSpace::new(Arc::new(ball.clone()), 1.0), 0.0));
            let rebound = Passage::new(&contact, IMPACT, 1e-6).ok()?.rebound();
            Some(Answer { values: vec![rebound.contact_time?], ..Answer::default() })
        })
    })];
    let finest = if effort == Effort::Brief { 4 } else { 6 };
    methods.extend((0..finest).map(|k| driven(10f64.powi(-2 * k - 1))));
    methods.extend(effort.decades(1, 6).map(move |steps| verlet(steps, depth)));
    Some(Study {
        case: "impact",
        about: "a ball that hits an elastic half-space: contact time".to_owned(),
        quantity: "contact time",
        reference: "2.943275184324705 x₀/v (Johnson 1985, eq. 11.23)".to_owned(),
        orders: &[1.0, 2.0],
        exact: Answer { values: vec![2.943_275_184_324_705 * depth], ..Answer::default() },
        methods,
    })
}

fn ball() -> Option<Paraboloid> {
    Some(Paraboloid { radius: Length::new(1.0).ok()? })
}

/// The bed driven by the mass, aiming at `accuracy`; its steps are those it took.
fn driven(accuracy: f64) -> Method {
    let model = || {
        let elastic = Relaxation { equilibrium: 1.0, terms: Vec::new(), viscosity: 0.0 };
        Some(StruckHalfSpace {
            spectrum: Arc::new(Spectrum::new(&elastic)),
            profile: Arc::new(ball()?),
            attraction: None,
        })
    };
    let steps = model().and_then(|model| model.flight(&IMPACT, accuracy).ok()).map_or(0, |flight| flight.steps());
    Method::new("bed driven by the mass", Setting::steps(steps), move || {
        let model = model()?;
        Some(move || {
            let flight = model.flight(&IMPACT, accuracy).ok()?;
            Some(Answer { values: vec![flight.rebound().contact_time?], bytes: flight.bytes(), ..Answer::default() })
        })
    })
}

/// The way of particle codes, `steps` per contact.
fn verlet(steps: usize, depth: f64) -> Method {
    #[expect(clippy::cast_precision_loss, reason = "steps are far below 2^53")]
    let step = 2.943 * depth / steps as f64;
    Method::new("velocity Verlet on Hertz's law", Setting::steps(steps), move || {
        Some(move || {
            let time = usual::verlet_contact_time(4.0 / 3.0, IMPACT.mass, IMPACT.speed, std::hint::black_box(step));
            Some(Answer { values: vec![time], bytes: 3 * size_of::<f64>(), ..Answer::default() })
        })
    })
}
