//! Elastic contacts over all sizes, stiffnesses and depths.

use super::{Found, Trial, Whose, powers};
use crate::check::closed_forms;
use crate::contact::adhesion::line::EdgeLine;
use crate::contact::direct::QuasiStatic;
use crate::contact::foundation::HalfSpace;
use crate::input::quantity::{Length, Modulus, Poisson};
use crate::input::table::InMemory;
use crate::material::{self, Body, Elastic};
use crate::shape::{Paraboloid, Profile, Sphere};
use std::sync::Arc;

pub(super) const TRIALS: &[Trial] = &[
    Trial {
        name: "stiffness, size and depth",
        range: "E* 1 Pa … 10 TPa, R 1 nm … 6 400 km, d/R 10⁻¹⁵ … 0.1",
        against: "Hertz: force, contact radius, pressure",
        bound: 1e-13,
        reason: "a few dozen roundings; no root is conditioned worse",
        whose: Whose::Ours,
        run: hertz,
    },
    Trial {
        name: "near the limits of numbers",
        range: "E* 10⁻³⁰⁰ … 10³⁰⁰ Pa, R and d 10⁻³⁰⁰ … 10¹⁵⁰ m, denormal depths",
        against: "Hertz wherever force and radius are normal numbers; never a NaN",
        bound: 1e-12,
        reason: "as above; the closed form itself is evaluated in logarithms, 700 units in the last place",
        whose: Whose::Ours,
        run: limits,
    },
    Trial {
        name: "sphere to its equator",
        range: "a/R 10⁻⁷ … 1 − 10⁻⁹",
        against: "exact sphere: rapidity form, series below a/R = 0.5",
        bound: 1e-12,
        reason: "the force at a depth does not depend on the radius to first order; the series of the reference loses a few digits",
        whose: Whose::Ours,
        run: sphere,
    },
    Trial {
        name: "Poisson's ratio",
        range: "ν = 0 and 0.5, and 10⁻¹ … 10⁻¹⁶ away from both",
        against: "1/E* = (1 − ν²)/E, 1/G* = (2 − ν)(1 + ν)/(2E)",
        bound: 1e-15,
        reason: "four roundings",
        whose: Whose::Ours,
        run: poisson,
    },
];

fn contact<P: Profile + Clone + 'static>(profile: &P, modulus: f64) -> QuasiStatic {
    QuasiStatic::new(EdgeLine::new(HalfSpace::new(Arc::new(profile.clone()), modulus), 0.0))
}

fn hertz() -> Option<Found> {
    let mut found = Found::default();
    for radius in powers(-9.0, 6.8, 1.58) {
        let ball = Paraboloid { radius: Length::new(radius).ok()? };
        for modulus in powers(0.0, 13.0, 1.3) {
            for depth in powers(-15.0, -1.0, 0.7) {
                let mut contact = contact(&ball, modulus);
                contact.indent(depth * radius).ok()?;
                let (balance, right) = (contact.present().balance, closed_forms::hertz(radius, depth * radius));
                found.pair(balance.force, modulus * right.force);
                found.pair(balance.contact_radius, right.radius);
                found.pair(contact.pressure(0.0), modulus * closed_forms::hertz_pressure(radius, depth * radius, 0.0));
            }
        }
    }
    Some(found)
}

/// ln F = ln(4/3) + ln E* + ½ ln R + (3/2) ln d.
fn limits() -> Option<Found> {
    let normal = |log: f64| (-700.0..700.0).contains(&log);
    let mut found = Found::default();
    for radius in powers(-300.0, 150.0, 37.5) {
        let ball = Paraboloid { radius: Length::new(radius).ok()? };
        for modulus in powers(-300.0, 300.0, 60.0) {
            for depth in powers(-300.0, 150.0, 25.0).chain([5e-324, 1e-310]) {
                let mut contact = contact(&ball, modulus);
                let moved = contact.indent(depth);
                let balance = contact.present().balance;
                let force = (4.0f64 / 3.0).ln() + modulus.ln() + 0.5 * radius.ln() + 1.5 * depth.ln();
                let edge = 0.5 * (radius.ln() + depth.ln());
                let square = 2.0 * edge - radius.ln();
                if normal(force) && normal(edge) && normal(square) && normal(2.0 * edge) && normal(force - modulus.ln())
                {
                    moved.ok()?;
                    found.error((balance.force.ln() - force).abs() / 700.0);
                } else {
                    found.law(moved.is_err() || !balance.force.is_nan() && !balance.contact_radius.is_nan());
                }
            }
        }
    }
    Some(found)
}

fn sphere() -> Option<Found> {
    let mut found = Found::default();
    let ball = Sphere { radius: Length::new(2.0).ok()? };
    for part in powers(-7.0, -0.31, 0.2) {
        let mut contact = contact(&ball, 3.0);
        contact.indent(ball.reduced(2.0 * part)).ok()?;
        found.pair(contact.present().balance.force, 3.0 * closed_forms::sphere_force_series(2.0, 2.0 * part));
    }
    for rapidity in (1..=21).map(|k| 0.5 * f64::from(k)) {
        let right = closed_forms::sphere(2.0, rapidity);
        let mut contact = contact(&ball, 3.0);
        contact.indent(right.indentation).ok()?;
        found.pair(contact.present().balance.force, 3.0 * right.force);
    }
    Some(found)
}

fn poisson() -> Option<Found> {
    let mut found = Found::default();
    let young = 7e10;
    let away = || powers(-16.0, -1.0, 1.0).chain([0.0]);
    for ratio in away().chain(away().map(|part| 0.5 - part)) {
        let body = Elastic { young: Modulus::new(young).ok()?, poisson: Poisson::new(ratio).ok()?, yield_stress: None };
        let pair = material::joined(&(Body::Elastic(body), Body::Rigid), &InMemory::default()).ok()??.pair;
        found.pair(pair.normal, young / (1.0 - ratio * ratio));
        found.pair(pair.tangential, 2.0 * young / ((2.0 - ratio) * (1.0 + ratio)));
    }
    Some(found)
}
