//! Bodies that are a dashpot alone, run as whole scenes, against the closed forms of E*(t) → η δ(t).

use crate::check::case::{Attempt, Case, Pairs, Proof};
use crate::check::sketch::{Sketch, ball, elastic, ends, relaxing, result};
use crate::contact::adhesion::EdgeRule;
use crate::material::Relaxation;
use crate::run::record::Record;
use std::f64::consts::{PI, TAU};

pub(super) const CASES: &[Case] = &[
    Case::new("viscous/pressed, withdrawn and pressed again", Proof::Rounding, 1e-13, "F = 2ηva where the ball is deeper than ever before and moves on, a = √(Rd), and none elsewhere: a product and a root").weak("a paraboloid").by(again),
    Case::new("viscous/under a force", Proof::Rounding, 1e-12, "(4/3)η√R d^{3/2} = ∫F dt of a force that grows, rests, ends and comes again: a sum and a root").weak("a paraboloid").by(under_a_force),
    Case::new("viscous/a ball that comes to rest", Proof::Bound, 1e-6, "(4/3)η√R d^{3/2} = mv: steps of the tolerance 1e-7, and what the ball still has to go when a part of 1e-7 of its speed is left").weak("a paraboloid").by(to_rest),
    Case::new("viscous/a damped adhesive contact under a force", Proof::Order, 1e-4, "to an accuracy of 1e-5: pressed and pulled in a million times the time E∞ takes to move its dashpot the contact is that of Johnson, Kendall & Roberts but for a part of a millionth").weak("approaches the limit only").by(damped_and_held),
    Case::new("viscous/beside an elastic body", Proof::Rounding, 1e-13, "in series with a spring a dashpot is Maxwell's element").weak("one history").by(maxwell),
];

/// R = 1 m, η* = 2 Pa s.
const VISCOSITY: f64 = 2.0;

fn dashpot() -> Relaxation {
    Relaxation { equilibrium: 0.0, terms: Vec::new(), viscosity: VISCOSITY }
}

fn viscous() -> Sketch {
    Sketch::of(ball(1.0)).body(relaxing(&dashpot())).steps(10)
}

/// Depth [m] of a ball that has been given an impulse [N s].
fn depth_after(impulse: f64) -> f64 {
    (0.75 * impulse / VISCOSITY).powf(2.0 / 3.0)
}

fn again() -> Attempt<Pairs> {
    let outcome = viscous().indent(1e-2, 1.0).hold(1.0).indent(2e-3, 1.0).indent(3e-2, 1.0).run()?;
    let mut deepest = 0.0;
    let pairs = outcome.records.windows(2).map(|pair| {
        let [before, now] = [&pair[0], &pair[1]].map(|record: &Record| (record.time, record.normal.indentation));
        let (depth, then) = now.1.zip(before.1).ok_or("no indentation")?;
        let grows = depth > deepest;
        deepest = depth.max(deepest);
        let speed = (depth - then) / (now.0 - before.0);
        Ok((pair[1].normal.force, if grows { 2.0 * VISCOSITY * speed * depth.sqrt() } else { 0.0 }))
    });
    pairs.collect()
}

fn under_a_force() -> Attempt<Pairs> {
    let (force, impulses) = (1e-3, [0.5e-3, 1.5e-3, 2e-3, 3e-3]);
    let outcome = viscous().press(force, 1.0).hold_force(1.0).press(0.0, 1.0).press(2.0 * force, 1.0).run()?;
    let told = ends(&outcome)
        .zip(impulses)
        .map(|(record, impulse)| Ok((record.normal.indentation.ok_or("no indentation")?, depth_after(impulse))));
    told.collect()
}

fn to_rest() -> Attempt<Pairs> {
    let speed = 0.01;
    let outcome = viscous().impact(speed).run()?;
    let told = |name: &str| result(&outcome, name);
    Ok(vec![
        (told("largest_indentation_m")?, depth_after(speed)),
        (told("dissipated_j")? / (0.5 * speed * speed), 1.0),
        (told("restitution")?, 0.0),
    ])
}

/// E∞ = 1 Pa with a dashpot of 1 µs; a³ = ¾(F + 3πw + √(6πwF + (3πw)²)) and d = a² − √(2πaw).
fn damped_and_held() -> Attempt<Pairs> {
    let (work, forces) = (1e-4, [1e-3, 5e-4, 8e-4, -2e-4]);
    let body = Relaxation { equilibrium: 1.0, terms: Vec::new(), viscosity: 1e-6 };
    let held = Sketch::of(ball(1.0)).body(relaxing(&body)).jkr(work, Some(EdgeRule::Relaxed)).steps(10).accuracy(1e-5);
    let outcome = forces.into_iter().fold(held, |sketch, force| sketch.press(force, 1.0)).run()?;
    let mut pairs = Pairs::new();
    for (record, force) in ends(&outcome).zip(forces) {
        let pull = 3.0 * PI * work;
        let a = (0.75 * (force + pull + (2.0 * pull * force + pull * pull).sqrt())).cbrt();
        pairs.push((record.normal.contact_radius.ok_or("no radius")?, a));
        pairs.push((record.normal.indentation.ok_or("no indentation")?, a * a - (TAU * a * work).sqrt()));
    }
    Ok(pairs)
}

fn maxwell() -> Attempt<Pairs> {
    let modulus = 3.0;
    let led = |sketch: Sketch| sketch.indent(1e-2, 1.0).hold(1.0).indent(4e-3, 1.0).run();
    let one = led(viscous().other(elastic(0.75 * modulus, 0.5)))?;
    let element = Relaxation { equilibrium: 0.0, terms: vec![(modulus, VISCOSITY / modulus)], viscosity: 0.0 };
    let other = led(Sketch::of(ball(1.0)).body(relaxing(&element)).steps(10))?;
    let forces = one.records.iter().zip(&other.records);
    Ok(forces.map(|(one, other)| (one.normal.force, other.normal.force)).collect())
}
