//! Viscoelastic contacts: Ting's triangle and creep.

use super::script::Steps;
use crate::check::case::Attempt;
use crate::check::contacts::paraboloid;
use crate::check::measured::{Creeping, DEPTH, triangle};
use crate::check::row::{Computed, Setting};
use crate::check::study::{Method, Study, Thoroughness};
use crate::contact::creep::Creep;
use crate::contact::viscoelastic::continuous::ContinuousContact;
use crate::contact::viscoelastic::direct::Direct;
use crate::contact::viscoelastic::layout::Layout;
use crate::contact::viscoelastic::lazy::Lazy;
use crate::contact::viscoelastic::memory::Memory;
use crate::drive::force::{Ramp, press};
use crate::material::Spectrum;
use crate::shape::Paraboloid;
use std::sync::Arc;

/// Radius of half the bed: a little beyond the largest contact, 0.1.
const REACH: f64 = 0.11;
/// Springs of the explicit Euler bed.
const EULER_SPRINGS: usize = 1000;
/// Forces on the way in and as many on the way out.
const RECORDS: usize = 10;
/// Time between two records [s].
const PAUSE: f64 = 0.1;

/// A ball with R = 1 driven by 0.01 and back, E* = 0.4 + 3.6e^{−t/0.2}: forces in and out.
pub fn ting(effort: Thoroughness) -> Attempt<Study> {
    let exact = triangle();
    let times = (1..=2 * RECORDS).map(|k| as_f64(k) * PAUSE);
    let values = times.map(|t| Ok(exact.at(t)?.0)).collect::<Attempt<_>>()?;
    let mut methods = vec![Method::new("continuous bed", Setting::FREE, || {
        let (spectrum, ball) = (spectrum(), paraboloid(1.0)?);
        Ok(move || continuous(&spectrum, &ball))
    })];
    methods.extend(effort.decades(2, 6).map(|count| {
        Method::new("lazy bed", Setting::springs(count), move || {
            let bed = Lazy::new(spectrum(), Layout::uniform(paraboloid(1.0)?.as_ref(), REACH, count));
            Ok(move || Ok(lazy(bed.clone())))
        })
    }));
    methods.extend(effort.decades(2, 5).map(|count| {
        Method::new("direct bed", Setting::springs(count), move || {
            let bed = Direct::new(spectrum(), Layout::uniform(paraboloid(1.0)?.as_ref(), REACH, count));
            Ok(move || Ok(direct(bed.clone())))
        })
    }));
    methods.extend(effort.decades(2, 6).map(euler));
    Ok(Study {
        case: "ting",
        about: "a ball driven into a standard linear solid and back: forces in and out".to_owned(),
        quantity: "force",
        reference: "Ting's integral".to_owned(),
        exact: Computed { values, ..Computed::default() },
        methods,
    })
}

fn spectrum() -> Arc<Spectrum> {
    Arc::new(Spectrum::new(&triangle().relaxation))
}

fn continuous(spectrum: &Arc<Spectrum>, ball: &Arc<Paraboloid>) -> Attempt<Computed> {
    let mut bed = Memory::new(spectrum.clone(), ball.clone());
    let mut values = Vec::new();
    for speed in [DEPTH, -DEPTH] {
        for k in 1..=RECORDS {
            values.push(bed.force_after(speed, as_f64(k) * PAUSE)?.0);
        }
        bed.advance(speed, 1.0)?;
    }
    Ok(Computed { values, bytes: size_of::<Memory>(), ..Computed::default() })
}

/// Speeds of all records.
fn speeds() -> impl Iterator<Item = f64> {
    (0..2 * RECORDS).map(|k| if k < RECORDS { DEPTH } else { -DEPTH })
}

fn lazy(mut bed: Lazy) -> Computed {
    let values = speeds().map(|speed| {
        bed.advance(speed, PAUSE);
        bed.force()
    });
    Computed { values: values.collect(), bytes: bed.bytes(), ..Computed::default() }
}

