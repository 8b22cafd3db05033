//! Viscoelastic contacts, run as whole scenes, against the solutions of Lee & Radok and of Ting.

use crate::check::case::{Attempt, Case, Pairs, Proof, worst};
use crate::check::sketch::{Sketch, ball, beside, relaxing, result, si};
use crate::check::ting::TingTriangle;
use crate::contact::adhesion::EdgeRule;
use crate::material::{Relaxation, Spectrum};
use crate::numerics::quadrature;
use crate::run::record::{Outcome, Record};
use crate::shape::{FlatPunch, Shape};
use std::f64::consts::{PI, TAU};

const DIGITS: &str = "the references have seven to ten digits";
const QUADRATURE: &str = "sums of 32 nodes over panels that shrink towards the edge, against the same integrals in other variables: a few hundred roundings of the greatest force";

pub(super) const CASES: &[Case] = &[
    Case::new("ting/triangles", Proof::Other, 5e-7, DIGITS).weak("one term each; the whole branch has two").by(triangles),
    Case::new("ting/instants at which the force vanishes", Proof::Rounding, 1e-13, "roots of I(t) = 2I(t − 1), I the primitive of E*, by bisection in double precision").weak("three spectra of one term").by(vanishing),
    Case::new("ting/whole unloading branch", Proof::Rounding, 1e-11, QUADRATURE).weak("relative to the greatest force; a paraboloid").by(|| unloading(two_terms())),
    Case::new("ting/ten terms over ten decades", Proof::Rounding, 1e-11, QUADRATURE).weak("relative to the greatest force; a paraboloid").by(|| unloading(ten_terms())),
    Case::new("ting/error estimate over true error", Proof::Bound, 1.0, "the estimate must not be smaller than the error").weak("two spectra; the cone over thirty decades is a test of the bed").by(true_over_estimated),
    Case::new("lee–radok/ramp and hold", Proof::Rounding, 1e-11, QUADRATURE).weak("a paraboloid").by(ramp_and_hold),
    Case::new("lee–radok/step", Proof::Rounding, 1e-13, "a jump is a ramp of 1e-20 of the shortest time: sums of one sign").weak("a paraboloid").by(step),
    Case::new("lee–radok/sinusoid", Proof::Bound, 2e-6, "chords within 1e-6 of the depth and springs for half of it").weak("a quarter of a cycle, while the contact grows").by(sinusoid),
    Case::new("creep/a³ = (3R/4) ∫ J dF", Proof::Rounding, 1e-11, "sums of one sign and one root; the ramp of 1e-12 of the shortest time").weak("a paraboloid; force that does not fall").by(creep),
    Case::new("oscillation/storage and loss of a punch", Proof::Bound, 1e-9, "the first harmonics of path and force by Simpson's rule on each chord of a 314th of a cycle, fourth order; what is left of the start e^(−20/0.4)").weak("a punch, whose edge stands still; of a ball the edge moves and only small loops agree").by(loop_of_a_punch),
    Case::new("oscillation/small loop on a ball", Proof::Order, 2e-3, "the edge moves by a thousandth of the radius: the loop differs from that of a still edge by as much").weak("one amplitude").by(loop_of_a_ball),
    Case::new("viscoelastic jkr/slow pull-off", Proof::Order, 2e-3, "one part in 10⁴ of the relaxation is left at this speed; near its vertical tangent the force shows the root").weak("approaches the limit only").by(slow_pull_off),
    Case::new("viscoelastic/ten records or a thousand", Proof::Rounding, 1e-12, "a record cuts a motion in two, which changes the springs by rounding").weak("one history").by(ten_or_a_thousand),
];

fn solid(equilibrium: f64, terms: &[(f64, f64)]) -> Relaxation {
    Relaxation { equilibrium, terms: terms.to_vec(), viscosity: 0.0 }
}

fn two_terms() -> Relaxation {
    solid(1.0, &[(3.0, 0.3), (2.0, 5.0)])
}

fn ten_terms() -> Relaxation {
    let fast = [(4.0, 1e-7), (3.6, 1e-6), (3.2, 1e-5), (2.8, 1e-4), (2.4, 1e-3)];
    solid(0.4, &[fast, [(2.0, 1e-2), (1.6, 0.1), (1.2, 1.0), (0.8, 10.0), (0.4, 1e3)]].concat())
}

/// Speed [m/s] of the triangles; they turn after a second. R = 1 m.
const SPEED: f64 = 0.01;

fn exact(relaxation: Relaxation) -> TingTriangle {
    TingTriangle { relaxation, radius: 1.0, speed: SPEED, turn: 1.0 }
}

