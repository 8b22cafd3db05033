//! Adhesive contacts over all strengths and ranges of attraction.

use super::case;
use crate::check::case::{Attempt, Case};
use crate::check::cases::adhesive::{maugis_force, pulled, retracted};
use crate::check::contacts::{jkr, paraboloid};
use crate::check::extreme::{Extreme, Tally, powers};
use std::f64::consts::PI;

pub(super) const CASES: &[Case] = &[
    case(
        "extremes/work of adhesion",
        Extreme {
            range: "w 10⁻⁹ … 10³ J/m², E* 1 Pa … 10 TPa, R 1 nm … 6 400 km",
            against: "Johnson, Kendall & Roberts: pull-off −(3/2)πwR and its radius, depth at which it parts",
            tried: strengths,
        },
        1e-12,
        "a root to two units in the last place; a turning point hides nothing of its own height",
    ),
    case(
        "extremes/a hair from pull-off",
        Extreme {
            range: "F = −(3/2)πwR(1 ∓ ε), ε 10⁻² … 10⁻¹⁴",
            against: "just before: the force asked for, radius of eq. 1 of Persson et al. 2008; just after: parted",
            tried: hair,
        },
        1e-13,
        "the radius is known to the square root of ε only: its error is multiplied by √ε",
    ),
    case(
        "extremes/Tabor parameter",
        Extreme {
            range: "10⁻³ … 10³",
            against: "pull-off between −2πwR and −(3/2)πwR, rising; at the ends those limits",
            tried: tabor,
        },
        1e-3,
        "at μ_T = 10⁻³ the pull-off differs from −2πwR by about 0.6 λ², at 10³ from −(3/2)πwR by about λ⁻²",
    ),
];

fn strengths() -> Attempt<Tally> {
    let mut tally = Tally::default();
    for work in powers(-9.0, 3.0, 1.5) {
        for modulus in powers(0.0, 13.0, 1.625) {
            for radius in powers(-9.0, 6.8, 1.58) {
                tally.pairs(&strength(work, modulus, radius)?);
            }
        }
    }
    Ok(tally)
}

fn strength(work: f64, modulus: f64, radius: f64) -> Attempt<[(f64, f64); 3]> {
    // Depth at which a ball parts, in (w²R/E*²)^{1/3}.
    let parting = -1.608_772_047_833_27;
    let ball = paraboloid(radius)?;
    let by_force = pulled(ball.clone(), modulus, work, -100.0 * PI * work * radius)?;
    let unit = (work / modulus).powf(2.0 / 3.0) * radius.cbrt();
    let by_depth = retracted(ball, modulus, work, -10.0 * unit)?;
    Ok([
        (by_force.force, -1.5 * PI * work * radius),
        (by_force.contact_radius, (1.125 * PI * work / modulus).cbrt() * radius.powf(2.0 / 3.0)),
        (by_depth.indentation, parting * unit),
    ])
}

/// R = E* = w = 1.
fn hair() -> Attempt<Tally> {
    let mut tally = Tally::default();
    let ball = paraboloid(1.0)?;
    let pull = 1.5 * PI;
    for hair in powers(-14.0, -2.0, 0.5) {
        let mut contact = jkr(ball.clone(), 1.0, 1.0);
        contact.press(0.0)?;
        let force = -pull * (1.0 - hair);
        contact.press(force)?;
        let balance = contact.present().balance;
        tally.law(contact.present().joined);
        tally.pair(balance.force, force);
        let left = ((force + pull).sqrt() + pull.sqrt()).powi(2);
        tally.error((balance.contact_radius / (0.75 * left).cbrt() - 1.0).abs() * hair.sqrt());
        contact.press(-pull * (1.0 + hair))?;
        tally.law(!contact.present().joined);
    }
    Ok(tally)
}

/// λ = 1.157 μ_T.
fn tabor() -> Attempt<Tally> {
    let mut tally = Tally::default();
    let mut last = -2.0;
    for parameter in powers(-3.0, 3.0, 0.125) {
        let force = maugis_force(1.157 * parameter)?;
        tally.law(force >= last - 1e-12 && (-2.0..=-1.5).contains(&force));
        last = force;
        if parameter < 1.1e-3 {
            tally.error((force + 2.0).abs());
        }
        if parameter > 900.0 {
            tally.error((force + 1.5).abs());
        }
    }
    Ok(tally)
}