fn direct(mut bed: Direct) -> Computed {
    let values = speeds().map(|speed| {
        bed.advance(speed, PAUSE);
        bed.force()
    });
    Computed { values: values.collect(), bytes: bed.bytes(), ..Computed::default() }
}

/// The usual way: every spring in every step.
fn euler(count: usize) -> Method {
    let setting = Setting { springs: Some(EULER_SPRINGS), ..Setting::steps(count) };
    Method::new("explicit Euler", setting, move || {
        let layout = Layout::uniform(paraboloid(1.0)?.as_ref(), REACH, EULER_SPRINGS);
        let width = 0.5 * layout.weight.first().ok_or("no springs")?;
        let time = move |k: usize| 2.0 * as_f64(k) / as_f64(count);
        let depths = (1..=count).map(|k| DEPTH * (1.0 - (1.0 - time(k)).abs())).collect();
        let (steps, relaxation) = (Steps { depths, step: time(1) }, triangle().relaxation);
        Ok(move || {
            let forces = steps.explicit_euler(&relaxation, &layout.height, width);
            let every = count / (2 * RECORDS);
            let values = forces.iter().skip(every - 1).step_by(every).copied().collect();
            Ok(Computed { values, bytes: 3 * size_of::<f64>() * EULER_SPRINGS, ..Computed::default() })
        })
    })
}

const CREEPING: Creeping = Creeping { force: 1e-3, rise: 0.01 };
/// Times of the records after the rise [s].
const LATER: [f64; 5] = [0.1, 0.5, 1.0, 3.0, 10.0];

/// A ball under a force that rises at once and stays: contact radii.
pub fn creep(effort: Thoroughness) -> Attempt<Study> {
    let spectrum = || Arc::new(Spectrum::new(&Creeping::relaxation()));
    let mut methods = vec![Method::new("compliance integral", Setting::FREE, move || {
        let (spectrum, ball) = (spectrum(), paraboloid(1.0)?);
        Ok(move || integral(&spectrum, &ball))
    })];
    let finest = if effort == Thoroughness::Brief { 4 } else { 6 };
    methods.extend((1..=finest).map(|digits| {
        Method::new("continuous bed, force met by steps", Setting::FREE, move || {
            let bed = ContinuousContact::new(Memory::new(spectrum(), paraboloid(1.0)?));
            Ok(move || driven(bed.clone(), 10f64.powi(-digits)))
        })
    }));
    Ok(Study {
        case: "creep",
        about: "a ball under a constant force on a standard linear solid: contact radii".to_owned(),
        quantity: "contact radius",
        reference: "a³ = (3R/4) ∫ J dF in closed form".to_owned(),
        exact: Computed { values: LATER.map(|t| CREEPING.radius(t)).to_vec(), ..Computed::default() },
        methods,
    })
}

fn integral(spectrum: &Arc<Spectrum>, ball: &Arc<Paraboloid>) -> Attempt<Computed> {
    let risen = Creep::new(spectrum.clone(), ball.clone()).after(CREEPING.force, CREEPING.rise);
    let depth = |t: &f64| risen.after(CREEPING.force, *t).indentation().ok_or("the force leaves the profile");
    let radii: Result<_, _> = LATER.iter().map(|t| depth(t).map(f64::sqrt)).collect();
    Ok(Computed { values: radii?, bytes: size_of::<Creep>(), ..Computed::default() })
}

fn driven(mut bed: ContinuousContact, accuracy: f64) -> Attempt<Computed> {
    let Creeping { force, rise } = CREEPING;
    press(&mut bed, &Ramp { from: 0.0, rate: force / rise, accuracy, scale: force, stiffness: 0.0 }, &[rise])?;
    let states = press(&mut bed, &Ramp { from: force, rate: 0.0, accuracy, scale: force, stiffness: 0.0 }, &LATER)?;
    let radii: Option<Vec<f64>> = states.iter().map(|state| state.contact_radius).collect();
    Ok(Computed { values: radii.ok_or("no contact radius")?, ..Computed::default() })
}

#[expect(clippy::cast_precision_loss, reason = "steps are far below 2^53")]
fn as_f64(n: usize) -> f64 {
    n as f64
}