/// A ball of a material, twenty records per entry.
fn soft_ball(relaxation: &Relaxation) -> Sketch {
    Sketch::of(ball(1.0)).body(relaxing(relaxation)).steps(20)
}

fn triangle(relaxation: &Relaxation) -> Attempt<Outcome> {
    soft_ball(relaxation).indent(SPEED, 1.0).indent(0.0, 1.0).run()
}

fn triangles() -> Attempt<Pairs> {
    let two: [(f64, f64); 4] =
        [(0.5, 0.002_171_497_338), (1.0, 0.005_262_688_380), (1.2, 0.002_530_129_213), (1.4, 0.000_916_887_196)];
    let forces: [(Relaxation, &[(f64, f64)]); 4] = [
        (solid(0.4, &[(3.6, 0.2)]), &[(1.0, 1.806_718_02e-3), (1.1, 6.847_747e-4), (1.2, 9.472_905e-5)]),
        (solid(2.0, &[(2.0, 0.2)]), &[(1.0, 3.374_102_65e-3), (1.3, 1.202_475e-3)]),
        (solid(0.04, &[(3.96, 0.01)]), &[(1.0, 1.321_353_24e-4)]),
        (two_terms(), &two),
    ];
    let mut pairs = Vec::new();
    for (relaxation, forces) in forces {
        let outcome = triangle(&relaxation)?;
        for &(time, force) in forces {
            let found = outcome.records.iter().find(|record| (record.time - time).abs() < 1e-9);
            pairs.push((found.ok_or_else(|| format!("no record at {time} s"))?.normal.force, force));
        }
    }
    Ok(pairs)
}

/// Time [s] of the first record without contact after the turn.
fn parting(records: &[Record]) -> Attempt<f64> {
    let apart = |record: &&Record| record.time > 1.0 && record.normal.contact_radius.is_some_and(|a| a <= 0.0);
    records.iter().find(apart).map(|record| record.time).ok_or_else(|| "the bodies do not part".into())
}

fn vanishing() -> Attempt<Pairs> {
    let instants = [
        (solid(0.4, &[(3.6, 0.2)]), 1.246_434_166_337_735_8),
        (solid(2.0, &[(2.0, 0.2)]), 1.807_048_721_673_473_2),
        (solid(0.04, &[(3.96, 0.01)]), 1.041_430_677_251_722_6),
    ];
    instants.iter().map(|(solid, time)| Ok((parting(&triangle(solid)?.records)?, *time))).collect()
}

/// Forces relative to the greatest, and when the bodies part.
fn deviations(exact: &TingTriangle, outcome: &Outcome) -> Attempt<Pairs> {
    let largest = result(outcome, "largest_force_n")?;
    let moved = outcome.records.iter().filter(|record| record.time > 0.0);
    let pair = |record: &Record| Ok(((record.normal.force - exact.at(record.time)?.0) / largest, 0.0));
    let mut pairs: Pairs = moved.map(pair).collect::<Attempt<_>>()?;
    let end = exact.parting()?;
    if end < 2.0 {
        pairs.push((parting(&outcome.records)?, end));
    }
    Ok(pairs)
}

fn unloading(relaxation: Relaxation) -> Attempt<Pairs> {
    let outcome = triangle(&relaxation)?;
    deviations(&exact(relaxation), &outcome)
}

fn true_over_estimated() -> Attempt<Pairs> {
    let used = |relaxation: Relaxation| {
        let outcome = triangle(&relaxation)?;
        let error = worst(&deviations(&exact(relaxation), &outcome)?);
        Ok((error / outcome.error_estimate.relative, 0.0))
    };
    [two_terms(), ten_terms()].into_iter().map(used).collect()
}

/// Lee & Radok with the ramp ended at a second: what was driven in relaxes.
fn ramp_and_hold() -> Attempt<Pairs> {
    let outcome = soft_ball(&ten_terms()).indent(SPEED, 1.0).hold(9.0).run()?;
    let largest = result(&outcome, "largest_force_n")?;
    let exact = exact(ten_terms());
    let error = |record: &Record| (record.normal.force - exact.force(record.time, record.time.min(1.0))) / largest;
    Ok(outcome.records[1..].iter().map(|record| (error(record), 0.0)).collect())
}

fn step() -> Attempt<Pairs> {
    let times = [0.0, 1e-8, 1e-3, 0.2, 5.0, 1e4];
    let table: [(&str, &[f64]); 2] = [("time_s", &times), ("indentation_m", &[0.01; 6])];
    let outcome = soft_ball(&ten_terms()).table(&table).run()?;
    let exact = exact(ten_terms());
    let pair = |&time: &f64| {
        let last = outcome.records.iter().rfind(|record| (record.time - time).abs() <= 0.0);
        let force = last.ok_or_else(|| format!("no record at {time} s"))?.normal.force;
        Ok((force, 4.0 / 3.0 * 1e-3 * exact.modulus(time)))
    };
    times.iter().map(pair).collect()
}

