//! Adhesive contacts over all strengths and ranges of attraction.

use super::{Found, Trial, Whose, powers};
use crate::contact::adhesion::line::EdgeLine;
use crate::contact::adhesion::range::RangeDisc;
use crate::contact::direct::QuasiStatic;
use crate::contact::foundation::HalfSpace;
use crate::input::quantity::Length;
use crate::shape::Paraboloid;
use std::f64::consts::PI;
use std::sync::Arc;

pub(super) const TRIALS: &[Trial] = &[
    Trial {
        name: "work of adhesion",
        range: "w 10⁻⁹ … 10³ J/m², E* 1 Pa … 10 TPa, R 1 nm … 6 400 km",
        against: "Johnson, Kendall & Roberts: pull-off −(3/2)πwR and its radius, depth at which it parts",
        bound: 1e-12,
        reason: "a root to two units in the last place; a turning point hides nothing of its own height",
        whose: Whose::Ours,
        run: jkr,
    },
    Trial {
        name: "a hair from pull-off",
        range: "F = −(3/2)πwR(1 ∓ ε), ε 10⁻² … 10⁻¹⁴",
        against: "just before: the force asked for, radius of eq. 1 of Persson et al. 2008; just after: parted",
        bound: 1e-13,
        reason: "the radius is known to the square root of ε only: its error is multiplied by √ε",
        whose: Whose::Ours,
        run: hair,
    },
    Trial {
        name: "Tabor parameter",
        range: "10⁻³ … 10³",
        against: "pull-off between −2πwR and −(3/2)πwR, rising; at the ends those limits",
        bound: 1e-3,
        reason: "at μ_T = 10⁻³ the pull-off differs from −2πwR by about 0.6 λ², at 10³ from −(3/2)πwR by about λ⁻²",
        whose: Whose::Ours,
        run: tabor,
    },
];

fn jkr() -> Option<Found> {
    let mut found = Found::default();
    // Depth at which a ball parts, in (w²R/E*²)^{1/3}.
    let parting = -1.608_772_047_833_27;
    for work in powers(-9.0, 3.0, 1.5) {
        for modulus in powers(0.0, 13.0, 1.625) {
            for radius in powers(-9.0, 6.8, 1.58) {
                let ball = Paraboloid { radius: Length::new(radius).ok()? };
                let contact = || {
                    let line = EdgeLine::new(HalfSpace::new(Arc::new(ball.clone()), modulus), work);
                    QuasiStatic::new(line)
                };
                let mut pulled = contact();
                pulled.press(0.0).ok()?;
                let before = pulled.press(-100.0 * PI * work * radius).ok()?.first()?.before;
                found.pair(before.force, -1.5 * PI * work * radius);
                found.pair(before.contact_radius, (1.125 * PI * work / modulus).cbrt() * radius.powf(2.0 / 3.0));
                let unit = (work / modulus).powf(2.0 / 3.0) * radius.cbrt();
                let mut retracted = contact();
                retracted.indent(0.0).ok()?;
                let before = retracted.indent(-10.0 * unit).ok()?.first()?.before;
                found.pair(before.indentation, parting * unit);
            }
        }
    }
    Some(found)
}

/// R = E* = w = 1.
fn hair() -> Option<Found> {
    let mut found = Found::default();
    let ball = Paraboloid { radius: Length::new(1.0).ok()? };
    let pull = 1.5 * PI;
    for hair in powers(-14.0, -2.0, 0.5) {
        let mut contact = QuasiStatic::new(EdgeLine::new(HalfSpace::new(Arc::new(ball.clone()), 1.0), 1.0));
        contact.press(0.0).ok()?;
        let force = -pull * (1.0 - hair);
        contact.press(force).ok()?;
        let balance = contact.present().balance;
        found.law(contact.present().joined);
        found.pair(balance.force, force);
        let left = ((force + pull).sqrt() + pull.sqrt()).powi(2);
        found.error((balance.contact_radius / (0.75 * left).cbrt() - 1.0).abs() * hair.sqrt());
        contact.press(-pull * (1.0 + hair)).ok()?;
        found.law(!contact.present().joined);
    }
    Some(found)
}

/// K = 4E*/3 = 1, R = 1, πw = 1: σ₀ = λ/2, and λ = 1.157 μ_T.
fn tabor() -> Option<Found> {
    let mut found = Found::default();
    let ball = Paraboloid { radius: Length::new(1.0).ok()? };
    let mut last = -2.0;
    for parameter in powers(-3.0, 3.0, 0.125) {
        let disc =
            RangeDisc::new(HalfSpace::new(Arc::new(ball.clone()), 0.75), 1.0 / PI, 0.5 * 1.157 * parameter).ok()?;
        let mut contact = QuasiStatic::new(disc);
        contact.press(0.0).ok()?;
        let force = contact.press(-3.0).ok()?.last()?.before.force;
        found.law(force >= last - 1e-12 && (-2.0..=-1.5).contains(&force));
        last = force;
        if parameter < 1.1e-3 {
            found.error((force + 2.0).abs());
        }
        if parameter > 900.0 {
            found.error((force + 1.5).abs());
        }
    }
    Some(found)
}
