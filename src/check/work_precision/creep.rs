//! Creep under a constant force.

use super::{Answer, Effort, Method, Setting, Study};
use crate::contact::viscoelastic::Spectrum;
use crate::contact::viscoelastic::continuous::ContinuousContact;
use crate::contact::viscoelastic::creep::Creep;
use crate::contact::viscoelastic::memory::Memory;
use crate::drive::force::{Ramp, press};
use crate::input::quantity::Length;
use crate::material::Relaxation;
use crate::shape::Paraboloid;
use std::sync::Arc;

/// Long-term and decaying part of the modulus [Pa], as large as each other, and the relaxation time [s].
const MATERIAL: (f64, f64, f64) = (1.0, 1.0, 1.0);
const FORCE: f64 = 1e-3;
/// Time in which the force rises [s].
const RISE: f64 = 0.01;
/// Times of the records after the rise [s].
const RECORDS: [f64; 5] = [0.1, 0.5, 1.0, 3.0, 10.0];

/// A ball under a force that rises at once and stays: contact radii.
pub(super) fn ball(effort: Effort) -> Option<Study> {
    let (spectrum, profile) = (spectrum(), Arc::new(shape()?));
    let mut methods = Vec::new();
    {
        let (spectrum, profile) = (spectrum.clone(), profile.clone());
        methods.push(Method::new("compliance integral", Setting::FREE, move || {
            let (spectrum, profile) = (spectrum.clone(), profile.clone());
            Some(move || integral(&spectrum, &profile))
        }));
    }
    let finest = if effort == Effort::Brief { 4 } else { 6 };
    for digits in 1..=finest {
        let (spectrum, profile) = (spectrum.clone(), profile.clone());
        methods.push(Method::new("continuous bed, force met by steps", Setting::FREE, move || {
            let bed = ContinuousContact::new(Memory::new(spectrum.clone(), profile.clone()));
            Some(move || driven(bed.clone(), 10f64.powi(-digits)))
        }));
    }
    Some(Study {
        case: "creep",
        about: "a ball under a constant force on a standard linear solid: contact radii".to_owned(),
        quantity: "contact radius",
        reference: "a³ = (3R/4) ∫ J dF in closed form".to_owned(),
        orders: &[2.0],
        exact: Answer { values: RECORDS.map(exact).to_vec(), ..Answer::default() },
        methods,
    })
}

fn shape() -> Option<Paraboloid> {
    Some(Paraboloid { radius: Length::new(1.0).ok()? })
}

fn spectrum() -> Arc<Spectrum> {
    let (equilibrium, modulus, time) = MATERIAL;
    Arc::new(Spectrum::new(&Relaxation { equilibrium, terms: vec![(modulus, time)], viscosity: 0.0 }))
}

/// a at the time `t` after the rise, J(t) = 1/E∞ − (1/E∞ − 1/E(0)) e^{−t/λ} with λ = τE(0)/E∞.
fn exact(t: f64) -> f64 {
    let (relaxed, decaying, time) = MATERIAL;
    let glassy = relaxed + decaying;
    let retardation = time * glassy / relaxed;
    let delayed = (retardation / RISE) * (-t / retardation).exp() * -(-RISE / retardation).exp_m1();
    (0.75 * FORCE * (1.0 / relaxed - (1.0 / relaxed - 1.0 / glassy) * delayed)).cbrt()
}

fn integral(spectrum: &Arc<Spectrum>, profile: &Arc<Paraboloid>) -> Option<Answer> {
    let risen = Creep::new(spectrum.clone(), profile.clone()).after(FORCE, RISE);
    let radius = |t: &f64| Some(risen.after(FORCE, *t).indentation()?.sqrt());
    let values: Option<Vec<f64>> = RECORDS.iter().map(radius).collect();
    Some(Answer { values: values?, bytes: size_of::<Creep>(), ..Answer::default() })
}

fn driven(mut bed: ContinuousContact, accuracy: f64) -> Option<Answer> {
    press(&mut bed, &Ramp { from: 0.0, rate: FORCE / RISE, accuracy, scale: FORCE }, &[RISE]).ok()?;
    let states = press(&mut bed, &Ramp { from: FORCE, rate: 0.0, accuracy, scale: FORCE }, &RECORDS).ok()?;
    let values = states.iter().filter_map(|state| state.contact_radius).collect();
    Some(Answer { values, bytes: 0, ..Answer::default() })
}