/// A step to d₀, then d₀ + A sin 2πft for a quarter of a cycle.
fn sinusoid() -> Attempt<Pairs> {
    let (depth, amplitude) = (0.01, 0.004);
    let table: [(&str, &[f64]); 2] = [("time_s", &[0.0, 1e-9]), ("indentation_m", &[depth; 2])];
    let outcome = soft_ball(&two_terms()).table(&table).oscillate(amplitude, 0.5, 0.25).run()?;
    let exact = exact(two_terms());
    let force = |t: f64| {
        let rise = |s: f64| {
            let d = depth + amplitude * (PI * s).sin();
            exact.modulus(t - s) * 1.5 * d.sqrt() * amplitude * PI * (PI * s).cos()
        };
        4.0 / 3.0 * (depth.powf(1.5) * exact.modulus(t + 1e-9) + quadrature::panel(rise, 0.0, t))
    };
    let waves = outcome.records.iter().filter(|record| record.entry == 1 && record.time > 1e-6);
    let pairs: Pairs = waves.map(|record| (record.normal.force, force(record.time - 1e-9))).collect();
    if pairs.is_empty() { Err("no record of the wave".into()) } else { Ok(pairs) }
}

fn creep() -> Attempt<Pairs> {
    let force = 1e-3;
    let outcome = soft_ball(&two_terms()).press(force, 1e-13).hold_force(1e3).run()?;
    let spectrum = Spectrum::new(&two_terms());
    let pair = |record: &Record| {
        let radius = record.normal.contact_radius.ok_or("no contact radius")?;
        Ok((radius.powi(3), 0.75 * force * spectrum.creep(record.time)))
    };
    outcome.records.iter().filter(|record| record.entry == 1).map(pair).collect()
}

fn moduli(shape: Attempt<Shape>, amplitude: f64) -> Attempt<Pairs> {
    let fast = solid(1.0, &[(3.0, 0.05), (2.0, 0.4)]);
    let held = Sketch::of(shape).body(relaxing(&fast)).steps(20).indent(0.01, 1.0).hold(40.0);
    let spectrum = Spectrum::new(&fast);
    let right = [("storage_modulus_pa", spectrum.storage(TAU)), ("loss_modulus_pa", spectrum.loss(TAU))];
    beside(&held.oscillate(amplitude, 1.0, 20.0).run()?, &right)
}

fn loop_of_a_punch() -> Attempt<Pairs> {
    moduli(si(0.5).map(|radius| Shape::FlatPunch(FlatPunch { radius })), 1e-3)
}

fn loop_of_a_ball() -> Attempt<Pairs> {
    moduli(ball(1.0), 2e-5)
}

/// Slow retraction reaches JKR's pull-off with E∞ = 1: F = −(5/6)πwR at d = −1.608772 (w²R/E∞²)^{1/3}.
fn slow_pull_off() -> Attempt<Pairs> {
    let soft = soft_ball(&solid(1.0, &[(5.0, 1.0), (0.5, 30.0)])).jkr(1.0, Some(EdgeRule::Relaxed));
    let outcome = soft.indent(5.0, 1e6).hold(1e6).retract(1e-7).run()?;
    let pulled = outcome.records.iter().rfind(|record| record.normal.force < 0.0);
    let last = pulled.ok_or("the bodies never pull")?.normal;
    Ok(vec![
        (last.force, -5.0 / 6.0 * PI),
        (last.indentation.ok_or("no indentation")?, -1.608_772_047_833_27),
        (result(&outcome, "pull_off_force_n")?, -1.5 * PI),
    ])
}

fn ten_or_a_thousand() -> Attempt<Pairs> {
    let moved = |steps| {
        let ball = soft_ball(&two_terms()).steps(steps).indent(0.01, 1.0).hold(0.3).indent(0.006, 0.2);
        ball.hold(2.0).indent(0.012, 1.0).indent(-0.001, 1.0).run()
    };
    let (few, many) = (moved(10)?, moved(1000)?);
    let names = ["largest_force_n", "largest_contact_radius_m", "work_j", "dissipated_j", "final_time_s"];
    let pair = |name| Ok((result(&few, name)?, result(&many, name)?));
    let mut pairs: Pairs = names.into_iter().map(pair).collect::<Attempt<_>>()?;
    pairs.push((parting(&few.records)?, parting(&many.records)?));
    Ok(pairs)
}
