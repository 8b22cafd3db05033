//! Elastic contacts over all sizes, stiffnesses and depths.

use super::case;
use crate::check::case::{Attempt, Case};
use crate::check::closed_forms;
use crate::check::contacts::{indented, paraboloid, plain};
use crate::check::extreme::{Extreme, Tally, powers};
use crate::check::sketch::{elastic, si};
use crate::input::table::InMemory;
use crate::material::{self, Body};
use crate::run::SimulationError;
use crate::shape::{Paraboloid, Profile, Sphere};
use std::sync::Arc;

pub(super) const CASES: &[Case] = &[
    case(
        "extremes/stiffness, size and depth",
        Extreme {
            range: "E* 1 Pa … 10 TPa, R 1 nm … 6 400 km, d/R 10⁻¹⁵ … 0.1",
            against: "Hertz: force, contact radius, pressure",
            tried: hertz,
        },
        1e-13,
        "a few dozen roundings; no root is conditioned worse",
    ),
    case(
        "extremes/near the limits of numbers",
        Extreme {
            range: "E* 10⁻³⁰⁰ … 10³⁰⁰ Pa, R and d 10⁻³⁰⁰ … 10¹⁵⁰ m, denormal depths",
            against: "Hertz wherever force and radius are normal numbers; never a NaN",
            tried: limits,
        },
        1e-12,
        "as above; the closed form itself is evaluated in logarithms, 700 units in the last place",
    ),
    case(
        "extremes/sphere to its equator",
        Extreme {
            range: "a/R 10⁻⁷ … 1 − 10⁻⁹",
            against: "exact sphere: rapidity form, series below a/R = 0.5",
            tried: sphere,
        },
        1e-12,
        "the force at a depth does not depend on the radius to first order; the series of the reference loses a few digits",
    ),
    case(
        "extremes/Poisson's ratio",
        Extreme {
            range: "ν = 0 and 0.5, and 10⁻¹ … 10⁻¹⁶ away from both",
            against: "1/E* = (1 − ν²)/E, 1/G* = (2 − ν)(1 + ν)/(2E)",
            tried: poisson,
        },
        1e-15,
        "four roundings",
    ),
];

fn hertz() -> Attempt<Tally> {
    let mut tally = Tally::default();
    for radius in powers(-9.0, 6.8, 1.58) {
        let ball = paraboloid(radius)?;
        for modulus in powers(0.0, 13.0, 1.3) {
            for depth in powers(-15.0, -1.0, 0.7) {
                let contact = indented(ball.clone(), modulus, depth * radius)?;
                let (balance, right) = (contact.present().balance, closed_forms::hertz(radius, depth * radius));
                tally.pair(balance.force, modulus * right.force);
                tally.pair(balance.contact_radius, right.radius);
                tally.pair(
                    contact.loaded().pressure(0.0),
                    modulus * closed_forms::hertz_pressure(radius, depth * radius, 0.0),
                );
            }
        }
    }
    Ok(tally)
}

fn limits() -> Attempt<Tally> {
    let mut tally = Tally::default();
    for radius in powers(-300.0, 150.0, 37.5) {
        let ball = paraboloid(radius)?;
        for modulus in powers(-300.0, 300.0, 60.0) {
            for depth in powers(-300.0, 150.0, 25.0).chain([5e-324, 1e-310]) {
                limit(&mut tally, &ball, modulus, depth)?;
            }
        }
    }
    Ok(tally)
}

/// ln F = ln(4/3) + ln E* + ½ ln R + (3/2) ln d where all on the way is a normal number.
fn limit(tally: &mut Tally, ball: &Arc<Paraboloid>, modulus: f64, depth: f64) -> Attempt<()> {
    let mut contact = plain(ball.clone(), modulus);
    let moved = contact.indent(depth);
    let balance = contact.present().balance;
    let radius = ball.radius.si();
    let force = (4.0f64 / 3.0).ln() + modulus.ln() + 0.5 * radius.ln() + 1.5 * depth.ln();
    let edge = 0.5 * (radius.ln() + depth.ln());
    let on_the_way = [force, edge, 2.0 * edge - radius.ln(), 2.0 * edge, force - modulus.ln()];
    if on_the_way.iter().all(|log| (-700.0..700.0).contains(log)) {
        moved?;
        tally.error((balance.force.ln() - force).abs() / 700.0);
    } else {
        tally.law(moved.is_err() || !balance.force.is_nan() && !balance.contact_radius.is_nan());
    }
    Ok(())
}

fn sphere() -> Attempt<Tally> {
    let mut tally = Tally::default();
    let ball = Arc::new(Sphere { radius: si(2.0)? });
    let force = |depth| indented(ball.clone(), 3.0, depth).map(|contact| contact.present().balance.force);
    for part in powers(-7.0, -0.31, 0.2) {
        let right = closed_forms::sphere_force_series(2.0, 2.0 * part);
        tally.pair(force(ball.reduced(2.0 * part))?, 3.0 * right);
    }
    for rapidity in (1..=21).map(|k| 0.5 * f64::from(k)) {
        let right = closed_forms::sphere(2.0, rapidity);
        tally.pair(force(right.indentation)?, 3.0 * right.force);
    }
    Ok(tally)
}

fn poisson() -> Attempt<Tally> {
    let mut tally = Tally::default();
    let young = 7e10;
    let away = || powers(-16.0, -1.0, 1.0).chain([0.0]);
    for ratio in away().chain(away().map(|part| 0.5 - part)) {
        let bodies = (elastic(young, ratio)?, Body::Rigid);
        let pair = material::joined(&bodies, &InMemory::default(), None)
            .map_err(SimulationError::from)?
            .ok_or("no pair")?
            .pair;
        tally.pair(pair.normal, young / (1.0 - ratio * ratio));
        tally.pair(pair.tangential, 2.0 * young / ((2.0 - ratio) * (1.0 + ratio)));
    }
    Ok(tally)
}
